//! Runs the program in this process and keeps what it says.

use std::path::{Path, PathBuf};

use transmode::Exit;

/// What a run left behind.
pub(crate) struct Ran {
    pub(crate) exit: Exit,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Ran {
    /// Expects exit code 2, nothing on standard output, and one sentence that contains `expected`.
    pub(crate) fn refused(&self, expected: &str) {
        assert_eq!(
            (self.exit, self.out.as_str()),
            (Exit::BadInput, ""),
            "should be refused: {expected}"
        );
        let one = self.err.trim_end().lines().count() == 1;
        assert!(self.err.starts_with("error: ") && one, "{}", self.err);
        assert!(self.err.contains(expected), "{}\nshould contain\n{expected}", self.err);
    }
}

/// `transmode WORDS`.
pub(crate) fn transmode(words: &[&str]) -> Ran {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let exit = transmode::run(
        std::iter::once("transmode").chain(words.iter().copied()),
        &mut out,
        &mut err,
    );
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Ran { exit, out: text(out), err: text(err) }
}

/// A record that the repository ships.
pub(crate) fn shipped(name: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/records").join(name);
    file.to_str().unwrap().to_owned()
}

/// A folder that goes away, with files in it.
pub(crate) struct Folder(tempfile::TempDir);

impl Folder {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes a file and returns its name for a command line.
    pub(crate) fn file(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        let path = self.path(name);
        std::fs::write(&path, bytes).unwrap();
        path.to_str().unwrap().to_owned()
    }

    pub(crate) fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}
