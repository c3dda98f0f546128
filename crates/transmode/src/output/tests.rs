use super::*;

#[test]
fn a_file_is_replaced_whole_and_no_draft_stays() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("result.json");
    let mut out = Vec::new();
    write_whole(&file, b"first", &mut out).unwrap();
    write_whole(&file, b"second", &mut out).unwrap();
    assert_eq!(std::fs::read(&file).unwrap(), b"second");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    assert!(out.is_empty());
}

#[test]
fn a_failed_write_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let mut out = Vec::new();
    let missing = folder.path().join("no").join("result.json");
    let message = write_whole(&missing, b"x", &mut out).unwrap_err().to_string();
    let reason = std::fs::File::open(&missing).unwrap_err();
    assert!(message.starts_with(&format!("cannot write {}: {reason}; ", missing.display())));
    // A folder stands where the file should.
    let place = folder.path().join("folder");
    std::fs::create_dir(&place).unwrap();
    assert!(write_whole(&place, b"x", &mut out).is_err());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_file_and_what_goes_with_it_are_written_both_or_neither() {
    let folder = tempfile::tempdir().unwrap();
    let (file, more) = (folder.path().join("result.json"), folder.path().join("more"));
    let is_there = || std::fs::read_dir(folder.path()).unwrap().count();
    let mut out = Vec::new();
    let missing = folder.path().join("no").join("result.json");
    let write_more = || more_to(&more);
    assert!(write_with(&missing, b"x", &mut out, write_more).is_err());
    assert_eq!(is_there(), 0);
    let fails = || Err(CommandError::Exists { file: more.clone() });
    for place in [&file, Path::new("-")] {
        assert!(write_with(place, b"x", &mut out, fails).is_err());
        assert_eq!((is_there(), out.len()), (0, 0));
    }
    write_with(&file, b"x", &mut out, write_more).unwrap();
    assert_eq!(is_there(), 2);
}

fn more_to(file: &Path) -> Result<(), CommandError> {
    std::fs::write(file, b"more")
        .map_err(|source| CommandError::Write { file: file.to_owned(), source })
}

#[test]
fn a_dash_is_standard_output() {
    let mut out = Vec::new();
    write_whole(Path::new("-"), b"x", &mut out).unwrap();
    assert_eq!(out, b"x");
}

#[cfg(unix)]
#[test]
fn a_device_is_written_to_and_not_replaced() {
    use std::os::unix::fs::FileTypeExt;
    write_whole(Path::new("/dev/null"), b"x", &mut Vec::new()).unwrap();
    assert!(std::fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}
