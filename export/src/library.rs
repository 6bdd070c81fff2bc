//! Where the libraries to pack are, and whether they belong to this program.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use sphere_dda_fmi_interface::platform::Platform;

use sphere_dda_fmu::version::BUILD_ID;

use crate::error::{ExportError, LIBRARY_VARIABLE};

/// Name of the library's crate.
const CRATE: &str = "sphere_dda_fmu";

/// Folder beside the program that has a folder for each platform.
const PLATFORMS: &str = "platforms";

/// A library and the platform it is for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Library {
    /// The platform.
    pub platform: Platform,
    /// The file.
    pub path: PathBuf,
}

/// The libraries for `platforms`, each once, checked: those that `fmu/platforms/build` has put into `platforms/NAME` beside this
/// program or one folder up. For the platform of this program `explicit` comes first and [`find_library`] last; without
/// `platforms` there is only that one.
///
/// # Errors
/// As [`find_library`] and [`check_library`]; [`ExportError::NoLibraryFor`].
pub fn find_libraries(
    explicit: Option<&Path>,
    platforms: &[Platform],
) -> Result<Vec<Library>, ExportError> {
    if platforms.is_empty() {
        let (platform, path) = (Platform::HERE, find_library(explicit)?);
        check(platform, &path)?;
        return Ok(vec![Library { platform, path }]);
    }
    let find = |&platform: &Platform| {
        let here = platform == Platform::HERE;
        let path = match apart(platform) {
            Ok(path) if !(here && explicit.is_some()) => path,
            Err(missing) if !here => return Err(missing),
            _ => find_library(explicit)?,
        };
        check(platform, &path)?;
        Ok(Library { platform, path })
    };
    let first = |(k, platform): &(usize, &Platform)| !platforms[..*k].contains(platform);
    let each = platforms.iter().enumerate().filter(first);
    each.map(|(_, platform)| find(platform)).collect()
}

/// The module that `fmu/platforms/build wasm` has put beside this program, checked.
///
/// # Errors
/// [`ExportError::NoLibraryFor`] and as [`check_library`].
pub(crate) fn find_module() -> Result<PathBuf, ExportError> {
    let path = apart(Platform::WASM)?;
    check(Platform::WASM, &path)?;
    Ok(path)
}

/// The library that was built apart for a platform.
fn apart(platform: Platform) -> Result<PathBuf, ExportError> {
    let own = own_folder();
    let folders = [Some(own.as_path()), own.parent()].into_iter().flatten();
    let searched: Vec<PathBuf> = folders
        .map(|folder| folder.join(PLATFORMS).join(platform.name))
        .collect();
    let name = platform.file(CRATE);
    let found = searched.iter().map(|folder| folder.join(&name));
    let found = found.into_iter().find(|path| path.is_file());
    found.ok_or(ExportError::NoLibraryFor {
        platform: platform.name,
        name,
        searched,
    })
}

/// The folder of this program.
fn own_folder() -> PathBuf {
    let program = env::current_exe().ok();
    program
        .and_then(|exe| exe.parent().map(Path::to_path_buf))
        .unwrap_or_default()
}

/// The library to pack: `explicit`, else the environment variable [`LIBRARY_VARIABLE`], else beside this program, in its
/// `deps` folder or in `platforms/NAME`, where one that fits this program comes first.
///
/// # Errors
/// [`ExportError::NoLibrary`].
pub fn find_library(explicit: Option<&Path>) -> Result<PathBuf, ExportError> {
    let name = Platform::HERE.file(CRATE);
    let named = explicit
        .map(Path::to_path_buf)
        .or_else(|| env::var_os(LIBRARY_VARIABLE).map(OsString::into));
    if let Some(path) = named {
        let missing = || ExportError::NoLibrary {
            name: path.display().to_string(),
            searched: vec![path.clone()],
        };
        return if path.is_file() {
            Ok(path)
        } else {
            Err(missing())
        };
    }
    let own = own_folder();
    // Tests and examples run from below the folder that has the library.
    let mut searched = vec![own.clone(), own.join("deps")];
    searched.extend(own.parent().map(Path::to_path_buf));
    // A program that was installed has the libraries of all platforms beside it, and no other.
    searched.push(own.join(PLATFORMS).join(Platform::HERE.name));
    let mut found: Vec<PathBuf> = searched
        .iter()
        .map(|folder| folder.join(&name))
        .filter(|path| path.is_file())
        .collect();
    if found.is_empty() {
        return Err(ExportError::NoLibrary { name, searched });
    }
    // Cargo may leave an old copy beside the program and put the new one into `deps`.
    let fresh = found.iter().position(|path| check_library(path).is_ok());
    Ok(found.swap_remove(fresh.unwrap_or(0)))
}

/// Refuses a library that was not built from the sources of this program: it holds their id as text.
///
/// # Errors
/// [`ExportError::Read`], [`ExportError::Stale`].
pub fn check_library(path: &Path) -> Result<(), ExportError> {
    check(Platform::HERE, path)
}

/// As [`check_library`], for any platform.
fn check(platform: Platform, path: &Path) -> Result<(), ExportError> {
    let code = fs::read(path).map_err(|source| ExportError::Read {
        path: path.to_path_buf(),
        source,
    })?;
    let id = BUILD_ID.as_bytes();
    if code.windows(id.len()).any(|part| part == id) {
        return Ok(());
    }
    Err(ExportError::Stale {
        path: path.to_path_buf(),
        mend: if platform == Platform::HERE {
            "cargo build --release -p sphere-dda-fmu".to_owned()
        } else {
            format!("fmu/platforms/build {}", platform.name)
        },
    })
}
