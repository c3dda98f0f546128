//! Figures as SVG pictures.
//!
//! The picture has white paper, black axes and text, and the colours of the series. Its text names the bundled font and common
//! replacements; no letter is turned into outlines, so it can be searched and copied. Size and place of everything are
//! known before drawing: labels are wrapped, ticks thinned, and margins made as wide as the labels need.

mod check;
mod frame;
mod grid;
mod ink;
mod legend;
mod marks;
mod notes;
mod panel;
mod scale;

pub(crate) use grid::Medium;
pub(crate) use ink::ON_DARK;

use crate::figure::Figure;
use crate::{ReportError, font};
use kuva::backend::svg::SvgBackend;
use kuva::render::render::Scene;

/// Draws a figure; its title and caption are kept as the picture's title and description.
///
/// The same figure always gives the same text. Coordinates have two decimals. Lines are cut and points left out where they
/// lie outside an axis range.
///
/// # Errors
///
/// [`ReportError`] where the figure has no panels or columns or a bad identifier, or a panel has nothing to show, a number that is not
/// finite (or above 1e300), a value that its logarithmic axis cannot show, an impossible range, or equal axes on a logarithmic scale.
///
/// # Example
///
/// ```
/// use report::{Figure, Panel, Points, svg};
///
/// let map = Panel::z_plane("map").with(Points::poles("pole", [(0.5, 0.0)]));
/// let picture = svg::render(&Figure::new("map", "Pole map", "One pole.").with(map))?;
/// assert!(picture.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
/// # Ok::<(), report::ReportError>(())
/// ```
pub fn render(figure: &Figure) -> Result<String, ReportError> {
    draw(figure, Medium::Page)
}

pub(crate) fn draw(figure: &Figure, medium: Medium) -> Result<String, ReportError> {
    let grid = grid::Grid::new(figure, medium)?;
    let colours = ink::assign(figure);
    let legend = legend::Placed::new(figure, &colours, grid.width);
    let (width, height) = (grid.width.ceil(), (grid.height + legend.height).ceil());
    let mut scene = Scene::new(width, height).with_background(Some(ink::PAPER));
    for (i, (cell, colours)) in grid.cells.iter().zip(&colours).enumerate() {
        let suffix = if medium == Medium::Phone { "-phone" } else { "" };
        let id = format!("{}-clip-{i}{suffix}", figure.id);
        let frame = &cell.frame;
        let (left, top) = (frame.left, frame.top);
        scene.defs.push(format!(
            r#"<clipPath id="{id}"><rect x="{left:.2}" y="{top:.2}" width="{:.2}" height="{:.2}"/></clipPath>"#,
            frame.width, frame.height
        ));
        panel::draw(&mut scene, cell, colours, &id);
    }
    legend.draw(&mut scene, grid.height);
    let drawn = SvgBackend::new().with_pretty(true).render_scene(&scene);
    Ok(with_own_head(&drawn, figure, width, height))
}

/// Replaces the library's opening tag and version stamp by one with a view box, so that the picture scales, a title and a description.
fn with_own_head(drawn: &str, figure: &Figure, width: f64, height: f64) -> String {
    let body = drawn.split_once("-->").map_or(drawn, |(_, body)| body);
    let (title, caption) = (escape(&figure.title), escape(&figure.caption));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\" \
         font-family=\"{}\" fill=\"{}\">\n  <title>{title}</title>\n  <desc>{caption}</desc>{body}",
        font::FAMILIES,
        ink::BLACK
    )
}

/// Text as it stands between tags or in a quoted attribute.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' => out.push(c),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests;
