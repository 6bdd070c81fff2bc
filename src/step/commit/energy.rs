//! The energy ledger of a solved step.

use std::ops::Range;

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::forces::ContactForces;
use crate::detection::configuration::Configuration;
use crate::integrator::Integrator;
use crate::problem::law::split;
use crate::problem::{Law, Row};
use crate::spatial::{Pose, SpatialVector};
use crate::state::{BodyState, EnergyLedger, State};
use crate::step::commit::forces::Remains;
use crate::step::rows::elastic::ElasticContact;
use crate::step::solution::Solved;

/// What a contact loses in a step.
pub(super) struct Lost {
    /// By friction \[J\].
    pub(super) friction: f64,
    /// Along its normal, if it is a rigid impact \[J\].
    pub(super) impact: f64,
    /// Impulse along its normal \[N s\]; none of a couple.
    pub(super) impulse: f64,
    /// Velocity across it \[m/s\].
    pub(super) slip: Vec3,
}

impl Lost {
    /// Of a rigid contact with the impulse `p` \[N s\], of this part along the normal `n`, where surfaces meet with `u` \[m/s\].
    #[inline]
    fn of(u: Vec3, n: Vec3, (p, p_n): (Vec3, f64), impact: bool) -> Self {
        let along = u.dot(&n);
        Self {
            friction: -(p - n * p_n).dot(&u),
            impact: if impact { -p_n * along } else { 0.0 },
            impulse: p_n,
            slip: u - n * along,
        }
    }

    /// Adds it to `work`, and takes it from the work on the spheres that is `known` \[J\].
    #[inline]
    fn book(&self, work: &mut EnergyLedger, known: &mut f64) {
        work.friction += self.friction;
        *known -= self.friction;
        work.impact += self.impact;
        *known -= self.impact;
    }
}

/// Where the spheres and the boundaries end.
pub(super) struct End<'p> {
    position: Vec<Vec3>,
    poses: &'p [Pose],
    /// What contacts then have.
    remains: &'p Remains,
}

/// What the springs of a contact do \[J\].
pub(super) struct SpringWork {
    /// Work of the normal spring.
    normal: f64,
    /// What its damper loses, or a neck or bond that parts.
    pub(super) damped: f64,
    /// What the shear spring gives back.
    pub(super) shear: f64,
    /// What a bond's springs across the normal and its couples lose: to dampers, and where it breaks.
    bond: Option<f64>,
}

impl SpringWork {
    /// What counts as lost by friction beside the work across the normal.
    pub(super) fn slid(&self) -> f64 {
        self.bond.unwrap_or(self.shear)
    }
}

impl Solved<'_> {
    /// Adds the step's work. Lasting forces act along the displacement `dt v1`; an impact's work is `p . (u^- + u1)/2`. What
    /// contacts take across their normals is friction, along those of impacts the impact's loss. Along the normals of lasting
    /// contacts nothing is lost but by the scheme: that and all else of the change of kinetic energy is the numerical_work.
    pub(super) fn work(&self, state: &mut State, end: Option<&End>) {
        let all = 0..self.solution.impulses.len();
        let of = |_, rows| self.work_of(rows, end, &state.contacts);
        state.work = state.work + self.prediction().pool.pieces(all, of, |a, b| a + b);
        let loads: f64 = self
            .load_work(&state.applied_forces)
            .map(|(_, work)| work)
            .sum();
        state.work.loads += loads;
    }

    /// Work \[J\] of every point load, and of the forces `applied` from outside \[N\], with the sphere on which it acts.
    pub(crate) fn load_work(&self, applied: &[Vec3]) -> impl Iterator<Item = (usize, f64)> {
        let (prediction, velocity) = (self.prediction(), &self.solution.velocity);
        let loads = prediction.scene.loads.iter().map(move |load| {
            let i = load.sphere;
            let arm = prediction.kinematics.orientation[i] * load.arm;
            (i, prediction.step * load.force.dot(&velocity[i].at(arm)))
        });
        let applied = applied.iter().zip(velocity).enumerate();
        let power = move |(i, (force, v)): (usize, (&Vec3, &SpatialVector))| {
            (i, prediction.step * force.dot(&v.linear))
        };
        loads.chain(applied.map(power))
    }

    /// Where the spheres end and the boundaries with `poses`, if some contacts give way.
    pub(super) fn end<'p>(&self, poses: &'p [Pose], remains: &'p Remains) -> Option<End<'p>> {
        self.prediction().gives_way.then(|| {
            let mut position = Vec::new();
            let velocity = &self.solution.velocity;
            self.prediction().end_positions(velocity, &mut position);
            End {
                position,
                poses,
                remains,
            }
        })
    }

    /// Velocity of body `i` with which a row works: of an `impact` the mean, else that of the step.
    #[inline]
    fn working(&self, impact: bool, i: usize) -> SpatialVector {
        match impact {
            true => self.mean(i),
            false => self.solution.velocity[i],
        }
    }

    /// What the contacts and springs `range` of the rows do; `end` as [`Self::end`], `contacts` are those before.
    fn work_of(
        &self,
        range: Range<usize>,
        end: Option<&End>,
        contacts: &ContactForces,
    ) -> EnergyLedger {
        let mut work = EnergyLedger::default();
        // Work on the spheres that is accounted for.
        let mut known = 0.0;
        let rows = &self.assembly.problem.rows;
        // Up to here all rows that are of spheres are rigid and loose: nearly all.
        let assembly = self.assembly;
        let plain = match assembly.elastic.is_empty() && assembly.attraction.is_empty() {
            true => assembly.candidates.len(),
            false => 0,
        };
        for k in range {
            let p = &self.solution.impulses[k];
            if k < plain && rows.general(k).is_none() && assembly.driven_side(k).is_none() {
                if *p != Vec3::zeros() {
                    self.lost_of_spheres(k, *p).book(&mut work, &mut known);
                }
                continue;
            }
            if let (Some(elastic), Some(end)) = (self.assembly.elastic(k), end) {
                let sprung = self.work_of_spring(k, elastic, (end, contacts));
                work.contacts += sprung.normal + sprung.shear;
                work.impact += sprung.damped;
                known += sprung.normal - sprung.damped;
                // What the shear spring gives slides away, unless the force brings it to the bodies.
                work.friction += sprung.slid();
                if let Some(lost) = sprung.bond {
                    known += sprung.shear - lost;
                }
            }
            if *p == Vec3::zeros() || self.assembly.joint(k).is_some() {
                continue;
            }
            let general = rows.general(k);
            if general.is_some_and(|row| row.law == Law::Bilateral) {
                let spring = p.dot(&rows.relative(k, |i| self.solution.velocity[i]));
                work.springs += spring;
                known += spring;
                continue;
            }
            let contact = self.assembly.contact_of(k).unwrap_or(k);
            let held = self.assembly.elastic(contact);
            // Necks and bonds have their attraction in their energy.
            if held.is_none_or(|held| held.neck().is_none() && held.bond().is_none()) {
                let attracted =
                    self.work_of_attraction(k, |i| self.working(self.assembly.is_impact(k), i));
                work.contacts += attracted;
                known += attracted;
            }
            self.lost(k).book(&mut work, &mut known);
            // Of a prescribed motion, and of a belt also where its boundary is driven.
            if let Some(row) = general {
                let boundary = -p.dot(&row.prescribed_velocity);
                work.boundaries += boundary;
                known += boundary;
            }
            if let Some(driven) = self.assembly.driven_side(k) {
                let [_, grip] = rows.with(k, Row::jacobian);
                known += p.dot(&grip.velocity(&self.working(self.assembly.is_impact(k), driven)));
            }
        }
        work.numerical_work -= known;
        work
    }

    /// What the contact or the resistance of row `k` loses, but for its damper.
    pub(super) fn lost(&self, k: usize) -> Lost {
        let (rows, p) = (&self.assembly.problem.rows, self.pressing(k));
        let contact = self.assembly.contact_of(k);
        let held = contact.and_then(|contact| self.assembly.elastic(contact));
        let general = rows.general(k);
        if general.is_none() && held.is_none() && contact.is_some() {
            return self.lost_of_spheres(k, p);
        }
        let impact = self.assembly.is_impact(k);
        let working = |i| self.working(impact, i);
        let (mut u, n) = (rows.relative(k, working), rows.normal(k));
        // Friction works on the slip of the step's middle.
        if let Some(row) = general.filter(|row| row.is_contact() && row.is_rigid()) {
            u += row.across();
        }
        let couple = general.is_some_and(|row| matches!(row.law, Law::Resistance { .. }));
        // A couple of resistance is friction as a whole.
        let p_n = if couple { 0.0 } else { p.dot(&n) };
        let lost = Lost::of(u, n, (p, p_n), impact && rows.compliance(k) == 0.0);
        // The springs of a bond have all of it.
        match held.is_some_and(|held| held.bond().is_some()) {
            true => Lost {
                friction: 0.0,
                slip: Vec3::zeros(),
                ..lost
            },
            false => lost,
        }
    }

    /// [`Self::lost`] of contact `k`, which is rigid and of spheres, with the impulse `p` \[N s\].
    #[inline]
    fn lost_of_spheres(&self, k: usize, p: Vec3) -> Lost {
        let (rows, impact) = (&self.assembly.problem.rows, self.assembly.impact[k]);
        let (u, n) = (
            rows.relative(k, |i| self.working(impact, i)),
            rows.normal(k),
        );
        Lost::of(u, n, (p, p.dot(&n)), impact)
    }

    /// What the springs of a contact that gives way do. A contact that a step does not press any more loses what its springs still
    /// hold.
    pub(super) fn work_of_spring(
        &self,
        k: usize,
        elastic: &ElasticContact,
        (end, contacts): (&End, &ContactForces),
    ) -> SpringWork {
        let (assembly, rows) = (self.assembly, &self.assembly.problem.rows);
        let candidate = &assembly.candidates[k];
        let remains = end.remains;
        let end = Configuration {
            position: &end.position,
            poses: end.poses,
            ..assembly.start()
        };
        let [start, end] = [assembly.start_gap(k), end.gap(candidate)];
        let past = assembly.past[k].hold(contacts);
        let now = assembly.holds.get(k).copied().unwrap_or_default();
        let [before, after] = [elastic.energy(start, past), elastic.energy(end, now)];
        let normal = before - after;
        let speed = |velocity: &dyn Fn(usize) -> SpatialVector| rows.relative(k, velocity);
        let speeds = || {
            let before = speed(&|i| self.prediction().velocity(i));
            [before, speed(&|i| self.solution.velocity[i])]
        };
        let along = || speeds().map(|u| u.dot(&rows.normal(k)));
        let pressed = self.pressing(k) != Vec3::zeros();
        let damped = match (elastic.neck(), elastic.bond()) {
            // It has been pulled down its curve before it parts, wherever the step ends.
            (Some(neck), _) if now != Hold::Attached => neck.parted(),
            (Some(_), _) if pressed || !elastic.is_resolved() => elastic.damped(along),
            // Its damper has all but what the attraction works.
            (Some(_), _) => {
                let u = speed(&|i| self.solution.velocity[i]);
                normal - self.solution.impulses[k].dot(&u)
            }
            (None, Some(bond)) if self.breaks(k) => bond.energy(-end),
            _ => match (pressed, rows.compliance(k) == 0.0) {
                // What the scheme has missed since surfaces that adhere have touched is no loss of theirs.
                (false, _) if now == Hold::Attached && elastic.fold().is_some() => 0.0,
                (false, _) => normal,
                (true, true) => 0.0,
                (true, false) => elastic.damped(along),
            },
        };
        let stored = assembly.past[k].stored(contacts);
        let left = remains.springs[k].energy();
        let Some(bond) = elastic.bond() else {
            return SpringWork {
                normal,
                damped,
                shear: stored - left,
                bond: None,
            };
        };
        let normals = [assembly.past[k].carried(contacts).normal, candidate.normal];
        let couples = [assembly.past[k].torque(contacts), remains.couples[k]];
        let radius = rows.radius(k);
        let [old, new] = [0, 1].map(|i| {
            let couple = couples[i] / radius;
            ElasticContact::turned(bond, normals[i], couple)
        });
        let whole = self.spring_state(k).energy() + new;
        let left = if self.breaks(k) { left } else { whole };
        let across = speeds().map(|u| split(u, rows.normal(k)).1);
        SpringWork {
            normal,
            damped,
            shear: stored + old - left,
            bond: Some(whole - left + elastic.damped_across(across)),
        }
    }

    /// Adds the work on driven bodies, as [`Self::work`] does for spheres. Their weight acts along the path of the centre of mass.
    pub(super) fn body_work(
        &self,
        state: &mut State,
        finished: &[(BodyState, f64)],
        ends: &[Pose],
    ) {
        if self.prediction().bodies.is_empty() {
            return;
        }
        let (scene, step) = (self.prediction().scene, self.prediction().step);
        let integrator = scene.settings.integrator;
        let spheres = self.prediction().kinematics.len();
        let work = &mut state.work;
        let rows = &self.assembly.problem.rows;
        let all = self.solution.impulses.iter().zip(rows.all_bodies());
        for (k, (p, &[_, b])) in all.enumerate() {
            // Contacts with one have it as their body B, stops and springs of joints as A, on the ground.
            if (b as usize) < spheres {
                continue;
            }
            let (joint, driven) = (self.assembly.joint(k), self.assembly.driven_side(k));
            if joint.is_none() && driven.is_none() {
                continue;
            }
            let impact = self.assembly.is_impact(k);
            if let Some(joint) = joint {
                let done = p.dot(&rows.relative(k, |i| self.working(impact, i)));
                work.numerical_work -= done;
                match joint.limit.stops() {
                    true => work.impact -= done,
                    false => work.springs += done,
                }
            } else if let Some(driven) = driven {
                let [_, grip] = rows.with(k, Row::jacobian);
                work.numerical_work += p.dot(&grip.velocity(&self.working(impact, driven)));
            }
        }
        let bodies = self
            .prediction()
            .bodies
            .iter()
            .zip(&state.bodies)
            .zip(finished);
        for (d, ((body, before), (after, damped))) in bodies.enumerate() {
            let poses = [
                &self.prediction().poses[0][body.boundary],
                &ends[body.boundary],
            ];
            let [old, new] = [(before, poses[0], state.last_step), (after, poses[1], step)].map(
                |(carried, pose, last)| {
                    let (momentum, lasting) = (&carried.momentum, &carried.smooth);
                    body.kinetic_energy(pose, &integrator.reported(momentum, lasting, last))
                },
            );
            let at_action = body.action_velocity(&self.mean(spheres + d));
            let power =
                body.load.linear.dot(&at_action.linear) + body.load.angular.dot(&at_action.angular);
            work.loads += step * power;
            work.dampers += damped;
            let weight = body.weight_work(self.prediction().gravity, poses);
            work.numerical_work += new - old - step * power - damped - weight;
        }
    }

    /// Mean velocity of a body over the step: what an impact works with.
    fn mean(&self, i: usize) -> SpatialVector {
        match self.prediction().scene.settings.integrator {
            Integrator::Moreau => SpatialVector::ZERO
                .plus(&self.prediction().velocity(i), 0.5)
                .plus(&self.solution.velocity[i], 0.5),
            Integrator::Shi => self.solution.velocity[i],
        }
    }

    /// Adds the work of a gravity that changes to the `state` after the step, whose time is still that before.
    pub(super) fn gravity_work(&self, state: &mut State) {
        let (scene, dt) = (self.prediction().scene, self.prediction().step);
        let [from, to] = [0.0, dt].map(|after| state.gravity_at(scene, state.time + after));
        if from != to {
            let ends = self
                .prediction()
                .kinematics
                .position
                .iter()
                .zip(&state.kinematics.position);
            let middle: Vec<Vec3> = ends.map(|(a, b)| (a + b) * 0.5).collect();
            state.lift(scene, &middle, to - from);
            let heavy = self.prediction().bodies.iter().filter_map(|body| {
                let poses = [
                    &self.prediction().poses[0][body.boundary],
                    &state.poses[body.boundary],
                ];
                body.weight_moment(poses)
            });
            let moment: Vec3 = heavy.sum();
            state.work.gravity -= moment.dot(&(to - from));
        }
    }
}
