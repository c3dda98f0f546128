//! The lateral equations under unknown excitation, and what they tell of records that contradict them.

use std::path::Path;

use serde_json::Value;
use transmode::Exit;

use crate::identify_numbers::valid;
use crate::program::{Folder, Ran, transmode};

/// A pair of files in `tests/data/field`.
fn identify(name: &str, words: &[&str]) -> (Ran, Value) {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/field");
    let files = ["aileron", "rudder"].map(|surface| data.join(format!("{name}-{surface}.csv")));
    let files = files.each_ref().map(|file| file.to_str().unwrap());
    let always = ["--outputs", "beta,p,r", "--json", "-"];
    let ran = transmode(&[&["identify"], &files[..], &always, words].concat());
    assert_eq!(ran.err, "", "{words:?}");
    let json: Value = serde_json::from_str(&ran.out).unwrap();
    valid(&json);
    (ran, json)
}

fn mode<'a>(json: &'a Value, name: &str) -> &'a Value {
    let modes = json["modes"].as_array().unwrap();
    modes.iter().find(|mode| mode["name"] == name).unwrap_or_else(|| panic!("{modes:#?}"))
}

/// Whether a mode is the planted one within so many of its standard errors.
fn is(mode: &Value, re: f64, im: f64) {
    let off = |part: &str, planted: f64| {
        let number = |of: &str| mode[of][part].as_f64().unwrap_or_default();
        ((number("eigenvalue") - planted).abs(), 3.0 * number("deviation") + 1e-12)
    };
    for (off, limit) in [off("re", re), off("im", im)] {
        assert!(off < limit, "{re} {im}: {mode:#}");
    }
}

#[test]
fn a_yaw_damper_is_within_the_equations() {
    let (ran, json) = identify("01-yaw-damper", &[]);
    assert_eq!((ran.exit, &json["warnings"]), (Exit::Fine, &Value::Array(vec![])));
    assert_eq!(json["form"]["structure"], "lateral");
    is(mode(&json, "Dutch roll"), -0.1323, 0.9238);
    is(mode(&json, "roll subsidence"), -0.5823, 0.0);
    is(mode(&json, "spiral"), -0.0739, 0.0);
    let names: Vec<&str> = json["form"]["derivatives"]
        .as_array()
        .unwrap()
        .iter()
        .map(|own| own["name"].as_str().unwrap())
        .collect();
    assert_eq!(names[4..10], ["L_beta", "L_p", "L_r", "N_beta", "N_p", "N_r"]);
}

#[test]
fn biased_sensors_leave_the_modes_where_they_are() {
    let (ran, json) = identify("03-bias", &[]);
    assert_eq!((ran.exit, &json["order"]), (Exit::Fine, &4.into()));
    is(mode(&json, "Dutch roll"), -0.03294, 0.94665);
    is(mode(&json, "roll subsidence"), -0.56265, 0.0);
    is(mode(&json, "spiral"), -0.00728, 0.0);
    assert_eq!(json["offset_values"].as_array().unwrap().len(), 3);
}

#[test]
fn records_of_different_speeds_are_doubted() {
    let (ran, json) = identify("05-speeds-apart", &[]);
    assert_eq!(ran.exit, Exit::Doubtful);
    let warning = &json["warnings"][0];
    assert_eq!(warning["code"], "conditions-differ", "{:#}", json["warnings"]);
    let text = warning["text"].as_str().unwrap();
    for part in [
        "05-speeds-apart-aileron.csv has eigenvalues",
        "rudder.csv has eigenvalues",
        "times as fast as the first",
    ] {
        assert!(text.contains(part), "{text}");
    }
    assert_eq!(json["form"]["compared"]["structure"], "lateral");
}

#[test]
fn derivatives_are_printed_where_they_are_asked_for() {
    let folder = Folder::new();
    let page = folder.path("report").to_str().unwrap().to_owned();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/field");
    let files = ["aileron", "rudder"].map(|surface| {
        data.join(format!("04-complete-{surface}.csv")).to_str().unwrap().to_owned()
    });
    let words = ["--outputs", "beta,p,r", "--structure", "lateral", "--report", &page];
    let ran = transmode(&[&["identify", &files[0], &files[1]], &words[..]].concat());
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    for part in ["form: the lateral equations", "likelihood-ratio test", "L_beta", "tan(theta)"] {
        assert!(ran.out.contains(part), "{part}: {}", ran.out);
    }
    let page = std::fs::read_to_string(Path::new(&page).join("report.html")).unwrap();
    assert!(page.contains("Form of the equations") && page.contains("Dimensional derivatives"));
}

#[test]
fn equations_that_records_cannot_have_are_refused() {
    let (files, columns) = (["a.csv", "b.csv"], "t,x,p,r\n");
    let folder = Folder::new();
    let files = files.map(|name| {
        let rows = (0..80).map(|k| {
            let y = f64::from(k * k % 17);
            format!("{},{y},{},{}\n", f64::from(k) * 0.1, y * y % 5.0, y * 3.0 % 7.0)
        });
        folder.file(name, format!("{columns}{}", rows.collect::<String>()))
    });
    let words = ["--outputs", "x,p,r", "--structure", "lateral"];
    let ran = transmode(&[&["identify", &files[0], &files[1]], &words[..]].concat());
    assert_eq!(ran.exit, Exit::BadInput);
    assert!(ran.err.contains("--structure") && ran.err.contains("beta, p and r"), "{}", ran.err);
}
