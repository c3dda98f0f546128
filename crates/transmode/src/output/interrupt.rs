//! Ctrl-C: the program ends at once, but not between a draft and its file.

use std::sync::{Mutex, PoisonError};

/// Held while files are written.
static WRITING: Mutex<()> = Mutex::new(());

/// Does work that leaves drafts behind where it is broken off. It must not be called within itself.
pub(crate) fn uninterrupted<T>(work: impl FnOnce() -> T) -> T {
    let _writing = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
    work()
}

/// Lets an interruption or a request to end wait until what is being written is in its place. To be called once, by the program.
///
/// The signal then ends the program as if nobody had taken it, so that a shell's loop ends, too. Where there are no such signals, or no thread to take
/// them, nothing changes.
pub fn end_between_files() {
    // A thread that cannot be started leaves the signals as they are.
    #[cfg(unix)]
    let _ = std::thread::Builder::new().spawn(take_signals);
}

#[cfg(unix)]
fn take_signals() {
    use std::io::{IsTerminal, Write};

    use signal_hook::consts::{SIGINT, SIGTERM};

    let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGINT, SIGTERM]) else { return };
    for signal in signals.forever() {
        let _writing = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
        let mut terminal = std::io::stderr();
        if terminal.is_terminal() {
            // What a spinner or a bar left on its line.
            let _ = terminal.write_all(b"\r\x1b[2K");
        }
        let _ = signal_hook::low_level::emulate_default_handler(signal);
    }
}
