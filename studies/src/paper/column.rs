//! One sphere, and a stack of ten, at rest on a floor: augmentations and forces at a penalty that is held.
//!
//! The step's problem is the paper's: `shi`, multipliers from zero, no sweeps, `P` held. With `K = 2 m/dt^2` and the
//! contact modes of a stack of `n` (contact 1 is the floor)
//!
//! ```text
//! d_k(N) = d0 sum_j v_j(1) v_j(k) q_j^N           gap violation after N augmentations, d0 = g dt^2/2
//! q_j = 1/(1 + P/K l_j),  l_j = 2 - 2 cos t_j,  t_j = (2 j - 1) pi/(2 n + 1)
//! v_j(k) = cos((k - 1/2) t_j) / sqrt((2 n + 1)/4)
//! ```
//!
//! For `n = 1`: `l = 1`, `q = K/(K + P)`. The slowest mode `j = 1` decides: `N = ln(tol/a)/ln q_1`, with `a` its share of
//! the residual at the start. Residuals as the solver has them: gap `d_k/R`, force `K d_k/w_k/F_k` with `w_1 = 1` on the
//! floor, `w_k = 2` between spheres, `F_k = (n + 1 - k) m g`.

use std::f64::consts::PI;
use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::error::StepError;
use sphere_dda::problem::{GROUND, Problem};
use sphere_dda::scene::{Method, Scene};
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::augmented_lagrangian::SolverWorkspace;
use sphere_dda::solver::{Params, SMOOTHING, solve};
use sphere_dda::solver::{SolverKind, Tolerance};

use super::stepping::Example;
use crate::error::ReportError;

/// Factors on the paper's penalty.
pub const FACTORS: [f64; 5] = [0.01, 0.1, 1.0, 10.0, 100.0];
/// Tolerance of both counts \[-\].
pub const TOLERANCE: f64 = 1e-6;
/// Gravity of the examples \[m/s^2\].
const G: f64 = 9.81;

/// A stack of equal spheres with an example's numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// Number of spheres.
    pub spheres: usize,
    /// Radius \[m\].
    pub radius: f64,
    /// Density \[kg/m^3\].
    pub density: f64,
    /// Time step \[s\].
    pub step: f64,
    /// The paper's penalty \[N/m\].
    pub penalty: f64,
}

/// What the paper's loop took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Counted {
    /// Augmentations to the gap tolerance.
    pub gap: u64,
    /// Augmentations to the force tolerance.
    pub force: u64,
    /// Largest error of a force against `k m g` \[-\] then.
    pub error: f64,
}

/// Which residual ends the loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// Gap violation over radius.
    Gap,
    /// Force residual over the contact's force.
    Force,
}

impl Column {
    /// With the numbers of an example; of its sizes the largest.
    ///
    /// # Errors
    /// As [`Example::scene`].
    pub fn of(example: Example, spheres: usize) -> Result<Self, ReportError> {
        let scene = example.scene()?;
        let radius = scene.particles.radius.iter().copied().fold(0.0, f64::max);
        Ok(Self {
            spheres,
            radius,
            density: scene.materials[0].density,
            step: scene.settings.step,
            penalty: scene.settings.penalty.unwrap_or(f64::NAN),
        })
    }

    /// Mass of a sphere \[kg\].
    #[must_use]
    pub fn mass(&self) -> f64 {
        4.0 / 3.0 * PI * self.density * self.radius.powi(3)
    }

    /// `K = 2 m/dt^2` \[N/m\].
    #[must_use]
    pub fn inertia_stiffness(&self) -> f64 {
        2.0 * self.mass() / (self.step * self.step)
    }

    /// Contraction `q` of the slowest mode at penalty `p` \[N/m\].
    #[must_use]
    pub fn contraction(&self, p: f64) -> f64 {
        let angle = PI / (2 * self.spheres + 1) as f64;
        1.0 / (1.0 + p / self.inertia_stiffness() * (2.0 - 2.0 * angle.cos()))
    }

    /// What a count at penalty `p` \[N/m\] costs, in seconds of one core as recorded.
    #[must_use]
    pub fn cost(&self, p: f64) -> f64 {
        1.4e-5 * self.predicted(p, Stop::Force)
    }

    /// `ln(tol/a)/ln q` of the slowest mode at penalty `p` \[N/m\]; not rounded.
    #[must_use]
    pub fn predicted(&self, p: f64, stop: Stop) -> f64 {
        let n = self.spheres;
        let angle = PI / (2 * n + 1) as f64;
        let norm = (2 * n + 1) as f64 / 4.0;
        let free = 0.5 * G * self.step * self.step;
        let mode = |k: usize| ((k as f64 - 0.5) * angle).cos();
        let share = |k: usize| {
            let violation = free * mode(1) * mode(k) / norm;
            match stop {
                Stop::Gap => violation / self.radius,
                // A gap d is a force K d/w, w = 1 on the floor and 2 between spheres, against that of the spheres above.
                Stop::Force => {
                    let w = if k == 1 { 1.0 } else { 2.0 };
                    let above = (n + 1 - k) as f64;
                    violation * self.inertia_stiffness() / w / (above * self.mass() * G)
                }
            }
        };
        let largest = (1..=n).map(share).fold(0.0, f64::max);
        (TOLERANCE / largest).ln() / self.contraction(p).ln()
    }

    /// The problem of its first step.
    ///
    /// # Errors
    /// What loading or starting it says.
    pub fn problem(&self) -> Result<Problem, ReportError> {
        let simulation = self.simulation(Method::Alm, self.penalty, 1.0)?;
        let problem = simulation.problem(self.step);
        Ok(problem.map_err(|error| self.failed(error))?.0)
    }

    /// Augmentations that the paper's loop takes at penalty `p` \[N/m\] until each residual is small.
    ///
    /// # Errors
    /// What loading or starting it says.
    pub fn counted(&self, p: f64) -> Result<Counted, ReportError> {
        let problem = self.problem()?;
        let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
        let held = Params {
            kind: SolverKind::Direct,
            tolerance: Tolerance::default(),
            accept: false,
            min_sweeps: 1,
            max_sweeps: 0,
            max_factorizations: usize::MAX,
            penalty: p,
            adapt_penalty: false,
            smoothing: 0,
        };
        // From where one residual is small the loop goes on as if it had not stopped. The slip tolerance stays: a tenth of
        // the tighter one of gap and slip is what the inner iteration settles to; nothing slips here.
        let mut go_on = |gap: f64, force: f64| -> u64 {
            let tolerance = Tolerance {
                gap,
                slip: TOLERANCE,
                force,
            };
            let params = Params { tolerance, ..held };
            solve(
                &problem,
                &params,
                &mut SolverWorkspace::default(),
                &mut impulses,
            )
            .augmentations as u64
        };
        let gap = go_on(TOLERANCE, f64::INFINITY);
        let force = gap + go_on(f64::INFINITY, TOLERANCE);
        Ok(Counted {
            gap,
            force,
            error: self.force_error(&problem, &impulses),
        })
    }

    /// Augmentations of the library's own loop, sweeps and adapted penalty, from zero multipliers and penalty `p` \[N/m\]
    /// to its default tolerances, and the largest error of a force against `k m g` \[-\].
    ///
    /// # Errors
    /// What loading or starting it says.
    pub fn adapted(&self, p: f64) -> Result<(u64, f64), ReportError> {
        let problem = self.problem()?;
        let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
        let params = Params {
            kind: SolverKind::Direct,
            tolerance: Tolerance::default(),
            accept: false,
            min_sweeps: 1,
            max_sweeps: 0,
            max_factorizations: 1000,
            penalty: p,
            adapt_penalty: true,
            smoothing: SMOOTHING,
        };
        let report = solve(
            &problem,
            &params,
            &mut SolverWorkspace::default(),
            &mut impulses,
        );
        let error = self.force_error(&problem, &impulses);
        Ok((report.augmentations as u64, error))
    }

    /// Overlap of the lowest contact over the radius \[-\] by the penalty method at rest, its closed form
    /// `n m g/P/R` first. Steps without memory of velocity, so long that inertia plays no part, lead there; `None`
    /// where the closed form is more than half a radius.
    ///
    /// # Errors
    /// What loading, starting or stepping it says.
    pub fn penalty_overlap(&self, p: f64) -> Result<(f64, Option<f64>), ReportError> {
        let closed = self.spheres as f64 * self.mass() * G / p / self.radius;
        if closed > 0.5 {
            return Ok((closed, None));
        }
        let mut simulation = self.simulation(Method::Penalty, p, 0.0)?;
        let long = 1e5 * (self.mass() / p).sqrt();
        simulation = self.with_step(&simulation, long)?;
        for _ in 0..4 {
            simulation
                .advance(long)
                .map_err(|error| self.failed(error))?;
        }
        let lowest = self.radius - simulation.kinematics().position[0].z;
        Ok((closed, Some(lowest / self.radius)))
    }

    fn failed(&self, error: StepError) -> ReportError {
        ReportError::Step {
            case: format!("stack of {}", self.spheres),
            error,
        }
    }

    fn simulation(&self, method: Method, p: f64, kept: f64) -> Result<Simulation, ReportError> {
        let Self {
            radius,
            density,
            step,
            ..
        } = self;
        let centres: Vec<String> = (0..self.spheres)
            .map(|k| format!("[0.0, 0.0, {:?}]", radius * (2 * k + 1) as f64))
            .collect();
        let text = format!(
            "title = \"Stack\"\n[simulation]\nduration = {step:?}\nstep = {step:?}\nfixed_step = true\nstrict = true\ntolerance = {{ gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }}\nintegrator = \"shi\"\n\
             solver = \"direct\"\npenalty = {p:?}\ndynamic_coefficient = {kept:?}\n\
             [[material]]\nname = \"rock\"\ndensity = {density:?}\n\
             [[spheres]]\nname = \"stack\"\nmaterial = \"rock\"\nradius = {radius:?}\npositions = [{}]\n\
             [[boundary]]\nname = \"floor\"\nmaterial = \"rock\"\n\
             faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }}]\n",
            centres.join(", ")
        );
        let mut scene = Scene::from_toml("stack", &text, Path::new(""))?.scene;
        scene.settings.method = method;
        Simulation::new(Arc::new(scene)).map_err(|error| self.failed(error))
    }

    fn with_step(&self, simulation: &Simulation, step: f64) -> Result<Simulation, ReportError> {
        let mut scene = Scene::clone(simulation.scene());
        scene.settings.step = step;
        scene.settings.communication_step = step;
        Simulation::new(Arc::new(scene)).map_err(|error| self.failed(error))
    }

    /// Largest error of a normal force against `(n - k) m g`, `k` being the number of spheres below the contact \[-\]; a
    /// missing contact counts as an error of 1.
    fn force_error(&self, problem: &Problem, impulses: &[Vec3]) -> f64 {
        let mut found = vec![0.0; self.spheres];
        for (row, p) in problem.rows.iter().zip(impulses) {
            // The floor's contact is below sphere 0, that of spheres a < b below sphere b.
            let below = if row.b == GROUND { 0 } else { row.b as usize };
            if let Some(found) = found.get_mut(below) {
                *found += p.dot(&row.normal) / self.step;
            }
        }
        let weight = self.mass() * G;
        let error = |(below, force): (usize, f64)| {
            (force / ((self.spheres - below) as f64 * weight) - 1.0).abs()
        };
        found.into_iter().enumerate().map(error).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `ln(1e-6)/ln(K/(K + P))` of the force, `ln(1e-6 R/(g dt^2/2))/ln(K/(K + P))` of the gap.
    #[test]
    fn one_sphere_has_the_textbook_count() {
        let column = Column::of(Example::Funnel, 1).expect("the example");
        let k = 2.0 * column.mass() / 1e-4;
        let q = k / (k + 1e5);
        assert!((column.contraction(1e5) - q).abs() < 1e-15);
        let force = 1e-6f64.ln() / q.ln();
        assert!((column.predicted(1e5, Stop::Force) - force).abs() < 1e-9);
        let gap = (1e-6 * 0.25 / (0.5 * G * 1e-4)).ln() / q.ln();
        assert!((column.predicted(1e5, Stop::Gap) - gap).abs() < 1e-9);
    }

    /// All modes together, against the matrix: after N updates the violations are (1 + P/K W)^-N d0 e_1, with W the
    /// chain's matrix. The slowest mode is what is left.
    #[test]
    fn the_slowest_mode_is_what_is_left_of_the_matrix_power() {
        let n = 10;
        let column = Column::of(Example::Slopes, n).expect("the example");
        let p = 1e9;
        let ratio = p / column.inertia_stiffness();
        let updates = column.predicted(p, Stop::Gap).floor() as usize;
        let mut d = vec![0.0; n];
        d[0] = 0.5 * G * column.step * column.step / column.radius;
        for _ in 0..updates {
            // Thomas' algorithm on 1 + ratio W: W = tridiag(-1, 2, -1) with 1 in the first place.
            let (mut diagonal, mut right) = (vec![1.0 + 2.0 * ratio; n], d.clone());
            diagonal[0] = 1.0 + ratio;
            for k in 1..n {
                let factor = -ratio / diagonal[k - 1];
                diagonal[k] += factor * ratio;
                right[k] -= factor * right[k - 1];
            }
            d[n - 1] = right[n - 1] / diagonal[n - 1];
            for k in (0..n - 1).rev() {
                d[k] = (right[k] + ratio * d[k + 1]) / diagonal[k];
            }
        }
        let largest = d.iter().copied().fold(0.0, f64::max);
        let next = largest * column.contraction(p);
        assert!(
            largest > TOLERANCE && next <= TOLERANCE * 1.001,
            "{largest:e}"
        );
    }

    /// Measured counts, pinned: one sphere and ten, P/100 to 100 P where that takes less than a second; each is the
    /// prediction rounded up, or one more where rounding decides.
    #[test]
    fn counts_are_the_predicted_ones() {
        let mut text = String::new();
        for (spheres, factors) in [(1, &FACTORS[..]), (10, &FACTORS[2..])] {
            let column = Column::of(Example::Funnel, spheres).expect("the example");
            for factor in factors {
                let p = factor * column.penalty;
                let counted = column.counted(p).expect("it ends");
                for (stop, count) in [(Stop::Gap, counted.gap), (Stop::Force, counted.force)] {
                    let predicted = column.predicted(p, stop);
                    let off = count as f64 - predicted;
                    assert!((-0.01..=1.01).contains(&off), "{count} {predicted}");
                    text += &format!("{spheres} at {factor} P, {stop:?}: {count}\n");
                }
            }
        }
        insta::assert_snapshot!(text, @r"
        1 at 0.01 P, Gap: 24815
        1 at 0.01 P, Force: 45219
        1 at 0.1 P, Gap: 2485
        1 at 0.1 P, Force: 4529
        1 at 1 P, Gap: 252
        1 at 1 P, Force: 459
        1 at 10 P, Gap: 29
        1 at 10 P, Force: 52
        1 at 100 P, Gap: 6
        1 at 100 P, Force: 10
        10 at 1 P, Gap: 8673
        10 at 1 P, Force: 14434
        10 at 10 P, Gap: 870
        10 at 10 P, Force: 1448
        10 at 100 P, Gap: 90
        10 at 100 P, Force: 150
        ");
    }

    #[test]
    fn the_penalty_method_overlaps_by_its_closed_form() {
        let column = Column::of(Example::Funnel, 10).expect("the example");
        let (closed, found) = column.penalty_overlap(1e7).expect("it runs");
        let found = found.expect("a small overlap");
        assert!((found / closed - 1.0).abs() < 1e-6, "{found} {closed}");
        assert_eq!(column.penalty_overlap(1e3).expect("no run").1, None);
    }
}
