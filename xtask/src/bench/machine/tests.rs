use super::*;

#[test]
fn dates_are_those_of_the_calendar() {
    for (days, date) in [
        (0, (1970, 1, 1)),
        (-1, (1969, 12, 31)),
        (11_016, (2000, 2, 29)),
        (11_017, (2000, 3, 1)),
        (20_454, (2026, 1, 1)),
        (47_540, (2100, 2, 28)),
        (47_541, (2100, 3, 1)),
    ] {
        assert_eq!(civil_date(days), date, "{days}");
    }
}

#[test]
fn the_processor_is_named_once() {
    let text = "processor\t: 0\nmodel name\t: Fast CPU @ 3.0 GHz\nprocessor\t: 1\nmodel name\t: Fast CPU @ 3.0 GHz\n";
    assert_eq!(model_name(text), Some("Fast CPU @ 3.0 GHz".to_owned()));
    assert_eq!(model_name("processor: 0"), None);
}

#[test]
fn free_space_is_the_fourth_column() {
    let text =
        "Filesystem 1024-blocks Used Available Capacity Mounted on\n/dev/a 1000 400 600 40% /\n";
    assert_eq!(available(text), Some(614_400));
    assert_eq!(available("Filesystem\n"), None);
    assert_eq!(available(""), None);
}
