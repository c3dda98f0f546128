//! The fit of a record that is held in memory, whatever its format: the solution is refined on the data.

use std::path::Path;

use cfi_ident::{FitError, FitOptions, Segment, Structure};

use super::explained::explained;
use super::outcome::{FitOutcome, Passes, poles, short_name};
use crate::CommandError;
use crate::error::in_file;
use crate::records::Progress;
use crate::records::pair::{self, PairOptions};

pub(super) fn fit(
    file: &Path,
    [input, output]: [&str; 2],
    reading: &PairOptions,
    structure: &Structure,
    options: &FitOptions,
    progress: Progress,
) -> Result<FitOutcome, CommandError> {
    let pair = pair::load(file, [input, output], reading, progress)?;
    let segments = pair
        .stretches
        .iter()
        .map(|run| Segment::new(&pair.input[run.clone()], &pair.output[run.clone()]))
        .collect::<Result<Vec<_>, FitError>>();
    let fit = segments
        .and_then(|segments| cfi_ident::fit(&segments, structure, options))
        .map_err(|error| in_file(file, &explained(error)))?;
    let used: usize = pair.stretches.iter().map(ExactSizeIterator::len).sum();
    Ok(FitOutcome {
        file: short_name(file),
        format: pair.format.name(),
        passes: Passes::Several,
        input: input.to_owned(),
        output: output.to_owned(),
        sample_period_s: pair.period_s,
        samples: pair.input.len() as u64,
        missing: (pair.input.len() - used) as u64,
        segments: pair.stretches.len(),
        poles: poles(&fit),
        notes: pair.warnings,
        fit,
    })
}
