//! The one table of what is measured: names, units, meanings and values.
//!
//! [`quantities`] lists what is measured of a scene, numbers and vectors; [`values`] gives their components for a state, in
//! the same order. The columns of `history.csv` and the output variables of the FMU are this list; `docs/results.md`
//! describes it.
//!
//! ```text
//! boundary.NAME.*   every boundary       source.NAME.mass   every source
//! probe.NAME.*      every probed sphere  sink.NAME.mass     every sink
//! sensor.NAME.*     every sensor         *                  the whole scene
//! ```

mod fields;
mod readings;

use super::Observation;
use super::loads::Loads;
use super::sensors::region;
use crate::scene::body::Joint;
use crate::scene::{Boundary, Measure, Motion, Scene};
use fields::{
    BODY, DRIVEN, FLOW, Field, HELD, HINGE, HINGE_HELD, HINGED, PROBE, REGION, SINK, SLIDE,
    SLIDE_HELD, SLIDING, SOURCE, WALL, WHOLE, WRENCH,
};
pub use fields::{WXYZ, XYZ};
use readings::{Body, Flow, Sphere, Whole};

/// A number or several components.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Structured name, unique.
    pub name: String,
    /// The part of the name that all owners of its kind share.
    pub field: &'static str,
    /// The boundary that it is measured of.
    pub boundary: Option<usize>,
    /// Letters of the components; none: a single number.
    pub components: &'static [&'static str],
    /// Unit; `None`: a number without unit.
    pub unit: Option<&'static str>,
    /// Whether it is a count, 0 or more.
    pub is_count: bool,
    /// Whether the scene asks for it: an output of its FMU, unless `[fmu]` says otherwise.
    pub is_asked: bool,
    /// One line for people.
    pub description: &'static str,
}

impl Quantity {
    /// How many of [`values`] it is.
    #[must_use]
    pub fn count(&self) -> usize {
        self.components.len().max(1)
    }

    /// A name for each of its values; components count from 1.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        match self.components.len() {
            0 => vec![self.name.clone()],
            count => (1..=count).map(|k| format!("{}[{k}]", self.name)).collect(),
        }
    }
}

/// What is asked for of a boundary that moves, besides what its joint has: the wrench and the pose.
const MOVING: [&str; 4] = ["averageForce", "averageTorque", "position", "orientation"];
/// What is asked for of the whole: whether the steps are as good as they should be.
const TRUST: [&str; 2] = ["maxOverlap", "solver.unconvergedSteps"];

/// All quantities of a scene, in the order of [`values`].
#[must_use]
pub fn quantities(scene: &Scene) -> Vec<Quantity> {
    let mut list = Vec::new();
    for (b, boundary) in scene.boundaries.iter().enumerate() {
        let owner = ("boundary", &*boundary.name);
        let first = list.len();
        for fields in of_boundary(boundary) {
            describe(&mut list, owner, fields);
        }
        let moves = !matches!(boundary.motion, Motion::Fixed) || boundary.belt.is_some();
        for quantity in &mut list[first..] {
            quantity.boundary = Some(b);
            let of_any = BODY.iter().any(|field| field.name == quantity.field);
            let of_wall = WALL.iter().any(|field| field.name == quantity.field);
            quantity.is_asked = of_wall || moves && (!of_any || MOVING.contains(&quantity.field));
        }
    }
    for probe in &scene.probes {
        let first = list.len();
        describe(&mut list, ("probe", &probe.name), &PROBE);
        list[first..]
            .iter_mut()
            .for_each(|quantity| quantity.is_asked = probe.asked);
    }
    for sensor in &scene.sensors {
        let owner = ("sensor", &*sensor.name);
        match &sensor.measure {
            Measure::Region(_) => describe(&mut list, owner, &REGION),
            Measure::Wrench { .. } => describe(&mut list, owner, &WRENCH),
            Measure::MassFlow { .. } => describe(&mut list, owner, &FLOW),
        }
    }
    for source in &scene.sources {
        describe(&mut list, ("source", &source.name), &SOURCE);
    }
    for sink in &scene.sinks {
        describe(&mut list, ("sink", &sink.name), &SINK);
    }
    let first = list.len();
    describe(&mut list, ("", ""), &WHOLE);
    for quantity in &mut list[first..] {
        quantity.is_asked = TRUST.contains(&quantity.field);
    }
    if scene.pairs.coheres() {
        describe(&mut list, ("", ""), &HELD);
    }
    list
}

/// What is measured of a boundary.
fn of_boundary(boundary: &Boundary) -> Vec<&'static [Field<Body>]> {
    let mut list: Vec<&[_]> = vec![&BODY];
    let motion = &boundary.motion;
    let (along, body, held): (&[_], &[_], &[_]) = match motion.joint() {
        Joint::Free => (&[], &[], &[]),
        Joint::Slide { .. } => (&SLIDE, &SLIDING, &SLIDE_HELD),
        Joint::Hinge { .. } => (&HINGE, &HINGED, &HINGE_HELD),
    };
    if let Motion::Driven(driven) = motion {
        list.extend([&DRIVEN, along, body]);
        list.extend(driven.is_held().then_some(held));
    } else {
        list.push(along);
    }
    list.extend(boundary.wall_fields.then_some(&WALL[..]));
    list
}

/// Values of all quantities, in the order of [`quantities`] and in their units.
#[must_use]
pub fn values(state: &Observation) -> Vec<f64> {
    let scene = state.scene;
    let loads = Loads::new(state, scene.probes.iter().map(|probe| probe.sphere));
    let mut list = Vec::new();
    for (b, boundary) in scene.boundaries.iter().enumerate() {
        let body = Body::of(state, &loads, b);
        for fields in of_boundary(boundary) {
            measure(&mut list, fields, &body);
        }
    }
    for (probe, load) in scene.probes.iter().zip(&loads.spheres) {
        measure(&mut list, &PROBE, &Sphere::of(state, *load, probe.sphere));
    }
    for (s, sensor) in scene.sensors.iter().enumerate() {
        match &sensor.measure {
            Measure::Region(space) => {
                measure(&mut list, &REGION, &region::Reading::of(space, state));
            }
            Measure::Wrench { boundary } => {
                measure(&mut list, &WRENCH, &state.boundaries[*boundary].mean_wrench);
            }
            Measure::MassFlow { .. } => {
                let (mass, rate) = (state.passed[s], state.flow[s]);
                measure(&mut list, &FLOW, &Flow { mass, rate });
            }
        }
    }
    for mass in state.emitted {
        measure(&mut list, &SOURCE, mass);
    }
    for mass in state.removed {
        measure(&mut list, &SINK, mass);
    }
    let whole = Whole::of(state, &loads);
    measure(&mut list, &WHOLE, &whole);
    if scene.pairs.coheres() {
        measure(&mut list, &HELD, &whole);
    }
    list
}

fn describe<T>(list: &mut Vec<Quantity>, (kind, owner): (&str, &str), fields: &[Field<T>]) {
    list.extend(fields.iter().map(|field| Quantity {
        name: match owner {
            "" => field.name.to_owned(),
            _ => format!("{kind}.{owner}.{}", field.name),
        },
        field: field.name,
        boundary: None,
        components: field.components(),
        unit: field.unit,
        is_count: field.is_count(),
        is_asked: true,
        description: field.text,
    }));
}

fn measure<T>(list: &mut Vec<f64>, fields: &[Field<T>], reading: &T) {
    for field in fields {
        field.read(reading, list);
    }
}
