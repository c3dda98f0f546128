use super::*;

fn parse(text: &str, wanted: [&str; 2]) -> Result<Pair, String> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("f.csv");
    std::fs::write(&file, text).unwrap();
    let folder = format!("{}/", folder.path().display());
    let options = PairOptions { time: TimeSource::UsualOrUnknown, ..PairOptions::default() };
    load(&file, wanted, &options, Progress::Shown)
        .map_err(|error| error.to_string().replace(&folder, ""))
}

#[test]
fn not_a_number_is_a_gap_and_so_are_missing_rows() {
    let found = parse("t,a,b\n0,1,2\n0.5,NaN,nan\n1,3,-4\n", ["b", "a"]).unwrap();
    assert_eq!(found.period_s.unwrap().to_bits(), 0.5_f64.to_bits());
    let numbers = |values: &[f64]| format!("{values:?}");
    assert_eq!(numbers(&found.input), "[2.0, NaN, -4.0]");
    assert_eq!(numbers(&found.output), "[1.0, NaN, 3.0]");
    assert_eq!(found.stretches, [0..1, 2..3]);
    let found = parse("t,a,b\n0,1,2\n1,3,4\n2,5,6\n5,7,8\n", ["a", "b"]).unwrap();
    assert_eq!(found.stretches, [0..3, 3..4]);
}

#[test]
fn says_what_is_wrong() {
    let check = |text: &str, wanted, expected: &str| {
        assert_eq!(parse(text, wanted).unwrap_err(), expected);
    };
    check(
        "t,a,b\n0,1,2\nNaN,1,2\n1,3,4\n",
        ["a", "b"],
        "f.csv, line 3, column \"t\": the time is missing; repair or remove the row",
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
