//! How much of the spheres' fields a page holds: what must be small is told more coarsely before frames are left out.

use super::survey::Survey;

/// What is kept of the fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Detail {
    /// All but orientations, each component to 0.5 %.
    Whole,
    /// Velocity and force, each component to 2 %.
    Coarse,
    /// Their magnitudes, to 2 %.
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
}

impl Detail {
    /// The next coarser one.
    pub(super) fn coarser(self) -> Option<Self> {
        match self {
            Self::Whole => Some(Self::Coarse),
            Self::Coarse => Some(Self::Magnitudes),
            Self::Magnitudes => None,
        }
    }

    /// The fields of a recording that are kept.
    pub(super) fn kept(self, survey: &Survey) -> Vec<Kept> {
        let wanted = |name: &str| match self {
            Self::Whole => !LEFT_OUT.contains(&name),
            _ => TELLING.contains(&name),
        };
        let fields = survey.fields.iter().enumerate();
        let fields = fields.filter(|(_, field)| wanted(&field.name));
        let kept = |(index, field): (usize, &super::survey::FieldRange)| {
            let magnitude = self == Self::Magnitudes;
            Kept {
                field: index,
                magnitude,
                components: if magnitude { 1 } else { field.components },
                steps: if self == Self::Whole { 100.0 } else { 25.0 },
            }
        };
        fields.map(kept).collect()
    }
}
