//! What words of a command line mean, where they are more than a number or a name.

use std::num::NonZero;
use std::path::PathBuf;
use std::str::FromStr;

use crate::records::Window;

/// A method of reconstruction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum MethodName {
    /// Maximum likelihood: as accurate as the records allow, with deviations.
    #[default]
    Ml,
    /// Intersection of signal subspaces: closed form, no deviations.
    Subspace,
    /// The method of the paper, as printed there, for records without noise.
    #[value(alias = "paper")]
    AsPrinted,
}

impl MethodName {
    /// The word on the command line and in the JSON.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Ml => "ml",
            Self::Subspace => "subspace",
            Self::AsPrinted => "as-printed",
        }
    }
}

/// How many states there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OrderAsked {
    /// The records show it.
    Auto,
    /// So many.
    States(usize),
}

impl FromStr for OrderAsked {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "auto" => Ok(Self::Auto),
            number => order(number)
                .map(Self::States)
                .map_err(|_| "an order is a whole number, at least 1, or auto".to_owned()),
        }
    }
}

/// What sensors read in trim.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum OffsetsAsked {
    /// Zero, unless the records disagree.
    Auto,
    Zero,
    Free,
    /// Zero on average, with these standard deviations.
    Deviations(Vec<f64>),
}

impl FromStr for OffsetsAsked {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "auto" => Ok(Self::Auto),
            "zero" => Ok(Self::Zero),
            "free" => Ok(Self::Free),
            list => list
                .split(',')
                .map(positive)
                .collect::<Option<_>>()
                .map(Self::Deviations)
                .ok_or_else(|| {
                    "offsets are auto, zero, free, or positive standard deviations separated by commas"
                        .to_owned()
                }),
        }
    }
}

/// How the excitation moves between samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum HoldAsked {
    /// What is more likely.
    Auto,
    /// It stays what it was.
    ZeroOrder,
    /// It moves on straight from sample to sample.
    FirstOrder,
}

/// Whether something that was not recorded excited the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum ExcitationAsked {
    /// Only if the recorded inputs leave too much unexplained.
    Auto,
    /// In each record, something did.
    Yes,
    /// The recorded inputs are all there was.
    No,
}

/// The form of the equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum StructureAsked {
    /// What is more likely.
    Auto,
    /// A system of so many states, of which nothing else is known.
    BlackBox,
    /// The lateral equations of an aircraft: states beta, p, r and phi.
    Lateral,
}

/// By how much a column is late.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LagAsked {
    pub(crate) column: String,
    /// In s; `None` where it is to be estimated.
    pub(crate) seconds: Option<f64>,
}

impl FromStr for LagAsked {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const FORM: &str = "a lag is written COLUMN=SECONDS, or COLUMN=free to estimate it";
        let (column, lag) = text.rsplit_once('=').ok_or(FORM)?;
        let (column, lag) = (column.trim().to_owned(), lag.trim());
        if column.is_empty() {
            return Err(FORM.to_owned());
        }
        let seconds = match lag {
            "free" => None,
            number => {
                let seconds: f64 = number.parse().map_err(|_| FORM)?;
                if !(-10.0..=10.0).contains(&seconds) {
                    return Err("a lag is a number of seconds from -10 to 10".to_owned());
                }
                Some(seconds)
            }
        };
        Ok(Self { column, seconds })
    }
}

/// A band of frequencies in rad/s, either end open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Band {
    pub(crate) lowest: Option<f64>,
    pub(crate) highest: Option<f64>,
}

impl FromStr for Band {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const FORM: &str = "a band is written LO:HI, two frequencies in rad/s, none negative";
        let (low, high) = text.split_once(':').ok_or(FORM)?;
        let end = |text: &str| match text.trim() {
            "" => Ok(None),
            text => match text.parse::<f64>() {
                Ok(value) if value.is_finite() && value >= 0.0 => Ok(Some(value)),
                _ => Err(FORM),
            },
        };
        let (lowest, highest) = (end(low)?, end(high)?);
        if let (Some(low), Some(high)) = (lowest, highest)
            && high <= low
        {
            return Err(format!(
                "the band is empty: it ends at {high} rad/s, which is not above its start at {low} rad/s; exchange them"
            ));
        }
        Ok(Self { lowest, highest })
    }
}

/// A file, or a stretch of one, in which nobody excited the system.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum QuietFile {
    Whole(PathBuf),
    Stretch(Window),
}

impl QuietFile {
    pub(crate) fn path(&self) -> &PathBuf {
        match self {
            Self::Whole(file) => file,
            Self::Stretch(window) => &window.file,
        }
    }
}

impl FromStr for QuietFile {
    type Err = String;

    /// A file that is there is meant as a whole, whatever colons its name holds.
    fn from_str(text: &str) -> Result<Self, String> {
        let whole = PathBuf::from(text);
        if !whole.exists()
            && let Ok(window) = Window::parse(text)
        {
            return Ok(Self::Stretch(window));
        }
        Ok(Self::Whole(whole))
    }
}

/// A standard deviation of noise.
pub(crate) fn level(text: &str) -> Result<f64, String> {
    positive(text).ok_or_else(|| "a noise level is a positive number".to_owned())
}

/// A positive number.
pub(crate) fn positive(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite() && *value > 0.0)
}

/// A number of threads.
pub(crate) fn threads(text: &str) -> Result<usize, String> {
    let found = text.trim().parse().ok().filter(|threads| (1..=256).contains(threads));
    found.ok_or_else(|| "a number of threads is a whole number from 1 to 256".to_owned())
}

/// The number of threads asked for, or one for each processor.
pub(crate) fn threads_or_all(asked: Option<usize>) -> usize {
    let all = || std::thread::available_parallelism().map_or(1, NonZero::get);
    asked.unwrap_or_else(all)
}

/// An order of a model.
pub(crate) fn order(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(0) => Err("an order must be at least 1".to_owned()),
        Ok(order) => Ok(order),
        Err(_) => Err("an order is a whole number, at least 1".to_owned()),
    }
}

#[cfg(test)]
mod tests;
