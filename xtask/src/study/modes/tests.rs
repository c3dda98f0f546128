use super::*;
use crate::study::noise::flights::Simulator;

#[test]
fn modes_are_told_apart() {
    let modes = Simulator::new().unwrap().modes();
    assert!((modes.spiral.re + 0.0016).abs() < 1e-4);
    assert!((modes.roll.re + 0.5456).abs() < 1e-4);
    assert!((modes.dutch_roll - Complex::new(-0.0706, 1.6917)).norm() < 1e-4);
    assert!(told_apart(&[Complex::new(1.0, 0.0)]).is_err());
}
