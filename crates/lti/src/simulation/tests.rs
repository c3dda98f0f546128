//! Tests of `simulation.rs`.
