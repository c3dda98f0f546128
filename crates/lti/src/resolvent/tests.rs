//! Tests of `resolvent.rs`.
