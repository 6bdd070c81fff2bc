//! Materials and the table of pair properties.

use serde::{Deserialize, Serialize};

use crate::contact::cohesion::{Bond, Cohesion};
use crate::contact::elasticity::{Elasticity, damping_ratio};

/// A material.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Name, unique in the scene.
    pub name: String,
    /// Density \[kg/m^3\]; only spheres use it.
    pub density: f64,
}

/// How two materials touch.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Pair {
    /// Coulomb friction coefficient `mu = tan(phi)` \[-\], >= 0.
    pub friction: f64,
    /// Newton's coefficient of restitution `e` \[-\], 0..=1.
    pub restitution: f64,
    /// Coefficient of rolling resistance `mu_r` \[-\], >= 0: the couple is at most `mu_r R* p_n`, with
    /// `R* = R_i R_j / (R_i + R_j)`, on a boundary `R`.
    pub rolling_friction: f64,
    /// Coefficient of twisting resistance `mu_t` \[-\], >= 0: the couple about the normal is at most `mu_t R* p_n`.
    pub twisting_friction: f64,
    /// How the two give way; `None`: they are rigid.
    pub elasticity: Option<Elasticity>,
    /// Archard's wear coefficient `k` \[1/Pa\], >= 0: a boundary loses the volume `k F_n s` under a normal force that slides by `s`.
    pub wear: f64,
    /// How the two attract each other once they have touched.
    pub cohesion: Option<Cohesion>,
    /// Bonds between what touches at the start.
    pub bond: Option<Bond>,
}

impl Pair {
    /// Largest gap \[m\] of a bridge, a neck or a bond between spheres of at most this radius \[m\], or one and a boundary, where
    /// they give way by `elasticity`.
    fn holding_distance(&self, radius: f64, elasticity: Option<&Elasticity>) -> f64 {
        let cohesion = self.cohesion.map_or(0.0, |cohesion| {
            let neck = elasticity.and_then(|e| cohesion.neck(e, radius));
            let fold = neck.map_or(0.0, |neck| -neck.fold());
            cohesion.rupture_distance.max(fold)
        });
        let bond = self.bond.map_or(0.0, |bond| {
            let stretch = elasticity.map_or(0.0, |e| bond.stretch(e, radius));
            bond.reach + stretch
        });
        cohesion.max(bond)
    }
}

/// Symmetric table of [`Pair`]s for `n` materials.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PairTable {
    materials: usize,
    pairs: Vec<Pair>,
    /// Damping ratio \[-\] of each pair by its restitution.
    damping: Vec<f64>,
}

impl PairTable {
    /// A table for `materials` materials, every pair set to `default`.
    #[must_use]
    pub fn new(materials: usize, default: Pair) -> Self {
        Self {
            materials,
            pairs: vec![default; materials * materials],
            damping: vec![damping_ratio(default.restitution); materials * materials],
        }
    }

    /// The pair of materials `a` and `b`, in either order.
    #[must_use]
    pub fn get(&self, a: u16, b: u16) -> Pair {
        *self.between(a, b)
    }

    /// [`Self::get`], where it is kept.
    #[inline]
    pub(crate) fn between(&self, a: u16, b: u16) -> &Pair {
        &self.pairs[usize::from(a) * self.materials + usize::from(b)]
    }

    /// The pairs of materials, each once.
    pub(crate) fn all(&self) -> impl Iterator<Item = (u16, u16)> {
        let indices = (0..self.materials).filter_map(|a| u16::try_from(a).ok());
        indices.flat_map(|b| (0..=b).map(move |a| (a, b)))
    }

    /// Damping ratio \[-\] that gives the pair its restitution where it gives way.
    pub(crate) fn damping(&self, a: u16, b: u16) -> f64 {
        self.damping[usize::from(a) * self.materials + usize::from(b)]
    }

    /// Whether any pair gives way.
    #[must_use]
    pub fn gives_way(&self) -> bool {
        self.pairs.iter().any(|pair| pair.elasticity.is_some())
    }

    /// Whether any pair rebounds.
    pub(crate) fn rebounds(&self) -> bool {
        self.pairs.iter().any(|pair| pair.restitution > 0.0)
    }

    /// Whether any pair resists rolling or twisting.
    pub(crate) fn resists(&self) -> bool {
        let mut pairs = self.pairs.iter();
        pairs.any(|pair| {
            pair.rolling_friction > 0.0 || pair.twisting_friction > 0.0 || pair.bond.is_some()
        })
    }

    /// Whether any pair coheres or is bonded.
    pub(crate) fn coheres(&self) -> bool {
        let mut pairs = self.pairs.iter();
        pairs.any(|pair| pair.cohesion.is_some() || pair.bond.is_some())
    }

    /// Whether some pairs have bonds.
    pub(crate) fn has_bonds(&self) -> bool {
        let mut pairs = self.pairs.iter();
        pairs.any(|pair| pair.bond.is_some())
    }

    /// Largest gap \[m\] over which a contact is held, where no sphere is larger than `radius` \[m\]; boundaries give way by `others`.
    pub(crate) fn holding_distance(
        &self,
        radius: f64,
        others: impl Iterator<Item = Elasticity> + Clone,
    ) -> f64 {
        let of = |pair: &Pair| {
            let own = pair.holding_distance(radius, pair.elasticity.as_ref());
            let others = others.clone();
            let others = others.map(|other| pair.holding_distance(radius, Some(&other)));
            others.fold(own, f64::max)
        };
        self.pairs.iter().map(of).fold(0.0, f64::max)
    }

    /// Sets the pair of `a` and `b`, in both orders.
    pub fn set(&mut self, a: u16, b: u16, pair: Pair) {
        let ratio = damping_ratio(pair.restitution);
        for (a, b) in [(a, b), (b, a)] {
            let at = usize::from(a) * self.materials + usize::from(b);
            (self.pairs[at], self.damping[at]) = (pair, ratio);
        }
    }
}
