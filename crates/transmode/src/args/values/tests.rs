use super::*;

#[test]
fn orders() {
    assert_eq!("auto".parse(), Ok(OrderAsked::Auto));
    assert_eq!(" 4".parse(), Ok(OrderAsked::States(4)));
    for text in ["0", "-1", "four", "4.5", "", "Auto"] {
        assert!(text.parse::<OrderAsked>().is_err(), "{text}");
    }
}

#[test]
fn offsets() {
    assert_eq!("auto".parse(), Ok(OffsetsAsked::Auto));
    assert_eq!("zero".parse(), Ok(OffsetsAsked::Zero));
    assert_eq!("free".parse(), Ok(OffsetsAsked::Free));
    assert_eq!("0.1, 2e-3".parse(), Ok(OffsetsAsked::Deviations(vec![0.1, 2e-3])));
    for text in ["", "0", "-0.1", "0.1,,0.2", "NaN", "inf", "none"] {
        assert!(text.parse::<OffsetsAsked>().is_err(), "{text}");
    }
}

#[test]
fn bands() {
    let band = |lowest, highest| Ok(Band { lowest, highest });
    assert_eq!("0.1:10".parse(), band(Some(0.1), Some(10.0)));
    assert_eq!(":10".parse(), band(None, Some(10.0)));
    assert_eq!("0: ".parse(), band(Some(0.0), None));
    for text in ["", "3", "-1:2", "2:2", "3:2", "a:b", "1:NaN", "1:2:3", "inf:"] {
        assert!(text.parse::<Band>().is_err(), "{text}");
    }
}

#[test]
fn quiet_files() {
    assert_eq!("calm.csv".parse(), Ok(QuietFile::Whole("calm.csv".into())));
    let window = Window { file: "calm.csv".into(), start_s: Some(0.0), end_s: Some(9.5) };
    assert_eq!("calm.csv:0:9.5".parse(), Ok(QuietFile::Stretch(window)));
    assert_eq!("calm.csv:0:x".parse(), Ok(QuietFile::Whole("calm.csv:0:x".into())));
}

#[test]
fn the_paper_is_a_name_of_its_method() {
    use clap::ValueEnum;
    assert_eq!(MethodName::from_str("paper", false), Ok(MethodName::AsPrinted));
    assert_eq!(MethodName::AsPrinted.word(), "as-printed");
}
