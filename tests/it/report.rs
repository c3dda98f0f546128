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

/// Names that would be markup are text in the page and in every picture.
#[test]
fn hostile_names_stay_text() {
    const SENSORS: [&str; 3] =
        ["<script>alert('1')</script>", "p&amp;\"'><img src=x>", "`r` ]]> -->"];
    let folder = Folder::new();
    let quoted = SENSORS.map(|name| format!("\"{}\"", name.replace('"', "\"\"")));
    let header = format!("time,{}\n", quoted.join(","));
    let files = ["aileron", "rudder"].map(|surface| {
        let text = std::fs::read_to_string(shipped(&format!("white_snr10_{surface}.csv"))).unwrap();
        let (_, rows) = text.split_once('\n').unwrap();
        let four = |row: &str| row.split(',').take(4).collect::<Vec<_>>().join(",") + "\n";
        let rows: String = rows.lines().map(four).collect();
        folder.file(&format!("<b>{surface}&\"`.csv"), header.clone() + &rows)
    });
    let out = folder.path("out");
    let ran = transmode(&["identify", &files[0], &files[1], "--report", out.to_str().unwrap()]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));

    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    for markup in ["<script", "<img", "<b>", "&amp;\"", "&amp;amp;amp;"] {
        assert!(!page.contains(markup), "{markup}");
    }
    let (start, end) = (page.find("<main>").unwrap(), page.find("</main>").unwrap());
    let main = format!("{}</main>", &page[start..end]);
    let document = roxmltree::Document::parse(&main).unwrap();
    let texts: String = document
        .descendants()
        .filter(|node| node.is_text())
        .filter_map(|node| node.text())
        .collect();
    // Back quotes are the page's own mark of code: they may go, what is between them stays.
    for name in [SENSORS[0], SENSORS[1], "]]> -->", "<b>aileron&\"", "<b>rudder&\""] {
        assert!(texts.contains(name), "{name}");
    }
    for name in document.descendants().filter(roxmltree::Node::is_element) {
        assert!(!["script", "img", "b"].contains(&name.tag_name().name()));
    }
    let mut pictures = 0;
    for entry in std::fs::read_dir(&out).unwrap() {
        let file = entry.unwrap().path();
        if file.extension().is_some_and(|extension| extension == "svg") {
            let picture = std::fs::read_to_string(&file).unwrap();
            let parsed = roxmltree::Document::parse(&picture);
            assert!(parsed.is_ok(), "{}: {parsed:?}", file.display());
            pictures += 1;
        }
    }
    assert!(pictures > 5, "{pictures}");
}

#[test]
fn a_place_that_cannot_be_written_leaves_nothing() {
    let folder = Folder::new();
    let files = ["white_snr10_aileron.csv", "white_snr10_rudder.csv"].map(shipped);
    let json = folder.path("modes.json");
    let refuses = |place: &Path| {
        let words = ["identify", &files[0], &files[1], "--outputs", "beta,p,r", "--json"];
        let more = [json.to_str().unwrap(), "--report", place.to_str().unwrap()];
        transmode(&[&words[..], &more].concat()).refused("cannot write");
    };
    let file = PathBuf::from(folder.file("file", "dear"));
    for place in [folder.path("none/out"), file.clone(), file.join("out")] {
        refuses(&place);
        assert_eq!(folder.names(), ["file"]);
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "dear");
    // The same for a JSON file: no report comes without it.
    let out = folder.path("out");
    let taken = folder.path("taken.json");
    std::fs::create_dir(&taken).unwrap();
    let words = ["identify", &files[0], &files[1], "--outputs", "beta,p,r", "--json"];
    let more = [taken.to_str().unwrap(), "--report", out.to_str().unwrap()];
    transmode(&[&words[..], &more].concat()).refused("cannot write");
    assert!(!out.exists());
    std::fs::remove_dir(&taken).unwrap();
    // A folder that is there, but takes no files from anybody: the fault comes at the end of all work.
    let closed = Path::new("/proc/self");
    if cfg!(target_os = "linux") && closed.is_dir() {
        refuses(&closed.join("transmode-report"));
        assert_eq!(folder.names(), ["file"]);
    }
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
