//! The eigenvalues in the s-plane with their 95 % regions.

use num_complex::Complex;
use report::{
    Axis, Block, Dash, Ellipse, Ellipses, Figure, Guide, Ink, Line, Notes, Panel, Points,
};

use crate::CommandError;
use crate::identify::outcome::Outcome;
use crate::modes::IdentifiedMode;

pub(super) const ID: &str = "pole-map";

/// A zoom shows this many half axes to either side.
const REACH: f64 = 1.8;

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    if input.found.is_empty() {
        return Ok(Vec::new());
    }
    let points: Vec<Complex<f64>> = input.found.iter().map(at).collect();
    let regions: Vec<Region> = input.found.iter().filter_map(Region::of).collect();
    let fill = |panel: Panel| {
        let panel = regions.iter().fold(panel, |panel, region| region.draw(panel));
        panel.with(Points::poles("eigenvalue", points.iter().map(|s| (s.re, s.im))))
    };
    let empty = |title: String| {
        Panel::new(title, Axis::linear("real part (1/s)"), Axis::linear("imaginary part (rad/s)"))
            .equal_axes()
            .guide(Guide::Vertical(0.0))
            .guide(Guide::Horizontal(0.0))
    };
    let names =
        input.found.iter().map(|found| (at(found).re, at(found).im, found.named.name.to_string()));
    let (x, y) = whole(&points, &regions);
    let mut clusters = clusters(&regions);
    // A glass that makes things smaller shows nothing.
    clusters.retain(|cluster| 2.0 * cluster.half < x.1 - x.0);
    let title = if clusters.is_empty() { String::new() } else { "all".to_owned() };
    let all = fill(empty(title)).zoom(x, y).with(Notes::new(names));
    let is_profiled = input.found.iter().any(|found| found.mode.interval_95.is_some());
    let caption = match (regions.is_empty(), is_profiled) {
        (true, _) => {
            "Upper half of the s-plane; stable modes lie left of the vertical line. This method gives no regions."
        }
        (false, true) => {
            "Upper half of the s-plane, and each mode under the magnifying glass. An ellipse, and for a real mode an interval, holds the eigenvalue with \
             95 %; intervals are those of the likelihood and need not be symmetric. Stable modes lie left of the vertical line."
        }
        (false, false) => {
            "Upper half of the s-plane, and each mode under the magnifying glass. An ellipse, and for a real mode an interval, holds the eigenvalue with \
             95 %. Stable modes lie left of the vertical line."
        }
    };
    let mut figure = Figure::new(ID, "Eigenvalues in the s-plane", caption)
        .columns(if clusters.is_empty() { 1 } else { 2 })
        .with(all);
    for cluster in clusters {
        let (c, half) = (cluster.center, cluster.half);
        let zoomed =
            fill(empty(cluster.names)).zoom((c.re - half, c.re + half), (c.im - half, c.im + half));
        figure = figure.with(zoomed);
    }
    Ok(vec![figure.into()])
}

fn at(found: &IdentifiedMode) -> Complex<f64> {
    found.mode.mode.eigenvalue
}

/// The ranges of both axes around all points, the origin and those regions that are not much larger than all of that, with room for names.
fn whole(points: &[Complex<f64>], regions: &[Region]) -> ((f64, f64), (f64, f64)) {
    const MUCH: f64 = 1.5;
    let square = |ends: &[Complex<f64>]| {
        let reals = || ends.iter().map(|s| s.re).chain([0.0]);
        let low = reals().fold(f64::INFINITY, f64::min);
        let high = reals().fold(f64::NEG_INFINITY, f64::max);
        let top = ends.iter().map(|s| s.im).fold(0.0, f64::max);
        (low, high, (high - low).max(top).max(f64::MIN_POSITIVE))
    };
    let (_, _, size) = square(points);
    let shown = regions.iter().filter(|region| region.reach < MUCH * size);
    let ends = shown.flat_map(|region| {
        let up = if region.center.im > 0.0 { region.reach } else { 0.0 };
        let corner = Complex::new(region.reach, up);
        [region.center - region.reach, region.center + corner]
    });
    let (low, high, size) = square(&points.iter().copied().chain(ends).collect::<Vec<_>>());
    let margin = 0.12 * size;
    let middle = 0.5 * (low + high);
    ((middle - 0.5 * size - margin, middle + 0.5 * size + margin), (-margin, size + margin))
}

/// Where a mode lies with 95 %.
struct Region {
    name: String,
    center: Complex<f64>,
    /// The longer half axis, or the distance to the farther end, positive.
    reach: f64,
    shape: Shape,
}

#[derive(Clone, Copy)]
enum Shape {
    Ellipse(Ellipse),
    /// From the lowest to the highest real part.
    Interval([f64; 2]),
}

impl Region {
    /// `None` where the method or the records say nothing.
    fn of(found: &IdentifiedMode) -> Option<Self> {
        let center = at(found);
        let (reach, shape) = if center.im > 0.0 {
            let ellipse = found.mode.estimate.as_ref()?.continuous.ellipse_95();
            let drawn = Ellipse {
                center: (center.re, center.im),
                semi_axes: (ellipse.major, ellipse.minor),
                angle_rad: ellipse.angle_rad,
            };
            (ellipse.major, Shape::Ellipse(drawn))
        } else {
            // One number has an interval. Where that has no end, it leaves the panel.
            const FAR: f64 = 1e3;
            let ends = found.eigenvalue_interval_95()?;
            let distances = ends.map(|end| (end - center.re).abs());
            let reach = distances.into_iter().filter(|d| d.is_finite()).fold(0.0, f64::max);
            let far = FAR * reach.max(center.norm());
            (reach, Shape::Interval(ends.map(|end| end.clamp(center.re - far, center.re + far))))
        };
        let usable = reach.is_finite() && reach > 1e-12 * center.norm();
        usable.then(|| Self { name: found.named.name.to_string(), center, reach, shape })
    }

    fn draw(&self, panel: Panel) -> Panel {
        match self.shape {
            Shape::Ellipse(ellipse) => panel
                .with(Ellipses::new("95 % ellipse", Dash::Solid, [ellipse]).ink(Ink::Vermillion)),
            Shape::Interval(ends) => {
                let ends = ends.map(|end| (end, self.center.im));
                panel.with(Line::new("95 % interval", Dash::Solid, ends).ink(Ink::Green).width(3.0))
            }
        }
    }
}

/// Modes that are looked at together, since one lies in the other's neighbourhood.
struct Cluster {
    names: String,
    center: Complex<f64>,
    half: f64,
}

fn clusters(regions: &[Region]) -> Vec<Cluster> {
    let mut groups: Vec<Vec<&Region>> = Vec::new();
    for region in regions {
        let near = |other: &&Region| {
            (other.center - region.center).norm() < REACH * other.reach.max(region.reach)
        };
        let (close, mut far): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|group| group.iter().any(near));
        far.push(close.into_iter().flatten().chain([region]).collect());
        groups = far;
    }
    groups.into_iter().map(|group| cluster(&group)).collect()
}

fn cluster(group: &[&Region]) -> Cluster {
    let ends = |part: fn(&Complex<f64>) -> f64| {
        let low = group.iter().map(|region| part(&region.center) - region.reach);
        let high = group.iter().map(|region| part(&region.center) + region.reach);
        (low.fold(f64::INFINITY, f64::min), high.fold(f64::NEG_INFINITY, f64::max))
    };
    let ((left, right), (bottom, top)) = (ends(|s| s.re), ends(|s| s.im));
    let names: Vec<&str> = group.iter().map(|region| region.name.as_str()).collect();
    Cluster {
        names: names.join(" and "),
        center: Complex::new(0.5 * (left + right), 0.5 * (bottom + top)),
        half: 0.5 * REACH * (right - left).max(top - bottom),
    }
}

/// The ends of the bar that is drawn for a real mode.
#[cfg(test)]
pub(super) fn ends(found: &IdentifiedMode) -> Option<[f64; 2]> {
    match Region::of(found)?.shape {
        Shape::Interval(ends) => Some(ends),
        Shape::Ellipse(_) => None,
    }
}
