//! Files and bytes: VTU, PVD, the table of a history, snapshots, and what can go wrong with them.

pub mod durable;
pub mod error;
pub mod pvd;
pub mod snapshot;
pub mod table;
pub mod vtu;
