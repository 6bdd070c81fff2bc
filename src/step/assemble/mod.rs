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

mod contact;
pub mod joint;

pub use contact::Mover;

use crate::Vec3;
use crate::contact::{Key, Partner};
use crate::problem::law::SHEAR_RATIO;
use crate::problem::{GROUND, Grip, Law, Problem, Row};
use crate::scene::materials::Pair;
use crate::scene::particles::Kinematics;
use crate::scene::{Method, Scene};
use crate::spatial::{Dof6, Pose, Twist};
use crate::step::assemble::joint::{Hold, Kind};
use crate::step::driven::Ready;

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

impl<'a> Inputs<'a> {
    /// Makes `problem` one without rows: free velocities and inverse masses.
    pub fn bodies(&self, problem: &mut Problem) {
        let integrator = self.scene.settings.integrator;
        let spheres = 0..self.kinematics.len();
        problem.step = self.step;
        problem.rows.restart(&self.scene.particles.radius);
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
        mass * acceleration.linear.norm().max(self.gravity_size)
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
        let acceleration = acceleration.max(self.gravity_size);
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
