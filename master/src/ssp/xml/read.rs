//! System structures and parameter values of other tools, with any prefixes: what a master needs of them, and what it
//! must know to refuse.

use serde::Deserialize;
use serde::de::IgnoredAny;

use sphere_dda_model_description::Error;
use sphere_dda_model_description::lexical;
use sphere_dda_model_description::xml::{self, Expected};

use super::names::{FMU, SSP_VERSION};

/// The root of `SystemStructure.ssd`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct Structure {
    /// The system.
    #[serde(rename = "System")]
    pub(crate) system: System,
    /// Suggested experiment.
    #[serde(rename = "DefaultExperiment", default)]
    pub(crate) experiment: Experiment,
}

impl Structure {
    /// Reads a `.ssd`.
    ///
    /// # Errors
    /// Every variant of [`Error`] that is about reading.
    pub(crate) fn from_xml(text: &str) -> Result<Self, Error> {
        let expected = Expected {
            root: "SystemStructureDescription",
            attribute: "version",
            version: SSP_VERSION,
        };
        xml::read_expected(text, expected)
    }
}

/// Suggested start and end \[s\].
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
pub(crate) struct Experiment {
    /// Start.
    #[serde(rename = "@startTime", default, with = "lexical::optional")]
    pub(crate) start_time: Option<f64>,
    /// End.
    #[serde(rename = "@stopTime", default, with = "lexical::optional")]
    pub(crate) stop_time: Option<f64>,
}

/// Components, connections and values of parameters.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct System {
    /// Its name.
    #[serde(rename = "@name", default)]
    pub(crate) name: String,
    /// Values for parameters of the components.
    #[serde(rename = "ParameterBindings", default)]
    pub(crate) bindings: Bindings,
    /// What it consists of.
    #[serde(rename = "Elements", default)]
    pub(crate) elements: Elements,
    /// What feeds what.
    #[serde(rename = "Connections", default)]
    pub(crate) connections: Connections,
}

/// The list of [`Element`].
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
pub(crate) struct Elements {
    /// In the order of the document.
    #[serde(rename = "$value", default)]
    pub(crate) items: Vec<Element>,
}

/// A part of a system.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) enum Element {
    /// An FMU, or what else `type` says.
    Component(Component),
    /// A system of its own.
    System(Named),
    /// A dictionary of signals.
    SignalDictionaryReference(Named),
}

/// An element of which the name is all that is read.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct Named {
    /// The name.
    #[serde(rename = "@name", default)]
    pub(crate) name: String,
}

/// An FMU in the system.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct Component {
    /// Its name, unique in the system.
    #[serde(rename = "@name")]
    pub(crate) name: String,
    /// Media type; that of an FMU if absent.
    #[serde(rename = "@type", default)]
    pub(crate) kind: Option<String>,
    /// URI of the file, relative to the structure.
    #[serde(rename = "@source")]
    pub(crate) source: String,
    /// Which interface of the FMU is meant.
    #[serde(rename = "@implementation", default)]
    pub(crate) implementation: Option<String>,
    /// Values for its parameters.
    #[serde(rename = "ParameterBindings", default)]
    pub(crate) bindings: Bindings,
}

impl Component {
    /// Whether it is an FMU that can be run for co-simulation.
    pub(crate) fn is_fmu(&self) -> bool {
        let is = |given: &Option<String>, known: &[&str]| {
            given.as_deref().is_none_or(|given| known.contains(&given))
        };
        is(&self.kind, &[FMU]) && is(&self.implementation, &["CoSimulation", "any"])
    }
}

/// The list of [`Connection`].
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
pub(crate) struct Connections {
    /// In the order of the document.
    #[serde(rename = "Connection", default)]
    pub(crate) items: Vec<Connection>,
}

/// A connector that feeds another. Without an element a connector is the system's own.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct Connection {
    /// Element of the source.
    #[serde(rename = "@startElement", default)]
    pub(crate) start_element: Option<String>,
    /// The source.
    #[serde(rename = "@startConnector")]
    pub(crate) start_connector: String,
    /// Element of the target.
    #[serde(rename = "@endElement", default)]
    pub(crate) end_element: Option<String>,
    /// The target.
    #[serde(rename = "@endConnector")]
    pub(crate) end_connector: String,
    #[serde(rename = "LinearTransformation", default)]
    linear: Option<Skipped>,
    #[serde(rename = "BooleanMappingTransformation", default)]
    boolean: Option<Skipped>,
    #[serde(rename = "IntegerMappingTransformation", default)]
    integer: Option<Skipped>,
    #[serde(rename = "EnumerationMappingTransformation", default)]
    enumeration: Option<Skipped>,
}

impl Connection {
    /// Whether the values are to be changed on their way.
    pub(crate) fn transforms(&self) -> bool {
        let all = [
            &self.linear,
            &self.boolean,
            &self.integer,
            &self.enumeration,
        ];
        all.iter().any(|transformation| transformation.is_some())
    }
}

/// An element whose contents do not matter.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(from = "IgnoredAny")]
struct Skipped;

impl PartialEq for Skipped {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl From<IgnoredAny> for Skipped {
    fn from(_: IgnoredAny) -> Self {
        Self
    }
}

/// The list of [`Binding`].
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
pub(crate) struct Bindings {
    /// In the order of the document.
    #[serde(rename = "ParameterBinding", default)]
    pub(crate) items: Vec<Binding>,
}

/// Values from a file or from within the structure.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct Binding {
    /// URI of a `.ssv`; `None`: the values are here.
    #[serde(rename = "@source", default)]
    pub(crate) source: Option<String>,
    /// What the URI is relative to; the structure if absent.
    #[serde(rename = "@sourceBase", default)]
    pub(crate) source_base: Option<String>,
    /// What stands before every name.
    #[serde(rename = "@prefix", default)]
    pub(crate) prefix: String,
    /// The values, if there is no source.
    #[serde(rename = "ParameterValues", default)]
    pub(crate) values: Option<Values>,
    #[serde(rename = "ParameterMapping", default)]
    mapping: Option<Skipped>,
}

impl Binding {
    /// Whether names are to be replaced by others.
    pub(crate) fn maps(&self) -> bool {
        self.mapping.is_some()
    }
}

/// Values within the structure.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct Values {
    /// The values.
    #[serde(rename = "ParameterSet")]
    pub(crate) set: ParameterSet,
}

/// The root of a `.ssv`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct ParameterSet {
    /// The values.
    #[serde(rename = "Parameters")]
    pub(crate) parameters: Parameters,
}

impl ParameterSet {
    /// Reads a `.ssv`.
    ///
    /// # Errors
    /// Every variant of [`Error`] that is about reading.
    pub(crate) fn from_xml(text: &str) -> Result<Self, Error> {
        let expected = Expected {
            root: "ParameterSet",
            attribute: "version",
            version: SSP_VERSION,
        };
        xml::read_expected(text, expected)
    }
}

/// The list of [`Parameter`].
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
pub(crate) struct Parameters {
    /// In the order of the document.
    #[serde(rename = "Parameter", default)]
    pub(crate) items: Vec<Parameter>,
}

/// A parameter and its value.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(crate) struct Parameter {
    /// Its name.
    #[serde(rename = "@name")]
    pub(crate) name: String,
    #[serde(rename = "$value", default)]
    contents: Vec<Content>,
}

impl Parameter {
    /// Text and unit of the value; `None` if it has none of a type that is known.
    pub(crate) fn value(&self) -> Option<(&str, Option<&str>)> {
        self.contents.iter().find_map(|content| match content {
            Content::Real(own)
            | Content::Integer(own)
            | Content::Boolean(own)
            | Content::String(own)
            | Content::Enumeration(own)
            | Content::Binary(own) => Some((&*own.value, own.unit.as_deref())),
            Content::Other => None,
        })
    }
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
enum Content {
    Real(Text),
    Integer(Text),
    Boolean(Text),
    String(Text),
    Enumeration(Text),
    Binary(Text),
    #[serde(other)]
    Other,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Text {
    #[serde(rename = "@value", default)]
    value: String,
    #[serde(rename = "@unit", default)]
    unit: Option<String>,
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
        let [first, second] = &*read.system.bindings.items else {
            panic!("{:?}", read.system.bindings);
        };
        let values = &first.values.as_ref().unwrap().set.parameters.items;
        assert_eq!(
            (&*first.prefix, first.maps(), second.maps()),
            ("a.", false, true)
        );
        assert_eq!(values[0].value(), Some(("2.5", Some("m"))));
        assert_eq!(values[1].value(), Some(("true", None)));
        let fmus: Vec<bool> = read
            .system
            .elements
            .items
            .iter()
            .map(|element| matches!(element, Element::Component(own) if own.is_fmu()))
            .collect();
        assert_eq!(fmus, [true, false, false]);
        let wires = &read.system.connections.items;
        assert_eq!(
            (wires[0].start_element.as_deref(), wires[0].transforms()),
            (None, false)
        );
        assert!(wires[1].transforms());
        let newer = text.replace(
            "version=\"1.0\">\n          <System",
            "version=\"2.0\">\n          <System",
        );
        let error = Structure::from_xml(&newer).unwrap_err().to_string();
        assert_eq!(error, "attribute `version`: found `2.0`, expected `1.0`");
    }
}
