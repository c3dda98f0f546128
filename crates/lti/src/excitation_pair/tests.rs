//! Tests of `excitation_pair.rs`.
