use super::*;

#[test]
fn usual_names_are_known() {
    assert_eq!(lateral(&["phi", "r", "p", "beta"]), Ok(["beta", "p", "r"]));
    assert_eq!(lateral(&["AOS", "Roll_Rate", "Yaw Rate"]), Ok(["AOS", "Roll_Rate", "Yaw Rate"]));
    assert_eq!(lateral(&["ss", "beta", "p", "r"]), Ok(["beta", "p", "r"]));
    assert_eq!(lateral(&["beta", "q"]), Err(vec!["roll rate", "yaw rate"]));
}

#[test]
fn words_are_safe_in_a_shell() {
    assert_eq!(quoted("a/b.csv"), "a/b.csv");
    assert_eq!(quoted("my flight.csv"), "'my flight.csv'");
    assert_eq!(quoted("it's"), "'it'\\''s'");
    assert_eq!(quoted("$(x)"), "'$(x)'");
}
