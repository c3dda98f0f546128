use super::*;

fn parse(text: &str, wanted: [&str; 2]) -> Result<Pair, String> {
    let file = Path::new("f.csv");
    csv::read(file, text.as_bytes(), Missing::IsGap)
        .and_then(|columns| pair(file, columns, wanted, None))
        .map_err(|error| error.to_string())
}

#[test]
fn not_a_number_is_a_gap() {
    let found = parse("t,a,b\n0,1,2\n0.5,NaN,nan\n1,3,-4\n", ["b", "a"]).unwrap();
    assert_eq!(found.period.seconds().to_bits(), 0.5_f64.to_bits());
    let numbers = |values: &[f64]| format!("{values:?}");
    assert_eq!(numbers(&found.input), "[2.0, NaN, -4.0]");
    assert_eq!(numbers(&found.output), "[1.0, NaN, 3.0]");
}

#[test]
fn says_what_is_wrong() {
    let check = |text: &str, wanted, expected: &str| {
        assert_eq!(parse(text, wanted).unwrap_err(), expected);
    };
    check(
        "t,a,b\n0,1,2\nNaN,1,2\n1,3,4\n",
        ["a", "b"],
        "f.csv, line 3, column \"t\": \"NaN\" is not a finite number; repair or remove the row",
    );
    check(
        "t,a,b\n0,1,2\n1,inf,2\n",
        ["a", "b"],
        "f.csv, line 3, column \"a\": \"inf\" is not a finite number; repair or remove the row",
    );
    check("t,a,b\n0,1,2\n1,1,2\n", ["a", "c"], "f.csv has no column \"c\"; it has t, a, b");
    check(
        "t,a,b\n0,1,2\n1,1,2\n",
        ["a", "t"],
        "column \"t\" is time; --input and --output name sensors",
    );
}
