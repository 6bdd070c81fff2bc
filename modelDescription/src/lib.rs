//! FMI model descriptions.
