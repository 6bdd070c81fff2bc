//! Faults that were found in use: one file for each, with its symptom and its cause. `README.md` beside this file lists what
//! became of them.

#![allow(unreachable_pub, reason = "a test crate has no outside")]

mod bounds;
mod compliance;
mod far_away;
mod impacts;
mod invariance;
mod jammed;
mod ring;
mod rolling_hollow;
mod sleeping;
mod starts;
mod support;
mod turning;
mod wedged;
