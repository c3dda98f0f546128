//! Tests of `modes.rs`.
