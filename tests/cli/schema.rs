//! `sphere-dda schema`: the committed schema and reference are those of the code.

use std::path::Path;

use crate::command::done;

fn is_up_to_date(arguments: &[&str], file: &str) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let committed = std::fs::read_to_string(root.join(file)).unwrap_or_default();
    let printed = done(Path::new("."), arguments).out;
    assert!(
        printed == committed,
        "{file} is not what the code says: renew it with `cargo run -- {} > {file}`",
        arguments.join(" ")
    );
}

#[test]
fn the_schema_is_up_to_date() {
    is_up_to_date(&["schema"], "docs/scene.schema.json");
}

#[test]
fn the_reference_is_up_to_date() {
    is_up_to_date(&["schema", "--markdown"], "docs/scene.md");
}
