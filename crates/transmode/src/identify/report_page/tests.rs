//! Reports of shipped records by every method, and folders that are not touched.

use std::path::{Path, PathBuf};

use aircraft::{AircraftClass, FlightPhaseCategory};
use reconstruct::{Method, Options, reconstruct};

use super::contents::FIGURES;
use super::*;
use crate::args::values::MethodName;
use crate::identify::outcome::FlyingQualitiesCase;
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
    let outcome = Outcome {
        command: "transmode identify a.csv b.csv --report out",
        // The page takes it from the result.
        method: MethodName::Ml,
        records: &loaded.records,
        sources: &loaded.sources,
        warnings: &loaded.warnings,
        predictions: &[],
        coefficients: &[],
        decimation: std::num::NonZero::<usize>::MIN,
        causes: &[],
        options: &options,
        result: &result,
        found: &found,
        flying_qualities: Some(FlyingQualitiesCase {
            class: AircraftClass::I,
            phase: FlightPhaseCategory::B,
        }),
    };
    replace(folder, &draw(&outcome, Progress::Hidden).expect("a report is drawn"))
        .expect("and written");
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
    let page = report("noise_free", Method::Paper, &out);
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
    let is_refused_for = |name: &str| {
        let error = check(place.path()).expect_err("it is not ours");
        assert!(error.contains(&format!("holds {name}, which is no part of a report")), "{error}");
    };
    std::fs::write(place.path().join("order.svg"), "dear").expect("writable");
    is_refused_for("order.svg");
    std::fs::create_dir(place.path().join(PAGE)).expect("writable");
    is_refused_for("order.svg");
    std::fs::remove_dir(place.path().join(PAGE)).expect("empty");
    std::fs::write(place.path().join(PAGE), "<p>somebody's own</p>").expect("writable");
    is_refused_for("order.svg");
    let marked = "<meta name=\"generator\" content=\"transmode 0.0.1\">";
    std::fs::write(place.path().join(PAGE), marked).expect("writable");
    assert_eq!(check(place.path()), Ok(()), "an older report");
    std::fs::create_dir(place.path().join("order.png")).expect("writable");
    is_refused_for("order.png");
    std::fs::remove_dir(place.path().join("order.png")).expect("empty");
    std::fs::write(place.path().join("flight.csv"), "dear").expect("writable");
    let error = check(place.path()).expect_err("a record is in the folder");
    assert!(
        error.ends_with(
            "holds flight.csv, which is no part of a report; name a new or an empty folder"
        ),
        "{error}"
    );
    assert!(replace(place.path(), &[]).is_err());
    assert_eq!(names(place.path()), ["flight.csv", "order.svg", PAGE]);
    assert!(
        check(&place.path().join("flight.csv"))
            .is_err_and(|error| error.starts_with("cannot write"))
    );
    assert!(
        check(&place.path().join("none/out")).is_err_and(|error| error.starts_with("cannot write"))
    );
}

#[test]
fn an_old_report_is_never_lost() {
    let place = folder();
    let out = place.path().join("out");
    let write = |file: &Path, text: &str| {
        std::fs::create_dir_all(file).expect("writable");
        std::fs::write(file.join(PAGE), text).expect("writable");
    };
    let drafts = || {
        let drafts = tempfile::tempdir_in(place.path()).expect("writable");
        write(&drafts.path().join("new"), "new");
        drafts
    };
    write(&out, "old");
    let page = |folder: &Path| std::fs::read_to_string(folder.join(PAGE)).expect("a page");
    // The new one cannot be put in place: the old one comes back, or stays where it is.
    let error = folder::exchange(drafts(), &out, |from, to| match from.ends_with("new") {
        true => Err(std::io::ErrorKind::PermissionDenied.into()),
        false => std::fs::rename(from, to),
    });
    assert!(matches!(error, Err(CommandError::Write { .. })), "{error:?}");
    assert_eq!((page(&out), names(place.path())), ("old".to_owned(), vec!["out".to_owned()]));
    let error = folder::exchange(drafts(), &out, |from, to| match from == out {
        true => std::fs::rename(from, to),
        false => Err(std::io::ErrorKind::PermissionDenied.into()),
    });
    let Err(CommandError::NotRestored { kept, .. }) = error else { panic!("{error:?}") };
    assert_eq!(page(&kept), "old");
}

#[test]
fn page_and_json_have_the_same_intervals() {
    let place = folder();
    let loaded = records("white_snr10");
    let mut options = Options::default();
    options.profile = true;
    let result = reconstruct(&loaded.records, &options).expect("the records show modes");
    let mut found = crate::modes::name(&result, &loaded.records[0]).expect("modes have names");
    // In these records the two kinds of interval hardly differ; here they do.
    for found in found.iter_mut().filter(|found| found.mode.mode.period_s.is_none()) {
        let ends = found.mode.interval_95.as_mut().expect("the likelihood was looked at");
        *ends = [ends[0] - (ends[1] - ends[0]), ends[1]];
    }
    let outcome = Outcome {
        command: "transmode identify a.csv b.csv --report out",
        // The page takes it from the result.
        method: MethodName::Ml,
        records: &loaded.records,
        sources: &loaded.sources,
        warnings: &[],
        predictions: &[],
        coefficients: &[],
        decimation: std::num::NonZero::<usize>::MIN,
        causes: &[],
        options: &options,
        result: &result,
        found: &found,
        flying_qualities: None,
    };
    let out = place.path().join("out");
    replace(&out, &draw(&outcome, Progress::Hidden).expect("a report is drawn"))
        .expect("and written");
    let page = std::fs::read_to_string(out.join(PAGE)).expect("the page is there");
    let number = |value: f64| report::format_significant(value, 3);
    let mut differ = 0;
    for found in found.iter().filter(|found| found.mode.mode.period_s.is_none()) {
        // What JSON says.
        let cell = found.time_constant_interval_95().map_or_else(
            || "any sign".to_owned(),
            |[low, high]| format!("{} to {}", number(low), number(high)),
        );
        assert!(page.contains(&format!(">{cell}</td>")), "{cell}");
        assert_eq!(found.eigenvalue_interval_95(), found.mode.interval_95);
        let estimate = found.mode.estimate.as_ref().expect("the method says it");
        let first_order = estimate.time_constant_interval_95.map(|ends| ends.map(number));
        differ += usize::from(
            first_order != found.time_constant_interval_95().map(|ends| ends.map(number)),
        );
        let region = pole_map::ends(found).expect("a bar");
        assert_eq!(Some(region), found.mode.interval_95, "the bar of the map");
    }
    assert!(differ > 0, "the test would not see the intervals of first order");
    for words in ["Intervals of real modes are those of the likelihood", "; intervals are those of"]
    {
        assert!(page.contains(words), "{words}");
    }
}
