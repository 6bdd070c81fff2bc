//! `sphere-dda new`: each folder holds a scene that is sound and exports, and what the driver names is in its FMU.

use std::fs;

use crate::command::{done, said};

const KINDS: [&str; 7] = [
    "feeder",
    "hopper",
    "drum",
    "conveyor",
    "bucket",
    "landslide",
    "paper",
];

#[test]
fn every_kind_makes_a_folder_whose_scene_exports_with_the_variables_of_its_driver() {
    let root = tempfile::tempdir().unwrap();
    let root = root.path();
    for kind in KINDS {
        let folder = root.join("below").join(kind);
        let made = done(root, &["new", kind, &format!("below/{kind}")]).out;
        assert!(made.contains("drive.py"), "{made}");
        let scene = format!("{kind}.toml");
        done(&folder, &["check", &scene]);
        done(&folder, &["export", &scene, "-o", "x.fmu"]);
        let listed = done(&folder, &["inspect", "x.fmu"]).out;
        let driver = fs::read_to_string(folder.join("drive.py")).unwrap();
        let named = driver
            .lines()
            .filter(|l| l.starts_with("INPUTS") || l.starts_with("OUTPUTS"));
        let named: Vec<&str> = named
            .flat_map(|line| line.split('"').skip(1).step_by(2))
            .collect();
        assert!(!named.is_empty());
        for name in named {
            assert!(listed.contains(name), "{kind}: {name}: {listed}");
        }
        let mut first = fs::read_to_string(folder.join(&scene)).unwrap();
        assert!(first.starts_with("#:schema scene.schema.json\n"), "{kind}");
        assert!(folder.join("scene.schema.json").exists());
        for file in ["README.md", "drive.py"] {
            let text = fs::read_to_string(folder.join(file)).unwrap();
            assert!(text.contains(&format!("{kind}.toml")), "{file}");
            for hole in [
                "{NAME}",
                "{ABOUT}",
                "{INPUTS}",
                "{OUTPUTS}",
                "{STOP}",
                "{STEP}",
                "{PARAMETER}",
                "{USUAL}",
                "{OTHER}",
            ] {
                assert!(!text.contains(hole), "{file}: {hole}");
            }
        }
        // Fault: scenes with `friction_angle` refused the parameter of their README.
        let readme = fs::read_to_string(folder.join("README.md")).unwrap();
        let between = |begin, end| {
            let from = readme.split_once(begin).unwrap().1;
            from.split_once(end).unwrap().0
        };
        first += between("```toml\n", "```");
        fs::write(folder.join(&scene), &first).unwrap();
        let value = between("--set ", "`");
        done(&folder, &["check", &scene, "--set", value]);
    }
}

#[test]
fn what_is_there_is_left() {
    let root = tempfile::tempdir().unwrap();
    let root = root.path();
    fs::create_dir(root.join("mine")).unwrap();
    for (name, part) in [
        ("mine", "exists already"),
        ("..", "expected the name"),
        ("a b", "expected the name"),
    ] {
        let refused = said(root, &["new", "drum", name]);
        assert_eq!(refused.code, Some(2));
        assert!(refused.error.contains(part), "{}", refused.error);
    }
    assert_eq!(fs::read_dir(root.join("mine")).unwrap().count(), 0);
    let unknown = said(root, &["new", "mill", "x"]);
    assert_eq!(unknown.code, Some(2));
    assert!(
        unknown.error.contains("conveyor") && !root.join("x").exists(),
        "{}",
        unknown.error
    );
}
