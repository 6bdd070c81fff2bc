//! Forces of a solved step: of contacts, on boundaries and driven bodies, and the smooth part that the next step continues.

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::forces::{Beside, ContactForces, SpringState};
use crate::contact::{ContactForce, Partner};
use crate::problem::Law;
use crate::problem::law::split;
use crate::spatial::{Pose, SpatialVector, Wrench};
use crate::state::{BodyState, State};
use crate::step::rows::elastic::ElasticContact;
use crate::step::rows::joint::JointConstraint;
use crate::step::solution::Solved;

/// What contacts have beside their forces after the step.
pub(crate) struct Remains {
    /// Their springs, `[contacts]`; empty where none gives way.
    pub(super) springs: Vec<SpringState>,
    /// Couples \[N m\] of their resistances on A, `[contacts]`; empty where there is no resistance.
    pub(super) couples: Vec<Vec3>,
}

impl Solved<'_> {
    /// What contacts have after the step.
    pub(crate) fn remains(&self) -> Remains {
        let springs = match self.prediction().gives_way {
            true => self.assembly.candidates.len(),
            false => 0,
        };
        Remains {
            springs: (0..springs).map(|k| self.spring_left(k)).collect(),
            couples: match self.prediction().scene.pairs.resists() {
                true => self.assembly.couples(&self.solution.impulses),
                false => Vec::new(),
            },
        }
    }

    /// Contact forces and boundary wrenches into `state`. What sleeps keeps its forces.
    pub(crate) fn store(&self, state: &mut State, remains: &Remains) {
        let step = self.prediction().step;
        let sleeping = self.sleeping(&state.contacts);
        let mut asleep = 0;
        state.contacts.clear();
        let outside = &self.prediction().outside;
        state.wrenches.clone_from(&outside.wrenches);
        state.wrenches.resize(state.poses.len(), Wrench::default());
        state.smooth_wrenches.clone_from(&state.wrenches);
        for wall in &mut state.walls.list {
            wall.loads.clear();
            wall.smooth.clear();
        }
        let holds = &self.assembly.holds;
        for (k, candidate) in self.assembly.candidates.iter().enumerate() {
            let key = candidate.key;
            while let Some((load, beside)) = sleeping.get(asleep).filter(|(load, _)| load.key < key)
            {
                self.carry(state, *load, *beside, true);
                asleep += 1;
            }
            let same = sleeping
                .get(asleep)
                .is_some_and(|(load, _)| load.key == key);
            asleep += usize::from(same);
            let hold = holds.get(k).copied();
            if self.solution.loads(k) || hold.is_some_and(|hold| hold != Hold::Loose) {
                let (normal, force) = (candidate.normal, self.solution.impulses[k] / step);
                let load = ContactForce { key, normal, force };
                let beside = Beside {
                    torque: remains.couples.get(k).copied(),
                    spring: remains.springs.get(k).copied(),
                    hold,
                };
                self.carry(state, load, beside, !self.assembly.impact[k]);
            }
        }
        for (load, beside) in &sleeping[asleep..] {
            self.carry(state, *load, *beside, true);
        }
    }

    /// The spring of contact `k` at the end of the step.
    pub(super) fn spring_state(&self, k: usize) -> SpringState {
        let rows = &self.assembly.problem.rows;
        let (Some(elastic), Some(row)) = (self.assembly.elastic(k), rows.general(k)) else {
            return SpringState::Struck;
        };
        let Law::Contact { mu } = row.law else {
            return SpringState::Struck;
        };
        if row.is_rigid() {
            return SpringState::Struck;
        }
        let slip = split(rows.relative(k, |i| self.solution.velocity[i]), row.normal).1;
        let pressed = self.pressing(k).dot(&row.normal) / self.prediction().step;
        elastic.state_after(slip, mu * pressed)
    }

    /// What is left of the spring where the step breaks the bond that contact `k` has had in it.
    fn spring_left(&self, k: usize) -> SpringState {
        let whole = self.spring_state(k);
        match self.assembly.elastic(k) {
            Some(elastic) if self.breaks(k) => {
                let candidate = &self.assembly.candidates[k];
                let acting = self.solution.impulses[k].dot(&candidate.normal);
                let mu = self.prediction().pair(candidate.key).friction;
                elastic.state_unbound(whole, mu * acting / self.prediction().step)
            }
            _ => whole,
        }
    }

    /// Whether the step breaks the elastic bond of contact `k`.
    pub(super) fn breaks(&self, k: usize) -> bool {
        let bonded = |elastic: &ElasticContact| elastic.bond().is_some();
        self.assembly.elastic(k).is_some_and(bonded) && !self.assembly.holds[k].is_bond()
    }

    /// The contacts of spheres that sleep, with what goes with them.
    fn sleeping(&self, contacts: &ContactForces) -> Vec<(ContactForce, Beside)> {
        let prediction = self.prediction();
        if prediction.asleep.is_empty() {
            return Vec::new();
        }
        let loads = contacts.iter().enumerate();
        let sleeping = loads.filter(|(_, load)| prediction.sleeps(load.key));
        sleeping
            .map(|(k, load)| (*load, contacts.beside(k)))
            .collect()
    }

    /// Adds a contact and what it does to a boundary.
    #[inline]
    fn carry(&self, state: &mut State, load: ContactForce, beside: Beside, smooth: bool) {
        state.contacts.push(load, beside);
        if let Partner::Boundary { boundary, .. } = load.key.partner {
            self.bear(state, usize::from(boundary), (&load, beside), smooth);
        }
    }

    /// Adds what a contact does to boundary `b`.
    fn bear(
        &self,
        state: &mut State,
        b: usize,
        (load, beside): (&ContactForce, Beside),
        smooth: bool,
    ) {
        let prediction = self.prediction();
        let (scene, i) = (prediction.scene, load.key.sphere as usize);
        let (boundary, pose) = (&scene.boundaries[b], &prediction.poses[0][b]);
        let centre = boundary.copy_near(&scene.cell, pose, prediction.kinematics.position[i]);
        let sphere = (centre, scene.particles.radius[i]);
        let pivot = boundary.point_of_action + pose.translation;
        let wrench = beside.on_boundary(load, sphere, pivot);
        state.wrenches[b].add(&wrench, 1.0);
        if smooth {
            state.smooth_wrenches[b].add(&wrench, 1.0);
        }
        self.press(state, load, smooth);
    }

    pub(crate) fn spring_forces(&self) -> Vec<Vec3> {
        self.solution.impulses[self.assembly.candidates.len()..][..self.prediction().targets.len()]
            .iter()
            .map(|p| p / self.prediction().step)
            .collect()
    }

    /// What the driven bodies carry on after `solution`, and the work of their dampers \[J\], `[D]`.
    pub(crate) fn finished(&self, ends: &[Pose]) -> Vec<(BodyState, f64)> {
        let spheres = self.prediction().kinematics.len();
        let bodies = self.prediction().bodies.iter().enumerate();
        bodies
            .map(|(d, body)| {
                let [mut contacts, mut smooth] = [SpatialVector::ZERO; 2];
                let mut joint_forces = [0.0; 3];
                let rank = (spheres + d) as u32;
                for (k, &p) in self.solution.impulses.iter().enumerate() {
                    let bodies = self.assembly.problem.rows.bodies(k);
                    let Some(side) = bodies.iter().position(|&body| body == rank) else {
                        continue;
                    };
                    let push = self.assembly.problem.rows.momenta(k, p)[side];
                    if let Some(JointConstraint { limit, .. }) = self.assembly.joint(k) {
                        let force = p.dot(&limit.direction) / self.prediction().step;
                        joint_forces[limit.slot()] = force * limit.lever;
                    }
                    contacts = contacts.plus(&push, 1.0);
                    if !self.assembly.is_impact(k) {
                        smooth = smooth.plus(&push, 1.0);
                    }
                }
                let settings = &self.prediction().scene.settings;
                let impulses = [&contacts, &smooth];
                let end = &ends[body.boundary];
                body.finish(
                    settings,
                    &self.solution.velocity[spheres + d],
                    impulses,
                    joint_forces,
                    end,
                    self.prediction().step,
                )
            })
            .collect()
    }

    /// Acceleration by external forces and all contacts that are no impacts, `[N]`: what `solution` has over the free motion,
    /// less what impacts gave.
    ///
    /// That of members is theirs at the end of the step, or at its start unless it `moves` them.
    pub(crate) fn smooth_acceleration(&self, acceleration: &mut Vec<SpatialVector>, moves: bool) {
        let mobility = self.prediction().scene.settings.integrator.mobility();
        let rate = 1.0 / (mobility * self.prediction().step);
        let (velocity, free) = (&self.solution.velocity, &self.assembly.problem.free);
        let external = &self.prediction().external;
        let of_body = |i: usize| {
            // Driven bodies keep their own account.
            let external = external.get(i).unwrap_or(&SpatialVector::ZERO);
            external.plus(&velocity[i].plus(&free[i], -1.0), rate)
        };
        acceleration.resize(velocity.len(), SpatialVector::ZERO);
        let pool = &self.prediction().pool;
        pool.fill(&mut acceleration[..], of_body);
        for (k, impulse) in self.solution.impulses.iter().enumerate() {
            if *impulse != Vec3::zeros() && self.assembly.is_impact(k) {
                let row = self.assembly.problem.rows.get(k);
                self.assembly
                    .problem
                    .apply(&row, acceleration, impulse * -rate);
            }
        }
        self.accelerate_clumps(acceleration, moves);
        acceleration.truncate(self.prediction().kinematics.len());
    }
}
