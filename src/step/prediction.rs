//! First stage of a step: everything that it knows before contacts, from the state and the input.

use super::StepInput;
use super::apart::Outside;
use super::boundary_motion::BoundaryMotion;
use super::clump::{Acting, ClumpPrediction};
use super::driven::BodyPrediction;
use super::external::{self, mean_acceleration};
use super::sphere_motion::SphereMotion;
use crate::Vec3;
use crate::parallel::Pool;
use crate::problem::Problem;
use crate::scene::particles::Kinematics;
use crate::scene::{Boundary, Command, Method, Scene};
use crate::spatial::{Pose, SpatialOperator, SpatialVector, Twist};
use crate::state::State;

/// Length of the step before over that of this one from which on its velocities count for this one \[-\].
const STEADY: f64 = 0.25;

/// Arrays of a [`Prediction`], kept for their memory alone.
#[derive(Debug, Default)]
pub(super) struct PredictionArrays {
    pub(super) kinematics: Kinematics,
    pub(super) external: Vec<SpatialVector>,
    pub(super) spheres: Vec<SphereMotion>,
    pub(super) outside: Outside,
}

/// What a step's problem is made from: places and velocities at its start, loads, where boundaries go.
#[derive(Debug)]
pub(super) struct Prediction<'a> {
    pub(super) scene: &'a Scene,
    /// What shares the work of the step.
    pub(super) pool: Pool,
    /// Time step \[s\].
    pub(super) step: f64,
    /// Places at the start, velocities that match `step`.
    pub(super) kinematics: Kinematics,
    /// External acceleration, `[N]`.
    pub(super) external: Vec<SpatialVector>,
    /// Which spheres are asleep, `[N]`; empty where none is.
    pub(super) asleep: Vec<bool>,
    /// The spheres as contacts see them, `[N]`.
    pub(super) spheres: Vec<SphereMotion>,
    /// Boundary poses at the start and at the end, `[B]`; those of driven bodies at the end are without contacts.
    pub(super) poses: [Vec<Pose>; 2],
    /// Motion of the boundaries between these poses, `[B]`.
    pub(super) motions: Vec<BoundaryMotion>,
    /// Driven bodies, `[D]`, by ascending boundary; boundaries that are not among them move as prescribed.
    pub(super) bodies: Vec<BodyPrediction<'a>>,
    /// Clumps, `[C]`; after driven bodies among all bodies.
    pub(super) clumps: Vec<ClumpPrediction<'a>>,
    /// Boundary twists over the previous step, `[B]`.
    pub(super) twists: Vec<Twist>,
    /// Velocities of the boundaries' surfaces against their shapes \[m/s\], world axes, `[B]`.
    pub(super) surfaces: Vec<Vec3>,
    /// Gravity \[m/s^2\].
    pub(super) gravity: Vec3,
    /// Its size.
    pub(super) gravity_size: f64,
    /// What contacts that carry load may open in the step \[m\].
    pub(super) opened: f64,
    /// Spring targets at the end of the step \[m\], `[S]`.
    pub(super) targets: Vec<Vec3>,
    /// [`mean_acceleration`] \[m/s^2\].
    pub(super) mean_acceleration: f64,
    /// Whether velocities before the step tell how it goes on: after a much shorter step they are noise.
    pub(super) steady: bool,
    /// Whether some contacts give way: by the penalty method, the `stiffness` of a boundary, or materials.
    pub(super) gives_way: bool,
    /// Whether the run starts: what touches is attached. Whether it also makes bonds: it has no contacts yet.
    pub(super) starts: bool,
    pub(super) makes_bonds: bool,
    /// What is left out though it is there.
    pub(super) outside: Outside,
}

/// Predicts the step that `input` asks for from `state`, in the memory of `arrays`; `pool` shares the work.
pub(super) fn predict<'a>(
    scene: &'a Scene,
    state: &State,
    input: &StepInput,
    (arrays, pool): (PredictionArrays, &Pool),
) -> Prediction<'a> {
    let dt = input.dt;
    let bodies = BodyPrediction::all(scene, state, &input.commands, dt);
    let mut ends = input.poses.clone();
    for body in &bodies {
        let b = body.boundary;
        ends[b] = body.moved(&state.poses[b], &body.free, dt);
    }
    let integrator = scene.settings.integrator;
    let PredictionArrays {
        mut kinematics,
        mut external,
        spheres,
        outside,
    } = arrays;
    let now = &state.kinematics;
    kinematics.present.clone_from(&now.present);
    kinematics.position.clone_from(&now.position);
    kinematics.orientation.clone_from(&now.orientation);
    kinematics.velocity.resize(now.len(), Vec3::zeros());
    kinematics.spin.resize(now.len(), Vec3::zeros());
    let shifted = |first: usize, (velocities, spins): (&mut [Vec3], &mut [Vec3])| {
        let bodies = (first..).zip(velocities.iter_mut().zip(spins));
        for (i, (velocity, spin)) in bodies {
            let (v, smooth) = (now.spatial_velocity(i), &state.smooth[i]);
            let v = integrator.shift_half_step(&v, smooth, state.last_step, dt);
            (*velocity, *spin) = (v.linear, v.angular);
        }
    };
    let velocities = (&mut kinematics.velocity[..], &mut kinematics.spin[..]);
    pool.pieces(velocities, shifted, |(), ()| ());
    let end_time = state.time + dt;
    let springs = scene.springs.iter();
    let target = springs.map(|s| s.target + s.motion.pose_at(end_time).translation);
    let gravity = state.gravity_at(scene, integrator.middle(state.time, dt));
    let memory = (&mut external, pool);
    external::acceleration(scene, state, &kinematics, (gravity, dt), memory);
    let mut prediction = Prediction {
        scene,
        pool: pool.clone(),
        step: dt,
        gravity,
        gravity_size: gravity.norm(),
        opened: scene.settings.opened(dt),
        mean_acceleration: mean_acceleration(scene, &external, &bodies),
        steady: state.last_step >= STEADY * dt,
        gives_way: gives_way(scene),
        starts: false,
        makes_bonds: false,
        spheres: SphereMotion::all(scene, &kinematics, (spheres, pool)),
        external,
        asleep: state.asleep(),
        clumps: ClumpPrediction::all(
            scene,
            &kinematics,
            Some(Acting {
                gravity,
                applied: &state.applied_forces,
                before: Some(state),
            }),
            dt,
        ),
        kinematics,
        targets: target.collect(),
        motions: motions(scene, &state.poses, &ends, dt),
        poses: [state.poses.clone(), ends],
        bodies,
        twists: state.twists.clone(),
        surfaces: surfaces(scene, state, &input.commands),
        outside,
    };
    prediction.accelerate_members();
    prediction
}

/// Velocities of the boundaries' surfaces against their shapes \[m/s\], world axes, `[B]`.
fn surfaces(scene: &Scene, state: &State, commands: &[Command]) -> Vec<Vec3> {
    let boundaries = scene.boundaries.iter();
    let driven = boundaries.zip(state.poses.iter().zip(commands));
    driven
        .map(|(boundary, (pose, command))| boundary.surface_velocity(pose, command))
        .collect()
}

/// Whether a scene has contacts that give way.
fn gives_way(scene: &Scene) -> bool {
    let elastic = |boundary: &Boundary| boundary.stiffness.is_some();
    scene.settings.method == Method::Penalty
        || scene.pairs.gives_way()
        || scene.boundaries.iter().any(elastic)
}

fn motions(scene: &Scene, from: &[Pose], to: &[Pose], dt: f64) -> Vec<BoundaryMotion> {
    let poses = from.iter().zip(to);
    let boundaries = scene.boundaries.iter().zip(poses);
    boundaries
        .map(|(boundary, (from, to))| BoundaryMotion::new(boundary.point_of_action, [from, to], dt))
        .collect()
}

impl<'a> Prediction<'a> {
    /// For the forces at the time of `state`, of the length `dt` \[s\].
    pub(super) fn at_rest(scene: &'a Scene, state: &State, dt: f64) -> Self {
        let gravity = state.gravity_at(scene, state.time);
        let external = external::at_start(scene, state, gravity);
        let bodies = BodyPrediction::all(scene, state, &state.commands, dt);
        let mut prediction = Self {
            scene,
            pool: Pool::default(),
            step: dt,
            gravity,
            gravity_size: gravity.norm(),
            opened: scene.settings.opened(dt),
            mean_acceleration: mean_acceleration(scene, &external, &bodies),
            steady: false,
            gives_way: gives_way(scene),
            starts: scene.pairs.coheres(),
            makes_bonds: state.contacts.is_empty(),
            spheres: SphereMotion::all(scene, &state.kinematics, (Vec::new(), &Pool::default())),
            external,
            asleep: Vec::new(),
            clumps: ClumpPrediction::all(
                scene,
                &state.kinematics,
                Some(Acting {
                    gravity,
                    applied: &state.applied_forces,
                    before: None,
                }),
                dt,
            ),
            kinematics: state.kinematics.clone(),
            targets: scene.springs.iter().map(|spring| spring.target).collect(),
            motions: motions(scene, &state.poses, &state.poses, dt),
            poses: [state.poses.clone(), state.poses.clone()],
            bodies,
            twists: state.twists.clone(),
            surfaces: surfaces(scene, state, &state.commands),
            outside: Outside::default(),
        };
        prediction.accelerate_members();
        prediction
    }

    /// For a displacement of spheres without velocities and forces.
    pub(super) fn still(scene: &'a Scene, state: &State) -> Self {
        let mut kinematics = state.kinematics.clone();
        kinematics.stop();
        let boundaries = state.poses.len();
        let external = vec![SpatialVector::ZERO; kinematics.len()];
        Self {
            scene,
            pool: Pool::default(),
            step: scene.settings.step,
            gravity: Vec3::zeros(),
            gravity_size: 0.0,
            opened: scene.settings.opened(scene.settings.step),
            mean_acceleration: mean_acceleration(scene, &external, &[]),
            steady: false,
            gives_way: gives_way(scene),
            starts: false,
            makes_bonds: false,
            spheres: SphereMotion::all(scene, &kinematics, (Vec::new(), &Pool::default())),
            external,
            asleep: Vec::new(),
            clumps: ClumpPrediction::all(scene, &kinematics, None, scene.settings.step),
            kinematics,
            targets: Vec::new(),
            motions: motions(scene, &state.poses, &state.poses, scene.settings.step),
            poses: [state.poses.clone(), state.poses.clone()],
            // Boundaries give way to no overlap.
            bodies: Vec::new(),
            twists: vec![Twist::default(); boundaries],
            surfaces: vec![Vec3::zeros(); boundaries],
            outside: Outside::default(),
        }
    }

    /// Makes `problem` one of these bodies: velocities without contacts, inverse masses. Its rows are of another one.
    pub(super) fn bodies(&self, problem: &mut Problem) {
        let particles = &self.scene.particles;
        let integrator = self.scene.settings.integrator;
        let spheres = 0..self.kinematics.len();
        problem.step = self.step;
        let velocity = |i| self.kinematics.spatial_velocity(i);
        let free = |i| match self.is_asleep(i) {
            true => SpatialVector::ZERO,
            false => integrator.free(&velocity(i), &self.external[i], self.step),
        };
        problem.free.resize(spheres.len(), SpatialVector::ZERO);
        self.pool.fill(&mut problem.free[..], free);
        problem
            .free
            .extend(self.bodies.iter().map(|body| body.free));
        for clump in &self.clumps {
            let own = match self.is_asleep(clump.clump.members.start) {
                true => SpatialVector::ZERO,
                false => clump.free,
            };
            problem.free.push(own);
            for (i, arm) in clump.arms() {
                problem.free[i] = SpatialVector {
                    linear: own.at(arm),
                    angular: own.angular,
                };
            }
        }
        // The same in every step where none sleeps: `Assembly::into_arrays` forgets those of sleepers.
        let inverse_mass = |i| match particles.clump(i).is_some() || self.is_asleep(i) {
            true => SpatialVector::ZERO,
            false => SpatialVector {
                linear: particles.inverse_mass(i) * integrator.mobility(),
                angular: particles.inverse_inertia(i) * integrator.mobility(),
            },
        };
        if problem.inverse_mass.len() != spheres.len() || !self.asleep.is_empty() {
            problem.inverse_mass.clear();
            problem.inverse_mass.extend(spheres.map(inverse_mass));
        }
        problem.operators.clear();
        let operators = self.bodies.iter().map(|body| body.mobility);
        let clumps =
            self.clumps
                .iter()
                .map(|clump| match self.is_asleep(clump.clump.members.start) {
                    true => SpatialOperator::zero(),
                    false => clump.mobility,
                });
        problem.operators.extend(operators.chain(clumps));
    }

    /// Its arrays, for the next step.
    pub(super) fn into_arrays(self) -> PredictionArrays {
        PredictionArrays {
            kinematics: self.kinematics,
            external: self.external,
            spheres: self.spheres,
            outside: self.outside,
        }
    }

    /// Rank and prediction of the driven body that a boundary is.
    pub(super) fn body(&self, boundary: usize) -> Option<(usize, &BodyPrediction<'a>)> {
        let rank = self
            .bodies
            .binary_search_by_key(&boundary, |body| body.boundary);
        rank.ok().map(|rank| (rank, &self.bodies[rank]))
    }

    /// Velocity of one body before the step, of `[N + D + C]`.
    pub(super) fn velocity(&self, i: usize) -> SpatialVector {
        match i.checked_sub(self.kinematics.len()) {
            None => self.kinematics.spatial_velocity(i),
            Some(rank) => match self.bodies.get(rank) {
                Some(body) => body.velocity,
                None => self.clumps[rank - self.bodies.len()].velocity,
            },
        }
    }

    /// [`Self::velocity`] of all bodies.
    pub(super) fn velocities(&self) -> Vec<SpatialVector> {
        let bodies = 0..self.clump_body(self.clumps.len());
        bodies.map(|i| self.velocity(i)).collect()
    }

    /// Boundary poses at the end of the step, `[B]`: prescribed ones, and those that driven bodies reach with the
    /// `velocity` of the bodies, `[N + D + C]`.
    pub(super) fn end_poses(&self, velocity: &[SpatialVector]) -> Vec<Pose> {
        let [start, end] = &self.poses;
        let mut ends = end.clone();
        let bodies = &velocity[self.kinematics.len()..];
        for (body, velocity) in self.bodies.iter().zip(bodies) {
            let b = body.boundary;
            ends[b] = body.moved(&start[b], velocity, self.step);
        }
        ends
    }

    /// Into `position` where the `velocity` of the bodies leads the spheres \[m\], `[N]`.
    pub(super) fn end_positions(&self, velocity: &[SpatialVector], position: &mut Vec<Vec3>) {
        let start = &self.kinematics.position;
        position.resize(start.len(), Vec3::zeros());
        let end = |i: usize| start[i] + velocity[i].linear * self.step;
        self.pool.fill(&mut position[..], end);
    }
}
