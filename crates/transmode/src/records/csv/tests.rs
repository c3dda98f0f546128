use super::*;

fn parse(text: &(impl AsRef<[u8]> + ?Sized)) -> Result<Columns<&[u8]>, CommandError> {
    read(Path::new("f.csv"), text.as_ref())
}

#[test]
fn reads_columns_and_remembers_lines() {
    let columns = parse("time, beta\n0, 1e-3\n\n0.1,-2\r\n").unwrap();
    assert_eq!(columns.names, ["time", "beta"]);
    assert_eq!(columns.values, [vec![0.0, 0.1], vec![1e-3, -2.0]]);
    // The blank line is skipped, but counted.
    assert_eq!([columns.line(0), columns.line(1)], [2, 4]);
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_first_name() {
    assert_eq!(parse("\u{feff}time,beta\n0,1\n").unwrap().names, ["time", "beta"]);
}

#[test]
fn says_what_is_wrong_and_where() {
    let check =
        |text: &[u8], expected: &str| assert_eq!(parse(text).unwrap_err().to_string(), expected);
    check(b"", "f.csv holds no samples: a header line and rows of numbers are needed");
    check(b"\n\n", "f.csv holds no samples: a header line and rows of numbers are needed");
    check(b"time,beta\n", "f.csv holds no samples: a header line and rows of numbers are needed");
    check(b"time,beta\n0,1\n0.1\n", "f.csv, line 3: 1 fields, but the header names 2 columns");
    check(b"time,beta\n0,1,2\n", "f.csv, line 2: 3 fields, but the header names 2 columns");
    check(b"t,t\n0,1\n", "f.csv: column \"t\" is there twice; rename one of them");
    check(
        b"0,1\n0.1,2\n",
        "f.csv: the first line is a row of numbers; a header line that names the columns is needed",
    );
    for text in ["NaN", "inf", "", "left", "1,5"] {
        let quoted = format!("time,beta\n0,1\n0.1,\"{text}\"\n");
        check(
            quoted.as_bytes(),
            &format!(
                "f.csv, line 3, column \"beta\": {text:?} is not a finite number; repair or remove the row"
            ),
        );
    }
    check(
        b"time,beta\n0,\xff\n",
        "f.csv, line 2: the file is not UTF-8 text; export it as plain CSV",
    );
}

#[test]
fn a_long_field_is_shortened_in_the_message() {
    let message = parse(&format!("time,beta\n0,{}\n", "x".repeat(1000))).unwrap_err().to_string();
    assert!(message.contains("xxx...\""), "{message}");
    assert!(message.len() < 150, "{message}");
}

#[test]
fn lines_are_those_that_an_editor_shows() {
    for end in ["\n", "\r\n", "\r"] {
        let text = format!("{end}{end}time,beta{end}0,1{end}{end}{end}0.1,2{end}0.2,x{end}");
        let message = parse(&text).unwrap_err().to_string();
        assert!(message.starts_with("f.csv, line 8, column \"beta\""), "{message}");
        let message = parse(&text.replace(",x", "")).unwrap_err().to_string();
        assert!(message.starts_with("f.csv, line 8: 1 fields"), "{message}");
        let repaired = text.replace("0.2,x", "0.2,1");
        let columns = parse(&repaired).unwrap();
        assert_eq!([0, 1, 2].map(|row| columns.line(row)), [4, 7, 8]);
    }
    // Without an end of the last line.
    assert!(parse("t,b\r\n0,1\r\n0,x").unwrap_err().to_string().contains("line 3"));
}
