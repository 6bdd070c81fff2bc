//! A directory of results: numbering, rollback, holding back, overwriting, failures.

use std::fs;
use std::path::Path;
#[cfg(unix)]
use std::{
    process::Command,
    sync::mpsc::{RecvTimeoutError, channel},
    time::Duration,
};

use sphere_dda::formats::error::OutputError;
use sphere_dda::results::writer::{Options, Results};

use crate::made::{Made, listed, listed_or_none, place, record, scene};

#[test]
fn collections_name_frames_by_time() {
    let scene = scene(4);
    let directory = place("numbering");
    let mut results = Results::create(&scene, Options::new(&directory, &scene)).unwrap();
    // Points that miss the interval of 0.1 s, and two intervals at once.
    for time in [0.0, 0.03, 0.12, 0.18, 0.41, 0.1 + 0.2 + 0.2] {
        record(&mut results, &scene, time);
    }
    assert_eq!(results.finish().failures, 0);
    let names = |n: [u32; 4]| n.map(|n| format!("spheres_{n:06}.vtu"));
    let frames = listed(&directory.join("spheres.pvd"));
    assert_eq!(
        frames.iter().map(|f| f.1.clone()).collect::<Vec<_>>(),
        names([0, 1, 4, 5])
    );
    let times: Vec<f64> = frames.iter().map(|f| f.0).collect();
    assert_eq!(times, [0.0, 0.12, 0.41, 0.1 + 0.2 + 0.2], "17 digits");
}

/// Times in `history.csv`.
fn rows(directory: &Path) -> Vec<f64> {
    let mut table = csv::Reader::from_path(directory.join("history.csv")).unwrap();
    let columns = table.headers().unwrap().len();
    table
        .records()
        .map(|row| {
            let row = row.unwrap();
            assert_eq!(row.len(), columns);
            row[0].parse().unwrap()
        })
        .collect()
}

#[test]
fn rolling_back_drops_later_frames_and_rows() {
    let scene = scene(4);
    for hold in [false, true] {
        for told in [false, true] {
            let directory = place(&format!("rollback-{hold}-{told}"));
            let mut options = Options::new(&directory, &scene);
            options.hold = hold;
            let mut results = Results::create(&scene, options).unwrap();
            for k in 0..=6 {
                record(&mut results, &scene, 0.1 * f64::from(k));
            }
            if told {
                results.rollback(0.35);
                results.flush();
                let count = listed_or_none(&directory.join("spheres.pvd")).len();
                assert_eq!(count, if hold { 0 } else { 4 });
                assert!(!directory.join("spheres_000006.vtu").exists());
            }
            // A master that restored 0.3 s and takes another step length from there.
            for time in [0.35, 0.45] {
                record(&mut results, &scene, time);
            }
            assert_eq!(results.finish().failures, 0);
            let expected = [0.0, 0.1, 0.2, 0.1 * 3.0];
            let frames: Vec<f64> = listed(&directory.join("spheres.pvd"))
                .iter()
                .map(|f| f.0)
                .collect();
            assert_eq!(frames[..4], expected);
            assert_eq!(frames[4..], [0.45]);
            assert!(!directory.join("contacts_000006.vtu").exists());
            let table = rows(&directory);
            assert_eq!(table[..4], expected);
            assert_eq!(table[4..], [0.35, 0.45]);
        }
    }
}

#[test]
fn held_frames_reach_the_disk_when_committed() {
    let scene = scene(4);
    let directory = place("held");
    let mut options = Options::new(&directory, &scene);
    options.hold = true;
    let mut results = Results::create(&scene, options).unwrap();
    let pvd = directory.join("spheres.pvd");
    for k in 0..=4 {
        record(&mut results, &scene, 0.1 * f64::from(k));
    }
    results.flush();
    assert!(!pvd.exists());
    results.commit(0.2);
    results.flush();
    assert_eq!(listed(&pvd).len(), 3);
    assert_eq!(rows(&directory).len(), 3);
    // Without a word from the master the memory stays bounded: the oldest go out.
    for k in 5..=40 {
        record(&mut results, &scene, 0.1 * f64::from(k));
    }
    results.flush();
    assert_eq!(listed(&pvd).len(), 41 - 16);
    // And come back out of the files when the master rolls back further than that.
    results.rollback(1.0);
    results.flush();
    assert_eq!(listed(&pvd).len(), 11);
    drop(results);
    assert_eq!(rows(&directory).len(), 11);
}

#[test]
fn an_existing_run_is_refused_unless_overwritten() {
    let scene = scene(4);
    let directory = place("existing");
    let options = Options::new(&directory, &scene);
    let mut results = Results::create(&scene, options.clone()).unwrap();
    for time in [0.0, 0.1, 0.2] {
        record(&mut results, &scene, time);
    }
    drop(results);
    fs::write(directory.join("notes.txt"), "mine").unwrap();
    let error = Results::create(&scene, options.clone()).err().unwrap();
    assert!(matches!(error, OutputError::Exists { .. }), "{error}");
    let overwrite = Options {
        overwrite: true,
        ..options
    };
    let mut results = Results::create(&scene, overwrite).unwrap();
    record(&mut results, &scene, 0.0);
    drop(results);
    assert!(directory.join("notes.txt").exists());
    assert!(!directory.join("spheres_000002.vtu").exists());
    assert_eq!(rows(&directory), [0.0]);
    let about: serde_json::Value =
        serde_json::from_slice(&fs::read(directory.join("run.json")).unwrap()).unwrap();
    assert_eq!(about["title"], "a row");
    assert_eq!(about["settings"]["step"], 1e-3);
    assert_eq!(about["scene_hash"], "0".repeat(64));
}

#[test]
fn a_failing_disk_is_counted_and_does_not_stop_the_run() {
    let scene = scene(4);
    let directory = place("failing");
    let mut results = Results::create(&scene, Options::new(&directory, &scene)).unwrap();
    record(&mut results, &scene, 0.0);
    results.flush();
    // A directory in the way of a frame: it can be neither written nor replaced.
    fs::create_dir_all(directory.join("spheres_000001.vtu/blocked")).unwrap();
    for time in [0.1, 0.2] {
        record(&mut results, &scene, time);
    }
    let status = results.finish();
    assert_eq!((status.frames, status.rows, status.failures), (2, 3, 1));
    assert!(status.first_failure.unwrap().contains("spheres_000001.vtu"));
    assert_eq!(listed(&directory.join("spheres.pvd")).len(), 2);
}

#[cfg(unix)]
#[test]
fn a_slow_disk_holds_up_the_third_frame_and_no_rows() {
    let scene = scene(4);
    let directory = place("slow");
    let mut results = Results::create(&scene, Options::new(&directory, &scene)).unwrap();
    // Whoever opens a pipe to write to it waits for a reader: the writer hangs in its first frame.
    let pipe = directory.join("spheres_000000.vtu.tmp");
    let made = Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    record(&mut results, &scene, 0.0);
    for row in 1..=30 {
        record(&mut results, &scene, 0.1 + 0.001 * f64::from(row - 1));
    }
    let (done, third) = channel();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            record(&mut results, &scene, 0.2);
            done.send(()).unwrap();
        });
        let early = third.recv_timeout(Duration::from_millis(200));
        // Before the verdict, or a failure would wait for ever.
        assert!(!fs::read(&pipe).unwrap().is_empty());
        assert_eq!(
            early,
            Err(RecvTimeoutError::Timeout),
            "three frames are on their way"
        );
        third.recv().unwrap();
    });
    let status = results.finish();
    assert_eq!((status.frames, status.rows, status.failures), (3, 32, 0));
}

#[test]
fn a_broken_state_is_not_written() {
    let scene = scene(4);
    let directory = place("broken");
    let mut results = Results::create(&scene, Options::new(&directory, &scene)).unwrap();
    let mut made = Made::new(&scene, 0.0);
    made.kinematics.position[2].x = f64::NAN;
    results.record(&made.observe(&scene, 0.0));
    let status = results.finish();
    // The row holds the potential energy, the frame the position.
    assert_eq!((status.frames, status.rows, status.failures), (0, 0, 2));
    assert!(!directory.join("spheres.pvd").exists());
}
