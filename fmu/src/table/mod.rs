//! The table of variables: names, types, shapes, units, start values and what each variable means.
//!
//! One table is built from a [scene](sphere_dda::scene::Scene). FMI 3.0 has its rows as they are; FMI 2.0 has the elements of
//! each vector as scalars `x[1]`, `x[2]` ..., and nothing of boundaries and spheres as a whole. The XML of the model
//! descriptions and the dispatch of every get and set come from it, so they cannot disagree. Its outputs and
//! local variables are the solver's own list of what is measured, [`sphere_dda::observe::quantities`]. Names of the scene are identifiers, so they need no quotes.
//! The value reference is the rank in the list of the version, from 0.
//!
//! | name               | shape             | is                                                              |
//! |--------------------|-------------------|-----------------------------------------------------------------|
//! | `x`                | `[k]` or none     | time, a parameter, an input, measured                           |
//! | `boundaries.x`     | `[B, k]` or `[B]` | `boundary.NAME.x` of all boundaries, in their order             |
//! | `spheres.*`        | `[N, k]` or `[N]` | all spheres: [`Field`]                                          |
//! | `spheres.appliedForce` | `[N, 3]`     | input, if the scene asks for it                                 |
//! | `spheres.document` | none              | all spheres as one binary: [`crate::runtime::document`]         |
//! | `contacts.*`       | `[K, k]` or `[K]` | loaded contacts, if the scene asks for it: [`ContactField`]     |
//! | `contacts.document`| none              | all of them as one binary: [`crate::runtime::contacts`]         |
//! | `wall.NAME.*`      | `[T, ...]`        | triangles of a boundary with `wall_fields`                      |
//!
//! `N` is the number of spheres the scene has room for, and a sphere keeps its row. A row whose `spheres.present` is
//! false belongs to a sphere that waits in a source or has left through a sink: it rests where it was.
//!
//! # When a command holds
//!
//! Pose, slide and hinge inputs are total displacements from the scene's placement: the boundary moves linearly
//! (a rotation by its logarithm) from where it is to the commanded pose and reaches it at the end of the
//! communication step. Speeds, forces and torques are held over the step. The start values mean "as in the scene": zero,
//! and for a belt or a servo wall the scene's surface velocity or pressure.

mod binding;
mod contacts;
mod enumeration;
mod inputs;
mod outputs;
mod parameters;
mod scene_parameters;
mod spheres;
mod variable;
mod walls;

use std::collections::BTreeMap;

use serde::Serialize;
use sphere_dda::observe::quantities::{Quantity, quantities};
use sphere_dda::scene::Scene;
use sphere_dda_model_description::fmi2::Causality;
use sphere_dda_model_description::value::ScalarType;

use crate::version::Version;

pub use binding::{Binding, ContactField, Field, Input};
pub use enumeration::{Enumeration, solver_value};
pub use outputs::UnknownOutputs;
pub use parameters::{PARAMETERS, Parameter, Parameters};
pub(crate) use scene_parameters::value;
pub use variable::{Entry, Variable};

/// The variables of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Table {
    variables: Vec<Variable>,
    /// Number of components in the list of what is measured.
    measured: usize,
    /// Those of FMI 2.0: rank of the variable, element of a vector.
    scalars: Vec<(usize, Option<usize>)>,
}

impl Table {
    /// Builds the table: time, parameters, inputs of driven boundaries, everything that is measured; then the arrays over all
    /// boundaries and spheres. What is measured is an output if the scene asks for it, or `local`.
    ///
    /// # Errors
    /// Patterns of `[fmu] outputs` that name nothing.
    pub fn new(scene: &Scene) -> Result<Self, UnknownOutputs> {
        let (real, time) = (ScalarType::Float64, Causality::Independent);
        let mut variables = vec![Variable {
            unit: Some("s"),
            ..Variable::new("time", real, time, Binding::Time, "Simulated time")
        }];
        variables.extend(parameters::parameters(scene));
        variables.extend(scene_parameters::scene_parameters(scene));
        for (b, boundary) in scene.boundaries.iter().enumerate() {
            variables.extend(inputs::inputs(b, boundary));
        }
        let mut measured = 0;
        for quantity in quantities(scene) {
            variables.push(measure(measured, &quantity));
            measured += quantity.count();
        }
        let scalars = (0..).zip(&variables).flat_map(|(row, variable)| {
            let whole = variable.dims.is_empty();
            (0..variable.count()).map(move |k| (row, (!whole).then_some(k)))
        });
        let scalars = scalars.collect();
        variables.extend(over_boundaries(&variables, scene.boundaries.len()));
        variables.extend(spheres::spheres(scene));
        variables.extend(contacts::contacts(scene));
        variables.extend(walls::walls(scene));
        if let Some(patterns) = &scene.exposed.outputs {
            outputs::choose(patterns, &mut variables)?;
        }
        Ok(Self {
            variables,
            measured,
            scalars,
        })
    }

    /// All rows: the variables of FMI 3.0.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// Whether another table has the same variables, whatever their start values and bounds.
    #[must_use]
    pub fn is_like(&self, other: &Self) -> bool {
        let shape = |v: &Variable| (v.name.clone(), v.dims.clone(), v.scalar, v.variability);
        self.measured == other.measured
            && self.scalars == other.scalars
            && (self.variables.iter().map(shape)).eq(other.variables.iter().map(shape))
    }

    /// A name that two variables have.
    #[must_use]
    pub fn repeated(&self) -> Option<&str> {
        let mut names: Vec<&str> = self.variables.iter().map(|v| &*v.name).collect();
        names.sort_unstable();
        let repeated = names.windows(2).find(|pair| pair[0] == pair[1]);
        repeated.map(|pair| pair[0])
    }

    /// Number of values in [`sphere_dda::observe::quantities::values`].
    #[must_use]
    pub fn measured(&self) -> usize {
        self.measured
    }

    /// The variables of a version, by reference.
    #[must_use]
    pub fn entries(&self, version: Version) -> Vec<Entry<'_>> {
        (0..).map_while(|k| self.get(version, k)).collect()
    }

    /// The variable with a value reference.
    #[must_use]
    pub fn get(&self, version: Version, reference: u32) -> Option<Entry<'_>> {
        let rank = usize::try_from(reference).ok()?;
        let (row, index) = match version {
            Version::Two => *self.scalars.get(rank)?,
            Version::Three => (rank, None),
        };
        Some(Entry {
            reference,
            row,
            variable: self.variables.get(row)?,
            index,
        })
    }
}

fn measure(rank: usize, quantity: &Quantity) -> Variable {
    let scalar = match quantity.is_count {
        true => ScalarType::Int32,
        false => ScalarType::Float64,
    };
    let (name, text) = (&*quantity.name, quantity.description);
    let causality = match quantity.is_asked {
        true => Causality::Output,
        false => Causality::Local,
    };
    Variable {
        boundary: quantity.boundary.map(|b| (b, quantity.field)),
        unit: quantity.unit,
        min: quantity.is_count.then_some(0.0),
        ..Variable::new(name, scalar, causality, Binding::Output(rank), text)
    }
    .vector(quantity.components)
}

/// `boundaries.x` for every output `x` that all boundaries have.
fn over_boundaries(variables: &[Variable], boundaries: usize) -> Vec<Variable> {
    let outputs = variables.iter().filter_map(|variable| {
        let owner = variable.boundary?;
        Some((owner, variable, variable.rank(0)?))
    });
    let ranks: BTreeMap<(usize, &str), usize> = outputs
        .clone()
        .map(|(owner, _, rank)| (owner, rank))
        .collect();
    let gather = |((_, field), variable, _): ((usize, &'static str), &Variable, usize)| {
        let ranks = (0..boundaries).map(|b| ranks.get(&(b, field)).copied());
        let mut whole = Variable {
            name: format!("boundaries.{field}"),
            boundary: None,
            causality: Causality::Local,
            binding: Binding::Boundaries(ranks.collect::<Option<_>>()?),
            ..variable.clone()
        };
        whole.dims.insert(0, boundaries);
        whole.description += "; all boundaries in the scene's order";
        Some(whole)
    };
    let of_first = outputs.filter(|((boundary, _), ..)| *boundary == 0);
    of_first.filter_map(gather).collect()
}
