//! All spheres: their fields, and all as one binary, the output `spheres.document` of FMI 3.0, media type [`MEDIA_TYPE`].
//!
//! ```text
//! bytes       what, little endian
//! 0..8        magic "SDDASPH\0"
//! 8..12       version of this layout, u32: 1
//! 12..20      number of spheres N, u64
//! 20..28      time [s], f64
//! 28..        N records of 120 bytes: 15 numbers f64
//!             present (1 or 0), radius [m], position [m] x y z, orientation w x y z,
//!             velocity [m/s] x y z, angular velocity [rad/s] x y z
//! ```
//!
//! Record and row are the same: see [`crate::table`].

use sphere_dda::simulation::Simulation;
use sphere_dda_model_description::value::Value;

use super::header;
use crate::table::Field;

/// Media type of the binary.
pub const MEDIA_TYPE: &str = "application/x-sphere-dda-spheres";

const MAGIC: &[u8; 8] = b"SDDASPH\0";
const VERSION: u32 = 1;
const RECORD: usize = 120;
/// Numbers of the motion of a sphere.
pub const MOTION: usize = 13;

/// Bytes of the document of `spheres` spheres.
#[must_use]
pub fn size(spheres: usize) -> usize {
    header::LENGTH + RECORD * spheres
}

/// The document at `time` \[s\] of the experiment.
#[must_use]
pub fn of(simulation: &Simulation, time: f64) -> Vec<u8> {
    let kinematics = simulation.kinematics();
    let radius = &simulation.scene().particles.radius;
    let mut bytes = header::document(MAGIC, VERSION, (radius.len(), RECORD), time);
    for (i, &radius) in radius.iter().enumerate() {
        let present = f64::from(u8::from(kinematics.present[i]));
        let numbers = [present, radius].into_iter().chain(motion(simulation, i));
        bytes.extend(numbers.flat_map(f64::to_le_bytes));
    }
    bytes
}

/// Position, orientation w x y z, velocity and angular velocity of a sphere: the columns of [`Field::columns`].
#[must_use]
pub fn motion(simulation: &Simulation, sphere: usize) -> [f64; MOTION] {
    let kinematics = simulation.kinematics();
    let (x, q) = (kinematics.position[sphere], kinematics.orientation[sphere]);
    let (v, w) = {
        let twist = simulation.velocity(sphere);
        (twist.linear, twist.angular)
    };
    [
        x.x, x.y, x.z, q.w, q.i, q.j, q.k, v.x, v.y, v.z, w.x, w.y, w.z,
    ]
}

/// Gives a field of all spheres, row by row.
pub fn field(simulation: &Simulation, field: Field, give: &mut dyn FnMut(Value)) {
    let radius = &simulation.scene().particles.radius;
    for (i, &radius) in radius.iter().enumerate() {
        match field.columns() {
            Some(columns) => {
                let numbers = motion(simulation, i);
                numbers[columns].iter().for_each(|&x| give(Value::Real(x)));
            }
            None => give(match field {
                Field::Id => Value::Integer(i as i64),
                Field::Present => Value::Boolean(simulation.kinematics().present[i]),
                _ => Value::Real(radius),
            }),
        }
    }
}
