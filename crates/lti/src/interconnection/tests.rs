//! Tests of `interconnection.rs`.
