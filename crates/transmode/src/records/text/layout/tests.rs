use super::*;

fn found(text: &str) -> Layout {
    search(text.as_bytes(), true, 0).unwrap_or_else(|| panic!("no table in {text:?}"))
}

fn check(text: &str, separator: u8, names: &[&str], first_row: u64) {
    let layout = found(text);
    let found = (layout.separator, layout.names.as_slice(), layout.first_row);
    let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    assert_eq!(found, (separator, names.as_slice(), first_row), "{text:?}");
}

#[test]
fn a_header_is_found_below_other_lines() {
    check("Test no. 7\n\nt,p,r\n0,1,2\n0.1,3,4\n", b',', &["t", "p", "r"], 4);
    check("sep=;\nt;p\n0;1,5\n0,1;2\n", b';', &["t", "p"], 3);
    check("t p r\n0 1 2\n0.1 3   4\n", BLANK, &["t", "p", "r"], 2);
    check("Date, 2026\nRate, 10\nBy, me\n\nt,p\n0,1\n1,2\n2,3\n3,4\n", b',', &["t", "p"], 6);
    check("Rate: 10\nBy: me\nt\tp\r\n0\t1\r\n1\t2\r\n", b'\t', &["t", "p"], 4);
}

#[test]
fn a_header_may_stand_behind_marks() {
    check("# log 3\n# t p r\n# ---- - -\n0 1 2\n1 2 3\n", BLANK, &["t", "p", "r"], 4);
    check("% t, p, r\n0 1 2\n1 2 3\n", BLANK, &["t", "p", "r"], 2);
    let layout = found("#t,p\n#[s],[deg]\n0,1\n1,2\n");
    assert_eq!(layout.names, ["t", "p"]);
    assert_eq!(layout.units, Some(vec![Some("s".to_owned()), Some("deg".to_owned())]));
}

#[test]
fn units_stand_between_names_and_rows() {
    let layout = found("flight 3\ntime beta p\ns deg deg/s\n0 1 2\n1 2 3\n");
    assert_eq!(layout.names, ["time", "beta", "p"]);
    assert_eq!(layout.units.map(|units| units.len()), Some(3));
    // Names that look like units, with nothing above them.
    check("s,g\n0,1\n1,2\n", b',', &["s", "g"], 2);
}

#[test]
fn rows_without_names_and_texts_without_rows() {
    let layout = found("0,1,2\n1,2,3\n");
    assert_eq!((layout.names.len(), layout.fields, layout.first_row), (0, 3, 1));
    assert_eq!(search(b"some words\nand more\n", true, 0), None);
    assert_eq!(search(b"", true, 0), None);
    // No row is left out silently.
    assert_eq!(search(b"t,p\n0,1,2\n0,1\n1,2\n2,3\n", true, 0), None);
    // Words are fields, too, if most are numbers.
    check("t,p,mode\n0,1,AUTO\n1,2,AUTO\n", b',', &["t", "p", "mode"], 2);
    assert_eq!(search(b"a,b\n1,2\n3,4\n", true, 1).map(|layout| layout.first_row), Some(2));
}
