//! Tests of the crate against values computed elsewhere, and properties with planted answers.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

mod aircraft;
mod data;
mod oracle;
mod properties;
