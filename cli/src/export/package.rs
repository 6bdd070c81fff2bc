//! `sphere-dda export SCENE --ssp X.ssp`: the FMU and others, connected, in one archive.

use std::path::{Path, PathBuf};

use clap::Args;
use sphere_dda_master::{Fmu, System};

use crate::failure::Failure;
use crate::progress::print;
use crate::simulate::{connection, stem};

/// Arguments about a package.
#[derive(Debug, Args)]
#[command(next_help_heading = "System of FMUs (SSP 1.0)")]
pub(super) struct Package {
    /// Write the FMU, others and the connections between them into this archive, instead of the FMU alone. Names of
    /// variables are `<file name without .fmu>.<variable>` as for `simulate`; the scene's FMU has the scene's name.
    #[arg(long, value_name = "SSP", conflicts_with = "output")]
    pub(super) ssp: Option<PathBuf>,
    /// Another FMU of the system, of FMI 2.0; can be repeated. They step before the scene's, in this order.
    #[arg(long = "with", value_name = "FMU", requires = "ssp")]
    others: Vec<PathBuf>,
    /// Let an output feed an input; can be repeated.
    #[arg(long = "connect", value_name = "OUTPUT=INPUT", value_parser = connection, requires = "ssp")]
    connect: Vec<(String, String)>,
}

impl Package {
    /// The other FMUs.
    pub(super) fn open(&self) -> Result<Vec<Fmu>, Failure> {
        Ok(self
            .others
            .iter()
            .map(Fmu::open)
            .collect::<Result<_, _>>()?)
    }

    /// Connects the FMU of the scene and the others, and writes them to `ssp` with a set of parameters that has the values `set`
    /// and the start values of all others.
    pub(super) fn write(
        &self,
        fmu: &Path,
        others: &[Fmu],
        set: &[(String, String)],
        ssp: &Path,
    ) -> Result<(), Failure> {
        let own = Fmu::open(fmu)?;
        let all = others.iter().chain([&own]);
        let mut system = System::coupled(all.map(|fmu| (stem(fmu.path()), fmu)))?;
        let pairs = self.connect.iter();
        system.connect(pairs.map(|(output, input)| (&**output, &**input)))?;
        system.package(&stem(ssp), set, ssp)?;
        print(|out| {
            writeln!(
                out,
                "{}: {} FMUs, {} connections",
                ssp.display(),
                others.len() + 1,
                self.connect.len()
            )
        })
    }
}
