//! `[[spheres]]`, `[[source]]` and `[[sink]]`: where spheres are, where they come from and where they go.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{OneOrMany, Region, Triple, Vector};

/// `[[spheres]]`: a named group, placed by exactly one of `lattice`, `packing`, `positions`, `csv`, `vtu`,
/// `checkpoint`.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spheres {
    /// Name of the group, unique. Sphere k of it is `"name[k]"` elsewhere, counted from 0.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// Material.
    pub material: String,
    /// Name of a `[[clump]]`: every place is the centre of mass of such a clump, in a packing of the ball around it. Member j of
    /// clump k is `"name[k n + j]"` elsewhere, n being the number of members.
    #[schemars(extend("x-default" = "single spheres"))]
    pub clump: Option<String>,
    /// Rotation vectors of clumps \[rad\], one for all or one each.
    #[schemars(extend("x-default" = "random, by `seed`"))]
    pub rotations: Option<Vec<Vector>>,
    /// Radius \[m\]: one for all or a list (one for all in a packing). Required unless `size` or `clump` is given or the file
    /// has radii.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<OneOrMany<f64>>,
    /// Distribution the radii are drawn from, instead of `radius`.
    pub size: Option<Size>,
    /// Each radius is multiplied by 1 + `radius_jitter` U(-1, 1) \[-\].
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "exclusiveMaximum" = 1))]
    pub radius_jitter: f64,
    /// Seed of jitters, sizes and packing.
    #[serde(default)]
    pub seed: u64,
    /// A regular lattice.
    pub lattice: Option<Lattice>,
    /// A random packing of a region.
    pub packing: Option<Packing>,
    /// Centres \[m\].
    pub positions: Option<Vec<Vector>>,
    /// CSV file with columns x, y, z \[m\] and optionally radius \[m\], of clumps that of a sphere of the same volume, vx, vy, vz
    /// \[m/s\], wx, wy, wz \[rad/s\].
    pub csv: Option<String>,
    /// Frame of results, `spheres_NNNNNN.vtu`: its spheres with radius, velocity, spin and orientation, to seven
    /// digits unless the run wrote `float64`.
    pub vtu: Option<String>,
    /// Checkpoint of a run: its spheres with radius, velocity, spin and orientation.
    pub checkpoint: Option<String>,
    /// Initial velocity \[m/s\] of all.
    #[schemars(extend("x-default" = "zero, or the file's"))]
    pub velocity: Option<Vector>,
    /// Initial angular velocity \[rad/s\] of all.
    #[schemars(extend("x-default" = "zero, or the file's"))]
    pub spin: Option<Vector>,
    /// Locked degrees of freedom, world axes, one or a list of them.
    #[schemars(extend("x-default" = "none"))]
    pub lock: Option<OneOrMany<Lock>>,
}

/// A held degree of freedom.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Lock {
    /// Translation along x.
    X,
    /// Translation along y.
    Y,
    /// Translation along z.
    Z,
    /// Rotation about x.
    Rx,
    /// Rotation about y.
    Ry,
    /// Rotation about z.
    Rz,
    /// All three translations.
    Translations,
    /// All three rotations: the sphere slides like a block.
    Rotations,
}

/// A lattice: centre (i, j, k) = `origin` + i s_x e_x + j s_y e_y + k s_z e_z, i fastest.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Lattice {
    /// Centre of the first sphere \[m\].
    pub origin: Vector,
    /// Number of spheres along each axis.
    #[schemars(extend("minimum" = 1))]
    pub count: Triple<u32>,
    /// Distance between centres \[m\]: one or three.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub spacing: OneOrMany<f64>,
    /// Each coordinate is moved by `jitter` spacing U(-1, 1) \[-\].
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 0.5))]
    pub jitter: f64,
    /// Directions of e_x and e_y; normalised, e_y made perpendicular to e_x, e_z = e_x x e_y.
    #[schemars(extend("x-default" = "world axes", "minItems" = 2, "maxItems" = 2))]
    pub axes: Option<Vec<Vector>>,
}

/// Distribution of radii: a table with one key. Numbers of spheres follow it, except for `table`, where masses do.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Size {
    /// Every radius between two bounds is as likely as any other.
    Uniform(Uniform),
    /// Normal, cut off.
    Normal(Normal),
    /// The logarithm of the radius is normal; cut off.
    LogNormal(LogNormal),
    /// Classes of radii with their shares of the mass, as from a sieve.
    Table(MassTable),
}

/// Uniform radii.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Uniform {
    /// Smallest radius \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub min: f64,
    /// Largest radius \[m\], >= `min`.
    pub max: f64,
}

/// Normally distributed radii; draws outside the bounds are drawn again.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Normal {
    /// Mean radius \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mean: f64,
    /// Standard deviation \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub deviation: f64,
    /// Smallest radius \[m\], at most the mean.
    #[schemars(extend("x-default" = "mean - 3 deviations, at least mean / 10", "exclusiveMinimum" = 0))]
    pub min: Option<f64>,
    /// Largest radius \[m\], at least the mean and `min` + deviation / 10 or more.
    #[schemars(extend("x-default" = "mean + 3 deviations"))]
    pub max: Option<f64>,
}

/// Log-normally distributed radii; draws outside the bounds are drawn again.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LogNormal {
    /// Median radius \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub median: f64,
    /// Standard deviation of ln(radius) \[-\].
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10))]
    pub sigma: f64,
    /// Smallest radius \[m\], at most the median.
    #[schemars(extend("x-default" = "median exp(-3 sigma)", "exclusiveMinimum" = 0))]
    pub min: Option<f64>,
    /// Largest radius \[m\], at least the median and `min` exp(sigma / 10) or more.
    #[schemars(extend("x-default" = "median exp(3 sigma)"))]
    pub max: Option<f64>,
}

/// Radii in classes.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MassTable {
    /// Radius of each class \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Vec<f64>,
    /// Share of the mass of each class, in any unit; they are divided by their sum.
    #[schemars(extend("minimum" = 0))]
    pub mass: Vec<f64>,
}

/// A seeded random packing without overlap: exactly one of `count`, `mass`, `solid_fraction`. It keeps clear of the
/// boundaries as they stand at t = 0 and of the groups before it, on every side of them: a region larger than a hopper
/// also gets spheres outside of the hopper. In a periodic cell the copies of both count too. Solid fractions up to about 0.57 are reached.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Packing {
    /// What is filled; spheres lie wholly inside.
    pub region: Region,
    /// Number of spheres.
    #[schemars(extend("minimum" = 1))]
    pub count: Option<u32>,
    /// Mass \[kg\]: spheres are added until one more would exceed it.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass: Option<f64>,
    /// Volume of the spheres over that of the region \[-\], likewise.
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 0.74))]
    pub solid_fraction: Option<f64>,
}

/// `[[source]]`: emits spheres into a region while time goes on: exactly one of `rate`, `mass_rate`.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Name, unique among sources and sphere groups: `"name[k]"` is its sphere k.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// Material.
    pub material: String,
    /// Name of a `[[clump]]`: it emits such clumps, turned at random. All that is said of spheres here is then meant of clumps.
    pub clump: Option<String>,
    /// Radius \[m\], of clumps that of a sphere of their volume. Required unless `size` or `clump` is given.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Distribution the radii are drawn from, instead of `radius`.
    pub size: Option<Size>,
    /// Where spheres appear, wholly inside, wherever there is room.
    pub region: Region,
    /// Most spheres of this source that can be in the scene at a time. Those that wait take next to no time.
    #[schemars(extend("minimum" = 1))]
    pub capacity: u32,
    /// Spheres per second \[1/s\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub rate: Option<f64>,
    /// Mass per second \[kg/s\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass_rate: Option<f64>,
    /// Start of the emission \[s\].
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub start: f64,
    /// End of the emission \[s\], > `start`.
    #[schemars(extend("x-default" = "never"))]
    pub stop: Option<f64>,
    /// Velocity of new spheres \[m/s\].
    #[serde(default)]
    pub velocity: Vector,
    /// Angular velocity of new spheres \[rad/s\].
    #[serde(default)]
    pub spin: Vector,
    /// Seed of sizes and places.
    #[serde(default)]
    pub seed: u64,
}

/// `[[sink]]`: removes spheres whose centre lies in a region.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sink {
    /// Name, unique.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// Where spheres are removed.
    pub region: Region,
    /// Name of a source that gets the spheres back and emits them anew, whatever group they were of.
    #[schemars(extend("x-default" = "none, spheres of a source return to it, others leave for good"))]
    pub recycle: Option<String>,
}
