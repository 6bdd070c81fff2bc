//! How materials hold on to each other: `cohesion`, `surface_energy`, `rupture_distance` and `bond` of a pair.

use super::document::Document;
use super::file::{Adhesion, BondStrengths};
use crate::contact::cohesion::{Bond, Cohesion};
use crate::contact::elasticity::Elasticity;
use crate::scene::materials::Pair;

/// The keys of `[pair_default]` or a `[[pair]]`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Holding {
    pub(super) cohesion: Option<f64>,
    pub(super) surface_energy: Option<f64>,
    pub(super) adhesion: Option<Adhesion>,
    pub(super) rupture_distance: Option<f64>,
    pub(super) bond: Option<BondStrengths>,
}

impl Holding {
    /// `pair`, which has the default's, with what the table at `path` gives, checked. `penalty`: contacts are those of the penalty method.
    pub(super) fn over(
        self,
        document: &mut Document<'_>,
        path: &str,
        penalty: bool,
        mut pair: Pair,
    ) -> Pair {
        self.check(document, path, penalty);
        let own = match (self.cohesion, self.surface_energy, self.adhesion) {
            (Some(force), ..) => Some(Cohesion {
                force,
                ..Cohesion::default()
            }),
            (None, Some(energy), Some(Adhesion::Jkr)) => Some(Cohesion::jkr(energy)),
            (None, Some(energy), _) => Some(Cohesion::dmt(energy)),
            (None, None, _) => None,
        };
        let kept = pair.cohesion.map_or(0.0, |c| c.rupture_distance);
        pair.cohesion = own.or(pair.cohesion).map(|cohesion| Cohesion {
            rupture_distance: self.rupture_distance.unwrap_or(kept),
            ..cohesion
        });
        if self.rupture_distance.is_some() && pair.cohesion.is_none() {
            document.error(
                (path, "rupture_distance"),
                "found `rupture_distance` without a force that it ends",
                "give `cohesion` [N] or `surface_energy` [J/m^2] as well",
            );
        }
        let bond = self.bond.map(|bond| Bond {
            normal_strength: bond.normal_strength,
            shear_strength: bond.shear_strength,
            reach: bond.reach,
            young: bond.young,
        });
        pair.bond = bond.or(pair.bond);
        pair
    }

    fn check(&self, document: &mut Document<'_>, path: &str, penalty: bool) {
        let least = [
            ("cohesion", self.cohesion, "a force >= 0 [N]"),
            (
                "surface_energy",
                self.surface_energy,
                "an energy >= 0 [J/m^2]",
            ),
            (
                "rupture_distance",
                self.rupture_distance,
                "a distance >= 0 [m]",
            ),
        ];
        for (key, value, expected) in least {
            if let Some(value) = value {
                document.within((path, key), value, 0.0.., expected);
            }
        }
        if self.cohesion.is_some() && self.surface_energy.is_some() {
            document.error(
                (path, "surface_energy"),
                "found both `cohesion` and `surface_energy`, expected one of them",
                "`cohesion` is the pull-off force of every contact, `surface_energy` makes it grow with the radius",
            );
        }
        if self.adhesion.is_some() && self.surface_energy.is_none() {
            document.error(
                (path, "adhesion"),
                "found `adhesion` without `surface_energy`",
                "it says how a surface energy becomes a force: give `surface_energy` [J/m^2]",
            );
        }
        let Some(bond) = self.bond else { return };
        let strengths = [
            ("bond.normal_strength", bond.normal_strength),
            ("bond.shear_strength", bond.shear_strength),
        ];
        for (key, strength) in strengths {
            document.positive((path, key), strength, "a strength > 0 [Pa]");
        }
        document.within(
            (path, "bond.reach"),
            bond.reach,
            0.0..,
            "a distance >= 0 [m]",
        );
        if let Some(young) = bond.young {
            document.positive((path, "bond.young"), young, "young > 0 [Pa]");
        }
        if penalty {
            document.error(
                (path, "bond"),
                "found a bond with method = \"penalty\"",
                "its springs are no material's: remove the method, or the bond",
            );
        }
    }
}

/// What of a pair's whole law does not go together, from its two materials or its table: `key` and why, how to mend.
pub(super) fn clash(pair: &Pair) -> Option<(&'static str, &'static str, &'static str)> {
    let cohesion = pair.cohesion.filter(|cohesion| cohesion.jkr)?;
    match pair.elasticity {
        Some(Elasticity::Linear { .. }) => Some((
            "adhesion",
            "found \"jkr\" for contacts with `stiffness`",
            "its force curve is one of elastic solids: give `young` of the materials, or use \"dmt\"",
        )),
        Some(Elasticity::Hertz { .. }) if cohesion.rupture_distance > 0.0 => Some((
            "rupture_distance",
            "found `rupture_distance` for contacts with `young` and adhesion = \"jkr\"",
            "JKR's neck parts where its curve ends: remove it, or use \"dmt\"",
        )),
        _ => None,
    }
}
