use super::*;

fn split(text: &str, separator: u8) -> Vec<String> {
    let quoted = text.contains('"');
    texts(Row { line: 1, bytes: text.as_bytes(), quoted }, separator).unwrap()
}

#[test]
fn the_most_frequent_candidate_separates() {
    let check =
        |header: &str, expected: u8| assert_eq!(separator(header.as_bytes()), expected, "{header}");
    check("time,beta,p", b',');
    check("time;beta;p", b';');
    check("time\tbeta\tp", b'\t');
    check("time;\"beta, left, outer\";p", b';');
    check("time [s];beta, left;p;r", b';');
    check("time", b'\t');
    check("a;b\tc", b'\t');
}

#[test]
fn fields_are_cut_and_trimmed() {
    assert_eq!(split(" a , b,,c ", b','), ["a", "b", "", "c"]);
    assert_eq!(split("", b','), [""]);
    assert_eq!(split("\"a;\"\"b\"\"\";c\"d", b';'), ["a;\"b\"", "c\"d"]);
}

#[test]
fn numbers_with_either_mark() {
    let check = |text: &str, separator, expected: Option<f64>| {
        let found = number(text.as_bytes(), separator).map(|number| number.value.to_bits());
        assert_eq!(found, expected.map(f64::to_bits), "{text}");
    };
    check("1.5", b',', Some(1.5));
    check("-1,5e-3", b';', Some(-1.5e-3));
    check("1,5", b',', None);
    check("1.234,5", b';', None);
    check("1,234,5", b';', None);
    check("+7", b'\t', Some(7.0));
    check("", b',', Some(f64::NAN));
    check("abc", b',', None);
    check("1e999", b',', Some(f64::INFINITY));
    assert_eq!(number(b"1,5", b';').unwrap().mark, Some(b','));
    assert_eq!(number(b"15", b';').unwrap().mark, None);
}
