//! Tests of `scaling.rs`.
