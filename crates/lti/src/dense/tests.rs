//! Tests of `dense.rs`.
