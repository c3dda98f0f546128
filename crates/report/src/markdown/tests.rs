use super::*;
use crate::figure::Figure;
use crate::table::Column;

fn check(block: impl Into<Block>, expected: &str) {
    let document = Document::new("T").with(block);
    assert_eq!(render(&document, ""), format!("# T\n\n{expected}\n"));
}

#[test]
fn blocks_become_markdown() {
    check(Block::section("Result"), "## Result");
    check(Block::subsection("Detail"), "### Detail");
    check(Block::Heading { level: 9, text: "x".into() }, "#### x");
    check(Block::paragraph("chi² **is** `1.0`"), "chi² **is** `1.0`");
    check(Block::code("sh", "cargo run\n"), "```sh\ncargo run\n```");
    check(Block::code("", "a ``` b"), "````\na ``` b\n````");
    check(Block::bullets(["a", "b\nc"]), "- a\n- b\n  c");
    check(Block::numbers(["a", "b"]), "1. a\n2. b");
    check(Block::note("x"), "> [!NOTE]\n> x");
    check(Block::warning("x\ny"), "> [!WARNING]\n> x\n> y");
}

#[test]
fn literal_text_stays_literal() {
    check(
        Block::paragraph("T* a_1 _x_ <b> [l](u) & &amp; ~~y~~"),
        "T\\* a_1 \\_x\\_ \\<b\\> \\[l\\](u) & \\&amp; \\~\\~y\\~\\~",
    );
    check(Block::paragraph("# no heading"), "\\# no heading");
    check(Block::paragraph("1. no list"), "1\\. no list");
    check(Block::paragraph("- no list"), "\\- no list");
    check(Block::paragraph("1.5 is no list"), "1.5 is no list");
    check(Block::paragraph("`a` and a ` alone"), "`a` and a \\` alone");
}

#[test]
fn figures_and_tables_are_numbered() {
    let mut table = Table::new("Modes", [Column::left("a"), Column::center("b")]);
    table.push(["1", "2"]).unwrap();
    let figure = |id: &str| Figure::new(id, "Map", "See it.");
    let document = Document::new("T").with(figure("a")).with(table).with(figure("b"));
    let text = render(&document, "pictures of it/");
    assert!(
        text.contains("![Map](<pictures of it/a.svg>)\n\n**Figure 1.** Map. See it.\n"),
        "{text}"
    );
    assert!(text.contains("**Figure 2.**"), "{text}");
    assert!(
        text.contains("**Table 1.** Modes.\n\n| a | b |\n| :-- | :-: |\n| 1 | 2 |\n"),
        "{text}"
    );
}

#[test]
fn titles_end_like_sentences() {
    assert_eq!(sentences("Map", "See."), "Map. See.");
    assert_eq!(sentences("Why?", ""), "Why?");
    assert_eq!(sentences("", "See."), "See.");
}
