//! Tests of `time.rs`.
