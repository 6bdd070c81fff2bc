//! What masters read of a system beyond the standard.

use serde::Serialize;

/// What OMSimulator reads of a system, which it does not open without: the master and its communication step.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(super) struct Annotations {
    #[serde(rename = "ssc:Annotation")]
    annotation: Annotation,
}

#[derive(Debug, Clone, PartialEq, Default, Serialize)]
struct Annotation {
    #[serde(rename = "@type")]
    kind: &'static str,
    #[serde(rename = "oms:Annotations")]
    annotations: OmsAnnotations,
}

#[derive(Debug, Clone, PartialEq, Default, Serialize)]
struct OmsAnnotations {
    #[serde(rename = "@xmlns:oms")]
    namespace: &'static str,
    #[serde(rename = "oms:SimulationInformation")]
    information: SimulationInformation,
}

#[derive(Debug, Clone, PartialEq, Default, Serialize)]
struct SimulationInformation {
    #[serde(rename = "oms:FixedStepMaster")]
    master: FixedStepMaster,
}

#[derive(Debug, Clone, PartialEq, Default, Serialize)]
struct FixedStepMaster {
    #[serde(rename = "@description")]
    description: &'static str,
    #[serde(rename = "@stepSize")]
    step_size: f64,
    #[serde(rename = "@absoluteTolerance")]
    absolute_tolerance: f64,
    #[serde(rename = "@relativeTolerance")]
    relative_tolerance: f64,
}

impl Annotations {
    /// A fixed communication `step` \[s\].
    pub(super) fn of(step: f64) -> Self {
        let master = FixedStepMaster {
            description: "oms-ma",
            step_size: step,
            absolute_tolerance: 1e-4,
            relative_tolerance: 1e-4,
        };
        let annotations = OmsAnnotations {
            namespace: "https://raw.githubusercontent.com/OpenModelica/OMSimulator/master/schema/oms.xsd",
            information: SimulationInformation { master },
        };
        Self {
            annotation: Annotation {
                kind: "org.openmodelica",
                annotations,
            },
        }
    }
}
