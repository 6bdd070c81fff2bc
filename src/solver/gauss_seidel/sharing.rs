//! Which bodies contacts of a block may share: heavy ones on which many spheres lie.

use super::batch::Batch;
use super::lanes::{LANES, Real};
use crate::problem::Problem;

/// Largest mobility of all parts of a shared body over that of what touches it.
const SPLIT: f64 = 0.25;

/// How many contacts of a block may share each body.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Sharing {
    spheres: usize,
    /// Of those behind the spheres, `[M]`; empty where each is one.
    limits: Vec<usize>,
}

/// What touches a body.
#[derive(Debug, Clone, Copy)]
struct Touched {
    contacts: usize,
    /// Least mobility of what touches it over its own.
    ratio: f64,
}

impl Touched {
    /// How many contacts of a block may share the body.
    fn limit(&self) -> usize {
        match self.contacts > LANES {
            true => ((SPLIT * self.ratio) as usize).clamp(1, LANES),
            false => 1,
        }
    }
}

impl Sharing {
    /// Looks at the contacts that are `rows` of `problem`: all that touch bodies behind the spheres.
    pub(super) fn find(&mut self, problem: &Problem, rows: impl Iterator<Item = u32> + Clone) {
        self.spheres = problem.inverse_mass.len();
        self.limits.clear();
        if problem.operators.is_empty() {
            return;
        }
        let none = Touched {
            contacts: 0,
            ratio: f64::INFINITY,
        };
        let mut touched = vec![none; problem.operators.len()];
        let place = |body: u32| {
            let at = (body as usize).checked_sub(self.spheres)?;
            (at < problem.operators.len()).then_some(at)
        };
        let bodies = |k: u32| problem.rows.bodies(k as usize);
        for k in rows.clone() {
            for body in bodies(k) {
                if let Some(at) = place(body) {
                    touched[at].contacts += 1;
                }
            }
        }
        if touched.iter().all(|own| own.contacts <= LANES) {
            return;
        }
        for k in rows {
            for (side, at) in bodies(k).map(place).into_iter().enumerate() {
                if let Some(at) = at
                    && touched[at].contacts > LANES
                {
                    let rows = &problem.rows;
                    let traces = rows.with(k as usize, |row| problem.mobility_traces(row));
                    let ratio = traces[1 - side] / traces[side];
                    touched[at].ratio = touched[at].ratio.min(ratio);
                }
            }
        }
        self.limits.extend(touched.iter().map(Touched::limit));
    }

    /// The place of the body that contacts of `block`, which are `rows` of `problem`, do share.
    pub(super) fn shared(
        &self,
        problem: &Problem,
        block: &Batch<impl Real>,
        rows: &[u32],
    ) -> Option<u32> {
        if !self.any() {
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

    /// Whether they may share any.
    pub(super) fn any(&self) -> bool {
        !self.limits.is_empty()
    }

    /// How many contacts of a block may share this body.
    #[inline]
    pub(super) fn limit(&self, body: u32) -> usize {
        let at = (body as usize).checked_sub(self.spheres);
        let own = at.and_then(|at| self.limits.get(at));
        own.copied().unwrap_or(1)
    }
}
