use super::*;

/// Advances of DejaVu Sans 2.37 in its 2048 units per em, read with fontTools.
#[test]
fn widths_are_those_of_the_font() {
    let check = |text, units: f64| {
        let found = width(text, 2048);
        assert!((found - units).abs() < 0.5, "{text}: {found} units, expected {units}");
    };
    check("", 0.0);
    check("i", 569.0);
    check("m", 1995.0);
    check("0", 1303.0);
    check("im", 569.0 + 1995.0);
}

#[test]
fn figures_need_no_glyph_that_is_missing() {
    for character in "αβγδφψζωσ±−×·²⁻⁰¹⁹₀ᵢ|Ω∞≤".chars() {
        let font = skrifa::FontRef::new(DATA).unwrap();
        assert!(
            font.charmap().map(character).is_some_and(|glyph| glyph.to_u32() != 0),
            "{character}"
        );
    }
}

#[test]
fn lines_are_few_and_of_about_equal_width() {
    let check = |text: &str, limit: &str, expected: &[&str]| {
        assert_eq!(wrap(text, 12, width(limit, 12)), expected, "{text:?}");
    };
    check("roll rate", "roll rate", &["roll rate"]);
    check("sideslip roll rate", "roll rate", &["sideslip", "roll rate"]);
    // Filling line by line would leave "= 1" alone on the second one.
    check("roll rate near z = 1", "roll rate near z =", &["roll rate", "near z = 1"]);
    check("roll rate near z\u{a0}=\u{a0}1", "roll rate", &["roll rate", "near", "z\u{a0}=\u{a0}1"]);
    check("a_very_long_name of it", "a_very", &["a_very", "_long_", "name", "of it"]);
    check("  ", "roll rate", &[]);
}
