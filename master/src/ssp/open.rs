//! A system of FMUs from an SSP archive, 1.0 or 2.0: flat, with the values of its parameter sets.
//!
//! What would change the meaning if it were passed over is refused: systems in systems, transformations of values,
//! mappings of parameter names, units that differ. Connectors of the system itself lead nowhere and are passed over.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::path::{Path, PathBuf};

use percent_encoding::percent_decode_str;
use sphere_dda_model_description::Error as XmlError;
use sphere_dda_model_description::fmi3::Causality;
use thiserror::Error;

use crate::error::{ArchiveError, ImportError};
use crate::fmu::Fmu;
use crate::open::{Limits, inner_path, text, unpack};
use crate::system::{System, SystemError};

use super::xml::{
    Component, Element, ParameterBinding, ParameterSet, Structure, System as SspSystem,
};

/// Name of the structure in the archive.
const STRUCTURE: &str = "SystemStructure.ssd";

/// Most components: each can be a library in this process.
const MAX_COMPONENTS: usize = 1000;
/// Most values of parameters of all bindings together, and most connections.
const MAX_VALUES: usize = 200_000;
const MAX_CONNECTIONS: usize = 10_000;

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
    #[error("{path}: {place}: {source}; expected a file of SSP 1.0 or 2.0", path = path.display())]
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

/// Name, text and unit of the value of a parameter.
type ParameterValue = (String, String, Option<String>);

/// An unpacked SSP with its FMUs.
#[derive(Debug)]
pub struct Ssp {
    fmus: Vec<Fmu>,
    /// Name, and number of the FMU.
    components: Vec<(String, usize)>,
    connections: Vec<(String, String)>,
    /// The weaker before the stronger.
    values: Vec<ParameterValue>,
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
        let unpacked = unpack(&path, limits).map_err(|source| SspError::Archive {
            path: path.clone(),
            source,
        })?;
        let mut reader = Reader {
            path: &path,
            folder: unpacked.folder.path(),
            problems: Vec::new(),
        };
        let structure = reader.xml(STRUCTURE, Structure::from_xml)?;
        let (system, experiment) = (&structure.system, &structure.experiment);
        let mut values = Vec::new();
        // Before anything is expanded.
        let within = reader.check_numbers(system);
        let (components, sources) = match within {
            true => reader.components(system, &mut values)?,
            false => Default::default(),
        };
        // Values of the system are stronger than those of its components.
        for binding in system.bindings().iter().filter(|_| within) {
            reader.values(binding, &binding.prefix, &mut values)?;
        }
        let connections = reader.connections(system);
        let problems = reader.problems;
        if !problems.is_empty() {
            return Err(SspError::Refused { path, problems });
        }
        let left = limits.bytes - unpacked.bytes;
        let fmus = open_fmus(&path, &sources, limits, left)?;
        Ok(Self {
            fmus,
            components,
            connections,
            values,
            experiment: (experiment.start_time, experiment.stop_time),
            path,
        })
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
        // The ends of a connection do not say which way the values go, their causalities do.
        let backwards = |name: &str, causality: Causality| {
            let variable = system.known(name);
            variable.is_some_and(|variable| variable.declared.causality == causality)
        };
        let pairs: Vec<(&str, &str)> = self
            .connections
            .iter()
            .map(|(start, end)| {
                match backwards(start, Causality::Input) && backwards(end, Causality::Output) {
                    true => (&**end, &**start),
                    false => (&**start, &**end),
                }
            })
            .collect();
        system.connect(pairs)?;
        Ok(system)
    }

    /// Names and texts of the parameter values, each name once.
    ///
    /// # Errors
    ///
    /// [`SspError::Refused`] for values in another unit than their variables.
    pub fn set(&self, system: &System<'_>) -> Result<Vec<(String, String)>, SspError> {
        let mut set: Vec<(String, String)> = Vec::new();
        let mut places: HashMap<&str, usize> = HashMap::new();
        let mut problems = Vec::new();
        for (name, text, unit) in &self.values {
            // Names that are not there are refused where the values are set.
            let own = system.known(name);
            let own = own.and_then(|variable| variable.declared.unit.as_ref());
            if let (Some(unit), Some(own)) = (unit, own)
                && *unit != own.name
            {
                problems.push(format!(
                    "parameter `{name}`: found a value in `{unit}`, expected it in `{}`: values are not converted",
                    own.name
                ));
            }
            match places.entry(name) {
                Entry::Occupied(place) => set[*place.get()].1.clone_from(text),
                Entry::Vacant(place) => {
                    place.insert(set.len());
                    set.push((name.clone(), text.clone()));
                }
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

/// Opens FMUs that have `left` bytes among them.
fn open_fmus(
    path: &Path,
    sources: &[PathBuf],
    limits: Limits,
    mut left: u64,
) -> Result<Vec<Fmu>, SspError> {
    let mut fmus = Vec::new();
    for source in sources {
        let bytes = left;
        let fmu = Fmu::open_within(source, Limits { bytes, ..limits }).map_err(|source| {
            SspError::Fmu {
                path: path.to_owned(),
                source: Box::new(source),
            }
        })?;
        left -= fmu.bytes();
        fmus.push(fmu);
    }
    Ok(fmus)
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

    /// Names of the components with the numbers of their FMUs, and the files of these; adds the components' values.
    #[expect(clippy::type_complexity, reason = "two lists, named above")]
    fn components(
        &mut self,
        system: &SspSystem,
        values: &mut Vec<ParameterValue>,
    ) -> Result<(Vec<(String, usize)>, Vec<PathBuf>), SspError> {
        let (mut components, mut sources) = (Vec::new(), Vec::new());
        for element in system.elements() {
            let Some((component, source)) = self.component(element) else {
                continue;
            };
            let known = sources.iter().position(|known| *known == source);
            let number = known.unwrap_or(sources.len());
            if known.is_none() {
                sources.push(source);
            }
            components.push((component.name.clone(), number));
            for binding in component.bindings() {
                let prefix = format!("{}.{}", component.name, binding.prefix);
                self.values(binding, &prefix, values)?;
            }
        }
        Ok((components, sources))
    }

    /// Full names of the connectors at both ends of each connection between components.
    fn connections(&mut self, system: &SspSystem) -> Vec<(String, String)> {
        let mut connections = Vec::new();
        for wire in system.connections() {
            let (Some(from), Some(to)) = (&wire.start_element, &wire.end_element) else {
                continue;
            };
            let from = format!("{from}.{}", wire.start_connector);
            let to = format!("{to}.{}", wire.end_connector);
            if wire.transforms() {
                self.refuse(format!(
                    "connection `{from}` to `{to}`: found a transformation, expected none: values are not converted"
                ));
            }
            if wire.has_indices() {
                self.refuse(format!(
                    "connection `{from}` to `{to}`: found startIndices or endIndices, expected none, since SSP does not say where \
                     they count from: connect whole arrays, or name an element, as `y[1]`"
                ));
            }
            connections.push((from, to));
        }
        connections
    }

    /// Refuses structures that are empty or too large. Returns whether there are not too many components.
    fn check_numbers(&mut self, system: &SspSystem) -> bool {
        let [components, connections] = [system.elements().len(), system.connections().len()];
        for (found, most, what) in [
            (components, MAX_COMPONENTS, "components"),
            (connections, MAX_CONNECTIONS, "connections"),
        ] {
            if found > most {
                self.refuse(format!("found {found} {what}, expected at most {most}"));
            }
        }
        if components == 0 {
            self.refuse("found no component, expected at least one".to_owned());
        }
        components <= MAX_COMPONENTS
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

    /// Adds the values of a binding; none, with the reason, if it cannot be followed.
    fn values(
        &mut self,
        binding: &ParameterBinding,
        prefix: &str,
        values: &mut Vec<ParameterValue>,
    ) -> Result<(), SspError> {
        if values.len() > MAX_VALUES {
            return Ok(());
        }
        if binding.maps() {
            self.refuse(
                "parameter binding: found a mapping of names, expected the names of variables"
                    .to_owned(),
            );
        }
        let inside = binding.source_base.as_deref().unwrap_or("SSD") == "SSD";
        let set = match (&binding.source, &binding.values) {
            (Some(source), _) if inside => match self.file("parameter binding", source) {
                Some(file) => self.xml(&file, ParameterSet::from_xml)?,
                None => return Ok(()),
            },
            (Some(source), _) => {
                self.refuse(format!(
                    "parameter binding: found source {source:?} within a component, expected one in the folder of {STRUCTURE}"
                ));
                return Ok(());
            }
            (None, Some(values)) => values.set.clone(),
            (None, None) => return Ok(()),
        };
        for parameter in set.parameters() {
            let name = format!("{prefix}{}", parameter.name);
            match parameter.values() {
                Ok(own) => {
                    values.extend(own.into_iter().map(|(element, text, unit)| {
                        let name = format!("{name}{element}");
                        (name, text.to_owned(), unit.map(str::to_owned))
                    }));
                }
                Err(problem) => self.refuse(format!("parameter `{name}`: {problem}")),
            }
        }
        if values.len() > MAX_VALUES {
            self.refuse(format!(
                "parameter bindings: found more than {MAX_VALUES} values in all, expected at most that"
            ));
        }
        Ok(())
    }
}
