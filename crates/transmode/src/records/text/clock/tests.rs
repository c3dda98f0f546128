use super::*;

fn seconds(fields: &[&str]) -> Vec<Option<f64>> {
    let mut clock = Clock::default();
    fields.iter().map(|field| clock.seconds(field.as_bytes())).collect()
}

#[test]
fn every_way_of_writing_a_time() {
    let at = |last: f64| vec![Some(45_296.25), Some(last)];
    assert_eq!(seconds(&["12:34:56.25", "12:34:56.30"]), at(45_296.3));
    assert_eq!(seconds(&["12:34:56,25", "12:34:57"]), at(45_297.0));
    assert_eq!(seconds(&["330:12:34:56.25", "331:12:34:56.25"]), at(131_696.25));
    assert_eq!(seconds(&["2026-11-26T12:34:56.25", "2026-11-27T12:34:56.25"]), at(131_696.25));
    assert_eq!(seconds(&["2026-11-26 12:34:56.25", "2026-11-26 12:34:56.3"]), at(45_296.3));
    let with_offset = ["2026-11-26T14:34:56.25+02:00", "2026-11-26T12:34:56.3Z"];
    assert_eq!(seconds(&with_offset), at(45_296.3));
}

#[test]
fn a_time_of_day_passes_midnight() {
    let found = seconds(&["23:59:59.9", "00:00:00.0", "00:00:00.1"]);
    assert_eq!(found, [Some(86_399.9), Some(86_400.0), Some(86_400.1)]);
    let year = seconds(&["365:23:59:59.9", "001:00:00:00.0", "002:00:00:00.0"]);
    assert_eq!(year, [Some(86_399.9), Some(86_400.0), Some(172_800.0)]);
    assert_eq!(seconds(&["366:23:59:59.9", "001:00:00:00.1"])[1], Some(86_400.1));
    assert_eq!(seconds(&["9:59:59.9", "10:00:00.0"]), [Some(35_999.9), Some(36_000.0)]);
    // A little back is no midnight, and no business of the clock.
    assert_eq!(seconds(&["12:00:01", "12:00:00"]), [Some(43_201.0), Some(43_200.0)]);
}

#[test]
fn what_is_no_time_or_another_kind_of_one() {
    for text in [
        "",
        "1.5",
        "12:34",
        "25:00:00",
        "12:60:00",
        "0:12:00:00",
        "367:12:00:00",
        "12:34:56.x",
        "a:b:c",
        "2026-02-30T12:00:00",
        "2026-11-26",
    ] {
        assert_eq!(seconds(&[text]), [None], "{text}");
    }
    assert_eq!(seconds(&["12:00:00", "330:12:00:00"])[1], None);
    assert_eq!(seconds(&["2026-11-26T12:00:00", "2026-11-26T12:00:00Z"])[1], None);
}

#[test]
fn minutes_and_seconds_pass_the_hour() {
    let found = seconds(&["59:59.9", "00:00.0", "0:1.5", "00:02"]);
    assert_eq!(found, [Some(3599.9), Some(3600.0), Some(3601.5), Some(3602.0)]);
    assert_eq!(seconds(&["75:00.5"]), [Some(4500.5)]);
}

#[test]
fn dates_with_the_year_at_the_end() {
    let at = |last: f64| vec![Some(86_399.5), Some(last)];
    for dates in [
        ["26.11.2026 23:59:59.5", "27.11.2026 00:00:00.5"],
        ["11/26/2026 23:59:59.5", "11/27/2026 00:00:00.5"],
        ["26/11/26 23:59:59.5", "27/11/26 00:00:00.5"],
        ["11/26/2026 11:59:59.5 PM", "11/27/2026 12:00:00.5 AM"],
        ["2026/11/26 23:59:59.5", "2026/11/27 00:00:00.5"],
        // The next midnight tells.
        ["03/04/2026 23:59:59.5", "04/04/2026 00:00:00.5"],
        ["03/04/2026 23:59:59.5", "03/05/2026 00:00:00.5"],
    ] {
        assert_eq!(seconds(&dates), at(86_400.5), "{dates:?}");
    }
    let month_first = ["03/04/2026 12:00:00", "03/05/2026 12:00:00", "03/06/2026 12:00:01"];
    assert_eq!(seconds(&month_first), [Some(43_200.0), Some(129_600.0), Some(216_001.0)]);
    let same_day = ["03/04/2026 12:00:00", "03/04/2026 12:00:01"];
    assert_eq!(seconds(&same_day), [Some(43_200.0), Some(43_201.0)]);
    for wrong in ["31.02.2026 12:00:00", "13/13/2026 12:00:00", "1/2/2026", "1/2/2026 13:00:00 PM"]
    {
        assert_eq!(seconds(&[wrong]), [None], "{wrong}");
    }
}
