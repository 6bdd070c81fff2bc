//! A problem compiled for sweeps: contacts of spheres in blocks, every other row as it is.

use super::block::{self, Block, Body, Pace, Progress};
use crate::Vec3;
use crate::problem::{Dof6, GROUND, Law, Problem, Row};
use crate::scene::Tolerance;
use crate::solver::residual::{Residual, Scale};

/// Rank of a lane without a contact.
pub(super) const NONE: u32 = u32::MAX;
/// Blocks that fill at the same time: a contact joins one in which its bodies are not yet met.
const OPEN: usize = 16;
/// Relative rounding within which a contact's arm is its body's radius.
const SAME: f64 = 1e-12;

/// A row that is no contact of spheres.
#[derive(Debug, Clone, Copy)]
struct Other {
    row: u32,
    scale: Scale,
    impulse: Vec3,
    previous: Vec3,
}

/// The compiled problem; its memory serves from solve to solve.
#[derive(Debug, Default)]
pub struct Kernel {
    blocks: Vec<Block>,
    /// `[N + 1]`; the last one never moves.
    bodies: Vec<Body>,
    /// Bodies after the last sweep.
    before: Vec<Body>,
    /// Length by which each body's spin is scaled \[m\], `[N]`; zero until a contact gives it.
    radius: Vec<f64>,
    others: Vec<Other>,
    /// Velocities of the bodies that other rows move, while such a row is under way.
    velocity: Vec<Dof6>,
    /// Whether a row is a contact with a resistance, `[C]`: both go with the other rows.
    resisted: Vec<bool>,
    /// For each body the filling blocks that hold it, as bits.
    held: Vec<u16>,
    tolerance: Tolerance,
    step: f64,
}

/// A contact whose bodies move as spheres do.
struct SphereContact {
    friction: f64,
    /// Inverse mass and `R^2/I` of A and B \[1/kg\].
    mobility: [[f64; 2]; 2],
}

impl Kernel {
    /// Compiles `problem`, velocities being those of `impulses`.
    pub(super) fn compile(&mut self, problem: &Problem, tolerance: &Tolerance, impulses: &[Vec3]) {
        let n = problem.free.len();
        self.tolerance = *tolerance;
        self.step = problem.step;
        self.blocks.clear();
        self.others.clear();
        self.radius.clear();
        self.radius.resize(n, 0.0);
        self.held.clear();
        self.held.resize(n, 0);
        self.resisted.clear();
        self.resisted.resize(problem.rows.len(), false);
        for row in &problem.rows {
            if let Law::Resistance { contact, .. } = row.law {
                self.resisted[contact as usize] = true;
            }
        }
        let mut filling = [Filling::default(); OPEN];
        let mut oldest = 0;
        for (k, row) in problem.rows.iter().enumerate() {
            let contact = match self.resisted[k] {
                true => None,
                false => self.sphere_contact(problem, row),
            };
            let Some(contact) = contact else {
                self.others.push(Other {
                    row: k as u32,
                    scale: Scale::of_row(problem, row),
                    impulse: impulses[k],
                    previous: impulses[k],
                });
                continue;
            };
            let busy = self.held[row.a as usize]
                | self.held.get(row.b as usize).copied().unwrap_or_default();
            let mut at = (!busy).trailing_zeros() as usize;
            if at >= OPEN {
                at = oldest;
                self.flush(&mut filling[at], at);
                oldest = (oldest + 1) % OPEN;
            }
            let lane = filling[at].count;
            self.fill(
                &mut filling[at].block,
                lane,
                (k as u32, row),
                &contact,
                impulses[k],
            );
            filling[at].count += 1;
            for body in [row.a, row.b] {
                if let Some(held) = self.held.get_mut(body as usize) {
                    *held |= 1 << at;
                }
            }
            if filling[at].count == 4 {
                self.flush(&mut filling[at], at);
            }
        }
        for step in 0..OPEN {
            let at = (oldest + step) % OPEN;
            if filling[at].count > 0 {
                self.flush(&mut filling[at], at);
            }
        }
        self.reload(problem, impulses);
    }

    /// Takes the velocities of `impulses` anew, without rounding from many sweeps.
    pub(super) fn reload(&mut self, problem: &Problem, impulses: &[Vec3]) {
        self.velocity = problem.velocities(impulses);
        self.bodies.clear();
        for (i, v) in self.velocity.iter().enumerate() {
            let scale = self.scale(i);
            // Driven bodies move by other rows only, which have their own operator.
            let w = problem.inverse_mass.get(i).copied().unwrap_or(Dof6::ZERO);
            let (v, s) = (v.linear, v.angular * scale);
            self.bodies.push(Body {
                linear: [v.x, v.y, v.z, w.linear.x],
                spin: [s.x, s.y, s.z, w.angular.x * scale * scale],
            });
        }
        self.bodies.push(Body::default());
        self.before.clone_from(&self.bodies);
    }

    fn scale(&self, body: usize) -> f64 {
        match self.radius[body] {
            0.0 => 1.0,
            radius => radius,
        }
    }

    /// `row` as a contact of spheres, if it is one.
    fn sphere_contact(&mut self, problem: &Problem, row: &Row) -> Option<SphereContact> {
        let Law::Contact { mu } = row.law else {
            return None;
        };
        if row.compliance_n != 0.0 || row.compliance_t != 0.0 {
            return None;
        }
        let a = self.sphere(problem, row.a, -row.arm_a, row.normal)?;
        let b = self.sphere(problem, row.b, row.arm_b, row.normal)?;
        Some(SphereContact {
            friction: mu,
            mobility: [a, b],
        })
    }

    /// Inverse mass and `R^2/I` of a body with the same mobility in all directions that is touched at `R normal`.
    fn sphere(
        &mut self,
        problem: &Problem,
        body: u32,
        arm: Vec3,
        normal: Vec3,
    ) -> Option<[f64; 2]> {
        if body == GROUND {
            return Some([0.0; 2]);
        }
        let w = problem.inverse_mass.get(body as usize)?;
        let same = |v: &Vec3| v.x == v.y && v.y == v.z;
        if !(same(&w.linear) && same(&w.angular)) {
            return None;
        }
        let radius = arm.dot(&normal);
        let known = &mut self.radius[body as usize];
        if *known == 0.0 {
            *known = radius;
        }
        let off = (arm - normal * radius).norm_squared() + (radius - *known).powi(2);
        if !(radius > 0.0 && off <= (SAME * radius).powi(2)) {
            return None;
        }
        Some([w.linear.x, w.angular.x * radius * radius])
    }

    fn fill(
        &self,
        block: &mut Block,
        lane: usize,
        (k, row): (u32, &Row),
        contact: &SphereContact,
        impulse: Vec3,
    ) {
        let still = self.radius.len() as u32;
        block.bodies[0][lane] = row.a;
        block.bodies[1][lane] = if row.b == GROUND { still } else { row.b };
        block.rows[lane] = k;
        let bias = row.bias + row.drift;
        for axis in 0..3 {
            block.normal[axis][lane] = row.normal[axis];
            block.impulse[axis][lane] = impulse[axis];
            block.previous[axis][lane] = impulse[axis];
            block.bias[axis][lane] = bias[axis];
        }
        block.friction[lane] = contact.friction;
        let [a, b] = contact.mobility;
        let w_n = a[0] + b[0];
        let w_t = w_n + (a[1] + b[1]);
        let inverse = |w: f64| if w > 0.0 { 1.0 / w } else { 0.0 };
        let length = row.radius / self.step;
        // Where nothing moves, anything is allowed.
        let gap = (self.tolerance.gap * length / w_n).min(f64::INFINITY);
        let slip = (self.tolerance.slip * length / w_t).min(f64::INFINITY);
        block.mass[0][lane] = inverse(w_n);
        block.mass[1][lane] = inverse(w_t);
        block.allowed[0][lane] = gap * gap;
        block.allowed[1][lane] = slip * slip;
        block.scale[lane] = row.impulse_scale * row.impulse_scale;
    }

    /// Appends a filled block and empties it.
    fn flush(&mut self, filling: &mut Filling, at: usize) {
        let still = self.radius.len() as u32;
        for lane in 0..4 {
            let block = &mut filling.block;
            if lane >= filling.count {
                block.bodies = block.bodies.map(|mut bodies| {
                    bodies[lane] = still;
                    bodies
                });
                block.rows[lane] = NONE;
                continue;
            }
            for body in [block.bodies[0][lane], block.bodies[1][lane]] {
                if let Some(held) = self.held.get_mut(body as usize) {
                    *held &= !(1 << at);
                }
            }
        }
        self.blocks.push(filling.block);
        *filling = Filling::default();
    }

    /// One sweep: the blocks, then the other rows.
    pub(super) fn sweep(&mut self, problem: &Problem, pace: Pace) -> Progress {
        for (body, before) in self.bodies.iter_mut().zip(&mut self.before) {
            let now = *body;
            if pace.momentum != 0.0 {
                for k in 0..3 {
                    body.linear[k] += pace.momentum * (body.linear[k] - before.linear[k]);
                    body.spin[k] += pace.momentum * (body.spin[k] - before.spin[k]);
                }
            }
            *before = now;
        }
        let mut progress = block::sweep(&mut self.blocks, &mut self.bodies, pace);
        let mut change = Residual::default();
        for other in 0..self.others.len() {
            let [along, squared] = self.other(problem, pace, other, &mut change);
            progress.along += along;
            progress.change += squared;
        }
        progress.settled &= change.within(&self.tolerance.scaled(pace.strictness));
        progress
    }

    /// Solves one of the other rows, by the operations that every row has.
    fn other(
        &mut self,
        problem: &Problem,
        pace: Pace,
        at: usize,
        change: &mut Residual,
    ) -> [f64; 2] {
        let mut other = self.others[at];
        let row = &problem.rows[other.row as usize];
        let bodies = [row.a, row.b].into_iter().filter(|&body| body != GROUND);
        for i in bodies.clone().map(|body| body as usize) {
            let Body { linear, spin } = self.bodies[i];
            self.velocity[i] = Dof6 {
                linear: Vec3::new(linear[0], linear[1], linear[2]),
                angular: Vec3::new(spin[0], spin[1], spin[2]) / self.scale(i),
            };
        }
        let old = other.impulse;
        let p = old + (old - other.previous) * pace.momentum;
        let u = row.relative_velocity(&self.velocity);
        let correction = other.scale.correction(row, u, p, self.load(problem, row));
        change.include(
            other.row as usize,
            other.scale.residuals(row, problem.step, &correction),
        );
        let full = row.normal * correction.normal + correction.tangential;
        let delta = full * pace.damping;
        other.impulse = p + delta;
        other.previous = old;
        self.others[at] = other;
        if delta != Vec3::zeros() {
            problem.apply(row, &mut self.velocity, delta);
            for i in bodies.map(|body| body as usize) {
                let Dof6 { linear, angular } = self.velocity[i];
                let spin = angular * self.scale(i);
                self.bodies[i].linear[..3].copy_from_slice(linear.as_slice());
                self.bodies[i].spin[..3].copy_from_slice(spin.as_slice());
            }
        }
        [delta.dot(&(other.impulse - old)), full.norm_squared()]
    }

    /// Normal impulse \[N s\] that bounds a resistance; zero for all other rows.
    fn load(&self, problem: &Problem, row: &Row) -> f64 {
        let Law::Resistance { contact, .. } = row.law else {
            return 0.0;
        };
        let found = self
            .others
            .binary_search_by_key(&contact, |other| other.row);
        let normal = problem.rows[contact as usize].normal;
        found.map_or(0.0, |at| self.others[at].impulse.dot(&normal).max(0.0))
    }

    /// Writes the impulses of all rows \[N s\], `[C]`.
    pub(super) fn store(&self, impulses: &mut [Vec3]) {
        for block in &self.blocks {
            for (lane, &row) in block.rows.iter().enumerate() {
                if row != NONE {
                    let [x, y, z] = block.impulse.map(|p| p[lane]);
                    impulses[row as usize] = Vec3::new(x, y, z);
                }
            }
        }
        for other in &self.others {
            impulses[other.row as usize] = other.impulse;
        }
    }
}

/// A block that fills.
#[derive(Debug, Clone, Copy, Default)]
struct Filling {
    block: Block,
    count: usize,
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    /// A row of spheres of different sizes on the ground, pushed, with one row that is no contact of spheres.
    fn problem() -> Problem {
        let mut problem = Problem {
            step: 1e-3,
            ..Problem::default()
        };
        let radius = |i: usize| 0.01 * (1.0 + 0.1 * (i % 4) as f64);
        for i in 0..23 {
            let x = i as f64;
            let mass = 2e4 * radius(i).powi(3);
            problem.free.push(Dof6 {
                linear: Vector3::new(0.3 - 0.05 * x, 0.1 * (x * 1.7).sin(), -0.1),
                angular: Vector3::new((x * 0.9).cos(), 0.5, (x * 2.3).sin()),
            });
            let inverse = 1.0 / (0.4 * mass * radius(i) * radius(i));
            problem.inverse_mass.push(Dof6 {
                linear: Vector3::repeat(1.0 / mass),
                angular: Vector3::repeat(inverse),
            });
        }
        for a in 0..23_u32 {
            for b in [a + 1, GROUND] {
                if b == 23 {
                    continue;
                }
                let normal = if b == GROUND {
                    Vector3::z()
                } else {
                    -Vector3::new(1.0, 0.1, 0.05 * f64::from(a % 3)).normalize()
                };
                let [ra, rb] = [a, b.min(22)].map(|i| radius(i as usize));
                problem.rows.push(Row {
                    a,
                    b,
                    normal,
                    arm_a: normal * -ra,
                    arm_b: if b == GROUND {
                        Vec3::zeros()
                    } else {
                        normal * rb
                    },
                    drift: Vec3::zeros(),
                    bias: normal * 0.01,
                    compliance_n: if a == 7 { 0.1 } else { 0.0 },
                    compliance_t: 0.0,
                    law: Law::Contact { mu: 0.3 },
                    radius: ra.min(rb),
                    impulse_scale: 1e-4,
                });
            }
        }
        problem
    }

    /// The oracle is the row's own operations, one row after the other in the order of the blocks.
    #[test]
    fn blocks_do_what_rows_do_one_after_the_other() {
        let problem = problem();
        let start: Vec<Vec3> = (0..problem.rows.len())
            .map(|k| problem.rows[k].normal * (1e-4 * (k % 5) as f64))
            .collect();
        let pace = Pace {
            momentum: 0.0,
            damping: 0.8,
            strictness: 1.0,
            force: 1e-6,
        };
        let mut kernel = Kernel::default();
        kernel.compile(&problem, &Tolerance::default(), &start);
        assert_eq!(kernel.others.len(), 2, "one springy sphere's rows");
        let mut order: Vec<u32> = kernel.blocks.iter().flat_map(|block| block.rows).collect();
        order.retain(|&row| row != NONE);
        order.extend(kernel.others.iter().map(|other| other.row));
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..problem.rows.len() as u32));

        let mut expected = start.clone();
        let mut velocity = problem.velocities(&start);
        let mut found = start;
        for sweep in 0..3 {
            let progress = kernel.sweep(&problem, pace);
            kernel.store(&mut found);
            let mut change = 0.0;
            for &k in &order {
                let row = &problem.rows[k as usize];
                let p = &mut expected[k as usize];
                let scale = Scale::of_row(&problem, row);
                let correction = scale.correction(row, row.relative_velocity(&velocity), *p, 0.0);
                let full = row.normal * correction.normal + correction.tangential;
                change += full.norm_squared();
                *p += full * pace.damping;
                problem.apply(row, &mut velocity, full * pace.damping);
            }
            for (k, (p, q)) in found.iter().zip(&expected).enumerate() {
                assert!((p - q).norm() < 1e-15, "sweep {sweep}, row {k}: {p} {q}");
            }
            assert!((progress.change - change).abs() < 1e-9 * change);
            assert!(!progress.settled);
        }
    }

    /// What two sweeps leave and momentum moves is the same in impulses and velocities.
    #[test]
    fn momentum_moves_impulses_and_velocities_together() {
        let problem = problem();
        let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
        let mut kernel = Kernel::default();
        kernel.compile(&problem, &Tolerance::default(), &impulses);
        for k in 0..20 {
            let momentum = if k < 3 { 0.0 } else { 0.7 };
            let pace = Pace {
                momentum,
                damping: 1.0,
                strictness: 1.0,
                force: 1e-6,
            };
            kernel.sweep(&problem, pace);
        }
        kernel.store(&mut impulses);
        let velocity = problem.velocities(&impulses);
        for (i, v) in velocity.iter().enumerate() {
            let body = &kernel.bodies[i];
            let (linear, spin) = (v.linear, v.angular * kernel.scale(i));
            for k in 0..3 {
                assert!((body.linear[k] - linear[k]).abs() < 1e-12);
                assert!((body.spin[k] - spin[k]).abs() < 1e-12);
            }
        }
    }
}
