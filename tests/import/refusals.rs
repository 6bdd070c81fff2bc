//! Archives, descriptions and libraries that cannot be used.

use std::path::Path;

use sphere_dda_fmu::import::{ArchiveError, Fmu, ImportError, Limits};

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
