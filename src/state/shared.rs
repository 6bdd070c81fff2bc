//! A state that several hold until one of them changes it.

use std::mem::replace;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::State;

/// A state that is copied when it is changed while others hold it: to keep one costs nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedState(Arc<State>);

impl SharedState {
    pub(crate) fn new(state: State) -> Self {
        Self(Arc::new(state))
    }

    /// Gives the present state away and goes on with a copy: in the memory of `spare`, if nobody else holds that.
    pub(crate) fn fork(&mut self, spare: Option<Self>) -> Self {
        let memory = spare.and_then(|mut spare| {
            Arc::get_mut(&mut spare.0)?.clone_from(&self.0);
            Some(spare.0)
        });
        let copy = memory.unwrap_or_else(|| Arc::new((*self.0).clone()));
        Self(replace(&mut self.0, copy))
    }
}

impl Deref for SharedState {
    type Target = State;

    fn deref(&self) -> &State {
        &self.0
    }
}

impl DerefMut for SharedState {
    fn deref_mut(&mut self) -> &mut State {
        Arc::make_mut(&mut self.0)
    }
}

impl Serialize for SharedState {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for SharedState {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        State::deserialize(deserializer).map(Self::new)
    }
}
