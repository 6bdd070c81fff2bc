//! Runs a scene to its end and measures what it cost, how accurate it was and where its spheres are.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use serde::Serialize;
use sphere_dda::contact::Partner;
use sphere_dda::observe::Observation;
use sphere_dda::observe::energy::Energy;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;
use sphere_dda::state::StepReport;

/// Ticks a second of the times in `/proc/self/stat`: fixed by the Linux interface.
const TICKS: f64 = 100.0;

/// What a run cost and reached.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Measured {
    /// Version of the library.
    pub(crate) version: &'static str,
    /// Number of spheres.
    pub(crate) spheres: usize,
    /// Largest internal step \[s\].
    pub(crate) step: f64,
    /// Gap tolerance \[-\].
    pub(crate) tolerance: f64,
    /// CPU time of all threads from the forces at t = 0 to the end, but for the files of [`Outputs`] \[s\].
    pub(crate) cpu_s: f64,
    /// Time on the clock for the same \[s\].
    pub(crate) wall_s: f64,
    /// Costs and residuals, summed or worst over all internal steps.
    #[serde(flatten)]
    pub(crate) total: StepReport,
    /// Contacts with a force at the ends of communication steps, mean.
    pub(crate) loaded_contacts: f64,
    /// Mean over the last `mean_s` of the vertical force of the spheres on the boundary `floor` \[N\]; absent without such.
    pub(crate) floor_force: Option<f64>,
    /// Kinetic energy at the end \[J\].
    pub(crate) kinetic_energy: f64,
    /// Peak memory of the process less what it held before the scene was read \[B\]; absent where the system does not tell.
    pub(crate) memory_bytes: Option<f64>,
    /// What each communication step cost.
    pub(crate) course: Course,
    /// Force \[N\] and torque \[N m\] of the spheres on each boundary, means over the communication steps, by its name.
    pub(crate) wrenches: BTreeMap<String, Vec<[f64; 6]>>,
}

/// One entry per communication step, in order.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Course {
    /// Its end \[s\].
    pub(crate) time: Vec<f64>,
    /// CPU time of all threads \[s\]: adds up to that of the run, but is up to a few milliseconds late.
    pub(crate) cpu_s: Vec<f64>,
    /// Time on the clock \[s\].
    pub(crate) wall_s: Vec<f64>,
    /// Internal steps.
    pub(crate) steps: Vec<u64>,
    /// Gauss-Seidel sweeps.
    pub(crate) sweeps: Vec<u64>,
    /// Contacts with a force at its end.
    pub(crate) contacts: Vec<usize>,
    /// Largest overlap over radius at the end of any of its internal steps \[-\].
    pub(crate) max_overlap: Vec<f64>,
    /// Largest gap over radius at which a contact carried load at the end of any of its internal steps \[-\].
    pub(crate) max_opening: Vec<f64>,
}

/// Where positions go, and how the floor's force is averaged.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Outputs<'a> {
    /// File of all positions after each communication step: `x y z` per sphere, little-endian f64.
    pub(crate) frames: Option<&'a Path>,
    /// File of the end: `x y z vx vy vz wx wy wz` per sphere, little-endian f64.
    pub(crate) end: Option<&'a Path>,
    /// File of the loaded contacts after each communication step: their number, then both spheres of each, -1 in the place of
    /// the second one for a boundary; little-endian i64.
    pub(crate) contacts: Option<&'a Path>,
    /// Time before the end over which the floor's force is averaged \[s\].
    pub(crate) mean_s: f64,
}

/// Runs `scene`; `memory_before` is [`memory`] before it was read.
///
/// # Errors
/// A step that failed, or a file that cannot be written, in words.
pub(crate) fn measure(
    scene: Scene,
    outputs: Outputs<'_>,
    memory_before: Option<f64>,
) -> Result<Measured, String> {
    let settings = scene.settings.clone();
    let mut frames = outputs.frames.map(create).transpose()?;
    let mut touching = outputs.contacts.map(create).transpose()?;
    let (started, clock) = (cpu()?, Instant::now());
    let mut simulation = Simulation::new(Arc::new(scene)).map_err(|e| e.to_string())?;
    let boundaries = &simulation.scene().boundaries;
    let floor = boundaries.iter().position(|b| b.name == "floor");
    let mut measured = Measured {
        version: env!("CARGO_PKG_VERSION"),
        spheres: simulation.scene().particles.len(),
        step: settings.step,
        tolerance: settings.tolerance.gap,
        ..Measured::default()
    };
    let points = (settings.duration / settings.communication_step).round() as usize;
    let (mut impulse, mut averaged) = (0.0, 0.0);
    // By the clock: one thread writes, and the account of its CPU time is too coarse.
    let mut told = 0.0;
    // Differences of one series of readings: the system's account lags by up to a few milliseconds.
    let mut before = cpu()?;
    for k in 1..=points {
        let (start, begun) = (simulation.time(), Instant::now());
        let end = settings.duration * k as f64 / points as f64;
        let report = simulation.advance_to(end).map_err(|e| e.to_string())?;
        let contacts = simulation.state().contacts.len();
        let (clock, spent) = (begun.elapsed().as_secs_f64(), cpu()?);
        let costs = [spent - before, clock];
        measured.course.add(end, costs, &report, contacts);
        before = spent;
        measured.total.add(&report);
        // A margin of rounding: a communication step that begins at the border counts.
        if let Some(floor) = floor
            && start > settings.duration - outputs.mean_s - 1e-9
        {
            let h = end - start;
            impulse -= simulation.mean_wrench(floor).force.z * h;
            averaged += h;
        }
        for (b, boundary) in simulation.scene().boundaries.iter().enumerate() {
            let wrench = simulation.mean_wrench(b);
            let ([fx, fy, fz], [tx, ty, tz]) = (wrench.force.into(), wrench.torque.into());
            let of = measured.wrenches.entry(boundary.name.clone());
            of.or_default().push([fx, fy, fz, tx, ty, tz]);
        }
        let asked = Instant::now();
        if let Some(file) = &mut touching {
            write_contacts(file, &simulation).map_err(|e| e.to_string())?;
        }
        if let Some(file) = &mut frames {
            for x in &simulation.kinematics().position {
                write(file, x.as_slice()).map_err(|e| e.to_string())?;
            }
        }
        if touching.is_some() || frames.is_some() {
            told += asked.elapsed().as_secs_f64();
        }
    }
    measured.wall_s = clock.elapsed().as_secs_f64() - told;
    measured.cpu_s = cpu()? - started - told;
    // Before anything below allocates.
    measured.memory_bytes = memory("VmHWM:")
        .zip(memory_before)
        .map(|(peak, before)| peak - before);
    measured.floor_force = (averaged > 0.0).then(|| impulse / averaged);
    measured.kinetic_energy = Energy::of(&Observation::of(&simulation)).kinetic();
    measured.loaded_contacts =
        measured.course.contacts.iter().sum::<usize>() as f64 / points as f64;
    for mut file in [frames, touching].into_iter().flatten() {
        file.flush().map_err(|e| e.to_string())?;
    }
    if let Some(path) = outputs.end {
        write_end(path, &simulation)?;
    }
    Ok(measured)
}

impl Course {
    fn add(&mut self, time: f64, [cpu_s, wall_s]: [f64; 2], report: &StepReport, contacts: usize) {
        self.time.push(time);
        self.cpu_s.push(cpu_s);
        self.wall_s.push(wall_s);
        self.steps.push(report.internal_steps);
        self.sweeps.push(report.sweeps);
        self.contacts.push(contacts);
        self.max_overlap.push(report.max_overlap);
        self.max_opening.push(report.max_opening);
    }
}

fn write_end(path: &Path, simulation: &Simulation) -> Result<(), String> {
    let mut file = create(path)?;
    for (i, x) in simulation.kinematics().position.iter().enumerate() {
        let v = simulation.velocity(i);
        for part in [x, &v.linear, &v.angular] {
            write(&mut file, part.as_slice()).map_err(|e| e.to_string())?;
        }
    }
    file.flush().map_err(|e| e.to_string())
}

fn write_contacts(file: &mut impl Write, simulation: &Simulation) -> io::Result<()> {
    let contacts = simulation.contacts();
    file.write_all(&(contacts.len() as i64).to_le_bytes())?;
    contacts.iter().try_for_each(|contact| {
        let other = match contact.key.partner {
            Partner::Sphere { index, .. } => i64::from(index),
            Partner::Boundary { .. } => -1,
        };
        file.write_all(&i64::from(contact.key.sphere).to_le_bytes())?;
        file.write_all(&other.to_le_bytes())
    })
}

fn create(path: &Path) -> Result<BufWriter<File>, String> {
    let file = File::create(path).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(BufWriter::new(file))
}

fn write(file: &mut impl Write, numbers: &[f64]) -> io::Result<()> {
    numbers
        .iter()
        .try_for_each(|x| file.write_all(&x.to_le_bytes()))
}

/// CPU time of this process, all its threads \[s\]: the larger of what threads that still run have used, to the nanosecond,
/// and what ended ones have used too, in whole ticks.
fn cpu() -> Result<f64, String> {
    Ok(running().max(ticked()?))
}

fn running() -> f64 {
    let tasks = fs::read_dir("/proc/self/task").into_iter().flatten();
    let texts =
        tasks.filter_map(|task| fs::read_to_string(task.ok()?.path().join("schedstat")).ok());
    let nanoseconds = texts.filter_map(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.sum::<f64>() * 1e-9
}

fn ticked() -> Result<f64, String> {
    let path = "/proc/self/stat";
    let text = fs::read_to_string(path).map_err(|e| format!("{path}: {e}; this needs Linux"))?;
    // The second field is the name in parentheses, which may hold blanks; user and system time are the 14th and 15th.
    let fields = text.rsplit(')').next().unwrap_or("").split_whitespace();
    let ticks: Vec<f64> = fields.skip(11).take(2).flat_map(str::parse).collect();
    match ticks[..] {
        [user, system] => Ok((user + system) / TICKS),
        _ => Err(format!("{path}: no times in it")),
    }
}

/// A row of `/proc/self/status` such as `VmHWM:`, peak memory, or `VmRSS:`, memory now \[B\].
pub(crate) fn memory(row: &str) -> Option<f64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|line| line.starts_with(row))?;
    let kibibytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kibibytes * 1024.0)
}
