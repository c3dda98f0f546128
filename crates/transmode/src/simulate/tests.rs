use super::*;

#[test]
fn noise_is_read() {
    assert_eq!(Noise::parse(" none"), Ok(Noise::Absent));
    assert_eq!(Noise::parse("snr=30"), Ok(Noise::Ratio(30.0)));
    let [beta, p] = ["beta", "p"].map(|name| Sensor::parse(name).unwrap());
    let expected = Noise::Levels(vec![(beta, 0.001), (p, 0.0)]);
    assert_eq!(Noise::parse("beta=1e-3, p=0"), Ok(expected));
    for (text, expected) in [
        ("", "noise is written snr=100"),
        ("100", "noise is written snr=100"),
        ("snr=0", "is no ratio"),
        ("snr=nan", "is no ratio"),
        ("q=1", "the sensors are beta, p, r and phi"),
        ("p=1,p=2", "p is there twice"),
        ("p=-1", "is no standard deviation"),
        ("p=inf", "is no standard deviation"),
    ] {
        let error = Noise::parse(text).unwrap_err();
        assert!(error.contains(expected), "{text:?}: {error}");
    }
}
