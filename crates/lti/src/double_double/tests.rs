//! Tests of `double_double.rs`.
