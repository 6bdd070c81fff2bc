//! The boundaries as glTF 2.0 (binary), for masters and viewers that show the FMU while it runs.
//!
//! One node for each boundary, with the name of its terminal. Its translation and rotation are the boundary's position \[m\] and
//! orientation where the scene places it, before any motion; `extras` names the variables that they follow. Points \[m\] are relative to the reference
//! point. glTF has y upwards, scenes have z: a node above all others turns one into the other, so that the values of the
//! variables go into the nodes as they are.

use std::f64::consts::FRAC_1_SQRT_2;

use serde_json::{Value, json};
use sphere_dda::Vec3;
use sphere_dda::geometry::Triangulation;
use sphere_dda::results::frames::patches;
use sphere_dda::scene::Scene;
use sphere_dda_fmu::table::Entry;
use sphere_dda_fmu::version::VERSION;

/// Its place in `resources/`.
pub(crate) const GEOMETRY_FILE: &str = "boundaries.glb";

/// Component types and kinds of arrays, as glTF numbers them.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// The boundaries of a scene; `variables` are those of FMI 2.0, one for each component. `None` if there is no boundary.
#[must_use]
pub(crate) fn glb(scene: &Scene, variables: &[Entry]) -> Option<Vec<u8>> {
    if scene.boundaries.is_empty() {
        return None;
    }
    let mut parts = Parts::default();
    // From z upwards to y upwards; glTF orders quaternions x, y, z, w.
    let children: Vec<usize> = (1..=scene.boundaries.len()).collect();
    let upright = [-FRAC_1_SQRT_2, 0.0, 0.0, FRAC_1_SQRT_2];
    let mut nodes = vec![json!({ "rotation": upright, "children": children })];
    let mut meshes = Vec::new();
    for (b, patch) in patches(scene).enumerate() {
        let boundary = &scene.boundaries[b];
        let point = boundary.point_of_action;
        let named = |field: &str, component: usize| {
            let mut own = variables.iter().filter(|entry| {
                entry
                    .variable
                    .boundary
                    .is_some_and(|(owner, of)| owner == b && of == field)
            });
            own.nth(component).map(Entry::name)
        };
        nodes.push(json!({
            "name": boundary.name,
            "mesh": b,
            "translation": [point.x, point.y, point.z],
            "rotation": [0.0, 0.0, 0.0, 1.0],
            "extras": {
                "translation": ([0, 1, 2].map(|k| named("position", k))),
                "rotation": ([1, 2, 3, 0].map(|k| named("orientation", k))),
            },
        }));
        let (points, triangles) = parts.push(&patch, point);
        meshes.push(json!({
            "name": boundary.name,
            "primitives": [{ "attributes": { "POSITION": points }, "indices": triangles, "material": 0 }],
        }));
    }
    let document = json!({
        "asset": { "version": "2.0", "generator": format!("sphere-dda {VERSION}") },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": nodes,
        "meshes": meshes,
        "materials": [{
            "doubleSided": true,
            "pbrMetallicRoughness": { "baseColorFactor": [0.7, 0.72, 0.75, 1.0], "metallicFactor": 0.0 },
        }],
        "accessors": parts.accessors,
        "bufferViews": parts.views,
        "buffers": [{ "byteLength": parts.bytes.len() }],
    });
    Some(container(document.to_string().into_bytes(), parts.bytes))
}

/// Arrays of numbers in one buffer, and what glTF says of them.
#[derive(Default)]
struct Parts {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Parts {
    /// Adds points relative to `origin`, and triangles. Returns the numbers of their accessors.
    fn push(&mut self, patch: &Triangulation, origin: Vec3) -> (usize, usize) {
        let points = patch.points.iter().map(|x| (x - origin).map(|v| v as f32));
        let points: Vec<_> = points.collect();
        // The standard wants the bounds of the numbers as they are stored.
        let all = || points.iter().copied();
        let least = all().reduce(|a, b| a.inf(&b)).unwrap_or_default();
        let most = all().reduce(|a, b| a.sup(&b)).unwrap_or_default();
        let stored = points.iter().flat_map(|x| x.iter());
        let bytes: Vec<u8> = stored.flat_map(|v| v.to_le_bytes()).collect();
        let vertices = self.array(
            &bytes,
            VERTICES,
            json!({
                "componentType": FLOAT, "type": "VEC3", "count": points.len(),
                "min": least.as_slice(), "max": most.as_slice(),
            }),
        );
        let corners = patch.triangles.iter().flatten();
        let bytes: Vec<u8> = corners.flat_map(|corner| corner.to_le_bytes()).collect();
        let count = 3 * patch.triangles.len();
        let accessor = json!({ "componentType": UNSIGNED_INT, "type": "SCALAR", "count": count });
        (vertices, self.array(&bytes, INDICES, accessor))
    }

    fn array(&mut self, bytes: &[u8], target: u32, mut accessor: Value) -> usize {
        accessor["bufferView"] = self.views.len().into();
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(), "target": target,
        }));
        self.bytes.extend_from_slice(bytes);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }
}

/// The binary form: a header of 12 bytes, then both chunks, each with its length and kind, filled up to 4 bytes.
fn container(mut document: Vec<u8>, mut bytes: Vec<u8>) -> Vec<u8> {
    document.resize(document.len().next_multiple_of(4), b' ');
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    let chunk = |kind: &[u8; 4], content: Vec<u8>| {
        let length = (content.len() as u32).to_le_bytes();
        [&length[..], &kind[..], &content].concat()
    };
    let chunks = [chunk(b"JSON", document), chunk(b"BIN\0", bytes)].concat();
    let length = (12 + chunks.len()) as u32;
    [
        &b"glTF"[..],
        &2_u32.to_le_bytes(),
        &length.to_le_bytes(),
        &chunks,
    ]
    .concat()
}
