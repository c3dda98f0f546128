use super::*;
use proptest::prelude::*;

fn linear(low: f64, high: f64) -> View {
    View { scale: Scale::Linear, low, high }
}

fn log(low: f64, high: f64) -> View {
    View { scale: Scale::Log10, low: low.log10(), high: high.log10() }
}

/// All labels of an axis, in ascending order.
fn labels(view: View, length_px: f64, direction: Direction) -> Vec<String> {
    let ticks = Ticks::new(view, length_px, direction);
    let major = ticks.places(view).map(|unit| ticks.style.label(unit));
    major.chain(ticks.extra.iter().map(|(_, label)| label.clone())).collect()
}

#[test]
fn labels_are_round_numbers() {
    let check = |view, length_px, expected: &str| {
        let found = labels(view, length_px, Direction::Horizontal).join(" ");
        assert_eq!(found, expected, "{view:?}");
    };
    check(linear(-1.1, 1.1), 300.0, "−1.0 −0.5 0 0.5 1.0");
    check(linear(-25.0, 25.0), 300.0, "−20 −10 0 10 20");
    check(linear(0.9, 1.05), 160.0, "0.90 0.95 1.00 1.05");
    check(linear(0.99999, 1.00001), 290.0, "0.999990 0.999995 1.000000 1.000005 1.000010");
    check(linear(-2.2e7, 3e7), 290.0, "−2×10⁷ −1×10⁷ 0 1×10⁷ 2×10⁷ 3×10⁷");
    check(linear(1e-9, 2.4e-9), 200.0, "1.0×10⁻⁹ 1.5×10⁻⁹ 2.0×10⁻⁹");
    check(linear(1.0, 1.0 + 4.2e-12), 400.0, "1.000000000000 1.000000000002 1.000000000004");
    check(linear(1e5, 1e5 + 10.0), 290.0, "1.00000×10⁵ 1.00005×10⁵ 1.00010×10⁵");
    check(log(0.5, 2000.0), 300.0, "1 10 100 1000");
    check(log(1e-16, 1e2), 300.0, "10⁻¹⁵ 10⁻¹² 10⁻⁹ 10⁻⁶ 10⁻³ 10⁰");
    check(log(1e-150, 1e150), 300.0, "10⁻¹⁵⁰ 10⁻¹⁰⁰ 10⁻⁵⁰ 10⁰ 10⁵⁰ 10¹⁰⁰ 10¹⁵⁰");
    // Less than two powers of ten: the numbers between are labelled.
    check(log(2.0, 17.0), 300.0, "2 5 10");
    check(log(2e-8, 6e-8), 300.0, "2×10⁻⁸ 5×10⁻⁸");
    check(log(3.1, 4.3), 300.0, "3.2 3.4 3.6 3.8 4.0 4.2");
}

#[test]
fn minor_ticks_are_the_whole_multiples_of_a_power_of_ten() {
    let ticks = Ticks::new(log(1.0, 1000.0), 300.0, Direction::Horizontal);
    assert_eq!(ticks.minor.len(), 3 * 8);
    assert!((ticks.minor[0] - 2f64.log10()).abs() < 1e-15);
    // Where only some powers are labelled, the others get a tick.
    let ticks = Ticks::new(log(1e-16, 1.0), 300.0, Direction::Vertical);
    assert_eq!(ticks.minor.len(), 17);
}

#[test]
fn a_view_has_a_margin_and_never_no_length() {
    let free = Axis::linear("x");
    let view = View::new(&free, Some((0.0, 1.0)));
    assert!((view.low + 0.06).abs() < 1e-15 && (view.high - 1.06).abs() < 1e-15);
    let view = View::new(&free, Some((5.0, 5.0)));
    assert!((view.low - 4.5).abs() < 1e-15 && (view.high - 5.5).abs() < 1e-15);
    let view = View::new(&free, Some((0.0, 0.0)));
    assert!((view.span() - 2.0).abs() < 1e-15);
    let view = View::new(&Axis::log("x"), Some((100.0, 100.0)));
    assert!((view.low - 1.5).abs() < 1e-15 && (view.high - 2.5).abs() < 1e-15);
    let view = View::new(&free.range(2.0, 3.0), Some((0.0, 1.0)));
    assert!(view.shows(2.0) && view.shows(3.0) && !view.shows(1.999));
}

/// Labels between decades give way where a short axis has no room for all of them.
#[test]
fn labels_between_decades_are_thinned() {
    let view = View { scale: Scale::Log10, low: -2.93, high: -1.07 };
    let ticks = Ticks::new(view, 120.0, Direction::Horizontal);
    let labels: Vec<&str> = ticks.extra.iter().map(|(_, label)| label.as_str()).collect();
    assert_eq!(labels, ["0.002", "0.01", "0.05"]);
}

proptest! {
    /// Any axis has at least one and at most thirty labels, all different, in room that is theirs.
    #[test]
    fn labels_have_room(
        center in -1e3..1e3f64, decade in -12..12i32, span in 1e-6..1e3f64, length_px in 120.0..600.0f64,
        is_log in any::<bool>(), is_horizontal in any::<bool>()
    ) {
        let direction = if is_horizontal { Direction::Horizontal } else { Direction::Vertical };
        let view = if is_log {
            let middle = f64::from(decade);
            View { scale: Scale::Log10, low: middle - 0.02 * span - 0.01, high: middle + 0.02 * span + 0.01 }
        } else {
            let unit = 10f64.powi(decade);
            linear((center - 0.5 * span) * unit, (center + 0.5 * span) * unit)
        };
        let ticks = Ticks::new(view, length_px, direction);
        let mut places: Vec<(f64, String)> = ticks.places(view).map(|unit| (unit, ticks.style.label(unit))).collect();
        places.extend(ticks.extra.clone());
        prop_assert!((1..=30).contains(&places.len()), "{places:?}");
        for pair in places.windows(2) {
            let distance = (pair[1].0 - pair[0].0) / view.span() * length_px;
            prop_assert!(distance > 0.0 && pair[0].1 != pair[1].1, "{places:?}");
            let room = match direction {
                Direction::Horizontal => 0.5 * (font::width(&pair[0].1, TICK_PX) + font::width(&pair[1].1, TICK_PX)) + 2.0,
                Direction::Vertical => f64::from(TICK_PX) + 1.0,
            };
            prop_assert!(distance >= room, "{:?} has {distance:.1} of {room:.1} pixels", pair);
        }
        for (unit, _) in places {
            prop_assert!(unit >= view.low - 1e-8 * view.span() && unit <= view.high + 1e-8 * view.span());
        }
    }
}
