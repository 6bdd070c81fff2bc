//! What the true geometry corrects in the problem of a step.

use std::mem::take;

use super::assemble::{Assembly, follow};
use super::rows::contact::ContactRow;
use super::solution::Solution;
use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::history;
use crate::detection::configuration::{Candidate, Configuration};
use crate::problem::Row;
use crate::sorting::insert_all;
use crate::state::State;

/// What is corrected in a problem: gaps as the true geometry has them, normals and arms keep the start of the step, as in SHAKE;
/// rebounds where they make energy or have no solution, bonds whose attraction does not hold what they carry.
#[derive(Default)]
pub(super) struct Correction {
    /// Of the candidates, whether their gap is re-linearised.
    pub(super) yields: Vec<bool>,
    /// Contacts that close without being candidates, with the normals that they close with.
    pub(super) late: Vec<Candidate>,
    /// Impacts that rebound with this share of Newton's law.
    pub(super) rebounds: Vec<(usize, f64)>,
    /// Impacts of contacts that give way, which are no longer rigid.
    pub(super) sprung: Vec<usize>,
    /// Bonds that attract with so much \[N\] from now on.
    pub(super) filled: Vec<(usize, f64)>,
}

/// Gap \[m\] of contact `k` at `end`, without the compression of a contact that gives way, which is not an overlap.
pub(super) fn true_gap(
    assembly: &Assembly,
    solution: &Solution,
    end: &Configuration,
    k: usize,
) -> f64 {
    error_of(assembly, solution, k, end.gap(&assembly.candidates[k]))
}

/// [`true_gap`] of contact `k` whose gap is `gap` \[m\].
pub(super) fn error_of(assembly: &Assembly, solution: &Solution, k: usize, gap: f64) -> f64 {
    let (rows, step) = (&assembly.problem.rows, assembly.prediction.step);
    let along = || solution.impulses[k].dot(&rows.normal(k));
    match (assembly.compressed(k), rows.compliance(k)) {
        (Some(elastic), _) => {
            let attraction = assembly.attraction.get(k).copied().unwrap_or(0.0);
            elastic.error(gap, along() / step, attraction)
        }
        (None, 0.0) => gap - assembly.rest(k),
        (None, c) => gap + along() * c * step,
    }
}

/// Overlap \[m\] that the step may leave of the one with which contact `k` begins.
pub(super) fn left_of(assembly: &Assembly, k: usize) -> f64 {
    let prediction = assembly.prediction;
    let (settings, radius) = (&prediction.scene.settings, assembly.problem.rows.radius(k));
    let start = match assembly.candidates[k].gap < 0.0 {
        true => assembly.start_gap(k) - assembly.rest(k),
        false => 0.0,
    };
    settings.left(start, radius, prediction.step)
}

impl Correction {
    /// Applies this to a problem at its `solution`; forces of the last step are those of `state`. Late contacts are impacts as
    /// found, which is returned, or as in `impact`.
    pub(super) fn apply(
        &self,
        assembly: &mut Assembly,
        solution: &mut Solution,
        state: &State,
        impact: Option<&[bool]>,
    ) -> Vec<bool> {
        let prediction = assembly.prediction;
        let mut position = take(&mut solution.position);
        prediction.end_positions(&solution.velocity, &mut position);
        let poses = prediction.end_poses(&solution.velocity);
        let end = Configuration {
            position: &position,
            poses: &poses,
            ..Configuration::of(
                prediction.scene,
                &prediction.kinematics,
                &prediction.poses[0],
            )
        };
        for &bond in &self.filled {
            assembly.attract_with(bond, &mut solution.impulses);
        }
        let late: Vec<Candidate> = match impact {
            None => self.late.clone(),
            Some(_) => self.late.iter().map(|found| follow(&end, found)).collect(),
        };
        relinearise(assembly, solution, &end, &self.yields);
        solution.position = position;
        let anew = |assembly: &Assembly, k: usize, impact| {
            let carried = assembly.past[k].carried(&state.contacts);
            let (free, found) = (&assembly.problem.free, &assembly.candidates[k]);
            prediction.contact_row(free, found, carried, Some(impact))
        };
        for &k in &self.sprung {
            let contact = anew(assembly, k, false);
            assembly.problem.rows.update(k, |row| *row = contact.row);
            assembly.elastic[k] = contact.elastic;
            assembly.impact[k] = false;
        }
        for &(k, share) in &self.rebounds {
            let newton = anew(assembly, k, true).row;
            let now = assembly.problem.rows.bias(k);
            let wanted = share * newton.bias.dot(&newton.normal);
            assembly.problem.rows.shift(k, wanted - now);
        }
        insert(assembly, solution, state, (&late, impact))
    }
}

/// Lets the gaps of the contacts that yield be the true ones at `end`, where the solution leads, and their springs have their tangents
/// there.
fn relinearise(assembly: &mut Assembly, solution: &Solution, end: &Configuration, yields: &[bool]) {
    let step = assembly.prediction.step;
    let mut shifts = vec![0.0; yields.len()];
    let (all, pool) = (&*assembly, &assembly.prediction.pool);
    let shift = |k: usize| match yields[k] && all.compressed(k).is_none() {
        true => bias_of(all, solution, end, k) - all.problem.rows.bias(k),
        false => 0.0,
    };
    pool.fill(&mut shifts[..], shift);
    for k in (0..yields.len()).filter(|&k| yields[k]) {
        if assembly.compressed(k).is_none() {
            assembly.problem.rows.shift(k, shifts[k]);
            continue;
        }
        let gap = end.gap(&assembly.candidates[k]);
        let linear = linear_change(assembly, solution, k);
        let force = solution.impulses[k].dot(&assembly.problem.rows.normal(k)) / step;
        if let Some(elastic) = &mut assembly.elastic[k] {
            elastic.follow(force, gap);
            let [bias, compliance] = elastic.along(gap - linear);
            assembly.weaken(k, gap);
            let rows = &mut assembly.problem.rows;
            rows.shift(k, bias - rows.bias(k));
            rows.set_compliance(k, compliance);
        }
    }
}

/// What the solution adds to the gap of contact `k` in the problem \[m\].
fn linear_change(assembly: &Assembly, solution: &Solution, k: usize) -> f64 {
    let rows = &assembly.problem.rows;
    let velocity = rows.relative(k, |i| solution.velocity[i]);
    assembly.prediction.step * rows.normal(k).dot(&velocity)
}

/// Bias \[m/s\] of contact `k`, which is not compressed, by its true gap at `end`.
fn bias_of(assembly: &Assembly, solution: &Solution, end: &Configuration, k: usize) -> f64 {
    let (step, settings) = (
        assembly.prediction.step,
        &assembly.prediction.scene.settings,
    );
    let rows = &assembly.problem.rows;
    let gap = true_gap(assembly, solution, end, k);
    let compression = match rows.compliance(k) {
        0.0 => 0.0,
        c => solution.impulses[k].dot(&rows.normal(k)) * c * step,
    };
    let start = assembly.candidates[k].gap - assembly.rest(k);
    let carried =
        settings.carried(start, rows.radius(k), assembly.prediction.opened) - left_of(assembly, k);
    let linear = linear_change(assembly, solution, k);
    let wanted = (gap - carried - compression - linear) / step;
    match assembly.impact[k] {
        true => wanted.min(rows.bias(k)),
        false => wanted,
    }
}

/// Adds contacts that the solution closes. Returns which are impacts: as in `known_impact` or as they are found.
fn insert(
    assembly: &mut Assembly,
    solution: &mut Solution,
    state: &State,
    (found, known_impact): (&[Candidate], Option<&[bool]>),
) -> Vec<bool> {
    let prediction = assembly.prediction;
    let mut order: Vec<usize> = (0..found.len()).collect();
    order.sort_unstable_by_key(|&k| found[k].key);
    let sorted = || order.iter().map(|&k| &found[k]);
    let known = |k: usize| known_impact.map(|known| known[k]);
    let contacts = order
        .iter()
        .map(|&k| late_contact((assembly, solution), state, &found[k], known(k)));
    let contacts: Vec<ContactRow> = contacts.collect();
    let all = &assembly.candidates;
    let places = sorted().map(|found| all.partition_point(|c| c.key < found.key));
    let places: Vec<usize> = places.collect();
    insert_all(
        &mut assembly.candidates,
        &places,
        sorted().copied().collect(),
    );
    let keys = sorted().map(|found| found.key);
    assembly.late.extend(keys.clone());
    assembly.late.sort_unstable();
    let rows: Vec<Row> = contacts.iter().map(|contact| contact.row).collect();
    assembly.problem.rows.insert_all(&places, &rows);
    let impact = contacts.iter().map(|contact| contact.impact).collect();
    insert_all(&mut assembly.impact, &places, impact);
    let past = keys
        .map(|key| history::find(&state.contacts, key))
        .collect();
    insert_all(&mut assembly.past, &places, past);
    let count = found.len();
    insert_all(&mut solution.impulses, &places, vec![Vec3::zeros(); count]);
    if !assembly.holds.is_empty() {
        insert_all(&mut assembly.holds, &places, vec![Hold::Loose; count]);
        insert_all(&mut assembly.attraction, &places, vec![0.0; count]);
    }
    if prediction.gives_way {
        let elastic = contacts.into_iter().map(|contact| contact.elastic);
        insert_all(&mut assembly.elastic, &places, elastic.collect());
    }
    let mut impacts = vec![false; count];
    for (rank, (&k, place)) in order.iter().zip(places).enumerate() {
        impacts[k] = assembly.impact[place + rank];
        assembly.resist(state, place + rank, &mut solution.impulses);
    }
    impacts
}

/// A contact that the solution closes: an impact if it is `known` to be one, or as it is found.
fn late_contact(
    (assembly, solution): (&Assembly, &Solution),
    state: &State,
    found: &Candidate,
    known: Option<bool>,
) -> ContactRow {
    let (prediction, free) = (assembly.prediction, &assembly.problem.free);
    let past_load = history::find(&state.contacts, found.key).carried(&state.contacts);
    let mut contact = prediction.contact_row(free, found, past_load, known);
    let (row, step) = (&mut contact.row, prediction.step);
    let linear = step * found.normal.dot(&row.relative_velocity(&solution.velocity));
    let carried = 2.0 * prediction.scene.settings.reserve() * row.radius;
    if row.compliance_n > 0.0 {
        let start = Candidate {
            gap: found.gap - linear,
            ..*found
        };
        return prediction.contact_row(free, &start, past_load, Some(contact.impact));
    }
    // It may be the next feature of a boundary that the sphere is in already.
    let start = assembly.start().gap(found);
    let left = prediction.scene.settings.left(start, row.radius, step);
    let wanted = (found.gap - carried + left - linear) / step;
    row.bias += row.normal * (wanted - row.bias.dot(&row.normal));
    contact
}
