//! Contact detection: broad phase over a grid, spheres near boundaries, narrow phase, sweep (paths through a step).

pub mod broad_phase;
pub mod configuration;
pub mod detection_distance;
pub(crate) mod grid;
pub(crate) mod narrow_phase;
pub(crate) mod near_boundaries;
pub(crate) mod periodic;
pub(crate) mod sweep;
