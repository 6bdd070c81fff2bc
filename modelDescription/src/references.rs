//! Files about a model inside its FMU: the manifest of the layered standard FMI-LS-REF, 1.0.0-beta.1, and experiments in the format
//! `ma-hs-experiments` that it refers to. Both are drafts.
//!
//! The text of the experiments format puts the times of an experiment into its own attributes, the newest schema into an element
//! `TransientSimulation`: the first is written, both are read.

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use crate::xml::{self, Error, Expected};

/// Folder of the layered standard in the archive.
pub const FOLDER: &str = "extra/org.fmi-standard.fmi-ls-ref";
/// The manifest in it.
pub const MANIFEST_FILE: &str = "fmi-ls-manifest.xml";
/// Checksums of all other files of an archive of this project, beside the manifest.
pub const CHECKSUMS_FILE: &str = "checksums.sha256";
/// Version of the layered standard that is written.
pub const VERSION: &str = "1.0.0-beta.1";
/// Media type of experiments.
pub const EXPERIMENTS: &str = "application/x-ma-hs-experiments";

const MANIFEST: &str = "fmiReferences";
const ROOT: &str = "Experiments";
const NAMESPACE: &str = "http://fmi-standard.org/fmi-ls-manifest";
const NAME: &str = "org.fmi-standard.fmi-ls-ref";
const DESCRIPTION: &str =
    "Layered Standard providing information on related files included in an FMU.";

/// The manifest: which files there are, and what for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    #[serde(rename = "@xmlns:fmi-ls", default)]
    namespace: String,
    #[serde(rename = "@fmi-ls:fmi-ls-name", alias = "@fmi-ls-name")]
    name: String,
    /// Version of the layered standard.
    #[serde(rename = "@fmi-ls:fmi-ls-version", alias = "@fmi-ls-version")]
    pub version: String,
    #[serde(
        rename = "@fmi-ls:fmi-ls-description",
        alias = "@fmi-ls-description",
        default
    )]
    description: String,
    /// The files.
    #[serde(rename = "Related", default)]
    pub related: Vec<Related>,
}

/// A file.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Related {
    /// Media type.
    #[serde(rename = "@type")]
    pub media_type: Option<String>,
    /// Where it is, relative to the manifest.
    #[serde(rename = "@source")]
    pub source: String,
    /// What it is for, with a sub-role after `/`.
    #[serde(rename = "@role")]
    pub role: String,
    /// One line for people.
    #[serde(rename = "@description")]
    pub description: Option<String>,
}

impl Related {
    /// A file with all that is said of it.
    pub fn new(media_type: &str, source: &str, role: &str, description: &str) -> Self {
        Self {
            media_type: Some(media_type.to_owned()),
            source: source.to_owned(),
            role: role.to_owned(),
            description: Some(description.to_owned()),
        }
    }

    /// Whether it holds experiments that check an FMU in a new tool: a smoke test.
    #[must_use]
    pub fn is_smoke_test(&self) -> bool {
        matches!(&*self.role, "experiment" | "experiment/smoke-test")
    }
}

impl Manifest {
    /// The manifest of these files.
    #[must_use]
    pub fn new(related: Vec<Related>) -> Self {
        Self {
            namespace: NAMESPACE.to_owned(),
            name: NAME.to_owned(),
            version: VERSION.to_owned(),
            description: DESCRIPTION.to_owned(),
            related,
        }
    }

    /// Reads the text of a manifest, of any version.
    ///
    /// # Errors
    /// [`Error`], with line and column.
    pub fn from_xml(text: &str) -> Result<Self, Error> {
        read(text, MANIFEST)
    }

    /// Writes the text.
    ///
    /// # Errors
    /// [`Error::Character`] if a text has a character that XML cannot carry.
    pub fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, MANIFEST)
    }
}

/// Experiments.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Experiments {
    /// Name of all together.
    #[serde(rename = "@name")]
    pub name: String,
    /// The experiments.
    #[serde(rename = "Experiment", default)]
    pub list: Vec<Experiment>,
}

/// One experiment.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Experiment {
    /// Its name.
    #[serde(rename = "@name")]
    pub name: String,
    /// One line for people.
    #[serde(rename = "@description")]
    pub description: Option<String>,
    /// Start \[s\].
    #[serde(rename = "@startTime")]
    pub start: Option<f64>,
    /// Stop \[s\].
    #[serde(rename = "@stopTime")]
    pub stop: Option<f64>,
    /// Communication step \[s\].
    #[serde(rename = "@stepSize")]
    pub step: Option<f64>,
    /// The times, as the newest schema has them.
    #[serde(rename = "TransientSimulation")]
    pub transient: Option<Transient>,
    /// Values of parameters, SSV.
    #[serde(rename = "Parameters")]
    pub parameters: Option<Data>,
    /// Inputs over time.
    #[serde(rename = "Stimuli")]
    pub stimuli: Option<Data>,
    /// Outputs over time that are expected.
    #[serde(rename = "References")]
    pub references: Option<Data>,
    /// What tools add.
    #[serde(rename = "Annotations")]
    pub annotations: Option<Annotations>,
}

/// Times of an experiment.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Transient {
    /// Start \[s\].
    #[serde(rename = "@startTime")]
    pub start: Option<f64>,
    /// Stop \[s\].
    #[serde(rename = "@stopTime")]
    pub stop: Option<f64>,
    /// Communication step \[s\].
    #[serde(rename = "@stepSize")]
    pub step: Option<f64>,
}

/// A file of an experiment.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Data {
    /// Media type; a table of comma-separated values, or SSV, if absent.
    #[serde(rename = "@type")]
    pub media_type: Option<String>,
    /// Where it is, relative to the experiments.
    #[serde(rename = "@source")]
    pub source: String,
}

impl Data {
    /// The file `source` beside the experiments.
    pub fn of(source: &str) -> Self {
        Self {
            media_type: None,
            source: source.to_owned(),
        }
    }
}

/// Annotations of an experiment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Annotations {
    /// One of each tool.
    #[serde(rename = "Annotation", default)]
    pub list: Vec<Annotation>,
}

/// An annotation; what other tools say is skipped.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Annotation {
    /// Name of the kind.
    #[serde(rename = "@type")]
    pub kind: String,
    /// How far results may be from those that are expected: of this project.
    #[serde(rename = "Tolerances")]
    pub tolerances: Option<Tolerances>,
}

/// How far a result may be from the expected one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Tolerances {
    /// Over the largest value of the variable in the experiment \[-\].
    #[serde(rename = "@relative")]
    pub relative: f64,
    /// In the unit of the variable.
    #[serde(rename = "@absolute")]
    pub absolute: f64,
}

impl Default for Tolerances {
    /// Processors of another class round otherwise, and forces in a packing follow the solver's tolerances.
    fn default() -> Self {
        Self {
            relative: 1e-3,
            absolute: 1e-9,
        }
    }
}

/// Kind of the annotation with [`Tolerances`].
const TOLERANCES: &str = "sphere-dda.tolerances";

impl Experiment {
    /// Sets the tolerances.
    #[must_use]
    pub fn within(mut self, tolerances: Tolerances) -> Self {
        let annotation = Annotation {
            kind: TOLERANCES.to_owned(),
            tolerances: Some(tolerances),
        };
        self.annotations = Some(Annotations {
            list: vec![annotation],
        });
        self
    }

    /// The tolerances, if it says them.
    #[must_use]
    pub fn tolerances(&self) -> Option<Tolerances> {
        let annotations = self.annotations.iter().flat_map(|a| &a.list);
        annotations
            .filter(|a| a.kind == TOLERANCES)
            .find_map(|a| a.tolerances)
    }

    /// Start, stop and step \[s\], wherever they stand.
    #[must_use]
    pub fn times(&self) -> Transient {
        let inner = self.transient.unwrap_or_default();
        Transient {
            start: self.start.or(inner.start),
            stop: self.stop.or(inner.stop),
            step: self.step.or(inner.step),
        }
    }
}

impl Experiments {
    /// Reads the text of experiments.
    ///
    /// # Errors
    /// [`Error`], with line and column.
    pub fn from_xml(text: &str) -> Result<Self, Error> {
        read(text, ROOT)
    }

    /// Writes the text.
    ///
    /// # Errors
    /// [`Error::Character`] if a text has a character that XML cannot carry.
    pub fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, ROOT)
    }
}

fn read<T: serde::de::DeserializeOwned>(text: &str, root: &'static str) -> Result<T, Error> {
    let expected = Expected {
        root,
        attribute: "",
        version: "",
    };
    xml::read_expected(text, expected)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let manifest = Manifest::new(vec![Related::new(EXPERIMENTS, "a.exp", "experiment", "A")]);
        let text = manifest.to_xml().unwrap();
        assert!(
            text.contains(r#"fmi-ls:fmi-ls-version="1.0.0-beta.1""#),
            "{text}"
        );
        assert_eq!(Manifest::from_xml(&text).unwrap(), manifest);
        let tolerances = Tolerances {
            relative: 1e-3,
            absolute: 1e-9,
        };
        let one = Experiment {
            name: "one".to_owned(),
            stop: Some(0.5),
            references: Some(Data::of("out.csv")),
            ..Experiment::default()
        };
        let experiments = Experiments {
            name: "smoke test".to_owned(),
            list: vec![one.within(tolerances)],
        };
        let text = experiments.to_xml().unwrap();
        let again = Experiments::from_xml(&text).unwrap();
        assert_eq!(again, experiments, "{text}");
        assert_eq!(again.list[0].tolerances(), Some(tolerances));
    }

    /// The times of the newest schema, annotations of another tool, a manifest of another version and prefix.
    #[test]
    fn forms_of_other_tools_are_read() {
        let text = r#"<Experiments name="x"><Experiment name="y" tolerance="0.004">
            <TransientSimulation startTime="0" stopTime="2" stepSize="0.5"/><Stimuli type="text/csv" source="in.csv"/>
            <Annotations><Annotation type="com.example"><t:a xmlns:t="u" b="1">text</t:a></Annotation></Annotations>
            </Experiment></Experiments>"#;
        let one = &Experiments::from_xml(text).unwrap().list[0];
        assert_eq!((one.times().stop, one.times().step), (Some(2.0), Some(0.5)));
        assert_eq!(one.tolerances(), None);
        let text = r#"<fmiReferences xmlns:l="http://fmi-standard.org/fmi-ls-manifest" l:fmi-ls-name="org.fmi-standard.fmi-ls-ref"
            l:fmi-ls-version="1.0.0-alpha.1" l:fmi-ls-description="d"><Related source="a" role="model"><Label name="b"/></Related>
            <Related source="b" role="experiment/validation"/></fmiReferences>"#;
        let manifest = Manifest::from_xml(text).unwrap();
        assert_eq!(manifest.version, "1.0.0-alpha.1");
        assert_eq!(manifest.related.len(), 2);
        assert!(!manifest.related[1].is_smoke_test());
        let wrong = Manifest::from_xml("<Experiments/>").unwrap_err();
        assert!(
            wrong.to_string().contains("expected `fmiReferences`"),
            "{wrong}"
        );
    }
}
