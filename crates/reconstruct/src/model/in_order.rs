//! Work shared between threads.

use std::thread::{Builder, ScopedJoinHandle};

/// The results of all jobs, in the order of the jobs whoever did them, so that sums of them do not depend on the number of threads.
pub(crate) fn in_order<J: Sync, R: Send>(
    jobs: &[J],
    threads: usize,
    work: impl Fn(&J) -> R + Sync,
) -> Vec<R> {
    let share = jobs.len().div_ceil(threads.max(1));
    let (own, others) = jobs.split_at(share);
    let all = |jobs: &[J]| jobs.iter().map(&work).collect::<Vec<R>>();
    if others.is_empty() {
        return all(own);
    }
    std::thread::scope(|scope| {
        let helpers: Vec<_> = others
            .chunks(share)
            .map(|jobs| (jobs, Builder::new().spawn_scoped(scope, || all(jobs))))
            .collect();
        let mut results = all(own);
        for (jobs, helper) in helpers {
            match helper.map(ScopedJoinHandle::join) {
                Ok(Ok(more)) => results.extend(more),
                Ok(Err(panic)) => std::panic::resume_unwind(panic),
                // A system that gives no more threads has this one.
                Err(_) => results.extend(all(jobs)),
            }
        }
        results
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_the_order_of_the_jobs() {
        let jobs: Vec<usize> = (0..23).collect();
        let expected: Vec<usize> = jobs.iter().map(|job| job * job).collect();
        for threads in [0, 1, 2, 3, 22, 23, 40] {
            assert_eq!(in_order(&jobs, threads, |job| job * job), expected, "{threads}");
        }
        assert!(in_order(&[], 4, |job: &usize| *job).is_empty());
    }
}
