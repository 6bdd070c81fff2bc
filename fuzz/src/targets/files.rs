//! Files that a scene refers to. The first byte of an input says which one it is.

use std::fs;

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;
use std::path::Path;
use std::sync::Arc;

use super::Target;
use super::scene::takes;

/// A scene whose groups, boundary or motion come from the file `x`.
const SCENES: [&str; 6] = [
    "[[boundary]]\nname = \"b\"\nmaterial = \"m\"\nfaces = [{ stl = { file = \"x\" } }]\n",
    "[[boundary]]\nname = \"b\"\nmaterial = \"m\"\nfaces = [{ terrain = { file = \"x\" } }]\n",
    "[[spheres]]\nname = \"c\"\nmaterial = \"m\"\nradius = 0.01\ncsv = \"x\"\n",
    "[[spheres]]\nname = \"c\"\nmaterial = \"m\"\nvtu = \"x\"\n",
    "[[spheres]]\nname = \"c\"\nmaterial = \"m\"\ncheckpoint = \"x\"\n",
    "[[boundary]]\nname = \"b\"\nmaterial = \"m\"\nfaces = [{ plane = { point = [0, 0, -9], normal = [0, 0, 1] } }]\nmotion = { table = { csv = \"x\" } }\n",
];
const HEAD: &str = "[simulation]\nduration = 1.0\nstep = 1e-3\n[[material]]\nname = \"m\"\ndensity = 1000.0\n\
                    [[spheres]]\nname = \"s\"\nmaterial = \"m\"\nradius = 0.01\npositions = [[0.2, 0.2, 5.0]]\n";

pub(super) struct Files;

impl Target for Files {
    fn name(&self) -> &'static str {
        "files"
    }

    fn corpus(&self) -> Vec<Vec<u8>> {
        let text = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n";
        let mut binary = vec![b' '; 80];
        binary.extend(1_u32.to_le_bytes());
        let corners: [f32; 12] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        binary.extend(corners.iter().flat_map(|x| x.to_le_bytes()));
        binary.extend([0, 0]);
        let grid = "ncols 3\nnrows 2\nxllcorner -0.5\nyllcorner 0\ncellsize 1.0\nNODATA_value -9999\n1 2 3\n0.5 -9999 1\n";
        let table = "time [s],x [m],y [m],z [m],rx [rad],ry [rad],rz [rad]\n0,0,0,0,0,0,0\n1,0,0,0.1,0,0.2,0\n";
        let places = "x [m],y [m],z [m],radius [m],vx [m/s],vy [m/s],vz [m/s]\n0,0,1,0.01,0,0,-1\n0,0,2,0.02,0,0,0\n";
        let kind = |kind: u8, bytes: &[u8]| [&[kind], bytes].concat();
        let mut corpus = vec![
            kind(0, text.as_bytes()),
            kind(0, &binary),
            kind(1, grid.as_bytes()),
            kind(2, places.as_bytes()),
            kind(5, table.as_bytes()),
        ];
        // What the program itself writes.
        if let Ok(loaded) = Scene::from_toml("scene.toml", HEAD, Path::new(""))
            && let Ok(simulation) = Simulation::new(Arc::new(loaded.scene))
        {
            corpus.push(kind(4, &simulation.snapshot()));
        }
        let frame = include_bytes!("corpus/frame.vtu");
        corpus.push(kind(3, frame));
        corpus
    }

    fn attempt(&self, input: &[u8]) -> bool {
        let Some((kind, bytes)) = input.split_first() else {
            return false;
        };
        let Some(scene) = SCENES.get(usize::from(*kind)) else {
            return false;
        };
        let bytes = match kind {
            4 => super::state::sealed_snapshot(bytes.to_vec()),
            _ => bytes.to_vec(),
        };
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("x"), bytes).expect("a file in it");
        takes(&format!("{HEAD}{scene}"), folder.path())
    }
}
