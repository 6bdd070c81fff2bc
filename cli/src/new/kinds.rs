//! What `sphere-dda new` can begin with: the scenes of the examples, and what their drivers move and plot.

use clap::ValueEnum;

/// A machine or a process.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// A trough that vibrates and conveys grains into a bin.
    Feeder,
    /// A bin of 2000 grains over a flap gate that opens.
    Hopper,
    /// A drum on a hinge, turned by a torque.
    Drum,
    /// A belt that carries what a chute drops.
    Conveyor,
    /// A bucket of grains that is shaken.
    Bucket,
    /// Boulders that run down a valley.
    Landslide,
    /// The funnel of the paper: 200 spheres through a cone.
    Paper,
}

/// What one of them is made of.
pub(super) struct Parts {
    /// The scene file.
    pub(super) scene: &'static str,
    /// Other files, by name.
    pub(super) files: &'static [(&'static str, &'static str)],
    /// Input and its value over the time `t`, in Python.
    pub(super) inputs: &'static [(&'static str, &'static str)],
    /// What is plotted.
    pub(super) outputs: &'static [&'static str],
    /// End time and communication step of the driver \[s\], as Python writes them.
    pub(super) times: [&'static str; 2],
}

impl Kind {
    pub(super) fn parts(self) -> Parts {
        match self {
            Self::Feeder => Parts {
                scene: include_str!("../../../examples/feeder/feeder.toml"),
                files: &[],
                inputs: &[(
                    "boundary.trough.displacement",
                    "1.5e-3 * min(t / 0.1, 1) * np.sin(2 * np.pi * 18 * t)",
                )],
                outputs: &["boundary.trough.averageForce[3]", "sensor.flow.mass"],
                times: ["4.0", "2e-3"],
            },
            Self::Hopper => Parts {
                scene: include_str!("../../../examples/hopper/hopper.toml"),
                files: &[],
                inputs: &[("boundary.gate.angle", "0.9 * min(t / 0.3, 1)")],
                outputs: &["sensor.stock.mass", "sensor.outflow.mass"],
                times: ["2.0", "5e-3"],
            },
            Self::Drum => Parts {
                scene: include_str!("../../../examples/drum/drum.toml"),
                files: &[],
                inputs: &[("boundary.drum.appliedTorque", "0.1 * min(t / 0.1, 1)")],
                outputs: &["boundary.drum.angularVelocity[2]", "kineticEnergy"],
                times: ["2.0", "1e-3"],
            },
            Self::Conveyor => Parts {
                scene: include_str!("../../../examples/conveyor/conveyor.toml"),
                files: &[],
                inputs: &[("boundary.belt.surfaceVelocity[1]", "0.6 + 0.6 * (t > 3)")],
                outputs: &["boundary.belt.averageForce[1]", "sensor.carried.mass"],
                times: ["6.0", "5e-3"],
            },
            Self::Bucket => Parts {
                scene: include_str!("../../../examples/bucket/bucket.toml"),
                files: &[],
                inputs: &[(
                    "boundary.bucket.velocity[3]",
                    "0.1 * np.sin(2 * np.pi * 4 * t)",
                )],
                outputs: &["boundary.bucket.averageForce[3]", "kineticEnergy"],
                times: ["1.5", "1e-3"],
            },
            Self::Landslide => Parts {
                scene: include_str!("../../../examples/landslide/landslide.toml"),
                files: &[(
                    "valley.asc",
                    include_str!("../../../examples/landslide/valley.asc"),
                )],
                inputs: &[],
                outputs: &["sensor.gate.mass", "sensor.deposit.mass", "kineticEnergy"],
                times: ["20.0", "0.05"],
            },
            Self::Paper => Parts {
                scene: include_str!("../../../examples/funnel/funnel.toml"),
                files: &[],
                inputs: &[],
                outputs: &["sensor.discharge.mass", "sensor.content.mass"],
                times: ["8.6", "0.02"],
            },
        }
    }
}
