//! The functional mock-up unit of sphere-dda, and a small master for FMUs of any kind.

pub mod import;
pub mod resource;
