//! Which categories are logged.

use std::ffi::c_char;

use super::guard::{Stages, Status, lend};
use sphere_dda_fmi_interface::abi2::fmi2Component;
use sphere_dda_fmi_interface::log::Level;

/// Chooses categories; see [`sphere_dda_fmi_interface::log::Log::select`]. Unknown names are told and left out.
pub(super) fn select<S: Status>(
    (c, function): (fmi2Component, &str),
    allowed: Stages,
    on: bool,
    count: usize,
    categories: *const *const c_char,
) -> S {
    lend(c, function, allowed, |component, lent| {
        let names = lent.array(categories, count, "categories")?.iter();
        let names: Vec<&str> = names
            .map(|&name| lent.text(name, "categories"))
            .collect::<Result<_, _>>()?;
        let log = component.instance.log();
        let unknown = log.select(on, &names);
        if unknown.is_empty() {
            return Ok(S::OK);
        }
        let names = unknown.join(", ");
        log.write(
            Level::Warning,
            format_args!("{function}: unknown categories {names}"),
        );
        Ok(S::WARNING)
    })
}
