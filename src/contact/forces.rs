//! What the contacts of a step carried: forces, couples where materials resist rolling or twisting, and the energy of their shear
//! springs where they give way.

use std::ops::{Deref, Range};

use serde::{Deserialize, Serialize};

use super::cohesion::Hold;
use super::{ContactForce, ContactId};
use crate::Vec3;
use crate::memory;
use crate::spatial::Wrench;

/// Loads in canonical order, `[C]`, as which this reads, and what goes with them.
#[derive(Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactForces {
    loads: Vec<ContactForce>,
    /// `[C]`; empty unless pairs of materials resist: most scenes have none.
    torques: Vec<Vec3>,
    /// Their springs, `[C]`; empty unless contacts give way.
    springs: Vec<SpringState>,
    /// What holds them together, `[C]`; empty unless pairs of materials cohere or are bonded.
    holds: Vec<Hold>,
}

/// What the spring of a contact goes on with.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) enum SpringState {
    /// The last step has not resolved its impact, which was rigid.
    Struck,
    /// What it holds across the normal.
    Stretched {
        /// Force on A \[N\]: of its stretch, not of what a solver has found.
        shear: Vec3,
        /// Shear stiffness \[N/m\]; infinite: rigid.
        stiffness: f64,
    },
}

impl SpringState {
    /// Energy \[J\] that it has stored across the normal.
    pub(crate) fn energy(&self) -> f64 {
        match self {
            Self::Struck => 0.0,
            Self::Stretched { shear, stiffness } => match shear.norm_squared() {
                0.0 => 0.0,
                square => 0.5 * square / stiffness,
            },
        }
    }
}

/// What goes with the force of a contact; all contacts have it, or none has.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Beside {
    /// Couple of rolling and twisting resistance on A \[N m\].
    pub(crate) torque: Option<Vec3>,
    /// Its spring.
    pub(crate) spring: Option<SpringState>,
    /// What holds it together.
    pub(crate) hold: Option<Hold>,
}

impl Beside {
    /// What a contact of a sphere at `x` \[m\] with a radius \[m\] does to its boundary, about `pivot` \[m\]. `x` is the copy that is near.
    pub(crate) fn on_boundary(
        &self,
        load: &ContactForce,
        (x, radius): (Vec3, f64),
        pivot: Vec3,
    ) -> Wrench {
        // A bond over a gap holds the boundary at its own end.
        let apart = self.hold.map_or(0.0, |hold| hold.rest().max(0.0));
        let point = x + load.normal * -(radius + apart);
        Wrench {
            force: -load.force,
            torque: -(point - pivot).cross(&load.force) - self.torque.unwrap_or_default(),
        }
    }
}

impl ContactForces {
    /// What goes with contact `k`.
    pub(crate) fn beside(&self, k: usize) -> Beside {
        Beside {
            torque: self.torques.get(k).copied(),
            spring: self.springs.get(k).copied(),
            hold: self.holds.get(k).copied(),
        }
    }

    /// What holds contact `k` together.
    #[inline]
    pub(crate) fn hold(&self, k: usize) -> Hold {
        self.holds.get(k).copied().unwrap_or_default()
    }

    /// Couple of rolling and twisting resistance of contact `k` on A \[N m\], mean over the step; its opposite acts on B.
    pub(crate) fn torque(&self, k: usize) -> Vec3 {
        self.torques.get(k).copied().unwrap_or_default()
    }

    /// Adds a contact, the last in canonical order.
    #[inline]
    pub(crate) fn push(&mut self, load: ContactForce, beside: Beside) {
        memory::push(&mut self.loads, load);
        if let Some(torque) = beside.torque {
            memory::push(&mut self.torques, torque);
        }
        if let Some(spring) = beside.spring {
            memory::push(&mut self.springs, spring);
        }
        if let Some(hold) = beside.hold {
            memory::push(&mut self.holds, hold);
        }
    }

    /// Forgets all contacts, but keeps the memory.
    pub(crate) fn clear(&mut self) {
        self.loads.clear();
        self.torques.clear();
        self.springs.clear();
        self.holds.clear();
    }

    /// Forgets the contacts whose keys are not `kept`.
    pub(crate) fn retain(&mut self, kept: impl Fn(&ContactId) -> bool) {
        let mut loads = self.loads.iter();
        let mut next = || loads.next().is_some_and(|load| kept(&load.key));
        self.torques.retain(|_| next());
        let mut loads = self.loads.iter();
        let mut next = || loads.next().is_some_and(|load| kept(&load.key));
        self.springs.retain(|_| next());
        let mut loads = self.loads.iter();
        let mut next = || loads.next().is_some_and(|load| kept(&load.key));
        self.holds.retain(|_| next());
        self.loads.retain(|load| kept(&load.key));
    }

    /// Into `to` the contacts whose bodies all have a place in `rank`, by these numbers; other spheres have [`u32::MAX`] there.
    pub(crate) fn gather(&self, rank: &[u32], to: &mut Self) {
        to.clear();
        for (k, load) in self.iter().enumerate() {
            if load.key.spheres().all(|i| rank[i] != u32::MAX) {
                let mut load = *load;
                load.key.renumber(rank);
                to.push(load, self.beside(k));
            }
        }
    }

    /// Puts `from`, whose spheres are those of `number`, in the places of what [`Self::gather`] took. `spare` is memory.
    pub(crate) fn scatter(
        &mut self,
        (number, rank): (&[u32], &[u32]),
        from: &Self,
        spare: &mut Self,
    ) {
        spare.clear();
        let numbered = |(k, load): (usize, &ContactForce)| {
            let mut load = *load;
            load.key.renumber(number);
            (load, from.beside(k))
        };
        let mut next = from.iter().enumerate().map(numbered).peekable();
        // What takes no part stays in runs.
        let mut first = 0;
        for (k, load) in self.loads.iter().enumerate() {
            let taken = load.key.spheres().all(|i| rank[i] != u32::MAX);
            let due = |(own, _): &(ContactForce, Beside)| own.key < load.key;
            if !taken && !next.peek().is_some_and(due) {
                continue;
            }
            spare.append(self, first..k);
            first = k + usize::from(taken);
            if !taken {
                while let Some((own, beside)) = next.next_if(due) {
                    spare.push(own, beside);
                }
            }
        }
        spare.append(self, first..self.loads.len());
        next.for_each(|(own, beside)| spare.push(own, beside));
        std::mem::swap(self, spare);
    }

    /// Adds the contacts of a `run` in `from`, the last in canonical order.
    fn append(&mut self, from: &Self, run: Range<usize>) {
        memory::append(&mut self.loads, &from.loads, &run);
        memory::append(&mut self.torques, &from.torques, &run);
        memory::append(&mut self.springs, &from.springs, &run);
        memory::append(&mut self.holds, &from.holds, &run);
    }

    /// Lets `change` change force and couple of each contact.
    pub(crate) fn change(&mut self, mut change: impl FnMut(&mut Vec3, Option<&mut Vec3>)) {
        let mut torques = self.torques.iter_mut();
        for load in &mut self.loads {
            change(&mut load.force, torques.next());
        }
    }

    /// Whether all that goes with contacts belongs to them.
    pub(crate) fn fits(&self) -> bool {
        let fits = |count: usize| count == 0 || count == self.loads.len();
        fits(self.torques.len()) && fits(self.springs.len()) && fits(self.holds.len())
    }
}

impl Deref for ContactForces {
    type Target = [ContactForce];

    fn deref(&self) -> &[ContactForce] {
        &self.loads
    }
}

impl Clone for ContactForces {
    fn clone(&self) -> Self {
        Self {
            loads: self.loads.clone(),
            torques: self.torques.clone(),
            springs: self.springs.clone(),
            holds: self.holds.clone(),
        }
    }

    /// In the memory that there is.
    fn clone_from(&mut self, other: &Self) {
        memory::copy(&mut self.loads, &other.loads);
        memory::copy(&mut self.torques, &other.torques);
        memory::copy(&mut self.springs, &other.springs);
        memory::copy(&mut self.holds, &other.holds);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Partner;

    #[test]
    fn couples_stay_with_their_contacts() {
        let load = |sphere| ContactForce {
            key: ContactId {
                sphere,
                partner: Partner::sphere(9),
            },
            normal: Vec3::z(),
            force: Vec3::z(),
        };
        let stretched = |shear| SpringState::Stretched {
            shear: Vec3::x() * shear,
            stiffness: 2.0,
        };
        let mut carried = ContactForces::default();
        for i in 0..4 {
            carried.push(
                load(i),
                Beside {
                    torque: Some(Vec3::x() * f64::from(i)),
                    spring: Some(stretched(f64::from(i))),
                    hold: None,
                },
            );
        }
        carried.retain(|key| key.sphere % 2 == 1);
        assert_eq!(carried.len(), 2);
        assert_eq!([0, 1].map(|k| carried.torque(k).x), [1.0, 3.0]);
        let springs = [0, 1].map(|k| carried.beside(k).spring);
        assert_eq!(springs, [1.0, 3.0].map(|shear| Some(stretched(shear))));
        assert_eq!(springs.map(|spring| spring.unwrap().energy()), [0.25, 2.25]);
        assert!(carried.fits());
        carried.clear();
        carried.push(load(0), Beside::default());
        assert_eq!(carried.torque(0), Vec3::zeros());
        assert!(carried.fits());
        assert_eq!(size_of::<ContactForce>(), 72);
    }

    #[test]
    fn contacts_of_some_come_back_among_all() {
        let load = |sphere, other, force| ContactForce {
            key: ContactId {
                sphere,
                partner: Partner::sphere(other),
            },
            normal: Vec3::z(),
            force: Vec3::z() * force,
        };
        let beside = |force| Beside {
            torque: Some(Vec3::x() * force),
            ..Beside::default()
        };
        let of = |loads: &[(u32, u32, f64)]| {
            let mut all = ContactForces::default();
            for &(a, b, force) in loads {
                all.push(load(a, b, force), beside(force));
            }
            all
        };
        // Spheres 1, 3 and 4 of 5.
        let (number, rank) = ([1, 3, 4], [u32::MAX, 0, u32::MAX, 1, 2]);
        let mut all = of(&[(0, 1, 1.0), (1, 3, 2.0), (2, 3, 3.0), (3, 4, 4.0)]);
        let mut some = ContactForces::default();
        all.gather(&rank, &mut some);
        assert_eq!(some, of(&[(0, 1, 2.0), (1, 2, 4.0)]));
        let after = of(&[(0, 2, 5.0), (1, 2, 6.0)]);
        all.scatter((&number, &rank), &after, &mut some);
        assert_eq!(
            all,
            of(&[(0, 1, 1.0), (1, 4, 5.0), (2, 3, 3.0), (3, 4, 6.0)])
        );
    }
}
