//! The header of the binaries `spheres.document` and `contacts.document`.
//!
//! ```text
//! bytes       what, little endian
//! 0..8        magic
//! 8..12       version of the layout, u32
//! 12..20      number of records, u64
//! 20..28      time [s], f64
//! ```

/// Bytes of the header.
pub(super) const LENGTH: usize = 28;

/// A document of `records` of `size` bytes that are still to be written, with its header.
pub(super) fn document(
    magic: &[u8; 8],
    version: u32,
    (records, size): (usize, usize),
    time: f64,
) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(LENGTH + records * size);
    bytes.extend_from_slice(magic);
    bytes.extend_from_slice(&version.to_le_bytes());
    bytes.extend_from_slice(&(records as u64).to_le_bytes());
    bytes.extend_from_slice(&time.to_le_bytes());
    bytes
}
