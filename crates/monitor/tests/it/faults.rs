//! Faulty sensors: seen, soon, of the right kind, in the right sensor.

use monitor::{Change, Detector, Diagnosis, MonitorError, Options, Window};

use crate::flights::{ALL_PAIRS, Excitation, Simulator, channels, detector, part};

/// Samples of a new flight, and the one at which its fault begins.
const SAMPLES: usize = 4_000;
const FAULT: usize = 2_000;
const WINDOW: usize = 50;

/// What a sensor reads instead of `value`, `after` samples behind the beginning of the fault; its noise has the deviation `level`.
type Fault = fn(value: f64, first: f64, after: f64, level: f64) -> f64;

struct Bench {
    simulator: Simulator,
    detector: Detector,
}

impl Bench {
    fn new(excitation: Excitation) -> Self {
        let simulator = Simulator::new(excitation, 30.0);
        let reference = channels(&simulator.fly(8_000, 1));
        let options = Options { window: WINDOW, false_alarms: 1e-4 };
        let detector = detector(&reference, &ALL_PAIRS, options);
        Self { simulator, detector }
    }

    /// A flight with a fault in one sensor.
    fn with(&self, sensor: usize, seed: u64, fault: Fault) -> (Vec<Window>, Option<Diagnosis>) {
        let mut new = channels(&self.simulator.fly(SAMPLES, seed));
        let level = self.simulator.level(sensor);
        let first = new[sensor][FAULT];
        let mut after = 0.0;
        for value in &mut new[sensor][FAULT..] {
            *value = fault(*value, first, after, level);
            after += 1.0;
        }
        let stretch = [part(&new, 0..SAMPLES)];
        let windows = self.detector.watch(&stretch).unwrap();
        let diagnosis = self.detector.diagnose(&windows, &stretch).unwrap();
        (windows, diagnosis)
    }

    /// Expects an alarm about that kind of change within so many windows, and that sensor first among the suspects.
    fn check(&self, sensor: usize, fault: Fault, change: Change, delay: usize) {
        for seed in [70, 71, 72] {
            let (windows, diagnosis) = self.with(sensor, seed, fault);
            let found = diagnosis.unwrap();
            let window = &windows[found.first_alarm];
            let what = format!("sensor {sensor}, {change}, seed {seed}: {found:?} {window:?}");
            assert!(window.known_at >= FAULT, "{what}");
            assert!(window.known_at <= FAULT + delay * WINDOW + self.detector.margin(), "{what}");
            assert_eq!(found.change, change, "{what}");
            assert!(found.suspects.contains(&sensor), "{what}");
        }
    }
}

const BIAS: Fault = |value, _, _, level| value + 20.0 * level;
const DRIFT: Fault = |value, _, after, level| value + 0.1 * level * after;
/// Noise of four times the usual deviation.
const NOISE: Fault = |value, _, after, level| {
    let uniform = (after * 0.618_033_988_749_895).fract() - 0.5;
    value + 4.0 * 12.0_f64.sqrt() * level * uniform
};
const LOUD: Fault = |value, first, after, level| NOISE(value, first, after, 4.0 * level);
const FREEZE: Fault = |_, first, _, _| first;
const NONE: Fault = |value, _, _, _| value;

#[test]
fn healthy_sensors_raise_none() {
    let bench = Bench::new(Excitation::White);
    for seed in [70, 71, 72] {
        assert_eq!(bench.with(0, seed, NONE).1, None);
    }
}

#[test]
fn a_frozen_sensor_is_named_at_once() {
    for excitation in [Excitation::White, Excitation::LowPass] {
        let bench = Bench::new(excitation);
        for sensor in 0..3 {
            bench.check(sensor, FREEZE, Change::Freeze, 2);
            assert_eq!(bench.with(sensor, 70, FREEZE).1.unwrap().suspects, [sensor]);
        }
    }
}

#[test]
fn added_noise() {
    let bench = Bench::new(Excitation::White);
    for sensor in [0, 2] {
        bench.check(sensor, NOISE, Change::Noise, 2);
    }
    // The pair of roll rate is dominated by the vane's noise, so that it takes more.
    bench.check(1, LOUD, Change::Noise, 2);
}

#[test]
fn a_bias() {
    let bench = Bench::new(Excitation::White);
    for sensor in [0, 2] {
        bench.check(sensor, BIAS, Change::Bias, 2);
    }
}

#[test]
fn a_drift() {
    let bench = Bench::new(Excitation::White);
    for sensor in [0, 2] {
        bench.check(sensor, DRIFT, Change::Drift, 6);
    }
}

#[test]
fn what_cannot_be_calibrated_is_refused() {
    let bench = Bench::new(Excitation::White);
    let links = || bench.detector.links().to_vec();
    let healthy = channels(&bench.simulator.fly(2_000, 5));
    let all = || vec![part(&healthy, 0..2_000)];
    let good = Options { window: WINDOW, false_alarms: 1e-3 };
    let calibrate =
        |links, options| Detector::calibrate(links, &all(), &all(), options).map(|_| ());
    assert_eq!(calibrate(links(), good), Ok(()));
    assert_eq!(calibrate(Vec::new(), good), Err(MonitorError::NoLink));
    let long = calibrate(links(), Options { window: 500, ..good });
    assert!(
        matches!(long, Err(MonitorError::TooFewWindows { needed: 14, links: 2, .. })),
        "{long:?}"
    );
    for false_alarms in [0.0, -1.0, 0.5, f64::NAN] {
        let bad = calibrate(links(), Options { false_alarms, ..good });
        assert!(matches!(bad, Err(MonitorError::BadOption { .. })), "{bad:?}");
    }
    let bad = calibrate(links(), Options { window: 1, ..good });
    assert!(matches!(bad, Err(MonitorError::BadOption { .. })), "{bad:?}");
    let mut missing = links();
    missing[0].output = 3;
    let bad = calibrate(missing, good);
    assert!(
        matches!(bad, Err(MonitorError::NoSuchChannel { output: 3, channels: 3, .. })),
        "{bad:?}"
    );
    let still: Vec<Vec<f64>> = vec![vec![0.0; 2_000]; 3];
    let still = Detector::calibrate(links(), &all(), &[part(&still, 0..2_000)], good).map(|_| ());
    assert_eq!(still, Err(MonitorError::Degenerate));
    // A stretch that is too short for a window gives none.
    assert_eq!(bench.detector.watch(&[part(&healthy, 0..60)]).unwrap(), []);
    assert!(bench.detector.watch(&[vec![&healthy[0]]]).is_err());
}
