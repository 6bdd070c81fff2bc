//! The rows of the table that an importer reads: outputs of boundaries, probes, sensors and the whole.

use sphere_dda::scene::Measure;
use sphere_dda_model_description::fmi2::Causality;

use super::rows::{Row, Rows, XYZ};
use super::{BoundaryOutput, GlobalOutput, ProbeOutput, Quantity, SensorOutput};

impl Rows {
    pub(super) fn boundary(&mut self, prefix: &str, boundary: usize) {
        use BoundaryOutput as B;
        let vectors = [
            (
                "force",
                XYZ,
                Some("N"),
                "Force of the spheres on the boundary, last internal step",
                B::Force,
            ),
            (
                "torque",
                XYZ,
                Some("N.m"),
                "Its torque about the point of action",
                B::Torque,
            ),
            (
                "averageForce",
                XYZ,
                Some("N"),
                "Force averaged over the communication step, impulse / h",
                B::AverageForce,
            ),
            (
                "averageTorque",
                XYZ,
                Some("N.m"),
                "Torque averaged over the communication step",
                B::AverageTorque,
            ),
            ("position", XYZ, Some("m"), "Point of action", B::Position),
            (
                "orientation",
                4,
                None,
                "Orientation from the scene's, unit quaternion",
                B::Orientation,
            ),
        ];
        for (name, size, unit, text, output) in vectors {
            self.vector(
                (format!("{prefix}.{name}"), size),
                unit,
                text,
                Causality::Output,
                |axis| Quantity::Boundary {
                    boundary,
                    output,
                    axis,
                },
            );
        }
        let of = |output| Quantity::Boundary {
            boundary,
            output,
            axis: 0,
        };
        let row = Row::count(
            format!("{prefix}.contactCount"),
            "Number of loaded contacts",
        );
        self.push(row, Causality::Output, of(B::ContactCount));
        let row = Row::real(
            format!("{prefix}.maxNormalForce"),
            Some("N"),
            "Largest normal force of one contact",
        );
        self.push(row, Causality::Output, of(B::MaxNormalForce));
        let row = Row::real(
            format!("{prefix}.power"),
            Some("W"),
            "Power of the spheres on the boundary",
        );
        self.push(row, Causality::Output, of(B::Power));
    }

    pub(super) fn probe(&mut self, prefix: &str, probe: usize) {
        use ProbeOutput as P;
        let vectors = [
            (
                "position",
                XYZ,
                Some("m"),
                "Centre of the sphere",
                P::Position,
            ),
            (
                "orientation",
                4,
                None,
                "Orientation, unit quaternion",
                P::Orientation,
            ),
            (
                "velocity",
                XYZ,
                Some("m/s"),
                "Velocity of the centre",
                P::Velocity,
            ),
            (
                "angularVelocity",
                XYZ,
                Some("rad/s"),
                "Angular velocity, world axes",
                P::AngularVelocity,
            ),
            (
                "contactForce",
                XYZ,
                Some("N"),
                "Sum of the contact forces on the sphere",
                P::ContactForce,
            ),
            (
                "contactTorque",
                XYZ,
                Some("N.m"),
                "Torque of the contact forces about the centre",
                P::ContactTorque,
            ),
        ];
        for (name, size, unit, text, output) in vectors {
            self.vector(
                (format!("{prefix}.{name}"), size),
                unit,
                text,
                Causality::Output,
                |axis| Quantity::Probe {
                    probe,
                    output,
                    axis,
                },
            );
        }
        let of = |output| Quantity::Probe {
            probe,
            output,
            axis: 0,
        };
        let row = Row::count(
            format!("{prefix}.contactCount"),
            "Number of loaded contacts",
        );
        self.push(row, Causality::Output, of(P::ContactCount));
        let row = Row::real(
            format!("{prefix}.maxNormalForce"),
            Some("N"),
            "Largest normal force of one contact",
        );
        self.push(row, Causality::Output, of(P::MaxNormalForce));
    }

    pub(super) fn sensor(&mut self, prefix: &str, sensor: usize, measure: &Measure) {
        let of = |output| Quantity::Sensor { sensor, output };
        let mass = |name: String, text: &str| Row::real(name, Some("kg"), text);
        match measure {
            Measure::Region(_) => {
                let row = mass(
                    prefix.to_owned(),
                    "Mass of the spheres whose centre is in the box",
                );
                self.push(row, Causality::Output, of(SensorOutput::Mass));
            }
            Measure::Wrench { boundary } => {
                use BoundaryOutput as B;
                let parts = [
                    ("force", "N", "Force on the boundary", B::AverageForce),
                    (
                        "torque",
                        "N.m",
                        "Torque on the boundary about its point of action",
                        B::AverageTorque,
                    ),
                ];
                for (name, unit, text, output) in parts {
                    self.vector(
                        (format!("{prefix}.{name}"), XYZ),
                        Some(unit),
                        &format!("{text}, averaged over the communication step"),
                        Causality::Output,
                        |axis| Quantity::Boundary {
                            boundary: *boundary,
                            output,
                            axis,
                        },
                    );
                }
            }
            Measure::MassFlow { .. } => {
                let text = "Mass that has crossed the plane along its normal since the start";
                let row = mass(format!("{prefix}.mass"), text);
                self.push(row, Causality::Output, of(SensorOutput::Mass));
                let text = "Mass flow through the plane, mean over the communication step";
                let row = Row::real(format!("{prefix}.rate"), Some("kg/s"), text);
                self.push(row, Causality::Output, of(SensorOutput::Rate));
            }
        }
    }

    pub(super) fn globals(&mut self) {
        use GlobalOutput as G;
        let of = |output| move |axis| Quantity::Global { output, axis };
        let text = "Momentum of the spheres, half-step velocities: averaged wrench x time + weight = its change";
        self.vector(
            ("momentum".into(), XYZ),
            Some("kg.m/s"),
            text,
            Causality::Output,
            of(G::Momentum),
        );
        let text = "Angular momentum about the origin, half-step velocities";
        self.vector(
            ("angularMomentum".into(), XYZ),
            Some("kg.m2/s"),
            text,
            Causality::Output,
            of(G::AngularMomentum),
        );
        let reals = [
            ("mass", Some("kg"), "Mass of all spheres", G::Mass),
            (
                "kineticEnergy",
                Some("J"),
                "Kinetic energy",
                G::KineticEnergy,
            ),
            (
                "potentialEnergy",
                Some("J"),
                "Potential energy of gravity and springs",
                G::PotentialEnergy,
            ),
            (
                "dissipatedEnergy",
                Some("J"),
                "Energy lost in contacts since the start",
                G::DissipatedEnergy,
            ),
            (
                "boundaryWork",
                Some("J"),
                "Work of moving boundaries on the spheres since the start",
                G::BoundaryWork,
            ),
            (
                "loadWork",
                Some("J"),
                "Work of point loads since the start",
                G::LoadWork,
            ),
            (
                "springWork",
                Some("J"),
                "Work of constrained springs since the start",
                G::SpringWork,
            ),
            (
                "maxOverlap",
                None,
                "Largest true overlap over radius in the communication step",
                G::MaxOverlap,
            ),
            (
                "solver.gapResidual",
                None,
                "Largest gap residual in the communication step",
                G::GapResidual,
            ),
            (
                "solver.slipResidual",
                None,
                "Largest slip residual in the communication step",
                G::SlipResidual,
            ),
            (
                "solver.forceResidual",
                None,
                "Largest force residual in the communication step",
                G::ForceResidual,
            ),
            (
                "recommendedStep",
                Some("s"),
                "Internal step advised at the present speeds",
                G::RecommendedStep,
            ),
        ];
        for (name, unit, text, output) in reals {
            self.push(
                Row::real(name, unit, text),
                Causality::Output,
                of(output)(0),
            );
        }
        let counts = [
            ("contactCount", "Number of loaded contacts", G::ContactCount),
            (
                "solver.internalSteps",
                "Internal steps of the communication step",
                G::InternalSteps,
            ),
            ("solver.cuts", "How many of them came from halving", G::Cuts),
            (
                "solver.sweeps",
                "Gauss-Seidel sweeps of the communication step",
                G::Sweeps,
            ),
            (
                "solver.augmentations",
                "Augmented-Lagrangian iterations of the communication step",
                G::Augmentations,
            ),
            (
                "solver.factorizations",
                "Factorizations of the communication step",
                G::Factorizations,
            ),
        ];
        for (name, text, output) in counts {
            self.push(Row::count(name, text), Causality::Output, of(output)(0));
        }
    }
}
