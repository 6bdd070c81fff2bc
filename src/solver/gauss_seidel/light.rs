//! Light spheres between heavy ones, each solved with all its contacts at once.
//!
//! Contact by contact a light sphere between a heavy one and the ground hands on its own momentum and no more: the heavy one is
//! held after as many sweeps as it has times the mass (the root of it with momentum). So after each sweep every sphere that is
//! pressed by bodies of at least [`RATIO`] times its mass, and whose contacts are not settled, is solved with them:
//!
//! ```text
//! d(y)  = u + b + c p + s y_v + n x y_s                      [m/s]     y: change of (v, R w) of the light sphere
//! p'(y) = Proj(p - d(y)/g)                                   [N s]     s: 1 where it is A, -1 where it is B
//! r(y)  = sum (s dp, -n x dp) - (y_v/m, y_s/k) = 0           [N s]     dp = p'(y) - p
//! ```
//!
//! `Proj` is the law of the contact, normal impulse first; `g` is the mobility of the other body with the contact's compliance,
//! at least the share [`FLOOR`] of the light sphere's own: ground is no wall, and what remains is left to the next sweep. Six unknowns,
//! by Newton's method with the derivative of each contact that is open, sticks or slips. What it does not solve stays as it is. All
//! in double precision without fused operations: the same bits with any registers.

use arrayvec::ArrayVec;
use nalgebra::{Matrix3, SMatrix, SVector};

use super::batch::{Extra, Form, PLAIN};
use super::batches::{Batches, Colours};
use super::lanes::{Body, LANES, Real};
use crate::Vec3;
use crate::problem::Law;
use crate::problem::law::split;
use crate::sorting::counting_sort;

/// How many times its mass what presses a light sphere must have.
const RATIO: f64 = 30.0;
/// Least mobility of what presses, over that of the light sphere.
const FLOOR: f64 = 0.02;
/// Iterations of Newton's method.
const ITERATIONS: usize = 8;
/// Share of the first squared residual at which it ends, and that from which its result is taken.
const SOLVED: f64 = 1e-4;
const TAKEN: f64 = 1e-2;
/// Where more of them are not settled than this and one in so many contacts, sweeps alone go on: they take less time.
const FEW: usize = 8;
const ROWS_EACH: usize = 40;

/// Light spheres of a problem, and their contacts.
#[derive(Debug, Default)]
pub(super) struct LightSpheres {
    /// Whether they are those of the problem at hand.
    known: bool,
    spheres: Vec<LightSphere>,
    /// Their contacts, by sphere; before they were sorted; and where those of each body end.
    contacts: Vec<Held>,
    found: Vec<Held>,
    ends: Vec<u32>,
    /// How many of them may be unsettled, and those that are.
    few: usize,
    unsettled: Vec<LightSphere>,
    /// How many contacts press each body, and how many of these are of bodies that move.
    pressing: Vec<[u32; 2]>,
}

#[derive(Debug, Clone, Copy)]
struct LightSphere {
    /// Its place among the bodies.
    body: u32,
    /// Where its contacts begin and end.
    contacts: [u32; 2],
}

/// A contact of a light sphere.
#[derive(Debug, Clone, Copy, Default)]
struct Held {
    block: u32,
    lane: u32,
    /// Places of the light sphere and of the other body.
    own: u32,
    other: u32,
    /// 1 where the light sphere is A, -1 where it is B.
    sign: f64,
}

/// What a light sphere's contacts are while it is solved.
struct Contact {
    n: Vec3,
    /// Impulse, and what the law should make zero at it.
    p: Vec3,
    d: Vec3,
    law: Law,
    /// `g` along the normal and across it.
    g: [f64; 2],
    sign: f64,
}

impl LightSpheres {
    /// Another problem is at hand.
    pub(super) fn forget(&mut self) {
        self.known = false;
    }

    /// Solves each that has a contact which the last sweep found not settled.
    pub(super) fn solve<T: Real>(&mut self, batches: &mut Batches<T>, turns: &Colours) {
        if !self.known {
            self.find(batches, turns);
            self.known = true;
        }
        if self.spheres.is_empty() {
            return;
        }
        let unsettled = &batches.unsettled;
        let is_unsettled = |held: &Held| unsettled[held.block as usize] >> held.lane & 1 == 1;
        let own = |sphere: &LightSphere| {
            let [start, end] = sphere.contacts.map(|at| at as usize);
            &self.contacts[start..end]
        };
        self.unsettled.clear();
        let unsettled = self
            .spheres
            .iter()
            .filter(|sphere| own(sphere).iter().any(is_unsettled));
        self.unsettled.extend(unsettled);
        if self.unsettled.len() > self.few {
            return;
        }
        for sphere in &self.unsettled {
            let held = own(sphere);
            let Body([_, _, _, m, _, _, _, k]) = exact(&batches.bodies[sphere.body as usize]);
            let contacts = held.iter().map(|held| Contact::of(batches, held));
            let contacts: ArrayVec<Contact, LANES> = contacts.collect();
            if let Some(impulses) = solved([m, k], &contacts) {
                for (held, p) in held.iter().zip(impulses) {
                    give(batches, held, p);
                }
            }
        }
    }

    /// Takes those of the blocks in `turns`.
    fn find<T: Real>(&mut self, batches: &Batches<T>, turns: &Colours) {
        self.spheres.clear();
        let mobility = |body: u32| batches.bodies[body as usize].0[3].exact();
        let mobilities = (0..batches.bodies.len() as u32).map(mobility);
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for m in mobilities.filter(|m| *m > 0.0) {
            (least, most) = (least.min(m), most.max(m));
        }
        if RATIO * least > most {
            return;
        }
        let bodies = batches.bodies.len();
        self.pressing.clear();
        self.pressing.resize(bodies, [0; 2]);
        each_contact(batches, turns, |_, [a, b]| {
            for (own, other) in [(a, b), (b, a)] {
                let presses = mobility(own) > 0.0 && RATIO * mobility(other) <= mobility(own);
                let [all, moving] = &mut self.pressing[own as usize];
                *all += u32::from(presses);
                *moving += u32::from(presses && mobility(other) > 0.0);
            }
        });
        let rows: usize = batches
            .blocks
            .iter()
            .map(|block| block.count as usize)
            .sum();
        self.few = FEW + rows / ROWS_EACH;
        self.found.clear();
        each_contact(batches, turns, |[block, lane], [a, b]| {
            for (own, other, sign) in [(a, b, 1.0), (b, a, -1.0)] {
                let [all, moving] = self.pressing[own as usize];
                if all >= 2 && moving >= 1 {
                    self.found.push(Held {
                        block,
                        lane,
                        own,
                        other,
                        sign,
                    });
                }
            }
        });
        let found = self.found.iter().copied();
        let by_sphere = (|held: &Held| held.own, bodies);
        counting_sort(found, by_sphere, &mut self.ends, &mut self.contacts);
        let mut start = 0;
        for (body, &end) in (0..).zip(&self.ends[..bodies]) {
            if (1..=LANES as u32).contains(&(end - start)) {
                let contacts = [start, end];
                self.spheres.push(LightSphere { body, contacts });
            }
            start = end;
        }
    }
}

/// Tells `see` the block, lane and places of the bodies of every contact; none of those that have levers or are on heavy bodies.
fn each_contact<T: Real>(
    batches: &Batches<T>,
    turns: &Colours,
    mut see: impl FnMut([u32; 2], [u32; 2]),
) {
    let groups = turns.iter().flatten();
    for group in groups.filter(|group| group.form != Form::Heavy) {
        let first = group.bodies.start as u32;
        for k in group.blocks.clone() {
            let block = &batches.blocks[k];
            if block.levers != PLAIN {
                continue;
            }
            let [a, b] = &block.bodies;
            for lane in 0..block.count as usize {
                see([k as u32, lane as u32], [a[lane] + first, b[lane] + first]);
            }
        }
    }
}

fn exact<T: Real>(body: &Body<T>) -> Body<f64> {
    Body(body.0.map(T::exact))
}

impl Contact {
    fn of<T: Real>(batches: &Batches<T>, held: &Held) -> Self {
        let block = &batches.blocks[held.block as usize];
        let lane = held.lane as usize;
        let vector = |x: &[[T; LANES]; 3]| Vec3::from_fn(|k, _| x[k][lane].exact());
        let (n, p) = (
            vector(&block.normal),
            vector(&block.impulse[batches.latest]),
        );
        let own = exact(&batches.bodies[held.own as usize]).0;
        let other = exact(&batches.bodies[held.other as usize]).0;
        let v = |x: &[f64; 8]| Vec3::new(x[0], x[1], x[2]);
        let s = |x: &[f64; 8]| Vec3::new(x[4], x[5], x[6]);
        let u = (v(&own) - v(&other)) * held.sign - (s(&own) + s(&other)).cross(&n);
        let extra: Option<&Extra<T>> = batches.extras.get(block.extra as usize);
        let (drift, [c_n, c_t]) = match extra {
            None => (Vec3::zeros(), [0.0; 2]),
            Some(extra) => (
                vector(&extra.velocity),
                extra.compliance.map(|c| c[lane].exact()),
            ),
        };
        let (p_n, p_t) = split(p, n);
        let ([m, k], [own_m, own_k]) = ([other[3], other[7]], [own[3], own[7]]);
        Self {
            n,
            p,
            d: u + drift + n * (block.bias[lane].exact() + p_n * c_n) + p_t * c_t,
            law: Law::Contact {
                mu: block.friction[lane].exact(),
            },
            g: [
                (m + c_n).max(FLOOR * own_m),
                (m + k + c_t).max(FLOOR * (own_m + own_k)),
            ],
            sign: held.sign,
        }
    }

    /// Its impulse if the light sphere moves by `v`, `s` more, and minus its derivative by `d`.
    fn impulse(&self, v: Vec3, s: Vec3) -> (Vec3, Matrix3<f64>) {
        let (n, [g_n, g_t]) = (self.n, self.g);
        let d = self.d + v * self.sign + n.cross(&s);
        let ((p_n, p_t), (d_n, d_t)) = (split(self.p, n), split(d, n));
        let normal = p_n - d_n / g_n;
        if normal <= 0.0 {
            return (Vec3::zeros(), Matrix3::zeros());
        }
        let plane = Matrix3::identity() - n * n.transpose();
        let held = self.law.bounds(normal).across(p_t - d_t / g_t, &plane);
        let [_, growth] = self.law.growth();
        let by_normal = (n + held.outward * growth) * n.transpose() / g_n;
        (n * normal + held.value, by_normal + held.tangent / g_t)
    }
}

/// Impulses of the `contacts` of a light sphere of mobilities `m`, `k`; `None` if they are not found.
fn solved([m, k]: [f64; 2], contacts: &[Contact]) -> Option<ArrayVec<Vec3, LANES>> {
    let mut y = SVector::<f64, 6>::zeros();
    let mut first = f64::INFINITY;
    let mut impulses = ArrayVec::new();
    for iteration in 0..=ITERATIONS {
        let (r, a) = residual([m, k], contacts, &y, &mut impulses);
        let (linear, angular) = (r.fixed_rows::<3>(0), r.fixed_rows::<3>(3));
        let size = linear.norm_squared() * m + angular.norm_squared() * k;
        if iteration == 0 {
            first = size;
        }
        if size <= SOLVED * first {
            return Some(impulses);
        }
        if iteration == ITERATIONS {
            return (size <= TAKEN * first).then_some(impulses);
        }
        y += a.lu().solve(&r)?;
    }
    None
}

/// `r(y)` and minus its derivative; `impulses` are then `p'(y)`.
fn residual(
    [m, k]: [f64; 2],
    contacts: &[Contact],
    y: &SVector<f64, 6>,
    impulses: &mut ArrayVec<Vec3, LANES>,
) -> (SVector<f64, 6>, SMatrix<f64, 6, 6>) {
    let v = Vec3::new(y[0], y[1], y[2]);
    let s = Vec3::new(y[3], y[4], y[5]);
    let (mut linear, mut angular) = (-v / m, -s / k);
    let mut a = [
        Matrix3::from_diagonal_element(1.0 / m),
        Matrix3::zeros(),
        Matrix3::zeros(),
        Matrix3::from_diagonal_element(1.0 / k),
    ];
    impulses.clear();
    for contact in contacts {
        let (p, slope) = contact.impulse(v, s);
        let (n, change) = (contact.n.cross_matrix(), p - contact.p);
        linear += change * contact.sign;
        angular -= n * change;
        let turned = slope * n;
        a[0] += slope;
        a[1] += turned * contact.sign;
        a[2] -= n * slope * contact.sign;
        a[3] -= n * turned;
        impulses.push(p);
    }
    let mut r = SVector::<f64, 6>::zeros();
    let mut whole = SMatrix::<f64, 6, 6>::zeros();
    r.fixed_rows_mut::<3>(0).copy_from(&linear);
    r.fixed_rows_mut::<3>(3).copy_from(&angular);
    for (at, part) in a.iter().enumerate() {
        let (row, column) = (3 * (at / 2), 3 * (at % 2));
        whole.fixed_view_mut::<3, 3>(row, column).copy_from(part);
    }
    (r, whole)
}

/// Makes `p` the impulse of a contact of a light sphere.
fn give<T: Real>(batches: &mut Batches<T>, held: &Held, p: Vec3) {
    let (latest, lane) = (batches.latest, held.lane as usize);
    let block = &mut batches.blocks[held.block as usize];
    let mut change = Vec3::zeros();
    for axis in 0..3 {
        let (old, new) = (block.impulse[latest][axis][lane], T::of(p[axis]));
        block.impulse[latest][axis][lane] = new;
        change[axis] = new.exact() - old.exact();
    }
    let n = Vec3::from_fn(|axis, _| block.normal[axis][lane].exact());
    let turn = n.cross(&change);
    for (body, sign) in [(held.own, held.sign), (held.other, -held.sign)] {
        let Body(x) = &mut batches.bodies[body as usize];
        let (m, k) = (x[3].exact(), x[7].exact());
        for axis in 0..3 {
            x[axis] += T::of(sign * m * change[axis]);
            x[4 + axis] += T::of(-k * turn[axis]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRICTION: f64 = 0.4;

    /// A light sphere between three heavy bodies and the ground: contacts that stick, slip and are open.
    fn contacts() -> Vec<Contact> {
        let contact = |n: [f64; 3], p: [f64; 3], d: [f64; 3], g: [f64; 2], sign: f64| Contact {
            n: Vec3::from(n).normalize(),
            p: p.into(),
            d: d.into(),
            law: Law::Contact { mu: FRICTION },
            g,
            sign,
        };
        vec![
            contact(
                [0.1, 0.2, 1.0],
                [0.0, 0.1, 2.0],
                [0.1, 0.0, -0.3],
                [0.2, 0.7],
                1.0,
            ),
            contact(
                [0.9, -0.2, 0.1],
                [1.0, 0.3, 0.0],
                [-0.2, 0.9, 0.4],
                [0.1, 0.4],
                -1.0,
            ),
            contact(
                [-0.5, 1.0, 0.3],
                [0.0; 3],
                [-0.1, -0.3, 0.2],
                [0.3, 1.0],
                -1.0,
            ),
            contact(
                [-0.3, -1.0, 0.2],
                [0.0; 3],
                [-0.4, -0.9, 0.1],
                [0.3, 1.0],
                1.0,
            ),
        ]
    }

    #[test]
    fn derivatives_are_those_of_the_residual() {
        let (mobility, contacts) = ([1.5, 3.7], contacts());
        let at = SVector::<f64, 6>::new(0.02, -0.05, 0.03, 0.04, 0.01, -0.06);
        let mut impulses = ArrayVec::new();
        let (_, slope) = residual(mobility, &contacts, &at, &mut impulses);
        let state = |(p, contact): (&Vec3, &Contact)| {
            let normal = p.dot(&contact.n);
            let across = (p - contact.n * normal).norm();
            match (normal > 0.0, across < 0.999 * FRICTION * normal) {
                (false, _) => "open",
                (true, true) => "sticks",
                (true, false) => "slips",
            }
        };
        let states: Vec<_> = impulses.iter().zip(&contacts).map(state).collect();
        for wanted in ["open", "sticks", "slips"] {
            assert!(states.contains(&wanted), "{states:?}");
        }
        let h = 1e-6;
        for k in 0..6 {
            let mut moved = |by: f64| {
                let mut y = at;
                y[k] += by;
                residual(mobility, &contacts, &y, &mut impulses).0
            };
            let difference = (moved(h) - moved(-h)) / (2.0 * h);
            let error = (difference + slope.column(k)).norm() / difference.norm();
            assert!(error < 1e-7, "{k}: {error}");
        }
    }
}
