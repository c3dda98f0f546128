use super::*;

#[test]
fn a_unit_stands_in_brackets_behind_the_name() {
    let check = |text: &str, name: &str, unit: Option<&str>| {
        let found = heading(text);
        assert_eq!((found.name.as_str(), found.unit.as_deref()), (name, unit), "{text}");
    };
    check("beta", "beta", None);
    check(" beta [deg] ", "beta", Some("deg"));
    check("p(rad/s)", "p", Some("rad/s"));
    check("alpha (left) [deg]", "alpha (left)", Some("deg"));
    check("ratio []", "ratio", Some(""));
    check("[deg]", "[deg]", None);
    check("h_ft", "h_ft", None);
    check("x]", "x]", None);
}

#[test]
fn a_row_of_units_is_told_from_names_and_numbers() {
    let row = |fields: &[&str]| units(&fields.iter().map(|f| (*f).to_owned()).collect::<Vec<_>>());
    let some = |text: &str| Some(text.to_owned());
    assert_eq!(
        row(&["s", "[deg]", "(deg/s)", ""]),
        Some(vec![some("s"), some("deg"), some("deg/s"), None])
    );
    assert_eq!(row(&["s", "furlong"]), Some(vec![some("s"), some("furlong")]));
    assert_eq!(row(&["0", "s"]), None);
    assert_eq!(row(&["1", "1"]), None);
    assert_eq!(row(&["0,5", "deg"]), None);
    assert_eq!(row(&["left", "right"]), None);
    assert_eq!(row(&["", ""]), None);
    assert_eq!(row(&["NaN", "s"]), None);
}
