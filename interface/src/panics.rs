//! Panics behind the C interface: what they say, and where they came from.

use std::any::Any;
use std::panic::{PanicHookInfo, set_hook, take_hook};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::thread::{ThreadId, current};

/// Where threads panicked that nobody has asked about, the latest last. Not in the threads themselves: what they hold would
/// keep the library loaded.
static PLACES: Mutex<Vec<(ThreadId, String)>> = Mutex::new(Vec::new());

/// Most places that are kept.
const KEPT: usize = 16;

fn places() -> MutexGuard<'static, Vec<(ThreadId, String)>> {
    PLACES.lock().unwrap_or_else(PoisonError::into_inner)
}

type Hook = Box<dyn Fn(&PanicHookInfo<'_>) + Send + Sync>;

/// What was done with panics before. A static: what the hook captured would be lost with the library when it is unloaded.
static BEFORE: OnceLock<Hook> = OnceLock::new();

/// From now on the places of panics are kept for [`told`]. What was done with panics before is still done.
pub fn watch() {
    BEFORE.get_or_init(|| {
        let before = take_hook();
        set_hook(Box::new(keep));
        before
    });
}

fn keep(panic: &PanicHookInfo<'_>) {
    if let Some(place) = panic.location() {
        let mut places = places();
        if places.len() == KEPT {
            places.remove(0);
        }
        places.push((current().id(), place.to_string()));
    }
    if let Some(before) = BEFORE.get() {
        before(panic);
    }
}

/// The message of a panic that was caught in this thread, and file and line that it came from. A panic of a worker goes on in
/// the thread that waits for it: without a place of this thread it is the latest.
#[must_use]
pub fn told(panic: &(dyn Any + Send)) -> String {
    let mut places = places();
    let own = places.iter().rposition(|(id, _)| *id == current().id());
    let place = match own {
        Some(own) => Some(places.remove(own)),
        None => places.pop(),
    };
    match place {
        Some((_, place)) => format!("{} ({place})", text(panic)),
        None => text(panic).to_owned(),
    }
}

fn text(panic: &(dyn Any + Send)) -> &str {
    let owned = panic.downcast_ref::<String>().map(String::as_str);
    owned
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("panic without a message")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::catch_unwind;

    #[test]
    fn a_panic_tells_its_message_and_its_place() {
        watch();
        let line = line!() + 1;
        let panic = catch_unwind(|| panic!("out of {}", "luck")).unwrap_err();
        let told = told(&*panic);
        assert!(told.starts_with("out of luck ("), "{told}");
        assert!(told.contains(&format!("panics.rs:{line}:")), "{told}");
    }
}
