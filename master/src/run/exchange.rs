//! Carries values from outputs to inputs.

use crate::calls::{InputValues, Participant};
use crate::system::System;
use crate::value::{Value, ValueType};
use crate::variable::Place;

use super::halt::Halt;

/// The instances of a system.
pub(super) type Instances = [Box<dyn Participant>];

/// Connections from one component to another: read together.
#[derive(Debug)]
struct Channel {
    source: usize,
    target: usize,
    outputs: Vec<Place>,
    inputs: Vec<Place>,
    /// Names of the outputs.
    names: Vec<String>,
}

/// All connections of a system.
#[derive(Debug)]
pub(super) struct Exchange {
    channels: Vec<Channel>,
    allow_nan: bool,
}

impl Exchange {
    pub(super) fn new(system: &System<'_>, allow_nan: bool) -> Self {
        let mut channels: Vec<Channel> = Vec::new();
        for connection in system.connections() {
            let (source, target) = (connection.source.0, connection.target.0);
            let fits = |channel: &Channel| (channel.source, channel.target) == (source, target);
            let place = channels.iter().position(fits).unwrap_or_else(|| {
                channels.push(Channel {
                    source,
                    target,
                    outputs: Vec::new(),
                    inputs: Vec::new(),
                    names: Vec::new(),
                });
                channels.len() - 1
            });
            if let Some(channel) = channels.get_mut(place) {
                channel.outputs.push(connection.source.1);
                channel.inputs.push(connection.target.1);
                channel.names.push(system.source_name(connection));
            }
        }
        Self {
            channels,
            allow_nan,
        }
    }

    /// What the outputs hold now for the inputs of component `target`.
    pub(super) fn read(
        &self,
        target: usize,
        instances: &mut Instances,
    ) -> Result<InputValues, Halt> {
        self.read_from(target, instances, |_| true)
    }

    /// As [`read`](Self::read), from those components only that `from` says.
    pub(super) fn read_from(
        &self,
        target: usize,
        instances: &mut Instances,
        from: impl Fn(usize) -> bool,
    ) -> Result<InputValues, Halt> {
        let mut load = InputValues::new();
        let own = |channel: &&Channel| channel.target == target && from(channel.source);
        for channel in self.channels.iter().filter(own) {
            let Some(source) = instances.get_mut(channel.source) else {
                continue;
            };
            let values = source
                .get(&channel.outputs)
                .map_err(Halt::at(channel.source))?;
            let ends = channel.inputs.iter().zip(&channel.names);
            for ((input, name), value) in ends.zip(values) {
                if !self.allow_nan && matches!(value, Value::Real(value) if value.is_nan()) {
                    return Err(Halt::Nan(name.clone()));
                }
                load.push((*input, value));
            }
        }
        Ok(load)
    }

    /// Names of the real ones among the outputs that [`read_from`](Self::read_from) reads, in its order.
    pub(super) fn real_names(&self, target: usize, from: impl Fn(usize) -> bool) -> Vec<String> {
        let own = |channel: &&Channel| channel.target == target && from(channel.source);
        let pairs = self
            .channels
            .iter()
            .filter(own)
            .flat_map(|channel| channel.outputs.iter().zip(&channel.names));
        pairs
            .filter(|(place, _)| place.scalar.value_type() == ValueType::Real)
            .map(|(_, name)| name.clone())
            .collect()
    }

    /// Whether some component gets values from itself or from one behind it.
    pub(super) fn has_loops(&self) -> bool {
        let back = |channel: &Channel| channel.source >= channel.target;
        self.channels.iter().any(back)
    }

    /// Sets inputs of component `target`.
    pub(super) fn write(
        target: usize,
        load: &InputValues,
        instances: &mut Instances,
    ) -> Result<(), Halt> {
        match instances.get_mut(target) {
            Some(instance) => instance.set(load).map_err(Halt::at(target)),
            None => Ok(()),
        }
    }

    /// Carries outputs to inputs until nothing changes, at most as often as there are components: through every
    /// chain of direct feedthrough, but a loop of it is not iterated to its end.
    pub(super) fn settle(&self, instances: &mut Instances) -> Result<(), Halt> {
        let mut before: Vec<InputValues> = vec![InputValues::new(); instances.len()];
        for _ in 0..instances.len() {
            let mut changed = false;
            for (target, old) in before.iter_mut().enumerate() {
                let load = self.read(target, instances)?;
                if load != *old {
                    Self::write(target, &load, instances)?;
                    *old = load;
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
        Ok(())
    }
}
