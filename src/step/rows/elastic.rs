//! Contacts that give way, as rows of a step: the spring and damper of [`crate::contact::elasticity`], which cannot pull.
//!
//! A step that resolves a contact, `k dt^2 <= 0.04 m` at the overlap that its energy or its load will reach, takes the spring where it is at the
//! start of the step, which is the middle of the staggered velocities `u-` before and `u1` after, and the damper at their mean, but
//! for one so strong that it would turn the motion round in the step:
//!
//! ```text
//! p_n = dt (F(d) - D (a u- + (1 - a) u1) - b k dt (u1 - u-)) >= 0,    a = 1/2 min(1, m/(D dt)),   b = 1/12
//! p_t = dt (F_t - k_t dt u-_t - D_t (a u- + (1 - a) u1)_t - b k_t dt (u1 - u-)_t)
//! ```
//!
//! `F_t` is the shear force of the last step, cut where the contact has become less stiff; the share `b` of the acceleration makes
//! the period of a spring right to fourth order (Newmark 1959, Fox and Goodwin). All of it is of second order.
//!
//! In a longer step an impact is that of a rigid contact, by Newton's law, and what persists is a spring alone as it is after the
//! step, which is stable at any step:
//!
//! ```text
//! p_n = dt F(-g - dt u1),    p_t = dt (F_t - k_t dt u1_t)
//! ```
//!
//! with the tangent of `F` at a known overlap in the row; the step's passes bring that where the solution is (Newton's method).
//! So is every contact with the integrator of Shi, which has no restitution.
//!
//! `F` is what presses against the attraction of a contact that holds, `p_n` likewise. A neck that is pulled beyond its largest tension
//! weakens: a step that resolves it has its force as that of any spring; a longer one has no `p_n` there, and the passes take the
//! attraction itself down the curve, to the end of the step. That converges where the bodies hold the neck, which is more than its
//! slope asks for; else it parts.

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::forces::SpringState;
use crate::contact::neck::Neck;
use crate::contact::spring::{BondSpring, ContactSpring};
use crate::problem::law::split;

/// Largest `k dt^2/m` of a step that resolves a contact: 16 steps from touching to parting.
const RESOLVED: f64 = 0.04;
/// Share `b` of the acceleration.
const AHEAD: f64 = 1.0 / 12.0;
/// The same of a bond's couples, which a state keeps with it: so little that it damps nothing.
const LITTLE: f64 = 1e-3;
/// Reduced mass of a pair of spheres across the normal over that along it.
const ACROSS: f64 = 2.0 / 7.0;

/// A contact that gives way, in a step.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ElasticContact {
    spring: ContactSpring,
    dt: f64,
    /// Overlap \[m\] at the start of the step, or where the row has its tangent.
    overlap: f64,
    /// Shear stiffness \[N/m\]; infinite: rigid.
    shear: f64,
    /// Shear force \[N\] that does not depend on what the step does.
    held: Vec3,
    /// Time \[s\] in which it answers to loads: `sqrt(m/k)`.
    response: f64,
    /// What resolves it, if the step does.
    resolved: Option<Resolved>,
}

/// A contact that the step resolves.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Resolved {
    /// `D a` and `D (1 - a)` \[N s/m\], along and across the normal.
    damping: [[f64; 2]; 2],
    /// Stiffnesses \[N/m\] where energy and load lead, along and across the normal.
    reached: [f64; 2],
}

/// What a contact was and how it moves before the step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Before {
    /// Gap \[m\].
    pub(super) gap: f64,
    /// Relative velocity of the surfaces along the normal \[m/s\], negative where they approach, and across it.
    pub(super) velocity: (f64, Vec3),
    /// Force \[N\] that pressed it in the last step.
    pub(super) pressed: f64,
    /// Shear force \[N\] and stiffness \[N/m\] of its spring, if it had one.
    pub(super) shear: Option<(Vec3, f64)>,
}

/// Bias \[m/s\] and compliance \[m/(s N s)\] of a row, along and across the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Terms {
    pub(super) along: [f64; 2],
    pub(super) across: (Vec3, f64),
}

/// `force` \[N\], no longer than `most` \[N\].
fn within(force: Vec3, most: f64) -> Vec3 {
    let (size, most) = (force.norm(), most.max(0.0));
    match size > most {
        true => force * (most / size),
        false => force,
    }
}

impl ElasticContact {
    /// Of a pair of the reduced mass `mass` \[kg\] and the given damping ratio; a normal force \[N\] of the size of `load` is to be
    /// expected. `resolves`: whether the integrator takes springs where they are.
    pub(super) fn new(
        spring: ContactSpring,
        (mass, ratio): (f64, f64),
        before: &Before,
        (dt, resolves, load): (f64, bool, f64),
    ) -> Self {
        let overlap = (-before.gap).max(spring.least());
        let touches = -before.gap > spring.least();
        let pressed = spring.overlap(match before.pressed > 0.0 {
            true => before.pressed,
            false => load,
        });
        let short = |overlap: f64| spring.slope(overlap) * dt * dt <= RESOLVED * mass;
        // Of most contacts loads alone tell that they are too stiff.
        let reached = match resolves && short(pressed) {
            true => {
                let energy = 0.5 * mass * before.velocity.0.powi(2) + spring.energy(overlap);
                spring.reach(energy).max(pressed)
            }
            false => pressed,
        };
        let stiffness = spring.slope(reached);
        let resolved = (resolves && short(reached)).then(|| Resolved {
            damping: match touches {
                true => {
                    let across = ACROSS * mass;
                    let stiffness = finite(spring.shear(overlap));
                    let along = shares(spring.damping(ratio, mass, overlap), mass, dt);
                    [
                        along,
                        shares(2.0 * ratio * (across * stiffness).sqrt(), across, dt),
                    ]
                }
                false => [[0.0; 2]; 2],
            },
            reached: [stiffness, spring.shear(reached)],
        });
        let overlap = match resolved {
            Some(_) => overlap,
            None => pressed,
        };
        let shear = spring.shear(overlap);
        let mut held = before.carried(shear);
        if resolved.is_some() && shear.is_finite() {
            held -= before.velocity.1 * (shear * before.touching(overlap, dt));
        }
        Self {
            spring,
            dt,
            overlap,
            shear,
            held,
            response: (mass / stiffness).sqrt(),
            resolved,
        }
    }

    /// Speed \[m/s\] up to which it swings under loads of this acceleration \[m/s^2\], and twice that of a step: what is slower is no
    /// impact.
    pub(super) fn swing(&self, loading: f64) -> f64 {
        2.0 * loading * self.response.max(self.dt)
    }

    /// Whether it is no impact at a gap \[m\], however fast: the step resolves it, or its surfaces are still held together.
    pub(super) fn is_never_impact(&self, gap: f64) -> bool {
        self.is_resolved() || self.bond().is_some() || self.neck().is_some() && gap > 0.0
    }

    /// Whether the step resolves it.
    pub(crate) fn is_resolved(&self) -> bool {
        self.resolved.is_some()
    }

    /// Energy \[J\] stored along the normal at a gap \[m\] where `hold` holds it.
    pub(crate) fn energy(&self, gap: f64, hold: Hold) -> f64 {
        let own = || self.spring.own_energy((-gap).max(0.0));
        match (hold, self.spring.curve(), self.spring.bond()) {
            (Hold::Attached, Some(neck), _) => neck.stored(-gap),
            (Hold::Bonded { .. }, _, Some(bond)) => own() + bond.energy(-gap),
            _ => own(),
        }
    }

    /// The neck that it has in this step.
    pub(crate) fn neck(&self) -> Option<&Neck> {
        self.spring.neck()
    }

    /// The bond that it has in this step.
    pub(crate) fn bond(&self) -> Option<&BondSpring> {
        self.spring.bond()
    }

    /// Overlap \[m\] down to which it adheres.
    pub(crate) fn fold(&self) -> Option<f64> {
        self.spring.curve().map(Neck::fold)
    }

    /// Attraction \[N\] of a neck at a gap \[m\]: its pull-off force, but for what `p_n` lacks of it in a step that does not resolve it.
    pub(crate) fn attraction(&self, gap: f64) -> Option<f64> {
        let neck = self.neck()?;
        Some(match (-gap > neck.fold(), -gap < neck.tensest()) {
            (false, _) => 0.0,
            (true, true) if !self.is_resolved() => neck.pull_off() - neck.force(-gap),
            (true, _) => neck.pull_off(),
        })
    }

    /// What its spring goes on with after a step in which the surfaces slip at `slip` \[m/s\] and friction bears `most` \[N\].
    pub(crate) fn state_after(&self, slip: Vec3, most: f64) -> SpringState {
        let stiffness = self.shear;
        let stretched = match (self.resolved, stiffness.is_finite()) {
            (_, false) => Vec3::zeros(),
            (Some(_), true) => self.held,
            (None, true) => self.held - slip * (stiffness * self.dt),
        };
        SpringState::Stretched {
            shear: within(stretched, most),
            stiffness,
        }
    }

    /// What is left of [`Self::state_after`] where the bond breaks: what its own law holds of the stretch, up to `most` \[N\].
    pub(crate) fn state_unbound(&self, whole: SpringState, most: f64) -> SpringState {
        let SpringState::Stretched { shear, stiffness } = whole else {
            return whole;
        };
        let own = self.spring.own_shear(self.overlap);
        let share = if own < stiffness {
            own / stiffness
        } else {
            1.0
        };
        SpringState::Stretched {
            shear: within(shear * share, most),
            stiffness: own,
        }
    }

    /// Energy \[J\] that its damper across the normal takes in a step that begins and ends with these slips \[m/s\].
    pub(crate) fn damped_across(&self, [before, after]: [Vec3; 2]) -> f64 {
        let taken = |resolved: &Resolved| {
            let [early, late] = resolved.damping[1];
            self.dt * (before * early + after * late).dot(&after)
        };
        self.resolved.as_ref().map_or(0.0, taken)
    }

    /// Terms of the row of a bond's couples, over the lever `R_b`: `held` \[N\] is what they were, `turning` \[m/s\] what turned it in
    /// the step before. Along the normal it is twisted, across it bent.
    pub(super) fn couple(
        &self,
        bond: &BondSpring,
        n: Vec3,
        (held, turning): (Vec3, Vec3),
    ) -> Terms {
        let [bent, twisted] = bond.turning();
        let terms = |stiffness: f64, held: Vec3, turning: Vec3| match self.is_resolved() {
            true => {
                let ahead = LITTLE * stiffness * self.dt;
                let force = held - turning * (stiffness * self.dt - ahead);
                (force * (-1.0 / ahead), 1.0 / (ahead * self.dt))
            }
            false => (
                held * (-1.0 / (stiffness * self.dt)),
                self.compliance(stiffness),
            ),
        };
        let [(held_n, held_t), (turning_n, turning_t)] = [held, turning].map(|x| split(x, n));
        let (along, compliance) = terms(twisted, n * held_n, n * turning_n);
        Terms {
            along: [along.dot(&n), compliance],
            across: terms(bent, held_t, turning_t),
        }
    }

    /// Energy \[J\] that a bond's couples have stored, over the lever `R_b` \[N\].
    pub(crate) fn turned(bond: &BondSpring, n: Vec3, couple: Vec3) -> f64 {
        let [bent, twisted] = bond.turning();
        let (along, across) = split(couple, n);
        0.5 * (along * along / twisted + across.norm_squared() / bent)
    }

    /// Energy \[J\] that its dampers take in a step that begins and ends with these relative velocities along the normal \[m/s\].
    pub(crate) fn damped(&self, speeds: impl FnOnce() -> [f64; 2]) -> f64 {
        let taken = |resolved: &Resolved| {
            let ([early, late], [before, after]) = (resolved.damping[0], speeds());
            self.dt * (early * before + late * after) * after
        };
        self.resolved.as_ref().map_or(0.0, taken)
    }

    /// By how much \[m\] a `gap` \[m\] differs from that at which the spring has a normal force \[N\] beside an attraction \[N\].
    pub(crate) fn error(&self, gap: f64, force: f64, attraction: f64) -> f64 {
        let Some((neck, wanted)) = self.neck().zip(self.attraction(gap)) else {
            return gap + self.spring.overlap(force.max(0.0));
        };
        let missed = (attraction - wanted) / neck.stiffness();
        match force > 0.0 || -gap > neck.tensest() {
            true => gap + neck.overlap(force.max(0.0)) + missed,
            false => missed,
        }
    }

    /// Takes the tangent at the normal force \[N\] that a solution has, or at its `gap` \[m\] where it has none.
    pub(crate) fn follow(&mut self, force: f64, gap: f64) {
        let least = match self.neck() {
            Some(neck) => neck.overlap(0.0),
            None => self.spring.least().max(0.0),
        };
        if force > 0.0 {
            self.overlap = self.spring.overlap(force);
        } else if -gap > least {
            self.overlap = -gap;
        }
    }

    /// Along the normal at a `gap` \[m\] of the start of a step that does not resolve it: bias and compliance.
    pub(crate) fn along(&self, gap: f64) -> [f64; 2] {
        let compliance = self.compliance(self.spring.slope(self.overlap));
        let free = gap + self.spring.intercept(self.overlap);
        [free / self.dt, compliance]
    }

    /// Compliance \[m/(s N s)\] of a stiffness \[N/m\].
    fn compliance(&self, stiffness: f64) -> f64 {
        1.0 / (stiffness * (self.dt * self.dt))
    }

    /// Its row.
    pub(super) fn terms(&self, before: &Before) -> Terms {
        let shear = self.shear;
        let Some(resolved) = self.resolved else {
            return Terms {
                along: self.along(before.gap),
                across: match shear.is_finite() {
                    true => (
                        self.held * (-1.0 / (shear * self.dt)),
                        self.compliance(shear),
                    ),
                    false => (Vec3::zeros(), 0.0),
                },
            };
        };
        let (speed, slip) = before.velocity;
        let [ahead, ahead_t] = resolved.reached.map(|k| AHEAD * k * self.dt);
        let [[early, late], [early_t, late_t]] = resolved.damping;
        let force = match -before.gap > self.spring.least() {
            true => self.spring.force(self.overlap),
            // Nothing acts yet, whatever the other contacts of the step do but for a push through all of the gap.
            false => -resolved.reached[0] * before.gap,
        };
        let weight = ahead + late;
        let along = [
            -(force + (ahead - early) * speed) / weight,
            1.0 / (weight * self.dt),
        ];
        let across = match shear.is_finite() {
            true => {
                let weight = ahead_t + late_t;
                let force = self.held + slip * (ahead_t - early_t);
                (force * (-1.0 / weight), 1.0 / (weight * self.dt))
            }
            false => (Vec3::zeros(), 0.0),
        };
        Terms { along, across }
    }
}

impl Before {
    /// Shear force \[N\] that goes on from the last step: where the contact is less stiff than it was, its stretch does.
    fn carried(&self, stiffness: f64) -> Vec3 {
        match self.shear {
            Some((force, was)) if was.is_finite() => force * (stiffness / was).min(1.0),
            _ => Vec3::zeros(),
        }
    }

    /// Time \[s\] of the step before for which the surfaces have touched.
    fn touching(&self, overlap: f64, dt: f64) -> f64 {
        let (speed, _) = self.velocity;
        match self.pressed > 0.0 || speed >= 0.0 {
            true => dt,
            false => (overlap / -speed).min(dt),
        }
    }
}

/// Shares of a damper \[N s/m\] for the velocities before and after a step of a mass \[kg\].
fn shares(damping: f64, mass: f64, dt: f64) -> [f64; 2] {
    let early = 0.5 * damping.min(mass / dt);
    [early, damping - early]
}

/// A stiffness that a damper can go with: none beside a rigid one.
fn finite(stiffness: f64) -> f64 {
    if stiffness.is_finite() {
        stiffness
    } else {
        0.0
    }
}
