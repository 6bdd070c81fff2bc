//! What driven bodies carry from step to step.

use serde::{Deserialize, Serialize};

use crate::scene::body::Body;
use crate::scene::{Motion, Scene};
use crate::spatial::{Pose, SpatialVector, Twist};

/// What a driven body carries from step to step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BodyState {
    /// Momentum \[N s\] and angular momentum about the reference point \[N m s\]: the integrator's own (half step for Moreau).
    pub momentum: SpatialVector,
    /// The velocity that goes with it, of the reference point.
    pub velocity: SpatialVector,
    /// Force \[N\] and torque about the reference point \[N m\] of all but impacts in the last step.
    pub smooth: SpatialVector,
    /// Displacement along the slide \[m\] or angle about the hinge \[rad\] from the scene's placement, whole turns included.
    pub joint_position: f64,
    /// Force along the slide \[N\] or torque about the hinge \[N m\] of the lower stop, the upper stop and the spring in the
    /// last step.
    pub(crate) joint_forces: [f64; 3],
}

/// The joint of a driven body; \[m\] and \[N\] of a slide, \[rad\] and \[N m\] of a hinge.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JointState {
    /// Displacement or angle from the scene's placement.
    pub joint_position: f64,
    /// Force or torque of its stops and its spring in the last internal step, positive to greater positions.
    pub force: f64,
}

impl Scene {
    /// Lets the driven bodies start at `poses`, `[B]`, at rest; those whose boundary has a state in `carried` keep their whole turns.
    pub(crate) fn start_bodies<'a>(
        &mut self,
        poses: &[Pose],
        carried: impl Iterator<Item = (usize, &'a BodyState)>,
    ) {
        for (boundary, pose) in self.boundaries.iter_mut().zip(poses) {
            if let Motion::Driven(body) = &mut boundary.motion {
                body.pose = *pose;
                body.twist = Twist::default();
            }
        }
        for (b, state) in carried {
            if let Motion::Driven(body) = &mut self.boundaries[b].motion {
                body.start_position = state.joint_position;
            }
        }
    }
}

impl BodyState {
    /// All driven bodies of a scene at t = 0, `[D]`.
    pub(crate) fn initial(scene: &Scene) -> Vec<Self> {
        let start = |(b, body): (usize, &Body)| {
            let pivot = scene.boundaries[b].point_of_action;
            let momentum = body.momentum_of(pivot, &body.pose, &body.twist);
            Self {
                momentum,
                velocity: body
                    .operator(pivot, body.pose.rotation, f64::recip)
                    .times(&momentum),
                smooth: SpatialVector::ZERO,
                joint_position: body.joint_position(&body.pose, body.start_position),
                joint_forces: [0.0; 3],
            }
        };
        scene.driven().map(start).collect()
    }
}
