//! Systems from SSP archives: what other tools write, and what is refused.

use std::path::{Path, PathBuf};

use sphere_dda_master::{
    ArchiveError, Coupling, Fmu, ImportError, Limits, Options, Ssp, SspError, System,
};

use crate::drive;
use crate::foreign_fmu::{Build, pack, pack_reference, pack_reference_of, write_archive};

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

fn filled([bindings, elements, connections]: [&str; 3]) -> String {
    SSD.replace("BINDINGS", bindings)
        .replace("ELEMENTS", elements)
        .replace("CONNECTIONS", connections)
}

/// An SSP of two oscillators, these parts of its structure filled in.
fn ssp(folder: &Path, parts: [&str; 3], values: &str) -> PathBuf {
    let fmu = folder.join("my fmu.fmu");
    pack(&fmu, Build::Whole, |_| ());
    let structure = filled(parts);
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

/// Version 2.0 of the same files means the same.
#[test]
fn both_versions_run_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let table = |parts: [&str; 3], values: &str, edit: &dyn Fn(String) -> String| {
        let path = ssp(folder.path(), parts, values);
        let structure = edit(filled(parts));
        let fmu = std::fs::read(folder.path().join("my fmu.fmu")).unwrap();
        let files = [
            ("SystemStructure.ssd", structure.into_bytes()),
            ("strong.ssv", edit(values.to_owned()).into_bytes()),
            ("resources/my fmu.fmu", fmu),
        ];
        write_archive(&path, &files);
        let read = Ssp::open(&path).unwrap();
        let system = read.system().unwrap();
        let options = Options {
            stop: read.experiment().1,
            set: read.set(&system).unwrap(),
            ..Options::default()
        };
        drive(&system, &options).unwrap()
    };
    let parts = [BOUND, "", ""];
    let old = table(parts, STRONG, &|text| text);
    let new = table(parts, STRONG, &|text| {
        text.replace("version=\"1.0\"", "version=\"2.0\"")
            .replace("ssv:Real", "ssv:Float64")
            .replace("<Real", "<Float64")
            // Which end is which is not said by their names.
            .replace(
                "startElement=\"a\" startConnector=\"echo\" endElement=\"b\" endConnector=\"force[1]\"",
                "startElement=\"b\" startConnector=\"force[1]\" endElement=\"a\" endConnector=\"echo\"",
            )
            .replace("</ssd:SystemStructureDescription>", "<ssd:MetaData kind=\"general\" type=\"text/plain\"/>\
                <ssd:Signature role=\"suitability\" type=\"x\"/></ssd:SystemStructureDescription>")
    });
    assert_eq!(old, new);
}

/// Arrays and the types of FMI 3.0, which SSP 2.0 has.
#[test]
fn arrays_and_types_of_version_2_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let space = pack_reference_of(folder.path(), "StateSpace", 3);
    let feed = pack_reference_of(folder.path(), "Feedthrough", 3);
    let decay = pack_reference(folder.path(), "Dahlquist");
    let files = |parameters: &str, connection: &str| {
        let structure = format!(
            r#"<SystemStructureDescription version="2.0" name="arrays"
    xmlns="http://ssp-standard.org/SSP1/SystemStructureDescription" xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon">
  <System name="root"><ParameterBindings><ParameterBinding source="all.ssv"/></ParameterBindings><Elements>
    <Component name="decay" source="decay.fmu"/>
    <Component name="one" source="space.fmu"><Connectors>
      <Connector name="u" kind="input"><ssc:Float64/><Dimension size="3"/></Connector>
      <Connector name="y" kind="output"><ssc:Float64 unit="m"/><Dimension sizeConnector="n"/><Clock name="c"/></Connector>
    </Connectors></Component>
    <Component name="two" source="space.fmu"/>
    <Component name="feed" source="feed.fmu"/>
  </Elements><Connections>
    <Connection startElement="decay" startConnector="x" endElement="one" endConnector="u[2]"/>
    <Connection startElement="two" startConnector="u" endElement="one" endConnector="y"/>
    {connection}
  </Connections></System><DefaultExperiment startTime="0" stopTime="4"/></SystemStructureDescription>"#
        );
        let set = format!(
            r#"<ParameterSet version="2.0" name="all"><Parameters>{parameters}</Parameters></ParameterSet>"#
        );
        let path = folder.path().join("arrays.ssp");
        let read = |path: &Path| std::fs::read(path).unwrap();
        write_archive(
            &path,
            &[
                ("SystemStructure.ssd", structure.into_bytes()),
                ("all.ssv", set.into_bytes()),
                ("space.fmu", read(&space)),
                ("feed.fmu", read(&feed)),
                ("decay.fmu", read(&decay)),
            ],
        );
        path
    };
    let parameters = r#"
      <Parameter name="one.A"><Float64 value="0 0 0 0 0 0 0 0 0"/><Dimension size="3"/><Dimension size="3"/></Parameter>
      <Parameter name="two.A"><Float64 value="0 0 0 0 0 0 0 0 0"/><Dimension size="3"/><Dimension size="3"/></Parameter>
      <Parameter name="feed.Float32_continuous_input"><Float32 value="-0.25"/></Parameter>
      <Parameter name="feed.Int8_input"><Int8 value="-128"/></Parameter>
      <Parameter name="feed.UInt64_input"><UInt64 value="9223372036854775807"/></Parameter>
      <Parameter name="feed.Boolean_input"><Boolean value="true"/></Parameter>
      <Parameter name="feed.String_input"><String><Value value="two words"/></String></Parameter>
      <Parameter name="feed.Binary_input"><Binary mime-type="x" value="00ff7f"/></Parameter>
      <Parameter name="feed.Enumeration_input"><Enumeration name="Option" value="Option 2"/></Parameter>"#;
    let read = Ssp::open(files(parameters, "")).unwrap();
    let system = read.system().unwrap();
    let options = Options {
        stop: read.experiment().1,
        step: Some(1.0),
        set: read.set(&system).unwrap(),
        coupling: Coupling::GaussSeidel,
        outputs: Some(vec![
            "decay.x".to_owned(),
            "two.y[2]".to_owned(),
            "feed.*_output".to_owned(),
            "feed.Binary_output".to_owned(),
        ]),
        ..Options::default()
    };
    let table = drive(&system, &options).unwrap();
    let mut csv = Vec::new();
    table.write_csv(&mut csv).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    let row = csv.lines().nth(1).unwrap();
    for part in [
        "-0.25",
        "-128",
        "9223372036854775807",
        "true",
        "two words",
        "00ff7f",
        ",2",
    ] {
        assert!(row.contains(part), "{part} is not in {row}");
    }
    // With A = 0 and B = C = D = 1: y = u + h (the sum of u at the steps before), twice.
    let (mut one, mut two) = (0.0, 0.0);
    for row in 1..5 {
        let u = table.real("decay.x").unwrap()[row];
        one += u;
        two += u + one;
        let found = table.real("two.y[2]").unwrap()[row];
        assert!(
            (found - (u + one + two)).abs() < 1e-12,
            "row {row}: {found}"
        );
    }

    let told = |parameters: &str, connection: &str| {
        Ssp::open(files(parameters, connection))
            .unwrap_err()
            .to_string()
    };
    for (parameter, part) in [
        (
            "<String><Value value=\"a\"/><Value value=\"b\"/></String><Dimension size=\"3\"/>",
            "parameter `p`: found 2 values for the dimensions [3], expected one for each element",
        ),
        (
            "<String value=\"a\"><Value value=\"b\"/></String>",
            "found the attribute value \"a\" and an element Value \"b\"",
        ),
        ("<Dimension size=\"3\"/>", "parameter `p`: found no value"),
    ] {
        let told = told(
            &format!("<Parameter name=\"p\">{parameter}</Parameter>"),
            "",
        );
        assert!(told.contains(part), "{part} is not in\n{told}");
    }
    let indices = r#"<Connection startElement="one" startConnector="y" startIndices="1" endElement="decay" endConnector="k"/>"#;
    let told = told("", indices);
    assert!(
        told.contains("connection `one.y` to `decay.k`: found startIndices"),
        "{told}"
    );
    let texts = r#"<Parameter name="p"><String><Value value="a b"/><Value value="c"/></String><Dimension size="1"/><Dimension size="2"/></Parameter>"#;
    let read = Ssp::open(files(texts, "")).unwrap();
    let set = read.set(&read.system().unwrap()).unwrap();
    let pair = |name: &str, value: &str| (name.to_owned(), value.to_owned());
    assert_eq!(set, [pair("p[1,1]", "a b"), pair("p[1,2]", "c")]);
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
