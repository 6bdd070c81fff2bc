//! Results: read-only views of a simulation.
