use super::*;
use crate::figure::Panel;
use crate::series::Points;
use crate::table::Column;

fn figure(id: &str) -> Figure {
    let map = || Panel::z_plane("map").with(Points::poles("pole", [(0.5, 0.0)]));
    Figure::new(id, "Map", "One pole.").columns(2).with(map()).with(map())
}

fn page() -> String {
    let mut table = Table::new("Modes", [Column::left("mode"), Column::right("period (s)")]);
    table.push(["Dutch roll", "3.71"]).unwrap();
    let document = Document::new("Modes <of> \"it\" & more")
        .with(Block::section("The result"))
        .with(Block::paragraph("a < b & `c > d` **strong**"))
        .with(table)
        .with(figure("map"))
        .with(figure("other"))
        .with(Block::code("sh\"", "a && b < c"))
        .with(Block::bullets(["one <1>"]))
        .with(Block::numbers(["two"]))
        .with(Block::note("careful"))
        .with(Block::warning("more careful"))
        .with(Block::section("The result"))
        .with(Block::section("±"));
    render(&document).unwrap()
}

#[test]
fn the_page_asks_for_nothing_else() {
    let page = page();
    for request in ["http", "//", "src=", "href=", "@import", "<script", "<link", "url(h"] {
        assert!(!page.contains(request), "{request}");
    }
    // The only addresses are those of the clip paths inside the page.
    assert_eq!(page.matches("url(").count(), page.matches("url(#").count());
}

#[test]
fn the_body_is_well_formed_and_its_anchors_differ() {
    let page = page();
    let start = page.find("<main>").unwrap();
    let end = page.find("</main>").unwrap() + "</main>".len();
    let document = roxmltree::Document::parse(&page[start..end]).unwrap();
    let mut anchors: Vec<&str> =
        document.descendants().filter_map(|node| node.attribute("id")).collect();
    for expected in ["map", "other", "the-result", "the-result-2", "section"] {
        assert!(anchors.contains(&expected), "{expected} is not among {anchors:?}");
    }
    let count = anchors.len();
    anchors.sort_unstable();
    anchors.dedup();
    assert_eq!(anchors.len(), count);
    let text = |class: &str| {
        let aside =
            document.descendants().find(|node| node.attribute("class") == Some(class)).unwrap();
        aside.descendants().filter_map(|node| node.text()).collect::<String>()
    };
    assert!(text("note").contains("careful") && text("warning").contains("more careful"));
    // Twice each: panels side by side, and below one another for narrow screens.
    assert_eq!(document.descendants().filter(|node| node.has_tag_name("svg")).count(), 4);
    let captions = document.descendants().filter(|node| node.has_tag_name("figcaption"));
    let captions: Vec<String> =
        captions.map(|node| node.descendants().filter_map(|n| n.text()).collect()).collect();
    assert!(
        captions[1].ends_with("Figure 2. Map. One pole.") || captions[1].contains("Map. One pole."),
        "{captions:?}"
    );
}

#[test]
fn text_is_escaped() {
    let page = page();
    assert!(page.contains("<h1>Modes &lt;of&gt; &quot;it&quot; &amp; more</h1>"));
    assert!(page.contains("<p>a &lt; b &amp; <code>c &gt; d</code> <strong>strong</strong></p>"));
    assert!(
        page.contains("<pre><code class=\"language-sh&quot;\">a &amp;&amp; b &lt; c</code></pre>")
    );
}

#[test]
fn every_colour_of_a_picture_has_a_rule_for_dark_screens() {
    let page = page();
    let rules = page.split_once("</style>").unwrap().0;
    for (light, dark) in svg::ON_DARK {
        assert!(rules.contains(&format!("[stroke=\"{light}\"] {{ stroke: {dark}; }}")), "{light}");
    }
    // Paper is always white: the rules hold for screens only.
    assert_eq!(
        rules.matches("prefers-color-scheme").count(),
        rules.matches("@media screen and (prefers-color-scheme").count()
    );
}

#[test]
fn two_figures_of_one_name_are_an_error() {
    let document = Document::new("t").with(figure("a")).with(figure("a"));
    assert_eq!(render(&document), Err(ReportError::DuplicateFigureId { id: "a".into() }));
    let broken = Document::new("t").with(Figure::new("a", "", ""));
    assert_eq!(render(&broken), Err(ReportError::NoPanels { figure: "a".into() }));
}

#[test]
fn a_heading_never_takes_the_anchor_of_a_figure() {
    let page = render(&Document::new("t").with(Block::section("Map")).with(figure("map"))).unwrap();
    assert!(page.contains("<h2 id=\"map-2\">"), "{page}");
}

#[test]
fn the_head_says_which_program_wrote_the_page() {
    assert!(!page().contains("generator"));
    let page = render(&Document::new("Modes").generator("it \"&\" 1.0")).unwrap();
    assert!(page.contains("<meta name=\"generator\" content=\"it &quot;&amp;&quot; 1.0\">\n"));
}
