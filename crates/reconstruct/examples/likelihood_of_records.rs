//! Maximum likelihood on two records of the paper's aircraft with sensor noise of 1 %: modes with deviations, and how long it takes.
//!
//! `cargo run --release -p reconstruct --example likelihood_of_records`

use std::io::Write;
use std::time::Instant;

use aircraft::catalog;
fn main() {}
