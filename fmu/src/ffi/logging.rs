//! Which categories are logged.

use std::ffi::c_char;

use super::guard::{Component, Stages, Status, lend};
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
        Ok(choose(component, function, on, &names))
    })
}

/// As [`select`], with names that are read.
pub(super) fn choose<S: Status>(
    component: &mut Component,
    function: &str,
    on: bool,
    names: &[&str],
) -> S {
    let log = component.instance.log();
    let unknown = log.select(on, names);
    if unknown.is_empty() {
        return S::OK;
    }
    let names = unknown.join(", ");
    log.write(
        Level::Warning,
        format_args!("{function}: unknown categories {names}"),
    );
    S::WARNING
}
