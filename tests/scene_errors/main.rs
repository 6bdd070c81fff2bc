//! Bad scenes: each is refused with the key path, the line, what was found and what is expected.

mod clumps;
mod parameters;
mod warnings;

use std::path::Path;

use proptest::prelude::*;
use sphere_dda::geometry::Shape;
use sphere_dda::scene::{InputKind, Motion};
use sphere_dda::scene::{Measure, Scene};
use sphere_dda::scene_file::{Loaded, SceneError, Summary};

const GOOD: &str = r#"title = "box"
[simulation]
duration = 1.0
step = 1e-3
[simulation.tolerance]
gap = 1e-6
[[material]]
name = "rock"
density = 2500.0
[[material]]
name = "steel"
[pair_default]
friction = 0.3
[[pair]]
materials = ["rock", "steel"]
friction_angle = 20.0
restitution = 0.5
[[spheres]]
name = "grains"
material = "rock"
radius = 0.1
lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }
[[spheres]]
name = "one"
material = "rock"
radius = [0.2]
positions = [[0.0, 0.0, 3.0]]
lock = ["rx", "y"]
[[boundary]]
name = "floor"
material = "steel"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 2.0] } }]
[[boundary]]
name = "gate"
material = "steel"
faces = [
  { rectangle = { corner = [9.0, 0.0, 0.0], u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0] } },
  { cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } },
]
motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }
[[load]]
sphere = "grains[4]"
force = [0.0, 0.0, 1.0]
[[spring]]
sphere = "one"
stiffness = 1e3
[[sensor]]
name = "flow"
mass_flow = { plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, -1.0] } }
[[sensor]]
name = "inside"
region = { box = { min = [0.0, 0.0, 0.0], max = [1.0, 1.0, 1.0] } }
[[probe]]
name = "top"
sphere = "one"
[output]
vtu_interval = 0.05
"#;

/// `from` of the good scene replaced by `to` gives a problem at `path`, on the line that holds `line`, whose text
/// (message and help) holds `text`.
struct Case {
    from: &'static str,
    to: &'static str,
    path: &'static str,
    line: &'static str,
    text: &'static str,
}

macro_rules! cases {
    ($($from:expr => $to:expr, $path:expr, $line:expr, $text:expr;)*) => {
        &[$(Case { from: $from, to: $to, path: $path, line: $line, text: $text }),*]
    };
}

const CASES: &[Case] = cases! {
    // Syntax, keys, types.
    "step = 1e-3" => "step = = 1e-3", "scene", "step = =", "TOML";
    "step = 1e-3" => "stepp = 1e-3", "simulation.stepp", "stepp", "did you mean `step`";
    "step = 1e-3\n" => "fixed_step = true\n", "simulation", "[simulation]", "missing key `step`";
    "step = 1e-3" => "step = 1e-3\naccuracy = \"high\"", "simulation.accuracy", "high", "standard";
    "[simulation]\nduration = 1.0\nstep = 1e-3\n[simulation.tolerance]\ngap = 1e-6\n" => "", "simulation", "title", "missing table `[simulation]`";
    "step = 1e-3" => "step = \"1 mm\"", "simulation.step", "\"1 mm\"", "found \"1 mm\", expected a time like \"5 ms\", or a number > 0 (in s)";
    "radius = 0.1\n" => "radius = \"3 kg\"\n", "spheres[0].radius", "3 kg", "found \"3 kg\", expected a length like \"8 mm\", or a number (in m), or a list";
    "radius = [0.2]" => "radius = [\"3 foo\"]", "spheres[1].radius[0]", "3 foo", "expected a length like";
    "friction = 0.3" => "friction = \"1 m\"", "pair_default.friction", "1 m", "found \"1 m\", expected a number >= 0";
    "radius = 0.1\n" => "radius = \"-1 mm\"\n", "spheres[0].radius", "-1 mm", "found -0.001";
    "step = 1e-3" => "step = ", "scene", "step =", "found nothing after `step =`, expected a value";
    "name = \"steel\"" => "name = steel", "scene", "name = steel", "found `steel` without quotes";
    "motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }" => "input = \"slide\"", "boundary[1].input", "\"slide\"", "found \"slide\", expected `{ slide = [x, y, z] }`";
    "motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }" => "input = { pose = 1 }", "boundary[1].input", "pose = 1", "expected `\"pose\"` alone";
    "faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 2.0] } }]" => "faces = { plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 2.0] } }", "boundary[0].faces", "faces = {", "found a table with the key `plane`, expected a list `[";
    "friction = 0.3" => "friction = true", "pair_default.friction", "true", "found true, expected a number >= 0";
    "r0 = 1.0" => "r0 = [1.0]", "boundary[1].faces[1].cone.r0", "r0 = [1.0]", "found a list of 1 entry, expected a number >= 0 (in m)";
    "lock = [\"rx\", \"y\"]" => "lock = 3", "spheres[1].lock", "lock = 3", "found 3, expected \"x\", \"y\"";
    "[output]\n" => "[output]\nfloat64 = 1\n", "output.float64", "float64 = 1", "found 1, expected true or false";
    "[output]\n" => "[fmu]\napplied_forces = 1\n[output]\n", "fmu.applied_forces", "applied_forces = 1", "found 1, expected true or false";
    "title = \"box\"" => "title = 3", "title", "title = 3", "found 3, expected a string in quotes";
    "title = \"box\"" => "license = 3", "license", "license = 3", "found 3, expected a string in quotes";
    "title = \"box\"" => "title = \"a\\u001b[31mb\"", "title", "title = ", "found \"a\\u{1b}[31mb\", expected a text without control characters";
    "title = \"box\"" => "author = \"a\\nb\"", "author", "author = ", "expected a text without control characters";
    "[[probe]]" => "[[probes]]", "probes", "[[probes]]", "did you mean `probe`";
    "[[probe]]" => "[probe]", "probe", "[probe]", "double brackets";
    "step = 1e-3" => "step = 1e-3\nmethod = \"almm\"", "simulation.method", "almm", "did you mean `alm`";
    "{ plane =" => "{ plan =", "boundary[0].faces[0]", "{ plan =", "did you mean `plane`";
    "normal = [0.0, 0.0, 2.0]" => "norml = [0.0, 0.0, 2.0]", "boundary[0].faces[0].plane.norml", "norml", "did you mean `normal`";
    "normal = [0.0, 0.0, 2.0]" => "normal = [0.0, 2.0]", "boundary[0].faces[0].plane.normal", "[0.0, 2.0]", "three numbers";
    "normal = [0.0, 0.0, 2.0]" => "normal = [0.0, 0.0, 2.0, 1.0]", "boundary[0].faces[0].plane.normal", "2.0, 1.0]", "three numbers";
    "\"rx\"" => "\"rxx\"", "spheres[1].lock[0]", "rxx", "did you mean `rx`";
    // Numbers.
    "step = 1e-3" => "step = nan", "simulation.step", "nan", "found nan, expected a finite number";
    "density = 2500.0" => "density = inf", "material[0].density", "inf", "found inf";
    "density = 2500.0" => "density = 1e300", "material[0].density", "1e300", "at most 1e30";
    "step = 1e-3" => "step = 0.0", "simulation.step", "step = 0.0", "found 0, expected a time > 0 [s]";
    "duration = 1.0" => "duration = -1.0", "simulation.duration", "duration", "found -1";
    "step = 1e-3" => "step = 1e-3\ncommunication_step = 0", "simulation.communication_step", "communication", "> 0 [s]";
    "gap = 1e-6" => "gap = 1e-20", "simulation.tolerance.gap", "gap =", "1e-12 to 1e-1";
    "step = 1e-3" => "step = 1e-3\nmethod = \"penalty\"", "simulation", "[simulation]", "missing key `penalty`";
    "step = 1e-3" => "step = 1e-3\npenalty = -1.0", "simulation.penalty", "penalty", "> 0 [N/m]";
    "step = 1e-3" => "step = 1e-3\nmax_initial_overlap = 2", "simulation.max_initial_overlap", "max_initial", "found 2";
    "step = 1e-3" => "step = 1e-3\nthreshold_velocity = -1", "simulation.threshold_velocity", "threshold", ">= 0 [m/s]";
    "step = 1e-3" => "step = 1e-3\ndynamic_coefficient = 1.5", "simulation.dynamic_coefficient", "dynamic", "found 1.5";
    "step = 1e-3" => "step = 1e-3\nmax_iterations = 0", "simulation.max_iterations", "max_iter", ">= 1";
    "step = 1e-3" => "step = 1e-3\nmax_iterations = -5", "simulation.max_iterations", "max_iter", "found -5, expected a whole number >= 1";
    "step = 1e-3" => "step = 1e-3\nmax_cuts = 99", "simulation.max_cuts", "max_cuts", "found 99";
    "vtu_interval = 0.05" => "vtu_interval = -0.05", "output.vtu_interval", "vtu_interval", ">= 0 [s]";
    // Gravity and the frame of reference.
    "step = 1e-3" => "step = 1e-3\ngravity_motion = { rotation = { axis = [0, 0, 0], speed = 1 } }", "simulation.gravity_motion.rotation.axis", "gravity_motion", "a direction of length > 0";
    "step = 1e-3" => "step = 1e-3\ngravity_motion = { rotatin = { axis = [0, 1, 0], speed = 1 } }", "simulation.gravity_motion", "gravity_motion", "did you mean `rotation`";
    "step = 1e-3" => "step = 1e-3\ngravity = [0, 0, -9]\ngravity_motion = { table = { time = [0], gravity = [[0, 0, -9]] } }", "simulation.gravity", "gravity = [0, 0, -9]", "found both `gravity` and a table";
    "step = 1e-3" => "step = 1e-3\ngravity_motion = { table = { time = [0, 1], gravity = [[0, 0, -9]] } }", "simulation.gravity_motion.table.gravity", "gravity_motion", "found 1 vectors, expected 2 of them";
    "step = 1e-3" => "step = 1e-3\ngravity_motion = { table = { time = [1, 1], gravity = [[0, 0, -9], [0, 0, 9]] } }", "simulation.gravity_motion.table.time", "gravity_motion", "found 1 after 1, expected strictly increasing";
    "step = 1e-3" => "step = 1e-3\ngravity_motion = { table = { time = [1, 2] } }", "simulation.gravity_motion.table", "gravity_motion", "expected `csv`, or `time` and `gravity`";
    "step = 1e-3" => "step = 1e-3\ngravity_motion = { table = { csv = \"none.csv\" } }", "simulation.gravity_motion.table.csv", "gravity_motion", "cannot read";
    "step = 1e-3" => "step = 1e-3\nrotating_frame = { axis = [0, 0, 0], speed = 1 }", "simulation.rotating_frame.axis", "rotating_frame", "a direction of length > 0";
    "step = 1e-3" => "step = 1e-3\nrotating_frame = { axis = [0, 0, 1] }", "simulation.rotating_frame", "rotating_frame", "missing key `speed`";
    // The periodic cell.
    "[[probe]]" => "[cell]\nx = [1, 0]\n[[probe]]", "cell.x", "x = [1, 0]", "found [1.0, 0.0], expected [lower face, upper face]";
    "[[probe]]" => "[cell]\nx = [0, 1, 2]\n[[probe]]", "cell.x", "x = [0, 1, 2]", "expected";
    "[[probe]]" => "[cell]\nw = [0, 1]\n[[probe]]", "cell.w", "w = [0, 1]", "unknown key `w`";
    "[[probe]]" => "[cell]\ny = [0, 0.3]\n[[probe]]", "cell.y", "y = [0, 0.3]", "found an edge of 0.3 m, expected at least 0.4004 m";
    "[[probe]]" => "[cell]\nz = [-1, 9]\n[[probe]]", "boundary[0]", "name = \"floor\"", "boundary `floor` crosses the faces of the cell across z: the normal of its plane has z = 1, expected 0";
    "[[probe]]" => "[cell]\nx = [-1, 9.5]\n[[probe]]", "boundary[1]", "name = \"gate\"", "boundary `gate` crosses a face of the cell: it reaches from x = 9 m to 22 m, expected -1 m to 9.5 m";
    "[[probe]]" => "[cell]\nx = [9, 22.1]\n[[probe]]", "boundary[1]", "name = \"gate\"", "takes 13 m of the cell's";
    "normal = [0.0, 0.0, 2.0] } }]" => "normal = [0.0, 0.0, 2.0] } }]\nmotion = { constant = { angular_velocity = [0, 1, 0] } }\n[cell]\nx = [-99, 99]", "boundary[0]", "name = \"floor\"", "may tilt its plane towards x";
    "normal = [0.0, 0.0, 2.0] } }]" => "normal = [0.0, 0.0, 2.0] } }]\nmotion = { table = { time = [0, 1], rotation = [[0, 0, 1], [1, 0, 0]] } }\n[cell]\nx = [-99, 99]", "boundary[0]", "name = \"floor\"", "may tilt its plane towards x";
    "normal = [0.0, 0.0, 2.0] } }]" => "normal = [0.0, 0.0, 2.0] } }]\ninput = \"pose\"\n[cell]\nx = [-99, 99]", "boundary[0]", "name = \"floor\"", "may tilt its plane towards x";
    "normal = [0.0, 0.0, 2.0] } }]" => "normal = [0.0, 0.0, 2.0] } }]\ninput = \"world_pose\"\n[cell]\nx = [-99, 99]", "boundary[0]", "name = \"floor\"", "may tilt its plane towards x";
    "[simulation.tolerance]\ngap = 1e-6\n" => "rotating_frame = { axis = [0, 0, 1], speed = 1 }\n[cell]\nx = [-99, 99]\n", "simulation.rotating_frame", "rotating_frame", "turns about an axis that is not x";
    "[[probe]]" => "[cell]\nx = [-99, 99]\n[[sensor]]\nname = \"leaning\"\nmass_flow = { plane = { point = [0, 0, 0], normal = [1, 0, 1] } }\n[[probe]]", "sensor[2].mass_flow", "normal = [1, 0, 1]", "the plane leans to x";
    // Materials and pairs.
    "density = 2500.0" => "density = 0.0", "material[0].density", "density", "> 0 [kg/m^3]";
    "density = 2500.0\n" => "", "material[0]", "[[material]]", "missing key `density`";
    "name = \"rock\"" => "name = \"2 rocks\"", "material[0].name", "2 rocks", "letters, digits";
    "name = \"steel\"" => "name = \"rock\"", "material[1].name", "name = \"rock\"\n[pair", "appears twice";
    "[\"rock\", \"steel\"]" => "[\"rock\", \"stel\"]", "pair[0].materials[1]", "stel", "did you mean `steel`";
    "[\"rock\", \"steel\"]" => "[\"rock\"]", "pair[0].materials", "materials", "two material names";
    "friction_angle = 20.0" => "friction_angle = 90.0", "pair[0].friction_angle", "90", "< 90 [degrees]";
    "friction_angle = 20.0" => "friction_angle = 20.0\nfriction = 0.1", "pair[0].friction_angle", "friction_angle", "both";
    "friction_angle = 20.0" => "friction_angle = 20.0\ncohesion = -1.0", "pair[0].cohesion", "-1.0", "a force >= 0 [N]";
    "friction_angle = 20.0" => "friction_angle = 20.0\nsurface_energy = -1.0", "pair[0].surface_energy", "-1.0", "an energy >= 0 [J/m^2]";
    "friction_angle = 20.0" => "friction_angle = 20.0\ncohesion = 1.0\nsurface_energy = 1.0", "pair[0].surface_energy", "surface_energy", "both `cohesion` and `surface_energy`";
    "friction_angle = 20.0" => "friction_angle = 20.0\nadhesion = \"jkr\"", "pair[0].adhesion", "adhesion", "without `surface_energy`";
    "friction_angle = 20.0" => "friction_angle = 20.0\nsurface_energy = 1.0\nstiffness = 1e3\nadhesion = \"jkr\"", "pair[0].adhesion", "adhesion", "for contacts with `stiffness`";
    "friction_angle = 20.0" => "friction_angle = 20.0\nsurface_energy = 1.0\n[[material]]\nname = \"gel\"\nyoung = 1e6\n[[pair]]\nmaterials = [\"gel\", \"rock\"]\nsurface_energy = 1.0\nadhesion = \"jkr\"\nrupture_distance = 1e-3", "pair[1].rupture_distance", "rupture_distance = 1e-3", "parts where its curve ends";
    "friction_angle = 20.0" => "friction_angle = 20.0\nrupture_distance = 1.0", "pair[0].rupture_distance", "rupture_distance", "without a force that it ends";
    "friction_angle = 20.0" => "friction_angle = 20.0\ncohesion = 1.0\nrupture_distance = -1.0", "pair[0].rupture_distance", "-1.0", "a distance >= 0 [m]";
    "friction_angle = 20.0" => "friction_angle = 20.0\nbond = { normal_strength = 0.0, shear_strength = 1.0 }", "pair[0].bond.normal_strength", "normal_strength = 0.0", "a strength > 0 [Pa]";
    "friction_angle = 20.0" => "friction_angle = 20.0\nbond = { normal_strength = 1.0, shear_strength = 1.0, reach = -1.0 }", "pair[0].bond.reach", "reach = -1.0", "a distance >= 0 [m]";
    "friction_angle = 20.0" => "friction_angle = 20.0\nbond = { normal_strength = 1.0, shear_strength = 1.0, young = 0.0 }", "pair[0].bond.young", "young = 0.0", "young > 0 [Pa]";
    "friction = 0.3" => "friction = -0.3", "pair_default.friction", "-0.3", ">= 0 [-]";
    "restitution = 0.5" => "restitution = 1.5", "pair[0].restitution", "1.5", "0 <= restitution <= 1";
    "restitution = 0.5" => "wear = -1.0", "pair[0].wear", "-1.0", "found -1, expected a coefficient >= 0 [1/Pa]";
    "faces = [{ plane" => "wall_fields = true\nfaces = [{ plane", "boundary[0].wall_fields", "true", "a plane has no triangles";
    "restitution = 0.5" => "stiffness = 0.0", "pair[0].stiffness", "stiffness = 0.0", "found 0, expected stiffness > 0 [N/m]";
    "name = \"steel\"" => "name = \"steel\"\nyoung = -1.0", "material[1].young", "young = -1.0", "found -1, expected young > 0 [Pa]";
    "name = \"steel\"" => "name = \"steel\"\nyoung = 1e9\npoisson = 0.6", "material[1].poisson", "poisson = 0.6", "0 <= poisson <= 0.5";
    "name = \"steel\"" => "name = \"steel\"\npoisson = 0.3", "material[1].poisson", "poisson = 0.3", "without `young`";
    "name = \"steel\"" => "name = \"steel\"\nyoung = 1e9\nstiffness = 1e5", "material[1].stiffness", "stiffness = 1e5", "both `young` and `stiffness`";
    "restitution = 0.5" => "[[pair]]\nmaterials = [\"steel\", \"rock\"]", "pair[1].materials", "\"steel\", \"rock\"", "appears twice";
    // Spheres.
    "radius = 0.1" => "radius = 0.0", "spheres[0].radius", "radius = 0.0", "found 0, expected a radius > 0 [m]";
    "radius = [0.2]" => "radius = [-0.2]", "spheres[1].radius[0]", "-0.2", "found -0.2";
    "radius = [0.2]" => "radius = [0.2, 0.2]", "spheres[1].radius", "[0.2, 0.2]", "2 radii";
    "radius = 0.1\n" => "", "spheres[0]", "name = \"grains\"", "missing key `radius`";
    "radius = 0.1" => "radius = 0.1\nradius_jitter = 1.0", "spheres[0].radius_jitter", "radius_jitter", "< 1";
    "count = [3, 2, 1]" => "count = [3, 0, 1]", "spheres[0].lattice.count", "count", "each >= 1";
    "count = [3, 2, 1]" => "count = [99999, 99999, 99999]", "spheres[0].lattice.count", "count", "at most 10000000";
    "spacing = 0.3" => "spacing = [0.3, 0.3]", "spheres[0].lattice.spacing", "spacing", "one or three lengths";
    "jitter = 0.1" => "jitter = 0.9", "spheres[0].lattice.jitter", "jitter", "<= 0.5";
    "jitter = 0.1" => "axes = [[1, 0, 0], [2, 0, 0]]", "spheres[0].lattice.axes", "axes", "not parallel";
    "positions = [[0.0, 0.0, 3.0]]\n" => "", "spheres[1]", "name = \"one\"", "found 0 of lattice, packing, positions, csv, vtu, checkpoint";
    "positions = [[0.0, 0.0, 3.0]]" => "positions = []", "spheres[1].positions", "positions", "an empty list";
    "positions = [[0.0, 0.0, 3.0]]" => "positions = [[0.0, 0.0, \"3\"]]", "spheres[1].positions[0][2]", "positions", "found \"3\", expected a length like \"8 mm\", or a number (in m)";
    "radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]" => "csv = \"none.csv\"", "spheres[1].csv", "csv", "cannot read";
    "radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]" => "csv = \"../a.csv\"", "spheres[1].csv", "csv", "below the scene's folder";
    "radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]" => "csv = \"bad.csv\"", "spheres[1].csv", "csv", "`abc` in `bad.csv` line 3, column `radius`";
    "radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]" => "csv = \"column.csv\"", "spheres[1].csv", "csv", "lacks the column `z`";
    "radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]" => "csv = \"semicolon.csv\"", "spheres[1].csv", "csv", "separated by ';', expected `,`";
    "spacing = 0.3" => "spacing = 0.1", "spheres[0]", "name = \"grains\"", "of the smaller radius, expected at most max_initial_overlap = 0.05";
    "origin = [0.0, 0.0, 0.2]" => "origin = [0.0, 0.0, -0.2]", "spheres[0]", "name = \"grains\"", "boundary `floor`";
    "material = \"rock\"\nradius = 0.1" => "material = \"rokc\"\nradius = 0.1", "spheres[0].material", "rokc", "did you mean `rock`";
    // Packings, sizes, files of results.
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }\npacking = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, count = 9 }", "spheres[0]", "name = \"grains\"", "found 2 of lattice, packing";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } } }", "spheres[0].packing", "packing", "found 0 of count, mass, solid_fraction";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, count = 9, mass = 1 }", "spheres[0].packing", "packing", "found 2 of count, mass, solid_fraction";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, number = 9 }", "spheres[0].packing.number", "packing", "unknown key `number`";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, count = 0 }", "spheres[0].packing.count", "packing", "found 0, expected 1 to 10000000";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, mass = -1 }", "spheres[0].packing.mass", "packing", "> 0 [kg]";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, mass = 1e-6 }", "spheres[0].packing", "packing", "less than the first one, expected at least one sphere";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, solid_fraction = 0.8 }", "spheres[0].packing.solid_fraction", "packing", "found 0.8, expected a share > 0 and below 0.74";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, count = 200 }", "spheres[0].packing", "packing", "at most 0.74 of the region's 1.0000e0 m^3";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, count = 145 }", "spheres[0].packing", "packing", "of 145 spheres, a solid fraction of 0.4";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, 5], max = [1, 1, 5.15] } }, count = 9 }", "spheres[0].packing", "packing", "found no place for a sphere of radius 0.1 m";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { box = { min = [0, 0, -2], max = [1, 1, -1] } }, count = 9 }", "spheres[0].packing", "packing", "move it out of the boundaries";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { beyond = { point = [0, 0, 0], normal = [0, 0, 1] } }, count = 9 }", "spheres[0].packing.region", "packing", "a bounded region: box, cylinder or mesh";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { cylinder = { base = [0, 0, 5], radius = 0, height = 1 } }, count = 9 }", "spheres[0].packing.region.cylinder.radius", "packing", "> 0 [m]";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { mesh = { file = \"none.stl\" } }, count = 9 }", "spheres[0].packing.region.mesh.file", "packing", "cannot read";
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "packing = { region = { mesh = { file = \"good.stl\" } }, count = 9 }", "spheres[0].packing.region.mesh.file", "packing", "3 edges have one facet only, the first from (10, 0, 0) to (11, 0, 0)";
    "region = { box = { min = [0.0, 0.0, 0.0], max = [1.0, 1.0, 1.0] } }" => "region = { mesh = { file = \"good.stl\" } }", "sensor[1].region", "region", "found `mesh`, expected `box` or `cylinder`";
    "radius = 0.1\nlattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }" => "radius = [0.1, 0.2]\npacking = { region = { box = { min = [0, 0, 5], max = [1, 1, 6] } }, count = 9 }", "spheres[0].radius", "radius = [0.1", "found a list of 2 radii, expected one radius for all";
    "radius = 0.1\n" => "radius = 0.1\nsize = { uniform = { min = 0.1, max = 0.1 } }\n", "spheres[0].size", "size =", "found both `radius` and `size`";
    "radius = 0.1\n" => "size = { unifrm = { min = 0.1, max = 0.1 } }\n", "spheres[0].size", "size =", "did you mean `uniform`";
    "radius = 0.1\n" => "size = { uniform = { min = 0, max = 0.1 } }\n", "spheres[0].size.uniform.min", "size =", "a radius > 0 [m]";
    "radius = 0.1\n" => "size = { uniform = { min = 0.1, max = 0.05 } }\n", "spheres[0].size.uniform.max", "size =", "found 0.05, expected at least min = 0.1 [m]";
    "radius = 0.1\n" => "size = { normal = { mean = 0, deviation = 0.1 } }\n", "spheres[0].size.normal.mean", "size =", "a radius > 0 [m]";
    "radius = 0.1\n" => "size = { normal = { mean = 0.1, deviation = 0 } }\n", "spheres[0].size.normal.deviation", "size =", "a length > 0 [m]";
    "radius = 0.1\n" => "size = { normal = { mean = 0.1, deviation = 0.01, min = 0.11 } }\n", "spheres[0].size.normal.min", "size =", "found 0.11, expected 0 < min <= mean = 0.1 [m]";
    "radius = 0.1\n" => "size = { normal = { mean = 0.1, deviation = 0.01, max = 0.09 } }\n", "spheres[0].size.normal.max", "size =", "at least mean = 0.1 [m]";
    "radius = 0.1\n" => "size = { normal = { mean = 0.1, deviation = 0.01, min = 0.1, max = 0.1001 } }\n", "spheres[0].size.normal.max", "size =", "a tenth of a deviation apart";
    "radius = 0.1\n" => "size = { log_normal = { median = 0.1, sigma = 0 } }\n", "spheres[0].size.log_normal.sigma", "size =", "0 < sigma <= 10 [-]";
    "radius = 0.1\n" => "size = { log_normal = { median = 0.1, sigma = 0.1, min = 0 } }\n", "spheres[0].size.log_normal.min", "size =", "0 < min <= median = 0.1 [m]";
    "radius = 0.1\n" => "size = { table = { radius = [], mass = [] } }\n", "spheres[0].size.table.radius", "size =", "an empty list";
    "radius = 0.1\n" => "size = { table = { radius = [0.1, 0.2], mass = [1] } }\n", "spheres[0].size.table.mass", "size =", "found 1 shares, expected one share for each of the 2 radii";
    "radius = 0.1\n" => "size = { table = { radius = [0.1, 0], mass = [1, 1] } }\n", "spheres[0].size.table.radius[1]", "size =", "a radius > 0 [m]";
    "radius = 0.1\n" => "size = { table = { radius = [0.1, 0.2], mass = [1, -1] } }\n", "spheres[0].size.table.mass[1]", "size =", "a share of the mass >= 0";
    "radius = 0.1\n" => "size = { table = { radius = [0.1, 0.2], mass = [0, 0] } }\n", "spheres[0].size.table.mass", "size =", "found only zeros";
    "radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]" => "vtu = \"none.vtu\"", "spheres[1].vtu", "vtu", "cannot read";
    "radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]" => "vtu = \"../a.vtu\"", "spheres[1].vtu", "vtu", "below the scene's folder";
    "radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]" => "vtu = \"good.csv\"", "spheres[1].vtu", "vtu", "cannot read `good.csv`: the data is elsewhere";
    // Boundaries.
    "material = \"steel\"\nfaces = [{" => "material = \"iron\"\nfaces = [{", "boundary[0].material", "iron", "unknown material `iron`";
    "name = \"gate\"" => "name = \"floor\"", "boundary[1].name", "floor\"\nmaterial = \"steel\"\nfaces = [\n", "appears twice";
    "faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 2.0] } }]" => "faces = []", "boundary[0].faces", "faces = []", "at least one face";
    "normal = [0.0, 0.0, 2.0]" => "normal = [0, 0, 0]", "boundary[0].faces[0].plane", "plane", "length 0";
    "v = [0.0, 1.0, 0.0]" => "v = [1.0, 1.0, 0.0]", "boundary[1].faces[0].rectangle", "rectangle", "perpendicular";
    "v = [0.0, 1.0, 0.0]" => "v = [0.0, 0.0, 0.0]", "boundary[1].faces[0].rectangle", "rectangle", "area";
    "r0 = 1.0" => "r0 = -1.0", "boundary[1].faces[1].cone", "cone", "-1";
    "height = 1.0" => "height = 0", "boundary[1].faces[1].cone", "cone", "height";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ box = { min = [1, 0, 0], max = [0, 1, 1] } }", "boundary[1].faces[1].box", "box =", "expected";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ triangle = [[0, 0, 0], [1, 0, 0]] }", "boundary[1].faces[1].triangle", "triangle", "2 corners";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]] }", "boundary[1].faces[1].polygon", "polygon", "plane";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ stl = { file = \"none.stl\" } }", "boundary[1].faces[1].stl.file", "none.stl", "cannot read";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ stl = { file = \"/etc/passwd\" } }", "boundary[1].faces[1].stl.file", "passwd", "relative path";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ stl = { file = \"empty.stl\" } }", "boundary[1].faces[1].stl.file", "empty.stl", "expected";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ stl = { file = \"none_inside.stl\" } }", "boundary[1].faces[1].stl.file", "none_inside.stl", "no facet";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ stl = { file = \"garbage.stl\" } }", "boundary[1].faces[1].stl.file", "garbage.stl", "STL";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ stl = { file = \"nan.stl\" } }", "boundary[1].faces[1].stl.file", "nan.stl", "expected";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ stl = { file = \"fin.stl\" } }", "boundary[1].faces[1].stl.file", "fin.stl", "at most two facets";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ stl = { file = \"good.stl\", scale = 0 } }", "boundary[1].faces[1].stl.scale", "good.stl", "a factor > 0";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ terrain = { file = \"none.asc\" } }", "boundary[1].faces[1].terrain.file", "none.asc", "cannot read";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ terrain = { file = \"bad.asc\" } }", "boundary[1].faces[1].terrain.file", "bad.asc", "`bad.asc` line 6: found `x`, expected a height";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ terrain = { file = \"bad.asc\" } }", "boundary[1].faces[1].terrain.file", "bad.asc", "`bad.asc` line 6: found the end after 3 heights";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ terrain = { file = \"holes.asc\" } }", "boundary[1].faces[1].terrain.file", "holes.asc", "no four neighbouring heights";
    "{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }" => "{ terrain = { file = \"good.asc\", scale = [1, 0, 1] } }", "boundary[1].faces[1].terrain.scale", "good.asc", "found [1.0, 0.0, 1.0], expected one or three factors > 0";
    // Motion.
    "motion = {" => "input = \"pose\"\nmotion = {", "boundary[1].input", "input", "both `motion` and `input`";
    "motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }" => "input = \"worldpose\"", "boundary[1].input", "worldpose", "`world_pose`";
    "motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }" => "body = { mass = 1.0 }\ninput = \"world_pose\"", "boundary[1].body", "body", "expected one of them";
    "time = [0.0, 1.0]" => "time = [1.0, 1.0]", "boundary[1].motion.table.time", "time", "strictly increasing";
    "time = [0.0, 1.0]" => "time = [0.0]", "boundary[1].motion.table.translation", "time", "2 vectors";
    "time = [0.0, 1.0]" => "csv = \"a.csv\"", "boundary[1].motion.table", "csv", "expected `csv` or `time`";
    "motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }" => "motion = { sinusoid = { frequency = 0 } }", "boundary[1].motion.sinusoid.frequency", "frequency", "> 0 [Hz]";
    "motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }" => "input = { slide = [0, 0, 0] }", "boundary[1].input.slide", "slide", "length > 0";
    "motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }" => "input = \"push\"", "boundary[1].input", "push", "found `push`";
    "motion = { table" => "stiffness = 0\nmotion = { table", "boundary[1].stiffness", "stiffness", "> 0 [N/m]";
    // References.
    "\"grains[4]\"" => "\"grains[6]\"", "load[0].sphere", "grains[6]", "an index below 6";
    "\"grains[4]\"" => "\"grains\"", "load[0].sphere", "\"grains\"\nforce", "has 6 spheres";
    "\"grains[4]\"" => "\"grain[4]\"", "load[0].sphere", "grain[4]", "did you mean `grains`";
    "\"grains[4]\"" => "\"grains[-1]\"", "load[0].sphere", "grains[-1]", "group[k]";
    "stiffness = 1e3" => "stiffness = -1e3", "spring[0].stiffness", "stiffness", "> 0 [N/m]";
    "stiffness = 1e3" => "stiffness = 1e3\nmotion = { sinusoid = { frequency = 2.0, rotation = [0, 0, 0.5] } }", "spring[0].motion", "sinusoid", "found a rotation, expected translations only";
    "stiffness = 1e3" => "stiffness = 1e3\nmotion = { constant = { angular_velocity = [0, 0, 3] } }", "spring[0].motion", "constant", "found a rotation, expected translations only";
    "stiffness = 1e3" => "stiffness = 1e3\nmotion = { table = { time = [0, 1], rotation = [[0, 0, 0], [0, 0, 1]] } }", "spring[0].motion", "rotation", "found a rotation, expected translations only";
    "[output]\n" => "[[source]]\nname = \"feed\"\nmaterial = \"rock\"\nradius = 1e-110\ncapacity = 3\nrate = 100\nregion = { box = { min = [4, 4, 4], max = [5, 5, 5] } }\n[output]\n", "source[0]", "[[source]]", "no usable mass";
    "normal = [0.0, 0.0, -1.0]" => "normal = [0.0, 0.0, 0.0]", "sensor[0].mass_flow.plane.normal", "mass_flow", "length > 0";
    "max = [1.0, 1.0, 1.0]" => "max = [1.0, -1.0, 1.0]", "sensor[1].region.box", "region", "min < max";
    "mass_flow = { plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, -1.0] } }" => "wrench = \"flor\"", "sensor[0].wrench", "flor", "did you mean `floor`";
    "region = { box" => "mass_flow = { plane = { point = [0, 0, 0], normal = [1, 0, 0] } }\nregion = { box", "sensor[1]", "name = \"inside\"", "2 measures";
    "name = \"inside\"" => "name = \"flow\"", "sensor[1].name", "name = \"flow\"\nregion", "appears twice";
    "sphere = \"one\"\n[output]" => "sphere = \"two\"\n[output]", "probe[0].sphere", "two", "unknown sphere group";
};

/// Folder with the good and bad files the cases name.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let facet = |corners: [[&str; 3]; 3]| {
        let vertices: String = corners
            .iter()
            .map(|c| format!("vertex {}\n", c.join(" ")))
            .collect();
        format!("facet normal 0 0 1\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    let solid = |facets: &[String]| format!("solid s\n{}endsolid s\n", facets.concat());
    let (a, b) = (["10", "0", "0"], ["11", "0", "0"]);
    let fin = |tip: [&'static str; 3]| facet([a, b, tip]);
    let files = [
        (
            "good.csv",
            "x,y,z,radius,vx\n0,0,3,0.2,1\n0,0,4,0.1,-1\n".to_owned(),
        ),
        ("bad.csv", "x,y,z,radius\n0,0,3,0.2\n0,0,4,abc\n".to_owned()),
        ("column.csv", "x,y,radius\n0,0,3\n".to_owned()),
        ("semicolon.csv", "x;y;z\n0;0;3\n".to_owned()),
        ("good.stl", solid(&[fin(["10", "1", "0"])])),
        ("empty.stl", String::new()),
        ("none_inside.stl", solid(&[])),
        ("garbage.stl", "this is no mesh".to_owned()),
        ("nan.stl", solid(&[fin(["10", "nan", "0"])])),
        (
            "fin.stl",
            solid(&[
                fin(["10", "1", "0"]),
                fin(["10", "-1", "0"]),
                fin(["10", "0", "1"]),
            ]),
        ),
    ];
    let grid = |heights: &str| {
        format!("ncols 2\nnrows 2\nxllcorner 30\nyllcorner 0\ncellsize 1\n{heights}\n")
    };
    let grids = [
        ("good.asc", grid("1 2 3 4")),
        ("bad.asc", grid("1 x 3")),
        ("holes.asc", grid("1 2 3 -9999")),
    ];
    for (name, content) in files.into_iter().chain(grids) {
        std::fs::write(folder.path().join(name), content).unwrap();
    }
    folder
}

fn load(text: &str, folder: &Path) -> Result<Loaded, SceneError> {
    Scene::from_toml("scene.toml", text, folder)
}

/// The good scene with one replacement that must change it.
fn edited(from: &str, to: &str) -> String {
    assert!(GOOD.contains(from), "the good scene has no `{from}`");
    GOOD.replacen(from, to, 1)
}

#[test]
fn each_bad_scene_is_refused_with_place_and_reason() {
    let folder = folder();
    assert!(CASES.len() >= 40);
    let mut failures = Vec::new();
    for case in CASES {
        let text = edited(case.from, case.to);
        let Some(at) = text.find(case.line) else {
            panic!("`{}` is not in the scene", case.line);
        };
        let line = 1 + text[..at].matches('\n').count();
        match load(&text, folder.path()) {
            Ok(_) => failures.push(format!("`{}` was accepted", case.to)),
            Err(error) => {
                let near = |found: usize| found == line || found + 1 == line;
                let hit = error.problems.iter().any(|p| {
                    let said = format!("{} {}", p.message, p.help.as_deref().unwrap_or(""));
                    p.path == case.path && near(p.line) && said.contains(case.text)
                });
                if !hit || error.problems.len() > 4 {
                    failures.push(format!(
                        "`{}` wants {}:{line} `{}`, got\n{}",
                        case.to,
                        case.path,
                        case.text,
                        error.plain()
                    ));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n---\n"));
}

#[test]
fn all_problems_are_reported_at_once_in_order() {
    let folder = folder();
    let text = GOOD
        .replacen("step = 1e-3", "step = -1.0\ncolour = \"red\"", 1)
        .replacen("density = 2500.0", "density = \"heavy\"\ndensty = 3", 1)
        .replacen("r0 = 1.0", "r0 = \"one\"", 1)
        .replacen("u = [1.0, 0.0, 0.0]", "u = [1.0]", 1)
        .replacen("\"grains[4]\"", "\"sand\"", 1);
    let error = load(&text, folder.path()).unwrap_err();
    let paths: Vec<&str> = error.problems.iter().map(|p| p.path.as_str()).collect();
    let expected = [
        "simulation.step",
        "simulation.colour",
        "material[0].density",
        "material[0].densty",
        "boundary[1].faces[0].rectangle.u",
        "boundary[1].faces[1].cone.r0",
        "load[0].sphere",
    ];
    assert_eq!(paths, expected, "{}", error.plain());
    assert!(error.problems.is_sorted_by_key(|p| p.line));
}

#[test]
fn a_missing_scene_file_is_a_problem() {
    let error = Scene::from_file("no/such/scene.toml").unwrap_err();
    assert!(
        error.plain().contains("cannot read the file"),
        "{}",
        error.plain()
    );
}

#[test]
fn the_good_scene_means_what_it_says() {
    let folder = folder();
    let loaded = load(GOOD, folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
    let scene = &loaded.scene;
    assert_eq!(scene.particles.len(), 7);
    assert_eq!(
        scene.particles.mass[6],
        4.0 / 3.0 * std::f64::consts::PI * 2500.0 * 0.2_f64.powi(3)
    );
    assert_eq!(scene.pairs.get(0, 1).friction, 20_f64.to_radians().tan());
    assert_eq!(scene.pairs.get(0, 0).friction, 0.3);
    assert_eq!(scene.particles.locks[6].translation, [false, true, false]);
    assert_eq!(scene.loads[0].sphere, 4);
    assert_eq!(scene.springs[0].target.z, 3.0);
    assert_eq!(scene.probes[0].sphere, 6);
    assert_eq!(scene.settings.gravity.z, -9.81);
    assert!(
        matches!(scene.sensors[0].measure, Measure::MassFlow { normal, .. } if normal.z == -1.0)
    );
    assert!(
        matches!(&scene.boundaries[0].geometry.shapes()[0], Shape::HalfSpace(p) if p.normal.z == 1.0)
    );
    assert!(matches!(scene.boundaries[1].motion, Motion::Table { .. }));
    // Jitter stays within its bound.
    for (k, centre) in scene.initial.position[..6].iter().enumerate() {
        let node = nalgebra::Vector3::new((k % 3) as f64 * 0.3, (k / 3) as f64 * 0.3, 0.2);
        assert!((centre - node).amax() <= 0.03 && (centre - node).amax() > 0.0);
    }
    assert!(loaded.warnings.is_empty());
}

#[test]
fn inputs_meshes_and_csv_are_read_and_packed() {
    let folder = folder();
    let text = GOOD
        .replacen("radius = [0.2]\npositions = [[0.0, 0.0, 3.0]]", "csv = \"./good.csv\"", 1)
        .replacen("{ cone = { base = [20.0, 0.0, 0.0], r0 = 1.0, r1 = 2.0, height = 1.0 } }", "{ stl = { file = \"good.stl\" } }, { terrain = { file = \"good.asc\" } }", 1)
        .replacen("motion = { table = { time = [0.0, 1.0], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]] } }", "input = { hinge = [0, 3, 0] }", 1)
        .replace("\"one\"\nstiffness", "\"one[0]\"\nstiffness")
        .replace("\"one\"\n[output]", "\"one[1]\"\n[output]");
    let loaded = load(&text, folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
    let scene = &loaded.scene;
    assert_eq!(scene.particles.radius[6..], [0.2, 0.1]);
    assert_eq!(scene.initial.velocity[7].x, -1.0);
    assert!(
        matches!(scene.boundaries[1].motion, Motion::Input(InputKind::Hinge { axis }) if axis.y == 1.0)
    );
    let packed: Vec<&str> = loaded.attachments.iter().map(|a| a.path.as_str()).collect();
    assert_eq!(packed, ["good.asc", "good.csv", "good.stl"]);
    // The same content in another folder is the same scene; other content is another.
    let elsewhere = tempfile::tempdir().unwrap();
    for file in &loaded.attachments {
        std::fs::write(elsewhere.path().join(&file.path), &file.content).unwrap();
    }
    let moved = load(&text, elsewhere.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
    assert_eq!(moved.scene, *scene);
    std::fs::write(
        elsewhere.path().join("good.csv"),
        "x,y,z,radius\n0,0,3,0.2\n0,0,4,0.2\n",
    )
    .unwrap();
    let changed = load(&text, elsewhere.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
    assert_ne!(changed.scene.hash, scene.hash);
}

#[test]
fn the_hash_depends_on_the_text_alone() {
    let folder = folder();
    let hash = |text: &str| load(text, folder.path()).unwrap().scene.hash;
    assert_eq!(hash(GOOD), hash(GOOD));
    assert_ne!(hash(GOOD), hash(&format!("{GOOD}# comment\n")));
    assert_eq!(hash(GOOD).len(), 64);
}

#[test]
fn what_has_no_effect_is_a_warning() {
    let folder = folder();
    let warnings = |to: &str| {
        load(&edited("step = 1e-3", to), folder.path())
            .unwrap()
            .warnings
    };
    let shi = warnings("step = 1e-3\nintegrator = \"shi\"");
    assert_eq!(shi.len(), 1);
    assert!(shi[0].message.contains("restitution has no effect"));
    let moreau = warnings("step = 1e-3\ndynamic_coefficient = 0.5");
    assert_eq!(moreau[0].path, "simulation.dynamic_coefficient");
    assert_eq!(moreau[0].line, 5);
    let overlap = edited("origin = [0.0, 0.0, 0.2]", "origin = [0.0, 0.0, 0.098]").replacen(
        ", jitter = 0.1",
        "",
        1,
    );
    let overlap = load(&overlap, folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
    assert!(
        overlap.warnings[0]
            .message
            .contains("6 overlaps in all are removed"),
        "{:?}",
        overlap.warnings
    );
}

/// Names of types as Rust has them: a user has never seen these.
#[test]
fn no_message_names_a_type_of_rust() {
    let folder = folder();
    let values = [
        "1",
        "-1",
        "1.5",
        "true",
        "\"a\"",
        "[]",
        "[1]",
        "[\"a\"]",
        "{}",
        "{ a = 1 }",
        "1979-05-27",
    ];
    let mut failures = Vec::new();
    let keys = GOOD.lines().filter_map(|line| line.split_once(" = "));
    for (key, typed) in keys.filter(|(key, typed)| !key.contains('{') && *typed != "[") {
        for value in values {
            let text = edited(&format!("{key} = {typed}"), &format!("{key} = {value}"));
            let Err(error) = load(&text, folder.path()) else {
                continue;
            };
            for problem in &error.problems {
                let mut words = problem.message.split(|c: char| !c.is_alphanumeric());
                let leaks = [
                    "f64", "u32", "u64", "i64", "variant", "struct", "sequence", "map", "newtype",
                    "enum", "tuple",
                ];
                if words.any(|word| leaks.contains(&word)) {
                    failures.push(format!("{key} = {value}: {problem}"));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn summary_suggests_step_and_penalty_by_their_formulas() {
    let folder = folder();
    let summary = Summary::of(&load(GOOD, folder.path()).unwrap().scene);
    let step = (1e-6 * 0.1 / (0.2 * 9.81_f64)).sqrt();
    assert!((summary.suggested_step / step - 1.0).abs() < 1e-12);
    let mass = 4.0 / 3.0 * std::f64::consts::PI * 2500.0 * 0.2_f64.powi(3);
    assert!((summary.suggested_penalty / (10.0 * mass / 1e-6) - 1.0).abs() < 1e-12);
    let text = summary.to_string();
    for part in [
        "7, radius 0.1 to 0.2 m",
        "floor           unbounded plane",
        "gate            (9, -2, 0) to (22, 2, 1) m, 13 x 4 x 1 m",
        "  sensors           2\n  probes            1\n",
        "of CPU time per simulated second (estimate",
    ] {
        assert!(text.contains(part), "{part} is not in\n{text}");
    }
}

#[test]
fn the_examples_are_good_scenes_without_overlaps() {
    for (name, spheres) in [
        ("funnel", 200),
        ("slopes", 180),
        ("feeder", 150),
        ("landslide", 300),
    ] {
        let path =
            Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}/{name}.toml"));
        let loaded = Scene::from_file(&path).unwrap_or_else(|e| panic!("{}", e.plain()));
        assert_eq!(loaded.scene.particles.len(), spheres);
        // The paper's penalty is kept for `--method penalty`.
        let warned = loaded.warnings.iter().any(|w| w.is_warning());
        assert!(!warned, "{:?}", loaded.warnings);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    /// Whatever is cut out of a scene, put into it or written twice, it is accepted or refused with a place.
    #[test]
    fn no_scene_text_panics(
        at in 0..GOOD.len(),
        length in 0_usize..60,
        put in prop::sample::select(vec![
            "", "0", "-", "nan", "\"", "[", "]]", "{", "}", "=", "\n", "[[spheres]]\n", "= 1\n", ".", "1e400", "é", "[simulation]\n",
        ]),
        twice in any::<bool>(),
    ) {
        let end = (at + length).min(GOOD.len());
        let kept = if twice { &GOOD[at..end] } else { "" };
        let text = format!("{}{put}{kept}{kept}{}", &GOOD[..at], &GOOD[end..]);
        match load(&text, Path::new("")) {
            Ok(loaded) => prop_assert!(!loaded.scene.particles.is_empty()),
            Err(error) => {
                prop_assert!(!error.problems.is_empty());
                for problem in &error.problems {
                    prop_assert!(problem.line >= 1 && problem.span.offset() <= text.len());
                    prop_assert!(!problem.message.is_empty());
                }
            }
        }
    }
}

/// Messages point at a place of any column, and show a part of a long line.
#[test]
fn long_lines_are_shown_in_part() {
    let numbers = "1, ".repeat(40_000);
    for (line, found) in [
        (format!("x = [{numbers}q]"), "found `"),
        (format!("title = [{numbers}nan]"), "found nan"),
        (
            format!("title = \"{}\" oops", "ü".repeat(40_000)),
            "this is not TOML",
        ),
    ] {
        let text = format!("{line}\n{GOOD}").replace("title = \"box\"\n", "");
        let error = Scene::from_toml("scene.toml", &text, Path::new("")).unwrap_err();
        assert!(error.plain().contains(found), "{}", error.plain());
        let shown = format!("{:?}", miette::Report::new(error));
        assert!(shown.len() < 3000, "{} characters", shown.len());
        assert!(shown.contains("scene.toml:1:"), "{shown}");
    }
}
