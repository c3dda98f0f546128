//! Tests of `frequency_response.rs`.
