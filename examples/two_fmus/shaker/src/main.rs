//! Writes `shaker.fmu`, or another file that is named.

use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1);
    let fmu = arguments
        .next()
        .map_or_else(|| PathBuf::from("shaker.fmu"), PathBuf::from);
    if arguments.next().is_some() {
        eprintln!("export-shaker: found more than one argument, expected the file to write");
        return ExitCode::from(2);
    }
    match shaker::export::export(&fmu) {
        Ok(()) => {
            println!("{}", fmu.display());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("export-shaker: {error}");
            ExitCode::FAILURE
        }
    }
}
