use super::*;

/// A smooth signal with noise of a hundredth.
fn signal() -> Vec<f64> {
    let mut random = flight::Stream::new(1, 0);
    (0..2000_u32).map(|k| (f64::from(k) / 30.0).sin() + 0.003 * random.normal()).collect()
}

#[test]
fn a_sound_signal_has_nothing_odd() {
    let found = Signal::of(&signal());
    assert_eq!(
        (found.outlier_count, found.stuck, found.saturated, found.missing),
        (0, None, None, 0)
    );
    assert!((found.rms - 0.5_f64.sqrt()).abs() < 0.01 && found.mean.abs() < 0.03);
    // Quiet, then a manoeuvre: large second differences, but none alone.
    let mut manoeuvre = signal();
    manoeuvre[1500..]
        .iter_mut()
        .enumerate()
        .for_each(|(k, x)| *x += (0.3 * f64::from(u32::try_from(k).unwrap())).sin());
    assert_eq!(Signal::of(&manoeuvre).outlier_count, 0);
}

#[test]
fn planted_faults_are_found_where_they_are() {
    let mut values = signal();
    values[700] += 0.5;
    values[1300] -= 0.5;
    values[900] = f64::NAN;
    let found = Signal::of(&values);
    assert_eq!(
        (found.outliers.as_slice(), found.outlier_count, found.missing),
        (&[700, 1300][..], 2, 1)
    );

    let mut values = signal();
    let held = values[400];
    values[400..440].fill(held);
    assert_eq!(Signal::of(&values).stuck, Some((400, 40)));

    let values: Vec<f64> = signal().iter().map(|x| x.min(0.8)).collect();
    let Some((edge, count)) = Signal::of(&values).saturated else { panic!("not found") };
    assert_eq!(edge.to_bits(), 0.8_f64.to_bits());
    assert!(count > 100, "{count}");
}

#[test]
fn a_coarse_sensor_is_neither_stuck_nor_saturated() {
    let coarse: Vec<f64> = signal().iter().map(|x| (x * 4.0).round() / 4.0).collect();
    let found = Signal::of(&coarse);
    assert_eq!((found.stuck, found.saturated), (None, None));
}

#[test]
fn a_dead_channel_is_constant() {
    assert!(Signal::of(&[1.5; 100]).is_constant());
    assert!(Signal::of(&[f64::NAN; 100]).is_constant());
    assert!(Signal::of(&[]).is_constant());
    assert!(!Signal::of(&[1.0, 2.0]).is_constant());
}
