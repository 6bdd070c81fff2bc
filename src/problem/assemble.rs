//! From bodies and contacts to algebra: the only place that reads particles and contacts and writes a
//! [`Problem`].
//!
//! Terms of the paper's potential energy (eq 6) and where they are:
//!
//! | term | here |
//! |---|---|
//! | inertia | `inverse_mass`, `free` |
//! | body force, point load | `free`, by the external acceleration |
//! | constrained spring, spring of a joint | a bilateral row of compliance `1/(P_c dt^2)` and bias `(x - target)/dt` |
//! | normal contact, shear contact, friction | a contact row |
//! | (not in the paper) stop of a joint | a contact row without friction on the body alone |
//! | (not in the paper) rolling and twisting resistance | a resistance row behind all others |
//! | elastic strain, initial stress | vanish: the spheres are rigid |
//!
//! A contact that approaches faster than the threshold velocity and whose free motion closes the gap is an
//! impact: `n.u1 >= -e n.u^-`. Every other candidate carries `n.u1 >= -g/dt`. With `e = 0` an impact keeps the
//! gap constraint: it lands on the surface instead of stopping above it.

use super::{Dof6, GROUND, Grip, Law, Problem, Row};
use crate::Vec3;
use crate::contacts::law::split;
use crate::contacts::narrow_phase::Candidate;
use crate::contacts::{Key, Partner};
use crate::driven::{Hold, Kind, Ready};
use crate::materials::Pair;
use crate::motion::{Pose, Twist};
use crate::particles::Kinematics;
use crate::scene::{Integrator, Method, Scene};
use crate::solver::augmented_lagrangian::SHEAR_RATIO;

/// Rounding of a velocity that several impulses have changed, over its size \[-\].
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// What a step's problem is made from.
#[derive(Debug, Clone, Copy)]
pub struct Inputs<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// State at the start; velocities already match `step`.
    pub kinematics: &'a Kinematics,
    /// External acceleration, `[N]`.
    pub external: &'a [Dof6],
    /// The spheres as contacts see them, `[N]`.
    pub movers: &'a [Mover],
    /// Time step \[s\].
    pub step: f64,
    /// Boundary poses at the start and at the end, `[B]`; those of driven bodies at the end are without contacts.
    pub poses: [&'a [Pose]; 2],
    /// Driven bodies, `[D]`, by ascending boundary; boundaries that are not among them move as prescribed.
    pub bodies: &'a [Ready<'a>],
    /// Boundary twists over the previous step, `[B]`.
    pub twists: &'a [Twist],
    /// Velocities of the boundaries' surfaces against their shapes \[m/s\], world axes, `[B]`.
    pub surfaces: &'a [Vec3],
    /// Gravity \[m/s^2\].
    pub gravity: Vec3,
    /// Its size.
    pub gravity_size: f64,
    /// Spring targets at the end of the step \[m\], `[S]`.
    pub targets: &'a [Vec3],
    /// [`mean_acceleration`] \[m/s^2\].
    pub mean_acceleration: f64,
}

/// A sphere as its contacts see it before the step.
#[derive(Debug, Clone, Copy)]
pub struct Mover {
    /// Velocity \[m/s\].
    velocity: Vec3,
    /// Angular velocity times radius \[m/s\].
    rolling: Vec3,
    /// Square of its speed \[m^2/s^2\].
    speed: f64,
    /// Square of its external acceleration \[m^2/s^4\].
    pull: f64,
    /// Radius \[m\].
    radius: f64,
    /// Mass \[kg\].
    mass: f64,
}

impl Mover {
    /// All spheres, `[N]`, in the given memory.
    #[must_use]
    pub fn all(
        scene: &Scene,
        kinematics: &Kinematics,
        external: &[Dof6],
        mut memory: Vec<Self>,
    ) -> Vec<Self> {
        let sizes = scene.particles.radius.iter().zip(&scene.particles.mass);
        let ways = kinematics.velocity.iter().zip(&kinematics.spin);
        memory.clear();
        memory.extend(sizes.zip(ways).zip(external).map(
            |(((&radius, &mass), (velocity, spin)), external)| Self {
                velocity: *velocity,
                rolling: spin * radius,
                speed: velocity.norm_squared(),
                pull: external.linear.norm_squared(),
                radius,
                mass,
            },
        ));
        memory
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

impl<'a> Inputs<'a> {
    /// Makes `problem` one without rows: free velocities and inverse masses.
    pub fn bodies(&self, problem: &mut Problem) {
        let integrator = self.scene.settings.integrator;
        let spheres = 0..self.kinematics.len();
        problem.step = self.step;
        problem.rows.clear();
        let free = |i| integrator.free(&self.velocity(i), &self.external[i], self.step);
        problem.free.clear();
        problem.free.extend(spheres.clone().map(free));
        problem
            .free
            .extend(self.bodies.iter().map(|body| body.free));
        // The same in every step.
        if problem.inverse_mass.len() != spheres.len() {
            problem.inverse_mass.clear();
            problem.inverse_mass.extend(spheres.map(|i| Dof6 {
                linear: self.scene.particles.inverse_mass(i) * integrator.mobility(),
                angular: self.scene.particles.inverse_inertia(i) * integrator.mobility(),
            }));
        }
        problem.operators.clear();
        let operators = self.bodies.iter().map(|body| body.mobility);
        problem.operators.extend(operators);
    }

    fn velocity(&self, i: usize) -> Dof6 {
        Dof6 {
            linear: self.kinematics.velocity[i],
            angular: self.kinematics.spin[i],
        }
    }

    /// Rank and start of the driven body that a boundary is.
    #[must_use]
    pub fn body(&self, boundary: usize) -> Option<(usize, &Ready<'a>)> {
        let rank = self
            .bodies
            .binary_search_by_key(&boundary, |body| body.boundary);
        rank.ok().map(|rank| (rank, &self.bodies[rank]))
    }

    /// Largest force \[N\] that gravity and loads exert on a body of a row; zero for the ground.
    #[must_use]
    pub fn weight(&self, body: u32) -> f64 {
        let (n, i) = (self.kinematics.len(), body as usize);
        let (mass, acceleration) = if body == GROUND {
            return 0.0;
        } else if i < n {
            (self.scene.particles.mass[i], self.external[i])
        } else {
            let driven = &self.bodies[i - n];
            (driven.mass(), driven.acceleration)
        };
        mass * acceleration.linear.norm().max(self.gravity.norm())
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
    #[inline(always)]
    pub fn contact(
        &self,
        free: &[Dof6],
        candidate: &Candidate,
        force: Vec3,
        told: Option<bool>,
    ) -> (Row, bool) {
        let settings = &self.scene.settings;
        let n = candidate.normal;
        let a = candidate.key.sphere as usize;
        let own = &self.movers[a];
        let meeting = match candidate.key.partner {
            Partner::Sphere { index, .. } => self.meeting_of_spheres(free, n, own, index),
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
        let threshold = settings
            .threshold_velocity
            .max(2.0 * self.step * acceleration.max(turning));
        let impact = told.unwrap_or_else(|| {
            let freely = || n.dot(&(free[a].linear - meeting.partner));
            approach < -threshold && candidate.gap + self.step * freely() < 0.0
        });
        let rebounds =
            impact && pair.restitution > 0.0 && settings.integrator == Integrator::Moreau;
        let gap_bias = candidate.gap / self.step;
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
        (row, impact)
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
    fn meeting_of_spheres(&self, free: &[Dof6], n: Vec3, own: &Mover, index: u32) -> Meeting {
        let other = &self.movers[index as usize];
        Meeting {
            b: index,
            arm_b: n * other.radius,
            drift: Vec3::zeros(),
            radius: own.radius.min(other.radius),
            before: own.velocity - other.velocity - (own.rolling + other.rolling).cross(&n),
            partner: free[index as usize].linear,
            acceleration: self.gravity_size,
            pull: own.pull.max(other.pull),
            lightest: own.mass.min(other.mass),
            speed: own.speed.max(other.speed),
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
            pull: own.pull,
            lightest: own.mass,
            speed: own.speed,
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

    fn pair(&self, key: Key) -> Pair {
        let material = &self.scene.particles.material;
        let of_b = match key.partner {
            Partner::Sphere { index, .. } => material[index as usize],
            Partner::Boundary { boundary, .. } => {
                self.scene.boundaries[usize::from(boundary)].material
            }
        };
        self.scene.pairs.get(material[key.sphere as usize], of_b)
    }

    /// The resistance to rolling and twisting of a contact, if it has one: `row` is the contact's row, `rank` its place,
    /// `torque` \[N m\] the last couple.
    #[must_use]
    pub fn resistance(&self, key: Key, row: &Row, rank: usize, torque: Vec3) -> Option<Row> {
        let pair = self.pair(key);
        if pair.rolling_friction == 0.0 && pair.twisting_friction == 0.0 {
            return None;
        }
        let particles = &self.scene.particles;
        let locked = |i: u32| particles.inverse_inertia(i as usize) == Vec3::zeros();
        let own = particles.radius[key.sphere as usize];
        let (reduced, drift) = match key.partner {
            Partner::Sphere { index, .. } if locked(row.a) && locked(index) => return None,
            Partner::Sphere { index, .. } => {
                let other = particles.radius[index as usize];
                (own * other / (own + other), Vec3::zeros())
            }
            // A driven body turns by itself.
            Partner::Boundary { .. } if row.b != GROUND => (own, Vec3::zeros()),
            Partner::Boundary { .. } if locked(row.a) => return None,
            Partner::Boundary { boundary, .. } => {
                let [start, end] = self.poses.map(|poses| &poses[usize::from(boundary)]);
                let turning = start.twist_to(end, self.step).angular;
                (own, -turning * row.radius)
            }
        };
        let share = reduced / row.radius;
        let mut resistance = Row {
            arm_a: Vec3::zeros(),
            arm_b: Vec3::zeros(),
            drift,
            bias: Vec3::zeros(),
            compliance_n: 0.0,
            compliance_t: 0.0,
            law: Law::Resistance {
                contact: rank as u32,
                rolling: pair.rolling_friction * share,
                twisting: pair.twisting_friction * share,
            },
            ..*row
        };
        let settings = &self.scene.settings;
        if let (Method::Penalty, Some(penalty)) = (settings.method, settings.penalty) {
            // A spring as stiff as the shear spring at the lever R* keeps the twist that carried the last couple.
            let stiffness = SHEAR_RATIO * penalty * share * share;
            let compliance = 1.0 / (stiffness * self.step * self.step);
            resistance.compliance_n = compliance;
            resistance.compliance_t = compliance;
            resistance.bias = torque * (-self.step / row.radius * compliance);
        }
        Some(resistance)
    }

    /// The row of a stop or spring of driven body `rank`, and whether it is an impact: a stop is met as a wall is, without
    /// restitution.
    #[must_use]
    pub fn hold(&self, free: &[Dof6], rank: usize, hold: &Hold) -> (Row, bool) {
        let (settings, body) = (&self.scene.settings, &self.bodies[rank]);
        let particles = &self.scene.particles;
        let normal = hold.normal();
        let dt2 = self.step * self.step;
        let (law, compliance) = match (hold.kind, settings.method, settings.penalty) {
            (Kind::Spring(stiffness), ..) => (Law::Bilateral, 1.0 / (stiffness * dt2)),
            (_, Method::Penalty, Some(penalty)) => {
                (Law::Contact { mu: 0.0 }, 1.0 / (penalty * dt2))
            }
            _ => (Law::Contact { mu: 0.0 }, 0.0),
        };
        let mut row = Row {
            a: (self.kinematics.len() + rank) as u32,
            b: GROUND,
            normal,
            arm_a: hold.arm,
            arm_b: Vec3::zeros(),
            drift: Vec3::zeros(),
            bias: normal * (hold.distance / self.step),
            compliance_n: compliance,
            compliance_t: compliance,
            law,
            radius: particles
                .radius
                .iter()
                .copied()
                .fold(f64::INFINITY, f64::min),
            impulse_scale: 0.0,
        };
        let before = body.velocity.at(hold.arm).dot(&normal);
        let acceleration = body.acceleration_at(hold.arm).norm();
        let acceleration = acceleration.max(self.gravity.norm());
        let change = if acceleration > 0.0 {
            acceleration * self.step
        } else {
            before.abs()
        };
        row.impulse_scale = body.mass() * change;
        let threshold = settings
            .threshold_velocity
            .max(2.0 * self.step * acceleration);
        let closes = hold.distance + self.step * normal.dot(&row.relative_velocity(free)) < 0.0;
        (row, hold.stops() && closes && before < -threshold)
    }

    /// The row of constrained point `s`.
    #[must_use]
    pub fn spring(&self, s: usize) -> Row {
        let spring = &self.scene.springs[s];
        let i = spring.sphere;
        let arm = self.kinematics.orientation[i] * spring.arm;
        let compliance = 1.0 / (spring.stiffness * self.step * self.step);
        let stretch = self.kinematics.position[i] + arm - self.targets[s];
        Row {
            a: i as u32,
            b: GROUND,
            normal: Vec3::z(),
            arm_a: arm,
            arm_b: Vec3::zeros(),
            drift: Vec3::zeros(),
            bias: stretch / self.step,
            compliance_n: compliance,
            compliance_t: compliance,
            law: Law::Bilateral,
            radius: self.scene.particles.radius[i],
            impulse_scale: self.scene.particles.mass[i]
                * self.external[i].linear.norm()
                * self.step,
        }
    }
}

/// Acceleration \[m/s^2\] by which all loads would change the speed of all bodies together: `sum |f| / sum m` over spheres
/// with their `external` accelerations, `[N]`, and driven `bodies`. What a body on which nothing acts itself is pressed with.
#[must_use]
pub fn mean_acceleration(scene: &Scene, external: &[Dof6], bodies: &[Ready]) -> f64 {
    let masses = &scene.particles.mass;
    let spheres = external.iter().zip(masses);
    let force: f64 = spheres.map(|(a, m)| m * a.linear.norm()).sum::<f64>()
        + bodies
            .iter()
            .map(|body| body.external.linear.norm())
            .sum::<f64>();
    let mass = masses.iter().sum::<f64>() + bodies.iter().map(Ready::mass).sum::<f64>();
    if mass > 0.0 { force / mass } else { 0.0 }
}

/// Into `external` the acceleration of every sphere by gravity and point loads, `[N]`; zero where locked or absent.
pub fn external_acceleration(
    scene: &Scene,
    kinematics: &Kinematics,
    gravity: Vec3,
    external: &mut Vec<Dof6>,
) {
    let particles = &scene.particles;
    external.clear();
    external.extend((0..particles.len()).map(|i| match kinematics.present[i] {
        true => Dof6 {
            linear: particles.free(i)[0].component_mul(&gravity),
            angular: Vec3::zeros(),
        },
        false => Dof6::ZERO,
    }));
    for load in &scene.loads {
        let i = load.sphere;
        let w = Dof6 {
            linear: particles.inverse_mass(i),
            angular: particles.inverse_inertia(i),
        };
        let arm = kinematics.orientation[i] * load.arm;
        external[i].kick(&w, &Grip::Point(arm).momentum(load.force));
    }
}
