//! Where everything is at one instant, and the pairs there.

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::{Contact, ContactForce, ContactId, Partner};
use crate::geometry::ClosestPoint;
use crate::scene::particles::{Kinematics, Particles};
use crate::scene::{Boundary, Scene};
use crate::spatial::cell::{Cell, HERE, Image};
use crate::spatial::extent::larger;
use crate::spatial::{Displacement, Pose};

/// Where everything is at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Configuration<'a> {
    /// The spheres.
    pub particles: &'a Particles,
    /// Their centres \[m\], `[N]`.
    pub position: &'a [Vec3],
    /// Which of them are in the scene, `[N]`.
    pub present: &'a [bool],
    /// The boundaries, `[B]`.
    pub boundaries: &'a [Boundary],
    /// Their poses, `[B]`.
    pub poses: &'a [Pose],
    /// The periodic cell.
    pub cell: &'a Cell,
}

/// A pair within reach at the start of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// Identity.
    pub key: ContactId,
    /// Unit normal from B to A.
    pub normal: Vec3,
    /// Gap \[m\].
    pub gap: f64,
    /// Largest curvature of the constant-gap surface of the pair \[1/m\].
    pub curvature: f64,
}

impl<'a> Configuration<'a> {
    /// Everything where `kinematics` and `poses` have it.
    #[must_use]
    pub fn of(scene: &'a Scene, kinematics: &'a Kinematics, poses: &'a [Pose]) -> Self {
        Self {
            particles: &scene.particles,
            position: &kinematics.position,
            present: &kinematics.present,
            boundaries: &scene.boundaries,
            poses,
            cell: &scene.cell,
        }
    }
}

impl Configuration<'_> {
    /// Centres of the spheres that are in the scene \[m\].
    pub(crate) fn present_positions(&self) -> impl Iterator<Item = Vec3> {
        let spheres = self.position.iter().zip(self.present);
        spheres.filter(|(_, present)| **present).map(|(x, _)| *x)
    }

    /// Radius of the smaller partner \[m\]: the scale of a pair's overlap.
    #[must_use]
    pub fn scale(&self, key: ContactId) -> f64 {
        self.particles.smaller_radius(key)
    }

    pub(super) fn pair(&self, i: u32, j: u32, image: Image) -> Candidate {
        let [a, b] = [i as usize, j as usize];
        let [ra, rb] = [a, b].map(|k| self.particles.radius[k]);
        let mut other = self.position[b];
        if image != HERE {
            other += self.cell.shift(image);
        }
        let distance = self.position[a] - other;
        let length = distance.norm();
        // Concentric centres have no normal: take a fixed one, so that the step goes on to resolve them.
        let normal = if length > 0.0 {
            distance / length
        } else {
            Vec3::z()
        };
        Candidate {
            key: ContactId {
                sphere: i,
                partner: Partner::Sphere { index: j, image },
            },
            normal,
            gap: length - ra - rb,
            curvature: 1.0 / (ra + rb),
        }
    }

    pub(super) fn boundary_candidate(
        &self,
        sphere: u32,
        boundary: u16,
        point: &ClosestPoint,
    ) -> Candidate {
        let pose = &self.poses[usize::from(boundary)];
        Candidate {
            key: ContactId {
                sphere,
                partner: Partner::Boundary {
                    boundary,
                    feature: point.feature,
                },
            },
            normal: pose.rotation * point.normal,
            gap: point.gap,
            curvature: point.curvature,
        }
    }

    /// The centre of sphere `i` in the frame of a boundary \[m\], by the copy that is nearest to it.
    pub(super) fn seen_by(&self, boundary: u16, i: u32) -> Vec3 {
        let b = usize::from(boundary);
        let (shape, pose) = (&self.boundaries[b], &self.poses[b]);
        shape.to_frame(
            pose,
            shape.copy_near(self.cell, pose, self.position[i as usize]),
        )
    }

    /// The pair of `candidate`, seen at this configuration: the same feature, the same side.
    pub(crate) fn follow(&self, candidate: &Candidate) -> Candidate {
        let i = candidate.key.sphere;
        match candidate.key.partner {
            Partner::Sphere { index, image } => self.pair(i, index, image),
            Partner::Boundary { boundary, feature } => {
                let point = self.follow_boundary(i, boundary, feature, candidate.normal);
                self.boundary_candidate(i, boundary, &point)
            }
        }
    }

    /// A feature of a boundary as sphere `i` touches it here, on the side of `normal`; in the boundary's frame.
    fn follow_boundary(&self, i: u32, boundary: u16, feature: u32, normal: Vec3) -> ClosestPoint {
        let b = usize::from(boundary);
        let normal = self.poses[b].rotation.inverse() * normal;
        let centre = self.seen_by(boundary, i);
        let radius = self.particles.radius[i as usize];
        let geometry = &self.boundaries[b].geometry;
        geometry.follow(feature, normal, centre, radius)
    }

    /// Where the contact is that carried `load` and `torque` \[N m\].
    pub(crate) fn contact(&self, load: &ContactForce, torque: Vec3, hold: Hold) -> Contact {
        let i = load.key.sphere;
        let (point, gap) = match load.key.partner {
            Partner::Sphere { index, image } => {
                let pair = self.pair(i, index, image);
                let b = index as usize;
                let other = self.position[b] + self.cell.shift(image);
                (other + pair.normal * self.particles.radius[b], pair.gap)
            }
            Partner::Boundary { boundary, feature } => {
                let closest = self.follow_boundary(i, boundary, feature, load.normal);
                let b = usize::from(boundary);
                let point = self.boundaries[b].from_frame(&self.poses[b], closest.point);
                (point, closest.gap)
            }
        };
        Contact {
            key: load.key,
            point,
            normal: load.normal,
            gap,
            force: load.force,
            torque,
            hold,
        }
    }

    /// The longest displacement \[m\] of points fixed to boundary `b`, where spheres are, while it moves to `to`.
    pub(crate) fn carried(&self, b: usize, to: &Pose) -> f64 {
        let Some(displacement) = self.displacement(b, to) else {
            return 0.0;
        };
        let mut displacements = self
            .present_positions()
            .map(|x| self.displacement_at(b, &displacement, x));
        if !displacement.turns {
            // A translation carries all alike, but for rounding.
            return displacements.next().map_or(0.0, |way| way * (1.0 + 1e-9));
        }
        displacements.fold(0.0, larger)
    }

    /// How boundary `b` moves to `to`, if it does.
    pub(crate) fn displacement(&self, b: usize, to: &Pose) -> Option<Displacement> {
        self.poses[b].displacement(to, self.boundaries[b].point_of_action)
    }

    /// Way \[m\] of the point fixed to boundary `b` that is at `x`.
    #[inline]
    pub(crate) fn displacement_at(&self, b: usize, displacement: &Displacement, x: Vec3) -> f64 {
        let x = self.boundaries[b].copy_near(self.cell, &self.poses[b], x);
        displacement.at(x).norm()
    }

    /// Distance of the centres of spheres `i` and `j` \[m\].
    #[inline]
    pub(super) fn apart(&self, i: u32, j: u32) -> f64 {
        (self.position[i as usize] - self.position[j as usize]).norm()
    }

    /// Gap \[m\] of [`Self::follow`].
    pub(crate) fn gap(&self, candidate: &Candidate) -> f64 {
        match candidate.key.partner {
            Partner::Sphere { index, image } => {
                let i = candidate.key.sphere;
                let [ra, rb] = [i, index].map(|k| self.particles.radius[k as usize]);
                let apart = match image {
                    HERE => self.apart(i, index),
                    image => self.between(i, index, image).norm(),
                };
                apart - ra - rb
            }
            Partner::Boundary { boundary, feature } => {
                let i = candidate.key.sphere;
                let point = self.follow_boundary(i, boundary, feature, candidate.normal);
                point.gap
            }
        }
    }
}
