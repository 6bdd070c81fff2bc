//! Systems from SSP archives: what other tools write, and what is refused.

use std::path::{Path, PathBuf};

use sphere_dda_master::{ArchiveError, Fmu, ImportError, Limits, Options, Ssp, SspError, System};

use crate::drive;
use crate::foreign_fmu::{Build, pack, write_archive};

const SSD: &str = r#"<ssd:SystemStructureDescription version="1.0" name="two"
    xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription">
  <ssd:System name="root">
    BINDINGS
    <ssd:Elements>
      <ssd:Component name="a" source="resources/my%20fmu.fmu"/>
      <ssd:Component name="b" type="application/x-fmu-sharedlibrary" source="./resources/my%20fmu.fmu">
        <ssd:ParameterBindings><ssd:ParameterBinding prefix="mass."><ssd:ParameterValues>
          <ssv:ParameterSet version="1.0" name="weak"><ssv:Parameters>
            <ssv:Parameter name="x"><ssv:Real value="-0.5" unit="m"/></ssv:Parameter>
            <ssv:Parameter name="m"><ssv:Real value="3"/></ssv:Parameter>
          </ssv:Parameters></ssv:ParameterSet>
        </ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>
      </ssd:Component>
      ELEMENTS
    </ssd:Elements>
    <ssd:Connections>
      <ssd:Connection startElement="a" startConnector="echo" endElement="b" endConnector="force[1]"/>
      <ssd:Connection startConnector="u" endElement="a" endConnector="force[1]"/>
      CONNECTIONS
    </ssd:Connections>
  </ssd:System>
  <ssd:DefaultExperiment startTime="0" stopTime="0.5"/>
</ssd:SystemStructureDescription>"#;

const STRONG: &str = r#"<ParameterSet version="1.0" name="strong"><Parameters>
    <Parameter name="b.mass.m"><Real value="4" unit="kg"/></Parameter>
    <Parameter name="a.level"><Enumeration value="high"/></Parameter>
    <Parameter name="a.force[1]"><Real value="2.5"/></Parameter>
  </Parameters></ParameterSet>"#;

const BOUND: &str =
    r#"<ssd:ParameterBindings><ssd:ParameterBinding source="strong.ssv"/></ssd:ParameterBindings>"#;

/// An SSP of two oscillators, these parts of its structure filled in.
fn ssp(folder: &Path, parts: [&str; 3], values: &str) -> PathBuf {
    let fmu = folder.join("my fmu.fmu");
    pack(&fmu, Build::Whole, |_| ());
    let [bindings, elements, connections] = parts;
    let structure = SSD
        .replace("BINDINGS", bindings)
        .replace("ELEMENTS", elements)
        .replace("CONNECTIONS", connections);
    let path = folder.join("two.ssp");
    let files = [
        ("SystemStructure.ssd", structure.into_bytes()),
        ("strong.ssv", values.as_bytes().to_vec()),
        ("resources/my fmu.fmu", std::fs::read(fmu).unwrap()),
    ];
    write_archive(&path, &files);
    path
}

#[test]
fn a_system_runs_as_if_it_were_put_together_by_hand() {
    let folder = tempfile::tempdir().unwrap();
    let path = ssp(folder.path(), [BOUND, "", ""], STRONG);
    let read = Ssp::open(&path).unwrap();
    let system = read.system().unwrap();
    let (start, stop) = read.experiment();
    let options = |set| Options {
        start,
        stop,
        set,
        ..Options::default()
    };
    let table = drive(&system, &options(read.set(&system).unwrap())).unwrap();
    assert_eq!(table.time.last(), Some(&0.5));

    let fmu = Fmu::open(folder.path().join("my fmu.fmu")).unwrap();
    let parts = ["a", "b"].map(|name| (name.to_owned(), &fmu));
    let mut by_hand = System::coupled(parts).unwrap();
    by_hand.connect([("a.echo", "b.force[1]")]).unwrap();
    let set = [
        ("b.mass.x", "-0.5"),
        ("b.mass.m", "4"),
        ("a.level", "high"),
        ("a.force[1]", "2.5"),
    ];
    let set = set.map(|(name, value)| (name.to_owned(), value.to_owned()));
    assert_eq!(table, drive(&by_hand, &options(set.to_vec())).unwrap());
    // The values are in it.
    assert_eq!(table.real("b.mass.x").unwrap()[0], -0.5);
    assert_eq!(table.real("b.echo").unwrap()[10], 2.5);
}

fn refused(folder: &Path, parts: [&str; 3], values: &str) -> String {
    let read = Ssp::open(ssp(folder, parts, values));
    let read = match read {
        Ok(read) => read,
        Err(error) => return error.to_string(),
    };
    let system = match read.system() {
        Ok(system) => system,
        Err(error) => return error.to_string(),
    };
    read.set(&system).unwrap_err().to_string()
}

#[test]
fn what_would_be_passed_over_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let component = |source: &str| format!("<ssd:Component name=\"c\" source=\"{source}\"/>");
    for source in [
        "../x.fmu",
        "/etc/passwd",
        "resources/absent.fmu",
        "file:///etc/passwd",
        "http://x/y.fmu",
        "..%2f..%2fetc%2fpasswd",
        "",
    ] {
        let told = refused(folder.path(), ["", &component(source), ""], STRONG);
        assert!(
            told.contains("component `c`: found source"),
            "{source}: {told}"
        );
    }
    for (parts, part) in [
        (
            ["", "<ssd:System name=\"in\"/>", ""],
            "system `in`: found a system within a system",
        ),
        (
            [
                "",
                "<ssd:Component name=\"c\" type=\"application/x-ssp-package\" source=\"a.ssp\"/>",
                "",
            ],
            "component `c`: found type `application/x-ssp-package`",
        ),
        (
            [
                "",
                "<ssd:Component name=\"c\" implementation=\"ModelExchange\" source=\"a.fmu\"/>",
                "",
            ],
            "implementation `ModelExchange`",
        ),
        (
            [
                "",
                "<ssd:SignalDictionaryReference name=\"bus\" dictionary=\"d\"/>",
                "",
            ],
            "`bus`: found a signal dictionary",
        ),
        (
            [
                "",
                "",
                "<ssd:Connection startElement=\"b\" startConnector=\"echo\" endElement=\"a\" endConnector=\"force[1]\">\
                 <ssc:LinearTransformation factor=\"2\"/></ssd:Connection>",
            ],
            "connection `b.echo` to `a.force[1]`: found a transformation",
        ),
        (
            [
                "",
                "",
                "<ssd:Connection startElement=\"b\" startConnector=\"x\" endElement=\"a\" endConnector=\"force[1]\"/>",
            ],
            "found `b.x`, expected",
        ),
        (
            [
                &BOUND.replace(
                    "strong.ssv\"/>",
                    "strong.ssv\"><ssd:ParameterMapping/></ssd:ParameterBinding>",
                ),
                "",
                "",
            ],
            "found a mapping of names",
        ),
        (
            [&BOUND.replace("strong.ssv", "weak.ssv"), "", ""],
            "parameter binding: found source \"weak.ssv\"",
        ),
        (
            [
                &BOUND.replace("source=", "sourceBase=\"component\" source="),
                "",
                "",
            ],
            "within a component",
        ),
    ] {
        let told = refused(folder.path(), parts, STRONG);
        assert!(told.contains(part), "{part} is not in\n{told}");
    }
    let grams = STRONG.replace("unit=\"kg\"", "unit=\"g\"");
    let told = refused(folder.path(), [BOUND, "", ""], &grams);
    assert!(
        told.contains("`b.mass.m`: found a value in `g`, expected it in `kg`"),
        "{told}"
    );
    let empty = STRONG.replace("<Real value=\"2.5\"/>", "<Description/>");
    let told = refused(folder.path(), [BOUND, "", ""], &empty);
    assert!(
        told.contains("parameter `a.force[1]`: found no value"),
        "{told}"
    );
}

/// Entities, deep nesting and archives within archives: none grows beyond the limits.
#[test]
fn hostile_systems_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.ssp");
    let structure = |text: String| {
        write_archive(&path, &[("SystemStructure.ssd", text.into_bytes())]);
        match Ssp::open(&path).unwrap_err() {
            SspError::Xml { source, .. } => source.to_string(),
            error => panic!("{error}"),
        }
    };
    let laughs = format!(
        "<!DOCTYPE x [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;\"><!ENTITY f SYSTEM \"file:///etc/passwd\">]>{}",
        SSD.replace("BINDINGS", "&b;")
    );
    assert!(structure(laughs).contains("found a DOCTYPE, expected none"));
    let undeclared = SSD.replace("name=\"a\"", "name=\"&lol;\"");
    let told = structure(undeclared);
    assert!(told.contains("lol"), "{told}");
    let deep = SSD.replace("BINDINGS", &"<x>".repeat(100_000));
    assert!(structure(deep).contains("more than 64 nested elements"));
    let cut = SSD.split_at(SSD.len() / 2).0.to_owned();
    assert!(structure(cut).contains("not well-formed"));
    write_archive(&path, &[("other.ssd", Vec::new())]);
    let error = Ssp::open(&path).unwrap_err();
    assert!(matches!(error, SspError::Read { .. }), "{error}");
    write_archive(&path, &[("../SystemStructure.ssd", Vec::new())]);
    let error = Ssp::open(&path).unwrap_err();
    assert!(
        matches!(
            &error,
            SspError::Archive {
                source: ArchiveError::Escape { .. },
                ..
            }
        ),
        "{error}"
    );

    // What the FMUs unpack to counts together with the SSP itself, and with each other.
    let copy = "<ssd:Component name=\"c\" source=\"resources/copy.fmu\"/>";
    let one = ssp(folder.path(), ["", copy, ""], STRONG);
    let error = Ssp::open(&one).unwrap_err().to_string();
    assert!(error.contains("component `c`: found source"), "{error}");
    let fmu = folder.path().join("my fmu.fmu");
    let packed = std::fs::read(&fmu).unwrap();
    let structure = ["BINDINGS", "CONNECTIONS"]
        .iter()
        .fold(SSD.replace("ELEMENTS", copy), |text, part| {
            text.replace(part, "")
        });
    let both = folder.path().join("both.ssp");
    let files = [
        ("SystemStructure.ssd", structure.into_bytes()),
        ("resources/my fmu.fmu", packed.clone()),
        ("resources/copy.fmu", packed.clone()),
    ];
    write_archive(&both, &files);
    let inside = walk(Fmu::open(&fmu).unwrap().folder());
    let limits = |fmus: u64| Limits {
        bytes: 2 * packed.len() as u64 + fmus * inside / 2 + 10_000,
        ..Limits::default()
    };
    assert!(Ssp::open_within(&both, limits(4)).is_ok());
    for halves in [1, 3] {
        let error = Ssp::open_within(&both, limits(halves)).unwrap_err();
        let SspError::Fmu { source, .. } = &error else {
            panic!("{error}");
        };
        assert!(
            matches!(
                **source,
                ImportError::Archive {
                    source: ArchiveError::Limit { .. },
                    ..
                }
            ),
            "{error}"
        );
    }
}

fn walk(folder: &Path) -> u64 {
    std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| {
            let entry = entry.unwrap();
            match entry.file_type().unwrap().is_dir() {
                true => walk(&entry.path()),
                false => entry.metadata().unwrap().len(),
            }
        })
        .sum()
}
