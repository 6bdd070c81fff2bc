//! Keys that do nothing.

use crate::integrator::Integrator;
use crate::scene::{Boundary, Method, Scene};
use crate::scene_file::decode::SceneFile;
use crate::scene_file::diagnostic::Advice;
use crate::scene_file::file::BondStrengths;
use crate::solver::SolverKind;
use crate::solver::gauss_seidel::SMALL;

pub(super) fn advise(scene: &Scene, file: &SceneFile) -> Vec<Advice> {
    let mut advice = numerics(scene);
    advice.extend(materials(scene, file));
    advice.extend(clumps(file));
    advice.extend(pairs(scene, file));
    advice.extend(wear(scene, file));
    advice.extend(glue(scene, file));
    advice
}

/// Keys of `[simulation]`.
fn numerics(scene: &Scene) -> Vec<Advice> {
    let settings = &scene.settings;
    let at = |key: &str| format!("simulation.{key}");
    let mut advice = Vec::new();
    let alm = settings.method == Method::Alm;
    let used = "it is used by solver = \"direct\" and by method = \"penalty\" only";
    if settings.penalty.is_some() && alm {
        match settings.solver {
            SolverKind::Direct => {}
            SolverKind::GaussSeidel => advice.push(Advice::warning(
                at("penalty"),
                "has no effect with solver = \"gauss-seidel\"",
                format!("remove it: {used}"),
            )),
            SolverKind::Auto => advice.push(
                Advice::warning(
                    at("penalty"),
                    "has no effect with solver = \"auto\" unless all else fails in a step",
                    format!("it does no harm; {used}"),
                )
                .harmless(),
            ),
        }
    }
    if !settings.adapt_penalty && (!alm || settings.solver == SolverKind::GaussSeidel) {
        let with = match alm {
            true => "solver = \"gauss-seidel\"",
            false => "method = \"penalty\"",
        };
        advice.push(Advice::warning(
            at("adapt_penalty"),
            format!("has no effect with {with}"),
            "remove it, or use method = \"alm\" with solver = \"direct\"",
        ));
    }
    if settings.threshold_velocity > 0.0 {
        let why = match settings.integrator {
            Integrator::Shi => Some("with integrator = \"shi\""),
            Integrator::Moreau if !scene.pairs.rebounds() => Some("without a restitution > 0"),
            Integrator::Moreau => None,
        };
        advice.extend(why.map(|why| {
            Advice::warning(
                at("threshold_velocity"),
                format!("has no effect {why}"),
                "remove it, or set `restitution` with integrator = \"moreau\"",
            )
        }));
    }
    let spheres = scene.particles.len();
    if settings.threads > 1 && spheres < SMALL {
        advice.push(
            Advice::warning(
                at("threads"),
                format!(
                    "has no effect with {spheres} spheres: threads share the work of scenes of {SMALL} and more"
                ),
                "it does no harm; several runs at once use several cores",
            )
            .harmless(),
        );
    }
    advice
}

/// Materials that neither spheres nor boundaries have.
fn materials(scene: &Scene, file: &SceneFile) -> Vec<Advice> {
    let used = |index: usize| {
        let is = |material: u16| usize::from(material) == index;
        scene.particles.material.iter().any(|&m| is(m))
            || scene.boundaries.iter().any(|b| is(b.material))
    };
    let unused = file.materials.iter().enumerate().filter(|(i, _)| !used(*i));
    let advice = unused.map(|(index, element)| {
        let name = &scene.materials[index].name;
        Advice::warning(
            element.path.clone(),
            format!("material `{name}` is used by no spheres and no boundary"),
            format!("remove it, or write `material = \"{name}\"` where it is meant"),
        )
    });
    advice.collect()
}

/// Clumps that no group and no source places.
fn clumps(file: &SceneFile) -> Vec<Advice> {
    let groups = file
        .spheres
        .iter()
        .filter_map(|group| group.value.as_ref()?.clump.as_ref());
    let sources = file
        .sources
        .iter()
        .filter_map(|source| source.value.as_ref()?.clump.as_ref());
    let placed: Vec<&String> = groups.chain(sources).collect();
    let advice = file.clumps.iter().filter_map(|element| {
        let name = element.name.as_ref()?;
        (!placed.contains(&name)).then(|| {
            Advice::warning(
                element.path.clone(),
                format!("clump `{name}` is placed by no spheres and no source"),
                format!("remove it, or write `clump = \"{name}\"` where it is meant"),
            )
        })
    });
    advice.collect()
}

/// Pairs that never touch: neither material has spheres.
fn pairs(scene: &Scene, file: &SceneFile) -> Vec<Advice> {
    let of_spheres = |name: &String| {
        let is = |m: &u16| scene.materials[usize::from(*m)].name == *name;
        scene.particles.material.iter().any(is)
    };
    let advice = file.pairs.iter().filter_map(|element| {
        let names = &element.value.as_ref()?.materials;
        (!names.iter().any(of_spheres)).then(|| {
            Advice::warning(
                element.path.clone(),
                "has no effect: no spheres have one of its materials, and boundaries do not touch each other",
                "remove it, or give spheres one of its materials",
            )
        })
    });
    advice.collect()
}

/// Wear of which no boundary keeps an account.
fn wear(scene: &Scene, file: &SceneFile) -> Option<Advice> {
    if scene.boundaries.iter().any(|boundary| boundary.wall_fields) {
        return None;
    }
    let default = file.pair_default.wear.map(|_| "pair_default".to_owned());
    let worn = |path: &String, wear: Option<f64>| wear.map(|_| path.clone());
    let mut materials = file.materials.iter();
    let material = materials.find_map(|m| worn(&m.path, m.value.as_ref()?.wear));
    let mut pairs = file.pairs.iter();
    let pair = pairs.find_map(|pair| worn(&pair.path, pair.value.as_ref()?.wear));
    let path = default.or(material).or(pair)?;
    Some(Advice::warning(
        format!("{path}.wear"),
        "has no effect: no boundary keeps what it feels",
        "write `wall_fields = true` in the boundary that wears, or remove it",
    ))
}

/// Stiffness of bonds between grains that are rigid.
fn glue(scene: &Scene, file: &SceneFile) -> Option<Advice> {
    let soft = |boundary: &Boundary| boundary.stiffness.is_some();
    if scene.pairs.gives_way() || scene.boundaries.iter().any(soft) {
        return None;
    }
    let given =
        |bond: &Option<BondStrengths>| bond.as_ref().is_some_and(|bond| bond.young.is_some());
    let default = given(&file.pair_default.bond).then(|| "pair_default".to_owned());
    let mut pairs = file.pairs.iter();
    let pair = pairs.find(|pair| pair.value.as_ref().is_some_and(|pair| given(&pair.bond)));
    let path = default.or(pair.map(|pair| pair.path.clone()))?;
    Some(Advice::warning(
        format!("{path}.bond.young"),
        "has no effect: bonds of rigid grains are rigid",
        "give `young` [Pa] to the materials as well, or remove it",
    ))
}
