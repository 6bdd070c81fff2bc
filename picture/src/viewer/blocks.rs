//! Blocks of frames: the first told by itself, the others by their changes, each part deflated on its own, so that a
//! page unpacks what it shows.
//!
//! ```text
//! motion    presence, then jumps, of each frame; three streams of positions
//! field k   a stream for each component
//! stream    1 byte: what numbers are told against; their code (see coding)
//! presence  1 byte for each frame: 0 as before, 1 all, 2 as a bit for each sphere follows
//! jumps     1 byte for each frame: 0 none, 2 a bit for each sphere: there is no way from the frame before to this one
//! contacts  see contacts
//! wall k    see walls
//! ```

use rayon::prelude::*;
use sphere_dda::Vec3;

use super::coding::{LARGEST, compressed, deflated, put_bits, put_stream};
use super::contacts::Contacts;
use super::detail::{Detail, Kept};
use super::error::ViewError;
use super::page::Parts;
use super::recording::Moment;
use super::survey::Survey;
use super::walls::WallBlock;

/// Position step `q` over the smallest radius: the error of a centre is at most 0.87 of this.
const STEP: f64 = 1e-3;
/// Most frames of a block, and most values of a stream that should be unpacked for one picture.
const FRAMES: usize = 24;
const VALUES: usize = 1_500_000;

/// How positions are coded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Grating {
    /// Position of code zero \[m\].
    pub(super) origin: Vec3,
    /// Step `q` \[m\].
    pub(super) step: f64,
}

impl Grating {
    pub(super) fn of(survey: &Survey) -> Self {
        let (low, high) = survey.reach.unwrap_or_default();
        let radius = survey.smallest_radius().unwrap_or(1.0);
        // A sphere lost in space must not cost the others their places, but it may leave what can be counted.
        let step = (STEP * radius).max((high - low).max() / LARGEST);
        Self { origin: low, step }
    }

    pub(super) fn code(&self, x: Vec3) -> [i64; 3] {
        ((x - self.origin) / self.step)
            .map(|n| n.round() as i64)
            .into()
    }
}

/// Frames of a block for so many spheres.
pub(super) fn length(spheres: usize) -> usize {
    (VALUES / spheres.max(1)).clamp(1, FRAMES)
}

/// A block that is being filled.
pub(super) struct Block<'a> {
    survey: &'a Survey,
    grating: Grating,
    fields: &'a [Kept],
    present: Vec<Vec<bool>>,
    jumps: Vec<Vec<bool>>,
    /// By axis, frame, slot.
    positions: [Vec<Vec<i64>>; 3],
    /// By field and component, frame, slot.
    values: Vec<Vec<Vec<i64>>>,
    contacts: Contacts<'a>,
    walls: WallBlock<'a>,
}

/// The parts of a block, ready for the page.
pub(super) struct Packed {
    pub(super) motion: Vec<u8>,
    pub(super) fields: Vec<Vec<u8>>,
    pub(super) contacts: Vec<u8>,
    pub(super) walls: Vec<Vec<u8>>,
}

impl Packed {
    /// The parts of the block of this number.
    pub(super) fn parts(self, number: usize) -> Parts {
        let mut parts = Parts::default();
        parts.push(format!("motion-{number}"), self.motion);
        parts.push(format!("contacts-{number}"), self.contacts);
        for (k, bytes) in self.fields.into_iter().enumerate() {
            parts.push(format!("field{k}-{number}"), bytes);
        }
        for (k, bytes) in self.walls.into_iter().enumerate() {
            parts.push(format!("wall{k}-{number}"), bytes);
        }
        parts
    }
}

/// Images of the spheres in the frame before, by slot.
pub(super) type Images = Vec<Option<[f64; 3]>>;

impl<'a> Block<'a> {
    pub(super) fn new(
        survey: &'a Survey,
        grating: Grating,
        detail: Detail,
        fields: &'a [Kept],
    ) -> Self {
        let components = fields.iter().map(|kept| kept.components);
        Self {
            survey,
            grating,
            fields,
            present: Vec::new(),
            jumps: Vec::new(),
            positions: Default::default(),
            values: vec![Vec::new(); components.sum()],
            contacts: Contacts::new(survey, detail.force_levels()),
            walls: WallBlock::new(&survey.walls),
        }
    }

    pub(super) fn frames(&self) -> usize {
        self.present.len()
    }

    /// Adds a frame; `images` are those of the frame before and become those of this one.
    pub(super) fn push(&mut self, moment: &Moment, images: &mut Images) -> Result<(), ViewError> {
        let slots = self.survey.slots.len();
        let spheres = &moment.spheres;
        let unknown = |what: &str| ViewError::Frame {
            time: moment.time,
            what: what.to_owned(),
            found: "another".to_owned(),
            expected: "what it was when the frame was first read: wait for the end of the run"
                .to_owned(),
        };
        let ranks: Option<Vec<usize>> = spheres.id.iter().map(|&id| self.survey.rank(id)).collect();
        let ranks = ranks.ok_or_else(|| unknown("a sphere"))?;
        let (mut present, mut jumps) = (vec![false; slots], vec![false; slots]);
        let mut codes = [vec![0; slots], vec![0; slots], vec![0; slots]];
        for (k, &slot) in ranks.iter().enumerate() {
            present[slot] = true;
            for (codes, code) in codes.iter_mut().zip(self.grating.code(spheres.position[k])) {
                codes[slot] = code;
            }
            if let Some(list) = &spheres.image {
                let before = images[slot].replace(list[k]);
                jumps[slot] = before.is_some_and(|before| before != list[k]);
            }
        }
        for (all, codes) in self.positions.iter_mut().zip(codes) {
            all.push(codes);
        }
        let mut stream = 0;
        for kept in self.fields {
            let range = &self.survey.fields[kept.field];
            let field = spheres.fields.iter().find(|field| field.name == range.name);
            let field = field.ok_or_else(|| unknown(&format!("array `{}`", range.name)))?;
            for component in 0..kept.components {
                let mut codes = vec![0; slots];
                for (row, &slot) in field.values.chunks_exact(range.components).zip(&ranks) {
                    let value = match kept.magnitude {
                        true => row.iter().map(|v| v * v).sum::<f64>().sqrt(),
                        false => row[component],
                    };
                    codes[slot] = compressed(value, kept.scale, kept.steps);
                }
                self.values[stream].push(codes);
                stream += 1;
            }
        }
        self.contacts.push(moment, &ranks);
        self.walls.push(moment)?;
        self.present.push(present);
        self.jumps.push(jumps);
        Ok(())
    }

    pub(super) fn pack(self) -> Packed {
        let mut motion = Vec::new();
        let mut before: Option<&Vec<bool>> = None;
        for here in &self.present {
            match before {
                Some(before) if before == here => motion.push(0),
                _ if here.iter().all(|&is| is) => motion.push(1),
                _ => {
                    motion.push(2);
                    put_bits(&mut motion, here.iter().copied());
                }
            }
            before = Some(here);
        }
        for jumps in &self.jumps {
            if jumps.iter().any(|&is| is) {
                motion.push(2);
                put_bits(&mut motion, jumps.iter().copied());
            } else {
                motion.push(0);
            }
        }
        let streams: Vec<_> = self.positions.iter().chain(&self.values).collect();
        let told = streams.into_par_iter().map(|stream| {
            let mut bytes = Vec::new();
            put_stream(&mut bytes, stream, &self.present);
            bytes
        });
        let told: Vec<Vec<u8>> = told.collect();
        let (axes, mut told) = told.split_at(self.positions.len());
        motion.extend(axes.iter().flatten());
        let fields = self.fields.iter().map(|kept| {
            let (own, rest) = told.split_at(kept.components);
            told = rest;
            deflated(&own.concat())
        });
        Packed {
            fields: fields.collect(),
            motion: deflated(&motion),
            contacts: deflated(&self.contacts.pack()),
            walls: self.walls.pack(),
        }
    }
}
