//! Sphere-based three-dimensional discontinuous deformation analysis (DDA) with
//! augmented-Lagrangian contact.
//!
//! Source of the method: S. A. R. Beyabanaki and A. C. Bagtzoglou, *Modified contact constraints in
//! sphere-based 3-D DDA*, American Journal of Engineering Research 9(4), 2020, pp. 171-180
//! ("the paper" in these pages).
//!
//! # What is solved
//!
//! Rigid spheres `i` with centre `c` \[m\], radius `R` \[m\], mass `m = 4/3 pi rho R^3` \[kg\] and moment of
//! inertia `I = 2/5 m R^2` \[kg m^2\] move by the increment `D = (u, r)`: three translations \[m\] and three
//! rotations \[rad\]. Every time step finds the increment and the contact multipliers `p` that satisfy
//!
//! ```text
//! K D = F                                   equilibrium of the step        (paper eq 5)
//! 0 <= p_n  perpendicular to  d_n >= 0      unilateral normal contact      (paper eq 8, projected)
//! p_t = Proj_{|.| <= mu p_n}(p_t - P_t d_t) Coulomb friction, exact cone
//! m   = Proj_{|m_r| <= mu_r R* p_n, |m_n| <= mu_t R* p_n}(m - P_r d_r)
//!                                           rolling and twisting resistance, optional
//! d_n = M + H_i D_i - Q_j D_j               gap at the end of the step     (paper eq 9)
//! ```
//!
//! # Sign law
//!
//! The unit normal `n` points from body B to body A (for a sphere on a boundary: from the boundary to the
//! sphere). A gap `g < 0` is an overlap. Multipliers `p_n >= 0` push the bodies apart; `p_t` lies in the
//! tangent plane. `p` acts on A, `-p` on B.
//!
//! # Notation
//!
//! | paper | DDA term | identifier | unit |
//! |---|---|---|---|
//! | `D_i` | displacement increment | `dt * velocity` | m, rad |
//! | `T_i` | first-order displacement function | [`scene::particles`] | - |
//! | `K_ij`, `F_i` | stiffness sub-matrix, force sub-vector | [`step`], [`solver`] | N/m, N |
//! | `M` | gap before the step | `gap`, [`contact::Contact::gap`] | m |
//! | `n` | contact normal | [`contact::Contact::normal`] | - |
//! | `H_i`, `Q_j` | rows of the normal displacement | `normal`, `arm` of [`problem::Row`] | - |
//! | `-lambda*` | multiplier, contact force | `impulse / dt` | N |
//! | `P_n` | penalty number, contact spring | `penalty` | N/m |
//! | `d_n` | normal distance after the step | `gap + dt u_n` | m |
//! | `phi` | friction angle | `friction = tan(phi)` | - |
//! | - | rolling, twisting resistance `mu_r`, `mu_t` | `rolling_friction`, `twisting_friction` | - |
//! | - | couple `m` of a resistance | [`contact::Contact::torque`]; its row has `impulse = m dt / radius` | N m |
//! | - | pull-off force `f_c`, strengths of a bond | [`contact::cohesion`] | N, Pa |
//! | - | surface velocity of a belt | [`scene::Belt`] | m/s |
//! | `dt` | time step | `step` | s |
//! | - | angular velocity `W` of the frame | [`scene::rotating_frame::RotatingFrame`] | rad/s |
//! | - | clump: members at `x + Q a` | [`scene::clump`] | m |
//! | - | image `k` and edges `L` of a copy `x + k L` | [`spatial::cell::Image`], [`spatial::cell::Cell`] | -, m |
//!
//! # A step, its contacts and their forces
//!
//! ```
//! use std::path::Path;
//! use std::sync::Arc;
//!
//! use sphere_dda::{scene::Scene, simulation::Simulation};
//!
//! let scene = Scene::from_file(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/slopes/slopes.toml"))?.scene;
//! let mut simulation = Simulation::new(Arc::new(scene))?;
//! let report = simulation.advance(0.01)?;
//! for contact in simulation.contacts() {
//!     println!("{:?}: gap {:.1e} m, force {:?} N", contact.key, contact.gap, contact.force.as_slice());
//! }
//! assert!(report.max_overlap < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`simulation::Simulation::problem`] gives the algebra of the next step and the impulses that a solver starts from. A solver
//! is a function of the shape of [`solver::solve`]; [`solver::residual::evaluate`] judges it: [`solver`] has one as an example.
//!
//! # Where things are
//!
//! [`scene_file`] reads a [`scene`], which never changes in a run. [`simulation`] owns the [`state`] and takes communication
//! steps. Of each internal [`step`], [`detection`] finds the candidate pairs, [`step`] writes them as a [`problem`],
//! [`solver`] solves it, and the step checks the true gaps and commits. [`observe`] turns a simulation into numbers,
//! [`results`] numbers into files.

pub mod communication_points;
pub mod contact;
pub mod detection;
pub mod error;
pub mod files;
pub mod formats;
pub mod geometry;
pub mod integrator;
pub mod linalg;
mod memory;
pub mod observe;
mod parallel;
pub mod problem;
pub mod random;
pub mod results;
pub mod scene;
pub mod scene_file;
pub mod simulation;
pub mod solver;
mod sorting;
pub mod spatial;
pub mod state;
pub mod step;

/// Vectors and rotations of the public types, in the version that this crate uses.
pub use nalgebra;

/// A vector in space: metres, newtons, metres per second ... as the field says.
pub type Vec3 = nalgebra::Vector3<f64>;
