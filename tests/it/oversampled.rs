//! Records that are sampled far faster than anything in them moves.

use serde_json::Value;
use transmode::Exit;

use crate::program::{Folder, transmode};

/// Two flights of 60 s at 500 Hz, whose fastest mode is below 0.3 Hz, and what is true of them.
fn flights(excitation: &str, ratio: &str) -> (Folder, [String; 2], Value) {
    let folder = Folder::new();
    let place = folder.path("flights");
    let place = place.to_str().unwrap();
    let noise = format!("snr={ratio}");
    let words = ["simulate", "paper", "--duration", "60", "--sample-period", "0.002"];
    let more = ["--excitation", excitation, "--noise", &noise, "--seed", "4", "-o", place];
    let ran = transmode(&[&words[..], &more].concat());
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    let files = ["aileron", "rudder"].map(|surface| format!("{place}/{surface}.csv"));
    let truth = std::fs::read(format!("{place}/truth.json")).unwrap();
    (folder, files, serde_json::from_slice(&truth).unwrap())
}

fn identify(files: &[String; 2], words: &[&str]) -> (Exit, Value) {
    let ran = transmode(&[&["identify", &files[0], &files[1], "--json", "-"], words].concat());
    assert_eq!(ran.err, "", "{words:?}");
    (ran.exit, serde_json::from_str(&ran.out).unwrap())
}

/// The modes by their names, within so many standard errors.
fn agree(found: &Value, truth: &Value, deviations: f64) {
    for true_mode in truth["modes"].as_array().unwrap() {
        let name = &true_mode["name"];
        let modes = found["modes"].as_array().unwrap();
        let mode = modes.iter().find(|mode| mode["name"] == *name).unwrap();
        for part in ["re", "im"] {
            let number = |value: &Value| value[part].as_f64().unwrap();
            let off = number(&mode["eigenvalue"]) - number(&true_mode["eigenvalue"]);
            let deviation = number(&mode["deviation"]);
            assert!(off.abs() <= deviations * deviation, "{name} {part}: {off} for {deviation}");
        }
    }
}

#[test]
fn they_are_decimated_and_right() {
    for (excitation, ratio) in [("multistep", "30"), ("lowpass", "100"), ("white", "100")] {
        let (_folder, files, truth) = flights(excitation, ratio);
        let (exit, found) = identify(&files, &[]);
        assert_eq!(exit, Exit::Fine, "{excitation}: {:#}", found["warnings"]);
        let warnings = found["warnings"].as_array().unwrap();
        assert_eq!(warnings.len(), 1, "{warnings:#?}");
        assert_eq!(warnings[0]["code"], "oversampled");
        let factor = found["decimation"].as_u64().unwrap();
        assert!(factor >= 4, "{excitation}: {factor}");
        let text = warnings[0]["text"].as_str().unwrap();
        let start = format!("of 500 samples in a second every {factor}");
        assert!(text.starts_with(&start) && text.ends_with("(--decimate 1 keeps all)"), "{text}");
        let period_s = found["sample_period_s"].as_f64().unwrap();
        assert!((period_s - 0.002 * factor as f64).abs() < 1e-9, "{period_s}");
        agree(&found, &truth, 2.5);
    }
}

#[test]
fn who_asks_for_a_factor_has_it() {
    let (_folder, files, truth) = flights("lowpass", "100");
    let (exit, found) = identify(&files, &["--decimate", "20"]);
    assert_eq!((exit, &found["decimation"]), (Exit::Fine, &Value::from(20)));
    assert_eq!(found["warnings"].as_array().unwrap().len(), 0);
    agree(&found, &truth, 2.5);
    let (_, found) = identify(&files, &["--decimate", "1", "--method", "subspace"]);
    assert_eq!((&found["decimation"], &found["sample_period_s"]), (&1.into(), &0.002.into()));
}
