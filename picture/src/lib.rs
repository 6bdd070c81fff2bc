//! Drawings: plots of curves as SVG, spheres and boundaries as SVG or PNG.
//!
//! [`panel`] projects and draws as SVG, [`bitmap`] as PNG, [`portrait`] chooses the view of a scene, [`plot`] draws
//! curves over axes. The same input gives the same bytes.

pub mod bitmap;
pub mod error;
pub mod panel;
pub mod plot;
pub mod portrait;
pub mod viewer;
