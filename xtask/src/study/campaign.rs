//! One study from the command line to its page: which kinds, on how many threads, kept and written
//! where.

use std::io::Write;
use std::path::{Path, PathBuf};

use super::definition::Study;
use super::kept_runs;
use crate::TaskError;
use crate::shared::page::{Page, Pictures};
use crate::shared::parallel::{all_cores, progress};

/// How much of a study to do, and where it goes.
#[derive(Debug, clap::Args)]
pub(super) struct Extent {
    /// A few seeds only, and all of them anew: whether everything runs.
    #[arg(long, conflicts_with_all = ["seeds", "update"])]
    quick: bool,

    /// Pairs of records of each kind; more seeds go on where fewer ended [default: those of the
    /// study's page under docs].
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    seeds: Option<u64>,

    /// Threads; the result does not depend on them [default: all cores].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,

    /// Where to keep the runs and write the page and its figures. Finished runs in it are not
    /// repeated [default: target/study].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Also rewrite the page under docs and its figures.
    #[arg(long)]
    update: bool,
}

impl Extent {
    fn seeds<S: Study>(&self) -> u64 {
        if self.quick { S::QUICK_SEEDS } else { self.seeds.unwrap_or(S::SEEDS) }
    }

    fn threads(&self) -> usize {
        self.threads.map_or_else(all_cores, usize::from)
    }

    /// Where finished runs are kept, within the folder.
    fn file<S: Study>(&self) -> String {
        format!("{}{}.jsonl", S::NAME, if self.quick { "-quick" } else { "" })
    }

    /// The command that makes the same document.
    fn command<S: Study>(&self) -> String {
        let seeds = if self.quick {
            " --quick".to_owned()
        } else {
            format!(" --seeds {}", self.seeds::<S>())
        };
        let update = if self.update { " --update" } else { "" };
        format!("cargo xtask study {}{seeds}{update}", S::NAME)
    }
}

/// Runs what is not there yet and writes the page.
pub(super) fn carry_out<S: Study>(
    root: &Path,
    extent: &Extent,
    out: &mut dyn Write,
) -> Result<(), TaskError> {
    let folder = extent.out.clone().unwrap_or_else(|| root.join("target/study"));
    std::fs::create_dir_all(&folder).map_err(|source| TaskError::io(&folder, source))?;
    let seeds = extent.seeds::<S>();
    let lines = extent.file::<S>();
    let file = folder.join(&lines);
    if extent.quick && file.exists() {
        std::fs::remove_file(&file).map_err(|source| TaskError::io(&file, source))?;
    }
    let study = S::new()?;
    let bar = progress(0, "{elapsed} left {eta}");
    let runs = kept_runs::collect(&study, seeds, &file, extent.threads(), &bar)?;
    bar.finish_and_clear();
    let document = study.document(&runs, seeds, &extent.command::<S>())?;
    let (name, command) =
        (format!("study-{}.md", S::NAME), format!("cargo xtask study {} --update", S::NAME));
    let page = Page { file: &name, command: &command, document: &document };
    page.write(&folder, "", Pictures::Both)?;
    if extent.update {
        page.write(&root.join("docs"), "figures", Pictures::Vector)?;
    }
    let text = format!("written to {}: {lines}, {name}, figures\n", folder.display());
    out.write_all(text.as_bytes()).map_err(|source| TaskError::io("standard output", source))
}

#[cfg(test)]
mod tests;
