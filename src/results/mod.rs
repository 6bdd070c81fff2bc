//! Results as files: the [`frames`] of grids (VTU files listed by PVD collections), the rows of the [`history`] (CSV),
//! [`checkpoint`]s, `run.json` and `view.py`, which [`writer::Results`] puts into a `directory` without keeping the solver
//! waiting for the disk.

pub mod checkpoint;
pub(crate) mod directory;
mod disk;
pub mod folder;
pub mod frames;
pub mod history;
mod names;
mod options;
pub mod start_file;
pub mod writer;

pub use options::Options;
