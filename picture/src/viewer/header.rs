//! What the page reads first, as JSON.

use serde::Serialize;

use super::labels::Label;
use super::live::About;
use super::walls::WallRange;

/// The head of a page. Lengths in m, all units SI.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Header {
    /// Of this layout.
    pub(super) version: u32,
    pub(super) generator: String,
    pub(super) title: String,
    /// Frames of the run for each that is kept.
    pub(super) thinned: usize,
    /// Frames of the run.
    pub(super) recorded: usize,
    pub(super) times: Vec<f64>,
    pub(super) frames_per_block: usize,
    pub(super) spheres: usize,
    pub(super) materials: Vec<String>,
    pub(super) origin: [f64; 3],
    pub(super) step: f64,
    /// What is to be seen at first: lowest and highest corner.
    pub(super) extent: [[f64; 3]; 2],
    pub(super) height: [f64; 2],
    pub(super) fields: Vec<FieldHeader>,
    pub(super) forces: ForceHeader,
    pub(super) boundaries: Vec<BoundaryHeader>,
    /// What the triangles of some boundaries feel.
    pub(super) walls: Vec<WallHeader>,
    pub(super) tables: Vec<TableHeader>,
    pub(super) labels: Vec<Label>,
    /// Of a scene that has not run.
    pub(super) still: bool,
    /// A text that stands over the picture, empty if there is none.
    pub(super) notice: String,
    /// Changes with each page of `--watch`; empty without it.
    pub(super) watched: String,
    /// Of a page that runs the solver.
    pub(super) live: Option<About>,
}

#[derive(Debug, Serialize)]
pub(super) struct FieldHeader {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) components: usize,
    /// Whether this is the magnitude of a vector.
    pub(super) magnitude: bool,
    /// `s` of the coding.
    pub(super) scale: f64,
    /// `K` of the coding.
    pub(super) steps: f64,
    /// Where colours end: 99 % of the values lie below.
    pub(super) top: f64,
}

#[derive(Debug, Serialize)]
pub(super) struct ForceHeader {
    pub(super) largest: f64,
    pub(super) top: f64,
    pub(super) decades: f64,
    /// Codes of forces `L`.
    pub(super) levels: u8,
}

#[derive(Debug, Serialize)]
pub(super) struct BoundaryHeader {
    /// In the scene.
    pub(super) index: usize,
    pub(super) name: String,
    pub(super) centre: [f64; 3],
    pub(super) points: usize,
    pub(super) triangles: usize,
    /// Whether its triangles keep what they feel.
    pub(super) felt: bool,
}

#[derive(Debug, Serialize)]
pub(super) struct WallHeader {
    pub(super) name: String,
    pub(super) unit: String,
    /// `s` of the coding.
    pub(super) scale: f64,
    /// `K` of the coding.
    pub(super) steps: f64,
    /// Where colours end: 99 % of the values above zero lie below.
    pub(super) top: f64,
}

impl WallHeader {
    pub(super) fn of(range: &WallRange) -> Self {
        let (steps, scale) = range.coding();
        Self {
            name: range.name.clone(),
            unit: range.unit.clone(),
            scale,
            steps,
            top: range.top(),
        }
    }
}

#[derive(Debug, Serialize)]
pub(super) struct TableHeader {
    pub(super) name: String,
    pub(super) rows: usize,
    pub(super) thinned: usize,
    pub(super) columns: Vec<[String; 2]>,
}
