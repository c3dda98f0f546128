use super::*;

#[test]
fn converts_to_si_with_angles_in_radians() {
    let check = |text: &str, si: &str, factor: f64| {
        let unit = Unit::parse(text).unwrap_or_else(|| panic!("{text} is not known"));
        assert_eq!(unit.si, si, "{text}");
        assert!((unit.factor - factor).abs() <= 1e-12 * factor, "{text}: {}", unit.factor);
    };
    check("deg", "rad", 0.017_453_292_519_943_295);
    check("\u{b0}/s", "rad/s", 0.017_453_292_519_943_295);
    check("Deg / sec", "rad/s", 0.017_453_292_519_943_295);
    check("rad", "rad", 1.0);
    check("kt", "m/s", 0.514_444_444_444_444_4);
    check("ft", "m", 0.3048);
    check("ft/s", "m/s", 0.3048);
    check("ft/s**2", "m/s^2", 0.3048);
    check("m/s\u{b2}", "m/s^2", 1.0);
    check("g", "m/s^2", 9.80665);
    check("ms", "s", 0.001);
    check("\u{3bc}s", "s", 1e-6);
    check("min", "s", 60.0);
    check("", "", 1.0);
    check("%", "", 0.01);
    check("mph", "m/s", 0.447_04);
    check("psi", "Pa", 6_894.757_293_168_361);
    check("hPa", "Pa", 100.0);
    check("inHg", "Pa", 3386.389);
    check("lbf", "N", 4.448_221_615_260_5);
    check("slug", "kg", 14.593_902_937_206_364);
    check("rpm", "rad/s", 0.104_719_755_119_659_77);
    check("kN", "N", 1000.0);
    check("kn", "m/s", 0.514_444_444_444_444_4);
    check("Nm", "N m", 1.0);
    check("Gauss", "T", 1e-4);
    check("Hz", "Hz", 1.0);
    check("kg", "kg", 1.0);
}

#[test]
fn temperatures_have_zeros_of_their_own() {
    for (text, value, kelvin) in
        [("degC", 20.0, 293.15), ("\u{b0}C", 0.0, 273.15), ("degF", 68.0, 293.15), ("K", 5.0, 5.0)]
    {
        let Unit { si, factor, offset } = Unit::parse(text).expect("known");
        assert_eq!(si, "K");
        assert!((value * factor + offset - kelvin).abs() < 1e-9, "{text}");
    }
}

#[test]
fn what_is_not_known_is_not_guessed() {
    for text in ["furlong", "nm", "counts", "m/s^3", "left", "degs", "lb"] {
        assert_eq!(Unit::parse(text), None, "{text}");
    }
    assert!(Unit::known().starts_with("rad, deg, mrad, rad/s, deg/s"));
}

#[test]
fn no_spelling_stands_for_two_units() {
    let all: Vec<_> = UNITS.iter().flat_map(|(spellings, ..)| spellings.iter()).collect();
    for (index, spelling) in all.iter().enumerate() {
        assert!(!all[..index].contains(spelling), "{spelling}");
        assert_eq!(spelling.to_lowercase(), **spelling);
    }
}
