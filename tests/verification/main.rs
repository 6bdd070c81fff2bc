//! Closed forms the solver has to meet. Each test derives its answer in its comment; `README.md` beside this
//! file lists how each was seen to fail.

#![allow(unreachable_pub, reason = "a test crate has no outside")]

mod adhesion;
mod adhesion_scenes;
mod any_scene;
mod applied_forces;
mod axes;
mod belts;
mod clump_scenes;
mod clumps;
mod cohesion;
mod cohesion_scenes;
mod compliant;
mod contact_statics;
mod convergence;
mod cooling;
mod defaults;
mod derivatives;
mod driven;
mod driven_scenes;
mod edges;
mod elastic_bonds;
mod frames;
mod free_motion;
mod holds;
mod impact;
mod incline;
mod invariance;
mod jams;
mod joints;
mod ledger;
mod light;
mod pace;
mod paper_examples;
mod periodic;
mod pinched;
mod problems;
mod regions;
mod registers;
mod resistance;
mod rest;
mod rolling;
mod scenes;
mod simultaneous;
mod sleep;
mod solvers;
mod springs;
mod support;
mod tunnelling;
mod turntable;
mod walls;
mod wedge;
