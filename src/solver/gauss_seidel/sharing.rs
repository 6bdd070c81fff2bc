//! Which bodies contacts of a block may share: heavy ones on which many spheres lie.

use super::batch::Batch;
use super::lanes::{LANES, Real};
use crate::problem::Problem;

/// Largest mobility of all parts of a shared body over that of what touches it.
const SPLIT: f64 = 0.25;

/// How many contacts of a block may share each body.
#[derive(Debug, Default)]
pub(super) struct Sharing {
    spheres: usize,
    /// Of those behind the spheres, `[M]`.
    others: Vec<Touched>,
    /// Whether contacts may share one of them.
    some: bool,
}

/// What touches a body.
#[derive(Debug, Clone, Copy)]
struct Touched {
    contacts: usize,
    /// Least mobility of what touches it over its own.
    ratio: f64,
}

impl Sharing {
    /// Looks at the contacts that are `rows` of `problem`.
    pub(super) fn find(&mut self, problem: &Problem, rows: &[u32]) {
        self.spheres = problem.inverse_mass.len();
        self.others.clear();
        self.some = false;
        let alone = Touched {
            contacts: 0,
            ratio: f64::INFINITY,
        };
        self.others.resize(problem.operators.len(), alone);
        if self.others.is_empty() {
            return;
        }
        let bodies = |k: u32| problem.rows.bodies(k as usize);
        for body in rows.iter().flat_map(|&k| bodies(k)) {
            if let Some(own) = self.of(body) {
                own.contacts += 1;
            }
        }
        self.some = self.others.iter().any(|own| own.contacts > LANES);
        if !self.some {
            return;
        }
        for &k in rows {
            for (side, body) in bodies(k).into_iter().enumerate() {
                if let Some(own) = self.of(body)
                    && own.contacts > LANES
                {
                    let traces = problem.mobility_traces(&problem.rows.get(k as usize));
                    let [mobility, other] = [side, 1 - side].map(|side| traces[side]);
                    own.ratio = own.ratio.min(other / mobility);
                }
            }
        }
    }

    /// The place of the body that contacts of `block`, which are `rows` of `problem`, do share.
    pub(super) fn shared(
        &self,
        problem: &Problem,
        block: &Batch<impl Real>,
        rows: &[u32],
    ) -> Option<u32> {
        if !self.some {
            return None;
        }
        let lanes = rows.iter().enumerate();
        let held = lanes.flat_map(|(lane, &k)| {
            let bodies = problem.rows.bodies(k as usize).into_iter().enumerate();
            bodies.map(move |(side, body)| (body, block.bodies[side][lane]))
        });
        let mut heavy = held.filter(|(body, _)| self.limit(*body) > 1);
        heavy
            .find(|(_, at)| block.holding(*at).count() > 1)
            .map(|(_, at)| at)
    }

    fn of(&mut self, body: u32) -> Option<&mut Touched> {
        let at = (body as usize).checked_sub(self.spheres)?;
        self.others.get_mut(at)
    }

    /// How many contacts of a block may share this body.
    #[inline]
    pub(super) fn limit(&self, body: u32) -> usize {
        if !self.some {
            return 1;
        }
        let at = (body as usize).checked_sub(self.spheres);
        match at.and_then(|at| self.others.get(at)) {
            Some(own) if own.contacts > LANES => ((SPLIT * own.ratio) as usize).clamp(1, LANES),
            _ => 1,
        }
    }
}
