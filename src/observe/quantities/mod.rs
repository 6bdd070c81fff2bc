//! The one table of what is measured: names, units, meanings and values.
//!
//! [`quantities`] lists the scalars of a scene, [`values`] gives their values for a state, in the same order. The
//! columns of `history.csv` and the output variables of the FMU are this list; `docs/results.md` describes it.
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
use crate::scene::{Measure, Motion, Scene};
use fields::{BODY, DRIVEN, FLOW, Field, HINGE, PROBE, REGION, SINK, SLIDE, SOURCE, WHOLE, WRENCH};
use readings::{Body, Flow, Sphere, Whole};

/// What kind of number a quantity is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Any number.
    Real,
    /// A count, 0 or more.
    Count,
}

/// One scalar.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Structured name, unique; components count from 1.
    pub name: String,
    /// Unit; `None`: a number without unit.
    pub unit: Option<&'static str>,
    /// Kind of number.
    pub kind: Kind,
    /// One line for people.
    pub description: String,
}

/// All quantities of a scene, in the order of [`values`].
#[must_use]
pub fn quantities(scene: &Scene) -> Vec<Quantity> {
    let mut list = Vec::new();
    for boundary in &scene.boundaries {
        let prefix = format!("boundary.{}.", boundary.name);
        describe(&mut list, &prefix, &BODY);
        if matches!(boundary.motion, Motion::Driven(_)) {
            describe(&mut list, &prefix, &DRIVEN);
        }
        describe(&mut list, &prefix, joint(&boundary.motion));
    }
    for probe in &scene.probes {
        describe(&mut list, &format!("probe.{}.", probe.name), &PROBE);
    }
    for sensor in &scene.sensors {
        let prefix = format!("sensor.{}.", sensor.name);
        match &sensor.measure {
            Measure::Region(_) => describe(&mut list, &prefix, &REGION),
            Measure::Wrench { .. } => describe(&mut list, &prefix, &WRENCH),
            Measure::MassFlow { .. } => describe(&mut list, &prefix, &FLOW),
        }
    }
    for source in &scene.sources {
        describe(&mut list, &format!("source.{}.", source.name), &SOURCE);
    }
    for sink in &scene.sinks {
        describe(&mut list, &format!("sink.{}.", sink.name), &SINK);
    }
    describe(&mut list, "", &WHOLE);
    list
}

/// What is measured of a boundary's joint.
fn joint(motion: &Motion) -> &'static [Field<Body>] {
    match motion {
        Motion::Driven(body) if body.is_held() => match body.joint {
            Joint::Slide { .. } => &SLIDE,
            Joint::Hinge { .. } => &HINGE,
            Joint::Free => &[],
        },
        _ => &[],
    }
}

/// Values of all quantities, in the order of [`quantities`] and in their units.
#[must_use]
pub fn values(state: &Observation) -> Vec<f64> {
    let scene = state.scene;
    let loads = Loads::new(state, scene.probes.iter().map(|probe| probe.sphere));
    let mut list = Vec::new();
    for (b, boundary) in scene.boundaries.iter().enumerate() {
        let body = Body::of(state, &loads, b);
        measure(&mut list, &BODY, &body);
        if matches!(boundary.motion, Motion::Driven(_)) {
            measure(&mut list, &DRIVEN, &body);
        }
        measure(&mut list, joint(&boundary.motion), &body);
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
    measure(&mut list, &WHOLE, &Whole::of(state, &loads));
    list
}

fn describe<T>(list: &mut Vec<Quantity>, prefix: &str, fields: &[Field<T>]) {
    for field in fields {
        let parts = field.components();
        let kind = field.kind();
        if parts.is_empty() {
            list.push(Quantity {
                name: format!("{prefix}{}", field.name),
                unit: field.unit,
                kind,
                description: field.text.to_owned(),
            });
        }
        for (k, part) in parts.iter().enumerate() {
            list.push(Quantity {
                name: format!("{prefix}{}[{}]", field.name, k + 1),
                unit: field.unit,
                kind,
                description: format!("{}; {part}", field.text),
            });
        }
    }
}

fn measure<T>(list: &mut Vec<f64>, fields: &[Field<T>], reading: &T) {
    for field in fields {
        field.read(reading, list);
    }
}
