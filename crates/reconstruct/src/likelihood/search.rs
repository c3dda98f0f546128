//! How is it searched? From starts to local optima, from these to the best one.
//!
//! | file | what it does |
//! |---|---|
//! | `hold_selection.rs` | which hold: the search with the excitation held between samples, and with one that moves |
//! | `multistart.rs` | over all starts and their local optima to the best one |
//! | `slow_mode_restarts.rs`, `eigenvalue_penalty.rs` | restarts with a slow mode moved elsewhere |
//! | `frequency_subset.rs` | fewer frequencies for the first look |
//! | `local_search.rs` | from one start to its local optimum, noise levels and input directions included |
//! | `levenberg_marquardt.rs` | steps downhill |
//! | `input_direction.rs` | b_j from the spectra with A and C held |
//! | `noise_levels.rs` | noise levels by restricted likelihood |
//! | `report.rs` | how the search went |

pub(crate) mod eigenvalue_penalty;
mod frequency_subset;
pub(crate) mod hold_selection;
mod input_direction;
pub(crate) mod levenberg_marquardt;
pub(crate) mod local_search;
pub(crate) mod multistart;
pub(crate) mod noise_levels;
pub(crate) mod report;
mod slow_mode_restarts;
