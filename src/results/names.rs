//! Names of the files of a run.

/// The number in a checkpoint's name; `None` if it is the name of something else.
pub(super) fn number(name: &str) -> Option<u64> {
    let digits = name.strip_prefix("checkpoint_")?.strip_suffix(".state")?;
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit());
    digits.parse().ok().filter(|_| plain)
}

pub(super) fn name(number: u64) -> String {
    format!("checkpoint_{number:06}.state")
}
