//! From sensor records to named modes: the program behind `transmode`, as a function that a test can call.
//!
//! [`run`] takes the words of a command line and two places to write to, and returns the exit code. All files that the product reads or
//! writes are read or written here; the crates below compute.

mod aircraft_file;
mod args;
mod colors;
mod error;
mod exit;
mod fit;
mod identify;
mod inspect;
mod json;
mod modes;
mod numbers;
mod output;
mod pages;
mod records;
mod sensor_health;
mod simulate;

use std::ffi::OsString;
use std::io::{ErrorKind, Write};

use clap::Parser;

use colors::Colors;
use records::Progress;

pub use colors::Terminals;
pub use error::CommandError;
pub use exit::Exit;
pub use output::end_between_files;

/// Carries out a command line, the program's name first. Results go to `out`, errors to `err`, both without colours unless `--color always` asks for them.
///
/// # Example
///
/// ```
/// let (mut out, mut err) = (Vec::new(), Vec::new());
/// let exit = transmode::run(["transmode", "identify", "no-such-file.csv", "neither.csv"], &mut out, &mut err);
/// assert_eq!(exit, transmode::Exit::BadInput);
/// assert!(out.is_empty());
/// assert!(String::from_utf8_lossy(&err).starts_with("error: cannot read no-such-file.csv"));
/// ```
pub fn run<W: Into<OsString> + Clone>(
    words: impl IntoIterator<Item = W>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Exit {
    run_on(words, out, err, Terminals::default())
}

/// The same, with colours where a terminal shows them.
pub fn run_on<W: Into<OsString> + Clone>(
    words: impl IntoIterator<Item = W>,
    out: &mut dyn Write,
    err: &mut dyn Write,
    terminals: Terminals,
) -> Exit {
    let words: Vec<OsString> = words.into_iter().map(Into::into).collect();
    let typed = as_typed(&words);
    let colors = Colors::of(&words, terminals);
    let args = match args::Args::try_parse_from(&words) {
        Ok(args) => args,
        // Help and version are asked for, so they are results; anything else is bad input.
        Err(answer) => {
            let (to, exit): (&mut dyn Write, _) =
                if answer.use_stderr() { (err, Exit::BadInput) } else { (out, Exit::Fine) };
            let colored = if answer.use_stderr() { colors.err } else { colors.out };
            let text = answer.render();
            let text = if colored { text.ansi().to_string() } else { text.to_string() };
            return match to.write_all(text.as_bytes()) {
                Err(error) if error.kind() != ErrorKind::BrokenPipe => Exit::BadInput,
                _ => exit,
            };
        }
    };
    let progress = if args.quiet { Progress::Hidden } else { Progress::Shown };
    let mut nowhere = std::io::sink();
    // Where the result goes to a file, a quiet command says nothing.
    let out = if args.quiet && args.command.writes_files() { &mut nowhere } else { out };
    let result = match args.command {
        args::Command::Identify(args) => identify::run(&args, &typed, progress, out),
        args::Command::Fit(args) => fit::run(&args, progress, out),
        args::Command::Inspect(args) => inspect::run(&args, progress, out),
        args::Command::Simulate(args) => simulate::run(&args, out),
        args::Command::Monitor(args) => sensor_health::run(&args, progress, out),
        args::Command::Completions(args) => pages::completions(&args, out),
        args::Command::Man(args) => pages::man(&args, out),
    };
    result.unwrap_or_else(|error| {
        // A reader that went away, such as `head`, has what it wanted.
        if error.is_broken_pipe() {
            return Exit::Fine;
        }
        // Nothing is left to be told if even this cannot be written; the exit code says it.
        let _ = writeln!(err, "{} {error}", colors.label("error:"));
        Exit::BadInput
    })
}

/// A command line as a shell takes it, the program by its own name.
///
/// Bytes that are no text come out as replacement characters; such a line is for reading.
fn as_typed(words: &[OsString]) -> String {
    let arguments = words.iter().skip(1).map(|word| word.to_string_lossy());
    let text: Vec<_> = std::iter::once("transmode".into()).chain(arguments).collect();
    // A word with a zero byte, which no shell can take, leaves the line unquoted.
    shlex::try_join(text.iter().map(AsRef::as_ref)).unwrap_or_else(|_| text.join(" "))
}

#[cfg(test)]
mod tests {
    use super::as_typed;

    #[test]
    fn words_come_back_from_a_shell() {
        let typed = |words: &[&str]| as_typed(&words.iter().map(Into::into).collect::<Vec<_>>());
        assert_eq!(typed(&["/bin/transmode", "identify", "a.csv"]), "transmode identify a.csv");
        let words = ["", "identify", "two words.csv", "it's.csv", "--outputs", "$p,r"];
        let split = shlex::split(&typed(&words)).expect("a shell takes it");
        assert_eq!(split[1..], words[1..]);
    }
}
