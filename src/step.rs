//! One internal time step.
