use super::*;
use crate::figure::Scale;
use proptest::prelude::*;

fn frame(x: (f64, f64), y: (f64, f64)) -> Frame {
    let view = |(low, high)| View { scale: Scale::Linear, low, high };
    Frame { left: 10.0, top: 20.0, width: 200.0, height: 100.0, x: view(x), y: view(y) }
}

#[test]
fn corners_go_to_corners() {
    let frame = frame((-1.0, 3.0), (0.0, 10.0));
    assert_eq!(frame.pixel((-1.0, 0.0)), (10.0, 120.0));
    assert_eq!(frame.pixel((3.0, 10.0)), (210.0, 20.0));
    assert_eq!(frame.pixel((1.0, 5.0)), (110.0, 70.0));
    assert!(frame.pixel((1e300, -1e300)).0.is_finite());
}

#[test]
fn lines_are_cut_at_the_frame() {
    let frame = frame((0.0, 1.0), (0.0, 1.0));
    let check =
        |line: &[Pixel], expected: &[&[Pixel]]| assert_eq!(frame.clip(line), expected, "{line:?}");
    check(
        &[(20.0, 30.0), (40.0, 50.0), (60.0, 30.0)],
        &[&[(20.0, 30.0), (40.0, 50.0), (60.0, 30.0)]],
    );
    check(&[(-90.0, 70.0), (110.0, 70.0)], &[&[(10.0, 70.0), (110.0, 70.0)]]);
    check(&[(0.0, 0.0), (5.0, 200.0)], &[]);
    // Out and back in: two parts.
    check(
        &[(110.0, 70.0), (310.0, 70.0), (310.0, 100.0), (110.0, 100.0)],
        &[&[(110.0, 70.0), (210.0, 70.0)], &[(210.0, 100.0), (110.0, 100.0)]],
    );
    // Along the frame.
    check(&[(10.0, 20.0), (210.0, 20.0)], &[&[(10.0, 20.0), (210.0, 20.0)]]);
    check(&[(50.0, 50.0)], &[]);
}

#[test]
fn the_whole_unit_circle_is_one_closed_line() {
    let arcs = frame((-1.2, 1.2), (-1.1, 1.1)).unit_circle();
    assert_eq!(arcs.len(), 1);
    assert!(close(arcs[0][0], *arcs[0].last().unwrap()));
    assert!(frame((-0.5, 0.5), (-0.5, 0.5)).unit_circle().is_empty());
    assert!(frame((2.0, 3.0), (-0.5, 0.5)).unit_circle().is_empty());
}

proptest! {
    /// Zoomed in on any point of the circle, by up to eight decades, the arc passes through the middle of the panel and stays inside.
    #[test]
    fn arcs_survive_zoom(angle in 0.0..std::f64::consts::TAU, decades in 0.0..8.0f64) {
        let half = 10f64.powf(-decades);
        let (sin, cos) = angle.sin_cos();
        let frame = frame((cos - half, cos + half), (sin - half, sin + half));
        let middle = (110.0, 70.0);
        let arcs = frame.unit_circle();
        prop_assert!(!arcs.is_empty());
        let mut nearest = f64::INFINITY;
        for arc in &arcs {
            for pair in arc.windows(2) {
                prop_assert!((9.9..=210.1).contains(&pair[0].0) && (19.9..=120.1).contains(&pair[0].1), "{:?}", pair[0]);
                nearest = nearest.min(distance_to_segment(middle, pair[0], pair[1]));
            }
        }
        prop_assert!(nearest < 0.2, "{nearest} pixels off");
    }
}

fn distance_to_segment(p: Pixel, a: Pixel, b: Pixel) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let t =
        (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / (dx * dx + dy * dy).max(1e-300)).clamp(0.0, 1.0);
    (p.0 - a.0 - t * dx).hypot(p.1 - a.1 - t * dy)
}
