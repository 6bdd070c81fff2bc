//! Where the resources of an FMU are.
//!
//! `fmi2Instantiate` passes a URI that importers write in many ways: `file:///p`, `file:/p`, `file://localhost/p`,
//! plain paths, percent-encoded or not, with a slash at the end or not, with a drive of Windows, or nothing at all.

use std::path::{Path, PathBuf};

use percent_encoding::percent_decode_str;
use thiserror::Error;

/// Why there is no resource directory.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ResourceError {
    /// The URI is not one of a file on this machine.
    #[error(
        "resource location: found {uri:?}, expected a URI like `file:///path/resources` or a path: unpack the FMU on this machine"
    )]
    NotLocal {
        /// The URI.
        uri: String,
    },
    /// There is no such directory.
    #[error(
        "resource location: found {given}, which is no directory at {path}, expected the unpacked folder `resources` \
         of the FMU: unpack the whole FMU before it is instantiated",
        path = path.display()
    )]
    NotThere {
        /// What the importer passed.
        given: String,
        /// The path that it means.
        path: PathBuf,
    },
    /// The importer passed nothing, and the system does not tell where the library is.
    #[error(
        "resource location: found none, and not the library's own path either, expected a URI: have the importer pass fmuResourceLocation"
    )]
    NoLibrary,
}

/// The resource directory that `uri` means. `None` or the empty text is the folder `resources` of the FMU that this
/// library lies in (`binaries/<platform>/`), or else beside the library.
///
/// # Errors
///
/// Every variant of [`ResourceError`]. Only on Linux can the library find itself.
pub fn directory(uri: Option<&str>) -> Result<PathBuf, ResourceError> {
    let Some(uri) = uri.filter(|uri| !uri.is_empty()) else {
        let library = own_library().ok_or(ResourceError::NoLibrary)?;
        return beside(&library);
    };
    let raw = local_part(uri, cfg!(windows)).ok_or_else(|| ResourceError::NotLocal {
        uri: uri.to_owned(),
    })?;
    // Some importers encode, some do not; a name may hold a `%` of its own.
    let decoded = percent_decode_str(&raw)
        .decode_utf8()
        .map(|text| PathBuf::from(&*text));
    let literal = PathBuf::from(&raw);
    let candidates = [decoded.ok(), Some(literal.clone())];
    let found = candidates
        .iter()
        .flatten()
        .find(|candidate| candidate.is_dir());
    match found {
        Some(path) => Ok(path.clone()),
        None => Err(ResourceError::NotThere {
            given: format!("{uri:?}"),
            path: candidates.into_iter().flatten().next().unwrap_or(literal),
        }),
    }
}

/// The path in `uri`, still encoded; `None` if it is not on this machine.
fn local_part(uri: &str, windows: bool) -> Option<String> {
    let Some(rest) = strip_scheme(uri, "file:") else {
        // A single letter is a drive, not a scheme.
        let scheme = uri.find("://").is_some_and(|at| at > 1);
        return (!scheme).then(|| uri.to_owned());
    };
    let path = match rest.strip_prefix("//") {
        None => rest.to_owned(),
        Some(after) if is_drive(after) => after.to_owned(),
        Some(after) => {
            let (host, path) = after.split_at(after.find('/')?);
            match host {
                "" => path.to_owned(),
                _ if host.eq_ignore_ascii_case("localhost") => path.to_owned(),
                _ if windows => format!("//{host}{path}"),
                _ => return None,
            }
        }
    };
    // `/C:/x` is `C:/x`.
    let drive = path.strip_prefix('/').filter(|after| is_drive(after));
    Some(drive.unwrap_or(&path).to_owned())
}

fn strip_scheme<'a>(uri: &'a str, scheme: &str) -> Option<&'a str> {
    let start = uri.get(..scheme.len())?;
    start
        .eq_ignore_ascii_case(scheme)
        .then(|| uri.get(scheme.len()..))?
}

/// Whether the text begins with a drive: `C:` or `C|`, then a separator or the end.
fn is_drive(text: &str) -> bool {
    let mut bytes = text.bytes();
    bytes.next().is_some_and(|byte| byte.is_ascii_alphabetic())
        && matches!(bytes.next(), Some(b':' | b'|'))
        && matches!(bytes.next(), None | Some(b'/' | b'\\'))
}

/// The folder `resources` that belongs to the library at `library`.
fn beside(library: &Path) -> Result<PathBuf, ResourceError> {
    let unpacked = library.ancestors().nth(3);
    let folder = library.parent();
    let candidates: Vec<PathBuf> = [unpacked, folder]
        .into_iter()
        .flatten()
        .map(|place| place.join("resources"))
        .collect();
    let found = candidates.iter().find(|candidate| candidate.is_dir());
    match (found, candidates.first()) {
        (Some(path), _) => Ok(path.clone()),
        (None, Some(path)) => Err(ResourceError::NotThere {
            given: "none".to_owned(),
            path: path.clone(),
        }),
        (None, None) => Err(ResourceError::NoLibrary),
    }
}

/// The file that this code was loaded from. `/proc/self/maps` has its absolute path, also if it was opened by a
/// relative one and the working directory has changed since.
fn own_library() -> Option<PathBuf> {
    let maps = std::fs::read_to_string("/proc/self/maps").ok()?;
    mapped_at(&maps, own_library as *const () as usize)
}

/// The file that is mapped at `address`, by the lines of `/proc/self/maps`:
/// `start-end permissions offset device inode path`.
fn mapped_at(maps: &str, address: usize) -> Option<PathBuf> {
    for line in maps.lines() {
        let (range, _) = line.split_once(' ')?;
        let (start, end) = range.split_once('-')?;
        let start = usize::from_str_radix(start, 16).ok()?;
        let end = usize::from_str_radix(end, 16).ok()?;
        if (start..end).contains(&address) {
            let path = line.get(line.find('/')?..)?;
            // The kernel writes a line feed in a name as `\012`.
            return Some(PathBuf::from(path.replace("\\012", "\n")));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn forms_of_the_location() {
        for (uri, path) in [
            ("file:///tmp/a/resources", "/tmp/a/resources"),
            ("file:/tmp/a/resources", "/tmp/a/resources"),
            ("file://localhost/tmp/a", "/tmp/a"),
            ("FILE://LocalHost/tmp/a/", "/tmp/a/"),
            ("/tmp/a/resources/", "/tmp/a/resources/"),
            ("resources", "resources"),
            ("file:resources", "resources"),
            ("file:///C:/a/resources", "C:/a/resources"),
            ("file:/C:/a", "C:/a"),
            ("file://C:/a", "C:/a"),
            ("file:///c|/a", "c|/a"),
            ("C:\\a\\resources", "C:\\a\\resources"),
            ("C://a", "C://a"),
            ("file:///tmp/run #2?/resources", "/tmp/run #2?/resources"),
        ] {
            assert_eq!(local_part(uri, false).as_deref(), Some(path), "{uri}");
        }
        let share = local_part("file://server/share/a", true);
        assert_eq!(share.as_deref(), Some("//server/share/a"));
        for uri in [
            "file://server/share/a",
            "http://a/b",
            "file://server",
            "ftp://x",
        ] {
            assert_eq!(local_part(uri, false), None, "{uri}");
        }
    }

    #[test]
    fn refusals_name_what_was_found() {
        let error = directory(Some("http://a/b")).unwrap_err();
        assert!(error.to_string().contains("http://a/b"), "{error}");
        let error = directory(Some("file:///no%20such/dir")).unwrap_err();
        assert_eq!(
            error,
            ResourceError::NotThere {
                given: "\"file:///no%20such/dir\"".to_owned(),
                path: "/no such/dir".into(),
            }
        );
    }

    #[test]
    fn the_library_finds_itself() {
        let executable = std::env::current_exe().unwrap();
        assert_eq!(own_library(), Some(executable.canonicalize().unwrap()));

        let maps =
            "1000-2000 r-xp 00000000 08:01 7 /opt/a b/x.so\n2000-3000 rw-p 00000000 00:00 0 \n";
        assert_eq!(mapped_at(maps, 0x1fff), Some("/opt/a b/x.so".into()));
        assert_eq!(mapped_at(maps, 0x2000), None);
        assert_eq!(mapped_at(maps, 0x3000), None);
    }

    #[test]
    fn resources_lie_two_folders_up_or_beside() {
        let root = tempfile::tempdir().unwrap();
        let binaries = root.path().join("binaries/linux64");
        std::fs::create_dir_all(&binaries).unwrap();
        let library = binaries.join("x.so");
        assert!(matches!(
            beside(&library),
            Err(ResourceError::NotThere { .. })
        ));
        std::fs::create_dir(binaries.join("resources")).unwrap();
        assert_eq!(beside(&library), Ok(binaries.join("resources")));
        std::fs::create_dir(root.path().join("resources")).unwrap();
        assert_eq!(beside(&library), Ok(root.path().join("resources")));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Whatever the folder is called, each way of writing it leads there.
        #[test]
        fn every_way_of_writing_leads_there(name in "[a-zA-Z0-9 %#?&+äß~.-]{1,20}") {
            prop_assume!(name != "." && name != "..");
            let root = tempfile::tempdir().unwrap();
            let path = root.path().join(format!("x{name}"));
            std::fs::create_dir(&path).unwrap();
            let encoded = url::Url::from_file_path(&path).unwrap().to_string();
            let plain = path.to_str().unwrap();
            for uri in [
                encoded.clone(),
                format!("{encoded}/"),
                encoded.replace("file://", "file:"),
                encoded.replace("file://", "file://localhost"),
                plain.to_owned(),
                format!("{plain}/"),
                format!("file://{plain}"),
            ] {
                let found = directory(Some(&uri));
                prop_assert_eq!(found.as_deref().map(Path::canonicalize).unwrap().unwrap(),
                    path.canonicalize().unwrap(), "{}", uri);
            }
        }

        #[test]
        fn no_text_is_a_panic(uri in ".{0,40}") {
            let _outcome = directory(Some(&uri));
        }
    }
}
