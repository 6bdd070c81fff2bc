//! A run killed at any moment leaves collections whose frames are all complete.

use std::fs;

use sphere_dda::results::frames::Series;
use sphere_dda::results::writer::{Options, Results};

use crate::made::{listed_or_none, place, record, scene};
use crate::vtu::check_blocks;

const KILLED: &str = "SPHERE_DDA_TEST_KILLED_RUN";

/// Writes frames, and goes back every now and then, until it is killed: the child of the test below.
#[test]
#[ignore = "runs for ever: started and killed by a_killed_run_stays_readable"]
fn write_until_killed() {
    let scene = scene(500);
    let mut options = Options::new(std::env::var(KILLED).unwrap(), &scene);
    options.overwrite = true;
    let mut results = Results::create(&scene, options).unwrap();
    let mut step = 0;
    for count in 1.. {
        record(&mut results, &scene, 0.1 * f64::from(step));
        step = if count % 17 == 0 { step - 5 } else { step + 1 };
    }
}

#[test]
fn a_killed_run_stays_readable() {
    let directory = place("vtk-killed");
    let mut frames = 0;
    for round in 0..20 {
        let mut child = std::process::Command::new(std::env::current_exe().unwrap())
            .args(["killed::write_until_killed", "--exact", "--ignored"])
            .env(KILLED, &directory)
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_micros(30_000 + 7_300 * round));
        child.kill().unwrap();
        child.wait().unwrap();
        for series in Series::ALL {
            let pvd = directory.join(format!("{}.pvd", series.name()));
            for (_, file) in listed_or_none(&pvd) {
                check_blocks(&fs::read(directory.join(file)).unwrap());
                frames += 1;
            }
        }
    }
    assert!(frames > 100, "only {frames} frames: the child hardly ran");
}
