use super::*;

#[test]
fn a_print_agrees_when_its_rounding_does() {
    let check = |printed: &str, value: f64, expected: bool| {
        assert_eq!(agrees_with_print(printed, value), expected, "{printed} and {value}");
    };
    check("0.9469", 0.946_905, true);
    check("0.9469", 0.946_96, false);
    check("-0.5455", -0.545_563, false);
    check("-0.5456", -0.545_563, true);
    check("13", 13.4, true);
    check("13", 13.6, false);
    check("nonsense", 0.0, false);
}

#[test]
fn verdicts_cannot_be_talked_up() {
    let numbers = |print, paper: &[&str], computed: f64, reference: f64| {
        Check::numbers("id", print, paper, &[computed], &[reference], 1e-9, "").verdict
    };
    assert_eq!(numbers(Print::Right, &["0.5"], 0.5, 0.5), Verdict::Match);
    assert_eq!(numbers(Print::Slip, &["0.6"], 0.5, 0.5), Verdict::Erratum);
    // Computed value off, though the print agrees.
    assert_eq!(numbers(Print::Right, &["0.5"], 0.5001, 0.5), Verdict::Differs);
    // A slip that is none, and a slip that nobody listed.
    assert_eq!(numbers(Print::Slip, &["0.5"], 0.5, 0.5), Verdict::Differs);
    assert_eq!(numbers(Print::Right, &["0.6"], 0.5, 0.5), Verdict::Differs);
    assert_eq!(numbers(Print::Right, &["0.5"], f64::NAN, 0.5), Verdict::Differs);
    assert_eq!(numbers(Print::Right, &["0.5", "0.7"], 0.5, 0.5), Verdict::Differs);
}

#[test]
fn multisets_count_multiplicities() {
    let z = |re| Complex::new(re, 0.0);
    assert!(multiset_distance(&[z(1.0), z(1.0)], &[z(1.0), z(2.0)]) > 0.9);
    assert!(multiset_distance(&[z(2.0), z(1.0)], &[z(1.0), z(2.0)]) < 1e-15);
    assert!(multiset_distance(&[z(1.0)], &[z(1.0), z(2.0)]).is_infinite());
}
