//! The fit of a CSV record, which is held in memory: the solution is refined on the data.

use std::path::Path;

use cfi_ident::{FitError, FitOptions, Segment, Structure};

use super::explained::explained;
use super::format::Format;
use super::found::{Found, poles, short_name};
use crate::CommandError;
use crate::records::runs::{Side, runs};
use crate::records::{in_file, pair};

pub(super) fn fit(
    file: &Path,
    [input, output]: [&str; 2],
    time: Option<&str>,
    structure: &Structure,
    options: &FitOptions,
) -> Result<Found, CommandError> {
    let pair = pair::load(file, input, output, time)?;
    let runs = runs(&pair.input, &pair.output).map_err(|found| CommandError::InfiniteSample {
        file: file.to_owned(),
        sample: found.index as u64,
        column: match found.side {
            Side::Input => format!("{input:?}"),
            Side::Output => format!("{output:?}"),
        },
        value: found.value,
    })?;
    let segments = runs
        .iter()
        .map(|run| Segment::new(&pair.input[run.clone()], &pair.output[run.clone()]))
        .collect::<Result<Vec<_>, FitError>>();
    let fit = segments
        .and_then(|segments| cfi_ident::fit(&segments, structure, options))
        .map_err(|error| in_file(file, &explained(error)))?;
    let used: usize = runs.iter().map(ExactSizeIterator::len).sum();
    Ok(Found {
        file: short_name(file),
        format: Format::Csv,
        input: input.to_owned(),
        output: output.to_owned(),
        sample_period_s: Some(pair.period.seconds()),
        samples: pair.input.len() as u64,
        missing: (pair.input.len() - used) as u64,
        segments: runs.len(),
        poles: poles(&fit),
        fit,
    })
}
