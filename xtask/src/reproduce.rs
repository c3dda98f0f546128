//! `cargo xtask reproduce`: the paper's examples, figures and eigenvalues, beside what the paper
//! prints.

mod aircraft_model;
mod beyond;
mod check;
mod composite_models;
mod errata;
mod example_4_1;
mod example_4_2;
mod iir_models;
mod picture;
mod reconstruction;
mod results;

use std::io::Write;
use std::path::{Path, PathBuf};

use reconstruct::{Record, paper};
use report::{Block, Column, Document, Table, html, markdown, svg};

use crate::TaskError;
use crate::shared::page::{Page, Pictures, write_figures, write_whole};
use crate::shared::paper_aircraft::PaperAircraft;
use crate::shared::parallel::progress;
use check::{Check, Verdict};

/// Reproduce the paper: its examples, its four figures, its reconstructed eigenvalues.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Only this part: example-4-1, example-4-2, aircraft, figures-1-2, figure-3, figure-4 or
    /// beyond.
    #[arg(long, value_name = "ID")]
    only: Option<String>,

    /// Where to write figures, results.json, report.html and report.md [default: target/reproduce].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Fail where a verdict is `differs` or docs/reproduction.md is stale; write nothing.
    #[arg(long, conflicts_with_all = ["out", "update"])]
    check: bool,

    /// Also rewrite docs/reproduction.md and its figures.
    #[arg(long, conflicts_with = "only")]
    update: bool,
}

/// What one part of the paper amounts to: text and figures for the report, checks for results.json.
pub(crate) struct Part {
    title: &'static str,
    introduction: &'static str,
    checks: Vec<Check>,
    blocks: Vec<Block>,
}

/// The example of part VI, which several parts of the reproduction look at: the paper's aircraft,
/// its records, and what the paper's method makes of them.
pub(crate) struct AircraftExample {
    aircraft: PaperAircraft,
    /// Aileron record, rudder record.
    records: [Record; 2],
    result: paper::Solution,
}

impl AircraftExample {
    fn compute() -> Result<Self, TaskError> {
        let aircraft = PaperAircraft::new()?;
        let records = aircraft.paper_records()?;
        let result = paper::identify(&records, &paper::Options::default())
            .map_err(TaskError::computation("reconstruction"))?;
        Ok(Self { aircraft, records, result })
    }
}

type Build = fn(&AircraftExample) -> Result<Part, TaskError>;

/// The parts in the paper's order and what goes beyond it, and what `--only` calls them.
const PARTS: [(&str, Build); 7] = [
    ("example-4-1", example_4_1::build),
    ("example-4-2", example_4_2::build),
    ("aircraft", aircraft_model::build),
    ("figures-1-2", composite_models::build),
    ("figure-3", iir_models::build),
    ("figure-4", reconstruction::build),
    ("beyond", beyond::build),
];

pub(crate) fn run(root: &Path, args: &Args, out: &mut dyn Write) -> Result<(), TaskError> {
    let chosen = chosen_parts(args.only.as_deref())?;
    let bar = progress(chosen.len() + 2, "{msg}");
    bar.set_message("records");
    let example = AircraftExample::compute()?;
    bar.inc(1);
    let mut parts = Vec::new();
    for (id, build) in chosen {
        bar.set_message(id);
        parts.push(build(&example)?);
        bar.inc(1);
    }
    let document = compose(&parts)?;
    let checks: Vec<&Check> = parts.iter().flat_map(|part| &part.checks).collect();

    if args.check {
        bar.finish_and_clear();
        if args.only.is_none() {
            check_committed(root, &document)?;
            errata::check(root, &checks)?;
        }
    } else {
        bar.set_message("figures and reports");
        let folder = args.out.clone().unwrap_or_else(|| root.join("target/reproduce"));
        write_results(&folder, &document, &results::json(&checks, &example)?)?;
        if args.update {
            committed(&document).write(&root.join("docs"), "figures", Pictures::Vector)?;
        }
        bar.finish_and_clear();
        say(out, &summary(&checks))?;
        say(
            out,
            &format!(
                "written to {}: report.html, report.md, results.json, figures\n",
                folder.display()
            ),
        )?;
    }
    let differing: Vec<_> = checks
        .iter()
        .filter(|check| check.verdict == Verdict::Differs)
        .map(|check| check.id)
        .collect();
    if !differing.is_empty() {
        return Err(TaskError::Differs { ids: differing });
    }
    if args.check {
        say(out, &format!("{} checks, none differs\n", checks.len()))?;
    }
    Ok(())
}

fn chosen_parts(only: Option<&str>) -> Result<Vec<(&'static str, Build)>, TaskError> {
    let Some(given) = only else {
        return Ok(PARTS.to_vec());
    };
    // The first two figures are one part; either name means it.
    let wanted = if matches!(given, "figure-1" | "figure-2") { "figures-1-2" } else { given };
    let found = PARTS.iter().find(|(id, _)| *id == wanted).copied();
    found.map(|part| vec![part]).ok_or_else(|| TaskError::NoSuchPart {
        given: given.to_owned(),
        known: PARTS.iter().map(|(id, _)| *id).collect(),
    })
}

fn compose(parts: &[Part]) -> Result<Document, TaskError> {
    let mut document = Document::new("Reproduction of the paper").with(Block::paragraph(
        "Every number and figure of **Reconstruction of Aircraft Lateral Dynamics Using Two Transmissibility Operators**, computed anew by \
         `cargo xtask reproduce` and held against the print. A **match** agrees with all printed digits and with an independent \
         reference value; an **erratum** agrees with the reference value, and the print is listed in errata.md.",
    ));
    let checks: Vec<_> = parts.iter().flat_map(|part| &part.checks).collect();
    document.push(Block::note(counts(&checks)));
    for part in parts {
        document.push(Block::section(part.title));
        document.push(Block::paragraph(part.introduction));
        document.push(check_table(&part.checks)?);
        part.blocks.iter().for_each(|block| document.push(block.clone()));
    }
    Ok(document)
}

/// The checks for a reader: what is printed, what comes out. Errors are told as the bound that they
/// keep, so that the text does not depend on a machine's rounding.
fn check_table(checks: &[Check]) -> Result<Table, TaskError> {
    let header = ["check", "paper", "computed", "error below", "verdict", "note"].map(Column::left);
    let mut table = Table::new("The paper beside this computation", header);
    for check in checks {
        let bound = if check.tolerance > 0.0 {
            format!("{:.0e}", check.tolerance)
        } else {
            "exact".to_owned()
        };
        let Check { shown, note, .. } = check;
        table
            .push([check.id, &shown.paper, &shown.computed, &bound, check.verdict.word(), note])
            .map_err(TaskError::computation("report"))?;
    }
    Ok(table)
}

fn summary(checks: &[&Check]) -> String {
    let mut text = String::new();
    for check in checks {
        text += &format!("{:8} {:28} {}\n", check.verdict.word(), check.id, check.shown.computed);
    }
    text + &counts(checks) + "\n"
}

fn counts(checks: &[&Check]) -> String {
    let count = |verdict| checks.iter().filter(|check| check.verdict == verdict).count();
    format!(
        "{} checks: {} match, {} are errata of the print, {} differ.",
        checks.len(),
        count(Verdict::Match),
        count(Verdict::Erratum),
        count(Verdict::Differs)
    )
}

fn write_results(folder: &Path, document: &Document, results: &str) -> Result<(), TaskError> {
    write_figures(document, folder, Pictures::Both)?;
    let page = html::render(document).map_err(TaskError::computation("report"))?;
    write_whole(&folder.join("report.html"), page.as_bytes())?;
    write_whole(&folder.join("report.md"), markdown::render(document, "").as_bytes())?;
    write_whole(&folder.join("results.json"), results.as_bytes())
}

/// The page under docs.
fn committed(document: &Document) -> Page<'_> {
    Page { file: "reproduction.md", command: "cargo xtask reproduce --update", document }
}

fn check_committed(root: &Path, document: &Document) -> Result<(), TaskError> {
    let page = committed(document);
    let file = root.join("docs").join(page.file);
    let text = std::fs::read_to_string(&file).map_err(|source| TaskError::io(&file, source))?;
    if text.replace("\r\n", "\n") != page.text("figures") {
        return Err(TaskError::Stale { file });
    }
    for figure in document.figures() {
        let file = root.join(format!("docs/figures/{}.svg", figure.id));
        let committed =
            std::fs::read_to_string(&file).map_err(|source| TaskError::io(&file, source))?;
        let drawn = svg::render(figure).map_err(TaskError::computation("figures"))?;
        if !picture::same(&committed, &drawn) {
            return Err(TaskError::Stale { file });
        }
    }
    Ok(())
}

fn say(out: &mut dyn Write, text: &str) -> Result<(), TaskError> {
    out.write_all(text.as_bytes()).map_err(|source| TaskError::io("standard output", source))
}
