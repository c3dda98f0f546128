//! Tests of `rosenbrock.rs`.
