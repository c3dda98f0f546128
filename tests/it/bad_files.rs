//! The written list of bad inputs: what a file holds, what is asked of it, and the sentence that says what is wrong.
//!
//! More of them, one theme a test, are in `bad_input.rs` (tables) and `fit_bad_input.rs` (arrays).

use crate::arrays::{Array, Mat, archive, gzip, header, mat, npy, npy_vector};
use crate::program::{Folder, shipped, transmode};

/// Five channels of 200 samples; time in steps of 0.1 s.
fn columns() -> [Vec<f64>; 5] {
    let channel =
        |factor: u32| (0..200_u32).map(|k| f64::from(k * k * factor % 97) - 48.0).collect();
    let time = (0..200).map(|k| f64::from(k) / 10.0).collect();
    [time, channel(1), channel(3), channel(7), channel(11)]
}

const NAMES: [&str; 5] = ["time", "beta", "p", "r", "phi"];

/// The same as text, with each row as `change` makes it.
fn table(header: &str, change: impl Fn(usize, String) -> String) -> Vec<u8> {
    let columns = columns();
    let row = |k: usize| {
        let fields: Vec<_> = columns.iter().map(|column| column[k].to_string()).collect();
        change(k, fields.join(","))
    };
    (format!("{header}\n") + &(0..200).map(|k| row(k) + "\n").collect::<String>()).into_bytes()
}

const HEADER: &str = "time,beta,p,r,phi";

pub(crate) fn good() -> Vec<u8> {
    table(HEADER, |_, row| row)
}

/// Good but for row 90, on line 92.
fn with_row(changed: &str) -> Vec<u8> {
    table(HEADER, |k, row| if k == 90 { changed.to_owned() } else { row })
}

fn with_header(header: &str) -> Vec<u8> {
    table(header, |_, row| row)
}

fn npz(change: impl Fn(&str, Vec<f64>) -> Vec<u8>) -> Vec<u8> {
    let members: Vec<_> = NAMES
        .iter()
        .zip(columns())
        .map(|(name, column)| (format!("{name}.npy"), change(name, column)))
        .collect();
    archive(&members.iter().map(|(name, bytes)| (name.as_str(), bytes.clone())).collect::<Vec<_>>())
}

fn matlab(version: Mat) -> Vec<u8> {
    let columns = columns();
    let variables: Vec<_> = NAMES
        .iter()
        .zip(&columns)
        .map(|(name, x)| (*name, 6, [x.len(), 1], x.as_slice()))
        .collect();
    mat(version, &variables)
}

fn cut(mut bytes: Vec<u8>, part: usize) -> Vec<u8> {
    bytes.truncate(bytes.len() * part / 100);
    bytes
}

fn utf16(text: &[u8]) -> Vec<u8> {
    [0xff, 0xfe].into_iter().chain(text.iter().flat_map(|byte| [*byte, 0])).collect()
}

/// Name of the file, its bytes, more words of the command line, a phrase of the sentence.
type Case = (&'static str, Vec<u8>, &'static [&'static str], &'static str);

fn texts() -> Vec<Case> {
    let nan = |from: usize| {
        table(HEADER, move |k, row| {
            if k % from == 0 {
                format!("{},nan,nan,nan,nan", row.split(',').next().unwrap())
            } else {
                row
            }
        })
    };
    let many = (0..1_000_000).map(|k| format!("c{k}")).collect::<Vec<_>>().join(",");
    let plain: &[&str] = &[];
    vec![
        ("empty.csv", Vec::new(), plain, "empty.csv holds no samples"),
        ("header.csv", format!("{HEADER}\n").into_bytes(), plain, "header.csv holds no samples"),
        ("comments.csv", b"# a\n% b\n\n# c\n".to_vec(), plain, "comments.csv holds no samples"),
        ("mark.csv", b"\xef\xbb\xbf".to_vec(), plain, "mark.csv holds no samples"),
        (
            "numbers.csv",
            good()[HEADER.len() + 1..].to_vec(),
            plain,
            "the first line is a row of numbers",
        ),
        (
            "junk.csv",
            (0..4000_u32).map(|k| u8::try_from(k * k % 251).unwrap()).collect(),
            plain,
            "byte 0 is zero, so this is no text",
        ),
        ("nul.csv", with_row("9,1,\0,3,4"), plain, "is zero, so this is no text"),
        ("utf16.csv", utf16(&with_row("9,1,x,3,4")), plain, "\"x\" is not a finite number"),
        (
            "latin.csv",
            b"time,beta [\x8f],p,r\n0,1,2,3\n".to_vec(),
            plain,
            "line 1: the file is not UTF-8 text",
        ),
        (
            "endless.csv",
            vec![b'1'; 40_000_000],
            plain,
            "line 1: the line is longer than 33554432 bytes",
        ),
        (
            "wide.csv",
            many.into_bytes(),
            plain,
            "the header names 1000000 columns, and at most 10000 are read",
        ),
        (
            "quote.csv",
            with_row("9,\"1,2,3,4"),
            plain,
            "line 92: a quote is opened there and never closed",
        ),
        (
            "ragged.csv",
            with_row("9,1,2,3"),
            plain,
            "line 92: 4 fields, but the header names 5 columns",
        ),
        (
            "mixed.csv",
            with_row("9;1;2;3;4"),
            plain,
            "line 92: 1 field, but the header names 5 columns; the fields must be separated by ','",
        ),
        (
            "semicolons.csv",
            table("time;beta;p;r;phi", |_, row| row),
            plain,
            "1 field, but the header names 5 columns; the fields must be separated by ';'",
        ),
        (
            "comma.csv",
            with_row("9,0,1,0,2,0,3,0,4,0"),
            plain,
            "if the comma is its decimal mark too, export with semicolons",
        ),
        (
            "marks.csv",
            b"t;a;b;c\n0;1,5;2;3\n0.1;1;2;3\n".to_vec(),
            plain,
            "line 3, column \"t\": \"0.1\" has a decimal point, where the rows above have a decimal comma",
        ),
        (
            "text.csv",
            with_row("9,1,left,3,4"),
            plain,
            "line 92, column \"p\": \"left\" is not a finite number",
        ),
        (
            "infinite.csv",
            with_row("9,1,-inf,3,4"),
            plain,
            "line 92, column \"p\": \"-inf\" is not a finite number",
        ),
        (
            "twice.csv",
            with_header("time,beta,p,p [deg/s],phi"),
            plain,
            "column \"p\" is there twice",
        ),
        (
            "unit.csv",
            with_header("time,beta [deg],p [furlong],r,phi"),
            plain,
            "column \"p\": the unit \"furlong\" is not known; known are rad, deg",
        ),
        (
            "unitrow.csv",
            table("time,beta,p,r,phi\ns,rad,stone,rad/s,", |_, row| row),
            plain,
            "column \"p\": the unit \"stone\" is not known",
        ),
        (
            "clock.csv",
            with_header("time [fortnight],beta,p,r,phi"),
            plain,
            "column \"time\": \"fortnight\" is no unit of time",
        ),
        (
            "degrees.csv",
            with_header("time [deg],beta,p,r,phi"),
            plain,
            "column \"time\": \"deg\" is no unit of time",
        ),
        (
            "untimed.csv",
            with_header("k,beta,p,r,phi"),
            plain,
            "is called time, t or timestamp; name it with --time, or give --sample-period",
        ),
        ("alone.csv", b"time\n0\n0.1\n".to_vec(), plain, "time is its only column"),
        (
            "clocks.csv",
            table(HEADER, |k, _| format!("{}:00:0{},1,2,3,4", ["12", "330:12"][k / 9 % 2], k % 9)),
            plain,
            "line 11, column \"time\": \"330:12:00:00\" is no time; all rows must hold seconds, or all be written as",
        ),
        (
            "american.csv",
            table(HEADER, |k, _| format!("11/31/2026 12:00:0{},1,2,3,4", k % 10)),
            plain,
            "\"11/31/2026 12:00:00\" is no time",
        ),
        (
            "milliclock.csv",
            table("time [ms],beta,p,r,phi", |k, _| format!("12:00:0{},1,2,3,4", k % 10)),
            plain,
            "\"12:00:00\" is what a clock shows, but the heading states a unit; leave the unit out",
        ),
        (
            "swapped.csv",
            table(HEADER, |k, row| {
                if k == 90 {
                    "8.9,1,2,3,4".to_owned()
                } else if k == 89 {
                    "9,1,2,3,4".to_owned()
                } else {
                    row
                }
            }),
            plain,
            "line 92: time runs backwards by 0.1 s",
        ),
        ("repeated.csv", with_row("8.9,1,2,3,4"), plain, "line 92: time stands still"),
        (
            "late.csv",
            with_row("9.07,1,2,3,4"),
            plain,
            "line 92: time advances by 0.17 s, elsewhere by 0.1 s (likewise line 93); cut the record there, or interpolate it to equal steps with --resample PERIOD",
        ),
        (
            "notime.csv",
            with_row(",1,2,3,4"),
            plain,
            "line 92, column \"time\": the time is missing",
        ),
        ("gaps.csv", nan(3), plain, "its gaps leave no stretch of 50 samples, the longest has 2"),
        (
            "nothing.csv",
            nan(1),
            plain,
            "its gaps leave no stretch of 50 samples, the longest has 0",
        ),
        (
            "cut.csv.gz",
            cut(gzip(&good()), 60),
            plain,
            "the compressed file is damaged or truncated",
        ),
        (
            "junk.gz",
            [&b"\x1f\x8b"[..], &[7; 100]].concat(),
            plain,
            "the compressed file is damaged or truncated",
        ),
        (
            "packed.gz",
            gzip(&npy(&columns(), Array::default())),
            plain,
            "is zero, so this is no text",
        ),
    ]
}

fn arrays() -> Vec<Case> {
    let period: &[&str] = &["--sample-period", "0.1", "--outputs", "1,2,3"];
    let plain: &[&str] = &[];
    let good = || npy(&columns(), Array::default());
    let objects = || [header("|O", false, "(200,)"), vec![0; 1600]].concat();
    let five = |text: &str| text.as_bytes().to_vec();
    let mut hdf5 = five("MATLAB 7.3 MAT-file, Platform: GLNXA64");
    hdf5.resize(512, b' ');
    hdf5.extend(b"\x89HDF\r\n\x1a\n");
    let words = mat(Mat::V7, &[("title", 4, [1, 1], &[0.0]), ("notes", 1, [1, 1], &[0.0])]);
    let mut damaged = matlab(Mat::V6);
    damaged[136] = 0x0f;
    vec![
        ("objects.npy", objects(), period, "the numbers are of type \"|O\""),
        ("cut.npy", cut(good(), 90), period, "it is truncated; copy or save it again"),
        ("untimed.npy", good(), plain, "none of its columns (0, 1, 2, 3, 4) is called time"),
        (
            "named.npy",
            b"time,beta\n0,1\n".to_vec(),
            period,
            "this does not start as an NPY file does",
        ),
        (
            "cut.npz",
            cut(npz(|_, x| npy_vector(&x)), 50),
            plain,
            "the archive is damaged or truncated",
        ),
        (
            "nothing.npz",
            archive(&[("readme.txt", b"hello".to_vec())]),
            plain,
            "this is a ZIP archive without arrays",
        ),
        (
            "sheet.xlsx",
            archive(&[("xl/workbook.xml", b"<x/>".to_vec())]),
            plain,
            "this is a spreadsheet; export the sheet as CSV",
        ),
        (
            "lengths.npz",
            npz(|name, x| npy_vector(if name == "r" { &x[..150] } else { &x })),
            plain,
            "\"r\" has 150; the channels of a record must be equally long",
        ),
        (
            "objects.npz",
            npz(|name, x| if name == "r" { objects() } else { npy_vector(&x) }),
            &["--outputs", "beta,p,r"],
            "\"r\" cannot be used: the numbers are of type \"|O\"",
        ),
        (
            "infinite.npz",
            npz(|name, mut x| {
                if name == "p" {
                    x[7] = f64::INFINITY
                }
                npy_vector(&x)
            }),
            plain,
            "sample 7 (from 0), column p: inf is not a finite number",
        ),
        ("v73.mat", hdf5, plain, "the HDF5 file cannot be read"),
        (
            "v4.mat",
            [&[0; 4][..], &[200, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0, 0], &[1; 99]].concat(),
            plain,
            "MATLAB file of version 4",
        ),
        (
            "words.mat",
            words,
            plain,
            "holds no numeric vector or matrix (it holds cell array, text)",
        ),
        ("cut6.mat", cut(matlab(Mat::V6), 50), plain, "damaged or truncated at byte"),
        ("cut7.mat", cut(matlab(Mat::V7), 50), plain, "damaged or truncated at byte"),
        (
            "damaged.mat",
            damaged,
            plain,
            "damaged or truncated at byte 128: a variable does not start with its flags",
        ),
        (
            "short.mat",
            five("MATLAB 5.0 MAT-file"),
            plain,
            "damaged or truncated at byte 0: it ends there",
        ),
        (
            "text.mat",
            table(HEADER, |_, row| row),
            plain,
            "this is no MATLAB file, though it is called one",
        ),
        (
            "wide.mat",
            mat(Mat::V7, &[("x", 6, [2, 3], &[1.0; 6])]),
            plain,
            "the file holds no numeric vector or matrix",
        ),
        ("raw.f64", vec![1; 800], plain, "raw doubles say neither names nor times"),
        ("data.h5", b"\x89HDF\r\n\x1a\n".to_vec(), plain, "the HDF5 file cannot be read"),
        ("data.parquet", b"PAR1 and so on".to_vec(), plain, "built without Parquet"),
    ]
}

fn choices() -> Vec<Case> {
    vec![
        (
            "q.csv",
            good(),
            &["--outputs", "beta,p,q"],
            "q.csv has no column \"q\"; it has time, beta, p, r, phi",
        ),
        ("t.csv", good(), &["--time", "clock"], "t.csv has no column \"clock\""),
        ("twice.csv", good(), &["--outputs", "p,r,p"], "--outputs names \"p\" twice"),
        ("large.csv", good(), &["--decimate", "20"], "--decimate 20 needs more than"),
        (
            "huge.csv",
            good(),
            &["--decimate", "18446744073709551615"],
            "needs more than 18446744073709551615 samples",
        ),
        (
            "two.csv",
            good(),
            &["--outputs", "beta,p"],
            "2 records of 2 sensors, but 3 records are needed",
        ),
        (
            "other.csv",
            table(HEADER, |k, row| format!("{},{}", k * 2, row.split_once(',').unwrap().1)),
            &[],
            "is sampled every",
        ),
    ]
}

#[test]
fn the_written_list() {
    let cases = [texts(), arrays(), choices()].concat();
    assert!(cases.len() >= 60, "{}", cases.len());
    for (name, bytes, words, expected) in cases {
        let folder = Folder::new();
        let file = folder.file(name, bytes);
        let json = folder.path("modes.json");
        let good = shipped("noise_free_rudder.csv");
        let all = [&["identify", &file, &good, "--json", json.to_str().unwrap()], words].concat();
        transmode(&all).refused(expected);
        // Nothing half-written, the file as it was.
        assert_eq!(folder.names(), [name]);
    }
}

#[cfg(unix)]
#[test]
fn places_that_cannot_be_read_or_written() {
    use std::os::unix::fs::PermissionsExt;
    let good = ["noise_free_aileron.csv", "noise_free_rudder.csv"].map(shipped);
    let folder = Folder::new();
    transmode(&["identify", folder.path("").to_str().unwrap(), &good[0]]).refused("cannot read");
    transmode(&["identify", folder.path("no.csv").to_str().unwrap(), &good[0]])
        .refused("cannot read");
    // Nobody but the superuser reads a file without permissions.
    let locked = folder.file("locked.csv", b"time,a\n");
    std::fs::set_permissions(&locked, std::fs::Permissions::from_mode(0o000)).unwrap();
    if std::fs::File::open(&locked).is_err() {
        transmode(&["identify", &locked, &good[0]]).refused("cannot read");
    }
    let write = |command: &[&str], place: &str| transmode(&[command, &["--json", place]].concat());
    let identify = ["identify", &good[0], &good[1], "--outputs", "beta,p,r"];
    for command in [&identify[..], &["inspect", &good[0]]] {
        write(command, "/dev/full").refused("cannot write /dev/full");
        write(command, folder.path("no/x.json").to_str().unwrap()).refused("cannot write");
        write(command, &good[0]).refused("is the record itself");
    }
}
