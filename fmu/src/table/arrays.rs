//! The variables of FMI 3.0: the same table, its components gathered into arrays, and the spheres as a whole.
//!
//! | name                   | dimensions         | is                                                            |
//! |------------------------|--------------------|---------------------------------------------------------------|
//! | `x`                    | `[k]` or none      | the components `x[1]` to `x[k]` of the table, or its scalar `x` |
//! | `boundaries.x`         | `[B, k]` or `[B]`  | the outputs `boundary.NAME.x` of all boundaries, in their order |
//! | `spheres.*`            | `[N, k]` or `[N]`  | all spheres: [`Field`]                                        |
//! | `spheres.document`     | none               | all spheres as one binary: [`crate::runtime::document`]                |
//!
//! `N` is the number of spheres the scene has room for, and a sphere keeps its row. A row whose `spheres.present` is
//! false belongs to a sphere that waits in a source or has left through a sink: it rests where it was.

use serde::Serialize;
use sphere_dda::scene::Scene;
use sphere_dda_model_description::fmi2::{BaseType, Causality as Causality2, Variability};
use sphere_dda_model_description::fmi3::{Causality, Kind};

use super::enumeration::Enumeration;
use super::scalars::Table;
use super::variable::{Value, Variable};

/// What is known of every sphere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Field {
    /// Row, from 0.
    Id,
    /// Whether it is in the scene.
    Present,
    /// Radius \[m\].
    Radius,
    /// Centre \[m\].
    Position,
    /// Orientation, unit quaternion w, x, y, z.
    Orientation,
    /// Velocity of the centre \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\], world axes.
    AngularVelocity,
}

/// Where the values of a variable come from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub enum Source {
    /// Rows of the [`Table`], by reference.
    Scalars(Vec<u32>),
    /// A field of all spheres.
    Spheres(Field),
    /// All spheres as one binary.
    Document,
}

/// A variable of FMI 3.0.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Array {
    /// Structured name, unique.
    pub name: String,
    /// Value reference: rank in the list.
    pub reference: u32,
    /// Type of the elements.
    pub kind: Kind,
    /// Who provides the values.
    pub causality: Causality,
    /// When they may change.
    pub variability: Variability,
    /// Unit, one that the exporter defines.
    pub unit: Option<&'static str>,
    /// Extents, the slowest first; empty: one value.
    pub dimensions: Vec<usize>,
    /// Start values: of inputs and parameters, one for each element.
    pub start: Vec<Value>,
    /// Smallest allowed value.
    pub min: Option<f64>,
    /// Largest allowed value.
    pub max: Option<f64>,
    /// The named values of an enumeration.
    pub choices: Option<&'static Enumeration>,
    /// One line for people.
    pub description: String,
    /// Where the values come from.
    pub source: Source,
}

impl Array {
    /// Number of elements.
    #[must_use]
    pub fn elements(&self) -> usize {
        self.dimensions.iter().product()
    }
}

/// The variables of FMI 3.0 of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Arrays {
    list: Vec<Array>,
}

impl Arrays {
    /// Gathers the table of a scene, then adds the arrays over all boundaries and spheres.
    #[must_use]
    pub fn new(scene: &Scene, table: &Table) -> Self {
        let mut list: Vec<Array> = Vec::new();
        for variable in table.variables() {
            match list.last_mut().filter(|array| continues(array, variable)) {
                Some(array) => extend(array, variable),
                None => list.push(begin(variable)),
            }
        }
        let names = scene.boundaries.iter().map(|b| b.name.as_str());
        list.extend(over_boundaries(&list, &names.collect::<Vec<_>>()));
        if !scene.particles.is_empty() {
            list.extend(over_spheres(scene.particles.len()));
        }
        for (reference, array) in (0..).zip(&mut list) {
            array.reference = reference;
        }
        Self { list }
    }

    /// All variables, by reference.
    #[must_use]
    pub fn list(&self) -> &[Array] {
        &self.list
    }

    /// The variable with a value reference.
    #[must_use]
    pub fn get(&self, reference: u32) -> Option<&Array> {
        self.list.get(usize::try_from(reference).ok()?)
    }
}

/// A name as its stem and its component, from 1.
fn component(name: &str) -> Option<(&str, usize)> {
    let (stem, rest) = name.strip_suffix(']')?.rsplit_once('[')?;
    Some((stem, rest.parse().ok()?))
}

/// Whether `variable` is the next component of `array`.
fn continues(array: &Array, variable: &Variable) -> bool {
    let next = array.dimensions.first().map(|extent| extent + 1);
    component(&variable.name).is_some_and(|(stem, k)| stem == array.name && Some(k) == next)
}

fn extend(array: &mut Array, variable: &Variable) {
    if let Source::Scalars(members) = &mut array.source {
        members.push(variable.reference);
    }
    array.dimensions[0] += 1;
    array.start.extend(variable.start.clone());
    let letter = variable.description.rsplit_once("; ");
    // The first component's text ends with `; x`: of the array's, only what all have in common is true.
    if let (Some((first, _)), Some((text, _))) = (array.description.rsplit_once("; "), letter)
        && first == text
    {
        array.description = first.to_owned();
    }
}

fn begin(variable: &Variable) -> Array {
    let first = component(&variable.name).filter(|(_, k)| *k == 1);
    Array {
        name: first
            .map_or(variable.name.as_str(), |(stem, _)| stem)
            .to_owned(),
        reference: 0,
        kind: match variable.base {
            BaseType::Real => Kind::Float64,
            BaseType::Integer if variable.choices.is_some() => Kind::Enumeration,
            BaseType::Integer => Kind::Int32,
            BaseType::Boolean => Kind::Boolean,
            BaseType::String => Kind::String,
        },
        causality: match variable.causality {
            Causality2::Parameter => Causality::Parameter,
            Causality2::CalculatedParameter => Causality::CalculatedParameter,
            Causality2::Input => Causality::Input,
            Causality2::Output => Causality::Output,
            Causality2::Local => Causality::Local,
            Causality2::Independent => Causality::Independent,
        },
        variability: variable.variability,
        unit: variable.unit,
        dimensions: first.map(|_| vec![1]).unwrap_or_default(),
        start: variable.start.iter().cloned().collect(),
        min: variable.min,
        max: variable.max,
        choices: variable.choices,
        description: variable.description.clone(),
        source: Source::Scalars(vec![variable.reference]),
    }
}

/// `boundaries.x` for every output `x` that all boundaries have in the same form.
fn over_boundaries(list: &[Array], names: &[&str]) -> Vec<Array> {
    let of = |name: &str, field: &str| {
        let name = format!("boundary.{name}.{field}");
        list.iter()
            .find(|array| array.name == name && array.causality == Causality::Output)
    };
    let Some((first, _)) = names.split_first() else {
        return Vec::new();
    };
    let prefix = format!("boundary.{first}.");
    let fields = list.iter().filter_map(|a| a.name.strip_prefix(&prefix));
    let gather = |field: &str| {
        let parts: Option<Vec<&Array>> = names.iter().map(|name| of(name, field)).collect();
        let parts = parts?;
        let mut whole = (*parts.first()?).clone();
        let mut members = Vec::new();
        for part in &parts {
            match &part.source {
                Source::Scalars(references) => members.extend(references),
                _ => return None,
            }
        }
        whole.name = format!("boundaries.{field}");
        whole.dimensions.insert(0, parts.len());
        whole.description = format!("{}; all boundaries in the scene's order", whole.description);
        whole.source = Source::Scalars(members);
        Some(whole)
    };
    fields.filter_map(gather).collect()
}

fn over_spheres(spheres: usize) -> Vec<Array> {
    use Field as F;
    let array = |name: &str, kind, unit, columns: Option<usize>, text: &str, source| Array {
        name: format!("spheres.{name}"),
        reference: 0,
        kind,
        causality: Causality::Output,
        variability: if kind == Kind::Float64 {
            Variability::Continuous
        } else {
            Variability::Discrete
        },
        unit,
        dimensions: [spheres].into_iter().chain(columns).collect(),
        start: Vec::new(),
        min: None,
        max: None,
        choices: None,
        description: text.to_owned(),
        source,
    };
    let field = |name, kind, unit, columns, text, field| {
        array(name, kind, unit, columns, text, Source::Spheres(field))
    };
    let fixed = |mut array: Array| {
        array.causality = Causality::CalculatedParameter;
        array.variability = Variability::Fixed;
        array
    };
    let (real, truth) = (Kind::Float64, Kind::Boolean);
    let mut document = array(
        "document",
        Kind::Binary,
        None,
        None,
        "All spheres in one binary",
        Source::Document,
    );
    document.dimensions.clear();
    let waits = "Whether the sphere is in the scene; the row of one that is not rests where it was";
    let turn = "Orientation, unit quaternion w, x, y, z";
    let spin = "Angular velocity, world axes";
    let speed = "Velocity of the centre";
    vec![
        fixed(field(
            "id",
            Kind::Int64,
            None,
            None,
            "Row of the sphere, from 0",
            F::Id,
        )),
        fixed(field("radius", real, Some("m"), None, "Radius", F::Radius)),
        field("present", truth, None, None, waits, F::Present),
        field("position", real, Some("m"), Some(3), "Centre", F::Position),
        field("orientation", real, None, Some(4), turn, F::Orientation),
        field("velocity", real, Some("m/s"), Some(3), speed, F::Velocity),
        field(
            "angularVelocity",
            real,
            Some("rad/s"),
            Some(3),
            spin,
            F::AngularVelocity,
        ),
        document,
    ]
}
