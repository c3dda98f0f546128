//! Ctrl-C: the program ends at once, but not between a draft and its file.

use std::sync::{Mutex, PoisonError};

use crate::Exit;

/// Held while files are written.
static WRITING: Mutex<()> = Mutex::new(());

/// Does work that leaves drafts behind where it is broken off. It must not be called within itself.
pub(crate) fn uninterrupted<T>(work: impl FnOnce() -> T) -> T {
    let _writing = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
    work()
}

/// Lets an interruption or a request to end wait until what is being written is in its place. To be called once, by the program.
///
/// Where the system takes no handler, interruptions end the program as they would without one.
pub fn end_between_files() {
    let _ = ctrlc::set_handler(|| {
        let _writing = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
        std::process::exit(Exit::INTERRUPTED);
    });
}
