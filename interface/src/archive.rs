//! The archive of an FMU: deflated, without zip64 and with one fixed time stamp, so that the same files give the same
//! bytes.

use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use thiserror::Error;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// Why there is no archive.
#[derive(Debug, Error)]
#[error("cannot {action} `{}`: {source}; expected a folder that exists, may be written to and has free space: choose another one", path.display())]
pub struct ArchiveError {
    /// What was tried.
    action: &'static str,
    /// The file or folder.
    path: PathBuf,
    /// The reason.
    source: io::Error,
}

/// Packs files, given by their paths in the archive, into `fmu`, replacing it when all is done: whoever opens it sees
/// the old archive or the new one.
///
/// # Errors
/// [`ArchiveError`]; no half-written archive is left.
pub fn write(fmu: &Path, files: &[(String, &[u8])]) -> Result<(), ArchiveError> {
    let archive = zipped(files).map_err(failed("compress", fmu))?;
    let folder = match fmu.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    let mut file = tempfile::NamedTempFile::new_in(folder).map_err(failed("write into", folder))?;
    file.write_all(&archive).map_err(failed("write", fmu))?;
    let file: File = file
        .persist(fmu)
        .map_err(|e| failed("write", fmu)(e.error))?;
    file.sync_all().map_err(failed("write", fmu))?;
    readable(&file).map_err(failed("set the permissions of", fmu))
}

fn zipped(files: &[(String, &[u8])]) -> io::Result<Vec<u8>> {
    let options = SimpleFileOptions::default()
        .compression_method(zip::CompressionMethod::Deflated)
        .last_modified_time(zip::DateTime::default())
        .unix_permissions(0o644);
    let mut archive = ZipWriter::new(io::Cursor::new(Vec::new()));
    for (name, content) in files {
        archive.start_file(name.as_str(), options)?;
        archive.write_all(content)?;
    }
    Ok(archive.finish()?.into_inner())
}

/// Temporary files are private; an FMU is passed on.
#[cfg(unix)]
fn readable(file: &File) -> io::Result<()> {
    use std::fs::Permissions;
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn readable(_: &File) -> io::Result<()> {
    Ok(())
}

fn failed(action: &'static str, path: &Path) -> impl Fn(io::Error) -> ArchiveError {
    let path = path.to_path_buf();
    move |source| ArchiveError {
        action,
        path: path.clone(),
        source,
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn the_same_files_give_the_same_bytes() {
        let folder = tempfile::tempdir().unwrap();
        let files = [("a/b".to_owned(), &b"text"[..])];
        let paths = ["1.fmu", "2.fmu"].map(|name| folder.path().join(name));
        for path in &paths {
            write(path, &files).unwrap();
        }
        let [one, two] = paths.map(|path| fs::read(path).unwrap());
        assert_eq!(one, two);
        let error = write(Path::new("/no/such/folder/x.fmu"), &files).unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("cannot write into `/no/such/folder`"),
            "{error}"
        );
    }
}
