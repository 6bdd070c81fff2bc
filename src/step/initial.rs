//! The start of a run: overlaps out by displacement, contact forces at rest.

use super::assemble::joint::JointConstraint;
use super::assembly::Assembly;
use super::prediction::{Prediction, surfaces};
use super::replicas::{self, ReplicaPair};
use super::workspace::Workspace;
use super::{Effort, StepFailure, external};
use crate::Vec3;
use crate::detection::configuration::Configuration;
use crate::parallel::Pool;
use crate::problem::{Law, Row, retain};
use crate::scene::{Method, Scene};
use crate::spatial::{SpatialVector, Twist};
use crate::state::State;
use crate::step::assemble::SphereMotion;
use crate::step::driven::BodyPrediction;

/// Force residual at t = 0: forces at rest balance the weight, whatever the steps are asked for \[-\].
const AT_REST: f64 = 1e-8;

/// Contact forces at t = 0 from the acceleration-level problem: closed contacts that neither approach nor part
/// must not accelerate into each other. Leaves them and the persisting accelerations in `state`, and replica it in `pairs`.
///
/// # Errors
/// [`StepFailure`] if that problem has no solution within the tolerances.
pub fn initial_forces(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
    pairs: &mut [[&mut State; 2]],
) -> Result<(), StepFailure> {
    let dt = 0.5 * scene.settings.step;
    let start = Prediction::at_rest(scene, state, dt);
    let starts = each(pairs, |state| Prediction::at_rest(scene, state, dt));
    let mut stage = Assembly::new(start.inputs(scene, dt), state, workspace);
    let mut replicas = replicas(&stage, scene, dt, &starts, pairs);
    let resting = stage.resting(scene);
    for side in replicas.iter_mut().flat_map(|pair| &mut pair.stages) {
        side.keep(&resting);
    }
    stage.keep(&resting);
    let report = stage.solve((state, effort(scene)), workspace, None);
    if scene.settings.method == Method::Alm && scene.settings.strict && !report.converged {
        return Err(stage.failure(&report));
    }
    if scene.settings.method == Method::Alm {
        stage.polish(state, workspace, AT_REST);
    }
    replicas::follow(&stage, &mut replicas).map_err(|broken| stage.broken(&report, broken))?;
    for ((pair, starts), states) in replicas.iter().zip(&starts).zip(pairs) {
        for (k, side) in pair.stages.iter().enumerate() {
            side.store_start(states[k], &starts[k].external);
        }
    }
    stage.store_start(state, &start.external);
    Ok(())
}

/// There is no shorter step at the start: the best iterate is taken, unless the scene is strict.
fn effort(scene: &Scene) -> Effort {
    Effort {
        accept: !scene.settings.strict,
        ..Effort::default()
    }
}

/// One of something for each state.
fn each<T>(pairs: &[[&mut State; 2]], of: impl Fn(&State) -> T) -> Vec<[T; 2]> {
    let pair = |pair: &[&mut State; 2]| [0, 1].map(|k| of(&*pair[k]));
    pairs.iter().map(pair).collect()
}

fn replicas<'a>(
    stage: &Assembly,
    scene: &'a Scene,
    dt: f64,
    starts: &'a [[Prediction<'a>; 2]],
    pairs: &[[&mut State; 2]],
) -> Vec<ReplicaPair<'a>> {
    let pair = |(starts, pair): (&'a [Prediction<'a>; 2], &[&mut State; 2])| ReplicaPair {
        stages: [0, 1].map(|k| Assembly::replica(stage, starts[k].inputs(scene, dt), &*pair[k])),
    };
    starts.iter().zip(pairs).map(pair).collect()
}

/// Removes overlaps at t = 0 by the smallest displacement (in the mass metric) that closes no other gap; leaves the
/// largest overlap found in `state.initial_overlap`. The penalty method keeps its overlaps. `pairs` do as `state` does.
///
/// # Errors
/// [`StepFailure`] if no such displacement is found.
pub fn remove_overlaps(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
    pairs: &mut [[&mut State; 2]],
) -> Result<(), StepFailure> {
    let configuration = Configuration::of(scene, &state.kinematics, &state.poses);
    workspace.neighbors.ensure(&configuration, &[], 0.0);
    let mut closed = Vec::new();
    state.initial_overlap =
        configuration.overlaps(&workspace.neighbors, 0.0, &Pool::default(), &mut closed);
    if scene.settings.method == Method::Penalty
        || state.initial_overlap <= scene.settings.tolerance.gap
    {
        return Ok(());
    }
    let dt = scene.settings.step;
    let start = Prediction::still(scene, state);
    let starts = each(pairs, |state| Prediction::still(scene, state));
    let mut stage = Assembly::new(start.inputs(scene, dt), state, workspace);
    let mut replicas = replicas(&stage, scene, dt, &starts, pairs);
    for side in replicas.iter_mut().flat_map(|pair| &mut pair.stages) {
        side.displace();
    }
    stage.displace();
    stage.resolve((state, effort(scene)), workspace, &mut replicas)?;
    for (pair, states) in replicas.iter().zip(pairs) {
        for (side, state) in pair.stages.iter().zip(states) {
            let solution = side.problem.velocities(&side.impulses);
            state.kinematics.position = side.moved(&solution);
        }
    }
    state.kinematics.position = stage.position;
    Ok(())
}

impl<'s> Prediction<'s> {
    /// For the forces at the time of `state`.
    fn at_rest(scene: &'s Scene, state: &State, dt: f64) -> Self {
        let gravity = state.gravity_at(scene, state.time);
        let external = external::at_start(scene, &state.kinematics, gravity);
        Self {
            spheres: SphereMotion::all(scene, &state.kinematics, Vec::new()),
            external,
            kinematics: state.kinematics.clone(),
            gravity,
            targets: scene.springs.iter().map(|spring| spring.target).collect(),
            standing: state.poses.clone(),
            ends: state.poses.clone(),
            bodies: BodyPrediction::all(scene, state, &state.commands, dt),
            twists: state.twists.clone(),
            surfaces: surfaces(scene, state, &state.commands),
        }
    }

    /// For a displacement of spheres without velocities and forces.
    fn still(scene: &Scene, state: &State) -> Self {
        let mut kinematics = state.kinematics.clone();
        kinematics.stop();
        let boundaries = state.poses.len();
        let external = vec![SpatialVector::ZERO; kinematics.len()];
        Self {
            spheres: SphereMotion::all(scene, &kinematics, Vec::new()),
            external,
            kinematics,
            gravity: Vec3::zeros(),
            targets: Vec::new(),
            standing: state.poses.clone(),
            ends: state.poses.clone(),
            // Walls give way to no overlap.
            bodies: Vec::new(),
            twists: vec![Twist::default(); boundaries],
            surfaces: vec![Vec3::zeros(); boundaries],
        }
    }
}

impl Assembly<'_> {
    /// Leaves contacts without friction, for a displacement.
    fn displace(&mut self) {
        self.problem.rows.truncate(self.candidates.len());
        self.impulses.truncate(self.candidates.len());
        let frictionless = |_, row: &mut Row| row.law = Law::Contact { mu: 0.0 };
        self.problem.rows.update_all(frictionless);
        self.moves = false;
    }

    /// Forces at t = 0 into `state`.
    fn store_start(&self, state: &mut State, external: &[SpatialVector]) {
        self.store(state);
        state.springs = self.spring_forces();
        let solution = self.problem.velocities(&self.impulses);
        self.persisting_acceleration(&solution, &mut state.smooth);
        external::keep(self.inputs.scene, state, external);
        let at_rest = self.finished(&solution, self.inputs.poses[0]);
        for (carried, (found, _)) in state.bodies.iter_mut().zip(at_rest) {
            carried.smooth = found.smooth;
            carried.joint_forces = found.joint_forces;
        }
    }

    /// Whether each row is kept: of the candidates those that are closed and neither approach nor part.
    fn resting(&self, scene: &Scene) -> Vec<bool> {
        let velocity = self.before();
        let mut weight = scene.settings.gravity.norm();
        if scene.settings.rotating_frame.is_some() {
            let external = self.inputs.external.iter().map(|a| a.linear.norm());
            weight = external.fold(weight, f64::max);
        }
        let creep = weight * self.inputs.step;
        let settings = &scene.settings;
        // A step leaves a loaded contact open by what it may carry, and its own error.
        let closed = (settings.tolerance.gap + settings.opening).max(1e-9);
        let rests = |k: usize| {
            let row = self.problem.rows.get(k);
            self.candidates[k].gap <= closed * row.radius
                && row.normal.dot(&row.relative_velocity(&velocity)).abs() <= 1e-3 * creep
        };
        let stop_rests = |joint: &JointConstraint, row: &Row| {
            joint.limit.distance <= closed * row.radius
                && row.normal.dot(&row.relative_velocity(&velocity)).abs() <= 1e-3 * creep
        };
        (0..self.problem.rows.len())
            .map(|k| match (self.contact_of(k), self.joint(k)) {
                (Some(contact), _) => rests(contact),
                (None, Some(joint)) if joint.limit.stops() => {
                    stop_rests(joint, &self.problem.rows.get(k))
                }
                _ => true,
            })
            .collect()
    }

    /// Keeps these rows. Their contacts may not accelerate into each other: with zero gap, less what sliding over a curved
    /// surface opens or closes by itself, `g(t) = g + dt n.u + ...`.
    fn keep(&mut self, keep: &[bool]) {
        let velocity = self.before();
        let first = self.first_joint();
        for (k, joint) in (first..).zip(&mut self.joints) {
            if joint.limit.stops() {
                self.problem.rows.update(k, |row| row.bias = Vec3::zeros());
                joint.impact = false;
            }
        }
        retain(&mut self.joints, &keep[first..]);
        self.problem.rows.bind(|contact| {
            let before = &keep[..*contact as usize];
            *contact = before.iter().filter(|kept| **kept).count() as u32;
        });
        let step = self.inputs.step;
        let position = self.moved(&velocity);
        let slid = Configuration {
            position: &position,
            ..self.start
        };
        for (k, candidate) in self.candidates.iter().enumerate() {
            if self.problem.rows.compliance(k) == 0.0 {
                self.problem.rows.update(k, |row| {
                    let linear = step * row.normal.dot(&row.relative_velocity(&velocity));
                    let curved = slid.follow(candidate).gap - candidate.gap - linear;
                    row.bias = row.normal * (2.0 * curved / step);
                });
            }
        }
        self.impact.fill(false);
        retain(&mut self.impulses, keep);
        self.problem.rows.retain(keep);
        retain(&mut self.candidates, keep);
        self.impact.truncate(self.candidates.len());
    }
}
