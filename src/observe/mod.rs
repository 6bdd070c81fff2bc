//! What is measured: read-only views of a simulation.
//!
//! [`Observation`] is what every observer reads: the state at the end of a communication step. From it come
//! [`energy`], [`loads`] and [`sensors`]; [`quantities`] is the one table of all that is measured. [`crate::results`] writes
//! files from it. Nothing in here feeds back into the solver.

mod derivatives;
pub mod energy;
pub mod loads;
pub mod quantities;
pub mod sensors;
pub mod walls;

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::{Contact, Partner};
use crate::scene::Scene;
use crate::scene::particles::Kinematics;
use crate::simulation::Simulation;
use crate::spatial::{Pose, Twist, Wrench};
use crate::state::{EnergyLedger, JointState, StepReport, Velocities, Walls};

/// A boundary at the end of a communication step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BoundaryState {
    /// Displacement from the scene.
    pub pose: Pose,
    /// Velocity \[m/s\], \[rad/s\] over the last internal step, that of a driven body at its end.
    pub twist: Twist,
    /// Velocity of its surface against its shape \[m/s\], world axes; contacts feel the part across their normal.
    pub surface_velocity: Vec3,
    /// Contact wrench over the last internal step.
    pub wrench: Wrench,
    /// Contact wrench averaged over the last communication step.
    pub mean_wrench: Wrench,
    /// Travel of a driven body's joint and the force of its stops and spring; zero for all others.
    pub joint: JointState,
}

/// The state at the end of a communication step, as observers see it.
#[derive(Debug, Clone)]
pub struct Observation<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Time \[s\].
    pub time: f64,
    /// Gravity \[m/s^2\] at `time`.
    pub gravity: Vec3,
    /// Weight, inertial forces, point loads and applied forces on all spheres \[N\], averaged over the last communication step.
    pub body_force: Vec3,
    /// Positions, orientations, the integrator's own (half-step) velocities; `[N]` each.
    pub kinematics: &'a Kinematics,
    /// Velocities at `time`, and those whose momentum the impulses balance: [`Simulation::half_step_velocity`].
    pub velocities: Velocities<'a>,
    /// Loaded contacts in canonical order: gap and point at `time`, mean force of the last internal step.
    pub contacts: Vec<Contact>,
    /// `[B]`.
    pub boundaries: Vec<BoundaryState>,
    /// Mass that has passed each sensor \[kg\], `[S]`; zero for sensors that do not cumulate.
    pub passed: &'a [f64],
    /// Mean flow of each sensor over the last communication step \[kg/s\], `[S]`; likewise.
    pub flow: &'a [f64],
    /// Mass that each source has emitted since t = 0 \[kg\], `[sources]`.
    pub emitted: &'a [f64],
    /// Mass that each sink has removed since t = 0 \[kg\], `[sinks]`.
    pub removed: &'a [f64],
    /// What the triangles of boundaries have felt: [`walls`].
    pub walls: &'a Walls,
    /// Bonds that have broken since t = 0.
    pub broken_bonds: u64,
    /// Work since t = 0.
    pub work: EnergyLedger,
    /// Report of the last communication step.
    pub report: StepReport,
}

impl<'a> Observation<'a> {
    /// The present state of `simulation`.
    #[must_use]
    pub fn of(simulation: &'a Simulation) -> Self {
        let scene: &Scene = simulation.scene();
        Self {
            scene,
            time: simulation.time(),
            gravity: simulation.gravity(),
            body_force: simulation.mean_body_force(),
            kinematics: simulation.kinematics(),
            velocities: simulation.velocities(),
            contacts: simulation.contacts(),
            boundaries: (0..scene.boundaries.len())
                .map(|b| BoundaryState {
                    pose: simulation.boundary_pose(b),
                    twist: simulation.boundary_twist(b),
                    surface_velocity: simulation.surface_velocity(b),
                    wrench: simulation.wrench(b),
                    mean_wrench: simulation.mean_wrench(b),
                    joint: simulation.joint(b),
                })
                .collect(),
            passed: &simulation.state().passed,
            flow: &simulation.state().flow,
            emitted: &simulation.state().emitted,
            removed: &simulation.state().removed,
            walls: &simulation.state().walls,
            broken_bonds: simulation.state().broken_bonds,
            work: *simulation.work(),
            report: *simulation.report(),
        }
    }

    /// Indices of the spheres that are in the scene, ascending.
    pub fn present(&self) -> impl Iterator<Item = usize> + use<'a> {
        let present = self.kinematics.present.iter().enumerate();
        present.filter(|(_, is)| **is).map(|(i, _)| i)
    }

    /// Contacts that carry a force, overlap or hold.
    pub fn active_contacts(&self) -> impl Iterator<Item = &Contact> {
        self.contacts.iter().filter(|contact| {
            contact.gap < 0.0 || contact.force != Vec3::zeros() || contact.hold != Hold::Loose
        })
    }

    /// Closest point \[m\] on body B, of the copies that touch, beside the centre of body A.
    #[must_use]
    pub fn contact_point(&self, contact: &Contact) -> Vec3 {
        let own = self.kinematics.position[contact.key.sphere as usize];
        match contact.key.partner {
            Partner::Sphere { .. } => contact.point,
            Partner::Boundary { .. } => self.scene.cell.nearest(contact.point, own),
        }
    }

    /// From the centre of body B, or the closest point on a boundary, to the centre of body A \[m\]: the copies that touch, and of
    /// members their clumps.
    pub(crate) fn branch(&self, contact: &Contact) -> [Vec3; 2] {
        let (centre, cell) = (&self.kinematics.position, &self.scene.cell);
        let own = contact.key.sphere as usize;
        match contact.key.partner {
            Partner::Sphere { index, image } => [
                self.centre(index as usize) + cell.shift(image),
                self.centre(own),
            ],
            Partner::Boundary { .. } => {
                let near = cell.nearest(centre[own], contact.point);
                // Their difference is exactly zero of a single sphere.
                [contact.point, near + (self.centre(own) - centre[own])]
            }
        }
    }

    /// Centre of mass \[m\] of what sphere `i` belongs to.
    fn centre(&self, i: usize) -> Vec3 {
        match self.scene.particles.clump(i) {
            None => self.kinematics.position[i],
            Some(clump) => self.scene.clumps[clump].place(self.kinematics).0,
        }
    }
}
