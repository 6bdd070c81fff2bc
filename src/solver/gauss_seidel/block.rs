//! Four contacts at a time: the update of Gauss-Seidel in lanes.
//!
//! With `s = R w`, a contact of two spheres (or of a sphere and the ground) at normal `n` has
//!
//! ```text
//! u   = v_A - v_B - (s_A + s_B) x n + b             [m/s]
//! v_A += m_A dp,  v_B -= m_B dp                     m: inverse mass [1/kg]
//! s_A -= k_A (n x dp),  s_B -= k_B (n x dp)         k = R^2/I [1/kg]
//! ```
//!
//! so that no radius and no arm is needed, and a body is eight numbers. No two contacts of a block share a moving body: the
//! lanes give the bits that one contact after the other gives. No multiplication is fused with an addition, so that
//! processors with and without wide registers agree in every bit.

/// A body as blocks see it.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C, align(64))]
pub(super) struct Body {
    /// Velocity \[m/s\] and inverse mass \[1/kg\].
    pub(super) linear: [f64; 4],
    /// `R w` \[m/s\] and `R^2/I` \[1/kg\].
    pub(super) spin: [f64; 4],
}

/// One number of four contacts.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C, align(32))]
pub(super) struct Quad(pub(super) [f64; 4]);

impl Quad {
    #[inline(always)]
    pub(super) fn splat(x: f64) -> Self {
        Self([x; 4])
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let Self([a, b, c, d]) = self;
        Self([f(a), f(b), f(c), f(d)])
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let (Self([a, b, c, d]), Self([p, q, r, s])) = (self, other);
        Self([f(a, p), f(b, q), f(c, r), f(d, s)])
    }

    #[inline(always)]
    fn all(self, other: Self, f: impl Fn(f64, f64) -> bool) -> bool {
        let (Self([a, b, c, d]), Self([p, q, r, s])) = (self, other);
        f(a, p) & f(b, q) & f(c, r) & f(d, s)
    }

    #[inline(always)]
    pub(super) fn sum(self) -> f64 {
        let Self([a, b, c, d]) = self;
        (a + b) + (c + d)
    }
}

impl std::ops::Add for Quad {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl std::ops::Sub for Quad {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl std::ops::Mul for Quad {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

/// A vector of four contacts.
pub(super) type Quad3 = [Quad; 3];

#[inline(always)]
fn dot(a: Quad3, b: Quad3) -> Quad {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross(a: Quad3, b: Quad3) -> Quad3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[inline(always)]
fn each(f: impl Fn(usize) -> Quad) -> Quad3 {
    [f(0), f(1), f(2)]
}

/// Four contacts without a common moving body; lanes without a contact have zeros and bodies that nothing moves.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Block {
    /// Bodies A and B.
    pub(super) bodies: [[u32; 4]; 2],
    /// The rows, or [`super::kernel::NONE`].
    pub(super) rows: [u32; 4],
    /// Normals.
    pub(super) normal: Quad3,
    /// Impulses after the last sweep \[N s\].
    pub(super) impulse: Quad3,
    /// Impulses after the last but one.
    pub(super) previous: Quad3,
    /// Biases with the ground's velocity \[m/s\].
    pub(super) bias: Quad3,
    /// Friction coefficients.
    pub(super) friction: Quad,
    /// `1/w_n` and `1/w_t` \[kg\]; zero where nothing moves.
    pub(super) mass: [Quad; 2],
    /// Corrections that the tolerances of gap and (squared) slip allow \[N s\].
    pub(super) allowed: [Quad; 2],
    /// Squared scale of the force residual \[N^2 s^2\].
    pub(super) scale: Quad,
}

/// How a sweep goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    /// Share of the last sweep's change by which a contact's impulse is moved before it is solved.
    pub(super) momentum: f64,
    /// Share of a contact's correction that is applied.
    pub(super) damping: f64,
    /// Share of the tolerances that counts as settled.
    pub(super) strictness: f64,
    /// Tolerance of the force residual.
    pub(super) force: f64,
}

/// What a sweep saw.
#[derive(Debug, Clone, Copy)]
pub(super) struct Progress {
    /// Whether every contact was within the tolerances when its turn came.
    pub(super) settled: bool,
    /// Corrections times changes of the impulses: negative where momentum leads astray.
    pub(super) along: f64,
}

/// The bodies of four contacts.
struct Four {
    v: Quad3,
    mass: Quad,
    s: Quad3,
    spin_mass: Quad,
}

impl Four {
    #[inline(always)]
    fn load(bodies: &[Body], at: [u32; 4]) -> Self {
        let [p, q, r, s] = at.map(|i| &bodies[i as usize]);
        let linear = |k: usize| Quad([p.linear[k], q.linear[k], r.linear[k], s.linear[k]]);
        let spin = |k: usize| Quad([p.spin[k], q.spin[k], r.spin[k], s.spin[k]]);
        Self {
            v: each(linear),
            mass: linear(3),
            s: each(spin),
            spin_mass: spin(3),
        }
    }

    #[inline(always)]
    fn store(&self, bodies: &mut [Body], at: [u32; 4]) {
        for lane in 0..4 {
            bodies[at[lane] as usize] = Body {
                linear: [
                    self.v[0].0[lane],
                    self.v[1].0[lane],
                    self.v[2].0[lane],
                    self.mass.0[lane],
                ],
                spin: [
                    self.s[0].0[lane],
                    self.s[1].0[lane],
                    self.s[2].0[lane],
                    self.spin_mass.0[lane],
                ],
            };
        }
    }
}

/// One sweep over `blocks`.
pub(super) fn sweep(blocks: &mut [Block], bodies: &mut [Body], pace: Pace) -> Progress {
    let sweep = Sweep {
        blocks,
        bodies,
        pace,
    };
    #[cfg(target_arch = "x86_64")]
    if let Some(wide) = pulp::x86::V3::try_new() {
        return wide.vectorize(sweep);
    }
    pulp::NullaryFnOnce::call(sweep)
}

struct Sweep<'a> {
    blocks: &'a mut [Block],
    bodies: &'a mut [Body],
    pace: Pace,
}

impl pulp::NullaryFnOnce for Sweep<'_> {
    type Output = Progress;

    #[inline(always)]
    fn call(self) -> Progress {
        let mut progress = Progress {
            settled: true,
            along: 0.0,
        };
        let mut along = Quad::default();
        for block in self.blocks {
            let (settled, change) = block.update(self.bodies, &self.pace);
            progress.settled &= settled;
            along = along + change;
        }
        progress.along = along.sum();
        progress
    }
}

impl Block {
    #[inline(always)]
    fn update(&mut self, bodies: &mut [Body], pace: &Pace) -> (bool, Quad) {
        let n = self.normal;
        let old = self.impulse;
        let zero = Quad::default();
        let [mut a, mut b] = self.bodies.map(|at| Four::load(bodies, at));
        let turn = cross(each(|k| a.s[k] + b.s[k]), n);
        let u = each(|k| (a.v[k] - b.v[k] - turn[k]) + self.bias[k]);
        let momentum = Quad::splat(pace.momentum);
        let p = each(|k| old[k] + momentum * (old[k] - self.previous[k]));
        let (u_n, p_n) = (dot(u, n), dot(p, n));
        let [mass_n, mass_t] = self.mass;
        let free = p_n - u_n * mass_n;
        let normal = free.zip(zero, |a, b| if a > b { a } else { b });
        // Tangential part of p - u/w_t.
        let across = p_n - u_n * mass_t;
        let t = each(|k| p[k] - u[k] * mass_t - n[k] * across);
        let (tt, limit) = (dot(t, t), self.friction * normal);
        let cut = limit.zip(tt.map(f64::sqrt), |limit, length| limit / length);
        let sticks = |k: usize| tt.0[k] <= limit.0[k] * limit.0[k];
        let lane = |k: usize| if sticks(k) { 1.0 } else { cut.0[k] };
        let share = Quad([lane(0), lane(1), lane(2), lane(3)]);
        let d = each(|k| n[k] * normal + t[k] * share - p[k]);
        // Judged before damping.
        let (d_n, dd) = (normal - p_n, dot(d, d));
        let strict = Quad::splat(pace.strictness);
        let strict_force = Quad::splat(pace.strictness * pace.force);
        let size = normal * normal + tt * share * share;
        let size = size.zip(self.scale, |a, b| if a > b { a } else { b });
        let settled = d_n
            .map(f64::abs)
            .all(strict * self.allowed[0], |a, b| a <= b)
            & (dd - d_n * d_n).all(strict * strict * self.allowed[1], |a, b| a <= b)
            & dd.all(strict_force * strict_force * size, |a, b| a <= b);
        let damping = Quad::splat(pace.damping);
        let d = d.map(|d| d * damping);
        let new = each(|k| p[k] + d[k]);
        let along = dot(d, each(|k| new[k] - old[k]));
        self.previous = old;
        self.impulse = new;
        if !dd.all(zero, |a, b| a == b) {
            let c = cross(n, d);
            for k in 0..3 {
                a.v[k] = a.v[k] + a.mass * d[k];
                b.v[k] = b.v[k] - b.mass * d[k];
                a.s[k] = a.s[k] - a.spin_mass * c[k];
                b.s[k] = b.s[k] - b.spin_mass * c[k];
            }
            a.store(bodies, self.bodies[0]);
            b.store(bodies, self.bodies[1]);
        }
        (settled, along)
    }
}
