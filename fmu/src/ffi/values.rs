//! Getting and setting values, whichever version calls.

use std::ffi::c_char;

use sphere_dda_fmi_interface::abi2::fmi2Component;
use sphere_dda_fmi_interface::pointers::{Lent, c_string};
use sphere_dda_model_description::value::{ScalarType, Value};

use super::guard::{Stages, Status, lend};
use crate::runtime::instance::Call;
use crate::runtime::refusal::Refusal;
use crate::version::Version;

/// An exported function on its way: instance, name, states in which it is allowed, type of its values.
pub(super) struct Function {
    pub(super) component: fmi2Component,
    pub(super) name: &'static str,
    pub(super) allowed: Stages,
    pub(super) version: Version,
    pub(super) scalar: ScalarType,
}

/// Value references, and how many.
pub(super) type References = (*const u32, usize);

impl Function {
    fn call(&self) -> Call {
        let (version, scalar) = (self.version, self.scalar);
        Call { version, scalar }
    }

    /// Names of the arguments with references and values.
    fn arguments(&self) -> (&'static str, &'static str) {
        match self.version {
            Version::Two => ("vr", "value"),
            Version::Three => ("valueReferences", "values"),
        }
    }

    /// Reads `count` values; `convert` takes them out of their envelope.
    pub(super) fn get<S: Status, T: Copy>(
        &self,
        references: References,
        (values, count): (*mut T, usize),
        convert: impl Fn(Value) -> Option<T>,
    ) -> S {
        lend(
            self.component,
            self.name,
            self.allowed,
            |component, lent| {
                let (of, to) = self.arguments();
                let references = lent.array(references.0, references.1, of)?;
                let mut places = lent.places(values, count, to)?.iter_mut();
                let mut give = |value| {
                    if let (Some(place), Some(value)) = (places.next(), convert(value)) {
                        place.write(value);
                    }
                };
                component
                    .instance
                    .get(self.call(), references, count, &mut give)?;
                Ok(S::OK)
            },
        )
    }

    /// Reads texts; they live until the next call of this function for the instance.
    pub(super) fn get_texts<S: Status>(
        &self,
        references: References,
        (values, count): (*mut *const c_char, usize),
    ) -> S {
        lend(
            self.component,
            self.name,
            self.allowed,
            |component, lent| {
                let (of, to) = self.arguments();
                let references = lent.array(references.0, references.1, of)?;
                let mut texts = Vec::new();
                let mut give = |value| {
                    if let Value::String(text) = value {
                        texts.push(c_string(&text));
                    }
                };
                component
                    .instance
                    .get(self.call(), references, count, &mut give)?;
                let places = lent.places(values, count, to)?;
                component.strings = texts;
                for (place, text) in places.iter_mut().zip(&component.strings) {
                    place.write(text.as_ptr());
                }
                Ok(S::OK)
            },
        )
    }

    /// Sets `count` values; `convert` puts them into an envelope.
    pub(super) fn set<S: Status, T: Copy>(
        &self,
        references: References,
        values: (*const T, usize),
        convert: impl Fn(T) -> Result<Value, Refusal>,
    ) -> S {
        self.set_lent(references, values, |value, _| convert(value))
    }

    /// As [`Self::set`]; values may be pointers.
    fn set_lent<S: Status, T: Copy>(
        &self,
        references: References,
        (values, count): (*const T, usize),
        convert: impl Fn(T, Lent<'_>) -> Result<Value, Refusal>,
    ) -> S {
        lend(
            self.component,
            self.name,
            self.allowed,
            |component, lent| {
                let (of, to) = self.arguments();
                let references = lent.array(references.0, references.1, of)?;
                let values = lent.array(values, count, to)?.iter();
                let values: Result<_, Refusal> =
                    values.map(|&value| convert(value, lent)).collect();
                component.instance.set(self.call(), references, values?)?;
                Ok(S::OK)
            },
        )
    }

    /// Sets texts.
    pub(super) fn set_texts<S: Status>(
        &self,
        references: References,
        values: (*const *const c_char, usize),
    ) -> S {
        let name = self.arguments().1;
        self.set_lent(references, values, |text, lent| {
            Ok(Value::String(lent.text(text, name)?.to_owned()))
        })
    }
}
