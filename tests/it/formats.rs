//! Files of other programs: structures, groups, matrices of rows, compressed text.

use std::path::Path;

use serde_json::Value;
use transmode::Exit;

use crate::program::{Folder, transmode};

fn file(name: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/formats").join(name);
    file.to_str().unwrap().to_owned()
}

fn inspect(words: &[&str]) -> Value {
    let ran = transmode(&[&["inspect"], words, &["--json", "-"]].concat());
    assert_eq!(ran.err, "", "{words:?}");
    let json: Value = serde_json::from_str(&ran.out).unwrap();
    json["files"][0].clone()
}

/// Name, smallest and largest number of each channel.
fn channels(file: &Value) -> Vec<(String, f64, f64)> {
    let number = |channel: &Value, what: &str| channel[what].as_f64().unwrap();
    let channel = |channel: &Value| {
        let name = channel["name"].as_str().unwrap().to_owned();
        (name, number(channel, "min"), number(channel, "max"))
    };
    file["channels"].as_array().unwrap().iter().map(channel).collect()
}

/// The channel has the numbers of this one of the record, by its extremes.
fn is_called(found: &[(String, f64, f64)], name: &str, values: impl Fn(f64) -> f64) {
    let channel = found.iter().find(|channel| channel.0 == name);
    let (_, low, high) = channel.unwrap_or_else(|| panic!("no {name} in {found:?}"));
    let all = || (0..120).map(|k| values(f64::from(k)));
    let expected = [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)];
    for (found, expected) in [low, high].into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{name}: {found} {expected}");
    }
}

fn p(k: f64) -> f64 {
    k * k % 97.0 - 48.0
}

fn r(k: f64) -> f64 {
    k * k * 3.0 % 89.0 - 44.0
}

#[test]
fn structures_of_matlab() {
    for name in ["structure-v6.mat", "structure-v7.mat", "structure-v73.mat"] {
        let whole = inspect(&[&file(name), "--variable", "log"]);
        assert_eq!((&whole["time"], &whole["samples"]), (&"time".into(), &120.into()), "{name}");
        assert_eq!(whole["sample_period_s"], 0.1, "{name}");
        let found = channels(&whole);
        is_called(&found, "imu.p", p);
        is_called(&found, "imu.r", r);
        is_called(&found, "xyz_1", p);
        is_called(&found, "xyz_3", |k| p(k) - r(k));
        is_called(&found, "count", |k| k);
        // What is text is said, and no channel.
        let others = whole["other_columns"].as_array().unwrap();
        let text = others.iter().find(|other| other["name"] == "imu.name");
        assert_eq!(text.unwrap()["verdict"]["is"], "not-read", "{name}: {others:?}");
        let words = [&file(name), "--variable", "log.imu", "--sample-period", "0.1"];
        is_called(&channels(&inspect(&words)), "p", p);
        let words = ["inspect", &file(name), "--variable", "log.gps"];
        transmode(&words).refused("has no variable \"log.gps\"; it has ");
    }
}

#[test]
fn matrices_of_rows() {
    for (name, first) in [("rows.mat", 1), ("rows.npz", 0)] {
        let found = inspect(&[&file(name)]);
        assert_eq!((&found["time"], &found["samples"]), (&"time".into(), &120.into()), "{name}");
        let found = channels(&found);
        is_called(&found, &format!("x_{first}"), p);
        is_called(&found, &format!("x_{}", first + 1), r);
    }
    // Whole numbers beside floats count or flag something, and are a channel where they are asked for.
    let names = |file: &Value| channels(file).into_iter().map(|found| found.0).collect::<Vec<_>>();
    let npz = file("rows.npz");
    assert_eq!(names(&inspect(&[&npz])), ["x_0", "x_1", "x_2"]);
    assert_eq!(names(&inspect(&[&npz, "--outputs", "x_0,n"])), ["x_0", "n"]);
}

#[test]
fn groups_and_tables_of_hdf5() {
    let whole = inspect(&[&file("groups.h5")]);
    assert_eq!((&whole["format"], &whole["time"]), (&"hdf5".into(), &"time".into()));
    let found = channels(&whole);
    is_called(&found, "imu.p", p);
    is_called(&found, "imu.r", r);
    is_called(&found, "xyz_0", p);
    is_called(&found, "xyz_2", |k| p(k) - r(k));
    is_called(&found, "on", |k| f64::from(k % 2.0 < 0.5));
    is_called(&found, "table.a", |k| k);
    is_called(&found, "table.b", p);
    let found = inspect(&[&file("groups.h5"), "--variable", "/log/imu", "--sample-period", "0.1"]);
    is_called(&channels(&found), "r", r);
    // fit reads the same.
    let ran = transmode(&[
        "fit",
        &file("groups.h5"),
        "--input",
        "imu.p",
        "--output",
        "imu.r",
        "--iir",
        "1",
        "--causal",
        "2",
        "--anticausal",
        "2",
    ]);
    assert_ne!(ran.exit, Exit::BadInput, "{}", ran.err);
    assert!(ran.out.contains("120 samples, every 0.1 s"), "{}", ran.out);
}

#[test]
fn structured_arrays_of_numpy() {
    for name in ["structured.npy", "structured.npz"] {
        let whole = inspect(&[&file(name)]);
        assert_eq!((&whole["time"], &whole["samples"]), (&"time".into(), &120.into()), "{name}");
        let found = channels(&whole);
        assert_eq!(found.len(), 5);
        is_called(&found, "p", p);
        is_called(&found, "xyz_1", r);
        is_called(&found, "n", |k| k);
    }
}

#[test]
fn text_compressed_with_zstandard() {
    let whole = inspect(&[&file("two-frames.csv.zst")]);
    assert_eq!((&whole["format"], &whole["samples"]), (&"csv.zst".into(), &120.into()));
    is_called(&channels(&whole), "r", r);
    let folder = Folder::new();
    let mut bytes = std::fs::read(file("two-frames.csv.zst")).unwrap();
    bytes.truncate(bytes.len() - 20);
    transmode(&["inspect", &folder.file("cut.csv.zst", &bytes)])
        .refused("the compressed file is damaged or truncated");
}

#[test]
fn formats_that_are_not_read_are_named() {
    let folder = Folder::new();
    for (name, start, words) in [
        (
            "log.ulg",
            &b"ULog\x01\x12\x35\x01and so on"[..],
            "PX4 flight log (ULog); convert it with ulog2csv",
        ),
        (
            "run.tdms",
            b"TDSm\x0e\0\0\0",
            "National Instruments file (TDMS); export it as CSV or LVM",
        ),
        ("run.mf4", b"MDF     4.10    ", "measurement data file (MDF); export it as CSV"),
    ] {
        transmode(&["inspect", &folder.file(name, start)]).refused(words);
    }
}
