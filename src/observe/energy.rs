//! Energy, momentum and angular momentum.
//!
//! ```text
//! translational   sum m |v|^2 / 2           v, w: reported velocity at `time`
//! rotational      sum I |w|^2 / 2           I = 2/5 m R^2
//! gravity         - sum m g . c             zero at the origin of the scene
//! centrifugal     - sum m |W x (c - p)|^2 / 2 - W . J W / 2      the latter of clumps only
//! springs         sum P_c |x - t|^2 / 2     x: constrained point, t: its target; k (q - q_0)^2 / 2 of a joint
//! loads           - sum f . x               x: point of the load
//! P               sum m v_h                 v_h, w_h: half-step velocity
//! L               sum (c x m v_h + I w_h)   about the origin
//! ```
//!
//! Of a clump, mass, centre and inertia are its own, and it counts once.
//!
//! Driven bodies have kinetic energy and weight too; their loads count as work ([`crate::state::EnergyLedger`]), not as a potential.
//! Momenta are those of the spheres, on which the wrenches of all boundaries act, driven ones included. They use the
//! half-step velocity because that is the one whose change over a step is exactly the impulse of the step. Only spheres in
//! the scene count. Units: J, N s, N m s.

use super::Observation;
use crate::Vec3;
use crate::spatial::{SpatialVector, Twist};

/// Mechanical energy \[J\].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// Kinetic energy of the centres.
    pub translational: f64,
    /// Kinetic energy of the rotation.
    pub rotational: f64,
    /// Potential of gravity, zero at the origin.
    pub gravity: f64,
    /// Centrifugal potential in a rotating frame, zero on its axis.
    pub centrifugal: f64,
    /// Potential of the springs of constrained points and joints.
    pub springs: f64,
    /// Potential of the point loads, zero at the origin.
    pub loads: f64,
}

impl Energy {
    /// Energy of the state.
    #[must_use]
    pub fn of(state: &Observation) -> Self {
        Totals::of(state).energy
    }

    /// Adds what is not of single spheres: driven bodies, springs, loads.
    fn add_others(&mut self, state: &Observation) {
        let (scene, energy) = (state.scene, self);
        for (b, body) in scene.driven() {
            let (boundary, now) = (&scene.boundaries[b], &state.boundaries[b]);
            let [linear, angular] =
                body.kinetic_energy(boundary.point_of_action, &now.pose, &now.twist);
            energy.translational += linear;
            energy.rotational += angular;
            if body.gravity {
                let centre = boundary.from_frame(&now.pose, body.centre);
                energy.gravity -= body.mass * state.gravity.dot(&centre);
            }
            if let Some(spring) = &body.spring {
                let stretch = now.joint.joint_position - spring.rest;
                energy.springs += 0.5 * spring.stiffness * stretch * stretch;
            }
        }
        let present = |sphere: usize| state.kinematics.present[sphere];
        for spring in scene.springs.iter().filter(|s| present(s.sphere)) {
            let target = spring.target + spring.motion.pose_at(state.time).translation;
            let stretch = material_point(state, spring.sphere, spring.arm) - target;
            energy.springs += 0.5 * spring.stiffness * stretch.norm_squared();
        }
        for load in scene.loads.iter().filter(|l| present(l.sphere)) {
            energy.loads -= load
                .force
                .dot(&material_point(state, load.sphere, load.arm));
        }
    }

    /// Translational plus rotational.
    #[must_use]
    pub fn kinetic(&self) -> f64 {
        self.translational + self.rotational
    }

    /// Gravity, centrifugal force, springs and loads.
    #[must_use]
    pub fn potential(&self) -> f64 {
        self.gravity + self.centrifugal + self.springs + self.loads
    }
}

/// Linear and angular momentum of the spheres.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Momentum {
    /// Linear momentum \[N s\].
    pub linear: Vec3,
    /// Angular momentum about the origin \[N m s\].
    pub angular: Vec3,
}

impl Momentum {
    /// Momentum of the state, with the half-step velocities.
    #[must_use]
    pub fn of(state: &Observation) -> Self {
        Totals::of(state).momentum
    }
}

/// Sums over all spheres in the scene, formed in one pass: a master reads them after every step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Totals {
    /// Mass \[kg\].
    pub mass: f64,
    /// Number of spheres.
    pub spheres: u64,
    /// Energy, that of driven bodies, springs and loads included.
    pub energy: Energy,
    /// Momentum.
    pub momentum: Momentum,
    /// Smallest radius \[m\]; infinite where there is no sphere.
    pub(crate) smallest_radius: f64,
    /// Largest reported speed of a centre \[m/s\].
    pub(crate) largest_speed: f64,
}

impl Totals {
    /// Sums of the state.
    pub(crate) fn of(state: &Observation) -> Self {
        let particles = &state.scene.particles;
        let frame = state.scene.settings.rotating_frame.as_ref();
        let (mut energy, mut momentum) = (Energy::default(), Momentum::default());
        let (mut mass, mut spheres) = (0.0, 0);
        let (mut smallest_radius, mut square) = (f64::INFINITY, 0.0_f64);
        for i in state.present() {
            // What is of a clump as a whole comes after.
            let single = particles.clump(i).is_none();
            let own = particles.mass[i];
            let inertia = if single { particles.inertia(i) } else { 0.0 };
            let centre = state.kinematics.position[i];
            mass += own;
            spheres += 1;
            smallest_radius = particles.radius[i].min(smallest_radius);
            let velocity = state.velocities.reported(i);
            let speed = velocity.linear.norm_squared();
            square = speed.max(square);
            if single {
                energy.translational += 0.5 * own * speed;
            }
            energy.rotational += 0.5 * inertia * velocity.angular.norm_squared();
            energy.gravity -= own * state.gravity.dot(&centre);
            if let Some(frame) = frame.filter(|_| single) {
                energy.centrifugal += own * frame.potential(centre);
            }
            let velocity = state.velocities.half_step(i);
            let linear = velocity.linear * own;
            momentum.linear += linear;
            if single {
                momentum.angular += centre.cross(&linear) + velocity.angular * inertia;
            }
        }
        for clump in &state.scene.clumps {
            let first = clump.members.start;
            let (centre, rotation) = clump.place(state.kinematics);
            if !state.kinematics.present[first] {
                continue;
            }
            let [reported, half] = [
                state.velocities.reported(first),
                state.velocities.half_step(first),
            ]
            .map(|Twist { linear, angular }| {
                let of_first = SpatialVector { linear, angular };
                clump.of_member(rotation, &of_first)
            });
            let [translational, rotational] = clump.shape.kinetic_energy(rotation, &reported);
            energy.translational += translational;
            energy.rotational += rotational;
            if let Some(frame) = frame {
                let inertia = clump.shape.inertia(rotation, |moment| moment);
                energy.centrifugal += clump.shape.mass * frame.potential(centre);
                energy.centrifugal += frame.potential_of_turning(&inertia);
            }
            let half = clump.shape.momentum(rotation, &half);
            momentum.angular += centre.cross(&half.linear) + half.angular;
        }
        energy.add_others(state);
        Self {
            mass,
            spheres,
            energy,
            momentum,
            smallest_radius,
            largest_speed: square.sqrt(),
        }
    }
}

/// Where a point of a sphere is now \[m\]; `arm` \[m\] from the centre in the sphere's own axes.
fn material_point(state: &Observation, sphere: usize, arm: Vec3) -> Vec3 {
    state.kinematics.position[sphere] + state.kinematics.orientation[sphere] * arm
}

impl Observation<'_> {
    /// Internal step \[s\] at which the gap tolerance also makes forces mean something:
    /// `min(sqrt(tol R / (0.2 g)), 0.15 R / v)` with the smallest radius and the largest speed, at most the scene's.
    pub(crate) fn recommended_step(&self, totals: &Totals) -> f64 {
        let (scene, radius) = (self.scene, totals.smallest_radius);
        let of_boundaries = self.boundaries.iter().map(|b| b.twist.linear.norm());
        let speed = of_boundaries.fold(totals.largest_speed, f64::max);
        let gravity = self.gravity.norm();
        let mut step = scene.settings.step;
        if gravity > 0.0 {
            step = step.min((scene.settings.tolerance.gap * radius / (0.2 * gravity)).sqrt());
        }
        if speed > 0.0 {
            step = step.min(0.15 * radius / speed);
        }
        step
    }
}
