//! Getting and setting values: dispatch by the variable table.

use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::values;
use sphere_dda_model_description::fmi2::{BaseType, Causality, Variability};

use super::Instance;
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;
use crate::table::{Binding, Value, Variable, component};
use sphere_dda_fmi_interface::log::Level;

impl Instance {
    /// Values of variables of one type, in the order of `references`.
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NoValue`]; in initialization mode also [`Refusal::Step`].
    pub fn get(&mut self, base: BaseType, references: &[u32]) -> Result<Vec<Value>, Refusal> {
        let mut outputs = false;
        for &reference in references {
            let binding = self.variable(base, reference)?.binding;
            outputs |= matches!(binding, Binding::Output(_));
        }
        if outputs {
            self.look()?;
            if let (None, Some(simulation)) = (&self.measured.outputs, &self.simulation) {
                self.measured.outputs = Some(values(&Observation::of(simulation)));
            }
        }
        let variables = references.iter().map(|&r| self.variable(base, r));
        variables.map(|found| self.value(found?)).collect()
    }

    fn value(&self, variable: &Variable) -> Result<Value, Refusal> {
        let rank = match variable.binding {
            Binding::Time => return Ok(Value::Real(self.run.time)),
            Binding::Parameter(parameter) => return Ok(self.run.parameters.get(parameter)),
            Binding::Input {
                boundary,
                input,
                axis,
            } => {
                let mut command = self.run.commands[boundary];
                return Ok(Value::Real(*component(&mut command, input, axis)));
            }
            Binding::Output(rank) => rank,
        };
        let outputs = self.measured.outputs.as_ref();
        match outputs.and_then(|values| values.get(rank)) {
            // A cast keeps within the range: the C interface has no integer beyond 2^31.
            Some(&value) if variable.base == BaseType::Integer => Ok(Value::Integer(value as i32)),
            Some(&value) => Ok(Value::Real(value)),
            None => Err(Refusal::NoValue {
                name: variable.name.clone(),
                stage: self.run.stage,
            }),
        }
    }

    /// Before outputs are read: brings the start up to date in initialization mode, warns of a read that is too early.
    pub(super) fn look(&mut self) -> Result<(), Refusal> {
        match self.run.stage {
            LifeCycle::Initialization if self.run.pending => self.prepare()?,
            LifeCycle::StepComplete if self.run.pending && !self.read_ahead => {
                self.read_ahead = true;
                let text = "outputs read after a set without a step: they are those of the last step (told once)";
                self.log.write(Level::Warning, text);
            }
            _ => {}
        }
        Ok(())
    }

    /// Sets variables; all or none.
    ///
    /// # Errors
    /// [`Refusal::Reference`], [`Refusal::NotSettable`], [`Refusal::Range`].
    pub fn set(&mut self, values: Vec<(u32, Value)>) -> Result<(), Refusal> {
        for (reference, value) in &values {
            self.check(*reference, value)?;
        }
        for (reference, value) in values {
            match (self.variable(value.base(), reference)?.binding, value) {
                (Binding::Parameter(parameter), value) => self.run.parameters.set(parameter, value),
                (
                    Binding::Input {
                        boundary,
                        input,
                        axis,
                    },
                    Value::Real(value),
                ) => {
                    *component(&mut self.run.commands[boundary], input, axis) = value;
                    for rate in &mut self.run.rates[boundary] {
                        *component(rate, input, axis) = 0.0;
                    }
                }
                _ => continue,
            }
            self.run.pending = true;
        }
        Ok(())
    }

    fn check(&self, reference: u32, value: &Value) -> Result<(), Refusal> {
        let variable = self.variable(value.base(), reference)?;
        let before = matches!(
            self.run.stage,
            LifeCycle::Instantiated | LifeCycle::Initialization
        );
        let allowed = match (variable.causality, variable.variability) {
            (Causality::Input, _) => true,
            // What a step began with holds to its end, but for inputs.
            (_, Variability::Tunable) => self.run.stage != LifeCycle::Intermediate,
            (Causality::Parameter, _) => before,
            _ => false,
        };
        if !allowed {
            return Err(Refusal::NotSettable {
                name: variable.name.clone(),
                kind: format!("{:?}, {:?}", variable.causality, variable.variability)
                    .to_lowercase(),
                stage: self.run.stage,
                allowed: match variable.causality {
                    Causality::Parameter => "set it before or in initialization mode",
                    _ => "only parameters and inputs can be set",
                },
            });
        }
        if let (Some(choices), Value::Integer(found)) = (variable.choices, value)
            && choices.item(*found).is_none()
        {
            let items = choices.items.iter();
            let items: Vec<String> = items
                .map(|(name, value, _)| format!("{value} ({name})"))
                .collect();
            return Err(Refusal::Item {
                name: variable.name.clone(),
                found: (*found).into(),
                expected: items.join(", "),
            });
        }
        let Value::Real(found) = *value else {
            return Ok(());
        };
        let (min, max) = (
            variable.min.unwrap_or(f64::MIN),
            variable.max.unwrap_or(f64::MAX),
        );
        if found.is_finite() && (min..=max).contains(&found) {
            return Ok(());
        }
        let expected = match (variable.min, variable.max) {
            (None, None) => "a finite number".to_owned(),
            // The least positive number is how a model description says "not 0".
            (Some(min), None) if min == f64::MIN_POSITIVE => "a number > 0".to_owned(),
            (Some(min), None) => format!("a number >= {min}"),
            (None, Some(_)) => format!("a number <= {max}"),
            (Some(_), Some(_)) => format!("a number from {} to {}", short(min), short(max)),
        };
        Err(Refusal::Range {
            name: variable.name.clone(),
            found,
            expected,
        })
    }

    pub(super) fn variable(&self, base: BaseType, reference: u32) -> Result<&Variable, Refusal> {
        let found = self.model.table.get(reference);
        found
            .filter(|variable| variable.base == base)
            .ok_or_else(|| Refusal::Reference {
                reference,
                found: found
                    .map(|variable| format!("`{}` of type {:?}", variable.name, variable.base)),
                expected: base,
            })
    }
}

/// A bound as a person writes it.
fn short(bound: f64) -> String {
    match (1e-3..1e6).contains(&bound.abs()) || bound == 0.0 {
        true => bound.to_string(),
        false => format!("{bound:e}"),
    }
}
