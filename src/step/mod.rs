//! One internal time step, its stages in order: `stage` finds candidates and writes rows, `resolve` solves until the true
//! geometry agrees, `commit` writes the solution into the state; `start` does the same at t = 0.

pub mod assemble;
mod beside;
mod commit;
pub mod driven;
mod external;
mod failure;
mod passing;
mod resolve;
mod stage;
mod start;

pub use beside::Beside;
use beside::Twin;
pub(crate) use external::release;
pub use start::{initial_forces, remove_overlaps};

use crate::Vec3;
use crate::detection::broad_phase::{NeighborList, Reach};
use crate::linalg::LinearError;
use crate::problem::{Impulses, Problem};
use crate::scene::Scene;
use crate::scene::particles::Kinematics;
use crate::solver::Report;
use crate::solver::augmented_lagrangian::Workspace;
use crate::solver::gauss_seidel::SMALL;
use crate::spatial::{Dof6, Pose, Twist};
use crate::state::State;
use crate::step::assemble::{Inputs, Mover, mean_acceleration};
use crate::step::driven::Ready;
use stage::{Memory, Stage};

/// What is kept between steps for speed and never shows in results.
#[derive(Debug, Default)]
pub struct Scratch {
    neighbors: NeighborList,
    workspace: Workspace,
    memory: Memory,
    reach: Vec<Reach>,
    kept: Kept,
}

/// Cost and quality of one internal step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StepOutcome {
    /// The solver's report, summed over passes.
    pub solver: Report,
    /// Largest true overlap over radius at the end \[-\].
    pub max_overlap: f64,
    /// How near a contact is to the edge of its state \[-\]: [`crate::state::StepReport::kink`].
    pub kink: f64,
    /// Whether the tolerances were not met and the best iterate was taken.
    pub unconverged: bool,
}

impl StepOutcome {
    fn of(solver: Report, max_overlap: f64) -> Self {
        Self {
            solver,
            max_overlap,
            kink: solver.residual.kink,
            unconverged: false,
        }
    }
}

/// How far a step goes before it fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Effort {
    /// Most Gauss-Seidel sweeps of a solve, where the step can be cut instead; `None`: every solver as long as it may.
    pub sweeps: Option<usize>,
    /// Whether the best iterate of a solve that does not converge is taken.
    pub accept: bool,
    /// Whether bodies may move so far against each other that they could pass.
    pub pass: bool,
}

/// Why an internal step failed; the caller may cut it.
#[derive(Debug, Clone, PartialEq)]
pub struct StepFailure {
    /// Which residual: `gap`, `slip` or `force`.
    pub what: &'static str,
    /// Its value \[-\].
    pub residual: f64,
    /// What was asked for \[-\].
    pub tolerance: f64,
    /// The worst contact, if there is one.
    pub contact: Option<crate::contact::Key>,
    /// A sphere that two rigid boundaries press from opposite sides, and the boundaries.
    pub pinched: Option<(usize, [u16; 2])>,
    /// Two bodies that would pass through each other within the step.
    pub passed: Option<Passed>,
    /// The linear system that ended the solver early.
    pub broken: Option<Box<LinearError>>,
}

/// Two bodies that move so far against each other in a step that contact at its ends does not tell what happens between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passed {
    /// The pair; of a boundary's features none in particular.
    pub contact: crate::contact::Key,
    /// Relative motion over the smaller radius \[-\].
    pub motion: f64,
}

/// Takes `state` from `state.time` to `state.time + dt`, boundaries to `poses`. On failure `state` is unchanged.
///
/// # Errors
/// [`StepFailure`] with the worst contact if the tolerances cannot be met.
pub fn step(
    scene: &Scene,
    state: &mut State,
    scratch: &mut Scratch,
    (dt, poses): (f64, Vec<Pose>),
    effort: Effort,
) -> Result<StepOutcome, StepFailure> {
    let pool = scratch.workspace.kernel.pool(scene.settings.threads);
    let step = || step_beside(scene, state, scratch, (dt, poses, effort), &mut []);
    match scene.particles.len() {
        0..SMALL => step(),
        _ => pool.within(step),
    }
}

/// [`step`] to `(dt, poses)` with an effort, and beside it pairs of states to either side of `state`: see `beside`.
///
/// # Errors
/// As [`step`], and if the tangent of the solution is singular.
pub fn step_beside(
    scene: &Scene,
    state: &mut State,
    scratch: &mut Scratch,
    (dt, poses, effort): (f64, Vec<Pose>, Effort),
    pairs: &mut [[Beside<'_>; 2]],
) -> Result<StepOutcome, StepFailure> {
    let mut kept = std::mem::take(&mut scratch.kept);
    kept.kinematics.swap_places(&mut state.kinematics);
    let mut start = Start::of(scene, state, dt, poses, &mut kept);
    let beside = |beside: &Beside| {
        let poses = beside.poses.clone();
        Start::of(scene, beside.state, dt, poses, &mut Kept::of(beside.state))
    };
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
    let outcome = match stage.resolve((state, effort), scratch, &mut twins) {
        Ok(outcome) => outcome,
        Err(failure) => {
            start.kinematics.swap_places(&mut state.kinematics);
            return Err(failure);
        }
    };
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

/// The problem that a step of `dt` \[s\] from `state` begins with, boundaries moving to `poses`, and the impulses \[N s\] it
/// starts from: candidates within reach, gaps not yet re-linearised.
#[must_use]
pub fn problem(scene: &Scene, state: &State, dt: f64, poses: &[Pose]) -> (Problem, Impulses) {
    let start = Start::of(scene, state, dt, poses.to_vec(), &mut Kept::of(state));
    let inputs = start.inputs(scene, dt);
    let stage = Stage::new(inputs, state, &mut Scratch::default());
    (stage.problem, stage.impulses)
}

/// Arrays kept from step to step for their memory alone.
#[derive(Debug, Default)]
struct Kept {
    /// As a step begins, with the places of its state, which gets these for those at the end.
    kinematics: Kinematics,
    external: Vec<Dof6>,
    movers: Vec<Mover>,
    accelerations: Vec<Dof6>,
}

impl Kept {
    /// For a step that leaves `state` its places.
    fn of(state: &State) -> Self {
        Self {
            kinematics: state.kinematics.clone(),
            ..Self::default()
        }
    }
}

/// What a step takes from the state before it moves anything.
struct Start<'a> {
    kinematics: Kinematics,
    gravity: Vec3,
    external: Vec<Dof6>,
    movers: Vec<Mover>,
    targets: Vec<Vec3>,
    standing: Vec<Pose>,
    ends: Vec<Pose>,
    bodies: Vec<Ready<'a>>,
    twists: Vec<Twist>,
    surfaces: Vec<Vec3>,
}

/// Velocities of the boundaries' surfaces against their shapes \[m/s\], world axes, `[B]`.
fn surfaces(scene: &Scene, state: &State) -> Vec<Vec3> {
    let boundaries = scene.boundaries.iter();
    let driven = boundaries.zip(state.poses.iter().zip(&state.commands));
    driven
        .map(|(boundary, (pose, command))| boundary.surface_velocity(pose, command))
        .collect()
}

impl<'s> Start<'s> {
    /// With the places in `kept`, and velocities of `state` for a step of `dt` \[s\].
    fn of(scene: &'s Scene, state: &State, dt: f64, mut ends: Vec<Pose>, kept: &mut Kept) -> Self {
        let bodies = Ready::all(scene, state, dt);
        for body in &bodies {
            let b = body.boundary;
            ends[b] = body.moved(&state.poses[b], &body.free, dt);
        }
        let integrator = scene.settings.integrator;
        let mut kinematics = std::mem::take(&mut kept.kinematics);
        kinematics.present.clone_from(&state.kinematics.present);
        kinematics.velocity.clear();
        kinematics.spin.clear();
        let count = state.kinematics.len();
        kinematics.velocity.reserve_exact(count);
        kinematics.spin.reserve_exact(count);
        for (i, persisting) in state.persisting.iter().enumerate() {
            let v = dof(&state.kinematics, i);
            let v = integrator.restep(&v, persisting, state.last_step, dt);
            kinematics.velocity.push(v.linear);
            kinematics.spin.push(v.angular);
        }
        let end_time = state.time + dt;
        let springs = scene.springs.iter();
        let gravity = state.gravity_at(scene, integrator.middle(state.time, dt));
        let mut external = std::mem::take(&mut kept.external);
        external::acceleration(scene, state, &kinematics, (gravity, dt), &mut external);
        let memory = std::mem::take(&mut kept.movers);
        let movers = Mover::all(scene, &kinematics, memory);
        Self {
            gravity,
            external,
            movers,
            kinematics,
            targets: springs
                .map(|spring| spring.target + spring.motion.pose_at(end_time).translation)
                .collect(),
            standing: state.poses.clone(),
            ends,
            bodies,
            twists: state.twists.clone(),
            surfaces: surfaces(scene, state),
        }
    }

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

    fn inputs<'a>(&'a self, scene: &'a Scene, dt: f64) -> Inputs<'a> {
        Inputs {
            scene,
            kinematics: &self.kinematics,
            external: &self.external,
            movers: &self.movers,
            step: dt,
            poses: [&self.standing, &self.ends],
            bodies: &self.bodies,
            twists: &self.twists,
            surfaces: &self.surfaces,
            gravity: self.gravity,
            gravity_size: self.gravity.norm(),
            targets: &self.targets,
            mean_acceleration: mean_acceleration(scene, &self.external, &self.bodies),
        }
    }
}

fn dof(kinematics: &Kinematics, i: usize) -> Dof6 {
    Dof6 {
        linear: kinematics.velocity[i],
        angular: kinematics.spin[i],
    }
}
