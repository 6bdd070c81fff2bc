//! An instance of FMI 3.0 in a simulation: elements of arrays by their places, though calls know whole arrays only.

use std::collections::{BTreeMap, BTreeSet};

use sphere_dda_model_description::fmi2::Variability;
use sphere_dda_model_description::fmi3::Causality;

use super::abi::Functions;
use super::events;
use crate::calls::instance::Instance;
use crate::calls::participant::{InputValues, Participant, Step};
use crate::calls::state::{Agenda, SavedState};
use crate::calls::watch::Message;
use crate::error::ImportError;
use crate::open::Description;
use crate::status::Phase;
use crate::value::{ScalarType, Value};
use crate::variable::{Place, Variable};

/// An instance with what its arrays were last set to, since a single element cannot be set.
pub(crate) struct Arrays {
    instance: Instance<Functions>,
    /// By value reference: number of elements, and their values as far as they are known.
    variables: BTreeMap<u32, (usize, Vec<Value>)>,
    experiment: (Option<f64>, f64, f64),
    /// Events are handled here; `None` leaves them to the FMU.
    agenda: Option<Agenda>,
    /// Communication steps may have any length.
    any_step: bool,
    /// Inputs whose changes are events.
    discrete: BTreeSet<u32>,
}

impl Arrays {
    pub(crate) fn new(
        instance: Instance<Functions>,
        description: &Description,
        variables: &[Variable],
    ) -> Self {
        let entry = |own: &Variable| {
            // Values are kept of what can be set; outputs may be large.
            let values = if own.causality == Causality::Output {
                Vec::new()
            } else {
                own.start.clone()
            };
            (own.reference, (own.elements(), values))
        };
        Self {
            instance,
            variables: variables.iter().map(entry).collect(),
            experiment: (None, 0.0, 0.0),
            agenda: description.has_event_mode().then(Agenda::default),
            any_step: description.takes_any_step(),
            discrete: variables
                .iter()
                .filter(|own| {
                    own.causality == Causality::Input && own.variability == Variability::Discrete
                })
                .map(|own| own.reference)
                .collect(),
        }
    }

    fn elements(&self, reference: u32) -> usize {
        self.variables
            .get(&reference)
            .map_or(1, |(count, _)| *count)
    }
}

impl Arrays {
    /// Whether a value is one that a discrete input does not have yet.
    fn is_event(&self) -> impl Fn(&(Place, Value)) -> bool {
        move |(place, value)| {
            let known = self.variables.get(&place.reference);
            let known = known.and_then(|(_, own)| own.get(place.element));
            self.agenda.is_some()
                && self.discrete.contains(&place.reference)
                && known != Some(value)
        }
    }

    fn assign(&mut self, values: &InputValues) -> Result<(), ImportError> {
        let mut changed: BTreeMap<ScalarType, Vec<u32>> = BTreeMap::new();
        for (place, _) in values {
            let references = changed.entry(place.scalar).or_default();
            if !references.contains(&place.reference) {
                references.push(place.reference);
            }
        }
        // What the description gives no start for is read before a part of it is replaced.
        for (&scalar, references) in &changed {
            for &reference in references {
                let count = self.elements(reference);
                let known = self
                    .variables
                    .get(&reference)
                    .map_or(0, |(_, own)| own.len());
                let given = values
                    .iter()
                    .filter(|(place, _)| place.reference == reference);
                let own = if known == count {
                    continue;
                } else if given.count() == count {
                    vec![Value::Boolean(false); count]
                } else {
                    self.instance.get_values(scalar, &[reference], count)?
                };
                self.variables.insert(reference, (count, own));
            }
        }
        for (place, value) in values {
            if let Some((_, own)) = self.variables.get_mut(&place.reference)
                && let Some(slot) = own.get_mut(place.element)
            {
                *slot = value.clone();
            }
        }
        for (scalar, references) in changed {
            let own = |reference: &u32| self.variables.get(reference).map(|(_, own)| own.clone());
            let all: Vec<Value> = references.iter().filter_map(own).flatten().collect();
            self.instance.set_values(scalar, &references, &all)?;
        }
        Ok(())
    }
}

impl Participant for Arrays {
    fn set_up(
        &mut self,
        tolerance: Option<f64>,
        start: f64,
        stop: f64,
        values: &InputValues,
    ) -> Result<(), ImportError> {
        self.experiment = (tolerance, start, stop);
        self.set(values)
    }

    fn enter_initialization(&mut self) -> Result<(), ImportError> {
        let (tolerance, start, stop) = self.experiment;
        self.instance
            .enter_initialization_mode(tolerance, start, stop)
    }

    fn exit_initialization(&mut self) -> Result<(), ImportError> {
        let events = self.agenda.is_some();
        self.instance.exit_initialization_mode(events)?;
        match &mut self.agenda {
            Some(agenda) => events::handle(&mut self.instance, agenda),
            None => Ok(()),
        }
    }

    fn get(&mut self, places: &[Place]) -> Result<Vec<Value>, ImportError> {
        // Each variable once, of one type after another, and where its values begin.
        let mut wanted: BTreeMap<ScalarType, BTreeMap<u32, usize>> = BTreeMap::new();
        for place in places {
            let own = wanted.entry(place.scalar).or_default();
            own.insert(place.reference, 0);
        }
        let mut found: BTreeMap<ScalarType, Vec<Value>> = BTreeMap::new();
        for (&scalar, variables) in &mut wanted {
            let mut count = 0;
            for (&reference, begin) in variables.iter_mut() {
                *begin = count;
                count += self.elements(reference);
            }
            let references: Vec<u32> = variables.keys().copied().collect();
            found.insert(
                scalar,
                self.instance.get_values(scalar, &references, count)?,
            );
        }
        let value = |place: &Place| {
            let begin = wanted.get(&place.scalar)?.get(&place.reference)?;
            found
                .get(&place.scalar)?
                .get(begin + place.element)
                .cloned()
        };
        Ok(places.iter().filter_map(value).collect())
    }

    fn set(&mut self, values: &InputValues) -> Result<(), ImportError> {
        let event = self.instance.phase() == Phase::Stepping && values.iter().any(self.is_event());
        if event {
            self.instance.enter_event_mode()?;
        }
        self.assign(values)?;
        match &mut self.agenda {
            Some(agenda) if event => events::handle(&mut self.instance, agenda),
            _ => Ok(()),
        }
    }

    fn step(&mut self, time: f64, step: f64, no_rollback: bool) -> Result<Step, ImportError> {
        if let Some(agenda) = &mut self.agenda {
            let span = (time, step);
            return events::step(&mut self.instance, agenda, self.any_step, span, no_rollback);
        }
        let returned = self.instance.do_step(time, step, no_rollback)?;
        // A step that ends early, unasked for, counts as one done in part.
        if !(returned.discarded || returned.early || returned.terminated) {
            return Ok(Step::Done);
        }
        Ok(Step::Discarded {
            last_successful_time: returned.last_successful_time,
            terminated: returned.terminated,
        })
    }

    fn save(&mut self) -> Result<SavedState, ImportError> {
        let mut state = self.instance.save_state()?;
        if let Some(agenda) = self.agenda {
            let inputs = self.discrete.iter();
            state.agenda = agenda;
            state.inputs = inputs
                .filter_map(|&reference| {
                    Some((reference, self.variables.get(&reference)?.1.clone()))
                })
                .collect();
        }
        Ok(state)
    }

    fn restore(&mut self, state: &SavedState) -> Result<(), ImportError> {
        if let Some(agenda) = &mut self.agenda {
            *agenda = state.agenda;
            for (reference, values) in &state.inputs {
                if let Some((_, own)) = self.variables.get_mut(reference) {
                    own.clone_from(values);
                }
            }
        }
        self.instance.restore_state(state)
    }

    fn free(&mut self, state: SavedState) -> Result<(), ImportError> {
        self.instance.free_state(state)
    }

    fn finish(&mut self) -> Result<(), ImportError> {
        self.instance.terminate()
    }

    fn messages(&self) -> (Vec<Message>, usize) {
        self.instance.take_messages()
    }
}
