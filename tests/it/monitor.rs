//! `transmode monitor`: healthy sensors, faulty ones, and what it refuses.

use serde_json::Value;
use transmode::Exit;

use crate::program::{Folder, transmode};

/// Two flights of the same kind, and a third with another seed.
fn flights() -> (Folder, [String; 3]) {
    let folder = Folder::new();
    let files = ["1", "2", "3"].map(|seed| {
        let place = folder.path(seed);
        let place = place.to_str().unwrap();
        // The same sensors in all flights: a ratio would be to the response of each.
        let noise = "beta=0.0003,p=0.003,r=0.001";
        let words = ["--duration", "400", "--noise", noise, "--seed", seed, "-o", place];
        let ran = transmode(&[&["simulate", "paper", "--surface", "aileron"], &words[..]].concat());
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        format!("{place}/aileron.csv")
    });
    (folder, files)
}

/// A copy of a record with another value in one column from row 2000 (200 s) on.
fn changed(folder: &Folder, file: &str, column: usize, change: impl Fn(f64, u32) -> f64) -> String {
    let text = std::fs::read_to_string(file).unwrap();
    let mut lines = text.lines();
    let mut copy = format!("{}\n", lines.next().unwrap());
    for (row, line) in (0_u32..).zip(lines) {
        let mut fields: Vec<String> = line.split(',').map(str::to_owned).collect();
        if row >= 2000 {
            fields[column] = change(fields[column].parse().unwrap(), row - 2000).to_string();
        }
        copy += &format!("{}\n", fields.join(","));
    }
    folder.file("changed.csv", copy)
}

fn alarm(words: &[&str]) -> Value {
    let ran = transmode(&[&["monitor", "--json", "-"], words].concat());
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Doubtful, ""), "{}", ran.out);
    serde_json::from_str::<Value>(&ran.out).unwrap()["records"][0]["alarm"].clone()
}

#[test]
fn healthy_sensors_raise_no_alarm() {
    let (folder, [reference, new, _]) = flights();
    let json = folder.path("alarms.json");
    let words = ["monitor", "--reference", &reference, &new, "--false-alarms", "1e-5"];
    let ran = transmode(&[&words[..], &["--json", json.to_str().unwrap()]].concat());
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""), "{}", ran.out);
    assert!(ran.out.contains("pairs: beta to p, beta to r"), "{}", ran.out);
    assert!(ran.out.contains("aileron.csv: no alarm in"), "{}", ran.out);
    let found: Value = serde_json::from_slice(&std::fs::read(&json).unwrap()).unwrap();
    assert_eq!(found["schema"], 1);
    assert_eq!((&found["span_s"], &found["false_alarms_per_span"]), (&5.0.into(), &1e-5.into()));
    // 720 spans in an hour.
    assert!((found["false_alarms_per_hour"].as_f64().unwrap() - 0.0072).abs() < 1e-12);
    assert_eq!(found["records"][0]["alarm"], Value::Null);
    let spans = found["records"][0]["spans"].as_array().unwrap();
    assert!((70..80).contains(&spans.len()), "{}", spans.len());
    assert!(spans.iter().all(|span| span["alarm"] == false));
}

#[test]
fn faults_are_seen_soon_and_called_by_their_names() {
    let (folder, [reference, new, _]) = flights();
    let check = |column: usize, sensor: &str, kind: &str, change: &dyn Fn(f64, u32) -> f64| {
        let file = changed(&folder, &new, column, change);
        let alarm = alarm(&["--reference", &reference, &file, "--false-alarms", "1e-4"]);
        let time = alarm["time_s"].as_f64().unwrap();
        assert!((200.0..225.0).contains(&time), "{sensor} {kind}: {alarm}");
        assert_eq!(alarm["change"], kind, "{sensor} {kind}: {alarm}");
        let sensors = alarm["sensors"].as_array().unwrap();
        assert!(sensors.contains(&sensor.into()), "{sensor} {kind}: {alarm}");
        let [statistic, limit] = ["statistic", "limit"].map(|name| alarm[name].as_f64().unwrap());
        assert!(statistic > limit, "{alarm}");
        sensors.len()
    };
    assert_eq!(check(1, "beta", "freeze", &|_, _| 0.123), 1);
    assert_eq!(check(2, "p", "freeze", &|_, _| 0.123), 1);
    check(3, "r", "bias", &|value, _| value + 0.1);
    check(3, "r", "drift", &|value, after| value + 0.001 * f64::from(after));
    check(3, "r", "noise", &|value, after| {
        value + 0.1 * ((f64::from(after) * 0.618_033_988_749_895).fract() - 0.5)
    });
}

#[test]
fn models_that_fit_wrote() {
    let (folder, [fitted, reference, new]) = flights();
    let json = folder.path("fit.json");
    let json = json.to_str().unwrap();
    let ran = transmode(&["fit", &fitted, "--input", "beta", "--output", "r", "--json", json]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    let words = ["monitor", "--reference", &reference, "--model", json];
    let ran = transmode(&[&words[..], &[&new, "--false-alarms", "0.01/hour"]].concat());
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""), "{}", ran.out);
    assert!(ran.out.contains("pairs: beta to r\n") && !ran.out.contains("warning"), "{}", ran.out);
    assert!(ran.out.contains("0.010 in an hour"), "{}", ran.out);
    let file = changed(&folder, &new, 3, |value, _| value + 0.1);
    let found = alarm(&["--reference", &reference, "--model", json, &file]);
    // A single pair cannot tell its sensors apart.
    assert_eq!(found["sensors"].as_array().unwrap().len(), 2);
    // Limits from the record that was fitted would be too narrow.
    let ran = transmode(&["monitor", "--reference", &fitted, "--model", json, &new]);
    assert!(ran.out.contains("warning: a model was fitted to the reference itself"), "{}", ran.out);
}

#[test]
fn models_that_cannot_be() {
    let (folder, [reference, new, _]) = flights();
    let json = folder.path("fit.json");
    let json = json.to_str().unwrap();
    transmode(&["fit", &reference, "--input", "beta", "--output", "r", "--json", json]);
    let good = std::fs::read_to_string(json).unwrap();
    let check = |text: &str, more: &[&str], expected: &str| {
        let bad = folder.file("bad.json", text);
        let words = ["monitor", "--reference", &reference, &new, "--model", &bad];
        transmode(&[&words[..], more].concat()).refused(expected);
    };
    check("{", &[], "bad.json: this is no result of transmode fit --json");
    check(&good.replace("\"schema\": 1", "\"schema\": 9"), &[], "schema 9 is not known, 1 is");
    check(&good.replace("c_1", "c_7"), &[], "its parameters are not those of its orders");
    check(&good.replace("\"iir\": 4", "\"iir\": 99999"), &[], "10000 parameters");
    check(
        &good,
        &["--outputs", "beta,p"],
        "it relates \"r\", which is not among the sensors beta, p",
    );
    check(
        &good.replace("\"sample_period_s\": 0.1", "\"sample_period_s\": 0.2"),
        &[],
        "it is sampled every 0.2 s, the reference every 0.1 s",
    );
    check(
        &good.replace("\"input\": \"beta\"", "\"input\": \"alpha\""),
        &[],
        "has no column \"alpha\"",
    );
    let missing = folder.path("no.json");
    let words = ["monitor", "--reference", &reference, &new, "--model"];
    transmode(&[&words[..], &[missing.to_str().unwrap()]].concat()).refused("cannot read");
}

#[test]
fn a_stretch_too_short_for_a_span_is_left_out_with_a_warning() {
    let (folder, [reference, new, _]) = flights();
    // Rows 60 to 65 and 2000 to 2005 are missing: stretches of 60, 1934 and 1994 samples, of which the first has no span.
    let text = std::fs::read_to_string(&new).unwrap();
    let rows = text
        .lines()
        .enumerate()
        .filter(|(line, _)| !(61..67).contains(line) && !(2001..2007).contains(line));
    let file = folder.file("gaps.csv", rows.map(|(_, row)| format!("{row}\n")).collect::<String>());
    let words = ["monitor", "--reference", &reference, &file, "--false-alarms", "1e-5"];
    let ran = transmode(&[&words[..], &["--json", "-"]].concat());
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""), "{}", ran.out);
    let found: Value = serde_json::from_str(&ran.out).unwrap();
    let names: Vec<&Value> =
        found["records"].as_array().unwrap().iter().map(|record| &record["file"]).collect();
    assert_eq!(names, ["gaps.csv#2", "gaps.csv#3"]);
    let warnings = found["warnings"].as_array().unwrap();
    let warning = warnings.iter().find(|warning| warning["code"] == "no-span").unwrap();
    let text = warning["text"].as_str().unwrap();
    let expected = "gaps.csv#1 was left out: its 60 samples are too few for one span, which takes ";
    assert!(text.starts_with(expected), "{text}");
    // Nothing is left to watch.
    let short = std::fs::read_to_string(&new).unwrap();
    let rows = short.lines().take(140).enumerate().filter(|(line, _)| !(70..76).contains(line));
    let file =
        folder.file("short.csv", rows.map(|(_, row)| format!("{row}\n")).collect::<String>());
    transmode(&["monitor", "--reference", &reference, &file])
        .refused("short.csv#1: its 69 samples are too few for one span");
}

#[test]
fn rows_that_are_missing_cost_no_span_and_hide_no_fault() {
    let (folder, [reference, new, _]) = flights();
    // Two of three 47th rows, of the reference as well.
    let lossy = |file: &str, name: &str| {
        let text = std::fs::read_to_string(file).unwrap();
        let rows =
            text.lines().enumerate().filter(|(line, _)| line % 47 != 40 || line / 47 % 3 == 0);
        folder.file(name, rows.map(|(_, row)| format!("{row}\n")).collect::<String>())
    };
    let [reference, healthy] = [lossy(&reference, "reference.csv"), lossy(&new, "healthy.csv")];
    let faulty = changed(&folder, &new, 3, |value, _| value + 0.1);
    let faulty = lossy(&faulty, "faulty.csv");
    let words = ["monitor", "--reference", &reference, "--false-alarms", "1e-4", "--json", "-"];
    let ran = transmode(&[&words[..], &[&healthy, &faulty]].concat());
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Doubtful, ""), "{}", ran.out);
    let found: Value = serde_json::from_str(&ran.out).unwrap();
    let records = found["records"].as_array().unwrap();
    assert_eq!(records.len(), 2);
    for record in records {
        let spans = record["spans"].as_array().unwrap().len();
        assert!((70..80).contains(&spans), "{spans}");
        assert_eq!(record["spans_not_judged"], 0);
    }
    assert_eq!(records[0]["alarm"], Value::Null);
    let time = records[1]["alarm"]["time_s"].as_f64().unwrap();
    assert!((200.0..225.0).contains(&time), "{time}");
    let warnings = found["warnings"].as_array().unwrap();
    assert!(warnings.iter().all(|warning| warning["code"] == "bridged"), "{warnings:#?}");
    // Where each gap splits, hardly a span is left.
    let ran = transmode(&[&words[..], &[&healthy, "--bridge", "0"]].concat());
    assert_eq!(ran.exit, Exit::BadInput, "{}", ran.out);
}

#[test]
fn records_and_words_that_cannot_be() {
    let (folder, [reference, new, _]) = flights();
    let check = |words: &[&str], expected: &str| {
        let ran = transmode(&[&["monitor", "--reference", &reference, &new], words].concat());
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""), "{words:?}");
        assert!(ran.err.contains(expected), "{words:?}\n{}", ran.err);
    };
    for rate in ["0", "-1", "nan", "often"] {
        check(&["--false-alarms", rate], "a rate is a positive number");
    }
    check(&["--false-alarms", "1/day"], "\"day\" is neither span nor hour");
    check(&["--false-alarms", "0.5"], "asks for a chance of 0.5 in a span of 5 s; less than 1/2");
    check(&["--span", "0"], "a span is a positive number of seconds");
    check(&["--span", "0.1"], "a span of 0.1 s is 1 of its samples");
    check(&["--span", "100"], "give a longer reference or a shorter --span");
    check(&["--span", "1e12"], "2 to 1000000000 are possible: change --span");
    check(&["--model", "x.json", "--iir", "3"], "cannot be used with");
    check(&["--causal", "-1"], "an order is a whole number");
    check(&["--causal", "3000"], "its first half, to which the models are fitted");
    check(&["--outputs", "beta"], "it has one sensor, and a transmissibility relates two");
    check(&["--outputs", "beta,q"], "has no column \"q\"");
    check(&["--json", &reference], "is the record itself; write the result to another file");
    transmode(&["monitor", "--reference", "no-such.csv", &new]).refused("cannot read no-such.csv");
    assert_eq!(transmode(&["monitor", &new]).exit, Exit::BadInput);
    // A new record that is too short, or sampled otherwise.
    let rows = |step: f64, count: u32| {
        let row =
            |k: u32| format!("{},{},{},{}\n", f64::from(k) * step, k * k % 13, k * k % 7, k % 5);
        "time,beta,p,r\n".to_owned() + &(0..count).map(row).collect::<String>()
    };
    let monitor = |file: &str| transmode(&["monitor", "--reference", &reference, file]);
    monitor(&folder.file("short.csv", rows(0.1, 80))).refused("are too few for one span");
    monitor(&folder.file("slow.csv", rows(0.2, 500)))
        .refused("it is sampled every 0.2 s, the reference every 0.1 s");
    let other = rows(0.1, 500).replace("time,beta", "time,alpha");
    monitor(&folder.file("other.csv", other))
        .refused("it has the sensors alpha, p, r, and the reference has");
}
