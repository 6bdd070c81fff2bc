//! Strong coupling: a step is repeated until what the FMUs hand each other at its end is what they were given for it.
//!
//! Let x be the values that go back to FMUs which stepped before their source, and G(x) what the sources hold after a
//! step with x. Sought is x = G(x), as [`accelerate`](super::accelerate) seeks it.

use crate::calls::{InputValues, SavedState};
use crate::value::Value;

use super::accelerate::{Change, QuasiNewton, Search};
use super::components::Components;
use super::exchange::Exchange;
use super::halt::Halt;
use super::options::Iteration;

/// What became of an iterated step.
pub(super) enum Outcome {
    /// A component wants to end at this time \[s\], without a way back.
    Ended(f64),
    /// The step is done.
    Done {
        /// How often it was made.
        iterations: u32,
        /// The change that was left, if the values did not agree.
        left: Option<f64>,
        /// The time that a component came to \[s\], if it wanted to end in the last iteration.
        ended: Option<f64>,
    },
}

/// All components from point `k` to the next.
pub(super) fn iterate(
    components: &mut Components<'_>,
    settings: Iteration,
    quasi_newton: &mut QuasiNewton,
    k: u64,
) -> Result<Outcome, Halt> {
    let guess = returned(components)?;
    if guess.iter().all(InputValues::is_empty) {
        // Nothing comes back: the first trial is the step.
        return Ok(match sweep(components, k, &guess, true)? {
            Some(time) => Outcome::Ended(time),
            None => Outcome::Done {
                iterations: 1,
                left: None,
                ended: None,
            },
        });
    }
    let states = components.save()?;
    let outcome = search(components, settings, quasi_newton, (k, guess), &states);
    let released = components.release(states);
    let outcome = outcome?;
    released?;
    Ok(outcome)
}

/// Trials from `states`, the first with `guess`, until two agree. A component that wants to end in a trial does so under values that
/// are not the step's: only the end of the last trial counts.
fn search(
    components: &mut Components<'_>,
    settings: Iteration,
    quasi_newton: &mut QuasiNewton,
    (k, mut guess): (u64, Vec<InputValues>),
    states: &[SavedState],
) -> Result<Outcome, Halt> {
    let mut search = Search::new(quasi_newton, reals(&guess));
    put(&mut guess, &search.first());
    let mut best = None;
    for iterations in 1..=settings.max_iterations {
        let ended = sweep(components, k, &guess, false)?;
        let found = returned(components)?;
        let (x, g) = (reals(&guess), reals(&found));
        let change = search.change(&x, &g);
        if others_agree(&guess, &found) && change.size <= settings.tolerance {
            search.end();
            return Ok(Outcome::Done {
                iterations,
                left: None,
                ended,
            });
        }
        if best.as_ref().is_none_or(|(least, _)| change.size < *least) {
            best = Some((change.size, guess));
        }
        if iterations == settings.max_iterations && !settings.accept_unconverged {
            return Err(not_converged(components, change));
        }
        guess = found;
        if iterations < settings.max_iterations {
            put(&mut guess, &search.next(&x, &g, settings.relaxation));
        }
        components.restore(states)?;
    }
    let (left, guess) = best.unwrap_or((0.0, guess));
    let ended = sweep(components, k, &guess, false)?;
    search.end();
    Ok(Outcome::Done {
        iterations: settings.max_iterations + 1,
        left: Some(left),
        ended,
    })
}

fn not_converged(components: &Components<'_>, last: Change) -> Halt {
    let names = returned_names(components);
    Halt::NotConverged {
        variable: last.worst.and_then(|worst| names.get(worst).cloned()),
        change: last.size,
    }
}

/// Every component one step, in their order: with values of t + h from those before it, guessed ones from the others. The time that
/// the first came to that wants to end before; where there is a way back the others step all the same.
fn sweep(
    components: &mut Components<'_>,
    k: u64,
    guess: &[InputValues],
    no_rollback: bool,
) -> Result<Option<f64>, Halt> {
    let mut ended = None;
    for (component, guessed) in guess.iter().enumerate() {
        let Components {
            exchange,
            instances,
            ..
        } = components;
        let mut load = exchange.read_from(component, instances, |source| source < component)?;
        load.extend(guessed.iter().cloned());
        Exchange::write(component, &load, instances)?;
        ended = ended.or(components.step(component, k, no_rollback)?);
        if no_rollback && ended.is_some() {
            break;
        }
    }
    Ok(ended)
}

/// What now goes back to each component from itself and those behind it.
fn returned(components: &mut Components<'_>) -> Result<Vec<InputValues>, Halt> {
    let Components {
        exchange,
        instances,
        ..
    } = components;
    (0..instances.len())
        .map(|target| exchange.read_from(target, instances, |source| source >= target))
        .collect()
}

/// Names of the real ones among the values of [`returned`].
fn returned_names(components: &Components<'_>) -> Vec<String> {
    let exchange = &components.exchange;
    (0..components.instances.len())
        .flat_map(|target| exchange.real_names(target, |source| source >= target))
        .collect()
}

/// Whether all values are the same that are no real numbers.
fn others_agree(given: &[InputValues], found: &[InputValues]) -> bool {
    let pairs = given.iter().flatten().zip(found.iter().flatten());
    pairs
        .filter(|((_, value), _)| !matches!(value, Value::Real(_)))
        .all(|((_, a), (_, b))| a == b)
}

/// The real values of loads, one after another.
fn reals(loads: &[InputValues]) -> Vec<f64> {
    let values = loads.iter().flatten().map(|(_, value)| value);
    values
        .filter_map(|value| match value {
            Value::Real(value) => Some(*value),
            _ => None,
        })
        .collect()
}

/// Replaces the real values of loads.
fn put(loads: &mut [InputValues], values: &[f64]) {
    let mut values = values.iter();
    for (_, value) in loads.iter_mut().flatten() {
        if let Value::Real(old) = value
            && let Some(new) = values.next()
        {
            *old = *new;
        }
    }
}
