//! A system of FMUs from an SSP 1.0 archive: flat, with the values of its parameter sets.
//!
//! What would change the meaning if it were passed over is refused: systems in systems, transformations of values,
//! mappings of parameter names, units that differ. Connectors of the system itself lead nowhere and are passed over.

use std::path::{Path, PathBuf};

use percent_encoding::percent_decode_str;
use sphere_dda_model_description::Error as XmlError;
use thiserror::Error;

use crate::error::{ArchiveError, ImportError};
use crate::fmu::Fmu;
use crate::open::{Limits, inner_path, text, unpack};
use crate::system::{System, SystemError};

use super::xml::read::{Binding, Component, Element, Parameter, ParameterSet, Structure};

/// Name of the structure in the archive.
const STRUCTURE: &str = "SystemStructure.ssd";

/// Most components: each can be a library in this process.
const MAX_COMPONENTS: usize = 1000;

/// Why an SSP cannot be used.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SspError {
    /// The file is not an archive that can be unpacked.
    #[error("{path}: {source}", path = path.display())]
    Archive {
        /// The SSP.
        path: PathBuf,
        /// What is wrong with it.
        source: ArchiveError,
    },
    /// A file in it cannot be read.
    #[error("{path}: {place}: {source}; expected a text in UTF-8", path = path.display())]
    Read {
        /// The SSP.
        path: PathBuf,
        /// Path in the archive.
        place: String,
        /// What the system says.
        source: std::io::Error,
    },
    /// A file in it cannot be understood.
    #[error("{path}: {place}: {source}; expected a file of SSP 1.0", path = path.display())]
    Xml {
        /// The SSP.
        path: PathBuf,
        /// Path in the archive.
        place: String,
        /// Where and why.
        source: XmlError,
    },
    /// What is not understood, or not done: all of it.
    #[error("{}", list(.path, .problems))]
    Refused {
        /// The SSP.
        path: PathBuf,
        /// One line each.
        problems: Vec<String>,
    },
    /// An FMU in it cannot be used.
    #[error("{path}: {source}", path = path.display())]
    Fmu {
        /// The SSP.
        path: PathBuf,
        /// Why.
        source: Box<ImportError>,
    },
}

fn list(path: &Path, problems: &[String]) -> String {
    let lines = problems.iter();
    let lines: Vec<String> = lines
        .map(|problem| format!("{}: {STRUCTURE}: {problem}", path.display()))
        .collect();
    lines.join("\n")
}

/// An unpacked SSP with its FMUs.
#[derive(Debug)]
pub struct Ssp {
    fmus: Vec<Fmu>,
    /// Name, and number of the FMU.
    components: Vec<(String, usize)>,
    connections: Vec<(String, String)>,
    /// Name, text and unit of each value, the weaker before the stronger.
    values: Vec<(String, String, Option<String>)>,
    experiment: (Option<f64>, Option<f64>),
    path: PathBuf,
}

impl Ssp {
    /// Unpacks the archive at `path` and the FMUs in it, all together within the default [`Limits`].
    ///
    /// # Errors
    ///
    /// [`SspError`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self, SspError> {
        Self::open_within(path, Limits::default())
    }

    /// As [`open`](Self::open), within other limits.
    ///
    /// # Errors
    ///
    /// [`SspError`].
    pub fn open_within(path: impl AsRef<Path>, limits: Limits) -> Result<Self, SspError> {
        let path = path.as_ref().to_owned();
        let unpacked = unpack(&path, limits);
        let unpacked = unpacked.map_err(|source| SspError::Archive {
            path: path.clone(),
            source,
        })?;
        let mut reader = Reader {
            path: &path,
            folder: unpacked.folder.path(),
            problems: Vec::new(),
        };
        let structure = reader.xml(STRUCTURE, Structure::from_xml)?;
        let mut read = Self {
            fmus: Vec::new(),
            components: Vec::new(),
            connections: Vec::new(),
            values: Vec::new(),
            experiment: (
                structure.experiment.start_time,
                structure.experiment.stop_time,
            ),
            path: path.clone(),
        };
        let mut sources: Vec<PathBuf> = Vec::new();
        for element in &structure.system.elements.items {
            let Some((component, source)) = reader.component(element) else {
                continue;
            };
            let known = sources.iter().position(|known| *known == source);
            let number = known.unwrap_or(sources.len());
            if known.is_none() {
                sources.push(source);
            }
            read.components.push((component.name.clone(), number));
            for binding in &component.bindings.items {
                let prefix = format!("{}.{}", component.name, binding.prefix);
                read.values.extend(reader.values(binding, &prefix)?);
            }
        }
        // Values of the system are stronger than those of its components.
        for binding in &structure.system.bindings.items {
            read.values.extend(reader.values(binding, &binding.prefix)?);
        }
        for wire in &structure.system.connections.items {
            let (Some(from), Some(to)) = (&wire.start_element, &wire.end_element) else {
                continue;
            };
            let (from, to) = (
                format!("{from}.{}", wire.start_connector),
                format!("{to}.{}", wire.end_connector),
            );
            if wire.transforms() {
                reader.refuse(format!(
                    "connection `{from}` to `{to}`: found a transformation, expected none: values are not converted"
                ));
            }
            read.connections.push((from, to));
        }
        if read.components.len() > MAX_COMPONENTS {
            let found = read.components.len();
            reader.refuse(format!(
                "found {found} components, expected at most {MAX_COMPONENTS}"
            ));
        }
        if read.components.is_empty() && reader.problems.is_empty() {
            reader.refuse("found no component, expected at least one".to_owned());
        }
        let problems = reader.problems;
        if !problems.is_empty() {
            return Err(SspError::Refused { path, problems });
        }
        let mut left = limits.bytes - unpacked.bytes;
        for source in sources {
            let within = Limits {
                bytes: left,
                ..limits
            };
            let fmu = Fmu::open_within(&source, within).map_err(|source| SspError::Fmu {
                path: path.clone(),
                source: Box::new(source),
            })?;
            left -= fmu.bytes();
            read.fmus.push(fmu);
        }
        Ok(read)
    }

    /// The system: its components in the order of the structure, which is that of their steps.
    ///
    /// # Errors
    ///
    /// [`SystemError`].
    pub fn system(&self) -> Result<System<'_>, SystemError> {
        let components = self.components.iter();
        let named =
            components.filter_map(|(name, number)| Some((name.clone(), self.fmus.get(*number)?)));
        let mut system = System::coupled(named)?;
        let pairs = self.connections.iter();
        system.connect(pairs.map(|(from, to)| (&**from, &**to)))?;
        Ok(system)
    }

    /// Names and texts of the parameter values, each name once.
    ///
    /// # Errors
    ///
    /// [`SspError::Refused`] for values in another unit than their variables.
    pub fn set(&self, system: &System<'_>) -> Result<Vec<(String, String)>, SspError> {
        let mut set: Vec<(String, String)> = Vec::new();
        let mut problems = Vec::new();
        for (name, text, unit) in &self.values {
            // Names that are not there are refused where the values are set.
            let own = system.find(name).ok();
            let own = own.and_then(|variable| variable.declared.unit.as_ref());
            if let (Some(unit), Some(own)) = (unit, own)
                && *unit != own.name
            {
                problems.push(format!(
                    "parameter `{name}`: found a value in `{unit}`, expected it in `{}`: values are not converted",
                    own.name
                ));
            }
            match set.iter_mut().find(|(known, _)| known == name) {
                Some((_, old)) => old.clone_from(text),
                None => set.push((name.clone(), text.clone())),
            }
        }
        if problems.is_empty() {
            return Ok(set);
        }
        let path = self.path.clone();
        Err(SspError::Refused { path, problems })
    }

    /// Start and stop time that the structure suggests \[s\].
    pub fn experiment(&self) -> (Option<f64>, Option<f64>) {
        self.experiment
    }
}

/// Reads files of an unpacked archive and collects what is refused.
struct Reader<'a> {
    path: &'a Path,
    folder: &'a Path,
    problems: Vec<String>,
}

impl Reader<'_> {
    fn refuse(&mut self, problem: String) {
        self.problems.push(problem);
    }

    fn xml<T>(
        &self,
        place: &str,
        read: impl FnOnce(&str) -> Result<T, XmlError>,
    ) -> Result<T, SspError> {
        let text = text(&self.folder.join(place)).map_err(|source| SspError::Read {
            path: self.path.to_owned(),
            place: place.to_owned(),
            source,
        })?;
        read(&text).map_err(|source| SspError::Xml {
            path: self.path.to_owned(),
            place: place.to_owned(),
            source,
        })
    }

    /// Where in the archive an URI leads to; `None`, with the reason, if that is not a file in it.
    fn file(&mut self, what: &str, uri: &str) -> Option<String> {
        let decoded = percent_decode_str(uri).decode_utf8_lossy();
        let inner = inner_path(&decoded).filter(|inner| self.folder.join(inner).is_file());
        if inner.is_none() {
            self.refuse(format!(
                "{what}: found source {uri:?}, expected the relative path of a file in the archive"
            ));
        }
        inner.map(|inner| inner.to_string_lossy().into_owned())
    }

    fn component<'e>(&mut self, element: &'e Element) -> Option<(&'e Component, PathBuf)> {
        match element {
            Element::Component(component) if component.is_fmu() => {
                let what = format!("component `{}`", component.name);
                let file = self.file(&what, &component.source)?;
                Some((component, self.folder.join(file)))
            }
            Element::Component(component) => {
                self.refuse(format!(
                    "component `{}`: found type `{}` and implementation `{}`, expected an FMU for co-simulation",
                    component.name,
                    component.kind.as_deref().unwrap_or("(none)"),
                    component.implementation.as_deref().unwrap_or("(none)")
                ));
                None
            }
            Element::System(named) => {
                self.refuse(format!(
                    "system `{}`: found a system within a system, expected components only: write it flat",
                    named.name
                ));
                None
            }
            Element::SignalDictionaryReference(named) => {
                self.refuse(format!(
                    "`{}`: found a signal dictionary, expected connections between components",
                    named.name
                ));
                None
            }
        }
    }

    /// Names, texts and units of the values of a binding.
    fn values(
        &mut self,
        binding: &Binding,
        prefix: &str,
    ) -> Result<Vec<(String, String, Option<String>)>, SspError> {
        if binding.maps() {
            self.refuse(
                "parameter binding: found a mapping of names, expected the names of variables"
                    .to_owned(),
            );
        }
        let inside = binding.source_base.as_deref().unwrap_or("SSD") == "SSD";
        let file = match &binding.source {
            None => None,
            Some(source) if inside => match self.file("parameter binding", source) {
                Some(file) => Some(file),
                None => return Ok(Vec::new()),
            },
            Some(source) => {
                self.refuse(format!(
                    "parameter binding: found source {source:?} within a component, expected one beside {STRUCTURE}"
                ));
                return Ok(Vec::new());
            }
        };
        let set = match (file, &binding.values) {
            (Some(file), _) => self.xml(&file, ParameterSet::from_xml)?,
            (None, Some(values)) => values.set.clone(),
            (None, None) => return Ok(Vec::new()),
        };
        let value = |parameter: &Parameter| {
            let (text, unit) = parameter.value()?;
            let name = format!("{prefix}{}", parameter.name);
            Some((name, text.to_owned(), unit.map(str::to_owned)))
        };
        let parameters = &set.parameters.items;
        for parameter in parameters.iter().filter(|own| own.value().is_none()) {
            self.refuse(format!(
                "parameter `{prefix}{}`: found no value, expected one of type Real, Integer, Boolean, String or Enumeration",
                parameter.name
            ));
        }
        Ok(parameters.iter().filter_map(value).collect())
    }
}
