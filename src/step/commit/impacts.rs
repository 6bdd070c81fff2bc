//! Which contacts of a solved step count as impacts: their forces are none that the next step may go on with. As smooth forces they
//! would shift the half step.

use std::iter::once;
use std::mem::take;
use std::ops::Range;

use crate::Vec3;
use crate::problem::Rows;
use crate::sorting::counting_sort;
use crate::spatial::SpatialVector;
use crate::state::State;
use crate::step::assemble::Assembly;
use crate::step::rows::elastic::ElasticContact;
use crate::step::solution::Solution;

/// Forces over those carried before and what loads bring, from which on a contact was hit through others.
const STRUCK: f64 = 2.0;
/// Change of a force since the last step, over the force, up to which it lasts.
const STEADY: f64 = 0.2;
/// Forces that a body keeps over what changes its motion, from which on they only hold against its impacts.
const HELD: f64 = 4.0;

/// Counts as impacts the contacts that an impact has hit through others: their impulses are more than [`STRUCK`] times what they
/// carried before and what loads bring in a step, or their sum on a body only holds against its impacts. Of a step that is `unconverged` all
/// are. `balance` is memory.
pub(crate) fn spread_impacts(
    assembly: &mut Assembly,
    solution: &Solution,
    (state, unconverged): (&State, bool),
    balance: &mut Balance,
) {
    if unconverged {
        assembly.impact.fill(true);
        assembly
            .joints
            .iter_mut()
            .for_each(|joint| joint.impact = true);
        return;
    }
    let struck = |(k, p): (usize, &Vec3)| *p != Vec3::zeros() && assembly.is_impact(k);
    if !solution.impulses.iter().enumerate().any(struck) {
        return;
    }
    let prediction = assembly.prediction;
    let step = prediction.step;
    let first = assembly.first_joint();
    for (k, joint) in assembly.joints.iter_mut().enumerate() {
        let load = prediction.weight(assembly.problem.rows.bodies(first + k)[0]);
        let before = joint.limit.force.abs();
        let handed_on = solution.impulses[first + k].norm() > STRUCK * step * (before + load);
        joint.impact |= joint.limit.stops() && handed_on;
    }
    // What a step resolves is no impact.
    let resolved =
        |assembly: &Assembly, k| assembly.elastic(k).is_some_and(ElasticContact::is_resolved);
    let mut impact = take(&mut assembly.impact);
    let hit = |first, impact: &mut [bool]| {
        for (k, impact) in (first..).zip(impact) {
            if !solution.loads(k) || resolved(assembly, k) {
                continue;
            }
            let size = solution.impulses[k].norm();
            let before = assembly.past[k].force(&state.contacts).norm();
            // Most carry what they did.
            if size <= STRUCK * step * before {
                continue;
            }
            let bodies = assembly.problem.rows.bodies(k);
            let load = bodies.map(|body| prediction.weight(body));
            let load = load[0].max(load[1]);
            *impact |= size > STRUCK * step * (before + load);
        }
    };
    assembly
        .prediction
        .pool
        .pieces(&mut impact[..], hit, |(), ()| ());
    assembly.impact = impact;
    balance.take(assembly, solution);
    for k in balance.held(assembly, solution) {
        let (size, before) = (
            solution.impulses[k].norm(),
            assembly.past[k].force(&state.contacts),
        );
        if (size - step * before.norm()).abs() <= STEADY * size {
            balance.change(assembly, solution, (k, false));
        }
    }
    let mut found = balance.held(assembly, solution);
    loop {
        found.retain(|&k| !assembly.impact[k] && !resolved(assembly, k));
        if found.is_empty() {
            return;
        }
        for &k in &found {
            balance.change(assembly, solution, (k, true));
        }
        found = balance.held_beside(assembly, solution, &found);
    }
}

/// Which bodies only hold against their impacts; its memory serves from step to step.
#[derive(Debug, Default)]
pub(crate) struct Balance {
    /// Whether a body has its sums, `[N + M]`: those that impacts touch do, for no other can hold against them.
    summed: Vec<bool>,
    /// Impulses \[N s\], \[N m s\] of smooth contacts and of impacts on such bodies, `[N + M]`.
    sums: Vec<[SpatialVector; 2]>,
    /// Radius \[m\] of a contact below which they cancel: each is much more than what both together change of the motion. Zero where
    /// there are no sums.
    limits: Vec<f64>,
    /// Rows of resistances by their contacts, in order.
    resistances: Vec<(usize, usize)>,
    rows: RowsOfBodies,
}

/// The rows of each body: made when asked for first.
#[derive(Debug, Default)]
struct RowsOfBodies {
    /// Where those of each body end in `sides`, `[N + M]`; empty until they are asked for.
    ends: Vec<u32>,
    /// By body: twice the row, and one more where the body is its second.
    sides: Vec<u32>,
}

impl RowsOfBodies {
    fn forget(&mut self) {
        self.ends.clear();
    }

    /// Looks at the rows, of `bodies` bodies, unless it has.
    fn find(&mut self, rows: &Rows, bodies: usize) {
        if !self.ends.is_empty() {
            return;
        }
        let held = rows.all_bodies().as_flattened();
        let body = |side: &u32| held[*side as usize];
        let sides = (0..held.len() as u32).filter(|side| (body(side) as usize) < bodies);
        counting_sort(sides, (body, bodies), &mut self.ends, &mut self.sides);
    }

    /// Those of `body`, ascending; none of the ground.
    fn of(&self, body: u32) -> impl Iterator<Item = usize> {
        let body = body as usize;
        let start = body.checked_sub(1).and_then(|before| self.ends.get(before));
        let ends = [start, self.ends.get(body)].map(|end| end.map_or(0, |&end| end as usize));
        let own = self.sides.get(ends[0]..ends[1]).unwrap_or_default();
        own.iter().map(|side| *side as usize / 2)
    }
}

impl Balance {
    /// Sums up the rows of `assembly` on the bodies that impacts touch.
    fn take(&mut self, assembly: &Assembly, solution: &Solution) {
        let rows = &assembly.problem.rows;
        let pool = &assembly.prediction.pool;
        let bodies = solution.velocity.len();
        self.summed.clear();
        self.summed.resize(bodies, false);
        self.sums.resize(bodies, [SpatialVector::ZERO; 2]);
        self.rows.forget();
        let loaded = |k: &usize| solution.loads(*k);
        let all = 0..solution.impulses.len();
        for k in all.clone().filter(loaded) {
            if assembly.is_impact(k) {
                for body in rows.bodies(k).map(|body| body as usize) {
                    if self.summed.get(body) == Some(&false) {
                        self.summed[body] = true;
                        self.sums[body] = [SpatialVector::ZERO; 2];
                    }
                }
            }
        }
        for k in all.filter(loaded) {
            if rows.bodies(k).into_iter().any(|body| self.has(body)) {
                self.add(rows, (k, solution.impulses[k]), assembly.is_impact(k));
            }
        }
        self.limits.resize(bodies, 0.0);
        let (sums, summed) = (&self.sums, &self.summed);
        let of = |body: usize| match summed[body] {
            true => limit(assembly, body, &sums[body]),
            false => 0.0,
        };
        pool.fill(&mut self.limits[..], of);
        self.resistances.clear();
        self.resistances
            .extend(rows.resistances().map(|(row, contact)| (contact, row)));
        self.resistances.sort_unstable();
    }

    /// Whether `body` has its sums; the ground has none.
    fn has(&self, body: u32) -> bool {
        self.summed.get(body as usize) == Some(&true)
    }

    /// Adds the impulse \[N s\] of row `k` to the smooth ones of its bodies that have sums, or to the impacts.
    fn add(&mut self, rows: &Rows, (k, impulse): (usize, Vec3), impact: bool) {
        for (body, push) in rows.bodies(k).into_iter().zip(&rows.momenta(k, impulse)) {
            if self.has(body) {
                let sum = &mut self.sums[body as usize][usize::from(impact)];
                *sum = sum.plus(push, 1.0);
            }
        }
    }

    /// Sums up the rows of `body`, unless it has its sums or is the ground.
    fn sum_up(&mut self, assembly: &Assembly, solution: &Solution, body: u32) {
        if self.summed.get(body as usize) != Some(&false) {
            return;
        }
        let rows = &assembly.problem.rows;
        self.rows.find(rows, self.summed.len());
        let mut sums = [SpatialVector::ZERO; 2];
        for k in self.rows.of(body).filter(|&k| solution.loads(k)) {
            let pushes = rows.momenta(k, solution.impulses[k]);
            let sum = &mut sums[usize::from(assembly.is_impact(k))];
            for (_, push) in rows
                .bodies(k)
                .iter()
                .zip(&pushes)
                .filter(|(own, _)| **own == body)
            {
                *sum = sum.plus(push, 1.0);
            }
        }
        (self.summed[body as usize], self.sums[body as usize]) = (true, sums);
    }

    /// The loaded contacts of bodies whose smooth forces and impacts cancel.
    fn held(&self, assembly: &Assembly, solution: &Solution) -> Vec<usize> {
        // No contact has a radius below zero: mostly there is nothing to look for.
        if self.limits.iter().all(|limit| *limit <= 0.0) {
            return Vec::new();
        }
        let cancels = |k: &usize| self.cancels(assembly, solution, *k);
        let all = 0..assembly.impact.len();
        let piece = |_, range: Range<usize>| range.filter(cancels).collect();
        assembly
            .prediction
            .pool
            .pieces(all, piece, |mut a: Vec<usize>, b| {
                a.extend(b);
                a
            })
    }

    /// Likewise of the bodies of contacts that are `changed` alone: the others are as they were.
    fn held_beside(
        &mut self,
        assembly: &Assembly,
        solution: &Solution,
        changed: &[usize],
    ) -> Vec<usize> {
        let rows = &assembly.problem.rows;
        self.rows.find(rows, self.sums.len());
        let bodies = changed.iter().flat_map(|&k| rows.bodies(k));
        let mut bodies: Vec<u32> = bodies.collect();
        bodies.sort_unstable();
        bodies.dedup();
        let beside = bodies.iter().flat_map(|&body| self.rows.of(body));
        let mut found: Vec<usize> = beside
            .filter(|&k| k < assembly.impact.len() && self.cancels(assembly, solution, k))
            .collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Whether contact `k` is loaded and of a body on which they cancel.
    fn cancels(&self, assembly: &Assembly, solution: &Solution, k: usize) -> bool {
        let rows = &assembly.problem.rows;
        let of = |body: u32| self.limits.get(body as usize).copied().unwrap_or(0.0);
        let [a, b] = rows.bodies(k);
        let limit = of(a).max(of(b));
        // Of most contacts the bodies tell, without their rows.
        limit > 0.0 && rows.radius(k) < limit && solution.loads(k)
    }

    /// Counts contact `k` as an impact, or no longer.
    fn change(&mut self, assembly: &mut Assembly, solution: &Solution, (k, impact): (usize, bool)) {
        if assembly.impact[k] == impact {
            return;
        }
        for body in assembly.problem.rows.bodies(k) {
            self.sum_up(assembly, solution, body);
        }
        assembly.impact[k] = impact;
        let rows = &assembly.problem.rows;
        let first = self
            .resistances
            .partition_point(|(contact, _)| *contact < k);
        let resistance = self.resistances.get(first);
        let resistance = resistance.filter(|(contact, _)| *contact == k).copied();
        for k in once(k).chain(resistance.map(|(_, row)| row)) {
            let impulse = solution.impulses[k];
            self.add(rows, (k, -impulse), !impact);
            self.add(rows, (k, impulse), impact);
        }
        for body in rows.bodies(k).map(|body| body as usize) {
            if let Some(sums) = self.sums.get(body) {
                self.limits[body] = limit(assembly, body, sums);
            }
        }
    }
}

/// [`Balance::limits`] of a body.
fn limit(assembly: &Assembly, body: usize, [smooth, impacts]: &[SpatialVector; 2]) -> f64 {
    let net = smooth.plus(impacts, 1.0);
    let brought = assembly.prediction.step * assembly.prediction.weight(body as u32);
    match smooth.linear.norm() > HELD * (net.linear.norm() + brought) {
        true => f64::INFINITY,
        false => (smooth.angular.norm() / HELD - net.angular.norm()) / brought,
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::Arc;

    use super::*;
    use crate::parallel::Pool;
    use crate::problem::GROUND;
    use crate::scene::Scene;
    use crate::simulation::Simulation;
    use crate::step::linear_problem::linear_problem;
    use crate::step::prediction::{PredictionArrays, predict};
    use crate::step::{StepInput, Workspace};

    /// Three spheres that touch each other and a floor, with resistance to rolling.
    const SCENE: &str = r#"
[simulation]
duration = 1.0
[[material]]
name = "rock"
density = 2500.0
[pair_default]
friction = 0.5
rolling_friction = 0.1
[[spheres]]
name = "three"
material = "rock"
radius = 0.1
positions = [[0.0, 0.0, 0.1], [0.2, 0.0, 0.1], [0.1, 0.0, 0.2732050808]]
[[boundary]]
name = "floor"
material = "rock"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
"#;

    /// Lets `check` have the problem that the scene of `text` starts with.
    fn at_start(text: &str, check: impl FnOnce(&mut Assembly)) {
        let loaded = Scene::from_toml("scene", text, Path::new(""));
        let scene = Arc::new(loaded.expect("a scene").scene);
        let simulation = Simulation::new(scene.clone()).expect("a start");
        let (state, mut workspace) = (simulation.state(), Workspace::default());
        let input = StepInput::still(state, 1e-3);
        let mut prediction = predict(
            &scene,
            state,
            &input,
            (PredictionArrays::default(), &Pool::default()),
        );
        let (mut assembly, _) = linear_problem(&mut prediction, state, &mut workspace);
        check(&mut assembly);
    }

    #[test]
    fn sums_that_follow_changes_are_those_made_anew() {
        at_start(SCENE, |assembly| {
            let count = assembly.problem.rows.len();
            assert_eq!((assembly.impact.len(), count), (5, 10));
            let mut impulses: Vec<_> = (1..=count).map(|k| Vec3::new(0.1, 1.0, k as f64)).collect();
            // One of the two an impact, the first sphere only holds against it.
            (impulses[0], impulses[1]) = (Vec3::z() * 1e4, Vec3::z() * -1e4);
            let solution = Solution::of(assembly, impulses);
            let (mut kept, mut anew) = (Balance::default(), Balance::default());
            kept.take(assembly, &solution);
            let mut most = 0;
            for (k, impact) in [(0, true), (3, true), (4, true), (3, false), (1, true)] {
                kept.change(assembly, &solution, (k, impact));
                anew.take(assembly, &solution);
                let held = anew.held(assembly, &solution);
                assert_eq!(kept.held(assembly, &solution), held, "{k}");
                let [a, b] = assembly.problem.rows.bodies(k);
                let of = |k: &usize| assembly.problem.rows.bodies(*k).into_iter();
                let mut own = held.clone();
                own.retain(|k| of(k).any(|body| body != GROUND && [a, b].contains(&body)));
                assert_eq!(kept.held_beside(assembly, &solution, &[k]), own, "{k}");
                most = most.max(held.len());
                for body in (0..anew.summed.len()).filter(|&body| anew.summed[body]) {
                    assert!(kept.summed[body]);
                    for (kept, anew) in kept.sums[body].iter().zip(&anew.sums[body]) {
                        let apart = kept.plus(anew, -1.0);
                        assert!(apart.dot(&apart) < 1e-16, "{k}: {kept:?}, {anew:?}");
                    }
                    let [kept, anew] = [&kept, &anew].map(|own| own.limits[body]);
                    assert!(
                        kept == anew || (kept - anew).abs() < 1e-9,
                        "{k}: {kept}, {anew}"
                    );
                }
            }
            assert!(most > 0);
        });
    }

    /// More than one thread takes at a time.
    #[test]
    fn each_body_has_its_own_limit() {
        let places: Vec<String> = (0..600)
            .map(|i| format!("[{:.1}, 0.0, 0.1]", 0.3 * f64::from(i)))
            .collect();
        let three = "[[0.0, 0.0, 0.1], [0.2, 0.0, 0.1], [0.1, 0.0, 0.2732050808]]";
        let text = SCENE.replace(three, &format!("[{}]", places.join(", ")));
        at_start(&text, |assembly| {
            let count = assembly.problem.rows.len();
            assert_eq!((assembly.impact.len(), count), (600, 1200));
            let impulses = (1..=count).map(|k| Vec3::new(0.1 * k as f64, 1.0, k as f64));
            assembly.impact.fill(true);
            assembly.impact[7] = false;
            let solution = Solution::of(assembly, impulses.collect());
            let mut balance = Balance::default();
            balance.take(assembly, &solution);
            assert_eq!(balance.limits.len(), 600);
            for (body, found) in balance.limits.iter().enumerate() {
                if body == 7 {
                    assert_eq!(*found, 0.0);
                    continue;
                }
                assert_eq!(*found, limit(assembly, body, &balance.sums[body]), "{body}");
            }
            assert!(balance.limits.windows(2).all(|pair| pair[0] != pair[1]));
        });
    }
}
