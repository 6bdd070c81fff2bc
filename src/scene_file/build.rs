//! The file as typed becomes a validated [`Scene`] in one step; every problem of the file is reported at once.

use std::path::Path;

use super::advice::advise;
use super::bodies::{boundary, motion};
use super::cell::{cell, turns};
use super::checks::{accept, direction};
use super::clumps::{self, Template};
use super::decode::{self, Entry, SceneFile};
use super::diagnostic::SceneError;
use super::document::Document;
use super::edits::written;
use super::identity::hash;
use super::names::{Context, Names};
use super::overlap::Overlaps;
use super::pairs::pairs;
use super::parameters;
use super::quantities::quantities;
use super::regions::measured;
use super::settings::{choose_slip, choose_steps, fall, materials, settings};
use super::source_text::SourceText;
use super::sources::{sinks, source};
use super::spheres::{self, Present};
use super::{Loaded, file};
use crate::Vec3;
use crate::contact::forces::ContactForces;
use crate::geometry::Facets;
use crate::scene::clump::{Clump, ClumpShape};
use crate::scene::materials::Material;
use crate::scene::particles::{Kinematics, Particles};
use crate::scene::{
    Boundary, Measure, Motion, Output, PointLoad, Probe, Scene, Sensor, Source, Spring,
};
use crate::spatial::cell::Cell;

/// Reads, checks and builds; `name` is what problems call the file, `folder` where its files lie, `values` those of parameters
/// that are not to have their default.
pub(super) fn load(
    name: &str,
    text: &str,
    folder: &Path,
    values: &[(String, f64)],
) -> Result<Loaded, SceneError> {
    let (mut edited, mut fitted) = (None, Vec::new());
    let mut document = Document::parse(text, folder);
    // A broken syntax shifts keys into wrong tables: its consequences would only hide it.
    let scene = if document.refused() {
        None
    } else {
        let entries = decode::parameters(&mut document);
        let numbers = quantities(document.root());
        let root = written(document.root().clone(), &numbers);
        let (parameters, edits) = parameters::parameters(&mut document, &root, &entries, values);
        let root = written(root, &edits);
        edited = parameters::with_defaults(text, &document, &entries, &parameters, values);
        let file = SceneFile::decode(&mut document, &root);
        let templates: Vec<_> = (file.clumps.iter())
            .map(|entry| Template::new(&mut document, entry))
            .collect();
        let scene = build(&mut document, &file, &templates).map(|scene| Scene {
            parameters,
            ..scene
        });
        let fits = templates.into_iter().flatten();
        fitted = fits.filter_map(|template| template.fitted).collect();
        scene
    };
    let refused = document.refused();
    let (errors, warnings, attachments) = document.into_parts();
    match scene {
        Some(mut scene) if !refused => {
            let text = edited.unwrap_or_else(|| text.to_owned());
            scene.hash = hash(&text, &attachments);
            if scene.title.is_empty() {
                scene.title = stem(name);
            }
            Ok(Loaded {
                scene,
                name: name.to_owned(),
                text,
                attachments,
                fitted,
                warnings,
            })
        }
        _ => Err(SceneError {
            source_code: SourceText::new(name, text.to_owned()),
            problems: errors,
        }),
    }
}

/// The name of a scene file without folder and ending: the title of a scene that gives none.
fn stem(name: &str) -> String {
    let stem = Path::new(name).file_stem().unwrap_or_default();
    match stem.to_string_lossy() {
        stem if stem.is_empty() => "scene".to_owned(),
        stem => stem.into_owned(),
    }
}

fn build(
    document: &mut Document<'_>,
    file: &SceneFile,
    templates: &[Option<Template>],
) -> Option<Scene> {
    let groups = file.spheres.iter().map(Entry::declaration);
    let mut context = Context {
        materials: Names::declare(document, "material", &file.materials),
        clumps: Names::declare(document, "clump", &file.clumps),
        groups: Names::declare_all(
            document,
            "sphere group",
            groups.chain(file.sources.iter().map(Entry::declaration)),
        ),
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
    let settings = file.simulation.as_ref().and_then(|s| settings(document, s));
    let materials = materials(document, file);
    let pairs = pairs(document, &context, file);
    let boundary_names = Names::declare(document, "boundary", &file.boundaries);
    let boundaries: Vec<_> = (file.boundaries.iter())
        .map(|b| {
            let value = b.value.as_ref()?;
            boundary(document, &context, &boundary_names, &b.path, value)
        })
        .collect();
    let boundaries: Option<Vec<_>> = boundaries.into_iter().collect();
    let cell = cell(document, &file.cell);
    let (particles, initial, clumps, sources) = populate(
        document,
        (&mut context, templates),
        file,
        &materials,
        (boundaries.as_deref(), cell),
    );
    if file.spheres.is_empty() && file.sources.is_empty() {
        document.error(
            "spheres",
            "found no spheres, expected at least one",
            "add a group `[[spheres]]` or a `[[source]]`",
        );
    }
    let loads = loads(document, &context, &file.loads, &initial);
    let mut settings = settings;
    if let (Some(settings), Some(typed)) = (&mut settings, &file.simulation) {
        let boundaries = boundaries.as_deref().unwrap_or_default();
        let spheres = (&particles, &initial, &clumps[..]);
        let fall = fall(settings, spheres, boundaries, &loads);
        choose_steps(settings, typed, fall);
        choose_slip(settings, typed, &pairs);
    }
    // Their names are declared, and judged, among the groups.
    let source_names = Names::of("source", file.sources.iter().map(Entry::declaration));
    let scene = Scene {
        title: file.title.clone(),
        about: file.about.clone(),
        // Known when all files have been read.
        hash: String::new(),
        loads,
        springs: springs(document, &context, &file.springs, &initial),
        sinks: sinks(document, &source_names, &file.sinks),
        sources,
        sensors: sensors(document, &boundary_names, &file.sensors),
        probes: probes(document, &context, &file.probes, particles.len()),
        output: output(document, file.output),
        exposed: file.fmu.clone(),
        settings: settings?,
        materials,
        pairs,
        particles,
        clumps,
        initial,
        initial_contacts: ContactForces::default(),
        cell,
        boundaries: boundaries?,
        // Known to whoever has set them.
        parameters: Vec::new(),
    };
    if context.ranges.iter().all(Option::is_some) {
        super::frame::judge(document, &scene, &file.boundaries);
        let fit = super::cell::judge(document, &scene, &file.boundaries, &file.sensors)
            & clumps::judge(document, &scene);
        let groups = &context.ranges[..file.spheres.len()];
        if fit {
            Overlaps::of(&scene).judge(document, &scene, groups, &file.spheres);
        }
        if !document.refused() {
            for advice in advise(&scene, file, &context.ranges) {
                document.advise(advice);
            }
        }
    }
    Some(scene)
}

/// The spheres of the groups, then those that wait in sources, and the sources.
fn populate(
    document: &mut Document<'_>,
    (context, templates): (&mut Context, &[Option<Template>]),
    file: &SceneFile,
    materials: &[Material],
    (boundaries, cell): (Option<&[Boundary]>, Cell),
) -> (Particles, Kinematics, Vec<Clump>, Vec<Source>) {
    let (mut particles, mut initial) = (Particles::default(), Kinematics::default());
    let mut clumps = Vec::new();
    for group in &file.spheres {
        let range = group.value.as_ref().and_then(|value| {
            let material =
                sphere_material(document, context, file, materials, group, &value.material)?;
            let named = (group.path.as_str(), value.clump.as_ref());
            let clump = shape(document, context, templates, named, material.1)?;
            let present = Present {
                particles: &mut particles,
                initial: &mut initial,
                clumps: &mut clumps,
                boundaries,
                cell,
            };
            spheres::add(document, (&group.path, value), material, clump, present)
        });
        context.ranges.push(range);
    }
    let mut sources = Vec::with_capacity(file.sources.len());
    for element in &file.sources {
        let source = element.value.as_ref().and_then(|value| {
            let material =
                sphere_material(document, context, file, materials, element, &value.material)?;
            let named = (element.path.as_str(), value.clump.as_ref());
            let clump = shape(document, context, templates, named, material.1)?;
            let store = (&mut particles, &mut initial, &mut clumps);
            source(document, &element.path, value, material, clump, store)
        });
        let range = source.as_ref().map(|source| source.spheres.clone());
        context.ranges.push(range);
        sources.extend(source);
    }
    particles.shrink_to_fit();
    initial.shrink_to_fit();
    (particles, initial, clumps, sources)
}

/// The shape of the clumps of a group or source at a path, which names one or none; `None` if it was refused.
fn shape(
    document: &mut Document<'_>,
    context: &mut Context,
    templates: &[Option<Template>],
    (path, name): (&str, Option<&String>),
    material: &Material,
) -> Option<Option<ClumpShape>> {
    let Some(name) = name else {
        return Some(None);
    };
    let key = format!("{path}.clump");
    let rank = context.clumps.resolve(document, &key, name)?;
    let template = templates[rank].as_ref()?;
    template.shape(document, &key, material.density).map(Some)
}

/// The material of a group or a source of spheres; it must have a density.
fn sphere_material<'a, T>(
    document: &mut Document<'_>,
    context: &Context,
    file: &SceneFile,
    materials: &'a [Material],
    element: &Entry<T>,
    name: &str,
) -> Option<(u16, &'a Material)> {
    let key = format!("{}.material", element.path);
    let index = context.materials.resolve(document, &key, name)?;
    let typed = &file.materials[index];
    if typed.value.as_ref().is_some_and(|m| m.density.is_none()) {
        let help = format!(
            "`{}` uses it for spheres: add `density = ...` in kg/m^3",
            element.path
        );
        document.error(&typed.path, "missing key `density`", help);
    }
    Some((u16::try_from(index).ok()?, materials.get(index)?))
}

fn loads(
    document: &mut Document<'_>,
    context: &Context,
    elements: &[Entry<file::Load>],
    initial: &Kinematics,
) -> Vec<PointLoad> {
    let loads = elements.iter().filter_map(|element| {
        let value = element.value.as_ref()?;
        let sphere = held(document, context, initial, &element.path, &value.sphere)?;
        Some(PointLoad {
            sphere,
            arm: arm(initial, sphere, value.point),
            force: value.force.into(),
        })
    });
    loads.collect()
}

/// A point \[m\] from the centre of `sphere` at t = 0, world axes, in the sphere's own axes.
fn arm(initial: &Kinematics, sphere: usize, point: file::Vector) -> Vec3 {
    initial.orientation[sphere].inverse() * Vec3::from(point)
}

/// The sphere that the element at `path` pushes or holds: one that is there from the start.
fn held(
    document: &mut Document<'_>,
    context: &Context,
    initial: &Kinematics,
    path: &str,
    text: &str,
) -> Option<usize> {
    let path = format!("{path}.sphere");
    let sphere = context.sphere(document, &path, text)?;
    let found = format!("`{text}`, which waits in a source");
    let expected = "a sphere of a group `[[spheres]]`";
    document
        .demand(initial.present[sphere], path, found, expected)
        .then_some(sphere)
}

fn springs(
    document: &mut Document<'_>,
    context: &Context,
    elements: &[Entry<file::Spring>],
    initial: &Kinematics,
) -> Vec<Spring> {
    let springs = elements.iter().filter_map(|element| {
        let (path, value) = (&element.path, element.value.as_ref()?);
        let stiffness = value.stiffness;
        document.positive((path, "stiffness"), stiffness, "a stiffness > 0 [N/m]");
        let motion = match &value.motion {
            Some(given) => {
                let path = format!("{path}.motion");
                let motion = motion(document, &path, given);
                motion.filter(|motion| {
                    let expected = "translations only: the target is a point, which cannot turn";
                    document.demand(!turns(motion), path, "a rotation", expected)
                })
            }
            None => Some(Motion::Fixed),
        };
        let sphere = held(document, context, initial, path, &value.sphere)?;
        let start = initial.position[sphere] + Vec3::from(value.point);
        Some(Spring {
            sphere,
            arm: arm(initial, sphere, value.point),
            stiffness,
            target: value.target.map_or(start, Vec3::from),
            motion: motion?,
        })
    });
    springs.collect()
}

fn sensors(
    document: &mut Document<'_>,
    boundaries: &Names,
    elements: &[Entry<file::Sensor>],
) -> Vec<Sensor> {
    Names::declare(document, "sensor", elements);
    let sensors = elements.iter().filter_map(|element| {
        let (path, value) = (&element.path, element.value.as_ref()?);
        let measure = match (&value.region, &value.mass_flow, &value.wrench) {
            (Some(given), None, None) => {
                let path = format!("{path}.region");
                Measure::Region(measured(document, &path, given)?)
            }
            (None, None, Some(name)) => Measure::Wrench {
                boundary: boundaries.resolve(document, &format!("{path}.wrench"), name)?,
            },
            (None, Some(flow), None) => mass_flow(document, &format!("{path}.mass_flow"), flow)?,
            (region, flow, wrench) => {
                let given = [region.is_some(), flow.is_some(), wrench.is_some()];
                let n = given.into_iter().filter(|is| *is).count();
                return document.refuse(
                    path,
                    format!("{n} measures"),
                    "exactly one of region, mass_flow, wrench",
                );
            }
        };
        Some(Sensor {
            name: value.name.clone(),
            measure,
        })
    });
    sensors.collect()
}

/// A flow through a plane, or through a polygon in it.
fn mass_flow(document: &mut Document<'_>, path: &str, given: &file::MassFlow) -> Option<Measure> {
    match given {
        file::MassFlow::Plane(plane) => Some(Measure::MassFlow {
            point: plane.point.into(),
            normal: direction(document, &format!("{path}.plane.normal"), plane.normal)?,
            outline: Vec::new(),
        }),
        file::MassFlow::Polygon(corners) => {
            let outline: Vec<Vec3> = corners.iter().map(|&c| c.into()).collect();
            let checked = Facets::polygon(&outline);
            accept(document, &format!("{path}.polygon"), checked)?;
            // Newell's vector area: a polygon that was accepted has one.
            let area: Vec3 = (1..outline.len() - 1)
                .map(|i| (outline[i] - outline[0]).cross(&(outline[i + 1] - outline[0])))
                .sum();
            Some(Measure::MassFlow {
                point: outline[0],
                normal: area.normalize(),
                outline,
            })
        }
    }
}

/// The first, the middle and the last sphere unless the scene names its own.
fn probes(
    document: &mut Document<'_>,
    context: &Context,
    elements: &[Entry<file::Probe>],
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
                asked: false,
            })
            .collect();
    }
    let probes = elements.iter().filter_map(|element| {
        let value = element.value.as_ref()?;
        Some(Probe {
            name: value.name.clone(),
            sphere: context.sphere(document, &format!("{}.sphere", element.path), &value.sphere)?,
            asked: true,
        })
    });
    probes.collect()
}

fn output(document: &mut Document<'_>, output: Output) -> Output {
    let intervals = [
        ("vtu_interval", output.vtu_interval),
        ("csv_interval", output.csv_interval),
        ("checkpoint_interval", output.checkpoint_interval),
    ];
    for (key, value) in intervals {
        document.within(("output", key), value, 0.0.., "a time >= 0 [s]");
    }
    output
}
