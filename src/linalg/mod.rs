//! Sparse algebra over 6x6 blocks.
