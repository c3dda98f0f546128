//! Tests of `exponential.rs`.
