//! `transmode fit`: one record -> the transmissibility between two of its sensors.

mod explained;
mod file_kind;
mod json;
mod memory;
mod outcome;
mod stream;
mod text;
mod warning;

use std::io::Write;

use cfi_ident::{ConstantTerm, FitOptions, Orders, Structure};

use crate::args::FitArgs;
use crate::args::values::threads_or_all;
use crate::error::in_file;
use crate::records::Progress;
use crate::records::format_error::FormatError;
use crate::{CommandError, Exit, output};
use file_kind::FileKind;
use warning::warnings;

/// Reads the record, fits the model and writes what was found.
pub(crate) fn run(
    args: &FitArgs,
    progress: Progress,
    out: &mut dyn Write,
) -> Result<Exit, CommandError> {
    let orders = Orders::new(args.iir, args.causal, args.anticausal)
        .map_err(|error| CommandError::Reconstruct(error.to_string()))?;
    let constant_term =
        if args.constant_term { ConstantTerm::Included } else { ConstantTerm::Omitted };
    let structure = Structure::new(orders, constant_term);
    let options = FitOptions { threads: threads_or_all(args.threads), ..FitOptions::default() };
    // The names in a file are trimmed as well.
    let (input, output) = (args.input.trim(), args.output.trim());
    if input == output {
        return Err(CommandError::SameColumn { column: input.to_owned() });
    }
    if let Some(file) = &args.json {
        output::check_place(file, &[&args.file])?;
    }

    let kind =
        FileKind::of(&args.file, args.channels).map_err(|error| in_file(&args.file, &error))?;
    let outcome = match kind {
        FileKind::Table => {
            let reading = args.pair_options();
            memory::fit(&args.file, [input, output], &reading, &structure, &options, progress)?
        }
        _ if args.names_time() => return Err(in_file(&args.file, &FormatError::NeedlessTime)),
        _ => stream::fit(&args.file, kind, [input, output], &structure, &options, progress)?,
    };
    let warnings = warnings(&outcome);

    output::write_result(
        args.json.as_deref(),
        || json::render(&outcome, &warnings),
        || text::render(&outcome, &warnings),
        out,
    )?;
    Ok(if warnings.iter().any(|warning| warning.is_doubt()) { Exit::Doubtful } else { Exit::Fine })
}
