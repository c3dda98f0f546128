//! How a command ends.

/// How a command ended; the program's exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Exit {
    /// 0: all is well, or nobody is left to read the result, as with `| head -0`.
    Fine = 0,
    /// 1: there is a result, but it cannot be trusted. The warnings say why.
    Doubtful = 1,
    /// 2: the command line or a file is at fault. No file is left half-written.
    BadInput = 2,
}

impl From<Exit> for std::process::ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}
