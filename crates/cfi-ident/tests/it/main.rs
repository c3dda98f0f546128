//! Integration tests: what the public functions give for records and planted models.

mod noise_free;
mod records;
