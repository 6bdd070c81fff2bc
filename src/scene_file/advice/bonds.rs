//! Bonds that join nothing.

use crate::scene::Scene;
use crate::scene_file::bonds::{StartBond, at_start};
use crate::scene_file::decode::SceneFile;
use crate::scene_file::diagnostic::Advice;

/// One for `[pair_default]` and each `[[pair]]` whose `bond` joins nothing at t = 0.
pub(super) fn advise(scene: &Scene, file: &SceneFile) -> Vec<Advice> {
    let own: Vec<([u16; 2], &str)> = own(scene, file).collect();
    if file.pair_default.bond.is_none() && own.is_empty() {
        return Vec::new();
    }
    let found = at_start(scene);
    let own_of = |bond: &StartBond| {
        let [a, b] = bond.materials;
        let mut own = own.iter();
        own.position(|(pair, _)| [[a, b], [b, a]].contains(pair))
    };
    let of = |index: Option<usize>| found.iter().filter(move |bond| own_of(bond) == index);
    let default = file
        .pair_default
        .bond
        .map(|_| empty("pair_default", of(None)));
    let pairs = own.iter().enumerate();
    let pairs = pairs.map(|(k, (_, path))| empty(path, of(Some(k))));
    default.into_iter().chain(pairs).flatten().collect()
}

/// The `[[pair]]`s that have a `bond` of their own, by their materials.
fn own<'f>(scene: &Scene, file: &'f SceneFile) -> impl Iterator<Item = ([u16; 2], &'f str)> {
    file.pairs.iter().filter_map(|element| {
        let pair = element.value.as_ref()?;
        pair.bond?;
        let index = |name: &String| {
            let index = scene.materials.iter().position(|m| m.name == *name)?;
            u16::try_from(index).ok()
        };
        let [a, b] = pair.materials.as_slice() else {
            return None;
        };
        Some(([index(a)?, index(b)?], element.path.as_str()))
    })
}

/// What to say of a `bond` at `path` that has `found` at t = 0.
fn empty<'b>(path: &str, found: impl Iterator<Item = &'b StartBond>) -> Option<Advice> {
    let (made, apart): (Vec<&StartBond>, Vec<_>) = found.partition(|bond| bond.joined);
    if made.iter().any(|bond| bond.of_spheres) {
        return None;
    }
    // Bonds with a boundary alone are none of the spheres that lie beside each other.
    let apart = apart
        .iter()
        .filter(|bond| bond.of_spheres || made.is_empty());
    let nearest = apart.map(|bond| bond.gap).fold(f64::INFINITY, f64::min);
    if !made.is_empty() && nearest.is_infinite() {
        return None;
    }
    let what = match made.is_empty() {
        true => "joins nothing",
        false => "joins spheres to boundaries, but not to each other",
    };
    let (apart, help) = match nearest.is_finite() {
        true => (
            format!("the nearest surfaces are {nearest:.1e} m apart"),
            format!(
                "give it a `reach` [m] of more than that, as `reach = {:.1e}`, or place them so that they touch",
                1.1 * nearest
            ),
        ),
        false => (
            "no surfaces of its materials are nearer than a radius".to_owned(),
            "place them so that they touch, or remove it".to_owned(),
        ),
    };
    let message = format!("{what}: bonds are made at t = 0 alone, where {apart}");
    Some(Advice::warning(format!("{path}.bond"), message, help))
}
