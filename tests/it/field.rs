//! Files as loggers write them: each kind of peculiarity is read, and said.

mod variants;

use std::path::Path;

use serde_json::Value;
use transmode::Exit;

use crate::program::{Folder, transmode};

/// One of the files in `tests/data/field`.
fn field(name: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/field").join(name);
    file.to_str().unwrap().to_owned()
}

fn pair(name: &str) -> [String; 2] {
    ["aileron", "rudder"].map(|surface| field(&format!("{name}-{surface}.csv")))
}

fn identify(files: &[String; 2], words: &[&str]) -> (Exit, Value) {
    let files = [files[0].as_str(), files[1].as_str()];
    let ran = transmode(&[&["identify"], &files[..], words, &["--json", "-"]].concat());
    assert_eq!(ran.err, "", "{files:?} {words:?}");
    (ran.exit, serde_json::from_str(&ran.out).unwrap())
}

fn inspect(words: &[&str]) -> (Exit, Value) {
    let ran = transmode(&[&["inspect"], words, &["--json", "-"]].concat());
    assert_eq!(ran.err, "", "{words:?}");
    (ran.exit, serde_json::from_str(&ran.out).unwrap())
}

/// The modes of the aircraft, each within four of its standard errors and a percent of the Dutch roll's frequency.
fn has_the_modes(json: &Value) {
    let close = |re: f64, im: f64| {
        json["modes"].as_array().unwrap().iter().any(|mode| {
            let part = |of: &str, part: &str| mode[of][part].as_f64().unwrap_or(0.0);
            let error = |which: &str, truth: f64| {
                (part("eigenvalue", which) - truth).abs()
                    <= (4.0 * part("deviation", which)).clamp(1e-4, 0.05)
            };
            error("re", re) && error("im", im)
        })
    };
    for (re, im) in [(-0.03294, 0.94665), (-0.56265, 0.0)] {
        assert!(close(re, im), "{re} {im}: {:#}", json["modes"]);
    }
}

fn warning<'a>(json: &'a Value, code: &str) -> Option<&'a str> {
    let all = json["warnings"].as_array().unwrap();
    all.iter().find(|warning| warning["code"] == code).and_then(|found| found["text"].as_str())
}

fn finding<'a>(json: &'a Value, code: &str) -> Option<&'a str> {
    let all = json["files"][0]["findings"].as_array().unwrap();
    all.iter().find(|finding| finding["code"] == code).and_then(|found| found["text"].as_str())
}

#[test]
fn stamps_to_four_decimals() {
    let (exit, json) = identify(&pair("06-stamps-four-decimals"), &["--outputs", "beta,p,r"]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    let period = json["sample_period_s"].as_f64().unwrap();
    assert!((period * 30.0 - 1.0).abs() < 2e-6, "{period}");
    assert_eq!(json["records"][0]["clock"]["basis"], "rounded-stamps");
    has_the_modes(&json);
}

#[test]
fn stamps_to_a_millisecond() {
    let files = pair("07-ms-stamps-60hz");
    let (exit, json) = identify(&files, &["--outputs", "beta,p,r"]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    let period = json["sample_period_s"].as_f64().unwrap();
    assert!((period * 60.0 - 1.0).abs() < 2e-6, "{period}");
    let text = warning(&json, "clock").unwrap();
    assert!(
        text.contains("fitted to the time stamps") && text.contains("stamps rounded to 0.001 s"),
        "{text}"
    );
    let clock = &json["records"][1]["clock"];
    assert_eq!(clock["basis"], "rounded-stamps");
    let largest = clock["largest_deviation_s"].as_f64().unwrap();
    assert!((3e-4..6e-4).contains(&largest), "{largest}");
    has_the_modes(&json);
    // The same is said on the terminal, once for each file.
    let ran = transmode(&["identify", &files[0], &files[1], "--outputs", "beta,p,r"]);
    assert_eq!(ran.out.matches("note: 07-ms-stamps").count(), 2, "{}", ran.out);
    assert!(ran.out.contains("% of a period"), "{}", ran.out);
}

#[test]
fn stamps_in_whole_seconds() {
    let files = pair("07-whole-seconds");
    let (exit, json) = identify(&files, &["--outputs", "beta,p,r", "--sample-period", "0.1"]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    assert_eq!(json["sample_period_s"], 0.1);
    assert_eq!(json["records"][0]["clock"]["basis"], "sample-period");
    let text = warning(&json, "time-unused").unwrap();
    assert!(text.contains("column time is not used"), "{text}");
    has_the_modes(&json);
    // The rows of a second are taken to be even without it as well.
    let (exit, json) = identify(&files, &["--outputs", "beta,p,r"]);
    assert_eq!((exit, &json["sample_period_s"]), (Exit::Fine, &Value::from(0.1)));
    assert!(warning(&json, "clock").unwrap().contains("stamps rounded to 1 s"));
    has_the_modes(&json);
}

#[test]
fn array_indices_are_part_of_the_name() {
    let (exit, json) = identify(&pair("08-bracket-index"), &[]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    assert_eq!(json["channels"], serde_json::json!(["xyz[0]", "xyz[1]", "xyz[2]"]));
    has_the_modes(&json);
    let folder = Folder::new();
    let rows: String = (0..60).map(|k| format!("{k},{},{},1\n", k * k % 7, k * k % 5)).collect();
    let file =
        folder.file("x.csv", format!("t [s],gyroADC(0),gyroADC(1) [deg/s],ratio [1]\n{rows}"));
    let (_, json) = inspect(&[&file]);
    let channel = |index: usize| {
        let channel = &json["files"][0]["channels"][index];
        (channel["name"].as_str().unwrap().to_owned(), channel["unit"].as_str().map(str::to_owned))
    };
    assert_eq!(channel(0), ("gyroADC(0)".to_owned(), None));
    assert_eq!(channel(1), ("gyroADC(1)".to_owned(), Some("deg/s".to_owned())));
    assert_eq!(channel(2), ("ratio".to_owned(), Some("1".to_owned())));
}

#[test]
fn a_column_of_words_is_ignored() {
    let (exit, json) = inspect(&[&field("09-text-column.csv")]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["files"][0]["findings"]);
    assert_eq!(json["files"][0]["channels"].as_array().unwrap().len(), 3);
    assert_eq!(finding(&json, "not-read").unwrap(), "mode is ignored: it holds words (\"MANUAL\")");
    // identify says it too, and takes the others.
    let folder = Folder::new();
    let files = pair("08-bracket-index").map(|file| {
        let text = std::fs::read_to_string(&file).unwrap();
        let word = |(k, line): (usize, &str)| match k {
            0 => format!("{line},phase,event\n"),
            // The second column of words is empty for a long time.
            _ => format!("{line},cruise,{}\n", if k > 300 { "stick released" } else { "" }),
        };
        let name = Path::new(&file).file_name().unwrap().to_str().unwrap().to_owned();
        folder.file(&name, text.lines().enumerate().map(word).collect::<String>())
    });
    let (exit, json) = identify(&files, &[]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    assert!(warning(&json, "columns-ignored").unwrap().contains("phase, event"));
    has_the_modes(&json);
}

#[test]
fn an_unknown_unit_is_kept() {
    let (exit, json) = inspect(&[&field("09-unknown-unit.csv")]);
    // status never changes, which is a problem of its own.
    assert_eq!(exit, Exit::Doubtful);
    assert_eq!(json["files"][0]["channels"].as_array().unwrap().len(), 4);
    assert_eq!(json["files"][0]["channels"][3]["unit"], "flags");
    let text = finding(&json, "unit-unknown").unwrap();
    assert_eq!(
        text,
        "the unit \"flags\" of status is not known; its numbers are taken as they are"
    );
}

#[test]
fn blanks_and_titles() {
    for (name, first_row) in [("12-blanks.txt", 0.0), ("12-title-line.csv", 0.0)] {
        let (exit, json) = inspect(&[&field(name)]);
        assert_eq!(exit, Exit::Fine, "{name}: {:#}", json["files"][0]["findings"]);
        let names: Vec<_> = json["files"][0]["channels"]
            .as_array()
            .unwrap()
            .iter()
            .map(|channel| channel["name"].as_str().unwrap())
            .collect();
        assert_eq!(names, ["beta", "p", "r"], "{name}");
        assert_eq!(json["files"][0]["start_s"], first_row);
        assert_eq!(json["files"][0]["sample_period_s"], 0.1);
    }
}

#[test]
fn a_scaled_copy_is_named_and_left_out() {
    let files = pair("15-scaled-copy");
    let (exit, json) = inspect(&[&files[0]]);
    assert_eq!(exit, Exit::Doubtful);
    let text = finding(&json, "duplicate").unwrap();
    assert!(text.starts_with("beta_deg is 57.295") && text.contains("times beta;"), "{text}");
    let verdict = &json["files"][0]["channels"][3]["verdict"];
    assert_eq!((&verdict["is"], &verdict["of"]), (&Value::from("copy"), &Value::from("beta")));
    let (exit, json) = identify(&files, &[]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    assert_eq!(json["channels"], serde_json::json!(["beta", "p", "r"]));
    let text = warning(&json, "copy-left-out").unwrap();
    assert_eq!(text, "beta_deg is left out: it is 57.3 times beta");
    has_the_modes(&json);
    let words = ["identify", &files[0], &files[1], "--outputs", "beta,p,r,beta_deg"];
    transmode(&words).refused("\"beta_deg\" is 57.2958 times \"beta\" in all records");
}

/// The aileron and rudder records with their time as `stamp` writes it.
fn restamped(
    folder: &Folder,
    header: &str,
    stamp: impl Fn(usize, f64) -> Option<String>,
) -> [String; 2] {
    pair("08-bracket-index").map(|file| {
        let text = std::fs::read_to_string(&file).unwrap();
        let row = |(k, line): (usize, &str)| {
            let (time, rest) = line.split_once(',').unwrap();
            match k {
                0 => Some(format!("{header},beta,p,r\n")),
                _ => Some(format!("{},{rest}\n", stamp(k - 1, time.parse().unwrap())?)),
            }
        };
        let name = Path::new(&file).file_name().unwrap().to_str().unwrap().to_owned();
        folder.file(&name, text.lines().enumerate().filter_map(row).collect::<String>())
    })
}

/// A number in [0, 1) for each row.
fn scatter(k: usize) -> f64 {
    (k as f64 * 0.618_033_988_749_895 + (k * k % 101) as f64 / 101.0).fract()
}

#[test]
fn stamps_with_jitter() {
    let folder = Folder::new();
    let files = restamped(&folder, "time", |k, time| {
        Some(format!("{:.5}", time + 0.04 * (scatter(k) - 0.5)))
    });
    let (exit, json) = identify(&files, &["--outputs", "beta,p,r"]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    assert_eq!(json["records"][0]["clock"]["basis"], "scattered-stamps");
    let period = json["sample_period_s"].as_f64().unwrap();
    assert!((period / 0.1 - 1.0).abs() < 1e-4, "{period}");
    has_the_modes(&json);
}

#[test]
fn two_loggers_whose_clocks_differ() {
    let folder = Folder::new();
    let aileron = restamped(&folder, "time", |_, time| Some(format!("{time:.4}")))[0].clone();
    let other = Folder::new();
    let rudder = restamped(&other, "time", |_, time| Some(format!("{:.6}", 50.0 + 1.0004 * time)))
        [1]
    .clone();
    let (exit, json) = identify(&[aileron.clone(), rudder], &["--outputs", "beta,p,r"]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    let text = warning(&json, "clocks-differ").unwrap();
    assert!(text.contains("differ by a part of 0.0004"), "{text}");
    let period = json["sample_period_s"].as_f64().unwrap();
    assert!((0.1..0.10004).contains(&period), "{period}");
    has_the_modes(&json);
    // More than that is no drift.
    let rudder =
        restamped(&other, "time", |_, time| Some(format!("{:.6}", 1.01 * time)))[1].clone();
    transmode(&["identify", &aileron, &rudder, "--outputs", "beta,p,r"])
        .refused("resample one of them");
}

#[test]
fn uneven_samples_are_refused_and_resampled() {
    let folder = Folder::new();
    // Rows are left out at random: what is left has steps of one to many periods, and a few stamps are late.
    let files = restamped(&folder, "time", |k, time| {
        let late = if k % 7 == 3 { 0.045 } else { 0.0 };
        (k == 0 || scatter(k) > 0.25).then(|| format!("{:.3}", time + late))
    });
    let words = ["identify", &files[0], &files[1], "--outputs", "beta,p,r"];
    let ran = transmode(&words);
    if ran.exit == Exit::BadInput {
        assert!(ran.err.contains("--resample") || ran.err.contains("gaps"), "{}", ran.err);
    }
    let folder = Folder::new();
    // Samples of the same motion at other times: straight between the rows, as the motion is slow beside them.
    let files = ["aileron", "rudder"].map(|surface| {
        let text =
            std::fs::read_to_string(field(&format!("08-bracket-index-{surface}.csv"))).unwrap();
        let rows: Vec<Vec<f64>> = text
            .lines()
            .skip(1)
            .map(|line| line.split(',').map(|field| field.parse().unwrap()).collect())
            .collect();
        let mut out = "time,beta,p,r\n".to_owned();
        let mut time = 0.0;
        let mut k = 0;
        while time < rows.len() as f64 / 10.0 - 1.0 {
            let at = time * 10.0;
            #[expect(clippy::cast_possible_truncation, reason = "a row of a small file")]
            let row = at.floor() as usize;
            let part = at - at.floor();
            let value = |c: usize| rows[row][c] + part * (rows[row + 1][c] - rows[row][c]);
            out += &format!("{time:.6},{:e},{:e},{:e}\n", value(1), value(2), value(3));
            time += 0.05 * (0.4 + 1.6 * scatter(k));
            k += 1;
        }
        folder.file(&format!("uneven-{surface}.csv"), out)
    });
    transmode(&["identify", &files[0], &files[1], "--outputs", "beta,p,r"])
        .refused("--resample PERIOD");
    let (exit, json) = identify(&files, &["--outputs", "beta,p,r", "--resample", "0.2"]);
    assert_ne!(exit, Exit::BadInput);
    assert_eq!(json["sample_period_s"], 0.2);
    assert_eq!(json["records"][0]["clock"]["basis"], "resampled");
    assert!(warning(&json, "resampled").is_some());
    let dutch_roll = json["modes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|mode| mode["eigenvalue"]["im"].as_f64().unwrap())
        .fold(0.0, f64::max);
    assert!((dutch_roll / 0.94665 - 1.0).abs() < 0.02, "{dutch_roll}");
    // fit knows the same remedy.
    let fit = ["fit", &files[0], "--input", "beta", "--output", "p"];
    transmode(&fit).refused("--resample PERIOD");
    let ran = transmode(
        &[&fit[..], &["--resample", "0.2", "--causal", "5", "--anticausal", "5"]].concat(),
    );
    assert_ne!(ran.exit, Exit::BadInput, "{}", ran.err);
    assert!(ran.out.contains("every 0.2 s") && ran.out.contains("note: "), "{}", ran.out);
}

#[test]
fn clocks_that_are_odd_are_noted() {
    let folder = Folder::new();
    let whole = |factor: f64| move |_: usize, time: f64| Some(format!("{:.0}", time * factor));
    let (_, json) = identify(&restamped(&folder, "time", whole(1e3)), &["--outputs", "beta,p,r"]);
    let text = warning(&json, "clock-unit").unwrap();
    assert!(text.contains("states no unit") && text.ends_with("0.1 s if it is in ms"), "{text}");
    // Nanoseconds since 1970 can be nothing else.
    let epoch = |_: usize, time: f64| Some(format!("{:.0}", 1.7e18 + time * 1e9));
    let (exit, json) =
        identify(&restamped(&folder, "timestamp", epoch), &["--outputs", "beta,p,r"]);
    assert_eq!(exit, Exit::Fine, "{:#}", json["warnings"]);
    assert!(warning(&json, "clock-unit").unwrap().contains("taken to be in ns"));
    let period = json["sample_period_s"].as_f64().unwrap();
    assert!((period / 0.1 - 1.0).abs() < 1e-6, "{period}");
    has_the_modes(&json);
}

#[test]
fn headers_of_many_kinds() {
    let folder = Folder::new();
    let rows = |separator: &str| -> String {
        (0..60)
            .map(|k: u32| {
                let fields = [
                    0.1 * f64::from(k),
                    f64::from(k * k % 17),
                    f64::from(k * k % 23),
                    f64::from(k * k % 29),
                ];
                fields.map(|field| format!("{field:.1}")).join(separator) + "\n"
            })
            .collect()
    };
    let comma = |text: &str| text.replace('.', ",");
    let cases: Vec<(&str, String, &[&str])> = vec![
        ("sep.csv", format!("sep=;\ntime;beta;p;r\n{}", comma(&rows(";"))), &[]),
        ("excel.csv", format!("\"sep=;\"\r\ntime;beta;p;r\r\n{}", rows(";")), &[]),
        (
            "preamble.csv",
            format!(
                "Logger, X1\nRate, 10\nPilot, A. B.\nDate, 2026-11-26\n\ntime,beta,p,r\ns,deg,deg/s,deg/s\n{}",
                rows(",")
            ),
            &[],
        ),
        (
            "marks.dat",
            format!("# written by a tool\n# time beta p r\n# ---- ---- - -\n{}", rows("  ")),
            &[],
        ),
        ("percent.dat", format!("% time, beta, p, r\n{}", rows(" ")), &[]),
        ("unitmarks.dat", format!("#time beta p r\n#s deg deg/s deg/s\n{}", rows("\t ")), &[]),
        ("bare.csv", rows(","), &["--columns", "time,beta,p,r"]),
        ("bare.txt", rows(" "), &["--columns", "time, beta, p, r"]),
        ("renamed.csv", format!("a,b,c,d\n{}", rows(",")), &["--columns", "time,beta,p,r"]),
        (
            "skipped.csv",
            format!("time,beta,p,r\nx,y,z,w\n\"never closed\ntime,beta,p,r\n{}", rows(",")),
            &["--skip-lines", "3"],
        ),
        ("trailing.csv", format!("time,beta,p,r\n{}", rows(",").replace('\n', ",\n")), &[]),
        (
            "labview.lvm",
            format!(
                "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\n\nChannels\t3\n***End_of_Header***\t\t\nX_Value\tbeta\tp\tr\tComment\n{}",
                rows("\t").replace('\n', "\t\n")
            ),
            &[],
        ),
    ];
    for (name, text, words) in cases {
        let file = folder.file(name, text);
        let (_, json) = inspect(&[&[file.as_str()], words].concat());
        let found = &json["files"][0];
        let names: Vec<_> = found["channels"]
            .as_array()
            .unwrap()
            .iter()
            .map(|channel| channel["name"].as_str().unwrap())
            .filter(|name| *name != "Comment")
            .collect();
        assert_eq!(names, ["beta", "p", "r"], "{name}");
        assert_eq!((&found["samples"], &found["time"]), (&60.into(), &"time".into()), "{name}");
        let period = found["sample_period_s"].as_f64().unwrap();
        assert!((period - 0.1).abs() < 1e-9, "{name}: {period}");
        let largest = found["channels"][1]["max"].as_f64().unwrap();
        let degrees = if name.starts_with("preamble") || name.starts_with("unit") {
            1_f64.to_radians()
        } else {
            1.0
        };
        assert!((largest - 18.0 * degrees).abs() < 1e-9, "{name}: {largest}");
    }
    let bare = folder.file("unnamed.csv", format!("7 lines\nof words\n{}", rows(",")));
    transmode(&["inspect", &bare]).refused("--columns");
    let words = ["inspect", &bare, "--columns", "time,beta"];
    transmode(&words).refused("4 fields, but --columns names 2");
}

#[test]
fn words_for_missing_numbers() {
    let folder = Folder::new();
    let words = [
        "NA",
        "N/A",
        "null",
        "None",
        "-nan(ind)",
        "1.#QNAN",
        "NaN",
        "",
        "-1.#IND",
        "#N/A",
        "--",
        "nan",
    ];
    let rows: String = (0..60_usize)
        .map(|k| {
            format!("{:.1},{},{}\n", 0.1 * k as f64, k * k % 17, words.get(k).unwrap_or(&"1.5"))
        })
        .collect();
    let file = folder.file("na.csv", format!("time,beta,p\n{rows}"));
    let (_, json) = inspect(&[&file]);
    assert_eq!(json["files"][0]["channels"][1]["missing"], words.len());
    assert!(finding(&json, "not-read").is_none());
}
