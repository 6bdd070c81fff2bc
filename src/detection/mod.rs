//! Contact detection: broad phase over a grid, spheres near walls, narrow phase, sweep (ways through a step).

pub mod broad_phase;
pub mod grid;
pub mod narrow_phase;
pub mod near_walls;
pub mod periodic;
pub mod sweep;
