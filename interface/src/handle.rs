//! What the importer holds of this library, behind pointers that it hands back: a number in front of each tells a living one
//! from one that was freed, or that is something else.

use std::ffi::c_void;

/// Types that are handed out, each with a number of its own.
pub trait Kind {
    /// The number in front of every value of the type.
    const MAGIC: u64;
}

/// A value behind a number.
#[repr(C)]
struct Handle<T> {
    magic: u64,
    value: T,
}

/// Hands out a value; [`take`] takes it back.
#[must_use]
pub fn give<T: Kind>(value: T) -> *mut c_void {
    let magic = T::MAGIC;
    Box::into_raw(Box::new(Handle { magic, value })).cast()
}

/// Whether a pointer is one of [`give`] that was not taken back.
fn lives<T: Kind>(pointer: *mut Handle<T>) -> bool {
    // SAFETY: not null and aligned; the importer passes what it was given. Should that have been freed, most allocators leave the
    // memory readable, and the number in it is overwritten by `take`: a call that is wrong by the standard fails instead of
    // harming others.
    !pointer.is_null()
        && pointer.is_aligned()
        && unsafe { (&raw const (*pointer).magic).read_volatile() } == T::MAGIC
}

/// The value behind a pointer; `None`: there is none of this kind.
///
/// # Safety
/// Nobody else uses the value while the reference lives.
pub unsafe fn look<'a, T: Kind>(pointer: *mut c_void) -> Option<&'a mut T> {
    let handle: *mut Handle<T> = pointer.cast();
    // SAFETY: alive; the caller uses it alone.
    lives(handle).then(|| unsafe { &mut (*handle).value })
}

/// Takes a value back; `None`: there is none of this kind.
///
/// # Safety
/// Nobody uses the value, and nobody else takes it at the same time.
pub unsafe fn take<T: Kind>(pointer: *mut c_void) -> Option<T> {
    let handle: *mut Handle<T> = pointer.cast();
    if !lives(handle) {
        return None;
    }
    // SAFETY: alive, so from `give`, and by the number below it is so only once.
    unsafe {
        (&raw mut (*handle).magic).write_volatile(0);
        Some(Box::from_raw(handle).value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct One(u8);
    struct Other;
    impl Kind for One {
        const MAGIC: u64 = 1;
    }
    impl Kind for Other {
        const MAGIC: u64 = 2;
    }

    #[test]
    fn only_what_was_given_is_taken_back() {
        let one = give(One(7));
        let mut foreign = [0_u64; 4];
        let odd: *mut c_void = one.wrapping_byte_add(1);
        // SAFETY: one thread, and no reference is kept.
        unsafe {
            assert_eq!(look::<One>(one).map(|one| one.0), Some(7));
            assert!(look::<Other>(one).is_none());
            assert!(take::<Other>(one).is_none());
            for pointer in [
                std::ptr::null_mut(),
                odd,
                foreign.as_mut_ptr().cast::<c_void>(),
            ] {
                assert!(look::<One>(pointer).is_none());
                assert!(take::<One>(pointer).is_none());
            }
            assert_eq!(take::<One>(one).map(|one| one.0), Some(7));
        }
    }
}
