//! `transmode identify`: records -> modes, on the terminal and as JSON.

mod json;
mod text;

use std::io::Write;
use std::path::Path;

use cfi_ident::{ConstantTerm, Orders, Structure};
use reconstruct::{Method, Options, reconstruct};

use crate::args::IdentifyArgs;
use crate::records::{self, Loaded, Progress};
use crate::{CommandError, Exit, modes, output, report};

/// Reads the records, reconstructs the modes and writes them.
pub(crate) fn run(
    args: &IdentifyArgs,
    typed: &str,
    out: &mut dyn Write,
) -> Result<Exit, CommandError> {
    if let Some(file) = &args.json {
        output::check_place(file, &args.files.paths())?;
    }
    if let Some(folder) = &args.report {
        report::check_place(folder)?;
    }
    let Loaded { records, sources, warnings } =
        records::load(&args.files.files, &args.files.options(), Progress::Shown)?;

    let fault = |message: String| CommandError::Reconstruct(message);
    let orders = Orders::new(args.iir, args.causal, args.anticausal)
        .map_err(|error| fault(error.to_string()))?;
    let mut options = Options::default();
    options.method = Method::AsPrinted;
    options.printed.identification.structure = Structure::new(orders, ConstantTerm::Omitted);
    let result = reconstruct(&records, &options).map_err(|error| fault(error.to_string()))?;
    let found = modes::name(&result, &records[0])?;
    let printed = result.printed.as_ref().ok_or_else(|| fault("nothing was found".to_owned()))?;

    if let Some(folder) = &args.report {
        let input = report::Input {
            command: typed,
            records: &records,
            sources: &sources,
            warnings: &warnings,
            options: &options,
            result: &result,
            found: &found,
            flying: None,
            progress: Progress::Shown,
        };
        report::write(folder, &input)?;
    }
    // The file first: if it cannot be written, nothing has been said yet.
    let standard_output = Path::new("-");
    if let Some(file) = &args.json {
        output::write_whole(file, &json::render(&records, printed, &found, &warnings)?, out)?;
    }
    if args.json.as_deref() != Some(standard_output) {
        output::write_whole(
            standard_output,
            text::render(&records, printed, &found, &warnings).as_bytes(),
            out,
        )?;
    }
    Ok(if result.doubts.is_empty() { Exit::Fine } else { Exit::Doubtful })
}
