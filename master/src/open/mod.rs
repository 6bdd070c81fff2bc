//! Archives and model descriptions of others, unpacked and read within limits.

mod archive;
mod description;
mod opened;

pub use archive::{Limits, RATIO_FLOOR};
pub use description::Description;
pub use opened::remove_unpacked;

pub(crate) use archive::{inner_path, unpack};
pub(crate) use opened::{Folder, Opened, text};
