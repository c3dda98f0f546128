//! Tests of `state_space.rs`.
