use super::*;
use crate::{Figure, Panel, Points, svg};

fn decoded(svg: &str, scale: f32) -> Pixmap {
    Pixmap::decode_png(&render(svg, scale).unwrap()).unwrap()
}

fn dark_pixels(image: &Pixmap) -> usize {
    image.pixels().iter().filter(|pixel| pixel.red() < 128 && pixel.alpha() == 255).count()
}

const EMPTY: &str =
    r#"<svg xmlns="http://www.w3.org/2000/svg" width="20" height="10" viewBox="0 0 20 10"></svg>"#;

#[test]
fn the_image_is_as_large_as_the_scale_says() {
    for (scale, size) in [(1.0, (20, 10)), (2.5, (50, 25))] {
        let image = decoded(EMPTY, scale);
        assert_eq!((image.width(), image.height()), size);
    }
}

/// The picture names the bundled font; a machine without any font draws the same letters.
#[test]
fn letters_are_drawn_with_the_bundled_font() {
    let drawn = |text: &str| {
        let body = format!(
            "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/><text x=\"1\" y=\"9\" font-size=\"9\">{text}</text></svg>"
        );
        dark_pixels(&decoded(&EMPTY.replace("</svg>", &body), 4.0))
    };
    assert_eq!(drawn(""), 0);
    assert!(drawn("HH") > 2 * drawn("i") && drawn("i") > 20, "{} {}", drawn("HH"), drawn("i"));
    assert!(drawn("⁻⁹") > 20);
}

#[test]
fn a_figure_is_on_white_paper() {
    let figure = Figure::new("f", "", "")
        .with(Panel::z_plane("map").with(Points::poles("pole", [(0.5, 0.0)])));
    let image = decoded(&svg::render(&figure).unwrap(), 1.0);
    let corner = image.pixel(0, 0).unwrap();
    assert_eq!((corner.red(), corner.green(), corner.blue(), corner.alpha()), (255, 255, 255, 255));
    assert!(dark_pixels(&image) > 1000);
}

#[test]
fn what_cannot_be_drawn_is_an_error() {
    let check = |svg: &str, scale: f32, reason: &str| {
        let found = render(svg, scale).unwrap_err().to_string();
        assert!(found.contains(reason), "{found}");
    };
    check("no picture", 1.0, "svg to png");
    check(EMPTY, 0.0, "scale 0, needs to be positive and finite");
    check(EMPTY, f32::NAN, "scale NaN");
    check(EMPTY, 1e4, "20000000000 pixels, needs 1 to 100000000");
    check(EMPTY, f32::MAX, "pixels");
}
