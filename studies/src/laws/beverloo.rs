//! Beverloo's law: the rate through an orifice does not know the height of the bed.
//!
//! ```text
//! rate = C rho_b sqrt(g) (D - k d)^(5/2)
//! ```
//!
//! for what flows: below five grains orifices jam now and then. `D` orifice, `d` grain \[m\]; `C` about 0.58, `k` about 1.4 for
//! spheres. Sources: W. A. Beverloo, H. A. Leniger, J. van de Velde, *The flow of granular solids through orifices*, Chemical
//! Engineering Science 15 (1961); `k` for spheres: R. M. Nedderman, *Statics and Kinematics of Granular Materials* (1992); jams:
//! I. Zuriguel, A. Garcimartin, D. Maza, L. A. Pugnaloni, J. M. Pastor, *Jamming during the discharge of granular matter from a
//! silo*, Physical Review E 71 (2005).

use std::fmt::Write as _;

use sphere_dda::scene::particles::Kinematics;

use super::bed::{self, Cost, Friction, G, GRAIN, Run};
use super::fit::{self, Line};
use crate::Watch;
use crate::error::ReportError;

/// `k` for spheres.
const SHAPE: f64 = 1.4;
/// Orifices over the mean grain.
const ORIFICES: [f64; 5] = [4.0, 5.0, 6.0, 8.0, 10.0];
/// Diameter of the bin \[m\].
const BIN: f64 = 0.18;
/// Friction coefficient of everything.
const FRICTION: Friction = Friction::sliding(0.5);
/// Number of grains.
const COUNT: usize = 4500;
/// Packings, each of which flows through every orifice: rates of few grains fluctuate.
pub(super) const PACKINGS: u64 = 3;
/// Filling, then the longest outflow \[s\].
const TIMES: [f64; 2] = [0.7, 2.0];
/// When the flow counts as established \[s\], and the share of the grains at which the measurement ends.
const BEGUN: f64 = 0.2;
const SHARE: f64 = 0.45;
/// Time without a grain after which an orifice has jammed \[s\]: the smallest lets 20 grains out in it.
const JAM: f64 = 0.1;
/// Corners of the orifice.
const CORNERS: usize = 48;

/// Outflow of one bin.
#[derive(Debug, Clone, PartialEq)]
pub struct Flow {
    /// Rate \[kg/s\].
    pub rate: f64,
    /// Rates of the first and of the second half of the measurement \[kg/s\].
    pub halves: [f64; 2],
    /// Time \[s\] and mass that has left \[kg\].
    pub history: Vec<(f64, f64)>,
    /// Whether an arch stopped it.
    pub jammed: bool,
}

/// Outflow through one orifice.
#[derive(Debug, Clone, PartialEq)]
pub struct Outflow {
    /// Diameter over the mean grain.
    pub orifice: f64,
    /// By packing.
    pub flows: Vec<Flow>,
}

/// What was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Beverloo {
    /// By orifice.
    pub outflows: Vec<Outflow>,
    /// Bulk density of the bed at rest \[kg/m^3\].
    pub bulk_density: f64,
    /// Exponent of `rate ~ (D - k d)^n`.
    pub exponent: f64,
    /// `C` for the exponent 5/2.
    pub coefficient: f64,
}

impl Outflow {
    /// `D - k d` \[m\].
    #[must_use]
    pub fn effective(&self) -> f64 {
        (self.orifice - SHAPE) * GRAIN
    }

    /// How many jammed.
    #[must_use]
    pub fn jams(&self) -> usize {
        self.flows.iter().filter(|flow| flow.jammed).count()
    }

    /// Those that did not.
    fn flowing(&self) -> impl Iterator<Item = &Flow> + Clone {
        self.flows.iter().filter(|flow| !flow.jammed)
    }

    /// Mean rate of what did not jam, and its standard error \[kg/s\].
    #[must_use]
    pub fn rate(&self) -> [f64; 2] {
        fit::mean(self.flowing().map(|flow| flow.rate))
    }

    /// Likewise of the first and of the second half of the measurement \[kg/s\].
    #[must_use]
    pub fn halves(&self) -> [f64; 2] {
        [0, 1].map(|half| fit::mean(self.flowing().map(|flow| flow.halves[half]))[0])
    }
}

/// What a filling costs.
pub(super) const FILLING: Cost = Cost {
    cases: PACKINGS as usize,
    seconds: 0.8,
    simulated: 0.7,
};

/// What an outflow costs.
pub(super) const OUTFLOW: Cost = Cost {
    cases: ORIFICES.len() * PACKINGS as usize,
    seconds: 2.3,
    simulated: 1.3,
};

/// Fills bins, then opens every orifice in each.
///
/// # Errors
/// What a run says.
pub fn run(share: f64, threads: usize, watch: &dyn Watch) -> Result<Beverloo, ReportError> {
    let count = (share * COUNT as f64) as usize;
    let fill = |(), packing| filled(count, packing, watch);
    let bins = bed::by_packing(threads, &[()], PACKINGS, fill)?.concat();
    let bulk_density = fit::mean(bins.iter().map(|bin| bin.0))[0];
    let flows = bed::by_packing(threads, &ORIFICES, PACKINGS, |orifice, packing| {
        let (_, full) = &bins[packing as usize - 1];
        outflow((count, packing), orifice, full, watch)
    })?;
    let outflows = ORIFICES.into_iter().zip(flows);
    let outflows: Vec<Outflow> = outflows
        .map(|(orifice, flows)| Outflow { orifice, flows })
        .collect();
    let points = outflows.iter().map(|o| (o.effective(), o.rate()[0]));
    let points: Vec<(f64, f64)> = points.collect();
    let scale = |x: f64| bulk_density * G.sqrt() * x.powf(2.5);
    let coefficient = points.iter().map(|p| p.1 / scale(p.0)).sum::<f64>() / points.len() as f64;
    Ok(Beverloo {
        exponent: Line::power(&points).slope,
        outflows,
        bulk_density,
        coefficient,
    })
}

/// A bin at rest: bulk density \[kg/m^3\], and where its grains are.
fn filled(count: usize, packing: u64, watch: &dyn Watch) -> Result<(f64, Kinematics), ReportError> {
    let name = format!("Beverloo, filling, packing {packing}");
    let run = Run::new(&name, watch, FILLING);
    let scene = bed::scene("beverloo.toml", &text((count, packing), None))?;
    let mut bin = run.begin(scene)?;
    run.wait(&mut bin, TIMES[0])?;
    Ok((density(bed::places(&bin)), bed::at_rest(&bin)))
}

/// The bin, closed or with an orifice of diameter `open` \[m\].
fn text((count, packing): (usize, u64), open: Option<f64>) -> String {
    let radius = 0.5 * BIN;
    let floor = match open {
        None => "{ rectangle = { corner = [-0.12, -0.12, 0.0], u = [0.24, 0.0, 0.0], v = [0.0, 0.24, 0.0] } }".to_owned(),
        Some(open) => ring(open, 1.2 * BIN),
    };
    bed::head("Beverloo", bed::G, FRICTION, FRICTION)
        + &bed::grains(
            &format!(
                "{{ cylinder = {{ base = [0.0, 0.0, 0.0], radius = {radius}, height = 0.27 }} }}"
            ),
            count,
            packing,
        )
        + &bed::boundary(
            "bin",
            &format!(
                "{{ cylinder = {{ base = [0.0, 0.0, 0.0], radius = {radius}, height = 0.35 }} }}"
            ),
            "",
        )
        + &bed::boundary("floor", &floor, "")
        + "[[sink]]\nname = \"below\"\nregion = { beyond = { point = [0.0, 0.0, -0.05], normal = [0.0, 0.0, -1.0] } }\n"
}

/// A flat floor between a polygon of the orifice's area and one that reaches `outer` \[m\].
fn ring(open: f64, outer: f64) -> String {
    let sector = std::f64::consts::TAU / CORNERS as f64;
    let inner = 0.5 * open * (sector / sector.sin()).sqrt();
    let corner = |r: f64, k: usize| {
        let (s, c) = (sector * k as f64).sin_cos();
        format!("[{:e}, {:e}, 0.0]", r * c, r * s)
    };
    let mut faces = String::new();
    for k in 0..CORNERS {
        let next = (k + 1) % CORNERS;
        let corners = [
            (inner, k),
            (0.5 * outer, k),
            (0.5 * outer, next),
            (inner, next),
        ];
        let corners = corners.map(|(r, k)| corner(r, k)).join(", ");
        let _ = write!(faces, "{{ polygon = [{corners}] }}, ");
    }
    faces
}

fn outflow(
    grains: (usize, u64),
    orifice: f64,
    full: &Kinematics,
    watch: &dyn Watch,
) -> Result<Flow, ReportError> {
    let name = format!(
        "Beverloo, orifice of {orifice} grains, packing {}",
        grains.1
    );
    let run = Run::new(&name, watch, OUTFLOW);
    let mut scene = bed::scene("beverloo.toml", &text(grains, Some(orifice * GRAIN)))?;
    scene.initial = full.clone();
    let mut bin = run.begin(scene)?;
    let mass = |bin: &_| {
        bed::places(bin)
            .filter(|(x, _)| x.z > 0.0)
            .map(|(_, m)| m)
            .sum::<f64>()
    };
    let all = mass(&bin);
    let mut history = Vec::new();
    run.advance(&mut bin, TIMES[1], |bin| {
        let left = all - mass(bin);
        history.push((bin.time(), left));
        Ok(left < SHARE * all && !jammed(&history))
    })?;
    let jammed = jammed(&history);
    let established: Vec<(f64, f64)> = history.iter().copied().filter(|p| p.0 >= BEGUN).collect();
    let rate = |points: &[(f64, f64)]| Line::through(points).slope;
    let (first, second) = established.split_at(established.len() / 2);
    let end = if jammed { ", then jammed" } else { "" };
    watch.note(&format!("{name}: {:.3} kg/s{end}", rate(&established)));
    Ok(Flow {
        rate: rate(&established),
        halves: [rate(first), rate(second)],
        history,
        jammed,
    })
}

/// Whether no mass has left for [`JAM`] at the end of a history.
fn jammed(history: &[(f64, f64)]) -> bool {
    history.last().is_some_and(|&(now, left)| {
        let mut before = history.iter().rev();
        before
            .find(|point| now - point.0 > JAM)
            .is_some_and(|point| point.1 >= left)
    })
}

/// Bulk density \[kg/m^3\] of the middle half of the bed.
fn density(places: impl Iterator<Item = (sphere_dda::Vec3, f64)>) -> f64 {
    let mut places: Vec<(f64, f64)> = places.map(|(x, m)| (x.z, m)).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let middle = &places[places.len() / 4..3 * places.len() / 4];
    let mass: f64 = middle.iter().map(|p| p.1).sum();
    let height = middle.last().map_or(0.0, |p| p.0) - middle.first().map_or(0.0, |p| p.0);
    mass / (height * 0.25 * std::f64::consts::PI * BIN * BIN)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grain every 10 ms until `end`: a jam is told once the last one is more than [`JAM`] old, and not before.
    #[test]
    fn a_jam_is_a_time_without_a_grain() {
        let until = |now: usize, end: usize| -> Vec<(f64, f64)> {
            let point = |k: usize| (0.01 * k as f64, 0.1 * k.min(end) as f64);
            (1..=now).map(point).collect()
        };
        assert!(!jammed(&[]));
        assert!(!jammed(&until(3, 0)));
        assert!(!jammed(&until(40, 40)));
        assert!(!jammed(&until(49, 40)));
        assert!(jammed(&until(52, 40)));
        assert!(jammed(&until(13, 0)));
    }
}
