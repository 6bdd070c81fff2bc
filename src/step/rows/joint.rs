//! Stops and springs of slides and hinges: rows of the step's problem on the joint's one free direction.
//!
//! With the position `q` \[m\] or \[rad\] from the scene's configuration, and its rate over the step `q'`:
//!
//! ```text
//! lower stop   0 <= f  perp  q + dt q' - q_min >= 0        no restitution, no friction
//! upper stop   0 <= f  perp  q_max - q - dt q' >= 0
//! spring       f = -k (q + dt q' - q_0)                    backward Euler, as constrained points
//! ```
//!
//! A row holds a body at a point: a slide anywhere, a hinge at the lever `L = sqrt(I/m)`, its radius of gyration, across the
//! axis, so that its rows have the units and the mass `m` of all others: `u = L q'`, torque `L p`.

use crate::Vec3;
use crate::scene::Boundary;
use crate::scene::body::{Body, Joint};
use crate::step::driven::BodyPrediction;

/// What acts on a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A stop that pushes to greater positions.
    Lower,
    /// A stop that pushes to lesser positions.
    Upper,
    /// A spring of this stiffness \[N/m\] at the row's point.
    Spring(f64),
}

/// A stop or a spring at the start of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointLimit {
    /// Which.
    pub kind: Kind,
    /// Where it holds the body, from its reference point \[m\].
    pub arm: Vec3,
    /// Unit vector in which that point moves when the position of the joint grows.
    pub direction: Vec3,
    /// Velocity of that point over the rate of the joint's position: 1 for a slide \[-\], `L` for a hinge \[m\].
    pub lever: f64,
    /// Distance to the stop, negative beyond it, or stretch of the spring \[m\] at the point.
    pub distance: f64,
    /// Force along `direction` in the last step \[N\] at the point.
    pub force: f64,
}

impl JointLimit {
    /// Its place in `state::BodyState::joint_forces`.
    #[must_use]
    pub fn slot(&self) -> usize {
        match self.kind {
            Kind::Lower => 0,
            Kind::Upper => 1,
            Kind::Spring(_) => 2,
        }
    }

    /// Whether it is a stop.
    #[must_use]
    pub fn stops(&self) -> bool {
        !matches!(self.kind, Kind::Spring(_))
    }

    /// Unit normal of its row: for a stop the direction in which it pushes.
    #[must_use]
    pub fn normal(&self) -> Vec3 {
        match self.kind {
            Kind::Lower | Kind::Spring(_) => self.direction,
            Kind::Upper => -self.direction,
        }
    }
}

impl Body {
    /// Its stops and its spring at `joint_position`, with what they exerted in the last step.
    fn joint_limits(
        &self,
        boundary: &Boundary,
        joint_position: f64,
        last: &[f64; 3],
    ) -> Vec<JointLimit> {
        let (arm, direction, lever) = match self.joint {
            Joint::Free => return Vec::new(),
            Joint::Slide { axis } => (Vec3::zeros(), axis, 1.0),
            Joint::Hinge { axis } => {
                let moment = self.moment_about(axis, boundary.point_of_action);
                let lever = (moment / self.mass).sqrt();
                // Any direction across the axis serves.
                let across = axis.cross(&Vec3::ith(axis.iamin(), 1.0)).normalize();
                (across * lever, axis.cross(&across), lever)
            }
        };
        let [lower, upper] = self.limits;
        let lower = lower.map(|at| (Kind::Lower, joint_position - at));
        let upper = upper.map(|at| (Kind::Upper, at - joint_position));
        let spring = self.spring.map(|spring| {
            let stiffness = spring.stiffness / (lever * lever);
            (Kind::Spring(stiffness), joint_position - spring.rest)
        });
        let found = [lower, upper, spring].into_iter().zip(last);
        found
            .filter_map(|(found, last)| {
                let (kind, way) = found?;
                Some(JointLimit {
                    kind,
                    arm,
                    direction,
                    lever,
                    distance: way * lever,
                    force: last / lever,
                })
            })
            .collect()
    }
}

/// A stop or spring of a driven body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct JointConstraint {
    pub(crate) limit: JointLimit,
    pub(crate) impact: bool,
}

impl BodyPrediction<'_> {
    /// Its stops and its spring.
    #[must_use]
    pub fn joint_limits(&self) -> Vec<JointLimit> {
        self.body
            .joint_limits(self.surface, self.joint_position, &self.joint_forces)
    }
}
