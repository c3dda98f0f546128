//! `transmode inspect`: what is in files, what is wrong with them, and how to go on.

mod causes;
mod file;
mod json;
mod mapping;
mod signal;
mod text;
mod verdict;

use std::io::Write;
use std::path::{Path, PathBuf};

pub(crate) use causes::{Cause, causes};

use crate::args::InspectArgs;
use crate::records::{self, Progress};
use crate::{CommandError, Exit, output};
use file::{Inspected, Weight};
use mapping::{lateral, quoted};
use verdict::Verdict;

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
    let reading = args.reading.options();
    let inspect = |file: &PathBuf| file::inspect(file, &selection, &reading, progress);
    let files = args.files.iter().map(inspect).collect::<Result<Vec<_>, _>>()?;
    let suggestion = suggestion(args, &files);

    output::write_result(
        args.json.as_deref(),
        || json::render(&files, &suggestion),
        || text::render(&files, &suggestion),
        out,
    )?;
    let is_problem =
        |file: &Inspected| file.findings.iter().any(|finding| finding.weight == Weight::Problem);
    Ok(if files.iter().any(is_problem) { Exit::Doubtful } else { Exit::Fine })
}

/// Why no command could use these files together.
fn obstacle(args: &InspectArgs, files: &[Inspected]) -> Option<String> {
    let twice = |(index, file): (usize, &PathBuf)| {
        args.files[..index].iter().any(|other| records::is_same_file(other, file))
    };
    if let Some((_, file)) = args.files.iter().enumerate().find(|found| twice(*found)) {
        return Some(format!("{} is given twice", file.display()));
    }
    if let Some(file) = files.iter().find(|file| file.sampling.is_none()) {
        return Some(format!("the samples of {} are not evenly spaced", file.file));
    }
    let period = |file: &Inspected| file.sampling.as_ref().map_or(0.0, |found| found.period_s);
    let first = files.first()?;
    // What identify takes for one period.
    let differs = |file: &&Inspected| !records::is_near_period(period(file), period(first));
    files.iter().find(differs).map(|file| {
        format!(
            "{} is sampled every {} s, {} every {} s: resample one of them",
            first.file,
            period(first),
            file.file,
            period(file)
        )
    })
}

/// A command line for these files, with the sensors that look right; or what keeps them from being used together.
fn suggestion(args: &InspectArgs, files: &[Inspected]) -> String {
    let Some(first) = files.first() else { return String::new() };
    if let Some(obstacle) = obstacle(args, files) {
        return format!("no suggestion: {obstacle}");
    }
    // A sensor that is dead in one file, or not there, is of no use.
    let is_good = |file: &Inspected, name: &str| {
        file.channels.iter().any(|channel| {
            let is_useless = matches!(
                channel.verdict,
                Some(Verdict::Constant | Verdict::Counter | Verdict::Copy { .. })
            );
            channel.name == name && !is_useless
        })
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
            if let Some(time) = &args.time.column {
                words.extend(["--time".to_owned(), quoted(time)]);
            } else if let Some(period_s) = args.time.sample_period {
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
