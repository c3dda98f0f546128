//! One study from the command line to its page: which cases, on how many threads, kept and written where.

use std::io::Write;
use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressStyle};
use report::Document;

use super::runs::{self, Kept};
use crate::TaskError;
use crate::shared::page::{Page, Pictures};

/// What a study does.
pub(super) trait Campaign: Sync {
    /// What one run leaves behind.
    type Outcome: Kept;
    /// The word after `cargo xtask study`.
    const NAME: &'static str;
    /// Seeds of each kind of record in the page under docs.
    const SEEDS: u64;
    /// Seeds with `--quick`.
    const QUICK_SEEDS: u64;

    /// All cases with seeds from 1 on. Seeds vary slowest, so that a study that was stopped has seen every kind of record.
    fn cases(&self, seeds: u64) -> Vec<<Self::Outcome as Kept>::Case>;

    /// One run.
    fn run(&self, case: &<Self::Outcome as Kept>::Case) -> Result<Self::Outcome, TaskError>;

    /// What all runs say, in the order of the cases. `command` is what was typed.
    fn document(
        &self,
        outcomes: &[Self::Outcome],
        seeds: u64,
        command: &str,
    ) -> Result<Document, TaskError>;
}

/// How much of a study to do, and where it goes.
#[derive(Debug, clap::Args)]
pub(super) struct Extent {
    /// A few seeds only, and all of them anew: whether everything runs.
    #[arg(long, conflicts_with_all = ["seeds", "update"])]
    quick: bool,

    /// Pairs of records of each kind; more seeds go on where fewer ended [default: 200 in the study of noise, 100 in that of disturbances].
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    seeds: Option<u64>,

    /// Threads; the result does not depend on them [default: all cores].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,

    /// Where to keep the runs and write the page and its figures. Finished runs in it are not repeated [default: target/study].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Also rewrite the page under docs and its figures.
    #[arg(long)]
    update: bool,
}

impl Extent {
    fn seeds<C: Campaign>(&self) -> u64 {
        if self.quick { C::QUICK_SEEDS } else { self.seeds.unwrap_or(C::SEEDS) }
    }

    fn threads(&self) -> usize {
        self.threads.map_or_else(
            || std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
            usize::from,
        )
    }

    /// Where finished runs are kept, within the folder.
    fn file<C: Campaign>(&self) -> String {
        format!("{}{}.jsonl", C::NAME, if self.quick { "-quick" } else { "" })
    }

    /// The command that makes the same document.
    fn command<C: Campaign>(&self) -> String {
        let seeds = if self.quick {
            " --quick".to_owned()
        } else {
            format!(" --seeds {}", self.seeds::<C>())
        };
        let update = if self.update { " --update" } else { "" };
        format!("cargo xtask study {}{seeds}{update}", C::NAME)
    }
}

/// Runs what is not there yet and writes the page.
pub(super) fn carry_out<C: Campaign>(
    campaign: &C,
    root: &Path,
    extent: &Extent,
    out: &mut dyn Write,
) -> Result<(), TaskError> {
    let folder = extent.out.clone().unwrap_or_else(|| root.join("target/study"));
    std::fs::create_dir_all(&folder).map_err(|source| TaskError::io(&folder, source))?;
    let seeds = extent.seeds::<C>();
    let cases = campaign.cases(seeds);
    let bar = ProgressBar::new(cases.len() as u64).with_style(
        ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} left {eta}")
            .unwrap_or_else(|_| ProgressStyle::default_bar()),
    );
    let runs = extent.file::<C>();
    let file = folder.join(&runs);
    if extent.quick && file.exists() {
        std::fs::remove_file(&file).map_err(|source| TaskError::io(&file, source))?;
    }
    let outcomes = runs::collect(
        &cases,
        &file,
        extent.threads(),
        |case| campaign.run(case),
        |done| bar.set_position(done as u64),
    )?;
    bar.finish_and_clear();
    let document = campaign.document(&outcomes, seeds, &extent.command::<C>())?;
    let (name, command) =
        (format!("study-{}.md", C::NAME), format!("cargo xtask study {} --update", C::NAME));
    let page = Page { file: &name, command: &command, document: &document };
    page.write(&folder, "", Pictures::Both)?;
    if extent.update {
        page.write(&root.join("docs"), "figures", Pictures::Vector)?;
    }
    let text = format!("written to {}: {runs}, {name}, figures\n", folder.display());
    out.write_all(text.as_bytes()).map_err(|source| TaskError::io("standard output", source))
}

#[cfg(test)]
mod tests;
