//! `transmode fit`: one transmissibility from CSV, NPY and raw records.

use serde_json::Value;
use transmode::Exit;

use crate::arrays::{Array, npy, raw};
use crate::program::{Folder, shipped, transmode};

/// Runs `fit` and reads its JSON.
fn json(words: &[&str]) -> (Exit, Value) {
    let ran = transmode(&[&["fit"], words, &["--json", "-"]].concat());
    assert_eq!(ran.err, "", "{words:?}");
    (ran.exit, serde_json::from_str(&ran.out).unwrap())
}

/// White noise as large as that of numbers spread evenly between -0.5 and 0.5.
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut random = flight::Stream::new(seed, 0);
    move || random.normal() / 12.0_f64.sqrt()
}

/// Columns beta, p and r of a shipped record with noise of a hundredth.
fn noisy() -> [Vec<f64>; 3] {
    let text = std::fs::read_to_string(shipped("noise_free_aileron.csv")).unwrap();
    let mut columns = [const { Vec::new() }; 3];
    let mut noise = noise(7);
    for line in text.lines().skip(1) {
        for (column, field) in columns.iter_mut().zip(line.split(',').skip(1)) {
            column.push(field.parse::<f64>().unwrap() + 0.02 * noise());
        }
    }
    columns
}

fn csv(columns: &[Vec<f64>; 3]) -> String {
    let row = |k: usize| {
        let [beta, p, r] = [0, 1, 2].map(|c| columns[c][k]);
        format!("{:.1},{beta:?},{p:?},{r:?}\n", f64::from(u32::try_from(k).unwrap()) / 10.0)
    };
    "time,beta,p,r\n".to_owned() + &(0..columns[0].len()).map(row).collect::<String>()
}

fn numbers<'a>(json: &'a Value, name: &'a str) -> impl Iterator<Item = f64> + 'a {
    json["parameters"].as_array().unwrap().iter().map(move |p| p[name].as_f64().unwrap())
}

fn codes(json: &Value) -> Vec<&str> {
    json["warnings"].as_array().unwrap().iter().map(|w| w["code"].as_str().unwrap()).collect()
}

fn parameter(json: &Value, name: &str) -> f64 {
    let all = json["parameters"].as_array().unwrap();
    all.iter().find(|p| p["name"] == name).unwrap()["value"].as_f64().unwrap()
}

#[test]
fn one_record_gives_the_same_numbers_from_every_kind_of_file() {
    let (folder, columns) = (Folder::new(), noisy());
    let file = folder.file("r.csv", csv(&columns));
    let (exit, from_csv) = json(&[&file, "--input", "beta", "--output", "p"]);
    assert_eq!(exit, Exit::Fine);
    assert_eq!(
        [&from_csv["format"], &from_csv["input"], &from_csv["output"]],
        ["csv", "beta", "p"]
    );
    assert_eq!(from_csv["sample_period_s"], 0.1);
    // 2000 samples less r and d, 54 parameters.
    assert_eq!(
        ["samples", "equations", "rank", "degrees_of_freedom"].map(|name| &from_csv[name]),
        [2000, 1950, 54, 1896]
    );
    assert_eq!(from_csv["parameters"].as_array().unwrap().len(), 54);
    assert_eq!(from_csv["warnings"], Value::Array(Vec::new()));

    let files = [
        ("c.npy", npy(&columns, Array::default())),
        ("fortran.npy", npy(&columns, Array { fortran_order: true, ..Array::default() })),
        ("big.npy", npy(&columns, Array { descr: ">f8", ..Array::default() })),
        ("big_fortran.npy", npy(&columns, Array { descr: ">f8", fortran_order: true })),
        ("r.f64", raw(&columns)),
    ];
    for (name, bytes) in files {
        let file = folder.file(name, bytes);
        let channels = if name == "r.f64" { &["--channels", "3"][..] } else { &[] };
        let words = [&[file.as_str(), "--input", "0", "--output", "1"], channels].concat();
        let (exit, found) = json(&words);
        assert_eq!((exit, &found["sample_period_s"]), (Exit::Fine, &Value::Null), "{name}");
        for what in ["orders", "samples", "equations", "rank", "segments", "warnings"] {
            assert_eq!(found[what], from_csv[what], "{name} {what}");
        }
        // One pass against several: both are the exact solution, rounded.
        for what in ["value", "deviation"] {
            for (a, b) in numbers(&found, what).zip(numbers(&from_csv, what)) {
                assert!((a - b).abs() <= 1e-14 * b.abs(), "{name} {what} {a} {b}");
            }
        }
        let residual = ["residual_norm", "relative_residual", "condition", "residual_rms"];
        for what in residual {
            let [a, b] = [&found, &from_csv].map(|json| json[what].as_f64().unwrap());
            assert!((a - b).abs() <= 1e-12 * b, "{name} {what} {a} {b}");
        }
    }
}

#[test]
fn numbers_of_four_bytes_are_what_they_stand_for() {
    let folder = Folder::new();
    #[expect(clippy::cast_possible_truncation, reason = "that is what is tested")]
    let columns = noisy().map(|c| c.iter().map(|x| f64::from(*x as f32)).collect::<Vec<_>>());
    let fit = |name: &str, array| {
        let file = folder.file(name, npy(&columns, array));
        json(&[&file, "--input", "2", "--output", "0"]).1["parameters"].take()
    };
    let eight = fit("eight.npy", Array::default());
    for (descr, fortran_order) in [("<f4", false), (">f4", false), (">f4", true)] {
        assert_eq!(fit("four.npy", Array { descr, fortran_order }), eight, "{descr}");
    }
}

/// y(k+1) = 0.5 y(k) + 2 u(k) + u(k-1), y(0) = `start`: a pole at 1/2, a zero at -1/2.
fn planted(samples: usize, start: f64, seed: u64) -> [Vec<f64>; 2] {
    let mut noise = noise(seed);
    let u: Vec<f64> = (0..samples).map(|_| noise()).collect();
    let mut y = vec![start];
    for k in 1..samples {
        y.push(0.5 * y[k - 1] + 2.0 * u[k - 1] + if k > 1 { u[k - 2] } else { 0.0 });
    }
    [u, y]
}

const PLANTED: [&str; 7] = ["--iir", "1", "--constant-term", "--causal", "2", "--anticausal", "1"];

fn is_planted(json: &Value) {
    for (name, value) in [("c_0", -0.5), ("h_-1", 0.0), ("h_0", 2.0), ("h_1", 1.0), ("h_2", 0.0)] {
        let found = parameter(json, name);
        assert!((found - value).abs() < 1e-12, "{name} {found}");
    }
    let poles = json["poles"].as_array().unwrap();
    assert_eq!(poles.len(), 1);
    assert!((poles[0]["re"].as_f64().unwrap() - 0.5).abs() < 1e-12);
    assert_eq!(poles[0]["im"], 0.0);
}

#[test]
fn a_record_longer_than_a_block_loses_no_equation() {
    let (folder, samples) = (Folder::new(), 300_000);
    let file = folder.file("long.npy", npy(&planted(samples, 0.0, 1), Array::default()));
    let words = [&[file.as_str(), "--input", "0", "--output", "1"][..], &PLANTED].concat();
    let (exit, found) = json(&words);
    is_planted(&found);
    assert_eq!(found["equations"], samples - 3);
    assert_eq!(found["segments"], 1);
    // Without noise the residual is rounding, and one pass cannot tell; the parameters are right all the same.
    assert_eq!((exit, codes(&found)), (Exit::Fine, vec!["residual-floor"]));
    for threads in ["1", "2", "8"] {
        assert_eq!(json(&[&words[..], &["--threads", threads]].concat()).1, found);
    }
}

#[test]
fn no_equation_reaches_across_a_gap() {
    let folder = Folder::new();
    // Two stretches that have nothing to do with one another; in between, one sample that only one channel misses.
    let [first, second] = [planted(700, 0.0, 1), planted(900, 50.0, 2)];
    let columns = [0, 1].map(|channel| {
        let between = if channel == 0 { 1.0 } else { f64::NAN };
        [&first[channel][..], &[between], &second[channel]].concat()
    });
    let check = |words: &[&str]| {
        let (exit, found) = json(&[words, &PLANTED].concat());
        assert_eq!(exit, Exit::Fine);
        is_planted(&found);
        let counts = ["samples", "missing_samples", "segments", "equations", "samples_used"];
        assert_eq!(counts.map(|name| &found[name]), [1601, 1, 2, 697 + 897, 1600]);
    };
    for fortran_order in [false, true] {
        let file =
            folder.file("gap.npy", npy(&columns, Array { fortran_order, ..Array::default() }));
        check(&[&file, "--input", "0", "--output", "1"]);
    }
    let file = folder.file("gap.f64", raw(&columns));
    check(&[&file, "--channels", "2", "--input", "0", "--output", "1"]);
    let row = |k: usize| format!("{k},{:?},{:?}\n", columns[0][k], columns[1][k]);
    let table = "t,u,y\n".to_owned() + &(0..1601).map(row).collect::<String>();
    let file = folder.file("gap.csv", table);
    check(&[&file, "--input", "u", "--output", "y"]);
}

#[test]
fn stretches_too_short_for_an_equation_are_told() {
    let folder = Folder::new();
    let [u, mut y] = planted(400, 0.0, 3);
    for gap in [3, 6] {
        y[gap] = f64::NAN;
    }
    let file = folder.file("gaps.npy", npy(&[u, y], Array::default()));
    let words = [&["fit", &file, "--input", "0", "--output", "1"][..], &PLANTED].concat();
    let ran = transmode(&words);
    assert_eq!(ran.exit, Exit::Fine);
    assert!(ran.out.contains("400 samples, 2 of them missing"), "{}", ran.out);
    let expected =
        "warning: 2 of 3 stretches between gaps are shorter than the 4 samples of one equation";
    assert!(ran.out.contains(expected), "{}", ran.out);
}

#[test]
fn what_the_record_does_not_determine_is_doubtful() {
    let folder = Folder::new();
    // D and the numerator may have any common factor.
    let file = folder.file("r.npy", npy(&planted(1000, 0.0, 4), Array::default()));
    let words = [&file, "--input", "0", "--output", "1", "--iir", "2", "--constant-term"];
    let (exit, found) = json(&words);
    assert_eq!(exit, Exit::Doubtful);
    assert!(codes(&found).contains(&"rank-deficient"), "{found}");
    assert_eq!((&found["rank"], found["parameters"].as_array().unwrap().len()), (&52.into(), 53));
    let c_1 = &found["parameters"][1];
    assert_eq!((&c_1["identifiable"], &c_1["deviation"]), (&Value::Bool(false), &Value::Null));
    let ran = transmode(&[&["fit"], &words[..]].concat());
    assert_eq!(ran.exit, Exit::Doubtful);
    assert!(
        ran.out.contains("warning: rank 52 of 53: the record does not determine c_0, c_1"),
        "{}",
        ran.out
    );
}

#[test]
fn rounding_that_only_a_second_pass_removes_is_doubtful() {
    let folder = Folder::new();
    // The shifted copies differ by 1e-11 of themselves.
    let mut noise = noise(5);
    let u: Vec<f64> = (0..1000).map(|_| 1.0 + 1e-11 * noise()).collect();
    let y: Vec<f64> = (0..1000).map(|k| u[k] + if k > 0 { u[k - 1] } else { 0.0 }).collect();
    let orders = ["--iir", "0", "--causal", "2", "--anticausal", "0"];
    let array = folder.file("r.npy", npy(&[u.clone(), y.clone()], Array::default()));
    let words = [&["fit", &array, "--input", "0", "--output", "1"][..], &orders].concat();
    let ran = transmode(&words);
    assert_eq!(ran.exit, Exit::Doubtful, "{}", ran.out);
    assert!(ran.out.contains("warning: rounding may have moved the parameters by"), "{}", ran.out);
    assert!(ran.out.contains("is not made for NPY and raw files"), "{}", ran.out);
    // In memory it is made.
    let row = |k: usize| format!("{k},{:?},{:?}\n", u[k], y[k]);
    let table = "t,u,y\n".to_owned() + &(0..1000).map(row).collect::<String>();
    let file = folder.file("r.csv", table);
    let (exit, found) =
        json(&[&[file.as_str(), "--input", "u", "--output", "y"][..], &orders].concat());
    assert_eq!((exit, codes(&found)), (Exit::Fine, Vec::new()), "{found}");
}

#[test]
fn the_terminal_shows_what_matters() {
    let aileron = shipped("noise_free_aileron.csv");
    let ran = transmode(&["fit", &aileron, "--input", "beta", "--output", "p"]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""), "{}", ran.out);
    let expected = [
        "transmissibility from beta to p: noise_free_aileron.csv, 2000 samples, every 0.1 s\n",
        "orders: l = 4, r = 25, d = 25\n",
        "fit: 1950 equations from 1 stretch, rank 54 of 54, condition number ",
        "residual: root mean square ",
        "poles in z: ",
        "largest 5 of 51",
    ];
    for text in expected {
        assert!(ran.out.contains(text), "{text:?} is missing in\n{}", ran.out);
    }
    // Five rows in descending order.
    let sizes: Vec<f64> = ran
        .out
        .lines()
        .filter_map(|line| line.trim().strip_prefix("h_"))
        .map(|row| row.split_whitespace().nth(1).unwrap().parse::<f64>().unwrap().abs())
        .collect();
    assert_eq!(sizes.len(), 5, "{}", ran.out);
    assert!(sizes.is_sorted_by(|a, b| a >= b), "{sizes:?}");
}

#[test]
fn json_goes_to_a_file_beside_the_text() {
    let (folder, aileron) = (Folder::new(), shipped("noise_free_aileron.csv"));
    let file = folder.path("fit.json");
    let words = ["fit", &aileron, "--input", "beta", "--output", "p", "--json"];
    let ran = transmode(&[&words[..], &[file.to_str().unwrap()]].concat());
    assert_eq!(ran.exit, Exit::Fine);
    assert!(ran.out.contains("poles in z"));
    let written: Value = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    let (_, alone) = json(&[&aileron, "--input", "beta", "--output", "p"]);
    assert_eq!(written, alone);
    assert_eq!(folder.names(), ["fit.json"]);
}

#[test]
fn help_has_examples() {
    let ran = transmode(&["fit", "--help"]);
    assert_eq!(ran.exit, Exit::Fine);
    for text in ["Examples:", "--channels", "NPY", "Exit codes: 0"] {
        assert!(ran.out.contains(text), "{text}");
    }
}
