use super::*;

#[test]
fn a_window_is_read_from_the_right() {
    let check = |text: &str, file: &str, start_s, end_s| {
        let expected = Window { file: file.into(), start_s, end_s };
        assert_eq!(Window::parse(text), Ok(expected), "{text}");
    };
    check("a.csv:10:40.5", "a.csv", Some(10.0), Some(40.5));
    check("C:\\flight:2.csv:-1:1e3", "C:\\flight:2.csv", Some(-1.0), Some(1000.0));
    check("a.csv::40", "a.csv", None, Some(40.0));
    check("a.csv:10:", "a.csv", Some(10.0), None);
    check("a.csv::", "a.csv", None, None);
    for text in
        ["a.csv", "a.csv:10", ":10:40", "a.csv:x:40", "a.csv:10:inf", "a.csv:40:10", "a.csv:10:10"]
    {
        assert!(Window::parse(text).is_err(), "{text}");
    }
    assert_eq!(Window::parse("a.csv:0.1:").unwrap().suffix(), ":0.1:");
}

#[test]
fn periods_and_factors_that_cannot_be() {
    assert_eq!(period("0.02"), Ok(0.02));
    for text in ["0", "-1", "NaN", "inf", "1e13", "x"] {
        assert!(period(text).is_err(), "{text}");
    }
    assert_eq!(factor("3").map(NonZero::get), Ok(3));
    for text in ["0", "-1", "1.5", ""] {
        assert!(factor(text).is_err(), "{text}");
    }
}
