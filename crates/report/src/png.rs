//! SVG pictures as PNG images.

use crate::{ReportError, font};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};
use std::sync::{Arc, OnceLock};

/// Largest image: 100 million pixels, 400 megabytes while it is drawn.
const LARGEST: f64 = 1e8;

/// Rasterises a picture with the bundled font alone, so that it looks the same on every machine.
///
/// `scale` is pixels of the image per unit of the picture: 1 for a screen, 2 for a fine screen, 3 to 4 for print.
///
/// # Errors
///
/// [`ReportError::Raster`] where the text is not an SVG picture, the scale is not positive and finite, or the image would have no
/// pixel or more than 100 million.
pub fn render(svg: &str, scale: f32) -> Result<Vec<u8>, ReportError> {
    let fault = |reason: String| ReportError::Raster { reason };
    if !(scale.is_finite() && scale > 0.0) {
        return Err(fault(format!("scale {scale}, needs to be positive and finite")));
    }
    let tree = Tree::from_str(svg, &options()).map_err(|error| fault(error.to_string()))?;
    let size = tree.size().to_int_size().scale_by(scale);
    let pixels =
        f64::from(tree.size().width()) * f64::from(tree.size().height()) * f64::from(scale).powi(2);
    let image = size
        .filter(|_| pixels <= LARGEST)
        .and_then(|size| Pixmap::new(size.width(), size.height()));
    let mut image =
        image.ok_or_else(|| fault(format!("{pixels:.0} pixels, needs 1 to {LARGEST:.0}")))?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut image.as_mut());
    image.encode_png().map_err(|error| fault(error.to_string()))
}

fn options() -> Options<'static> {
    static FONTS: OnceLock<Arc<fontdb::Database>> = OnceLock::new();
    let fonts = FONTS.get_or_init(|| {
        let mut fonts = fontdb::Database::new();
        fonts.load_font_source(fontdb::Source::Binary(Arc::new(font::DATA)));
        Arc::new(fonts)
    });
    Options {
        font_family: "DejaVu Sans".to_owned(),
        fontdb: Arc::clone(fonts),
        ..Options::default()
    }
}

#[cfg(test)]
mod tests;
