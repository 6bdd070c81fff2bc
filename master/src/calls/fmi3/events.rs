//! Events of an instance of FMI 3.0 with an event mode, and steps from event to event.
//!
//! An event comes from the FMU within a step, at a time that it has announced, or by a discrete input that changes. The
//! FMU is in event mode for as long as it takes to handle it, and in step mode whenever the simulation calls it.

use super::abi::Functions;
use crate::calls::instance::Instance;
use crate::calls::participant::Step;
use crate::calls::state::Agenda;
use crate::error::ImportError;

/// Most updates of discrete states for one event, and most events at one time.
const MOST: u32 = 1000;
/// Part of a step by which times may differ and still be the same.
const SAME: f64 = 1e-9;

/// Handles the event for which the instance is in event mode; then it is in step mode again.
pub(super) fn handle(
    instance: &mut Instance<Functions>,
    agenda: &mut Agenda,
) -> Result<(), ImportError> {
    for _ in 0..MOST {
        let updated = instance.update_discrete_states()?;
        agenda.next_event = updated.next_event;
        agenda.terminated |= updated.terminated;
        if !updated.again {
            return instance.enter_step_mode();
        }
    }
    Err(endless("fmi3UpdateDiscreteStates"))
}

/// From `time` by `step` \[s\] through all events on the way. With `any_step` the instance comes to announced times and may
/// return early; else it handles events at the end of the step.
pub(super) fn step(
    instance: &mut Instance<Functions>,
    agenda: &mut Agenda,
    any_step: bool,
    (time, step): (f64, f64),
    no_rollback: bool,
) -> Result<Step, ImportError> {
    let (target, same) = (time + step, SAME * step);
    let (mut now, mut standing) = (time, 0);
    while !agenda.terminated {
        let on_the_way = |next: &f64| any_step && now + same < *next && *next < target - same;
        let (end, length) = match agenda.next_event.filter(on_the_way) {
            Some(next) => (next, next - now),
            None if now == time => (target, step),
            None => (target, target - now),
        };
        let returned = instance.do_step(now, length, no_rollback)?;
        let last = returned.last_successful_time;
        if returned.discarded {
            return Ok(Step::Discarded {
                last_successful_time: last.or((now > time).then_some(now)),
                terminated: returned.terminated,
            });
        }
        let reached = last.filter(|_| returned.early).unwrap_or(end);
        standing = if reached > now { 0 } else { standing + 1 };
        now = reached;
        if returned.terminated {
            break;
        }
        let due = agenda.next_event.is_some_and(|next| next <= now + same);
        if returned.event || due {
            instance.enter_event_mode()?;
            handle(instance, agenda)?;
        }
        if now >= target - same && !agenda.terminated {
            return Ok(Step::Done);
        }
        if standing > MOST {
            return Err(endless("fmi3DoStep"));
        }
    }
    Ok(Step::Discarded {
        last_successful_time: Some(now),
        terminated: true,
    })
}

fn endless(function: &'static str) -> ImportError {
    ImportError::Endless {
        function,
        found: MOST,
    }
}
