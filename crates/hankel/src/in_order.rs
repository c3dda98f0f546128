//! Work shared between threads whose results are taken in the order of the jobs.

use std::thread::{Builder, ScopedJoinHandle};

/// Jobs that a thread does before the results are taken, so that no more than these are kept.
const ROUND: usize = 128;

/// How jobs are shared between threads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sharing {
    /// Threads that work, the calling one among them; zero counts as one.
    pub threads: usize,
    /// The fewest jobs that are worth a thread; fewer threads work where there are not as many for each. Zero counts as one.
    pub least: usize,
}

/// Does all jobs, and hands the results over in the order of the jobs, whoever did them: sums of results do not depend on the
/// number of threads.
///
/// `work` gets some jobs that follow each other, and gives one result for each, in their order; so buffers can serve several
/// jobs. `take` is called by the calling thread, while the others may still work. Threads live no longer than the call. Where
/// the system gives no more of them, the calling one does their work. A panic of `work` goes on in the caller.
///
/// # Example
///
/// ```
/// use hankel::{Sharing, in_order};
///
/// let jobs: Vec<f64> = (1..=1000).map(f64::from).collect();
/// let sum = |threads| {
///     let mut sum = 0.0;
///     let inverses = |jobs: &[f64]| jobs.iter().map(|k| k.recip()).collect();
///     in_order(&jobs, Sharing { threads, least: 1 }, inverses, |inverse| sum += inverse);
///     sum
/// };
/// assert_eq!(sum(1).to_bits(), sum(7).to_bits());
/// ```
pub fn in_order<J: Sync, R: Send>(
    jobs: &[J],
    sharing: Sharing,
    work: impl Fn(&[J]) -> Vec<R> + Sync,
    mut take: impl FnMut(R),
) {
    let work = &work;
    let threads = sharing.threads.max(1);
    for round in jobs.chunks(ROUND.saturating_mul(threads)) {
        let share = round.len().div_ceil(threads).max(sharing.least).min(round.len());
        let (own, others) = round.split_at(share);
        std::thread::scope(|scope| {
            let helpers: Vec<_> = others
                .chunks(share)
                .map(|jobs| (jobs, Builder::new().spawn_scoped(scope, || work(jobs))))
                .collect();
            work(own).into_iter().for_each(&mut take);
            for (jobs, helper) in helpers {
                match helper.map(ScopedJoinHandle::join) {
                    Ok(Ok(results)) => results.into_iter().for_each(&mut take),
                    Ok(Err(panic)) => std::panic::resume_unwind(panic),
                    // A system that gives no more threads has this one.
                    Err(_) => work(jobs).into_iter().for_each(&mut take),
                }
            }
        });
    }
}

#[cfg(test)]
mod tests;
