//! What is inside a region `V` of space at one instant.
//!
//! ```text
//! mass                m = sum_i m_i                                    spheres i whose centre c_i is inside
//! count               n = sum_i 1
//! solid fraction      sum_i |ball_i in V| / |V|                        true volumes of all spheres
//! centre of mass      sum_i m_i c_i / m                                the region's own centre when it is empty
//! coordination        sum_i (loaded contacts of i) / n                 a contact with a boundary counts one; 0 when empty
//! stress              s = 1/|V| sum_c w_c (f_c l_c + l_c f_c) / 2      Love-Weber; dyadic products, made symmetric
//! normal forces       max and mean of f_c . n_c                        contacts whose point is inside; 0 without any
//! ```
//!
//! `f_c` \[N\] is the force on sphere A of a contact, the mean of the last internal step; `l_c` \[m\] its branch vector: from
//! the centre of sphere B, or from the contact point on a boundary, to the centre of A; `w_c` the share of the branch's
//! length that lies in `V`. With this share, the sum of the forces through any plane of the region is kept: for a
//! block pressed by `F` over the area `A`, `s_zz = F/A` wherever the region's faces run. **Compression is positive.** The
//! unsymmetric part, which stands for couples not in balance, is dropped. There is no kinetic part (`rho v v`): in
//! rapid flow the total stress is larger.
//!
//! Overlaps of spheres within the tolerance are counted twice in the solid fraction. Spheres that are absent do not count.
//! Sources: A. E. H. Love, *Treatise on the Mathematical Theory of Elasticity*, 1927, p. 618; J. Weber, *Bull. Liaison
//! Ponts et Chaussees* 20, 1966; for the weights R. J. Hardy, *J. Chem. Phys.* 76, 1982, p. 622.

use super::branch::share_inside;
use super::solid::volume_inside;
use crate::Vec3;
use crate::contact::Partner;
use crate::geometry::region::Primitive;
use crate::observe::Observation;

/// Reading of a region.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reading {
    /// Mass of the spheres whose centre is inside \[kg\].
    pub mass: f64,
    /// Their number.
    pub count: u64,
    /// Volume of the spheres in the region over its own \[-\].
    pub solid_fraction: f64,
    /// Centre of mass of the spheres whose centre is inside \[m\]; the region's centre when there is none.
    pub centre_of_mass: Vec3,
    /// Mean number of loaded contacts of a sphere whose centre is inside \[-\].
    pub coordination_number: f64,
    /// Mean stress \[Pa\]: xx, yy, zz, xy, yz, xz; compression positive.
    pub stress: [f64; 6],
    /// Largest normal force of a contact whose point is inside \[N\].
    pub max_normal_force: f64,
    /// Mean of these normal forces \[N\].
    pub mean_normal_force: f64,
}

impl Reading {
    /// What a region, a box or a cylinder, holds now.
    #[must_use]
    pub fn of(region: &Primitive, state: &Observation) -> Self {
        let mut reading = Self::default();
        reading.spheres(region, state);
        reading.contacts(region, state);
        reading
    }

    fn spheres(&mut self, region: &Primitive, state: &Observation) {
        let (mut moment, mut solid) = (Vec3::zeros(), 0.0);
        let particles = &state.scene.particles;
        let (cell, bounds) = (&state.scene.cell, region.bounds());
        for (i, &centre) in state.kinematics.position.iter().enumerate() {
            if !state.kinematics.present[i] {
                continue;
            }
            let radius = particles.radius[i];
            for image in cell.copies(centre, bounds, radius) {
                let centre = centre + cell.shift(image);
                solid += volume_inside(region, centre, radius);
                if region.contains(centre) {
                    self.count += 1;
                    self.mass += particles.mass[i];
                    moment += centre * particles.mass[i];
                }
            }
        }
        self.solid_fraction = solid / region.volume();
        self.centre_of_mass = if self.count > 0 {
            moment / self.mass
        } else {
            middle(region)
        };
    }

    fn contacts(&mut self, region: &Primitive, state: &Observation) {
        let centre = &state.kinematics.position;
        let (cell, bounds) = (&state.scene.cell, region.bounds());
        let inside = |x: Vec3| {
            let copies = cell.copies(x, bounds, 0.0);
            copies
                .filter(|&image| region.contains(x + cell.shift(image)))
                .count() as u64
        };
        let (mut ends, mut count, mut sum) = (0, 0u64, 0.0);
        let mut stress = [0.0; 6];
        for contact in state.active_contacts() {
            let a = contact.key.sphere as usize;
            ends += inside(centre[a]);
            if let Partner::Sphere { index, .. } = contact.key.partner {
                ends += inside(centre[index as usize]);
            }
            let points = inside(contact.point);
            if points > 0 {
                let force = contact.force.dot(&contact.normal);
                count += points;
                sum += force * points as f64;
                self.max_normal_force = self.max_normal_force.max(force);
            }
            let [start, end] = state.branch(contact);
            let reach = (end - start).amax();
            let share: f64 = cell
                .copies(end, bounds, reach)
                .map(|image| {
                    share_inside(region, start + cell.shift(image), end + cell.shift(image))
                })
                .sum();
            if share > 0.0 {
                let (f, l) = (contact.force, (end - start) * share);
                let both = |i: usize, j: usize| 0.5 * (f[i] * l[j] + f[j] * l[i]);
                let terms = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
                for (sum, (i, j)) in stress.iter_mut().zip(terms) {
                    *sum += both(i, j);
                }
            }
        }
        if self.count > 0 {
            self.coordination_number = ends as f64 / self.count as f64;
        }
        if count > 0 {
            self.mean_normal_force = sum / count as f64;
        }
        self.stress = stress.map(|sum| sum / region.volume());
    }
}

/// Centre \[m\] of a region.
fn middle(region: &Primitive) -> Vec3 {
    match region {
        Primitive::Box { min, max } => (min + max) * 0.5,
        Primitive::Cylinder {
            base, axis, height, ..
        } => base + axis * (0.5 * height),
    }
}
