//! Rows of contacts: how two bodies meet, whether that is an impact, and the scale of its forces.

use super::Inputs;
use crate::Vec3;
use crate::contact::Partner;
use crate::detection::narrow_phase::Candidate;
use crate::integrator::Integrator;
use crate::problem::law::{SHEAR_RATIO, split};
use crate::problem::{GROUND, Law, Row};
use crate::scene::particles::Kinematics;
use crate::scene::{Method, Scene};
use crate::spatial::Dof6;

/// Rounding of a velocity that several impulses have changed, over its size \[-\].
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A sphere as its contacts see it before the step.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub struct Mover {
    /// Velocity \[m/s\].
    velocity: Vec3,
    /// Angular velocity times radius \[m/s\].
    rolling: Vec3,
    /// Radius \[m\].
    radius: f64,
    /// Mass \[kg\].
    mass: f64,
}

impl Mover {
    /// All spheres, `[N]`, in the given memory.
    #[must_use]
    pub fn all(scene: &Scene, kinematics: &Kinematics, mut memory: Vec<Self>) -> Vec<Self> {
        let sizes = scene.particles.radius.iter().zip(&scene.particles.mass);
        let ways = kinematics.velocity.iter().zip(&kinematics.spin);
        memory.clear();
        memory.extend(
            sizes
                .zip(ways)
                .map(|((&radius, &mass), (velocity, spin))| Self {
                    velocity: *velocity,
                    rolling: spin * radius,
                    radius,
                    mass,
                }),
        );
        memory
    }

    /// Square of its speed \[m^2/s^2\].
    fn speed(&self) -> f64 {
        self.velocity.norm_squared()
    }
}

/// How the bodies of a contact meet.
struct Meeting {
    b: u32,
    arm_b: Vec3,
    drift: Vec3,
    /// Smaller radius of the pair.
    radius: f64,
    /// Velocity of A's surface against B's before the step.
    before: Vec3,
    /// Velocity of the partner at the contact without contacts.
    partner: Vec3,
    /// Accelerations that act: of the wall, and the largest external one of the spheres, squared.
    acceleration: f64,
    pull: f64,
    lightest: f64,
    /// Square of the larger speed.
    speed: f64,
    stiffness: Option<f64>,
}

impl Inputs<'_> {
    /// Square of the external acceleration of a sphere \[m^2/s^4\].
    fn pull(&self, sphere: usize) -> f64 {
        self.external[sphere].linear.norm_squared()
    }

    /// Velocity of a boundary's material point at `x` \[m\], over this step and over the previous one.
    fn wall_velocity(&self, boundary: usize, x: Vec3) -> [Vec3; 2] {
        let wall = &self.scene.boundaries[boundary];
        let [start, end] = self.poses.map(|poses| &poses[boundary]);
        let now = if start == end {
            Vec3::zeros()
        } else {
            (wall.from_frame(end, wall.to_frame(start, x)) - x) / self.step
        };
        let twist = &self.twists[boundary];
        let pivot = wall.point_of_action + start.translation;
        [now, twist.linear + twist.angular.cross(&(x - pivot))]
    }

    /// The row of a candidate, and whether it is an impact: as `told`, or as it finds. `force` \[N\] is the contact's last one.
    #[must_use]
    pub fn contact(
        &self,
        free: &[Dof6],
        candidate: &Candidate,
        force: Vec3,
        told: Option<bool>,
    ) -> (Row, bool) {
        let (row, impact, _) = self.meet(free, candidate, force, told);
        (row, impact)
    }

    /// [`Self::contact`], and whether it is rigid and of spheres on each other or on ground at rest.
    #[inline(always)]
    pub(crate) fn meet(
        &self,
        free: &[Dof6],
        candidate: &Candidate,
        force: Vec3,
        told: Option<bool>,
    ) -> (Row, bool, bool) {
        let settings = &self.scene.settings;
        let n = candidate.normal;
        let a = candidate.key.sphere as usize;
        let own = &self.movers[a];
        let meeting = match candidate.key.partner {
            Partner::Sphere { index, .. } => self.meeting_of_spheres(free, n, (a, own), index),
            Partner::Boundary { boundary, .. } => {
                self.meeting_with_boundary(free, n, (a, own), usize::from(boundary))
            }
        };
        let acceleration = meeting.acceleration.max(meeting.pull.sqrt());
        let pair = self.pair(candidate.key);
        let (approach, sliding) = split(meeting.before, n);
        // Only a contact that was loaded can be taken for an approaching one because its normal turns.
        let turning = match force == Vec3::zeros() {
            true => 0.0,
            false => sliding.norm_squared() * candidate.curvature,
        };
        // Where nothing acts itself, loads elsewhere press the contact.
        let acting = match acceleration {
            0.0 => self.mean_acceleration,
            acceleration => acceleration,
        };
        let threshold = settings
            .threshold_velocity
            .max(2.0 * self.step * acting.max(turning));
        let excess = candidate.gap - settings.carried(candidate.gap, meeting.radius);
        let impact = told.unwrap_or_else(|| {
            let freely = || n.dot(&(free[a].linear - meeting.partner));
            approach < -threshold && excess + self.step * freely() < 0.0
        });
        let rebounds =
            impact && pair.restitution > 0.0 && settings.integrator == Integrator::Moreau;
        let gap_bias = excess / self.step;
        let mut bias = n * match rebounds {
            true => pair.restitution * approach,
            false => gap_bias,
        };
        let mut compliance = [0.0; 2];
        let dt2 = self.step * self.step;
        if let (Method::Penalty, Some(penalty)) = (settings.method, settings.penalty) {
            compliance = [1.0, SHEAR_RATIO].map(|ratio| 1.0 / (ratio * penalty * dt2));
            // The shear spring keeps the stretch that carried the last force.
            bias = n * gap_bias - split(force * self.step, n).1 * compliance[1];
        } else if let Some(stiffness) = meeting.stiffness {
            compliance[0] = 1.0 / (stiffness * dt2);
        }
        let row = Row {
            a: a as u32,
            b: meeting.b,
            normal: n,
            arm_a: n * -own.radius,
            arm_b: meeting.arm_b,
            drift: meeting.drift,
            bias,
            compliance_n: compliance[0],
            compliance_t: compliance[1],
            law: Law::Contact { mu: pair.friction },
            radius: meeting.radius,
            impulse_scale: self.impulse_scale(&meeting, acceleration, turning),
        };
        let sphere = meeting.b == GROUND || (meeting.b as usize) < self.kinematics.len();
        let plain = sphere && row.drift == Vec3::zeros() && compliance == [0.0; 2];
        (row, impact, plain)
    }

    /// Scale of the force residual \[N s\] of a contact on which `acceleration` acts, while its normal turns by `turning`
    /// \[m/s^2\].
    #[inline]
    fn impulse_scale(&self, meeting: &Meeting, acceleration: f64, turning: f64) -> f64 {
        let rounding = ROUNDING * meeting.speed.sqrt() / self.scene.settings.tolerance.force;
        let mut change = match acceleration.max(turning) {
            // Where nothing accelerates, the speed of approach is a scale as well.
            0.0 => meeting.before.norm(),
            acceleration => acceleration * self.step,
        };
        // Where nothing acts itself, forces are passed on from loads elsewhere.
        if acceleration == 0.0 {
            change = change.max(self.mean_acceleration * self.step);
        }
        // Rounding of the speeds is beneath any.
        meeting.lightest * change.max(rounding)
    }

    #[inline(always)]
    fn meeting_of_spheres(
        &self,
        free: &[Dof6],
        n: Vec3,
        (a, own): (usize, &Mover),
        index: u32,
    ) -> Meeting {
        let other = &self.movers[index as usize];
        Meeting {
            b: index,
            arm_b: n * other.radius,
            drift: Vec3::zeros(),
            radius: own.radius.min(other.radius),
            before: own.velocity - other.velocity - (own.rolling + other.rolling).cross(&n),
            partner: free[index as usize].linear,
            acceleration: self.gravity_size,
            pull: self.pull(a).max(self.pull(index as usize)),
            lightest: own.mass.min(other.mass),
            speed: own.speed().max(other.speed()),
            stiffness: None,
        }
    }

    fn meeting_with_boundary(
        &self,
        free: &[Dof6],
        n: Vec3,
        (a, own): (usize, &Mover),
        boundary: usize,
    ) -> Meeting {
        let (wall, pose) = (&self.scene.boundaries[boundary], &self.poses[0][boundary]);
        let centre = wall.copy_near(&self.scene.cell, pose, self.kinematics.position[a]);
        let point = centre - n * own.radius;
        let mut meeting = Meeting {
            b: GROUND,
            arm_b: Vec3::zeros(),
            // A belt slides along the shape: it takes no part in the approach.
            drift: -split(self.surfaces[boundary], n).1,
            radius: own.radius,
            before: own.velocity - own.rolling.cross(&n),
            partner: Vec3::zeros(),
            acceleration: self.gravity_size,
            pull: self.pull(a),
            lightest: own.mass,
            speed: own.speed(),
            stiffness: wall.stiffness,
        };
        let acceleration = if let Some((rank, body)) = self.body(boundary) {
            let (rank, arm) = (self.kinematics.len() + rank, point - body.reference);
            meeting.b = rank as u32;
            meeting.arm_b = arm;
            meeting.before -= body.velocity.at(arm);
            meeting.lightest = meeting.lightest.min(body.mass());
            meeting.partner = free[rank].at(arm);
            body.acceleration_at(arm).norm()
        } else {
            let [now, previous] = self.wall_velocity(boundary, point);
            meeting.drift -= now;
            meeting.before -= previous;
            meeting.partner = now;
            (now - previous).norm() / self.step
        };
        meeting.acceleration = meeting.acceleration.max(acceleration);
        meeting
    }
}
