//! What a fit of spheres to a clump's mesh is like.

use std::f64::consts::PI;
use std::fmt;

use crate::Vec3;
use crate::geometry::{BallFit, Moments};

/// Spheres that stand for a mesh, and the moments of both.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// Name of the clump.
    pub clump: String,
    /// The file of the mesh.
    pub file: String,
    /// The spheres, in the axes of the mesh.
    pub balls: BallFit,
    /// Moments of the mesh: those of the clump.
    pub mesh: Moments,
}

impl fmt::Display for Fitted {
    /// Number of spheres and error of their surface; then volume, centroid and inertia of mesh and spheres.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (mesh, balls) = (&self.mesh, &self.balls);
        let size = libm::cbrt(mesh.volume / (4.0 / 3.0 * PI));
        let share = |length: f64| format!("{length:.2e} m ({:.1} %)", 100.0 * length / size);
        let off = |found: f64, of: f64| format!("{:+.1} %", 100.0 * (found / of - 1.0));
        let triple = |x: Vec3| format!("({:.4e}, {:.4e}, {:.4e})", x.x, x.y, x.z);
        let [own, of_spheres] = [mesh.principal(), balls.union.principal()];
        let inertia = [0, 1, 2].map(|k| off(of_spheres[k], own[k])).join(", ");
        writeln!(
            f,
            "  clump {:<11} {} spheres for `{}`",
            self.clump,
            balls.radii.len(),
            self.file
        )?;
        writeln!(
            f,
            "    surface         off by {}, at most {}; radii {} above inscribed ones (% of the radius of a ball of this volume)",
            share(balls.mean),
            share(balls.largest),
            share(balls.grown)
        )?;
        let volume = off(balls.union.volume, mesh.volume);
        writeln!(
            f,
            "    volume          {:.4e} m^3, of the spheres {volume}",
            mesh.volume
        )?;
        let beside = (balls.union.centroid - mesh.centroid).norm();
        writeln!(
            f,
            "    centroid        {} m, of the spheres {beside:.1e} m beside it",
            triple(mesh.centroid)
        )?;
        write!(
            f,
            "    inertia         principal, over the density {} m^5, of the spheres {inertia}",
            triple(own)
        )
    }
}
