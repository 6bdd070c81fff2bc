//! A sphere as its contacts see it before the step.

use crate::Vec3;
use crate::parallel::Pool;
use crate::scene::Scene;
use crate::scene::particles::Kinematics;

/// A sphere as its contacts see it before the step.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C, align(64))]
pub(super) struct SphereMotion {
    /// Velocity \[m/s\].
    pub(super) velocity: Vec3,
    /// Angular velocity times radius \[m/s\].
    pub(super) rolling: Vec3,
    /// Radius \[m\].
    pub(super) radius: f64,
    /// Mass \[kg\]; of a member that of its clump.
    pub(super) mass: f64,
}

impl SphereMotion {
    /// All spheres, `[N]`, in the given memory.
    pub(super) fn all(
        scene: &Scene,
        kinematics: &Kinematics,
        (mut memory, pool): (Vec<Self>, &Pool),
    ) -> Vec<Self> {
        let particles = &scene.particles;
        memory.resize(kinematics.len(), Self::default());
        pool.fill(&mut memory[..], |i| Self {
            velocity: kinematics.velocity[i],
            rolling: kinematics.spin[i] * particles.radius[i],
            radius: particles.radius[i],
            mass: particles.mass[i],
        });
        for clump in &scene.clumps {
            for member in &mut memory[clump.members.clone()] {
                member.mass = clump.shape.mass;
            }
        }
        memory
    }

    /// Square of its speed \[m^2/s^2\].
    pub(super) fn speed(&self) -> f64 {
        self.velocity.norm_squared()
    }
}
