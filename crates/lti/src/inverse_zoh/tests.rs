//! Tests of `inverse_zoh.rs`.
