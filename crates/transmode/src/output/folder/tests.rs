use super::*;

fn files(names: &[&str]) -> Vec<(String, Vec<u8>)> {
    names.iter().map(|name| ((*name).to_owned(), name.as_bytes().to_vec())).collect()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn all_files_or_none() {
    let above = tempfile::tempdir().unwrap();
    let folder = above.path().join("new");
    // The last one cannot be put in place: a folder stands there, or its own folder is missing.
    let error = write_folder(&folder, &files(&["a", "no/b"]), Overwrite::Refused).unwrap_err();
    assert!(matches!(error, CommandError::Write { .. }), "{error}");
    assert!(!folder.exists());

    write_folder(&folder, &files(&["a", "b"]), Overwrite::Refused).unwrap();
    assert_eq!(names(&folder), ["a", "b"]);
    let error = write_folder(&folder, &files(&["0", "b"]), Overwrite::Refused).unwrap_err();
    assert!(matches!(error, CommandError::Exists { .. }), "{error}");
    assert_eq!(names(&folder), ["a", "b"]);
}

#[test]
fn what_is_there_is_replaced_only_if_that_is_allowed() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a"), "old").unwrap();
    let names = ["a".to_owned()];
    let check = |overwrite| check_folder(folder.path(), &names, overwrite);
    assert!(matches!(check(Overwrite::Refused), Err(CommandError::Exists { .. })));
    check(Overwrite::Allowed).unwrap();
    write_folder(folder.path(), &files(&["a"]), Overwrite::Allowed).unwrap();
    assert_eq!(std::fs::read_to_string(folder.path().join("a")).unwrap(), "a");
    // A folder is never replaced, and a file is no folder.
    std::fs::create_dir(folder.path().join("c")).unwrap();
    let taken = check_folder(folder.path(), &["c".to_owned()], Overwrite::Allowed);
    assert!(matches!(taken, Err(CommandError::Write { .. })));
    let file = folder.path().join("a");
    assert!(matches!(
        check_folder(&file, &[], Overwrite::Allowed),
        Err(CommandError::Write { .. })
    ));
}

#[test]
fn a_fault_brings_back_what_was_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let text = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    std::fs::write(folder.path().join("a"), "old").unwrap();
    // Something else makes a folder in a file's place behind the check.
    std::fs::create_dir(folder.path().join("c")).unwrap();
    std::fs::write(folder.path().join("c/dear"), "dear").unwrap();
    let error = write_folder(folder.path(), &files(&["a", "b", "c"]), Overwrite::Allowed);
    assert!(matches!(error, Err(CommandError::Exists { .. })));
    assert_eq!(names(folder.path()), ["a", "c"]);
    assert_eq!((text("a"), text("c/dear")), ("old".to_owned(), "dear".to_owned()));

    std::fs::remove_dir_all(folder.path().join("c")).unwrap();
    write_folder(folder.path(), &files(&["a", "b", "c"]), Overwrite::Allowed).unwrap();
    assert_eq!(names(folder.path()), ["a", "b", "c"]);
    assert_eq!(text("a"), "a");
}

#[test]
fn what_cannot_be_brought_back_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let old = tempfile::tempdir_in(folder.path()).unwrap();
    let before = old.path().join("0");
    std::fs::write(&before, "old").unwrap();
    let placed = Placed {
        file: folder.path().join("gone/a"),
        before: Some(before.clone()),
        is_written: true,
    };
    let first = CommandError::Exists { file: "b".into() };
    let error = undo(&[placed], old, first).to_string();
    assert!(error.contains(&format!("it is kept as {}", before.display())), "{error}");
    assert_eq!(std::fs::read_to_string(&before).unwrap(), "old");
}
