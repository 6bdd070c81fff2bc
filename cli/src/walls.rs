//! `sphere-dda walls`: what the triangles of boundaries feel, as CSV.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use miette::miette;
use sphere_dda::formats::vtu::{Contents, Field};
use sphere_dda::observe::walls::is_array;
use sphere_dda::results::folder::Folder;

use crate::failure::Failure;
use crate::progress::print;

/// Arguments of `walls`.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  sphere-dda walls results --boundary chute > chute.csv")]
pub(crate) struct Walls {
    /// A result folder of a scene with `wall_fields`.
    folder: PathBuf,
    /// Time [s]: of the frame next to it; the last frame if absent.
    #[arg(long, value_name = "SECONDS")]
    time: Option<f64>,
    /// Only this boundary.
    #[arg(long, value_name = "NAME")]
    boundary: Option<String>,
}

/// Prints a row for each triangle: its boundary, its number there, its middle, and all arrays of the frame.
///
/// # Errors
/// What is no result folder or has no such arrays, an unknown boundary, a standard output that cannot be written.
pub(crate) fn run(arguments: &Walls) -> Result<(), Failure> {
    let folder = Folder::open(&arguments.folder).map_err(Failure::input)?;
    let names = folder.about()["boundaries"].as_array();
    let names = names.into_iter().flatten().filter_map(|name| name.as_str());
    let names: Vec<&str> = names.collect();
    if let Some(wanted) = &arguments.boundary
        && !names.contains(&&**wanted)
    {
        return Err(Failure::Input(miette!(
            "--boundary: found `{wanted}`, expected one of {}",
            names.join(", ")
        )));
    }
    let times = folder.times();
    let distance = |k: &usize| match arguments.time {
        Some(time) => (times[*k] - time).abs(),
        None => -times[*k],
    };
    let frames = 0..times.len();
    let nearest = frames.min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let frame = folder
        .frame(nearest.unwrap_or_default())
        .map_err(Failure::input)?;
    let grid = frame.boundaries.unwrap_or_default();
    let (Some(owner), Some(area)) = (array(&grid, "boundary"), array(&grid, "area")) else {
        return Err(Failure::Input(miette!(
            "`{}` has no walls: expected `wall_fields = true` of a boundary of its scene",
            arguments.folder.display()
        )));
    };
    let asked = |t: &usize| {
        let name = names.get(owner.values[*t] as usize);
        let wanted = arguments.boundary.as_deref();
        area.values[*t] > 0.0 && wanted.is_none_or(|wanted| name == Some(&wanted))
    };
    let triangles: Vec<usize> = (0..owner.values.len()).filter(asked).collect();
    print(|out| write(out, &grid, &triangles, (&owner.values, &names)))
}

fn array<'a>(grid: &'a Contents, name: &str) -> Option<&'a Field> {
    grid.cell_data.iter().find(|field| field.name == name)
}

fn write(
    out: &mut dyn Write,
    grid: &Contents,
    triangles: &[usize],
    (owner, names): (&[f64], &[&str]),
) -> io::Result<()> {
    let fields = grid.cell_data.iter();
    let fields: Vec<&Field> = fields.filter(|field| is_array(&field.name)).collect();
    // Triangles are counted from the first of their boundary.
    let mut first = BTreeMap::new();
    for (t, own) in owner.iter().enumerate() {
        first.entry(*own as usize).or_insert(t);
    }
    write!(out, "boundary,triangle [-],x [m],y [m],z [m]")?;
    for field in &fields {
        for k in 1..=field.components {
            let index = if field.components > 1 {
                format!("[{k}]")
            } else {
                String::new()
            };
            write!(out, ",{}{index} [{}]", field.name, field.unit)?;
        }
    }
    writeln!(out)?;
    for &t in triangles {
        let own = owner[t] as usize;
        let name = names.get(own).copied().unwrap_or_default();
        let corners = grid.connectivity[3 * t..3 * t + 3].iter();
        let sum: sphere_dda::Vec3 = corners.map(|&corner| grid.points[corner as usize]).sum();
        let middle = sum / 3.0;
        write!(
            out,
            "{name},{},{},{},{}",
            t - first[&own],
            middle.x,
            middle.y,
            middle.z
        )?;
        for field in &fields {
            for value in &field.values[field.components * t..field.components * (t + 1)] {
                write!(out, ",{value}")?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}
