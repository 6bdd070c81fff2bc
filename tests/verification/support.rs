//! Small scenes written in code, and the momentum balance that every test checks in every step.

use std::sync::Arc;

use nalgebra::UnitQuaternion;
use sphere_dda::Vec3;
use sphere_dda::contact::elasticity::{Elastic, Elasticity};
use sphere_dda::geometry::{Facets, Geometry, HalfSpace, Revolution, Shape};
use sphere_dda::integrator::Integrator;
use sphere_dda::observe::Observation;
use sphere_dda::observe::energy::Energy;
use sphere_dda::observe::walls::{self, Interval};
use sphere_dda::scene::Motion;
use sphere_dda::scene::body::{Body, Joint};
use sphere_dda::scene::clump::{Clump, ClumpShape};
use sphere_dda::scene::gravity::GravityMotion;
use sphere_dda::scene::materials::{Material, Pair, PairTable};
use sphere_dda::scene::particles::{Kinematics, Locks, Particles};
use sphere_dda::scene::{Belt, Boundary};
use sphere_dda::scene::{Method, Output, Scene, Settings};
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::Tolerance;
use sphere_dda::spatial::SpatialVector;
use sphere_dda::spatial::cell::Cell;
use sphere_dda::spatial::{Pose, Twist};

/// Gravity of all cases \[m/s^2\].
pub const G: f64 = 9.81;

/// A scene under construction: one material for spheres, one for boundaries.
pub struct Case {
    pub scene: Scene,
}

impl Case {
    /// No bodies yet; the same friction and restitution for every pair.
    pub fn new(step: f64, friction: f64, restitution: f64) -> Self {
        let material = |name: &str| Material {
            name: name.into(),
            density: 2500.0,
        };
        let mut pairs = PairTable::new(2, Pair::default());
        for (a, b) in [(0, 0), (0, 1), (1, 1)] {
            pairs.set(
                a,
                b,
                Pair {
                    friction,
                    restitution,
                    ..Pair::default()
                },
            );
        }
        let settings = Settings {
            step,
            communication_step: step,
            tolerance: Tolerance::default(),
            opening: 0.0,
            strict: true,
            max_iterations: 4000,
            max_cuts: 6,
            ..Settings::default()
        };
        Self {
            scene: Scene {
                title: "case".into(),
                about: Default::default(),
                hash: "case".into(),
                settings,
                materials: vec![material("sphere"), material("wall")],
                pairs,
                particles: Particles::default(),
                clumps: vec![],
                initial: Kinematics::default(),
                initial_contacts: Default::default(),
                parameters: Vec::new(),
                cell: Cell::default(),
                boundaries: vec![],
                loads: vec![],
                springs: vec![],
                sources: vec![],
                sinks: vec![],
                sensors: vec![],
                probes: vec![],
                output: Output {
                    vtu_interval: 0.0,
                    csv_interval: 0.0,
                    float64: true,
                    checkpoint_interval: 0.0,
                },
                exposed: Default::default(),
            },
        }
    }

    pub fn settings(mut self, change: impl FnOnce(&mut Settings)) -> Self {
        change(&mut self.scene.settings);
        self
    }

    pub fn without_gravity(self) -> Self {
        self.settings(|s| s.gravity = Vec3::zeros())
    }

    pub fn tolerance(self, gap: f64, slip: f64, force: f64) -> Self {
        self.settings(|s| {
            s.tolerance.gap = gap;
            s.tolerance.slip = slip;
            s.tolerance.force = force;
        })
    }

    /// A sphere of density 2500 kg/m^3.
    pub fn sphere(self, radius: f64, position: Vec3, velocity: Vec3) -> Self {
        self.body(radius, position, velocity, Vec3::zeros(), Locks::default())
    }

    pub fn body(
        mut self,
        radius: f64,
        position: Vec3,
        velocity: Vec3,
        spin: Vec3,
        locks: Locks,
    ) -> Self {
        self.scene.particles.push(radius, 2500.0, 0, locks);
        self.scene.initial.push(position, velocity, spin);
        self
    }

    /// A clump at `position`, turned by `rotation`.
    pub fn clump(
        mut self,
        shape: &ClumpShape,
        (position, rotation): (Vec3, UnitQuaternion<f64>),
        velocity: Vec3,
        spin: Vec3,
    ) -> Self {
        let velocity = SpatialVector {
            linear: velocity,
            angular: spin,
        };
        let Scene {
            particles,
            initial,
            clumps,
            ..
        } = &mut self.scene;
        let store = (particles, initial, clumps);
        Clump::push(shape, 0, (position, rotation), &velocity, store);
        self
    }

    /// A fixed half-space through `point`, `normal` towards the spheres.
    pub fn plane(self, point: Vec3, normal: Vec3) -> Self {
        self.wall(vec![HalfSpace::new(point, normal).expect("a plane").into()])
    }

    /// A fixed boundary of these shapes.
    pub fn wall(self, shapes: Vec<Shape>) -> Self {
        self.moving(shapes, Motion::Fixed)
    }

    /// A boundary of these shapes that moves.
    pub fn moving(mut self, shapes: Vec<Shape>, motion: Motion) -> Self {
        self.scene.boundaries.push(Boundary {
            name: format!("wall{}", self.scene.boundaries.len()),
            material: 1,
            geometry: Geometry::new(shapes).expect("a geometry"),
            motion,
            point_of_action: Vec3::zeros(),
            stiffness: None,
            belt: None,
            wall_fields: false,
        });
        self
    }

    /// Rolling and twisting resistance of every pair.
    pub fn resistance(mut self, rolling_friction: f64, twisting_friction: f64) -> Self {
        for (a, b) in [(0, 0), (0, 1), (1, 1)] {
            let pair = Pair {
                rolling_friction,
                twisting_friction,
                ..self.scene.pairs.get(a, b)
            };
            self.scene.pairs.set(a, b, pair);
        }
        self
    }

    /// Spheres of a material that gives way as Hertz and Mindlin say, on walls that are rigid.
    pub fn elastic(self, young: f64, poisson: f64) -> Self {
        let ball = Some(Elastic { young, poisson });
        self.giving_way(0, 0, Elasticity::hertz([ball; 2]))
            .giving_way(0, 1, Elasticity::hertz([ball, None]))
    }

    /// Lets two materials give way.
    pub fn giving_way(mut self, a: u16, b: u16, elasticity: Option<Elasticity>) -> Self {
        let pair = Pair {
            elasticity,
            ..self.scene.pairs.get(a, b)
        };
        self.scene.pairs.set(a, b, pair);
        self
    }

    /// Makes the last boundary a belt, `velocity` in its own axes.
    pub fn belt(mut self, velocity: Vec3) -> Self {
        let boundary = self.scene.boundaries.last_mut().expect("a boundary");
        boundary.belt = Some(Belt {
            velocity,
            input: false,
        });
        self
    }

    /// A cylinder about the y axis, 2 m long, that turns with `speed` \[rad/s\] about it.
    pub fn drum(self, radius: f64, speed: f64) -> Self {
        let base = Vec3::y() * -1.0;
        let side = Revolution::cylinder(base, Vec3::y(), radius, 2.0).expect("a cylinder");
        let turning = Twist {
            linear: Vec3::zeros(),
            angular: Vec3::y() * speed,
        };
        self.moving(vec![Shape::Revolution(side)], Motion::Constant(turning))
    }

    /// Lets the last boundary keep what its triangles feel, with the wear coefficient \[1/Pa\] of every pair.
    pub fn felt(mut self, wear: f64) -> Self {
        let boundary = self.scene.boundaries.last_mut().expect("a boundary");
        boundary.wall_fields = true;
        for (a, b) in [(0, 0), (0, 1), (1, 1)] {
            let pair = Pair {
                wear,
                ..self.scene.pairs.get(a, b)
            };
            self.scene.pairs.set(a, b, pair);
        }
        self
    }

    /// A boundary of the given shapes that `body` moves; its point of action is the origin.
    pub fn driven(self, shapes: Vec<Shape>, body: Body) -> Self {
        self.moving(shapes, Motion::Driven(Box::new(body)))
    }

    pub fn floor(self) -> Self {
        self.plane(Vec3::zeros(), Vec3::z())
    }

    pub fn start(self) -> Run {
        let simulation = Simulation::new(Arc::new(self.scene)).expect("the case starts");
        Run { simulation }
    }
}

/// A body without loads, at rest, on which gravity acts; its principal axes are those of the scene.
pub fn body(mass: f64, centre: Vec3, moments: Vec3, joint: Joint) -> Body {
    Body {
        mass,
        centre,
        moments,
        axes: UnitQuaternion::identity(),
        joint,
        force: Vec3::zeros(),
        torque: Vec3::zeros(),
        servo: None,
        limits: [None; 2],
        spring: None,
        damping: [0.0; 2],
        gravity: true,
        hold_while_settling: false,
        pose: Pose::default(),
        start_position: 0.0,
        twist: Twist::default(),
        input: false,
    }
}

/// A running case.
pub struct Run {
    pub simulation: Simulation,
}

impl Run {
    pub fn position(&self, i: usize) -> Vec3 {
        self.simulation.kinematics().position[i]
    }

    pub fn velocity(&self, i: usize) -> Vec3 {
        self.simulation.velocity(i).linear
    }

    pub fn spin(&self, i: usize) -> Vec3 {
        self.simulation.velocity(i).angular
    }

    pub fn force_on_boundary(&self, b: usize) -> Vec3 {
        self.simulation.wrench(b).force
    }

    pub fn mass(&self, i: usize) -> f64 {
        self.simulation.scene().particles.mass[i]
    }

    /// Normal force of the only contact; zero without one.
    pub fn normal_force(&self) -> f64 {
        match &self.simulation.contacts()[..] {
            [] => 0.0,
            [contact] => contact.force.dot(&contact.normal),
            more => panic!("{} contacts", more.len()),
        }
    }

    /// Momentum of the half-step velocities \[N s\], which balances also where a step was cut.
    pub fn momentum(&self) -> Vec3 {
        let masses = self.simulation.scene().particles.mass.iter().enumerate();
        masses
            .map(|(i, m)| self.simulation.half_step_velocity(i).linear * *m)
            .sum()
    }

    /// Angular momentum of the half-step velocities about the origin \[N m s\].
    pub fn angular_momentum(&self) -> Vec3 {
        let particles = &self.simulation.scene().particles;
        (0..particles.len())
            .map(|i| {
                let v = self.simulation.half_step_velocity(i);
                self.position(i).cross(&(v.linear * particles.mass[i]))
                    + v.angular * particles.inertia(i)
            })
            .sum()
    }

    /// Kinetic energy of the reported velocities \[J\].
    pub fn kinetic(&self) -> f64 {
        let particles = &self.simulation.scene().particles;
        (0..particles.len())
            .map(|i| {
                let v = self.simulation.velocity(i);
                0.5 * particles.mass[i] * v.linear.norm_squared()
                    + 0.5 * particles.inertia(i) * v.angular.norm_squared()
            })
            .sum()
    }

    /// Kinetic energy and the potential of gravity \[J\].
    pub fn energy(&self) -> f64 {
        let masses = self.simulation.scene().particles.mass.iter().enumerate();
        let gravity = self.simulation.gravity();
        let potential: f64 = masses
            .map(|(i, m)| -m * gravity.dot(&self.position(i)))
            .sum();
        self.kinetic() + potential
    }

    /// Energy of spheres and driven bodies, springs and loads included \[J\].
    pub fn whole_energy(&self) -> Energy {
        Energy::of(&Observation::of(&self.simulation))
    }

    /// One step of the scene, with the balance of linear momentum and the true overlaps: boundary forces, weight, loads and
    /// springs are the rate of momentum, to 1e-9 of all impulses (free spheres, integrator `moreau`, also where steps are
    /// cut); no overlap exceeds the gap tolerance.
    pub fn step(&mut self) {
        self.advance(self.simulation.scene().settings.step);
    }

    pub fn advance(&mut self, h: f64) {
        let bodies = self.bodies();
        let last = self.simulation.state().last_step;
        let end = self.simulation.time() + h;
        let communication = self.simulation.begin(end).expect("a communication step");
        // The first one says how far back the velocities lie.
        let before = self.momentum();
        let finished = self.simulation.finish(communication);
        finished.expect("the step converges");
        let scene = Arc::clone(self.simulation.scene());
        if scene.settings.method == Method::Alm {
            let overlap = self.simulation.report().max_overlap;
            assert!(
                overlap <= scene.settings.tolerance.gap,
                "overlap {overlap:e} R at {} s",
                self.simulation.time()
            );
        }
        self.check_walls();
        let locked = scene
            .particles
            .locks
            .iter()
            .any(|l| l.translation.iter().any(|x| *x));
        if scene.settings.integrator == Integrator::Shi {
            return;
        }
        let step = scene.settings.step;
        let now = self.simulation.state().last_step;
        if (last - now).abs() <= 1e-12 * h && (now - step).abs() <= 1e-12 * h {
            self.check_bodies(&bodies, h);
        }
        let cut = self.simulation.report().internal_steps > 1;
        if locked || (cut && !scene.springs.is_empty()) {
            return;
        }
        let mass = scene.particles.mass.iter();
        let weight: Vec3 = mass.map(|m| self.simulation.gravity() * *m).sum();
        let applied = self.simulation.state().applied_forces.iter();
        let loads = scene.loads.iter().map(|load| &load.force);
        let loads: Vec3 = loads.chain(applied).sum();
        let body_force = self.simulation.mean_body_force();
        let settings = &scene.settings;
        let constant = settings.gravity_motion == GravityMotion::Fixed
            && self.simulation.gravity() == settings.gravity;
        if constant && settings.rotating_frame.is_none() {
            let error = (body_force - weight - loads).norm();
            assert!(error <= 1e-12 * (weight.norm() + loads.norm()), "{error:e}");
        }
        let springs: Vec3 = self.simulation.state().springs.iter().sum();
        let walls: Vec3 = (0..scene.boundaries.len())
            .map(|b| -self.simulation.mean_wrench(b).force)
            .sum();
        let force = body_force + springs + walls;
        let scale: f64 = weight.norm()
            + self
                .simulation
                .contacts()
                .iter()
                .map(|c| c.force.norm())
                .sum::<f64>()
            + loads.norm()
            + springs.norm()
            + before.norm() / h;
        let error = (self.momentum() - before - force * h).norm();
        // Opposite momenta cancel to rounding only.
        let particles = &scene.particles;
        let rounded =
            |i: usize| particles.mass[i] * (self.velocity(i).norm() + particles.radius[i] / h);
        let rounding = f64::EPSILON * (0..particles.len()).map(rounded).sum::<f64>();
        assert!(
            error <= 1e-9 * scale * h + rounding,
            "momentum is off by {error:e} of {:e} N s",
            scale * h
        );
    }

    /// The tractions of a boundary's triangles add up to its average force.
    pub fn check_walls(&self) {
        let state = Observation::of(&self.simulation);
        for (b, boundary) in state.boundaries.iter().enumerate() {
            let triangles = walls::readings(&state, b, Interval::Step);
            if triangles.is_empty() {
                continue;
            }
            let sum: Vec3 = triangles.iter().map(|t| t.load.force).sum();
            let scale: f64 = triangles.iter().map(|t| t.load.force.norm()).sum();
            let error = (sum - boundary.mean_wrench.force).norm();
            assert!(
                error <= 1e-12 * scale.max(boundary.mean_wrench.force.norm()),
                "boundary {b}: tractions miss {error:e} N of {scale:e} N at {} s",
                state.time
            );
        }
    }

    /// Momentum and angular momentum about the reference point of each driven body, and its pose.
    fn bodies(&self) -> Vec<(SpatialVector, Pose)> {
        let scene = self.simulation.scene();
        let carried = self.simulation.state().bodies.iter();
        carried
            .zip(scene.driven())
            .map(|(carried, (b, _))| (carried.momentum, self.simulation.boundary_pose(b)))
            .collect()
    }

    /// The momentum of driven bodies without damper and outside load changes by weight, loads and the contacts' wrench; of a
    /// free one also the angular momentum. Only in a step that was not cut do all torques act at the start.
    fn check_bodies(&self, before: &[(SpatialVector, Pose)], h: f64) {
        let scene = self.simulation.scene();
        let driven = scene.driven().zip(before).zip(self.bodies());
        for (((b, body), (old, start)), (new, _)) in driven {
            if body.damping != [0.0; 2] || body.input || body.servo.is_some() {
                continue;
            }
            let mut wrench = self.simulation.mean_wrench(b);
            if body.limits != [None; 2] || body.spring.is_some() {
                // What stops and springs exert is known of the last internal step only.
                let Joint::Slide { axis } = body.joint else {
                    continue;
                };
                if self.simulation.report().internal_steps > 1 {
                    continue;
                }
                wrench.force += axis * self.simulation.joint(b).force;
            }
            let weight = scene.settings.gravity * body.mass;
            let force = weight * f64::from(u8::from(body.gravity)) + body.force + wrench.force;
            let scale = weight.norm() + body.force.norm() + wrench.force.norm();
            let scale = h * (scale + (old.linear.norm() + new.linear.norm()) / h);
            let error = match body.joint {
                Joint::Free => (new.linear - old.linear - force * h).norm(),
                Joint::Slide { axis } => (new.linear - old.linear - force * h).dot(&axis).abs(),
                Joint::Hinge { .. } => 0.0,
            };
            assert!(
                error <= 1e-9 * scale,
                "body {b}: momentum is off by {error:e} N s"
            );
            if !matches!(body.joint, Joint::Free) || self.simulation.report().internal_steps > 1 {
                continue;
            }
            let arm = start.rotation * (scene.boundaries[b].point_of_action - body.centre);
            let torque = wrench.torque + body.torque + arm.cross(&(wrench.force + body.force));
            let scale = (torque.norm() + wrench.torque.norm()) * h + old.angular.norm();
            let error = (new.angular - old.angular - torque * h).norm();
            assert!(
                error <= 1e-9 * scale,
                "body {b}: angular momentum is off by {error:e} N m s"
            );
        }
    }

    pub fn steps(&mut self, n: usize) {
        for _ in 0..n {
            self.step();
        }
    }
}

/// Asserts `|found - expected| <= relative * max(|expected|, scale)`.
#[track_caller]
pub fn close(found: f64, expected: f64, relative: f64, scale: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= relative * expected.abs().max(scale),
        "found {found:.15e}, expected {expected:.15e}, error {error:e}"
    );
}

/// A mesh over a grid of points `at(i, j)`, `0 <= i <= n`, `0 <= j <= m`, each cell cut in two triangles.
pub fn grid(n: u32, m: u32, at: impl Fn(u32, u32) -> Vec3) -> Facets {
    let number = |i: u32, j: u32| j * (n + 1) + i;
    let vertices = (0..=m).flat_map(|j| (0..=n).map(move |i| (i, j)));
    let cells = (0..m).flat_map(|j| (0..n).map(move |i| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let [a, b, c, d] =
            [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| number(i, j));
        [[a, b, c], [a, c, d]]
    });
    Facets::mesh(
        "grid",
        vertices.map(|(i, j)| at(i, j)).collect(),
        triangles.collect(),
    )
}

/// The order `log(coarse / fine) / log(ratio)` of an error when the step shrinks by `ratio`.
pub fn order(coarse: f64, fine: f64, ratio: f64) -> f64 {
    (coarse / fine).ln() / ratio.ln()
}
