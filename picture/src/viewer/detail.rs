//! How much of the spheres' fields a page holds: what must be small is told more coarsely before anything is left out.
//!
//! | | error of a component `v` at most | fields |
//! |---|---|---|
//! | `Whole` | 0.5 % of it, 5e-7 of the largest in the run | all but orientations |
//! | `Fine` | 2 % of it, 1/1000 of where the colours end | the same |
//! | `Colours` | 6 % of it, 1/128 of where the colours end | the same |
//! | `Sizes` | likewise | velocity and force, of the others their magnitudes |
//! | `Telling` | likewise | velocity and force |
//! | `Magnitudes` | likewise | their magnitudes |

use super::coding::{RANGE, coding};
use super::survey::{FieldRange, Survey};

/// What is kept of the fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Detail {
    /// All but orientations, each component to 0.5 %, contact forces to 2.3 %.
    Whole,
    /// Likewise, to 2 %.
    Fine,
    /// Likewise, to 6 %, as finely as colours show; contact forces to 10 %.
    Colours,
    /// Likewise, but of fields other than velocity and force their magnitudes.
    Sizes,
    /// Velocity and force alone.
    Telling,
    /// Their magnitudes.
    Magnitudes,
}

/// Arrays over spheres that no page holds: what cannot be shown as a number.
const LEFT_OUT: [&str; 1] = ["orientation"];
/// Arrays that say most.
const TELLING: [&str; 2] = ["velocity", "force"];

/// A field as it is kept.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kept {
    /// Index in the survey.
    pub(super) field: usize,
    /// Whether only the magnitude of its components is.
    pub(super) magnitude: bool,
    /// Numbers per sphere.
    pub(super) components: usize,
    /// Steps `K` of its coding.
    pub(super) steps: f64,
    /// Its `s`: below it steps are of one size.
    pub(super) scale: f64,
}

impl Detail {
    /// The next coarser one.
    pub(super) fn coarser(self) -> Option<Self> {
        match self {
            Self::Whole => Some(Self::Fine),
            Self::Fine => Some(Self::Colours),
            Self::Colours => Some(Self::Sizes),
            Self::Sizes => Some(Self::Telling),
            Self::Telling => Some(Self::Magnitudes),
            Self::Magnitudes => None,
        }
    }

    /// Codes of contact forces.
    pub(super) fn force_levels(self) -> u8 {
        match self {
            Self::Whole | Self::Fine => 255,
            _ => 63,
        }
    }

    /// The fields of a recording that are kept.
    pub(super) fn kept(self, survey: &Survey) -> Vec<Kept> {
        let wanted = |name: &str| match self {
            Self::Telling | Self::Magnitudes => TELLING.contains(&name),
            _ => !LEFT_OUT.contains(&name),
        };
        let fields = survey.fields.iter().enumerate();
        let fields = fields.filter(|(_, field)| wanted(&field.name));
        let kept = |(index, field): (usize, &FieldRange)| {
            let magnitude = match self {
                Self::Magnitudes => true,
                Self::Sizes => field.components > 1 && !TELLING.contains(&&*field.name),
                _ => false,
            };
            let (steps, scale) = self.coding(field);
            Kept {
                field: index,
                magnitude,
                components: if magnitude { 1 } else { field.components },
                steps,
                scale,
            }
        };
        fields.map(kept).collect()
    }

    /// `K` and `s` of a field; near zero a step is `s/K`.
    fn coding(self, field: &FieldRange) -> (f64, f64) {
        let (steps, shades) = match self {
            Self::Whole => return coding(field.largest),
            Self::Fine => (25.0, 512.0),
            _ => (8.0, 64.0),
        };
        let top = field.top();
        match top > 0.0 {
            true => (steps, steps * top / shades),
            // Nearly all is zero: there is no colour to go by.
            false => (steps, field.largest / RANGE),
        }
    }
}
