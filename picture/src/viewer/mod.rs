//! Results and scenes as one HTML file that shows them in a browser, offline.
//!
//! The page holds a `header` as JSON, and the data in parts of which each is deflated for itself: `blocks` of
//! frames with positions, fields and `contacts`, boundaries as rigid `bodies`, columns of `tables`. `coding`
//! has the error of each number. The program that shows them is in `web/`.

mod blocks;
mod bodies;
mod coding;
mod contacts;
mod detail;
mod entropy;
mod error;
mod header;
pub mod labels;
pub mod live;
mod page;
mod ranges;
mod recording;
mod survey;
mod tables;
mod text;
mod walls;

pub use detail::Detail;
pub use error::ViewError;
pub use recording::Recording;
pub use tables::Table;

use rayon::prelude::*;
use sphere_dda::Vec3;

use blocks::{Block, Grating};
use bodies::Bodies;
use coding::{deflated, doubles, singles, wholes};
use contacts::DECADES;
use detail::Kept;
use header::{BoundaryHeader, FieldHeader, ForceHeader, Header, TableHeader, WallHeader};
use labels::Label;
use live::Live;
use page::{Parts, bare, html};
use survey::Survey;

/// What a page shows besides its frames.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Title of the page.
    pub title: String,
    /// Names of the materials and of the boundaries, by index.
    pub materials: Vec<String>,
    /// Likewise.
    pub boundaries: Vec<String>,
    /// Tables for the plots.
    pub tables: Vec<Table>,
    /// Names in the picture.
    pub labels: Vec<Label>,
    /// Largest page \[bytes\]: fields get coarser, then frames are left out, until it is smaller.
    pub max_size: Option<u64>,
    /// A text over the picture.
    pub notice: String,
    /// What the page compares with its file to see that it is old; empty: it never looks.
    pub watched: String,
    /// The solver, in a page that runs it; the first of the tables has its outputs.
    pub live: Option<Live>,
}

/// A page and what was left out of it.
#[derive(Debug)]
pub struct Page {
    /// The file.
    pub html: String,
    /// Frames of the recording, and those that are kept: every `thinned`-th and the last.
    pub recorded: usize,
    /// Frames in the page.
    pub frames: usize,
    /// Frames of the recording for each in the page.
    pub thinned: usize,
    /// What is kept of the fields.
    pub detail: Detail,
    /// Spheres.
    pub spheres: usize,
    /// Largest error of a centre \[m\].
    pub position_error: f64,
}

/// Makes a page. `progress` hears how many frames of how many have been read; the number of all changes where frames
/// have to be left out.
///
/// # Errors
/// [`ViewError`].
pub fn page(
    recording: &Recording,
    options: &Options,
    mut progress: impl FnMut(usize, usize) + Send,
) -> Result<Page, ViewError> {
    let recorded = recording.times().len();
    let all: Vec<usize> = (0..recorded).collect();
    let mut total = 2 * recorded;
    let survey = Survey::of(recording, &all, |done| progress(done, total))?;
    let limited = options.max_size.is_some();
    let tried = if limited {
        tried(recorded, &survey)
    } else {
        Vec::new()
    };
    total += tried.len();
    let first = recording.frame(0)?;
    let mut bodies = Bodies::new(&first.surface);
    let fixed = fixed_parts(&survey, &bodies, options);
    let mut thinned = 1;
    let mut detail = match options.max_size {
        Some(limit) if !tried.is_empty() => {
            let show = |done| progress(recorded + done, total);
            let limit = limit.saturating_sub(fixed.size());
            promising(recording, &survey, &tried, limit, show)?
        }
        _ => Detail::Whole,
    };
    loop {
        let kept = kept(recorded, thinned);
        let fields = detail.kept(&survey);
        let taken = Taken {
            frames: &kept,
            detail,
            fields: &fields,
            thinned,
        };
        let header = header(recording, options, &survey, &bodies, taken);
        let room = options.max_size.map(|limit| {
            let bare = bare(&header) + fixed.size();
            (limit, limit.saturating_sub(bare))
        });
        let began = total - kept.len();
        let mut show = |done| progress(began + done, total);
        match fill(
            recording,
            &survey,
            &mut bodies,
            taken,
            room.map(|r| r.1),
            &mut show,
        )? {
            Filled::Whole(mut parts) => {
                parts.extend(fixed);
                return Ok(Page {
                    html: html(&header, &parts),
                    recorded,
                    frames: kept.len(),
                    thinned,
                    detail,
                    spheres: survey.slots.len(),
                    position_error: 0.5 * 3_f64.sqrt() * header.step,
                });
            }
            Filled::Full { .. } if detail < Detail::Magnitudes => {
                detail = detail.coarser().unwrap_or(detail);
                total += kept.len();
            }
            Filled::Full { done } if kept.len() > 1 => {
                // What was reached tells how many would have had room.
                let share = (done.max(1) as f64 / kept.len() as f64).min(0.99);
                let next = (thinned as f64 / share).ceil() as usize;
                thinned = next.clamp(thinned + 1, recorded.max(thinned + 1));
                total += self::kept(recorded, thinned).len();
            }
            Filled::Full { .. } => {
                let (limit, _) = room.unwrap_or_default();
                let whole = fill(recording, &survey, &mut bodies, taken, None, &mut show)?;
                let least = match whole {
                    Filled::Whole(parts) => parts.size() + bare(&header) + fixed.size(),
                    Filled::Full { .. } => limit,
                };
                return Err(ViewError::Size { least, limit });
            }
        }
    }
}

/// Blocks that are tried before all are made, and how many times more there must be.
const TRIED: usize = 3;
const WORTH: usize = 4;
/// A trial may be wrong by this: what is too large by no more is made.
const DOUBT: f64 = 1.05;

/// Frames of blocks over the whole recording; none if a trial costs about as much as the page.
fn tried(recorded: usize, survey: &Survey) -> Vec<usize> {
    let length = blocks::length(survey.slots.len());
    let blocks = recorded / length;
    if blocks < WORTH * TRIED {
        return Vec::new();
    }
    let block = |k: usize| (2 * k + 1) * blocks / (2 * TRIED) * length;
    (0..TRIED)
        .flat_map(|k| block(k)..block(k) + length)
        .collect()
}

/// The finest detail whose blocks promise to have room, by those with the frames `tried` of `recorded`.
fn promising(
    recording: &Recording,
    survey: &Survey,
    tried: &[usize],
    room: u64,
    mut progress: impl FnMut(usize) + Send,
) -> Result<Detail, ViewError> {
    let next = |detail: &Detail| detail.coarser();
    let details: Vec<Detail> = std::iter::successors(Some(Detail::Whole), next).collect();
    let fields: Vec<Vec<Kept>> = details.iter().map(|d| d.kept(survey)).collect();
    let grating = Grating::of(survey);
    let begin = |k: usize| Block::new(survey, grating, details[k], &fields[k]);
    let mut blocks: Vec<Block> = (0..details.len()).map(begin).collect();
    let mut sizes = vec![0; details.len()];
    let mut images = vec![vec![None; survey.slots.len()]; details.len()];
    let length = blocks::length(survey.slots.len());
    let mut done = 0;
    recording.each(tried, |moment| {
        let all = blocks.par_iter_mut().zip(&mut images);
        all.try_for_each(|(block, images)| block.push(&moment, images))?;
        done += 1;
        if done % length == 0 {
            for (k, block) in blocks.iter_mut().enumerate() {
                sizes[k] += std::mem::replace(block, begin(k)).pack().parts(0).size();
            }
        }
        progress(done);
        Ok(true)
    })?;
    let share = tried.len() as f64 / recording.times().len() as f64;
    let has_room = |k: &usize| sizes[*k] as f64 <= DOUBT * share * room as f64;
    let first = (0..details.len()).find(has_room);
    Ok(first.map_or(Detail::Magnitudes, |k| details[k]))
}

/// Every `thinned`-th frame and the last; with as many as there are, the first alone.
fn kept(recorded: usize, thinned: usize) -> Vec<usize> {
    let last = recorded - 1;
    let mut kept: Vec<usize> = (0..recorded).step_by(thinned).collect();
    if thinned < recorded && kept.last() != Some(&last) {
        kept.push(last);
    }
    kept
}

/// What a page taken of a recording.
#[derive(Clone, Copy)]
struct Taken<'a> {
    /// Indices of the frames.
    frames: &'a [usize],
    detail: Detail,
    fields: &'a [Kept],
    /// Frames of the recording for each that is taken.
    thinned: usize,
}

/// Blocks of frames that were made within the room there was.
enum Filled {
    Whole(Parts),
    Full {
        /// Frames that had room.
        done: usize,
    },
}

fn fill(
    recording: &Recording,
    survey: &Survey,
    bodies: &mut Bodies,
    taken: Taken<'_>,
    room: Option<u64>,
    progress: &mut (dyn FnMut(usize) + Send),
) -> Result<Filled, ViewError> {
    let grating = Grating::of(survey);
    let Taken {
        frames: kept,
        detail,
        fields,
        ..
    } = taken;
    let length = blocks::length(survey.slots.len());
    let mut parts = Parts::default();
    let mut images = vec![None; survey.slots.len()];
    let mut block = Block::new(survey, grating, detail, fields);
    let (mut number, mut done) = (0, 0);
    let mut full = false;
    bodies.restart();
    recording.each(kept, |moment| {
        block.push(&moment, &mut images)?;
        bodies.push(&moment)?;
        done += 1;
        if block.frames() == length || done == kept.len() {
            let whole = std::mem::replace(&mut block, Block::new(survey, grating, detail, fields));
            parts.extend(whole.pack().parts(number));
            number += 1;
        }
        full = room.is_some_and(|room| parts.size() > room);
        progress(done);
        Ok(!full)
    })?;
    if full {
        return Ok(Filled::Full { done: done - 1 });
    }
    parts.push("boundary-motion", singles(&bodies.motion));
    parts.push("boundary-force", singles(&bodies.force));
    if room.is_some_and(|room| parts.size() > room) {
        return Ok(Filled::Full { done: kept.len() });
    }
    Ok(Filled::Whole(parts))
}

/// What does not depend on how many frames are kept.
fn fixed_parts(survey: &Survey, bodies: &Bodies, options: &Options) -> Parts {
    let mut parts = Parts::default();
    if let Some(live) = &options.live {
        parts.push("module", deflated(&live.module));
    }
    let slots = &survey.slots;
    parts.push("sphere-id", wholes(slots.iter().map(|slot| slot.id)));
    parts.push(
        "sphere-material",
        wholes(slots.iter().map(|slot| slot.material)),
    );
    let radius: Vec<f64> = slots.iter().map(|slot| slot.radius).collect();
    parts.push("sphere-radius", doubles(&radius));
    for (k, body) in bodies.list.iter().enumerate() {
        let arms = body.arms.iter().flat_map(|arm| <[f64; 3]>::from(*arm));
        let arms: Vec<f32> = arms.map(|v| v as f32).collect();
        parts.push(format!("boundary{k}-points"), singles(&arms));
        let corners = body.triangles.iter().flatten().map(|&c| i64::from(c));
        parts.push(format!("boundary{k}-triangles"), wholes(corners));
    }
    for (t, table) in options.tables.iter().enumerate() {
        parts.push(format!("table{t}-time"), doubles(&table.time));
        for (c, column) in table.columns.iter().enumerate() {
            parts.push(format!("table{t}-{c}"), singles(&column.values));
        }
    }
    parts
}

fn header(
    recording: &Recording,
    options: &Options,
    survey: &Survey,
    bodies: &Bodies,
    taken: Taken<'_>,
) -> Header {
    let times = recording.times();
    let grating = Grating::of(survey);
    let fields = taken.fields.iter();
    let fields = fields.map(|kept| (kept, &survey.fields[kept.field]));
    let name = |index: usize| {
        let name = options.boundaries.get(index).cloned();
        name.unwrap_or_else(|| format!("boundary {index}"))
    };
    let boundary = |body: &bodies::Body| BoundaryHeader {
        index: body.index,
        name: name(body.index),
        centre: body.centre.into(),
        points: body.arms.len(),
        triangles: body.triangles.len(),
        felt: survey.walls.boundaries.contains(&body.index),
    };
    let table = |table: &Table| TableHeader {
        name: table.name.clone(),
        rows: table.time.len(),
        thinned: table.thinned,
        columns: table
            .columns
            .iter()
            .map(|c| [c.name.clone(), c.unit.clone()])
            .collect(),
    };
    let corners = bodies.list.iter().flat_map(|body| {
        let centre = body.centre;
        body.arms
            .iter()
            .map(move |arm| (centre + arm, centre + arm))
    });
    let joined = |(l, h): (Vec3, Vec3), (m, n): (Vec3, Vec3)| (l.inf(&m), h.sup(&n));
    let extent = corners.chain(survey.start).reduce(joined);
    let (low, high) = extent.unwrap_or((Vec3::repeat(-0.5), Vec3::repeat(0.5)));
    let (bottom, top) = survey.reach.unwrap_or((low, high));
    Header {
        version: 2,
        generator: format!("sphere-dda {}", env!("CARGO_PKG_VERSION")),
        title: options.title.clone(),
        thinned: taken.thinned,
        recorded: times.len(),
        times: taken.frames.iter().map(|&k| times[k]).collect(),
        frames_per_block: blocks::length(survey.slots.len()),
        spheres: survey.slots.len(),
        materials: options.materials.clone(),
        origin: grating.origin.into(),
        step: grating.step,
        extent: [low.into(), high.into()],
        height: [bottom.z.max(low.z), top.z.min(high.z)],
        fields: fields
            .map(|(kept, field)| FieldHeader {
                name: field.name.clone(),
                unit: field.unit.clone(),
                components: kept.components,
                magnitude: kept.magnitude,
                scale: kept.scale,
                steps: kept.steps,
                top: field.top(),
            })
            .collect(),
        forces: ForceHeader {
            largest: survey.largest_force,
            top: survey.top_force(),
            decades: DECADES,
            levels: taken.detail.force_levels(),
        },
        boundaries: bodies.list.iter().map(boundary).collect(),
        walls: survey.walls.fields.iter().map(WallHeader::of).collect(),
        tables: options.tables.iter().map(table).collect(),
        labels: options.labels.clone(),
        still: matches!(recording, Recording::Still(_)),
        notice: options.notice.clone(),
        watched: options.watched.clone(),
        live: options.live.as_ref().map(|live| live.about.clone()),
    }
}
