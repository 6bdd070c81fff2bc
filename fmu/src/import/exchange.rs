//! Values on their way from outputs to inputs.

use sphere_dda_model_description::fmi2::BaseType;

use super::system::System;
use super::values::{self, Value, set};
use super::{ImportError, Instance};

/// Values for the inputs of one instance, by value reference.
pub(super) type Load = Vec<(u32, Value)>;

/// Why values did not arrive: the number of the component that failed, and how.
pub(super) enum Broken {
    /// A call failed.
    Call(usize, Box<ImportError>),
    /// The output of this name is NaN.
    Nan(String),
}

impl Broken {
    /// For the error of a call of this component.
    pub(super) fn at(component: usize) -> impl Fn(ImportError) -> Self {
        move |error| Self::Call(component, Box::new(error))
    }
}

/// Connections of one type from one component to another: one call to read them all.
#[derive(Debug)]
struct Channel {
    source: usize,
    target: usize,
    base: BaseType,
    outputs: Vec<u32>,
    inputs: Vec<u32>,
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
            let base = connection.base;
            let fits = |channel: &Channel| {
                (channel.source, channel.target, channel.base) == (source, target, base)
            };
            let place = channels.iter().position(fits).unwrap_or_else(|| {
                channels.push(Channel {
                    source,
                    target,
                    base,
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
    pub(super) fn read(&self, target: usize, instances: &mut [Instance]) -> Result<Load, Broken> {
        let mut load = Load::new();
        for channel in self
            .channels
            .iter()
            .filter(|channel| channel.target == target)
        {
            let Some(source) = instances.get_mut(channel.source) else {
                continue;
            };
            let values = values::get(source, channel.base, &channel.outputs)
                .map_err(Broken::at(channel.source))?;
            for (k, (input, name)) in channel.inputs.iter().zip(&channel.names).enumerate() {
                let Some(value) = values.get(k) else {
                    continue;
                };
                if !self.allow_nan && matches!(value, Value::Real(value) if value.is_nan()) {
                    return Err(Broken::Nan(name.clone()));
                }
                load.push((*input, value));
            }
        }
        Ok(load)
    }

    /// Sets inputs of component `target`.
    pub(super) fn write(
        target: usize,
        load: &Load,
        instances: &mut [Instance],
    ) -> Result<(), Broken> {
        match instances.get_mut(target) {
            Some(instance) => set(instance, load).map_err(Broken::at(target)),
            None => Ok(()),
        }
    }

    /// Carries outputs to inputs until nothing changes, at most as often as there are components: through every
    /// chain of direct feedthrough, but a loop of it is not iterated to its end.
    pub(super) fn settle(&self, instances: &mut [Instance]) -> Result<(), Broken> {
        let mut before: Vec<Load> = vec![Load::new(); instances.len()];
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
