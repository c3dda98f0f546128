//! Whatever is wrong with the input: exit code 2, one sentence with the place, nothing on standard output, nothing half-written.

use transmode::Exit;

use crate::program::{Folder, shipped, transmode};

/// Runs `identify` with a bad file beside a good one, asking for JSON, and expects the sentence.
fn refuses(bytes: impl AsRef<[u8]>, more: &[&str], expected: &str) {
    let folder = Folder::new();
    let bad = folder.file("bad.csv", bytes);
    let json = folder.path("modes.json");
    let good = shipped("noise_free_rudder.csv");
    let words = [&["identify", &bad, &good, "--json", json.to_str().unwrap()], more].concat();
    transmode(&words).refused(expected);
    assert_eq!(folder.names(), ["bad.csv"]);
}

fn header() -> String {
    "time,beta,p,r,phi\n".to_owned()
}

fn rows(count: u32, row: impl Fn(u32) -> String) -> String {
    header() + &(0..count).map(row).collect::<String>()
}

/// Five finite columns that vary; time in steps of 0.1 s.
fn good_row(k: u32) -> String {
    let value = |factor: u32| f64::from(k * k * factor % 97) - 48.0;
    format!("{},{},{},{},{}\n", f64::from(k) / 10.0, value(1), value(3), value(7), value(11))
}

#[test]
fn files_that_are_no_tables() {
    refuses("", &[], "bad.csv holds no samples");
    refuses(header(), &[], "bad.csv holds no samples");
    refuses("\n\n\n", &[], "bad.csv holds no samples");
    refuses("0,1,2,3,4\n0.1,1,2,3,4\n", &[], "the first line is a row of numbers");
    refuses(b"\x7fELF\x02\x01\x00\xff\xfe", &[], "bad.csv");
    refuses(
        b"time,beta,p,r,phi\n0,1,2,\xff\xfe,4\n",
        &[],
        "bad.csv, line 2: the file is not UTF-8 text",
    );
    refuses(
        header() + "0,1,2,3,4\n0.1,1,2,3\n",
        &[],
        "bad.csv, line 3: 4 fields, but the header names 5 columns",
    );
    refuses(
        header() + "0,1,2,3,4,5\n",
        &[],
        "bad.csv, line 2: 6 fields, but the header names 5 columns",
    );
    refuses("time,beta,beta,r,phi\n0,1,2,3,4\n", &[], "column \"beta\" is there twice");
}

#[test]
fn fields_that_are_no_numbers() {
    for text in ["inf", "-Infinity", "abc", "1e999", "1;5", "0x10"] {
        let table = rows(100, |k| if k == 40 { format!("4,1,{text},3,4\n") } else { good_row(k) });
        refuses(
            table,
            &[],
            &format!("bad.csv, line 42, column \"p\": {text:?} is not a finite number"),
        );
    }
}

#[test]
fn time_that_does_not_advance_evenly() {
    let table = |change: fn(u32) -> u32| rows(200, move |k| good_row(change(k)));
    // A step of one and a half periods is no gap.
    let late =
        |k: u32| format!("{},1,2,3,4\n", f64::from(k) / 10.0 + if k < 90 { 0.0 } else { 0.05 });
    refuses(
        rows(200, late),
        &[],
        "bad.csv, line 92: time advances by 0.15 s, elsewhere by 0.1 s; cut",
    );
    // Another reading at the same time; a row that was written twice is left out.
    let twice = |k: u32| match k {
        90 => good_row(89).trim_end().to_owned() + "9\n",
        _ => good_row(k - u32::from(k > 90)),
    };
    refuses(rows(200, twice), &[], "bad.csv, line 92: time stands still");
    refuses(
        table(|k| if k == 90 { 10 } else { k }),
        &[],
        "bad.csv, line 92: time runs backwards by 7.9 s; put",
    );
    refuses(
        table(|_| 7),
        &[],
        "line 3: time stands still, as in the row before (likewise line 4, line 5, line 6, line 7 and 194 more)",
    );
    refuses(header() + &good_row(0), &[], "bad.csv holds 1 sample; at least 2");
    refuses(table(|k| 200 - k), &[], "bad.csv, line 3: time runs backwards by 0.1 s");
    for (exponent, step) in [("e300", "1e299"), ("e-319", "1e-320")] {
        refuses(
            rows(200, |k| good_row(k).replacen(',', &format!("{exponent},"), 1)),
            &[],
            &format!("bad.csv, column \"time\": time advances by {step} s; time in seconds"),
        );
    }
}

#[test]
fn columns_that_are_not_there() {
    let good = || rows(200, good_row);
    refuses(
        good(),
        &["--outputs", "beta,p,q"],
        "bad.csv has no column \"q\"; it has time, beta, p, r, phi",
    );
    refuses(good(), &["--time", "clock"], "bad.csv has no column \"clock\"");
    refuses(good(), &["--outputs", "beta,p,p"], "--outputs names \"p\" twice");
    refuses(
        good(),
        &["--outputs", "beta,time,p"],
        "--outputs names \"time\" as a sensor, but it is the column of time",
    );
    refuses(good(), &["--outputs", "beta,,p"], "separate the names by single commas");
    refuses("time,,p\n0,1,2\n0.1,2,3\n", &["--outputs", "q,r"], "it has time, \"\", p");
    refuses("time\n0\n0.1\n", &[], "bad.csv: time is its only column");
    refuses(good(), &["--outputs", "beta,p"], "2 records of 2 sensors, but 3 records are needed");
    refuses(
        good(),
        &["--outputs", "beta,p", "--method", "as-printed"],
        "2 sensors, but 3 are needed",
    );
    refuses("time,beta,p\n0,1,2\n0.1,2,3\n", &[], "has channels beta, p");
    refuses(
        "beta,p,r,phi\n1,2,3,4\n",
        &[],
        "none of its columns (beta, p, r, phi) is called time, t or timestamp",
    );
}

#[test]
fn records_that_say_too_little() {
    refuses(rows(60, good_row), &["--method", "as-printed"], "60 samples");
    refuses(rows(8, good_row), &[], "8 samples");
    let constant =
        rows(200, |k| format!("{},1.5,{k},{},{}\n", f64::from(k) / 10.0, k * k % 13, k % 7));
    refuses(constant, &[], "constant");
    let slow = rows(200, |k| {
        format!("{},{k},{},{},{}\n", f64::from(k) / 5.0, k * k % 31, k * k % 13, k % 7)
    });
    refuses(slow, &[], "is sampled every 0.1 s, record \"bad.csv\" every 0.2 s");
}

#[test]
fn orders_that_cannot_be() {
    let [good, more] = ["noise_free_aileron.csv", "noise_free_rudder.csv"].map(shipped);
    let check = |words: &[&str], expected: &str| {
        let ran =
            transmode(&[&["identify", &good, &more, "--method", "as-printed"], words].concat());
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""), "{words:?}");
        assert!(ran.err.contains(expected), "{}", ran.err);
    };
    check(&["--causal", "1000000"], "10000 parameters");
    for option in ["--iir", "--causal", "--anticausal"] {
        check(&[option, "0"], "an order must be at least 1");
        check(&[option, "four"], &format!("invalid value 'four' for '{option}"));
    }
    check(&["--causal", "3000"], "samples");
    check(&["--iir", "-1"], "an order is a whole number, at least 1");
}

#[test]
fn command_lines_that_cannot_be() {
    let good = shipped("noise_free_aileron.csv");
    for words in [&["identify"][..], &["nonsense"], &[], &["identify", &good, "--json"]] {
        let ran = transmode(words);
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""), "{words:?}");
        assert!(!ran.err.is_empty());
    }
    let ran = transmode(&["identify", &good]);
    assert_eq!(ran.exit, Exit::BadInput);
    assert!(ran.err.contains("1 record of 4 sensors, but 2 records are needed"), "{}", ran.err);
    let ran = transmode(&["identify", &good, &good]);
    assert!(ran.err.contains("is given twice and would count as two records"), "{}", ran.err);
}

#[test]
fn places_that_cannot_be_written() {
    let [good, more] = ["noise_free_aileron.csv", "noise_free_rudder.csv"].map(shipped);
    let folder = Folder::new();
    let missing = folder.path("no").join("modes.json");
    let ran = transmode(&["identify", &good, &more, "--json", missing.to_str().unwrap()]);
    assert_eq!(ran.exit, Exit::BadInput);
    let reason = std::fs::File::open(&missing).unwrap_err();
    let expected = "make its folder first, or name another";
    assert_eq!(
        ran.err,
        format!("error: cannot write {}: {reason}; {expected}\n", missing.display())
    );
    assert!(folder.names().is_empty());
}
