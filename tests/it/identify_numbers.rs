//! The JSON of `transmode identify` holds the library's own numbers, and is of the form that its schema describes.

use reconstruct::subspace::OrderChoice;
use reconstruct::{Channel, Method, NoiseModel, Options, Reconstruction, Record, reconstruct};
use serde_json::Value;
use transmode::Exit;

use crate::program::{shipped, transmode};

/// The schema that docs/ publishes.
pub(crate) fn valid(json: &Value) {
    let schema: Value =
        serde_json::from_str(include_str!("../../docs/identify.schema.json")).unwrap();
    let validator = jsonschema::draft202012::new(&schema).unwrap();
    let faults: Vec<_> = validator
        .iter_errors(json)
        .map(|error| format!("{error} at {}", error.instance_path()))
        .collect();
    assert!(faults.is_empty(), "{faults:?}\n{json:#}");
}

/// A shipped record with beta, p and r.
fn record(file: &str) -> Record {
    let text = std::fs::read_to_string(shipped(file)).unwrap();
    let mut columns = vec![Vec::new(); 3];
    for line in text.lines().skip(1) {
        let fields = line.split(',').skip(1).take(3);
        for (column, field) in columns.iter_mut().zip(fields) {
            column.push(field.parse().unwrap());
        }
    }
    let channels = ["beta", "p", "r"]
        .into_iter()
        .zip(columns)
        .map(|(name, values)| Channel::new(name, values));
    let period = lti::SamplePeriod::new(0.1).unwrap();
    Record::new(file, period, channels.collect()).unwrap()
}

fn same(found: &Value, expected: f64, what: &str) {
    if expected.is_finite() {
        let found = found.as_f64().unwrap_or_else(|| panic!("{what} is {found}"));
        assert_eq!(found.to_bits(), expected.to_bits(), "{what}: {found}, {expected}");
    } else {
        assert!(found.is_null(), "{what}: {found}");
    }
}

fn same_modes(json: &Value, whole: &Reconstruction) {
    let mut modes: Vec<_> = whole.modes.iter().collect();
    modes.sort_by(|a, b| b.mode.natural_frequency_rad_s.total_cmp(&a.mode.natural_frequency_rad_s));
    let found = json["modes"].as_array().unwrap();
    assert_eq!(found.len(), modes.len());
    for (found, expected) in found.iter().zip(modes) {
        let mode = &expected.mode;
        same(&found["eigenvalue"]["re"], mode.eigenvalue.re, "re");
        same(&found["eigenvalue"]["im"], mode.eigenvalue.im, "im");
        same(&found["frequency_rad_s"], mode.natural_frequency_rad_s, "frequency");
        same(&found["damping_ratio"], mode.damping_ratio, "damping");
        same(&found["time_to_half_or_double_s"], mode.time_to_half_or_double_s, "half or double");
        match mode.time_constant_s {
            Some(time_constant_s) => same(&found["time_constant_s"], time_constant_s, "constant"),
            None => assert!(found["time_constant_s"].is_null()),
        }
        // At an eigenvalue the sensors stand in a fixed ratio: C v, whatever the basis of the states.
        if let (Some(model), Some(vector)) = (whole.model(), &mode.eigenvector) {
            let shape = model.c.map(num_complex::Complex::from) * vector;
            let part = |k: usize| {
                let part = &found["shape"][k];
                num_complex::Complex::new(
                    part["re"].as_f64().unwrap(),
                    part["im"].as_f64().unwrap(),
                )
            };
            let largest = (0..3).map(|k| part(k).norm()).fold(0.0, f64::max);
            assert!((largest - 1.0).abs() < 1e-12, "{largest}");
            for k in 1..3 {
                assert!((part(k) * shape[0] - part(0) * shape[k]).norm() < 1e-9 * shape.norm());
            }
        }
        let Some(estimate) = &expected.estimate else {
            assert!(found["deviation"].is_null() && found["damping_ratio_interval_95"].is_null());
            continue;
        };
        same(&found["deviation"]["re"], estimate.continuous.real_standard_error(), "deviation");
        same(
            &found["deviation"]["im"],
            estimate.continuous.imaginary_standard_error(),
            "deviation",
        );
        match expected.interval_95 {
            Some(interval) => {
                for (end, expected) in interval.into_iter().enumerate() {
                    same(&found["eigenvalue_interval_95"][end], expected, "interval");
                }
            }
            None => assert!(found["eigenvalue_interval_95"].is_null()),
        }
        let [low, high] = estimate.natural_frequency_rad_s.interval_95();
        same(&found["frequency_interval_95_rad_s"][0], low, "low");
        same(&found["frequency_interval_95_rad_s"][1], high, "high");
    }
}

/// The program and the library on a pair of shipped records, with options said in both ways.
fn agree(pair: &str, words: &[&str], change: impl FnOnce(&mut Options)) -> Value {
    let files = [format!("{pair}_aileron.csv"), format!("{pair}_rudder.csv")];
    let records = files.each_ref().map(|file| record(file));
    let mut options = Options::default();
    change(&mut options);
    options.profile = true;
    let expected = reconstruct(&records, &options).unwrap();

    let [aileron, rudder] = files.map(|file| shipped(&file));
    let identify = ["identify", &aileron, &rudder, "--outputs", "beta,p,r", "--json", "-"];
    let ran = transmode(&[&identify[..], words].concat());
    assert_eq!(ran.err, "");
    let json: Value = serde_json::from_str(&ran.out).unwrap();
    valid(&json);
    same_modes(&json, &expected);
    let doubtful = !expected.doubts.is_empty();
    assert_eq!(ran.exit, if doubtful { Exit::Doubtful } else { Exit::Fine });
    let texts: Vec<_> = expected.doubts.iter().map(ToString::to_string).collect();
    let warnings: Vec<_> = json["warnings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|warning| warning["text"].as_str().unwrap().to_owned())
        .collect();
    assert_eq!(warnings, texts);
    if let Some(order) = expected.order() {
        assert_eq!(json["order"], order.order);
        same(&json["order_evidence"]["gap"], order.gap, "gap");
    }
    for (found, expected) in
        json["noise"].as_array().unwrap().iter().zip(expected.noise_levels().into_iter().flatten())
    {
        same(&found["deviation"], expected.value, "level");
    }
    let sensors = if expected.noise_levels().is_some() { 3 } else { 0 };
    assert_eq!(json["noise"].as_array().unwrap().len(), sensors);
    let goodness = expected.fit().map(|fit| &fit.chi_squared);
    same(
        &json["goodness"]["chi2_per_dof"],
        goodness.map_or(f64::NAN, |found| found.per_degree_of_freedom()),
        "chi2",
    );
    let p_value = goodness.and_then(|found| found.p_value);
    same(&json["goodness"]["p_value"], p_value.unwrap_or(f64::NAN), "p");
    for (found, expected) in json["records"].as_array().unwrap().iter().zip(expected.excitations())
    {
        assert_eq!(found["excitation_rank"], expected.rank);
    }
    json
}

const PAIRS: [&str; 4] = ["noise_free", "white_snr100", "white_snr10", "multistep_snr100"];

#[test]
fn maximum_likelihood() {
    for pair in PAIRS {
        let json = agree(pair, &[], |_| ());
        assert_eq!(json["method"], "ml");
        assert!(json["modes"][0]["deviation"]["re"].is_number());
        assert!(json["transmissibilities"].is_null());
    }
}

#[test]
fn signal_subspaces() {
    for pair in PAIRS {
        let json = agree(pair, &["--method", "subspace"], |options| {
            options.method = Method::Subspace;
        });
        assert_eq!(json["method"], "subspace");
        assert!(json["search"].is_null());
    }
}

#[test]
fn as_printed() {
    for pair in PAIRS {
        let json = agree(pair, &["--method", "as-printed"], |options| {
            options.method = Method::Paper;
        });
        assert_eq!(json["transmissibilities"].as_array().unwrap().len(), 4);
        assert!(json["noise_origin"].is_null() && json["records"][0]["excitation_rank"].is_null());
    }
}

#[test]
fn order_and_noise_as_given() {
    let json =
        agree("white_snr100", &["--order", "4", "--noise", "0.0297,0.0759,0.0592"], |options| {
            options.order = OrderChoice::Fixed(4);
            options.noise = NoiseModel::Levels(vec![0.0297, 0.0759, 0.0592]);
        });
    assert_eq!(json["noise_origin"], "given");
    let p_value = json["goodness"]["p_value"].as_f64().unwrap();
    assert!((1e-3..=1.0).contains(&p_value), "{p_value}");
    assert_eq!(json["order_evidence"]["asked"], true);
}

#[test]
fn offsets_trend_band_and_feedthrough_as_given() {
    let words = [
        "--offsets",
        "0.1,0.2,0.3",
        "--trend",
        "--band",
        "0.05:20",
        "--feedthrough",
        "r,beta",
        "--order",
        "4",
    ];
    let json = agree("white_snr100", &words, |options| {
        options.measurement.offsets = reconstruct::Offsets::PriorDeviation(vec![0.1, 0.2, 0.3]);
        options.measurement.trend = reconstruct::Trend::Linear;
        options.band = Some(reconstruct::likelihood::FrequencyBand {
            lowest_rad_s: 0.05,
            highest_rad_s: 20.0,
        });
        options.measurement.feedthrough_sensors = vec![2, 0];
        options.order = OrderChoice::Fixed(4);
    });
    assert_eq!(json["band_rad_s"], serde_json::json!([0.05, 20.0]));
    agree("white_snr100", &["--offsets", "free"], |options| {
        options.measurement.offsets = reconstruct::Offsets::Free;
    });
    for (word, hold) in [
        ("zero-order", reconstruct::likelihood::Hold::ZeroOrder),
        ("first-order", reconstruct::likelihood::Hold::FirstOrder),
    ] {
        let json = agree("white_snr100", &["--hold", word, "--order", "4"], |options| {
            options.hold = Some(hold);
            options.order = OrderChoice::Fixed(4);
        });
        assert_eq!(json["hold"]["order"], if word == "zero-order" { 0 } else { 1 });
        assert!(json["hold"]["evidence"].is_null());
    }
}
