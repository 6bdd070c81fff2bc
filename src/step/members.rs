//! Members of clumps in a step: they have no unknowns of their own and go where their clumps take them.

use super::prediction::Prediction;
use super::solution::Solved;
use crate::Vec3;
use crate::scene::particles::Kinematics;
use crate::spatial::SpatialVector;
use crate::state::State;

impl Prediction<'_> {
    /// The number of clump `c` among all bodies, `[N + D + C]`.
    pub(super) fn clump_body(&self, c: usize) -> usize {
        self.kinematics.len() + self.bodies.len() + c
    }

    /// The body that moves sphere `i`, of all bodies, and if that is a clump the sphere's centre from its own \[m\].
    #[inline]
    pub(super) fn mover(&self, i: usize) -> (u32, Option<Vec3>) {
        match self.scene.particles.clump(i) {
            None => (i as u32, None),
            Some(c) => {
                let clump = &self.clumps[c];
                let arm = clump.clump.shape.arms[i - clump.clump.members.start];
                (self.clump_body(c) as u32, Some(clump.rotation * arm))
            }
        }
    }

    /// Lets the members in `external`, `[N]`, accelerate with their clumps.
    pub(super) fn accelerate_members(&mut self) {
        for clump in &self.clumps {
            for (i, arm) in clump.arms() {
                self.external[i] = clump.acceleration_at(arm);
            }
        }
    }

    /// Lets the members in `velocity`, `[N + D + C]`, move to where their clumps take them: `(x_k(t + dt) - x_k(t))/dt`.
    pub(super) fn carry_members(&self, velocity: &mut [SpatialVector]) {
        for (c, clump) in self.clumps.iter().enumerate() {
            let own = velocity[self.clump_body(c)];
            if self.is_asleep(clump.clump.members.start) {
                velocity[clump.clump.members.clone()].fill(own);
                continue;
            }
            let (centre, rotation) = clump.moved(&own, self.step);
            for (i, arm) in clump.clump.members.clone().zip(&clump.clump.shape.arms) {
                let way = centre + rotation * arm - self.kinematics.position[i];
                velocity[i].linear = way / self.step;
                velocity[i].angular = own.angular;
            }
        }
    }

    /// Lets the clumps in `kinematics` turn as `velocity` has them, `[N + D + C]`.
    pub(super) fn turn_members(&self, velocity: &[SpatialVector], kinematics: &mut Kinematics) {
        for (c, clump) in self.clumps.iter().enumerate() {
            let (_, rotation) = clump.moved(&velocity[self.clump_body(c)], self.step);
            kinematics.orientation[clump.clump.members.clone()].fill(rotation);
        }
    }
}

impl Solved<'_> {
    /// Force \[N\] and torque \[N m\] on a clump by gravity, loads and the contacts that are no impacts, which `acceleration`, `[N + D + C]`,
    /// has in its problem.
    fn smooth_force(&self, c: usize, acceleration: &[SpatialVector]) -> SpatialVector {
        let clump = &self.prediction().clumps[c];
        let contacts = clump
            .mass
            .times(&acceleration[self.prediction().clump_body(c)]);
        clump.external.plus(&contacts, 1.0)
    }

    /// Writes what the clumps feel into the smooth `acceleration` of their members at the end of the step, `[N + D + C]`; at its start if
    /// the step does not `move` them.
    pub(super) fn accelerate_clumps(&self, acceleration: &mut [SpatialVector], moves: bool) {
        let prediction = self.prediction();
        for (c, clump) in prediction.clumps.iter().enumerate() {
            let shape = &clump.clump.shape;
            let force = self.smooth_force(c, acceleration);
            let velocity = &self.solution.velocity[prediction.clump_body(c)];
            let rotation = match moves {
                true => clump.moved(velocity, prediction.step).1,
                false => clump.rotation,
            };
            let own = shape.response(rotation, &force);
            clump.clump.share(rotation, &own, acceleration);
        }
    }

    /// Moves the clumps: the motion of their members in `state`, whose smooth accelerations are those before, and the numerical work as
    /// for spheres. `smooth` are the accelerations after, `[N]`.
    pub(super) fn advance_clumps(&self, state: &mut State, smooth: &[SpatialVector]) {
        let prediction = self.prediction();
        let (settings, step) = (&prediction.scene.settings, prediction.step);
        let integrator = settings.integrator;
        for (c, clump) in prediction.clumps.iter().enumerate() {
            let shape = &clump.clump.shape;
            let first = clump.clump.members.start;
            if prediction.is_asleep(first) {
                continue;
            }
            let v1 = &self.solution.velocity[prediction.clump_body(c)];
            let (centre, rotation) = clump.moved(v1, step);
            let momentum = integrator.finish(
                &clump.momentum,
                &clump.mass.times(v1),
                settings.dynamic_coefficient,
            );
            let after = shape.response(rotation, &momentum);
            let kinetic = |rotation, velocity: &SpatialVector, smooth: &SpatialVector| {
                let smooth = clump.clump.of_member(rotation, smooth);
                let reported = integrator.reported(velocity, &smooth, step);
                shape
                    .kinetic_energy(rotation, &reported)
                    .iter()
                    .sum::<f64>()
            };
            let new = kinetic(rotation, &after, &smooth[first]);
            let old = kinetic(clump.rotation, &clump.velocity, &state.smooth[first]);
            let power = clump.field.linear.dot(&v1.linear) + clump.field.angular.dot(&v1.angular);
            state.work.numerical_work += new - old - step * power;
            let place = (centre, rotation);
            clump.clump.put(place, &after, &mut state.kinematics);
        }
        // Loads work along the ways of the members, which are chords: what the ledger has of it.
        let particles = &prediction.scene.particles;
        let work = self.load_work(&state.applied_forces);
        let members = work.filter(|(i, _)| particles.clump(*i).is_some());
        let work: f64 = members.map(|(_, work)| work).sum();
        state.work.numerical_work -= work;
    }
}
