//! Results as files: what [`writer::Results`] puts into a [`directory`] without keeping the solver waiting for the disk.

pub mod checkpoint;
pub mod directory;
mod disk;
pub mod frames;
pub mod history;
pub mod start_file;
pub mod writer;
