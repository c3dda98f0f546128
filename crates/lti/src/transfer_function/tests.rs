//! Tests of `transfer_function.rs`.
