//! Variables of either version in one form.

mod declaration;
mod version2;
mod version3;

pub(crate) use declaration::{Items, MAX_ELEMENTS, Place, Variable, shape};
pub(crate) use version2::variables as variables_2;
pub(crate) use version3::variables as variables_3;
