//! A step with replicas: its derivative along directions of its data.
//!
//! A [`Pair`] is the same step from two states, a little to either side. What is smooth and closed-form (geometry, commands,
//! inertia, the commit) is done with each of the two, and half their difference is the derivative: error of second order in
//! a displacement of `3e-5` radii. The contact solve is not repeated: half the difference of the two problems goes through the
//! tangent of the solution, [`crate::solver::tangent`], pass by pass as gaps are corrected, and both get the impulses of the
//! solution changed by that.

use super::assemble::{Assembly, AssemblyArrays, assemble, follow};
use super::commit::{commit, spread_impacts};
use super::failure::singular;
use super::initial::{effort, overlaps, solve_forces};
use super::linear_problem::linear_problem;
use super::output::Taken;
use super::prediction::{Prediction, PredictionArrays, predict};
use super::resolve::{Pass, Passes};
use super::sleep::{Attempt, Sleepers, undisturbed};
use super::solution::{Solution, Solved};
use super::workspace::Workspace;
use super::{Effort, StepFailure, StepInput, StepOutput};
use crate::detection::configuration::Configuration;
use crate::linalg::LinearError;
use crate::parallel::Pool;
use crate::scene::Scene;
use crate::solver::tangent::{Change, respond};
use crate::spatial::SpatialVector;
use crate::state::State;

/// A state beside the one that takes the step, and its own step.
#[derive(Debug)]
pub struct Replica<'a> {
    /// The state; on success it takes the step too.
    pub state: &'a mut State,
    /// Its own step.
    pub input: StepInput<'a>,
}

/// [`super::step`] by an input with an effort, with pairs of states to either side of `state`.
///
/// # Errors
/// As [`super::step`], and if the tangent of the solution is singular.
pub fn step_with_replicas(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
    (input, effort): (&StepInput, Effort),
    replicas: &mut [[Replica<'_>; 2]],
) -> Result<StepOutput, StepFailure> {
    let of = |state: &State, input| {
        predict(
            scene,
            state,
            input,
            (PredictionArrays::default(), &Pool::default()),
        )
    };
    let mut prediction = of(state, input);
    let beside = replicas.iter();
    let beside = beside.map(|pair| {
        pair.each_ref()
            .map(|replica| of(replica.state, &replica.input))
    });
    let mut beside: Vec<[Prediction; 2]> = beside.collect();
    let output = loop {
        // All take part: none can be reached that does not.
        let taken = undisturbed(&mut prediction, state, |prediction, state| {
            attempt(
                (prediction, &mut beside),
                (state, &mut *replicas),
                workspace,
                effort,
            )
        })?;
        if let Taken::Done(output) = taken {
            break output;
        }
    };
    for replica in replicas.iter_mut().flatten() {
        replica.state.calm.clone_from(&state.calm);
        replica.state.ground.clone_from(&state.ground);
    }
    if output.solver.penalty > 0.0 && output.solver.penalty.is_finite() {
        state.penalty = output.solver.penalty;
    }
    Ok(output)
}

/// Stages from detection on, of the step and those `beside` it.
fn attempt(
    (prediction, beside): (&mut Prediction, &mut [[Prediction; 2]]),
    (state, replicas): (&mut State, &mut [[Replica<'_>; 2]]),
    workspace: &mut Workspace,
    effort: Effort,
) -> Attempt {
    let (mut assembly, mut solution) = linear_problem(prediction, state, workspace);
    for replica in beside.iter_mut().flatten() {
        replica.asleep.clone_from(&assembly.prediction.asleep);
    }
    let states = replicas
        .iter()
        .map(|pair| pair.each_ref().map(|replica| &*replica.state));
    let mut pairs = pairs(&assembly, beside, states);
    let how = (&*state, effort);
    let resolved = resolve(&mut assembly, &mut solution, how, workspace, &mut pairs);
    if let Some(disturbed) = Attempt::failed_beside_sleepers(&assembly, &resolved, (state, effort))
    {
        return disturbed;
    }
    let output = match resolved {
        Ok(output) => output,
        Err(failure) => return Attempt::Done(Err(failure)),
    };
    assembly.hold_on(&mut solution);
    spread_impacts(
        &mut assembly,
        &solution,
        (state, output.unconverged),
        &mut workspace.balance,
    );
    let solved = Solved {
        assembly: &assembly,
        solution: &solution,
    };
    let sleepers = Sleepers::of(&solved, state);
    let ends = sleepers.ends(output);
    if matches!(ends, Attempt::Disturbed { .. }) {
        return ends;
    }
    for (pair, replicas) in pairs.iter_mut().zip(&mut *replicas) {
        for (side, replica) in pair.0.iter_mut().zip(replicas) {
            side.take_impacts(&assembly);
            let (solved, state) = (side.solved(), &mut *replica.state);
            let sleepers = Sleepers::of(&solved, state);
            commit(&solved, state, &sleepers, &mut Vec::new());
        }
    }
    commit(&solved, state, &sleepers, &mut Vec::new());
    ends
}

/// [`super::remove_overlaps`] and [`super::initial_forces`], with pairs of states to either side of `state`.
///
/// # Errors
/// As these, and if the tangent of a solution is singular.
pub fn start_with_replicas(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
    replicas: &mut [[&mut State; 2]],
) -> Result<(), StepFailure> {
    if overlaps(scene, state, workspace) {
        let mut prediction = Prediction::still(scene, state);
        let beside = each(replicas, |state| Prediction::still(scene, state));
        let (mut assembly, mut solution) = linear_problem(&mut prediction, state, workspace);
        let mut pairs = pairs(&assembly, &beside, views(replicas));
        for side in pairs.iter_mut().flat_map(|pair| &mut pair.0) {
            side.assembly.displace(&mut side.solution.impulses);
        }
        assembly.displace(&mut solution.impulses);
        let how = (&*state, effort(scene));
        resolve(&mut assembly, &mut solution, how, workspace, &mut pairs)?;
        for (pair, states) in pairs.iter().zip(&mut *replicas) {
            for (side, state) in pair.0.iter().zip(states) {
                let velocity = &side.solution.velocity;
                let kinematics = &mut state.kinematics;
                let prediction = side.assembly.prediction;
                prediction.end_positions(velocity, &mut kinematics.position);
                prediction.turn_members(velocity, kinematics);
            }
        }
        let turning = assembly.prediction;
        turning.turn_members(&solution.velocity, &mut state.kinematics);
        state.kinematics.position = solution.position;
    }
    let dt = 0.5 * scene.settings.step;
    let mut prediction = Prediction::at_rest(scene, state, dt);
    let beside = each(replicas, |state| Prediction::at_rest(scene, state, dt));
    let (mut assembly, mut solution) = linear_problem(&mut prediction, state, workspace);
    let mut pairs = pairs(&assembly, &beside, views(replicas));
    let resting = assembly.resting();
    for side in pairs.iter_mut().flat_map(|pair| &mut pair.0) {
        side.assembly.keep(&resting, &mut side.solution.impulses);
    }
    assembly.keep(&resting, &mut solution.impulses);
    let report = solve_forces(&assembly, &mut solution, state.penalty, workspace)?;
    respond_all(&assembly, &solution, &mut pairs)
        .map_err(|error| singular(&assembly, &solution, &report, error))?;
    for (pair, states) in pairs.iter_mut().zip(replicas) {
        for (side, state) in pair.0.iter_mut().zip(states) {
            side.assembly.act(&mut side.solution);
            side.solved().commit_forces(state);
        }
    }
    assembly.act(&mut solution);
    let solved = Solved {
        assembly: &assembly,
        solution: &solution,
    };
    solved.commit_forces(state);
    Ok(())
}

/// One of something for each state.
fn each<T>(pairs: &[[&mut State; 2]], of: impl Fn(&State) -> T) -> Vec<[T; 2]> {
    views(pairs).map(|pair| pair.map(&of)).collect()
}

fn views<'a>(pairs: &'a [[&mut State; 2]]) -> impl Iterator<Item = [&'a State; 2]> {
    pairs
        .iter()
        .map(|pair| pair.each_ref().map(|state| &**state))
}

/// The step of one replica.
struct Side<'a> {
    assembly: Assembly<'a>,
    solution: Solution,
}

/// The steps to either side, below and above.
struct Pair<'a>([Side<'a>; 2]);

fn pairs<'a, 's>(
    assembly: &Assembly,
    predictions: &'a [[Prediction<'a>; 2]],
    states: impl Iterator<Item = [&'s State; 2]>,
) -> Vec<Pair<'a>> {
    let pair = |(predictions, states): (&'a [Prediction<'a>; 2], [&State; 2])| {
        Pair([0, 1].map(|k| Side::new(assembly, &predictions[k], states[k])))
    };
    predictions.iter().zip(states).map(pair).collect()
}

impl<'a> Side<'a> {
    /// The problem from slightly other data than that `of` the step: the same contacts, each an impact if it is one there.
    fn new(of: &Assembly, prediction: &'a Prediction<'a>, state: &State) -> Self {
        let mut arrays = AssemblyArrays::default();
        prediction.bodies(&mut arrays.problem);
        let kinematics = &prediction.kinematics;
        let start = Configuration::of(prediction.scene, kinematics, &prediction.poses[0]);
        let candidates = of.candidates.iter();
        arrays.candidates = candidates.map(|c| follow(&start, c)).collect();
        let mut solution = Solution::default();
        let impact = Some(&of.impact[..]);
        let impulses = &mut solution.impulses;
        let assembly = assemble(prediction, arrays, state, impact, impulses);
        Self { assembly, solution }
    }

    /// Counts as impacts what `assembly` does, and holds what it holds.
    fn take_impacts(&mut self, assembly: &Assembly) {
        let own = &mut self.assembly;
        own.impact.clone_from(&assembly.impact);
        own.take_holds(assembly.holds.clone());
        own.act(&mut self.solution);
        for (own, joint) in own.joints.iter_mut().zip(&assembly.joints) {
            own.impact = joint.impact;
        }
    }

    fn solved(&self) -> Solved<'_> {
        Solved {
            assembly: &self.assembly,
            solution: &self.solution,
        }
    }
}

/// As [`super::resolve::resolve`]; every correction is applied to all.
fn resolve(
    assembly: &mut Assembly,
    solution: &mut Solution,
    (state, effort): (&State, Effort),
    workspace: &mut Workspace,
    pairs: &mut [Pair],
) -> Result<StepOutput, StepFailure> {
    let mut passes = Passes::new(assembly, solution, (state.penalty, effort));
    loop {
        let pass = passes.next(assembly, solution, workspace)?;
        respond_all(assembly, solution, pairs)
            .map_err(|error| singular(assembly, solution, passes.report(), error))?;
        match pass {
            Pass::Accepted(output) => return Ok(output),
            Pass::Corrected(correction) => {
                let impacts = correction.apply(assembly, solution, state, None);
                for side in pairs.iter_mut().flat_map(|pair| &mut pair.0) {
                    let (assembly, solution) = (&mut side.assembly, &mut side.solution);
                    correction.apply(assembly, solution, state, Some(&impacts));
                }
            }
        }
    }
}

/// Lets replicas follow the solution by its tangent.
///
/// # Errors
/// [`LinearError`] if that is singular.
fn respond_all(
    assembly: &Assembly,
    solution: &Solution,
    pairs: &mut [Pair],
) -> Result<(), LinearError> {
    if pairs.is_empty() {
        return Ok(());
    }
    let (problem, impulses) = (&assembly.problem, &solution.impulses);
    let velocity = problem.velocities(impulses);
    let changes = pairs.iter().map(|pair| change(impulses, &velocity, pair));
    let changes: Vec<Change> = changes.collect();
    for (pair, response) in pairs.iter_mut().zip(respond(problem, impulses, &changes)?) {
        for (side, sign) in pair.0.iter_mut().zip([-1.0, 1.0]) {
            let changed = impulses.iter().zip(&response);
            let changed = changed.map(|(p, change)| p + change * sign).collect();
            side.solution = Solution::of(&side.assembly, changed);
        }
    }
    Ok(())
}

/// Half the difference of the problems of a pair, at the solution of the step.
fn change(impulses: &[crate::Vec3], velocity: &[SpatialVector], pair: &Pair) -> Change {
    let [below, above] = pair.0.each_ref().map(|side| &side.assembly.problem);
    let [low, high] = [below, above].map(|problem| problem.velocities(impulses));
    let rows = || below.rows.iter().zip(above.rows.iter());
    let zero = SpatialVector::ZERO;
    let velocities = low.iter().zip(&high);
    Change {
        velocity: velocities
            .map(|(low, high)| zero.plus(high, 0.5).plus(low, -0.5))
            .collect(),
        normal: rows()
            .map(|(low, high)| (high.normal - low.normal) * 0.5)
            .collect(),
        approach: rows()
            .map(|(low, high)| {
                let [low, high] = [low, high].map(|row| row.relative_velocity(velocity) + row.bias);
                (high - low) * 0.5
            })
            .collect(),
    }
}
