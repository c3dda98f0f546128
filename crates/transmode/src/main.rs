//! The program: its arguments, its streams, its exit code.

use std::io::IsTerminal;
use std::process::ExitCode;

fn main() -> ExitCode {
    transmode::end_between_files();
    // Standard error is not locked: the thread of a spinner writes to it, too.
    let (mut out, mut err) = (std::io::stdout().lock(), std::io::stderr());
    let is_set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    // The convention of no-color.org, and terminals that say that they show none.
    let plain = is_set("NO_COLOR") || std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    let terminals =
        transmode::Terminals { out: out.is_terminal() && !plain, err: err.is_terminal() && !plain };
    transmode::run_on(std::env::args_os(), &mut out, &mut err, terminals).into()
}
