//! Reports of shipped records by every method, and folders that are not touched.

use std::path::{Path, PathBuf};

use reconstruct::{Method, Options, reconstruct};

use super::*;
use crate::records::{LoadOptions, load};

/// Two records that the repository ships.
fn records(name: &str) -> crate::records::Loaded {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/records");
    let files: Vec<PathBuf> =
        ["aileron", "rudder"].map(|surface| folder.join(format!("{name}_{surface}.csv"))).to_vec();
    load(&files, &LoadOptions::default(), Progress::Hidden).expect("shipped records can be read")
}

/// Writes a report of them and gives the page back.
fn report(name: &str, method: Method, folder: &Path) -> String {
    let loaded = records(name);
    let mut options = Options::default();
    options.method = method;
    let result = reconstruct(&loaded.records, &options).expect("the records show modes");
    let found = crate::modes::name(&result, &loaded.records[0]).expect("modes have names");
    let input = Input {
        command: "transmode identify a.csv b.csv --report out",
        records: &loaded.records,
        sources: &loaded.sources,
        warnings: &loaded.warnings,
        options: &options,
        result: &result,
        found: &found,
        flying: Some((AircraftClass::I, FlightPhaseCategory::B)),
        progress: Progress::Hidden,
    };
    write(folder, &input).expect("a report is written");
    std::fs::read_to_string(folder.join(PAGE)).expect("the page is there")
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let name = |entry: std::io::Result<std::fs::DirEntry>| entry.expect("an entry").file_name();
    let mut names: Vec<String> =
        entries.map(|entry| name(entry).to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

#[test]
fn maximum_likelihood_fills_every_section() {
    let place = folder();
    let out = place.path().join("out");
    let page = report("white_snr10", Method::MaximumLikelihood, &out);
    let mut expected = vec![PAGE.to_owned()];
    expected.extend(FIGURES.iter().flat_map(|id| [format!("{id}.png"), format!("{id}.svg")]));
    expected.sort();
    assert_eq!(names(&out), expected);
    assert_eq!(names(place.path()), ["out"], "nothing is left beside it");
    for text in [
        "Dutch roll",
        "spiral",
        "MIL-F-8785C for class I and flight-phase category B",
        "white_snr10_aileron.csv",
        "transmode identify a.csv b.csv --report out",
        env!("CARGO_PKG_VERSION"),
        "Nothing found in the records speaks against the result",
    ] {
        assert!(page.contains(text), "{text} is missing");
    }
    assert!(page.len() < 3_000_000, "{} bytes", page.len());
}

#[test]
fn other_methods_say_what_they_cannot_show() {
    let place = folder();
    let out = place.path().join("out");
    let page = report("white_snr100", Method::Subspace, &out);
    assert!(page.contains("This method gives no deviations"));
    assert!(page.contains("come from maximum likelihood alone"));
    assert!(!names(&out).contains(&format!("{}.svg", transmissibility::ID)));
    // A report replaces an older one as a whole.
    let page = report("noise_free", Method::AsPrinted, &out);
    assert!(page.contains("has no model of all sensors"));
    assert!(!names(&out).contains(&format!("{}.svg", spectra::ID)));
    assert!(names(&out).contains(&format!("{}.svg", pole_map::ID)));
}

#[test]
fn the_same_records_give_the_same_page() {
    let place = folder();
    let (first, second) = (place.path().join("first"), place.path().join("second"));
    let pages = [&first, &second].map(|out| report("multistep_snr100", Method::Subspace, out));
    assert_eq!(pages[0], pages[1]);
}

#[test]
fn folders_with_other_things_are_not_touched() {
    let place = folder();
    let check = |folder: &Path| check_place(folder).map_err(|error| error.to_string());
    assert_eq!(check(&place.path().join("new")), Ok(()));
    assert_eq!(check(place.path()), Ok(()), "empty");
    std::fs::write(place.path().join(PAGE), "old").expect("writable");
    std::fs::write(place.path().join("order.svg"), "old").expect("writable");
    assert_eq!(check(place.path()), Ok(()), "an older report");
    std::fs::write(place.path().join("flight.csv"), "dear").expect("writable");
    let error = check(place.path()).expect_err("a record is in the folder");
    assert!(
        error.ends_with(
            "holds flight.csv, which is no part of a report; name a new or an empty folder"
        ),
        "{error}"
    );
    assert!(folder::replace(place.path(), &[]).is_err());
    assert_eq!(names(place.path()), ["flight.csv", "order.svg", PAGE]);
    assert!(
        check(&place.path().join("flight.csv"))
            .is_err_and(|error| error.starts_with("cannot write"))
    );
    assert!(
        check(&place.path().join("none/out")).is_err_and(|error| error.starts_with("cannot write"))
    );
}
