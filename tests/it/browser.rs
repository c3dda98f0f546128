//! A browser without a window: what a page does when it is opened from disk.
//!
//! The browser is Chromium: the one that `TRANSMODE_CHROMIUM` names, or the first of the usual names on the path. Where there is none, tests that need it
//! pass without looking, unless `TRANSMODE_REQUIRE_BROWSER` is set, as it is in CI.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// A browser with a profile of its own.
pub(crate) struct Browser {
    program: PathBuf,
    folder: tempfile::TempDir,
}

/// What opening a page led to.
pub(crate) struct Opened {
    /// Lines that the page or the browser wrote to the console.
    pub(crate) console: Vec<String>,
    /// Addresses beyond the disk that were asked for.
    pub(crate) requests: Vec<String>,
    /// The page's elements after all has settled.
    pub(crate) dom: String,
}

impl Browser {
    /// `None` where there is none and none is required.
    pub(crate) fn find() -> Option<Self> {
        const NAMES: [&str; 4] =
            ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
        let path = std::env::var_os("PATH").unwrap_or_default();
        let on_path = || {
            let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
            NAMES.iter().find_map(|name| {
                folders.iter().map(|folder| folder.join(name)).find(|file| file.is_file())
            })
        };
        let program = std::env::var_os("TRANSMODE_CHROMIUM").map(PathBuf::from).or_else(on_path);
        let required = std::env::var_os("TRANSMODE_REQUIRE_BROWSER").is_some();
        assert!(
            program.is_some() || !required,
            "no browser: install chromium, or name one in TRANSMODE_CHROMIUM"
        );
        let Some(program) = program else {
            // Past the capture of output, so that it is seen although the test passes.
            let _ = writeln!(
                std::io::stderr(),
                "\nNOT TESTED: no browser, so nothing looks at the page of a report; install chromium, or name one in TRANSMODE_CHROMIUM"
            );
            return None;
        };
        Some(Self { program, folder: tempfile::tempdir().unwrap() })
    }

    /// Opens a page from disk and waits until it has settled.
    pub(crate) fn open(&self, page: &Path) -> Opened {
        let log = self.folder.path().join("net.json");
        let flag = format!("--log-net-log={}", log.display());
        let ran = self.run(&[flag.as_str(), "--dump-dom", "--enable-logging=stderr"], page);
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let console = text(&ran.stderr);
        let console = console.lines().filter(|line| line.contains("CONSOLE"));
        Opened {
            console: console.map(str::to_owned).collect(),
            requests: requests(&std::fs::read(&log).unwrap()),
            dom: text(&ran.stdout),
        }
    }

    /// A picture of a page in a window of so many pixels.
    pub(crate) fn picture(&self, page: &Path, size: (u32, u32), dark: bool, to: &Path) {
        let size = format!("--window-size={},{}", size.0, size.1);
        let to = format!("--screenshot={}", to.display());
        let scheme = format!("--blink-settings=preferredColorScheme={}", u8::from(!dark));
        self.run(&[size.as_str(), to.as_str(), scheme.as_str(), "--hide-scrollbars"], page);
    }

    /// The page on paper.
    pub(crate) fn print(&self, page: &Path, to: &Path) {
        let to = format!("--print-to-pdf={}", to.display());
        self.run(&[to.as_str(), "--no-pdf-header-footer"], page);
    }

    fn run(&self, flags: &[&str], page: &Path) -> std::process::Output {
        let profile = format!("--user-data-dir={}", self.folder.path().join("profile").display());
        // Without a sandbox, since CI is root; the pages are our own.
        let ran = Command::new(&self.program)
            .args(["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"])
            .args([
                "--no-first-run",
                "--disable-background-networking",
                "--disable-component-update",
            ])
            .args(["--disable-sync", "--disable-default-apps", "--disable-extensions"])
            // Whatever it asks for on its own leads nowhere.
            .arg("--host-resolver-rules=MAP * ~NOTFOUND")
            .args([profile.as_str(), "--virtual-time-budget=4000"])
            .args(flags)
            .arg(format!("file://{}", page.display()))
            .output()
            .unwrap();
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        ran
    }
}

/// The addresses beyond the disk that pages asked for, from a network log.
fn requests(log: &[u8]) -> Vec<String> {
    // A browser that is stopped early leaves the list open.
    let text = String::from_utf8_lossy(log);
    let open = text.trim_end().trim_end_matches(',').to_owned();
    let json: Value = serde_json::from_str(&open)
        .or_else(|_| serde_json::from_str(&format!("{open}]}}")))
        .unwrap();
    let events = json["events"].as_array().cloned().unwrap_or_default();
    // The browser asks for things of its own, such as updates; those have no page that started them.
    let from_page = |event: &&Value| {
        event["params"]["initiator"].as_str().is_some_and(|origin| origin != "not an origin")
    };
    let addresses =
        events.iter().filter(from_page).filter_map(|event| event["params"]["url"].as_str());
    let beyond = |address: &&str| {
        ["http:", "https:", "ws:", "wss:", "ftp:"].iter().any(|s| address.starts_with(s))
    };
    addresses.filter(beyond).map(str::to_owned).collect()
}
