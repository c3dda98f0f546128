//! Tests of `transmissibility.rs`.
