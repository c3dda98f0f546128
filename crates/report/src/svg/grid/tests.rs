use super::*;
use crate::figure::Axis;
use crate::series::{Marker, Points};

fn panel(x: &str, y: &str) -> Panel {
    let points = Points::new("p", Marker::Cross, [(0.0, 0.0), (1.0, 1.0)]);
    Panel::new("t", Axis::linear(x), Axis::linear(y)).with(points)
}

#[test]
fn panels_are_lettered() {
    let check = |index, expected| assert_eq!(letter(index), expected, "{index}");
    check(0, "a");
    check(25, "z");
    check(26, "aa");
    check(27, "ab");
    check(702, "aaa");
}

#[test]
fn a_label_is_not_repeated_beside_or_above_itself() {
    let figure = Figure::new("f", "", "")
        .columns(2)
        .with(panel("x", "y"))
        .with(panel("x", "y"))
        .with(panel("x", "w"))
        .with(panel("v", "y"));
    let shown = |medium| -> Vec<String> {
        let grid = Grid::new(&figure, medium).unwrap();
        grid.cells
            .iter()
            .map(|cell| format!("{}|{}", cell.x_label.concat(), cell.y_label.concat()))
            .collect()
    };
    assert_eq!(shown(Medium::Page), ["|y", "x|", "x|w", "v|y"]);
    assert_eq!(shown(Medium::Phone), ["x|y", "x|y", "x|w", "v|y"]);
}

#[test]
fn plot_areas_are_in_line_and_cells_do_not_overlap() {
    let figure = (0..5).fold(Figure::new("f", "", "").columns(3), |figure, i| {
        figure.with(panel(
            "x",
            if i == 4 { "a label that takes two lines because it is long" } else { "y" },
        ))
    });
    let grid = Grid::new(&figure, Medium::Page).unwrap();
    for (i, cell) in grid.cells.iter().enumerate() {
        let above = &grid.cells[i % 3];
        assert_eq!((cell.left, cell.frame.left), (above.left, above.frame.left));
        assert!(
            cell.left + cell.width <= grid.width + 1e-9
                && cell.top + cell.height <= grid.height + 1e-9
        );
        if i % 3 > 0 {
            let before = &grid.cells[i - 1];
            assert!(before.left + before.width <= cell.left + 1e-9);
            assert_eq!(
                (before.top, before.frame.top, before.frame.height),
                (cell.top, cell.frame.top, cell.frame.height)
            );
        }
    }
}
