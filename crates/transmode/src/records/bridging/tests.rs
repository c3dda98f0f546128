use super::*;

const GAP: f64 = f64::NAN;

fn check(gaps: &[(usize, usize)], longest: usize, expected: &[(Range<usize>, usize, usize)]) {
    let a = [1.0, 2.0, 3.0, 4.0, 5.0, GAP, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0];
    let b = [GAP, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, GAP];
    let found = stretches(0..12, gaps, &[&a, &b], longest, 400);
    let found: Vec<_> =
        found.into_iter().map(|s| (s.rows.clone(), s.samples(), s.missing)).collect();
    assert_eq!(found, expected);
}

#[test]
fn short_gaps_stay_inside_and_long_ones_split() {
    check(&[], 0, &[(1..5, 4, 0), (6..11, 5, 0)]);
    check(&[], 1, &[(1..11, 10, 1)]);
    check(&[(9, 1)], 1, &[(1..11, 11, 2)]);
    check(&[(9, 2)], 1, &[(1..9, 8, 1), (9..11, 2, 0)]);
    // A missing row beside an incomplete one is a gap of two.
    check(&[(6, 1)], 1, &[(1..5, 4, 0), (6..11, 5, 0)]);
    check(&[(6, 1)], 2, &[(1..11, 11, 2)]);
    // More than one row in four.
    check(&[(3, 2), (8, 2)], 2, &[(1..3, 2, 0), (3..5, 2, 0), (6..8, 2, 0), (8..11, 3, 0)]);
}

#[test]
fn what_is_missing_is_marked() {
    let values = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
    let found = stretches(1..8, &[(1, 5), (3, 2)], &[&values], 2, 400);
    assert_eq!(found.len(), 1);
    let marked = found[0].of(&values);
    assert_eq!(marked.len(), 9);
    assert_eq!(marked[..2], [2.0, 3.0]);
    assert!(marked[2].is_nan() && marked[3].is_nan());
    assert_eq!(marked[4..], [4.0, 5.0, 6.0, 7.0, 8.0]);
}

#[test]
fn the_usual_bridge_is_three_samples_or_a_quarter_of_a_second() {
    assert_eq!(Bridge::Never.longest(0.1), 0);
    assert_eq!(Bridge::Usual.longest(0.1), 3);
    assert_eq!(Bridge::Usual.longest(0.02), 12);
    assert_eq!(Bridge::Usual.longest(0.001), 25);
    assert_eq!(Bridge::Usual.longest(60.0), 3);
    assert_eq!(Bridge::UpTo(0.3).longest(0.1), 3);
    assert_eq!(Bridge::UpTo(0.0).longest(0.1), 0);
    assert_eq!(Bridge::UpTo(1.0).longest(0.1), 10);
}
