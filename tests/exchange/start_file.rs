//! Start files: what is read is what was written, and nothing else is taken for it.

use sphere_dda::results::start_file::{StartFile, StartFileError};
use sphere_dda::simulation::Settle;

use crate::scene;

const SETTLE: Settle = Settle {
    time: 1.0,
    until_rest: false,
};

const BALL: &str = r#"
[simulation]
duration = 1.0
step = 0.001
[[material]]
name = "glass"
density = 2500
[[spheres]]
name = "ball"
material = "glass"
radius = [0.1]
positions = [[0, 0, 1]]
"#;

#[test]
fn a_start_file_comes_back_as_it_was_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ball.start");
    let missing = StartFile::read(&path).unwrap_err();
    assert!(
        matches!(missing, StartFileError::Missing { .. }),
        "{missing}"
    );
    let file = StartFile {
        hash: StartFile::hash(&scene(BALL), SETTLE),
        start: (0..=255).collect(),
    };
    file.write(&path).unwrap();
    assert_eq!(StartFile::read(&path).unwrap(), file);
}

#[test]
fn the_hash_is_that_of_scene_and_settling() {
    let hash = |text: &str, settle| StartFile::hash(&scene(text), settle);
    let own = hash(BALL, SETTLE);
    assert_eq!(own, hash(BALL, SETTLE));
    let heavier = BALL.replace("2500", "2600");
    let longer = Settle {
        time: 2.0,
        ..SETTLE
    };
    let rest = Settle {
        until_rest: true,
        ..SETTLE
    };
    for other in [hash(&heavier, SETTLE), hash(BALL, longer), hash(BALL, rest)] {
        assert_ne!(own, other);
    }
    // How long a run is and what solves it does not change where it starts.
    let mut run = scene(BALL);
    run.settings.duration = 7.0;
    run.settings.solver = sphere_dda::solver::SolverKind::Direct;
    assert_eq!(own, StartFile::hash(&run, SETTLE));
}

#[test]
fn damaged_files_and_others_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ball.start");
    let file = StartFile {
        hash: StartFile::hash(&scene(BALL), SETTLE),
        start: vec![1; 100],
    };
    file.write(&path).unwrap();
    let whole = std::fs::read(&path).unwrap();
    for at in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[at] ^= 1;
        std::fs::write(&path, &bytes).unwrap();
        assert!(StartFile::read(&path).is_err(), "byte {at}");
        std::fs::write(&path, &whole[..at]).unwrap();
        assert!(StartFile::read(&path).is_err(), "cut at {at}");
    }
    std::fs::write(&path, "[simulation]").unwrap();
    let other = StartFile::read(&path).unwrap_err();
    assert!(matches!(other, StartFileError::Other { .. }), "{other}");
    let mut damaged = whole;
    damaged[200 - 60] ^= 1;
    std::fs::write(&path, damaged).unwrap();
    let damaged = StartFile::read(&path).unwrap_err().to_string();
    assert!(
        damaged.contains("checksum") && damaged.contains("settle anew"),
        "{damaged}"
    );
}
