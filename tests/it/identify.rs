//! `transmode identify`, above all by the printed method, on the records that the repository ships.

use serde_json::Value;
use transmode::Exit;

use crate::program::{Folder, shipped, transmode};

/// Name, eigenvalue: tests/data/reference.json /aircraft/spec_A, the fastest first.
const MODES: [(&str, f64, f64); 3] = [
    ("Dutch roll", -0.070_594_067_703_702_26, 1.691_678_361_958_471_2),
    ("roll subsidence", -0.545_562_845_619_248_3, 0.0),
    ("spiral", -0.001_563_638_219_256_003_3, 0.0),
];

fn noise_free() -> [String; 2] {
    ["noise_free_aileron.csv", "noise_free_rudder.csv"].map(shipped)
}

#[test]
fn names_the_modes_of_the_aircraft() {
    let [aileron, rudder] = noise_free();
    let words = ["identify", &aileron, &rudder, "--outputs", "beta,p,r", "--method", "as-printed"];
    let ran = transmode(&words);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    for text in [
        "Dutch roll",
        "-0.0705941 ± j1.69168",
        "roll subsidence",
        "-0.545563",
        "spiral",
        "-0.00156364",
    ] {
        assert!(ran.out.contains(text), "{text} is missing in\n{}", ran.out);
    }
    assert!(ran.out.contains("zeros: 4 shared by 2 differences"), "{}", ran.out);
}

#[test]
fn json_holds_the_numbers_in_full() {
    let ([aileron, rudder], folder) = (noise_free(), Folder::new());
    let file = folder.path("modes.json");
    let words = [
        "identify",
        &aileron,
        &rudder,
        "--outputs",
        "beta,p,r",
        "--method",
        "as-printed",
        "--json",
    ];
    let ran = transmode(&[&words[..], &[file.to_str().unwrap()]].concat());
    assert_eq!(ran.exit, Exit::Fine);
    assert!(ran.out.contains("Dutch roll"));
    let json: Value = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    assert_eq!(folder.names(), ["modes.json"]);

    assert_eq!(json["schema"], 1);
    assert_eq!(json["method"], "as-printed");
    assert_eq!(json["order"], 4);
    assert_eq!(json["sample_period_s"], 0.1);
    assert_eq!(json["records"][1]["file"], "noise_free_rudder.csv");
    assert_eq!(json["records"][1]["samples"], 2000);
    assert_eq!(json["warnings"], Value::Array(Vec::new()));
    assert_eq!(json["modes"].as_array().unwrap().len(), 3);
    for (mode, (name, re, im)) in json["modes"].as_array().unwrap().iter().zip(MODES) {
        assert_eq!(mode["name"], name);
        for (part, expected) in [("re", re), ("im", im)] {
            let found = mode["eigenvalue"][part].as_f64().unwrap();
            assert!((found - expected).abs() < 1e-9, "{name} {part}: {found}");
        }
    }
    let transmissibilities = json["transmissibilities"].as_array().unwrap();
    assert_eq!(transmissibilities.len(), 4);
    assert!(
        transmissibilities.iter().all(|found| found["rank"] == 54 && found["parameters"] == 54)
    );

    // On standard output the JSON stands alone, and is the same.
    let ran = transmode(&[&words[..], &["-"]].concat());
    let alone: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(alone, json);
}

#[test]
fn all_columns_but_time_are_sensors_by_default() {
    let [aileron, rudder] = noise_free();
    let words = ["identify", &aileron, &rudder, "--method", "as-printed", "--json", "-"];
    let ran = transmode(&words);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.out);
    let json: Value = serde_json::from_str(&ran.out).unwrap();
    // beta to p, r and phi, for two records.
    assert_eq!(json["transmissibilities"].as_array().unwrap().len(), 6);
    assert_eq!(json["order"], 4);
}

#[test]
fn the_column_of_time_can_be_named() {
    let ([aileron, rudder], folder) = (noise_free(), Folder::new());
    let renamed = [aileron, rudder].map(|file| {
        let text = std::fs::read_to_string(&file).unwrap().replacen("time", "seconds", 1);
        folder.file(file.rsplit('/').next().unwrap(), text)
    });
    let words = ["identify", &renamed[0], &renamed[1], "--outputs", "beta,p,r"];
    let ran = transmode(&words);
    assert_eq!(ran.exit, Exit::BadInput);
    assert!(
        ran.err.contains("none of its columns (seconds, beta, p, r, phi) is called time"),
        "{}",
        ran.err
    );
    // Blanks around names are no part of them.
    let words = ["identify", &renamed[0], &renamed[1], "--outputs", " beta, p ,r"];
    assert_eq!(transmode(&[&words[..], &["--time", " seconds"]].concat()).exit, Exit::Fine);
}

#[test]
fn noise_is_told_and_the_exit_code_says_it() {
    let folder = Folder::new();
    let noisy = noise_free().map(|file| {
        let text = std::fs::read_to_string(&file).unwrap();
        let mut random = flight::Stream::new(99, 0);
        let mut lines = text.lines();
        let mut changed = format!("{}\n", lines.next().unwrap());
        for line in lines {
            let mut fields = line.split(',');
            changed += fields.next().unwrap();
            for field in fields {
                let noisy = field.parse::<f64>().unwrap() + 0.03 * random.normal();
                changed += &format!(",{noisy}");
            }
            changed.push('\n');
        }
        folder.file(file.rsplit('/').next().unwrap(), changed)
    });
    let words =
        ["identify", &noisy[0], &noisy[1], "--outputs", "beta,p,r", "--method", "as-printed"];
    let ran = transmode(&words);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Doubtful, ""));
    assert!(
        ran.out.contains("warning: record noise_free_aileron.csv, sensor p: the fit leaves"),
        "{}",
        ran.out
    );
}

#[test]
fn help_and_version_are_results() {
    for words in [&["--help"][..], &["--version"], &["identify", "--help"]] {
        let ran = transmode(words);
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
        assert!(!ran.out.is_empty());
    }
    let first = "Reconstructs the dynamics of a system from sensor records alone";
    assert!(transmode(&["--help"]).out.starts_with(first));
    assert!(transmode(&["identify", "--help"]).out.contains("Examples:"));
    assert!(transmode(&["--help"]).out.contains("Exit codes: 0"));
}

/// An output whose reader went away.
struct Gone;

impl std::io::Write for Gone {
    fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
        Err(std::io::ErrorKind::BrokenPipe.into())
    }
    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_reader_that_went_away_is_no_fault() {
    let [aileron, rudder] = noise_free();
    for words in [
        &[
            "transmode",
            "identify",
            &aileron,
            &rudder,
            "--outputs",
            "beta,p,r",
            "--method",
            "subspace",
        ][..],
        &["transmode", "--help"],
    ] {
        let mut err = Vec::new();
        let exit = transmode::run(words.iter().copied(), &mut Gone, &mut err);
        assert_eq!((exit, err.as_slice()), (Exit::Fine, &b""[..]), "{words:?}");
    }
}
