//! `cargo xtask study noise`: what the methods are worth on records with white noise, beside the information bound.

mod case;
mod document;
mod figures;
pub(crate) mod flights;
pub(crate) mod methods;
mod outcome;
mod statistics;

use std::io::Write;
use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressStyle};

#[cfg(test)]
pub(crate) use case::cases;
pub(crate) use case::{Case, Excitation};
pub(crate) use figures::{Look, METHODS, MODES, RATIO_AXIS};
pub(crate) use outcome::{EDITION, Outcome};
pub(crate) use statistics::median;

use super::runs;
use crate::TaskError;
use crate::page::{Page, Pictures};
use flights::Simulator;

/// Errors, deviations and coverage of each method, for four excitations and four levels of noise.
#[derive(Debug, clap::Args)]
pub(super) struct NoiseArgs {
    /// A few seeds only, and all of them anew: whether everything runs.
    #[arg(long, conflicts_with_all = ["seeds", "update"])]
    quick: bool,

    /// Pairs of records for each excitation and level of noise. More seeds go on where fewer ended.
    #[arg(long, default_value_t = 200, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    seeds: u64,

    /// Threads; the result does not depend on them [default: all cores].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,

    /// Where to keep the runs and write study-noise.md and its figures. Finished runs in it are not repeated [default: target/study].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Also rewrite docs/study-noise.md and its figures.
    #[arg(long)]
    update: bool,
}

impl NoiseArgs {
    pub(super) fn seeds(&self) -> u64 {
        const QUICK: u64 = 3;
        if self.quick { QUICK } else { self.seeds }
    }

    pub(super) fn threads(&self) -> usize {
        self.threads.map_or_else(
            || std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
            usize::from,
        )
    }

    /// Where finished runs are kept, within the folder.
    pub(super) fn file(&self) -> &'static str {
        if self.quick { "noise-quick.jsonl" } else { "noise.jsonl" }
    }

    /// The command that makes the same document.
    pub(super) fn command(&self) -> String {
        let seeds =
            if self.quick { " --quick".to_owned() } else { format!(" --seeds {}", self.seeds) };
        let update = if self.update { " --update" } else { "" };
        format!("cargo xtask study noise{seeds}{update}")
    }
}

pub(super) fn run(root: &Path, args: &NoiseArgs, out: &mut dyn Write) -> Result<(), TaskError> {
    let folder = args.out.clone().unwrap_or_else(|| root.join("target/study"));
    std::fs::create_dir_all(&folder).map_err(|source| TaskError::io(&folder, source))?;
    let cases = case::cases(args.seeds());
    let bar = ProgressBar::new(cases.len() as u64).with_style(
        ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} left {eta}")
            .unwrap_or_else(|_| ProgressStyle::default_bar()),
    );
    let simulator = Simulator::new()?;
    let file = folder.join(args.file());
    if args.quick && file.exists() {
        std::fs::remove_file(&file).map_err(|source| TaskError::io(&file, source))?;
    }
    let outcomes = runs::collect(
        &cases,
        &file,
        args.threads(),
        |case| methods::run(&simulator, case),
        |done| bar.set_position(done as u64),
    )?;
    bar.finish_and_clear();
    let summaries = statistics::summaries(&outcomes);
    let document = document::compose(&summaries, args.seeds(), &args.command())?;
    let page = Page {
        file: "study-noise.md",
        command: "cargo xtask study noise --update",
        document: &document,
    };
    page.write(&folder, "", Pictures::Both)?;
    if args.update {
        page.write(&root.join("docs"), "figures", Pictures::Vector)?;
    }
    let text =
        format!("written to {}: {}, study-noise.md, figures\n", folder.display(), args.file());
    out.write_all(text.as_bytes()).map_err(|source| TaskError::io("standard output", source))
}
