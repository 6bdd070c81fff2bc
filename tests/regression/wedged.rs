//! Fault: in a rockfall against a fixed wall 1215 of 1417 steps counted as unconverged. Cause: any sphere that carried load from
//! two boundaries with normals more than 120 degrees apart was taken for squeezed and softened, once any step had failed.
//!
//! Fault: on a screen of bars that shakes all steps were unconverged once a grain was stuck between two bars. Cause: both bars, faces of one
//! boundary, approached it as the screen went up.

use sphere_dda::Vec3;

use crate::support::{Case, list};

const RADIUS: f64 = 0.1;

/// A stone wedged between the faces of these boundaries, and far away one that a lid squeezes until it lifts: how many steps are
/// unconverged until then, and after.
fn unconverged(wedge: &[(&str, &str)]) -> [u64; 2] {
    let lid = "motion = { table = { time = [0.0, 0.1, 0.2, 1.0], translation = [[0, 0, 0], [0, 0, -0.011], [0, 0, 0.5], [0, 0, 0.5]] } }";
    let case = Case::new(1e-3)
        .tolerance(1e-4)
        .contact(0.6, 0.0)
        .boundary(
            "rectangle = { corner = [9.0, -1.0, 0.0], u = [2.0, 0.0, 0.0], v = [0.0, 2.0, 0.0] }",
            "",
        )
        .boundary(
            "rectangle = { corner = [9.0, -1.0, 0.21], u = [2.0, 0.0, 0.0], v = [0.0, 2.0, 0.0] }",
            lid,
        );
    let case = wedge
        .iter()
        .fold(case, |case, (faces, motion)| case.boundary(faces, motion));
    let squeezed = Vec3::new(10.0, 0.0, RADIUS);
    let wedged = Vec3::new(-RADIUS, 0.0, 5.0);
    let mut run = [squeezed, wedged]
        .into_iter()
        .fold(case, |case, place| {
            case.sphere(RADIUS, place, Vec3::zeros(), Vec3::zeros())
        })
        .loose()
        .start();
    [0.25, 0.5].map(|until| {
        let mut count = 0;
        while run.simulation.time() < until - 1e-9 {
            let report = run.simulation.advance(1e-3).expect("a step");
            count += report.unconverged_steps;
        }
        count
    })
}

const WALL: &str =
    "rectangle = { corner = [0.0, -1.0, 4.0], u = [0.0, 2.0, 0.0], v = [0.0, 0.0, 2.0] }";

/// A slope of 48 degrees under the stone.
fn slope() -> String {
    let normal = Vec3::new(0.74, 0.0, 0.67).normalize();
    let along = Vec3::new(0.67, 0.0, -0.74).normalize();
    let corner = Vec3::new(-RADIUS, 0.0, 5.0) - normal * RADIUS - along * 0.5 - Vec3::y();
    format!(
        "rectangle = {{ corner = {}, u = [0.0, 2.0, 0.0], v = {} }}",
        list(corner),
        list(along)
    )
}

#[test]
fn a_stone_wedged_at_rest_is_not_squeezed() {
    let [squeezed, wedged] = unconverged(&[(WALL, ""), (&slope(), "")]);
    assert!(squeezed > 0, "the lid squeezes the other one");
    assert_eq!(wedged, 0);
}

#[test]
fn a_stone_wedged_between_faces_of_a_boundary_that_moves_is_not_squeezed() {
    let both = format!("{WALL} }}, {{ {}", slope());
    let up = "motion = { constant = { velocity = [0.0, 0.0, 0.3] } }";
    let [squeezed, wedged] = unconverged(&[(&both, up)]);
    assert!(squeezed > 0, "the lid squeezes the other one");
    assert_eq!(wedged, 0);
}
