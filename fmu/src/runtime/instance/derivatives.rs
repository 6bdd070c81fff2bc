//! Derivatives: of inputs and outputs by time, of outputs by the inputs held over the last step.

use std::sync::Arc;

use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::values;
use sphere_dda::scene::Command;
use sphere_dda::simulation::{Direction, LARGEST, Simulation};
use sphere_dda_fmi_interface::pointers::BadArgument;

use super::Instance;
use super::values::{Call, counted, elements};
use crate::runtime::document::{MOTION, motion};
use crate::runtime::refusal::Refusal;
use crate::table::{Binding, Entry, Input};
use crate::version::Version;

/// An element of an input: its row in the table, what it is of, and which component.
type Known = ((usize, usize), usize, Input);

const KNOWN: &str = "an input of a boundary as known";

/// All that has a derivative: the outputs of the table in its order, then the motion of each sphere.
pub(super) fn measure(simulation: &Simulation) -> Vec<f64> {
    let mut all = values(&Observation::of(simulation));
    let spheres = 0..simulation.kinematics().len();
    all.extend(spheres.flat_map(|i| motion(simulation, i)));
    all
}

impl Instance {
    /// Sets derivatives by time of real inputs of FMI 2.0 for the next step: reference, order (1 or 2), value; all or none.
    /// Setting an input takes its derivatives back, and so does a step.
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NotDerivable`], [`Refusal::Argument`], [`Refusal::Range`].
    pub fn set_derivatives(&mut self, given: &[(u32, i32, f64)]) -> Result<(), Refusal> {
        let mut places = Vec::with_capacity(given.len());
        for &(reference, order, value) in given {
            let known = self.knowns(Version::Two, &[reference], "a real input")?;
            let Some(rank) = [1, 2].iter().position(|known| *known == order) else {
                return Err(bad_order(order, "1 or 2"));
            };
            if !(-LARGEST..=LARGEST).contains(&value) {
                let entry = self.model.table.get(Version::Two, reference);
                let name = entry.map(|entry| entry.name()).unwrap_or_default();
                return Err(Refusal::Range {
                    name: format!("derivative {order} of {name}"),
                    found: value,
                    expected: "a number from -1e30 to 1e30".to_owned(),
                });
            }
            places.extend(known.into_iter().map(|known| (known, rank, value)));
        }
        for (((_, axis), boundary, input), rank, value) in places {
            *input.of(&mut self.run.rates[boundary][rank], axis) = value;
            self.run.pending = true;
        }
        Ok(())
    }

    /// First derivatives by time of real outputs, all elements of one after the other, `count` together:
    /// [`Simulation::time_derivatives`].
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NotDerivable`], [`Refusal::Argument`] of the number or of an order that is not 1,
    /// [`Refusal::NoStep`].
    pub fn output_derivatives(
        &mut self,
        version: Version,
        references: &[u32],
        orders: &[i32],
        count: usize,
    ) -> Result<Vec<f64>, Refusal> {
        if let Some(&order) = orders.iter().find(|order| **order != 1) {
            return Err(bad_order(order, "1"));
        }
        let ranks = self.unknowns(version, references, count)?;
        self.look()?;
        let Some(simulation) = self.stepped() else {
            return Err(self.no_derivatives());
        };
        if self.measured.rates.is_none() {
            self.measured.rates = Some(simulation.time_derivatives_of(measure)?);
        }
        let rates = self.measured.rates.as_deref().unwrap_or_default();
        Ok(picked(rates, &ranks))
    }

    /// Change of `unknowns`, `count` elements of real outputs, for the change `seed` of `knowns`, inputs of boundaries held
    /// over the last step: as many of `seed` as `knowns` have elements.
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NotDerivable`], [`Refusal::NoStep`], [`Refusal::Range`] of the seed,
    /// [`Refusal::Argument`] of a number of elements, [`Refusal::Step`] if the tangent of the step is singular.
    pub fn directional_derivative(
        &mut self,
        version: Version,
        (unknowns, knowns): (&[u32], &[u32]),
        seed: &[f64],
        count: usize,
    ) -> Result<Vec<f64>, Refusal> {
        let ranks = self.unknowns(version, unknowns, count)?;
        let inputs = self.knowns(version, knowns, KNOWN)?;
        elements(seed.len(), inputs.len())?;
        finite(seed)?;
        let mut sum = vec![0.0; ranks.len()];
        for (column, seed) in self.columns(&inputs)?.iter().zip(seed) {
            for (sum, part) in sum.iter_mut().zip(picked(column, &ranks)) {
                *sum += part * seed;
            }
        }
        Ok(sum)
    }

    /// Products of the derivatives of `unknowns` by each of the `count` elements of `knowns` with `seed`, one number for each
    /// element of `unknowns`. FMI 3.0 only.
    ///
    /// # Errors
    /// As [`Self::directional_derivative`].
    pub fn adjoint_derivative(
        &mut self,
        (unknowns, knowns): (&[u32], &[u32]),
        seed: &[f64],
        count: usize,
    ) -> Result<Vec<f64>, Refusal> {
        let ranks = self.unknowns(Version::Three, unknowns, seed.len())?;
        let inputs = self.knowns(Version::Three, knowns, KNOWN)?;
        elements(count, inputs.len())?;
        finite(seed)?;
        let columns = self.columns(&inputs)?;
        let products = columns.iter().map(|column| {
            let parts = picked(column, &ranks);
            parts.iter().zip(seed).map(|(part, seed)| part * seed).sum()
        });
        Ok(products.collect())
    }

    /// Derivatives of all that [`measure`] gives by each of `inputs`.
    fn columns(&mut self, inputs: &[Known]) -> Result<Vec<&[f64]>, Refusal> {
        self.look()?;
        let Some(simulation) = self.stepped() else {
            return Err(self.no_derivatives());
        };
        let known = &self.measured.columns;
        let missing: Vec<&Known> = inputs
            .iter()
            .filter(|(place, ..)| !known.contains_key(place))
            .collect();
        if !missing.is_empty() {
            let directions: Vec<Direction> = missing.iter().map(|known| direction(known)).collect();
            let columns = simulation.directional_derivatives_of(&directions, measure)?;
            let places = missing.iter().map(|(place, ..)| *place);
            self.measured.columns.extend(places.zip(columns));
        }
        let known = &self.measured.columns;
        let columns = inputs.iter().filter_map(|(place, ..)| known.get(place));
        Ok(columns.map(Vec::as_slice).collect())
    }

    /// The simulation, if it has a step to differentiate.
    fn stepped(&self) -> Option<&Simulation> {
        let simulation = self.simulation.as_ref();
        simulation.filter(|simulation| simulation.replay_record().is_some())
    }

    /// The elements of real inputs of boundaries.
    fn knowns(
        &self,
        version: Version,
        references: &[u32],
        expected: &'static str,
    ) -> Result<Vec<Known>, Refusal> {
        let mut all = Vec::new();
        for entry in self.entries(&self.model.table, Call::reals(version), references)? {
            let Binding::Input { boundary, input } = entry.variable.binding else {
                return Err(not_derivable(&entry, expected));
            };
            let elements = entry.elements();
            all.extend(elements.map(|k| ((entry.row, k), boundary, input)));
        }
        Ok(all)
    }

    /// Places of the `count` elements of real outputs in what [`measure`] gives.
    fn unknowns(
        &self,
        version: Version,
        references: &[u32],
        count: usize,
    ) -> Result<Vec<usize>, Refusal> {
        let table = Arc::clone(&self.model.table);
        let entries = self.entries(&table, Call::reals(version), references)?;
        let mut ranks = Vec::new();
        for entry in &entries {
            match &entry.variable.binding {
                Binding::Spheres(field) if let Some(columns) = field.columns() => {
                    let first = table.measured();
                    let spheres = 0..self.model.scene.particles.len();
                    ranks.extend(spheres.flat_map(|i| {
                        let columns = columns.clone();
                        columns.map(move |column| first + MOTION * i + column)
                    }));
                }
                Binding::Output(_) | Binding::Boundaries(_) => {
                    ranks.extend(entry.elements().filter_map(|k| entry.variable.rank(k)));
                }
                _ => return Err(not_derivable(entry, "a real output")),
            }
        }
        counted(count, &entries)?;
        Ok(ranks)
    }

    fn no_derivatives(&self) -> Refusal {
        Refusal::NoStep {
            stage: self.run.stage,
            why: "they are of the start or the last communication step, and there is none",
        }
    }
}

/// What one unit of an input adds to the command of its boundary.
fn direction(&((_, axis), boundary, input): &Known) -> Direction {
    let mut change = Command::default();
    *input.of(&mut change, axis) = 1.0;
    Direction { boundary, change }
}

fn picked(values: &[f64], ranks: &[usize]) -> Vec<f64> {
    ranks
        .iter()
        .filter_map(|&rank| values.get(rank))
        .copied()
        .collect()
}

fn not_derivable(entry: &Entry<'_>, expected: &'static str) -> Refusal {
    let name = entry.name();
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

fn bad_order(order: i32, expected: &'static str) -> Refusal {
    Refusal::Argument(BadArgument {
        argument: "order",
        found: order.to_string(),
        expected,
    })
}
