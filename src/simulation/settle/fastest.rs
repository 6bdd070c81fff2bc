//! What moves fastest in a scene that should come to rest.

use std::fmt;

use crate::Vec3;
use crate::scene::line_of_sight::Wall;
use crate::simulation::Simulation;
use crate::simulation::trajectory::displacement;

/// A time \[s\] in which no body turns: over it a displacement is a speed.
const INSTANT: f64 = 1e-9;

/// What moves fastest.
#[derive(Debug, Clone, PartialEq)]
pub enum Fastest {
    /// A sphere.
    Sphere {
        /// Its number.
        index: usize,
        /// Its centre \[m\].
        position: Vec3,
        /// Whether no boundary lies below it along gravity: it falls for good.
        lost: bool,
    },
    /// A driven body.
    Body {
        /// Name of its boundary.
        boundary: String,
    },
}

impl fmt::Display for Fastest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sphere {
                index,
                position,
                lost,
            } => {
                let [x, y, z]: [f64; 3] = (*position).into();
                write!(f, "sphere {index} at ({x:.4}, {y:.4}, {z:.4}) m")?;
                match lost {
                    true => write!(
                        f,
                        ", which has left all boundaries and falls with nothing below it"
                    ),
                    false => Ok(()),
                }
            }
            Self::Body { boundary } => write!(f, "the body of boundary `{boundary}`"),
        }
    }
}

/// A sphere or the body of a boundary, by its number.
#[derive(Debug, Clone, Copy)]
pub(super) enum Mover {
    Sphere(usize),
    Body(usize),
}

impl Simulation {
    /// Largest speed \[m/s\] of a centre or of a surface about its centre, or of a driven body, and of what it is.
    pub(super) fn fastest(&self) -> (f64, Option<Mover>) {
        let radius = &self.scene.particles.radius;
        let driven = self.scene.driven().map(|(b, _)| {
            let (pose, twist) = (&self.state.poses[b], self.boundary_twist(b));
            let moved = displacement(
                &self.scene.boundaries[b],
                [pose, &pose.advanced(&twist, INSTANT)],
                std::iter::empty(),
            );
            (moved / INSTANT, Mover::Body(b))
        });
        let spheres = (0..radius.len()).map(|i| {
            let twist = self.velocity(i);
            let speed = twist.linear.norm().max(radius[i] * twist.angular.norm());
            (speed, Mover::Sphere(i))
        });
        spheres
            .chain(driven)
            .fold((0.0, None), |(most, who), (speed, mover)| {
                match speed > most {
                    true => (speed, Some(mover)),
                    false => (most, who),
                }
            })
    }

    /// What to say of a mover.
    pub(super) fn describe(&self, mover: Mover) -> Fastest {
        let scene = &self.scene;
        match mover {
            Mover::Body(b) => Fastest::Body {
                boundary: scene.boundaries[b].name.clone(),
            },
            Mover::Sphere(index) => {
                let position = self.state.kinematics.position[index];
                let walls = scene.boundaries.iter().zip(&self.state.poses);
                let mut walls = walls.map(|(boundary, pose)| Wall::new(boundary, *pose));
                let down = self.gravity().try_normalize(0.0);
                Fastest::Sphere {
                    index,
                    position,
                    lost: down
                        .is_some_and(|down| !walls.any(|wall| wall.meets(scene, position, down))),
                }
            }
        }
    }
}
