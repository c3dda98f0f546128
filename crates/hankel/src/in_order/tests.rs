use super::*;

#[test]
fn results_come_in_the_order_of_the_jobs() {
    let jobs: Vec<usize> = (0..1000).collect();
    for threads in [0, 1, 2, 7] {
        for least in [0, 1, 4, 3000] {
            let mut seen = Vec::new();
            let sharing = Sharing { threads, least };
            in_order(&jobs, sharing, |jobs| jobs.to_vec(), |job| seen.push(job));
            assert_eq!(seen, jobs, "{sharing:?}");
        }
    }
    let sharing = Sharing { threads: 3, least: 4 };
    in_order(&[0; 0], sharing, |jobs| jobs.to_vec(), |_| panic!("there is no job"));
}

#[test]
fn no_thread_starts_for_less_than_it_is_worth() {
    // For each job, how many are done together.
    let together = |threads, least| {
        let mut together = Vec::new();
        let work = |jobs: &[i32]| vec![jobs.len(); jobs.len()];
        in_order(&[0; 10], Sharing { threads, least }, work, |length| together.push(length));
        together
    };
    assert_eq!(together(4, 1), [3, 3, 3, 3, 3, 3, 3, 3, 3, 1]);
    assert_eq!(together(4, 4), [4, 4, 4, 4, 4, 4, 4, 4, 2, 2]);
    assert_eq!(together(usize::MAX, 20), [10; 10]);
}
