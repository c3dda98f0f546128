//! Missing rows cost those rows: the modes stay, and only long gaps split a record.

use std::path::Path;

use serde_json::Value;
use transmode::Exit;

use crate::program::{Folder, transmode};

/// The lines of one of the shipped files.
fn lines(name: &str) -> Vec<String> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("data").join(name);
    std::fs::read_to_string(file).unwrap().lines().map(str::to_owned).collect()
}

fn pair(name: &str) -> [Vec<String>; 2] {
    ["aileron", "rudder"].map(|surface| lines(&name.replace('*', surface)))
}

fn identify(files: &[Vec<String>; 2], words: &[&str]) -> (Exit, Value) {
    let folder = Folder::new();
    let names = ["aileron.csv", "rudder.csv"];
    let files = [0, 1].map(|k| folder.file(names[k], files[k].join("\n") + "\n"));
    let ran = transmode(
        &[&["identify", &files[0], &files[1], "--outputs", "beta,p,r", "--json", "-"], words]
            .concat(),
    );
    assert_eq!(ran.err, "", "{words:?}");
    (ran.exit, serde_json::from_str(&ran.out).unwrap())
}

/// Without about one row in fifty, the same ones whenever it is asked.
fn with_losses(lines: &[String], seed: u64) -> (Vec<String>, usize) {
    let mut state = seed;
    let mut is_kept = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        !(state >> 33).is_multiple_of(50)
    };
    // Lost rows at an end make a record shorter.
    let last = lines.len() - 1;
    let kept: Vec<String> = lines
        .iter()
        .enumerate()
        .filter(|(row, _)| is_kept() || *row < 2 || *row == last)
        .map(|(_, line)| line.clone())
        .collect();
    let lost = lines.len() - kept.len();
    (kept, lost)
}

/// The modes with positive imaginary parts, of `value` in the z plane's image in 1/s.
fn modes(json: &Value) -> Vec<[f64; 4]> {
    let part = |mode: &Value, of: &str, part: &str| mode[of][part].as_f64().unwrap_or(0.0);
    let one = |mode: &Value| {
        [
            part(mode, "eigenvalue", "re"),
            part(mode, "eigenvalue", "im"),
            part(mode, "deviation", "re"),
            part(mode, "deviation", "im"),
        ]
    };
    json["modes"].as_array().unwrap().iter().map(one).collect()
}

/// Those of the complete records, each within so many of its standard errors, which grow: those of the Dutch roll
/// by up to 1.6.
fn agree(found: &Value, complete: &Value, deviations: f64) {
    let (found_modes, expected) = (modes(found), modes(complete));
    assert_eq!(found_modes.len(), expected.len(), "{:#}", found["modes"]);
    for ([re, im, re_deviation, im_deviation], [true_re, true_im, expected_deviation, _]) in
        found_modes.iter().zip(&expected)
    {
        assert!((re - true_re).abs() <= deviations * re_deviation, "{re} for {true_re}");
        assert!((im - true_im).abs() <= deviations * im_deviation, "{im} for {true_im}");
        let ratio = re_deviation / expected_deviation;
        assert!((0.8..1.8).contains(&ratio), "deviations {re_deviation}, {expected_deviation}");
    }
}

fn codes(json: &Value) -> Vec<&str> {
    let all = json["warnings"].as_array().unwrap();
    all.iter().map(|warning| warning["code"].as_str().unwrap()).collect()
}

fn bridged(json: &Value) -> Vec<u64> {
    let records = json["records"].as_array().unwrap();
    records.iter().map(|record| record["bridged_rows"].as_u64().unwrap()).collect()
}

#[test]
fn one_missing_row_costs_one_row() {
    let (exit, complete) = identify(&pair("field/04-complete-*.csv"), &[]);
    assert_eq!((exit, codes(&complete)), (Exit::Fine, Vec::new()));
    let (exit, found) = identify(&pair("field/04-one-row-missing-*.csv"), &[]);
    assert_eq!((exit, codes(&found)), (Exit::Fine, vec!["bridged", "bridged"]));
    assert_eq!(
        found["warnings"][0]["text"],
        "aileron.csv: 1 row in gaps of up to 1 is missing or incomplete, and taken as unknown inside one record (gaps longer than 0.3 s would split it, --bridge)"
    );
    assert_eq!(bridged(&found), [1, 1]);
    assert_eq!(found["records"][0]["samples"], complete["records"][0]["samples"]);
    agree(&found, &complete, 1.0);
}

#[test]
fn two_percent_of_the_rows_may_be_lost() {
    for name in [
        "records/white_snr100_*.csv",
        "records/white_snr10_*.csv",
        "records/multistep_snr100_*.csv",
        "field/04-complete-*.csv",
    ] {
        let files = pair(name);
        let (exit, complete) = identify(&files, &[]);
        assert_eq!(exit, Exit::Fine, "{name}: {:#}", complete["warnings"]);
        let [(aileron, first), (rudder, second)] =
            [with_losses(&files[0], 1), with_losses(&files[1], 2)];
        // Between one and four rows in a hundred.
        let hundredths = files[0].len() / 100;
        for lost in [first, second] {
            assert!((hundredths..4 * hundredths).contains(&lost), "{name}: {lost}");
        }
        let (exit, found) = identify(&[aileron, rudder], &[]);
        assert_eq!(exit, Exit::Fine, "{name}: {:#}", found["warnings"]);
        assert_eq!(bridged(&found), [first as u64, second as u64]);
        agree(&found, &complete, 2.0);
    }
}

#[test]
fn cells_of_one_sensor_may_be_missing() {
    let mut files = pair("records/white_snr100_*.csv");
    let (_, complete) = identify(&files, &[]);
    // time, beta, p, r
    for row in [50, 51, 300, 800, 1203] {
        let mut fields: Vec<&str> = files[0][row].split(',').collect();
        fields[2] = "NaN";
        files[0][row] = fields.join(",");
    }
    let (exit, found) = identify(&files, &[]);
    assert_eq!((exit, codes(&found)), (Exit::Fine, vec!["bridged"]));
    assert_eq!(bridged(&found), [5, 0]);
    agree(&found, &complete, 1.0);
}

#[test]
fn long_gaps_split_and_so_do_short_ones_on_demand() {
    let mut files = pair("field/04-complete-*.csv");
    files[0].drain(400..404);
    let (_, found) = identify(&files, &[]);
    assert_eq!(codes(&found)[0], "gaps");
    assert_eq!(bridged(&found), [0, 0, 0]);
    let (exit, found) = identify(&files, &["--bridge", "0.4"]);
    assert_eq!((exit, codes(&found)), (Exit::Fine, vec!["bridged"]));
    assert_eq!(bridged(&found), [4, 0]);
    let (_, found) = identify(&pair("field/04-one-row-missing-*.csv"), &["--bridge", "0"]);
    assert_eq!(codes(&found)[..2], ["gaps", "gaps"]);
    let ran = transmode(&["identify", "a.csv", "b.csv", "--bridge", "-1"]);
    assert_eq!(ran.exit, Exit::BadInput);
    assert!(ran.err.contains("the longest gap that is bridged is a number of seconds, 0 for none"));
}

#[test]
fn a_quiet_record_may_lose_rows() {
    let folder = Folder::new();
    let place = folder.path("gusts");
    let place = place.to_str().unwrap();
    let words =
        ["simulate", "paper", "--gust", "0.002", "--with-quiet", "--seed", "3", "-o", place];
    assert_eq!(transmode(&words).exit, Exit::Fine);
    let identify = |quiet: &str| {
        let files = ["aileron", "rudder"].map(|surface| format!("{place}/{surface}.csv"));
        let words = ["identify", &files[0], &files[1], "--noise-record", quiet, "--json", "-"];
        let ran = transmode(&words);
        assert_eq!(ran.err, "");
        serde_json::from_str::<Value>(&ran.out).unwrap()
    };
    let quiet = format!("{place}/quiet.csv");
    let complete = identify(&quiet);
    let text = std::fs::read_to_string(&quiet).unwrap();
    let lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let (kept, lost) = with_losses(&lines, 3);
    let found = identify(&folder.file("lossy.csv", kept.join("\n") + "\n"));
    assert_eq!(codes(&found).iter().filter(|code| **code == "bridged").count(), 1);
    assert!(!codes(&found).contains(&"longest-stretch"), "{:#}", found["warnings"]);
    let text = found["warnings"][0]["text"].as_str().unwrap();
    assert!(text.starts_with(&format!("lossy.csv: {lost} rows in gaps")), "{text}");
    agree(&found, &complete, 1.0);
}
