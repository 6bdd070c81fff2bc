//! The master: one simulation of a system, from start to stop.

mod accelerate;
mod communication_points;
mod components;
mod drive;
mod error;
mod event;
mod exchange;
mod halt;
mod input_table;
mod iterate;
mod options;
mod simulate;
mod table;

pub use error::SimulateError;
pub use event::Event;
pub use input_table::{InputTable, InputTableError};
pub use options::{Coupling, Iteration, Options};
pub use simulate::simulate;
pub use table::{Column, CsvWriter, End, NotConverged, Table};
