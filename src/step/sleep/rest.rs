//! What falls asleep at the end of a step.
//!
//! A sphere is calm while its centre and the surfaces of its contacts are slower than `rest_speed`, and no boundary that it
//! touches moves. Spheres fall asleep that have been calm for ten steps, on a boundary, which takes the momentum that is left:
//!
//! - islands, that is spheres that hang together by loaded contacts or in one clump, where no sphere has gathered more than
//!   a thousandth of the speed that gravity would have brought since it is calm: forces balance;
//! - of other islands the parts that stand still: as slow as gravity would make them in ten thousandths of a step, with forces that
//!   balance within the tolerance, and with neighbours that do;
//! - spheres that drift: slower than a hundredth of gravity would have made them, they keep their velocity to a thousandth of it, and
//!   all that they touch stands still. They roll to and fro in gaps of a heap, or along a floor. What is pushed slowly drifts as well,
//!   but beside others that do, and stays awake.

use petgraph::unionfind::UnionFind;

use super::Sleepers;
use crate::Vec3;
use crate::contact::{ContactForce, ContactId, Partner};
use crate::scene::Scene;
use crate::spatial::{SpatialVector, Wrench};
use crate::state::{ASLEEP, FALLEN, State};
use crate::step::solution::Solved;

/// Steps without motion after which spheres may fall asleep.
const CALM: u32 = 10;
/// Largest share of gravity that may be without balance: the speed over what gravity would have brought since motion ended, or the
/// acceleration of what drifts.
const BALANCE: f64 = 1e-3;
/// Largest share of gravity that would have brought what drifts its speed.
const DRIFT: f64 = 1e-2;
/// Surface speed of a spin that no contact feels, over that of all other motion.
const SPIN: f64 = 10.0;
/// Shares of the tolerance of forces by which a body may be out of balance: to fall asleep, and, beside what is awake, to sleep on.
const FALLING: f64 = 0.5;
const WAKING: f64 = 1.0;

impl Solved<'_> {
    /// Leaves in the `acceleration` of spheres that sleep no external one: their contacts, which are no rows, balance it.
    pub(crate) fn still(&self, acceleration: &mut [SpatialVector]) {
        let prediction = self.prediction();
        for i in (0..prediction.asleep.len()).filter(|&i| prediction.asleep[i]) {
            acceleration[i] = SpatialVector::ZERO;
        }
    }

    /// Counts steps without motion and lets spheres fall asleep, at the end of a step. Of the `sleepers` those out of balance wake.
    pub(crate) fn rest(&self, state: &mut State, sleepers: &Sleepers) {
        let prediction = self.prediction();
        let scene = prediction.scene;
        if !may_rest(scene) {
            return;
        }
        state.calm.resize(scene.particles.len(), 0);
        state.ground.resize(scene.particles.len(), 0);
        for i in sleepers.beyond(WAKING) {
            state.calm[i] = 0;
        }
        let reported: Vec<_> = (0..state.calm.len())
            .map(|i| self.reported(state, i))
            .collect();
        let mut calm = self.calm_spheres(state, &reported);
        for spring in &scene.springs {
            calm[spring.sphere] = false;
        }
        let slow = scene.settings.rest_speed;
        for load in state.contacts.iter() {
            if self.slip(&reported, load) > slow || !self.is_on_ground(load.key) {
                load.key.spheres().for_each(|i| calm[i] = false);
            }
        }
        for clump in &scene.clumps {
            // A clump is calm as a whole, and a member that another one has moved is awake.
            let members = clump.members.clone();
            let whole = members.clone().all(|i| calm[i]);
            calm[members].fill(whole);
        }
        let mut due = false;
        for (i, count) in state.calm.iter_mut().enumerate() {
            if *count >= FALLEN && prediction.is_asleep(i) {
                *count = ASLEEP;
                continue;
            }
            // One that was woken counts anew.
            let before = if *count >= FALLEN { 0 } else { *count };
            *count = if calm[i] {
                (before + 1).min(FALLEN - 1)
            } else {
                0
            };
            due |= *count > 0 && *count % CALM == 0;
        }
        if due {
            self.fall_asleep(state);
        }
    }

    /// Whether each sphere is slow at its `reported` velocity, `[N]`.
    fn calm_spheres(&self, state: &State, reported: &[SpatialVector]) -> Vec<bool> {
        let scene = self.prediction().scene;
        let (slow, radius) = (scene.settings.rest_speed, &scene.particles.radius);
        let calm = |i: usize| {
            let v = &reported[i];
            state.kinematics.present[i]
                && v.linear.norm() <= slow
                && v.angular.norm() * radius[i] <= SPIN * slow
        };
        (0..radius.len()).map(calm).collect()
    }

    /// Whether sphere `i` has been slow for long enough, and is slower than forces without balance would make it.
    fn balances(&self, state: &State, i: usize) -> bool {
        self.has_gathered(state, i, (BALANCE, state.calm[i]))
    }

    /// Whether sphere `i` has been slow for long enough, and is no faster than a share of gravity would make it in so many `steps`.
    fn has_gathered(&self, state: &State, i: usize, (share, steps): (f64, u32)) -> bool {
        let time = f64::from(steps) * self.prediction().step;
        let speed = self.reported(state, i).linear.norm();
        state.calm[i] >= CALM && speed <= share * self.pull() * time
    }

    /// Gravity \[m/s^2\], or what loads would accelerate all by.
    fn pull(&self) -> f64 {
        match self.prediction().gravity_size {
            0.0 => self.prediction().mean_acceleration,
            gravity => gravity,
        }
    }

    fn reported(&self, state: &State, i: usize) -> SpatialVector {
        let integrator = self.prediction().scene.settings.integrator;
        let velocity = state.kinematics.spatial_velocity(i);
        integrator.reported(&velocity, &state.smooth[i], self.prediction().step)
    }

    /// Speed of the surfaces of a contact against each other, on a boundary at rest \[m/s\], at the `reported` velocities, `[N]`.
    fn slip(&self, reported: &[SpatialVector], load: &ContactForce) -> f64 {
        let radius = &self.prediction().scene.particles.radius;
        let one = |i: usize| {
            let v = &reported[i];
            (v.linear, v.angular * radius[i])
        };
        let (own, spin) = one(load.key.sphere as usize);
        let (apart, turning) = match load.key.partner {
            Partner::Sphere { index, .. } => {
                let (other, turning) = one(index as usize);
                (own - other, spin + turning)
            }
            Partner::Boundary { .. } => (own, spin),
        };
        (apart - turning.cross(&load.normal)).norm()
    }

    /// Whether a contact is between spheres or with a boundary that does not move.
    fn is_on_ground(&self, key: ContactId) -> bool {
        match key.partner {
            Partner::Sphere { .. } => true,
            Partner::Boundary { boundary, .. } => !self.prediction().moves(usize::from(boundary)),
        }
    }

    /// Lets the spheres of calm islands fall asleep, and parts of others that stand still.
    fn fall_asleep(&self, state: &mut State) {
        let scene = self.prediction().scene;
        let asleep = |calm: u32| calm >= FALLEN;
        let islands = islands(scene, state, |_| true);
        let mut whole = vec![true; islands.len()];
        for (i, island) in islands.iter().enumerate() {
            whole[*island] &= asleep(state.calm[i]) || self.balances(state, i);
        }
        let still = self.still_spheres(state);
        let of = |i: usize| asleep(state.calm[i]) || whole[islands[i]] || still[i];
        let sleeps: Vec<bool> = (0..still.len()).map(of).collect();
        let parts = self::islands(scene, state, |i| sleeps[i]);
        let part = |load: &ContactForce, _| {
            let i = load.key.sphere as usize;
            sleeps[i].then(|| parts[i])
        };
        let mut ground: Vec<Option<Ground>> = strongest(state, parts.len(), part);
        // A part may lie on what takes no part in the step.
        for i in (0..sleeps.len()).filter(|&i| asleep(state.calm[i])) {
            let boundary = state.ground[i];
            ground[parts[i]].get_or_insert(Ground {
                boundary,
                load: None,
            });
        }
        for i in (0..sleeps.len()).filter(|&i| sleeps[i]) {
            if let Some(ground) = &ground[parts[i]]
                && !asleep(state.calm[i])
            {
                self.stop(state, i, ground);
                (state.calm[i], state.ground[i]) = (FALLEN, ground.boundary);
            }
        }
    }

    /// Whether each sphere stands still or drifts, or sleeps, and all stand still or sleep that it has contacts with.
    fn still_spheres(&self, state: &State) -> Vec<bool> {
        let scene = self.prediction().scene;
        let of = |i| state.calm[i] >= FALLEN || self.stands(state, i);
        let stands: Vec<bool> = (0..state.calm.len()).map(of).collect();
        let of = |i| stands[i] || self.drifts(state, i);
        let mut still: Vec<bool> = (0..state.calm.len()).map(of).collect();
        for load in state.contacts.iter() {
            if let Partner::Sphere { index, .. } = load.key.partner {
                let (a, b) = (load.key.sphere as usize, index as usize);
                still[a] &= stands[b];
                still[b] &= stands[a];
            }
        }
        for members in scene.clumps.iter().map(|clump| clump.members.clone()) {
            let whole = members.clone().all(|i| still[i]);
            still[members].fill(whole);
        }
        still
    }

    /// Whether sphere `i` is slower than forces without balance make it in a few steps, and its forces balance.
    fn stands(&self, state: &State, i: usize) -> bool {
        let tolerance = self.prediction().scene.settings.tolerance.force;
        self.has_gathered(state, i, (BALANCE, CALM))
            && self.keeps_velocity(state, i, FALLING * tolerance)
    }

    /// Whether sphere `i`, slow for long enough, hardly changes its velocity: it rolls in a gap or on a floor.
    fn drifts(&self, state: &State, i: usize) -> bool {
        self.has_gathered(state, i, (DRIFT, state.calm[i]))
            && self.keeps_velocity(state, i, BALANCE)
    }

    /// Whether the acceleration of sphere `i` is within a `share` of gravity.
    fn keeps_velocity(&self, state: &State, i: usize, share: f64) -> bool {
        let radius = self.prediction().scene.particles.radius[i];
        let size = |v: &SpatialVector| v.linear.norm().max(v.angular.norm() * radius);
        size(&state.smooth[i]) <= share * self.pull()
    }

    /// Stops sphere `i`. The boundary on the `ground` takes its momentum, the ledger its kinetic energy. Those of a clump go with
    /// its first member.
    fn stop(&self, state: &mut State, i: usize, ground: &Ground) {
        if let Some(stopped) = self.carries(state, i) {
            let boundary = usize::from(ground.boundary);
            let impulse = self.wrench(state, boundary, &stopped.momentum, stopped.centre);
            state.owed[boundary].add(&impulse, 1.0);
            // From now on the boundary has what accelerates it.
            let force = self.wrench(state, boundary, &stopped.force, stopped.centre);
            state.smooth_wrenches[boundary].add(&force, 1.0);
            if let Some(load) = &ground.load {
                self.strike(state, load, stopped.momentum.linear);
                let force = -stopped.force.linear;
                self.press_smooth(state, &ContactForce { force, ..*load });
            }
            state.work.numerical_work -= stopped.energy;
        }
        state.kinematics.velocity[i] = Vec3::zeros();
        state.kinematics.spin[i] = Vec3::zeros();
        state.smooth[i] = SpatialVector::ZERO;
    }

    /// Adds what the sleepers are out of balance by to the forces on the boundaries on which they sleep, where these are pressed most.
    pub(crate) fn hand_on(&self, state: &mut State, sleepers: &Sleepers) {
        if sleepers.bodies.is_empty() {
            return;
        }
        let mut extra = vec![[Wrench::default(); 2]; state.poses.len()];
        for body in &sleepers.bodies {
            let boundary = usize::from(state.ground[body.sphere]);
            for (extra, sum) in extra[boundary].iter_mut().zip([&body.net, &body.smooth]) {
                extra.add(&self.wrench(state, boundary, sum, body.centre), 1.0);
            }
        }
        let strongest = strongest(state, extra.len(), |_, boundary| {
            Some(usize::from(boundary))
        });
        for (b, ([net, smooth], strongest)) in extra.iter().zip(strongest).enumerate() {
            state.wrenches[b].add(net, 1.0);
            state.smooth_wrenches[b].add(smooth, 1.0);
            if let Some(at) = strongest.and_then(|ground| ground.load) {
                let load = |force: Vec3| ContactForce { force, ..at };
                self.press(state, &load(-net.force), false);
                self.press_smooth(state, &load(-smooth.force));
            }
        }
    }

    /// Force \[N\] and torque \[N m\], or impulses, on a body at `centre` \[m\] as a boundary has them at its point of action.
    fn wrench(&self, state: &State, boundary: usize, on: &SpatialVector, centre: Vec3) -> Wrench {
        let reference = self.prediction().scene.boundaries[boundary].point_of_action;
        let pivot = reference + state.poses[boundary].translation;
        on.about(centre - pivot)
    }

    /// What the body carries that has sphere `i` as its first member.
    fn carries(&self, state: &State, i: usize) -> Option<Stopped> {
        let scene = self.prediction().scene;
        let (particles, v) = (&scene.particles, self.reported(state, i));
        let (own, smooth) = (state.kinematics.spatial_velocity(i), &state.smooth[i]);
        let Some(c) = particles.clump(i) else {
            let times_mass = |v: &SpatialVector| SpatialVector {
                linear: v.linear * particles.mass[i],
                angular: v.angular * particles.inertia(i),
            };
            return Some(Stopped {
                centre: state.kinematics.position[i],
                momentum: times_mass(&own),
                force: times_mass(smooth),
                energy: particles.kinetic_energy(i, &v.linear, &v.angular),
            });
        };
        let clump = &scene.clumps[c];
        if clump.members.start != i {
            return None;
        }
        let (centre, rotation) = clump.place(&state.kinematics);
        let momentum = |v: &SpatialVector| {
            clump
                .shape
                .momentum(rotation, &clump.of_member(rotation, v))
        };
        let moves = clump.of_member(rotation, &v);
        Some(Stopped {
            centre,
            momentum: momentum(&own),
            force: momentum(smooth),
            energy: clump.shape.kinetic_energy(rotation, &moves).iter().sum(),
        })
    }
}

/// What a body carries that falls asleep.
struct Stopped {
    /// Its centre \[m\].
    centre: Vec3,
    /// Of the integrator's own velocity.
    momentum: SpatialVector,
    /// Force \[N\] and torque \[N m\] that accelerate it.
    force: SpatialVector,
    /// Kinetic energy \[J\].
    energy: f64,
}

/// Whether spheres may fall asleep in a scene.
fn may_rest(scene: &Scene) -> bool {
    scene.settings.rest_speed > 0.0 && scene.settings.is_steady()
}

/// What spheres sleep on.
struct Ground {
    boundary: u16,
    /// The strongest contact with it, if that takes part in the step.
    load: Option<ContactForce>,
}

/// The boundary of the strongest contact of each of `count` groups.
fn strongest(
    state: &State,
    count: usize,
    group: impl Fn(&ContactForce, u16) -> Option<usize>,
) -> Vec<Option<Ground>> {
    let mut found: Vec<Option<Ground>> = (0..count).map(|_| None).collect();
    for load in state.contacts.iter() {
        if let Partner::Boundary { boundary, .. } = load.key.partner
            && let Some(group) = group(load, boundary)
        {
            let known = found[group].as_ref().and_then(|ground| ground.load);
            if known.is_none_or(|known| load.force.norm() > known.force.norm()) {
                let load = Some(*load);
                found[group] = Some(Ground { boundary, load });
            }
        }
    }
    found
}

/// Spheres that hang together by loaded contacts, or in one clump, of those that are `in_it`: the label of each.
fn islands(scene: &Scene, state: &State, in_it: impl Fn(usize) -> bool) -> Vec<usize> {
    let mut islands = UnionFind::new(state.kinematics.len());
    for members in scene.clumps.iter().map(|clump| clump.members.clone()) {
        let first = members.start;
        members.for_each(|i| {
            islands.union(first, i);
        });
    }
    for load in state.contacts.iter() {
        let a = load.key.sphere as usize;
        if let Partner::Sphere { index, .. } = load.key.partner
            && in_it(a)
            && in_it(index as usize)
        {
            islands.union(a, index as usize);
        }
    }
    islands.into_labeling()
}
