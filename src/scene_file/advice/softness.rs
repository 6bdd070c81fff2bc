//! Grains too soft for the weight that lies on them, as with a Young's modulus typed in GPa.

use crate::contact::elasticity::{Elasticity, LARGEST_COMPRESSION};
use crate::scene::Scene;
use crate::scene_file::decode::SceneFile;
use crate::scene_file::diagnostic::Advice;
use crate::scene_file::summary::spheres_extent;

pub(super) fn advise(scene: &Scene, file: &SceneFile) -> Vec<Advice> {
    let materials = file.materials.iter().enumerate();
    let advice = materials.filter_map(|(index, element)| {
        let young = element.value.as_ref()?.young?;
        soft(scene, u16::try_from(index).ok()?, &element.path, young)
    });
    advice.collect()
}

/// Whether Hertz's law, `W = 4/3 E* sqrt(R*) d^(3/2)`, compresses the largest grain of `material`, whose modulus is `young` \[Pa\],
/// by more than its share of the radius. `W` \[N\] is the weight of all spheres over the grain's section, `M g (2 R)^2/A` with the
/// area `A` \[m^2\] of their box seen along gravity, and its own weight at least.
fn soft(scene: &Scene, material: u16, path: &str, young: f64) -> Option<Advice> {
    let law = scene.pairs.get(material, material).elasticity?;
    if !matches!(law, Elasticity::Hertz { .. }) {
        return None;
    }
    let particles = &scene.particles;
    let own = (0..particles.len()).filter(|i| particles.material[*i] == material);
    let largest = own.max_by(|a, b| particles.radius[*a].total_cmp(&particles.radius[*b]))?;
    let (radius, mass) = (particles.radius[largest], particles.mass[largest]);
    let gravity = scene.settings.gravity;
    let above = spheres_extent(scene).map_or(0.0, |(low, high)| {
        let [x, y, z] = (high - low).into();
        let along = gravity.abs() / gravity.norm();
        let area = along.x * y * z + along.y * x * z + along.z * x * y;
        let present = particles.mass.iter().zip(&scene.initial.present);
        let all: f64 = present.filter(|(_, there)| **there).map(|(m, _)| m).sum();
        all * (4.0 * radius * radius / area).min(1.0)
    });
    let weight = mass.max(above) * gravity.norm();
    let spring = law.spring(0.5 * radius);
    let compression = spring.overlap(weight) / radius;
    (compression > LARGEST_COMPRESSION).then(|| {
        let enough = young * weight / spring.force(LARGEST_COMPRESSION * radius);
        Advice::warning(
            format!("{path}.young"),
            format!(
                "found young = {young} Pa, by which the weight of what lies on a grain, about {weight:.1e} N, compresses it by {:.0} % \
                 of its radius; Hertz's law holds up to about {:.0} %",
                100.0 * compression,
                100.0 * LARGEST_COMPRESSION
            ),
            format!(
                "moduli are in Pa: {young} GPa is `young = {:e}`; here it takes {enough:.0e} Pa or more",
                young * 1e9
            ),
        )
    })
}
