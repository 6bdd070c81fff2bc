//! An instance: its life cycle, values, steps, saved states and results.

pub mod contacts;
pub mod document;
mod header;
pub mod instance;
pub mod life_cycle;
pub mod recorder;
pub mod refusal;
pub mod resource;
pub mod state;
pub mod walls;
