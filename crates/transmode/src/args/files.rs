//! The part of a command line that says which files are records and what of them is used.

use std::num::NonZero;
use std::path::PathBuf;

use clap::ValueHint;

use crate::records::options::{Angles, ReadOptions, factor, period};
use crate::records::selection::TimeSource;
use crate::records::{LoadOptions, Selection, Window};

/// Files and what of them becomes records.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct FileArgs {
    /// The records: text (.csv, .tsv, .txt, .lvm, also .gz and .zst), MATLAB (.mat), HDF5, NumPy (.npy, .npz).
    #[arg(num_args = 1.., value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    /// The sensors to use, in that order [default: all columns but time].
    #[arg(long, value_delimiter = ',', value_name = "COLUMN,..")]
    pub(crate) outputs: Vec<String>,

    #[command(flatten)]
    pub(crate) time: TimeArgs,

    #[command(flatten)]
    pub(crate) reading: ReadArgs,

    /// Interpolate to a sample every so many seconds: for samples that are really uneven, and channels of different rates.
    #[arg(long, value_name = "SECONDS", value_parser = period, allow_negative_numbers = true)]
    pub(crate) resample: Option<f64>,

    /// Angles that jump by a turn go on beyond it [default: true].
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true", value_name = "true|false")]
    pub(crate) unwrap: Option<bool>,

    /// Use only this stretch of a file, in seconds of its own time; several windows of one file are several records.
    #[arg(long, value_name = "FILE:START:END", value_parser = Window::parse, value_hint = ValueHint::FilePath)]
    pub(crate) window: Vec<Window>,

    /// Keep every K-th sample, behind a low-pass filter that takes about 13 of them at either end; 1 keeps all [default: 1; for identify without --inputs more where the records are sampled far faster than anything in them moves].
    #[arg(long, value_name = "K", value_parser = factor, allow_negative_numbers = true)]
    pub(crate) decimate: Option<NonZero<usize>>,
}

impl FileArgs {
    /// What the words ask for.
    pub(crate) fn options(&self) -> LoadOptions {
        let selection = selection(&self.outputs, &self.time);
        let decimate = self.decimate.unwrap_or(NonZero::<usize>::MIN);
        LoadOptions {
            selection,
            windows: self.window.clone(),
            decimate,
            reading: self.reading.options(),
            resample_s: self.resample,
            angles: if self.unwrap == Some(false) { Angles::AsRead } else { Angles::Unwrapped },
            ..LoadOptions::default()
        }
    }

    /// All files that are read.
    pub(crate) fn paths(&self) -> Vec<&std::path::Path> {
        let windows = self.window.iter().map(|window| window.file.as_path());
        self.files.iter().map(PathBuf::as_path).chain(windows).collect()
    }
}

/// Where the times of the samples come from.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct TimeArgs {
    /// The column of time [default: the one called time, t or timestamp].
    #[arg(id = "time", long = "time", value_name = "COLUMN")]
    pub(crate) column: Option<String>,

    /// The time between two samples, for files without a column of time, or in its place.
    #[arg(long, value_name = "SECONDS", conflicts_with = "time", value_parser = period, allow_negative_numbers = true)]
    pub(crate) sample_period: Option<f64>,
}

/// How files are written, where they do not say it.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct ReadArgs {
    /// The names of all columns of a text, in place of its header or where it has none.
    #[arg(long, value_delimiter = ',', value_name = "NAME,..")]
    pub(crate) columns: Vec<String>,

    /// Lines of a text to pass over above everything else.
    #[arg(long, value_name = "N", value_parser = lines, allow_negative_numbers = true)]
    pub(crate) skip_lines: Option<u64>,

    /// In a file of arrays, read only this variable and what is in it: log.imu, say [default: all].
    #[arg(long, value_name = "NAME")]
    pub(crate) variable: Option<String>,
}

impl ReadArgs {
    /// What the words ask for.
    pub(crate) fn options(&self) -> ReadOptions {
        ReadOptions {
            columns: self.columns.iter().map(|name| name.trim().to_owned()).collect(),
            skip_lines: self.skip_lines.unwrap_or(0),
            variable: self.variable.as_ref().map(|name| name.trim().to_owned()),
        }
    }
}

fn lines(text: &str) -> Result<u64, String> {
    text.trim().parse().map_err(|_| "a number of lines is a whole number, at least 0".to_owned())
}

impl TimeArgs {
    /// What the words ask for.
    pub(super) fn source(&self) -> TimeSource {
        match (&self.column, self.sample_period) {
            (Some(column), _) => TimeSource::Column(column.trim().to_owned()),
            (None, Some(period_s)) => TimeSource::Period(period_s),
            (None, None) => TimeSource::Usual,
        }
    }
}

/// The columns that the words ask for. Names are trimmed, as those in a file are.
pub(super) fn selection(outputs: &[String], time: &TimeArgs) -> Selection {
    let outputs = outputs.iter().map(|name| name.trim().to_owned()).collect();
    Selection { outputs, time: time.source(), lenient: false }
}
