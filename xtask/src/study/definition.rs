//! What a study is: kinds of records, one run, and what all runs say.

use report::Document;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::TaskError;

/// What a study provides. All else, from the command line through the runs to the page, is the same
/// for every study.
///
/// A new study is this trait, a variant of [`Which`](super::Which), a line of [`run`](super::run),
/// and the page under docs that its `--update` writes.
pub(super) trait Study: Sized + Sync {
    /// The word after `cargo xtask study`.
    const NAME: &'static str;
    /// Changes whenever the records or the methods change, so that no page mixes old and new runs.
    const EDITION: u32;
    /// How often each kind of record is made anew; `None` where the records are given, so that each
    /// kind has one run.
    const SEEDS: Option<Seeds>;
    /// A kind of record: all that is varied but the seed. In JSON an object, without a field
    /// `seed`.
    type Kind: Copy + PartialEq + Send + Sync + Serialize + DeserializeOwned;
    /// What one run leaves behind. In JSON an object, without a field `edition` or `case`.
    type Outcome: Send + Serialize + DeserializeOwned;

    /// What all runs need.
    fn new() -> Result<Self, TaskError>;

    /// All kinds, in the order of the document.
    fn kinds(&self) -> Vec<Self::Kind>;

    /// Those of `--quick`: all, where a few seeds of each don't take long.
    fn quick_kinds(&self) -> Vec<Self::Kind> {
        self.kinds()
    }

    /// One run, which depends on nothing but its kind and its seed.
    fn run(&self, kind: Self::Kind, seed: u64) -> Result<Self::Outcome, TaskError>;

    /// What all runs say. `command` is what was typed. [`sections`](super::sections) has what
    /// documents have in common.
    fn document(&self, runs: &Runs<Self>, seeds: u64, command: &str)
    -> Result<Document, TaskError>;
}

/// How many seeds each kind of record has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seeds {
    /// In the page under docs.
    pub(super) page: u64,
    /// With `--quick`.
    pub(super) quick: u64,
}

/// All kinds of a study with the outcomes of their runs.
pub(super) type Runs<S> = Vec<(<S as Study>::Kind, Vec<<S as Study>::Outcome>)>;
