use super::*;

const GAP: f64 = f64::NAN;

#[test]
fn gaps_in_time_and_in_any_channel_split() {
    let a = [1.0, 2.0, GAP, 4.0, 5.0, 6.0, 7.0, 8.0];
    let b = [1.0, 2.0, 3.0, GAP, 5.0, 6.0, 7.0, GAP];
    let check = |rows, gaps: &[usize], expected: &[Range<usize>]| {
        assert_eq!(segments(rows, gaps, &[&a, &b]), expected);
    };
    check(0..8, &[], &[0..2, 4..7]);
    check(0..8, &[6], &[0..2, 4..6, 6..7]);
    check(0..8, &[1, 2, 3, 7], &[0..1, 1..2, 4..7]);
    check(1..6, &[1, 5], &[1..2, 4..5, 5..6]);
    check(2..4, &[], &[]);
    check(4..4, &[], &[]);
}
