use super::*;

fn structure(l: usize, r: usize, d: usize, constant_term: ConstantTerm) -> Structure {
    Structure::new(Orders::new(l, r, d).unwrap(), constant_term)
}

#[test]
fn parameter_counts() {
    let check = |l, r, d, omitted, included| {
        assert_eq!(
            structure(l, r, d, ConstantTerm::Omitted).parameter_count(),
            omitted,
            "{l} {r} {d}"
        );
        assert_eq!(
            structure(l, r, d, ConstantTerm::Included).parameter_count(),
            included,
            "{l} {r} {d}"
        );
    };
    // The paper's (42)-(44): l + r + d without the constant term, one more with it.
    check(4, 25, 25, 54, 55);
    check(1, 0, 0, 1, 2);
    check(0, 0, 0, 1, 1);
    check(0, 2, 3, 6, 6);
    check(2, 3, 0, 5, 6);
}

#[test]
fn names_follow_the_order_of_the_vector() {
    let names: Vec<String> =
        structure(2, 1, 1, ConstantTerm::Included).parameters().map(|p| p.to_string()).collect();
    assert_eq!(names, ["c_0", "c_1", "h_-1", "h_0", "h_1"]);
    assert_eq!(
        structure(0, 0, 0, ConstantTerm::Omitted).parameters().collect::<Vec<_>>(),
        [Parameter::Markov(0)]
    );
}

#[test]
fn equations_need_the_past_and_the_future() {
    let check = |l, r, d, samples, expected| {
        assert_eq!(
            Orders::new(l, r, d).unwrap().equations(samples),
            expected,
            "{l} {r} {d} {samples}"
        );
    };
    check(4, 25, 25, 2000, 1950);
    check(4, 25, 1, 2000, 1971);
    check(0, 0, 0, 7, 7);
    check(4, 25, 25, 50, 0);
    check(4, 25, 25, 0, 0);
}

#[test]
fn huge_orders_are_refused() {
    for (l, r, d) in [(usize::MAX, 1, 1), (0, usize::MAX, usize::MAX), (0, 5000, 5000)] {
        assert!(
            matches!(Orders::new(l, r, d), Err(FitError::OrdersTooLarge { .. })),
            "{l} {r} {d}"
        );
    }
}
