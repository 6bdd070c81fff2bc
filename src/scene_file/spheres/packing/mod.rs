//! Random packings: so many spheres, so much mass or so much of the volume, without overlap.

mod free_space;
mod relaxation;

use rand_chacha::ChaCha8Rng;

use super::{MOST_SPHERES, Present};
use crate::Vec3;
use crate::geometry::region::Region;
use crate::scene_file::document::Document;
use crate::scene_file::file;
use crate::scene_file::regions::filled;
use free_space::FreeSpace;
use relaxation::{Bed, Jam};

/// Densest packing of equal spheres, pi / sqrt(18): no random packing comes near it.
const DENSEST: f64 = 0.7405;

/// How many spheres are asked for.
#[derive(Clone, Copy)]
enum Amount {
    Count(usize),
    /// Mass \[kg\].
    Mass(f64),
    /// Share of the region's volume \[-\].
    SolidFraction(f64),
}

/// A checked `packing`.
pub(super) struct Task {
    path: String,
    region: Region,
    amount: Amount,
}

impl Task {
    /// Checks the keys.
    pub(super) fn new(
        document: &mut Document<'_>,
        path: &str,
        given: &file::Packing,
    ) -> Option<Self> {
        let key = format!("{path}.region");
        let region = filled(document, &key, &given.region);
        let amount = match (given.count, given.mass, given.solid_fraction) {
            (Some(count), None, None) => {
                let key = format!("{path}.count");
                let in_range = (1..=MOST_SPHERES).contains(&(count as usize));
                let expected = format!("1 to {MOST_SPHERES} spheres");
                document
                    .demand(in_range, key, count, &expected)
                    .then_some(Amount::Count(count as usize))
            }
            (None, Some(mass), None) => document
                .positive((path, "mass"), mass, "a mass > 0 [kg]")
                .then_some(Amount::Mass(mass)),
            (None, None, Some(fraction)) => {
                let in_range = fraction > 0.0 && fraction < DENSEST;
                let key = format!("{path}.solid_fraction");
                let expected = "a share > 0 and below 0.74, the densest packing of equal spheres; \
                                random packings reach about 0.6";
                document
                    .demand(in_range, key, fraction, expected)
                    .then_some(Amount::SolidFraction(fraction))
            }
            (count, mass, fraction) => {
                let given = [count.is_some(), mass.is_some(), fraction.is_some()];
                let number = given.into_iter().filter(|is| *is).count();
                let message =
                    format!("found {number} of count, mass, solid_fraction, expected one");
                document.reject(path, message, "say once how much is packed")
            }
        };
        Some(Self {
            path: path.to_owned(),
            region: region?,
            amount: amount?,
        })
    }

    /// Draws radii \[m\] until the amount is reached; spheres of `density` \[kg/m^3\].
    pub(super) fn radii(
        &self,
        document: &mut Document<'_>,
        mut draw: impl FnMut(&mut ChaCha8Rng) -> f64,
        density: f64,
        random: &mut ChaCha8Rng,
    ) -> Option<Vec<f64>> {
        let path = self.path.as_str();
        let region = self.region.volume();
        let (most, budget) = match self.amount {
            Amount::Count(count) => (count, f64::INFINITY),
            Amount::Mass(mass) => (usize::MAX, mass / density),
            Amount::SolidFraction(fraction) => (usize::MAX, fraction * region),
        };
        let (mut radii, mut filled) = (Vec::new(), 0.0);
        while radii.len() < most {
            let radius = draw(random);
            let next = filled + volume(radius);
            if next > budget {
                break;
            }
            if next > DENSEST * region {
                let found = format!("more than {next:.4e} m^3 of spheres");
                let expected = format!(
                    "at most 0.74 of the region's {region:.4e} m^3; random packings reach about 0.6"
                );
                return document.refuse(path, found, &expected);
            }
            if radii.len() == MOST_SPHERES {
                let expected =
                    format!("at most {MOST_SPHERES} spheres: ask for less, or for larger ones");
                return document.refuse(path, "more", &expected);
            }
            filled = next;
            radii.push(radius);
        }
        if radii.is_empty() {
            let found = format!("room for {budget:.4e} m^3 of spheres, less than the first one");
            let help = "ask for more, or for smaller spheres";
            return document.reject(
                path,
                format!("found {found}, expected at least one sphere"),
                help,
            );
        }
        Some(radii)
    }

    /// Centres \[m\] of spheres with these radii \[m\].
    pub(super) fn places(
        &self,
        document: &mut Document<'_>,
        radii: &[f64],
        present: &Present<'_>,
        random: &mut ChaCha8Rng,
    ) -> Option<Vec<Vec3>> {
        // Without all of its boundaries the free space is another one; what is wrong with them is reported already.
        let room = FreeSpace::new(&self.region, present.boundaries?, present.cell)?;
        let obstacles = room.obstacles(present.particles, present.initial);
        match Bed::drop(&room, radii, &obstacles, random).and_then(|bed| bed.relax(&room)) {
            Ok(places) => Some(places),
            Err(Jam::NoPlace { radius }) => {
                let message = format!("found no place for a sphere of radius {radius} m");
                let help = "enlarge the region, or move it out of the boundaries; spheres lie wholly inside it";
                document.reject(self.path.as_str(), message, help)
            }
            Err(Jam::Full { packed }) => {
                let whole: f64 = packed.iter().map(|&k| volume(radii[k])).sum();
                let fraction = whole / self.region.volume();
                let message = format!(
                    "packed {} of {} spheres, a solid fraction of {fraction:.3} in the region",
                    packed.len(),
                    radii.len()
                );
                let help = format!(
                    "enlarge the region, or ask for about {} spheres or solid_fraction = {:.2}; what boundaries \
                     and earlier groups take of the region is not free",
                    packed.len(),
                    (100.0 * fraction).floor() / 100.0
                );
                document.reject(self.path.as_str(), message, help)
            }
        }
    }
}

/// Volume of a sphere \[m^3\].
fn volume(radius: f64) -> f64 {
    4.0 / 3.0 * std::f64::consts::PI * radius.powi(3)
}
