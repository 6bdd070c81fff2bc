//! One internal time step, its stages in order: `stage` finds candidates and writes rows, `resolve` solves until the true
//! geometry agrees, `commit` writes the solution into the state; `start` does the same at t = 0.

pub mod assemble;
mod assembly;
mod commit;
pub mod driven;
pub mod external;
mod failure;
mod initial;
mod input;
mod output;
mod prediction;
mod replicas;
mod resolve;
mod tunnelling;
mod workspace;

pub(crate) use external::release;
pub use initial::{initial_forces, remove_overlaps};
pub use input::{Effort, StepInput};
pub use output::{StepFailure, StepOutput, Tunnelling};
pub use replicas::Replica;
use replicas::ReplicaPair;
pub use workspace::Workspace;

use crate::problem::{Impulses, Problem};
use crate::scene::Scene;
use crate::solver::gauss_seidel::SMALL;
use crate::spatial::SpatialVector;
use crate::state::State;
use assembly::Assembly;
use prediction::Prediction;
use workspace::PredictionArrays;

/// Takes `state` from `state.time` to `state.time + dt` of `input`. On failure `state` is unchanged.
///
/// # Errors
/// [`StepFailure`] with the worst contact if the tolerances cannot be met.
pub fn step(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
    input: &StepInput,
    effort: Effort,
) -> Result<StepOutput, StepFailure> {
    let pool = workspace.workspace.kernel.pool(scene.settings.threads);
    let mut step = || step_with_replicas(scene, state, workspace, (input, effort), &mut []);
    match scene.particles.len() {
        0..SMALL => step(),
        _ => pool.within(step),
    }
}

/// [`step`] by an input with an effort, and replica it pairs of states to either side of `state`: see `replica`.
///
/// # Errors
/// As [`step`], and if the tangent of the solution is singular.
pub fn step_with_replicas(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
    (input, effort): (&StepInput, Effort),
    pairs: &mut [[Replica<'_>; 2]],
) -> Result<StepOutput, StepFailure> {
    let dt = input.dt;
    let mut kept = std::mem::take(&mut workspace.kept);
    let start = Prediction::of(scene, state, input, &mut kept);
    let replica = |replica: &Replica| {
        Prediction::of(
            scene,
            replica.state,
            &replica.input,
            &mut PredictionArrays::default(),
        )
    };
    let starts = pairs.iter().map(|pair| [0, 1].map(|k| replica(&pair[k])));
    let starts: Vec<[Prediction; 2]> = starts.collect();
    let mut stage = Assembly::new(start.inputs(scene, dt), state, workspace);
    let mut replicas: Vec<ReplicaPair> = starts
        .iter()
        .zip(&*pairs)
        .map(|(starts, pair)| ReplicaPair {
            stages: [0, 1]
                .map(|k| Assembly::replica(&stage, starts[k].inputs(scene, dt), pair[k].state)),
        })
        .collect();
    let outcome = stage.resolve((state, effort), workspace, &mut replicas)?;
    stage.spread_impacts(state);
    for ((pair, starts), states) in replicas.iter_mut().zip(&starts).zip(pairs) {
        pair.agree(&stage);
        for (k, side) in pair.stages.iter().enumerate() {
            let solution = side.problem.velocities(&side.impulses);
            starts[k].finish(side, states[k].state, &solution, dt, &mut Vec::new());
        }
    }
    start.finish(&stage, state, &stage.solution, dt, &mut kept.accelerations);
    workspace.memory = stage.memory();
    (kept.kinematics, kept.external, kept.spheres) =
        (start.kinematics, start.external, start.spheres);
    workspace.kept = kept;
    if outcome.solver.penalty > 0.0 && outcome.solver.penalty.is_finite() {
        state.penalty = outcome.solver.penalty;
    }
    Ok(outcome)
}

/// The problem that a step from `state` by `input` begins with, and the impulses \[N s\] it starts from: candidates within
/// reach, gaps not yet re-linearised.
#[must_use]
pub fn problem(scene: &Scene, state: &State, input: &StepInput) -> (Problem, Impulses) {
    let start = Prediction::of(scene, state, input, &mut PredictionArrays::default());
    let inputs = start.inputs(scene, input.dt);
    let stage = Assembly::new(inputs, state, &mut Workspace::default());
    (stage.problem, stage.impulses)
}

impl Prediction<'_> {
    /// Writes the solution of `stage` into `state`.
    fn finish(
        &self,
        stage: &Assembly,
        state: &mut State,
        solution: &[SpatialVector],
        dt: f64,
        spare: &mut Vec<SpatialVector>,
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
