use std::num::NonZero;

use super::*;

/// Writes a file of 200 samples with time from 5 s on in steps of 0.5 s, without the rows `missing`, and loads it.
fn loaded(missing: Range<usize>, change: impl FnOnce(&mut LoadOptions, &Path)) -> Loaded {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("f.csv");
    let row = |k: usize| {
        format!("{},{k},{}\n", 5.0 + 0.5 * f64::from(u32::try_from(k).unwrap()), k * k % 17)
    };
    let rows = (0..200).filter(|k| !missing.contains(k)).map(row);
    std::fs::write(&file, "t,a [deg],b\n".to_owned() + &rows.collect::<String>()).unwrap();
    let mut options = LoadOptions::default();
    change(&mut options, &file);
    let files = if options.windows.is_empty() { vec![file] } else { Vec::new() };
    load(&files, &options, Progress::Shown).unwrap()
}

fn names(loaded: &Loaded) -> Vec<(&str, usize)> {
    loaded.records.iter().map(|record| (record.name(), record.samples())).collect()
}

fn span(source: &Source) -> String {
    format!("{} to {}", source.span_s[0], source.span_s[1])
}

#[test]
fn a_whole_file_is_one_record() {
    let found = loaded(0..0, |_, _| ());
    assert_eq!(names(&found), [("f.csv", 200)]);
    assert_eq!(span(&found.sources[0]), "5 to 104.5");
    assert_eq!(found.sources[0].units, [Some("rad"), None]);
    assert_eq!(found.records[0].period().seconds().to_bits(), 0.5_f64.to_bits());
    assert!(found.warnings.is_empty());
    let degree = found.records[0].channels()[0].values[180];
    assert!((degree - std::f64::consts::PI).abs() < 1e-12);
}

#[test]
fn a_gap_makes_two_records() {
    let found = loaded(80..100, |options, _| {
        options.selection.outputs = vec!["b".to_owned(), "a".to_owned()]
    });
    assert_eq!(names(&found), [("f.csv#1", 80), ("f.csv#2", 100)]);
    assert_eq!(span(&found.sources[1]), "55 to 104.5");
    assert_eq!(found.records[0].channels()[0].name, "b");
    assert_eq!(found.warnings.iter().map(LoadWarning::code).collect::<Vec<_>>(), ["gaps"]);
}

#[test]
fn windows_and_decimation_say_what_is_left() {
    let window = |file: &Path, start_s, end_s| Window { file: file.to_owned(), start_s, end_s };
    let found = loaded(0..0, |options, file| {
        options.windows = vec![window(file, Some(10.0), Some(20.0)), window(file, None, Some(6.0))];
    });
    assert_eq!(names(&found), [("f.csv:10:20", 21), ("f.csv::6", 3)]);
    let found = loaded(0..0, |options, _| options.decimate = NonZero::new(2).unwrap());
    let [first, last] = found.sources[0].span_s;
    let count = f64::from(u32::try_from(found.records[0].samples()).unwrap());
    assert!((last - first - (count - 1.0)).abs() < 1e-9);
    // A ramp passes the filter as it is.
    let ramp = found.records[0].channels()[0].values[0].to_degrees();
    assert!((ramp - 2.0 * (first - 5.0)).abs() < 1e-9, "{ramp}");
}
