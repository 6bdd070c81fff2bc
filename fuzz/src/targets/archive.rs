//! Archives of FMUs and systems. Half of the inputs are the zip itself, half its description, packed afterwards.

use std::fs;
use std::io::{Cursor, Write};

use sphere_dda_master::{Fmu, Ssp};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::Target;

const SYSTEM: &str = r#"<SystemStructureDescription xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon" xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription" version="1.0" name="two">
  <System name="two"><Elements>
    <Component name="a" source="resources/a.fmu" type="application/x-fmu-sharedlibrary">
      <Connectors><Connector name="y" kind="output"/><Connector name="u" kind="input"/></Connectors>
    </Component>
    <Component name="b" source="resources/a.fmu" type="application/x-fmu-sharedlibrary"/>
  </Elements><Connections>
    <Connection startElement="a" startConnector="y" endElement="b" endConnector="u"/>
  </Connections></System>
  <DefaultExperiment startTime="0.0" stopTime="1.0"/>
</SystemStructureDescription>"#;
const DESCRIPTION: &str = r#"<fmiModelDescription fmiVersion="2.0" modelName="a" guid="{a}">
  <CoSimulation modelIdentifier="a" canHandleVariableCommunicationStepSize="true"/>
  <ModelVariables>
    <ScalarVariable name="u" valueReference="0" causality="input" variability="continuous"><Real start="0.0"/></ScalarVariable>
    <ScalarVariable name="y" valueReference="1" causality="output" variability="continuous"><Real/></ScalarVariable>
  </ModelVariables>
  <ModelStructure><Outputs><Unknown index="2"/></Outputs></ModelStructure>
</fmiModelDescription>"#;

pub(super) struct Archives;

impl Target for Archives {
    fn name(&self) -> &'static str {
        "archive"
    }

    fn corpus(&self) -> Vec<Vec<u8>> {
        let kind = |kind: u8, bytes: Vec<u8>| [vec![kind], bytes].concat();
        vec![
            kind(0, fmu(DESCRIPTION.as_bytes())),
            kind(1, DESCRIPTION.into()),
            kind(2, ssp(SYSTEM.as_bytes())),
            kind(3, SYSTEM.into()),
        ]
    }

    fn attempt(&self, input: &[u8]) -> bool {
        let Some((kind, bytes)) = input.split_first() else {
            return false;
        };
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("x.zip");
        let archive = match kind {
            1 => fmu(bytes),
            3 => ssp(bytes),
            _ => bytes.to_vec(),
        };
        fs::write(&path, archive).expect("a file in it");
        match kind {
            0 | 1 => Fmu::open(&path).is_ok(),
            _ => Ssp::open(&path).is_ok_and(|ssp| ssp.system().is_ok()),
        }
    }
}

fn fmu(description: &[u8]) -> Vec<u8> {
    let files: [(&str, &[u8]); 3] = [
        ("modelDescription.xml", description),
        ("resources/scene.toml", b"x = 1\n"),
        ("binaries/linux64/a.so", b"no library"),
    ];
    zipped(&files)
}

fn ssp(system: &[u8]) -> Vec<u8> {
    let inner = fmu(DESCRIPTION.as_bytes());
    zipped(&[("SystemStructure.ssd", system), ("resources/a.fmu", &inner)])
}

fn zipped(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in files {
        archive
            .start_file(*name, SimpleFileOptions::default())
            .expect("an entry in memory");
        archive.write_all(content).expect("bytes in memory");
    }
    archive.finish().expect("an archive in memory").into_inner()
}
