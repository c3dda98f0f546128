//! `transmode identify --inputs` on flights of a simulator (tests/data/simulator) whose surfaces were recorded.

use std::io::Read;
use std::path::Path;

use flate2::read::GzDecoder;
use serde_json::Value;
use transmode::Exit;

use crate::identify_numbers::valid;
use crate::program::{Folder, Ran, transmode};

/// The files of a flight, unpacked.
fn flight(folder: &Folder, aircraft: &str, kind: &str) -> Vec<String> {
    let surfaces = if kind == "both" { &["both"][..] } else { &["aileron", "rudder"][..] };
    let file = |surface: &&str| {
        let name = match *surface {
            "both" => format!("{aircraft}_both.csv"),
            surface => format!("{aircraft}_{surface}_{kind}.csv"),
        };
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/simulator");
        let packed = std::fs::File::open(data.join(format!("{name}.gz"))).unwrap();
        let mut text = String::new();
        GzDecoder::new(packed).read_to_string(&mut text).unwrap();
        folder.file(&name, text)
    };
    surfaces.iter().map(file).collect()
}

fn identify(files: &[String], words: &[&str]) -> (Ran, Value) {
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let always = ["--outputs", "beta,p,r", "--inputs", "d_aileron,d_rudder", "--json", "-"];
    let ran = transmode(&[&["identify"], &files[..], &always, words].concat());
    assert_eq!(ran.err, "", "{words:?}");
    let json: Value = serde_json::from_str(&ran.out).unwrap();
    valid(&json);
    (ran, json)
}

fn codes(json: &Value) -> Vec<&str> {
    let warnings = json["warnings"].as_array().unwrap();
    warnings.iter().map(|warning| warning["code"].as_str().unwrap()).collect()
}

/// Relative distance of the closest eigenvalue.
fn off(json: &Value, re: f64, im: f64) -> f64 {
    let modes = json["modes"].as_array().unwrap().iter();
    let distance = |mode: &Value| {
        let part = |part: &str| mode["eigenvalue"][part].as_f64().unwrap();
        (part("re") - re).hypot(part("im") - im) / re.hypot(im)
    };
    modes.map(distance).fold(f64::INFINITY, f64::min)
}

/// Roll and Dutch roll of `tests/data/simulator/truth.json`.
const A4: [(f64, f64); 2] = [(-2.4323, 0.0), (-1.7957, 2.0053)];
const B737: [(f64, f64); 2] = [(-1.1436, 0.0), (-0.5797, 1.6868)];

#[test]
fn an_airframe_is_the_lateral_equations() {
    let folder = Folder::new();
    let held_out = flight(&folder, "A4", "both");
    let (ran, json) = identify(&flight(&folder, "A4", "noise"), &["--validate", &held_out[0]]);
    assert_eq!((ran.exit, codes(&json)), (Exit::Fine, vec!["input-missing"; 2]));
    assert_eq!((&json["method"], &json["order"]), (&"output-error".into(), &4.into()));
    assert!(A4.iter().all(|&(re, im)| off(&json, re, im) < 0.01), "{}", json["modes"]);
    let names: Vec<_> =
        json["modes"].as_array().unwrap().iter().map(|mode| &mode["name"]).collect();
    assert_eq!(names, ["Dutch roll", "roll subsidence", "spiral"]);
    let recorded = &json["recorded_inputs"];
    assert_eq!(recorded["structure"], "lateral");
    let derivative = |name: &str| {
        let all = recorded["derivatives"].as_array().unwrap();
        let found = all.iter().find(|own| own["name"] == name).unwrap();
        (found["value"].as_f64().unwrap(), found["deviation"].as_f64().unwrap())
    };
    // The aileron rolls the aircraft, the rudder yaws it, and sideslip turns it back.
    assert!(derivative("L_d_aileron").0 > 5.0 && derivative("N_d_rudder").0 < -1.0);
    assert!(derivative("N_beta").0 > 10.0 * derivative("N_beta").1);
    let predicted = recorded["validation"].as_array().unwrap();
    assert!(predicted[1]["part"].as_f64().unwrap() > 0.95, "{predicted:?}");
}

#[test]
fn derivatives_become_coefficients_where_the_size_is_known() {
    let folder = Folder::new();
    let description = "[geometry]\nwing_area_ft2 = 260.0\nspan_ft = 27.5\nmass_slug = 544.0\nair_density_slug_ft3 = 0.000738\n\
                       true_airspeed_ft_s = 682.0\n[inertia]\nixx_slug_ft2 = 8090.0\nizz_slug_ft2 = 29200.0\nixz_slug_ft2 = 1300.0\n";
    let file = folder.file("a4.toml", description);
    let (ran, json) = identify(&flight(&folder, "A4", "both"), &["--aircraft", &file]);
    assert_eq!(ran.exit, Exit::Fine, "{}", json["warnings"]);
    let of = |list: &str, name: &str| {
        let all = json["recorded_inputs"][list].as_array().unwrap();
        all.iter().find(|own| own["name"] == name).unwrap()["value"].as_f64().unwrap()
    };
    // C_n_beta = (Izz N - Ixz L) / (q S b).
    let moment = 0.5 * 0.000738 * 682.0 * 682.0 * 260.0 * 27.5;
    let expected =
        (29200.0 * of("derivatives", "N_beta") - 1300.0 * of("derivatives", "L_beta")) / moment;
    assert!((of("coefficients", "C_n_beta") / expected - 1.0).abs() < 1e-9);
    assert!((0.1..0.5).contains(&of("coefficients", "C_n_beta")));
    assert!(of("coefficients", "C_l_p") < 0.0 && of("coefficients", "C_l_d_aileron") > 0.0);
    let bad = folder.file("bad.toml", description.replace("span_ft = 27.5", "span_ft = -1.0"));
    let file = flight(&folder, "A4", "both").remove(0);
    let words = ["identify", &file, "--outputs", "beta,p,r", "--inputs", "d_aileron,d_rudder"];
    transmode(&[&words[..], &["--aircraft", &bad]].concat()).refused("span_ft is -1");
}

#[test]
fn one_record_in_which_both_surfaces_move_is_enough() {
    let folder = Folder::new();
    let (ran, json) = identify(&flight(&folder, "A4", "both"), &[]);
    assert_eq!((ran.exit, codes(&json)), (Exit::Fine, Vec::new()), "{}", json["warnings"]);
    assert!(A4.iter().all(|&(re, im)| off(&json, re, im) < 0.02), "{}", json["modes"]);
}

/// Servos and a yaw damper are part of these records: four states cannot be right.
#[test]
fn equations_that_do_not_hold_are_not_bent() {
    let folder = Folder::new();
    let files = flight(&folder, "737", "clean");
    let (ran, json) = identify(&files, &[]);
    assert_eq!(ran.exit, Exit::Fine, "{}", json["warnings"]);
    assert!(B737.iter().all(|&(re, im)| off(&json, re, im) < 0.005), "{}", json["modes"]);
    assert_eq!(json["recorded_inputs"]["structure"], "black-box");
    let (ran, json) = identify(&files, &["--structure", "lateral"]);
    assert_eq!(ran.exit, Exit::Doubtful);
    assert!(codes(&json).contains(&"structure-contradicted"), "{}", json["warnings"]);
}

#[test]
fn turbulence_is_a_disturbance_like_any_other() {
    let folder = Folder::new();
    let (ran, json) = identify(&flight(&folder, "A4", "turb2"), &[]);
    assert_eq!(ran.exit, Exit::Fine, "{}", json["warnings"]);
    assert!(off(&json, A4[1].0, A4[1].1) < 0.12, "{}", json["modes"]);
}

#[test]
fn a_late_vane_has_its_lag_estimated() {
    let folder = Folder::new();
    let files = flight(&folder, "Concorde", "delay");
    let (ran, json) = identify(&files, &["--lag", "beta=free"]);
    assert_eq!(ran.exit, Exit::Fine, "{}", json["warnings"]);
    let lag = &json["recorded_inputs"]["lags"][0];
    let (value, error) = (lag["value_s"].as_f64().unwrap(), lag["deviation_s"].as_f64().unwrap());
    assert!((value - 0.1).abs() < 0.02 && error < 0.05, "{lag}");
    assert!(off(&json, -0.0742, 1.2197) < 0.005, "{}", json["modes"]);
}

#[test]
fn the_page_shows_measured_and_simulated() {
    let folder = Folder::new();
    let files = flight(&folder, "A4", "both");
    let out = folder.path("report");
    let out = out.to_str().unwrap();
    let (ran, _) = identify(&files, &["--report", out]);
    assert_eq!(ran.exit, Exit::Fine);
    let page = std::fs::read_to_string(format!("{out}/report.html")).unwrap();
    for text in ["Measured and simulated", "What is left over", "Coherence", "N_d_rudder"] {
        assert!(page.contains(text), "{text}");
    }
    for name in ["time-histories", "left-over", "coherence", "pole-map"] {
        assert!(Path::new(&format!("{out}/{name}.png")).is_file(), "{name}");
    }
}

#[test]
fn a_model_that_was_written_simulates_another_flight() {
    let folder = Folder::new();
    let files = flight(&folder, "A4", "noise");
    let (_, json) = identify(&files, &[]);
    let model = folder.file("modes.json", json.to_string());
    let other = flight(&folder, "A4", "both");
    let out = folder.path("predicted");
    let words = ["simulate", &model, "--inputs", &other[0], "-o", out.to_str().unwrap()];
    let ran = transmode(&words);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let percent = |sensor: &str| -> f64 {
        let line = ran.out.lines().find(|line| line.starts_with(&format!("{sensor}: "))).unwrap();
        line.split_whitespace().nth(1).unwrap().parse().unwrap()
    };
    // As --validate says it of the same flight.
    assert!(percent("p") > 95.0 && percent("r") > 85.0, "{}", ran.out);
    let table = std::fs::read_to_string(out.join("simulated.csv")).unwrap();
    let header = "time [s],beta,beta_simulated,p,p_simulated,r,r_simulated";
    assert_eq!(table.lines().next().unwrap(), header);
    assert_eq!(table.lines().count(), 2401);
    // Nothing is replaced without being asked for.
    assert_eq!(transmode(&words).exit, Exit::BadInput);

    let without = folder.file("without.json", {
        let mut json = json;
        json["recorded_inputs"] = Value::Null;
        json.to_string()
    });
    transmode(&["simulate", &without, "--inputs", &other[0]]).refused("has no model with inputs");
    transmode(&["simulate", &other[0], "--inputs", &other[0]]).refused("this is no result of");
}

#[test]
fn options_that_do_not_go_together() {
    let folder = Folder::new();
    let files = flight(&folder, "A4", "both");
    let always = ["identify", &files[0], "--outputs", "beta,p,r"];
    let inputs = ["--inputs", "d_aileron,d_rudder"];
    let cases: [(&[&str], &str); 5] = [
        (&["--lag", "gamma=0.1"], "--lag names \"gamma\", which is none of"),
        (&["--lag", "beta=0.1", "--lag", "beta=free"], "--lag names \"beta\" twice"),
        (&["--noise", "1,1,1", "--unknown-excitation", "no"], "leave one of both out"),
        (&["--unknown-excitation", "yes"], "1 record"),
        (&["--method", "subspace", "--structure", "lateral"], "belongs to --method ml"),
    ];
    for (words, expected) in cases {
        transmode(&[&always[..], &inputs, words].concat()).refused(expected);
    }
}
