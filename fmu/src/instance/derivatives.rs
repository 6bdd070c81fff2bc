//! Derivatives: of inputs and outputs by time.

use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::values;
use sphere_dda::simulation::Simulation;
use sphere_dda_fmi_interface::pointers::BadArgument;
use sphere_dda_model_description::fmi2::BaseType;
use sphere_dda_model_description::fmi3::Kind;

use super::Instance;
use crate::refusal::Refusal;
use crate::variables::{Array, Field, Meaning, Source, Variable, component};

const OUTPUTS: &str = "a real output";
/// Numbers that are measured of a sphere: position, orientation, velocity, angular velocity.
const PER_SPHERE: usize = 13;

/// All that has a derivative: the outputs of the table in its order, then of each sphere [`PER_SPHERE`] numbers.
pub(super) fn measure(simulation: &Simulation) -> Vec<f64> {
    let mut all = values(&Observation::of(simulation));
    let kinematics = simulation.kinematics();
    for i in 0..kinematics.len() {
        let (q, twist) = (kinematics.orientation[i], simulation.velocity(i));
        all.extend(kinematics.position[i].iter());
        all.extend([q.w, q.i, q.j, q.k]);
        all.extend(twist.linear.iter().chain(&twist.angular));
    }
    all
}

impl Instance {
    /// Sets derivatives by time of real inputs for the next step: reference, order (1 or 2), value; all or none. Setting an
    /// input takes its derivatives back, and so does a step.
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NotDerivable`], [`Refusal::Argument`], [`Refusal::Range`].
    pub fn set_derivatives(&mut self, given: &[(u32, i32, f64)]) -> Result<(), Refusal> {
        let mut places = Vec::with_capacity(given.len());
        for &(reference, order, value) in given {
            let variable = self.variable(BaseType::Real, reference)?;
            let Meaning::Input {
                boundary,
                input,
                axis,
            } = variable.meaning
            else {
                return Err(not_derivable(&variable.name, "a real input"));
            };
            let Some(rank) = [1, 2].iter().position(|known| *known == order) else {
                return Err(bad_order(order, "1 or 2"));
            };
            if !value.is_finite() {
                return Err(Refusal::Range {
                    name: format!("derivative {order} of {}", variable.name),
                    found: value,
                    expected: "a finite number".to_owned(),
                });
            }
            places.push((boundary, rank, input, axis, value));
        }
        for (boundary, rank, input, axis, value) in places {
            *component(&mut self.run.rates[boundary][rank], input, axis) = value;
            self.run.pending = true;
        }
        Ok(())
    }

    /// First derivatives by time of real outputs: [`Simulation::rates`].
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NotDerivable`], [`Refusal::Argument`] of an order that is not 1, [`Refusal::NoStep`].
    pub fn output_derivatives(
        &mut self,
        references: &[u32],
        orders: &[i32],
    ) -> Result<Vec<f64>, Refusal> {
        first_order(orders)?;
        let of = |&reference| self.rank(reference);
        let ranks: Vec<usize> = references.iter().map(of).collect::<Result<_, _>>()?;
        self.rates_at(&ranks)
    }

    /// As [`Self::output_derivatives`], of variables of FMI 3.0.
    ///
    /// # Errors
    /// [`Refusal::ArrayReference`], otherwise as [`Self::output_derivatives`].
    pub fn array_derivatives(
        &mut self,
        references: &[u32],
        orders: &[i32],
    ) -> Result<Vec<f64>, Refusal> {
        first_order(orders)?;
        let mut ranks = Vec::new();
        for &reference in references {
            ranks.extend(self.ranks(reference)?);
        }
        self.rates_at(&ranks)
    }

    fn rates_at(&mut self, ranks: &[usize]) -> Result<Vec<f64>, Refusal> {
        let Some(simulation) = &self.simulation else {
            return Err(self.no_derivatives());
        };
        if self.measured.rates.is_none() {
            self.measured.rates = Some(simulation.rates_of(measure)?);
        }
        let rates = self.measured.rates.as_deref().unwrap_or_default();
        Ok(picked(rates, ranks))
    }

    pub(super) fn no_derivatives(&self) -> Refusal {
        Refusal::NoStep {
            stage: self.run.stage,
            why: "they are of the last communication step, and there is none",
        }
    }

    /// Place of a real output in what [`measure`] gives.
    pub(super) fn rank(&self, reference: u32) -> Result<usize, Refusal> {
        let variable = self.variable(BaseType::Real, reference)?;
        output(variable)
    }

    /// Places of the elements of an output of FMI 3.0.
    pub(super) fn ranks(&self, reference: u32) -> Result<Vec<usize>, Refusal> {
        let array = self.array(Kind::Float64, reference)?;
        match &array.source {
            Source::Scalars(members) => members.iter().map(|&m| self.rank(m)).collect(),
            Source::Spheres(field) => self.field_ranks(array, *field),
            Source::Document => Err(not_derivable(&array.name, OUTPUTS)),
        }
    }

    fn field_ranks(&self, array: &Array, field: Field) -> Result<Vec<usize>, Refusal> {
        let columns = match field {
            Field::Position => 0..3,
            Field::Orientation => 3..7,
            Field::Velocity => 7..10,
            Field::AngularVelocity => 10..13,
            Field::Id | Field::Present | Field::Radius => {
                return Err(not_derivable(&array.name, OUTPUTS));
            }
        };
        let variables = self.model.table.variables();
        let outputs = variables
            .iter()
            .filter(|v| matches!(v.meaning, Meaning::Output(_)));
        let first = outputs.count();
        let spheres = 0..self.model.scene.particles.len();
        let of = |i| {
            columns
                .clone()
                .map(move |column| first + PER_SPHERE * i + column)
        };
        Ok(spheres.flat_map(of).collect())
    }
}

fn output(variable: &Variable) -> Result<usize, Refusal> {
    match variable.meaning {
        Meaning::Output(rank) => Ok(rank),
        _ => Err(not_derivable(&variable.name, OUTPUTS)),
    }
}

pub(super) fn picked(values: &[f64], ranks: &[usize]) -> Vec<f64> {
    ranks
        .iter()
        .filter_map(|&rank| values.get(rank))
        .copied()
        .collect()
}

pub(super) fn not_derivable(name: &str, expected: &'static str) -> Refusal {
    let name = name.to_owned();
    Refusal::NotDerivable { name, expected }
}

fn first_order(orders: &[i32]) -> Result<(), Refusal> {
    match orders.iter().find(|order| **order != 1) {
        Some(&order) => Err(bad_order(order, "1")),
        None => Ok(()),
    }
}

fn bad_order(order: i32, expected: &'static str) -> Refusal {
    Refusal::Argument(BadArgument {
        argument: "order",
        found: order.to_string(),
        expected,
    })
}
