//! One FMU: its archive, its variables, and its library once that is needed.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use crate::calls::{Arrays, Fmi2, Fmi3, Instance, Instance2, Library, Participant, Watch};
use crate::error::ImportError;
use crate::open::{Description, Folder, Limits, Opened};
use crate::variable::{MAX_ELEMENTS, Variable, variables_2, variables_3};

/// The library, once it is loaded.
#[derive(Debug)]
enum Loaded {
    Two(Arc<Library<Fmi2>>),
    Three(Arc<Library<Fmi3>>),
}

/// An unpacked FMU. Its folder is removed when it and its last instance are dropped.
#[derive(Debug)]
pub struct Fmu {
    opened: Opened,
    variables: Vec<Variable>,
    library: Mutex<Option<Loaded>>,
    watch: Watch,
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
        Self::of(Opened::within(path.as_ref(), limits)?, Watch::default())
    }

    /// One that another process has unpacked to `folder` from the archive at `path`; `watch` hears what its library does.
    pub(crate) fn unpacked(
        path: PathBuf,
        folder: PathBuf,
        watch: Watch,
    ) -> Result<Self, ImportError> {
        Self::of(Opened::read(path, Folder::OfAnother(folder), 0)?, watch)
    }

    fn of(opened: Opened, watch: Watch) -> Result<Self, ImportError> {
        let variables = match &opened.description {
            Description::Two(own) => Ok(variables_2(own)),
            Description::Three(own) => variables_3(own),
        };
        match variables {
            Ok(variables) => Ok(Self {
                opened,
                variables,
                library: Mutex::new(None),
                watch,
            }),
            Err((name, found)) => Err(ImportError::Elements {
                path: opened.path,
                name,
                found,
                limit: MAX_ELEMENTS,
            }),
        }
    }

    /// Where the archive was read from.
    pub fn path(&self) -> &Path {
        &self.opened.path
    }

    /// The folder that it is unpacked to.
    pub fn folder(&self) -> &Path {
        self.opened.folder.path()
    }

    /// The model description.
    pub fn description(&self) -> &Description {
        &self.opened.description
    }

    /// Size of all its files, unpacked \[byte\].
    pub(crate) fn bytes(&self) -> u64 {
        self.opened.bytes
    }

    pub(crate) fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// Makes an instance of an FMU of FMI 2.0, loading the library if none is loaded yet. [`simulate`](crate::simulate) runs those of
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
    pub fn instantiate(&self, name: &str, logging: bool) -> Result<Instance2, ImportError> {
        match self.library()? {
            Loaded::Two(library) => Instance::<Fmi2>::new(library, &self.opened, name, logging),
            Loaded::Three(_) => Err(ImportError::Version {
                path: self.opened.path.clone(),
            }),
        }
    }

    /// As [`instantiate`](Self::instantiate), of either version.
    pub(crate) fn participant(
        &self,
        name: &str,
        logging: bool,
    ) -> Result<Box<dyn Participant>, ImportError> {
        Ok(match self.library()? {
            Loaded::Two(library) => {
                Box::new(Instance::<Fmi2>::new(library, &self.opened, name, logging)?)
            }
            Loaded::Three(library) => {
                let instance = Instance::<Fmi3>::new(library, &self.opened, name, logging)?;
                Box::new(Arrays::new(
                    instance,
                    &self.opened.description,
                    &self.variables,
                ))
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
            Loaded::Two(library) => library.functions.missing.clone(),
            Loaded::Three(library) => library.functions.missing.clone(),
        })
    }

    fn library(&self) -> Result<Loaded, ImportError> {
        let mut slot = self.library.lock().unwrap_or_else(PoisonError::into_inner);
        let loaded = match &*slot {
            Some(loaded) => loaded.again(),
            None => {
                let loaded = match self.opened.description {
                    Description::Two(_) => {
                        Loaded::Two(Arc::new(Library::load(&self.opened, &self.watch)?))
                    }
                    Description::Three(_) => {
                        Loaded::Three(Arc::new(Library::load(&self.opened, &self.watch)?))
                    }
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
