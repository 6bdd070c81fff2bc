//! From facets as given to a mesh whose features have names: welding, slivers, flat groups, straight edges.
//!
//! Contact history follows feature numbers, so a number must not change where the surface does not:
//! coplanar triangles that share an edge are one face, collinear edges between the same faces are one edge.
//! Groups grow from their largest member and compare with that member only, so tolerances do not add up.

use std::collections::BTreeMap;

use super::error::{GeometryError, finite};
use super::facets::Facets;
use super::features::{Face, Topology};
use crate::Vec3;

/// Welding and flatness tolerance over the diagonal of the bounding box \[-\]: seven typed digits.
pub(super) const RELATIVE_TOLERANCE: f64 = 4e-7;
/// The same for computed vertices: a smooth surface of many facets is then not cut into flats with steps between.
const COMPUTED_TOLERANCE: f64 = 1e-11;
/// Coplanar neighbours may differ by at most this cosine (0.01 rad) besides lying in the plane.
const FLAT_COSINE: f64 = 1.0 - 5e-5;

/// What was mended when a mesh was built.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Repair {
    /// Vertices that coincided with an earlier one within the tolerance.
    pub welded_vertices: usize,
    /// Facets without area that were left out: name of the shape, number of the facet.
    pub dropped_facets: Vec<(String, usize)>,
}

/// An edge of the welded mesh.
pub(super) struct Edge {
    pub(super) ends: [u32; 2],
    /// The triangles at it.
    pub(super) triangles: Vec<u32>,
    /// Whether the surface goes on flat across it.
    flat: bool,
}

/// The welded triangles, and which edge ids each has.
struct Welded {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    tolerance: f64,
    repair: Repair,
}

pub(super) fn build(shapes: &[&Facets]) -> Result<Topology, GeometryError> {
    let welded = weld(shapes)?;
    let corners: Vec<[Vec3; 3]> = welded
        .triangles
        .iter()
        .map(|t| t.map(|v| welded.vertices[v as usize]))
        .collect();
    let (mut edges, edge_of) = edges(&welded.triangles);
    let (group, planes) = flat_groups(&corners, &edges, &edge_of, welded.tolerance);
    for edge in &mut edges {
        edge.flat = is_flat(edge, &group, &welded);
    }

    let (faces, border) = faces(&planes, &edges, &group);
    let first_edge = faces.len() as u32;
    let (edge_feature, straight) = straight_edges(&edges, &group, &welded, first_edge);
    let first_corner = first_edge + straight.len() as u32;
    let (vertex_feature, sharp) =
        corner_features(&edges, &edge_feature, &group, &welded, first_corner);

    let parts = (0..corners.len())
        .map(|t| {
            let [ab, bc, ca] = edge_of[t].map(|e| edge_feature[e as usize]);
            let [a, b, c] = welded.triangles[t].map(|v| vertex_feature[v as usize]);
            [group[t], ab, bc, ca, a, b, c]
        })
        .collect();
    Ok(Topology {
        vertices: welded.vertices,
        triangles: welded.triangles,
        parts,
        faces,
        border,
        edges: straight,
        corners: sharp,
        tolerance: welded.tolerance,
        repair: welded.repair,
    })
}

/// The faces, and the ends of the edges around each.
fn faces(planes: &[(Vec3, f64)], edges: &[Edge], group: &[u32]) -> (Vec<Face>, Vec<[u32; 2]>) {
    let mut sides: Vec<(u32, [u32; 2])> = Vec::new();
    for edge in edges.iter().filter(|e| !e.flat) {
        sides.extend(groups_at(edge, group).into_iter().map(|g| (g, edge.ends)));
    }
    // Stable: the border of a face keeps the order of the edges.
    sides.sort_by_key(|&(g, _)| g);
    let mut end = 0;
    let faces = (0..).zip(planes).map(|(g, &(normal, offset))| {
        let first = end;
        end += sides[first..].partition_point(|&(at, _)| at == g);
        Face {
            normal,
            offset,
            border: [first as u32, end as u32],
        }
    });
    (
        faces.collect(),
        sides.iter().map(|&(_, ends)| ends).collect(),
    )
}

/// Joins coinciding vertices, leaves out slivers, refuses what cannot be mended.
fn weld(shapes: &[&Facets]) -> Result<Welded, GeometryError> {
    let (mut min, mut max) = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
    for shape in shapes {
        for (i, &v) in shape.vertices.iter().enumerate() {
            finite(&shape.name, format!("vertex {i}"), v)?;
            (min, max) = (min.inf(&v), max.sup(&v));
        }
    }
    let rounding = shapes.iter().map(|s| s.rounding).fold(0.0, f64::max);
    let relative = if shapes.iter().all(|s| s.computed) {
        COMPUTED_TOLERANCE
    } else {
        RELATIVE_TOLERANCE
    };
    let largest = min.amax().max(max.amax());
    let tolerance = (relative * (max - min).norm())
        .max(4.0 * rounding)
        .max(16.0 * f64::EPSILON * largest);

    let mut grid = WeldGrid::new(tolerance);
    let mut triangles = Vec::new();
    let mut repair = Repair::default();
    for shape in shapes {
        let welded: Vec<u32> = shape.vertices.iter().map(|&v| grid.insert(v)).collect();
        let first = triangles.len();
        let mut origin = Vec::new();
        for (facet, indices) in shape.triangles.iter().enumerate() {
            if let Some(&vertex) = indices.iter().find(|&&v| v as usize >= welded.len()) {
                return Err(GeometryError::Index {
                    name: shape.name.clone(),
                    facet,
                    vertex,
                    vertices: welded.len(),
                });
            }
            let triangle = indices.map(|v| welded[v as usize]);
            if is_sliver(&triangle.map(|v| grid.points[v as usize]), tolerance) {
                repair.dropped_facets.push((shape.name.clone(), facet));
            } else {
                triangles.push(triangle);
                origin.push(facet);
            }
        }
        if origin.is_empty() {
            return Err(GeometryError::Empty {
                name: shape.name.clone(),
                facets: shape.triangles.len(),
            });
        }
        // Different shapes of one boundary may meet in one edge, as a partition in a box does; one file may not.
        for edge in edges(&triangles[first..]).0 {
            if edge.triangles.len() > 2 {
                return Err(GeometryError::NonManifold {
                    name: shape.name.clone(),
                    facets: edge.triangles.iter().map(|&t| origin[t as usize]).collect(),
                    edge: edge.ends.map(|v| grid.points[v as usize]),
                });
            }
        }
    }
    let given: usize = shapes.iter().map(|s| s.vertices.len()).sum();
    repair.welded_vertices = given - grid.points.len();
    Ok(Welded {
        vertices: grid.points,
        triangles,
        tolerance,
        repair,
    })
}

/// Points in cells much larger than the tolerance, so that nearly every look-up reads one cell.
struct WeldGrid {
    tolerance: f64,
    cells: BTreeMap<[i64; 3], Vec<u32>>,
    points: Vec<Vec3>,
}

impl WeldGrid {
    fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            cells: BTreeMap::new(),
            points: Vec::new(),
        }
    }

    /// The index of the first point within the tolerance of `p`, which may be `p` itself.
    fn insert(&mut self, p: Vec3) -> u32 {
        let size = (64.0 * self.tolerance).max(f64::MIN_POSITIVE);
        let cell = |v: Vec3| [0, 1, 2].map(|k| (v[k] / size).floor() as i64);
        let (low, high) = (
            cell(p.add_scalar(-self.tolerance)),
            cell(p.add_scalar(self.tolerance)),
        );
        let mut found: Option<u32> = None;
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let near = self.cells.get(&[x, y, z]).into_iter().flatten();
                    for &i in near {
                        if (self.points[i as usize] - p).norm() <= self.tolerance {
                            found = Some(found.map_or(i, |f| f.min(i)));
                        }
                    }
                }
            }
        }
        found.unwrap_or_else(|| {
            let index = self.points.len() as u32;
            self.points.push(p);
            self.cells.entry(cell(p)).or_default().push(index);
            index
        })
    }
}

/// Whether the height over the longest side is within the tolerance.
fn is_sliver(&[a, b, c]: &[Vec3; 3], tolerance: f64) -> bool {
    let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
    (b - a).cross(&(c - a)).norm() <= tolerance * longest
}

/// All edges in the order of their ends, and the edges ab, bc, ca of each triangle.
pub(super) fn edges(triangles: &[[u32; 3]]) -> (Vec<Edge>, Vec<[u32; 3]>) {
    let mut sides: Vec<([u32; 2], u32, usize)> = Vec::with_capacity(3 * triangles.len());
    for (t, &[a, b, c]) in triangles.iter().enumerate() {
        for (slot, (p, q)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            sides.push(([p.min(q), p.max(q)], t as u32, slot));
        }
    }
    sides.sort_unstable();
    let mut edges: Vec<Edge> = Vec::new();
    let mut edge_of = vec![[0; 3]; triangles.len()];
    for (ends, triangle, slot) in sides {
        match edges.last_mut() {
            Some(edge) if edge.ends == ends => edge.triangles.push(triangle),
            _ => edges.push(Edge {
                ends,
                triangles: vec![triangle],
                flat: false,
            }),
        }
        edge_of[triangle as usize][slot] = edges.len() as u32 - 1;
    }
    (edges, edge_of)
}

/// The flat group of each triangle, and the plane (normal, offset) of each group.
fn flat_groups(
    corners: &[[Vec3; 3]],
    edges: &[Edge],
    edge_of: &[[u32; 3]],
    tolerance: f64,
) -> (Vec<u32>, Vec<(Vec3, f64)>) {
    let area = |t: u32| {
        let [a, b, c] = corners[t as usize];
        (b - a).cross(&(c - a))
    };
    let mut seeds: Vec<u32> = (0..corners.len() as u32).collect();
    seeds.sort_by(|&s, &t| area(t).norm().total_cmp(&area(s).norm()).then(s.cmp(&t)));

    const NONE: u32 = u32::MAX;
    let mut seed_of = vec![NONE; corners.len()];
    for seed in seeds {
        if seed_of[seed as usize] != NONE {
            continue;
        }
        let normal = area(seed).normalize();
        let origin = corners[seed as usize][0];
        let mut front = vec![seed];
        seed_of[seed as usize] = seed;
        while let Some(t) = front.pop() {
            for &edge in &edge_of[t as usize] {
                for &next in &edges[edge as usize].triangles {
                    let in_plane = seed_of[next as usize] == NONE
                        && area(next).normalize().dot(&normal).abs() >= FLAT_COSINE
                        && corners[next as usize]
                            .iter()
                            .all(|c| (c - origin).dot(&normal).abs() <= tolerance);
                    if in_plane {
                        seed_of[next as usize] = seed;
                        front.push(next);
                    }
                }
            }
        }
    }

    // Numbered in the order of the triangles, so that the numbers do not hang on areas.
    let mut number = vec![NONE; corners.len()];
    let mut planes = Vec::new();
    let group = seed_of
        .iter()
        .map(|&seed| {
            let n = &mut number[seed as usize];
            if *n == NONE {
                *n = planes.len() as u32;
                let normal = area(seed).normalize();
                planes.push((normal, normal.dot(&corners[seed as usize][0])));
            }
            *n
        })
        .collect();
    (group, planes)
}

/// Whether two triangles of one group lie on opposite sides of the edge.
fn is_flat(edge: &Edge, group: &[u32], welded: &Welded) -> bool {
    let [a, b] = edge.ends.map(|v| welded.vertices[v as usize]);
    let along = (b - a).normalize();
    let inward = |t: u32| {
        let far = welded.triangles[t as usize]
            .iter()
            .find(|v| !edge.ends.contains(v));
        let arm = far.map_or(Vec3::zeros(), |&v| welded.vertices[v as usize] - a);
        arm - along * arm.dot(&along)
    };
    edge.triangles.iter().enumerate().any(|(i, &s)| {
        edge.triangles[i + 1..]
            .iter()
            .any(|&t| group[s as usize] == group[t as usize] && inward(s).dot(&inward(t)) < 0.0)
    })
}

/// The groups at an edge, sorted, each once.
fn groups_at(edge: &Edge, group: &[u32]) -> Vec<u32> {
    let mut at: Vec<u32> = edge.triangles.iter().map(|&t| group[t as usize]).collect();
    at.sort_unstable();
    at.dedup();
    at
}

/// The feature of each edge: its face where flat, else a straight chain of edges between the same faces, numbered from
/// `first` on; and the ends and one face of each chain.
fn straight_edges(
    edges: &[Edge],
    group: &[u32],
    welded: &Welded,
    first: u32,
) -> (Vec<u32>, Vec<([u32; 2], u32)>) {
    let point = |v: u32| welded.vertices[v as usize];
    let at_vertex = sharp_edges(edges, welded.vertices.len());
    let length = |e: u32| {
        let [a, b] = edges[e as usize].ends;
        (point(b) - point(a)).norm()
    };
    let mut seeds: Vec<u32> = (0..edges.len() as u32)
        .filter(|&e| !edges[e as usize].flat)
        .collect();
    seeds.sort_by(|&d, &e| length(e).total_cmp(&length(d)).then(d.cmp(&e)));

    const NONE: u32 = u32::MAX;
    let mut chain_of = vec![NONE; edges.len()];
    let mut chains: Vec<[u32; 2]> = Vec::new();
    for seed in seeds {
        if chain_of[seed as usize] != NONE {
            continue;
        }
        let chain = chains.len() as u32;
        chain_of[seed as usize] = chain;
        let groups = groups_at(&edges[seed as usize], group);
        let [a, b] = edges[seed as usize].ends;
        let ends = [(a, b), (b, a)].map(|(mut end, other)| {
            let along = (point(end) - point(other)).normalize();
            while let [d, e] = at_vertex[end as usize][..] {
                let next = if chain_of[d as usize] == chain { e } else { d };
                let [p, q] = edges[next as usize].ends;
                let far = if p == end { q } else { p };
                let arm = point(far) - point(other);
                let off = arm - along * arm.dot(&along);
                let goes_on = chain_of[next as usize] == NONE
                    && off.norm() <= welded.tolerance
                    && (point(far) - point(end)).dot(&along) > 0.0
                    && groups_at(&edges[next as usize], group) == groups;
                if !goes_on {
                    break;
                }
                chain_of[next as usize] = chain;
                end = far;
            }
            end
        });
        chains.push(ends);
    }

    let mut straight = Vec::with_capacity(chains.len());
    let mut number = vec![NONE; chains.len()];
    let feature = (0..edges.len())
        .map(|e| {
            if edges[e].flat {
                return flat_group(&edges[e], group);
            }
            let n = &mut number[chain_of[e] as usize];
            if *n == NONE {
                *n = first + straight.len() as u32;
                let face = group[edges[e].triangles[0] as usize];
                straight.push((chains[chain_of[e] as usize], face));
            }
            *n
        })
        .collect();
    (feature, straight)
}

/// The group that goes on across a flat edge: the one with two triangles there.
fn flat_group(edge: &Edge, group: &[u32]) -> u32 {
    let mut at: Vec<u32> = edge.triangles.iter().map(|&t| group[t as usize]).collect();
    at.sort_unstable();
    at.windows(2).find(|w| w[0] == w[1]).map_or(at[0], |w| w[0])
}

/// The edges at each vertex that are not flat.
fn sharp_edges(edges: &[Edge], vertices: usize) -> Vec<Vec<u32>> {
    let mut at_vertex = vec![Vec::new(); vertices];
    for (e, edge) in edges.iter().enumerate().filter(|(_, e)| !e.flat) {
        for v in edge.ends {
            at_vertex[v as usize].push(e as u32);
        }
    }
    at_vertex
}

/// The feature of each vertex: the face or straight edge that runs through it, else a corner of its own, numbered from
/// `first` on; and the vertex and one face of each corner.
fn corner_features(
    edges: &[Edge],
    edge_feature: &[u32],
    group: &[u32],
    welded: &Welded,
    first: u32,
) -> (Vec<u32>, Vec<(u32, u32)>) {
    const NONE: u32 = u32::MAX;
    let at_vertex = sharp_edges(edges, welded.vertices.len());
    let mut triangle_at = vec![NONE; welded.vertices.len()];
    for (t, triangle) in welded.triangles.iter().enumerate().rev() {
        for &v in triangle {
            triangle_at[v as usize] = t as u32;
        }
    }
    let mut corners = Vec::new();
    let feature = (0..welded.vertices.len())
        .map(|v| {
            if triangle_at[v] == NONE {
                return NONE;
            }
            let face = group[triangle_at[v] as usize];
            match at_vertex[v][..] {
                [] => face,
                [d, e] if edge_feature[d as usize] == edge_feature[e as usize] => {
                    edge_feature[d as usize]
                }
                _ => {
                    corners.push((v as u32, face));
                    first + corners.len() as u32 - 1
                }
            }
        })
        .collect();
    (feature, corners)
}
