use super::*;
use crate::{Axis, Column, Dash, Figure, Line, Panel, Table};

#[test]
fn the_data_of_figures_and_tables_read_back_exactly() {
    let x = 0.1 + 0.2;
    let panel = Panel::new("p", Axis::log("x"), Axis::linear("y").range(0.0, 1.0));
    let line = Line::new("l", Dash::DashDot, [(x, 5e-324), (f64::NAN, 1.0)]);
    let mut table = Table::new("t", [Column::right("c")]);
    table.push(["1"]).unwrap();
    let document =
        Document::new("d").with(Figure::new("f", "", "").with(panel.with(line))).with(table);
    let read: serde_json::Value = serde_json::from_str(&render(&document).unwrap()).unwrap();
    let panel = &read["blocks"][0]["panels"][0];
    assert_eq!(read["blocks"][0]["kind"], "figure");
    assert_eq!(panel["x"]["scale"], "log10");
    assert_eq!(panel["y"]["range"][1], 1.0);
    assert_eq!(panel["series"][0]["kind"], "line");
    assert_eq!(panel["series"][0]["dash"], "dashdot");
    assert_eq!(panel["series"][0]["xy"][0][0].as_f64(), Some(x));
    assert_eq!(panel["series"][0]["xy"][0][1].as_f64(), Some(5e-324));
    assert!(panel["series"][0]["xy"][1][0].is_null());
    assert_eq!(read["blocks"][1]["rows"][0][0], "1");
}
