//! Contact detection: broad phase over a grid, spheres near boundaries, narrow phase, sweep (ways through a step).

pub mod broad_phase;
pub mod configuration;
pub mod detection_distance;
pub mod grid;
pub mod narrow_phase;
pub mod near_boundaries;
pub mod periodic;
pub mod sweep;
