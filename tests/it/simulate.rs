//! `transmode simulate`: the files it writes, what is true of them, and what it refuses.

use serde_json::Value;
use transmode::Exit;

use crate::program::{Folder, transmode};

/// A description of an aircraft that may fly.
const TRAINER: &str = r#"
name = "trainer"
[derivatives]
trim_speed_ft_s = 200.0
y_beta_ft_s2 = -45.0
l_beta_per_s2 = -16.0
l_p_per_s = -8.4
l_r_per_s = 2.2
n_beta_per_s2 = 4.5
n_p_per_s = -0.35
n_r_per_s = -0.76
l_aileron_per_s2 = 28.0
n_aileron_per_s2 = -0.2
y_rudder_ft_s2 = 12.0
l_rudder_per_s2 = 2.5
n_rudder_per_s2 = -4.6
[inertia]
ixx_slug_ft2 = 1000.0
izz_slug_ft2 = 3500.0
ixz_slug_ft2 = 0.0
"#;

fn bytes(folder: &Folder, name: &str) -> Vec<u8> {
    std::fs::read(folder.path(name)).unwrap()
}

fn truth(folder: &Folder, name: &str) -> Value {
    serde_json::from_slice(&bytes(folder, &format!("{name}/truth.json"))).unwrap()
}

/// Simulates into a new folder of that name.
fn simulate(folder: &Folder, name: &str, words: &[&str]) {
    let place = folder.path(name);
    let fixed = ["simulate", "paper", "-o", place.to_str().unwrap()];
    let ran = transmode(&[&fixed[..], words].concat());
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""), "{words:?}");
    assert!(ran.out.contains("truth.json"));
}

fn readings(folder: &Folder, name: &str) -> Vec<Vec<f64>> {
    let text = String::from_utf8(bytes(folder, name)).unwrap();
    let row = |line: &str| line.split(',').map(|field| field.parse().unwrap()).collect();
    text.lines().skip(1).map(row).collect()
}

/// Root mean square of the difference of two records in each column but time.
fn difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<f64> {
    let squares = |column: usize| -> f64 {
        a.iter().zip(b).map(|(a, b)| (a[column] - b[column]).powi(2)).sum()
    };
    (1..a[0].len()).map(|column| (squares(column) / a.len() as f64).sqrt()).collect()
}

#[test]
fn one_record_for_each_surface_and_the_truth() {
    let folder = Folder::new();
    simulate(&folder, "flights", &["--duration", "30"]);
    let aileron = String::from_utf8(bytes(&folder, "flights/aileron.csv")).unwrap();
    assert!(aileron.starts_with("time [s],beta [rad],p [rad/s],r [rad/s]\n0,"));
    assert_eq!(aileron.lines().count(), 301);
    assert!(aileron.contains("\n0.3,"), "time is not spoilt by rounding");
    let truth = truth(&folder, "flights");
    let modes = truth["modes"].as_array().unwrap();
    let roll = modes.iter().find(|mode| mode["name"] == "roll subsidence").unwrap();
    // tests/data/reference.json /aircraft/spec_A
    let eigenvalue = roll["eigenvalue"]["re"].as_f64().unwrap();
    assert!((eigenvalue + 0.545_562_845_619_248_3).abs() < 1e-12);
    assert_eq!(truth["records"][1]["file"], "rudder.csv");
    assert_eq!(truth["records"][1]["surfaces"][0], "rudder");
    assert_eq!(truth["b"]["rudder"].as_array().unwrap().len(), 4);
    assert_eq!((&truth["seed"], &truth["samples"]), (&1.into(), &300.into()));
}

#[test]
fn the_same_seed_gives_the_same_bytes_and_another_one_does_not() {
    let folder = Folder::new();
    for excitation in ["white", "multistep", "doublet", "lowpass"] {
        let words = ["--excitation", excitation, "--gust", "0.01", "--duration", "60"];
        let name = |text: &str| format!("{excitation}-{text}");
        simulate(&folder, &name("a"), &words);
        simulate(&folder, &name("b"), &words);
        simulate(&folder, &name("c"), &[&words[..], &["--seed", "2"]].concat());
        for file in ["aileron.csv", "rudder.csv", "truth.json"] {
            let of = |text: &str| bytes(&folder, &format!("{}/{file}", name(text)));
            assert_eq!(of("a"), of("b"), "{excitation} {file}");
            assert_ne!(of("a"), of("c"), "{excitation} {file}");
        }
    }
}

#[test]
fn noise_has_the_size_that_the_truth_states() {
    let folder = Folder::new();
    simulate(&folder, "clean", &["--noise", "none"]);
    simulate(&folder, "noisy", &["--noise", "snr=20"]);
    let of = |name: &str| readings(&folder, &format!("{name}/aileron.csv"));
    let (clean, noisy) = (of("clean"), of("noisy"));
    let levels = truth(&folder, "noisy")["noise_levels"].clone();
    for (sensor, found) in ["beta", "p", "r"].iter().zip(difference(&clean, &noisy)) {
        let stated = levels[sensor].as_f64().unwrap();
        // 2000 samples: the deviation is known to 1.6 %.
        assert!((found / stated - 1.0).abs() < 0.08, "{sensor}: {found} {stated}");
    }
}

#[test]
fn gusts_have_the_size_that_was_asked_for() {
    let folder = Folder::new();
    // Sideslip does nothing to this aircraft, so that its vane reads the gust alone.
    let deaf = ["y_beta_ft_s2 = -45.0", "l_beta_per_s2 = -16.0", "n_beta_per_s2 = 4.5"];
    let text = deaf.iter().fold(TRAINER.to_owned(), |text, line| {
        let (name, _) = line.split_once('=').unwrap();
        text.replacen(line, &format!("{name}= 0.0"), 1)
    });
    let toml = folder.file("deaf.toml", text);
    let place = folder.path("flight");
    let words = ["simulate", &toml, "--excitation", "none", "--noise", "none", "--outputs", "beta"];
    let more = ["--gust", "0.02", "--duration", "20000", "-o", place.to_str().unwrap()];
    let ran = transmode(&[&words[..], &more].concat());
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let rows = readings(&folder, "flight/quiet.csv");
    let mean =
        |of: &dyn Fn(usize) -> f64, count: usize| (0..count).map(of).sum::<f64>() / count as f64;
    // In 20000 times its time constant of 1 s the deviation of a gust is known to 0.5 %.
    let square = mean(&|k| rows[k][1].powi(2), rows.len());
    assert!((square.sqrt() / 0.02 - 1.0).abs() < 0.025, "{}", square.sqrt());
    // Ten samples are a time constant: correlated by 1/e.
    let product = mean(&|k| rows[k][1] * rows[k + 10][1], rows.len() - 10);
    assert!((product / square - (-1.0_f64).exp()).abs() < 0.03, "{}", product / square);
}

#[test]
fn identify_finds_what_the_truth_states() {
    let folder = Folder::new();
    simulate(&folder, "flights", &["--noise", "none", "--excitation", "multistep"]);
    let [aileron, rudder] = ["aileron", "rudder"]
        .map(|name| folder.path(&format!("flights/{name}.csv")).to_str().unwrap().to_owned());
    let words = ["identify", &aileron, &rudder, "--method", "as-printed", "--json", "-"];
    let ran = transmode(&words);
    assert_eq!(ran.exit, Exit::Fine, "{}{}", ran.out, ran.err);
    let found: Value = serde_json::from_str(&ran.out).unwrap();
    let truth = truth(&folder, "flights");
    for mode in truth["modes"].as_array().unwrap() {
        let is_same = |other: &&Value| other["name"] == mode["name"];
        let found = found["modes"].as_array().unwrap().iter().find(is_same).unwrap();
        for part in ["re", "im"] {
            let of = |mode: &Value| mode["eigenvalue"][part].as_f64().unwrap();
            assert!((of(mode) - of(found)).abs() < 1e-6, "{mode} {found}");
        }
    }
}

#[test]
fn both_surfaces_at_once_and_none() {
    let folder = Folder::new();
    simulate(&folder, "both", &["--surface", "both", "--with-quiet", "--duration", "20"]);
    assert_eq!(truth(&folder, "both")["records"][0]["surfaces"].as_array().unwrap().len(), 2);
    let quiet = ["--excitation", "none", "--noise", "p=0.1", "--duration", "20"];
    simulate(&folder, "quiet", &quiet);
    let rows = readings(&folder, "quiet/quiet.csv");
    assert!(rows.iter().all(|row| row[1].abs() < 1e-300) && rows.iter().any(|row| row[2] != 0.0));
    let names: Vec<String> = std::fs::read_dir(folder.path("both"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(names.len(), 3, "{names:?}");
}

#[test]
fn an_aircraft_from_a_file() {
    let folder = Folder::new();
    let toml = folder.file("trainer.toml", TRAINER);
    let place = folder.path("flights");
    let words = ["simulate", &toml, "--duration", "20", "-o", place.to_str().unwrap()];
    let ran = transmode(&words);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    let truth = truth(&folder, "flights");
    assert_eq!(truth["aircraft"]["name"], "trainer");
    // Y_dr over U0, as the units require.
    assert_eq!(truth["b"]["rudder"][0], 12.0 / 200.0);
    assert_eq!(truth["a"][0][3], 32.174 / 200.0);

    let refuses = |name: &str, text: &str, expected: &str| {
        let file = folder.file(name, text);
        transmode(&["simulate", &file, "-o", folder.path("none").to_str().unwrap()])
            .refused(expected);
        assert!(!folder.path("none").exists());
    };
    let changed = |from: &str, to: &str| TRAINER.replacen(from, to, 1);
    refuses("a.toml", &changed("l_p_per_s = -8.4\n", ""), "missing field `l_p_per_s`");
    refuses("a.toml", &changed("l_p_per_s", "L_p"), "a.toml: line 7: unknown field `L_p`");
    refuses("a.toml", &changed("200.0", "-200.0"), "trim_speed_ft_s is -200");
    refuses("a.toml", &changed("1000.0", "\"heavy\""), "line 18: invalid type: string \"heavy\"");
    refuses("a.toml", "name =", "a.toml: line 1");
    refuses("a.json", "{", "a.json: EOF while parsing");
    refuses("a.txt", TRAINER, "a file that ends in .toml or .json");
    // Roots far to the right: 1e10 seconds do not help.
    refuses("a.toml", &changed("-8.4", "800.0"), "leaves the range of numbers");
}

#[test]
fn nothing_is_replaced_without_force() {
    let folder = Folder::new();
    let words = ["--duration", "20"];
    simulate(&folder, "flights", &words);
    let before = bytes(&folder, "flights/aileron.csv");
    let place = folder.path("flights");
    let again = ["simulate", "paper", "--seed", "9", "--duration", "20", "-o"];
    let again = [&again[..], &[place.to_str().unwrap()]].concat();
    transmode(&again).refused("aileron.csv is there already; choose another folder");
    assert_eq!(bytes(&folder, "flights/aileron.csv"), before);
    assert_eq!(transmode(&[&again[..], &["--force"]].concat()).exit, Exit::Fine);
    assert_ne!(bytes(&folder, "flights/aileron.csv"), before);
    // With a record that stays there would be no truth of it any more.
    let quiet = [&again[..], &["--force", "--with-quiet"]].concat();
    assert_eq!(transmode(&quiet).exit, Exit::Fine);
    let truth = bytes(&folder, "flights/truth.json");
    transmode(&[&again[..], &["--force"]].concat())
        .refused("quiet.csv is of an earlier simulation, whose truth.json would be replaced");
    assert_eq!(bytes(&folder, "flights/truth.json"), truth);
    // A folder above that is not there, and a file that is no folder.
    let missing = folder.path("no/where");
    transmode(&["simulate", "paper", "-o", missing.to_str().unwrap()]).refused("cannot write");
    let file = folder.file("file", "");
    transmode(&["simulate", "paper", "-o", &file]).refused("cannot write");
}

#[test]
fn words_that_cannot_be() {
    let folder = Folder::new();
    let place = folder.path("none").to_str().unwrap().to_owned();
    let check = |words: &[&str], expected: &str| {
        let ran = transmode(&[&["simulate", "paper", "-o", &place], words].concat());
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""), "{words:?}");
        assert!(ran.err.contains(expected), "{words:?}\n{}", ran.err);
        assert!(folder.names().is_empty());
    };
    check(&["--excitation", "sine"], "invalid value 'sine'");
    check(&["--surface", "flap"], "invalid value 'flap'");
    check(&["--amplitude", "0"], "a positive number is needed");
    check(&["--duration", "-1"], "a positive number is needed");
    check(&["--duration", "0.1"], "are 1 samples; 2 to 10000000 are possible");
    check(&["--duration", "1e300"], "10000000 are possible");
    check(&["--sample-period", "0"], "a sample period is a number of seconds");
    check(&["--gust", "-0.1"], "a number that is not negative is needed");
    check(&["--gust", "nan"], "a number that is not negative is needed");
    check(&["--seed", "-1"], "a seed is a whole number from 0");
    check(&["--noise", "loud"], "noise is written snr=100");
    check(&["--noise", "phi=0.1"], "--noise gives phi, which is not among the --outputs");
    check(&["--outputs", "beta,q"], "the sensors are beta, p, r and phi");
    check(&["--outputs", "beta,p,beta"], "--outputs names beta twice");
    check(&["--excitation", "none"], "--noise snr=100 is a ratio to the response");
    check(
        &["--excitation", "none", "--surface", "both", "--noise", "none"],
        "--excitation none moves no surface, so that --surface has no meaning",
    );
    let ran = transmode(&["simulate", "747", "-o", &place]);
    ran.refused("\"747\" is neither an aircraft of the catalog (paper");
}
