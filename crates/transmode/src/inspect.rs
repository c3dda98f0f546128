//! `transmode inspect`: what is in files, what is wrong with them, and how to go on.

mod file;
mod json;
mod mapping;
mod signal;
mod text;

use std::io::Write;
use std::path::{Path, PathBuf};

use crate::args::InspectArgs;
use crate::records::Progress;
use crate::{CommandError, Exit, output};
use file::{Inspected, Weight};
use mapping::{lateral, quoted};

/// Looks at the files and writes what was found.
pub(crate) fn run(
    args: &InspectArgs,
    progress: Progress,
    out: &mut dyn Write,
) -> Result<Exit, CommandError> {
    let selection = args.selection();
    selection.check()?;
    if let Some(file) = &args.json {
        let files: Vec<&Path> = args.files.iter().map(PathBuf::as_path).collect();
        output::check_place(file, &files)?;
    }
    let inspect = |file: &PathBuf| file::inspect(file, &selection, progress);
    let files = args.files.iter().map(inspect).collect::<Result<Vec<_>, _>>()?;
    let suggestion = suggestion(args, &files);

    // The file first: if it cannot be written, nothing has been said yet.
    let standard_output = Path::new("-");
    if let Some(file) = &args.json {
        output::write_whole(file, &json::render(&files, &suggestion)?, out)?;
    }
    if args.json.as_deref() != Some(standard_output) {
        output::write_whole(standard_output, text::render(&files, &suggestion).as_bytes(), out)?;
    }
    let is_problem =
        |file: &Inspected| file.findings.iter().any(|finding| finding.weight == Weight::Problem);
    Ok(if files.iter().any(is_problem) { Exit::Doubtful } else { Exit::Fine })
}

/// A command line for these files, with the sensors that look right; or which sensors are missing.
fn suggestion(args: &InspectArgs, files: &[Inspected]) -> String {
    let Some(first) = files.first() else { return String::new() };
    // A sensor that is dead in one file, or not there, is of no use.
    let is_good = |file: &Inspected, name: &str| {
        file.channels.iter().any(|channel| channel.name == name && !channel.signal.is_constant())
    };
    let names: Vec<&str> = first.channels.iter().map(|channel| channel.name.as_str()).collect();
    let common: Vec<&str> =
        names.into_iter().filter(|name| files.iter().all(|file| is_good(file, name))).collect();
    match lateral(&common) {
        Ok(sensors) => {
            let mut words: Vec<String> = vec!["transmode".to_owned(), "identify".to_owned()];
            words.extend(files.iter().map(|file| quoted(&file.file)));
            if files.len() == 1 {
                words.push("SECOND_FILE".to_owned());
            }
            words.extend(["--outputs".to_owned(), quoted(&sensors.join(","))]);
            if let Some(time) = &args.time {
                words.extend(["--time".to_owned(), quoted(time)]);
            } else if let Some(period_s) = args.sample_period {
                words.extend(["--sample-period".to_owned(), period_s.to_string()]);
            }
            format!("suggestion: {}", words.join(" "))
        }
        Err(missing) => {
            format!(
                "no suggestion: no column looks like {}; choose the sensors with --outputs",
                missing.join(" or ")
            )
        }
    }
}
