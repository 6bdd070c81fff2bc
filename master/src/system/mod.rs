//! Which FMUs run together, and which outputs feed which inputs.

use sphere_dda_model_description::fmi2::DefaultExperiment;
use sphere_dda_model_description::fmi3::Causality;
use thiserror::Error;

use crate::fmu::Fmu;
use crate::variable::Place;

mod connection;
mod variable;

use connection::mismatch;

pub use connection::{ConnectionError, ConnectionFault};
pub use variable::VariableError;

pub(crate) use connection::Connection;
pub(crate) use variable::{
    SystemVariable, check_settable_at_start, check_settable_in_steps, parse_one, parse_start,
};

/// Names that resemble an unknown one, at most.
const SUGGESTIONS: usize = 3;

/// FMUs and the connections between them. One FMU alone is a system too.
///
/// With one FMU the names of variables are those of its model description; with several they are
/// `<component>.<variable>`.
#[derive(Debug)]
pub struct System<'f> {
    components: Vec<Component<'f>>,
    connections: Vec<Connection>,
}

#[derive(Debug)]
struct Component<'f> {
    /// What its variables' names begin with; `None` if it is alone.
    name: Option<String>,
    fmu: &'f Fmu,
}

/// Why FMUs do not make a system.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SystemError {
    /// Two components have the same name.
    #[error("FMUs: found two named `{0}`, expected different names: rename one of the files")]
    Twice(String),
    /// Connections that cannot be made: all of them.
    #[error("{}", list(.0))]
    Connections(Vec<ConnectionError>),
}

fn list(errors: &[ConnectionError]) -> String {
    let lines: Vec<String> = errors.iter().map(ConnectionError::to_string).collect();
    lines.join("\n")
}

impl<'f> System<'f> {
    /// One FMU. Its variables keep their names.
    pub fn of(fmu: &'f Fmu) -> Self {
        Self {
            components: vec![Component { name: None, fmu }],
            connections: Vec::new(),
        }
    }

    /// FMUs by name, in the order in which they step.
    ///
    /// # Errors
    ///
    /// [`SystemError::Twice`].
    pub fn coupled(
        components: impl IntoIterator<Item = (String, &'f Fmu)>,
    ) -> Result<Self, SystemError> {
        let mut system = Self {
            components: Vec::new(),
            connections: Vec::new(),
        };
        for (name, fmu) in components {
            let same = |known: &Component<'_>| known.name.as_ref() == Some(&name);
            if system.components.iter().any(same) {
                return Err(SystemError::Twice(name));
            }
            let name = Some(name);
            system.components.push(Component { name, fmu });
        }
        Ok(system)
    }

    /// Connects outputs to inputs: pairs of names, output first. Types must be the same, and units as far as both
    /// variables have one; an input has one source.
    ///
    /// # Errors
    ///
    /// [`SystemError::Connections`] with all that is wrong; then none is made.
    pub fn connect<'n>(
        &mut self,
        pairs: impl IntoIterator<Item = (&'n str, &'n str)>,
    ) -> Result<(), SystemError> {
        let mut made = self.connections.clone();
        let mut errors = Vec::new();
        for (from, to) in pairs {
            match self.connection(from, to, &made) {
                Ok(connections) => made.extend(connections),
                Err(faults) => errors.extend(faults.into_iter().map(|fault| ConnectionError {
                    from: from.to_owned(),
                    to: to.to_owned(),
                    fault,
                })),
            }
        }
        if !errors.is_empty() {
            return Err(SystemError::Connections(errors));
        }
        self.connections = made;
        Ok(())
    }

    fn connection(
        &self,
        from: &str,
        to: &str,
        made: &[Connection],
    ) -> Result<Vec<Connection>, Vec<ConnectionFault>> {
        let (source, target) = match (self.find(from), self.find(to)) {
            (Ok(source), Ok(target)) => (source, target),
            (source, target) => {
                let errors = [source.err(), target.err()].into_iter().flatten();
                return Err(errors.map(ConnectionFault::from).collect());
            }
        };
        let mut faults = Vec::new();
        for (variable, expected) in [(&source, Causality::Output), (&target, Causality::Input)] {
            if variable.declared.causality != expected {
                faults.push(ConnectionFault::Causality {
                    name: variable.name.clone(),
                    found: variable.declared.causality,
                    expected,
                });
            }
        }
        faults.extend(mismatch(&source, &target));
        let pairs = source.places().into_iter().zip(target.places());
        let connections: Vec<Connection> = pairs
            .map(|(from, to)| Connection {
                source: (source.component, from),
                target: (target.component, to),
            })
            .collect();
        let taken = |known: &&Connection| connections.iter().any(|new| new.target == known.target);
        if let Some(known) = made.iter().find(taken) {
            faults.push(ConnectionFault::Taken(self.source_name(known)));
        }
        if faults.is_empty() {
            Ok(connections)
        } else {
            Err(faults)
        }
    }

    /// The FMUs in the order in which they step.
    pub fn fmus(&self) -> impl ExactSizeIterator<Item = &'f Fmu> {
        self.components.iter().map(|component| component.fmu)
    }

    /// Name of a component; `None` if it is the only one.
    pub(crate) fn component_name(&self, component: usize) -> Option<&str> {
        self.components.get(component)?.name.as_deref()
    }

    pub(crate) fn connections(&self) -> &[Connection] {
        &self.connections
    }

    /// Whether nothing feeds the input.
    pub(crate) fn check_free(&self, variable: &SystemVariable<'_>) -> Result<(), VariableError> {
        let places = variable.places();
        let feeds = |known: &&Connection| {
            known.target.0 == variable.component && places.contains(&known.target.1)
        };
        match self.connections.iter().find(feeds) {
            None => Ok(()),
            Some(connection) => Err(VariableError::Connected {
                name: variable.name.clone(),
                source_name: self.source_name(connection),
            }),
        }
    }

    /// Name of the output of a connection.
    pub(crate) fn source_name(&self, connection: &Connection) -> String {
        self.name_of(connection.source, Causality::Output)
    }

    /// Name of the input of a connection.
    pub(crate) fn target_name(&self, connection: &Connection) -> String {
        self.name_of(connection.target, Causality::Input)
    }

    /// Name of the value in a place: several variables of FMI 2.0 can share one, so the causality decides.
    fn name_of(&self, (component, place): (usize, Place), causality: Causality) -> String {
        let Some(component) = self.components.get(component) else {
            return String::new();
        };
        let mut declared = component.fmu.variables().iter();
        declared
            .find(|own| own.place(place.element) == place && own.causality == causality)
            .map(|own| component.full_name(&own.element_name(place.element)))
            .unwrap_or_default()
    }

    /// What the FMUs propose as experiment: each value from the first that has one.
    pub fn experiment(&self) -> DefaultExperiment {
        let mut proposed = DefaultExperiment::default();
        for fmu in self.fmus() {
            let own = fmu.description().experiment();
            proposed.start_time = proposed.start_time.or(own.start_time);
            proposed.stop_time = proposed.stop_time.or(own.stop_time);
            proposed.step_size = proposed.step_size.or(own.step_size);
            proposed.tolerance = proposed.tolerance.or(own.tolerance);
        }
        proposed
    }

    /// All variables, component by component.
    pub(crate) fn variables(&self) -> impl Iterator<Item = SystemVariable<'f>> {
        self.components
            .iter()
            .enumerate()
            .flat_map(|(k, component)| {
                let declared = component.fmu.variables().iter();
                declared.map(move |own| SystemVariable {
                    component: k,
                    name: component.full_name(&own.name),
                    declared: own,
                    element: None,
                })
            })
    }

    /// The variable of this name, if there is one.
    pub(crate) fn known(&self, name: &str) -> Option<SystemVariable<'f>> {
        let mut components = self.components.iter().enumerate();
        components.find_map(|(k, component)| {
            let own = component.own_name(name)?;
            let mut declared = component.fmu.variables().iter();
            let (found, element) =
                declared.find_map(|known| Some((known, known.answers_to(own)?)))?;
            Some(SystemVariable {
                component: k,
                name: name.to_owned(),
                declared: found,
                element,
            })
        })
    }

    /// The variable of this name.
    pub(crate) fn find(&self, name: &str) -> Result<SystemVariable<'f>, VariableError> {
        self.known(name).ok_or_else(|| VariableError::Unknown {
            name: name.to_owned(),
            expected: match &*self.components {
                [Component { name: None, .. }] => "a name in the model description",
                _ => "`<FMU>.<variable>` with a name in the FMU's model description",
            },
            similar: self.similar(name),
        })
    }

    /// Names like `name`, the most similar first.
    fn similar(&self, name: &str) -> Vec<String> {
        let mut ranked: Vec<(f64, String)> = self
            .variables()
            .map(|variable| (strsim::jaro_winkler(name, &variable.name), variable.name))
            .filter(|(likeness, _)| *likeness > 0.8)
            .collect();
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
        let names = ranked.into_iter().map(|(_, name)| name);
        names.take(SUGGESTIONS).collect()
    }
}

impl Component<'_> {
    fn full_name(&self, variable: &str) -> String {
        match &self.name {
            Some(name) => format!("{name}.{variable}"),
            None => variable.to_owned(),
        }
    }

    /// What is left of a name without that of the component.
    fn own_name<'n>(&self, name: &'n str) -> Option<&'n str> {
        match &self.name {
            Some(own) => name.strip_prefix(own.as_str())?.strip_prefix('.'),
            None => Some(name),
        }
    }
}
