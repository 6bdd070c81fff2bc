//! Getting and setting arrays: dispatch by the list of FMI 3.0.

use sphere_dda::simulation::Simulation;
use sphere_dda_fmi_interface::pointers::BadArgument;
use sphere_dda_model_description::fmi2::BaseType;
use sphere_dda_model_description::fmi3::Kind;

use super::Instance;
use crate::runtime::document;
use crate::runtime::refusal::Refusal;
use crate::table::{Array, Field, Source, Value};

/// An element of an array.
#[derive(Debug, Clone, PartialEq)]
pub enum Element {
    /// A value that FMI 2.0 has too.
    Plain(Value),
    /// An integer of 64 bits.
    Long(i64),
    /// Bytes.
    Binary(Vec<u8>),
}

impl Instance {
    /// Elements of variables of one type, one variable after the other, row by row.
    ///
    /// # Errors
    /// [`Refusal::ArrayReference`], [`Refusal::NoValue`]; in initialization mode also [`Refusal::Step`].
    pub fn get_arrays(&mut self, kind: Kind, references: &[u32]) -> Result<Vec<Element>, Refusal> {
        let mut values = Vec::new();
        for &reference in references {
            match self.array(kind, reference)?.source.clone() {
                Source::Scalars(members) => {
                    let found = self.get(base(kind), &members)?;
                    values.extend(found.into_iter().map(|value| match (kind, value) {
                        (Kind::Int64, Value::Integer(value)) => Element::Long(value.into()),
                        (_, value) => Element::Plain(value),
                    }));
                }
                Source::Spheres(field) => field_of(self.prepared(reference)?, field, &mut values),
                Source::Document => {
                    let time = self.run.time;
                    let bytes = document::of(self.prepared(reference)?, time);
                    values.push(Element::Binary(bytes));
                }
            }
        }
        Ok(values)
    }

    /// Sets variables of one type, all elements of each; all or none.
    ///
    /// # Errors
    /// [`Refusal::ArrayReference`], [`Refusal::Argument`] if there are more or fewer values than elements,
    /// [`Refusal::NotSettable`], [`Refusal::Range`].
    pub fn set_arrays(
        &mut self,
        kind: Kind,
        references: &[u32],
        values: Vec<Value>,
    ) -> Result<(), Refusal> {
        let mut members = Vec::new();
        for &reference in references {
            let array = self.array(kind, reference)?;
            match &array.source {
                Source::Scalars(scalars) => members.extend(scalars),
                _ => return Err(self.read_only(array)),
            }
        }
        if members.len() != values.len() {
            return Err(counted(values.len(), members.len()));
        }
        self.set(members.into_iter().zip(values).collect())
    }

    /// The variable of a type; enumerations pass as Int64.
    pub(super) fn array(&self, kind: Kind, reference: u32) -> Result<&Array, Refusal> {
        let found = self.model.arrays.get(reference);
        found
            .filter(|array| {
                array.kind == kind || [kind, array.kind] == [Kind::Int64, Kind::Enumeration]
            })
            .ok_or_else(|| Refusal::ArrayReference {
                reference,
                found: found.map(|array| format!("`{}` of type {}", array.name, array.kind)),
                expected: kind,
            })
    }

    fn read_only(&self, array: &Array) -> Refusal {
        Refusal::NotSettable {
            name: array.name.clone(),
            kind: format!("{:?}, {:?}", array.causality, array.variability).to_lowercase(),
            stage: self.run.stage,
            allowed: "only parameters and inputs can be set",
        }
    }

    /// The simulation that outputs are read from, placed as the settings ask.
    pub(super) fn prepared(&mut self, reference: u32) -> Result<&Simulation, Refusal> {
        self.look()?;
        let name = || {
            let array = self.model.arrays.get(reference);
            array.map(|array| array.name.clone()).unwrap_or_default()
        };
        self.simulation.as_ref().ok_or_else(|| Refusal::NoValue {
            name: name(),
            stage: self.run.stage,
        })
    }
}

/// More or fewer values than the variables have elements.
pub(crate) fn counted(found: usize, expected: usize) -> Refusal {
    let found = format!("{found}, for {expected} elements");
    let expected = "the number of elements of all variables";
    BadArgument {
        argument: "nValues",
        found,
        expected,
    }
    .into()
}

/// The type of the scalars behind an array.
fn base(kind: Kind) -> BaseType {
    match kind {
        // Scalars of 64 bits are enumerations.
        Kind::Int32 | Kind::Int64 => BaseType::Integer,
        Kind::Boolean => BaseType::Boolean,
        Kind::String => BaseType::String,
        _ => BaseType::Real,
    }
}

fn field_of(simulation: &Simulation, field: Field, values: &mut Vec<Element>) {
    let kinematics = simulation.kinematics();
    let radius = &simulation.scene().particles.radius;
    let real = |x: f64| Element::Plain(Value::Real(x));
    for (i, &radius) in radius.iter().enumerate() {
        match field {
            Field::Id => values.push(Element::Long(i as i64)),
            Field::Present => {
                values.push(Element::Plain(Value::Boolean(kinematics.present[i])));
            }
            Field::Radius => values.push(real(radius)),
            Field::Position => values.extend(kinematics.position[i].iter().map(|&x| real(x))),
            Field::Orientation => {
                let q = kinematics.orientation[i];
                values.extend([q.w, q.i, q.j, q.k].map(real));
            }
            Field::Velocity => {
                values.extend(simulation.velocity(i).linear.iter().map(|&x| real(x)));
            }
            Field::AngularVelocity => {
                values.extend(simulation.velocity(i).angular.iter().map(|&x| real(x)));
            }
        }
    }
}
