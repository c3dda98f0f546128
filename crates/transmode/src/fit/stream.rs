//! The fit of an NPY or raw record of any length: one pass in blocks, in constant memory.

use std::io::{Read, Seek};
use std::path::Path;

use cfi_ident::{Accumulator, Fit, FitError, FitOptions, Structure};

use super::explained::{explained, explained_in_array};
use super::file_kind::FileKind;
use super::outcome::{FitOutcome, Passes, poles, short_name};
use crate::CommandError;
use crate::error::in_file;
use crate::records::binary::{self, Placement};
use crate::records::blocks::{Block, Blocks};
use crate::records::npy;
use crate::records::progress::{Bar, Progress};
use crate::records::raw;
use crate::records::runs::{Infinite, Side, runs};

pub(super) fn fit(
    file: &Path,
    kind: FileKind,
    [input, output]: [&str; 2],
    structure: &Structure,
    options: &FitOptions,
    progress: Progress,
) -> Result<FitOutcome, CommandError> {
    let (mut source, length) = binary::open(file)?;
    let placement = match kind {
        FileKind::Raw(channels) => raw::placement(&mut source, length, channels),
        _ => npy::placement(&mut source, length),
    };
    let placement = placement.map_err(|error| error.of_file(file))?;
    let channels = [
        channel(file, &placement, "--input", input)?,
        channel(file, &placement, "--output", output)?,
    ];
    if channels[0] == channels[1] {
        return Err(CommandError::SameColumn { column: input.to_owned() });
    }

    let progress = progress.samples(placement.samples());
    let fault = |error: &dyn std::error::Error| in_file(file, error);
    let mut sums = Sums::new(structure, options).map_err(|error| fault(&explained(error)))?;
    let mut blocks = Blocks::new(source, placement, channels);
    sums.read(&mut blocks, &progress).map_err(|error| match error {
        StreamError::Read(source) => CommandError::Read { file: file.to_owned(), source },
        StreamError::Infinite { sample, side, value } => {
            let column = match side {
                Side::Input => channels[0],
                Side::Output => channels[1],
            };
            let (file, column) = (file.to_owned(), column.to_string());
            CommandError::InfiniteSample { file, sample, column, value }
        }
        StreamError::Fit(error) => fault(&explained(error)),
    })?;
    drop(progress);
    let fit = sums.fit().map_err(|error| {
        fault(&explained_in_array(error, placement.samples(), placement.channels()))
    })?;
    Ok(FitOutcome {
        file: short_name(file),
        format: kind.name(),
        passes: Passes::One,
        input: channels[0].to_string(),
        output: channels[1].to_string(),
        sample_period_s: None,
        samples: placement.samples(),
        missing: sums.missing,
        segments: sums.segments,
        poles: poles(&fit),
        notes: Vec::new(),
        fit,
    })
}

/// The index of a channel that the file has.
fn channel(
    file: &Path,
    placement: &Placement,
    option: &'static str,
    text: &str,
) -> Result<u64, CommandError> {
    let channels = placement.channels();
    text.parse().ok().filter(|index| *index < channels).ok_or_else(|| CommandError::NoSuchChannel {
        file: file.to_owned(),
        option,
        text: text.to_owned(),
        channels,
    })
}

/// The sums of the fit, and what they are the sums of.
#[derive(Debug)]
struct Sums {
    accumulator: Accumulator,
    segments: usize,
    missing: u64,
    /// Whether the last sample was no gap.
    inside: bool,
}

/// Why a stream ended early.
#[derive(Debug)]
enum StreamError {
    Read(std::io::Error),
    Infinite { sample: u64, side: Side, value: f64 },
    Fit(FitError),
}

impl Sums {
    fn new(structure: &Structure, options: &FitOptions) -> Result<Self, FitError> {
        let accumulator = Accumulator::new(structure, options)?;
        Ok(Self { accumulator, segments: 0, missing: 0, inside: false })
    }

    fn read(
        &mut self,
        blocks: &mut Blocks<impl Read + Seek>,
        progress: &Bar,
    ) -> Result<(), StreamError> {
        while let Some(block) = blocks.next().map_err(StreamError::Read)? {
            self.push(&block)?;
            progress.advance(block.input.len() as u64);
        }
        Ok(())
    }

    fn push(&mut self, block: &Block<'_>) -> Result<(), StreamError> {
        // Most blocks have no gap, and the sums see that in passing; where they have one, nothing has been added.
        match self.accumulator.push(block.input, block.output) {
            Ok(()) => self.begin(),
            Err(FitError::NotFinite { .. }) => self.push_runs(block)?,
            Err(error) => return Err(StreamError::Fit(error)),
        }
        Ok(())
    }

    fn push_runs(&mut self, block: &Block<'_>) -> Result<(), StreamError> {
        let runs = runs(block.input, block.output).map_err(|Infinite { index, side, value }| {
            StreamError::Infinite { sample: block.first + index as u64, side, value }
        })?;
        // Where the next sample would be, had there been no gap.
        let mut expected = 0;
        for run in runs {
            self.gap((run.start - expected) as u64);
            self.begin();
            self.accumulator
                .push(&block.input[run.clone()], &block.output[run.clone()])
                .map_err(StreamError::Fit)?;
            expected = run.end;
        }
        self.gap((block.input.len() - expected) as u64);
        Ok(())
    }

    /// Samples have come; they may be the first after a gap.
    fn begin(&mut self) {
        self.segments += usize::from(!self.inside);
        self.inside = true;
    }

    fn gap(&mut self, missing: u64) {
        if missing > 0 {
            self.accumulator.gap();
            self.inside = false;
            self.missing += missing;
        }
    }

    fn fit(&self) -> Result<Fit, FitError> {
        self.accumulator.fit()
    }
}

#[cfg(test)]
mod tests;
