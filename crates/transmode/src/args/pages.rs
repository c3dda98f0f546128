//! The command lines of `transmode completions` and `transmode man`.

use std::path::PathBuf;

use clap_complete::Shell;

/// Writes what a shell needs to complete this program's words.
///
/// For bash: transmode completions bash > ~/.local/share/bash-completion/completions/transmode
#[derive(Debug, clap::Args)]
pub(crate) struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    pub(crate) shell: Shell,
}

/// Writes the manual pages, one for the program and one for each command.
#[derive(Debug, clap::Args)]
pub(crate) struct ManArgs {
    /// The folder for the pages; it is made if it is not there. Pages that are there are replaced.
    #[arg(short, long, default_value = ".", value_name = "DIR")]
    pub(crate) output: PathBuf,
}
