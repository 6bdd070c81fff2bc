//! A system of FMUs as one SSP archive, for other masters.
//!
//! ```text
//! SystemStructure.ssd         components, connectors, connections
//! resources/<component>.fmu
//! resources/<component>_parameters.ssv    values of its parameters, as libcosim and Ecos read them
//! resources/parameters.ssv                the same of all, by `<component>.<parameter>`, as fmpy takes them
//! ```
//!
//! Connectors are the inputs and outputs, and the parameters that have a value in the sets. They have every number, and
//! of truth values, texts and enumerations those that are not at their start: some masters refuse whole sets for a text,
//! and what is at its start needs no entry.

use std::path::Path;
use std::{fs, io};

use sphere_dda_fmi_interface::archive::{self, ArchiveError};
use sphere_dda_model_description::Error as XmlError;
use sphere_dda_model_description::fmi3::Causality;
use sphere_dda_model_description::lexical::Lexical;
use sphere_dda_model_description::units::Unit;
use thiserror::Error;

use crate::error::ImportError;
use crate::open::Description;
use crate::system::{Connection as Wire, System, SystemVariable, VariableError};
use crate::system::{check_settable_at_start, parse_one};
use crate::value::{Value, ValueType};
use crate::variable::Variable;

use super::xml::{
    Component, Connection, Connector, Content, Enumeration, Experiment, Item, Parameter,
    ParameterSet, Signal, Structure, System as SspSystem, Text,
};

/// Where the parameters lie in the archive.
const VALUES: &str = "resources/parameters.ssv";

/// Tool that writes the files.
const TOOL: &str = concat!("sphere-dda ", env!("CARGO_PKG_VERSION"));

/// Why there is no SSP archive.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PackageError {
    /// A name or value of a parameter does not fit.
    #[error(transparent)]
    Variable(#[from] VariableError),
    /// Not a parameter.
    #[error(
        "variable `{name}`: found causality {found:?}, expected Parameter: an SSP has values of parameters only"
    )]
    Causality {
        /// Its name.
        name: String,
        /// Its causality.
        found: Causality,
    },
    /// An FMU of another version.
    #[error(transparent)]
    Version(#[from] ImportError),
    /// Two FMUs mean different things by one name.
    #[error(
        "FMUs: found two different {what} named `{name}`, expected one: an SSP has one list of them"
    )]
    Conflict {
        /// Units or enumerations.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A name has a character that XML cannot carry.
    #[error("system structure: {0}; change the name")]
    Xml(#[from] XmlError),
    /// An FMU cannot be read.
    #[error("cannot read `{path}`: {source}")]
    Read {
        /// The file.
        path: String,
        /// The reason.
        source: io::Error,
    },
    /// The archive cannot be written.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
}

impl System<'_> {
    /// Writes the system `name`, with its connections and the parameters `set` by name and text, into the archive `ssp`,
    /// replacing it when all is done.
    ///
    /// # Errors
    /// [`PackageError`]; no half-written archive is left.
    pub fn package(
        &self,
        name: &str,
        set: &[(String, String)],
        ssp: &Path,
    ) -> Result<(), PackageError> {
        let given = self.given(set)?;
        let units = self.units()?;
        let enumerations = self.enumerations()?;
        let interfaces = self.interfaces(&given);
        let names: Vec<&str> = (0..self.fmus().len())
            .map(|k| self.component_name(k).unwrap_or(name))
            .collect();
        let components = names.iter().zip(&interfaces).map(|(n, interface)| {
            Component::new(n, &place(n), &values(n), interface.connectors.clone())
        });
        let wires = self
            .connections()
            .iter()
            .map(|wire| self.wire(wire, &names));
        let proposed = self.experiment();
        let wires = wires.collect();
        let system = SspSystem::new(name, VALUES, components, wires, proposed.step_size);
        let experiment = Experiment {
            start_time: proposed.start_time,
            stop_time: proposed.stop_time,
        };
        let sets = self.sets(name, &names, &interfaces, &units)?;
        let structure = Structure::new(TOOL, system, &units, enumerations, experiment).to_xml()?;
        let archives = self.archives(&names)?;
        let mut files: Vec<(String, &[u8])> =
            vec![("SystemStructure.ssd".to_owned(), structure.as_bytes())];
        files.extend(
            sets.iter()
                .map(|(path, set)| (path.clone(), set.as_bytes())),
        );
        files.extend(archives.iter().map(|(path, fmu)| (path.clone(), &**fmu)));
        Ok(archive::write(ssp, &files)?)
    }

    /// The values of parameters that the caller gives, by name.
    fn given<'n>(
        &self,
        set: &'n [(String, String)],
    ) -> Result<Vec<(&'n str, Value)>, PackageError> {
        let mut given = Vec::new();
        for (name, text) in set {
            let variable = self.find(name)?;
            check_settable_at_start(&variable)?;
            let found = variable.declared.causality;
            if found != Causality::Parameter {
                let name = name.clone();
                return Err(PackageError::Causality { name, found });
            }
            given.push((name.as_str(), parse_one(&variable, text)?));
        }
        Ok(given)
    }

    /// The units of all FMUs, without their display units, which SSP does not know.
    fn units(&self) -> Result<Vec<Unit>, PackageError> {
        let mut units: Vec<Unit> = Vec::new();
        for fmu in self.fmus() {
            // SSP 1.0 knows no arrays.
            let Description::Two(description) = fmu.description() else {
                let path = fmu.path().to_owned();
                return Err(ImportError::Version { path }.into());
            };
            for unit in &description.unit_definitions {
                let bare = Unit {
                    display_units: Vec::new(),
                    ..unit.clone()
                };
                merge(&mut units, bare, |u| &u.name, "units")?;
            }
        }
        Ok(units)
    }

    /// The enumerations of all variables.
    fn enumerations(&self) -> Result<Vec<Enumeration>, PackageError> {
        let mut enumerations: Vec<Enumeration> = Vec::new();
        for variable in self.variables() {
            let Some(own) = &variable.declared.items else {
                continue;
            };
            let items = own.items.iter().map(|(name, value)| Item {
                name: name.clone(),
                value: *value,
            });
            let enumeration = Enumeration {
                name: own.name.clone(),
                items: items.collect(),
            };
            merge(&mut enumerations, enumeration, |e| &e.name, "enumerations")?;
        }
        Ok(enumerations)
    }

    /// The connectors and parameters of each component.
    fn interfaces(&self, given: &[(&str, Value)]) -> Vec<Interface> {
        let mut interfaces = vec![Interface::default(); self.fmus().len()];
        for variable in self.variables() {
            let Some(interface) = interfaces.get_mut(variable.component) else {
                continue;
            };
            let value = match variable.declared.causality {
                Causality::Parameter => {
                    let given = given.iter().find(|(name, _)| *name == variable.name);
                    parameter(&variable, given.map(|(_, value)| value))
                }
                _ => None,
            };
            let connector = connector(variable.declared, value.is_some());
            interface.connectors.extend(connector);
            let value = value.map(|value| (variable.declared.name.clone(), value));
            interface.parameters.extend(value);
        }
        interfaces
    }

    /// The parameter sets by their places in the package: that of all, and of each component.
    fn sets(
        &self,
        name: &str,
        names: &[&str],
        interfaces: &[Interface],
        units: &[Unit],
    ) -> Result<Vec<(String, String)>, PackageError> {
        let mut all = Vec::new();
        let mut sets = Vec::new();
        for (k, (own, interface)) in names.iter().zip(interfaces).enumerate() {
            let prefix = self.component_name(k).map(|name| format!("{name}."));
            let prefix = prefix.unwrap_or_default();
            let parameters = interface.parameters.iter();
            let parameters = parameters.map(|(n, value)| Parameter::new(n.clone(), value.clone()));
            let set = ParameterSet::new(own, TOOL, parameters.collect(), units).to_xml()?;
            sets.push((values(own), set));
            let parameters = interface.parameters.iter();
            all.extend(
                parameters.map(|(n, value)| Parameter::new(format!("{prefix}{n}"), value.clone())),
            );
        }
        let set = ParameterSet::new(name, TOOL, all, units).to_xml()?;
        sets.insert(0, (VALUES.to_owned(), set));
        Ok(sets)
    }

    /// The archives of the FMUs by their places in the package.
    fn archives(&self, names: &[&str]) -> Result<Vec<(String, Vec<u8>)>, PackageError> {
        let named = self.fmus().zip(names);
        named
            .map(|(fmu, name)| match fs::read(fmu.path()) {
                Ok(bytes) => Ok((place(name), bytes)),
                Err(source) => Err(PackageError::Read {
                    path: fmu.path().display().to_string(),
                    source,
                }),
            })
            .collect()
    }

    /// A connection by names.
    fn wire(&self, wire: &Wire, names: &[&str]) -> Connection {
        let end = |component: usize, full: String| {
            let name = match self.component_name(component) {
                Some(own) => full.get(own.len() + 1..).unwrap_or_default().to_owned(),
                None => full,
            };
            let element = names.get(component).copied().unwrap_or_default();
            (element.to_owned(), name)
        };
        Connection::new(
            end(wire.source.0, self.source_name(wire)),
            end(wire.target.0, self.target_name(wire)),
        )
    }
}

/// What a component shows.
#[derive(Debug, Clone, Default)]
struct Interface {
    connectors: Vec<Connector>,
    /// By the names in the FMU.
    parameters: Vec<(String, Content)>,
}

/// Where the parameters of a component lie in the archive.
fn values(name: &str) -> String {
    format!("resources/{name}_parameters.ssv")
}

/// Where the FMU of a component lies in the archive.
fn place(name: &str) -> String {
    format!("resources/{name}.fmu")
}

/// Adds what is new to a list without names that mean two things.
fn merge<T: PartialEq>(
    list: &mut Vec<T>,
    item: T,
    name: impl Fn(&T) -> &String,
    what: &'static str,
) -> Result<(), PackageError> {
    match list.iter().find(|known| name(known) == name(&item)) {
        None => list.push(item),
        Some(known) if *known == item => {}
        Some(_) => {
            let name = name(&item).clone();
            return Err(PackageError::Conflict { what, name });
        }
    }
    Ok(())
}

/// The connector of a variable, if it is to have one.
fn connector(variable: &Variable, has_value: bool) -> Option<Connector> {
    let kind = match variable.causality {
        Causality::Input => "input",
        Causality::Output => "output",
        Causality::Parameter if has_value => "parameter",
        _ => return None,
    };
    Some(Connector {
        name: variable.name.clone(),
        kind,
        signal: match (variable.scalar.value_type(), &variable.items) {
            (_, Some(items)) => Signal::Enumeration {
                name: items.name.clone(),
            },
            (ValueType::Real, None) => Signal::Real {
                unit: unit(variable),
            },
            (ValueType::Integer, None) => Signal::Integer,
            (ValueType::Boolean, None) => Signal::Boolean,
            // No variable of FMI 2.0 is binary.
            (ValueType::String | ValueType::Binary, None) => Signal::String,
        },
    })
}

fn unit(variable: &Variable) -> Option<String> {
    variable.unit.as_ref().map(|unit| unit.name.clone())
}

/// The entry of a parameter in the set, if it needs one.
fn parameter(variable: &SystemVariable<'_>, given: Option<&Value>) -> Option<Content> {
    let declared = variable.declared;
    let start = declared.start.first();
    let value = match (declared.scalar.value_type(), &declared.items) {
        (ValueType::Real, _) | (ValueType::Integer, None) => given.or(start)?,
        _ => given.filter(|given| Some(*given) != start)?,
    };
    Some(match (value, &declared.items) {
        (Value::Integer(value), Some(items)) => {
            let (name, _) = items.items.iter().find(|(_, item)| item == value)?;
            Content::Enumeration(name.clone().into())
        }
        (Value::Real(value), _) => Content::Real(Text::new(value.print(), unit(declared))),
        (Value::Integer(value), None) => Content::Integer(value.print().into()),
        (Value::Boolean(value), _) => Content::Boolean(value.print().into()),
        (Value::String(value), _) => Content::String(value.clone().into()),
        (Value::Binary(_), _) => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_name_means_one_thing() {
        let item = |name: &str, value| Enumeration {
            name: name.to_owned(),
            items: vec![Item {
                name: "one".to_owned(),
                value,
            }],
        };
        let mut list = Vec::new();
        let mut add = |new| merge(&mut list, new, |e: &Enumeration| &e.name, "enumerations");
        assert!(add(item("a", 1)).is_ok() && add(item("b", 2)).is_ok());
        assert!(add(item("a", 1)).is_ok(), "the same again is no conflict");
        let error = add(item("a", 2)).unwrap_err().to_string();
        assert!(error.contains("two different enumerations named `a`"));
        assert_eq!(list.len(), 2);
    }
}
