//! The `sphere-dda` command as a user meets it: files, messages, exit codes.

mod check;
mod command;
mod fmus;
mod interrupted;
mod paper;
mod refused;
mod runs;
