//! `--settle`, `--until-rest` and `--start`: a scene comes to rest before its t = 0, once.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use clap::Args;
use miette::miette;
use sphere_dda::results::start_file::{StartFile, StartFileError};
use sphere_dda::scene::Scene;
use sphere_dda::simulation::{Settle, SettleProgress, Settled};

use crate::arguments::positive;
use crate::failure::Failure;
use crate::progress::{Interrupt, Progress, note};

/// Longest settling time, unless given \[s\].
const PATIENCE: f64 = 60.0;
/// Unbalanced forces over the loads above which a settled start is reported as rough \[-\].
const ROUGH: f64 = 1e-6;
/// Digits of a hash that distinguish starts in messages.
const SHOWN: usize = 12;

/// How a scene settles before it starts.
#[derive(Debug, Args)]
pub(crate) struct Settling {
    /// Let the spheres settle before t = 0, at most for this long in all passes together [s], boundaries fixed, and start from
    /// rest.
    #[arg(long, value_name = "SECONDS", value_parser = positive, allow_negative_numbers = true)]
    settle: Option<f64>,
    /// Settle until the spheres are at rest, at most for --settle, or for 60 s.
    #[arg(long)]
    until_rest: bool,
    /// Keep the settled start in FILE, and read it instead of settling when it belongs to this scene and these options.
    /// Without --settle and --until-rest: read the start from FILE.
    #[arg(long, value_name = "FILE")]
    start: Option<PathBuf>,
}

impl Settling {
    /// The start for [`Scene::start_from`]: settles `scene` if asked to, and says how it went, or reads it from a start file.
    ///
    /// # Errors
    /// The step that could not be taken; spheres that do not come to rest though they should; a start file that cannot be read
    /// or written, or that is none; Ctrl-C.
    pub(crate) fn start(
        &self,
        scene: &Scene,
        interrupt: &Interrupt,
    ) -> Result<Option<Vec<u8>>, Failure> {
        let settles = self.settle.is_some() || self.until_rest;
        let settle = settles.then(|| Settle {
            time: self.settle.unwrap_or(PATIENCE),
            until_rest: self.until_rest,
        });
        match (settle, &self.start) {
            (None, None) => Ok(None),
            (None, Some(path)) => Ok(Some(read(scene, path)?)),
            (Some(settle), None) => Ok(Some(settled(scene, settle, interrupt)?)),
            (Some(settle), Some(path)) => Ok(Some(kept(scene, settle, path, interrupt)?)),
        }
    }
}

/// The start in the file at `path`, however its scene settled.
fn read(scene: &Scene, path: &Path) -> Result<Vec<u8>, Failure> {
    let file = StartFile::read(path)?;
    scene.clone().start_from(&file.start).map_err(|error| {
        Failure::Input(miette!(
            help = "add --settle SECONDS or --until-rest to settle anew",
            "start file `{}`: {error}",
            path.display()
        ))
    })?;
    told(path);
    Ok(file.start)
}

/// The start in the file at `path` if `scene` has settled so into it; else it settles now, into the file.
fn kept(
    scene: &Scene,
    settle: Settle,
    path: &Path,
    interrupt: &Interrupt,
) -> Result<Vec<u8>, Failure> {
    let hash = StartFile::hash(scene, settle);
    match StartFile::read(path) {
        Ok(file) if file.hash == hash => {
            told(path);
            return Ok(file.start);
        }
        Ok(file) => note(format_args!(
            "start file `{}` is of another scene or another settling: found {}, expected {}; settling anew",
            path.display(),
            shown(&file.hash),
            shown(&hash)
        )),
        Err(StartFileError::Missing { .. }) => {}
        Err(error) => return Err(error.into()),
    }
    let start = settled(scene, settle, interrupt)?;
    let file = StartFile { hash, start };
    file.write(path)?;
    note(format_args!("start kept in {}", path.display()));
    Ok(file.start)
}

fn told(path: &Path) {
    note(format_args!("start read from {}", path.display()));
}

fn shown(hash: &str) -> &str {
    hash.get(..SHOWN).unwrap_or(hash)
}

/// Settles `scene` and says how it went.
fn settled(scene: &Scene, settle: Settle, interrupt: &Interrupt) -> Result<Vec<u8>, Failure> {
    // When the spheres come to rest nobody knows; a given time is an end.
    let mut progress = match settle.until_rest {
        true => Progress::open(),
        false => Progress::new(0.0, settle.time),
    };
    let settled = Settled::new(scene, settle, |reached| {
        match settle.until_rest {
            true => progress.say(|| {
                let time = reached.time;
                format!("settling, {time:.3} s simulated, {}", line(reached))
            }),
            false => progress.show(reached.time, || line(reached)),
        }
        match interrupt.requested() {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    })?;
    drop(progress);
    if interrupt.requested() {
        return Err(Failure::Interrupted);
    }
    let Settled {
        start,
        time,
        passes,
        speed,
        fastest,
        rest_speed,
        at_rest,
        unbalanced,
        given_up,
    } = settled;
    if let Some(why) = given_up {
        note(format_args!(
            "warning: the start is that of pass {passes}; the next one failed: {why}"
        ));
    }
    let what = fastest.map_or("something".to_owned(), |fastest| fastest.to_string());
    if at_rest {
        note(format_args!(
            "settled in {time:.3} s, {passes} passes; the fastest sphere was slower than {rest_speed:.1e} m/s, unbalanced forces are \
             {unbalanced:.1e} of the loads"
        ));
        if unbalanced > ROUGH {
            note(format_args!(
                "warning: some spheres still accelerate; --settle with more than {} s balances better",
                settle.time
            ));
        }
    } else if settle.until_rest {
        return Err(Failure::Run(miette!(
            help = "what falls out of the scene needs a boundary below it; rolling spheres need friction and walls to stop, and a driven body that falls needs `hold_while_settling = true`; allow \
                    more time with --settle, or use --settle without --until-rest",
            "not at rest after {time} s: found a speed of {speed:.2e} m/s, expected at most {rest_speed:.1e} m/s; the fastest is {what}"
        )));
    } else {
        note(format_args!(
            "warning: after {time} s a speed of {speed:.2e} m/s was left, more than the {rest_speed:.1e} m/s of rest; all start from rest \
             nevertheless: settle longer, or use --until-rest; the fastest is {what}"
        ));
    }
    Ok(start)
}

/// The pass, and how far from rest the spheres are.
fn line(reached: &SettleProgress<'_>) -> String {
    let SettleProgress {
        pass,
        speed,
        rest_speed,
        ..
    } = reached;
    format!("{pass}, fastest sphere {speed:.1e} m/s (at rest below {rest_speed:.1e} m/s)")
}
