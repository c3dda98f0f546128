//! Why a task failed.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(Debug, thiserror::Error)]
pub(crate) enum TaskError {
    #[error("{}: {source}", place.display())]
    Io { place: PathBuf, source: std::io::Error },
    #[error("{}: not written: {source}", file.display())]
    Write { file: PathBuf, source: std::io::Error },
    #[error("the tree is not tidy:\n  {}", faults.join("\n  "))]
    Untidy { faults: Vec<String> },
    #[error("there is no part called {given:?}; the parts are {}", known.join(", "))]
    NoSuchPart { given: String, known: Vec<&'static str> },
    #[error("{part}: {message}")]
    Computation { part: &'static str, message: String },
    #[error("these checks do not come out as they must: {}", ids.join(", "))]
    Differs { ids: Vec<&'static str> },
    #[error("{} is stale; run `cargo xtask reproduce --update` and commit it", file.display())]
    Stale { file: PathBuf },
    #[error("docs/errata.md and the checks disagree: {}", faults.join("; "))]
    Errata { faults: Vec<String> },
}

impl TaskError {
    pub(crate) fn io(place: impl AsRef<Path>, source: std::io::Error) -> Self {
        Self::Io { place: place.as_ref().to_owned(), source }
    }

    /// For `map_err`: any error of a computation, with the part of the reproduction it belongs to.
    pub(crate) fn computation<E: std::fmt::Display>(
        part: &'static str,
    ) -> impl Fn(E) -> Self + Copy {
        move |error| Self::Computation { part, message: error.to_string() }
    }

    /// 2 where the command line is at fault, 1 where the project is.
    pub(crate) fn exit_code(&self) -> ExitCode {
        ExitCode::from(if matches!(self, Self::NoSuchPart { .. }) { 2 } else { 1 })
    }
}
