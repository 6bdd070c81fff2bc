//! The `sphere-dda` command as a user meets it: files, messages, exit codes.

mod check;
mod command;
mod corpus;
mod failing;
mod fmus;
#[path = "../foreign_fmu/mod.rs"]
#[expect(dead_code, reason = "the tests of the importer use the rest")]
mod foreign_fmu;
mod interrupted;
mod isolated;
mod killed;
mod new;
mod paper;
mod parameters;
mod refused;
mod resumed;
mod runs;
mod schema;
mod settled;
mod view;
