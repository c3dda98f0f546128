//! The program: its arguments, its streams, its exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    let (mut out, mut err) = (std::io::stdout().lock(), std::io::stderr().lock());
    transmode::run(std::env::args_os(), &mut out, &mut err).into()
}
