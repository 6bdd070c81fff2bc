//! Files and bytes: VTU, PVD, the table of a history, snapshots, friction problems, and what can go wrong with them.

pub(crate) mod durable;
pub mod error;
pub mod problem;
pub(crate) mod pvd;
pub mod snapshot;
pub(crate) mod table;
pub mod vtu;
