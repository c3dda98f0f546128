//! What two or more tasks use. Nothing here knows a task, and no task imports another.
//!
//! | file | what it holds |
//! |---|---|
//! | `page.rs`, `asked.rs` | pages under docs; their tables of what was asked for beside what was reached |
//! | `parallel.rs` | work on several threads, and how far it has come |
//! | `paper_aircraft.rs`, `noisy_flights.rs` | the paper's aircraft and records; the same with noise and other excitations |
//! | `simulator_flights.rs` | flights of aircraft in a simulator that nobody of the project wrote |
//! | `methods.rs` | the methods, applied to records, and how they look in figures |
//! | `modes.rs`, `matching.rs` | the modes that a method is to find; which eigenvalue stands for which, and how far off it is |
//! | `averages.rs`, `reference.rs` | what many numbers say together; the oracle values |

pub(crate) mod asked;
pub(crate) mod averages;
pub(crate) mod matching;
pub(crate) mod methods;
pub(crate) mod modes;
pub(crate) mod noisy_flights;
pub(crate) mod page;
pub(crate) mod paper_aircraft;
pub(crate) mod parallel;
pub(crate) mod reference;
pub(crate) mod simulator_flights;
