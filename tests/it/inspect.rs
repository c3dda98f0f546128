//! `transmode inspect`.

use serde_json::Value;
use transmode::Exit;

use crate::program::{Folder, shipped, transmode};

fn json(words: &[&str]) -> (Exit, Value) {
    let ran = transmode(&[&["inspect"], words, &["--json", "-"]].concat());
    assert_eq!(ran.err, "", "{words:?}");
    (ran.exit, serde_json::from_str(&ran.out).unwrap())
}

#[test]
fn a_shipped_record_is_sound() {
    let names = ["white_snr100_aileron.csv", "white_snr100_rudder.csv"];
    let [a, b] = names.map(shipped);
    let ran = transmode(&["inspect", &a, &b]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""), "{}", ran.out);
    assert!(
        ran.out.contains("2000 samples, every 0.1 s from 0 s to 199.9 s by time"),
        "{}",
        ran.out
    );
    let suggestion = format!("suggestion: transmode identify {a} {b} --outputs beta,p,r\n");
    assert!(ran.out.ends_with(&suggestion), "{}", ran.out);
    assert!(!ran.out.contains("note:") && !ran.out.contains("problem:"), "{}", ran.out);
    // What is suggested works.
    let words: Vec<&str> = suggestion.trim().split(' ').skip(2).collect();
    assert_ne!(transmode(&words).exit, Exit::BadInput);
    for name in ["multistep_snr100_aileron.csv", "noise_free_rudder.csv", "white_snr10_rudder.csv"]
    {
        let (exit, found) = json(&[&shipped(name)]);
        assert_eq!(
            (exit, &found["files"][0]["findings"]),
            (Exit::Fine, &Value::Array(Vec::new())),
            "{name}"
        );
    }
}

#[test]
fn planted_faults_are_named() {
    let text = std::fs::read_to_string(shipped("white_snr100_aileron.csv")).unwrap();
    let mut held = String::new();
    let mut faulty =
        "t [s],AOS [deg],roll_rate [deg/s],yaw_rate [deg/s],dead,copy [deg]\n".to_owned();
    for (k, line) in text.lines().skip(1).enumerate() {
        if (1000..1020).contains(&k) {
            continue;
        }
        let mut fields: Vec<String> = line.split(',').map(str::to_owned).collect();
        if k == 500 {
            fields[2] = "99".to_owned();
        }
        if k == 1500 {
            held.clone_from(&fields[3]);
        }
        if (1500..1600).contains(&k) {
            fields[3].clone_from(&held);
        }
        faulty += &format!("{},7,{}\n", fields.join(","), fields[1]);
    }
    let folder = Folder::new();
    let file = folder.file("my flight.csv", faulty);
    let (exit, found) = json(&[&file]);
    assert_eq!(exit, Exit::Doubtful);
    let findings: Vec<_> = found["files"][0]["findings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|f| (f["code"].as_str().unwrap(), f["text"].as_str().unwrap()))
        .collect();
    let expected = [
        ("gaps", "gaps split it into 2 records; after a gap it goes on at line 1002"),
        ("outliers", "roll_rate has outliers: line 502"),
        ("stuck", "yaw_rate is stuck for 100 samples from line 1482 on"),
        ("dead", "dead is constant; leave it out with --outputs"),
        ("duplicate", "copy repeats AOS; leave one of them out with --outputs"),
    ];
    assert_eq!(findings, expected);
    assert_eq!(found["files"][0]["channels"][0]["si_unit"], "rad");
    assert_eq!(
        found["suggestion"],
        format!(
            "suggestion: transmode identify '{file}' SECOND_FILE --outputs AOS,roll_rate,yaw_rate"
        )
    );
    let ran = transmode(&["inspect", &file]);
    assert!(
        ran.out.contains("problem: dead is constant") && ran.out.contains("rad/s (from deg/s)"),
        "{}",
        ran.out
    );
}

#[test]
fn times_that_do_not_fit_are_a_problem_and_no_error() {
    let folder = Folder::new();
    let rows = |time: fn(u32) -> u32| {
        (0..100)
            .map(|k| format!("{},{},{},{}\n", time(k), k % 7, k % 11, k % 13))
            .collect::<String>()
    };
    let file = folder.file("x.csv", format!("t,a,b,c\n{}", rows(|k| if k == 50 { 3 } else { k })));
    let (exit, found) = json(&[&file]);
    assert_eq!((exit, &found["files"][0]["sample_period_s"]), (Exit::Doubtful, &Value::Null));
    assert_eq!(
        found["files"][0]["findings"][0]["text"],
        "line 52: time runs backwards by 46.0 s; put the rows in order of time or cut the record there"
    );
    let file = folder.file("y.csv", format!("k,a,b,c\n{}", rows(|k| k)));
    let (exit, found) = json(&[&file]);
    assert_eq!(
        (exit, &found["files"][0]["findings"][0]["code"]),
        (Exit::Doubtful, &Value::from("no-time"))
    );
    let (exit, found) = json(&[&file, "--sample-period", "0.5", "--outputs", "a,b,c"]);
    assert_eq!((exit, &found["files"][0]["sample_period_s"]), (Exit::Fine, &Value::from(0.5)));
    let text = found["suggestion"].as_str().unwrap();
    assert!(
        text.starts_with("no suggestion: no column looks like sideslip or roll rate or yaw rate"),
        "{text}"
    );
}

#[test]
fn no_command_is_suggested_that_would_be_refused() {
    let folder = Folder::new();
    let slow = |step: f64| {
        let row = |k: u32| {
            let x = f64::from(k * k % 17);
            format!(
                "{},{x},{},{}\n",
                step * f64::from(k),
                2.0 * x - f64::from(k % 5),
                f64::from(k % 7)
            )
        };
        format!("time,beta,p,r\n{}", (0..80).map(row).collect::<String>())
    };
    let [a, b] = [("a.csv", 0.1), ("b.csv", 0.2)].map(|(name, step)| folder.file(name, slow(step)));
    for (files, expected) in [
        ([a.as_str(), a.as_str()], "is given twice"),
        ([a.as_str(), b.as_str()], ": resample one of them"),
    ] {
        let (_, found) = json(&files);
        let text = found["suggestion"].as_str().unwrap();
        assert!(text.starts_with("no suggestion: ") && text.ends_with(expected), "{text}");
        transmode(&["identify", files[0], files[1], "--outputs", "beta,p,r"]).refused(expected);
    }
}
