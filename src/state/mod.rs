//! The complete state of a simulation; as bytes: [`crate::formats::snapshot`].

mod body;
mod ledger;
mod report;
mod shared;
mod step_control;
mod velocities;
mod walls;

pub(crate) use body::BodyState;
pub use body::JointState;
pub use ledger::EnergyLedger;
pub use report::{Squeezed, StepReport};
pub use shared::SharedState;
pub(crate) use step_control::StepControl;
pub use velocities::Velocities;
pub(crate) use walls::TriangleLoads;
pub use walls::{TriangleSums, Wall, WallLoad, Walls};

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::contact::forces::ContactForces;
use crate::scene::particles::Kinematics;
use crate::scene::{Command, CommandDerivatives, Scene};
use crate::spatial::{Pose, SpatialVector, Twist, Wrench};

/// What a source has yet to emit.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Reserve {
    /// Spheres outside the scene, in the order they will be emitted.
    pub waiting: VecDeque<u32>,
    /// How much of what is due since the source's start has been emitted or forgone: spheres, or mass \[kg\].
    pub spent: f64,
    /// Number of the next draw of a place.
    pub draws: u64,
}

/// Everything that decides the future of a run.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Time \[s\].
    pub time: f64,
    /// Last internal step \[s\]; 0 before the first.
    pub last_step: f64,
    /// Gravity \[m/s^2\] as set: what [`crate::scene::gravity::GravityMotion`] moves.
    pub gravity: Vec3,
    /// Spheres; velocities are the integrator's own.
    pub kinematics: Kinematics,
    /// Acceleration by external and persisting contact forces in the last step, `[N]`.
    pub smooth: Vec<SpatialVector>,
    /// The part of `smooth` that is by external forces, `[N]`; empty unless the frame rotates.
    pub external: Vec<SpatialVector>,
    /// Forces applied from outside at the centres of the spheres \[N\], `[N]`; empty where all are zero.
    pub applied_forces: Vec<Vec3>,
    /// Weight, inertial forces, point loads and applied forces on all spheres in the last internal step \[N\].
    pub body_force: Vec3,
    /// The same averaged over the last communication step \[N\].
    pub mean_body_force: Vec3,
    /// Loaded contacts of the last step, canonical order.
    pub contacts: ContactForces,
    /// Force of each constrained spring on its sphere \[N\], `[S]`.
    pub springs: Vec<Vec3>,
    /// Boundary poses, `[B]`.
    pub poses: Vec<Pose>,
    /// Boundary twists over the last internal step, `[B]`.
    pub twists: Vec<Twist>,
    /// Driven bodies, `[D]`.
    pub bodies: Vec<BodyState>,
    /// Commands in force, `[B]`.
    pub commands: Vec<Command>,
    /// Their derivatives by time over the next communication step, `[B]`; empty where all are constant.
    pub rates: Vec<CommandDerivatives>,
    /// Wrench on each boundary over the last internal step, `[B]`.
    pub wrenches: Vec<Wrench>,
    /// Wrench on each boundary by contacts that were no impacts in the last internal step, `[B]`.
    pub smooth_wrenches: Vec<Wrench>,
    /// Wrench on each boundary averaged over the last communication step, `[B]`.
    pub mean_wrenches: Vec<Wrench>,
    /// Impulse on each boundary that the mean of the next communication step takes over from one that was too short for a mean
    /// of its own, `[B]`.
    pub owed: Vec<Wrench>,
    /// What the triangles of boundaries have felt.
    pub walls: Walls,
    /// Bonds that have broken since t = 0.
    pub broken_bonds: u64,
    /// Work since t = 0.
    pub work: EnergyLedger,
    /// Spheres of each source that wait outside the scene, `[sources]`.
    pub reserves: Vec<Reserve>,
    /// Mass each source has emitted \[kg\], `[sources]`.
    pub emitted: Vec<f64>,
    /// Mass each sink has removed \[kg\], `[sinks]`.
    pub removed: Vec<f64>,
    /// Cumulated mass of each sensor \[kg\], `[sensors]`; zero for those that do not cumulate.
    pub passed: Vec<f64>,
    /// Mean flow of each sensor over the last communication step \[kg/s\], `[sensors]`.
    pub flow: Vec<f64>,
    /// Largest overlap over radius removed by displacement before t = 0 \[-\].
    pub(crate) initial_overlap: f64,
    /// Penalty number in use \[N/m\].
    pub penalty: f64,
    /// Report of the last communication step.
    pub report: StepReport,
    /// Twice the time \[s\] by which the velocities whose momentum the impulses balance lie back: `simulation.step`, or the first communication
    /// step if that is shorter; before it the scene's. In a shorter one a change of force would count for more than it is.
    pub(crate) momentum_step: f64,
    /// Length of the next internal step.
    pub(crate) control: StepControl,
    /// Steps in a row without motion of each sphere, [`ASLEEP`] where it sleeps, `[N]`; empty where none may.
    pub(crate) calm: Vec<u32>,
    /// Boundary on which each sphere sleeps, if it does, `[N]`; empty likewise.
    pub(crate) ground: Vec<u16>,
}

/// A sphere that sleeps in [`State::calm`].
pub(crate) const ASLEEP: u32 = u32::MAX;
/// One that has fallen asleep in the last step: its forces have not been balanced yet.
pub(crate) const FALLEN: u32 = ASLEEP - 1;

/// A [`Clone`] of all `fields` that copies into the memory that there is, which the derived one does not.
macro_rules! clone_in_place {
    ($($field:ident)*) => {
        impl Clone for State {
            fn clone(&self) -> Self {
                Self {
                    $($field: self.$field.clone(),)*
                }
            }

            fn clone_from(&mut self, other: &Self) {
                $(self.$field.clone_from(&other.$field);)*
            }
        }
    };
}

clone_in_place! {
    time last_step gravity kinematics smooth external applied_forces body_force mean_body_force contacts
    springs poses twists bodies commands rates wrenches smooth_wrenches mean_wrenches owed walls broken_bonds work reserves
    emitted removed passed flow initial_overlap penalty report momentum_step control calm ground
}

impl State {
    /// Whether every array is as long as the scene wants it, and the next step one that it admits.
    pub(crate) fn fits(&self, scene: &Scene) -> bool {
        let (spheres, boundaries) = (scene.particles.len(), scene.boundaries.len());
        let of_boundaries = [
            self.poses.len(),
            self.twists.len(),
            self.commands.len(),
            self.wrenches.len(),
            self.smooth_wrenches.len(),
            self.mean_wrenches.len(),
            self.owed.len(),
        ];
        let others = [
            (self.bodies.len(), scene.driven().count()),
            (self.springs.len(), scene.springs.len()),
            (self.reserves.len(), scene.sources.len()),
            (self.emitted.len(), scene.sources.len()),
            (self.removed.len(), scene.sinks.len()),
            (self.passed.len(), scene.sensors.len()),
            (self.flow.len(), scene.sensors.len()),
        ];
        self.kinematics.fits(spheres)
            && self.smooth.len() == spheres
            && of_boundaries == [boundaries; 7]
            && self.walls.fits(scene)
            && others.iter().all(|(found, wanted)| found == wanted)
            && [0, spheres].contains(&self.external.len())
            && [0, spheres].contains(&self.applied_forces.len())
            && [0, boundaries].contains(&self.rates.len())
            && [0, spheres].contains(&self.calm.len())
            && self.ground.len() == self.calm.len()
            && self
                .ground
                .iter()
                .all(|&b| usize::from(b) < boundaries.max(1))
            && (f64::MIN_POSITIVE..=scene.settings.step).contains(&self.control.step)
            && (0.0..=scene.settings.step).contains(&self.momentum_step)
    }

    /// Which spheres are asleep, `[N]`; empty where none is.
    pub(crate) fn asleep(&self) -> Vec<bool> {
        let asleep = |count: &u32| *count >= FALLEN;
        match self.calm.iter().any(asleep) {
            true => self.calm.iter().map(asleep).collect(),
            false => Vec::new(),
        }
    }

    /// Wakes all spheres.
    pub(crate) fn wake(&mut self) {
        self.calm.fill(0);
    }

    /// Gravity \[m/s^2\] at time `t` \[s\].
    pub(crate) fn gravity_at(&self, scene: &Scene, t: f64) -> Vec3 {
        scene.settings.gravity_motion.at(self.gravity, t)
    }

    /// Books the potential energy `-m x . change` of a change of gravity \[m/s^2\] with the spheres at `position` \[m\], `[N]`.
    pub(crate) fn lift(&mut self, scene: &Scene, position: &[Vec3], change: Vec3) {
        if change != Vec3::zeros() {
            let spheres = position.iter().zip(&scene.particles.mass);
            let present = spheres.zip(&self.kinematics.present).filter(|(_, is)| **is);
            let moment: Vec3 = present.map(|((x, mass), _)| x * *mass).sum();
            self.work.gravity -= moment.dot(&change);
        }
    }
}
