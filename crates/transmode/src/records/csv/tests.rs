use super::*;

fn parse(text: &(impl AsRef<[u8]> + ?Sized)) -> Result<Columns<&[u8]>, CommandError> {
    read(Path::new("f.csv"), text.as_ref(), Missing::IsFault)
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
    check(b"time\n0,1\n", "f.csv, line 2: 2 fields, but the header names 1 column");
    check(
        b"\n  , \ntime,beta\n0,1\n",
        "f.csv, line 2: the header should be here, but the line holds no name; remove it if the header is below",
    );
    for (separator, shown) in [(";", "';'"), ("\t", "'\\t'")] {
        check(
            format!("time{separator}beta\n0{separator}1\n").as_bytes(),
            &format!(
                "f.csv: one column only, its name holds {shown}: the fields must be separated by commas; export with commas"
            ),
        );
    }
    for (text, line) in [
        ("\ntime,\"beta\n0,1\n", 2),
        ("time,beta\n0,\"1\n0.1,2\n", 2),
        ("time,beta\n0,1\n\"0.1,2\n", 3),
    ] {
        check(
            text.as_bytes(),
            &format!(
                "f.csv, line {line}: a quote is opened there and never closed; close or remove it"
            ),
        );
    }
    check(b"time,beta\n0,1\n0.1\n", "f.csv, line 3: 1 field, but the header names 2 columns");
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
        assert!(message.starts_with("f.csv, line 8: 1 field,"), "{message}");
        let repaired = text.replace("0.2,x", "0.2,1");
        let columns = parse(&repaired).unwrap();
        assert_eq!([0, 1, 2].map(|row| columns.line(row)), [4, 7, 8]);
    }
    // A line break between quotes ends a line, but no row. A doubled quote stays between them, a quote amid a field opens none.
    for end in ["\n", "\r\n", "\r"] {
        let text = format!(
            "\u{feff}\"time{end}in \"\"s,{end}\"{end}{end}0{end}\"1{end}\"{end}\"2\"{end}3\"4{end}"
        );
        let message = parse(&text).unwrap_err().to_string();
        assert!(
            message.starts_with("f.csv, line 9, column") && message.contains("3\\\"4"),
            "{message}"
        );
        let repaired = text.replace("3\"4", "3");
        let columns = parse(&repaired).unwrap();
        assert_eq!([0, 1, 2, 3].map(|row| columns.line(row)), [5, 6, 8, 9]);
    }
    // Without an end of the last line.
    assert!(parse("t,b\r\n0,1\r\n0,x").unwrap_err().to_string().contains("line 3"));
}
