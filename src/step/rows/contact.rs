//! Rows of contacts: how two bodies meet, whether that is an impact, and the scale of its forces.

use nalgebra::UnitQuaternion;

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::history::Carried;
use crate::contact::{ContactId, Partner};
use crate::detection::configuration::Candidate;
use crate::integrator::Integrator;
use crate::problem::law::split;
use crate::problem::{GROUND, Law, Row};
use crate::spatial::SpatialVector;
use crate::step::prediction::Prediction;
use crate::step::rows::elastic::{Before, ElasticContact, Terms};
use crate::step::sphere_motion::SphereMotion;

/// Share of the tolerated overlap that is the least at which a spring has its tangent \[-\].
const UNSEEN: f64 = 1e-3;
/// Rounding of a velocity that several impulses have changed, over its size \[-\].
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The row of a contact.
pub(crate) struct ContactRow {
    pub(crate) row: Row,
    pub(crate) impact: bool,
    /// Whether it is rigid and of spheres on each other or on ground at rest.
    pub(crate) is_of_spheres: bool,
    /// How it gives way, if it does; an impact that the step does not resolve is rigid all the same.
    pub(crate) elastic: Option<ElasticContact>,
}

/// Contact point from the centre of the body that moves a sphere \[m\], `own` from that of the sphere.
#[inline]
fn arm(centre: Option<Vec3>, own: Vec3) -> Vec3 {
    centre.map_or(own, |centre| centre + own)
}

/// How the bodies of a contact meet.
struct ContactKinematics {
    b: u32,
    arm_b: Vec3,
    prescribed_velocity: Vec3,
    /// Velocity of a belt \[m/s\], with a minus.
    belt: Vec3,
    /// Smaller radius of the pair, and `1/(1/R_A + 1/R_B)`.
    radius: f64,
    reduced_radius: f64,
    /// What turning of the normal until the middle of the step adds to the velocity across it.
    rolling: Vec3,
    /// Velocity of A's surface against B's before the step.
    before: Vec3,
    /// Likewise without the spins of spheres: what turns the normal.
    centres: Vec3,
    /// Velocity of the partner at the contact without contacts.
    partner: Vec3,
    /// Largest acceleration that acts: gravity, loads, of the surface.
    acceleration: f64,
    lightest: f64,
    /// `1/(1/m_A + 1/m_B)` \[kg\].
    reduced_mass: f64,
    /// Square of the larger speed.
    speed: f64,
}

impl Prediction<'_> {
    /// Square of the external acceleration of a sphere \[m^2/s^4\].
    fn pull(&self, sphere: usize) -> f64 {
        self.external[sphere].linear.norm_squared()
    }

    /// [`Self::mover`].
    #[inline(always)]
    fn mover_of<const RIGID: bool>(&self, i: usize) -> (u32, Option<Vec3>) {
        match RIGID {
            true => (i as u32, None),
            false => self.mover(i),
        }
    }

    /// Velocity of a boundary's point that is at `x` \[m\] now, over the previous step.
    fn previous_velocity(&self, boundary: usize, x: Vec3) -> Vec3 {
        let twist = &self.twists[boundary];
        let reference = self.scene.boundaries[boundary].point_of_action;
        let pivot = reference + self.poses[0][boundary].translation;
        twist.linear + twist.angular.cross(&(x - pivot))
    }

    /// By how much the normal of a loaded contact with a prescribed boundary turns until the middle of the step.
    fn turn_of_normal(&self, candidate: &Candidate, boundary: usize, centre: Vec3) -> Vec3 {
        let own = &self.spheres[candidate.key.sphere as usize];
        let Partner::Boundary { feature, .. } = candidate.key.partner else {
            return Vec3::zeros();
        };
        let (surface, pose) = (&self.scene.boundaries[boundary], &self.poses[0][boundary]);
        let motion = &self.motions[boundary];
        let middle = centre + (own.velocity - motion.at(centre)) * (0.5 * self.step);
        let normal = pose.rotation.inverse() * candidate.normal;
        let x = surface.to_frame(pose, middle);
        let found = surface.geometry.follow(feature, normal, x, own.radius);
        if !found.gap.is_finite() {
            return Vec3::zeros();
        }
        let half = UnitQuaternion::from_scaled_axis(motion.angular * (0.5 * self.step));
        half * (pose.rotation * found.normal) - candidate.normal
    }

    /// The row of a candidate: an impact as `known_impact`, or as it finds. `free` are the velocities without contacts;
    /// `carried` is what the contact did in the last step.
    pub(crate) fn contact_row(
        &self,
        free: &[SpatialVector],
        candidate: &Candidate,
        carried: Carried,
        known_impact: Option<bool>,
    ) -> ContactRow {
        self.row_of::<false, false>(free, candidate, carried, known_impact)
    }

    /// [`Self::contact_row`] of a scene where contacts are `LOOSE`, so that nothing holds them together, or `RIGID` and of single
    /// spheres: code of what does not occur there is not compiled.
    #[inline(always)]
    pub(crate) fn row_of<const LOOSE: bool, const RIGID: bool>(
        &self,
        free: &[SpatialVector],
        candidate: &Candidate,
        carried: Carried,
        known_impact: Option<bool>,
    ) -> ContactRow {
        let n = candidate.normal;
        let hold = match LOOSE {
            true => Hold::Loose,
            false => self.hold(candidate, carried.hold),
        };
        let attraction = match hold {
            Hold::Loose => 0.0,
            hold => self.attraction(candidate.key, hold, &carried),
        };
        // What presses it, whatever attracts.
        let force = carried.force + n * attraction;
        let a = candidate.key.sphere as usize;
        let own = &self.spheres[a];
        let (body, centre) = self.mover_of::<RIGID>(a);
        let mut contact = match candidate.key.partner {
            Partner::Sphere { index, .. } => {
                self.sphere_kinematics::<RIGID>(free, n, (a, own), index)
            }
            Partner::Boundary { boundary, .. } => {
                self.boundary_kinematics(free, candidate, force, usize::from(boundary))
            }
        };
        if !RIGID && self.gives_way && !self.clumps.is_empty() {
            contact.reduced_mass = self.mass_between(candidate.key, n, &contact);
        }
        let pair = self.pair(candidate.key);
        let (approach, _) = split(contact.before, n);
        // Only a contact that was loaded can be taken for an approaching one because its normal turns.
        let turning = match force == Vec3::zeros() {
            true => 0.0,
            false => split(contact.centres, n).1.norm_squared() * candidate.curvature,
        };
        let loading = self.loading(&contact, turning);
        let loading = loading.max(attraction / contact.lightest);
        let before = (!RIGID && self.gives_way).then(|| Before {
            gap: candidate.gap,
            velocity: split(contact.before + contact.belt, n),
            pressed: carried.force.dot(&carried.normal) + attraction,
            shear: carried.shear(n),
        });
        let elastic = before.as_ref().and_then(|before| {
            self.elastic::<LOOSE>((candidate, hold), &contact, (before, loading))
        });
        let excess = match elastic {
            Some(_) => candidate.gap,
            None => {
                let settings = &self.scene.settings;
                let gap = candidate.gap - hold.rest();
                gap - settings.carried(gap, contact.radius, self.opened)
                    + settings.left(gap, contact.radius, self.step)
            }
        };
        let impact = known_impact.unwrap_or_else(|| {
            if elastic
                .as_ref()
                .is_some_and(|elastic| elastic.is_never_impact(candidate.gap))
            {
                return false;
            }
            let freely = || n.dot(&(free[a].linear - contact.partner));
            // What presses a spring may press it further.
            let brought = match &elastic {
                Some(elastic) => {
                    elastic.swing(loading.max((carried.pressed() + attraction) / contact.lightest))
                }
                None => 2.0 * self.step * loading,
            };
            let threshold = self.scene.settings.threshold_velocity;
            approach < -threshold.max(brought) && excess + self.step * freely() < 0.0
        });
        let rebound = (impact && pair.restitution > 0.0).then_some(pair.restitution * approach);
        // The impact of a contact that the step does not resolve is rigid.
        let rigid = impact && self.scene.settings.integrator == Integrator::Moreau;
        let acting = elastic.as_ref().filter(|_| !rigid);
        // As the motion before the step goes on, two spheres that touch part by more than their linear gap. A little
        // is no matter: what rests is not to follow its own noise.
        let parting = 0.5 * self.step * self.step * turning;
        let bend = match candidate.key.partner {
            Partner::Sphere { .. } if self.steady && !impact && acting.is_none() => {
                let settings = &self.scene.settings;
                let little = settings.reserve().max(settings.tolerance.gap);
                (parting - little * contact.radius).max(0.0)
            }
            _ => 0.0,
        };
        let terms = acting
            .zip(before)
            .map(|(elastic, before)| elastic.terms(&before));
        // A spring is not pushed out of its compression at once.
        let excess = if rigid && elastic.is_some() {
            excess.max(0.0)
        } else {
            excess
        };
        // A bond acts in its middle: what it does to one body it undoes to the other.
        let apart = if hold.is_bond() {
            candidate.gap.max(0.0)
        } else {
            0.0
        };
        let middle = match candidate.key.partner {
            Partner::Sphere { .. } => 0.5 * apart,
            Partner::Boundary { .. } => apart,
        };
        let (mut bias, compliance) = self.bias(terms, n, (excess + bend, rebound));
        if !impact {
            bias += contact.rolling;
        }
        let row = Row {
            a: body,
            b: contact.b,
            normal: n,
            arm_a: arm(centre, n * -(own.radius + middle)),
            arm_b: match candidate.key.partner {
                Partner::Sphere { .. } => contact.arm_b + n * middle,
                Partner::Boundary { .. } if middle > 0.0 && contact.b != GROUND => {
                    contact.arm_b - n * middle
                }
                Partner::Boundary { .. } => contact.arm_b,
            },
            prescribed_velocity: contact.prescribed_velocity,
            bias,
            compliance_n: compliance[0],
            compliance_t: compliance[1],
            law: Law::Contact {
                mu: match hold {
                    Hold::Bonded { .. } => self.held_friction(candidate.key, hold)[0],
                    Hold::Loose | Hold::Attached => pair.friction,
                },
            },
            radius: contact.radius,
            impulse_scale: self.impulse_scale(&contact, turning),
        };
        let sphere = |body: u32| body == GROUND || (body as usize) < self.kinematics.len();
        let at_rest = row.prescribed_velocity == Vec3::zeros() && contact.rolling == Vec3::zeros();
        ContactRow {
            row,
            impact,
            is_of_spheres: sphere(body)
                && sphere(contact.b)
                && at_rest
                && elastic.is_none()
                && middle == 0.0,
            elastic,
        }
    }

    /// Mass \[kg\] with which the bodies of a contact meet along its normal, where clumps take part.
    fn mass_between(&self, key: ContactId, n: Vec3, contact: &ContactKinematics) -> f64 {
        let particles = &self.scene.particles;
        let one = |i: usize| {
            let clump = particles.clump(i).map(|c| &self.clumps[c]);
            let at = self.mover(i).1.zip(clump);
            at.map_or(particles.mass[i], |(arm, clump)| clump.mass_at(arm, n))
        };
        let a = one(key.sphere as usize);
        match key.partner {
            Partner::Sphere { index, .. } => {
                let b = one(index as usize);
                a * b / (a + b)
            }
            // Of a body that is driven its share stays.
            Partner::Boundary { .. } => {
                let own = self.spheres[key.sphere as usize].mass;
                let rest = 1.0 / contact.reduced_mass - 1.0 / own;
                1.0 / (1.0 / a + rest)
            }
        }
    }

    /// Acceleration \[m/s^2\] that loads and a normal that turns by `turning` bring to a contact.
    #[inline]
    fn loading(&self, contact: &ContactKinematics, turning: f64) -> f64 {
        // Where nothing acts itself, loads elsewhere press the contact.
        let acting = match contact.acceleration {
            0.0 => self.mean_acceleration,
            acceleration => acceleration,
        };
        acting.max(turning)
    }

    /// How a contact gives way, if it does. `before` is what it was, and it is to be pressed by `loading` \[m/s^2\].
    #[inline]
    fn elastic<const LOOSE: bool>(
        &self,
        (candidate, hold): (&Candidate, Hold),
        contact: &ContactKinematics,
        (before, loading): (&Before, f64),
    ) -> Option<ElasticContact> {
        let settings = &self.scene.settings;
        let elasticity = self.scene.elasticity(candidate.key)?;
        let spring = elasticity.spring(contact.reduced_radius);
        let [a, b] = self.scene.touching(candidate.key);
        let body = (contact.reduced_mass, self.scene.pairs.damping(a, b));
        // Where nothing acts, as much as an overlap that nobody sees.
        let least = spring.own_force(UNSEEN * settings.tolerance.gap * contact.radius);
        let load = least.max(contact.lightest * loading);
        let resolves = settings.integrator == Integrator::Moreau;
        let step = (self.step, resolves, load);
        let spring = match LOOSE {
            true => spring,
            false => self.held_spring(candidate.key, hold, (spring, contact.reduced_radius)),
        };
        Some(ElasticContact::new(spring, body, before, step))
    }

    /// Bias \[m/s\] and compliances of a contact: its spring's, or rigid with a gap that exceeds what it carries by `excess` \[m\],
    /// or parting with the speed `-rebound` \[m/s\].
    #[inline]
    fn bias(
        &self,
        spring: Option<Terms>,
        n: Vec3,
        (excess, rebound): (f64, Option<f64>),
    ) -> (Vec3, [f64; 2]) {
        let rebound = rebound.filter(|_| self.scene.settings.integrator == Integrator::Moreau);
        match (spring, rebound) {
            (_, Some(rebound)) => (n * rebound, [0.0; 2]),
            (None, None) => (n * (excess / self.step), [0.0; 2]),
            (Some(Terms { along, across }), None) => {
                (n * along[0] + across.0, [along[1], across.1])
            }
        }
    }

    /// Scale of the force residual \[N s\] of a contact whose normal turns by `turning`
    /// \[m/s^2\].
    #[inline]
    fn impulse_scale(&self, contact: &ContactKinematics, turning: f64) -> f64 {
        let acceleration = contact.acceleration;
        let rounding = ROUNDING * contact.speed.sqrt() / self.scene.settings.tolerance.force;
        let mut change = match acceleration.max(turning) {
            // Where nothing accelerates, the speed of approach is a scale as well.
            0.0 => contact.before.norm(),
            acceleration => acceleration * self.step,
        };
        // Where nothing acts itself, forces are passed on from loads elsewhere.
        if acceleration == 0.0 {
            change = change.max(self.mean_acceleration * self.step);
        }
        // Rounding of the speeds is beneath any.
        contact.lightest * change.max(rounding)
    }

    #[inline(always)]
    fn sphere_kinematics<const RIGID: bool>(
        &self,
        free: &[SpatialVector],
        n: Vec3,
        (a, own): (usize, &SphereMotion),
        index: u32,
    ) -> ContactKinematics {
        let other = &self.spheres[index as usize];
        let pull = self.pull(a).max(self.pull(index as usize));
        let (b, centre) = self.mover_of::<RIGID>(index as usize);
        ContactKinematics {
            b,
            arm_b: arm(centre, n * other.radius),
            prescribed_velocity: Vec3::zeros(),
            belt: Vec3::zeros(),
            rolling: Vec3::zeros(),
            radius: own.radius.min(other.radius),
            reduced_radius: own.radius * other.radius / (own.radius + other.radius),
            before: own.velocity - other.velocity - (own.rolling + other.rolling).cross(&n),
            centres: own.velocity - other.velocity,
            partner: free[index as usize].linear,
            acceleration: self.gravity_size.max(pull.sqrt()),
            lightest: own.mass.min(other.mass),
            reduced_mass: own.mass * other.mass / (own.mass + other.mass),
            speed: own.speed().max(other.speed()),
        }
    }

    /// Across the normal a contact that lasts slips where the step's middle has it: there the surface's velocity is taken, and
    /// there the normal, by `v - (R w) x n_1/2 = (v - (R w) x n) - (R w) x (n_1/2 - n)`.
    fn boundary_kinematics(
        &self,
        free: &[SpatialVector],
        candidate: &Candidate,
        force: Vec3,
        boundary: usize,
    ) -> ContactKinematics {
        let (n, a) = (candidate.normal, candidate.key.sphere as usize);
        let own = &self.spheres[a];
        let (surface, pose) = (&self.scene.boundaries[boundary], &self.poses[0][boundary]);
        let centre = surface.copy_near(&self.scene.cell, pose, self.kinematics.position[a]);
        let point = centre - n * own.radius;
        // A belt slides along the shape: it takes no part in the approach.
        let belt = -split(self.surfaces[boundary], n).1;
        let mut contact = ContactKinematics {
            b: GROUND,
            arm_b: Vec3::zeros(),
            prescribed_velocity: belt,
            belt,
            rolling: Vec3::zeros(),
            radius: own.radius,
            reduced_radius: own.radius,
            before: own.velocity - own.rolling.cross(&n),
            centres: own.velocity,
            partner: Vec3::zeros(),
            acceleration: self.gravity_size,
            lightest: own.mass,
            reduced_mass: own.mass,
            speed: own.speed(),
        };
        let acceleration = if let Some((rank, body)) = self.body(boundary) {
            let (rank, arm) = (self.kinematics.len() + rank, point - body.reference);
            contact.b = rank as u32;
            contact.arm_b = arm;
            contact.before -= body.velocity.at(arm);
            contact.centres -= body.velocity.at(arm);
            contact.lightest = contact.lightest.min(body.mass());
            contact.reduced_mass = own.mass * body.mass() / (own.mass + body.mass());
            contact.partner = free[rank].at(arm);
            body.acceleration_at(arm).norm()
        } else {
            let motion = &self.motions[boundary];
            let (now, previous) = (motion.at(point), self.previous_velocity(boundary, point));
            contact.before -= previous;
            contact.centres -= previous;
            contact.partner = now;
            let turn = match force == Vec3::zeros() || candidate.curvature == 0.0 {
                true => Vec3::zeros(),
                false => self.turn_of_normal(candidate, boundary, centre),
            };
            let mut across = split(now, n).1;
            if force != Vec3::zeros() {
                let middle = point + own.velocity * (0.5 * self.step) - turn * own.radius;
                across = split(motion.at(middle), n).1;
                contact.rolling = -split(own.rolling.cross(&turn), n).1;
            }
            contact.prescribed_velocity -= n * now.dot(&n) + across;
            ((now - previous) / self.step + motion.centripetal(point)).norm()
        };
        contact.acceleration = contact
            .acceleration
            .max(acceleration)
            .max(self.pull(a).sqrt());
        contact
    }
}
