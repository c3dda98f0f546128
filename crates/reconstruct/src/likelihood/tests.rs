use nalgebra::{DMatrix, DVector};
use serde_json::Value;

use super::*;
use crate::Channel;

/// Records and oracle of one pair.
pub(super) struct Oracle {
    pub(super) records: Vec<Record>,
    pub(super) value: Value,
}

fn read(path: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/");
    std::fs::read_to_string(format!("{folder}{path}")).unwrap()
}

fn record(pair: &str, tag: &str) -> Record {
    let text = read(&format!("records/{pair}_{tag}.csv"));
    let mut channels = ["beta", "p", "r"].map(|name| Channel::new(name, Vec::new()));
    for line in text.lines().skip(1) {
        for (channel, field) in channels.iter_mut().zip(line.split(',').skip(1)) {
            channel.values.push(field.parse().unwrap());
        }
    }
    Record::new(tag, lti::SamplePeriod::new(0.1).unwrap(), channels.to_vec()).unwrap()
}

pub(super) fn oracle(pair: &str) -> Oracle {
    let all: Value = serde_json::from_str(&read("likelihood.json")).unwrap();
    let records = vec![record(pair, "aileron"), record(pair, "rudder")];
    Oracle { records, value: all[pair].clone() }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn matrix(value: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = value.as_array().unwrap().iter().map(numbers).collect();
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, k| rows[i][k])
}

pub(super) fn start(value: &Value) -> SharedModel {
    let b = matrix(&value["start"]["b"]);
    SharedModel {
        a: matrix(&value["start"]["a"]),
        c: matrix(&value["start"]["c"]),
        b: b.column_iter().map(|column| column.into_owned()).collect(),
        feedthrough: None,
        period: lti::SamplePeriod::new(0.1).unwrap(),
    }
}

fn options(noise: NoiseModel, key: &str) -> LikelihoodOptions {
    let offsets = if key == "offsets_free" { Offsets::Free } else { Offsets::Zero };
    LikelihoodOptions { noise, offsets, ..LikelihoodOptions::default() }
}

#[test]
fn agrees_with_numpy_where_noise_levels_are_known() {
    for pair in ["white_snr100", "white_snr10", "multistep_snr100"] {
        let Oracle { records, value } = oracle(pair);
        for key in ["offsets_zero", "offsets_free"] {
            let part = &value[key];
            let options = options(NoiseModel::Given(numbers(&value["noise_true"])), key);
            let fit = maximise(&records, &[start(part)], &options).unwrap();
            let ratio = fit.chi_squared.per_degree_of_freedom();
            eprintln!("{pair} {key} {:?} {} {}", fit.search, ratio, part["known"]["chi_squared_per_degree"]);
            for pole in part["known"]["poles"].as_array().unwrap() {
                let get = |name: &str| pole[name].as_f64().unwrap();
                if get("im") < -1e-9 {
                    continue;
                }
                let s = num_complex::Complex::new(get("re"), get("im"));
                let mode = fit.modes.iter().min_by(|x, y| (x.continuous.value - s).norm().total_cmp(&(y.continuous.value - s).norm())).unwrap();
                let off = (mode.continuous.value - s).norm() / get("sd_re");
                eprintln!("   {s} {} off {off:.1e} sd ratio {:.4} {:.4}", mode.continuous.value, mode.continuous.real_deviation() / get("sd_re"), mode.continuous.imaginary_deviation() / get("sd_im"));
            }
        }
    }
}

#[test]
fn agrees_with_numpy_est() {
    for pair in ["white_snr100", "white_snr10", "multistep_snr100"] {
        let Oracle { records, value } = oracle(pair);
        for key in ["offsets_zero", "offsets_free"] {
            let part = &value[key];
            let options = options(NoiseModel::Estimated { first_guess: None }, key);
            let fit = maximise(&records, &[start(part)], &options).unwrap();
            let ratio = fit.chi_squared.per_degree_of_freedom();
            eprintln!("{pair} {key} {:?} {} {}", fit.search, ratio, part["known"]["chi_squared_per_degree"]);
            for (l, t) in fit.noise_levels.as_ref().unwrap().iter().zip(numbers(&value["noise_true"])) { eprintln!("   level {} {} true {t}", l.value, l.deviation); }
            for w in &fit.whiteness { eprintln!("  white {} {}", w.statistic, w.p_value); }
            for m in &fit.modes { eprintln!("  {} {}", m.continuous.value, m.continuous.real_deviation()); }
        }
    }
}
