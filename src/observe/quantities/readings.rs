//! What the fields are read from: one record for each boundary, probe and mass flow, and one for the whole scene.

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::observe::energy::Totals;
use crate::observe::loads::{BodyLoad, Loads};
use crate::observe::walls::Totals as WallTotals;
use crate::observe::{BoundaryState, Observation};
use crate::scene::body::Joint;
use crate::spatial::Twist;
use crate::state::{EnergyLedger, StepReport};

pub(super) struct Body {
    pub(super) load: BodyLoad,
    pub(super) state: BoundaryState,
    pub(super) position: Vec3,
    pub(super) orientation: [f64; 4],
    /// Of its slide or hinge, world; zero for all others.
    pub(super) axis: Vec3,
    /// Of its triangles; zero without `wall_fields`.
    pub(super) wall: WallTotals,
}

impl Body {
    pub(super) fn of(state: &Observation, loads: &Loads, b: usize) -> Self {
        let body = state.boundaries[b];
        let axis = match state.scene.boundaries[b].motion.joint() {
            Joint::Free => Vec3::zeros(),
            Joint::Slide { axis } | Joint::Hinge { axis } => axis,
        };
        Self {
            axis,
            wall: WallTotals::of(state, b),
            load: loads.boundaries[b],
            position: state.scene.boundaries[b].point_of_action + body.pose.translation,
            orientation: wxyz(&body.pose.rotation),
            state: body,
        }
    }

    /// Power \[W\] of the last internal step's forces: by the motion of the boundary and of its belt.
    pub(super) fn power(&self) -> f64 {
        let (wrench, twist) = (&self.state.wrench, &self.state.twist);
        wrench.force.dot(&twist.linear) + wrench.torque.dot(&twist.angular) + self.load.belt_power
    }
}

pub(super) struct Sphere {
    pub(super) load: BodyLoad,
    pub(super) position: Vec3,
    pub(super) orientation: [f64; 4],
    pub(super) velocity: Twist,
}

impl Sphere {
    pub(super) fn of(state: &Observation, load: BodyLoad, i: usize) -> Self {
        Self {
            load,
            position: state.kinematics.position[i],
            orientation: wxyz(&state.kinematics.orientation[i]),
            velocity: state.velocities.reported(i),
        }
    }
}

fn wxyz(rotation: &nalgebra::UnitQuaternion<f64>) -> [f64; 4] {
    [rotation.w, rotation.i, rotation.j, rotation.k]
}

pub(super) struct Flow {
    /// \[kg\]
    pub(super) mass: f64,
    /// \[kg/s\]
    pub(super) rate: f64,
}

pub(super) struct Whole {
    pub(super) totals: Totals,
    pub(super) body_force: Vec3,
    pub(super) work: EnergyLedger,
    pub(super) contacts: u64,
    pub(super) attached: u64,
    pub(super) bonds: u64,
    pub(super) broken_bonds: u64,
    pub(super) max_overlap: f64,
    pub(super) report: StepReport,
    pub(super) recommended_step: f64,
}

impl Whole {
    pub(super) fn of(state: &Observation, loads: &Loads) -> Self {
        let totals = Totals::of(state);
        let held =
            |by: &dyn Fn(Hold) -> bool| state.contacts.iter().filter(|c| by(c.hold)).count() as u64;
        Self {
            attached: held(&|hold| hold == Hold::Attached),
            bonds: held(&|hold| hold.is_bond()),
            broken_bonds: state.broken_bonds,
            body_force: state.body_force,
            work: state.work,
            contacts: loads.contacts,
            max_overlap: state.report.max_overlap.max(loads.max_overlap),
            report: state.report,
            recommended_step: state.recommended_step(&totals),
            totals,
        }
    }
}
