//! Derivatives by time: the state moves on along its own rates, and what is measured there is compared.
//!
//! ```text
//! places        x' = v, Q' = w x Q, of boundaries with their twist over the last internal step          exact
//! velocities    v' = a, the acceleration by external forces and lasting contacts in the last internal step
//! forces, work  (F - F_-)/dt, the backward difference over the last two internal steps; 0 where one of them held an impact
//! averages      (A - A_-)/h over the last two communication steps; 0 where the last held an impact
//! flow          the mass flow of the last communication step; its own rate 0
//! ```

use super::Simulation;
use crate::contact::history;
use crate::error::StepError;
use crate::simulation::ReplayRecord;
use crate::spatial::{Wrench, turned};
use crate::state::{EnergyLedger, SharedState, State};

/// How far the state moves on, over the last internal step \[-\].
const SHARE: f64 = 1e-2;

/// What changes by differences: the state before the last internal step, and which boundaries had an impact.
struct BeforeLastStep {
    before: SharedState,
    /// In one of the last two internal steps, `[B]`.
    struck: Vec<bool>,
    /// In the communication step, `[B]`.
    struck_before: Vec<bool>,
    /// Averages of the communication step before.
    averages: Vec<Wrench>,
    /// Length of the communication step \[s\].
    h: f64,
}

impl Simulation {
    /// As [`Self::time_derivatives`], of whatever numbers `measure` reads off a simulation.
    ///
    /// # Errors
    /// As [`Self::time_derivatives`].
    pub fn time_derivatives_of(
        &self,
        measure: impl Fn(&Self) -> Vec<f64>,
    ) -> Result<Vec<f64>, StepError> {
        let past = self.past()?;
        let dt = match self.state.last_step {
            dt if dt > 0.0 => dt,
            _ => self.scene.settings.step,
        };
        let eta = SHARE * dt;
        let [before, after] =
            [-eta, eta].map(|eta| measure(&self.at(self.drifted(past.as_ref(), eta))));
        let pairs = before.iter().zip(&after);
        Ok(pairs.map(|(a, b)| (b - a) / (2.0 * eta)).collect())
    }

    fn past(&self) -> Result<Option<BeforeLastStep>, StepError> {
        let ReplayRecord::Step(replay) = self.came_from()? else {
            return Ok(None);
        };
        let boundaries = self.scene.boundaries.len();
        let struck = |state: &State, b: usize| state.wrenches[b] != state.smooth_wrenches[b];
        let mut past = BeforeLastStep {
            before: replay.state.clone(),
            struck: Vec::new(),
            struck_before: vec![false; boundaries],
            averages: replay.averages.clone(),
            h: self.state.time - replay.start,
        };
        self.replay(replay, &mut [], |before, after| {
            past.before.clone_from(before);
            for (b, any) in past.struck_before.iter_mut().enumerate() {
                *any |= struck(&after.state, b);
            }
        })?;
        let last = |b| struck(&self.state, b) || struck(&past.before, b);
        past.struck = (0..boundaries).map(last).collect();
        Ok(Some(past))
    }

    /// The state `eta` \[s\] later along its rates.
    fn drifted(&self, past: Option<&BeforeLastStep>, eta: f64) -> SharedState {
        let mut state = self.state.clone();
        state.time += eta;
        let kinematics = &mut state.kinematics;
        for i in (0..kinematics.len()).filter(|&i| self.state.kinematics.present[i]) {
            let (twist, a) = (self.velocity(i), &self.state.smooth[i]);
            kinematics.position[i] += twist.linear * eta;
            kinematics.orientation[i] = turned(&kinematics.orientation[i], &twist.angular, eta);
            kinematics.velocity[i] += a.linear * eta;
            kinematics.spin[i] += a.angular * eta;
        }
        for (b, pose) in state.poses.iter_mut().enumerate() {
            *pose = pose.advanced(&self.boundary_twist(b), eta);
        }
        let now = &mut *state;
        for ((b, body), carried) in self.scene.driven().zip(&mut now.bodies) {
            carried.momentum = carried.momentum.plus(&carried.smooth, eta);
            carried.joint_position = body.joint_position(&now.poses[b], carried.joint_position);
        }
        let flows = state.passed.iter_mut().zip(&self.state.flow);
        flows.for_each(|(passed, flow)| *passed += flow * eta);
        if let Some(past) = past {
            self.extrapolate(past, eta, &mut state);
        }
        state
    }

    /// Moves forces and work on by their backward differences.
    fn extrapolate(&self, past: &BeforeLastStep, eta: f64, state: &mut State) {
        let share = eta / self.state.last_step;
        let before = &past.before;
        let grow = |wrench: &mut Wrench, then: &Wrench, share: f64| {
            let now = *wrench;
            wrench.add(&now, share);
            wrench.add(then, -share);
        };
        for b in 0..state.wrenches.len() {
            if !past.struck[b] {
                grow(&mut state.wrenches[b], &before.wrenches[b], share);
            }
            if !past.struck_before[b] {
                grow(&mut state.mean_wrenches[b], &past.averages[b], eta / past.h);
            }
        }
        if !past.struck.contains(&true) {
            let keys = state.contacts.iter().map(|contact| contact.key);
            let then: Vec<_> = history::transfer(&before.contacts, keys).collect();
            let mut then = then.into_iter();
            state.contacts.change(|force, torque| {
                let Some(then) = then.next() else { return };
                *force += (*force - then.force(&before.contacts)) * share;
                if let Some(torque) = torque {
                    *torque += (*torque - then.torque(&before.contacts)) * share;
                }
            });
        }
        for (carried, then) in state.bodies.iter_mut().zip(&before.bodies) {
            let joint_forces = carried.joint_forces.iter_mut().zip(&then.joint_forces);
            joint_forces.for_each(|(now, then)| *now += (*now - then) * share);
        }
        state.work = grown(&state.work, &before.work, share);
    }
}

fn grown(now: &EnergyLedger, then: &EnergyLedger, share: f64) -> EnergyLedger {
    let grow = |of: fn(&EnergyLedger) -> f64| of(now) + (of(now) - of(then)) * share;
    EnergyLedger {
        friction: grow(|w| w.friction),
        impact: grow(|w| w.impact),
        numerical_work: grow(|w| w.numerical_work),
        boundaries: grow(|w| w.boundaries),
        gravity: grow(|w| w.gravity),
        loads: grow(|w| w.loads),
        dampers: grow(|w| w.dampers),
        springs: grow(|w| w.springs),
        contacts: grow(|w| w.contacts),
    }
}
