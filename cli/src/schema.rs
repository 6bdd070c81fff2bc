//! `sphere-dda schema`: the JSON schema of scene files, or their reference.

use clap::Args;
use sphere_dda::scene_file::json_schema;

use crate::failure::Failure;
use crate::progress::print;
use crate::reference;

/// Arguments of `schema`.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  sphere-dda schema > scene.schema.json")]
pub(crate) struct Schema {
    /// Print the reference of scene files (Markdown) instead.
    #[arg(long)]
    markdown: bool,
}

/// Prints the schema or the reference.
///
/// # Errors
/// A standard output that cannot be written.
pub(crate) fn run(arguments: &Schema) -> Result<(), Failure> {
    let schema = json_schema();
    print(|out| {
        if arguments.markdown {
            write!(out, "{}", reference::markdown(&schema))
        } else {
            writeln!(out, "{schema:#}")
        }
    })
}
