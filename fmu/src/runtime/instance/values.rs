//! Getting and setting values: dispatch by the variable table.

use std::sync::Arc;

use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::values;
use sphere_dda::simulation::LARGEST;
use sphere_dda_fmi_interface::log::Level;
use sphere_dda_fmi_interface::pointers::BadArgument;
use sphere_dda_model_description::fmi2::{Causality, Variability};
use sphere_dda_model_description::value::{ScalarType, Value};

use super::Instance;
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;
use crate::runtime::walls::{Wall, give_corners};
use crate::runtime::{contacts, document};
use crate::table::{Binding, Entry, Table, Variable, value};
use crate::version::Version;

/// Which value references a call uses, and the type of its values in C.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Call {
    /// Version of the standard.
    pub version: Version,
    /// Type of the values.
    pub scalar: ScalarType,
}

impl Call {
    /// A call that passes real numbers.
    #[must_use]
    pub fn reals(version: Version) -> Self {
        let scalar = ScalarType::Float64;
        Self { version, scalar }
    }

    /// Whether values of a variable of this type pass; enumerations do as integers.
    fn passes(self, scalar: ScalarType) -> bool {
        self.scalar
            == match (scalar, self.version) {
                (ScalarType::Enumeration, Version::Two) => ScalarType::Int32,
                (ScalarType::Enumeration, Version::Three) => ScalarType::Int64,
                (other, _) => other,
            }
    }

    fn name(self, scalar: ScalarType) -> String {
        match self.version {
            Version::Two => scalar.name_2(),
            Version::Three => scalar.to_string(),
        }
    }
}

impl Instance {
    /// Gives the values of variables of one type, all elements of one after the other, which must be `count` together.
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::Argument`] of the number, [`Refusal::NoValue`]; in initialization mode also
    /// [`Refusal::Step`]. Nothing has been given then.
    pub fn get(
        &mut self,
        call: Call,
        references: &[u32],
        count: usize,
        give: &mut dyn FnMut(Value),
    ) -> Result<(), Refusal> {
        let table = Arc::clone(&self.model.table);
        let entries = self.entries(&table, call, references)?;
        counted(count, &entries)?;
        if let Some(computed) = entries.iter().find(|entry| entry.variable.is_computed()) {
            self.observe(computed, &entries)?;
        }
        for entry in &entries {
            self.read(entry, give);
        }
        Ok(())
    }

    /// Brings what is measured up to date, as far as it is asked for.
    fn observe(&mut self, computed: &Entry<'_>, entries: &[Entry<'_>]) -> Result<(), Refusal> {
        self.look()?;
        let Some(simulation) = &self.simulation else {
            return Err(Refusal::NoValue {
                name: computed.name(),
                stage: self.run.stage,
            });
        };
        let measured = entries.iter().any(|entry| entry.variable.rank(0).is_some());
        if measured && self.measured.outputs.is_none() {
            self.measured.outputs = Some(values(&Observation::of(simulation)));
        }
        let of_contacts = |entry: &&Entry<'_>| {
            matches!(
                entry.variable.binding,
                Binding::Contacts(_) | Binding::ContactsDocument
            )
        };
        if self.measured.contacts.is_none() && entries.iter().any(|entry| of_contacts(&entry)) {
            self.measured.contacts = Some(contacts::loaded(&Observation::of(simulation)));
        }
        for entry in entries {
            if let Binding::Wall { boundary: b, .. } = entry.variable.binding {
                let walls = &mut self.measured.walls;
                walls
                    .entry(b)
                    .or_insert_with(|| Wall::of(&Observation::of(simulation), b));
            }
        }
        Ok(())
    }

    /// Says once that arrays of contacts have fewer rows than there are contacts.
    fn tell_left_out(&mut self, contacts: usize, rows: usize) {
        if contacts > rows && !self.left_out {
            self.left_out = true;
            self.log.write(
                Level::Warning,
                format_args!(
                    "contacts: found {contacts} loaded ones at t = {} s, room for {rows} in the arrays: the others are left out, \
                     contactCount counts all (reported once); set `contacts` in [fmu] of the scene",
                    self.run.time
                ),
            );
        }
    }

    fn read(&mut self, entry: &Entry<'_>, give: &mut dyn FnMut(Value)) {
        let variable = entry.variable;
        let loaded = self.measured.contacts.as_deref().unwrap_or_default();
        match (&variable.binding, &self.simulation) {
            (Binding::Contacts(field), Some(_)) => {
                let (count, rows) = (loaded.len(), variable.dims[0]);
                contacts::field(loaded, rows, *field, give);
                self.tell_left_out(count, rows);
            }
            (Binding::ContactsDocument, Some(_)) => {
                give(Value::Binary(contacts::of(loaded, self.run.time)));
            }
            (Binding::Spheres(field), Some(simulation)) => {
                document::field(simulation, *field, give);
            }
            (Binding::Wall { boundary, field }, Some(_)) => {
                let wall = self.measured.walls.get(boundary);
                wall.into_iter().for_each(|wall| wall.give(*field, give));
            }
            (Binding::WallCorners(boundary), Some(simulation)) => {
                give_corners(&Observation::of(simulation), *boundary, give);
            }
            (Binding::Document, Some(simulation)) => {
                give(Value::Binary(document::of(simulation, self.run.time)));
            }
            _ => entry
                .elements()
                .for_each(|k| give(self.element(variable, k))),
        }
    }

    fn element(&self, variable: &Variable, k: usize) -> Value {
        match variable.binding {
            Binding::Parameter(rank) => self.run.parameters.get(rank, k),
            Binding::SceneParameter(rank) => {
                let is_integer = variable.scalar == ScalarType::Int32;
                value(is_integer, self.run.values[rank])
            }
            Binding::Input { boundary, input } => {
                let mut command = self.run.commands[boundary];
                Value::Real(*input.of(&mut command, k))
            }
            Binding::AppliedForces => Value::Real(self.run.forces[k / 3][k % 3]),
            Binding::Time => Value::Real(self.run.time),
            _ => {
                let outputs = self.measured.outputs.as_deref().unwrap_or_default();
                let value = variable.rank(k).map_or(f64::NAN, |rank| outputs[rank]);
                match variable.scalar {
                    // A cast keeps within the range: the C interface has no count beyond 2^31.
                    ScalarType::Int32 => Value::Integer((value as i32).into()),
                    _ => Value::Real(value),
                }
            }
        }
    }

    /// Before outputs are read: brings the start up to date in initialization mode, tells of a read that is too early.
    pub(super) fn look(&mut self) -> Result<(), Refusal> {
        match self.run.stage {
            LifeCycle::Initialization if self.run.pending => self.prepare()?,
            LifeCycle::StepComplete if self.run.pending && !self.read_ahead => {
                self.read_ahead = true;
                let text = "outputs read after a set without a step: they are those of the last step (reported once)";
                // No fault of the importer: a master sets what comes from outside before it carries outputs to inputs.
                self.log.write(Level::Ok, text);
            }
            _ => {}
        }
        Ok(())
    }

    /// Sets variables of one type, all elements of each; all or none.
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NotSettable`], [`Refusal::Argument`] if there are more or fewer values than
    /// elements, [`Refusal::Item`], [`Refusal::Range`]; [`Refusal::Model`] if the scene does not take parameters between steps.
    pub fn set(
        &mut self,
        call: Call,
        references: &[u32],
        values: Vec<Value>,
    ) -> Result<(), Refusal> {
        let table = Arc::clone(&self.model.table);
        let entries = self.entries(&table, call, references)?;
        for entry in &entries {
            self.settable(entry)?;
        }
        counted(values.len(), &entries)?;
        let elements = |entry: &Entry<'_>| {
            let variable = &table.variables()[entry.row];
            entry.elements().map(move |k| (variable, k))
        };
        let places: Vec<_> = entries.iter().flat_map(elements).collect();
        for ((variable, k), value) in places.iter().zip(&values) {
            within(variable, *k, value)?;
        }
        let mut turned: Option<Vec<f64>> = None;
        for ((variable, _), value) in places.iter().zip(&values) {
            let Binding::SceneParameter(rank) = variable.binding else {
                continue;
            };
            let turned = turned.get_or_insert_with(|| self.run.values.clone());
            match value {
                Value::Real(value) => turned[rank] = *value,
                Value::Integer(value) => turned[rank] = *value as f64,
                _ => {}
            }
        }
        if let Some(turned) = turned {
            self.turn(turned)?;
        }
        for ((variable, k), value) in places.into_iter().zip(values) {
            match (&variable.binding, value) {
                (Binding::Parameter(rank), value) => self.run.parameters.set(*rank, k, value),
                (Binding::Input { boundary, input }, Value::Real(value)) => {
                    *input.of(&mut self.run.commands[*boundary], k) = value;
                    for rate in &mut self.run.rates[*boundary] {
                        *input.of(rate, k) = 0.0;
                    }
                }
                (Binding::AppliedForces, Value::Real(value)) => {
                    self.run.forces[k / 3][k % 3] = value;
                }
                (Binding::SceneParameter(_), _) => {}
                _ => continue,
            }
            self.run.pending = true;
        }
        Ok(())
    }

    /// Whether a variable can be set now.
    fn settable(&self, entry: &Entry<'_>) -> Result<(), Refusal> {
        let variable = entry.variable;
        let before = matches!(
            self.run.stage,
            LifeCycle::Instantiated | LifeCycle::Initialization
        );
        let allowed = match (variable.causality, variable.variability) {
            (Causality::Input, _) => true,
            // What a step began with holds to its end, but for inputs.
            (_, Variability::Tunable) => self.run.stage != LifeCycle::Intermediate,
            (Causality::Parameter, _) => before,
            _ => false,
        };
        if allowed {
            return Ok(());
        }
        Err(Refusal::NotSettable {
            name: entry.name(),
            kind: format!("{:?}, {:?}", variable.causality, variable.variability).to_lowercase(),
            stage: self.run.stage,
            allowed: match variable.causality {
                Causality::Parameter => "set it before or in initialization mode",
                _ => "only parameters and inputs can be set",
            },
        })
    }

    /// The variables of a call's references, which must be of its type.
    pub(super) fn entries<'t>(
        &self,
        table: &'t Table,
        call: Call,
        references: &[u32],
    ) -> Result<Vec<Entry<'t>>, Refusal> {
        let entry = |&reference: &u32| {
            let found = table.get(call.version, reference);
            found
                .filter(|entry| call.passes(entry.variable.scalar))
                .ok_or_else(|| Refusal::Reference {
                    reference,
                    found: found.map(|entry| {
                        let of = call.name(entry.variable.scalar);
                        format!("`{}` of type {of}", entry.name())
                    }),
                    expected: call.name(call.scalar),
                })
        };
        references.iter().map(entry).collect()
    }
}

/// Whether a call has as many values as its variables have elements.
pub(super) fn counted(found: usize, entries: &[Entry<'_>]) -> Result<(), Refusal> {
    let expected = entries.iter().map(|entry| entry.elements().len()).sum();
    elements(found, expected)
}

/// Whether there are as many values as elements.
pub(super) fn elements(found: usize, expected: usize) -> Result<(), Refusal> {
    if found == expected {
        return Ok(());
    }
    Err(BadArgument {
        argument: "nValues",
        found: format!("{found}, for {expected} elements"),
        expected: "the number of elements of all variables",
    }
    .into())
}

/// Whether a value is one that the variable may have.
fn within(variable: &Variable, k: usize, value: &Value) -> Result<(), Refusal> {
    let found = match (variable.choices, value) {
        (Some(choices), Value::Integer(found)) if choices.item(*found).is_none() => {
            let items = choices.items.iter();
            let items: Vec<String> = items
                .map(|(name, value, _)| format!("{value} ({name})"))
                .collect();
            return Err(Refusal::Item {
                name: variable.element(k),
                found: *found,
                expected: items.join(", "),
            });
        }
        (_, Value::Real(found)) => *found,
        (_, Value::Integer(found)) => *found as f64,
        _ => return Ok(()),
    };
    // What may change between steps is computed with: the solver's bound of size holds for it.
    let size = match (variable.causality, variable.variability) {
        (Causality::Input, _) | (_, Variability::Tunable) => LARGEST,
        _ => f64::MAX,
    };
    let min = variable.min.unwrap_or(-size);
    let max = variable.max.unwrap_or(size);
    if found.is_finite() && (min..=max).contains(&found) {
        return Ok(());
    }
    let expected = match (variable.min, variable.max) {
        (None, None) if size < f64::MAX => {
            format!("a number from {} to {}", short(min), short(max))
        }
        (None, None) => "a finite number".to_owned(),
        // The least positive number is how a model description says "not 0".
        (Some(min), None) if min == f64::MIN_POSITIVE => "a number > 0".to_owned(),
        (Some(min), None) => format!("a number >= {min}"),
        (None, Some(_)) => format!("a number <= {max}"),
        (Some(_), Some(_)) => format!("a number from {} to {}", short(min), short(max)),
    };
    Err(Refusal::Range {
        name: variable.element(k),
        found,
        expected,
    })
}

/// A bound as a person writes it.
fn short(bound: f64) -> String {
    match (1e-3..1e6).contains(&bound.abs()) || bound == 0.0 {
        true => bound.to_string(),
        false => format!("{bound:e}"),
    }
}
