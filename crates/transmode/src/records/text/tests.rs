use super::*;

fn parse(text: &(impl AsRef<[u8]> + ?Sized)) -> Result<Table, CommandError> {
    read(text.as_ref(), |columns| (0..columns).collect())
}

/// Reads the columns that `choose` wants of a text with so many.
fn read(text: &[u8], choose: impl Fn(usize) -> Vec<usize>) -> Result<Table, CommandError> {
    let opened = open(Path::new("f.csv"), Format::Text, text, &ReadOptions::default())?;
    let channels = choose(opened.headings().len());
    Box::new(opened).read(Chosen { channels, ..Chosen::default() })
}

fn names(table: &Table) -> Vec<&str> {
    table.headings.iter().map(|heading| heading.name.as_str()).collect()
}

#[test]
fn reads_columns_and_remembers_lines() {
    let columns = parse("time, beta\n0, 1e-3\n\n0.1,-2\r\n").unwrap();
    assert_eq!(names(&columns), ["time", "beta"]);
    assert_eq!(columns.values, [vec![0.0, 0.1], vec![1e-3, -2.0]]);
    // The blank line is skipped, but counted.
    assert_eq!([0, 1].map(|row| columns.places.of(row)), ["line 2", "line 4"]);
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_first_name() {
    assert_eq!(names(&parse("\u{feff}time,beta\n0,1\n").unwrap()), ["time", "beta"]);
}

#[test]
fn says_what_is_wrong_and_where() {
    let check =
        |text: &[u8], expected: &str| assert_eq!(parse(text).unwrap_err().to_string(), expected);
    check(b"", "f.csv holds no samples: a header line and rows of numbers are needed");
    check(b"\n\n", "f.csv holds no samples: a header line and rows of numbers are needed");
    check(b"time,beta\n", "f.csv holds no samples: a header line and rows of numbers are needed");
    check(
        b"time;x\n0;1;2\n",
        "f.csv, line 2: 3 fields, but the header names 2 columns; repair or remove the row",
    );
    check(
        b"\n  , \n",
        "f.csv, line 2: the header should be here, but the line holds no name; remove it if the header is below",
    );
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
    check(
        b"time,beta\n0,1\n0.1\n",
        "f.csv, line 3: 1 field, but the header names 2 columns; the fields must be separated by ',', as in the header",
    );
    check(
        b"time,beta\n0,1,2\n",
        "f.csv, line 2: 3 fields, but the header names 2 columns; if the comma is its decimal mark too, export with semicolons between the fields",
    );
    check(b"t,t\n0,1\n", "f.csv: column \"t\" is there twice; rename one of them");
    check(
        b"0,1\n0.1,2\n",
        "f.csv: the first line is a row of numbers, and no line above names its 2 columns; put a header line there, or name the columns with --columns",
    );
    for text in ["inf", "left", "1,5"] {
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
        assert_eq!([0, 1, 2].map(|row| columns.places.of(row)), ["line 4", "line 7", "line 8"]);
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
        assert_eq!(
            [0, 1, 2, 3].map(|row| columns.places.of(row)),
            ["line 5", "line 6", "line 8", "line 9"]
        );
    }
    // Without an end of the last line.
    assert!(parse("t,b\r\n0,1\r\n0,x").unwrap_err().to_string().contains("line 3"));
}

#[test]
fn other_ways_to_write_a_table() {
    let numbers = |text: &str| {
        let table = parse(text).unwrap();
        let units: Vec<_> =
            table.headings.iter().map(|h| h.unit.clone().unwrap_or_default()).collect();
        (names(&table).join(" "), units.join(" "), format!("{:?}", table.values))
    };
    let check = |text: &str, expected: (&str, &str, &str)| {
        let (names, units, values) = numbers(text);
        assert_eq!((names.as_str(), units.as_str(), values.as_str()), expected, "{text}");
    };
    let plain = "[[0.0, 0.5], [1.5, -2.0]]";
    check("t;b\n0;1,5\n0,5;-2\n", ("t b", " ", plain));
    check("t\tb\n0\t1.5\n0.5\t-2\n", ("t b", " ", plain));
    check("# by a logger\n\nt [s],b (deg)\n%x\n0,1.5\n# pause\n0.5,-2\n", ("t b", "s deg", plain));
    check("t,b\ns,deg\n0,1.5\n0.5,-2\n,,\n", ("t b", "s deg", plain));
    // As numpy.savetxt writes a header.
    check("# t, b\n0,1.5\n0.5,-2\n", ("t b", " ", plain));
    check("t,b\n0,\n0.5,nan\n", ("t b", " ", "[[0.0, 0.5], [NaN, NaN]]"));
    let message = parse("t;b\n0;1,5\n0.5;2\n").unwrap_err().to_string();
    assert!(message.contains("line 3, column \"t\": \"0.5\" has a decimal point"), "{message}");
}

#[test]
fn only_the_chosen_columns_need_to_be_numbers() {
    let text = b"t,state,b\n0,on,1\n1,\xff,2\n";
    let table = read(text, |columns| vec![columns - 1, 0]).unwrap();
    assert_eq!(table.values, [[1.0, 2.0], [0.0, 1.0]]);
    assert_eq!((table.rows(), table.heading(0).name.as_str()), (2, "b"));
}
