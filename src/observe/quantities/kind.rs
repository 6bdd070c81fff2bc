//! What kind of number a quantity is.

/// What kind of number a quantity is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Any number.
    Real,
    /// A count, 0 or more.
    Count,
}
