//! Tests of `invariant_zeros.rs`.
