//! Derivatives: of inputs and outputs by time, of outputs by the inputs held over the last step.

use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::values;
use sphere_dda::scene::Command;
use sphere_dda::simulation::{Direction, Simulation};
use sphere_dda_fmi_interface::pointers::BadArgument;
use sphere_dda_model_description::fmi2::BaseType;
use sphere_dda_model_description::fmi3::Kind;

use super::{Instance, counted};
use crate::runtime::refusal::Refusal;
use crate::table::{Array, Binding, Field, Source, Variable, component};

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
            let Binding::Input {
                boundary,
                input,
                axis,
            } = variable.binding
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

    /// First derivatives by time of real outputs: [`Simulation::time_derivatives`].
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
        let ranks = self.all_ranks(references)?;
        self.rates_at(&ranks)
    }

    fn rates_at(&mut self, ranks: &[usize]) -> Result<Vec<f64>, Refusal> {
        self.look()?;
        let Some(simulation) = self
            .simulation
            .as_ref()
            .filter(|s| s.replay_record().is_some())
        else {
            return Err(self.no_derivatives());
        };
        if self.measured.rates.is_none() {
            self.measured.rates = Some(simulation.time_derivatives_of(measure)?);
        }
        let rates = self.measured.rates.as_deref().unwrap_or_default();
        Ok(picked(rates, ranks))
    }

    /// Change of `unknowns`, real outputs, for the change `seed` of `knowns`, inputs of boundaries held over the last step.
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NotDerivable`], [`Refusal::NoStep`], [`Refusal::Range`] of the seed,
    /// [`Refusal::Step`] if the tangent of the step is singular.
    pub fn directional_derivative(
        &mut self,
        unknowns: &[u32],
        knowns: &[u32],
        seed: &[f64],
    ) -> Result<Vec<f64>, Refusal> {
        let of = |&reference| self.rank(reference);
        let ranks: Vec<usize> = unknowns.iter().map(of).collect::<Result<_, _>>()?;
        self.forward(&ranks, knowns, seed)
    }

    /// As [`Self::directional_derivative`], of variables of FMI 3.0: as many of `seed` as `knowns` have elements.
    ///
    /// # Errors
    /// [`Refusal::ArrayReference`], [`Refusal::Argument`] of the number of elements, otherwise as there.
    pub fn array_directional_derivative(
        &mut self,
        unknowns: &[u32],
        knowns: &[u32],
        seed: &[f64],
    ) -> Result<Vec<f64>, Refusal> {
        let (ranks, inputs) = (self.all_ranks(unknowns)?, self.members(knowns)?);
        if seed.len() != inputs.len() {
            return Err(counted(seed.len(), inputs.len()));
        }
        self.forward(&ranks, &inputs, seed)
    }

    /// Products of the derivatives of `unknowns` by each element of `knowns` with `seed`, one number for each element of
    /// `unknowns`.
    ///
    /// # Errors
    /// As [`Self::array_directional_derivative`].
    pub fn array_adjoint_derivative(
        &mut self,
        unknowns: &[u32],
        knowns: &[u32],
        seed: &[f64],
    ) -> Result<Vec<f64>, Refusal> {
        let (ranks, inputs) = (self.all_ranks(unknowns)?, self.members(knowns)?);
        if seed.len() != ranks.len() {
            return Err(counted(seed.len(), ranks.len()));
        }
        finite(seed)?;
        let columns = self.columns(&inputs)?;
        let products = columns.iter().map(|column| {
            let parts = picked(column, &ranks);
            parts.iter().zip(seed).map(|(part, seed)| part * seed).sum()
        });
        Ok(products.collect())
    }

    fn forward(
        &mut self,
        ranks: &[usize],
        inputs: &[u32],
        seed: &[f64],
    ) -> Result<Vec<f64>, Refusal> {
        finite(seed)?;
        let mut sum = vec![0.0; ranks.len()];
        for (column, seed) in self.columns(inputs)?.iter().zip(seed) {
            for (sum, part) in sum.iter_mut().zip(picked(column, ranks)) {
                *sum += part * seed;
            }
        }
        Ok(sum)
    }

    /// Derivatives of all that [`measure`] gives by each of `inputs`.
    fn columns(&mut self, inputs: &[u32]) -> Result<Vec<&[f64]>, Refusal> {
        let directions: Vec<(u32, Direction)> = inputs
            .iter()
            .map(|&reference| Ok((reference, self.direction(reference)?)))
            .collect::<Result<_, Refusal>>()?;
        self.look()?;
        let Some(simulation) = self
            .simulation
            .as_ref()
            .filter(|s| s.replay_record().is_some())
        else {
            return Err(self.no_derivatives());
        };
        let known = &mut self.measured.columns;
        let missing: Vec<&(u32, Direction)> = directions
            .iter()
            .filter(|(reference, _)| !known.contains_key(reference))
            .collect();
        if !missing.is_empty() {
            let along: Vec<Direction> = missing.iter().map(|(_, direction)| *direction).collect();
            let columns = simulation.directional_derivatives_of(&along, measure)?;
            let references = missing.iter().map(|(reference, _)| *reference);
            known.extend(references.zip(columns));
        }
        let columns = inputs.iter().filter_map(|reference| known.get(reference));
        Ok(columns.map(Vec::as_slice).collect())
    }

    /// What one unit of an input adds to the command of its boundary.
    fn direction(&self, reference: u32) -> Result<Direction, Refusal> {
        let variable = self.variable(BaseType::Real, reference)?;
        let Binding::Input {
            boundary,
            input,
            axis,
        } = variable.binding
        else {
            return Err(not_derivable(
                &variable.name,
                "an input of a boundary as known",
            ));
        };
        let mut change = Command::default();
        *component(&mut change, input, axis) = 1.0;
        Ok(Direction { boundary, change })
    }

    fn all_ranks(&self, references: &[u32]) -> Result<Vec<usize>, Refusal> {
        let mut ranks = Vec::new();
        for &reference in references {
            ranks.extend(self.ranks(reference)?);
        }
        Ok(ranks)
    }

    /// The rows of the table behind arrays.
    fn members(&self, references: &[u32]) -> Result<Vec<u32>, Refusal> {
        let mut all = Vec::new();
        for &reference in references {
            let array = self.array(Kind::Float64, reference)?;
            match &array.source {
                Source::Scalars(members) => all.extend(members),
                _ => {
                    return Err(not_derivable(
                        &array.name,
                        "an input of a boundary as known",
                    ));
                }
            }
        }
        Ok(all)
    }

    pub(super) fn no_derivatives(&self) -> Refusal {
        Refusal::NoStep {
            stage: self.run.stage,
            why: "they are of the start or the last communication step, and there is none",
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
            .filter(|v| matches!(v.binding, Binding::Output(_)));
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
    match variable.binding {
        Binding::Output(rank) => Ok(rank),
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

fn finite(seed: &[f64]) -> Result<(), Refusal> {
    match seed.iter().find(|value| !value.is_finite()) {
        Some(value) => Err(Refusal::Argument(BadArgument {
            argument: "seed",
            found: value.to_string(),
            expected: "finite numbers",
        })),
        None => Ok(()),
    }
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
