//! The examples run from their start: overlaps, spheres beyond a boundary, work, states to look at.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::detection::broad_phase::NeighborList;
use sphere_dda::detection::configuration::Configuration;
use sphere_dda::error::StepError;
use sphere_dda::integrator::Integrator;
use sphere_dda::problem::Problem;
use sphere_dda::scene::{Method, Scene};
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::SolverKind;
use sphere_dda::spatial::Pose;
use sphere_dda_picture::error::DrawingError;

use super::beyond::Beyond;
use super::overlap::Overlaps;
use crate::Part;
use crate::error::ReportError;

/// The paper's examples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Example {
    /// Section V: funnel flow.
    Funnel,
    /// Section VI: multiple slopes.
    Slopes,
}

impl Example {
    /// Both, in the paper's order.
    pub const ALL: [Self; 2] = [Self::Funnel, Self::Slopes];

    /// Name of its scene.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Funnel => "funnel",
            Self::Slopes => "slopes",
        }
    }

    /// Times of the paper's pictures \[s\].
    #[must_use]
    pub fn printed(self) -> &'static [f64] {
        match self {
            Self::Funnel => &[6.0, 8.6],
            Self::Slopes => &[20.0, 47.0, 63.0],
        }
    }

    /// The last of them \[s\]: a whole run ends there.
    #[must_use]
    pub fn end(self) -> f64 {
        self.printed().iter().copied().fold(0.0, f64::max)
    }

    /// A time \[s\] before the first picture, with most of the spheres in contact.
    #[must_use]
    pub fn early(self) -> f64 {
        match self {
            Self::Funnel => 2.0,
            Self::Slopes => 5.0,
        }
    }

    /// Until when \[s\] penalties are compared: the spheres have met the funnel, or begun to slide.
    #[must_use]
    pub fn compared(self) -> f64 {
        match self {
            Self::Funnel => 1.0,
            Self::Slopes => 5.0,
        }
    }

    /// Layers that its spheres start in.
    #[must_use]
    pub fn layers(self) -> usize {
        match self {
            Self::Funnel => 2,
            Self::Slopes => 3,
        }
    }

    /// The scene as in `examples/`.
    ///
    /// # Errors
    /// [`ReportError::Scene`] if it is damaged.
    pub fn scene(self) -> Result<Scene, ReportError> {
        let text = match self {
            Self::Funnel => include_str!("../../../examples/funnel/funnel.toml"),
            Self::Slopes => include_str!("../../../examples/slopes/slopes.toml"),
        };
        let name = format!("examples/{0}/{0}.toml", self.name());
        Ok(Scene::from_toml(&name, text, Path::new(""))?.scene)
    }
}

/// What is run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    /// The scene.
    pub example: Example,
    /// Time integration.
    pub integrator: Integrator,
    /// Contact enforcement.
    pub method: Method,
    /// Penalty number over that of the paper.
    pub factor: f64,
    /// Until when \[s\].
    pub end: f64,
}

impl Case {
    /// Name in messages.
    #[must_use]
    pub fn name(&self) -> String {
        let Self {
            example,
            integrator,
            method,
            factor,
            ..
        } = self;
        let (integrator, method) = (integrator_name(*integrator), method_name(*method));
        format!("{}, {integrator}, {method}, {factor} P", example.name())
    }

    /// What it costs from the paper's penalty, in seconds of one core as recorded.
    #[must_use]
    pub fn cost(&self) -> f64 {
        let alm = self.method == Method::Alm;
        let whole = match (self.example, self.integrator) {
            (Example::Funnel, Integrator::Shi) => {
                if alm {
                    111.0
                } else {
                    7.0
                }
            }
            (Example::Funnel, Integrator::Moreau) => {
                if alm {
                    180.0
                } else {
                    128.0
                }
            }
            (Example::Slopes, Integrator::Shi) => {
                if alm {
                    107.0
                } else {
                    2.0
                }
            }
            (Example::Slopes, Integrator::Moreau) => {
                if alm {
                    86.0
                } else {
                    18.0
                }
            }
        };
        whole * self.end / self.example.end()
    }

    /// The scene of this case; ALM by the paper's loop, which adapts the penalty as the library does by itself.
    ///
    /// # Errors
    /// As [`Example::scene`].
    pub fn scene(&self) -> Result<Scene, ReportError> {
        let mut scene = self.example.scene()?;
        let settings = &mut scene.settings;
        settings.integrator = self.integrator;
        settings.method = self.method;
        settings.solver = SolverKind::Direct;
        settings.penalty = settings.penalty.map(|p| p * self.factor);
        Ok(scene)
    }
}

/// Name of an integrator in scenes.
#[must_use]
pub fn integrator_name(integrator: Integrator) -> &'static str {
    match integrator {
        Integrator::Moreau => "moreau",
        Integrator::Shi => "shi",
    }
}

/// Name of a method in the report.
#[must_use]
pub fn method_name(method: Method) -> &'static str {
    match method {
        Method::Alm => "ALM",
        Method::Penalty => "penalty",
    }
}

/// Sum and maximum of a count per step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Over all steps.
    pub sum: u64,
    /// In one step.
    pub max: u64,
}

impl Tally {
    /// Takes in the count of a step.
    pub fn include(&mut self, count: u64) {
        self.sum += count;
        self.max = self.max.max(count);
    }
}

/// A state worth a picture or a line of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// Time \[s\].
    pub time: f64,
    /// Overlaps at that time.
    pub overlaps: Overlaps,
    /// Centres \[m\], `[N]`.
    pub position: Vec<Vec3>,
    /// Whether each sphere is beyond a boundary, `[N]`.
    pub beyond: Vec<bool>,
}

impl Moment {
    /// Number of spheres beyond a boundary.
    #[must_use]
    pub fn beyond_count(&self) -> usize {
        self.beyond.iter().filter(|&&b| b).count()
    }
}

/// What a run gave.
#[derive(Debug, Clone)]
pub struct Record {
    /// What was run.
    pub case: Case,
    /// Its scene.
    pub scene: Arc<Scene>,
    /// Steps taken (communication steps; cut ones count once).
    pub steps: u64,
    /// Overlaps at the ends of all steps.
    pub overlaps: Overlaps,
    /// Multiplier updates per step.
    pub augmentations: Tally,
    /// Linear solves per step.
    pub solves: Tally,
    /// States at t = 0, at the early time and at the paper's times, as far as the run came.
    pub moments: Vec<Moment>,
    /// Time \[s\], largest overlap over radius, spheres beyond a boundary: after every step.
    pub history: Vec<(f64, f64, usize)>,
    /// Most spheres that were beyond a boundary at once.
    pub most_beyond: usize,
    /// The problem of the step at the early time.
    pub problem: Option<Problem>,
    /// When \[s\] all spheres of the funnel had left it, for the first time.
    pub emptied: Option<f64>,
    /// Why it ended early.
    pub failure: Option<StepError>,
}

/// Runs a case to its end, or as far as it goes: a penalty method that fails is a result.
///
/// # Errors
/// A damaged scene, an augmented-Lagrangian run that does not start, or [`ReportError::Interrupted`].
pub fn simulate(case: Case, part: &Part<'_>) -> Result<Record, ReportError> {
    let scene = Arc::new(case.scene()?);
    let mut simulation =
        Simulation::new(Arc::clone(&scene)).map_err(|error| ReportError::Step {
            case: case.name(),
            error,
        })?;
    let start = &simulation.kinematics().position;
    let beyond = Beyond::new(&scene.boundaries, start).map_err(|error| DrawingError {
        name: case.name(),
        found: error.to_string(),
        expected: "boundaries that can be triangulated",
    })?;
    let record = Record {
        case,
        scene: Arc::clone(&scene),
        steps: 0,
        overlaps: Overlaps::default(),
        augmentations: Tally::default(),
        solves: Tally::default(),
        moments: Vec::new(),
        history: Vec::new(),
        most_beyond: 0,
        problem: None,
        emptied: None,
        failure: None,
    };
    let mut observer = Observer {
        record,
        beyond,
        neighbors: NeighborList::default(),
        poses: (0..scene.boundaries.len())
            .map(|b| simulation.boundary_pose(b))
            .collect(),
    };
    observer.look(&simulation);
    let step = scene.settings.communication_step;
    let count = (case.end / step).round() as u64;
    for k in 1..=count {
        if part.watch.stop() {
            return Err(ReportError::Interrupted);
        }
        part.reached((k - 1) as f64 / count as f64);
        match simulation.advance_to(k as f64 * step) {
            Ok(report) => {
                observer.record.augmentations.include(report.augmentations);
                observer.record.solves.include(report.factorizations);
                observer.record.steps += 1;
                observer.look(&simulation);
            }
            Err(error) => {
                observer.record.failure = Some(error);
                break;
            }
        }
    }
    Ok(observer.record)
}

/// A run under way.
struct Observer {
    record: Record,
    beyond: Beyond,
    neighbors: NeighborList,
    poses: Vec<Pose>,
}

impl Observer {
    /// Takes the state into the record.
    fn look(&mut self, simulation: &Simulation) {
        let record = &mut self.record;
        let position = &simulation.kinematics().position;
        self.beyond.follow(position);
        let configuration = Configuration {
            particles: &record.scene.particles,
            position,
            present: &simulation.kinematics().present,
            boundaries: &record.scene.boundaries,
            poses: &self.poses,
            cell: &record.scene.cell,
        };
        let overlaps = Overlaps::of(&configuration, &mut self.neighbors);
        let time = simulation.time();
        let beyond = self.beyond.count();
        record.overlaps.merge(&overlaps);
        record.history.push((time, overlaps.largest, beyond));
        record.most_beyond = record.most_beyond.max(beyond);
        let case = record.case;
        if record.emptied.is_none() && position.iter().all(|x| x.z < 0.0) {
            record.emptied = Some(time);
        }
        let half = 0.5 * record.scene.settings.communication_step;
        let is = |t: f64| (t - time).abs() < half;
        if is(case.example.early()) {
            // The step is valid: it is the scene's own.
            record.problem = simulation.problem(2.0 * half).ok().map(|(p, _)| p);
        }
        if is(0.0) || is(case.example.early()) || case.example.printed().iter().any(|&t| is(t)) {
            record.moments.push(Moment {
                time,
                overlaps,
                position: position.clone(),
                beyond: (0..position.len())
                    .map(|i| self.beyond.is_beyond(i))
                    .collect(),
            });
        }
    }
}
