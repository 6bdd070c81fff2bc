//! One internal time step, its stages in order: `stage` finds candidates and writes rows, `resolve` solves until the true
//! geometry agrees, `commit` writes the solution into the state; `start` does the same at t = 0.

pub mod assemble;
mod beside;
mod commit;
pub mod driven;
pub mod external;
mod failure;
mod input;
mod outcome;
mod passing;
mod prediction;
mod resolve;
mod stage;
mod start;
mod workspace;

pub use beside::Beside;
use beside::Twin;
pub(crate) use external::release;
pub use input::{Effort, StepInput};
pub use outcome::{Passed, StepFailure, StepOutcome};
pub use start::{initial_forces, remove_overlaps};
pub use workspace::Scratch;

use crate::problem::{Impulses, Problem};
use crate::scene::Scene;
use crate::solver::gauss_seidel::SMALL;
use crate::spatial::Dof6;
use crate::state::State;
use prediction::Start;
use stage::Stage;
use workspace::Kept;

/// Takes `state` from `state.time` to `state.time + dt` of `input`. On failure `state` is unchanged.
///
/// # Errors
/// [`StepFailure`] with the worst contact if the tolerances cannot be met.
pub fn step(
    scene: &Scene,
    state: &mut State,
    scratch: &mut Scratch,
    input: &StepInput,
    effort: Effort,
) -> Result<StepOutcome, StepFailure> {
    let pool = scratch.workspace.kernel.pool(scene.settings.threads);
    let mut step = || step_beside(scene, state, scratch, (input, effort), &mut []);
    match scene.particles.len() {
        0..SMALL => step(),
        _ => pool.within(step),
    }
}

/// [`step`] by an input with an effort, and beside it pairs of states to either side of `state`: see `beside`.
///
/// # Errors
/// As [`step`], and if the tangent of the solution is singular.
pub fn step_beside(
    scene: &Scene,
    state: &mut State,
    scratch: &mut Scratch,
    (input, effort): (&StepInput, Effort),
    pairs: &mut [[Beside<'_>; 2]],
) -> Result<StepOutcome, StepFailure> {
    let dt = input.dt;
    let mut kept = std::mem::take(&mut scratch.kept);
    let start = Start::of(scene, state, input, &mut kept);
    let beside =
        |beside: &Beside| Start::of(scene, beside.state, &beside.input, &mut Kept::default());
    let starts = pairs.iter().map(|pair| [0, 1].map(|k| beside(&pair[k])));
    let starts: Vec<[Start; 2]> = starts.collect();
    let mut stage = Stage::new(start.inputs(scene, dt), state, scratch);
    let mut twins: Vec<Twin> = starts
        .iter()
        .zip(&*pairs)
        .map(|(starts, pair)| Twin {
            stages: [0, 1]
                .map(|k| Stage::beside(&stage, starts[k].inputs(scene, dt), pair[k].state)),
        })
        .collect();
    let outcome = stage.resolve((state, effort), scratch, &mut twins)?;
    stage.spread_impacts(state);
    for ((twin, starts), pair) in twins.iter_mut().zip(&starts).zip(pairs) {
        twin.agree(&stage);
        for (k, side) in twin.stages.iter().enumerate() {
            let solution = side.problem.velocities(&side.impulses);
            starts[k].finish(side, pair[k].state, &solution, dt, &mut Vec::new());
        }
    }
    start.finish(&stage, state, &stage.solution, dt, &mut kept.accelerations);
    scratch.memory = stage.memory();
    (kept.kinematics, kept.external, kept.movers) =
        (start.kinematics, start.external, start.movers);
    scratch.kept = kept;
    if outcome.solver.penalty > 0.0 && outcome.solver.penalty.is_finite() {
        state.penalty = outcome.solver.penalty;
    }
    Ok(outcome)
}

/// The problem that a step from `state` by `input` begins with, and the impulses \[N s\] it starts from: candidates within
/// reach, gaps not yet re-linearised.
#[must_use]
pub fn problem(scene: &Scene, state: &State, input: &StepInput) -> (Problem, Impulses) {
    let start = Start::of(scene, state, input, &mut Kept::default());
    let inputs = start.inputs(scene, input.dt);
    let stage = Stage::new(inputs, state, &mut Scratch::default());
    (stage.problem, stage.impulses)
}

impl Start<'_> {
    /// Writes the solution of `stage` into `state`.
    fn finish(
        &self,
        stage: &Stage,
        state: &mut State,
        solution: &[Dof6],
        dt: f64,
        spare: &mut Vec<Dof6>,
    ) {
        let poses = stage.end_poses(solution);
        stage.commit(state, solution, &poses, spare);
        let ways = state.poses.iter().zip(&poses);
        state.twists = ways.map(|(from, to)| from.twist_to(to, dt)).collect();
        state.poses = poses;
        self.book(stage.inputs.scene, state, dt);
        state.last_step = dt;
    }
}
