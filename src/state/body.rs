//! What driven bodies carry from step to step.

use serde::{Deserialize, Serialize};

use crate::scene::Scene;
use crate::scene::body::Body;
use crate::spatial::Dof6;

/// What a driven body carries from step to step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BodyState {
    /// Momentum \[N s\] and angular momentum about the reference point \[N m s\]: the integrator's own (half step for Moreau).
    pub momentum: Dof6,
    /// The velocity that goes with it, of the reference point.
    pub velocity: Dof6,
    /// Force \[N\] and torque about the reference point \[N m\] of all but impacts in the last step.
    pub persisting: Dof6,
    /// Displacement along the slide \[m\] or angle about the hinge \[rad\] from the scene's placement, whole turns included.
    pub travel: f64,
    /// Force along the slide \[N\] or torque about the hinge \[N m\] of the lower stop, the upper stop and the spring in the
    /// last step.
    pub holds: [f64; 3],
}

/// The joint of a driven body; \[m\] and \[N\] of a slide, \[rad\] and \[N m\] of a hinge.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JointState {
    /// Displacement or angle from the scene's placement.
    pub travel: f64,
    /// Force or torque of its stops and its spring in the last internal step, positive to greater travel.
    pub force: f64,
}

impl BodyState {
    /// All driven bodies of a scene at t = 0, `[D]`.
    #[must_use]
    pub fn initial(scene: &Scene) -> Vec<Self> {
        let start = |(b, body): (usize, &Body)| {
            let boundary = &scene.boundaries[b];
            let momentum = body.momentum_of(boundary, &body.pose, &body.twist);
            Self {
                momentum,
                velocity: body
                    .operator(boundary, body.pose.rotation, f64::recip)
                    .times(&momentum),
                persisting: Dof6::ZERO,
                travel: body.travel(&body.pose, 0.0),
                holds: [0.0; 3],
            }
        };
        scene.driven().map(start).collect()
    }
}
