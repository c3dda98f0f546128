use std::sync::atomic::{AtomicUsize, Ordering};

use serde::Deserialize;

use super::*;

/// Number and seed, 16 of each seed.
type Case = (u32, u64);

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Outcome {
    edition: u32,
    case: Case,
    values: [f64; 3],
}

impl Kept for Outcome {
    type Case = Case;
    const EDITION: u32 = 1;

    fn edition(&self) -> u32 {
        self.edition
    }

    fn case(&self) -> Case {
        self.case
    }
}

fn cases(seeds: u64) -> Vec<Case> {
    (1..=seeds).flat_map(|seed| (0..16).map(move |number| (number, seed))).collect()
}

fn outcome(case: &Case) -> Outcome {
    Outcome { edition: 1, case: *case, values: [1.0 / 3.0, 1e-300, case.1 as f64] }
}

#[test]
fn what_is_there_is_not_run_again() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("runs.jsonl");
    let count = AtomicUsize::new(0);
    let run = |case: &Case| {
        count.fetch_add(1, Ordering::Relaxed);
        Ok(outcome(case))
    };
    let first = collect(&cases(2), &file, 3, run, |_| ()).unwrap();
    assert_eq!(count.load(Ordering::Relaxed), 32);
    assert!(first.iter().map(|outcome| outcome.case).is_sorted());

    // The last line was cut off, another one is of an older edition.
    let text = std::fs::read_to_string(&file).unwrap();
    let whole: Vec<&str> = text.lines().collect();
    let old = whole[3].replace("\"edition\":1", "\"edition\":0");
    let mut left = [&whole[..3], &[old.as_str()], &whole[4..31]].concat().join("\n");
    left.push('\n');
    left.push_str(&whole[31][..20]);
    std::fs::write(&file, left).unwrap();
    count.store(0, Ordering::Relaxed);
    let again = collect(&cases(3), &file, 1, run, |_| ()).unwrap();
    assert_eq!(count.load(Ordering::Relaxed), 16 + 2);
    assert_eq!(again.len(), 48);
    // Fewer seeds are a part of what is there.
    count.store(0, Ordering::Relaxed);
    let part = collect(&cases(2), &file, 2, run, |_| ()).unwrap();
    assert_eq!(count.load(Ordering::Relaxed), 0);
    assert_eq!(part, first);
}

#[test]
fn the_first_fault_ends_the_study() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("runs.jsonl");
    let run = |case: &Case| {
        if case.1 == 2 {
            return Err(TaskError::computation("study")("seed 2"));
        }
        Ok(outcome(case))
    };
    let error = collect(&cases(3), &file, 1, run, |_| ()).unwrap_err();
    assert_eq!(error.to_string(), "study: seed 2");
    assert_eq!(kept::<Outcome>(&file).unwrap().len(), 16);
}

#[test]
fn results_keep_their_order() {
    let items: Vec<usize> = (0..100).collect();
    let doubled = in_parallel(&items, |item| 2 * item);
    assert_eq!(doubled, (0..100).map(|item| 2 * item).collect::<Vec<_>>());
    assert!(in_parallel(&[0; 0], |item| *item).is_empty());
}
