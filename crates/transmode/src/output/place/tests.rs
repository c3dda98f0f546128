use super::*;

#[test]
fn a_file_within_a_folder_that_is_there_or_not() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    std::fs::create_dir(at("old")).unwrap();
    for folder in ["old", "new"] {
        for file in
            [at(folder), at(folder).join("x.json"), at("old/../old").join("../").join(folder)]
        {
            assert!(is_within(&file, &at(folder)), "{}", file.display());
        }
        for file in [at("x.json"), at(&format!("{folder}.json")), Path::new("-").to_owned()] {
            assert!(!is_within(&file, &at(folder)), "{}", file.display());
        }
    }
    assert!(is_within(Path::new("report/x.json"), Path::new("./report")));
}
