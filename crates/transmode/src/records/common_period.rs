//! One sample period for all records of a run.
//!
//! Stamps that are rounded give periods that differ in the sixth digit, and the clocks of two loggers
//! differ by up to a part in a thousand. The methods take one period; that of a record that differs
//! by so little moves its eigenvalues by as little.

use lti::SamplePeriod;
use reconstruct::Record;

use super::loading::Loaded;
use super::sampling::{is_near_period, is_same_period};
use super::warning::LoadWarning;
use crate::CommandError;
use crate::error::in_file;
use crate::numbers::without_rounding;

/// Gives all records one period, where they differ by no more than two clocks do.
pub(super) fn share(loaded: &mut Loaded) -> Result<(), CommandError> {
    let read = |record: &Record| record.period().seconds();
    let Some(first) = loaded.records.first().map(read) else { return Ok(()) };
    if loaded.records.iter().all(|record| is_same_period(read(record), first)) {
        return Ok(());
    }
    let fitted: Vec<f64> = loaded
        .records
        .iter()
        .zip(&loaded.sources)
        .map(|(record, source)| {
            source.clock.fitted_period_s.map_or_else(|| read(record), without_rounding)
        })
        .collect();
    let shortest = fitted.iter().copied().fold(f64::INFINITY, f64::min);
    let longest = fitted.iter().copied().fold(0.0, f64::max);
    if !is_near_period(shortest, longest) {
        return Ok(());
    }
    let (mut sum, mut weight) = (0.0, 0.0);
    for (record, period) in loaded.records.iter().zip(&fitted) {
        sum += period * record.samples() as f64;
        weight += record.samples() as f64;
    }
    let agree = fitted.iter().all(|period| is_same_period(*period, fitted[0]));
    let common_s = if agree { fitted[0] } else { without_rounding(sum / weight) };
    if agree {
        for (record, source) in loaded.records.iter().zip(&loaded.sources) {
            let warning = LoadWarning::Clock {
                record: record.name().to_owned(),
                period_s: common_s,
                clock: source.clock,
            };
            LoadWarning::add_once(&mut loaded.warnings, warning);
        }
    } else {
        let name = |period: f64| {
            let index = fitted.iter().position(|other| other.to_bits() == period.to_bits());
            index.map_or_else(String::new, |index| loaded.records[index].name().to_owned())
        };
        loaded.warnings.push(LoadWarning::ClocksDiffer {
            records: [name(shortest), name(longest)],
            periods_s: [shortest, longest],
            common_s,
        });
    }
    for (record, source) in loaded.records.iter_mut().zip(&loaded.sources) {
        *record = with_period(record, common_s).map_err(|error| in_file(&source.file, &*error))?;
    }
    Ok(())
}

/// The same samples at another period.
pub(crate) fn with_period(
    record: &Record,
    period_s: f64,
) -> Result<Record, Box<dyn std::error::Error>> {
    let period = SamplePeriod::new(period_s)?;
    Ok(Record::with_missing(record.name(), period, record.marked())?)
}
