use std::sync::atomic::{AtomicU64, Ordering};

use report::Document;

use super::*;
use crate::study::definition::Seeds;

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Kind {
    number: u32,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Outcome {
    values: [f64; 3],
}

/// Sixteen kinds. Counts its runs, and fails at one seed.
#[derive(Default)]
struct Counting {
    count: AtomicU64,
    fails_at: u64,
}

impl Study for Counting {
    const NAME: &'static str = "counting";
    const EDITION: u32 = 1;
    const SEEDS: Option<Seeds> = Some(Seeds { page: 3, quick: 1 });
    type Kind = Kind;
    type Outcome = Outcome;

    fn new() -> Result<Self, TaskError> {
        Ok(Self::default())
    }

    fn kinds(&self) -> Vec<Kind> {
        (0..16).map(|number| Kind { number }).collect()
    }

    fn run(&self, kind: Kind, seed: u64) -> Result<Outcome, TaskError> {
        if seed == self.fails_at {
            return Err(TaskError::computation("study")(format!("seed {seed}")));
        }
        self.count.fetch_add(1, Ordering::Relaxed);
        Ok(Outcome { values: [f64::from(kind.number) / 3.0, 1e-300, seed as f64] })
    }

    fn document(&self, _: &Runs<Self>, _: u64, _: &str) -> Result<Document, TaskError> {
        Ok(Document::new("counting"))
    }
}

/// The runs, and how many of them are new.
fn collected(seeds: u64, file: &Path, threads: usize) -> (Runs<Counting>, u64) {
    let study = Counting::default();
    let runs =
        collect(&study, study.kinds(), seeds, file, threads, &ProgressBar::hidden()).unwrap();
    (runs, study.count.into_inner())
}

#[test]
fn what_is_there_is_not_run_again() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("runs.jsonl");
    let (first, new) = collected(2, &file, 3);
    assert_eq!(new, 32);
    for (number, (kind, outcomes)) in first.iter().enumerate() {
        assert_eq!(kind.number as usize, number);
        assert_eq!(outcomes.iter().map(|run| run.values[2]).collect::<Vec<_>>(), [1.0, 2.0]);
    }

    // The last line was cut off, another one is of an older edition.
    let text = std::fs::read_to_string(&file).unwrap();
    let whole: Vec<&str> = text.lines().collect();
    assert!(whole[0].starts_with(r#"{"edition":1,"case":{"number":"#), "{}", whole[0]);
    let old = whole[3].replace("\"edition\":1", "\"edition\":0");
    let mut left = [&whole[..3], &[old.as_str()], &whole[4..31]].concat().join("\n");
    left.push('\n');
    left.push_str(&whole[31][..20]);
    std::fs::write(&file, left).unwrap();
    let (again, new) = collected(3, &file, 1);
    assert_eq!(new, 16 + 2);
    assert!(again.iter().all(|(_, outcomes)| outcomes.len() == 3));
    // Those that were stopped first, then a third seed of every kind.
    let text = std::fs::read_to_string(&file).unwrap();
    assert_eq!(text.lines().rev().take(16).filter(|line| line.contains("\"seed\":3")).count(), 16);
    // Fewer seeds are a part of what is there.
    assert_eq!(collected(2, &file, 2), (first, 0));
}

#[test]
fn the_first_fault_ends_the_study() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("runs.jsonl");
    let study = Counting { fails_at: 2, ..Counting::default() };
    let error = collect(&study, study.kinds(), 3, &file, 1, &ProgressBar::hidden()).unwrap_err();
    assert_eq!(error.to_string(), "study: seed 2");
    assert_eq!(kept::<Counting>(&file, &study.kinds()).unwrap().len(), 16);
}
