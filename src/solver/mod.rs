//! Solvers of the step problem.
