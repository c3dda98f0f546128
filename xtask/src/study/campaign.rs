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
    /// A few runs only, and all of them anew: whether everything runs.
    #[arg(long, conflicts_with = "update")]
    quick: bool,

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

/// The same of a study that makes its records anew with every seed.
#[derive(Debug, clap::Args)]
pub(super) struct SeededExtent {
    /// Pairs of records of each kind; more seeds go on where fewer ended [default: those of the
    /// study's page under docs].
    #[arg(long, conflicts_with = "quick", value_parser = clap::value_parser!(u64).range(1..=100_000))]
    pub(super) seeds: Option<u64>,

    #[command(flatten)]
    pub(super) extent: Extent,
}

impl Extent {
    /// Runs of each kind, where so many seeds were asked for.
    fn seeds<S: Study>(&self, asked: Option<u64>) -> u64 {
        match S::SEEDS {
            Some(seeds) if self.quick => seeds.quick,
            Some(seeds) => asked.unwrap_or(seeds.page),
            None => 1,
        }
    }

    fn threads(&self) -> usize {
        self.threads.map_or_else(all_cores, usize::from)
    }

    /// Where finished runs are kept, within the folder.
    fn file<S: Study>(&self) -> String {
        format!("{}{}.jsonl", S::NAME, if self.quick { "-quick" } else { "" })
    }

    /// The command that makes the same document.
    fn command<S: Study>(&self, seeds: u64) -> String {
        let extent = match S::SEEDS {
            _ if self.quick => " --quick".to_owned(),
            Some(_) => format!(" --seeds {seeds}"),
            None => String::new(),
        };
        let update = if self.update { " --update" } else { "" };
        format!("cargo xtask study {}{extent}{update}", S::NAME)
    }
}

/// Runs what is not there yet and writes the page. `seeds` is what was asked for, if anything.
pub(super) fn carry_out<S: Study>(
    root: &Path,
    extent: &Extent,
    seeds: Option<u64>,
    out: &mut dyn Write,
) -> Result<(), TaskError> {
    let folder = extent.out.clone().unwrap_or_else(|| root.join("target/study"));
    std::fs::create_dir_all(&folder).map_err(|source| TaskError::io(&folder, source))?;
    let seeds = extent.seeds::<S>(seeds);
    let lines = extent.file::<S>();
    let file = folder.join(&lines);
    if extent.quick && file.exists() {
        std::fs::remove_file(&file).map_err(|source| TaskError::io(&file, source))?;
    }
    let study = S::new()?;
    let bar = progress(0, "{elapsed} left {eta}");
    let kinds = if extent.quick { study.quick_kinds() } else { study.kinds() };
    let runs = kept_runs::collect(&study, kinds, seeds, &file, extent.threads(), &bar)?;
    bar.finish_and_clear();
    let document = study.document(&runs, seeds, &extent.command::<S>(seeds))?;
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
