//! Work shared between threads whose results are taken in the order of the jobs.

use std::thread::{Builder, ScopedJoinHandle};

/// Jobs that a thread does before the results are taken.
const ROUND: usize = 128;

/// Fewer jobs than this are not worth a thread.
const SHARE: usize = 4;

/// Does all jobs and hands the results over in their order, so that sums do not depend on the number of threads. `work` gets a
/// part of the jobs, on one thread.
pub(crate) fn in_order<J: Sync, R: Send>(
    jobs: &[J],
    threads: usize,
    work: impl Fn(&[J]) -> Vec<R> + Sync,
    mut take: impl FnMut(&R),
) {
    let work = &work;
    for round in jobs.chunks(ROUND * threads) {
        let share = round.len().div_ceil(threads).max(SHARE).min(round.len());
        let (own, others) = round.split_at(share);
        std::thread::scope(|scope| {
            let helpers: Vec<_> = others
                .chunks(share)
                .map(|jobs| (jobs, Builder::new().spawn_scoped(scope, || work(jobs))))
                .collect();
            work(own).iter().for_each(&mut take);
            for (jobs, helper) in helpers {
                match helper.map(ScopedJoinHandle::join) {
                    Ok(Ok(results)) => results.iter().for_each(&mut take),
                    Ok(Err(panic)) => std::panic::resume_unwind(panic),
                    // A system that gives no more threads has this one.
                    Err(_) => work(jobs).iter().for_each(&mut take),
                }
            }
        });
    }
}

#[cfg(test)]
mod tests;
