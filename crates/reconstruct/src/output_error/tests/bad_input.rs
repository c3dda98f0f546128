use super::*;
use crate::ReconstructError;
use crate::subspace::OrderChoice;

type Change = fn(&mut RecordedInputs, &mut Options);

fn refused(change: Change) -> String {
    let (records, mut inputs) = flights(&[Flown { samples: 200, ..BOTH }], 1);
    let mut options = Options::default();
    change(&mut inputs, &mut options);
    match identify(&records, &inputs, &options) {
        Err(ReconstructError::Option { name, message }) => format!("{name}: {message}"),
        other => format!("{other:?}"),
    }
}

#[test]
fn inputs_and_options_that_do_not_fit() {
    let cases: [(Change, &str); 10] = [
        (
            |inputs, _| {
                inputs.signals[0][1] =
                    inputs.signals[0][0].iter().map(|value| -2.0 * value).collect();
            },
            "\"rudder\" is a multiple of \"aileron\"",
        ),
        (
            |_, options| {
                options.structure = Structure::Lateral;
                options.order = OrderChoice::Fixed(6);
            },
            "the lateral equations have 4 states",
        ),
        (|inputs, _| inputs.names.clear(), "recorded inputs: there are none"),
        (|inputs, _| inputs.signals.clear(), "recorded inputs: lists for 0 of 1 records"),
        (|inputs, _| inputs.signals[0].truncate(1), "has 1 of 2 inputs"),
        (
            |inputs, _| inputs.signals[0][0].truncate(199),
            "has 200 samples, its input \"aileron\" 199",
        ),
        (
            |inputs, _| inputs.signals[0][1][3] = f64::NAN,
            "input \"rudder\" of record \"flight\" is not finite",
        ),
        (|inputs, _| inputs.signals[0][1].fill(2.0), "input \"rudder\" moves in no record"),
        (|_, options| options.sensor_lags = vec![Lag::Free], "lags of sensors: 1 for 3"),
        (|_, options| options.input_lags = vec![Lag::Given(f64::NAN); 2], "one is not finite"),
    ];
    for (change, expected) in cases {
        let message = refused(change);
        assert!(message.contains(expected), "{message}, not {expected}");
    }
}

#[test]
fn lateral_equations_need_their_sensors() {
    let (records, inputs) = flights(&[Flown { samples: 200, ..BOTH }], 1);
    let renamed: Vec<_> = records[0]
        .channels()
        .iter()
        .map(|channel| Channel::new(format!("{}1", channel.name), channel.values.clone()))
        .collect();
    let record = Record::new("other", records[0].period(), renamed).unwrap();
    let options = Options { structure: Structure::Lateral, ..Options::default() };
    let error = identify(std::slice::from_ref(&record), &inputs, &options).unwrap_err();
    assert!(error.to_string().contains("need sensors beta, p and r"), "{error}");
    // A black box does not mind.
    let fit = identify(&[record], &inputs, &Options::default()).unwrap();
    assert!(fit.derivatives.is_empty());
}

#[test]
fn no_record_and_records_that_are_too_short() {
    let (records, inputs) = flights(&[Flown { samples: 200, ..BOTH }], 1);
    let none = RecordedInputs { signals: Vec::new(), ..inputs.clone() };
    assert!(matches!(
        identify(&[], &none, &Options::default()),
        Err(ReconstructError::TooFewRecords { .. })
    ));
    for samples in [1, 2, 3, 5, 9, 14] {
        let cut = records[0]
            .channels()
            .iter()
            .map(|channel| Channel::new(channel.name.clone(), channel.values[..samples].to_vec()));
        let record = Record::new("short", records[0].period(), cut.collect()).unwrap();
        let signals = inputs.signals[0].iter().map(|signal| signal[..samples].to_vec()).collect();
        let inputs = RecordedInputs { signals: vec![signals], ..inputs.clone() };
        // An error or a result, but no panic.
        let _ = identify(&[record], &inputs, &Options::default());
    }
}

#[test]
fn scales_do_not_matter() {
    for scale in [1e-100, 1e100] {
        let (records, mut inputs) = flights(&[Flown { samples: 600, ..BOTH }], 2);
        let scaled = records[0].channels().iter().map(|channel| {
            let values = channel.values.iter().map(|value| value * scale).collect();
            Channel::new(format!("y_{}", channel.name), values)
        });
        let record = Record::new("scaled", records[0].period(), scaled.collect()).unwrap();
        for signal in &mut inputs.signals[0] {
            signal.iter_mut().for_each(|value| *value /= scale);
        }
        let fit = identify(&[record], &inputs, &Options::default()).unwrap();
        let off = error(&fit.modes, &eigenvalues());
        assert!(off < 0.05, "{scale:e}: {off}");
    }
}
