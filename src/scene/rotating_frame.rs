//! A frame of reference that turns with constant angular velocity: the inertial forces in it.
//!
//! In a frame that turns with `W` \[rad/s\] about a point `p` \[m\] a centre `x` and a spin `w`, both as seen from the
//! frame, obey
//!
//! ```text
//! m dv/dt = f - m W x (W x (x - p)) - 2 m W x v      centrifugal, Coriolis
//! I dw/dt = t - I W x w                              the spin in the world is w + W, its axes turn with the frame
//! ```
//!
//! The inertia of a sphere is the same about all axes, so `I W x W = 0` and no centrifugal torque is left. The last two
//! terms are normal to the velocity and do no work; the first has the potential `-m |W x (x - p)|^2 / 2`. Of a body of inertia `J`
//! the angular momentum `L = J w` as seen from the frame obeys
//!
//! ```text
//! dL/dt = t - W x J W - (tr(J) W - 2 J W) x w        centrifugal torque, of the potential - W . J W / 2, and gyroscopic torque
//! ```
//!
//! which is what `d(J (w + W))/dt = t` in the world leaves. The last term does no work.
//!
//! A step takes the gyroscopic terms at the mean of its velocities before and after, found with the contact forces of the
//! last step (see `gyroscopic`): without contacts that is the implicit midpoint rule, which turns the velocity by a Cayley
//! transform and keeps its length; with them it is of second order where they change smoothly.

use nalgebra::Matrix3;
use serde::{Deserialize, Serialize};

use crate::Vec3;

/// A turning frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RotatingFrame {
    /// Angular velocity `W` \[rad/s\].
    pub angular_velocity: Vec3,
    /// A point `p` of the axis \[m\].
    pub point: Vec3,
}

impl RotatingFrame {
    /// Centrifugal acceleration `-W x (W x (x - p))` \[m/s^2\].
    pub(crate) fn centrifugal(&self, x: Vec3) -> Vec3 {
        let w = &self.angular_velocity;
        -w.cross(&w.cross(&(x - self.point)))
    }

    /// Centrifugal potential per mass `-|W x (x - p)|^2 / 2` \[J/kg\].
    pub(crate) fn potential(&self, x: Vec3) -> f64 {
        -0.5 * self
            .angular_velocity
            .cross(&(x - self.point))
            .norm_squared()
    }
}

impl RotatingFrame {
    /// Centrifugal torque \[N m\] on a body of this `inertia` \[kg m^2\].
    pub(crate) fn centrifugal_torque(&self, inertia: &Matrix3<f64>) -> Vec3 {
        let w = &self.angular_velocity;
        -w.cross(&(inertia * w))
    }

    /// Its potential \[J\].
    pub(crate) fn potential_of_turning(&self, inertia: &Matrix3<f64>) -> f64 {
        let w = &self.angular_velocity;
        -0.5 * w.dot(&(inertia * w))
    }

    /// Gyroscopic torque \[N m\] on a body of this `inertia` at the mean of its spins before and after a step of `dt` \[s\] that begins
    /// with the angular momentum `before` as seen from the frame; `others` is the torque of everything else:
    ///
    /// ```text
    /// J w = before + dt/2 (others - (tr(J) W - 2 J W) x w)
    /// ```
    pub(crate) fn gyroscopic_torque(
        &self,
        inertia: &Matrix3<f64>,
        before: Vec3,
        others: Vec3,
        dt: f64,
    ) -> Vec3 {
        let w = &self.angular_velocity;
        let turn = (w * inertia.trace() - inertia * w * 2.0).cross_matrix();
        let known = before + others * (0.5 * dt);
        // A positive definite matrix plus a skew one.
        let inverse = (inertia + turn * (0.5 * dt)).try_inverse();
        -turn * inverse.map_or(Vec3::zeros(), |inverse| inverse * known)
    }
}

/// `-rate x v`, with `v` the mean of the velocities before and after a step of `dt` \[s\] that begins with `before`:
///
/// ```text
/// v = before + dt/2 (others + free (-rate x v))
/// ```
///
/// `rate` \[rad/s\] is `2 W` for centres and `W` for spins; `others` is the acceleration by everything else; `free` is 1
/// along free axes and 0 along locked ones.
pub(crate) fn gyroscopic(rate: Vec3, before: Vec3, others: Vec3, free: Vec3, dt: f64) -> Vec3 {
    let turn = Matrix3::from_diagonal(&free) * rate.cross_matrix();
    let known = before + others * (0.5 * dt);
    // One plus a part of a skew matrix: its determinant is at least 1.
    let inverse = (Matrix3::identity() + turn * (0.5 * dt)).try_inverse();
    -turn * inverse.map_or(known, |inverse| inverse * known)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Rotation3;
    use proptest::prelude::*;

    fn vector(size: f64) -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-size..size).prop_map(Vec3::from)
    }

    proptest! {
        /// The equation it solves, and no work: the speed after the step is that before it.
        #[test]
        fn the_mean_velocity_solves_its_equation_and_no_work_is_done(
            rate in vector(50.0), before in vector(5.0), others in vector(20.0), dt in 1e-4..0.1f64,
            locked in prop::array::uniform3(any::<bool>()),
        ) {
            let free = Vec3::from(locked.map(|l| if l { 0.0 } else { 1.0 }));
            let (before, others) = (before.component_mul(&free), others.component_mul(&free));
            let turned = gyroscopic(rate, before, others, free, dt);
            let mean = before + (others + turned) * (0.5 * dt);
            prop_assert!((turned + rate.cross(&mean).component_mul(&free)).norm() < 1e-11);
            let after = before + gyroscopic(rate, before, Vec3::zeros(), free, dt) * dt;
            prop_assert!((after.norm() - before.norm()).abs() < 1e-13 * (1.0 + before.norm()));
        }

        /// Of a body: the equation it solves, no work, what is left of it for a sphere, and the torque as the slope of its potential.
        #[test]
        fn a_body_obeys_its_equation(
            w in vector(5.0), axes in vector(3.0), moments in prop::array::uniform3(0.5..1.0f64), spin in vector(5.0),
            others in vector(2.0), dt in 1e-4..0.1f64,
        ) {
            let frame = RotatingFrame { angular_velocity: w, point: Vec3::zeros() };
            let inertia = |turn: Vec3| {
                let axes = Rotation3::from_scaled_axis(turn) * Rotation3::from_scaled_axis(axes);
                axes * Matrix3::from_diagonal(&Vec3::from(moments)) * axes.inverse()
            };
            let own = inertia(Vec3::zeros());
            let torque = frame.gyroscopic_torque(&own, own * spin, others, dt);
            let mean = own.try_inverse().unwrap() * (own * spin + (others + torque) * (0.5 * dt));
            // As `L + J W` changes in the world, less the centrifugal torque.
            let world = -w.cross(&(own * mean)) - mean.cross(&(own * w)) + own * mean.cross(&w);
            prop_assert!((torque - world).norm() < 1e-10);
            prop_assert!(torque.dot(&mean).abs() < 1e-10);
            let ball = Matrix3::identity() * moments[0];
            let alone = frame.gyroscopic_torque(&ball, ball * spin, others, dt);
            let sphere = gyroscopic(w, spin, others / moments[0], Vec3::repeat(1.0), dt) * moments[0];
            prop_assert!((alone - sphere).norm() < 1e-10);
            prop_assert!(frame.centrifugal_torque(&ball).norm() < 1e-12);
            let h = 1e-5;
            let slope = Vec3::from_fn(|k, _| {
                let potential = |s: f64| frame.potential_of_turning(&inertia(Vec3::ith(k, s)));
                (potential(h) - potential(-h)) / (2.0 * h)
            });
            prop_assert!((frame.centrifugal_torque(&own) + slope).norm() < 1e-7);
        }

        /// The centrifugal acceleration is the slope of its potential.
        #[test]
        fn the_centrifugal_force_has_a_potential(w in vector(3.0), p in vector(1.0), x in vector(2.0)) {
            let frame = RotatingFrame { angular_velocity: w, point: p };
            let h = 1e-5;
            let slope = Vec3::from_fn(|k, _| {
                let e = Vec3::ith(k, h);
                (frame.potential(x + e) - frame.potential(x - e)) / (2.0 * h)
            });
            prop_assert!((frame.centrifugal(x) + slope).norm() < 1e-8);
        }
    }
}
