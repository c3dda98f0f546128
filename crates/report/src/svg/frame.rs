//! The frame of a panel: from values to pixels, and what of a line lies inside.

use super::scale::View;

/// A point on the paper.
pub(super) type Pixel = (f64, f64);

/// The plot area of a panel with its two views.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) x: View,
    pub(super) y: View,
}

impl Frame {
    pub(super) fn right(&self) -> f64 {
        self.left + self.width
    }

    pub(super) fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// Where a point goes, inside the frame or not.
    pub(super) fn pixel(&self, (x, y): (f64, f64)) -> Pixel {
        self.pixel_of_units((self.x.unit(x), self.y.unit(y)))
    }

    /// Where a point goes that is given in the units of the views.
    pub(super) fn pixel_of_units(&self, (x, y): (f64, f64)) -> Pixel {
        // Far outside, so that the line to it is drawn right, and still finite.
        let bounded = |pixel: f64| pixel.clamp(-1e12, 1e12);
        (
            bounded(self.left + (x - self.x.low) / self.x.span() * self.width),
            bounded(self.bottom() - (y - self.y.low) / self.y.span() * self.height),
        )
    }

    /// Is the point shown?
    pub(super) fn shows(&self, (x, y): (f64, f64)) -> bool {
        self.x.shows(x) && self.y.shows(y)
    }

    /// The parts of a polyline that lie inside the frame.
    pub(super) fn clip(&self, line: &[Pixel]) -> Vec<Vec<Pixel>> {
        let mut parts: Vec<Vec<Pixel>> = Vec::new();
        let mut open = false;
        for pair in line.windows(2) {
            let Some((from, to)) = self.clip_segment(pair[0], pair[1]) else {
                open = false;
                continue;
            };
            match parts.last_mut() {
                Some(part) if open => part.push(to),
                _ => parts.push(vec![from, to]),
            }
            // The next segment goes on from here only where this one was not cut short.
            open = to == pair[1];
        }
        parts
    }

    /// The part of a segment inside the frame (Liang and Barsky 1984).
    fn clip_segment(&self, from: Pixel, to: Pixel) -> Option<(Pixel, Pixel)> {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        let borders = [
            (-dx, from.0 - self.left),
            (dx, self.right() - from.0),
            (-dy, from.1 - self.top),
            (dy, self.bottom() - from.1),
        ];
        for (outwards, room) in borders {
            if outwards == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if outwards < 0.0 {
                enter = enter.max(room / outwards);
            } else {
                leave = leave.min(room / outwards);
            }
        }
        if enter > leave {
            return None;
        }
        let at = |t: f64| (from.0 + t * dx, from.1 + t * dy);
        Some((if enter > 0.0 { at(enter) } else { from }, if leave < 1.0 { at(leave) } else { to }))
    }

    /// The arcs of the unit circle that lie inside the frame, however far the panel zooms in.
    pub(super) fn unit_circle(&self) -> Vec<Vec<Pixel>> {
        use std::f64::consts::{FRAC_PI_2, PI, TAU};
        // Angles at which the circle crosses the lines that bound the frame; between two of them it is inside or outside.
        let mut cuts: Vec<f64> = vec![0.0, FRAC_PI_2, PI, 3.0 * FRAC_PI_2, TAU];
        for bound in [self.x.low, self.x.high] {
            if bound.abs() < 1.0 {
                cuts.extend([bound.acos(), TAU - bound.acos()]);
            }
        }
        for bound in [self.y.low, self.y.high] {
            if bound.abs() < 1.0 {
                cuts.extend([bound.asin().rem_euclid(TAU), PI - bound.asin()]);
            }
        }
        cuts.sort_by(f64::total_cmp);
        let mut arcs: Vec<Vec<Pixel>> = Vec::new();
        for cut in cuts.windows(2) {
            let at = |t: f64| (cut[0] + t * (cut[1] - cut[0])).sin_cos();
            let (sin, cos) = at(0.5);
            if cut[1] - cut[0] < 1e-14 || !self.shows((cos, sin)) {
                continue;
            }
            const STEPS: u32 = 48; // Of at most a quarter turn: the chord is 0.00013 of a radius off.
            let point = |i: u32| {
                let (sin, cos) = at(f64::from(i) / f64::from(STEPS));
                self.pixel((cos, sin))
            };
            let joined =
                arcs.last_mut().filter(|arc| arc.last().is_some_and(|end| close(*end, point(0))));
            match joined {
                Some(arc) => arc.extend((1..=STEPS).map(point)),
                None => arcs.push((0..=STEPS).map(point).collect()),
            }
        }
        arcs
    }
}

fn close(a: Pixel, b: Pixel) -> bool {
    (a.0 - b.0).hypot(a.1 - b.1) < 1e-6
}

#[cfg(test)]
mod tests;
