//! The file as typed becomes a validated [`Scene`] in one step; every problem of the file is reported at once.

use std::ops::Range;
use std::path::Path;

use miette::NamedSource;

use super::bodies::{boundary, motion};
use super::decode::{Element, SceneFile};
use super::document::{Document, did_you_mean};
use super::overlap::Overlaps;
use super::problem::SceneError;
use super::resources::{Resources, hash};
use super::{
    Integrator, Loaded, Measure, Method, Output, PointLoad, Probe, Scene, Sensor, Settings, Spring,
    Tolerance,
};
use super::{file, spheres};
use crate::Vec3;
use crate::materials::{Material, Pair, PairTable};
use crate::motion::Motion;
use crate::particles::{Kinematics, Particles};

/// Reads, checks and builds; `name` is what problems call the file, `folder` where its files lie.
pub(super) fn load(name: &str, text: &str, folder: &Path) -> Result<Loaded, SceneError> {
    let mut document = Document::parse(text);
    let mut resources = Resources::new(folder);
    // A broken syntax shifts keys into wrong tables: its consequences would only hide it.
    let scene = if document.refused() {
        None
    } else {
        let file = SceneFile::decode(&mut document);
        build(&mut document, &mut resources, &file)
    };
    let refused = document.refused();
    let (errors, warnings) = document.into_problems();
    match scene {
        Some(mut scene) if !refused => {
            let attachments = resources.into_attachments();
            scene.hash = hash(text, &attachments);
            Ok(Loaded {
                scene,
                name: name.to_owned(),
                text: text.to_owned(),
                attachments,
                warnings,
            })
        }
        _ => Err(SceneError {
            source_code: NamedSource::new(name, text.to_owned()),
            problems: errors,
        }),
    }
}

/// The names declared by one kind of element. An element that is unusable for another reason still declares its
/// name, so that references to it are not reported.
pub(super) struct Names {
    kind: &'static str,
    names: Vec<Option<String>>,
    usable: Vec<bool>,
}

impl Names {
    fn declare<T>(
        document: &mut Document<'_>,
        kind: &'static str,
        elements: &[Element<T>],
    ) -> Self {
        let names: Vec<_> = elements.iter().map(|e| e.name.clone()).collect();
        for (i, element) in elements.iter().enumerate() {
            let Some(name) = &element.name else { continue };
            let path = format!("{}.name", element.path);
            let mut letters = name.chars();
            let starts = letters
                .next()
                .is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
            let valid = starts && letters.all(|c| c.is_ascii_alphanumeric() || c == '_');
            let found = format!("`{name}`");
            document.demand(
                valid,
                path.as_str(),
                found,
                "a name of letters, digits and `_` that does not start with a digit",
            );
            if let Some(first) = names[..i].iter().position(|n| n.as_ref() == Some(name)) {
                let help = format!(
                    "`{}` has this name already; names are unique per kind",
                    elements[first].path
                );
                document.error(path, format!("{kind} `{name}` appears twice"), help);
            }
        }
        Self {
            kind,
            usable: elements.iter().map(|e| e.value.is_some()).collect(),
            names,
        }
    }

    /// The index of `name`; reports an unknown one at `path`.
    pub(super) fn resolve(
        &self,
        document: &mut Document<'_>,
        path: &str,
        name: &str,
    ) -> Option<usize> {
        let known = || self.names.iter().flatten().map(String::as_str);
        let Some(index) = self.names.iter().position(|n| n.as_deref() == Some(name)) else {
            let list: Vec<&str> = known().collect();
            let list = if list.is_empty() {
                "none".to_owned()
            } else {
                list.join(", ")
            };
            let help = format!("{}known: {list}", did_you_mean(name, known()));
            document.error(path, format!("unknown {} `{name}`", self.kind), help);
            return None;
        };
        self.usable[index].then_some(index)
    }
}

/// Names that elements of the scene refer to.
pub(super) struct Context {
    pub(super) materials: Names,
    groups: Names,
    ranges: Vec<Option<Range<usize>>>,
}

fn build(
    document: &mut Document<'_>,
    resources: &mut Resources<'_>,
    file: &SceneFile,
) -> Option<Scene> {
    let mut context = Context {
        materials: Names::declare(document, "material", &file.materials),
        groups: Names::declare(document, "sphere group", &file.spheres),
        ranges: Vec::new(),
    };
    for (kind, names) in [
        ("boundary", file.boundaries.len()),
        ("material", file.materials.len()),
    ] {
        let most = usize::from(u16::MAX);
        document.demand(
            names <= most,
            kind,
            names,
            &format!("at most {most} of them"),
        );
    }
    let settings = file.simulation.as_ref().map(|s| settings(document, s));
    let materials = materials(document, file);
    let pairs = pairs(document, &context, file);
    let mut particles = Particles::default();
    let mut initial = Kinematics::default();
    for group in &file.spheres {
        let range = group.value.as_ref().and_then(|value| {
            let key = format!("{}.material", group.path);
            let index = context.materials.resolve(document, &key, &value.material)?;
            if file.materials[index]
                .value
                .as_ref()
                .is_some_and(|m| m.density.is_none())
            {
                let help = format!(
                    "`{}` uses it for spheres: add `density = ...` in kg/m^3",
                    group.path
                );
                document.error(&file.materials[index].path, "missing key `density`", help);
            }
            let material = (u16::try_from(index).ok()?, materials.get(index)?);
            spheres::add(
                document,
                resources,
                &group.path,
                value,
                material,
                (&mut particles, &mut initial),
            )
        });
        context.ranges.push(range);
    }
    if file.spheres.is_empty() {
        document.error(
            "spheres",
            "found no spheres, expected at least one",
            "add a group `[[spheres]]`",
        );
    }
    Names::declare(document, "boundary", &file.boundaries);
    let boundaries: Vec<_> = file
        .boundaries
        .iter()
        .map(|b| boundary(document, resources, &context, &b.path, b.value.as_ref()?))
        .collect();
    let scene = Scene {
        title: file.title.clone(),
        // Known when all files have been read.
        hash: String::new(),
        loads: loads(document, &context, &file.loads),
        springs: springs(document, resources, &context, &file.springs, &initial),
        sensors: sensors(document, &file.sensors),
        probes: probes(document, &context, &file.probes, particles.len()),
        output: output(document, &file.output),
        settings: settings?,
        materials,
        pairs,
        particles,
        initial,
        boundaries: boundaries.into_iter().collect::<Option<_>>()?,
    };
    if context.ranges.iter().all(Option::is_some) {
        Overlaps::of(&scene).judge(document, &scene, &context.ranges, &file.spheres);
    }
    Some(scene)
}

fn settings(document: &mut Document<'_>, s: &file::Simulation) -> Settings {
    let at = |key: &str| format!("simulation.{key}");
    document.demand(
        s.duration > 0.0,
        at("duration"),
        s.duration,
        "a time > 0 [s]",
    );
    document.demand(s.step > 0.0, at("step"), s.step, "a time > 0 [s]");
    let communication_step = s.communication_step.unwrap_or(s.step);
    if s.communication_step.is_some() {
        document.demand(
            communication_step > 0.0,
            at("communication_step"),
            communication_step,
            "a time > 0 [s]",
        );
    }
    if let Some(penalty) = s.penalty {
        document.demand(
            penalty > 0.0,
            at("penalty"),
            penalty,
            "a stiffness > 0 [N/m]",
        );
    } else if s.method == Method::Penalty {
        let help =
            "add `penalty = ...` in N/m; `sphere-dda check` suggests one, or use method = \"alm\"";
        document.error(
            "simulation",
            "missing key `penalty`, which method = \"penalty\" needs",
            help,
        );
    }
    let overlap = s.max_initial_overlap;
    document.demand(
        (0.0..=0.5).contains(&overlap),
        at("max_initial_overlap"),
        overlap,
        "0 <= max_initial_overlap <= 0.5 [-]",
    );
    let threshold = s.threshold_velocity;
    document.demand(
        threshold >= 0.0,
        at("threshold_velocity"),
        threshold,
        "a speed >= 0 [m/s]",
    );
    let kept = s.dynamic_coefficient;
    document.demand(
        (0.0..=1.0).contains(&kept),
        at("dynamic_coefficient"),
        kept,
        "0 <= dynamic_coefficient <= 1 [-]",
    );
    if s.integrator == Integrator::Moreau && kept != 1.0 {
        document.warn(
            at("dynamic_coefficient"),
            "has no effect with integrator = \"moreau\"",
            "remove it or use \"shi\"",
        );
    }
    document.demand(
        s.max_iterations >= 1,
        at("max_iterations"),
        s.max_iterations,
        "a count >= 1",
    );
    document.demand(
        s.max_cuts <= 20,
        at("max_cuts"),
        s.max_cuts,
        "0 <= max_cuts <= 20",
    );
    let tolerance = Tolerance {
        gap: s.tolerance.gap,
        slip: s.tolerance.slip,
        force: s.tolerance.force,
    };
    for (key, value) in [
        ("gap", tolerance.gap),
        ("slip", tolerance.slip),
        ("force", tolerance.force),
    ] {
        let path = format!("simulation.tolerance.{key}");
        document.demand(
            (1e-12..=1e-1).contains(&value),
            path,
            format!("{value:e}"),
            "1e-12 to 1e-1 [-]",
        );
    }
    Settings {
        gravity: s.gravity.into(),
        duration: s.duration,
        step: s.step,
        communication_step,
        method: s.method,
        integrator: s.integrator,
        solver: s.solver,
        penalty: s.penalty,
        adapt_penalty: s.adapt_penalty,
        tolerance,
        max_initial_overlap: overlap,
        threshold_velocity: threshold,
        dynamic_coefficient: kept,
        max_iterations: s.max_iterations as usize,
        max_cuts: s.max_cuts,
    }
}

fn materials(document: &mut Document<'_>, file: &SceneFile) -> Vec<Material> {
    let materials = file.materials.iter().map(|element| {
        let density = element.value.as_ref().and_then(|m| m.density);
        if let Some(density) = density {
            document.demand(
                density > 0.0,
                format!("{}.density", element.path),
                density,
                "a density > 0 [kg/m^3]",
            );
        }
        // A material of boundaries only has no density; 1 keeps an unusable element's spheres finite until the
        // scene is refused.
        Material {
            name: element.name.clone().unwrap_or_default(),
            density: density.filter(|d| *d > 0.0).unwrap_or(1.0),
        }
    });
    materials.collect()
}

fn pairs(document: &mut Document<'_>, context: &Context, file: &SceneFile) -> PairTable {
    let d = file.pair_default;
    let default = pair(
        document,
        "pair_default",
        (d.friction, d.friction_angle, d.restitution),
        Pair::default(),
    );
    let mut table = PairTable::new(file.materials.len(), default);
    let mut rebounds = default.restitution > 0.0;
    let mut seen: Vec<(usize, usize)> = Vec::new();
    for element in &file.pairs {
        let (path, Some(value)) = (&element.path, &element.value) else {
            continue;
        };
        let own = pair(
            document,
            path,
            (value.friction, value.friction_angle, value.restitution),
            default,
        );
        rebounds |= own.restitution > 0.0;
        let key = format!("{path}.materials");
        let [a, b] = value.materials.as_slice() else {
            document.demand(
                false,
                key,
                format!("{} names", value.materials.len()),
                "two material names [a, b]",
            );
            continue;
        };
        let a = context.materials.resolve(document, &format!("{key}[0]"), a);
        let b = context.materials.resolve(document, &format!("{key}[1]"), b);
        let Some((a, b)) = a.zip(b) else { continue };
        let pair_of = (a.min(b), a.max(b));
        if seen.contains(&pair_of) {
            document.error(
                key,
                format!("the pair {:?} appears twice", value.materials),
                "keep one; the order of the names does not matter",
            );
        }
        seen.push(pair_of);
        if let (Ok(a), Ok(b)) = (u16::try_from(a), u16::try_from(b)) {
            table.set(a, b, own);
        }
    }
    let shi = file
        .simulation
        .as_ref()
        .is_some_and(|s| s.integrator == Integrator::Shi);
    if shi && rebounds {
        let help = "its rebound follows from the step (method of Shi 1988); use integrator = \"moreau\" for Newton's law";
        document.warn(
            "simulation.integrator",
            "restitution has no effect with integrator = \"shi\"",
            help,
        );
    }
    table
}

fn pair(
    document: &mut Document<'_>,
    path: &str,
    (friction, angle, restitution): (Option<f64>, Option<f64>, Option<f64>),
    default: Pair,
) -> Pair {
    if let Some(mu) = friction {
        document.demand(
            mu >= 0.0,
            format!("{path}.friction"),
            mu,
            "a coefficient >= 0 [-]",
        );
    }
    if let Some(angle) = angle {
        let range = (0.0..90.0).contains(&angle);
        document.demand(
            range,
            format!("{path}.friction_angle"),
            angle,
            "0 <= friction_angle < 90 [degrees]",
        );
    }
    if friction.is_some() && angle.is_some() {
        let message = "found both `friction` and `friction_angle`, expected one of them";
        document.error(
            format!("{path}.friction_angle"),
            message,
            "friction is the tangent of the angle",
        );
    }
    if let Some(e) = restitution {
        document.demand(
            (0.0..=1.0).contains(&e),
            format!("{path}.restitution"),
            e,
            "0 <= restitution <= 1 [-]",
        );
    }
    Pair {
        friction: friction
            .or(angle.map(|a| a.to_radians().tan()))
            .unwrap_or(default.friction),
        restitution: restitution.unwrap_or(default.restitution),
    }
}

impl Context {
    /// The sphere called `"group[k]"`, or `"group"` where that is a single one.
    fn sphere(&self, document: &mut Document<'_>, path: &str, text: &str) -> Option<usize> {
        let (group, index) = match text.split_once('[') {
            None => (text, None),
            Some((group, rest)) => {
                let Some(index) = rest.strip_suffix(']').and_then(|k| k.parse::<usize>().ok())
                else {
                    document.error(
                        path,
                        format!("found `{text}`, expected `group[k]`"),
                        "k counts the spheres of the group from 0",
                    );
                    return None;
                };
                (group, Some(index))
            }
        };
        let rank = self.groups.resolve(document, path, group)?;
        let range = self.ranges.get(rank)?.clone()?;
        match index {
            None if range.len() == 1 => Some(range.start),
            None => {
                let help = format!("write `{group}[k]` with k from 0 to {}", range.len() - 1);
                document.error(
                    path,
                    format!(
                        "`{group}` has {} spheres, expected one of them",
                        range.len()
                    ),
                    help,
                );
                None
            }
            Some(k) => {
                let expected = format!(
                    "an index below {}, the number of spheres of `{group}`",
                    range.len()
                );
                document
                    .demand(k < range.len(), path, k, &expected)
                    .then(|| range.start + k)
            }
        }
    }
}

fn loads(
    document: &mut Document<'_>,
    context: &Context,
    elements: &[Element<file::Load>],
) -> Vec<PointLoad> {
    let loads = elements.iter().filter_map(|element| {
        let value = element.value.as_ref()?;
        Some(PointLoad {
            sphere: context.sphere(document, &format!("{}.sphere", element.path), &value.sphere)?,
            arm: value.point.into(),
            force: value.force.into(),
        })
    });
    loads.collect()
}

fn springs(
    document: &mut Document<'_>,
    resources: &mut Resources<'_>,
    context: &Context,
    elements: &[Element<file::Spring>],
    initial: &Kinematics,
) -> Vec<Spring> {
    let springs = elements.iter().filter_map(|element| {
        let (path, value) = (&element.path, element.value.as_ref()?);
        let stiffness = value.stiffness;
        document.demand(
            stiffness > 0.0,
            format!("{path}.stiffness"),
            stiffness,
            "a stiffness > 0 [N/m]",
        );
        let motion = match &value.motion {
            Some(given) => motion(document, resources, &format!("{path}.motion"), given),
            None => Some(Motion::Fixed),
        };
        let sphere = context.sphere(document, &format!("{path}.sphere"), &value.sphere)?;
        let arm = Vec3::from(value.point);
        Some(Spring {
            sphere,
            arm,
            stiffness,
            target: value
                .target
                .map_or(initial.position[sphere] + arm, Vec3::from),
            motion: motion?,
        })
    });
    springs.collect()
}

fn sensors(document: &mut Document<'_>, elements: &[Element<file::Sensor>]) -> Vec<Sensor> {
    Names::declare(document, "sensor", elements);
    let sensors = elements.iter().filter_map(|element| {
        let (path, value) = (&element.path, element.value.as_ref()?);
        let measure = match (value.mass_in_box, value.mass_flow) {
            (Some(cuboid), None) => {
                let path = format!("{path}.mass_in_box");
                let (min, max) = (Vec3::from(cuboid.min), Vec3::from(cuboid.max));
                let proper = (0..3).all(|k| min[k] < max[k]);
                let found = format!("min {:?} and max {:?}", cuboid.min.0, cuboid.max.0);
                document.demand(proper, path, found, "min < max in every coordinate [m]");
                Measure::MassInBox { min, max }
            }
            (None, Some(plane)) => Measure::MassFlow {
                point: plane.point.into(),
                normal: direction(document, &format!("{path}.mass_flow.normal"), plane.normal)?,
            },
            (cuboid, plane) => {
                let n = usize::from(cuboid.is_some()) + usize::from(plane.is_some());
                document.demand(
                    false,
                    path,
                    format!("{n} measures"),
                    "exactly one of mass_in_box, mass_flow",
                );
                return None;
            }
        };
        Some(Sensor {
            name: value.name.clone(),
            measure,
        })
    });
    sensors.collect()
}

/// The first, the middle and the last sphere unless the scene names its own.
fn probes(
    document: &mut Document<'_>,
    context: &Context,
    elements: &[Element<file::Probe>],
    spheres: usize,
) -> Vec<Probe> {
    Names::declare(document, "probe", elements);
    if elements.is_empty() {
        let mut chosen: Vec<(&str, usize)> = Vec::new();
        for (name, sphere) in [
            ("first", 0),
            ("middle", spheres / 2),
            ("last", spheres.saturating_sub(1)),
        ] {
            if chosen.iter().all(|(_, other)| *other != sphere) && sphere < spheres {
                chosen.push((name, sphere));
            }
        }
        return chosen
            .into_iter()
            .map(|(name, sphere)| Probe {
                name: name.to_owned(),
                sphere,
            })
            .collect();
    }
    let probes = elements.iter().filter_map(|element| {
        let value = element.value.as_ref()?;
        Some(Probe {
            name: value.name.clone(),
            sphere: context.sphere(document, &format!("{}.sphere", element.path), &value.sphere)?,
        })
    });
    probes.collect()
}

fn output(document: &mut Document<'_>, output: &file::Output) -> Output {
    for (key, value) in [
        ("vtu_interval", output.vtu_interval),
        ("csv_interval", output.csv_interval),
    ] {
        document.demand(
            value >= 0.0,
            format!("output.{key}"),
            value,
            "a time >= 0 [s]",
        );
    }
    Output {
        vtu_interval: output.vtu_interval,
        csv_interval: output.csv_interval,
        float64: output.float64,
    }
}

/// The unit vector along a direction of any length.
pub(super) fn direction(
    document: &mut Document<'_>,
    path: &str,
    given: file::Vector,
) -> Option<Vec3> {
    let unit = Vec3::from(given).try_normalize(0.0);
    document.demand(
        unit.is_some(),
        path,
        format!("{:?}", given.0),
        "a direction of length > 0",
    );
    unit
}
