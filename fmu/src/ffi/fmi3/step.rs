//! Steps, with the importer called after each internal step if it wants to be.

use sphere_dda_fmi_interface::abi3::*;
use sphere_dda_fmi_interface::log::Level;

use super::super::guard::{ANY, STEPPING, Stages, Updates, call, lend};
use crate::runtime::instance::{Instance, Progress, Step};
use crate::runtime::life_cycle::LifeCycle;

use fmi3Status::{fmi3Discard, fmi3OK, fmi3Warning};

const WITHIN: Stages = &[
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Intermediate,
];
const FUNCTION: &str = "fmi3DoStep";

/// Takes a step; a discarded one leaves the instance at its beginning, a step that returns early at the end of an
/// internal step.
#[unsafe(no_mangle)]
pub(super) extern "C" fn fmi3DoStep(
    instance: fmi3Instance,
    currentCommunicationPoint: fmi3Float64,
    communicationStepSize: fmi3Float64,
    noSetFMUStatePriorToCurrentPoint: fmi3Boolean,
    eventHandlingNeeded: *mut fmi3Boolean,
    terminateSimulation: *mut fmi3Boolean,
    earlyReturn: *mut fmi3Boolean,
    lastSuccessfulTime: *mut fmi3Float64,
) -> fmi3Status {
    let (mut entered, mut early, mut wish) = (false, false, None);
    let step = (currentCommunicationPoint, communicationStepSize);
    let final_past = noSetFMUStatePriorToCurrentPoint != 0;
    let begun = lend(instance, FUNCTION, STEPPING, |component, lent| {
        lent.place(eventHandlingNeeded, "eventHandlingNeeded")?;
        lent.place(terminateSimulation, "terminateSimulation")?;
        lent.place(earlyReturn, "earlyReturn")?;
        lent.place(lastSuccessfulTime, "lastSuccessfulTime")?;
        entered = true;
        wish = component.updates;
        if wish.is_some() {
            component.instance.begin_step(step.0, step.1)?;
            return Ok(fmi3OK);
        }
        match component.instance.do_step(step.0, step.1, final_past)? {
            Step::Complete => Ok(complete(&component.instance)),
            Step::Discarded(why) => {
                let log = component.instance.log();
                log.write(Level::Discard, format_args!("{FUNCTION}: {why}"));
                Ok(fmi3Discard)
            }
        }
    });
    let status = match wish {
        Some(updates) if begun == fmi3OK => walk(instance, updates, final_past, &mut early),
        _ => begun,
    };
    // A call that does not belong here, or has no place for the results, has been told of and gets none.
    if entered {
        report(
            instance,
            (eventHandlingNeeded, terminateSimulation),
            (earlyReturn, early),
            lastSuccessfulTime,
        );
    }
    status
}

/// Status of a step that was taken: a warning if some of it missed the tolerances.
fn complete(instance: &Instance) -> fmi3Status {
    if instance.unconverged(FUNCTION) {
        fmi3Warning
    } else {
        fmi3OK
    }
}

/// The internal steps of a step that has begun. No reference to the instance lives while the importer is called: it
/// calls back.
fn walk(
    instance: fmi3Instance,
    updates: Updates,
    final_past: bool,
    early: &mut bool,
) -> fmi3Status {
    let mut return_time = f64::INFINITY;
    loop {
        let mut reached = None;
        let taken = call(instance, FUNCTION, WITHIN, |component| {
            match component.instance.internal_step()? {
                Progress::Taken { last } => {
                    reached = Some((component.instance.time(), last));
                    Ok(fmi3OK)
                }
                Progress::Discarded(why) => {
                    let log = component.instance.log();
                    log.write(Level::Discard, format_args!("{FUNCTION}: {why}"));
                    Ok(fmi3Discard)
                }
            }
        });
        let Some((time, last)) = reached else {
            return taken;
        };
        let may_return = !last && updates.early_return_allowed;
        return_time = update(updates, time, may_return).min(return_time);
        // Importers add up their times: one may miss the end of an internal step by rounding.
        *early = may_return && return_time - time <= 4.0 * f64::EPSILON * time.abs();
        if last || *early {
            return call(instance, FUNCTION, WITHIN, |component| {
                component.instance.end_step(final_past)?;
                Ok(complete(&component.instance))
            });
        }
    }
}

/// Calls the importer at the end of an internal step; the time \[s\] at which it wants the step to end, infinite if it
/// wants no early return. A later time than this one stays wanted: the step ends at the first internal step from then on.
fn update(updates: Updates, time: f64, may_return: bool) -> f64 {
    let (mut wanted, mut at) = (0, time);
    let may = fmi3Boolean::from(may_return);
    // SAFETY: the importer's own function, valid as long as the instance; the places outlive the call.
    unsafe {
        let callback = updates.callback;
        callback(
            updates.environment,
            time,
            1,
            1,
            1,
            may,
            &raw mut wanted,
            &raw mut at,
        );
    }
    match wanted {
        0 => f64::INFINITY,
        _ => at,
    }
}

/// Fills the places of the results.
fn report(
    instance: fmi3Instance,
    (event, terminate): (*mut fmi3Boolean, *mut fmi3Boolean),
    (place, early): (*mut fmi3Boolean, bool),
    last: *mut fmi3Float64,
) {
    let _: fmi3Status = lend(instance, FUNCTION, ANY, |component, lent| {
        let ends = component.instance.wants_to_terminate();
        lent.place(event, "eventHandlingNeeded")?.write(0);
        let ends = fmi3Boolean::from(ends);
        lent.place(terminate, "terminateSimulation")?.write(ends);
        let early = fmi3Boolean::from(early);
        lent.place(place, "earlyReturn")?.write(early);
        let time = component.instance.time();
        lent.place(last, "lastSuccessfulTime")?.write(time);
        Ok(fmi3OK)
    });
}
