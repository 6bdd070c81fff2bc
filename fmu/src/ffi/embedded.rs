//! The resources inside a component, which sees no files: the exporter appends them to its memory and writes at
//! [`SPHERE_DDA_RESOURCES`] where they are.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use sphere_dda::files;

/// Address and size of the resources \[bytes\], written by the exporter.
#[unsafe(no_mangle)]
static SPHERE_DDA_RESOURCES: [AtomicUsize; 2] = [AtomicUsize::new(0), AtomicUsize::new(0)];

const FOLDER: &str = "resources";

/// The folder that they are in.
pub(super) fn resources() -> &'static Path {
    files::hold(held);
    Path::new(FOLDER)
}

/// The files; none where they are damaged, and then the scene is what is missed.
fn held() -> BTreeMap<PathBuf, Vec<u8>> {
    let [address, size] = SPHERE_DDA_RESOURCES
        .each_ref()
        .map(|x| x.load(Ordering::Relaxed));
    let bytes = match size {
        0 => &[],
        // SAFETY: the exporter has put so many bytes there, which nothing else uses.
        _ => unsafe {
            std::slice::from_raw_parts(std::ptr::with_exposed_provenance::<u8>(address), size)
        },
    };
    let held: BTreeMap<String, Vec<u8>> = postcard::from_bytes(bytes).unwrap_or_default();
    held.into_iter()
        .map(|(name, content)| (Path::new(FOLDER).join(name), content))
        .collect()
}
