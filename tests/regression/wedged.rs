//! Fault: in a rockfall against a fixed wall 1215 of 1417 steps counted as unconverged. Cause: any sphere that carried load from
//! two boundaries with normals more than 120 degrees apart was taken for squeezed and softened, once any step had failed.

use sphere_dda::Vec3;

use crate::support::{Case, list};

/// A stone wedged between a wall and a slope of 48 degrees, and far away one that a lid squeezes until it lifts.
#[test]
fn a_stone_wedged_at_rest_is_not_squeezed() {
    let slope = Vec3::new(0.74, 0.0, 0.67).normalize();
    let along = Vec3::new(0.67, 0.0, -0.74).normalize();
    let lid = "motion = { table = { time = [0.0, 0.1, 0.2, 1.0], translation = [[0, 0, 0], [0, 0, -0.011], [0, 0, 0.5], [0, 0, 0.5]] } }";
    let radius = 0.1;
    let wedged = Vec3::new(-radius, 0.0, 5.0);
    let corner = wedged - slope * radius - along * 0.5 - Vec3::y();
    let plate = format!(
        "rectangle = {{ corner = {}, u = [0.0, 2.0, 0.0], v = {} }}",
        list(corner),
        list(along)
    );
    let mut run = Case::new(1e-3)
        .tolerance(1e-4)
        .contact(0.6, 0.0)
        .boundary(
            "rectangle = { corner = [9.0, -1.0, 0.0], u = [2.0, 0.0, 0.0], v = [0.0, 2.0, 0.0] }",
            "",
        )
        .boundary(
            "rectangle = { corner = [9.0, -1.0, 0.21], u = [2.0, 0.0, 0.0], v = [0.0, 2.0, 0.0] }",
            lid,
        )
        .boundary(
            "rectangle = { corner = [0.0, -1.0, 4.0], u = [0.0, 2.0, 0.0], v = [0.0, 0.0, 2.0] }",
            "",
        )
        .boundary(&plate, "")
        .sphere(
            radius,
            Vec3::new(10.0, 0.0, radius),
            Vec3::zeros(),
            Vec3::zeros(),
        )
        .sphere(radius, wedged, Vec3::zeros(), Vec3::zeros())
        .loose()
        .start();
    let mut unconverged = |until: f64| {
        let mut count = 0;
        while run.simulation.time() < until - 1e-9 {
            let report = run.simulation.advance(1e-3).expect("a step");
            count += report.unconverged_steps;
        }
        count
    };
    assert!(unconverged(0.25) > 0, "the lid squeezes the other one");
    assert_eq!(unconverged(0.5), 0);
}
