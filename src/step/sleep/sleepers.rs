//! The forces on bodies that sleep, old ones and those of awake neighbours: they must balance.

use crate::Vec3;
use crate::contact::{ContactForce, Partner};
use crate::solver::Report;
use crate::spatial::SpatialVector;
use crate::state::State;
use crate::step::apart::swept;
use crate::step::assemble::Assembly;
use crate::step::input::Effort;
use crate::step::output::{StepFailure, StepOutput, Taken};
use crate::step::prediction::Prediction;
use crate::step::solution::{Solution, Solved};

/// Out of balance by so many times what the tolerance of forces allows for, a body wakes within the step, and not after it.
const DISTURBED: f64 = 10.0;
/// Rings of spheres that wake about those beside which a step has failed.
const FAILED_RINGS: usize = 8;

/// The bodies that sleep, as a solution leaves them.
pub(crate) struct Sleepers {
    pub(super) bodies: Vec<Sleeper>,
}

/// A body that sleeps.
pub(super) struct Sleeper {
    /// The sphere, or the first member of the clump.
    pub(super) sphere: usize,
    /// Its centre \[m\].
    pub(super) centre: Vec3,
    /// Sum of all forces \[N\] and torques about its centre \[N m\] on it, and of those that persist.
    pub(super) net: SpatialVector,
    pub(super) smooth: SpatialVector,
    /// Whether it has contacts with awake ones.
    touched: bool,
    /// What it is out of balance by, over the tolerance times the sum of the sizes of its contacts' forces, or times its weight if that is
    /// more \[-\].
    excess: f64,
}

impl Sleepers {
    /// Those of a step that is `solved`, before it is committed to `state`.
    pub(crate) fn of(solved: &Solved, state: &State) -> Self {
        let (assembly, solution, prediction) =
            (solved.assembly, solved.solution, solved.prediction());
        if prediction.asleep.is_empty() {
            return Self { bodies: Vec::new() };
        }
        let touched = beside(assembly);
        let all = 0..prediction.clump_body(prediction.clumps.len()) as u32;
        let single = |body: &u32| match prediction.clump_of(*body) {
            Some(_) => true,
            None => prediction.scene.particles.clump(*body as usize).is_none(),
        };
        let found = all
            .filter(|&body| prediction.body_sleeps(body) && !prediction.is_obstacle(body))
            .filter(single);
        let found: Vec<u32> = found.collect();
        let rows = &assembly.problem.rows;
        let mut sums = Sums::new(prediction, &found);
        for (k, &impulse) in solution.impulses.iter().enumerate() {
            let bodies = rows.bodies(k);
            if impulse != Vec3::zeros() && bodies.iter().any(|&body| prediction.body_sleeps(body)) {
                let force = impulse * (1.0 / prediction.step);
                let how = (force.norm(), !assembly.is_impact(k));
                for (body, moment) in bodies.into_iter().zip(rows.momenta(k, force)) {
                    sums.add(body, &moment, how);
                }
            }
        }
        for (k, load) in state.contacts.iter().enumerate() {
            if prediction.sleeps(load.key) {
                sums.add_load(prediction, load, state.contacts.torque(k));
            }
        }
        let tolerance = prediction.scene.settings.tolerance.force;
        let touched = |k: usize| touched.binary_search(&found[k]).is_ok();
        let bodies = (0..found.len()).map(|k| sums.sleeper(prediction, k, (touched(k), tolerance)));
        Self {
            bodies: bodies.collect(),
        }
    }

    /// How a step ends whose `output` is this: not, if a body is out of balance by much more than the tolerance.
    pub(crate) fn ends(&self, output: StepOutput) -> Attempt {
        let off = self.beyond(DISTURBED);
        match off.is_empty() {
            true => Attempt::Done(Ok(output)),
            false => Attempt::Disturbed {
                spheres: off,
                rings: 1,
                report: output.solver,
            },
        }
    }

    /// Spheres that awake ones touch and that are out of balance by more than `share` of what the tolerance of forces allows for.
    pub(crate) fn beyond(&self, share: f64) -> Vec<usize> {
        let off = |body: &&Sleeper| body.touched && body.excess > share;
        let off = self.bodies.iter().filter(off);
        off.map(|body| body.sphere).collect()
    }
}

/// How an attempt at a step ends.
pub(crate) enum Attempt {
    /// With the next state, or without.
    Done(Result<StepOutput, StepFailure>),
    /// Spheres that sleep would move, or keep others from a solution.
    Disturbed {
        spheres: Vec<usize>,
        /// At least so many rings of spheres about them wake with them.
        rings: usize,
        /// What the solver has done.
        report: Report,
    },
    /// Something would reach what takes no part; what the solver has done.
    Outgrown(Report),
}

impl Attempt {
    /// That of a step in which what is awake may touch something that takes no part, at the start or on its way by the solution;
    /// `None` if it may not.
    pub(crate) fn leads_out(
        assembly: &Assembly,
        solution: &Solution,
        resolved: &Result<StepOutput, StepFailure>,
    ) -> Option<Self> {
        let prediction = assembly.prediction;
        let outside = &prediction.outside;
        if outside.is_empty() {
            return None;
        }
        let (solution, report) = match resolved {
            Ok(output) => (Some(solution), output.solver),
            Err(_) => (None, Report::default()),
        };
        let particles = &prediction.scene.particles;
        let spheres = 0..particles.len() as u32;
        let single = spheres.filter(|&i| particles.clump(i as usize).is_none());
        let clumps = (0..prediction.clumps.len()).map(|c| prediction.clump_body(c) as u32);
        let mut awake = single
            .chain(clumps)
            .filter(|&body| !prediction.body_sleeps(body));
        let strays = |body: u32| {
            let (sphere, from, _) = prediction.place_of(body);
            let after = |velocity: &SpatialVector| from + velocity.linear * prediction.step;
            let to = solution.map_or(from, |solution| after(&solution.velocity[body as usize]));
            let free = after(&prediction.velocity(body as usize));
            !outside.admits(sphere, [from, to], free)
        };
        let ends = solution.map(|solution| prediction.end_poses(&solution.velocity));
        let mut driven = prediction.bodies.iter().map(|body| body.boundary);
        let leaves = |b: usize| {
            let (boundary, start) = (&prediction.scene.boundaries[b], &prediction.poses[0][b]);
            let taken = start.advanced(&prediction.twists[b], prediction.step);
            let end = ends.as_ref().map_or(&taken, |ends| &ends[b]);
            let [found, taken] = [end, &taken].map(|end| swept(boundary, start, end));
            !(found.zip(taken)).is_some_and(|(found, taken)| outside.admits_boundary(found, taken))
        };
        let mut touched = beside(assembly).into_iter();
        let leads_out = awake.any(strays)
            || touched.any(|body| prediction.is_obstacle(body))
            || driven.any(leaves);
        leads_out.then_some(Self::Outgrown(report))
    }

    /// That of a problem which is not solved while bodies sleep beside those of its rows; `None` if it is, or none sleeps. Where the step
    /// can be cut by `effort`, only those near what fails count: shorter steps help against all else. What seems to be squeezed may be so
    /// by bodies that sleep.
    pub(crate) fn failed_beside_sleepers(
        assembly: &Assembly,
        resolved: &Result<StepOutput, StepFailure>,
        (state, effort): (&State, Effort),
    ) -> Option<Self> {
        let (report, failing) = match resolved {
            Ok(output) if !output.unconverged || output.squeezed.is_some() => return None,
            Ok(output) => (output.solver, Vec::new()),
            Err(failure) if effort.sweeps.is_none() || failure.pinched.is_some() => {
                (Report::default(), Vec::new())
            }
            Err(failure) => (Report::default(), failure.spheres()),
        };
        let prediction = assembly.prediction;
        let beside = beside(assembly);
        let mut beside = beside.iter().map(|&body| prediction.place_of(body).0);
        let spheres = match failing.is_empty() {
            true => Some(beside.collect()).filter(|all: &Vec<_>| !all.is_empty()),
            false => {
                let near = prediction.around(&failing, FAILED_RINGS, state);
                beside.any(|i| near[i]).then_some(failing)
            }
        };
        spheres.map(|spheres| Self::Disturbed {
            spheres,
            rings: FAILED_RINGS,
            report,
        })
    }
}

/// Attempts a step until it moves nothing that sleeps. What would move wakes, with what is about it, more each time.
pub(crate) fn undisturbed(
    prediction: &mut Prediction,
    state: &mut State,
    mut attempt: impl FnMut(&mut Prediction, &mut State) -> Attempt,
) -> Result<Taken, StepFailure> {
    let (mut next, mut spent) = (1, Report::default());
    loop {
        match attempt(prediction, state) {
            Attempt::Outgrown(report) => return Ok(Taken::Outgrown(spent.then(report))),
            Attempt::Done(output) => {
                let all = |output: StepOutput| StepOutput {
                    solver: spent.then(output.solver),
                    ..output
                };
                return output.map(|output| Taken::Done(all(output)));
            }
            Attempt::Disturbed {
                spheres,
                rings,
                report,
            } => {
                spent = spent.then(report);
                let rings = rings.max(next);
                prediction.wake_around(&spheres, rings, state);
                next = 2 * rings;
            }
        }
    }
}

/// The bodies that sleep and have rows, ascending.
fn beside(assembly: &Assembly) -> Vec<u32> {
    let (rows, prediction) = (&assembly.problem.rows, assembly.prediction);
    if prediction.asleep.is_empty() {
        return Vec::new();
    }
    let bodies = (0..rows.len()).flat_map(|k| rows.bodies(k));
    let mut found: Vec<u32> = bodies
        .filter(|&body| prediction.body_sleeps(body))
        .collect();
    found.sort_unstable();
    found.dedup();
    found
}

/// Sums of forces on some bodies.
struct Sums<'a> {
    bodies: &'a [u32],
    /// Where each of all bodies is among these.
    rank: Vec<u32>,
    net: Vec<SpatialVector>,
    /// Of those that persist.
    smooth: Vec<SpatialVector>,
    /// Sum of the sizes of the contacts' forces \[N\].
    sizes: Vec<f64>,
}

impl<'a> Sums<'a> {
    /// Of `bodies`: their external forces.
    fn new(prediction: &Prediction, bodies: &'a [u32]) -> Self {
        let mut rank = vec![u32::MAX; prediction.clump_body(prediction.clumps.len())];
        for (k, &body) in bodies.iter().enumerate() {
            rank[body as usize] = k as u32;
        }
        let external = bodies.iter().map(|&body| prediction.external_force(body));
        let net: Vec<SpatialVector> = external.collect();
        Self {
            bodies,
            rank,
            smooth: net.clone(),
            net,
            sizes: vec![0.0; bodies.len()],
        }
    }

    /// Adds a force and torque if `body` is one of them: `size` \[N\] is that of the force, and `lasts` whether it is of no impact.
    fn add(&mut self, body: u32, force: &SpatialVector, (size, lasts): (f64, bool)) {
        if let Some(&k) = self.rank.get(body as usize)
            && k != u32::MAX
        {
            let k = k as usize;
            self.net[k] = self.net[k].plus(force, 1.0);
            if lasts {
                self.smooth[k] = self.smooth[k].plus(force, 1.0);
            }
            self.sizes[k] += size;
        }
    }

    /// Adds a contact that sleeps, with its couple \[N m\] on A.
    fn add_load(&mut self, prediction: &Prediction, load: &ContactForce, couple: Vec3) {
        let a = load.key.sphere as usize;
        let mut give = |i: usize, side: f64| {
            let (body, arm) = prediction.mover(i);
            if self.rank[body as usize] == u32::MAX {
                return;
            }
            let radius = prediction.scene.particles.radius[i];
            let arm = arm.unwrap_or_default() - load.normal * (side * radius);
            let force = SpatialVector {
                linear: load.force * side,
                angular: (arm.cross(&load.force) + couple) * side,
            };
            self.add(body, &force, (load.force.norm(), true));
        };
        give(a, 1.0);
        if let Partner::Sphere { index, .. } = load.key.partner {
            give(index as usize, -1.0);
        }
    }

    fn sleeper(
        &self,
        prediction: &Prediction,
        k: usize,
        (touched, tolerance): (bool, f64),
    ) -> Sleeper {
        let body = self.bodies[k];
        let [net, smooth] = [&self.net[k], &self.smooth[k]].map(|sum| prediction.felt(body, sum));
        let (sphere, centre, reach) = prediction.place_of(body);
        let off = net.linear.norm().max(net.angular.norm() / reach);
        let allowed = tolerance * self.sizes[k].max(prediction.weight(body));
        Sleeper {
            sphere,
            centre,
            net,
            smooth,
            touched,
            excess: off / allowed,
        }
    }
}

impl Prediction<'_> {
    /// Rank of the clump that a body is.
    fn clump_of(&self, body: u32) -> Option<usize> {
        (body as usize).checked_sub(self.clump_body(0))
    }

    /// Whether a body, of `[N + D + C]` or the ground, sleeps.
    pub(crate) fn body_sleeps(&self, body: u32) -> bool {
        match self.clump_of(body).and_then(|c| self.clumps.get(c)) {
            Some(clump) => self.is_asleep(clump.clump.members.start),
            None => self.is_asleep(body as usize),
        }
    }

    /// Whether a body is an obstacle alone: its own contacts may lead out of the step.
    fn is_obstacle(&self, body: u32) -> bool {
        !self.outside.is_empty() && self.outside.is_obstacle(self.place_of(body).0)
    }

    /// External force \[N\] and torque \[N m\] on a sphere or clump.
    fn external_force(&self, body: u32) -> SpatialVector {
        if let Some(c) = self.clump_of(body) {
            return self.clumps[c].external;
        }
        let i = body as usize;
        let (particles, acceleration) = (&self.scene.particles, &self.external[i]);
        SpatialVector {
            linear: acceleration.linear * particles.mass[i],
            angular: acceleration.angular * particles.inertia(i),
        }
    }

    /// What of a force and torque on a body its locks leave.
    fn felt(&self, body: u32, force: &SpatialVector) -> SpatialVector {
        match self.clump_of(body) {
            Some(_) => *force,
            None => {
                let [shifts, turns] = self.scene.particles.free(body as usize);
                SpatialVector {
                    linear: force.linear.component_mul(&shifts),
                    angular: force.angular.component_mul(&turns),
                }
            }
        }
    }

    /// The sphere, or first member of the clump, that a body is; its centre and its reach \[m\].
    fn place_of(&self, body: u32) -> (usize, Vec3, f64) {
        if let Some(c) = self.clump_of(body) {
            let clump = &self.clumps[c];
            let (centre, _) = clump.clump.place(&self.kinematics);
            return (clump.clump.members.start, centre, clump.clump.shape.reach());
        }
        let i = body as usize;
        (
            i,
            self.kinematics.position[i],
            self.scene.particles.radius[i],
        )
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::Arc;

    use super::*;
    use crate::contact::ContactId;
    use crate::parallel::Pool;
    use crate::scene::Scene;
    use crate::simulation::Simulation;
    use crate::state::Squeezed;
    use crate::step::linear_problem::linear_problem;
    use crate::step::prediction::{PredictionArrays, predict};
    use crate::step::{StepInput, Workspace};

    /// Three balls on each other and one apart; gravity alone acts.
    const SCENE: &str = r#"
[simulation]
duration = 1.0
rest_speed = 0.001
[[material]]
name = "rock"
density = 2500.0
[pair_default]
friction = 0.5
[[spheres]]
name = "balls"
material = "rock"
radius = 0.1
positions = [[0.0, 0.0, 0.1], [0.0, 0.0, 0.3], [0.0, 0.0, 0.5], [9.0, 0.0, 0.1]]
[[boundary]]
name = "floor"
material = "rock"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
"#;

    /// A failure at the ball apart wakes no pile on which another one is awake, unless the step can be cut no more or the ball is squeezed;
    /// one at the pile does.
    #[test]
    fn a_step_that_fails_wakes_what_is_near_alone() {
        let loaded = Scene::from_toml("scene", SCENE, Path::new(""));
        let scene = Arc::new(loaded.expect("a scene").scene);
        let mut simulation = Simulation::new(scene.clone()).expect("a start");
        simulation.advance_to(0.5).expect("steps");
        let mut state = State::clone(simulation.state());
        assert_eq!(state.asleep(), [true; 4]);
        state.calm[2] = 0;
        state.calm[3] = 0;
        let input = StepInput::still(&state, 1e-3);
        let mut workspace = Workspace::default();
        let mut prediction = predict(
            &scene,
            &state,
            &input,
            (PredictionArrays::default(), &Pool::default()),
        );
        let (assembly, _) = linear_problem(&mut prediction, &state, &mut workspace);
        let squeezed = Squeezed {
            sphere: 3,
            boundaries: [0, 0],
            by_others: true,
        };
        let woken_by = |sphere: Option<u32>, pinched, sweeps| {
            let boundary = Partner::Boundary {
                boundary: 0,
                feature: 0,
            };
            let failure = StepFailure {
                what: "gap",
                residual: 1.0,
                tolerance: 0.1,
                contact: sphere.map(|sphere| ContactId {
                    sphere,
                    partner: boundary,
                }),
                pinched,
                passed: None,
                broken: None,
            };
            let effort = Effort {
                sweeps,
                ..Effort::default()
            };
            let found =
                Attempt::failed_beside_sleepers(&assembly, &Err(failure), (&state, effort))?;
            let Attempt::Disturbed { spheres, rings, .. } = found else {
                panic!("not that they wake");
            };
            let near = assembly.prediction.around(&spheres, rings, &state);
            Some(near)
        };
        let woken = |sphere, sweeps| woken_by(sphere, None, sweeps);
        let pile = Some(vec![true, true, true, false]);
        assert_eq!(woken_by(Some(3), Some(squeezed), Some(10)), pile);
        assert_eq!(woken(Some(3), Some(10)), None);
        assert_eq!(woken(Some(2), Some(10)), pile);
        assert_eq!(woken(Some(3), None), pile);
        assert_eq!(woken(None, Some(10)), pile);
    }
}
