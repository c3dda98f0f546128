//! What only the whole workspace can show: the program on files, and the layering of the crates.

mod bad_input;
mod identify;
mod layering;
mod program;
