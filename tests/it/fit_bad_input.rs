//! Whatever is wrong with the record of a fit: exit code 2, one sentence with the place, nothing on standard output, nothing half-written.

use transmode::Exit;

use crate::arrays::{Array, header, npy, raw};
use crate::program::{Folder, transmode};

/// Runs `fit` on a file of these bytes, asking for JSON, and expects the sentence behind the file's name.
fn refuses(name: &str, bytes: impl AsRef<[u8]>, words: &[&str], expected: &str) {
    let folder = Folder::new();
    let file = folder.file(name, bytes);
    let json = folder.path("fit.json");
    let words = [&["fit", &file, "--json", json.to_str().unwrap()], words].concat();
    transmode(&words).refused(expected);
    assert_eq!(folder.names(), [name]);
}

const PAIR: [&str; 4] = ["--input", "0", "--output", "1"];
const RAW: [&str; 6] = ["--channels", "3", "--input", "0", "--output", "1"];

fn columns(samples: u32) -> [Vec<f64>; 3] {
    [3, 7, 11].map(|factor| (0..samples).map(|k| f64::from(k * k * factor % 97)).collect())
}

#[test]
fn arrays_that_are_no_record() {
    let good = || npy(&columns(200), Array::default());
    let whole = good().len();
    refuses("x.npy", "", &PAIR, "x.npy: the file holds no samples");
    refuses("x.npy", "time,beta\n0,1\n", &PAIR, "x.npy: this does not start as an NPY file does");
    refuses("x.npy", &good()[..60], &PAIR, "x.npy: the file ends within its NPY header");
    refuses(
        "x.npy",
        &good()[..whole - 1],
        &PAIR,
        "x.npy: 200 samples of 3 channels take 4800 bytes, but the file has 4799 for them: it is truncated",
    );
    refuses(
        "x.npy",
        [good(), vec![0]].concat(),
        &PAIR,
        "has 4801 for them: something else follows",
    );
    let values = [0; 4800];
    for (descr, shape, expected) in [
        ("<i8", "(200, 3)", "x.npy: the numbers are of type \"<i8\"; floats of 4 or 8 bytes"),
        ("<c16", "(100, 3)", "of type \"<c16\""),
        ("|O", "(200, 3)", "of type \"|O\""),
        (
            "<f8",
            "(600,)",
            "shape (600,); two dimensions, samples x channels, are needed: put the sensors side by side",
        ),
        ("<f8", "()", "shape (); two dimensions"),
        ("<f8", "(10, 20, 3)", "shape (10, 20, 3); two dimensions"),
        ("<f8", "(0, 3)", "the file holds no samples"),
        ("<f8", "(3, 18446744073709551615)", "transpose it"),
        ("<f8", "(18446744073709551615, 3)", "it is truncated"),
    ] {
        refuses("x.npy", [&header(descr, false, shape)[..], &values].concat(), &PAIR, expected);
    }
    // The other way round: three samples of many channels.
    let turned = || [&header("<f8", false, "(3, 200)")[..], &values].concat();
    refuses(
        "x.npy",
        turned(),
        &PAIR,
        "3 samples in 1 segment(s) give 0 equations for 54 parameters",
    );
    refuses("x.npy", turned(), &PAIR, "; transpose the array if it is not samples x channels");
}

#[test]
fn raw_files_that_are_no_record() {
    let good = || raw(&columns(200));
    refuses("x.f64", "", &RAW, "x.f64: the file holds no samples");
    refuses(
        "x.f64",
        &good()[..4799],
        &RAW,
        "x.f64: its 4799 bytes are no multiple of 24, one sample of 3 channels of 8 bytes",
    );
    refuses(
        "x.f64",
        good(),
        &PAIR,
        "x.f64: raw doubles do not say how many channels there are; give --channels",
    );
    refuses("x.f64", npy(&columns(200), Array::default()), &RAW, "x.f64: this is an NPY file");
    refuses(
        "x.npy",
        npy(&columns(200), Array::default()),
        &RAW,
        "--channels is for raw doubles only",
    );
    refuses("x.csv", "t,a,b\n0,1,2\n", &RAW, "--channels is for raw doubles only");
    refuses(
        "x.f64",
        good(),
        &[&["--channels", "1"], &PAIR[..]].concat(),
        "--output \"1\" is none of its channels; they are called by their index, 0",
    );
}

#[test]
fn columns_that_are_not_there() {
    let good = || npy(&columns(200), Array::default());
    for text in ["3", "-1", "beta", "1.0", "99999999999999999999"] {
        refuses(
            "x.npy",
            good(),
            &["--input", "0", &format!("--output={text}")],
            &format!(
                "x.npy: --output {text:?} is none of its channels; they are called by their index, 0 to 2"
            ),
        );
    }
    refuses(
        "x.npy",
        good(),
        &[&PAIR[..], &["--time", "2"]].concat(),
        "--time is for CSV files only",
    );
    for output in ["0", "00", " 0"] {
        let words = ["--input", "0", "--output", output];
        refuses("x.npy", good(), &words, "--input and --output both name \"0\"");
    }
    let table = || "time,a,b\n0,1,2\n1,2,3\n";
    refuses(
        "x.csv",
        table(),
        &["--input", "a", "--output", "c"],
        "has no column \"c\"; it has time, a, b",
    );
    refuses("x.csv", table(), &["--input", "a", "--output", " a"], "both name \"a\"");
    refuses("x.csv", table(), &["--input", "time", "--output", "a"], "column \"time\" is time");
    refuses("x.csv", table(), &["--input", "a", "--output", "b", "--time", "c"], "no column \"c\"");
}

#[test]
fn samples_that_are_no_numbers() {
    let with = |channel: usize, sample: usize, value: f64| {
        let mut columns = columns(200);
        columns[channel][sample] = value;
        columns
    };
    let infinite = with(1, 123, f64::NEG_INFINITY);
    for fortran_order in [false, true] {
        refuses(
            "x.npy",
            npy(&infinite, Array { fortran_order, ..Array::default() }),
            &["--input", "0", "--output", "1"],
            "x.npy, sample 123 (from 0), column 1: -inf is not a finite number",
        );
    }
    refuses(
        "x.f64",
        raw(&with(0, 7, f64::INFINITY)),
        &RAW,
        "x.f64, sample 7 (from 0), column 0: inf",
    );
    // What is not asked for need not be finite.
    let folder = Folder::new();
    let file = folder.file("x.f64", raw(&with(2, 7, f64::INFINITY)));
    assert_ne!(transmode(&[&["fit", &file], &RAW[..]].concat()).exit, Exit::BadInput);
    // A number with four bytes may be infinite where the one with eight is not.
    let large = npy(&with(0, 5, 1e300), Array { descr: "<f4", ..Array::default() });
    refuses("x.npy", large, &PAIR, "x.npy, sample 5 (from 0), column 0: inf");
    let only_gaps = [vec![f64::NAN; 200], vec![1.0; 200]];
    refuses(
        "x.npy",
        npy(&only_gaps, Array::default()),
        &PAIR,
        "there is no sample at which both columns hold a number",
    );
    let gaps = (0..200).map(|k| format!("{k},NaN,{k}\n")).collect::<String>();
    refuses(
        "x.csv",
        "t,a,b\n".to_owned() + &gaps,
        &["--input", "a", "--output", "b"],
        "there is no sample at which both columns hold a number",
    );
    let table = "t,a,b\n0,1,2\n1,inf,3\n";
    refuses(
        "x.csv",
        table,
        &["--input", "a", "--output", "b"],
        "x.csv, line 3, column \"a\": \"inf\"",
    );
}

#[test]
fn records_that_say_too_little() {
    let constant = [vec![1.5; 200], columns(200)[0].clone()];
    refuses(
        "x.npy",
        npy(&constant, Array::default()),
        &PAIR,
        "x.npy: the pseudo input is constant",
    );
    let short = npy(&columns(60), Array::default());
    refuses(
        "x.npy",
        &short,
        &PAIR,
        "x.npy: 60 samples in 1 segment(s) give 10 equations for 54 parameters",
    );
    refuses(
        "x.npy",
        &short,
        &[&PAIR[..], &["--causal", "10000"]].concat(),
        "10000 parameters allowed",
    );
}

#[test]
fn files_that_cannot_be_read() {
    let folder = Folder::new();
    for name in ["x.npy", "x.f64", "x.csv"] {
        let channels = if name == "x.f64" { &["--channels", "2"][..] } else { &[] };
        let path = folder.path(name);
        let words = [&["fit", path.to_str().unwrap()], &PAIR[..], channels].concat();
        let ran = transmode(&words);
        assert_eq!(ran.exit, Exit::BadInput);
        let missing = std::fs::File::open(&path).unwrap_err();
        let expected = "check its name and folder";
        assert_eq!(
            ran.err,
            format!("error: cannot read {}: {missing}; {expected}\n", path.display())
        );
        std::fs::create_dir(&path).unwrap();
        let ran = transmode(&words);
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""));
        assert!(
            ran.err.starts_with(&format!("error: cannot read {}: ", path.display())),
            "{}",
            ran.err
        );
        assert!(ran.err.to_lowercase().contains("is a directory"), "{}", ran.err);
    }
}

#[cfg(unix)]
#[test]
fn a_device_has_no_length() {
    let ran = transmode(&[&["fit", "/dev/null"], &RAW[..]].concat());
    assert_eq!(ran.exit, Exit::BadInput);
    assert!(ran.err.contains("/dev/null: this is no regular file"), "{}", ran.err);
}

#[test]
fn command_lines_that_cannot_be() {
    for words in [
        &["fit"][..],
        &["fit", "x.npy"],
        &["fit", "x.npy", "--input", "0"],
        &["fit", "x.npy", "--input", "0", "--output", "1", "--threads", "0"],
        &["fit", "x.f64", "--input", "0", "--output", "1", "--channels", "0"],
        &["fit", "x.npy", "--input", "0", "--output", "1", "--iir", "-1"],
        &["fit", "x.npy", "y.npy", "--input", "0", "--output", "1"],
    ] {
        let ran = transmode(words);
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""), "{words:?}");
        assert!(!ran.err.is_empty());
    }
}

#[test]
fn the_record_is_never_replaced_by_the_result() {
    let folder = Folder::new();
    let bytes = npy(&columns(200), Array::default());
    let file = folder.file("x.npy", &bytes);
    let again = folder.path("./x.npy");
    for json in [file.as_str(), again.to_str().unwrap()] {
        let ran = transmode(&[&["fit", &file, "--json", json][..], &PAIR].concat());
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""));
        assert!(ran.err.contains("is the record itself"), "{}", ran.err);
    }
    let csv = folder.file("x.csv", "time,beta\n0,1\n0.1,2\n");
    let ran = transmode(&["identify", &csv, &csv, "--json", &csv]);
    assert!(ran.err.contains("is the record itself"), "{}", ran.err);
    let nowhere = folder.path("missing/fit.json");
    let words = ["fit", &file, "--json", nowhere.to_str().unwrap()];
    let ran = transmode(&[&words[..], &PAIR].concat());
    assert!(ran.err.contains("cannot write"), "{}", ran.err);
    assert_eq!(std::fs::read(&file).unwrap(), bytes);
}
