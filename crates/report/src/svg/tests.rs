use super::*;
use crate::figure::{Axis, Guide, Legend, Panel};
use crate::series::{Band, Dash, Ellipse, Ellipses, Fill, Ink, Line, Marker, Notes, Points, Stems};
use proptest::prelude::*;
use roxmltree::{Document, Node};

/// One line of text on the paper: what, and the box around it (left, top, right, bottom).
#[derive(Debug)]
struct Placed {
    text: String,
    area: [f64; 4],
}

fn number(node: Node<'_, '_>, name: &str) -> f64 {
    node.attribute(name)
        .and_then(|value| value.parse().ok())
        .unwrap_or_else(|| panic!("{name} in {node:?}"))
}

/// Where the groups around a node move it.
fn shift(node: Node<'_, '_>) -> (f64, f64) {
    let moves = node.ancestors().skip(1).filter_map(|group| group.attribute("transform"));
    moves.fold((0.0, 0.0), |(x, y), transform| {
        let inside = transform.trim_start_matches("translate(").trim_end_matches(')');
        let (dx, dy) = inside.split_once(',').unwrap();
        (x + dx.parse::<f64>().unwrap(), y + dy.parse::<f64>().unwrap())
    })
}

fn texts(document: &Document<'_>) -> Vec<Placed> {
    let nodes = document.descendants().filter(|node| node.has_tag_name("text"));
    nodes
        .map(|node| {
            let (dx, dy) = shift(node);
            let (x, y, size) =
                (number(node, "x") + dx, number(node, "y") + dy, number(node, "font-size"));
            let text = node.text().unwrap_or("").to_owned();
            let width = font::width(&text, node.attribute("font-size").unwrap().parse().unwrap());
            let before = match node.attribute("text-anchor") {
                Some("middle") => 0.5 * width,
                Some("end") => width,
                _ => 0.0,
            };
            // Heights of the letters of DejaVu Sans, above and below the baseline.
            let (above, below) = (0.76 * size, 0.24 * size);
            let area = if node.attribute("transform").is_some() {
                [x - above, y - width + before, x + below, y + before]
            } else {
                [x - before, y - above, x - before + width, y + below]
            };
            Placed { text, area }
        })
        .collect()
}

fn check_texts(svg: &str) -> Result<(), String> {
    let document = Document::parse(svg).map_err(|error| error.to_string())?;
    let root = document.root_element();
    let (width, height) = (number(root, "width"), number(root, "height"));
    let texts = texts(&document);
    for (i, a) in texts.iter().enumerate() {
        let [left, top, right, bottom] = a.area;
        if left < 0.0 || top < 0.0 || right > width || bottom > height {
            return Err(format!("{a:?} leaves the picture of {width} by {height}"));
        }
        for b in &texts[..i] {
            let across = right.min(b.area[2]) - left.max(b.area[0]);
            let down = bottom.min(b.area[3]) - top.max(b.area[1]);
            if across > 0.5 && down > 0.5 {
                return Err(format!("{a:?} lies over {b:?}"));
            }
        }
    }
    Ok(())
}

fn example() -> Figure {
    let map = |title: &str| {
        Panel::z_plane(title)
            .with(Points::poles("pole", [(0.5, 0.25), (0.5, -0.25)]))
            .with(Points::zeros("zero", [(-0.75, 0.0)]))
            .with(Points::eigenvalues("eigenvalue", [(0.5, 0.25)]))
    };
    let time = Panel::new("response", Axis::linear("time (s)"), Axis::linear("roll rate (rad/s)"))
        .with(Band::new("95 % band", [(0.0, -1.0, 1.0), (2.0, 0.0, 1.5)]).ink(Ink::Sky))
        .with(Line::new("model", Dash::DashDot, [(0.0, 0.0), (2.0, 1.0)]).marker(Marker::Diamond))
        .with(Notes::new([(2.0, 1.0, "end & <stop>")]));
    let stems = Panel::new("", Axis::linear("index"), Axis::log("|h| (1/s)").range(1e-18, 10.0))
        .with(
            Stems::new("|h|", [(-25.0, 1e-17), (0.0, 1.0), (25.0, 0.0)])
                .marker(Marker::Square, Fill::Open),
        )
        .with(Ellipses::new(
            "region",
            Dash::Dotted,
            [Ellipse { center: (0.0, 1.0), semi_axes: (5.0, 0.5), angle_rad: 0.0 }],
        ));
    let zoom = map("near z = 1")
        .zoom((0.4, 0.6), (0.1, 0.3))
        .guide(Guide::Horizontal(0.2))
        .guide(Guide::Vertical(9.0));
    Figure::new("example", "Title & <more>", "A caption.")
        .columns(2)
        .with(map("whole map"))
        .with(zoom)
        .with(time)
        .with(stems)
}

#[test]
fn every_label_is_in_the_picture() {
    let svg = render(&example()).unwrap();
    let document = Document::parse(&svg).unwrap();
    let found: Vec<String> = texts(&document).into_iter().map(|placed| placed.text).collect();
    let expected = [
        "(a) whole map",
        "(b) near z = 1",
        "(c) response",
        "(d)",
        "real part",
        "imaginary part",
        "time (s)",
        "roll rate (rad/s)",
        "index",
        "|h| (1/s)",
        "pole",
        "zero",
        "eigenvalue",
        "95 % band",
        "model",
        "|h|",
        "region",
        "unit circle",
        "end & <stop>",
        "−1.0",
        "10⁻¹⁵",
    ];
    for label in expected {
        assert!(found.iter().any(|text| text == label), "{label} is not among {found:?}");
    }
    let told = |name| {
        document.descendants().find(|node| node.has_tag_name(name)).and_then(|node| node.text())
    };
    assert_eq!((told("title"), told("desc")), (Some("Title & <more>"), Some("A caption.")));
    assert!(check_texts(&svg).is_ok(), "{:?}", check_texts(&svg));
}

#[test]
fn the_same_figure_gives_the_same_text() {
    assert_eq!(render(&example()).unwrap(), render(&example()).unwrap());
}

#[test]
fn a_unit_is_as_long_in_x_as_in_y() {
    // Far from square, so that one of the two ranges has to give way.
    for xy in [[(0.0, 0.0), (9.0, 1.0)], [(0.0, 0.0), (1.0, 9.0)]] {
        let panel = Panel::new("", Axis::linear("x"), Axis::linear("y")).equal_axes();
        let figure = Figure::new("f", "", "")
            .with(panel.with(Points::new("", Marker::Circle, xy).radius(3.0)));
        let svg = render(&figure).unwrap();
        let document = Document::parse(&svg).unwrap();
        let circles: Vec<_> =
            document.descendants().filter(|node| node.has_tag_name("circle")).collect();
        assert_eq!(circles.len(), 2);
        let along = |name| (number(circles[1], name) - number(circles[0], name)).abs();
        let (x, y) = (along("cx") / xy[1].0, along("cy") / xy[1].1);
        assert!((x / y - 1.0).abs() < 1e-3, "{x} pixels across, {y} down");
    }
}

/// Ticks are drawn by the plotting library and points by us: both have to mean the same place.
#[test]
fn a_point_is_where_its_tick_says() {
    let check = |x: Axis, y: Axis, point: (f64, f64), labels: (&str, &str)| {
        let points = Points::new("", Marker::Circle, [point]);
        let svg =
            render(&Figure::new("f", "", "").with(Panel::new("", x, y).with(points))).unwrap();
        let document = Document::parse(&svg).unwrap();
        let circle = document.descendants().find(|node| node.has_tag_name("circle")).unwrap();
        let (dx, dy) = shift(circle);
        let texts = texts(&document);
        let label = |text| texts.iter().find(|placed| placed.text == text).unwrap().area;
        let (below, beside) = (label(labels.0), label(labels.1));
        let across = 0.5 * (below[0] + below[2]) - number(circle, "cx") - dx;
        let down = 0.5 * (beside[1] + beside[3]) - number(circle, "cy") - dy;
        // Letters are not quite centred in the height of their font.
        assert!(
            across.abs() < 0.02 && down.abs() < 1.5,
            "{labels:?} is {across} and {down} pixels off"
        );
    };
    let linear = |low, high| Axis::linear("a").range(low, high);
    let log = |low, high| Axis::log("a").range(low, high);
    check(linear(-1.3, 2.7), linear(0.0, 50.0), (0.5, 20.0), ("0.5", "20"));
    check(linear(0.0, 1e-20), linear(1e5, 1e6), (4e-21, 5e5), ("4.0×10⁻²¹", "5.0×10⁵"));
    check(log(0.3, 200.0), log(1e-20, 1e-3), (10.0, 1e-12), ("10", "10⁻¹²"));
    check(log(2.0, 17.0), log(1.1, 1.9), (5.0, 1.5), ("5", "1.5"));
}

#[test]
fn what_lies_outside_a_range_is_not_drawn() {
    let circles = |range: (f64, f64)| {
        let points = Points::zeros("", [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (5.0, 0.0)]);
        let panel = Panel::new("", Axis::linear("x").range(range.0, range.1), Axis::linear("y"))
            .with(points);
        render(&Figure::new("f", "", "").with(panel)).unwrap().matches("<circle").count()
    };
    assert_eq!(circles((-1.0, 6.0)), 4);
    assert_eq!(circles((0.0, 1.0)), 3);
    assert_eq!(circles((0.1, 0.9)), 1);
    assert_eq!(circles((7.0, 8.0)), 0);
}

#[test]
fn the_narrowest_and_the_widest_ranges_are_drawn() {
    let limits = [
        (1.0, 1.0 + 2e-12),
        (-1e300, 1e300),
        (0.0, 1e-300),
        (1e300 * (1.0 - 2e-12), 1e300),
        (-1e-300, 1e300),
    ];
    let logs = [
        (1.0, 1.0 + 2e-12),
        (1e-300, 1e300),
        (1e-300, 1e-300 * (1.0 + 2e-12)),
        (1e300 * (1.0 - 2e-12), 1e300),
    ];
    let linear = limits.map(|(low, high)| Axis::linear("x").range(low, high));
    for axis in linear.into_iter().chain(logs.map(|(low, high)| Axis::log("x").range(low, high))) {
        let (low, high) = axis.range.unwrap();
        let panel = Panel::new("", axis.clone(), Axis::linear("y")).unit_circle();
        let line = Line::new("line", Dash::Solid, [(low, 0.0), (high, 1.0)]);
        let band = Band::new("band", [(low, 0.0, 1.0), (high, 0.5, 1e300)]);
        let svg = render(&Figure::new("f", "", "").with(panel.with(line).with(band))).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{axis:?}");
        assert_eq!(check_texts(&svg), Ok(()), "{axis:?}");
    }
}

#[test]
fn a_legend_entry_stands_for_all_panels() {
    let count = |figure: &Figure, label: &str| {
        let svg = render(figure).unwrap();
        texts(&Document::parse(&svg).unwrap()).iter().filter(|placed| placed.text == label).count()
    };
    assert_eq!(count(&example(), "pole"), 1);
    assert_eq!(count(&example().legend(Legend::Hidden), "pole"), 0);
    let bare =
        Figure::new("f", "", "").with(Panel::z_plane("").with(Points::poles("", [(0.0, 0.0)])));
    assert_eq!(count(&bare, "unit circle"), 0);
}

#[test]
fn text_is_taken_literally() {
    let strange = "$x^2$ \\$ <g> & \"q\" 'a' \u{0} \u{ffff} ]]> φ̇";
    let panel = Panel::new(strange, Axis::linear(strange), Axis::linear(strange))
        .with(Points::poles(strange, [(0.0, 0.0)]));
    let svg = render(&Figure::new("f", strange, strange).with(panel)).unwrap();
    let document = Document::parse(&svg).unwrap();
    let placed = texts(&document);
    let one_line = placed.iter().find(|placed| placed.text.contains("φ̇")).unwrap();
    let words: Vec<&str> = one_line.text.split_whitespace().collect();
    assert_eq!(words.join(" "), "$x^2$ \\$ <g> & \"q\" 'a' ]]> φ̇");
}

#[test]
fn every_colour_has_a_variant_for_the_dark() {
    let svg = render(&example()).unwrap();
    let document = Document::parse(&svg).unwrap();
    for node in document.descendants() {
        for name in ["fill", "stroke"] {
            let colour = node.attribute(name).unwrap_or("none");
            assert!(
                colour == "none" || ON_DARK.iter().any(|(light, _)| *light == colour),
                "{colour} in {node:?}"
            );
        }
    }
}

fn words() -> impl Strategy<Value = String> {
    let word = prop_oneof![
        Just("roll"),
        Just("rate"),
        Just("(rad/s)"),
        Just("transmissibility_of_everything"),
        Just("δβ"),
        Just("z = 1")
    ];
    prop::collection::vec(word, 0..9).prop_map(|words| words.join(" "))
}

fn panel() -> impl Strategy<Value = Panel> {
    let values = prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64), 1..20);
    let place = (-12..12i32, -1e4..1e4f64, -12..12i32, -1e4..1e4f64);
    let marker = prop_oneof![
        Just(Marker::Cross),
        Just(Marker::Circle),
        Just(Marker::Triangle),
        Just(Marker::Diamond)
    ];
    (words(), words(), words(), words(), values, place, marker, 0..5u8).prop_map(
        |(title, x, y, label, values, place, marker, kind)| {
            let logs = kind == 3;
            let at = |value: f64, decade: i32, offset: f64| {
                if logs {
                    10f64.powf(value * f64::from(decade))
                } else {
                    (value + offset) * 10f64.powi(decade)
                }
            };
            let xy: Vec<_> = values
                .iter()
                .map(|(u, v)| (at(*u, place.0, place.1), at(*v, place.2, place.3)))
                .collect();
            let panel = match kind {
                0 => Panel::z_plane(title),
                1 => Panel::new(title, Axis::linear(x), Axis::linear(y)).equal_axes(),
                3 => Panel::new(title, Axis::log(x), Axis::log(y)),
                _ => Panel::new(title, Axis::linear(x), Axis::linear(y)),
            };
            match kind {
                0..=1 => panel.with(Points::new(label, marker, xy)),
                2 => panel.with(Stems::new(label, xy)),
                _ => panel.with(Line::new(label, Dash::Dashed, xy).marker(marker)),
            }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever the labels and the data: well-formed, no text cut off, no text over other text.
    #[test]
    fn text_never_overlaps(panels in prop::collection::vec(panel(), 1..7), columns in 1..5usize) {
        let figure = panels.into_iter().fold(Figure::new("f", "t", "c").columns(columns), Figure::with);
        for medium in [Medium::Page, Medium::Phone] {
            let svg = draw(&figure, medium).unwrap();
            let checked = check_texts(&svg);
            prop_assert!(checked.is_ok(), "{}", checked.unwrap_err());
            prop_assert!(!svg.contains("NaN") && !svg.contains("inf"));
        }
    }
}
