//! What a page needs to run the solver itself: the core module of the FMU's component, and which of its variables it uses.

use serde::Serialize;

/// A solver for a page.
#[derive(Debug, Clone)]
pub struct Live {
    /// Core module of WebAssembly with the scene inside.
    pub module: Vec<u8>,
    /// Its variables.
    pub about: About,
}

/// The variables that a page uses, by their value references in FMI 3.0.
#[derive(Debug, Clone, Serialize)]
pub struct About {
    /// Instantiation token.
    pub token: String,
    /// Communication step \[s\].
    pub step: f64,
    /// Mass of all spheres \[kg\].
    pub mass: f64,
    /// Material of each sphere, `[N]`.
    pub materials: Vec<usize>,
    /// Arrays of the spheres, if there are any.
    pub spheres: Option<SphereArrays>,
    /// Arrays of the boundaries, if there are any.
    pub boundaries: Option<BoundaryArrays>,
    /// Numbers that sliders set; the elements of a vector one after the other.
    pub controls: Vec<Control>,
    /// Numbers that plots show, likewise.
    pub outputs: Vec<Output>,
}

/// Value references of arrays over the spheres.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct SphereArrays {
    /// Radii \[m\].
    pub radius: u32,
    /// Whether they are in the scene.
    pub present: u32,
    /// Centres \[m\].
    pub position: u32,
    /// Velocities \[m/s\].
    pub velocity: u32,
    /// Angular velocities \[rad/s\].
    pub angular_velocity: u32,
    /// All loaded contacts as one binary.
    pub contacts: u32,
}

/// Value references of arrays over the boundaries.
#[derive(Debug, Clone, Serialize)]
pub struct BoundaryArrays {
    /// Reference points \[m\].
    pub position: u32,
    /// Orientations, quaternions w, x, y, z.
    pub orientation: u32,
    /// Forces \[N\].
    pub force: u32,
}

/// A number that a slider sets.
#[derive(Debug, Clone, Serialize)]
pub struct Control {
    /// The variable.
    pub variable: String,
    /// The number: `variable`, or `variable[k]` from 1.
    pub name: String,
    /// What it is.
    pub text: String,
    /// Its unit, if it has one.
    pub unit: Option<&'static str>,
    /// Value reference of the variable.
    pub reference: u32,
    /// Whether it is an input; if not, a tunable parameter.
    pub input: bool,
    /// Value at the start.
    pub start: f64,
    /// Smallest allowed value.
    pub min: Option<f64>,
    /// Largest allowed value.
    pub max: Option<f64>,
}

/// A variable that plots show.
#[derive(Debug, Clone, Serialize)]
pub struct Output {
    /// Value reference.
    pub reference: u32,
    /// Whether it holds whole numbers.
    pub whole: bool,
}
