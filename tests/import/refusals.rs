//! Archives, descriptions and libraries that cannot be used.

use std::path::Path;

use sphere_dda_master::{ArchiveError, Fmu, ImportError, Limits};

use crate::foreign_fmu::{Build, entries, pack, write_archive, write_link};

#[test]
fn libraries_that_cannot_be_used_are_named() {
    let instantiate = |build: Build, edit: fn(&mut String)| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.fmu");
        pack(&path, build, edit);
        let fmu = Fmu::open(&path).unwrap();
        let result = fmu.instantiate("x", false).map(|_| ());
        result.unwrap_err()
    };
    let error = instantiate(Build::WithoutDoStep, |_| ());
    assert!(
        matches!(
            error,
            ImportError::MissingFunction {
                function: "fmi2DoStep",
                ..
            }
        ),
        "{error}"
    );
    let error = instantiate(Build::UndefinedSymbol, |_| ());
    assert!(matches!(error, ImportError::Load { .. }), "{error}");
    let error = instantiate(Build::OtherVersion, |_| ());
    assert!(
        error
            .to_string()
            .contains("found \"1.0\", expected \"2.0\""),
        "{error}"
    );
    let error = instantiate(Build::Whole, |xml| {
        *xml = xml.replace("{foreign-", "{other-")
    });
    assert!(
        error
            .to_string()
            .contains("the FMU says: wrong guid {other-oscillator}"),
        "{error}"
    );
    let error = instantiate(Build::Whole, |xml| {
        *xml = xml.replace("Identifier=\"oscillator\"", "Identifier=\"pendulum\"");
    });
    let ImportError::NoBinary { found, .. } = &error else {
        panic!("{error}");
    };
    assert!(found.contains("64"), "{found}");
}

#[test]
fn hostile_archives_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.fmu");
    let refusal = |path: &Path, limits: Limits| match Fmu::open_within(path, limits).unwrap_err() {
        ImportError::Archive { source, .. } => source,
        error => panic!("{error}"),
    };
    let small = Limits {
        entries: 10,
        bytes: 1 << 20,
        ratio: 100,
    };

    for name in [
        "../evil.txt",
        "/evil.txt",
        "a/../../evil.txt",
        "..\\evil.txt",
        "C:\\evil.txt",
    ] {
        write_archive(&path, &[(name, b"x".to_vec())]);
        let error = refusal(&path, Limits::default());
        assert!(
            matches!(error, ArchiveError::Escape { .. }),
            "{name}: {error}"
        );
        assert!(!folder.path().parent().unwrap().join("evil.txt").exists());
    }

    write_archive(&path, &[("zeros", vec![0; 2 << 20])]);
    let error = refusal(&path, small);
    assert!(
        matches!(
            error,
            ArchiveError::Limit {
                what: "bytes unpacked",
                ..
            }
        ),
        "{error}"
    );
    // 1000 to 1, once there is enough of it to matter.
    write_archive(&path, &[("zeros", vec![0; 80 << 20])]);
    let error = refusal(&path, Limits::default());
    assert!(
        matches!(
            error,
            ArchiveError::Limit {
                what: "unpacked bytes per packed byte",
                ..
            }
        ),
        "{error}"
    );

    let many: Vec<String> = (0..11).map(|k| format!("f{k}")).collect();
    let many: Vec<_> = many.iter().map(|name| (&**name, Vec::new())).collect();
    write_archive(&path, &many);
    let error = refusal(&path, small);
    assert!(
        matches!(
            error,
            ArchiveError::Limit {
                what: "entries",
                ..
            }
        ),
        "{error}"
    );

    write_link(&path, "resources/link", "/etc/passwd");
    let error = refusal(&path, Limits::default());
    assert!(
        matches!(error, ArchiveError::SymbolicLink { .. }),
        "{error}"
    );

    write_archive(
        &path,
        &[("a1", b"first".to_vec()), ("a2", b"second".to_vec())],
    );
    let bytes = std::fs::read(&path).unwrap();
    let twice: Vec<u8> = String::from_utf8_lossy(&bytes)
        .contains("a2")
        .then(|| replace(&bytes, b"a2", b"a1"))
        .unwrap();
    std::fs::write(&path, twice).unwrap();
    let error = refusal(&path, Limits::default());
    assert!(matches!(error, ArchiveError::Overlap), "{error}");

    // The same content twice is no reason: what is missing then is the model description.
    write_archive(&path, &[("a1", b"same".to_vec()), ("a2", b"same".to_vec())]);
    let bytes = std::fs::read(&path).unwrap();
    std::fs::write(&path, replace(&bytes, b"a2", b"a1")).unwrap();
    let error = Fmu::open(&path).unwrap_err().to_string();
    assert!(error.contains("modelDescription.xml"), "{error}");

    std::fs::write(&path, b"no zip at all").unwrap();
    let error = refusal(&path, Limits::default());
    assert!(matches!(error, ArchiveError::Zip { .. }), "{error}");
    let error = refusal(&folder.path().join("absent.fmu"), Limits::default());
    assert!(matches!(error, ArchiveError::Open(_)), "{error}");

    // A size in the directory that lies: less is declared than comes out, or the checksum does not fit.
    let whole = entries(Build::Whole, |_| ());
    let whole: Vec<_> = whole
        .iter()
        .map(|(name, bytes)| (&**name, bytes.clone()))
        .collect();
    write_archive(&path, &whole);
    let bytes = std::fs::read(&path).unwrap();
    for cut in [bytes.len() / 2, bytes.len() - 10, 30] {
        std::fs::write(&path, &bytes[..cut]).unwrap();
        let error = refusal(&path, Limits::default());
        assert!(matches!(error, ArchiveError::Zip { .. }), "{error}");
    }
}

fn replace(bytes: &[u8], from: &[u8], to: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for at in 0..=bytes.len() - from.len() {
        if bytes[at..].starts_with(from) {
            bytes[at..at + from.len()].copy_from_slice(to);
        }
    }
    bytes
}

#[test]
fn descriptions_that_cannot_be_used_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.fmu");
    let refusal = |description: Option<&[u8]>| {
        match description {
            Some(text) => write_archive(&path, &[("modelDescription.xml", text.to_vec())]),
            None => write_archive(&path, &[("oscillator/modelDescription.xml", Vec::new())]),
        }
        Fmu::open(&path).unwrap_err()
    };
    let error = refusal(None);
    assert!(
        matches!(error, ImportError::NoDescription { .. }),
        "{error}"
    );
    let error = refusal(Some(b"\xff\xfe not UTF-8"));
    assert!(
        matches!(error, ImportError::NoDescription { .. }),
        "{error}"
    );
    for text in [
        "",
        "<fmiModelDescription",
        "<a/>",
        "<fmiModelDescription fmiVersion=\"3.0\"/>",
    ] {
        let error = refusal(Some(text.as_bytes()));
        assert!(matches!(error, ImportError::Description { .. }), "{error}");
    }
    let xml = String::from_utf8(entries(Build::Whole, |_| ())[0].1.clone()).unwrap();
    let exchange = xml
        .replace("<CoSimulation", "<ModelExchange")
        .replace("canHandleVariableCommunicationStepSize=\"true\"", "");
    let error = refusal(Some(exchange.as_bytes()));
    assert!(
        matches!(error, ImportError::NoCoSimulation { .. }),
        "{error}"
    );
    let escaping = xml.replace(
        "modelIdentifier=\"oscillator\"",
        "modelIdentifier=\"../../evil\"",
    );
    let error = refusal(Some(escaping.as_bytes()));
    assert!(
        matches!(error, ImportError::ModelIdentifier { .. }),
        "{error}"
    );
}

/// The sizes that an archive declares are not believed: neither a small one for much, nor an absurd one for little.
#[test]
fn declared_sizes_are_not_believed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.fmu");
    let size = 3_000_007_u32;
    let limits = Limits {
        bytes: 1 << 20,
        ..Limits::default()
    };
    for declared in [7_u32, u32::MAX - 1] {
        write_archive(&path, &[("zeros", vec![0; size as usize])]);
        let bytes = std::fs::read(&path).unwrap();
        let lying = replace(&bytes, &size.to_le_bytes(), &declared.to_le_bytes());
        assert_ne!(bytes, lying);
        std::fs::write(&path, lying).unwrap();
        let ImportError::Archive { source, .. } = Fmu::open_within(&path, limits).unwrap_err()
        else {
            panic!("{declared}");
        };
        assert!(
            matches!(
                source,
                ArchiveError::Limit { .. } | ArchiveError::Zip { .. }
            ),
            "{declared}: {source}"
        );
    }
    // Little is there, whatever is declared: nothing is reserved for it.
    let xml = entries(Build::Whole, |_| ())[0].1.clone();
    write_archive(&path, &[("modelDescription.xml", xml.clone())]);
    let bytes = std::fs::read(&path).unwrap();
    let length = u32::try_from(xml.len()).unwrap();
    std::fs::write(
        &path,
        replace(&bytes, &length.to_le_bytes(), &(u32::MAX - 1).to_le_bytes()),
    )
    .unwrap();
    if let Err(error) = Fmu::open_within(&path, limits) {
        assert!(matches!(error, ImportError::Archive { .. }), "{error}");
    }
}

/// Descriptions that would grow without bound: entities, nesting, arrays of FMI 3.0.
#[test]
fn descriptions_do_not_grow_without_bound() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.fmu");
    let refusal = |text: String| {
        write_archive(&path, &[("modelDescription.xml", text.into_bytes())]);
        Fmu::open(&path).unwrap_err().to_string()
    };
    let xml = String::from_utf8(entries(Build::Whole, |_| ())[0].1.clone()).unwrap();
    let laughs = xml.replacen(
        "<fmiModelDescription",
        "<!DOCTYPE x [<!ENTITY a \"&b;&b;\"><!ENTITY b \"&c;&c;\"><!ENTITY c \"ha\">]><fmiModelDescription",
        1,
    );
    assert!(refusal(laughs).contains("found a DOCTYPE, expected none"));
    let deep = xml.replace("<UnitDefinitions>", &"<x>".repeat(1_000_000));
    assert!(refusal(deep).contains("more than 64 nested elements"));

    let arrays = |dimensions: &str| {
        format!(
            "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"x\" instantiationToken=\"x\">\
             <CoSimulation modelIdentifier=\"x\"/><ModelVariables>\
             <UInt64 name=\"n\" valueReference=\"1\" causality=\"structuralParameter\" start=\"18446744073709551615\"/>\
             <Float64 name=\"big\" valueReference=\"2\" causality=\"input\" start=\"0\">{dimensions}</Float64>\
             </ModelVariables><ModelStructure/></fmiModelDescription>"
        )
    };
    for (dimensions, found) in [
        ("<Dimension start=\"1000000000000\"/>", "1000000000000"),
        (
            "<Dimension start=\"4294967296\"/><Dimension start=\"4294967296\"/>",
            "more than 2^64",
        ),
        ("<Dimension valueReference=\"1\"/>", "18446744073709551615"),
    ] {
        let told = refusal(arrays(dimensions));
        assert!(
            told.contains(&format!(
                "variable `big`: found {found} elements, expected at most"
            )),
            "{told}"
        );
    }
    let told = refusal(arrays("<Dimension start=\"-1\"/>"));
    assert!(told.contains("modelDescription.xml: line 1"), "{told}");
}
