//! One internal time step, its stages in order.

use crate::Vec3;
use crate::contacts::broad_phase::NeighborList;
use crate::contacts::narrow_phase::{Candidate, Placement};
use crate::contacts::{Contact, Partner, history};
use crate::integrate::turned;
use crate::motion::Pose;
use crate::particles::Kinematics;
use crate::problem::assemble::{Inputs, external_acceleration};
use crate::problem::{Dof6, GROUND, Law, Problem};
use crate::scene::{Integrator, Method, Scene};
use crate::simulation::Wrench;
use crate::solver::augmented_lagrangian::Workspace;
use crate::solver::{Params, Report, solve};
use crate::state::State;

/// Passes of re-linearisation and late contacts before the step is cut.
const PASSES: usize = 30;
/// A loaded contact may leave its linearised surface by this share of the radius before its gap is
/// re-linearised; overlaps are held to the tolerance whatever this is.
const OPENING: f64 = 1e-3;
/// Contacts with a gap below this share of the radius are candidates even at rest.
const NEAR: f64 = 1e-3;
/// Share of the gap tolerance left to the linear problem; the rest is for curvature and rounding.
const LINEAR_SHARE: f64 = 0.5;

/// What is kept between steps for speed and never shows in results.
#[derive(Debug, Default)]
pub struct Scratch {
    neighbors: NeighborList,
    workspace: Workspace,
}

/// Cost and quality of one internal step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StepOutcome {
    /// The solver's report, summed over passes.
    pub solver: Report,
    /// Largest true overlap over radius at the end \[-\].
    pub max_overlap: f64,
}

/// Why an internal step failed; the caller may cut it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepFailure {
    /// Which residual: `gap`, `slip` or `force`.
    pub what: &'static str,
    /// Its value \[-\].
    pub residual: f64,
    /// What was asked for \[-\].
    pub tolerance: f64,
    /// The worst contact, if there is one.
    pub contact: Option<crate::contacts::Key>,
}

/// The step under way: its problem and who its rows are.
struct Stage<'a> {
    inputs: Inputs<'a>,
    start: Placement<'a>,
    problem: Problem,
    candidates: Vec<Candidate>,
    impact: Vec<bool>,
    impulses: Vec<Vec3>,
}

/// Takes `state` from `state.time` to `state.time + dt`, boundaries to `poses`. On failure `state` is unchanged.
///
/// # Errors
/// [`StepFailure`] with the worst contact if the tolerances cannot be met.
pub fn step(
    scene: &Scene,
    state: &mut State,
    scratch: &mut Scratch,
    dt: f64,
    poses: Vec<Pose>,
) -> Result<StepOutcome, StepFailure> {
    let integrator = scene.settings.integrator;
    let (standing, twists) = (state.poses.clone(), state.twists.clone());
    let external = external_acceleration(scene, &state.kinematics, state.gravity);
    let mut kinematics = state.kinematics.clone();
    for (i, persisting) in state.persisting.iter().enumerate() {
        let v = integrator.restep(&dof(&kinematics, i), persisting, state.last_step, dt);
        kinematics.velocity[i] = v.linear;
        kinematics.spin[i] = v.angular;
    }
    let end_time = state.time + dt;
    let targets: Vec<Vec3> = scene
        .springs
        .iter()
        .map(|spring| spring.target + spring.motion.pose_at(end_time).translation)
        .collect();
    let inputs = Inputs {
        scene,
        kinematics: &kinematics,
        external: &external,
        step: dt,
        poses: [&standing, &poses],
        twists: &twists,
        gravity: state.gravity,
        targets: &targets,
    };
    let mut stage = Stage::new(inputs, state, scratch);
    let (solution, outcome) = stage.resolve(state, scratch)?;
    stage.commit(state, &solution);
    if outcome.solver.penalty > 0.0 && outcome.solver.penalty.is_finite() {
        state.penalty = outcome.solver.penalty;
    }
    state.twists = state
        .poses
        .iter()
        .zip(&poses)
        .map(|(from, to)| from.twist_to(to, dt))
        .collect();
    state.poses = poses;
    state.last_step = dt;
    Ok(outcome)
}

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
    let external = external_acceleration(scene, &kinematics, state.gravity);
    let targets: Vec<Vec3> = scene.springs.iter().map(|spring| spring.target).collect();
    let (poses, twists) = (state.poses.clone(), state.twists.clone());
    let inputs = Inputs {
        scene,
        kinematics: &kinematics,
        external: &external,
        step: dt,
        poses: [&poses, &poses],
        twists: &twists,
        gravity: state.gravity,
        targets: &targets,
    };
    let mut stage = Stage::new(inputs, state, scratch);
    stage.keep_resting(scene);
    let report = stage.solve(state, scratch);
    if scene.settings.method == Method::Alm && !report.converged {
        return Err(stage.failure(&report));
    }
    stage.store(state);
    state.springs = stage.spring_forces();
    state.persisting = stage.persisting_acceleration();
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
        boundaries: &scene.boundaries,
        poses: &state.poses,
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
    kinematics.velocity.fill(Vec3::zeros());
    kinematics.spin.fill(Vec3::zeros());
    let poses = state.poses.clone();
    let inputs = Inputs {
        scene,
        kinematics: &kinematics,
        external: &vec![Dof6::ZERO; kinematics.len()],
        step: scene.settings.step,
        poses: [&poses, &poses],
        twists: &vec![Default::default(); poses.len()],
        gravity: Vec3::zeros(),
        targets: &[],
    };
    let mut stage = Stage::new(inputs, state, scratch);
    for row in &mut stage.problem.rows {
        row.law = Law::Contact { mu: 0.0 };
    }
    let (solution, _) = stage.resolve(state, scratch)?;
    state.kinematics.position = stage.moved(&solution);
    Ok(())
}

fn dof(kinematics: &Kinematics, i: usize) -> Dof6 {
    Dof6 {
        linear: kinematics.velocity[i],
        angular: kinematics.spin[i],
    }
}

impl<'a> Stage<'a> {
    /// Candidates within the step's reach, rows, warm start.
    fn new(inputs: Inputs<'a>, state: &State, scratch: &mut Scratch) -> Self {
        let scene = inputs.scene;
        let problem = inputs.bodies();
        let start = Placement {
            particles: &scene.particles,
            position: &inputs.kinematics.position,
            boundaries: &scene.boundaries,
            poses: inputs.poses[0],
        };
        // What a sphere can move in the step, before contacts change its velocity: the check after the
        // solve finds what this misses.
        let reach: Vec<f64> = (0..inputs.kinematics.len())
            .map(|i| {
                let free = problem.free[i].linear.norm();
                let now = inputs.kinematics.velocity[i].norm();
                inputs.step * free.max(now) + NEAR * scene.particles.radius[i]
            })
            .collect();
        let wall_motion = |i: u32, b: u16| {
            let (wall, i) = (&scene.boundaries[usize::from(b)], i as usize);
            let [from, to] = inputs.poses.map(|poses| &poses[usize::from(b)]);
            let x = inputs.kinematics.position[i];
            (wall.from_frame(to, wall.to_frame(from, x)) - x).norm()
        };
        let largest = reach.iter().copied().fold(0.0, f64::max);
        scratch.neighbors.ensure(&start, 2.0 * largest);
        let walls = scratch.neighbors.walls.iter();
        let widest = walls
            .map(|&(i, b)| reach[i as usize] + wall_motion(i, b))
            .fold(0.0, f64::max);
        scratch.neighbors.ensure(&start, widest);
        let candidates = start.candidates(
            &scratch.neighbors,
            |i, j| reach[i as usize] + reach[j as usize],
            |i, b| reach[i as usize] + wall_motion(i, b),
        );
        let mut stage = Self {
            inputs,
            start,
            problem,
            candidates,
            impact: Vec::new(),
            impulses: Vec::new(),
        };
        stage.write_rows(state);
        stage
    }

    /// Rows and warm-start impulses for the candidates and the constrained points.
    fn write_rows(&mut self, state: &State) {
        let forces = history::transfer(&state.contacts, self.candidates.iter().map(|c| c.key));
        self.problem.rows.clear();
        self.impact.clear();
        for (candidate, &force) in self.candidates.iter().zip(&forces) {
            let (row, impact) = self.inputs.contact(&self.problem.free, candidate, force);
            self.problem.rows.push(row);
            self.impact.push(impact);
        }
        let springs = 0..self.inputs.targets.len();
        self.problem
            .rows
            .extend(springs.map(|s| self.inputs.spring(s)));
        let step = self.inputs.step;
        let springs_held = state
            .springs
            .iter()
            .copied()
            .take(self.inputs.targets.len());
        self.impulses = forces
            .into_iter()
            .chain(springs_held)
            .map(|f| f * step)
            .collect();
    }

    /// Keeps the candidates that are closed and neither approach nor part, with zero gap.
    fn keep_resting(&mut self, scene: &Scene) {
        let velocity: Vec<Dof6> = (0..self.inputs.kinematics.len())
            .map(|i| dof(self.inputs.kinematics, i))
            .collect();
        let creep = scene.settings.gravity.norm() * self.inputs.step;
        let closed = scene.settings.tolerance.gap.max(1e-9);
        let contacts = self.candidates.len();
        let keep: Vec<bool> = (0..self.problem.rows.len())
            .map(|k| {
                let row = &self.problem.rows[k];
                k >= contacts
                    || (self.candidates[k].gap <= closed * row.radius
                        && row.normal.dot(&row.relative_velocity(&velocity)).abs() <= 1e-3 * creep)
            })
            .collect();
        for (row, impact) in self.problem.rows.iter_mut().zip(&mut self.impact) {
            if row.compliance_n == 0.0 {
                row.bias = Vec3::zeros();
            }
            *impact = false;
        }
        retain(&mut self.impulses, &keep);
        retain(&mut self.problem.rows, &keep);
        retain(&mut self.candidates, &keep);
        self.impact.truncate(self.candidates.len());
    }

    /// Solves the problem as it stands.
    fn solve(&mut self, state: &State, scratch: &mut Scratch) -> Report {
        let settings = &self.inputs.scene.settings;
        let mut tolerance = settings.tolerance;
        tolerance.gap *= LINEAR_SHARE;
        let penalty_method = settings.method == Method::Penalty;
        let params = Params {
            kind: settings.solver,
            tolerance,
            max_sweeps: settings.max_iterations,
            max_factorizations: settings.max_iterations.div_ceil(20),
            // Contact springs carry the penalty themselves: nothing is left to augment.
            penalty: if penalty_method {
                f64::INFINITY
            } else {
                state.penalty
            },
            adapt_penalty: settings.adapt_penalty && !penalty_method,
        };
        solve(
            &self.problem,
            &params,
            &mut scratch.workspace,
            &mut self.impulses,
        )
    }

    /// Solves until the true geometry agrees: gaps are re-linearised, late contacts join.
    fn resolve(
        &mut self,
        state: &State,
        scratch: &mut Scratch,
    ) -> Result<(Vec<Dof6>, StepOutcome), StepFailure> {
        let mut total = Report::default();
        for _ in 0..PASSES {
            total = total.then(self.solve(state, scratch));
            if !total.converged {
                return Err(self.failure(&total));
            }
            let solution = self.problem.velocities(&self.impulses);
            let position = self.moved(&solution);
            let end = Placement {
                position: &position,
                poses: self.inputs.poses[1],
                ..self.start
            };
            scratch.neighbors.ensure(&end, 0.0);
            let closed = end.candidates(&scratch.neighbors, |_, _| 0.0, |_, _| 0.0);
            let max_overlap = closed
                .iter()
                .map(|c| -c.gap / end.scale(c.key))
                .fold(0.0, f64::max);
            if self.inputs.scene.settings.method == Method::Penalty
                || !self.correct(&end, &closed, &solution, state)
            {
                return Ok((
                    solution,
                    StepOutcome {
                        solver: total,
                        max_overlap,
                    },
                ));
            }
        }
        Err(StepFailure {
            what: "gap",
            residual: f64::NAN,
            tolerance: self.inputs.scene.settings.tolerance.gap,
            contact: None,
        })
    }

    /// Compares the linear gaps with the true ones at the end of the step. Re-linearises those that are off
    /// (the gap only: normals and arms keep the start of the step, as in SHAKE) and adds contacts that closed
    /// without being candidates. Returns whether anything changed.
    fn correct(
        &mut self,
        end: &Placement,
        closed: &[Candidate],
        solution: &[Dof6],
        state: &State,
    ) -> bool {
        let settings = &self.inputs.scene.settings;
        let tolerance = settings.tolerance.gap;
        let step = self.inputs.step;
        let mut true_gaps = Vec::with_capacity(self.candidates.len());
        let mut off = false;
        for (k, candidate) in self.candidates.iter().enumerate() {
            let row = &self.problem.rows[k];
            // With a contact stiffness the spring's compression is not an overlap.
            let compression = self.impulses[k].dot(&row.normal) * row.compliance_n * step;
            let gap = end.follow(candidate).gap + compression;
            let overlaps = gap < -tolerance * row.radius;
            let opens =
                self.impulses[k] != Vec3::zeros() && !self.impact[k] && gap > OPENING * row.radius;
            off |= overlaps || opens;
            true_gaps.push(gap);
        }
        let late: Vec<Candidate> = closed
            .iter()
            .filter(|c| c.gap < -tolerance * end.scale(c.key))
            .filter(|c| {
                self.candidates
                    .binary_search_by_key(&c.key, |known| known.key)
                    .is_err()
            })
            .copied()
            .collect();
        if !off && late.is_empty() {
            return false;
        }
        for (k, gap) in true_gaps.into_iter().enumerate() {
            let row = &mut self.problem.rows[k];
            let n = row.normal;
            let linear = step * n.dot(&row.relative_velocity(solution));
            let compression = self.impulses[k].dot(&n) * row.compliance_n * step;
            let wanted = (gap - compression - linear) / step;
            let now = row.bias.dot(&n);
            if self.impact[k] {
                // A rebound yields only to an overlap.
                if gap < -tolerance * row.radius {
                    row.bias += n * (wanted.min(now) - now);
                }
            } else {
                row.bias += n * (wanted - now);
            }
        }
        for found in late {
            self.insert(found, solution, state);
        }
        true
    }

    /// Adds a contact that `solution` closes: its normal is the one it closes with.
    fn insert(&mut self, found: Candidate, solution: &[Dof6], state: &State) {
        let force = history::transfer(&state.contacts, std::iter::once(found.key))[0];
        let (mut row, impact) = self.inputs.contact(&self.problem.free, &found, force);
        let linear = self.inputs.step * found.normal.dot(&row.relative_velocity(solution));
        row.bias +=
            row.normal * ((found.gap - linear) / self.inputs.step - row.bias.dot(&row.normal));
        let at = self.candidates.partition_point(|c| c.key < found.key);
        self.candidates.insert(at, found);
        self.problem.rows.insert(at, row);
        self.impact.insert(at, impact);
        self.impulses.insert(at, Vec3::zeros());
    }

    fn moved(&self, solution: &[Dof6]) -> Vec<Vec3> {
        let start = self.inputs.kinematics.position.iter();
        start
            .zip(solution)
            .map(|(x, v)| x + v.linear * self.inputs.step)
            .collect()
    }

    fn failure(&self, report: &Report) -> StepFailure {
        let tolerance = &self.inputs.scene.settings.tolerance;
        let residual = &report.residual;
        let kinds = [
            ("gap", residual.gap, tolerance.gap, residual.worst[0]),
            ("slip", residual.slip, tolerance.slip, residual.worst[1]),
            ("force", residual.force, tolerance.force, residual.worst[2]),
        ];
        let excess = |(_, value, limit, _): &(_, f64, f64, _)| value / limit;
        let worst = kinds.iter().max_by(|a, b| excess(a).total_cmp(&excess(b)));
        let (what, residual, tolerance, row) = worst.copied().unwrap_or(kinds[0]);
        StepFailure {
            what,
            residual,
            tolerance,
            contact: self.candidates.get(row).map(|c| c.key),
        }
    }

    /// Contact forces and boundary wrenches into `state`.
    fn store(&self, state: &mut State) {
        let step = self.inputs.step;
        let boundaries = &self.inputs.scene.boundaries;
        state.contacts.clear();
        state.wrenches = vec![Wrench::default(); boundaries.len()];
        state.persisting_wrenches = state.wrenches.clone();
        for (k, candidate) in self.candidates.iter().enumerate() {
            let force = self.impulses[k] / step;
            if force == Vec3::zeros() {
                continue;
            }
            state.contacts.push(Contact {
                key: candidate.key,
                point: candidate.point,
                normal: candidate.normal,
                gap: candidate.gap,
                force,
            });
            if let Partner::Boundary { boundary, .. } = candidate.key.partner {
                let b = usize::from(boundary);
                let row = &self.problem.rows[k];
                let point = self.inputs.kinematics.position[row.a as usize] + row.arm_a;
                let pivot = boundaries[b].point_of_action + self.inputs.poses[0][b].translation;
                let wrench = Wrench {
                    force: -force,
                    torque: -(point - pivot).cross(&force),
                };
                state.wrenches[b].add(&wrench, 1.0);
                if !self.impact.get(k).copied().unwrap_or(false) {
                    state.persisting_wrenches[b].add(&wrench, 1.0);
                }
            }
        }
    }

    fn spring_forces(&self) -> Vec<Vec3> {
        self.impulses[self.candidates.len()..]
            .iter()
            .map(|p| p / self.inputs.step)
            .collect()
    }

    /// Acceleration by external forces and all contacts that are no impacts, `[N]`.
    fn persisting_acceleration(&self) -> Vec<Dof6> {
        let mut acceleration = self.inputs.external.to_vec();
        let mobility = 1.0 / self.inputs.scene.settings.integrator.mobility();
        for (k, row) in self.problem.rows.iter().enumerate() {
            if !self.impact.get(k).copied().unwrap_or(false) {
                let force = self.impulses[k] * (mobility / self.inputs.step);
                row.apply(&self.problem.inverse_mass, &mut acceleration, force);
            }
        }
        acceleration
    }

    /// Writes the solution into `state`: motion, forces, work.
    fn commit(&self, state: &mut State, solution: &[Dof6]) {
        let scene = self.inputs.scene;
        let settings = &scene.settings;
        let step = self.inputs.step;
        self.work(state, solution);
        self.store(state);
        state.springs = self.spring_forces();
        state.persisting = self.persisting_acceleration();
        let position = self.moved(solution);
        for (i, v1) in solution.iter().enumerate() {
            let after = settings
                .integrator
                .finish(&dof(self.inputs.kinematics, i), v1, settings);
            state.kinematics.velocity[i] = after.linear;
            state.kinematics.spin[i] = after.angular;
            state.kinematics.orientation[i] =
                turned(&self.inputs.kinematics.orientation[i], &v1.angular, step);
        }
        state.kinematics.position = position;
        let end = Placement {
            position: &state.kinematics.position,
            poses: self.inputs.poses[1],
            ..self.start
        };
        for (contact, candidate) in state.contacts.iter_mut().zip(
            self.candidates
                .iter()
                .zip(&self.impulses)
                .filter(|(_, p)| **p != Vec3::zeros())
                .map(|(c, _)| c),
        ) {
            let now = end.follow(candidate);
            contact.point = now.point;
            contact.gap = now.gap;
        }
    }

    /// Adds the step's work. A contact's is `p . (u^- + u^+)/2` in the velocities the integrator carries.
    fn work(&self, state: &mut State, solution: &[Dof6]) {
        let settings = &self.inputs.scene.settings;
        let before: Vec<Dof6> = (0..solution.len())
            .map(|i| dof(self.inputs.kinematics, i))
            .collect();
        let mean: Vec<Dof6> = before
            .iter()
            .zip(solution)
            .map(|(before, v1)| match settings.integrator {
                Integrator::Moreau => Dof6::ZERO.plus(before, 0.5).plus(v1, 0.5),
                Integrator::Shi => *v1,
            })
            .collect();
        for (k, row) in self.problem.rows.iter().enumerate() {
            let p = self.impulses[k];
            let relative = p.dot(&row.relative_velocity(&mean));
            if k >= self.candidates.len() {
                state.work.springs += relative;
            } else {
                state.work.dissipated -= relative;
                if row.b == GROUND {
                    state.work.boundaries -= p.dot(&row.drift);
                }
            }
        }
        for load in &self.inputs.scene.loads {
            let arm = self.inputs.kinematics.orientation[load.sphere] * load.arm;
            state.work.loads += self.inputs.step * load.force.dot(&mean[load.sphere].at(arm));
        }
    }
}

/// Keeps the entries whose flag is set; entries beyond the flags stay.
fn retain<T>(items: &mut Vec<T>, keep: &[bool]) {
    let mut flags = keep.iter();
    items.retain(|_| flags.next().copied().unwrap_or(true));
}
