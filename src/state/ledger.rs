//! Work done since t = 0, by its kinds.

use std::ops::Add;

use serde::{Deserialize, Serialize};

/// Work done since t = 0 \[J\].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct EnergyLedger {
    /// Energy lost by sliding friction, and by resistance to rolling and twisting.
    pub friction: f64,
    /// Energy lost along the normals of impacts, in the dampers of contacts that give way, and at the stops of joints.
    pub impact: f64,
    /// Energy that the scheme has added; negative: taken. What is left of the change of kinetic energy after all other work.
    pub numerical_work: f64,
    /// Work of moving boundaries on the spheres.
    pub boundaries: f64,
    /// Potential energy that spheres and driven bodies got because gravity changed with time.
    pub gravity: f64,
    /// Work of point loads and applied forces on the spheres, and of all loads but gravity on driven bodies.
    pub loads: f64,
    /// Work of the dampers of driven bodies: at most zero.
    pub dampers: f64,
    /// Work of constrained springs on the spheres, and of the springs of joints on driven bodies.
    pub springs: f64,
    /// Work of the springs of contacts that give way: what they have stored since t = 0, with a minus.
    pub contacts: f64,
}

impl EnergyLedger {
    /// Energy lost in contacts \[J\]: friction and impact.
    #[must_use]
    pub fn dissipated(&self) -> f64 {
        self.friction + self.impact
    }
}

impl Add for EnergyLedger {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            friction: self.friction + other.friction,
            impact: self.impact + other.impact,
            numerical_work: self.numerical_work + other.numerical_work,
            boundaries: self.boundaries + other.boundaries,
            gravity: self.gravity + other.gravity,
            loads: self.loads + other.loads,
            dampers: self.dampers + other.dampers,
            springs: self.springs + other.springs,
            contacts: self.contacts + other.contacts,
        }
    }
}
