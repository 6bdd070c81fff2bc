//! The licences in an FMU are those of what its library links.

use std::collections::BTreeSet;
use std::process::Command;

use sphere_dda_export::documentation::THIRD_PARTY;

/// `name version` of all crates of others in the library, as `fmu/licences/collect.py` asks for them.
fn linked(platform: &str) -> BTreeSet<String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let tree = "tree --locked -p sphere-dda-fmu -e normal,no-proc-macro --prefix none --format {p} --target";
    let done = Command::new(cargo)
        .args(tree.split(' ').chain([platform]))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(
        done.status.success(),
        "{}",
        String::from_utf8_lossy(&done.stderr)
    );
    let text = String::from_utf8(done.stdout).unwrap();
    let crates = text.lines().map(|line| {
        let mut words = line.split_whitespace();
        let (name, version) = (words.next().unwrap(), words.next().unwrap());
        format!("{name} {}", version.trim_start_matches('v'))
    });
    crates.filter(|c| !c.starts_with("sphere-dda")).collect()
}

#[test]
fn every_linked_crate_is_listed_in_its_version_and_no_other() {
    let platforms = [
        "x86_64-unknown-linux-gnu",
        "x86_64-pc-windows-gnu",
        "wasm32-unknown-unknown",
    ];
    let linked: BTreeSet<String> = platforms.iter().flat_map(|p| linked(p)).collect();
    let (crates, _) = THIRD_PARTY.split_once("\n=====").unwrap();
    let bare: Vec<_> = crates
        .lines()
        .filter(|line| line.starts_with("- ") && !line.ends_with(']'))
        .collect();
    assert!(bare.is_empty(), "without the text of a licence: {bare:?}");
    let lines = crates.lines().filter_map(|l| l.strip_prefix("- "));
    let listed: BTreeSet<String> = lines
        .filter_map(|line| line.split_once(':'))
        .map(|(name, _)| name.to_owned())
        .collect();
    assert!(linked.len() > 50);
    let renew = "renew it: python3 fmu/licences/collect.py > fmu/licences/third-party.txt";
    let missing: Vec<_> = linked.difference(&listed).collect();
    let gone: Vec<_> = listed.difference(&linked).collect();
    assert!(
        missing.is_empty() && gone.is_empty(),
        "fmu/licences/third-party.txt lacks {missing:?} and has {gone:?} too much; {renew}"
    );
}
