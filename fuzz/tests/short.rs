//! A short run over all targets, with the inputs that a fixed seed gives.

use std::process::Command;

#[test]
fn damaged_input_is_refused_or_taken() {
    let failures = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_sphere-dda-fuzz"))
        .args(["--inputs", "400", "--failures"])
        .arg(failures.path())
        .output()
        .unwrap();
    let (out, error) = (output.stdout, output.stderr);
    let text = [out, error].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    assert!(output.status.success(), "{}\n{}", text[0], text[1]);
    // Damage that refuses everything would find nothing: of each target some inputs are sound.
    let rows = text[0]
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>());
    let taken: Vec<u32> = rows.map(|row| row[3].parse().unwrap()).collect();
    assert_eq!(taken.len(), 6, "{}", text[0]);
    assert!(taken.iter().all(|&count| count > 40), "{}", text[0]);
}
