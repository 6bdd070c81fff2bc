//! The step under way: candidates, rows, and the solve that repeats until the true geometry agrees.

use super::beside::{self, Twin};
use super::{Passed, Scratch, StepFailure, StepOutcome};
use crate::Vec3;
use crate::contacts::narrow_phase::{Candidate, Placement};
use crate::contacts::{Partner, history};
use crate::driven::Hold;
use crate::linalg::LinearError;
use crate::motion::Pose;
use crate::problem::assemble::Inputs;
use crate::problem::{Dof6, Law, Problem};
use crate::scene::{Method, SolverKind};
use crate::solver::residual::{Scale, evaluate};
use crate::solver::{Params, Report, SMOOTHING, solve};
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

/// A stop or spring of a driven body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Held {
    pub(super) hold: Hold,
    pub(super) impact: bool,
}

/// The step under way: its problem and who its rows are.
pub(super) struct Stage<'a> {
    pub(super) inputs: Inputs<'a>,
    pub(super) start: Placement<'a>,
    pub(super) problem: Problem,
    pub(super) candidates: Vec<Candidate>,
    pub(super) impact: Vec<bool>,
    /// Stops and springs of the driven bodies: their rows follow those of the constrained points.
    pub(super) holds: Vec<Held>,
    pub(super) impulses: Vec<Vec3>,
    /// Whether bodies move through the step: a displacement that removes overlaps is no way.
    pub(super) moves: bool,
}

impl<'a> Stage<'a> {
    /// Candidates within the step's reach, rows, warm start.
    pub(super) fn new(inputs: Inputs<'a>, state: &State, scratch: &mut Scratch) -> Self {
        let scene = inputs.scene;
        let problem = inputs.bodies();
        let start = Placement {
            particles: &scene.particles,
            position: &inputs.kinematics.position,
            present: &inputs.kinematics.present,
            boundaries: &scene.boundaries,
            poses: inputs.poses[0],
            cell: &scene.cell,
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
            let x = wall.copy_near(&scene.cell, from, inputs.kinematics.position[i]);
            (wall.from_frame(to, wall.to_frame(from, x)) - x).norm()
        };
        let largest = reach.iter().copied().fold(0.0, f64::max);
        // Of every sphere and boundary: what the list holds already must not decide what it lacks.
        let carried = (0..scene.boundaries.len()).map(|b| start.carried(b, &inputs.poses[1][b]));
        let widest = carried.fold(largest, |widest, way| widest.max(largest + way));
        scratch.neighbors.ensure(&start, widest.max(2.0 * largest));
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
            holds: Vec::new(),
            impulses: Vec::new(),
            moves: true,
        };
        stage.write_rows(state, None);
        stage
    }

    /// The step beside `other`, from slightly other data: the same contacts, each an impact if it is one there.
    pub(super) fn beside(other: &Stage, inputs: Inputs<'a>, state: &State) -> Self {
        let scene = inputs.scene;
        let start = Placement {
            particles: &scene.particles,
            position: &inputs.kinematics.position,
            present: &inputs.kinematics.present,
            boundaries: &scene.boundaries,
            poses: inputs.poses[0],
            cell: &scene.cell,
        };
        let mut stage = Self {
            problem: inputs.bodies(),
            candidates: other.candidates.iter().map(|c| follow(&start, c)).collect(),
            inputs,
            start,
            impact: Vec::new(),
            holds: Vec::new(),
            impulses: Vec::new(),
            moves: other.moves,
        };
        stage.write_rows(state, Some(&other.impact));
        stage
    }

    /// Rows and warm-start impulses for the candidates, the constrained points, the stops and springs of driven bodies and
    /// the contacts' resistances, in this order.
    fn write_rows(&mut self, state: &State, told: Option<&[bool]>) {
        let carried = history::transfer(&state.contacts, self.candidates.iter().map(|c| c.key));
        self.problem.rows.clear();
        self.impact.clear();
        for (k, (candidate, carried)) in self.candidates.iter().zip(&carried).enumerate() {
            let (free, told) = (&self.problem.free, told.map(|told| told[k]));
            let (row, impact) = self.inputs.contact(free, candidate, carried.force, told);
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
        self.impulses = carried
            .iter()
            .map(|carried| carried.force)
            .chain(springs_held)
            .map(|f| f * step)
            .collect();
        for (rank, body) in self.inputs.bodies.iter().enumerate() {
            for hold in body.holds() {
                let (row, impact) = self.inputs.hold(&self.problem.free, rank, &hold);
                self.problem.rows.push(row);
                self.impulses.push(hold.direction * (hold.force * step));
                self.holds.push(Held { hold, impact });
            }
        }
        if self.inputs.scene.pairs.resists() {
            for (k, carried) in carried.iter().enumerate() {
                self.resist(k, carried.torque);
            }
        }
    }

    /// Adds the resistance of contact `k`, if it has one, with its last couple.
    fn resist(&mut self, k: usize, torque: Vec3) {
        let row = &self.problem.rows[k];
        let key = self.candidates[k].key;
        if let Some(resistance) = self.inputs.resistance(key, row, k, torque) {
            let lever = resistance.radius;
            self.problem.rows.push(resistance);
            self.impulses.push(torque * (self.inputs.step / lever));
        }
    }

    /// The contact that row `k` is, or whose resistance it is.
    pub(super) fn contact_of(&self, k: usize) -> Option<usize> {
        match self.problem.rows.get(k)?.law {
            Law::Resistance { contact, .. } => Some(contact as usize),
            _ => (k < self.candidates.len()).then_some(k),
        }
    }

    /// Whether row `k` belongs to an impact.
    pub(super) fn is_impact(&self, k: usize) -> bool {
        match self.contact_of(k) {
            Some(contact) => self.impact[contact],
            None => self.held(k).is_some_and(|held| held.impact),
        }
    }

    /// Row of the first stop or spring of a driven body.
    pub(super) fn first_hold(&self) -> usize {
        self.candidates.len() + self.inputs.targets.len()
    }

    /// The stop or spring that row `k` is.
    pub(super) fn held(&self, k: usize) -> Option<&Held> {
        self.holds.get(k.checked_sub(self.first_hold())?)
    }

    /// Solves the problem as it stands.
    pub(super) fn solve(&mut self, state: &State, scratch: &mut Scratch) -> Report {
        let params = self.params(state);
        let workspace = &mut scratch.workspace;
        solve(&self.problem, &params, workspace, &mut self.impulses)
    }

    /// Brings forces that are solved already to the residual `force` as far as Gauss-Seidel gets.
    pub(super) fn polish(&mut self, state: &State, scratch: &mut Scratch, force: f64) {
        let mut params = self.params(state);
        params.kind = SolverKind::GaussSeidel;
        params.tolerance.force = params.tolerance.force.min(force);
        let before = self.impulses.clone();
        let scales = Scale::of(&self.problem);
        let coarse = evaluate(&self.problem, &scales, &before).force;
        let workspace = &mut scratch.workspace;
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
            max_sweeps: settings.max_iterations,
            max_factorizations: settings.max_iterations.div_ceil(20),
            // Contact springs carry the penalty themselves: nothing is left to augment.
            penalty: if penalty_method {
                f64::INFINITY
            } else {
                state.penalty
            },
            adapt_penalty: settings.adapt_penalty && !penalty_method,
            // A penalty held by the scene asks for the paper's loop and nothing else.
            smoothing: if settings.adapt_penalty { SMOOTHING } else { 0 },
        }
    }

    /// Solves until the true geometry agrees: gaps are re-linearised, late contacts join.
    pub(super) fn resolve(
        &mut self,
        state: &State,
        scratch: &mut Scratch,
        twins: &mut [Twin<'_>],
    ) -> Result<(Vec<Dof6>, StepOutcome), StepFailure> {
        let mut total = Report::default();
        for _ in 0..PASSES {
            total = total.then(self.solve(state, scratch));
            if !total.converged {
                return Err(self.failure(&total));
            }
            beside::follow(self, twins).map_err(|broken| self.broken(&total, broken))?;
            let solution = self.problem.velocities(&self.impulses);
            let position = self.moved(&solution);
            let ends = self.end_poses(&solution);
            let end = Placement {
                position: &position,
                poses: &ends,
                ..self.start
            };
            scratch.neighbors.ensure(&end, 0.0);
            let closed = end.candidates(&scratch.neighbors, |_, _| 0.0, |_, _| 0.0);
            let max_overlap = closed
                .iter()
                .map(|c| -c.gap / end.scale(c.key))
                .fold(0.0, f64::max);
            // The penalty method lets bodies overlap as they like.
            let alm = self.inputs.scene.settings.method == Method::Alm;
            let swept = alm && self.moves;
            if swept && let Some(passed) = self.struck(&end, &closed) {
                return Err(self.too_fast(&total, passed));
            }
            if alm && self.correct(&end, &closed, (&solution, state), twins) {
                continue;
            }
            if swept && let Some(passed) = self.passed(&solution, &ends, scratch) {
                return Err(self.too_fast(&total, passed));
            }
            let outcome = StepOutcome {
                solver: total,
                max_overlap,
                kink: self.kink(&solution),
            };
            return Ok((solution, outcome));
        }
        Err(StepFailure {
            what: "gap",
            residual: f64::NAN,
            tolerance: self.inputs.scene.settings.tolerance.gap,
            contact: None,
            // Forces without bound satisfy a pinch on paper: then only the geometry refuses it.
            pinched: (0..self.candidates.len()).find_map(|row| self.pinch(row)),
            passed: None,
            broken: None,
        })
    }

    /// Compares the linear gaps with the true ones at the end of the step. Re-linearises those that are off
    /// (the gap only: normals and arms keep the start of the step, as in SHAKE) and adds contacts that closed
    /// without being candidates. Returns whether anything changed.
    fn correct(
        &mut self,
        end: &Placement,
        closed: &[Candidate],
        (solution, state): (&[Dof6], &State),
        twins: &mut [Twin<'_>],
    ) -> bool {
        let settings = &self.inputs.scene.settings;
        let tolerance = settings.tolerance.gap;
        let loaded = |k: usize| self.impulses[k] != Vec3::zeros();
        let wall = |k: usize| matches!(self.candidates[k].key.partner, Partner::Boundary { .. });
        // Two spheres without load that overlap are among the closed ones below.
        let mut off = (0..self.candidates.len()).any(|k| {
            (loaded(k) || wall(k)) && {
                let (gap, radius) = (self.true_gap(end, k), self.problem.rows[k].radius);
                let opens = loaded(k) && !self.impact[k] && gap > OPENING * radius;
                gap < -tolerance * radius || opens
            }
        });
        let mut late: Vec<Candidate> = Vec::new();
        for found in closed {
            if found.gap < -tolerance * end.scale(found.key) {
                match self
                    .candidates
                    .binary_search_by_key(&found.key, |known| known.key)
                {
                    Ok(k) => off |= !loaded(k),
                    Err(_) => late.push(*found),
                }
            }
        }
        if !off && late.is_empty() {
            return false;
        }
        // A rebound yields only to an overlap.
        let yields: Vec<bool> = (0..self.candidates.len())
            .map(|k| {
                !self.impact[k] || self.true_gap(end, k) < -tolerance * self.problem.rows[k].radius
            })
            .collect();
        self.relinearise(end, solution, &yields);
        let told: Vec<bool> = late
            .iter()
            .map(|found| self.insert(*found, (solution, state), None))
            .collect();
        for stage in twins.iter_mut().flat_map(|twin| &mut twin.stages) {
            let solution = stage.problem.velocities(&stage.impulses);
            let (position, poses) = (stage.moved(&solution), stage.end_poses(&solution));
            let end = Placement {
                position: &position,
                poses: &poses,
                ..stage.start
            };
            let late: Vec<Candidate> = late.iter().map(|found| follow(&end, found)).collect();
            stage.relinearise(&end, &solution, &yields);
            for (found, told) in late.into_iter().zip(&told) {
                stage.insert(found, (&solution, state), Some(*told));
            }
        }
        true
    }

    /// Lets the gaps of the contacts that yield be the true ones at `end`, where `solution` leads.
    fn relinearise(&mut self, end: &Placement, solution: &[Dof6], yields: &[bool]) {
        let step = self.inputs.step;
        for k in (0..yields.len()).filter(|&k| yields[k]) {
            let gap = self.true_gap(end, k);
            let row = &mut self.problem.rows[k];
            let n = row.normal;
            let linear = step * n.dot(&row.relative_velocity(solution));
            let compression = self.impulses[k].dot(&n) * row.compliance_n * step;
            let wanted = (gap - compression - linear) / step;
            let now = row.bias.dot(&n);
            row.bias += match self.impact[k] {
                true => n * (wanted.min(now) - now),
                false => n * (wanted - now),
            };
        }
    }

    /// Gap \[m\] of contact `k` at `end`, without the compression of a contact spring, which is not an overlap.
    fn true_gap(&self, end: &Placement, k: usize) -> f64 {
        let row = &self.problem.rows[k];
        let compression = self.impulses[k].dot(&row.normal) * row.compliance_n * self.inputs.step;
        end.follow(&self.candidates[k]).gap + compression
    }

    /// Adds a contact that `solution` closes: its normal is the one it closes with. Returns whether it is an impact, as
    /// `told` or as it is found.
    fn insert(
        &mut self,
        found: Candidate,
        (solution, state): (&[Dof6], &State),
        told: Option<bool>,
    ) -> bool {
        let carried = history::transfer(&state.contacts, std::iter::once(found.key))[0];
        let (mut row, impact) =
            self.inputs
                .contact(&self.problem.free, &found, carried.force, told);
        let linear = self.inputs.step * found.normal.dot(&row.relative_velocity(solution));
        row.bias +=
            row.normal * ((found.gap - linear) / self.inputs.step - row.bias.dot(&row.normal));
        let at = self.candidates.partition_point(|c| c.key < found.key);
        self.candidates.insert(at, found);
        self.problem.rows.insert(at, row);
        self.impact.insert(at, impact);
        self.impulses.insert(at, Vec3::zeros());
        for row in &mut self.problem.rows {
            if let Law::Resistance { contact, .. } = &mut row.law {
                *contact += u32::from(*contact as usize >= at);
            }
        }
        self.resist(at, carried.torque);
        impact
    }

    /// Boundary poses at the end of the step, `[B]`: prescribed ones, and those that the driven bodies reach.
    pub(super) fn end_poses(&self, solution: &[Dof6]) -> Vec<Pose> {
        let [start, end] = self.inputs.poses;
        let mut ends = end.to_vec();
        let bodies = &solution[self.inputs.kinematics.len()..];
        for (body, velocity) in self.inputs.bodies.iter().zip(bodies) {
            let b = body.boundary;
            ends[b] = body.moved(&start[b], velocity, self.inputs.step);
        }
        ends
    }

    pub(super) fn moved(&self, solution: &[Dof6]) -> Vec<Vec3> {
        let start = self.inputs.kinematics.position.iter();
        start
            .zip(solution)
            .map(|(x, v)| x + v.linear * self.inputs.step)
            .collect()
    }

    fn too_fast(&self, report: &Report, passed: Passed) -> StepFailure {
        StepFailure {
            passed: Some(passed),
            ..self.failure(report)
        }
    }

    pub(super) fn broken(&self, report: &Report, broken: LinearError) -> StepFailure {
        StepFailure {
            broken: Some(Box::new(broken)),
            ..self.failure(report)
        }
    }

    pub(super) fn failure(&self, report: &Report) -> StepFailure {
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
            contact: self.contact_of(row).map(|k| self.candidates[k].key),
            pinched: report
                .residual
                .worst
                .iter()
                .find_map(|&row| self.pinch(row)),
            passed: None,
            broken: report.broken.map(Box::new),
        }
    }

    /// Whether the sphere of contact `row` carries load from two rigid boundaries on opposite sides.
    fn pinch(&self, row: usize) -> Option<(usize, [u16; 2])> {
        let sphere = self.candidates.get(row)?.key.sphere;
        let walls: Vec<(u16, Vec3)> = (0..self.candidates.len())
            .filter(|&k| self.candidates[k].key.sphere == sphere)
            .filter(|&k| self.problem.rows[k].compliance_n == 0.0)
            .filter(|&k| self.impulses[k] != Vec3::zeros())
            .filter_map(|k| match self.candidates[k].key.partner {
                Partner::Boundary { boundary, .. } => {
                    // A driven body gives way.
                    let rigid = self.inputs.body(usize::from(boundary)).is_none();
                    rigid.then_some((boundary, self.candidates[k].normal))
                }
                Partner::Sphere { .. } => None,
            })
            .collect();
        walls.iter().enumerate().find_map(|(k, (a, n))| {
            let opposite = walls[k + 1..].iter().find(|(_, m)| n.dot(m) < -0.5)?;
            Some((sphere as usize, [*a, opposite.0]))
        })
    }
}

/// The pair of `candidate` at another placement; where that has no such feature, as it was.
fn follow(at: &Placement, candidate: &Candidate) -> Candidate {
    let found = at.follow(candidate);
    match found.gap.is_finite() {
        true => found,
        false => *candidate,
    }
}
