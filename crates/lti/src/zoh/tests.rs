//! Tests of `zoh.rs`.
