//! What is written: a system structure and a set of parameter values.

use serde::Serialize;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::lexical;
use sphere_dda_model_description::units::{BaseUnit, Unit};
use sphere_dda_model_description::xml;

use super::names::{FMU, SSC, SSD, SSP_VERSION, SSV};

/// The root of `SystemStructure.ssd`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct SystemStructure {
    #[serde(rename = "@xmlns:ssd")]
    ssd: &'static str,
    #[serde(rename = "@xmlns:ssc")]
    ssc: &'static str,
    #[serde(rename = "@version")]
    version: &'static str,
    /// Name, for people.
    #[serde(rename = "@name")]
    pub(crate) name: String,
    /// Tool that wrote it.
    #[serde(rename = "@generationTool")]
    pub(crate) generation_tool: String,
    /// The system.
    #[serde(rename = "ssd:System")]
    pub(crate) system: TopSystem,
    /// Enumerations that connectors refer to.
    #[serde(rename = "ssd:Enumerations", skip_serializing_if = "Option::is_none")]
    enumerations: Option<Enumerations>,
    /// Units that connectors refer to.
    #[serde(rename = "ssd:Units", skip_serializing_if = "Option::is_none")]
    units: Option<Units>,
    /// Suggested experiment.
    #[serde(rename = "ssd:DefaultExperiment")]
    pub(crate) default_experiment: Experiment,
}

impl SystemStructure {
    /// A system with the units and enumerations of its connectors.
    #[must_use]
    pub(crate) fn new(
        name: &str,
        tool: &str,
        system: TopSystem,
        units: &[Unit],
        enumerations: Vec<Enumeration>,
        default_experiment: Experiment,
    ) -> Self {
        Self {
            ssd: SSD,
            ssc: SSC,
            version: SSP_VERSION,
            name: name.to_owned(),
            generation_tool: tool.to_owned(),
            system,
            enumerations: Enumerations::of(enumerations),
            units: Units::of(units),
            default_experiment,
        }
    }

    /// The text of a `.ssd`.
    ///
    /// # Errors
    /// [`Error::Character`] if a text has a character that XML cannot carry.
    pub(crate) fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, "ssd:SystemStructureDescription")
    }
}

/// Suggested start and end \[s\].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct Experiment {
    /// Start.
    #[serde(
        rename = "@startTime",
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub(crate) start_time: Option<f64>,
    /// End.
    #[serde(
        rename = "@stopTime",
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub(crate) stop_time: Option<f64>,
}

/// Components and the connections between them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct TopSystem {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "ssd:ParameterBindings")]
    bindings: Bindings,
    #[serde(rename = "ssd:Elements")]
    elements: Elements,
    #[serde(rename = "ssd:Connections", skip_serializing_if = "Option::is_none")]
    connections: Option<Connections>,
}

impl TopSystem {
    /// A system with the parameter values in the file `values`, which names parameters `<component>.<parameter>`.
    #[must_use]
    pub(crate) fn new(
        name: &str,
        values: &str,
        components: Vec<Component>,
        connections: Vec<Connection>,
    ) -> Self {
        Self {
            name: name.to_owned(),
            bindings: Bindings {
                bindings: [Binding {
                    source: values.to_owned(),
                }],
            },
            elements: Elements { components },
            connections: (!connections.is_empty()).then_some(Connections { connections }),
        }
    }
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Bindings {
    #[serde(rename = "ssd:ParameterBinding")]
    bindings: [Binding; 1],
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Binding {
    #[serde(rename = "@source")]
    source: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Elements {
    #[serde(rename = "ssd:Component")]
    components: Vec<Component>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Connections {
    #[serde(rename = "ssd:Connection")]
    connections: Vec<Connection>,
}

/// An FMU in the system.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Component {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@type")]
    kind: &'static str,
    #[serde(rename = "@source")]
    source: String,
    #[serde(rename = "@implementation")]
    implementation: &'static str,
    #[serde(rename = "ssd:Connectors", skip_serializing_if = "Option::is_none")]
    connectors: Option<Connectors>,
}

impl Component {
    /// The co-simulation FMU in the file `source`, an URI inside the package.
    #[must_use]
    pub(crate) fn new(name: &str, source: &str, connectors: Vec<Connector>) -> Self {
        Self {
            name: name.to_owned(),
            kind: FMU,
            source: source.to_owned(),
            implementation: "CoSimulation",
            connectors: (!connectors.is_empty()).then_some(Connectors { connectors }),
        }
    }
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Connectors {
    #[serde(rename = "ssd:Connector")]
    connectors: Vec<Connector>,
}

/// A variable of a component.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Connector {
    /// Its name.
    #[serde(rename = "@name")]
    pub(crate) name: String,
    /// `input`, `output` or `parameter`.
    #[serde(rename = "@kind")]
    pub(crate) kind: &'static str,
    /// Its type.
    #[serde(rename = "$value")]
    pub(crate) signal: Signal,
}

/// Type of a connector.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) enum Signal {
    /// A real number.
    #[serde(rename = "ssc:Real")]
    Real {
        /// Its unit.
        #[serde(rename = "@unit", skip_serializing_if = "Option::is_none")]
        unit: Option<String>,
    },
    /// An integer.
    #[serde(rename = "ssc:Integer")]
    Integer,
    /// A truth value.
    #[serde(rename = "ssc:Boolean")]
    Boolean,
    /// A text.
    #[serde(rename = "ssc:String")]
    String,
    /// An item of an enumeration.
    #[serde(rename = "ssc:Enumeration")]
    Enumeration {
        /// Name of the enumeration.
        #[serde(rename = "@name")]
        name: String,
    },
}

/// An output that feeds an input: component and connector of both.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct Connection {
    /// Component of the output.
    #[serde(rename = "@startElement")]
    pub(crate) start_element: String,
    /// The output.
    #[serde(rename = "@startConnector")]
    pub(crate) start_connector: String,
    /// Component of the input.
    #[serde(rename = "@endElement")]
    pub(crate) end_element: String,
    /// The input.
    #[serde(rename = "@endConnector")]
    pub(crate) end_connector: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Units {
    #[serde(rename = "ssc:Unit")]
    units: Vec<PlainUnit>,
}

/// A unit without display units, which SSP does not know.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct PlainUnit {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "ssc:BaseUnit")]
    base: BaseUnit,
}

impl Units {
    fn of(units: &[Unit]) -> Option<Self> {
        let plain = |unit: &Unit| PlainUnit {
            name: unit.name.clone(),
            base: unit.base_unit.unwrap_or(BaseUnit::DIMENSIONLESS),
        };
        let units: Vec<PlainUnit> = units.iter().map(plain).collect();
        (!units.is_empty()).then_some(Self { units })
    }
}

#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
struct Enumerations {
    #[serde(rename = "ssc:Enumeration")]
    enumerations: Vec<Enumeration>,
}

impl Enumerations {
    fn of(enumerations: Vec<Enumeration>) -> Option<Self> {
        (!enumerations.is_empty()).then_some(Self { enumerations })
    }
}

/// Integers with names.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct Enumeration {
    /// Its name.
    #[serde(rename = "@name")]
    pub(crate) name: String,
    /// The items.
    #[serde(rename = "ssc:Item")]
    pub(crate) items: Vec<Item>,
}

/// One named integer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct Item {
    /// Its name.
    #[serde(rename = "@name")]
    pub(crate) name: String,
    /// Its value.
    #[serde(rename = "@value", with = "lexical")]
    pub(crate) value: i64,
}

/// The root of a `.ssv`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct ParameterSet {
    #[serde(rename = "@xmlns:ssv")]
    ssv: &'static str,
    #[serde(rename = "@xmlns:ssc")]
    ssc: &'static str,
    #[serde(rename = "@version")]
    version: &'static str,
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@generationTool")]
    generation_tool: String,
    #[serde(rename = "ssv:Parameters")]
    parameters: Parameters,
    #[serde(rename = "ssv:Units", skip_serializing_if = "Option::is_none")]
    units: Option<Units>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Parameters {
    #[serde(rename = "ssv:Parameter")]
    parameters: Vec<Parameter>,
}

/// A parameter and its value.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Parameter {
    /// Name: `<component>.<parameter>`.
    #[serde(rename = "@name")]
    pub(crate) name: String,
    /// Type and value.
    #[serde(rename = "$value")]
    pub(crate) value: ParameterValue,
}

/// Type and value of a parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) enum ParameterValue {
    /// A real number.
    #[serde(rename = "ssv:Real")]
    Real {
        /// The number.
        #[serde(rename = "@value", with = "lexical")]
        value: f64,
        /// Its unit.
        #[serde(rename = "@unit", skip_serializing_if = "Option::is_none")]
        unit: Option<String>,
    },
    /// An integer.
    #[serde(rename = "ssv:Integer")]
    Integer {
        /// The number.
        #[serde(rename = "@value", with = "lexical")]
        value: i64,
    },
    /// A truth value.
    #[serde(rename = "ssv:Boolean")]
    Boolean {
        /// Whether it is true.
        #[serde(rename = "@value", with = "lexical")]
        value: bool,
    },
    /// A text.
    #[serde(rename = "ssv:String")]
    String {
        /// The text.
        #[serde(rename = "@value")]
        value: String,
    },
    /// An item of an enumeration.
    #[serde(rename = "ssv:Enumeration")]
    Enumeration {
        /// Name of the item.
        #[serde(rename = "@value")]
        value: String,
    },
}

impl ParameterSet {
    /// Values with the units they are in.
    #[must_use]
    pub(crate) fn new(name: &str, tool: &str, parameters: Vec<Parameter>, units: &[Unit]) -> Self {
        Self {
            ssv: SSV,
            ssc: SSC,
            version: SSP_VERSION,
            name: name.to_owned(),
            generation_tool: tool.to_owned(),
            parameters: Parameters { parameters },
            units: Units::of(units),
        }
    }

    /// The text of a `.ssv`.
    ///
    /// # Errors
    /// [`Error::Character`] if a text has a character that XML cannot carry.
    pub(crate) fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, "ssv:ParameterSet")
    }
}
