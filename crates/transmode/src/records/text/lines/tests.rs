use super::*;

fn rows(text: &str, separator: u8) -> Vec<(u64, String)> {
    let mut lines = Lines::new(text.as_bytes());
    lines.separated_by(separator);
    let mut found = Vec::new();
    while let Some(row) = lines.next().unwrap() {
        found.push((row.line, String::from_utf8(row.bytes.to_vec()).unwrap()));
    }
    found
}

#[test]
fn every_end_of_line_counts_once() {
    for end in ["\n", "\r\n", "\r"] {
        let text = format!("a{end}{end}b,c{end}d");
        let expected = [(1, "a"), (2, ""), (3, "b,c"), (4, "d")].map(|(n, t)| (n, t.to_owned()));
        assert_eq!(rows(&text, b','), expected, "{end:?}");
    }
    assert_eq!(rows("", b','), []);
    assert_eq!(rows("\n", b','), [(1, String::new())]);
}

#[test]
fn a_row_goes_on_where_a_quote_is_open() {
    let found = rows("a;\"b\nc\"\"\n\";d\n\"\"x\"\n3\"4\n", b';');
    let expected = [(1, "a;\"b\nc\"\"\n\";d"), (4, "\"\"x\""), (5, "3\"4")];
    assert_eq!(found, expected.map(|(n, t)| (n, t.to_owned())));
    let mut lines = Lines::new(&b"a\n1,\"2\n3\n"[..]);
    assert!(lines.next().unwrap().is_some());
    assert!(matches!(lines.next(), Err(LineError::OpenQuote { line: 2 })));
}

/// A source that gives one byte at a time.
struct Slow<'a>(&'a [u8]);

impl Read for Slow<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let (Some((first, rest)), [place, ..]) = (self.0.split_first(), buffer) else {
            return Ok(0);
        };
        (*place, self.0) = (*first, rest);
        Ok(1)
    }
}

#[test]
fn pieces_leave_no_trace() {
    let text = "time,\"x\r\ny\"\r\n\r\n0,1\r2,3\n\"\"\"\",4";
    let mut lines = Lines::new(Slow(text.as_bytes()));
    let mut found = Vec::new();
    while let Some(row) = lines.next().unwrap() {
        found.push((row.line, String::from_utf8(row.bytes.to_vec()).unwrap()));
    }
    assert_eq!(found, rows(text, b','));
    assert_eq!(found.len(), 5);
}

#[test]
fn an_endless_line_is_refused() {
    let mut lines = Lines::new(std::io::repeat(b'1'));
    assert!(matches!(lines.next(), Err(LineError::Long { line: 1 })));
    let mut lines = Lines::new((&b"\""[..]).chain(std::io::repeat(b'\n')));
    assert!(matches!(lines.next(), Err(LineError::OpenQuote { line: 1 })));
}
