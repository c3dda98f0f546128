//! `cargo xtask bench`: how fast and how accurate the fits are, beside what others do on the same
//! data in the same run.

mod accuracy;
mod exact;
mod growth;
mod limit;
mod machine;
mod noise;
mod ours;
mod paper;
mod peak;
mod peers;
mod recorded;
mod records;
mod speed;
mod stream;
mod times;
mod timing;

use std::io::Write;
use std::path::{Path, PathBuf};

use indicatif::ProgressBar;
use report::{Block, Document};

use crate::TaskError;
use crate::shared::page::{Page, Pictures};
use crate::shared::parallel::progress;
use peers::Peers;

/// Measure speed, accuracy, growth and memory of the fits.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Also time numpy, scipy and SLICOT, in a virtual environment made below target/bench-peers.
    #[arg(long)]
    peers: bool,

    /// Also stream a record of 1e8 samples, which takes 1.6 GB of disk for a few minutes.
    #[arg(long)]
    long: bool,

    /// Only this group: speed, accuracy, growth, limit, paper, noise or recorded.
    #[arg(long, value_name = "ID")]
    only: Option<String>,

    /// Where to write benchmarks.md and its figures [default: target/bench].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Also rewrite docs/benchmarks.md and its figures.
    #[arg(long, conflicts_with = "only")]
    update: bool,

    /// Read the record in this folder in blocks, fit it, and print time and memory as JSON: what
    /// the growth group runs as a process of its own.
    #[arg(long, value_name = "DIR", hide = true, exclusive = true)]
    stream: Option<PathBuf>,
}

/// What the groups share.
pub(crate) struct Bench {
    /// For records, gone at the end.
    folder: tempfile::TempDir,
    peers: Peers,
    long: bool,
    bar: ProgressBar,
}

impl Bench {
    /// Says on the terminal what is measured now.
    fn say(&self, what: impl Into<String>) {
        self.bar.set_message(what.into());
        self.bar.tick();
    }
}

/// A chapter of the document.
pub(crate) struct Group {
    title: &'static str,
    introduction: String,
    blocks: Vec<Block>,
}

type Measure = fn(&Bench) -> Result<Group, TaskError>;

/// The groups in their order, and what `--only` calls them.
const GROUPS: [(&str, Measure); 7] = [
    ("speed", speed::measure),
    ("accuracy", accuracy::measure),
    ("growth", growth::measure),
    ("limit", limit::measure),
    ("paper", paper::measure),
    ("noise", noise::measure),
    ("recorded", recorded::measure),
];

pub(crate) fn run(root: &Path, args: &Args, out: &mut dyn Write) -> Result<(), TaskError> {
    if let Some(folder) = &args.stream {
        return stream::child(folder, out);
    }
    let chosen = chosen_groups(args.only.as_deref())?;
    let target = root.join("target");
    std::fs::create_dir_all(&target).map_err(|source| TaskError::io(&target, source))?;
    let bar = progress(chosen.len(), "{elapsed} {msg}");
    let bench = prepare(&target, args, bar)?;
    let mut document = introduction(args, &bench);
    for (id, measure) in chosen {
        bench.say(id);
        let group = measure(&bench)?;
        document.push(Block::section(group.title));
        document.push(Block::paragraph(group.introduction));
        group.blocks.into_iter().for_each(|block| document.push(block));
        bench.bar.inc(1);
    }
    bench.bar.finish_and_clear();
    let folder = args.out.clone().unwrap_or_else(|| target.join("bench"));
    let page =
        Page { file: "benchmarks.md", command: "cargo xtask bench --update", document: &document };
    page.write(&folder, "", Pictures::Both)?;
    if args.update {
        page.write(&root.join("docs"), "figures", Pictures::Vector)?;
    }
    let text = format!("written to {}: benchmarks.md, figures\n", folder.display());
    out.write_all(text.as_bytes()).map_err(|source| TaskError::io("standard output", source))
}

fn prepare(target: &Path, args: &Args, bar: ProgressBar) -> Result<Bench, TaskError> {
    let folder = tempfile::Builder::new()
        .prefix("bench-")
        .tempdir_in(target)
        .map_err(|source| TaskError::io(target, source))?;
    let peers = if args.peers {
        bar.set_message("virtual environment for the peers");
        bar.tick();
        Peers::prepare(target, folder.path())?
    } else {
        Peers::not_asked()
    };
    Ok(Bench { folder, peers, long: args.long, bar })
}

fn chosen_groups(only: Option<&str>) -> Result<Vec<(&'static str, Measure)>, TaskError> {
    let Some(given) = only else {
        return Ok(GROUPS.to_vec());
    };
    let found = GROUPS.iter().find(|(id, _)| *id == given).copied();
    found.map(|group| vec![group]).ok_or_else(|| TaskError::NoSuchPart {
        given: given.to_owned(),
        known: GROUPS.iter().map(|(id, _)| *id).collect(),
    })
}

fn introduction(args: &Args, bench: &Bench) -> Document {
    let mut facts: Vec<String> =
        machine::facts().into_iter().map(|(name, value)| format!("{name}: {value}")).collect();
    facts.push(format!("command: `{}`", command(args)));
    let versions: Vec<String> =
        bench.peers.versions().iter().map(|(name, version)| format!("{name} {version}")).collect();
    if !versions.is_empty() {
        facts.push(format!("peers: {}", versions.join(", ")));
    }
    Document::new("Benchmarks")
        .with(Block::paragraph(
            "Times are medians of several runs after one that is not counted, all in one run of the command; the spread is the range between \
             the quartiles. Peers run on one thread, on the same data, and only their solver is timed: for them the regressors are \
             built before the clock starts, while our times begin with the record.",
        ))
        .with(Block::bullets(facts))
}

/// The command as one would type it.
fn command(args: &Args) -> String {
    let mut words = vec!["cargo xtask bench".to_owned()];
    words.extend(args.peers.then(|| "--peers".to_owned()));
    words.extend(args.long.then(|| "--long".to_owned()));
    words.extend(args.only.as_ref().map(|id| format!("--only {id}")));
    words.extend(args.update.then(|| "--update".to_owned()));
    words.join(" ")
}

#[cfg(test)]
mod tests;
