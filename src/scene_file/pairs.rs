//! How materials touch: `[[pair]]` over what their `[[material]]`s say over `[pair_default]`.

use super::cohesion::{self, Holding};
use super::decode::SceneFile;
use super::document::Document;
use super::names::Context;
use crate::contact::elasticity::{Elastic, Elasticity};
use crate::integrator::Integrator;
use crate::scene::Method;
use crate::scene::materials::{Pair, PairTable};

/// Coefficients as a table of the file gives them.
#[derive(Debug, Clone, Copy, Default)]
struct Given {
    friction: Option<f64>,
    restitution: Option<f64>,
    rolling: Option<f64>,
    twisting: Option<f64>,
    stiffness: Option<f64>,
    wear: Option<f64>,
}

/// Poisson's ratio of a material that gives Young's modulus alone.
const POISSON: f64 = 0.25;

impl Given {
    /// What two materials say together: of each coefficient the smaller one, or that of the one that gives it.
    fn of_both(a: Self, b: Self) -> Self {
        let smaller = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
        Self {
            friction: smaller(a.friction, b.friction),
            restitution: smaller(a.restitution, b.restitution),
            rolling: smaller(a.rolling, b.rolling),
            twisting: smaller(a.twisting, b.twisting),
            stiffness: smaller(a.stiffness, b.stiffness),
            wear: smaller(a.wear, b.wear),
        }
    }

    /// The pair that takes from `default` what is not given.
    fn over(self, default: Pair) -> Pair {
        Pair {
            friction: self.friction.unwrap_or(default.friction),
            restitution: self.restitution.unwrap_or(default.restitution),
            rolling_friction: self.rolling.unwrap_or(default.rolling_friction),
            twisting_friction: self.twisting.unwrap_or(default.twisting_friction),
            elasticity: self
                .stiffness
                .map(Elasticity::linear)
                .or(default.elasticity),
            wear: self.wear.unwrap_or(default.wear),
            ..default
        }
    }
}

/// The coefficients of a table of the file, checked: three types that have the same keys.
macro_rules! given {
    ($document:expr, $path:expr, $table:expr) => {{
        let table = $table;
        let given = Given {
            friction: table.friction,
            restitution: table.restitution,
            rolling: table.rolling_friction,
            twisting: table.twisting_friction,
            stiffness: table.stiffness,
            wear: table.wear,
        };
        checked($document, $path, given, table.friction_angle)
    }};
}

/// What holds surfaces together as a table of the file gives it: two types that have the same keys.
macro_rules! holding {
    ($table:expr) => {{
        let table = $table;
        Holding {
            cohesion: table.cohesion,
            surface_energy: table.surface_energy,
            adhesion: table.adhesion,
            rupture_distance: table.rupture_distance,
            bond: table.bond,
        }
    }};
}

/// `[pair_default]`, the coefficients of `[[material]]` and `[[pair]]`, checked.
pub(super) fn pairs(document: &mut Document<'_>, context: &Context, file: &SceneFile) -> PairTable {
    let default = given!(document, "pair_default", &file.pair_default).over(Pair::default());
    let materials = file.materials.iter();
    let materials: Vec<Given> = materials
        .map(|element| match &element.value {
            Some(value) => given!(document, &element.path, value),
            None => Given::default(),
        })
        .collect();
    let elastic = elastic(document, file);
    let method = file.simulation.as_ref().map(|s| s.method);
    let penalty = method == Some(Method::Penalty);
    let default = holding!(&file.pair_default).over(document, "pair_default", penalty, default);
    let both = |a: usize, b: usize| {
        // Moduli of the materials are more than a default.
        let hertz = Elasticity::hertz([elastic[a], elastic[b]]);
        let elasticity = hertz.or(default.elasticity);
        let default = Pair {
            elasticity,
            ..default
        };
        Given::of_both(materials[a], materials[b]).over(default)
    };
    let mut table = PairTable::new(materials.len(), default);
    let indices = || (0..materials.len()).filter_map(|a| u16::try_from(a).ok());
    for (a, b) in indices().flat_map(|a| indices().map(move |b| (a, b))) {
        table.set(a, b, both(a.into(), b.into()));
    }
    let mut seen: Vec<(usize, usize)> = Vec::new();
    let mut own_holds = Vec::new();
    for element in &file.pairs {
        let (path, Some(value)) = (&element.path, &element.value) else {
            continue;
        };
        let own = given!(document, path, value);
        let key = format!("{path}.materials");
        let [a, b] = value.materials.as_slice() else {
            document.demand(
                false,
                key,
                format!("{} names", value.materials.len()),
                "two material names [a, b]",
            );
            continue;
        };
        let a = context.materials.resolve(document, &format!("{key}[0]"), a);
        let b = context.materials.resolve(document, &format!("{key}[1]"), b);
        let Some((a, b)) = a.zip(b) else { continue };
        let pair_of = (a.min(b), a.max(b));
        if seen.contains(&pair_of) {
            document.error(
                key,
                format!("the pair {:?} appears twice", value.materials),
                "keep one; the order of the names does not matter",
            );
        }
        seen.push(pair_of);
        let pair = own.over(both(a, b));
        let pair = holding!(value).over(document, path, penalty, pair);
        if let (Ok(a), Ok(b)) = (u16::try_from(a), u16::try_from(b)) {
            table.set(a, b, pair);
            own_holds.push((a, b, path.clone()));
        }
    }
    clashes(document, &table, &own_holds);
    let shi = file
        .simulation
        .as_ref()
        .is_some_and(|s| s.integrator == Integrator::Shi);
    if shi && table.rebounds() {
        let help = "its rebound follows from the step (method of Shi 1988); use integrator = \"moreau\" for Newton's law";
        document.warn(
            "simulation.integrator",
            "restitution has no effect with integrator = \"shi\"",
            help,
        );
    }
    table
}

/// Tells what does not go together in the law of a pair, once for each table that gives it.
fn clashes(document: &mut Document<'_>, table: &PairTable, own: &[(u16, u16, String)]) {
    let mut told = Vec::new();
    for (a, b) in table.all() {
        let of = |(x, y, path): &(u16, u16, String)| {
            ((*x, *y) == (a, b) || (*x, *y) == (b, a)).then(|| path.clone())
        };
        let path = own.iter().find_map(of);
        let path = path.unwrap_or_else(|| "pair_default".into());
        if let Some((key, found, help)) = cohesion::clash(&table.get(a, b))
            && !told.contains(&path)
        {
            document.error((path.as_str(), key), found, help);
            told.push(path);
        }
    }
}

/// Young's modulus and Poisson's ratio of the materials that give them, checked.
fn elastic(document: &mut Document<'_>, file: &SceneFile) -> Vec<Option<Elastic>> {
    let mut all = Vec::new();
    for element in &file.materials {
        let (path, Some(value)) = (&element.path, &element.value) else {
            all.push(None);
            continue;
        };
        if let Some(young) = value.young {
            document.positive((path, "young"), young, "young > 0 [Pa]");
        }
        if let Some(poisson) = value.poisson {
            let expected = "0 <= poisson <= 0.5 [-]";
            document.within((path, "poisson"), poisson, 0.0..=0.5, expected);
        }
        if value.young.is_none() && value.poisson.is_some() {
            let message = "found `poisson` without `young`";
            document.error(
                (path, "poisson"),
                message,
                "give `young` [Pa] as well, or leave both out: rigid",
            );
        }
        if value.young.is_some() && value.stiffness.is_some() {
            let message = "found both `young` and `stiffness`, expected one of them";
            let help = "`young` is Hertz's law, `stiffness` a linear spring";
            document.error((path, "stiffness"), message, help);
        }
        all.push(value.young.map(|young| Elastic {
            young,
            poisson: value.poisson.unwrap_or(POISSON),
        }));
    }
    all
}

/// Checks the coefficients of the table at `path`.
fn checked(document: &mut Document<'_>, path: &str, given: Given, angle: Option<f64>) -> Given {
    let coefficients = [
        ("friction", given.friction),
        ("rolling_friction", given.rolling),
        ("twisting_friction", given.twisting),
    ];
    for (key, coefficient) in coefficients {
        if let Some(mu) = coefficient {
            document.within(format!("{path}.{key}"), mu, 0.0.., "a coefficient >= 0 [-]");
        }
    }
    if let Some(wear) = given.wear {
        document.within(
            format!("{path}.wear"),
            wear,
            0.0..,
            "a coefficient >= 0 [1/Pa]",
        );
    }
    if let Some(angle) = angle {
        let range = (0.0..90.0).contains(&angle);
        document.demand(
            range,
            (path, "friction_angle"),
            angle,
            "0 <= friction_angle < 90 [degrees]",
        );
    }
    if given.friction.is_some() && angle.is_some() {
        let message = "found both `friction` and `friction_angle`, expected one of them";
        document.error(
            (path, "friction_angle"),
            message,
            "friction is the tangent of the angle",
        );
    }
    if let Some(e) = given.restitution {
        document.within(
            (path, "restitution"),
            e,
            0.0..=1.0,
            "0 <= restitution <= 1 [-]",
        );
    }
    if let Some(stiffness) = given.stiffness {
        document.positive((path, "stiffness"), stiffness, "stiffness > 0 [N/m]");
    }
    Given {
        friction: given.friction.or(angle.map(|a| a.to_radians().tan())),
        ..given
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::scene::Scene;
    use crate::scene_file::{Loaded, SceneError};

    /// A scene of a rock on steel and rubber, with lines for the three materials and for the pairs.
    fn scene([rock, steel, rubber]: [&str; 3], pairs: &str) -> Result<Loaded, Box<SceneError>> {
        let text = format!(
            "[simulation]\nduration = 1.0\nstep = 1e-3\n\
             [[material]]\nname = \"rock\"\ndensity = 2500.0\n{rock}\n\
             [[material]]\nname = \"steel\"\n{steel}\n[[material]]\nname = \"rubber\"\n{rubber}\n{pairs}\n\
             [[spheres]]\nname = \"one\"\nmaterial = \"rock\"\nradius = 0.1\npositions = [[0.0, 0.0, 0.0]]\n"
        );
        Scene::from_toml("scene", &text, Path::new("")).map_err(Box::new)
    }

    fn numbers(table: &PairTable, a: u16, b: u16) -> [f64; 4] {
        let pair = table.get(a, b);
        assert_eq!(pair, table.get(b, a));
        [
            pair.friction,
            pair.restitution,
            pair.rolling_friction,
            pair.twisting_friction,
        ]
    }

    /// `[[pair]]` before the smaller of the materials before `[pair_default]` before zero, each coefficient for itself.
    #[test]
    fn coefficients_come_from_pairs_materials_defaults() {
        let rock = "friction = 0.5\nrolling_friction = 0.1\ntwisting_friction = 0.02";
        let steel = "friction_angle = 45.0\nrolling_friction = 0.01";
        let pairs = "[pair_default]\nrestitution = 0.3\ntwisting_friction = 0.07\n\
                     [[pair]]\nmaterials = [\"rubber\", \"rock\"]\nfriction = 0.9\nrestitution = 0.0";
        let loaded = scene([rock, steel, "restitution = 0.8"], pairs).unwrap();
        let table = &loaded.scene.pairs;
        assert_eq!(numbers(table, 0, 0), [0.5, 0.3, 0.1, 0.02]);
        assert_eq!(numbers(table, 0, 1), [0.5, 0.3, 0.01, 0.02]);
        assert_eq!(numbers(table, 0, 2), [0.9, 0.0, 0.1, 0.02]);
        let [friction, rest @ ..] = numbers(table, 1, 2);
        assert!((friction - 1.0).abs() < 1e-15);
        assert_eq!(rest, [0.8, 0.01, 0.07]);
        assert!(table.resists() && table.rebounds());
        let bare = scene(["", "", ""], "").unwrap();
        assert_eq!(numbers(&bare.scene.pairs, 0, 2), [0.0; 4]);
        assert!(!bare.scene.pairs.resists());
    }

    #[test]
    fn bad_coefficients_are_named() {
        let rolling = "rolling_friction = -0.1";
        let cases = [
            (
                [rolling, "", ""],
                "",
                "material[0].rolling_friction",
                "found -0.1",
            ),
            (
                ["", "restitution = 2.0", ""],
                "",
                "material[1].restitution",
                "<= 1",
            ),
            (
                ["", "", "friction = 1.0\nfriction_angle = 9.0"],
                "",
                "material[2].friction_angle",
                "both",
            ),
            (
                ["", "", ""],
                "[pair_default]\ntwisting_friction = -1.0",
                "pair_default.twisting_friction",
                ">= 0 [-]",
            ),
            (
                ["", "", ""],
                "[[pair]]\nmaterials = [\"rock\", \"steel\"]\nrolling_friction = -2.0",
                "pair[0].rolling_friction",
                "a coefficient >= 0",
            ),
            (
                ["", "", ""],
                "[pair_default]\nrolling_frction = 1.0",
                "pair_default.rolling_frction",
                "did you mean",
            ),
        ];
        for (materials, pairs, path, text) in cases {
            let error = scene(materials, pairs).unwrap_err();
            assert_eq!(error.problems.len(), 1, "{}", error.plain());
            assert_eq!(error.problems[0].path, path);
            assert!(error.plain().contains(text), "{}", error.plain());
        }
    }
}
