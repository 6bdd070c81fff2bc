//! A shaker as an FMU: mass, spring and damper on a shaken foot, with a force that the importer gives.
//!
//! ```text
//! m x'' + d x' + k (x - A sin(2 pi f t)) = F + S     F held over every communication step, S constant
//! ```
//!
//! | module       | holds                                                              |
//! |--------------|--------------------------------------------------------------------|
//! | [`model`]    | the equation and its exact step                                     |
//! | [`variables`]| the table of variables: value reference = place                     |
//! | [`instance`] | life cycle, values, states                                          |
//! | [`export`]   | the model description and the archive                               |
//! | `ffi`        | the C functions of FMI 2.0, the only unsafe code                     |

pub mod export;
mod ffi;
pub mod instance;
pub mod model;
pub mod variables;
