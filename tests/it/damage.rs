//! Whatever bytes a file holds, the program answers: with a table, or with one sentence, and never with a panic.
//!
//! Each reader gets bytes that are no file at all behind the start that makes the program choose it, and good files with bytes changed, left
//! out or cut off.

use std::path::Path;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use transmode::Exit;

use crate::arrays::{Array, Mat, archive, gzip, mat, npy, npy_vector};
use crate::program::{Folder, transmode};

/// Files for each reader and each way to break them; all readers together take a few seconds. The environment variable PROPTEST_CASES asks for more.
const CASES: u32 = 200;

const NAMES: [&str; 4] = ["time", "beta", "p", "r"];

fn columns() -> [Vec<f64>; 4] {
    let channel =
        |factor: u32| (0..60_u32).map(|k| f64::from(k * k * factor % 97) - 48.0).collect();
    [(0..60).map(|k| f64::from(k) / 10.0).collect(), channel(1), channel(3), channel(7)]
}

fn text(separator: &str) -> Vec<u8> {
    let columns = columns();
    let row = |k: usize| {
        columns.iter().map(|c| c[k].to_string()).collect::<Vec<_>>().join(separator) + "\n"
    };
    let header =
        format!("# a comment\n\"time\" [s]{separator}beta [deg]{separator}p{separator}r\n")
            .replace("\"time\" [s]", "\"time [s]\"");
    (header + &(0..60).map(row).collect::<String>()).into_bytes()
}

/// Every reader: what a file of it is called, what it starts with, and a good one.
fn readers() -> Vec<(&'static str, &'static [u8], Vec<u8>)> {
    let columns = columns();
    let vectors: Vec<_> = NAMES
        .iter()
        .zip(&columns)
        .map(|(name, x)| (*name, 6, [x.len(), 1], x.as_slice()))
        .collect();
    let members: Vec<_> = NAMES
        .iter()
        .zip(&columns)
        .map(|(name, x)| (format!("{name}.npy"), npy_vector(x)))
        .collect();
    let members: Vec<_> =
        members.iter().map(|(name, bytes)| (name.as_str(), bytes.clone())).collect();
    vec![
        ("x.csv", b"", text(",")),
        ("x.tsv", b"t\tb\n0\t", text("\t")),
        ("x.txt", b"t;b\n0;1\n", text(";")),
        ("x.gz", b"\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\xff", gzip(&text(","))),
        ("x.npy", b"\x93NUMPY\x01\x00", npy(&columns, Array::default())),
        ("x.npz", b"PK\x03\x04", archive(&members)),
        ("v6.mat", b"MATLAB 5.0 MAT-file", mat(Mat::V6, &vectors)),
        ("v7.mat", b"MATLAB 5.0 MAT-file", mat(Mat::V7, &vectors)),
        ("blanks.txt", b"t b p\n0 1 2\n", text(" ")),
        ("preamble.csv", b"sep=;\n", preamble()),
        ("x.lvm", b"LabVIEW Measurement\n", [b"LabVIEW Measurement\n", &preamble()[..]].concat()),
        ("structure-v6.mat", b"MATLAB 5.0 MAT-file", format("structure-v6.mat")),
        ("structure-v7.mat", b"MATLAB 5.0 MAT-file", format("structure-v7.mat")),
        ("structure-v73.mat", b"MATLAB 7.3 MAT-file", format("structure-v73.mat")),
        ("groups.h5", b"\x89HDF\r\n\x1a\n", format("groups.h5")),
        ("structured.npy", b"\x93NUMPY\x01\x00", format("structured.npy")),
        ("x.csv.zst", b"\x28\xb5\x2f\xfd", format("two-frames.csv.zst")),
    ]
}

/// A file in the format of another program.
fn format(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/formats");
    std::fs::read(folder.join(name)).unwrap()
}

/// A table below lines of other kinds.
fn preamble() -> Vec<u8> {
    let rows: String = (0..60)
        .map(|k| format!("{:.1};{};{},5\n", f64::from(k) / 10.0, k * k % 17, k % 5))
        .collect();
    format!(
        "\"log\" 7\nrate: 10\n\n# time;beta;p\n# s;deg;deg/s\n# ----\n{}",
        rows.replace('.', ",")
    )
    .into_bytes()
}

/// Runs `inspect` on these bytes: a result or a sentence.
fn answers(folder: &Folder, name: &str, bytes: &[u8]) -> Result<(), TestCaseError> {
    let file = folder.file(name, bytes);
    let period: &[&str] = if name.ends_with("npy") { &["--sample-period", "0.1"] } else { &[] };
    let ran = transmode(&[&["inspect", &file], period].concat());
    if ran.exit == Exit::BadInput {
        prop_assert!(ran.out.is_empty() && ran.err.starts_with("error: "), "{}", ran.err);
        prop_assert!(ran.err.len() < 20_000);
    } else {
        prop_assert!(ran.err.is_empty() && !ran.out.is_empty(), "{}", ran.err);
    }
    Ok(())
}

/// One change to a file: bytes replaced, left out, repeated or cut off, at a place given as a part of its length.
#[derive(Clone, Debug)]
enum Change {
    Replace(f64, u8),
    LeaveOut(f64, usize),
    Repeat(f64, usize),
    Cut(f64),
}

impl Change {
    fn strategy() -> impl Strategy<Value = Self> {
        // Half of all changes hit the first twentieth, where headers are.
        let place = || prop_oneof![0.0..0.05_f64, 0.0..1.0_f64];
        prop_oneof![
            4 => (place(), prop_oneof![any::<u8>(), Just(0), Just(0xff), Just(b'"'), Just(b',')]).prop_map(|(at, byte)| Self::Replace(at, byte)),
            1 => (place(), 1..16_usize).prop_map(|(at, count)| Self::LeaveOut(at, count)),
            1 => (place(), 1..16_usize).prop_map(|(at, count)| Self::Repeat(at, count)),
            1 => place().prop_map(Self::Cut),
        ]
    }

    fn apply(&self, bytes: &mut Vec<u8>) {
        #[expect(clippy::cast_possible_truncation, reason = "a place in a small file")]
        let place = |part: f64| (part * bytes.len() as f64) as usize;
        match *self {
            Self::Replace(at, byte) => {
                let at = place(at);
                bytes.iter_mut().skip(at).take(1).for_each(|place| *place = byte);
            }
            Self::LeaveOut(at, count) => {
                let at = place(at);
                bytes.drain(at..(at + count).min(bytes.len()));
            }
            Self::Repeat(at, count) => {
                let at = place(at);
                let piece = bytes[at..(at + count).min(bytes.len())].to_vec();
                bytes.splice(at..at, piece);
            }
            Self::Cut(at) => bytes.truncate(place(at)),
        }
    }
}

fn run<S: Strategy>(strategy: &S, test: impl Fn(S::Value) -> Result<(), TestCaseError>) {
    let mut config = Config { failure_persistence: None, ..Config::default() };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = CASES;
    }
    if let Err(error) = TestRunner::new(config).run(strategy, test) {
        panic!("{error}");
    }
}

#[test]
fn any_bytes_get_an_answer() {
    let folder = Folder::new();
    for (name, start, _) in readers() {
        run(&proptest::collection::vec(any::<u8>(), 0..600), |bytes| {
            answers(&folder, name, &[start, &bytes].concat())
        });
    }
    // Printable ones get further into a table.
    run(&"[-+0-9.,;eE\t\n\r\"#% a-c\\[\\]]{0,400}", |text| {
        answers(&folder, "x.csv", text.as_bytes())
    });
}

#[test]
fn damaged_files_get_an_answer() {
    let folder = Folder::new();
    for (name, _, good) in readers() {
        assert!(answers(&folder, name, &good).is_ok());
        run(&proptest::collection::vec(Change::strategy(), 1..4), |changes| {
            let mut bytes = good.clone();
            changes.iter().for_each(|change| change.apply(&mut bytes));
            answers(&folder, name, &bytes)
        });
    }
}
