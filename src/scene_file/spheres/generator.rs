//! What places the spheres or clumps of a group.

use rand_chacha::ChaCha8Rng;

use super::initial_motion::InitialMotion;
use super::{files, lattice};
use crate::scene_file::document::Document;
use crate::scene_file::file;

/// What places the spheres of a group.
pub(super) enum Generator<'a> {
    Lattice(&'a file::Lattice),
    Packing(&'a file::Packing),
    Positions(&'a [file::Vector]),
    Csv(&'a str),
    Vtu(&'a str),
    Checkpoint(&'a str),
}

impl<'a> Generator<'a> {
    /// The one key that places a group.
    pub(super) fn of(
        document: &mut Document<'_>,
        path: &str,
        group: &'a file::Spheres,
    ) -> Option<Self> {
        let given: Vec<Self> = [
            group.lattice.as_ref().map(Self::Lattice),
            group.packing.as_ref().map(Self::Packing),
            group.positions.as_deref().map(Self::Positions),
            group.csv.as_deref().map(Self::Csv),
            group.vtu.as_deref().map(Self::Vtu),
            group.checkpoint.as_deref().map(Self::Checkpoint),
        ]
        .into_iter()
        .flatten()
        .collect();
        let number = given.len();
        let only = given.into_iter().next().filter(|_| number == 1);
        if only.is_none() {
            let message = format!(
                "found {number} of lattice, packing, positions, csv, vtu, checkpoint, expected one"
            );
            let help = "give the group exactly one of lattice = { ... }, packing = { ... }, \
                        positions = [[x, y, z], ...], csv = \"file\", vtu = \"file\", checkpoint = \"file\"";
            document.error(path, message, help);
        }
        only
    }

    /// The places, and the radii where a file has them.
    pub(super) fn read(
        &self,
        document: &mut Document<'_>,
        path: &str,
        random: &mut ChaCha8Rng,
    ) -> Option<(Vec<InitialMotion>, Option<Vec<f64>>)> {
        let content = |document: &mut Document<'_>, key: &str, name: &str| {
            let content = document.read(&format!("{path}.{key}"), name);
            content.map(<[u8]>::to_owned)
        };
        match *self {
            Self::Lattice(lattice) => {
                let starts = lattice::fill(document, &format!("{path}.lattice"), lattice, random);
                Some((starts?, None))
            }
            Self::Positions(list) => {
                let starts = list.iter().map(|&p| InitialMotion::at(p.into())).collect();
                let key = format!("{path}.positions");
                let some = !list.is_empty();
                document
                    .demand(some, key, "an empty list", "at least one [x, y, z]")
                    .then_some((starts, None))
            }
            Self::Csv(name) => {
                let bytes = content(document, "csv", name)?;
                files::csv(document, &format!("{path}.csv"), name, &bytes)
            }
            Self::Vtu(name) => {
                let bytes = content(document, "vtu", name)?;
                files::vtu(document, &format!("{path}.vtu"), name, &bytes)
            }
            Self::Checkpoint(name) => {
                let bytes = content(document, "checkpoint", name)?;
                files::checkpoint(document, &format!("{path}.checkpoint"), name, &bytes)
            }
            // A packing is made of its radii, not read.
            Self::Packing(_) => None,
        }
    }
}
