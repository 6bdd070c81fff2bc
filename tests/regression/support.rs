//! Small scenes as text, and what the tests measure of them.

use std::fmt::Write as _;
use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::observe::Observation;
use sphere_dda::observe::energy::Energy;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

/// Gravity of all cases \[m/s^2\].
pub const G: f64 = 9.81;

/// A scene file under construction: one material of 2500 kg/m^3, steps of one length, tolerances of 1e-9.
#[derive(Clone)]
pub struct Case {
    simulation: String,
    pair: String,
    rest: String,
    groups: usize,
    boundaries: usize,
    tolerance: f64,
}

/// A vector as TOML writes it.
pub fn list(x: Vec3) -> String {
    format!("[{:?}, {:?}, {:?}]", x.x, x.y, x.z)
}

impl Case {
    pub fn new(step: f64) -> Self {
        Self {
            simulation: format!(
                "duration = 100.0\nstep = {step:?}\ncommunication_step = {step:?}\nfixed_step = true\nstrict = true\n"
            ),
            pair: String::new(),
            rest: String::new(),
            groups: 0,
            boundaries: 0,
            tolerance: 1e-9,
        }
    }

    /// Tolerances of gap, slip and force.
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Steps that do not converge are taken as they are.
    pub fn loose(mut self) -> Self {
        self.simulation = self.simulation.replace("strict = true", "strict = false");
        self
    }

    /// A line of `[simulation]`.
    pub fn set(mut self, line: &str) -> Self {
        self.simulation += line;
        self.simulation.push('\n');
        self
    }

    pub fn gravity(self, gravity: Vec3) -> Self {
        self.set(&format!("gravity = {}", list(gravity)))
    }

    /// Friction and restitution of all contacts.
    pub fn contact(mut self, friction: f64, restitution: f64) -> Self {
        self.pair = format!("friction = {friction:?}\nrestitution = {restitution:?}\n");
        self
    }

    /// More lines of `[pair_default]`.
    pub fn pair(mut self, line: &str) -> Self {
        self.pair += line;
        self.pair.push('\n');
        self
    }

    /// One sphere: radius, centre, velocity, spin. It is the group `sK`, K from 0.
    pub fn sphere(self, radius: f64, x: Vec3, v: Vec3, w: Vec3) -> Self {
        let text = format!(
            "radius = {radius:?}\npositions = [{}]\nvelocity = {}\nspin = {}\n",
            list(x),
            list(v),
            list(w)
        );
        self.spheres(&text)
    }

    /// A group of spheres by its keys.
    pub fn spheres(mut self, text: &str) -> Self {
        let k = self.groups;
        self.groups += 1;
        // Writing to a String cannot fail.
        let _ = write!(
            self.rest,
            "[[spheres]]\nname = \"s{k}\"\nmaterial = \"m\"\n{text}\n"
        );
        self
    }

    /// A boundary of one face with more of its keys. It is `bK`, K from 0.
    pub fn boundary(mut self, face: &str, more: &str) -> Self {
        let k = self.boundaries;
        self.boundaries += 1;
        let _ = write!(
            self.rest,
            "[[boundary]]\nname = \"b{k}\"\nmaterial = \"m\"\nfaces = [{{ {face} }}]\n{more}\n"
        );
        self
    }

    /// Another table of the scene.
    pub fn table(mut self, text: &str) -> Self {
        self.rest += text;
        self
    }

    /// A fixed plane through `point`.
    pub fn plane(self, point: Vec3, normal: Vec3) -> Self {
        let face = format!(
            "plane = {{ point = {}, normal = {} }}",
            list(point),
            list(normal)
        );
        self.boundary(&face, "")
    }

    pub fn floor(self) -> Self {
        self.plane(Vec3::zeros(), Vec3::z())
    }

    pub fn text(&self) -> String {
        let Self {
            simulation,
            pair,
            rest,
            tolerance: t,
            ..
        } = self;
        format!(
            "[simulation]\n{simulation}tolerance = {{ gap = {t:?}, slip = {t:?}, force = {t:?}, opening = 0.0 }}\n\
             [[material]]\nname = \"m\"\ndensity = 2500.0\n[pair_default]\n{pair}\n{rest}"
        )
    }

    pub fn scene(&self) -> Scene {
        let text = self.text();
        match Scene::from_toml("case", &text, Path::new("")) {
            Ok(loaded) => loaded.scene,
            Err(error) => panic!("{error}\n{text}"),
        }
    }

    pub fn start(&self) -> Run {
        let simulation = Simulation::new(Arc::new(self.scene())).expect("the case starts");
        Run { simulation }
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

    pub fn mass(&self, i: usize) -> f64 {
        self.simulation.scene().particles.mass[i]
    }

    /// Takes a step of the scene.
    pub fn step(&mut self) {
        let step = self.simulation.scene().settings.step;
        self.simulation.advance(step).expect("the step converges");
    }

    pub fn steps(&mut self, count: usize) {
        for _ in 0..count {
            self.step();
        }
    }

    /// Steps until `time` \[s\].
    pub fn until(&mut self, time: f64) {
        let step = self.simulation.scene().settings.step;
        let count = ((time - self.simulation.time()) / step).round() as usize;
        self.steps(count);
    }

    /// Kinetic energy and potentials \[J\].
    pub fn energy(&self) -> Energy {
        Energy::of(&Observation::of(&self.simulation))
    }

    /// All mechanical energy \[J\].
    pub fn total(&self) -> f64 {
        let energy = self.energy();
        energy.kinetic() + energy.potential()
    }

    /// Largest gap of a contact that carries load \[m\].
    pub fn opening(&self) -> f64 {
        let contacts = self.simulation.contacts();
        contacts
            .iter()
            .map(|c| c.gap)
            .fold(f64::NEG_INFINITY, f64::max)
    }
}

/// The order at which errors of two steps, the second half the first, vanish.
pub fn order(errors: [f64; 2]) -> f64 {
    (errors[0] / errors[1]).log2()
}
