//! `transmode identify --report`: the folder, and the page in a browser.

use std::path::{Path, PathBuf};

use transmode::Exit;

use crate::browser::Browser;
use crate::program::{Folder, shipped, transmode};

/// A report of two shipped records.
fn report(folder: &Folder) -> PathBuf {
    let files = ["white_snr10_aileron.csv", "white_snr10_rudder.csv"].map(shipped);
    let out = folder.path("out");
    let ran = transmode(&[
        "identify",
        &files[0],
        &files[1],
        "--outputs",
        "beta,p,r",
        "--aircraft-class",
        "I",
        "--flight-phase",
        "B",
        "--report",
        out.to_str().unwrap(),
    ]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(ran.out.contains("Dutch roll"), "the table stays on the terminal: {}", ran.out);
    out.join("report.html")
}

#[test]
fn the_folder_holds_a_page_and_its_figures() {
    let folder = Folder::new();
    let page = std::fs::read_to_string(report(&folder)).unwrap();
    assert_eq!(folder.names(), ["out"]);
    assert!(page.contains("--flight-phase B --report"), "the command is in the page");
    assert!(page.contains("for class I and flight-phase category B"));
    for (start, name) in [("<svg", "pole-map.svg"), ("\u{fffd}PNG", "pole-map.png")] {
        let bytes = std::fs::read(folder.path("out").join(name)).unwrap();
        assert!(String::from_utf8_lossy(&bytes).starts_with(start), "{name}");
    }
}

#[test]
fn folders_with_other_things_are_refused_before_any_work() {
    let folder = Folder::new();
    folder.file("flight.csv", "dear");
    let place = folder.path("");
    let ran =
        transmode(&["identify", "none.csv", "neither.csv", "--report", place.to_str().unwrap()]);
    ran.refused("holds flight.csv, which is no part of a report; name a new or an empty folder");
    assert_eq!(folder.names(), ["flight.csv"]);
}

#[test]
fn the_page_opens_from_disk_and_asks_for_nothing() {
    let Some(browser) = Browser::find() else { return };
    let folder = Folder::new();
    let page = report(&folder);
    let opened = browser.open(&page);
    assert_eq!(opened.console, [""; 0]);
    assert_eq!(opened.requests, [""; 0]);
    assert!(opened.dom.contains("<svg") && opened.dom.contains("Dutch roll"));

    // The test would see both.
    let bad = "<script>console.error('seen')</script><img src=\"http://elsewhere.example/x.png\">";
    let bad = PathBuf::from(folder.file("bad.html", bad));
    let opened = browser.open(&bad);
    assert!(opened.console.iter().any(|line| line.contains("seen")), "{:?}", opened.console);
    assert!(opened.requests.iter().any(|url| url.contains("/x.png")), "{:?}", opened.requests);
}

/// Nothing but tables, which scroll by themselves, is wider than the screen.
#[test]
fn the_page_fits_a_phone_and_a_desk() {
    let Some(browser) = Browser::find() else { return };
    let folder = Folder::new();
    let page = report(&folder);
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join("report");
    std::fs::create_dir_all(&kept).unwrap();
    for width in [390_u32, 1280] {
        let (opened, framed) =
            (browser.open(&framed(&folder, &page, width)), framed(&folder, &page, width));
        let asked = format!("data-inner=\"{width}\"");
        assert!(opened.dom.contains(&asked), "{}", start(&opened.dom));
        assert!(opened.dom.contains(&format!("data-scroll=\"{width}\"")), "{}", start(&opened.dom));
        for (dark, name) in [(false, "light"), (true, "dark")] {
            let picture = kept.join(format!("{width}-{name}.png"));
            browser.picture(&framed, (width.max(600), 9000), dark, &picture);
            assert!(std::fs::metadata(&picture).unwrap().len() > 50_000, "{}", picture.display());
        }
    }
    let paper = kept.join("paper.pdf");
    browser.print(&page, &paper);
    assert!(std::fs::read(&paper).unwrap().starts_with(b"%PDF"));
}

/// The page in a frame of so many pixels, which tells how wide its content is: windows of browsers have a least width.
fn framed(folder: &Folder, page: &Path, width: u32) -> PathBuf {
    const TELL: &str = "<script>addEventListener('load', () => { const root = document.documentElement; \
                        parent.postMessage([innerWidth, root.scrollWidth], '*'); });</script></body>";
    let telling = std::fs::read_to_string(page).unwrap().replace("</body>", TELL);
    folder.file("telling.html", telling);
    let frame = format!(
        "<!doctype html><body style=\"margin:0\"><script>addEventListener('message', event => {{ \
         document.body.dataset.inner = event.data[0]; document.body.dataset.scroll = event.data[1]; }});</script>\
         <iframe src=\"telling.html\" style=\"border:0;width:{width}px;height:9000px\" scrolling=\"no\"></iframe></body>"
    );
    PathBuf::from(folder.file("frame.html", frame))
}

fn start(dom: &str) -> &str {
    dom.get(..300).unwrap_or(dom)
}
