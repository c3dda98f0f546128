//! Work shared between threads.

/// The results of all jobs, in the order of the jobs whoever did them, so that sums of them do not depend on the number of threads.
pub(super) fn in_order<J: Sync, R: Send>(
    jobs: &[J],
    threads: usize,
    work: impl Fn(&J) -> R + Sync,
) -> Vec<R> {
    let share = jobs.len().div_ceil(threads.max(1));
    let (own, others) = jobs.split_at(share);
    let work = &work;
    std::thread::scope(|scope| {
        let helpers: Vec<_> = others
            .chunks(share.max(1))
            .map(|jobs| scope.spawn(|| jobs.iter().map(work).collect::<Vec<R>>()))
            .collect();
        let mut results: Vec<R> = own.iter().map(work).collect();
        for helper in helpers {
            match helper.join() {
                Ok(more) => results.extend(more),
                Err(panic) => std::panic::resume_unwind(panic),
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
