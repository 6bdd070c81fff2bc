//! The values of all outputs at a communication point: computed once, then only read.

use sphere_dda::Vec3;
use sphere_dda::contacts::{Contact, Partner};
use sphere_dda::observe::Observation;
use sphere_dda::observe::energy::{Energy, Momentum};
use sphere_dda::observe::sensors::mass_inside;
use sphere_dda::scene::{Measure, Scene};
use sphere_dda::simulation::{Simulation, StepReport, Wrench};
use sphere_dda::state::Work;

use crate::variables::{BoundaryOutput, GlobalOutput, ProbeOutput, Quantity, SensorOutput, Value};

/// Contact forces summed over one body.
#[derive(Debug, Clone, Copy, Default)]
struct Load {
    wrench: Wrench,
    count: u64,
    max_normal_force: f64,
}

impl Load {
    fn add(&mut self, contact: &Contact, wrench: Wrench) {
        self.wrench.force += wrench.force;
        self.wrench.torque += wrench.torque;
        self.count += 1;
        self.max_normal_force = self
            .max_normal_force
            .max(contact.force.dot(&contact.normal));
    }
}

#[derive(Debug, Clone)]
struct BoundaryValues {
    load: Load,
    wrench: Wrench,
    average: Wrench,
    position: Vec3,
    orientation: [f64; 4],
    power: f64,
}

#[derive(Debug, Clone)]
struct ProbeValues {
    load: Load,
    position: Vec3,
    orientation: [f64; 4],
    velocity: Vec3,
    angular_velocity: Vec3,
}

/// Reading of a sensor: mass \[kg\] and its rate \[kg/s\], zero where it has none.
#[derive(Debug, Clone, Copy)]
struct Reading {
    mass: f64,
    rate: f64,
}

/// All outputs at one communication point.
#[derive(Debug, Clone)]
pub struct Outputs {
    boundaries: Vec<BoundaryValues>,
    probes: Vec<ProbeValues>,
    sensors: Vec<Reading>,
    mass: f64,
    energy: Energy,
    work: Work,
    momentum: Momentum,
    contacts: u64,
    max_overlap: f64,
    report: StepReport,
    recommended_step: f64,
}

impl Outputs {
    /// The outputs of a simulation's present state.
    #[must_use]
    pub fn of(simulation: &Simulation) -> Self {
        let state = Observation::of(simulation);
        let scene = state.scene;
        let (on_boundaries, on_probes, contacts) = loads(&state);
        Self {
            boundaries: boundaries(&state, on_boundaries),
            probes: probes(&state, on_probes),
            sensors: sensors(&state),
            mass: scene.particles.mass.iter().sum(),
            energy: Energy::of(&state),
            work: state.work,
            momentum: Momentum::of(&state),
            contacts,
            max_overlap: state.report.max_overlap.max(state.max_overlap()),
            report: state.report,
            recommended_step: recommended_step(&state),
        }
    }

    /// The value of an output; `None` for inputs, parameters and time, which are not outputs.
    #[must_use]
    pub fn get(&self, quantity: Quantity) -> Option<Value> {
        match quantity {
            Quantity::Boundary {
                boundary,
                output,
                axis,
            } => self.boundaries.get(boundary).map(|b| b.get(output, axis)),
            Quantity::Probe {
                probe,
                output,
                axis,
            } => self.probes.get(probe).map(|p| p.get(output, axis)),
            Quantity::Sensor { sensor, output } => self.sensors.get(sensor).map(|reading| {
                Value::Real(match output {
                    SensorOutput::Mass => reading.mass,
                    SensorOutput::Rate => reading.rate,
                })
            }),
            Quantity::Global { output, axis } => Some(self.global(output, axis)),
            Quantity::Time | Quantity::Parameter(_) | Quantity::Input { .. } => None,
        }
    }

    fn global(&self, output: GlobalOutput, axis: usize) -> Value {
        let count = match output {
            GlobalOutput::ContactCount => self.contacts,
            GlobalOutput::InternalSteps => self.report.internal_steps,
            GlobalOutput::Cuts => self.report.cuts,
            GlobalOutput::Sweeps => self.report.sweeps,
            GlobalOutput::Augmentations => self.report.augmentations,
            GlobalOutput::Factorizations => self.report.factorizations,
            GlobalOutput::Mass => return Value::Real(self.mass),
            GlobalOutput::Momentum => return Value::Real(self.momentum.linear[axis]),
            GlobalOutput::AngularMomentum => return Value::Real(self.momentum.angular[axis]),
            GlobalOutput::KineticEnergy => return Value::Real(self.energy.kinetic()),
            GlobalOutput::PotentialEnergy => return Value::Real(self.energy.potential()),
            GlobalOutput::DissipatedEnergy => return Value::Real(self.work.dissipated),
            GlobalOutput::BoundaryWork => return Value::Real(self.work.boundaries),
            GlobalOutput::LoadWork => return Value::Real(self.work.loads),
            GlobalOutput::SpringWork => return Value::Real(self.work.springs),
            GlobalOutput::MaxOverlap => return Value::Real(self.max_overlap),
            GlobalOutput::GapResidual => return Value::Real(self.report.gap_residual),
            GlobalOutput::SlipResidual => return Value::Real(self.report.slip_residual),
            GlobalOutput::ForceResidual => return Value::Real(self.report.force_residual),
            GlobalOutput::RecommendedStep => return Value::Real(self.recommended_step),
        };
        integer(count)
    }
}

impl BoundaryValues {
    fn get(&self, output: BoundaryOutput, axis: usize) -> Value {
        Value::Real(match output {
            BoundaryOutput::Force => self.wrench.force[axis],
            BoundaryOutput::Torque => self.wrench.torque[axis],
            BoundaryOutput::AverageForce => self.average.force[axis],
            BoundaryOutput::AverageTorque => self.average.torque[axis],
            BoundaryOutput::Position => self.position[axis],
            BoundaryOutput::Orientation => self.orientation[axis],
            BoundaryOutput::ContactCount => return integer(self.load.count),
            BoundaryOutput::MaxNormalForce => self.load.max_normal_force,
            BoundaryOutput::Power => self.power,
        })
    }
}

impl ProbeValues {
    fn get(&self, output: ProbeOutput, axis: usize) -> Value {
        Value::Real(match output {
            ProbeOutput::Position => self.position[axis],
            ProbeOutput::Orientation => self.orientation[axis],
            ProbeOutput::Velocity => self.velocity[axis],
            ProbeOutput::AngularVelocity => self.angular_velocity[axis],
            ProbeOutput::ContactForce => self.load.wrench.force[axis],
            ProbeOutput::ContactTorque => self.load.wrench.torque[axis],
            ProbeOutput::ContactCount => return integer(self.load.count),
            ProbeOutput::MaxNormalForce => self.load.max_normal_force,
        })
    }
}

/// Counts beyond 2^31 stay there: the C interface has no larger integer.
fn integer(count: u64) -> Value {
    Value::Integer(i32::try_from(count).unwrap_or(i32::MAX))
}

fn wxyz(rotation: &nalgebra::UnitQuaternion<f64>) -> [f64; 4] {
    [rotation.w, rotation.i, rotation.j, rotation.k]
}

/// Loads on every boundary and probe, and the number of loaded contacts.
fn loads(state: &Observation) -> (Vec<Load>, Vec<Load>, u64) {
    let scene: &Scene = state.scene;
    let mut boundaries = vec![Load::default(); scene.boundaries.len()];
    let mut spheres = vec![None; scene.particles.len()];
    for probe in &scene.probes {
        spheres[probe.sphere] = Some(Load::default());
    }
    let mut count = 0;
    for contact in state.active_contacts() {
        count += 1;
        let mut sphere = |index: u32, sign: f64| {
            let index = index as usize;
            if let Some(load) = &mut spheres[index] {
                // The contact point lies at -R n from A and at +R n from B, the force on B is -F: one torque law.
                let torque = -scene.particles.radius[index] * contact.normal.cross(&contact.force);
                load.add(
                    contact,
                    Wrench {
                        force: sign * contact.force,
                        torque,
                    },
                );
            }
        };
        sphere(contact.key.sphere, 1.0);
        match contact.key.partner {
            Partner::Sphere(other) => sphere(other, -1.0),
            Partner::Boundary { boundary, .. } => {
                boundaries[usize::from(boundary)].add(contact, Wrench::default());
            }
        }
    }
    let probes = scene
        .probes
        .iter()
        .map(|probe| spheres[probe.sphere].unwrap_or_default());
    (boundaries, probes.collect(), count)
}

fn boundaries(state: &Observation, loads: Vec<Load>) -> Vec<BoundaryValues> {
    let bodies = state
        .scene
        .boundaries
        .iter()
        .zip(&state.boundaries)
        .zip(loads);
    bodies
        .map(|((boundary, body), load)| BoundaryValues {
            load,
            wrench: body.wrench,
            average: body.mean_wrench,
            position: boundary.point_of_action + body.pose.translation,
            orientation: wxyz(&body.pose.rotation),
            power: body.wrench.force.dot(&body.twist.linear)
                + body.wrench.torque.dot(&body.twist.angular),
        })
        .collect()
}

fn probes(state: &Observation, loads: Vec<Load>) -> Vec<ProbeValues> {
    let probes = state.scene.probes.iter().zip(loads);
    probes
        .map(|(probe, load)| ProbeValues {
            load,
            position: state.kinematics.position[probe.sphere],
            orientation: wxyz(&state.kinematics.orientation[probe.sphere]),
            velocity: state.velocity[probe.sphere].linear,
            angular_velocity: state.velocity[probe.sphere].angular,
        })
        .collect()
}

fn sensors(state: &Observation) -> Vec<Reading> {
    let sensors = state.scene.sensors.iter().zip(state.passed).zip(state.flow);
    sensors
        .map(|((sensor, &passed), &flow)| match &sensor.measure {
            Measure::Region(region) => Reading {
                mass: mass_inside(&state.scene.particles, &state.kinematics.position, region),
                rate: 0.0,
            },
            // Its outputs are those of the boundary.
            Measure::Wrench { .. } => Reading {
                mass: 0.0,
                rate: 0.0,
            },
            Measure::MassFlow { .. } => Reading {
                mass: passed,
                rate: flow,
            },
        })
        .collect()
}

/// Internal step \[s\] at which the gap tolerance also makes forces mean something:
/// `min(sqrt(tol R / (0.2 g)), 0.15 R / v)` with the smallest radius and the largest speed, at most the scene's.
fn recommended_step(state: &Observation) -> f64 {
    let scene = state.scene;
    let radius = scene
        .particles
        .radius
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    let of_spheres = state.velocity.iter().map(|v| v.linear.norm());
    let of_boundaries = state.boundaries.iter().map(|b| b.twist.linear.norm());
    let speed = of_spheres.chain(of_boundaries).fold(0.0, f64::max);
    let gravity = state.gravity.norm();
    let mut step = scene.settings.step;
    if gravity > 0.0 {
        step = step.min((scene.settings.tolerance.gap * radius / (0.2 * gravity)).sqrt());
    }
    if speed > 0.0 {
        step = step.min(0.15 * radius / speed);
    }
    step
}
