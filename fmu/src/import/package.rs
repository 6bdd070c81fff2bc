//! A system of FMUs as one SSP archive, for other masters.
//!
//! ```text
//! SystemStructure.ssd         components, connectors, connections
//! resources/<component>.fmu
//! resources/parameters.ssv    values of their parameters, by `<component>.<parameter>`
//! ```
//!
//! Connectors are the inputs and outputs, and the parameters that have a value in the set. The set has every number, and
//! of truth values, texts and enumerations those that are not at their start: some masters refuse whole sets for a text,
//! and what is at its start needs no entry.

use std::path::Path;
use std::{fs, io};

use sphere_dda_fmi_interface::archive::{self, ArchiveError};
use sphere_dda_model_description::Error as XmlError;
use sphere_dda_model_description::fmi3::Causality;
use sphere_dda_model_description::ssp::{
    Component, Connection, Connector, Enumeration, Experiment, Item, Parameter, ParameterSet,
    ParameterValue, Signal, SystemStructure, TopSystem,
};
use sphere_dda_model_description::units::Unit;
use thiserror::Error;

use super::connection::Connection as Wire;
use super::quantity::Quantity;
use super::system::{System, Variable};
use super::values::{Base, Value, VariableError, check_settable_at_start, parse_one};
use super::{Description, ImportError};

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
        let mut given = Vec::new();
        for (name, text) in set {
            let variable = self.find(name)?;
            check_settable_at_start(&variable)?;
            if variable.quantity.causality != Causality::Parameter {
                let found = variable.quantity.causality;
                return Err(PackageError::Causality {
                    name: name.clone(),
                    found,
                });
            }
            given.push((name.as_str(), parse_one(&variable, text)?));
        }
        let mut units: Vec<Unit> = Vec::new();
        let mut enumerations: Vec<Enumeration> = Vec::new();
        for fmu in self.fmus() {
            // SSP 1.0 knows no arrays.
            let Description::Two(description) = fmu.description() else {
                let path = fmu.path().to_owned();
                return Err(ImportError::Version { path }.into());
            };
            for unit in &description.unit_definitions {
                // Display units are left out, so only the base decides.
                let bare = Unit {
                    display_units: Vec::new(),
                    ..unit.clone()
                };
                merge(&mut units, bare, |u| &u.name, "units")?;
            }
        }
        let mut parameters = Vec::new();
        let mut connectors: Vec<Vec<Connector>> = vec![Vec::new(); self.fmus().len()];
        for variable in self.variables() {
            let value = match variable.quantity.causality {
                Causality::Parameter => {
                    let given = given.iter().find(|(name, _)| *name == variable.name);
                    parameter(&variable, given.map(|(_, value)| value))
                }
                _ => None,
            };
            if let Some(own) = &variable.quantity.items {
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
            if let (Some(connector), Some(list)) = (
                connector(variable.quantity, value.is_some()),
                connectors.get_mut(variable.component),
            ) {
                list.push(connector);
            }
            parameters.extend(value.map(|value| Parameter {
                name: variable.name.clone(),
                value,
            }));
        }
        let names: Vec<&str> = (0..self.fmus().len())
            .map(|k| self.component_name(k).unwrap_or(name))
            .collect();
        let place = |name: &str| format!("resources/{name}.fmu");
        let components = names.iter().zip(connectors);
        let components = components.map(|(n, c)| Component::new(n, &place(n), c));
        let wires = self
            .connections()
            .iter()
            .map(|wire| self.wire(wire, &names));
        let system = TopSystem::new(name, VALUES, components.collect(), wires.collect());
        let proposed = self.experiment();
        let experiment = Experiment {
            start_time: proposed.start_time,
            stop_time: proposed.stop_time,
        };
        let set = ParameterSet::new(name, TOOL, parameters, &units).to_xml()?;
        let structure =
            SystemStructure::new(name, TOOL, system, &units, enumerations, experiment).to_xml()?;
        let mut archives = Vec::new();
        for (fmu, name) in self.fmus().zip(&names) {
            let read = fs::read(fmu.path()).map_err(|source| PackageError::Read {
                path: fmu.path().display().to_string(),
                source,
            })?;
            archives.push((place(name), read));
        }
        let mut files: Vec<(String, &[u8])> = vec![
            ("SystemStructure.ssd".to_owned(), structure.as_bytes()),
            (VALUES.to_owned(), set.as_bytes()),
        ];
        files.extend(archives.iter().map(|(path, fmu)| (path.clone(), &**fmu)));
        Ok(archive::write(ssp, &files)?)
    }

    /// A connection by names.
    fn wire(&self, wire: &Wire, names: &[&str]) -> Connection {
        let end = |component: usize, full: String| {
            let name = match self.component_name(component) {
                Some(own) => full.get(own.len() + 1..).unwrap_or_default().to_owned(),
                None => full,
            };
            let element = names.get(component).map(|&name| name.to_owned());
            (element.unwrap_or_default(), name)
        };
        let (start_element, start_connector) = end(wire.source.0, self.source_name(wire));
        let (end_element, end_connector) = end(wire.target.0, self.target_name(wire));
        Connection {
            start_element,
            start_connector,
            end_element,
            end_connector,
        }
    }
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
fn connector(quantity: &Quantity, has_value: bool) -> Option<Connector> {
    let kind = match quantity.causality {
        Causality::Input => "input",
        Causality::Output => "output",
        Causality::Parameter if has_value => "parameter",
        _ => return None,
    };
    Some(Connector {
        name: quantity.name.clone(),
        kind,
        signal: match (quantity.call.base(), &quantity.items) {
            (_, Some(items)) => Signal::Enumeration {
                name: items.name.clone(),
            },
            (Base::Real, None) => Signal::Real {
                unit: unit(quantity),
            },
            (Base::Integer, None) => Signal::Integer,
            (Base::Boolean, None) => Signal::Boolean,
            // No variable of FMI 2.0 is binary.
            (Base::String | Base::Binary, None) => Signal::String,
        },
    })
}

fn unit(quantity: &Quantity) -> Option<String> {
    quantity.unit.as_ref().map(|unit| unit.name.clone())
}

/// The entry of a parameter in the set, if it needs one.
fn parameter(variable: &Variable<'_>, given: Option<&Value>) -> Option<ParameterValue> {
    let quantity = variable.quantity;
    let start = quantity.start.first();
    let value = match (quantity.call.base(), &quantity.items) {
        (Base::Real, _) | (Base::Integer, None) => given.or(start)?,
        _ => given.filter(|given| Some(*given) != start)?,
    };
    Some(match (value, &quantity.items) {
        (Value::Integer(value), Some(items)) => ParameterValue::Enumeration {
            value: items
                .items
                .iter()
                .find(|(_, item)| item == value)
                .map(|(name, _)| name.clone())?,
        },
        (Value::Real(value), _) => ParameterValue::Real {
            value: *value,
            unit: unit(quantity),
        },
        (Value::Integer(value), None) => ParameterValue::Integer { value: *value },
        (Value::Boolean(value), _) => ParameterValue::Boolean { value: *value },
        (Value::String(value), _) => ParameterValue::String {
            value: value.clone(),
        },
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
