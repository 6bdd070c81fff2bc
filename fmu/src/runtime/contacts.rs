//! All loaded contacts: their fields, and all as one binary, the variable `contacts.document` of FMI 3.0, media type
//! [`MEDIA_TYPE`].
//!
//! ```text
//! bytes       what, little endian
//! 0..8        magic "SDDACON\0"
//! 8..12       version of this layout, u32: 1
//! 12..20      number of contacts C, u64
//! 20..28      time [s], f64
//! 28..        C records of 120 bytes: 2 numbers i64, 13 numbers f64
//!             row of the sphere, row of the other sphere or -1 - index of the boundary,
//!             closest point on the other body [m] x y z, unit normal to the sphere x y z,
//!             force on the sphere [N] x y z, couple on it [N m] x y z, gap [m]
//! ```
//!
//! Forces are means of the last internal step. A force acts on a sphere of radius R where the normal meets it: at `-R n` from
//! the centre of the sphere, at `+R n` from that of the other.

use sphere_dda::contact::{Contact, Partner};
use sphere_dda::observe::Observation;
use sphere_dda_model_description::value::Value;

use super::header;
use crate::table::ContactField;

/// Media type of the binary.
pub const MEDIA_TYPE: &str = "application/x-sphere-dda-contacts";

const MAGIC: &[u8; 8] = b"SDDACON\0";
const VERSION: u32 = 1;
const RECORD: usize = 120;
/// Real numbers of a contact.
const NUMBERS: usize = 13;

/// The contacts that carry a force or overlap, in canonical order, each with its point beside its sphere.
#[must_use]
pub fn loaded(state: &Observation) -> Vec<Contact> {
    let beside = |contact: &Contact| Contact {
        point: state.contact_point(contact),
        ..*contact
    };
    state.active_contacts().map(beside).collect()
}

/// The document at `time` \[s\] of the experiment.
#[must_use]
pub fn of(contacts: &[Contact], time: f64) -> Vec<u8> {
    let mut bytes = header::document(MAGIC, VERSION, (contacts.len(), RECORD), time);
    for contact in contacts {
        bytes.extend(bodies(contact).into_iter().flat_map(i64::to_le_bytes));
        bytes.extend(numbers(contact).into_iter().flat_map(f64::to_le_bytes));
    }
    bytes
}

/// Gives a field of the first `rows` contacts, row by row; rows without a contact hold -1 or 0.
pub fn field(contacts: &[Contact], rows: usize, field: ContactField, give: &mut dyn FnMut(Value)) {
    for row in 0..rows {
        let contact = contacts.get(row);
        match field.columns() {
            Some(columns) => {
                let numbers = contact.map_or([0.0; NUMBERS], numbers);
                numbers[columns].iter().for_each(|&x| give(Value::Real(x)));
            }
            None => {
                let bodies = contact.map_or([-1; 2], bodies);
                bodies.into_iter().for_each(|x| give(Value::Integer(x)));
            }
        }
    }
}

/// Sphere A; sphere B, or -1 - index of the boundary.
fn bodies(contact: &Contact) -> [i64; 2] {
    let other = match contact.key.partner {
        Partner::Sphere { index, .. } => index.into(),
        Partner::Boundary { boundary, .. } => -1 - i64::from(boundary),
    };
    [contact.key.sphere.into(), other]
}

/// The columns of [`ContactField::columns`].
fn numbers(contact: &Contact) -> [f64; NUMBERS] {
    let mut numbers = [contact.gap; NUMBERS];
    let vectors = [contact.point, contact.normal, contact.force, contact.torque];
    for (place, &number) in numbers.iter_mut().zip(vectors.iter().flatten()) {
        *place = number;
    }
    numbers
}
