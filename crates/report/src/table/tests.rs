use super::*;

fn table(rows: &[[&str; 2]]) -> Table {
    let mut table = Table::new("t", [Column::left("mode"), Column::right("value (1/s)")]);
    for row in rows {
        table.push(*row).unwrap();
    }
    table
}

#[test]
fn a_row_of_another_width_is_refused_and_leaves_no_trace() {
    let mut table = table(&[["roll", "1"]]);
    for cells in [0, 1, 3] {
        let refused = table.push(vec!["x"; cells]);
        assert_eq!(
            refused,
            Err(ReportError::RowWidth { table: "t".into(), found: cells, needed: 2 })
        );
    }
    assert_eq!(table.rows().len(), 1);
    let text = table.push(["x"]).unwrap_err().to_string();
    assert_eq!(text, "table \"t\": row has 1 cells, the table has 2 columns");
}

#[test]
fn comma_separated_values_are_quoted_where_needed() {
    let check = |cell, expected: &str| {
        let csv = table(&[[cell, "1"]]).to_csv();
        assert_eq!(csv, format!("mode,value (1/s)\n{expected},1\n"), "{cell:?}");
    };
    check("roll", "roll");
    check("", "");
    check("-0.07 ± j1.69", "-0.07 ± j1.69");
    check("a,b", "\"a,b\"");
    check("say \"x\"", "\"say \"\"x\"\"\"");
    check("two\nlines", "\"two\nlines\"");
    check(" padded", "\" padded\"");
    assert_eq!(table(&[]).to_csv(), "mode,value (1/s)\n");
}

#[test]
fn markdown_keeps_bars_and_alignment() {
    let markdown = table(&[["|h| of `a|b`", "**1**"], ["two\nlines", "x_1 < 2"]]).to_markdown();
    let expected = "**t**\n\n| mode | value (1/s) |\n| :-- | --: |\n| \\|h\\| of `a\\|b` | **1** |\n| two lines | x_1 \\< 2 |\n";
    assert_eq!(markdown, expected);
}

#[test]
fn html_escapes_and_aligns() {
    let html = table(&[["<b> & `c`", "**1**"]]).to_html();
    assert!(
        html.contains(
            "<th scope=\"col\">mode</th><th scope=\"col\" class=\"right\">value (1/s)</th>"
        ),
        "{html}"
    );
    assert!(
        html.contains(
            "<td>&lt;b&gt; &amp; <code>c</code></td><td class=\"right\"><strong>1</strong></td>"
        ),
        "{html}"
    );
    assert!(roxmltree::Document::parse(&html).is_ok());
}
