//! Clumps that are refused.

use crate::{edited, folder, load};

const GROUP: &str =
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }";

/// The good scene whose first group has clumps, with more in the group, in the clump and at the end of the file.
fn scene(group: &str, clump: &str, more: &str) -> String {
    let text = edited("radius = 0.1\n", &format!("clump = \"rod\"\n{group}\n"));
    let text = text.replacen(
        GROUP,
        "lattice = { origin = [0.0, 0.0, 0.3], count = [3, 2, 1], spacing = 0.4 }",
        1,
    );
    let members = "members = [{ position = [0, 0, 0], radius = 0.1 }, { position = [0, 0, 0.1], radius = 0.1 }]";
    let clump = if clump.contains("members") {
        clump.to_owned()
    } else {
        format!("{members}\n{clump}")
    };
    format!("{text}\n[[clump]]\nname = \"rod\"\n{clump}\n{more}\n")
}

#[test]
fn each_bad_clump_is_refused_with_place_and_reason() {
    let folder = folder();
    let good = scene("seed = 3", "mass = 4.0", "");
    let loaded = load(&good, folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
    assert_eq!(loaded.scene.clumps.len(), 6);
    assert_eq!(loaded.scene.particles.len(), 13);
    let mass: f64 = loaded.scene.particles.mass[..12].iter().sum();
    assert!((mass - 24.0).abs() < 1e-12);
    let cases = [
        (
            scene("radius = [0.1, 0.2]", "", ""),
            "spheres[0].radius",
            "a list of 2 radii",
        ),
        (
            scene("lock = \"x\"", "", ""),
            "spheres[0].lock",
            "which has none",
        ),
        (
            scene("rotations = [[0, 0, 1], [0, 1, 0]]", "", ""),
            "spheres[0].rotations",
            "or 6 of them",
        ),
        (
            good.replacen("clump = \"rod\"", "clump = \"rodd\"", 1),
            "spheres[0].clump",
            "did you mean `rod`",
        ),
        (
            edited("radius = 0.1\n", "radius = 0.1\nrotations = [[0, 0, 1]]\n"),
            "spheres[0].rotations",
            "give `clump`",
        ),
        (
            scene("", "mass = 0.0", ""),
            "clump[0].mass",
            "a mass > 0 [kg]",
        ),
        (
            scene("", "inertia = [1.0, 2.0, 9.0]", ""),
            "clump[0].inertia",
            "[1.0, 2.0, 9.0]",
        ),
        (
            scene("", "members = [{ position = [0, 0, 0], radius = 1.0 }]", ""),
            "clump[0].members",
            "2 to 20",
        ),
        (
            scene(
                "",
                "members = [{ position = [0, 0, 0], radius = 0.1 }, { position = [0, 0, 0.01], radius = 0.05 }]",
                "",
            ),
            "clump[0].members[1]",
            "lies inside another member",
        ),
        (
            scene("", "", "[cell]\nx = [-5.0, -4.8]"),
            "cell.x",
            "diameters of the largest clump",
        ),
    ];
    for (text, path, part) in cases {
        let error = load(&text, folder.path()).expect_err(path).plain();
        assert!(
            error.contains(path) && error.contains(part),
            "{path}: {error}"
        );
    }
    let turning = scene("", "", "").replacen(
        "step = 1e-3",
        "step = 1e-3\nrotating_frame = { axis = [0, 0, 1], speed = 1.0, point = [0, 0, 0] }",
        1,
    );
    let error = load(&turning, folder.path())
        .expect_err("a frame that turns")
        .plain();
    assert!(
        error.contains("rotating frame in a scene with clumps"),
        "{error}"
    );
}
