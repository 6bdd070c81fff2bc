//! Texts like `"8 mm"` where a scene takes numbers in a unit.

use toml::Spanned;
use toml::de::DeValue;

use super::document::Step;
use super::edits::Edit;
use super::schema::plain_schema;
use super::units;
use super::wording::Place;

/// The numbers for all quantities with a unit that fits their key; others stay as they are, and are refused where they are read.
pub(super) fn quantities(root: &Spanned<DeValue<'_>>) -> Vec<Edit> {
    let schema = plain_schema();
    let mut edits = Vec::new();
    collect(root, Place::top(&schema), &mut Vec::new(), &mut edits);
    edits
}

fn collect(
    value: &Spanned<DeValue<'_>>,
    place: Place<'_>,
    steps: &mut Vec<Step>,
    edits: &mut Vec<Edit>,
) {
    let mut below = |next: &Spanned<DeValue<'_>>, step: Step| {
        if let Some(place) = place.below(&step) {
            steps.push(step);
            collect(next, place, steps, edits);
            steps.pop();
        }
    };
    match value.get_ref() {
        DeValue::String(text) => {
            let number = place.quantity().and_then(|unit| units::number(text, unit));
            if let Some(literal) = number {
                let steps = steps.clone();
                edits.push(Edit { steps, literal });
            }
        }
        DeValue::Array(list) => {
            for (k, next) in list.iter().enumerate() {
                below(next, Step::Index(k));
            }
        }
        DeValue::Table(table) => {
            for (key, next) in table {
                below(next, Step::Key(key.get_ref().to_string()));
            }
        }
        _ => {}
    }
}
