//! `transmode identify`: records -> modes, on the terminal and as JSON.

mod json;
mod text;

use std::io::Write;
use std::path::Path;

use cfi_ident::{ConstantTerm, Orders, Structure};
use reconstruct::{AsPrintedOptions, as_printed};

use crate::args::IdentifyArgs;
use crate::records::{self, Loaded, Progress};
use crate::{CommandError, Exit, modes, output};

/// Reads the records, reconstructs the modes and writes them.
pub(crate) fn run(
    args: &IdentifyArgs,
    progress: Progress,
    out: &mut dyn Write,
) -> Result<Exit, CommandError> {
    if let Some(file) = &args.json {
        output::check_place(file, &args.files.paths())?;
    }
    let Loaded { records, warnings, .. } =
        records::load(&args.files.files, &args.files.options(), progress)?;

    let fault = |message: String| CommandError::Reconstruct(message);
    let orders = Orders::new(args.iir, args.causal, args.anticausal)
        .map_err(|error| fault(error.to_string()))?;
    let mut options = AsPrintedOptions::default();
    options.identification.structure = Structure::new(orders, ConstantTerm::Omitted);
    let result = as_printed(&records, &options).map_err(|error| fault(error.to_string()))?;
    let found = modes::name(&result, &records[0])?;

    // The file first: if it cannot be written, nothing has been said yet.
    let standard_output = Path::new("-");
    if let Some(file) = &args.json {
        output::write_whole(file, &json::render(&records, &result, &found, &warnings)?, out)?;
    }
    if args.json.as_deref() != Some(standard_output) {
        output::write_whole(
            standard_output,
            text::render(&records, &result, &found, &warnings).as_bytes(),
            out,
        )?;
    }
    Ok(if result.doubts.is_empty() { Exit::Fine } else { Exit::Doubtful })
}
