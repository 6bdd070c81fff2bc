//! From bodies and contacts to algebra: the rows of a step's [`Problem`](crate::problem::Problem).
//!
//! Terms of the paper's potential energy (eq 6) and where they are:
//!
//! | term | here |
//! |---|---|
//! | inertia | `inverse_mass`, `free` of the problem: `Prediction::bodies` |
//! | body force, point load | `free`, by the external acceleration |
//! | constrained spring, spring of a joint | a bilateral row of compliance `1/(P_c dt^2)` and bias `(x - target)/dt` |
//! | normal contact, shear contact, friction | a contact row |
//! | (not in the paper) stop of a joint | a contact row without friction on the body alone |
//! | (not in the paper) rolling and twisting resistance | a resistance row behind all others |
//! | elastic strain, initial stress | vanish: the spheres are rigid |
//!
//! A contact that approaches faster than the threshold velocity and whose free motion closes the gap is an
//! impact: `n.u1 >= -e n.u^-`. Every other candidate carries `n.u1 >= -g/dt`. With `e = 0` an impact keeps the
//! gap constraint: it lands on the surface instead of stopping above it. Contacts that give way are in `elastic`.

pub(super) mod contact;
pub(super) mod elastic;
pub(super) mod joint;

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::{ContactId, Partner};
use crate::problem::law::SHEAR_RATIO;
use crate::problem::{GROUND, Law, Row};
use crate::scene::Method;
use crate::scene::materials::Pair;
use crate::spatial::SpatialVector;
use crate::step::prediction::Prediction;
use crate::step::rows::elastic::ElasticContact;
use crate::step::rows::joint::{JointLimit, Kind};

impl Prediction<'_> {
    /// Largest force \[N\] that gravity and loads exert on a body of a row; zero for the ground.
    pub(super) fn weight(&self, body: u32) -> f64 {
        let (n, i) = (self.kinematics.len(), body as usize);
        let (mass, acceleration) = if body == GROUND {
            return 0.0;
        } else if i < n {
            (self.scene.particles.mass[i], self.external[i])
        } else if let Some(driven) = self.bodies.get(i - n) {
            (driven.mass(), driven.acceleration)
        } else {
            let clump = &self.clumps[i - n - self.bodies.len()];
            (clump.clump.shape.mass, clump.acceleration)
        };
        mass * acceleration.linear.norm().max(self.gravity_size)
    }

    /// The properties of a contact.
    pub(super) fn pair(&self, key: ContactId) -> &Pair {
        let [a, b] = self.scene.touching(key);
        self.scene.pairs.between(a, b)
    }

    /// The resistance to rolling and twisting of a contact and what holds it, if it has one: `row` is the contact's row, `rank` its place,
    /// `torque` \[N m\] the last couple.
    pub(super) fn resistance(
        &self,
        (key, hold): (ContactId, Hold),
        row: &Row,
        rank: usize,
        torque: Vec3,
    ) -> Option<Row> {
        let [_, rolling, twisting] = self.held_friction(key, hold);
        if rolling == 0.0 && twisting == 0.0 {
            return None;
        }
        let particles = &self.scene.particles;
        let locked = |i: u32| particles.free(i as usize)[1] == Vec3::zeros();
        let prescribed_velocity = match key.partner {
            Partner::Sphere { index, .. } if locked(key.sphere) && locked(index) => return None,
            Partner::Sphere { .. } => Vec3::zeros(),
            // A driven body turns by itself.
            Partner::Boundary { .. } if row.b != GROUND => Vec3::zeros(),
            Partner::Boundary { .. } if locked(key.sphere) => return None,
            Partner::Boundary { boundary, .. } => {
                let [start, end] = self
                    .poses
                    .each_ref()
                    .map(|poses| &poses[usize::from(boundary)]);
                let turning = start.twist_to(end, self.step).angular;
                -turning * row.radius
            }
        };
        let share = particles.reduced_radius(key) / row.radius;
        let mut resistance = Row {
            arm_a: Vec3::zeros(),
            arm_b: Vec3::zeros(),
            prescribed_velocity,
            bias: Vec3::zeros(),
            compliance_n: 0.0,
            compliance_t: 0.0,
            law: Law::Resistance {
                contact: rank as u32,
                rolling: rolling * share,
                twisting: twisting * share,
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

    /// Lets the row of a resistance be the bending and twisting spring of the bond of `elastic`, whose couple \[N m\] was `torque`.
    pub(super) fn spring_couple(
        &self,
        elastic: Option<&ElasticContact>,
        torque: Vec3,
        row: &mut Row,
    ) {
        let Some((elastic, bond)) = elastic.and_then(|e| Some((e, e.bond()?))) else {
            return;
        };
        let turning = row.relative(|i| self.velocity(i));
        let terms = elastic.couple(bond, row.normal, (torque / row.radius, turning));
        row.bias = row.normal * terms.along[0] + terms.across.0;
        (row.compliance_n, row.compliance_t) = (terms.along[1], terms.across.1);
    }

    /// The row of a stop or spring of driven body `rank`, and whether it is an impact: a stop acts as a boundary, without
    /// restitution. `radius` \[m\] is the scale of its gap and slip.
    pub(super) fn limit(
        &self,
        free: &[SpatialVector],
        (rank, limit): (usize, &JointLimit),
        radius: f64,
    ) -> (Row, bool) {
        let (settings, body) = (&self.scene.settings, &self.bodies[rank]);
        let normal = limit.normal();
        let dt2 = self.step * self.step;
        let (law, compliance) = match (limit.kind, settings.method, settings.penalty) {
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
            arm_a: limit.arm,
            arm_b: Vec3::zeros(),
            prescribed_velocity: Vec3::zeros(),
            bias: normal * (limit.distance / self.step),
            compliance_n: compliance,
            compliance_t: compliance,
            law,
            radius,
            impulse_scale: 0.0,
        };
        let before = body.velocity.at(limit.arm).dot(&normal);
        let acceleration = body.acceleration_at(limit.arm).norm();
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
        let closes = limit.distance + self.step * normal.dot(&row.relative_velocity(free)) < 0.0;
        (row, limit.stops() && closes && before < -threshold)
    }

    /// The row of constrained point `s`.
    pub(super) fn spring(&self, s: usize) -> Row {
        let spring = &self.scene.springs[s];
        let i = spring.sphere;
        let arm = self.kinematics.orientation[i] * spring.arm;
        let (body, centre) = self.mover(i);
        let compliance = 1.0 / (spring.stiffness * self.step * self.step);
        let stretch = self.kinematics.position[i] + arm - self.targets[s];
        Row {
            a: body,
            b: GROUND,
            normal: Vec3::z(),
            arm_a: centre.map_or(arm, |centre| centre + arm),
            arm_b: Vec3::zeros(),
            prescribed_velocity: Vec3::zeros(),
            bias: stretch / self.step,
            compliance_n: compliance,
            compliance_t: compliance,
            law: Law::Bilateral,
            radius: self.scene.particles.radius[i],
            impulse_scale: self.spheres[i].mass * self.external[i].linear.norm() * self.step,
        }
    }
}
