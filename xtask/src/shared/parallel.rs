//! Work on several threads, and how far it has come.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use indicatif::{ProgressBar, ProgressStyle};

use crate::TaskError;

/// The number of cores, or 1 where the system does not tell.
pub(crate) fn all_cores() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

/// A bar of this many steps, with these fields of [`indicatif`] behind the counts.
pub(crate) fn progress(steps: usize, fields: &str) -> ProgressBar {
    ProgressBar::new(steps as u64).with_style(
        ProgressStyle::with_template(&format!("{{bar:30}} {{pos}}/{{len}} {fields}"))
            .unwrap_or_else(|_| ProgressStyle::default_bar()),
    )
}

/// The results of `run` for all items, in their order whatever the number of threads. After the
/// first fault no further item begins.
pub(crate) fn in_parallel<T: Sync, R: Send>(
    items: &[T],
    threads: usize,
    run: impl Fn(&T) -> Result<R, TaskError> + Sync,
) -> Result<Vec<R>, TaskError> {
    let (next, failed) = (AtomicUsize::new(0), AtomicBool::new(false));
    let results = Mutex::new(BTreeMap::new());
    let work = || {
        while !failed.load(Ordering::Relaxed) {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(place) else {
                return;
            };
            let result = run(item);
            failed.fetch_or(result.is_err(), Ordering::Relaxed);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_keep_their_order() {
        let items: Vec<usize> = (0..100).collect();
        let doubled = in_parallel(&items, 3, |item| Ok(2 * item)).unwrap();
        assert_eq!(doubled, (0..100).map(|item| 2 * item).collect::<Vec<_>>());
        assert!(in_parallel(&[0; 0], 3, |item| Ok(*item)).unwrap().is_empty());
    }

    #[test]
    fn a_fault_ends_the_work() {
        let begun = AtomicUsize::new(0);
        let error = in_parallel(&[1, 2, 3, 4], 1, |item| {
            begun.fetch_add(1, Ordering::Relaxed);
            if *item == 2 { Err(TaskError::computation("x")("two")) } else { Ok(()) }
        });
        assert_eq!(error.unwrap_err().to_string(), "x: two");
        assert_eq!(begun.load(Ordering::Relaxed), 2);
    }
}
