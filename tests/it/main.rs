//! What only the whole workspace can show: the program on files, and the layering of the crates.
#![expect(clippy::unwrap_used, reason = "a test that unwraps an error has failed")]

mod arrays;
mod bad_files;
mod bad_input;
mod bad_windows;
mod browser;
mod damage;
mod field;
mod files;
mod fit;
mod fit_bad_input;
mod flights;
mod formats;
mod gaps;
mod identify;
mod identify_bad_input;
mod identify_numbers;
mod identify_records;
mod inspect;
mod lateral;
mod layering;
mod monitor;
mod oversampled;
mod pages;
mod program;
mod recorded_inputs;
mod report;
mod simulate;
mod tutorial;
