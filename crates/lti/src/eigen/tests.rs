//! Tests of `eigen.rs`.
