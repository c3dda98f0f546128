//! The bundled font: how wide a text is, before anything is drawn.
//!
//! DejaVu Sans 2.37 (licence beside it in `assets`) has the Greek letters, superscripts and signs of our figures. It is wider
//! than the usual replacements (Arial, Helvetica, Verdana), so that what fits with it also fits where a reader lacks it.

use skrifa::MetadataProvider;
use skrifa::instance::{LocationRef, Size};

/// The font file, for the rasteriser.
pub(crate) const DATA: &[u8] = include_bytes!("../assets/DejaVuSans.ttf");

/// Families named in pictures, the bundled one first.
pub(crate) const FAMILIES: &str = "DejaVu Sans, Verdana, Arial, Helvetica, sans-serif";

/// Width of one line of text in pixels at this font size.
pub(crate) fn width(text: &str, size_px: u32) -> f64 {
    f64::from(size_px) * text.chars().map(advance_em).sum::<f64>()
}

/// Splits a text at spaces (not at no-break spaces) into as few lines as the limit allows, and these of about equal width. A
/// single word that is wider is broken anywhere.
pub(crate) fn wrap(text: &str, size_px: u32, limit_px: f64) -> Vec<String> {
    let pieces = text.split_ascii_whitespace().flat_map(|word| break_word(word, size_px, limit_px));
    let words: Vec<(&str, f64)> = pieces.map(|word| (word, width(word, size_px))).collect();
    let space_px = width(" ", size_px);
    let lines = break_lines(&words, space_px, limit_px);
    if lines.len() < 2 {
        return lines;
    }
    // The narrowest limit that needs no further line.
    let (mut narrow, mut wide) = (0.0, limit_px);
    for _ in 0..12 {
        let middle = 0.5 * (narrow + wide);
        if break_lines(&words, space_px, middle).len() > lines.len() {
            narrow = middle;
        } else {
            wide = middle;
        }
    }
    break_lines(&words, space_px, wide)
}

/// A word in pieces no wider than the limit, of at least one character each.
fn break_word(word: &str, size_px: u32, limit_px: f64) -> Vec<&str> {
    let (mut pieces, mut start, mut used) = (Vec::new(), 0, 0.0);
    for (at, character) in word.char_indices() {
        let advance = f64::from(size_px) * advance_em(character);
        if at > start && used + advance > limit_px {
            pieces.push(&word[start..at]);
            (start, used) = (at, 0.0);
        }
        used += advance;
    }
    pieces.push(&word[start..]);
    pieces
}

/// Fills one line after the other.
fn break_lines(words: &[(&str, f64)], space_px: f64, limit_px: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut used = f64::INFINITY;
    for (word, word_px) in words {
        match lines.last_mut() {
            Some(line) if used + space_px + word_px <= limit_px => {
                line.push(' ');
                line.push_str(word);
                used += space_px + word_px;
            }
            _ => {
                lines.push((*word).to_owned());
                used = *word_px;
            }
        }
    }
    lines
}

/// Advance of one character in units of the font size.
fn advance_em(character: char) -> f64 {
    thread_local! {
        static FONT: Option<skrifa::FontRef<'static>> = skrifa::FontRef::new(DATA).ok();
    }
    const UNKNOWN: f64 = 0.6; // The box that stands for a missing glyph.
    FONT.with(|font| {
        let Some(font) = font else { return UNKNOWN };
        let glyph = font.charmap().map(character).unwrap_or_default();
        let metrics = font.glyph_metrics(Size::new(1.0), LocationRef::default());
        metrics.advance_width(glyph).map_or(UNKNOWN, f64::from)
    })
}

#[cfg(test)]
mod tests;
