//! The model descriptions of a scene.

mod definitions;
pub mod version2;
pub mod version3;
