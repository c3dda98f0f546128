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
fn lines_are_as_long_as_allowed_and_no_longer() {
    let limit = width("roll rate", 12);
    assert_eq!(wrap("sideslip roll rate", 12, limit), ["sideslip", "roll rate"]);
    assert_eq!(wrap("transmissibility of one", 12, limit), ["transmissibility", "of one"]);
    assert!(wrap("  ", 12, limit).is_empty());
}
