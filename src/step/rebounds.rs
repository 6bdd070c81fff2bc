//! Newton's law of impact, limited where impacts at once would make energy.
//!
//! Newton's law lets an impact part with `e` times its own speed of approach. A single impact loses energy by that at any `e <= 1`.
//! Of several at once one may close a pair that parts, or that is at rest: no common mean velocity is left in which their work is
//! negative, and energy is made. Then all impacts that hang together rebound with `theta e` instead, with the largest
//! `0 <= theta <= 1` at which the work of their rows,
//!
//! ```text
//! D(theta) = sum p(theta) . (u^- + u1(theta))/2,
//! ```
//!
//! is not positive. At `theta = 0` it never is. As long as the same contacts stick, slip and part, `D` is a square function.
//!
//! Nor do impacts rebound that hang together with what no solver solves, after the step has been cut: in a chain of bodies between two
//! boundaries they may demand more than there is between these, and then no solution exists.
//!
//! Nor does a body rebound that a boundary wedges: where the line between two of its contacts lies in both cones of friction, they
//! hold each other with any force. If it cannot part from one as far as the other's gap lets it, Newton's law has no solution.

use std::collections::{BTreeMap, BTreeSet};

use petgraph::unionfind::UnionFind;

use super::assemble::Assembly;
use super::correction::Correction;
use super::solution::Solution;
use crate::Vec3;
use crate::integrator::Integrator;
use crate::problem::law::split;
use crate::problem::{GROUND, Law};
use crate::scene::Method;

/// Solves in search of the largest rebound.
const SOLVES: usize = 12;
/// Loss of energy, over the work of the impacts, with which the search ends.
const NEAR: f64 = 1e-6;

/// The search for the shares `theta` of a step, by island.
#[derive(Debug, Default)]
pub(super) struct Rebounds(BTreeMap<usize, Search>);

/// `theta` of an island between one that makes energy and one that makes none.
#[derive(Debug)]
struct Search {
    share: f64,
    makes: [f64; 2],
    loses: Option<[f64; 2]>,
    /// Whether the last solve made energy.
    made: bool,
    solves: usize,
    ended: bool,
}

/// Work of the rows of an island, and its scale \[J\].
#[derive(Debug, Clone, Copy, Default)]
struct Work {
    gain: f64,
    scale: f64,
    rebounds: bool,
}

impl Rebounds {
    /// Smaller rebounds where the solution makes energy, or larger ones where too much of them was taken away.
    pub(super) fn limit(&mut self, assembly: &Assembly, solution: &Solution) -> Option<Correction> {
        if !assembly.has_rebounds() {
            return None;
        }
        let impacts = 0..assembly.candidates.len();
        let rebounding: Vec<usize> = impacts.filter(|&k| assembly.rebounds(k)).collect();
        if !rebounding.iter().any(|&k| solution.loads(k)) {
            return None;
        }
        let mut islands = islands(assembly);
        let mut works = vec![Work::default(); assembly.problem.free.len()];
        for (k, p) in solution.impulses.iter().enumerate() {
            let island = &mut works[islands.find_mut(assembly.problem.rows.bodies(k)[0] as usize)];
            let [gain, scale] = work(assembly, solution, k, *p);
            island.gain += gain;
            island.scale += scale;
        }
        for &k in &rebounding {
            let a = assembly.problem.rows.bodies(k)[0] as usize;
            works[islands.find_mut(a)].rebounds = true;
        }
        let mut changed = false;
        for (island, work) in works.iter().enumerate().filter(|(_, work)| work.rebounds) {
            let bound = assembly.prediction.scene.settings.tolerance.force * work.scale;
            changed |= match self.0.get_mut(&island) {
                Some(search) => search.next(work, bound),
                None if work.gain > bound => {
                    self.0.insert(island, Search::new(work));
                    true
                }
                None => false,
            };
        }
        let share = |k: usize| {
            let a = assembly.problem.rows.bodies(k)[0] as usize;
            let search = self.0.get(&islands.find(a))?;
            Some((k, search.share))
        };
        changed.then(|| Correction {
            rebounds: rebounding.into_iter().filter_map(share).collect(),
            ..Correction::default()
        })
    }

    /// Whether some impacts are left that [`Self::give_up`] would give up.
    pub(super) fn are_left(&self, assembly: &Assembly) -> bool {
        let mut all = 0..assembly.candidates.len();
        !self.are_given_up() && all.any(|k| assembly.demands(k))
    }

    /// Whether rebounds of some island are given up.
    pub(super) fn are_given_up(&self) -> bool {
        self.0
            .values()
            .any(|search| search.share == 0.0 && search.ended)
    }

    /// Gives up what impacts demand in the islands of `rows` that no solver solves: none rebounds, and those of contacts that give way
    /// do so. `None` where nothing is left to give up.
    pub(super) fn give_up(&mut self, assembly: &Assembly, rows: &[usize]) -> Option<Correction> {
        let islands = islands(assembly);
        let island = |k: usize| islands.find(assembly.problem.rows.bodies(k)[0] as usize);
        let unsolved: BTreeSet<usize> = rows.iter().map(|&k| island(k)).collect();
        let is_left = |k: usize| {
            let search = self.0.get(&island(k));
            unsolved.contains(&island(k)) && search.is_none_or(|search| search.share > 0.0)
        };
        let impacts = (0..assembly.candidates.len()).filter(|&k| assembly.demands(k) && is_left(k));
        let (sprung, rigid): (Vec<usize>, Vec<usize>) =
            impacts.partition(|&k| assembly.elastic(k).is_some());
        for &k in sprung.iter().chain(&rigid) {
            self.0.insert(island(k), Search::GIVEN_UP);
        }
        (!sprung.is_empty() || !rigid.is_empty()).then(|| Correction {
            rebounds: rigid.into_iter().map(|k| (k, 0.0)).collect(),
            sprung,
            ..Correction::default()
        })
    }
}

impl Search {
    /// No rebounds, whatever is found.
    const GIVEN_UP: Self = Self {
        share: 0.0,
        makes: [0.0; 2],
        loses: None,
        made: true,
        solves: SOLVES,
        ended: true,
    };

    /// After a solve with the whole rebounds: none shows how much there is to lose.
    fn new(work: &Work) -> Self {
        Self {
            share: 0.0,
            makes: [1.0, work.gain],
            loses: None,
            made: true,
            solves: 1,
            ended: false,
        }
    }

    /// The share of the next solve after one with the present share. Returns whether that is another.
    fn next(&mut self, work: &Work, bound: f64) -> bool {
        if self.ended {
            return false;
        }
        self.solves += 1;
        let found = [self.share, work.gain];
        let makes = work.gain > bound;
        // Illinois: an end that stays twice pulls less.
        let pull = if makes == self.made { 0.5 } else { 1.0 };
        if makes {
            self.makes = found;
            self.loses = self.loses.map(|[share, gain]| [share, pull * gain]);
        } else {
            self.makes[1] *= pull;
            self.loses = Some(found);
            self.ended = work.gain > -NEAR * work.scale;
        }
        self.made = makes;
        let before = self.share;
        self.share = match self.loses {
            // Not even without rebounds: overlaps are pushed out, or the solve is not that exact.
            None => 0.0,
            Some([low, _]) if self.solves >= SOLVES => low,
            Some(_) if self.ended => before,
            Some([low, lost]) => {
                let [high, made] = self.makes;
                low + (high - low) * lost / (lost - made)
            }
        };
        self.ended |= self.solves >= SOLVES || self.loses.is_none();
        self.share != before
    }
}

/// Bodies that hang together by rows.
fn islands(assembly: &Assembly) -> UnionFind<usize> {
    let mut islands = UnionFind::new(assembly.problem.free.len());
    for k in 0..assembly.problem.rows.len() {
        let [a, b] = assembly.problem.rows.bodies(k);
        if b != GROUND {
            islands.union(a as usize, b as usize);
        }
    }
    islands
}

/// Work of row `k` on the mean velocity of the step, and its size against the velocity before \[J\]. Springs store theirs.
fn work(assembly: &Assembly, solution: &Solution, k: usize, p: Vec3) -> [f64; 2] {
    let rows = &assembly.problem.rows;
    let general = rows.general(k);
    let stores = general.is_some_and(|row| row.law == Law::Bilateral || row.compliance_n > 0.0);
    if p == Vec3::zeros() || stores {
        return [0.0; 2];
    }
    let before = rows.relative(k, |i| assembly.prediction.velocity(i));
    let after = rows.relative(k, |i| solution.velocity[i]);
    let across = general.map_or(Vec3::zeros(), |row| row.across());
    [
        p.dot(&((before + after) * 0.5 + across)),
        p.dot(&before).abs(),
    ]
}

impl Assembly<'_> {
    /// Whether impacts of the scene rebound by Newton's law.
    fn has_rebounds(&self) -> bool {
        self.has_rigid_impacts() && self.prediction.scene.pairs.rebounds()
    }

    /// Whether impacts of the scene are rigid where steps do not resolve them.
    fn has_rigid_impacts(&self) -> bool {
        let settings = &self.prediction.scene.settings;
        settings.integrator == Integrator::Moreau && settings.method != Method::Penalty
    }

    /// Whether contact `k` is an impact that rebounds.
    fn rebounds(&self, k: usize) -> bool {
        self.impact[k]
            && self.prediction.pair(self.candidates[k].key).restitution > 0.0
            && !self.is_wedged(k)
    }

    /// Whether contact `k` is an impact that demands what other contacts may leave no room for: to rebound, or that what gives way is
    /// rigid.
    fn demands(&self, k: usize) -> bool {
        self.has_rigid_impacts()
            && self.impact[k]
            && (self.rebounds(k) || self.elastic(k).is_some())
    }

    fn is_wedged(&self, k: usize) -> bool {
        let [a, b] = self.problem.rows.bodies(k);
        b == GROUND && self.wedged.binary_search(&a).is_ok()
    }

    /// Lets what boundaries wedge not rebound from them.
    pub(super) fn hold_wedged(&mut self) {
        if !self.has_rebounds() {
            return;
        }
        let rows = &self.problem.rows;
        let body = |k: usize| rows.bodies(k)[0];
        let all = 0..self.candidates.len();
        let on_ground = all.filter(|&k| rows.bodies(k)[1] == GROUND);
        let rebounding = on_ground.clone().filter(|&k| self.rebounds(k));
        let rebounding: BTreeSet<u32> = rebounding.map(body).collect();
        if rebounding.is_empty() {
            return;
        }
        let contacts = on_ground.filter(|&k| rebounding.contains(&body(k)));
        let mut contacts: Vec<usize> = contacts.collect();
        contacts.sort_by_key(|&k| body(k));
        let by_body = contacts.chunk_by(|&k, &l| body(k) == body(l));
        let wedged = by_body.filter(|contacts| self.is_wedge(contacts));
        let wedged: Vec<usize> = wedged.flatten().copied().collect();
        self.wedged = wedged.iter().map(|&k| body(k)).collect();
        for k in wedged {
            let rebound = self.problem.rows.bias(k).min(0.0);
            if self.impact[k] {
                self.problem.rows.shift(k, -rebound);
            }
        }
    }

    /// Whether the line between two of these contacts of a body with boundaries lies in the cones of friction of both, and they demand
    /// more than there is between them.
    fn is_wedge(&self, contacts: &[usize]) -> bool {
        let rows = &self.problem.rows;
        let in_cone = |k: usize, line: Vec3| {
            let friction = self.prediction.pair(self.candidates[k].key).friction;
            let (along, across) = split(line, rows.normal(k));
            across.norm() <= friction * along
        };
        let point = |k: usize| rows.with(k, |row| row.arm_a);
        contacts.iter().enumerate().any(|(at, &k)| {
            contacts[at + 1..].iter().any(|&l| {
                let line = point(l) - point(k);
                rows.bias(k) + rows.bias(l) < 0.0 && in_cone(k, line) && in_cone(l, -line)
            })
        })
    }
}
