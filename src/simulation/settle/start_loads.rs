//! What loads a scene: the scales of rest and balance.

use crate::parallel::Pool;
use crate::scene::Scene;
use crate::simulation::Simulation;
use crate::step::driven::BodyPrediction;
use crate::step::external::external_acceleration;

/// Share of `sqrt(a R)` that counts as rest.
const STILL: f64 = 1e-3;

/// Loads at t = 0, and the times and lengths that follow from them.
pub(super) struct StartLoads {
    /// Sum of the weights, inertial and other forces on spheres and driven bodies \[N\].
    force: f64,
    /// Gravity, or without it what `force` gives the spheres \[m/s^2\].
    acceleration: f64,
    /// Smallest radius \[m\].
    smallest: f64,
    /// Time for which spheres must be slow to be at rest \[s\].
    pub(super) pause: f64,
}

impl StartLoads {
    /// Those of `simulation`, which has not moved yet. What is commanded from outside is not in them.
    pub(super) fn of(simulation: &Simulation) -> Self {
        let (scene, state) = (&simulation.scene, &simulation.state);
        let mut external = Vec::new();
        let gravity = simulation.gravity();
        let memory = (&mut external, &Pool::default());
        external_acceleration(scene, state, &state.kinematics, gravity, memory);
        let present = |i: &usize| state.kinematics.present[*i];
        let (mut force, mut mass) = (0.0, 0.0);
        for i in (0..external.len()).filter(present) {
            let mut acceleration = external[i].linear;
            if let Some(frame) = scene.settings.rotating_frame {
                acceleration += frame.centrifugal(state.kinematics.position[i]);
            }
            force += scene.particles.mass[i] * acceleration.norm();
            mass += scene.particles.mass[i];
        }
        for body in BodyPrediction::all(scene, state, &state.commands, scene.settings.step) {
            let bounds = scene.boundaries[body.boundary].geometry.finite_bounds();
            let reach = bounds.map_or(0.0, |(min, max)| 0.5 * (max - min).norm());
            force += body.external.linear.norm();
            if reach > 0.0 {
                force += body.load.angular.norm() / reach;
            }
        }
        let acceleration = match gravity.norm() {
            none if none == 0.0 && mass > 0.0 => force / mass,
            gravity => gravity,
        };
        let smallest = scene.particles.smallest_radius();
        let pause = if acceleration > 0.0 && smallest.is_finite() {
            (smallest / acceleration).sqrt()
        } else {
            scene.settings.communication_step
        };
        Self {
            force,
            acceleration,
            smallest,
            pause,
        }
    }

    /// Step \[s\] in which the loads move a sphere by ten gap tolerances, `sqrt(10 tol R / a)`: small steps reach small gaps
    /// with the least work.
    pub(super) fn easy_step(&self, scene: &Scene) -> f64 {
        (10.0 * scene.settings.tolerance.gap * self.smallest / self.acceleration).sqrt()
    }

    /// Speed of rest \[m/s\] with the steps and tolerances of `scene`; 0 without spheres.
    pub(super) fn rest_speed(&self, scene: &Scene) -> f64 {
        if !self.smallest.is_finite() {
            return 0.0;
        }
        let settings = &scene.settings;
        let tolerance = settings.tolerance.gap.max(settings.tolerance.slip);
        let undetermined = 2.0 * tolerance * self.smallest / settings.step;
        STILL * (self.acceleration * self.smallest).sqrt()
            + undetermined
            + self.acceleration * settings.step
    }

    /// Sum of the forces that accelerate the spheres of `simulation`, over the loads \[-\]; 0 without loads, which leave
    /// nothing to balance.
    pub(super) fn unbalanced(&self, simulation: &Simulation) -> f64 {
        if self.force == 0.0 {
            return 0.0;
        }
        let forces = simulation.scene.particles.mass.iter();
        let forces = forces.zip(&simulation.state.smooth);
        forces.map(|(m, a)| m * a.linear.norm()).sum::<f64>() / self.force
    }
}
