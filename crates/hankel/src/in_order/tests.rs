use super::*;

#[test]
fn results_come_in_the_order_of_the_jobs() {
    let jobs: Vec<usize> = (0..1000).collect();
    for threads in [1, 2, 7] {
        let mut seen = Vec::new();
        in_order(&jobs, threads, |jobs| jobs.to_vec(), |job| seen.push(*job));
        assert_eq!(seen, jobs, "{threads} threads");
    }
    in_order(&[0; 0], 3, |jobs| jobs.to_vec(), |_| panic!("there is no job"));
}
