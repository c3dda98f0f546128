//! Tests of `logarithm.rs`.
