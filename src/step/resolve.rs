//! The solve that repeats until the true geometry agrees: gaps are re-linearised, late contacts join.

use std::mem::take;
use std::ops::Range;

use super::assembly::{Assembly, follow};
use super::replicas::{self, ReplicaPair};
use super::workspace::Workspace;
use super::{Effort, StepFailure, StepOutput, Tunnelling};
use crate::Vec3;
use crate::contact::{Partner, history};
use crate::detection::configuration::{Candidate, Configuration};
use crate::scene::Method;
use crate::solver::Report;
use crate::spatial::SpatialVector;
use crate::state::State;

/// Passes of re-linearisation and late contacts before the step is cut.
const PASSES: usize = 30;
/// A loaded contact may leave its linearised surface by this share of the radius before its gap is
/// re-linearised; overlaps are joint to the tolerance whatever this is.
const OPENING: f64 = 1e-3;
/// Weights that press a squeezed sphere into a boundary by its radius: a thousand by a hundredth of it.
const WEIGHTS: f64 = 1e5;

impl Assembly<'_> {
    /// Solves until the true geometry agrees: gaps are re-linearised, late contacts join.
    pub(super) fn resolve(
        &mut self,
        (state, effort): (&State, Effort),
        workspace: &mut Workspace,
        replicas: &mut [ReplicaPair<'_>],
    ) -> Result<StepOutput, StepFailure> {
        let mut total = Report::default();
        let budget = self.inputs.scene.settings.sweeps.filter(|_| self.moves);
        let sweep_limit = effort.sweeps.filter(|_| self.moves);
        // What gives way overlaps by more than the tolerance, though its problem is solved.
        let mut gives_way = effort.accept && self.soften_pinched();
        let mut reached = 0.0;
        for _ in 0..PASSES {
            let left = budget.map(|budget| budget - total.sweeps);
            total = total.then(self.solve((state, effort), workspace, left.or(sweep_limit)));
            if !total.converged && effort.accept && self.soften_pinched() {
                gives_way = true;
                total = total.then(self.solve((state, effort), workspace, left.or(sweep_limit)));
            }
            let spent = budget.is_some_and(|budget| total.sweeps >= budget);
            let as_it_is = spent || (effort.accept && !total.converged);
            if !total.converged && !as_it_is {
                return Err(self.failure(&total));
            }
            replicas::follow(self, replicas).map_err(|broken| self.broken(&total, broken))?;
            let checked = self.check(state, workspace, replicas, (as_it_is, effort.pass));
            let (overlap, agrees) = checked.map_err(|passed| self.too_fast(&total, passed))?;
            if agrees {
                return Ok(StepOutput {
                    unconverged: !total.converged || gives_way,
                    ..StepOutput::of(total, overlap)
                });
            }
            reached = overlap;
        }
        if effort.accept {
            return Ok(StepOutput {
                unconverged: true,
                ..StepOutput::of(total, reached)
            });
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

    /// Lets the contacts with boundaries of spheres that two rigid ones squeeze give way, so that there is an answer: `k` such
    /// that [`WEIGHTS`] weights press a sphere in by a radius. Returns whether there are new ones.
    fn soften_pinched(&mut self) -> bool {
        let mut squeezed: Vec<u32> = (0..self.candidates.len())
            .filter_map(|row| self.pinch(row))
            .map(|(sphere, _)| sphere as u32)
            .collect();
        squeezed.dedup();
        let scene = self.inputs.scene;
        for k in 0..self.candidates.len() {
            let key = self.candidates[k].key;
            let of_boundary = matches!(key.partner, Partner::Boundary { .. });
            if of_boundary && squeezed.contains(&key.sphere) {
                let i = key.sphere as usize;
                let weight = scene.particles.mass[i] * self.inputs.gravity_size.max(1.0);
                let stiffness = WEIGHTS * weight / scene.particles.radius[i];
                let compliance = 1.0 / (stiffness * self.inputs.step * self.inputs.step);
                self.problem
                    .rows
                    .update(k, |row| row.compliance_n = compliance);
            }
        }
        !squeezed.is_empty()
    }

    /// Holds the impulses against the true geometry at the end of the step: the largest overlap over radius there, and whether
    /// the problem could stay as it is. If they are to be taken `as_it_is` it does, and bodies may `pass` if they may.
    ///
    /// # Errors
    /// Bodies that pass through each other.
    fn check(
        &mut self,
        state: &State,
        workspace: &mut Workspace,
        replicas: &mut [ReplicaPair<'_>],
        (as_it_is, pass): (bool, bool),
    ) -> Result<(f64, bool), Tunnelling> {
        let solution = take(&mut self.solution);
        let mut position = take(&mut self.position);
        let mut closed = take(&mut self.closed);
        self.lead(&solution, &mut position);
        let ends = self.end_poses(&solution);
        let end = Configuration {
            position: &position,
            poses: &ends,
            ..self.start
        };
        workspace.neighbors.ensure(&end, &[], 0.0);
        let limit = self.inputs.scene.settings.tolerance.gap;
        let max_overlap = end.overlaps(&workspace.neighbors, limit, &self.pool, &mut closed);
        // The penalty method lets bodies overlap as they like.
        let alm = self.inputs.scene.settings.method == Method::Alm;
        let swept = alm && self.moves && !pass;
        let struck = if swept {
            self.struck(&end, &closed)
        } else {
            None
        };
        let verdict = if let Some(passed) = struck {
            Err(passed)
        } else if alm && !as_it_is && self.correct(&end, &closed, (&solution, state), replicas) {
            Ok((max_overlap, false))
        } else if swept && let Some(passed) = self.passed(&solution, &ends, workspace) {
            Err(passed)
        } else {
            Ok((max_overlap, true))
        };
        (self.solution, self.position, self.closed) = (solution, position, closed);
        verdict
    }

    /// Compares the linear gaps with the true ones at the end of the step. Re-linearises those that are off
    /// (the gap only: normals and arms keep the start of the step, as in SHAKE) and adds contacts that closed
    /// without being candidates. Returns whether anything changed.
    fn correct(
        &mut self,
        end: &Configuration,
        closed: &[Candidate],
        (solution, state): (&[SpatialVector], &State),
        replicas: &mut [ReplicaPair<'_>],
    ) -> bool {
        let settings = &self.inputs.scene.settings;
        let tolerance = settings.tolerance.gap;
        let opening = OPENING.max(3.0 * settings.opening);
        let loaded = |k: usize| self.impulses[k] != Vec3::zeros();
        let of_boundary =
            |k: usize| matches!(self.candidates[k].key.partner, Partner::Boundary { .. });
        // Two spheres without load that overlap are among the closed ones below.
        let is_off = |k: usize| {
            (loaded(k) || of_boundary(k)) && {
                let (gap, radius) = (self.true_gap(end, k), self.problem.rows.radius(k));
                let opens = loaded(k) && !self.impact[k] && gap > opening * radius;
                gap < -tolerance * radius || opens
            }
        };
        let any = |_, range: Range<usize>| range.into_iter().any(is_off);
        let all = 0..self.candidates.len();
        let mut off = self.pool.pieces(all, any, |a, b| a | b);
        let mut late: Vec<Candidate> = Vec::new();
        for found in closed {
            match self
                .candidates
                .binary_search_by_key(&found.key, |known| known.key)
            {
                Ok(k) => off |= !loaded(k),
                Err(_) => late.push(*found),
            }
        }
        if !off && late.is_empty() {
            return false;
        }
        // A rebound yields only to an overlap.
        let yields: Vec<bool> = (0..self.candidates.len())
            .map(|k| {
                !self.impact[k] || self.true_gap(end, k) < -tolerance * self.problem.rows.radius(k)
            })
            .collect();
        self.relinearise(end, solution, &yields);
        let known_impact: Vec<bool> = late
            .iter()
            .map(|found| self.insert(*found, (solution, state), None))
            .collect();
        for stage in replicas.iter_mut().flat_map(|pair| &mut pair.stages) {
            let solution = stage.problem.velocities(&stage.impulses);
            let (position, poses) = (stage.moved(&solution), stage.end_poses(&solution));
            let end = Configuration {
                position: &position,
                poses: &poses,
                ..stage.start
            };
            let late: Vec<Candidate> = late.iter().map(|found| follow(&end, found)).collect();
            stage.relinearise(&end, &solution, &yields);
            for (found, known_impact) in late.into_iter().zip(&known_impact) {
                stage.insert(found, (&solution, state), Some(*known_impact));
            }
        }
        true
    }

    /// Lets the gaps of the contacts that yield be the true ones at `end`, where `solution` leads.
    fn relinearise(&mut self, end: &Configuration, solution: &[SpatialVector], yields: &[bool]) {
        let (step, settings) = (self.inputs.step, &self.inputs.scene.settings);
        for k in (0..yields.len()).filter(|&k| yields[k]) {
            let gap = self.true_gap(end, k);
            let row = self.problem.rows.get(k);
            let n = row.normal;
            let linear = step * n.dot(&row.relative_velocity(solution));
            let compression = self.impulses[k].dot(&n) * row.compliance_n * step;
            let carried = settings.carried(self.candidates[k].gap, row.radius);
            let wanted = (gap - carried - compression - linear) / step;
            let now = row.bias.dot(&n);
            let wanted = match self.impact[k] {
                true => wanted.min(now),
                false => wanted,
            };
            self.problem.rows.shift(k, wanted - now);
        }
    }

    /// Gap \[m\] of contact `k` at `end`, without the compression of a contact spring, which is not an overlap.
    fn true_gap(&self, end: &Configuration, k: usize) -> f64 {
        let gap = end.gap(&self.candidates[k]);
        match self.problem.rows.compliance(k) {
            0.0 => gap,
            c => gap + self.impulses[k].dot(&self.problem.rows.normal(k)) * c * self.inputs.step,
        }
    }

    /// Adds a contact that `solution` closes: its normal is the one it closes with. Returns whether it is an impact, as
    /// `known_impact` or as it is found.
    fn insert(
        &mut self,
        found: Candidate,
        (solution, state): (&[SpatialVector], &State),
        known_impact: Option<bool>,
    ) -> bool {
        let past = history::find(&state.contacts, found.key);
        let (mut row, impact) = self.inputs.contact(
            &self.problem.free,
            &found,
            past.force(&state.contacts),
            known_impact,
        );
        let linear = self.inputs.step * found.normal.dot(&row.relative_velocity(solution));
        let carried = self.inputs.scene.settings.opening * row.radius;
        row.bias += row.normal
            * ((found.gap - carried - linear) / self.inputs.step - row.bias.dot(&row.normal));
        let at = self.candidates.partition_point(|c| c.key < found.key);
        self.candidates.insert(at, found);
        self.problem.rows.insert(at, row);
        self.impact.insert(at, impact);
        self.past.insert(at, past);
        self.impulses.insert(at, Vec3::zeros());
        self.problem
            .rows
            .bind(|contact| *contact += u32::from(*contact as usize >= at));
        self.resist(state, at);
        impact
    }
}
