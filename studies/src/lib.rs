//! Reports: what the solver does, measured by running it, as Markdown with plots and pictures.
//!
//! [`document`] and [`table`] hold the text, [`folder`] puts it on the disk with the drawings, [`report`] keeps them
//! together, [`parallel`] runs the cases, [`Watch`] follows them. [`paper`] is the study of Beyabanaki and Bagtzoglou (2020), [`laws`] that of
//! the laws of granular matter, [`corpus`] that of contact problems of others. Nothing in a report depends on
//! the clock, the number of threads or the machine's load.

pub mod corpus;
pub mod document;
pub mod error;
pub mod folder;
pub mod laws;
pub mod paper;
pub mod parallel;
pub mod report;
pub mod table;
mod watch;

pub use watch::{Part, Unwatched, Watch};
