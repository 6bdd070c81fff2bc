//! Closed forms the solver has to meet. Each test derives its answer in its comment; `README.md` beside this
//! file lists how each was seen to fail.

#![allow(unreachable_pub, reason = "a test crate has no outside")]

mod belts;
mod contact_statics;
mod driven;
mod free_motion;
mod impact;
mod incline;
mod paper_examples;
mod pinched;
mod regions;
mod resistance;
mod solvers;
mod springs;
mod support;
