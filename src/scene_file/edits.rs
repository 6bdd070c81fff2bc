//! Values written into a parsed scene before it is decoded: those of parameters, and numbers for quantities with a unit.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::document::Step;

/// A value and its place.
pub(super) struct Edit {
    /// The way to the key.
    pub(super) steps: Vec<Step>,
    /// The value as TOML.
    pub(super) literal: String,
}

/// The document with all edits.
pub(super) fn written<'s>(
    mut root: Spanned<DeValue<'s>>,
    edits: &'s [Edit],
) -> Spanned<DeValue<'s>> {
    for edit in edits {
        write(&mut root, &edit.steps, &edit.literal);
    }
    root
}

/// Writes a value at `steps`; tables that are missing are made, entries of lists are there. What it replaces keeps its place in
/// the text.
fn write<'s>(place: &mut Spanned<DeValue<'s>>, steps: &[Step], literal: &'s str) {
    let Some((step, rest)) = steps.split_first() else {
        if let Ok(value) = DeValue::parse(literal) {
            *place.get_mut() = value.into_inner();
        }
        return;
    };
    let span = place.span();
    let next = match (place.get_mut(), step) {
        (DeValue::Table(table), Step::Key(key)) => Some(
            table
                .entry(Spanned::new(span.clone(), key.clone().into()))
                .or_insert_with(|| Spanned::new(span, DeValue::Table(DeTable::new()))),
        ),
        (DeValue::Array(array), Step::Index(index)) => array.get_mut(*index),
        _ => None,
    };
    if let Some(next) = next {
        write(next, rest, literal);
    }
}
