//! Why a scene could not settle.

use thiserror::Error;

use super::Pass;
use crate::error::StepError;
use crate::solver::Tolerance;

/// Why a scene could not settle.
#[derive(Debug, Clone, PartialEq, Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum SettleError {
    /// The caller asked for something impossible.
    #[error(transparent)]
    Argument(StepError),
    /// A step of a pass could not be taken.
    #[error("settling, {pass}, {time:.4} s simulated: {}", told(source, tolerance))]
    Step {
        /// The pass.
        pass: Pass,
        /// Time simulated in all passes \[s\].
        time: f64,
        /// The scene's own tolerances; those of the pass may differ.
        tolerance: Tolerance,
        /// What went wrong; its times count from the start of settling.
        source: Box<StepError>,
    },
}

/// A step's error in words: of tolerances those that the user can set.
fn told(source: &StepError, own: &Tolerance) -> String {
    let StepError::NotConverged {
        step,
        what,
        residual,
        tolerance,
        contact,
        cuts,
        broken,
        ..
    } = source
    else {
        return source.to_string();
    };
    let own = match *what {
        "gap" => own.gap,
        "slip" => own.slip,
        _ => own.force,
    };
    // A pass is never finer than the scene where the scene's value is what stopped it.
    let (whose, loosen) = if own < *tolerance {
        ("that of this pass; the scene's is finer", String::new())
    } else if own > *tolerance {
        (
            "that of this pass, whatever the scene's tolerance is",
            String::new(),
        )
    } else {
        ("that of the scene", format!("loosen tolerance.{what}, "))
    };
    format!(
        "{what} {residual:.2e} stays above {tolerance:e}, {whose} (tolerance.{what} = {own:e}), at {contact} after {cuts} cuts of a step to \
         {step:e} s{broken}; {loosen}reduce simulation.step or raise simulation.max_iterations"
    )
}
