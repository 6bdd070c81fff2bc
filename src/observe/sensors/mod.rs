//! Sensors: what is inside a region ([`region`], with the volumes of `solid` and the branches of `branch`), and
//! the mass that passes a plane or a polygon ([`flow`](crate::simulation::flow)). Spheres that are absent never count.

pub(crate) mod branch;
pub mod region;
pub(crate) mod solid;
