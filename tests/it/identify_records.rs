//! `transmode identify` on flights made for one question each: two excitations, gaps, measured inputs, a quiet record, decimation, a file of options.

use serde_json::Value;
use transmode::Exit;

use crate::flights::{AILERON, Flight, LEVELS, QUIET, RUDDER, table};
use crate::identify_numbers::valid;
use crate::program::{Folder, Ran, transmode};

/// The eigenvalues, the fastest first: tests/data/reference.json /aircraft/spec_A.
const MODES: [(f64, f64); 3] =
    [(-0.070_594_067, 1.691_678_362), (-0.545_562_846, 0.0), (-0.001_563_638, 0.0)];

fn identify(words: &[&str]) -> (Ran, Value) {
    let ran = transmode(&[&["identify"], words, &["--json", "-"]].concat());
    assert_eq!(ran.err, "", "{words:?}");
    let json: Value = serde_json::from_str(&ran.out).unwrap();
    valid(&json);
    (ran, json)
}

fn codes(json: &Value) -> Vec<&str> {
    json["warnings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|warning| warning["code"].as_str().unwrap())
        .collect()
}

/// Every part of every eigenvalue is within five of its deviations.
fn near_the_truth(json: &Value) {
    assert_eq!(json["order"], 4);
    for (mode, (re, im)) in json["modes"].as_array().unwrap().iter().zip(MODES) {
        for (part, expected) in [("re", re), ("im", im)] {
            let found = mode["eigenvalue"][part].as_f64().unwrap();
            let deviation = mode["deviation"][part].as_f64().unwrap();
            assert!(
                (found - expected).abs() <= 5.0 * deviation + 1e-9,
                "{}: {part} {found} +- {deviation}, {expected} is true",
                mode["name"]
            );
            assert!(deviation < 0.05, "{mode}");
        }
    }
}

#[test]
fn two_excitations_at_once_are_told() {
    let folder = Folder::new();
    let both = Flight { moved: [1.0, 1.0], ..AILERON };
    let files = [folder.file("both.csv", both.csv()), folder.file("rudder.csv", RUDDER.csv())];
    for method in ["ml", "subspace"] {
        let words = [&files[0], &files[1], "--outputs", "beta,p,r", "--method", method];
        let (ran, json) = identify(&words);
        assert_eq!(ran.exit, Exit::Doubtful);
        assert!(codes(&json).contains(&"several-excitations"), "{method}: {}", json["warnings"]);
        assert_eq!(json["records"][0]["excitation_rank"], 2);
        assert_eq!(json["records"][1]["excitation_rank"], 1);
        let ran = transmode(&[&["identify"], &words[..]].concat());
        assert_eq!(ran.exit, Exit::Doubtful);
        for text in [
            "both.csv, 1500 samples, every 0.1 s, at least 2 excitations",
            "warning: record both.csv: the signal's rank grows",
        ] {
            assert!(ran.out.contains(text), "{text} is missing in\n{}", ran.out);
        }
    }
    // The control: one at a time is fine.
    let aileron = folder.file("aileron.csv", AILERON.csv());
    let (ran, json) = identify(&[&aileron, &files[1], "--outputs", "beta,p,r"]);
    assert_eq!((ran.exit, codes(&json)), (Exit::Fine, Vec::new()));
    near_the_truth(&json);
}

/// Without the rows 700 to 719.
fn with_gap(flight: Flight) -> String {
    let mut columns = flight.columns();
    columns.iter_mut().for_each(|column| {
        column.drain(700..720);
    });
    table("time,beta,p,r,aileron,rudder", &columns)
}

#[test]
fn stretches_between_gaps_share_their_excitation() {
    let folder = Folder::new();
    let gappy = folder.file("gappy.csv", with_gap(AILERON));
    let rudder = folder.file("rudder.csv", RUDDER.csv());
    for method in ["ml", "subspace"] {
        let words = [&gappy, &rudder, "--outputs", "beta,p,r", "--method", method];
        let (ran, json) = identify(&words);
        // They are told apart from records that were excited alike: nobody is warned.
        assert_eq!((ran.exit, codes(&json)), (Exit::Fine, vec!["gaps"]), "{}", json["warnings"]);
        assert_eq!(json["records"].as_array().unwrap().len(), 3);
        if method == "ml" {
            near_the_truth(&json);
        }
    }
    // Alone they are one record.
    for method in ["ml", "subspace", "as-printed"] {
        let words = ["identify", &gappy, "--outputs", "beta,p,r", "--method", method];
        transmode(&words).refused(
            "1 record of 3 sensors, but 2 records are needed, each with an excitation of its own; the stretches between the gaps of \
             gappy.csv count as one",
        );
    }
    // Two sensors need three records, and three pieces of two are not three.
    transmode(&["identify", &gappy, &rudder, "--outputs", "beta,p"])
        .refused("2 records of 2 sensors, but 3 records are needed");
}

#[test]
fn two_records_that_were_excited_alike_are_told() {
    let folder = Folder::new();
    let again = Flight { seed: 9, ..AILERON };
    let files = [folder.file("one.csv", AILERON.csv()), folder.file("two.csv", again.csv())];
    let (ran, json) = identify(&[&files[0], &files[1], "--outputs", "beta,p,r"]);
    assert_eq!(ran.exit, Exit::Doubtful);
    for code in ["same-excitation", "same-direction"] {
        assert!(codes(&json).contains(&code), "{}", json["warnings"]);
    }
}

#[test]
fn the_printed_method_takes_the_longest_stretch() {
    let folder = Folder::new();
    let still = [0.0; 3];
    let gappy = folder.file("gappy.csv", with_gap(Flight { levels: still, ..AILERON }));
    let rudder = folder.file("rudder.csv", Flight { levels: still, ..RUDDER }.csv());
    let words = [&gappy, &rudder, "--outputs", "beta,p,r", "--method", "as-printed"];
    let (ran, json) = identify(&words);
    assert_eq!((ran.exit, codes(&json)), (Exit::Fine, vec!["gaps", "longest-stretch"]));
    assert_eq!(json["records"][0]["file"], "gappy.csv#2");
    assert_eq!(json["records"][0]["samples"], 780);
    assert_eq!(json["order"], 4);
}

/// Doublets, fifty samples a second: the gap behind three states is the largest by far, and four are there.
#[test]
fn the_likelihood_decides_where_the_gaps_leave_the_order_open() {
    let folder = Folder::new();
    let place = folder.path("flights");
    let words = ["--excitation", "doublet", "--sample-period", "0.02", "--noise", "snr=30"];
    let more = ["--duration", "60", "--seed", "3", "-o", place.to_str().unwrap()];
    let ran = transmode(&[&["simulate", "paper"], &words[..], &more].concat());
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    let files = ["aileron.csv", "rudder.csv"].map(|name| place.join(name));
    let [aileron, rudder] = files.each_ref().map(|file| file.to_str().unwrap());
    let (ran, json) = identify(&[aileron, rudder]);
    assert_eq!((ran.exit, codes(&json)), (Exit::Fine, vec![]), "{}", json["warnings"]);
    near_the_truth(&json);
    let text = transmode(&["identify", aileron, rudder]).out;
    let line = text.lines().find(|line| line.starts_with("order: 4, by a gap of 10 ")).unwrap();
    assert!(line.contains("(next are 200 for 3,") && line.contains(", and e^"), "{line}");
    assert!(line.contains(" times more likely than 3"), "{line}");
}

/// Noise of a third of the response, a minute long: one of two states alternates from sample to sample.
#[test]
fn a_state_that_alternates_has_no_name_and_is_one_state() {
    let folder = Folder::new();
    let (place, report) = (folder.path("flights"), folder.path("report"));
    let words = ["--noise", "snr=3", "--duration", "60", "--seed", "2", "-o"];
    transmode(&[&["simulate", "paper"], &words[..], &[place.to_str().unwrap()]].concat());
    let files = ["aileron.csv", "rudder.csv"].map(|name| place.join(name));
    let [aileron, rudder] = files.each_ref().map(|file| file.to_str().unwrap());
    let zero = ["--white-noise", "--offsets", "zero"];
    let words = [&[aileron, rudder], &zero[..], &["--report", report.to_str().unwrap()]].concat();
    let (_, json) = identify(&words);
    let mode = &json["modes"][0];
    assert_eq!((&mode["name"], &json["order"]), (&"unnamed".into(), &2.into()), "{mode}");
    assert!(
        (mode["eigenvalue"]["im"].as_f64().unwrap() - 10.0 * std::f64::consts::PI).abs() < 1e-9
    );
    let page = std::fs::read_to_string(report.join("report.html")).unwrap();
    assert!(page.contains("2 modes with 2 states"));
}

#[test]
fn windows_that_are_not_what_they_seem_are_told() {
    let [aileron, rudder] =
        ["white_snr100_aileron.csv", "white_snr100_rudder.csv"].map(crate::program::shipped);
    let windows = [format!("{aileron}::120"), format!("{aileron}:80:600"), format!("{rudder}:0:")];
    let words = windows.iter().flat_map(|window| ["--window", window]);
    let (_, json) = identify(&words.collect::<Vec<_>>());
    assert_eq!(codes(&json)[..2], ["window-cut", "windows-overlap"]);
    let text = |index: usize| json["warnings"][index]["text"].as_str().unwrap().to_owned();
    assert!(text(0).ends_with("what the file has of it: from 80 s to 199.9 s"), "{}", text(0));
    let both = "white_snr100_aileron.csv::120 and white_snr100_aileron.csv:80:600 overlap";
    assert!(text(1).starts_with(both), "{}", text(1));
    // Ends within a step of the file's are meant to be the file's.
    let words = ["--window", &format!("{aileron}:0:200"), &rudder];
    assert_eq!(codes(&identify(&words).1), [""; 0]);
}

/// In the first flight a yaw damper moves the rudder, too, and what it does is measured; in the second it rests.
#[test]
fn a_measured_input_is_no_second_excitation() {
    let folder = Folder::new();
    let header = "time,beta,p,r,damper";
    let damped = Flight { moved: [1.0, 0.3], ..AILERON }.columns();
    let [time, beta, p, r, _, damper] = damped;
    let damped = folder.file("damped.csv", table(header, &[time, beta, p, r, damper]));
    let [time, beta, p, r, none, _] = RUDDER.columns();
    let rudder = folder.file("rudder.csv", table(header, &[time, beta, p, r, none]));

    // By itself it explains hardly anything, so that something else must have moved the aircraft as well.
    let (ran, json) = identify(&[&damped, &rudder, "--inputs", "damper"]);
    assert_eq!((ran.exit, codes(&json)), (Exit::Fine, vec!["idle-input"]), "{}", json["warnings"]);
    assert_eq!(json["method"], "ml");
    near_the_truth(&json);
    let (ran, json) =
        identify(&[&damped, &rudder, "--known-input", "damper", "--unknown-excitation", "yes"]);
    assert_eq!((ran.exit, codes(&json)), (Exit::Fine, vec!["idle-input"]), "{}", json["warnings"]);
    // By default the other columns are the sensors.
    assert_eq!(json["noise"].as_array().unwrap().len(), 3);
    near_the_truth(&json);
    // The control: as an unknown input it is one too many.
    let words = [&damped, &rudder, "--outputs", "beta,p,r", "--method", "subspace"];
    let (ran, json) = identify(&words);
    assert_eq!(ran.exit, Exit::Doubtful);
    assert_eq!(json["records"][0]["excitation_rank"], 2);
}

#[test]
fn measured_inputs_keep_step_with_gaps_and_windows() {
    let folder = Folder::new();
    let flight = Flight { moved: [1.0, 0.3], ..AILERON };
    let gappy = folder.file("gappy.csv", with_gap(flight));
    let other = folder.file("other.csv", Flight { seed: 7, moved: [0.2, 1.0], ..AILERON }.csv());
    let window = format!("{other}:5:");
    // The first flight's rudder and the second one's aileron are neither known, so that both need the other's column.
    let words = [
        &gappy,
        "--window",
        &window,
        "--outputs",
        "beta,p,r",
        "--known-input",
        "aileron",
        "--known-input",
        "rudder",
    ];
    let (_, json) = identify(&words);
    let samples: Vec<_> =
        json["records"].as_array().unwrap().iter().map(|r| r["samples"].clone()).collect();
    assert_eq!(samples, [700, 780, 1450]);
}

#[test]
fn a_quiet_record_gives_the_noise() {
    let folder = Folder::new();
    let aileron = folder.file("aileron.csv", AILERON.csv());
    let rudder = folder.file("rudder.csv", RUDDER.csv());
    let quiet = folder.file("quiet.csv", QUIET.csv());
    let words = [&aileron, &rudder, "--outputs", "beta,p,r", "--noise-record"];
    let (ran, json) = identify(&[&words[..], &[&quiet]].concat());
    assert_eq!(ran.exit, Exit::Fine, "{}", json["warnings"]);
    assert_eq!(json["noise_origin"], "quiet-record");
    assert!(json["noise"].as_array().unwrap().is_empty());
    let p_value = json["goodness"]["p_value"].as_f64().unwrap();
    assert!(p_value > 1e-3, "{p_value}");
    near_the_truth(&json);

    // A stretch of a record's own file will do, if the record leaves it out.
    let mut calm_first = QUIET.columns();
    for (column, more) in calm_first.iter_mut().zip(AILERON.columns()) {
        column.extend(more);
    }
    calm_first[0] = (0..3000).map(|k| f64::from(k) * 0.1).collect();
    let file = folder.file("long.csv", table("time,beta,p,r,aileron,rudder", &calm_first));
    let [moved, calm] = [format!("{file}:150:"), format!("{file}:0:149.9")];
    let rudder = format!("{rudder}::");
    let words =
        ["--window", &moved, "--window", &rudder, "--outputs", "beta,p,r", "--noise-record", &calm];
    let (_, again) = identify(&words);
    assert_eq!(again["modes"], json["modes"]);
}

#[test]
fn decimation_leaves_out_what_its_filter_stops() {
    let folder = Folder::new();
    let fast = |flight: Flight| Flight { period_s: 0.025, samples: 6000, ..flight }.csv();
    let files = [folder.file("a.csv", fast(AILERON)), folder.file("r.csv", fast(RUDDER))];
    let words = [&files[0], &files[1], "--outputs", "beta,p,r", "--decimate", "4"];
    let (_, json) = identify(&words);
    let edge = json["band_rad_s"][1].as_f64().unwrap();
    assert!((edge - 0.8 * std::f64::consts::PI / 0.1).abs() < 1e-9, "{edge}");
    assert_eq!(json["sample_period_s"], 0.1);
    let (_, json) = identify(&[&words[..], &["--band", "0:10"]].concat());
    assert_eq!(json["band_rad_s"][1], 10.0);
    let (_, json) = identify(&[&words[..], &["--method", "subspace"]].concat());
    assert!(json["band_rad_s"].is_null());
}

#[test]
fn options_from_a_file() {
    let folder = Folder::new();
    folder.file("aileron.csv", AILERON.csv());
    folder.file("rudder.csv", RUDDER.csv());
    let levels = LEVELS.map(|level| level.to_string()).join(", ");
    let text = format!(
        "# Two flights.\nfiles = [\"aileron.csv\", \"rudder.csv\"]\noutputs = [\"beta\", \"p\", \"r\"]\nnoise = [{levels}]\norder = 4\n"
    );
    let config = folder.file("run.toml", text);
    let (ran, json) = identify(&["--config", &config]);
    assert_eq!((ran.exit, &json["noise_origin"]), (Exit::Fine, &Value::from("given")));
    near_the_truth(&json);
    let files = ["aileron.csv", "rudder.csv"].map(|name| folder.path(name));
    let [aileron, rudder] = files.each_ref().map(|file| file.to_str().unwrap());
    let noise = levels.replace(' ', "");
    let words = [aileron, rudder, "--outputs", "beta,p,r", "--noise", &noise, "--order", "4"];
    assert_eq!(identify(&words).1, json);
    // The command line wins.
    let (_, json) = identify(&["--config", &config, "--method", "subspace", "--order", "auto"]);
    assert_eq!(
        (&json["method"], &json["order_evidence"]["asked"]),
        (&"subspace".into(), &false.into())
    );
}

#[test]
fn levels_need_a_class_and_a_phase() {
    let folder = Folder::new();
    let files = [folder.file("a.csv", AILERON.csv()), folder.file("r.csv", RUDDER.csv())];
    let words = [&files[0], &files[1], "--outputs", "beta,p,r"];
    let (_, json) = identify(&words);
    assert!(json["modes"][0]["level"].is_null());
    let flight = ["--aircraft-class", "III", "--flight-phase", "B"];
    let (_, json) = identify(&[&words[..], &flight].concat());
    // A damping ratio of 0.04 misses the 0.08 of Level 1; a roll mode of 1.8 s misses 1.4 s.
    let levels: Vec<_> =
        json["modes"].as_array().unwrap().iter().map(|mode| mode["level"].clone()).collect();
    assert_eq!(levels, ["2", "2", "1"]);
    let ran = transmode(&[&["identify"], &words[..], &flight].concat());
    assert!(ran.out.contains("level"), "{}", ran.out);
}

#[test]
fn units_are_said() {
    let folder = Folder::new();
    let files = [("a.csv", AILERON), ("r.csv", RUDDER)].map(|(name, flight)| {
        let mut columns = flight.columns();
        columns[1..4].iter_mut().flatten().for_each(|value| *value = value.to_degrees());
        folder.file(name, table("time [s],beta [deg],p [deg/s],r [deg/s],aileron,rudder", &columns))
    });
    let words = [&files[0], &files[1], "--outputs", "beta,p,r"];
    let (_, json) = identify(&words);
    let units: Vec<_> =
        json["noise"].as_array().unwrap().iter().map(|noise| noise["unit"].clone()).collect();
    assert_eq!(units, ["rad", "rad/s", "rad/s"]);
    let level = json["noise"][0]["deviation"].as_f64().unwrap();
    assert!((level - LEVELS[0]).abs() < 0.1 * LEVELS[0], "{level}");
    let ran = transmode(&[&["identify"], &words[..]].concat());
    for text in
        ["eigenvalue [1/s]", " rad, p ", "; estimated from the records", "order: 4, by a gap of"]
    {
        assert!(ran.out.contains(text), "{text} is missing in\n{}", ran.out);
    }
}
