//! What of the files becomes records.

use std::num::NonZero;
use std::path::PathBuf;

use super::bridging::{Bridge, MOST_MISSING};
use super::selection::Selection;

/// How files become records.
#[derive(Clone, Debug)]
pub(crate) struct LoadOptions {
    pub(crate) selection: Selection,
    /// Windows that replace the whole file, each a record of its own.
    pub(crate) windows: Vec<Window>,
    /// Every how many samples one is kept, behind a low-pass filter; 1 keeps all and filters nothing.
    pub(crate) decimate: NonZero<usize>,
    /// Columns that hold measured inputs, beside the sensors.
    pub(crate) known_inputs: Vec<String>,
    /// Whether a measured input may be missing from all files: then it did not move.
    pub(crate) inputs_may_be_missing: bool,
    /// How the files are written, where they do not say it.
    pub(crate) reading: ReadOptions,
    /// The period to which samples are interpolated, in seconds.
    pub(crate) resample_s: Option<f64>,
    pub(crate) angles: Angles,
    /// Which gaps are missing samples of one record.
    pub(crate) bridge: Bridge,
    /// No gap is bridged in a record where more rows than this are missing.
    pub(crate) most_missing: usize,
}

/// How a file is written, where it does not say it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct ReadOptions {
    /// The names of the columns of a text, in place of its header; as the file has it if empty.
    pub(crate) columns: Vec<String>,
    /// Lines of a text above everything that is read.
    pub(crate) skip_lines: u64,
    /// The variable of a file of arrays whose channels are read, `log.imu` say; all if absent.
    pub(crate) variable: Option<String>,
}

/// What becomes of angles that jump by a turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Angles {
    /// They go on beyond it.
    #[default]
    Unwrapped,
    AsRead,
}

impl Default for LoadOptions {
    /// All sensors, the usual column of time, whole files, all samples.
    fn default() -> Self {
        Self {
            selection: Selection::default(),
            windows: Vec::new(),
            decimate: NonZero::<usize>::MIN,
            known_inputs: Vec::new(),
            inputs_may_be_missing: false,
            reading: ReadOptions::default(),
            resample_s: None,
            angles: Angles::default(),
            bridge: Bridge::default(),
            most_missing: MOST_MISSING,
        }
    }
}

/// A stretch of a file, both ends included.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Window {
    pub(crate) file: PathBuf,
    /// In seconds of the file's own time; from its beginning if absent.
    pub(crate) start_s: Option<f64>,
    /// To its end if absent.
    pub(crate) end_s: Option<f64>,
}

impl Window {
    /// Reads `FILE:START:END`. The file's name may hold colons, and either end may be left out.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let mut parts = text.rsplitn(3, ':');
        let (Some(end), Some(start), Some(file)) = (parts.next(), parts.next(), parts.next())
        else {
            return Err(
                "a window is written FILE:START:END, in seconds of the file's own time".to_owned()
            );
        };
        if file.is_empty() {
            return Err("the file is missing in front of :START:END".to_owned());
        }
        let second = |text: &str| match text.trim() {
            "" => Ok(None),
            text => match text.parse::<f64>() {
                Ok(value) if value.is_finite() => Ok(Some(value)),
                _ => Err(format!("{text:?} is no time in seconds")),
            },
        };
        let (start_s, end_s) = (second(start)?, second(end)?);
        if let (Some(start), Some(end)) = (start_s, end_s)
            && end <= start
        {
            return Err(format!(
                "the window ends at {end} s, which is not after its start at {start} s; exchange them"
            ));
        }
        Ok(Self { file: file.into(), start_s, end_s })
    }

    /// As it was asked for, behind the file's name.
    pub(crate) fn suffix(&self) -> String {
        let shown =
            |second: Option<f64>| second.map_or_else(String::new, |second| second.to_string());
        format!(":{}:{}", shown(self.start_s), shown(self.end_s))
    }
}

/// A sample period given on the command line, in seconds.
pub(crate) fn period(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(period_s) if (1e-12..=1e12).contains(&period_s) => Ok(period_s),
        _ => Err("a sample period is a number of seconds from 1e-12 to 1e12".to_owned()),
    }
}

/// The longest gap that is bridged, given on the command line, in seconds.
pub(crate) fn bridge(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(bridge_s) if (0.0..=1e12).contains(&bridge_s) => Ok(bridge_s),
        _ => Err("the longest gap that is bridged is a number of seconds, 0 for none".to_owned()),
    }
}

/// A factor of decimation given on the command line.
pub(crate) fn factor(text: &str) -> Result<NonZero<usize>, String> {
    text.trim()
        .parse()
        .map_err(|_| "a factor is a whole number, at least 1; 1 keeps all samples".to_owned())
}

#[cfg(test)]
mod tests;
