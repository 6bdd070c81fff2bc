//! Height fields: what the files mean, and which are refused.

use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, Geometry, HeightField};

use super::{close, closest_points, geometry, same, v};

fn field(text: &str) -> HeightField {
    HeightField::esri_ascii(text.as_bytes()).unwrap_or_else(|e| panic!("{e:?}"))
}

fn placed(text: &str, scale: [f64; 3], translation: Vec3) -> Facets {
    field(text).facets("terrain", scale, translation)
}

fn facets(text: &str) -> Facets {
    placed(text, [1.0; 3], Vec3::zeros())
}

/// An ESRI ASCII grid of `columns` x `rows` cells of 1 m, its south-western node at the origin.
fn grid(columns: usize, rows: usize, z: impl Fn(f64, f64) -> f64) -> String {
    let mut text = format!("ncols {columns}\nnrows {rows}\nxllcenter 0\nyllcenter 0\ncellsize 1\n");
    for row in (0..rows).rev() {
        let line: Vec<String> = (0..columns)
            .map(|column| z(column as f64, row as f64).to_string())
            .collect();
        text += &(line.join(" ") + "\n");
    }
    text
}

/// The height of the surface at `(x, y)` \[m\], by bisection: the normal of the closest touch says on which side of
/// the surface a point lies.
fn height(surface: &Geometry, x: f64, y: f64) -> f64 {
    let (mut low, mut high) = (-100.0, 100.0);
    // Rays are not offered, so the sign of the normal's vertical part says on which side a point lies.
    for _ in 0..80 {
        let z = 0.5 * (low + high);
        let mut found = closest_points(surface, v(x, y, z), 0.0, 300.0);
        found.sort_by(|a, b| a.gap.total_cmp(&b.gap));
        if found[0].normal.z > 0.0 {
            high = z;
        } else {
            low = z;
        }
    }
    0.5 * (low + high)
}

#[test]
fn heights_stand_at_the_cell_centres_north_first() {
    let text =
        "NCOLS 3\nNRows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\nnodata_value -1\n1 2 3\n4 5 6\n";
    let field = field(text);
    assert_eq!(field.height(0, 0), Some(4.0));
    assert_eq!(field.height(2, 1), Some(3.0));
    assert_eq!(field.height(3, 0), None);
    let corners = facets(text).vertices;
    for expected in [
        v(11.0, 21.0, 4.0),
        v(15.0, 21.0, 6.0),
        v(11.0, 23.0, 1.0),
        v(15.0, 23.0, 3.0),
    ] {
        assert!(corners.contains(&expected), "{expected:?} of {corners:?}");
    }
    assert_eq!((corners.len(), facets(text).triangles.len()), (6, 4));
    // Centres instead of corners, dx and dy, other order, white space and line breaks: the same grid.
    let other = "\u{feff}dy 2\r\ndx 2\r\nyllcenter 21\r\nxllcenter 11\r\nnrows 2\r\nncols 3\r\n\r\n1\t2\r\n3 4e0\r\n5 6.0";
    assert_eq!(
        HeightField::esri_ascii(other.as_bytes()).as_ref(),
        Ok(&field)
    );
}

#[test]
fn the_surface_passes_through_its_nodes_and_is_bilinear_along_their_lines() {
    let z = |x: f64, y: f64| 0.3 * x - 0.2 * y + 0.5 * (x * 1.3).sin() * (y * 0.7).cos();
    let surface = geometry([facets(&grid(6, 5, z))]);
    for j in 0..5 {
        for i in 0..6 {
            let (x, y) = (f64::from(i), f64::from(j));
            let node = closest_points(&surface, v(x, y, z(x, y)), 0.0, 1e-12);
            assert!(!node.is_empty(), "the node {x} {y} is not on the surface");
            if i < 5 {
                let between = height(&surface, x + 0.25, y.clamp(1e-9, 4.0 - 1e-9));
                let expected = 0.75 * z(x, y) + 0.25 * z(x + 1.0, y);
                assert!(
                    (between - expected).abs() < 1e-8,
                    "{between} is not {expected}"
                );
            }
        }
    }
}

/// The joints of a plane grid are no features: its closed form is the plane's, wherever the sphere stands.
#[test]
fn a_plane_grid_is_a_plane() {
    let z = |x: f64, y: f64| 0.1 * x - 0.3 * y + 7.0;
    let normal = v(-0.1, 0.3, 1.0).normalize();
    let surface = geometry([facets(&grid(40, 30, z))]);
    for k in 0..500 {
        let (x, y) = (1.0 + 0.07 * f64::from(k), 1.0 + 0.05 * f64::from(k));
        let (x, y) = if k % 5 == 0 {
            (x.round(), y.round())
        } else {
            (x, y)
        };
        let foot = v(x, y, z(x, y));
        let found = closest_points(&surface, foot + normal * 0.9, 1.0, 0.0);
        assert_eq!(found.len(), 1);
        close(found[0].gap, -0.1);
        same(found[0].normal, normal);
        assert_eq!(found[0].feature, 0);
    }
}

/// A gently curved surface is not cut into flats with steps between them: the gap of a sphere that follows the
/// triangles' own heights stays what it is.
#[test]
fn a_smooth_slope_has_no_steps() {
    let z = |x: f64, _: f64| 1e-7 * x * x;
    let surface = geometry([facets(&grid(1000, 3, z))]);
    let radius = 1e-3;
    for k in 1..990 {
        // In the middle of a cell, away from the edges that the sphere would touch instead.
        let x = f64::from(k) + 0.5;
        let slope = z(x + 0.5, 0.0) - z(x - 0.5, 0.0);
        let foot = v(x, 1.0, 0.5 * (z(x + 0.5, 0.0) + z(x - 0.5, 0.0)));
        let normal = v(-slope, 0.0, 1.0).normalize();
        let found = closest_points(&surface, foot + normal * radius, radius, 1e-6);
        assert_eq!(found.len(), 1);
        assert!(
            found[0].gap.abs() < 1e-6 * radius,
            "{:e} at {x}",
            found[0].gap
        );
    }
}

#[test]
fn squares_without_data_are_holes() {
    let mut text =
        grid(5, 5, |_, _| 1.0).replacen("cellsize 1\n", "cellsize 1\nNODATA_value nan\n", 1);
    // The middle node: the third line of heights is the third from the south.
    let middle = text.lines().nth(8).unwrap().to_owned();
    text = text.lines().enumerate().map(|(k, l)| if k == 8 { middle.replacen("1 1 1", "1 1 NaN", 1) } else { l.to_owned() } + "\n").collect();
    let field = field(&text);
    assert_eq!(field.height(2, 2), None);
    let holed = field.facets("hole", [1.0; 3], Vec3::zeros());
    assert_eq!((holed.vertices.len(), holed.triangles.len()), (24, 24));
    let surface = geometry([holed]);
    assert!(
        closest_points(&surface, v(2.0, 2.0, 1.2), 0.5, 0.0).is_empty(),
        "the hole is open"
    );
    assert_eq!(
        closest_points(&surface, v(0.5, 2.0, 1.2), 0.5, 0.0).len(),
        1
    );
    // -9999 unless the file says otherwise.
    let default = grid(3, 2, |x, _| if x == 2.0 { -9999.0 } else { 0.0 });
    assert_eq!(facets(&default).triangles.len(), 2);
}

/// Diagonals follow the bend: a ridge and a valley along either diagonal of the cells keep their height along it.
#[test]
fn ridges_and_valleys_across_the_cells_get_no_dams() {
    for sign in [1.0, -1.0] {
        for mirrored in [false, true] {
            let across = move |x: f64, y: f64| if mirrored { x + y - 6.0 } else { x - y };
            let surface = geometry([facets(&grid(7, 7, |x, y| sign * across(x, y).abs()))]);
            // The corner squares of the grid have no neighbours to judge a ridge by.
            for k in 2..10 {
                let t = 0.5 * f64::from(k) + 1e-7;
                let z = height(&surface, t, if mirrored { 6.0 - t } else { t });
                assert!(z.abs() < 1e-5, "{z} at {t}");
            }
        }
    }
}

#[test]
fn large_map_coordinates_lose_nothing() {
    let z = |x: f64, y: f64| 0.013 * x * y;
    let near = facets(&grid(20, 20, z));
    let far = grid(20, 20, z)
        .replace("xllcenter 0", "xllcenter 5000000")
        .replace("yllcenter 0", "yllcenter 4000000");
    let far = placed(&far, [1.0; 3], v(-5e6, -4e6, 0.0));
    assert_eq!(far, near);
}

#[test]
fn scales_apply_before_the_translation() {
    let text = grid(2, 2, |x, y| 1.0 + x + 2.0 * y);
    let corners = placed(&text, [2.0, 3.0, 0.1], v(10.0, 20.0, 30.0)).vertices;
    same(
        *corners.iter().max_by(|a, b| a.z.total_cmp(&b.z)).unwrap(),
        v(12.0, 23.0, 30.4),
    );
}

/// Each bad file is refused with every problem it has: line, what stands there, what should.
#[test]
fn bad_grids_are_refused_with_line_and_reason() {
    let good = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n1 2 3\n4 5 6\n";
    assert!(HeightField::esri_ascii(good.as_bytes()).is_ok());
    /// Text that is replaced, by what, and the lines and parts of the problems.
    type Case = (&'static str, &'static str, &'static [(usize, &'static str)]);
    let cases: &[Case] = &[
        ("ncols 3\n", "", &[(1, "without ncols")]),
        (
            "xllcorner 0\nyllcorner 0\ncellsize 1\n",
            "",
            &[(
                1,
                "cellsize or dx, xllcorner or xllcenter, cellsize or dy, yllcorner",
            )],
        ),
        (
            "ncols 3",
            "ncols 3.5",
            &[(1, "found ncols 3.5, expected a whole number from 2")],
        ),
        ("nrows 2", "nrows 1", &[(2, "nrows 1")]),
        ("nrows 2", "nrows -2", &[(2, "nrows -2")]),
        (
            "ncols 3\nnrows 2",
            "ncols 99999999\nnrows 99999999",
            &[(2, "at most 100000000")],
        ),
        ("ncols 3", "ncols three", &[(1, "`ncols three`")]),
        (
            "ncols 3",
            "ncols",
            &[(1, "`ncols`, expected the key and one number")],
        ),
        ("ncols 3", "ncols 3 4", &[(1, "`ncols 3 4`")]),
        ("ncols 3", "ncols 3\nncols 3", &[(2, "again")]),
        ("ncols 3", "ncol 3", &[(1, "`ncol`"), (1, "without ncols")]),
        (
            "cellsize 1",
            "cellsize 0",
            &[(5, "a size > 0"), (5, "a size > 0")],
        ),
        ("cellsize 1", "cellsize nan", &[(5, "`cellsize nan`")]),
        (
            "cellsize 1",
            "cellsize 1\ndx 1",
            &[(5, "one of the two"), (1, "without cellsize or dy")],
        ),
        (
            "yllcorner 0",
            "yllcorner 0\nyllcenter 0",
            &[(5, "yllcenter together with yllcorner")],
        ),
        (
            "cellsize 1\nNODATA_value -9999",
            "cellsize -1\nNODATA_value none",
            &[(6, "NODATA_value none"), (5, "a size > 0")],
        ),
        (
            "4 5 6",
            "4 5",
            &[(
                8,
                "the end after 5 heights, expected ncols x nrows = 3 x 2 = 6",
            )],
        ),
        ("4 5 6", "4 5 6 7", &[(8, "from `7` on")]),
        ("4 5 6", "4 x 6", &[(8, "`x`")]),
        ("4 5 6", "4 nan inf", &[(8, "`nan`"), (8, "`inf`")]),
        (
            "1 2 3\n4 5 6",
            "1,5 2 3\n4 5",
            &[(7, "decimal point"), (8, "the end after 5")],
        ),
    ];
    for (from, to, expected) in cases {
        let text = good.replacen(from, to, 1);
        let problems = HeightField::esri_ascii(text.as_bytes()).expect_err(&text);
        let mut left: Vec<String> = problems.iter().map(ToString::to_string).collect();
        for (line, part) in *expected {
            let place = format!("line {line}: found ");
            let at = left
                .iter()
                .position(|p| p.starts_with(&place) && p.contains(part));
            left.remove(at.unwrap_or_else(|| panic!("{text}: {line} {part}: {left:?}")));
        }
        assert!(
            left.is_empty() || to.contains("size"),
            "{text}: also {left:?}"
        );
    }
    let binary = HeightField::esri_ascii(b"II*\0\xff\xfe\n").unwrap_err();
    assert!(binary[0].to_string().contains("not text"));
    let words = HeightField::esri_ascii("words\n".repeat(1000).as_bytes()).unwrap_err();
    assert!(words.len() < 20);
    let dashes =
        HeightField::esri_ascii((good.to_owned() + &"- ".repeat(1000)).as_bytes()).unwrap_err();
    assert!(dashes.len() < 20);
    assert!(
        HeightField::esri_ascii(b"").unwrap_err()[0]
            .to_string()
            .contains("without ncols, nrows")
    );
}
