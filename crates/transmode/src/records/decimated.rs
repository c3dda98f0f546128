//! Records of every K-th sample, behind a low-pass filter.

use std::num::NonZero;

use lti::SamplePeriod;
use reconstruct::{Channel, Record};

use super::decimation::{self, Decimator};
use super::loading::Loaded;
use super::oversampling::{Oversampled, oversampled};
use super::segments::SHORTEST;
use super::source::Source;
use super::warning::LoadWarning;
use crate::CommandError;
use crate::error::{SelectionError, in_file};
use crate::numbers::without_rounding;

impl Loaded {
    /// Decimates where all records are sampled far faster than anything in them moves, says so, and returns the factor.
    pub(crate) fn decimate_if_oversampled(&mut self) -> Result<NonZero<usize>, CommandError> {
        let Some(Oversampled { factor, highest_hz }) = oversampled(&self.records, &self.sources)
        else {
            return Ok(NonZero::<usize>::MIN);
        };
        let period_s = self.records.first().map_or(0.0, |record| record.period().seconds());
        self.leave_out_short(factor);
        self.decimate(factor)?;
        let warning =
            LoadWarning::Oversampled { factor: factor.get(), rate_hz: 1.0 / period_s, highest_hz };
        self.warnings.push(warning);
        Ok(factor)
    }

    /// Leaves out stretches of which hardly anything would be left.
    fn leave_out_short(&mut self, factor: NonZero<usize>) {
        let needed = decimation::length(factor) + SHORTEST * factor.get();
        let is_long = |record: &Record| record.samples() >= needed;
        let kept: Vec<bool> = self.records.iter().map(is_long).collect();
        for whole in 0..self.sources.last().map_or(0, |last| last.whole + 1) {
            let short: Vec<&Record> = (0..kept.len())
                .filter(|&index| !kept[index] && self.sources[index].whole == whole)
                .map(|index| &self.records[index])
                .collect();
            let Some(first) = short.first() else { continue };
            let record = first.name().rsplit_once('#').map_or(first.name(), |(whole, _)| whole);
            self.warnings.push(LoadWarning::ShortStretches {
                record: record.to_owned(),
                count: short.len(),
                samples: short.iter().map(|record| record.samples()).sum(),
                needed,
            });
        }
        retain(&mut self.records, &kept);
        retain(&mut self.sources, &kept);
        retain(&mut self.known_inputs, &kept);
    }

    /// Keeps every so many samples of all records and of their inputs. What is missing was interpolated, and is filtered with the rest.
    pub(crate) fn decimate(&mut self, factor: NonZero<usize>) -> Result<(), CommandError> {
        if factor.get() == 1 {
            return Ok(());
        }
        let decimator = Decimator::new_checked(factor, &self.records, &self.sources)?;
        for warning in &mut self.warnings {
            if let LoadWarning::Bridged { interpolated, .. } = warning {
                *interpolated = true;
            }
        }
        for (record, source) in self.records.iter_mut().zip(&mut self.sources) {
            let period_s = record.period().seconds();
            let period = SamplePeriod::new(without_rounding(period_s * factor.get() as f64))
                .map_err(|error| in_file(&source.file, &error))?;
            let thin = |channel: &Channel| {
                Channel::new(channel.name.clone(), decimator.decimate(&channel.values))
            };
            let channels = record.channels().iter().map(thin).collect();
            *record = Record::new(record.name(), period, channels)
                .map_err(|error| in_file(&source.file, &error))?;
            let first_s = source.span_s[0] + decimator.margin() as f64 * period_s;
            let last_s = first_s + (record.samples() - 1) as f64 * period.seconds();
            source.span_s = [first_s, last_s].map(without_rounding);
        }
        for signal in self.known_inputs.iter_mut().flatten() {
            *signal = decimator.decimate(signal);
        }
        Ok(())
    }
}

impl Decimator {
    /// Refuses a record that is shorter than the filter.
    fn new_checked(
        factor: NonZero<usize>,
        records: &[Record],
        sources: &[Source],
    ) -> Result<Self, CommandError> {
        let needed = decimation::length(factor);
        for (record, source) in records.iter().zip(sources) {
            if record.samples() < needed {
                let (file, found) = (source.file.clone(), record.samples());
                let factor = factor.get();
                return Err(SelectionError::Decimation { file, factor, needed, found }.into());
            }
        }
        Ok(Self::new(factor))
    }
}

fn retain<T>(items: &mut Vec<T>, kept: &[bool]) {
    let mut kept = kept.iter();
    items.retain(|_| kept.next().copied().unwrap_or(true));
}
