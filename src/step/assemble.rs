//! Third stage of a step: the rows of its problem, who they are, and the impulses that the solve starts from.

use std::collections::LinkedList;
use std::ops::Range;

use super::prediction::Prediction;
use super::rows::elastic::ElasticContact;
use super::rows::joint::JointConstraint;
use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::history::{self, HistoryIndex};
use crate::contact::{ContactId, Partner};
use crate::detection::configuration::{Candidate, Configuration};
use crate::memory;
use crate::parallel::{Pieces, chained};
use crate::problem::{Law, Problem, Row, RowWriter};
use crate::state::State;

/// Arrays of an [`Assembly`], kept for their memory alone.
#[derive(Debug, Default)]
pub(super) struct AssemblyArrays {
    pub(super) problem: Problem,
    pub(super) candidates: Vec<Candidate>,
    pub(super) late: Vec<ContactId>,
    pub(super) impact: Vec<bool>,
    pub(super) past: Vec<HistoryIndex>,
    pub(super) elastic: Vec<Option<ElasticContact>>,
    pub(super) joints: Vec<JointConstraint>,
    pub(super) attraction: Vec<f64>,
    pub(super) holds: Vec<Hold>,
}

/// The problem of a step and who its rows are: candidates, then constrained points, stops and springs of joints, resistances.
pub(super) struct Assembly<'a> {
    pub(super) prediction: &'a Prediction<'a>,
    pub(super) problem: Problem,
    pub(super) candidates: Vec<Candidate>,
    /// Those that joined as the solution closed them, with the gap at the end of the step, ascending.
    pub(super) late: Vec<ContactId>,
    /// Of the candidates, whether they are impacts.
    pub(super) impact: Vec<bool>,
    /// Bodies that boundaries wedge, ascending: they do not rebound from them.
    pub(super) wedged: Vec<u32>,
    /// Which contacts of the last step the candidates continue.
    pub(super) past: Vec<HistoryIndex>,
    /// How they give way; empty where none does.
    pub(super) elastic: Vec<Option<ElasticContact>>,
    /// Stops and springs of the driven bodies.
    pub(super) joints: Vec<JointConstraint>,
    /// Attraction \[N\] of the candidates; empty where none holds.
    pub(super) attraction: Vec<f64>,
    /// What holds the candidates together, in the step and then after it; empty likewise.
    pub(super) holds: Vec<Hold>,
    /// Bonds that the step breaks.
    pub(super) broken_bonds: u64,
    /// Whether bodies move through the step; a displacement that removes overlaps has no path.
    pub(super) moves: bool,
}

/// Of pieces of the contacts: their past, whether they are impacts, and their impulses.
type Others<'a> = (&'a mut [HistoryIndex], (&'a mut [bool], &'a mut [Vec3]));

/// Writes rows and warm-start impulses for the candidates in `arrays`, whose problem has bodies and any rows. Candidates
/// are impacts as they are found, or as in `impact`. Forces of the last step are those of `state`.
pub(super) fn assemble<'a>(
    prediction: &'a Prediction<'a>,
    arrays: AssemblyArrays,
    state: &State,
    impact: Option<&[bool]>,
    impulses: &mut Vec<Vec3>,
) -> Assembly<'a> {
    let mut assembly = Assembly {
        prediction,
        problem: arrays.problem,
        candidates: arrays.candidates,
        late: arrays.late,
        impact: arrays.impact,
        wedged: Vec::new(),
        past: arrays.past,
        elastic: arrays.elastic,
        joints: arrays.joints,
        attraction: arrays.attraction,
        holds: arrays.holds,
        broken_bonds: 0,
        moves: true,
    };
    assembly.late.clear();
    let coheres = prediction.scene.pairs.coheres();
    let rigid = !prediction.gives_way && prediction.clumps.is_empty();
    match (rigid, coheres) {
        (true, true) => assembly.write_contacts::<false>(state, impact, impulses),
        (true, false) => assembly.write_contacts::<true>(state, impact, impulses),
        (false, true) => assembly.write_whole::<false>(state, impact, impulses),
        (false, false) => assembly.write_whole::<true>(state, impact, impulses),
    }
    assembly.hold_wedged();
    assembly.attract(&state.contacts, impulses);
    let springs = 0..prediction.targets.len();
    let forces = state.springs.iter().take(springs.len());
    impulses.extend(forces.map(|f| f * prediction.step));
    let rows = &mut assembly.problem.rows;
    rows.extend(springs.map(|s| prediction.spring(s)));
    assembly.joints.clear();
    // Of all spheres: only bodies ask for it.
    let largest = match prediction.bodies.is_empty() {
        true => 0.0,
        false => prediction.scene.particles.largest_radius(),
    };
    for (rank, body) in prediction.bodies.iter().enumerate() {
        for limit in body.joint_limits() {
            let free = &assembly.problem.free;
            let (row, impact) = prediction.limit(free, (rank, &limit), largest);
            assembly.problem.rows.push(row);
            impulses.push(limit.direction * (limit.force * prediction.step));
            assembly.joints.push(JointConstraint { limit, impact });
        }
    }
    if prediction.scene.pairs.resists() {
        for k in 0..assembly.candidates.len() {
            assembly.resist(state, k, impulses);
        }
    }
    assembly
}

impl Assembly<'_> {
    /// Rows of the candidates, which are rigid and of single spheres; `LOOSE` says that none coheres.
    fn write_contacts<const LOOSE: bool>(
        &mut self,
        state: &State,
        known_impact: Option<&[bool]>,
        impulses: &mut Vec<Vec3>,
    ) {
        let (prediction, contacts) = (self.prediction, &state.contacts);
        let candidates = &self.candidates[..];
        let Problem { free, rows, .. } = &mut self.problem;
        let count = candidates.len();
        let rewritten = rows.rewrite(&prediction.scene.particles.radius, count);
        self.elastic.clear();
        memory::resize(&mut self.past, count, HistoryIndex::NONE);
        memory::resize(&mut self.impact, count, false);
        memory::resize(impulses, count, Vec3::zeros());
        let known_impact = |k: usize| known_impact.map(|known| known[k]);
        let write = |first: usize, (mut rows, others): (RowWriter, Others)| {
            let (past, (impact, impulses)) = others;
            let keys = candidates[first..].iter().map(|candidate| candidate.key);
            let transferred = history::transfer(contacts, keys);
            let (mut whole, count) = (Vec::new(), rows.count());
            let is_candidate = |key| known(candidates, key);
            for (k, (past, transferred)) in past.iter_mut().zip(transferred).enumerate() {
                let candidate = &candidates[first + k];
                *past = match LOOSE {
                    true => transferred,
                    false => history::succeed(contacts, transferred, candidate.key, is_candidate),
                };
                let carried = past.carried(contacts);
                let (force, known) = (carried.force, known_impact(first + k));
                let contact = prediction.row_of::<LOOSE, true>(free, candidate, carried, known);
                rows.write(k, &contact.row, contact.is_of_spheres);
                impact[k] = contact.impact;
                impulses[k] = force * prediction.step;
                if !contact.is_of_spheres {
                    if whole.is_empty() {
                        whole.reserve(count - k);
                    }
                    whole.push(contact.row);
                }
            }
            match whole.is_empty() {
                true => LinkedList::new(),
                false => LinkedList::from([whole]),
            }
        };
        let others = (&mut self.impact[..], &mut impulses[..]);
        let all = (rewritten, (&mut self.past[..], others));
        let whole = prediction.pool.pieces(all, write, chained);
        if !whole.is_empty() {
            rows.settle(whole.into_iter().flatten());
        }
    }

    /// Likewise where contacts give way or are of clumps: nearly all rows are kept whole, so each is made once.
    fn write_whole<const LOOSE: bool>(
        &mut self,
        state: &State,
        known_impact: Option<&[bool]>,
        impulses: &mut Vec<Vec3>,
    ) {
        let (prediction, contacts) = (self.prediction, &state.contacts);
        let Problem { free, rows, .. } = &mut self.problem;
        rows.restart(&prediction.scene.particles.radius);
        self.impact.clear();
        self.elastic.clear();
        self.past.clear();
        let keys = self.candidates.iter().map(|candidate| candidate.key);
        self.past.extend(history::transfer(contacts, keys));
        if !LOOSE {
            let is_candidate = |key| known(&self.candidates, key);
            for (past, candidate) in self.past.iter_mut().zip(&self.candidates) {
                *past = history::succeed(contacts, *past, candidate.key, is_candidate);
            }
        }
        impulses.clear();
        for (k, (candidate, past)) in self.candidates.iter().zip(&self.past).enumerate() {
            let (carried, known) = (past.carried(contacts), known_impact.map(|known| known[k]));
            let contact = prediction.row_of::<LOOSE, false>(free, candidate, carried, known);
            rows.push(contact.row);
            impulses.push(carried.force * prediction.step);
            self.impact.push(contact.impact);
            if prediction.gives_way {
                self.elastic.push(contact.elastic);
            }
        }
    }

    /// Adds the resistance of contact `k`, if it has one, with its last couple.
    pub(super) fn resist(&mut self, state: &State, k: usize, impulses: &mut Vec<Vec3>) {
        let torque = self.past[k].torque(&state.contacts);
        let candidate = &self.candidates[k];
        let hold = self.past[k].hold(&state.contacts);
        let hold = self.prediction.hold(candidate, hold);
        let contact = (candidate.key, hold);
        let bond = self.elastic(k).filter(|elastic| elastic.bond().is_some());
        let torque = match bond {
            Some(_) => self.past[k].turned_torque(&state.contacts, candidate.normal),
            None => torque,
        };
        let of = |row: &Row| self.prediction.resistance(contact, row, k, torque);
        if let Some(mut resistance) = self.problem.rows.with(k, of) {
            self.prediction.spring_couple(bond, torque, &mut resistance);
            let lever = resistance.radius;
            self.problem.rows.push(resistance);
            impulses.push(torque * (self.prediction.step / lever));
        }
    }

    /// Its arrays, for the next step.
    pub(super) fn into_arrays(mut self) -> AssemblyArrays {
        if !self.prediction.asleep.is_empty() {
            self.problem.inverse_mass.clear();
        }
        AssemblyArrays {
            problem: self.problem,
            candidates: self.candidates,
            late: self.late,
            impact: self.impact,
            past: self.past,
            elastic: self.elastic,
            joints: self.joints,
            attraction: self.attraction,
            holds: self.holds,
        }
    }

    /// Where everything is at the start of the step.
    pub(super) fn start(&self) -> Configuration<'_> {
        let prediction = self.prediction;
        Configuration::of(
            prediction.scene,
            &prediction.kinematics,
            &prediction.poses[0],
        )
    }

    /// Gap \[m\] of candidate `k` at the start of the step.
    pub(super) fn start_gap(&self, k: usize) -> f64 {
        let candidate = &self.candidates[k];
        match self.late.binary_search(&candidate.key) {
            Ok(_) => self.start().gap(candidate),
            Err(_) => candidate.gap,
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
        self.candidates.len() + self.prediction.targets.len()
    }

    /// The stop or spring that row `k` is.
    pub(super) fn joint(&self, k: usize) -> Option<&JointConstraint> {
        self.joints.get(k.checked_sub(self.first_joint())?)
    }

    /// The driven body that row `k` has as its body B.
    pub(super) fn driven_side(&self, k: usize) -> Option<usize> {
        let [_, b] = self.problem.rows.bodies(k);
        let (spheres, driven) = (
            self.prediction.kinematics.len(),
            self.prediction.bodies.len(),
        );
        (spheres..spheres + driven)
            .contains(&(b as usize))
            .then_some(b as usize)
    }

    /// How candidate `k` gives way, if it does.
    pub(super) fn elastic(&self, k: usize) -> Option<&ElasticContact> {
        self.elastic.get(k)?.as_ref()
    }

    /// Likewise where a step does not resolve it and no impact is rigid: its gap follows its force.
    pub(super) fn compressed(&self, k: usize) -> Option<&ElasticContact> {
        self.elastic(k)
            .filter(|elastic| !elastic.is_resolved() && self.problem.rows.compliance(k) > 0.0)
    }

    /// Gap \[m\] that the bond of candidate `k` keeps; zero without one.
    pub(super) fn rest(&self, k: usize) -> f64 {
        self.holds.get(k).map_or(0.0, Hold::rest)
    }

    /// Whether candidate `k` is a contact with a boundary.
    pub(super) fn is_with_boundary(&self, k: usize) -> bool {
        matches!(self.candidates[k].key.partner, Partner::Boundary { .. })
    }

    /// The candidates of this sphere and partner, by whatever feature.
    pub(super) fn contacts_between(
        &self,
        sphere: u32,
        partner: Partner,
    ) -> impl Iterator<Item = usize> {
        let same = move |key: ContactId| match (key.partner, partner) {
            (Partner::Boundary { boundary: a, .. }, Partner::Boundary { boundary: b, .. }) => {
                a == b
            }
            (a, b) => a == b,
        };
        self.contacts_of(sphere)
            .filter(move |&k| same(self.candidates[k].key))
    }

    /// The candidates of this sphere, whose partners come after it.
    pub(super) fn contacts_of(&self, sphere: u32) -> Range<usize> {
        let own = |c: &Candidate| c.key.sphere;
        let from = self.candidates.partition_point(|c| own(c) < sphere);
        let count = self.candidates[from..].partition_point(|c| own(c) == sphere);
        from..from + count
    }
}

/// Whether a contact is among candidates.
fn known(candidates: &[Candidate], key: ContactId) -> bool {
    let found = candidates.binary_search_by_key(&key, |candidate| candidate.key);
    found.is_ok()
}

/// The pair of `candidate` at another configuration; where that has no such feature, as it was.
pub(super) fn follow(at: &Configuration, candidate: &Candidate) -> Candidate {
    let found = at.follow(candidate);
    match found.gap.is_finite() {
        true => found,
        false => *candidate,
    }
}
