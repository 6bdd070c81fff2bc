//! The step under way: candidates, rows and their impulses.

use std::mem::take;

use super::Effort;
use super::workspace::Workspace;
use crate::Vec3;
use crate::contact::history;
use crate::contact::history::HistoryIndex;
use crate::detection::configuration::{Candidate, Configuration};
use crate::detection::detection_distance::DetectionDistance;
use crate::parallel::Pool;
use crate::problem::{Law, Problem, RowWriter};
use crate::scene::Method;
use crate::solver::residual::{Scale, evaluate};
use crate::solver::{Params, Report, SMOOTHING, SolverKind, solve};
use crate::spatial::extent::larger;
use crate::spatial::{Pose, SpatialVector};
use crate::state::State;
use crate::step::assemble::AssemblyInput;
use crate::step::assemble::joint::JointConstraint;
use crate::step::workspace::AssemblyArrays;

/// Contacts with a gap below this share of the radius are candidates even at rest.
const NEAR: f64 = 1e-3;
/// Sweeps of every step where contacts keep their gaps. At rest one would do, and leave the same error in each step: a bed
/// creeps by their sum.
const STANDING_SWEEPS: usize = 3;
/// Share of the gap tolerance left to the linear problem; the rest is for curvature and rounding.
const LINEAR_SHARE: f64 = 0.9;

/// The step under way: its problem and who its rows are.
pub(super) struct Assembly<'a> {
    pub(super) inputs: AssemblyInput<'a>,
    pub(super) pool: Pool,
    pub(super) start: Configuration<'a>,
    pub(super) problem: Problem,
    pub(super) candidates: Vec<Candidate>,
    pub(super) impact: Vec<bool>,
    /// Stops and springs of the driven bodies: their rows follow those of the constrained points.
    pub(super) joints: Vec<JointConstraint>,
    pub(super) impulses: Vec<Vec3>,
    /// Which contacts of the last step the candidates go on with.
    pub(super) past: Vec<HistoryIndex>,
    /// Velocities of the impulses, `[N + D]`, and where they lead the spheres \[m\], `[N]`: of the last pass of the solve.
    pub(super) solution: Vec<SpatialVector>,
    pub(super) position: Vec<Vec3>,
    /// Pairs that overlap there beyond the tolerance.
    pub(super) closed: Vec<Candidate>,
    /// Whether bodies move through the step: a displacement that removes overlaps is no way.
    pub(super) moves: bool,
}

/// Of pieces of the contacts: their past, whether they are impacts, and their impulses.
type Others<'a> = (&'a mut [HistoryIndex], (&'a mut [bool], &'a mut [Vec3]));

impl<'a> Assembly<'a> {
    /// Candidates within the step's reach, rows, warm start.
    pub(super) fn new(inputs: AssemblyInput<'a>, state: &State, workspace: &mut Workspace) -> Self {
        let pool = workspace
            .workspace
            .kernel
            .pool(inputs.scene.settings.threads);
        let mut stage = Self::empty(inputs, take(&mut workspace.memory), pool);
        let (scene, start, step) = (inputs.scene, stage.start, inputs.step);
        // What a sphere can move in the step, before contacts change its velocity: the check after the
        // solve finds what this misses. Against other spheres what all have in common does not count.
        let both = inputs.kinematics.velocity.iter().zip(&stage.problem.free);
        let both = both.map(|(now, free)| [*now, free.linear]);
        let radii = &scene.particles.radius;
        let mut reach = take(&mut workspace.reach);
        DetectionDistance::of(both, step, |i| NEAR * radii[i], &mut reach);
        let boundary_motion = |i: u32, b: u16| {
            let b = usize::from(b);
            start.way_at(
                b,
                &inputs.poses[1][b],
                inputs.kinematics.position[i as usize],
            )
        };
        let largest = radii.iter().copied().fold(0.0, larger);
        let diameter = 2.0 * (largest + DetectionDistance::largest(&reach).pairs);
        let kernel = &mut workspace.workspace.kernel;
        kernel.prepare(start.position, diameter);
        // Of every sphere and boundary: what the list holds already must not decide what it lacks.
        let carried = (0..scene.boundaries.len()).map(|b| start.carried(b, &inputs.poses[1][b]));
        let carried = carried.fold(0.0, f64::max);
        workspace.neighbors.ensure(&start, &reach, carried);
        start.candidates(
            &workspace.neighbors,
            |i, j| {
                let [a, b] = [i, j].map(|k| &reach[k as usize]);
                (a.pairs + b.pairs).min(a.boundaries + b.boundaries)
            },
            |i, b| reach[i as usize].boundaries + boundary_motion(i, b),
            &mut stage.candidates,
        );
        workspace.reach = reach;
        stage.write_rows(state, None);
        stage
    }

    /// The step replica `other`, from slightly other data: the same contacts, each an impact if it is one there.
    pub(super) fn replica(other: &Assembly, inputs: AssemblyInput<'a>, state: &State) -> Self {
        let mut stage = Self::empty(inputs, AssemblyArrays::default(), Pool::default());
        let candidates = other.candidates.iter();
        stage.candidates = candidates.map(|c| follow(&stage.start, c)).collect();
        stage.moves = other.moves;
        stage.write_rows(state, Some(&other.impact));
        stage
    }

    /// Bodies, and nothing between them.
    fn empty(inputs: AssemblyInput<'a>, mut memory: AssemblyArrays, pool: Pool) -> Self {
        inputs.bodies(&mut memory.problem);
        memory.candidates.clear();
        memory.closed.clear();
        memory.impact.clear();
        memory.joints.clear();
        memory.impulses.clear();
        Self {
            inputs,
            pool,
            start: Configuration::of(inputs.scene, inputs.kinematics, inputs.poses[0]),
            problem: memory.problem,
            candidates: memory.candidates,
            closed: memory.closed,
            impact: memory.impact,
            joints: memory.joints,
            impulses: memory.impulses,
            past: memory.past,
            solution: memory.solution,
            position: memory.position,
            moves: true,
        }
    }

    /// Its arrays, for the next step.
    pub(super) fn memory(self) -> AssemblyArrays {
        AssemblyArrays {
            problem: self.problem,
            candidates: self.candidates,
            closed: self.closed,
            impact: self.impact,
            joints: self.joints,
            impulses: self.impulses,
            past: self.past,
            solution: self.solution,
            position: self.position,
        }
    }

    /// Rows and warm-start impulses for the candidates, the constrained points, the stops and springs of driven bodies and
    /// the contacts' resistances, in this order.
    fn write_rows(&mut self, state: &State, known_impact: Option<&[bool]>) {
        let step = self.inputs.step;
        let (inputs, candidates, contacts) = (&self.inputs, &self.candidates[..], &*state.contacts);
        let Problem { free, rows, .. } = &mut self.problem;
        let count = candidates.len();
        self.past.resize(count, HistoryIndex::NONE);
        self.impact.resize(count, false);
        self.impulses.resize(count, Vec3::zeros());
        let known_impact = |k: usize| known_impact.map(|known_impact| known_impact[k]);
        let write = |first: usize, (mut rows, others): (RowWriter, Others)| {
            let (past, (impact, impulses)) = others;
            let keys = candidates[first..].iter().map(|candidate| candidate.key);
            let transferred = history::transfer(contacts, keys);
            let mut whole = false;
            for (k, (past, transferred)) in past.iter_mut().zip(transferred).enumerate() {
                *past = transferred;
                let (candidate, force) = (&candidates[first + k], past.force(contacts));
                let (row, hits, plain) =
                    inputs.contact_row(free, candidate, force, known_impact(first + k));
                rows.write(k, &row, plain);
                impact[k] = hits;
                impulses[k] = force * step;
                whole |= !plain;
            }
            whole
        };
        let others = (&mut self.impact[..], &mut self.impulses[..]);
        let all = (rows.extend_plain(count), (&mut self.past[..], others));
        if self.pool.pieces(all, write, |a, b| a | b) {
            rows.settle(|k| {
                let force = self.past[k].force(contacts);
                inputs
                    .contact(free, &candidates[k], force, known_impact(k))
                    .0
            });
        }
        let springs = 0..self.inputs.targets.len();
        self.problem
            .rows
            .extend(springs.map(|s| self.inputs.spring(s)));
        let springs_held = state.springs.iter().take(self.inputs.targets.len());
        self.impulses.extend(springs_held.map(|f| f * step));
        for (rank, body) in self.inputs.bodies.iter().enumerate() {
            for limit in body.joint_limits() {
                let (row, impact) = self.inputs.limit(&self.problem.free, rank, &limit);
                self.problem.rows.push(row);
                self.impulses.push(limit.direction * (limit.force * step));
                self.joints.push(JointConstraint { limit, impact });
            }
        }
        if self.inputs.scene.pairs.resists() {
            for k in 0..self.candidates.len() {
                self.resist(state, k);
            }
        }
    }

    /// Adds the resistance of contact `k`, if it has one, with its last couple.
    pub(super) fn resist(&mut self, state: &State, k: usize) {
        let (row, torque) = (
            self.problem.rows.get(k),
            self.past[k].torque(&state.contacts),
        );
        let key = self.candidates[k].key;
        if let Some(resistance) = self.inputs.resistance(key, &row, k, torque) {
            let lever = resistance.radius;
            self.problem.rows.push(resistance);
            self.impulses.push(torque * (self.inputs.step / lever));
        }
    }

    /// The contact that row `k` is, or whose resistance it is.
    pub(super) fn contact_of(&self, k: usize) -> Option<usize> {
        if k < self.candidates.len() {
            return Some(k);
        }
        match self.problem.rows.general(k)?.law {
            Law::Resistance { contact, .. } => Some(contact as usize),
            _ => None,
        }
    }

    /// Whether row `k` belongs to an impact.
    pub(super) fn is_impact(&self, k: usize) -> bool {
        match self.contact_of(k) {
            Some(contact) => self.impact[contact],
            None => self.joint(k).is_some_and(|joint| joint.impact),
        }
    }

    /// Row of the first stop or spring of a driven body.
    pub(super) fn first_joint(&self) -> usize {
        self.candidates.len() + self.inputs.targets.len()
    }

    /// The stop or spring that row `k` is.
    pub(super) fn joint(&self, k: usize) -> Option<&JointConstraint> {
        self.joints.get(k.checked_sub(self.first_joint())?)
    }

    /// Solves the problem as it stands; by `sweeps` at most, if so many are given.
    pub(super) fn solve(
        &mut self,
        (state, effort): (&State, Effort),
        workspace: &mut Workspace,
        sweeps: Option<usize>,
    ) -> Report {
        let mut params = self.params(state);
        params.accept = effort.accept;
        if let Some(sweeps) = sweeps {
            params.kind = SolverKind::GaussSeidel;
            params.max_sweeps = sweeps;
        }
        let workspace = &mut workspace.workspace;
        workspace.velocity = take(&mut self.solution);
        let report = solve(&self.problem, &params, workspace, &mut self.impulses);
        self.solution = take(&mut workspace.velocity);
        report
    }

    /// Brings forces that are solved already to the residual `force` as far as Gauss-Seidel gets.
    pub(super) fn polish(&mut self, state: &State, workspace: &mut Workspace, force: f64) {
        let mut params = self.params(state);
        params.kind = SolverKind::GaussSeidel;
        params.tolerance.force = params.tolerance.force.min(force);
        let before = self.impulses.clone();
        let scales = Scale::of(&self.problem);
        let coarse = evaluate(&self.problem, &scales, &before).force;
        let workspace = &mut workspace.workspace;
        let report = solve(&self.problem, &params, workspace, &mut self.impulses);
        if !report.converged && report.residual.force > coarse {
            self.impulses = before;
        }
    }

    fn params(&self, state: &State) -> Params {
        let settings = &self.inputs.scene.settings;
        let mut tolerance = settings.tolerance;
        tolerance.gap *= LINEAR_SHARE;
        let penalty_method = settings.method == Method::Penalty;
        Params {
            kind: settings.solver,
            tolerance,
            accept: false,
            min_sweeps: if settings.opening > 0.0 {
                STANDING_SWEEPS
            } else {
                1
            },
            max_sweeps: settings.max_iterations,
            max_factorizations: settings.max_iterations.div_ceil(20),
            // Contact springs carry the penalty themselves: nothing is left to augment.
            penalty: if penalty_method {
                f64::INFINITY
            } else {
                state.penalty
            },
            adapt_penalty: settings.adapt_penalty && !penalty_method,
            // A penalty joint by the scene asks for the paper's loop and nothing else.
            smoothing: if settings.adapt_penalty { SMOOTHING } else { 0 },
        }
    }

    /// Boundary poses at the end of the step, `[B]`: prescribed ones, and those that the driven bodies reach.
    pub(super) fn end_poses(&self, solution: &[SpatialVector]) -> Vec<Pose> {
        let [start, end] = self.inputs.poses;
        let mut ends = end.to_vec();
        let bodies = &solution[self.inputs.kinematics.len()..];
        for (body, velocity) in self.inputs.bodies.iter().zip(bodies) {
            let b = body.boundary;
            ends[b] = body.moved(&start[b], velocity, self.inputs.step);
        }
        ends
    }

    /// Where `solution` leads the spheres \[m\], `[N]`.
    pub(super) fn moved(&self, solution: &[SpatialVector]) -> Vec<Vec3> {
        let mut position = Vec::new();
        self.lead(solution, &mut position);
        position
    }

    /// [`Self::moved`] into `position`.
    pub(super) fn lead(&self, solution: &[SpatialVector], position: &mut Vec<Vec3>) {
        let start = self.inputs.kinematics.position.iter().zip(solution);
        position.clear();
        position.extend(start.map(|(x, v)| x + v.linear * self.inputs.step));
    }
}

/// The pair of `candidate` at another configuration; where that has no such feature, as it was.
pub(super) fn follow(at: &Configuration, candidate: &Candidate) -> Candidate {
    let found = at.follow(candidate);
    match found.gap.is_finite() {
        true => found,
        false => *candidate,
    }
}
