//! `body` of a `[[boundary]]`: what it needs to be moved by force and torque.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{OneOrMany, Vector};

/// A boundary's body: it moves by the forces of the spheres, its weight and its loads, solved together with the spheres.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Mass \[kg\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass: f64,
    /// Centre of mass \[m\].
    #[schemars(extend("x-default" = "the reference point"))]
    pub centre: Option<Vector>,
    /// Inertia about the centre of mass in the scene's axes \[kg m^2\]: `[Ixx, Iyy, Izz]`, or three rows of three. A free body needs
    /// it, a hinge unless its centre of mass lies off the axis, a slide does not use it.
    #[schemars(extend("x-default" = "none"))]
    pub inertia: Option<Vec<OneOrMany<f64>>>,
    /// Its free degrees of freedom.
    #[serde(default)]
    pub joint: Joint,
    /// Constant force at the reference point \[N\], world axes.
    #[serde(default)]
    pub force: Vector,
    /// Constant torque \[N m\], world axes.
    #[serde(default)]
    pub torque: Vector,
    /// Pressure of a servo wall, along the axis of its slide.
    #[schemars(extend("x-default" = "none"))]
    pub servo: Option<Servo>,
    /// Stops of a slide or hinge, without restitution.
    #[schemars(extend("x-default" = "none"))]
    pub limits: Option<Limits>,
    /// Spring along a slide or about a hinge.
    #[schemars(extend("x-default" = "none"))]
    pub spring: Option<JointSpring>,
    /// Damping force over velocity \[N s/m\], of the centre of mass or along the slide.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Damping torque over angular velocity \[N m s/rad\].
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub angular_damping: f64,
    /// Whether gravity acts on it.
    #[serde(default = "yes")]
    pub gravity: bool,
    /// Whether it stays in its place while the spheres settle before t = 0; then it starts at rest.
    #[serde(default)]
    pub hold_while_settling: bool,
    /// Velocity of the reference point at t = 0 \[m/s\].
    #[serde(default)]
    pub velocity: Vector,
    /// Angular velocity at t = 0 \[rad/s\].
    #[serde(default)]
    pub angular_velocity: Vector,
}

/// What a body can do.
#[derive(Debug, Clone, Copy, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Joint {
    /// Anything.
    #[default]
    Free,
    /// Move along this axis without turning, any length > 0.
    Slide(Vector),
    /// Turn about this axis through the reference point, any length > 0.
    Hinge(Vector),
}

/// How far a slide or hinge travels from the scene's placement, which lies between: \[m\] along the slide, \[rad\] about the
/// hinge, whole turns counted.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// Least travel \[m\], of a hinge \[rad\], at most 0.
    #[schemars(extend("x-default" = "none", "maximum" = 0))]
    pub lower: Option<f64>,
    /// Greatest travel \[m\], of a hinge \[rad\], at least 0.
    #[schemars(extend("x-default" = "none", "minimum" = 0))]
    pub upper: Option<f64>,
}

/// A linear spring along the slide or about the hinge of a body.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointSpring {
    /// Force over displacement \[N/m\], of a hinge torque over angle \[N m/rad\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness: f64,
    /// Travel from the scene's placement at which it exerts nothing \[m\], of a hinge \[rad\].
    #[serde(default)]
    pub rest: f64,
}

/// A pressure that a body on a slide exerts: either on `area`, or on the rectangle `between` two pairs of boundaries.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Servo {
    /// Pressure \[Pa\]; positive pushes along the axis of the slide.
    pub pressure: f64,
    /// Area it acts on \[m^2\].
    #[schemars(extend("x-default" = "by `between`", "exclusiveMinimum" = 0))]
    pub area: Option<f64>,
    /// Whether the pressure is an input of the FMU, `pressure` then being its start.
    #[serde(default)]
    pub input: bool,
    /// Two pairs of boundaries: the area is the product of the distances between their reference points.
    #[schemars(extend("x-default" = "none"))]
    pub between: Option<Vec<Vec<String>>>,
}

fn yes() -> bool {
    true
}
