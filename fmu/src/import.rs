//! Runs foreign FMUs, alone or coupled: any co-simulation FMU of FMI 2.0 or 3.0 with a library for this system.
//!
//! | type or function | is                                                                     |
//! |------------------|------------------------------------------------------------------------|
//! | [`Fmu`]          | an unpacked archive and its model description; loads the library once   |
//! | [`Instance`]     | one running instance: every call of the standard, judged by its status  |
//! | [`System`]       | one FMU, or several with outputs connected to inputs; to an SSP          |
//! | [`Ssp`]          | FMUs, connections and parameters from an SSP                             |
//! | [`simulate`]     | a small master: inputs from a table, outputs to a table                 |
//!
//! The archive and the description are untrusted: they are read within limits and refused with a reason. The
//! library itself is native code of this process. It is called as the standard says, in the order it says, so
//! that a library that keeps to the standard cannot do harm; one that does not can do anything, as everywhere.
//!
//! ```no_run
//! use sphere_dda_fmu::import::{Fmu, Options, System, simulate};
//! use std::ops::ControlFlow;
//!
//! let fmu = Fmu::open("funnel.fmu")?;
//! let table = simulate(&System::of(&fmu), &Options::default(), |_| ControlFlow::Continue(()))?;
//! table.write_csv(std::io::stdout())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod archive;
mod connection;
mod description;
mod error;
mod exchange;
mod fmi2;
mod fmi3;
mod grid;
mod instance;
mod iterate;
mod library;
mod logger;
mod package;
mod participant;
mod quantity;
mod run;
mod signals;
mod simulate;
mod ssp;
mod system;
mod table;
mod values;

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use sphere_dda_model_description::{MAX_BYTES, names};
use tempfile::TempDir;

pub use archive::{ArchiveError, Limits, RATIO_FLOOR};
pub use connection::{ConnectionError, ConnectionFault};
pub use description::Description;
pub use error::ImportError;
pub use instance::{Instance, SavedState, Step};
pub use iterate::{Iteration, Unsettled};
pub use logger::Message;
pub use package::PackageError;
pub use signals::{Signals, SignalsError};
pub use simulate::{Coupling, Event, Options, SimulateError, simulate};
pub use ssp::{Ssp, SspError};
pub use system::{System, SystemError};
pub use table::{Column, End, Table};
pub use values::{Base, Value, Values, VariableError};

use archive::Unpacked;
use library::{Interface, Library};
use logger::RawStatus;
use participant::Participant;
use quantity::{MAX_ELEMENTS, Quantity, quantities_2, quantities_3};

/// What a function of the interface says about its work: `fmi2Status`, `fmi3Status`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// All well.
    Ok,
    /// Not quite right, but the simulation can go on.
    Warning,
    /// The call was refused, or a step was done in part only; nothing is broken.
    Discard,
    /// This instance cannot go on; it can be reset, restored or freed.
    Error,
    /// All instances of the FMU are beyond repair; none may be called again, not even to free it.
    Fatal,
    /// A step is still under way.
    Pending,
}

impl Status {
    fn from_raw(raw: RawStatus) -> Option<Self> {
        Some(match raw {
            0 => Self::Ok,
            1 => Self::Warning,
            2 => Self::Discard,
            3 => Self::Error,
            4 => Self::Fatal,
            5 => Self::Pending,
            _ => return None,
        })
    }
}

impl fmt::Display for Status {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Ok => "OK",
            Self::Warning => "Warning",
            Self::Discard => "Discard",
            Self::Error => "Error",
            Self::Fatal => "Fatal",
            Self::Pending => "Pending",
        })
    }
}

/// Where an instance is in its life: section 4.2.4 of FMI 2.0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Made, not yet initialized.
    Instantiated,
    /// In initialization mode.
    Initialization,
    /// At a communication point.
    Stepping,
    /// After a step that was discarded.
    Discarded,
    /// After a call that returned `Error`.
    Failed,
    /// Terminated.
    Terminated,
    /// After a call of any instance of the FMU that returned `Fatal`.
    Dead,
}

impl fmt::Display for Phase {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Instantiated => "instantiated",
            Self::Initialization => "in initialization mode",
            Self::Stepping => "at a communication point",
            Self::Discarded => "after a discarded step",
            Self::Failed => "after an error",
            Self::Terminated => "terminated",
            Self::Dead => "beyond repair",
        })
    }
}

/// Unpacks an archive and gives it and the text of its description.
fn unpack(path: &Path, limits: Limits) -> Result<(Unpacked, String), ImportError> {
    let path = path.to_owned();
    let unpacked = match archive::unpack(&path, limits) {
        Ok(unpacked) => unpacked,
        Err(source) => return Err(ImportError::Archive { path, source }),
    };
    match text(&unpacked.folder.path().join("modelDescription.xml")) {
        Ok(text) => Ok((unpacked, text)),
        Err(problem) => Err(ImportError::NoDescription { path, problem }),
    }
}

/// The text of a file that is not too long for XML.
fn text(path: &Path) -> io::Result<String> {
    let length = fs::metadata(path)?.len();
    if length > MAX_BYTES as u64 {
        return Err(io::Error::other(format!(
            "found {length} bytes, expected at most {MAX_BYTES}"
        )));
    }
    fs::read_to_string(path)
}

/// The library, once it is loaded.
#[derive(Debug)]
enum Loaded {
    Two(Arc<Library<fmi2::Functions>>),
    Three(Arc<Library<fmi3::Functions>>),
}

/// An unpacked FMU. Its folder is removed when it and its last instance are dropped.
#[derive(Debug)]
pub struct Fmu {
    path: PathBuf,
    folder: Arc<TempDir>,
    /// Size of all its files, unpacked \[byte\].
    bytes: u64,
    description: Description,
    quantities: Vec<Quantity>,
    library: Mutex<Option<Loaded>>,
}

impl Fmu {
    /// Unpacks the archive at `path` within the default [`Limits`] and reads its description. The library is not
    /// loaded before the first [`instantiate`](Self::instantiate).
    ///
    /// # Errors
    ///
    /// [`ImportError::Archive`], [`NoDescription`](ImportError::NoDescription),
    /// [`Description`](ImportError::Description), [`NoCoSimulation`](ImportError::NoCoSimulation),
    /// [`ModelIdentifier`](ImportError::ModelIdentifier) and [`Elements`](ImportError::Elements).
    pub fn open(path: impl AsRef<Path>) -> Result<Self, ImportError> {
        Self::open_within(path, Limits::default())
    }

    /// As [`open`](Self::open), within other limits.
    ///
    /// # Errors
    ///
    /// As [`open`](Self::open).
    pub fn open_within(path: impl AsRef<Path>, limits: Limits) -> Result<Self, ImportError> {
        let path = path.as_ref().to_owned();
        let (Unpacked { folder, bytes }, text) = unpack(&path, limits)?;
        let description = match Description::from_xml(&text) {
            Ok(description) => description,
            Err(source) => return Err(ImportError::Description { path, source }),
        };
        if !description.offers_co_simulation() {
            return Err(ImportError::NoCoSimulation { path });
        }
        if !names::is_c_identifier(description.model_identifier()) {
            let found = description.model_identifier().to_owned();
            return Err(ImportError::ModelIdentifier { path, found });
        }
        let quantities = match &description {
            Description::Two(own) => Ok(quantities_2(own)),
            Description::Three(own) => quantities_3(own),
        };
        let quantities = match quantities {
            Ok(quantities) => quantities,
            Err((name, found)) => {
                let limit = MAX_ELEMENTS;
                return Err(ImportError::Elements {
                    path,
                    name,
                    found,
                    limit,
                });
            }
        };
        Ok(Self {
            path,
            folder: Arc::new(folder),
            bytes,
            description,
            quantities,
            library: Mutex::new(None),
        })
    }

    /// Where the archive was read from.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The folder that it is unpacked to.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// The model description.
    pub fn description(&self) -> &Description {
        &self.description
    }

    fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    /// Makes an instance of an FMU of FMI 2.0, loading the library if none is loaded yet. [`simulate`] runs those of
    /// FMI 3.0 too.
    ///
    /// `logging` asks the FMU to log more than warnings and errors.
    ///
    /// # Errors
    ///
    /// [`ImportError::NoBinary`], [`Load`](ImportError::Load), [`MissingFunction`](ImportError::MissingFunction),
    /// [`Interface`](ImportError::Interface), [`OnlyOnce`](ImportError::OnlyOnce),
    /// [`Instantiate`](ImportError::Instantiate), [`Phase`](ImportError::Phase) after a `Fatal`,
    /// [`Nul`](ImportError::Nul), [`Version`](ImportError::Version).
    pub fn instantiate(&self, name: &str, logging: bool) -> Result<Instance, ImportError> {
        match self.library()? {
            Loaded::Two(library) => Instance::<fmi2::Functions>::new(library, self, name, logging),
            Loaded::Three(_) => Err(ImportError::Version {
                path: self.path.clone(),
            }),
        }
    }

    /// As [`instantiate`](Self::instantiate), of either version.
    fn participant(&self, name: &str, logging: bool) -> Result<Box<dyn Participant>, ImportError> {
        Ok(match self.library()? {
            Loaded::Two(library) => Box::new(Instance::<fmi2::Functions>::new(
                library, self, name, logging,
            )?),
            Loaded::Three(library) => {
                let instance = Instance::<fmi3::Functions>::new(library, self, name, logging)?;
                Box::new(fmi3::Arrays::new(instance, &self.quantities))
            }
        })
    }

    /// Names of the optional functions of the interface that the library does not have.
    ///
    /// # Errors
    ///
    /// Those of loading: see [`instantiate`](Self::instantiate).
    pub fn missing_functions(&self) -> Result<Vec<&'static str>, ImportError> {
        Ok(match self.library()? {
            Loaded::Two(library) => library.functions.missing().to_vec(),
            Loaded::Three(library) => library.functions.missing().to_vec(),
        })
    }

    fn library(&self) -> Result<Loaded, ImportError> {
        let mut slot = self.library.lock().unwrap_or_else(PoisonError::into_inner);
        let loaded = match &*slot {
            Some(loaded) => loaded.again(),
            None => {
                let loaded = match self.description {
                    Description::Two(_) => Loaded::Two(Arc::new(Library::load(self)?)),
                    Description::Three(_) => Loaded::Three(Arc::new(Library::load(self)?)),
                };
                slot.insert(loaded).again()
            }
        };
        Ok(loaded)
    }
}

impl Loaded {
    fn again(&self) -> Self {
        match self {
            Self::Two(library) => Self::Two(Arc::clone(library)),
            Self::Three(library) => Self::Three(Arc::clone(library)),
        }
    }
}
