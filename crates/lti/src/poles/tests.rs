//! Tests of `poles.rs`.
