//! Alarms on simulated flights: how often on healthy sensors, and how soon on faulty ones.
#![expect(clippy::unwrap_used, reason = "a test that unwraps an error has failed")]

mod faults;
mod flights;
mod healthy;
