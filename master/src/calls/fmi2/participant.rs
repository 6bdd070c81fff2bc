//! An instance of FMI 2.0 in a simulation.

use super::abi::Functions;
use crate::calls::instance::Instance;
use crate::calls::participant::{InputValues, Participant, Step};
use crate::calls::state::SavedState;
use crate::calls::watch::Message;
use crate::error::ImportError;
use crate::value::{ScalarType, Value};
use crate::variable::Place;

impl Participant for Instance<Functions> {
    fn set_up(
        &mut self,
        tolerance: Option<f64>,
        start: f64,
        stop: f64,
        values: &InputValues,
    ) -> Result<(), ImportError> {
        self.setup_experiment(tolerance, start, Some(stop))?;
        self.set(values)
    }

    fn enter_initialization(&mut self) -> Result<(), ImportError> {
        self.enter_initialization_mode()
    }

    fn exit_initialization(&mut self) -> Result<(), ImportError> {
        self.exit_initialization_mode()
    }

    fn get(&mut self, places: &[Place]) -> Result<Vec<Value>, ImportError> {
        let mut found: Vec<Option<Value>> = vec![None; places.len()];
        for scalar in [
            ScalarType::Float64,
            ScalarType::Int32,
            ScalarType::Boolean,
            ScalarType::String,
        ] {
            let own = places
                .iter()
                .enumerate()
                .filter(|(_, p)| p.scalar == scalar);
            let (slots, references): (Vec<usize>, Vec<u32>) =
                own.map(|(slot, place)| (slot, place.reference)).unzip();
            let values: Vec<Value> = match scalar {
                ScalarType::Float64 => all(self.get_real(&references)?, Value::Real),
                ScalarType::Int32 => {
                    all(self.get_integer(&references)?, |n| Value::Integer(n.into()))
                }
                ScalarType::Boolean => all(self.get_boolean(&references)?, Value::Boolean),
                _ => all(self.get_string(&references)?, Value::String),
            };
            for (slot, value) in slots.into_iter().zip(values) {
                if let Some(place) = found.get_mut(slot) {
                    *place = Some(value);
                }
            }
        }
        Ok(found.into_iter().flatten().collect())
    }

    fn set(&mut self, values: &InputValues) -> Result<(), ImportError> {
        let (mut real, mut integer, mut boolean, mut string) =
            (Lists::new(), Lists::new(), Lists::new(), Lists::new());
        for (place, value) in values {
            let reference = place.reference;
            match value {
                Value::Real(value) => real.push(reference, *value),
                Value::Integer(value) => {
                    let fitting = i32::try_from(*value);
                    let fitting = fitting.map_err(|_| ImportError::Range {
                        function: "fmi2SetInteger",
                        found: value.to_string(),
                        expected: "32 bits".to_owned(),
                    })?;
                    integer.push(reference, fitting);
                }
                Value::Boolean(value) => boolean.push(reference, *value),
                Value::String(value) => string.push(reference, &**value),
                // No variable of FMI 2.0 is binary, and connections join equal types only.
                Value::Binary(_) => {}
            }
        }
        self.set_real(&real.references, &real.values)?;
        self.set_integer(&integer.references, &integer.values)?;
        self.set_boolean(&boolean.references, &boolean.values)?;
        self.set_string(&string.references, &string.values)
    }

    fn step(&mut self, time: f64, step: f64, no_rollback: bool) -> Result<Step, ImportError> {
        self.do_step(time, step, no_rollback)
    }

    fn save(&mut self) -> Result<SavedState, ImportError> {
        self.save_state()
    }

    fn restore(&mut self, state: &SavedState) -> Result<(), ImportError> {
        self.restore_state(state)
    }

    fn free(&mut self, state: SavedState) -> Result<(), ImportError> {
        self.free_state(state)
    }

    fn finish(&mut self) -> Result<(), ImportError> {
        self.terminate()
    }

    fn messages(&self) -> (Vec<Message>, usize) {
        self.take_messages()
    }
}

fn all<T>(values: Vec<T>, value: impl Fn(T) -> Value) -> Vec<Value> {
    values.into_iter().map(value).collect()
}

/// References and values side by side, as the interface wants them.
struct Lists<T> {
    references: Vec<u32>,
    values: Vec<T>,
}

impl<T> Lists<T> {
    fn new() -> Self {
        Self {
            references: Vec::new(),
            values: Vec::new(),
        }
    }

    fn push(&mut self, reference: u32, value: T) {
        self.references.push(reference);
        self.values.push(value);
    }
}
