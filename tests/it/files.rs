//! One record in every kind of file gives the same modes; units, gaps, windows and decimation do what they say.

use serde_json::Value;
use transmode::Exit;

use crate::arrays::{Array, Mat, archive, gzip, mat, npy, npy_vector};
use crate::program::{Folder, shipped, transmode};

const NAMES: [&str; 4] = ["time", "beta", "p", "r"];

/// Columns time, beta, p, r of a shipped record.
fn columns(name: &str) -> [Vec<f64>; 4] {
    let text = std::fs::read_to_string(shipped(name)).unwrap();
    let mut columns = [const { Vec::new() }; 4];
    for line in text.lines().skip(1) {
        for (column, field) in columns.iter_mut().zip(line.split(',')) {
            column.push(field.parse::<f64>().unwrap());
        }
    }
    columns
}

fn pair() -> [[Vec<f64>; 4]; 2] {
    ["noise_free_aileron.csv", "noise_free_rudder.csv"].map(columns)
}

/// A table with these separators, numbers as `number` writes them.
fn table(
    columns: &[Vec<f64>],
    header: &str,
    separator: &str,
    number: impl Fn(f64) -> String,
) -> String {
    let row = |k: usize| {
        let fields: Vec<_> = columns.iter().map(|column| number(column[k])).collect();
        fields.join(separator) + "\n"
    };
    format!("{header}\n") + &(0..columns[0].len()).map(row).collect::<String>()
}

fn plain(number: f64) -> String {
    format!("{number:?}")
}

/// A table whose time is that of a clock, from a minute before midnight on: `stamp` writes the day, 0 or 1, and the time of day.
fn clocked(columns: &[Vec<f64>; 4], stamp: impl Fn(usize, &str) -> String) -> Vec<u8> {
    let row = |k: usize| {
        let tenths = 863_400 + k;
        let (day, second) = (tenths / 864_000, tenths % 864_000 / 10);
        let [hour, minute, second] = [second / 3600, second / 60 % 60, second % 60];
        let clock = format!("{hour:02}:{minute:02}:{second:02}.{}00", tenths % 10);
        let numbers = [1, 2, 3].map(|column| plain(columns[column][k]));
        format!("{},{}\n", stamp(day, &clock), numbers.join(","))
    };
    let rows: String = (0..columns[0].len()).map(row).collect();
    format!("time,beta,p,r\n{rows}").into_bytes()
}

/// Runs `identify` on two files and reads its JSON.
fn identify(files: &[String], words: &[&str]) -> (Exit, Value) {
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let ran = transmode(
        &[&["identify"], &files[..], words, &["--method", "as-printed", "--json", "-"]].concat(),
    );
    assert_eq!(ran.err, "", "{words:?}");
    (ran.exit, serde_json::from_str(&ran.out).unwrap())
}

/// Eigenvalues, the fastest first.
fn eigenvalues(json: &Value) -> Vec<[f64; 2]> {
    let part = |mode: &Value, part| mode["eigenvalue"][part].as_f64().unwrap();
    json["modes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|mode| [part(mode, "re"), part(mode, "im")])
        .collect()
}

fn expected() -> Vec<[f64; 2]> {
    let files = ["noise_free_aileron.csv", "noise_free_rudder.csv"].map(shipped);
    let (exit, json) = identify(&files, &["--outputs", "beta,p,r"]);
    assert_eq!((exit, json["modes"].as_array().unwrap().len()), (Exit::Fine, 3));
    eigenvalues(&json)
}

fn agree(found: &Value, tolerance: f64, what: &str) {
    let (found, expected) = (eigenvalues(found), expected());
    assert_eq!(found.len(), expected.len(), "{what}");
    for (a, b) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((a - b).abs() <= tolerance, "{what}: {a} {b}");
    }
}

/// Writes columns in a format.
type Make<'a> = &'a dyn Fn(&[Vec<f64>; 4]) -> Vec<u8>;

#[test]
fn one_record_is_the_same_in_every_format() {
    let [aileron, rudder] = pair();
    let csv = |c: &[Vec<f64>; 4]| table(c, "time,beta,p,r", ",", plain).into_bytes();
    let semicolons = |c: &[Vec<f64>; 4]| {
        let comma = |number: f64| plain(number).replace('.', ",");
        format!("\u{feff}% a comment\r\n{}", table(c, "time;beta;p;r", ";", comma)).into_bytes()
    };
    let tabs = |c: &[Vec<f64>; 4]| {
        table(c, "time\tbeta\tp\tr\ns\trad\trad/s\trad/s", "\t", plain).into_bytes()
    };
    let npz = |c: &[Vec<f64>; 4]| {
        let members: Vec<_> = NAMES
            .iter()
            .zip(c)
            .map(|(name, column)| (format!("{name}.npy"), npy_vector(column)))
            .collect();
        archive(
            &members.iter().map(|(name, bytes)| (name.as_str(), bytes.clone())).collect::<Vec<_>>(),
        )
    };
    let mats = |version, c: &[Vec<f64>; 4]| {
        let mut variables: Vec<_> =
            NAMES.iter().zip(c).map(|(name, x)| (*name, 6, [x.len(), 1], x.as_slice())).collect();
        variables.push(("dt", 6, [1, 1], &[0.1]));
        variables.push(("title", 4, [1, 2], &[0.0]));
        mat(version, &variables)
    };
    let makes: [(&str, Make<'_>); 10] = [
        ("csv", &csv),
        ("day.csv", &|c| {
            clocked(c, |day, clock| format!("{}T{clock}", ["2026-12-31", "2027-01-01"][day]))
        }),
        ("clock.csv", &|c| clocked(c, |_, clock| clock.to_owned())),
        ("txt", &semicolons),
        ("tsv", &tabs),
        ("csv.gz", &|c| gzip(&csv(c))),
        ("npz", &npz),
        ("v6.mat", &|c| mats(Mat::V6, c)),
        ("v7.mat", &|c| mats(Mat::V7, c)),
        // What it holds counts, not what it is called.
        ("dat", &npz),
    ];
    let folder = Folder::new();
    for (extension, make) in makes {
        let a = folder.file(&format!("a.{extension}"), make(&aileron));
        let b = folder.file(&format!("b.{extension}"), make(&rudder));
        let (exit, json) = identify(&[a, b], &["--outputs", "beta,p,r"]);
        assert_eq!(
            (exit, &json["sample_period_s"]),
            (Exit::Fine, &Value::from(0.1)),
            "{extension}"
        );
        agree(&json, 0.0, extension);
    }
    // An array has neither names nor times.
    let files = [("a.npy", &aileron), ("b.npy", &rudder)];
    let files = files.map(|(name, c)| folder.file(name, npy(&c[1..], Array::default())));
    let (exit, json) = identify(&files, &["--outputs", "0,1,2", "--sample-period", "0.1"]);
    assert_eq!(exit, Exit::Fine);
    agree(&json, 0.0, "npy");
}

#[test]
fn stated_units_are_converted() {
    let folder = Folder::new();
    let names = ["a.csv", "b.csv"];
    let files = std::array::from_fn::<_, 2, _>(|index| {
        let mut columns = pair()[index].clone();
        columns[0].iter_mut().for_each(|t| *t *= 1000.0);
        columns[1..3].iter_mut().flatten().for_each(|x| *x = x.to_degrees());
        folder.file(
            names[index],
            table(&columns, "time [ms],beta (deg),p [°/s],r [rad/s]", ",", plain),
        )
    });
    let (exit, json) = identify(&files, &["--outputs", "beta,p [°/s],r"]);
    assert_eq!((exit, &json["sample_period_s"]), (Exit::Fine, &Value::from(0.1)));
    agree(&json, 1e-9, "degrees");
    assert_eq!(json["transmissibilities"][0]["output"], "p");
}

#[test]
fn gaps_leave_the_stretches_between_them() {
    let [aileron, rudder] = pair();
    let folder = Folder::new();
    // Rows 20 to 29 are not there, row 1990 holds no beta.
    let mut gappy = aileron.clone();
    gappy[1][1990] = f64::NAN;
    gappy.iter_mut().for_each(|column| {
        column.drain(20..30);
    });
    let files = [
        folder.file("a.csv", table(&gappy, "time,beta,p,r", ",", plain)),
        folder.file("b.csv", table(&rudder, "time,beta,p,r", ",", plain)),
    ];
    let (_, json) = identify(&files, &["--outputs", "beta,p,r", "--bridge", "0"]);
    let records: Vec<_> = json["records"]
        .as_array()
        .unwrap()
        .iter()
        .map(|r| (r["file"].as_str().unwrap(), r["samples"].as_u64().unwrap()))
        .collect();
    assert_eq!(records, [("a.csv", 1960), ("b.csv", 2000)]);
    let text = |index: usize| json["warnings"][index]["text"].as_str().unwrap();
    assert_eq!(
        text(0),
        "gaps split a.csv into 3 stretches, which count as one record; the second starts at line 22"
    );
    assert_eq!(
        text(1),
        "2 stretches of a.csv between gaps, 29 samples in all, were left out: shorter than 50 samples"
    );
    agree(&json, 1e-8, "gaps");
}

#[test]
fn windows_are_records() {
    let [aileron, rudder] = pair();
    let folder = Folder::new();
    // One flight: the aileron moves in the first 200 s, the rudder in the next.
    let mut flight = aileron.clone();
    for (column, more) in flight.iter_mut().zip(&rudder) {
        column.extend(more);
    }
    flight[0] = (0..4000).map(|k| 50.0 + f64::from(k) / 10.0).collect();
    let file = folder.file("flight:1.csv", table(&flight, "time,beta,p,r", ",", plain));
    let windows = [format!("{file}:50:249.9"), format!("{file}:250:")];
    let (exit, json) =
        identify(&[], &["--window", &windows[0], "--window", &windows[1], "--outputs", "beta,p,r"]);
    assert_eq!(exit, Exit::Fine);
    assert_eq!(json["records"][0]["file"], "flight:1.csv:50:249.9");
    assert_eq!(json["records"][1]["samples"], 2000);
    agree(&json, 0.0, "windows");
}

#[test]
fn decimation_keeps_the_span_and_says_the_new_period() {
    let files = ["noise_free_aileron.csv", "noise_free_rudder.csv"].map(shipped);
    let (_, json) = identify(&files, &["--outputs", "beta,p,r", "--decimate", "2"]);
    assert_eq!(json["sample_period_s"], 0.2);
    // 2000 samples less 2 x 26 of the filter, every second.
    let samples = json["records"][0]["samples"].as_u64().unwrap();
    assert!((973..=976).contains(&samples), "{samples}");
}
