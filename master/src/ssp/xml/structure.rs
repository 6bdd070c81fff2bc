//! The structure of a system: components, connections, values of parameters.

use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use serde_with_macros::apply;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::lexical;
use sphere_dda_model_description::units::Unit;
use sphere_dda_model_description::xml;

use super::annotations::Annotations;
use super::document::{SSC, SSD, SSP_VERSION, read};
use super::parameters::{ParameterSet, Units};

/// Media type of an FMU.
const FMU: &str = "application/x-fmu-sharedlibrary";

/// The root of `SystemStructure.ssd`.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) struct Structure {
    #[serde(rename = "@xmlns:ssd", skip_deserializing)]
    ssd: &'static str,
    #[serde(rename = "@xmlns:ssc", skip_deserializing)]
    ssc: &'static str,
    #[serde(rename = "@version")]
    version: String,
    /// Name, for people.
    #[serde(rename = "@name", default)]
    name: String,
    /// Tool that wrote it.
    #[serde(rename = "@generationTool")]
    generation_tool: Option<String>,
    /// The system.
    #[serde(rename = "ssd:System", alias = "System")]
    pub(in crate::ssp) system: System,
    /// Enumerations that connectors refer to.
    #[serde(rename = "ssd:Enumerations", skip_deserializing)]
    enumerations: Option<Enumerations>,
    /// Units that connectors refer to.
    #[serde(rename = "ssd:Units", skip_deserializing)]
    units: Option<Units>,
    /// Suggested experiment.
    #[serde(rename = "ssd:DefaultExperiment", alias = "DefaultExperiment", default)]
    pub(in crate::ssp) experiment: Experiment,
}

impl Structure {
    /// A system with the units and enumerations of its connectors.
    pub(in crate::ssp) fn new(
        tool: &str,
        system: System,
        units: &[Unit],
        enumerations: Vec<Enumeration>,
        experiment: Experiment,
    ) -> Self {
        Self {
            ssd: SSD,
            ssc: SSC,
            version: SSP_VERSION.to_owned(),
            name: system.name.clone(),
            generation_tool: Some(tool.to_owned()),
            system,
            enumerations: (!enumerations.is_empty()).then_some(Enumerations { enumerations }),
            units: Units::of(units),
            experiment,
        }
    }

    /// Reads a `.ssd`.
    ///
    /// # Errors
    /// Every variant of [`Error`] that is about reading.
    pub(in crate::ssp) fn from_xml(text: &str) -> Result<Self, Error> {
        read(text, "SystemStructureDescription")
    }

    /// The text of a `.ssd`.
    ///
    /// # Errors
    /// [`Error::Character`] if a text has a character that XML cannot carry.
    pub(in crate::ssp) fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, "ssd:SystemStructureDescription")
    }
}

/// Suggested start and end \[s\].
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(default, skip_serializing_if = "Option::is_none", with = "lexical::optional")],
)]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub(in crate::ssp) struct Experiment {
    /// Start.
    #[serde(rename = "@startTime")]
    pub(in crate::ssp) start_time: Option<f64>,
    /// End.
    #[serde(rename = "@stopTime")]
    pub(in crate::ssp) stop_time: Option<f64>,
}

/// Components, connections and values of parameters.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) struct System {
    #[serde(rename = "@name", default)]
    name: String,
    #[serde(rename = "ssd:ParameterBindings", alias = "ParameterBindings")]
    bindings: Option<Bindings>,
    #[serde(rename = "ssd:Elements", alias = "Elements", default)]
    elements: Elements,
    #[serde(rename = "ssd:Connections", alias = "Connections")]
    connections: Option<Connections>,
    #[serde(rename = "ssd:Annotations", skip_deserializing)]
    annotations: Option<Annotations>,
}

impl System {
    /// A system with the parameter values in the file `values`, which names parameters `<component>.<parameter>`, and the communication
    /// `step` \[s\] that OMSimulator needs.
    pub(in crate::ssp) fn new(
        name: &str,
        values: &str,
        components: impl Iterator<Item = Component>,
        connections: Vec<Connection>,
        step: Option<f64>,
    ) -> Self {
        Self {
            name: name.to_owned(),
            bindings: Some(Bindings::to(values)),
            elements: Elements {
                items: components.map(Element::Component).collect(),
            },
            connections: (!connections.is_empty()).then_some(Connections { items: connections }),
            annotations: step.map(Annotations::of),
        }
    }

    /// What it consists of.
    pub(in crate::ssp) fn elements(&self) -> &[Element] {
        &self.elements.items
    }

    /// Values for parameters of the components.
    pub(in crate::ssp) fn bindings(&self) -> &[ParameterBinding] {
        self.bindings.as_ref().map_or(&[], |list| &list.items)
    }

    /// What feeds what.
    pub(in crate::ssp) fn connections(&self) -> &[Connection] {
        self.connections.as_ref().map_or(&[], |list| &list.items)
    }
}

#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
struct Elements {
    #[serde(rename = "$value", default)]
    items: Vec<Element>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Connections {
    #[serde(rename = "ssd:Connection", alias = "Connection", default)]
    items: Vec<Connection>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Bindings {
    #[serde(rename = "ssd:ParameterBinding", alias = "ParameterBinding", default)]
    items: Vec<ParameterBinding>,
}

impl Bindings {
    /// To the set in the file `source`.
    fn to(source: &str) -> Self {
        let binding = ParameterBinding {
            source: Some(source.to_owned()),
            ..ParameterBinding::default()
        };
        Self {
            items: vec![binding],
        }
    }
}

/// A part of a system.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) enum Element {
    /// An FMU, or what else `type` says.
    #[serde(rename = "ssd:Component", alias = "Component")]
    Component(Component),
    /// A system of its own.
    System(Named),
    /// A dictionary of signals.
    SignalDictionaryReference(Named),
}

/// An element of which the name is all that is read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) struct Named {
    /// The name.
    #[serde(rename = "@name", default)]
    pub(in crate::ssp) name: String,
}

/// An FMU in the system.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) struct Component {
    /// Its name, unique in the system.
    #[serde(rename = "@name")]
    pub(in crate::ssp) name: String,
    /// Media type; that of an FMU if absent.
    #[serde(rename = "@type")]
    pub(in crate::ssp) kind: Option<String>,
    /// URI of the file, relative to the structure.
    #[serde(rename = "@source", default)]
    pub(in crate::ssp) source: String,
    /// Which interface of the FMU is meant.
    #[serde(rename = "@implementation")]
    pub(in crate::ssp) implementation: Option<String>,
    #[serde(rename = "ssd:Connectors", skip_deserializing)]
    connectors: Option<Connectors>,
    #[serde(rename = "ssd:ParameterBindings", alias = "ParameterBindings")]
    bindings: Option<Bindings>,
}

impl Component {
    /// The co-simulation FMU in the file `source` with the parameter values in the file `values`, URIs inside the package.
    pub(in crate::ssp) fn new(
        name: &str,
        source: &str,
        values: &str,
        connectors: Vec<Connector>,
    ) -> Self {
        Self {
            name: name.to_owned(),
            kind: Some(FMU.to_owned()),
            source: source.to_owned(),
            implementation: Some("CoSimulation".to_owned()),
            connectors: (!connectors.is_empty()).then_some(Connectors { connectors }),
            bindings: Some(Bindings::to(values)),
        }
    }

    /// Whether it is an FMU that can be run for co-simulation.
    pub(in crate::ssp) fn is_fmu(&self) -> bool {
        let is = |given: &Option<String>, known: &[&str]| {
            given.as_deref().is_none_or(|given| known.contains(&given))
        };
        is(&self.kind, &[FMU]) && is(&self.implementation, &["CoSimulation", "any"])
    }

    /// Values for its parameters.
    pub(in crate::ssp) fn bindings(&self) -> &[ParameterBinding] {
        self.bindings.as_ref().map_or(&[], |list| &list.items)
    }
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Connectors {
    #[serde(rename = "ssd:Connector")]
    connectors: Vec<Connector>,
}

/// A variable of a component.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(in crate::ssp) struct Connector {
    /// Its name.
    #[serde(rename = "@name")]
    pub(in crate::ssp) name: String,
    /// `input`, `output` or `parameter`.
    #[serde(rename = "@kind")]
    pub(in crate::ssp) kind: &'static str,
    /// Its type.
    #[serde(rename = "$value")]
    pub(in crate::ssp) signal: Signal,
}

/// Type of a connector.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(in crate::ssp) enum Signal {
    /// A real number and its unit.
    #[serde(rename = "ssc:Real")]
    Real {
        #[serde(rename = "@unit", skip_serializing_if = "Option::is_none")]
        unit: Option<String>,
    },
    #[serde(rename = "ssc:Integer")]
    Integer,
    #[serde(rename = "ssc:Boolean")]
    Boolean,
    #[serde(rename = "ssc:String")]
    String,
    /// An item of the enumeration of this name.
    #[serde(rename = "ssc:Enumeration")]
    Enumeration {
        #[serde(rename = "@name")]
        name: String,
    },
}

/// A connector that feeds another. Without an element a connector is the system's own.
#[apply(
    crate = "serde_with_macros",
    Option<String> => #[serde(skip_serializing_if = "Option::is_none")],
    Option<IgnoredAny> => #[serde(skip_serializing)],
)]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(in crate::ssp) struct Connection {
    /// Element of the source.
    #[serde(rename = "@startElement")]
    pub(in crate::ssp) start_element: Option<String>,
    /// The source.
    #[serde(rename = "@startConnector")]
    pub(in crate::ssp) start_connector: String,
    /// Element of the target.
    #[serde(rename = "@endElement")]
    pub(in crate::ssp) end_element: Option<String>,
    /// The target.
    #[serde(rename = "@endConnector")]
    pub(in crate::ssp) end_connector: String,
    #[serde(rename = "@startIndices")]
    start_indices: Option<String>,
    #[serde(rename = "@endIndices")]
    end_indices: Option<String>,
    #[serde(rename = "LinearTransformation")]
    linear: Option<IgnoredAny>,
    #[serde(rename = "BooleanMappingTransformation")]
    boolean: Option<IgnoredAny>,
    #[serde(rename = "IntegerMappingTransformation")]
    integer: Option<IgnoredAny>,
    #[serde(rename = "EnumerationMappingTransformation")]
    enumeration: Option<IgnoredAny>,
}

impl Connection {
    /// From one to another connector, each with its element before it.
    pub(in crate::ssp) fn new(start: (String, String), end: (String, String)) -> Self {
        Self {
            start_element: Some(start.0),
            start_connector: start.1,
            end_element: Some(end.0),
            end_connector: end.1,
            ..Self::default()
        }
    }

    /// Whether it joins single elements of arrays.
    pub(in crate::ssp) fn has_indices(&self) -> bool {
        self.start_indices.is_some() || self.end_indices.is_some()
    }

    /// Whether the values are to be changed on their way.
    pub(in crate::ssp) fn transforms(&self) -> bool {
        let all = [self.linear, self.boolean, self.integer, self.enumeration];
        all.iter().any(Option::is_some)
    }
}

/// Values from a file or from within the structure.
#[apply(
    crate = "serde_with_macros",
    Option<String> => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(in crate::ssp) struct ParameterBinding {
    /// URI of a `.ssv`; `None`: the values are here.
    #[serde(rename = "@source")]
    pub(in crate::ssp) source: Option<String>,
    /// What the URI is relative to; the structure if absent.
    #[serde(rename = "@sourceBase")]
    pub(in crate::ssp) source_base: Option<String>,
    /// What stands before every name.
    #[serde(rename = "@prefix", default, skip_serializing)]
    pub(in crate::ssp) prefix: String,
    /// The values, if there is no source.
    #[serde(rename = "ParameterValues", skip_serializing)]
    pub(in crate::ssp) values: Option<Values>,
    #[serde(rename = "ParameterMapping", skip_serializing)]
    mapping: Option<IgnoredAny>,
}

impl ParameterBinding {
    /// Whether names are to be replaced by others.
    pub(in crate::ssp) fn maps(&self) -> bool {
        self.mapping.is_some()
    }
}

/// Values within the structure.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(in crate::ssp) struct Values {
    /// The values.
    #[serde(rename = "ParameterSet")]
    pub(in crate::ssp) set: ParameterSet,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Enumerations {
    #[serde(rename = "ssc:Enumeration")]
    enumerations: Vec<Enumeration>,
}

/// Integers with names.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(in crate::ssp) struct Enumeration {
    /// Its name.
    #[serde(rename = "@name")]
    pub(in crate::ssp) name: String,
    /// The items.
    #[serde(rename = "ssc:Item")]
    pub(in crate::ssp) items: Vec<Item>,
}

/// One named integer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(in crate::ssp) struct Item {
    /// Its name.
    #[serde(rename = "@name")]
    pub(in crate::ssp) name: String,
    /// Its value.
    #[serde(rename = "@value", with = "lexical")]
    pub(in crate::ssp) value: i64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without prefixes, with what other tools write: annotations, descriptions, systems' own connectors.
    #[test]
    fn structures_of_other_tools_are_read() {
        let text = r#"<SystemStructureDescription xmlns="http://ssp-standard.org/SSP1/SystemStructureDescription"
            xmlns:c="http://ssp-standard.org/SSP1/SystemStructureCommon" name="x" version="1.0">
          <System name="root" description="a b">
            <Annotations><c:Annotation type="t"><x y="1"/></c:Annotation></Annotations>
            <Connectors><Connector name="u" kind="input"><c:Real unit="m"/></Connector></Connectors>
            <ElementGeometry x1="0" y1="0" x2="1" y2="1"/>
            <ParameterBindings>
              <ParameterBinding prefix="a."><ParameterValues>
                <v:ParameterSet xmlns:v="http://ssp-standard.org/SSP1/SystemStructureParameterValues" version="1.0" name="n">
                  <v:Parameters>
                    <v:Parameter name="k" description="d"><v:Real value="2.5" unit="m"/></v:Parameter>
                    <v:Parameter name="on"><v:Annotations/><v:Boolean value="true"/></v:Parameter>
                  </v:Parameters>
                </v:ParameterSet>
              </ParameterValues></ParameterBinding>
              <ParameterBinding source="resources/p.ssv"><ParameterMapping/></ParameterBinding>
            </ParameterBindings>
            <Elements>
              <Component name="a" source="resources/a.fmu"><Connectors/></Component>
              <System name="inner"><Elements/></System>
              <Component name="b" type="application/x-ssp-package" source="b.ssp"/>
            </Elements>
            <Connections>
              <Connection startConnector="u" endElement="a" endConnector="u"/>
              <Connection startElement="a" startConnector="y" endElement="b" endConnector="u">
                <LinearTransformation factor="2"/>
              </Connection>
            </Connections>
          </System>
          <Units><c:Unit name="m"><c:BaseUnit m="1"/></c:Unit></Units>
          <DefaultExperiment startTime="0.0" stopTime="2"/>
        </SystemStructureDescription>"#;
        let read = Structure::from_xml(text).unwrap();
        assert_eq!(read.experiment.stop_time, Some(2.0));
        let [first, second] = read.system.bindings() else {
            panic!("{:?}", read.system);
        };
        let values = &first.values.as_ref().unwrap().set.parameters();
        assert_eq!(
            (&*first.prefix, first.maps(), second.maps()),
            ("a.", false, true)
        );
        let value = |k: usize| values[k].values().unwrap().pop();
        assert_eq!(value(0), Some((String::new(), "2.5", Some("m"))));
        assert_eq!(value(1), Some((String::new(), "true", None)));
        let fmus: Vec<bool> = read
            .system
            .elements()
            .iter()
            .map(|element| matches!(element, Element::Component(own) if own.is_fmu()))
            .collect();
        assert_eq!(fmus, [true, false, false]);
        let wires = read.system.connections();
        assert_eq!(
            (wires[0].start_element.as_deref(), wires[0].transforms()),
            (None, false)
        );
        assert!(wires[1].transforms());
        let of = |version: &str| {
            let own = format!("version=\"{version}\">\n          <System");
            let text = text.replace("version=\"1.0\">\n          <System", &own);
            Structure::from_xml(&text).map(|read| read.system)
        };
        assert_eq!(of("2.0").unwrap(), read.system);
        let error = of("3.0").unwrap_err().to_string();
        assert_eq!(
            error,
            "attribute `version`: found `3.0`, expected `1.0` or `2.0`"
        );
    }
}
