//! Integration tests: what the public functions give for records and planted models.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail by panicking")]

mod engines;
mod limits;
mod noise_free;
mod planted;
mod records;
