//! `transmode monitor`: do the sensors of new records still go together as those of a healthy one did?

mod json;
mod model_file;
mod outcome;
mod reference;
mod text;

use std::io::Write;

use monitor::Detector;
use reconstruct::Record;

use crate::args::MonitorArgs;
use crate::records::bridging::Bridge;
use crate::records::{self, LoadOptions, LoadWarning, Loaded, Progress};
use crate::{CommandError, Exit, output};
use outcome::{MonitorOutcome, Watched};

/// Calibrates with the reference, watches the new records and writes what was found.
pub(crate) fn run(
    args: &MonitorArgs,
    progress: Progress,
    out: &mut dyn Write,
) -> Result<Exit, CommandError> {
    if let Some(file) = &args.json {
        let mut files = args.files.paths();
        files.push(&args.reference);
        files.extend(args.model.iter().map(std::path::PathBuf::as_path));
        output::check_place(file, &files)?;
    }
    let models =
        args.model.iter().map(|file| model_file::read(file)).collect::<Result<Vec<_>, _>>()?;
    let mut options = args.files.options();
    options.bridge = args.bridge.map_or(Bridge::Usual, Bridge::UpTo);
    // Each window has unknowns of its own: there may be any number of them.
    options.most_missing = usize::MAX;
    if options.selection.outputs.is_empty() {
        options.selection.outputs = model_file::sensors(&models);
    }
    let of_reference = LoadOptions { windows: Vec::new(), ..options.clone() };
    let reference = std::slice::from_ref(&args.reference);
    let healthy = records::load(reference, &of_reference, progress)?;
    let mut warnings = healthy.warnings.clone();
    let reference = reference::calibrate(args, healthy, &models)?;

    let Loaded { records, sources, warnings: more, .. } =
        records::load(&args.files.files, &options, progress)?;
    warnings.extend(more);
    let (mut watched, mut short) = (Vec::new(), Vec::new());
    for (record, source) in records.iter().zip(&sources) {
        reference.check(record)?;
        match watch(&reference.detector, record, source.span_s[0])? {
            Some(found) => watched.push(found),
            None => short.push(record),
        }
    }
    let needed = reference.detector.margin() + reference.detector.options().window;
    if let (true, Some(first)) = (watched.is_empty(), short.first()) {
        let message = format!(
            "its {} samples are too few for one span, which takes {needed}; give a longer record or a shorter --span",
            first.samples()
        );
        return Err(CommandError::InFile { file: first.name().into(), message });
    }
    for record in short {
        let (record, samples) = (record.name().to_owned(), record.samples());
        LoadWarning::add_once(&mut warnings, LoadWarning::NoSpan { record, samples, needed });
    }
    let outcome = MonitorOutcome { reference, watched, warnings };

    output::write_result(
        args.json.as_deref(),
        || json::render(&outcome),
        || text::render(&outcome),
        out,
    )?;
    let is_alarm = |watched: &Watched| watched.diagnosis.is_some();
    Ok(if outcome.watched.iter().any(is_alarm) { Exit::Doubtful } else { Exit::Fine })
}

/// `None` where the record is too short for a span.
fn watch(
    detector: &Detector,
    record: &Record,
    start_s: f64,
) -> Result<Option<Watched>, CommandError> {
    let fault = |message: String| CommandError::InFile { file: record.name().into(), message };
    let channels = reference::marked(record);
    let stretches = [reference::stretch(&channels)];
    let windows = detector.watch(&stretches).map_err(|error| fault(error.to_string()))?;
    let not_judged = detector.windows_in(record.samples()) - windows.len();
    if windows.is_empty() && not_judged == 0 {
        return Ok(None);
    }
    let diagnosis =
        detector.diagnose(&windows, &stretches).map_err(|error| fault(error.to_string()))?;
    Ok(Some(Watched { name: record.name().to_owned(), start_s, windows, not_judged, diagnosis }))
}
