//! The start of a run: overlaps out by displacement, contact forces at rest.

use super::stage::{Held, Stage};
use super::{Scratch, StepFailure, external, surfaces};
use crate::Vec3;
use crate::contacts::narrow_phase::Placement;
use crate::driven::Ready;
use crate::motion::Twist;
use crate::problem::assemble::{Inputs, mean_acceleration};
use crate::problem::{Dof6, Law, Row};
use crate::scene::{Method, Scene};
use crate::state::State;

/// Force residual at t = 0: forces at rest balance the weight, whatever the steps are asked for \[-\].
const AT_REST: f64 = 1e-8;

/// Contact forces at t = 0 from the acceleration-level problem: closed contacts that neither approach nor part
/// must not accelerate into each other. Leaves them and the persisting accelerations in `state`.
///
/// # Errors
/// [`StepFailure`] if that problem has no solution within the tolerances.
pub fn initial_forces(
    scene: &Scene,
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), StepFailure> {
    let dt = 0.5 * scene.settings.step;
    let kinematics = state.kinematics.clone();
    let gravity = state.gravity_at(scene, state.time);
    let external = external::at_start(scene, &kinematics, gravity);
    let targets: Vec<Vec3> = scene.springs.iter().map(|spring| spring.target).collect();
    let (poses, twists) = (state.poses.clone(), state.twists.clone());
    let bodies = Ready::all(scene, state, dt);
    let inputs = Inputs {
        scene,
        kinematics: &kinematics,
        external: &external,
        step: dt,
        poses: [&poses, &poses],
        bodies: &bodies,
        twists: &twists,
        surfaces: &surfaces(scene, state),
        gravity,
        targets: &targets,
        mean_acceleration: mean_acceleration(scene, &external, &bodies),
    };
    let mut stage = Stage::new(inputs, state, scratch);
    stage.keep_resting(scene);
    let report = stage.solve(state, scratch);
    if scene.settings.method == Method::Alm && !report.converged {
        return Err(stage.failure(&report));
    }
    if scene.settings.method == Method::Alm {
        stage.polish(state, scratch, AT_REST);
    }
    stage.store(state);
    state.springs = stage.spring_forces();
    state.persisting = stage.persisting_acceleration();
    external::keep(scene, state, &external);
    let solution = stage.problem.velocities(&stage.impulses);
    let at_rest = stage.finished(&solution, &poses);
    for (carried, (found, _)) in state.bodies.iter_mut().zip(at_rest) {
        carried.persisting = found.persisting;
        carried.holds = found.holds;
    }
    Ok(())
}

/// Removes overlaps at t = 0 by the smallest displacement (in the mass metric) that closes no other gap; leaves the
/// largest overlap found in `state.initial_overlap`. The penalty method keeps its overlaps.
///
/// # Errors
/// [`StepFailure`] if no such displacement is found.
pub fn remove_overlaps(
    scene: &Scene,
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), StepFailure> {
    let start = Placement {
        particles: &scene.particles,
        position: &state.kinematics.position,
        present: &state.kinematics.present,
        boundaries: &scene.boundaries,
        poses: &state.poses,
        cell: &scene.cell,
    };
    scratch.neighbors.ensure(&start, 0.0);
    let closed = start.candidates(&scratch.neighbors, |_, _| 0.0, |_, _| 0.0);
    state.initial_overlap = closed
        .iter()
        .map(|c| -c.gap / start.scale(c.key))
        .fold(0.0, f64::max);
    if scene.settings.method == Method::Penalty
        || state.initial_overlap <= scene.settings.tolerance.gap
    {
        return Ok(());
    }
    let mut kinematics = state.kinematics.clone();
    kinematics.stop();
    let poses = state.poses.clone();
    let inputs = Inputs {
        scene,
        kinematics: &kinematics,
        external: &vec![Dof6::ZERO; kinematics.len()],
        step: scene.settings.step,
        poses: [&poses, &poses],
        // Walls give way to no overlap.
        bodies: &[],
        twists: &vec![Twist::default(); poses.len()],
        surfaces: &vec![Vec3::zeros(); poses.len()],
        gravity: Vec3::zeros(),
        targets: &[],
        mean_acceleration: 0.0,
    };
    let mut stage = Stage::new(inputs, state, scratch);
    stage.problem.rows.truncate(stage.candidates.len());
    stage.impulses.truncate(stage.candidates.len());
    for row in &mut stage.problem.rows {
        row.law = Law::Contact { mu: 0.0 };
    }
    stage.moves = false;
    let (solution, _) = stage.resolve(state, scratch, &mut [])?;
    state.kinematics.position = stage.moved(&solution);
    Ok(())
}

impl Stage<'_> {
    /// Keeps the candidates that are closed and neither approach nor part. They may not accelerate into each other: with
    /// zero gap, less what sliding over a curved surface opens or closes by itself, `g(t) = g + dt n.u + ...`.
    fn keep_resting(&mut self, scene: &Scene) {
        let velocity = self.before();
        let mut weight = scene.settings.gravity.norm();
        if scene.settings.rotating_frame.is_some() {
            let external = self.inputs.external.iter().map(|a| a.linear.norm());
            weight = external.fold(weight, f64::max);
        }
        let creep = weight * self.inputs.step;
        let closed = scene.settings.tolerance.gap.max(1e-9);
        let rests = |k: usize| {
            let row = &self.problem.rows[k];
            self.candidates[k].gap <= closed * row.radius
                && row.normal.dot(&row.relative_velocity(&velocity)).abs() <= 1e-3 * creep
        };
        let stop_rests = |held: &Held, row: &Row| {
            held.hold.distance <= closed * row.radius
                && row.normal.dot(&row.relative_velocity(&velocity)).abs() <= 1e-3 * creep
        };
        let keep: Vec<bool> = (0..self.problem.rows.len())
            .map(|k| match (self.contact_of(k), self.held(k)) {
                (Some(contact), _) => rests(contact),
                (None, Some(held)) if held.hold.stops() => stop_rests(held, &self.problem.rows[k]),
                _ => true,
            })
            .collect();
        let first = self.first_hold();
        for (held, row) in self.holds.iter_mut().zip(&mut self.problem.rows[first..]) {
            if held.hold.stops() {
                row.bias = Vec3::zeros();
                held.impact = false;
            }
        }
        retain(&mut self.holds, &keep[first..]);
        for row in &mut self.problem.rows {
            if let Law::Resistance { contact, .. } = &mut row.law {
                let before = &keep[..*contact as usize];
                *contact = before.iter().filter(|kept| **kept).count() as u32;
            }
        }
        let step = self.inputs.step;
        let position = self.moved(&velocity);
        let slid = Placement {
            position: &position,
            ..self.start
        };
        for ((row, candidate), impact) in self
            .problem
            .rows
            .iter_mut()
            .zip(&self.candidates)
            .zip(&mut self.impact)
        {
            if row.compliance_n == 0.0 {
                let linear = step * row.normal.dot(&row.relative_velocity(&velocity));
                let curved = slid.follow(candidate).gap - candidate.gap - linear;
                row.bias = row.normal * (2.0 * curved / step);
            }
            *impact = false;
        }
        retain(&mut self.impulses, &keep);
        retain(&mut self.problem.rows, &keep);
        retain(&mut self.candidates, &keep);
        self.impact.truncate(self.candidates.len());
    }
}

/// Keeps the entries whose flag is set; entries beyond the flags stay.
fn retain<T>(items: &mut Vec<T>, keep: &[bool]) {
    let mut flags = keep.iter();
    items.retain(|_| flags.next().copied().unwrap_or(true));
}
