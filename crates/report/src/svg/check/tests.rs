use crate::figure::{Axis, Figure, Guide, Panel};
use crate::series::{Band, Dash, Ellipse, Ellipses, Line, Marker, Notes, Points, Series, Stems};
use crate::{ReportError, svg};

fn linear() -> Panel {
    Panel::new("p", Axis::linear("x"), Axis::linear("y"))
}

fn points(xy: &[(f64, f64)]) -> Points {
    Points::new("s", Marker::Plus, xy.iter().copied())
}

fn fault(panel: Panel) -> String {
    let figure = Figure::new("f", "", "").with(panel);
    svg::render(&figure).map_or_else(|error| error.to_string(), |_| "none".to_owned())
}

#[test]
fn every_number_has_to_be_finite() {
    let check = |series: Series, index: usize, value: &str| {
        let expected = format!(
            "figure \"f\", panel 1, series \"{}\", item {index}: {value} is not finite",
            series.label()
        );
        assert_eq!(fault(linear().with(series)), expected);
    };
    check(points(&[(0.0, 1.0), (f64::NAN, 1.0)]).into(), 1, "NaN");
    check(Line::new("s", Dash::Solid, [(0.0, f64::INFINITY)]).into(), 0, "inf");
    check(Stems::new("s", [(f64::NEG_INFINITY, 0.0)]).into(), 0, "-inf");
    check(Band::new("s", [(0.0, 1.0, 2.0), (1.0, 1.0, f64::NAN)]).into(), 1, "NaN");
    let ellipse = |a| Ellipse { center: (0.0, 0.0), semi_axes: (a, 1.0), angle_rad: 0.0 };
    check(Ellipses::new("s", Dash::Solid, [ellipse(1.0), ellipse(f64::NAN)]).into(), 1, "NaN");
    check(Notes::new([(f64::NAN, 0.0, "n")]).into(), 0, "NaN");
    // As good as infinite: spans and margins would overflow.
    assert!(fault(linear().with(points(&[(1e301, 0.0)]))).ends_with("is not finite"));
    assert!(
        fault(linear().guide(Guide::Vertical(f64::NAN)).with(points(&[(0.0, 0.0)])))
            .contains("NaN")
    );
    assert_eq!(fault(linear().with(points(&[(-1e300, 1e-300), (1e300, 0.0)]))), "none");
}

#[test]
fn logarithms_need_positive_values() {
    let log = |range: Option<(f64, f64)>| {
        let y = Axis::log("y");
        Panel::new(
            "p",
            Axis::linear("x"),
            range.map_or(y.clone(), |(low, high)| y.range(low, high)),
        )
    };
    let zero = "figure \"f\", panel 1, series \"s\", item 1: 0 on a logarithmic y axis, needs > 0 (or 0 where the axis has a range)";
    assert_eq!(fault(log(None).with(points(&[(0.0, 1.0), (1.0, 0.0)]))), zero);
    assert_eq!(fault(log(Some((0.1, 2.0))).with(points(&[(0.0, 1.0), (1.0, 0.0)]))), "none");
    assert!(
        fault(log(Some((0.1, 2.0))).with(points(&[(0.0, -1.0)])))
            .contains("-1 on a logarithmic y axis")
    );
    assert_eq!(fault(log(None).with(points(&[(0.0, 1e-300), (1.0, 1e300)]))), "none");
}

#[test]
fn ranges_have_to_be_in_order() {
    let check = |axis: Axis, fine: bool| {
        let found = fault(Panel::new("p", axis.clone(), Axis::linear("y").range(0.0, 1.0)));
        assert_eq!(found == "none", fine, "{axis:?}: {found}");
    };
    check(Axis::linear("x").range(0.0, 1.0), true);
    check(Axis::linear("x").range(1.0, 0.0), false);
    check(Axis::linear("x").range(1.0, 1.0), false);
    check(Axis::linear("x").range(f64::NAN, 1.0), false);
    check(Axis::linear("x").range(0.0, f64::INFINITY), false);
    check(Axis::linear("x").range(1.0, 1.0 + 1e-13), false);
    check(Axis::linear("x").range(1.0, 1.0 + 1e-9), true);
    check(Axis::log("x").range(0.0, 1.0), false);
    check(Axis::log("x").range(1e-300, 1.0), true);
}

#[test]
fn a_figure_needs_a_name_panels_and_something_to_show() {
    let with =
        |id: &str| svg::render(&Figure::new(id, "", "").with(linear().with(points(&[(0.0, 0.0)]))));
    for id in ["a", "pole-zero_map2", &"a".repeat(80)] {
        assert!(with(id).is_ok(), "{id}");
    }
    for id in ["", "2a", "A", "a b", "a/b", "../a", "é", &"a".repeat(81)] {
        assert_eq!(with(id), Err(ReportError::FigureId { id: id.to_owned() }));
    }
    assert_eq!(
        svg::render(&Figure::new("f", "", "")),
        Err(ReportError::NoPanels { figure: "f".into() })
    );
    let no_columns = Figure::new("f", "", "").with(linear().with(points(&[(0.0, 0.0)]))).columns(0);
    assert_eq!(svg::render(&no_columns), Err(ReportError::NoColumns { figure: "f".into() }));
    assert_eq!(
        fault(linear()),
        "figure \"f\", panel 1: no data in the x direction and no range given"
    );
    assert_eq!(fault(linear().with(points(&[]))), fault(linear()));
    assert_eq!(fault(linear().zoom((0.0, 1.0), (0.0, 1.0))), "none");
    assert_eq!(fault(Panel::z_plane("no pole at all")), "none");
    let log =
        Panel::new("p", Axis::log("x"), Axis::linear("y")).equal_axes().with(points(&[(1.0, 1.0)]));
    assert_eq!(fault(log), "figure \"f\", panel 1: equal axes need two linear scales");
}
