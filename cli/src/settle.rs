//! `--settle` and `--until-rest`: a scene comes to rest before its t = 0.

use std::ops::ControlFlow;

use clap::Args;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::{Settle, Settled};

use crate::failure::Failure;
use crate::progress::{Interrupt, Progress, note};
use crate::run::positive;

/// Longest time that spheres get to come to rest unless told otherwise \[s\].
const PATIENCE: f64 = 60.0;

/// How a scene settles before it starts.
#[derive(Debug, Args)]
pub(crate) struct Settling {
    /// Let the spheres settle for this long before t = 0 [s], boundaries held, and start from rest.
    #[arg(long, value_name = "SECONDS", value_parser = positive, allow_negative_numbers = true)]
    settle: Option<f64>,
    /// Settle until the spheres are at rest, at most for --settle, or for 60 s.
    #[arg(long)]
    until_rest: bool,
}

impl Settling {
    /// Settles `scene` if asked to, and says how it went: the start for [`Scene::start_from`].
    ///
    /// # Errors
    /// The step that could not be taken; spheres that do not come to rest though they should; Ctrl-C.
    pub(crate) fn start(
        &self,
        scene: &Scene,
        interrupt: &Interrupt,
    ) -> Result<Option<Vec<u8>>, Failure> {
        if self.settle.is_none() && !self.until_rest {
            return Ok(None);
        }
        let settle = Settle {
            time: self.settle.unwrap_or(PATIENCE),
            until_rest: self.until_rest,
        };
        let mut progress = Progress::new(0.0, settle.time);
        let settled = Settled::new(scene, settle, |simulation| {
            let detail = || format!("settling, {} contacts", simulation.state().contacts.len());
            progress.show(simulation.time(), detail);
            match interrupt.requested() {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        })?;
        if interrupt.requested() {
            return Err(Failure::Interrupted);
        }
        let Settled {
            time,
            speed,
            rest_speed,
            at_rest,
            unbalanced,
            ..
        } = settled;
        if at_rest {
            note(format_args!(
                "settled in {time:.3} s; the fastest sphere was slower than {rest_speed:.1e} m/s, unbalanced forces are {unbalanced:.1e} of the weight"
            ));
        } else if self.until_rest {
            return Err(Failure::Run(miette::miette!(
                help = "rolling spheres need friction and walls to stop; allow more time with --settle, or use --settle without --until-rest",
                "not at rest after {time} s: found a speed of {speed:.2e} m/s, expected at most {rest_speed:.1e} m/s"
            )));
        } else {
            note(format_args!(
                "warning: after {time} s a sphere still moved at {speed:.2e} m/s, more than the {rest_speed:.1e} m/s of rest; it starts from rest nevertheless: settle longer, or use --until-rest"
            ));
        }
        Ok(Some(settled.start))
    }
}
