//! Gives the library a build id: a hash of every source file that goes into it.
//!
//! The command line refuses to pack a library whose id is not its own, so an FMU never carries an older solver than
//! the one that wrote its description.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default()).join("..");
    let mut hasher = DefaultHasher::new();
    for part in [
        "src",
        "interface/src",
        "modelDescription/src",
        "fmu/src",
        "Cargo.lock",
    ] {
        let path = root.join(part);
        println!("cargo::rerun-if-changed={}", path.display());
        hash(&path, part, &mut hasher)?;
    }
    let version = env::var("CARGO_PKG_VERSION").unwrap_or_default();
    println!(
        "cargo::rustc-env=SPHERE_DDA_BUILD_ID={version}+{:016x}",
        hasher.finish()
    );
    Ok(())
}

/// Adds names and contents below `path`, in the order of the names.
fn hash(path: &Path, name: &str, hasher: &mut DefaultHasher) -> io::Result<()> {
    // Packaged alone, the crate has no neighbours.
    if !path.exists() {
        return Ok(());
    }
    name.hash(hasher);
    if path.is_file() {
        fs::read(path)?.hash(hasher);
        return Ok(());
    }
    let mut children: Vec<_> = fs::read_dir(path)?.collect::<Result<_, _>>()?;
    children.sort_by_key(fs::DirEntry::file_name);
    for child in children {
        hash(&child.path(), &child.file_name().to_string_lossy(), hasher)?;
    }
    Ok(())
}
