//! The edges between the crates: they point down, and the lower a crate the smaller its tree.

use std::collections::BTreeSet;
use std::process::Command;

/// Our crates that each of our crates may name directly, with all features on. ARCHITECTURE.md draws the same.
const ALLOWED: [(&str, &[&str]); 14] = [
    ("doubled", &[]),
    ("poly", &["doubled"]),
    ("lti", &["doubled", "poly"]),
    ("hankel", &["doubled"]),
    ("era", &["lti", "poly"]),
    ("cfi-ident", &["hankel"]),
    ("aircraft", &["lti"]),
    ("reconstruct", &["cfi-ident", "doubled", "era", "hankel", "lti", "poly"]),
    ("report", &[]),
    ("flight", &["lti"]),
    ("monitor", &["cfi-ident"]),
    (
        "transmode",
        &["aircraft", "cfi-ident", "flight", "lti", "monitor", "poly", "reconstruct", "report"],
    ),
    (
        "xtask",
        &["aircraft", "cfi-ident", "flight", "hankel", "lti", "poly", "reconstruct", "report"],
    ),
    ("tests", &[]),
];

/// Crates that a package's normal dependencies are, at most `depth` edges away.
fn dependencies(package: &str, depth: Option<&str>, features: &[&str]) -> BTreeSet<String> {
    let mut command = Command::new(env!("CARGO"));
    command.args([
        "tree",
        "--offline",
        "--edges",
        "normal",
        "--prefix",
        "none",
        "--format",
        "{p}",
        "--package",
        package,
    ]);
    command.args(depth.iter().flat_map(|depth| ["--depth", *depth])).args(features);
    command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines()
        .filter_map(|line| line.split(' ').next())
        .map(str::to_owned)
        .filter(|name| name != package)
        .collect()
}

fn ours() -> BTreeSet<String> {
    ALLOWED.iter().map(|(name, _)| (*name).to_owned()).collect()
}

#[test]
fn each_crate_names_only_crates_below_it() {
    for (package, allowed) in ALLOWED {
        let named: BTreeSet<_> = dependencies(package, Some("1"), &["--all-features"])
            .intersection(&ours())
            .cloned()
            .collect();
        let allowed: BTreeSet<_> = allowed.iter().map(|name| (*name).to_owned()).collect();
        assert_eq!(named, allowed, "{package}");
    }
}

#[test]
fn every_crate_has_a_place_in_the_layers() {
    let folders = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../crates")).unwrap();
    for folder in folders {
        let name = folder.unwrap().file_name().into_string().unwrap();
        assert!(ours().contains(&name), "{name} has none");
    }
}

#[test]
fn poly_alone_pulls_in_no_linear_algebra() {
    let alone = dependencies("poly", None, &["--no-default-features"]);
    let linear_algebra = |tree: &BTreeSet<String>| {
        tree.iter()
            .filter(|name| {
                ["faer", "nalgebra", "gemm", "matrixmultiply"]
                    .iter()
                    .any(|part| name.starts_with(part))
            })
            .count()
    };
    assert_eq!(linear_algebra(&alone), 0, "{alone:?}");
    // The control: with its features it does, so the search would find it.
    assert!(linear_algebra(&dependencies("poly", None, &["--all-features"])) >= 2);
}

#[test]
fn the_plotting_library_is_known_to_report_alone() {
    let direct = |package: &str| dependencies(package, Some("1"), &["--all-features"]);
    assert!(direct("report").contains("kuva"));
    for (package, _) in ALLOWED.iter().filter(|(package, _)| *package != "report") {
        for library in ["kuva", "resvg"] {
            assert!(!direct(package).contains(library), "{package} names {library}");
        }
    }
}

#[test]
fn the_solver_is_optional() {
    assert!(!dependencies("cfi-ident", None, &["--no-default-features"]).contains("clarabel"));
    assert!(dependencies("cfi-ident", None, &["--all-features"]).contains("clarabel"));
    assert!(!dependencies("transmode", None, &[]).contains("clarabel"));
}
