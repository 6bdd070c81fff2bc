//! Vectors, poses and boxes in space: what moves a body and where it lies.

pub mod cell;
pub(crate) mod extent;
mod pose;
mod vector;

pub(crate) use pose::Displacement;
pub use pose::{Pose, turned};
pub(crate) use vector::SpatialOperator;
pub use vector::{SpatialVector, Twist, Wrench};
