//! What only the whole workspace can show: the program on files, and the layering of the crates.
#![expect(clippy::unwrap_used, reason = "a test that unwraps an error has failed")]

mod arrays;
mod bad_input;
mod fit;
mod fit_bad_input;
mod identify;
mod layering;
mod program;
