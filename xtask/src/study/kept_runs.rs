//! Each finished run is kept at once, so that a study that was stopped goes on where it was.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use indicatif::ProgressBar;
use serde::{Deserialize, Serialize};

use super::definition::{Runs, Study};
use crate::TaskError;
use crate::shared::parallel::in_parallel;

/// A line of the file. All but the edition and the seed is the study's own.
#[derive(Serialize, Deserialize)]
struct Line<Kind, Outcome> {
    edition: u32,
    case: Case<Kind>,
    #[serde(flatten)]
    outcome: Outcome,
}

#[derive(Serialize, Deserialize)]
struct Case<Kind> {
    #[serde(flatten)]
    kind: Kind,
    seed: u64,
}

/// The outcomes of each of these kinds, seeds from 1 on: those in `file`, and those of new runs,
/// which are added to it. Seeds vary slowest, so that a study that was stopped has seen every kind.
pub(super) fn collect<S: Study>(
    study: &S,
    kinds: Vec<S::Kind>,
    seeds: u64,
    file: &Path,
    threads: usize,
    bar: &ProgressBar,
) -> Result<Runs<S>, TaskError> {
    let fault = |source| TaskError::io(file, source);
    let mut outcomes = kept::<S>(file, &kinds)?;
    outcomes.retain(|(seed, _), _| (1..=seeds).contains(seed));
    let open: Vec<(u64, usize)> = (1..=seeds)
        .flat_map(|seed| (0..kinds.len()).map(move |kind| (seed, kind)))
        .filter(|run| !outcomes.contains_key(run))
        .collect();
    bar.set_length((outcomes.len() + open.len()) as u64);
    bar.set_position(outcomes.len() as u64);
    let sink = Mutex::new(appendable(file).map_err(fault)?);
    let added = in_parallel(&open, threads, |(seed, kind)| {
        let outcome = study.run(kinds[*kind], *seed)?;
        let case = Case { kind: kinds[*kind], seed: *seed };
        let line = serde_json::to_string(&Line { edition: S::EDITION, case, outcome: &outcome })
            .map_err(TaskError::computation("study"))?;
        let mut sink = sink.lock().unwrap_or_else(PoisonError::into_inner);
        sink.write_all(format!("{line}\n").as_bytes()).map_err(fault)?;
        bar.inc(1);
        Ok(outcome)
    })?;
    outcomes.extend(open.into_iter().zip(added));
    let mut runs: Runs<S> = kinds.into_iter().map(|kind| (kind, Vec::new())).collect();
    for ((_, kind), outcome) in outcomes {
        runs[kind].1.push(outcome);
    }
    Ok(runs)
}

/// What earlier runs left, by seed and place of the kind. Lines of another edition and half a line
/// at the end don't count.
fn kept<S: Study>(
    file: &Path,
    kinds: &[S::Kind],
) -> Result<BTreeMap<(u64, usize), S::Outcome>, TaskError> {
    let text = match std::fs::read(file) {
        Ok(bytes) => String::from_utf8_lossy(&bytes).into_owned(),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(TaskError::io(file, error)),
    };
    let outcome = |line: &str| {
        let line: Line<S::Kind, S::Outcome> = serde_json::from_str(line).ok()?;
        let kind = kinds.iter().position(|kind| *kind == line.case.kind)?;
        (line.edition == S::EDITION).then_some(((line.case.seed, kind), line.outcome))
    };
    Ok(text.lines().filter_map(outcome).collect())
}

/// The file, at its end, which is the end of a line.
fn appendable(path: &Path) -> std::io::Result<File> {
    let mut file = OpenOptions::new().create(true).append(true).open(path)?;
    if file.seek(SeekFrom::End(0))? > 0 {
        file.write_all(b"\n")?;
    }
    Ok(file)
}

#[cfg(test)]
mod tests;
