use super::*;

fn period() -> SamplePeriod {
    SamplePeriod::new(0.1).unwrap()
}

fn record(channels: &[(&str, &[f64])]) -> Result<Record, ReconstructError> {
    Record::new(
        "r",
        period(),
        channels.iter().map(|(name, values)| Channel::new(*name, values.to_vec())).collect(),
    )
}

#[test]
fn names_the_place_of_each_fault() {
    let check = |channels: &[(&str, &[f64])], expected: &str| {
        assert_eq!(record(channels).unwrap_err().to_string(), expected);
    };
    check(&[], "record \"r\" holds no samples");
    check(&[("beta", &[])], "record \"r\" holds no samples");
    check(
        &[("beta", &[1.0, 2.0]), ("p", &[1.0])],
        "record \"r\": channel \"p\" has 1 samples, the first channel has 2",
    );
    check(&[("beta", &[1.0]), ("beta", &[1.0])], "record \"r\": channel \"beta\" is there twice");
    check(
        &[("beta", &[1.0, 2.0]), ("p", &[1.0, f64::NAN])],
        "record \"r\": sample 1 of channel \"p\" is not a finite number",
    );
}

#[test]
fn refuses_records_of_different_systems() {
    let first = record(&[("beta", &[1.0]), ("p", &[1.0])]).unwrap();
    let swapped = record(&[("p", &[1.0]), ("beta", &[1.0])]).unwrap();
    assert!(matches!(
        check_compatible(&[first.clone(), swapped]),
        Err(ReconstructError::DifferentChannels { .. })
    ));
    let slower =
        Record::new("slow", SamplePeriod::new(0.2).unwrap(), first.channels().to_vec()).unwrap();
    assert!(matches!(
        check_compatible(&[first.clone(), slower]),
        Err(ReconstructError::DifferentSampling { .. })
    ));
    let jittered =
        Record::new("j", SamplePeriod::new(0.1 + 1e-9).unwrap(), first.channels().to_vec())
            .unwrap();
    assert_eq!(check_compatible(&[first, jittered]), Ok(()));
}
