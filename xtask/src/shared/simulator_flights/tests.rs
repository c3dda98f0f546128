use super::*;

#[test]
fn the_truth_is_that_of_the_aircraft() {
    let truth = Truth::read(&folder()).unwrap();
    assert_eq!(truth.0.len(), 6);
    for aircraft in truth.0.values() {
        let modes = aircraft.modes();
        assert!(modes.roll.re < modes.spiral.re && modes.dutch_roll.im > 0.0, "{aircraft:?}");
    }
    // The 787-8's spiral is unstable, the Cub's roll the fastest.
    assert!(truth.of("787-8").unwrap().modes().spiral.re > 0.01);
    assert!(truth.of("J3Cub").unwrap().modes().roll.re < -12.0);
    assert!(truth.of("Spitfire").is_err());
}

#[test]
fn columns_become_sensors() {
    let text = "time,beta,p,r,d_rudder\n0,1,2,3,4\n0.5,-4e-1,5,6,5\n1,7,8,9,6\n";
    let (record, moved) = parse("rudder", text).unwrap();
    assert_eq!(moved, [vec![0.0; 3], vec![4.0, 5.0, 6.0]]);
    assert_eq!((record.name(), record.period().seconds()), ("rudder", 0.5));
    let found: Vec<_> =
        record.channels().iter().map(|c| (c.name.as_str(), c.values.as_slice())).collect();
    let expected: [(&str, &[f64]); 3] =
        [("beta", &[1.0, -0.4, 7.0]), ("p", &[2.0, 5.0, 8.0]), ("r", &[3.0, 6.0, 9.0])];
    assert_eq!(found, expected);
}

#[test]
fn a_bad_file_says_where() {
    for (text, expected) in [
        ("", "the first columns must be time,beta,p,r"),
        ("time,beta,r,p\n", "the first columns must be time,beta,p,r"),
        ("time,beta,p,r\n0,1,2,3\n", "fewer than two samples"),
        ("time,beta,p,r\n0,1,2\n", "line 2: \"0,1,2\" is not 4 numbers"),
        ("time,beta,p,r\n0,1,2,3\n1,1,x,3\n", "line 3: \"1,1,x,3\" is not 4 numbers"),
        ("time,beta,p,r\n0,1,2,3\n1,1,2,3\n3,1,2,3\n", "line 3: a step other than 1.5 s"),
    ] {
        assert_eq!(parse("x", text).unwrap_err(), expected);
    }
}
