//! Runs of a study: on several threads, each finished one kept at once, so that a study that was stopped goes on where it was.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::TaskError;

/// What a run leaves behind: a line of JSON that says what it belongs to.
pub(super) trait Kept: Serialize + DeserializeOwned + Send {
    /// What was varied.
    type Case: Copy + Ord + Send + Sync;
    /// Changes whenever the records or the methods change, so that no study mixes old and new runs.
    const EDITION: u32;

    fn edition(&self) -> u32;
    fn case(&self) -> Self::Case;
}

/// The outcomes of all cases, in the order of the cases: those in `file`, and those of `run`, which are added to it.
pub(super) fn collect<O: Kept>(
    cases: &[O::Case],
    file: &Path,
    threads: usize,
    run: impl Fn(&O::Case) -> Result<O, TaskError> + Sync,
    finished: impl Fn(usize) + Sync,
) -> Result<Vec<O>, TaskError> {
    let fault = |source| TaskError::io(file, source);
    let mut outcomes = kept::<O>(file)?;
    outcomes.retain(|case, _| cases.contains(case));
    let open: Vec<O::Case> =
        cases.iter().copied().filter(|case| !outcomes.contains_key(case)).collect();
    finished(outcomes.len());
    let sink = Mutex::new((appendable(file).map_err(fault)?, outcomes, None));
    let (next, failed) = (AtomicUsize::new(0), AtomicBool::new(false));
    let work = || {
        while !failed.load(Ordering::Relaxed) {
            let Some(case) = open.get(next.fetch_add(1, Ordering::Relaxed)) else {
                return;
            };
            let result = run(case);
            let mut sink = sink.lock().unwrap_or_else(PoisonError::into_inner);
            let (file, outcomes, error) = &mut *sink;
            let kept = result.and_then(|outcome| {
                let line =
                    serde_json::to_string(&outcome).map_err(TaskError::computation("study"))?;
                file.write_all(format!("{line}\n").as_bytes()).map_err(fault)?;
                Ok(outcome)
            });
            match kept {
                Ok(outcome) => {
                    outcomes.insert(*case, outcome);
                    finished(outcomes.len());
                }
                Err(fault) => {
                    failed.store(true, Ordering::Relaxed);
                    error.get_or_insert(fault);
                }
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
    let (_, outcomes, error) = sink.into_inner().unwrap_or_else(PoisonError::into_inner);
    error.map_or_else(|| Ok(outcomes.into_values().collect()), Err)
}

/// The results of `run` for all items, in their order, computed on all cores.
pub(crate) fn in_parallel<T: Sync, R: Send>(items: &[T], run: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let next = AtomicUsize::new(0);
    let results = Mutex::new(BTreeMap::new());
    let work = || {
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(place) else {
                return;
            };
            let result = run(item);
            results.lock().unwrap_or_else(PoisonError::into_inner).insert(place, result);
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
    results.into_inner().unwrap_or_else(PoisonError::into_inner).into_values().collect()
}

/// What an earlier run left. Lines of another edition and half a line at the end don't count.
fn kept<O: Kept>(file: &Path) -> Result<BTreeMap<O::Case, O>, TaskError> {
    let text = match std::fs::read(file) {
        Ok(bytes) => String::from_utf8_lossy(&bytes).into_owned(),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(TaskError::io(file, error)),
    };
    let lines = text.lines().filter_map(|line| serde_json::from_str::<O>(line).ok());
    Ok(lines
        .filter(|outcome| outcome.edition() == O::EDITION)
        .map(|outcome| (outcome.case(), outcome))
        .collect())
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
