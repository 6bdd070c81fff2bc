//! The fields of each kind of reading: name, unit, meaning, and how to read the value.

use super::readings::{Body, Flow, Sphere, Whole};
use crate::Vec3;
use crate::observe::sensors::region::Reading;
use crate::spatial::Wrench;

/// Components of a vector.
pub const XYZ: &[&str] = &["x", "y", "z"];
/// Components of a quaternion.
pub const WXYZ: &[&str] = &["w", "x", "y", "z"];

/// One quantity of a reading `T`, a number or several components.
pub(super) struct Field<T> {
    pub(super) name: &'static str,
    pub(super) unit: Option<&'static str>,
    pub(super) text: &'static str,
    value: Read<T>,
}

enum Read<T> {
    Real(fn(&T) -> f64),
    Count(fn(&T) -> u64),
    Vector(fn(&T) -> Vec3),
    Quaternion(fn(&T) -> [f64; 4]),
    Tensor(fn(&T) -> [f64; 6]),
}

impl<T> Field<T> {
    /// Letters of the components; none for a single number.
    pub(super) fn components(&self) -> &'static [&'static str] {
        match self.value {
            Read::Real(_) | Read::Count(_) => &[],
            Read::Vector(_) => XYZ,
            Read::Quaternion(_) => WXYZ,
            Read::Tensor(_) => &["xx", "yy", "zz", "xy", "yz", "xz"],
        }
    }

    pub(super) fn is_count(&self) -> bool {
        matches!(self.value, Read::Count(_))
    }

    /// Appends the value, or the components.
    pub(super) fn read(&self, reading: &T, list: &mut Vec<f64>) {
        match self.value {
            Read::Real(of) => list.push(of(reading)),
            Read::Count(of) => list.push(of(reading) as f64),
            Read::Vector(of) => list.extend_from_slice(of(reading).as_slice()),
            Read::Quaternion(of) => list.extend(of(reading)),
            Read::Tensor(of) => list.extend(of(reading)),
        }
    }
}

type Text = &'static str;

const fn real<T>(name: Text, unit: Text, text: Text, of: fn(&T) -> f64) -> Field<T> {
    field(name, Some(unit), text, Read::Real(of))
}

const fn number<T>(name: Text, text: Text, of: fn(&T) -> f64) -> Field<T> {
    field(name, None, text, Read::Real(of))
}

const fn count<T>(name: Text, text: Text, of: fn(&T) -> u64) -> Field<T> {
    field(name, None, text, Read::Count(of))
}

const fn vector<T>(name: Text, unit: Text, text: Text, of: fn(&T) -> Vec3) -> Field<T> {
    field(name, Some(unit), text, Read::Vector(of))
}

const fn turn<T>(name: Text, text: Text, of: fn(&T) -> [f64; 4]) -> Field<T> {
    field(name, None, text, Read::Quaternion(of))
}

const fn tensor<T>(name: Text, unit: Text, text: Text, of: fn(&T) -> [f64; 6]) -> Field<T> {
    field(name, Some(unit), text, Read::Tensor(of))
}

const fn field<T>(name: Text, unit: Option<Text>, text: Text, value: Read<T>) -> Field<T> {
    Field {
        name,
        unit,
        text,
        value,
    }
}

const LOADED: Text = "Number of loaded contacts";
const LARGEST: Text = "Largest normal force of one contact";

#[rustfmt::skip]
pub(super) const BODY: [Field<Body>; 9] = [
    vector("force", "N", "Force of the spheres on the boundary, last internal step", |b| b.state.wrench.force),
    vector("torque", "N.m", "Torque of the spheres on the boundary about its reference point, last internal step", |b| b.state.wrench.torque),
    vector("averageForce", "N", "Force of the spheres, averaged over the communication step (impulse over its length)", |b| b.state.mean_wrench.force),
    vector("averageTorque", "N.m", "Torque of the spheres about the reference point, averaged over the communication step", |b| b.state.mean_wrench.torque),
    vector("position", "m", "Position of the reference point", |b| b.position),
    turn("orientation", "Rotation from the scene's placement, unit quaternion w, x, y, z", |b| b.orientation),
    count("contactCount", LOADED, |b| b.load.count),
    real("maxNormalForce", "N", LARGEST, |b| b.load.max_normal_force),
    real("power", "W", "Power of the spheres on the boundary", Body::power),
];

/// Of driven bodies, whose motion is a result.
pub(super) const DRIVEN: [Field<Body>; 4] = [
    vector(
        "translation",
        "m",
        "Translation from the scene's placement",
        |b| b.state.pose.translation,
    ),
    vector(
        "rotation",
        "rad",
        "Rotation vector from the scene's placement, at most pi long",
        |b| b.state.pose.rotation_vector(),
    ),
    vector("velocity", "m/s", "Velocity of the reference point", |b| {
        b.state.twist.linear
    }),
    vector(
        "angularVelocity",
        "rad/s",
        "Angular velocity, world axes",
        |b| b.state.twist.angular,
    ),
];

/// Of boundaries that move along a slide, by command or as a body.
#[rustfmt::skip]
pub(super) const SLIDE: [Field<Body>; 1] = [
    real("slideForce", "N", "Force of the spheres along the slide, averaged over the communication step", |b| b.axis.dot(&b.state.mean_wrench.force)),
];

/// Of boundaries that turn about a hinge, by command or as a body.
#[rustfmt::skip]
pub(super) const HINGE: [Field<Body>; 1] = [
    real("hingeTorque", "N.m", "Torque of the spheres about the hinge, averaged over the communication step", |b| b.axis.dot(&b.state.mean_wrench.torque)),
];

/// Of bodies on a slide.
#[rustfmt::skip]
pub(super) const SLIDING: [Field<Body>; 2] = [
    real("jointTravel", "m", "Displacement along the slide from the scene's placement", |b| b.state.joint.joint_position),
    real("jointSpeed", "m/s", "Speed along the slide", |b| b.axis.dot(&b.state.twist.linear)),
];

/// Of bodies on a hinge.
#[rustfmt::skip]
pub(super) const HINGED: [Field<Body>; 2] = [
    real("jointAngle", "rad", "Angle about the hinge from the scene's placement, whole turns included", |b| b.state.joint.joint_position),
    real("jointSpeed", "rad/s", "Angular speed about the hinge", |b| b.axis.dot(&b.state.twist.angular)),
];

/// Of bodies on a slide with stops or a spring.
#[rustfmt::skip]
pub(super) const SLIDE_HELD: [Field<Body>; 1] = [
    real("jointForce", "N", "Force of the stops and the spring along the slide, last internal step", |b| b.state.joint.force),
];

/// Of bodies on a hinge with stops or a spring.
#[rustfmt::skip]
pub(super) const HINGE_HELD: [Field<Body>; 1] = [
    real("jointTorque", "N.m", "Torque of the stops and the spring about the hinge, last internal step", |b| b.state.joint.force),
];

/// Of boundaries with `wall_fields`.
#[rustfmt::skip]
pub(super) const WALL: [Field<Body>; 3] = [
    real("frictionEnergy", "J", "Energy lost by sliding friction and by resistance to rolling and twisting on the boundary since the start", |b| b.wall.friction),
    real("impactEnergy", "J", "Energy lost along the normals of impacts on the boundary since the start", |b| b.wall.impact),
    real("wearVolume", "m3", "Volume worn off the boundary since the start (Archard)", |b| b.wall.wear),
];

#[rustfmt::skip]
pub(super) const PROBE: [Field<Sphere>; 8] = [
    vector("position", "m", "Centre of the sphere", |s| s.position),
    turn("orientation", "Orientation, unit quaternion w, x, y, z", |s| s.orientation),
    vector("velocity", "m/s", "Velocity of the centre", |s| s.velocity.linear),
    vector("angularVelocity", "rad/s", "Angular velocity, world axes", |s| s.velocity.angular),
    vector("contactForce", "N", "Sum of the contact forces on the sphere", |s| s.load.wrench.force),
    vector("contactTorque", "N.m", "Torque of the contact forces about the centre", |s| s.load.wrench.torque),
    count("contactCount", LOADED, |s| s.load.count),
    real("maxNormalForce", "N", LARGEST, |s| s.load.max_normal_force),
];

#[rustfmt::skip]
pub(super) const REGION: [Field<Reading>; 8] = [
    real("mass", "kg", "Mass of the spheres whose centre is in the region", |r| r.mass),
    count("count", "Number of spheres whose centre is in the region", |r| r.count),
    number("solidFraction", "Solid volume fraction of the region", |r| r.solid_fraction),
    vector("centreOfMass", "m", "Centre of mass of the spheres whose centre is in the region; the region's when empty", |r| r.centre_of_mass),
    number("coordinationNumber", "Mean number of loaded contacts of a sphere whose centre is in the region", |r| r.coordination_number),
    tensor("stress", "Pa", "Mean stress in the region (Love-Weber), compression positive", |r| r.stress),
    real("maxNormalForce", "N", "Largest normal force of a contact in the region", |r| r.max_normal_force),
    real("meanNormalForce", "N", "Mean normal force of the contacts in the region", |r| r.mean_normal_force),
];

#[rustfmt::skip]
pub(super) const WRENCH: [Field<Wrench>; 2] = [
    vector("force", "N", "Force of the spheres on the boundary, averaged over the communication step", |w| w.force),
    vector("torque", "N.m", "Torque of the spheres about the boundary's reference point, averaged over the communication step", |w| w.torque),
];

#[rustfmt::skip]
pub(super) const FLOW: [Field<Flow>; 2] = [
    real("mass", "kg", "Mass that has passed along the normal since the start", |f| f.mass),
    real("rate", "kg/s", "Mass flow along the normal, mean over the communication step", |f| f.rate),
];

pub(super) const SOURCE: [Field<f64>; 1] =
    [real("mass", "kg", "Mass emitted since the start", |m| *m)];

pub(super) const SINK: [Field<f64>; 1] =
    [real("mass", "kg", "Mass removed since the start", |m| *m)];

/// Of scenes whose contacts hold.
#[rustfmt::skip]
pub(super) const HELD: [Field<Whole>; 3] = [
    count("attachedCount", "Number of contacts that cohesion holds", |w| w.attached),
    count("bondCount", "Number of bonds that hold", |w| w.bonds),
    count("brokenBonds", "Number of bonds that have broken since the start", |w| w.broken_bonds),
];

#[rustfmt::skip]
pub(super) const WHOLE: [Field<Whole>; 32] = [
    real("mass", "kg", "Mass of all spheres in the scene", |w| w.totals.mass),
    count("sphereCount", "Number of spheres in the scene", |w| w.totals.spheres),
    vector("momentum", "kg.m/s", "Momentum of the spheres at half-step velocities; it changes by the impulses of averaged wrenches and weight", |w| w.totals.momentum.linear),
    vector("angularMomentum", "kg.m2/s", "Angular momentum about the origin, half-step velocities", |w| w.totals.momentum.angular),
    vector("averageBodyForce", "N", "Weight, inertial forces of a rotating frame, point loads and applied forces, averaged over the communication step", |w| w.body_force),
    real("kineticEnergy", "J", "Kinetic energy", |w| w.totals.energy.kinetic()),
    real("potentialEnergy", "J", "Potential energy of gravity, centrifugal force, springs and point loads", |w| w.totals.energy.potential()),
    real("dissipatedEnergy", "J", "Energy lost in contacts since the start: friction and impact", |w| w.work.dissipated()),
    real("frictionEnergy", "J", "Energy lost by sliding friction since the start", |w| w.work.friction),
    real("impactEnergy", "J", "Energy lost along the normals of impacts since the start", |w| w.work.impact),
    real("residualEnergy", "J", "Numerical energy error since the start: positive where time stepping added energy", |w| w.work.numerical_work),
    real("boundaryWork", "J", "Work of moving boundaries on the spheres since the start", |w| w.work.boundaries),
    real("gravityWork", "J", "Potential energy gained since the start because gravity changed with time", |w| w.work.gravity),
    real("loadWork", "J", "Work of point loads and applied forces, and of the loads on driven bodies since the start", |w| w.work.loads),
    real("damperWork", "J", "Work of the dampers of driven bodies since the start", |w| w.work.dampers),
    real("springWork", "J", "Work of constrained springs and springs of joints since the start", |w| w.work.springs),
    real("contactWork", "J", "Work of the springs of contacts that give way and of cohesion since the start: what they have stored, with a minus", |w| w.work.contacts),
    count("contactCount", LOADED, |w| w.contacts),
    number("maxOverlap", "Largest true overlap over radius in the communication step, beyond what contacts that give way are compressed by", |w| w.max_overlap),
    number("maxCompression", "Largest overlap over radius of a contact that gives way in the communication step: no error", |w| w.report.max_compression),
    number("maxOpening", "Largest gap over radius at which a contact carried load in the communication step, impacts left out", |w| w.report.max_opening),
    count("solver.internalSteps", "Internal steps of the communication step", |w| w.report.internal_steps),
    count("solver.cuts", "Halvings of internal steps in the communication step", |w| w.report.cuts),
    count("solver.unconvergedSteps", "Internal steps that missed the tolerances; their best iterate was taken", |w| w.report.unconverged_steps),
    count("solver.sweeps", "Gauss-Seidel sweeps of the communication step", |w| w.report.sweeps),
    count("solver.augmentations", "Augmented-Lagrangian iterations of the communication step", |w| w.report.augmentations),
    count("solver.factorizations", "Factorizations of the communication step", |w| w.report.factorizations),
    number("solver.gapResidual", "Largest gap residual in the communication step", |w| w.report.gap_residual),
    number("solver.slipResidual", "Largest slip residual in the communication step", |w| w.report.slip_residual),
    number("solver.forceResidual", "Largest force residual in the communication step", |w| w.report.force_residual),
    number("solver.activeSetMargin", "Distance of the contacts from opening, closing, sticking or slipping in the communication step: 1 far, 0 at a change, where derivatives are one-sided", |w| 1.0 - w.report.active_set_closeness),
    real("recommendedStep", "s", "Recommended internal step at the present speeds", |w| w.recommended_step),
];
