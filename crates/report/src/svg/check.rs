//! Is the figure drawable: ranges in order, numbers finite, logarithms defined. Yields what the data span.

use crate::ReportError;
use crate::figure::{Aspect, Axis, Figure, Guide, Panel, Scale};
use crate::series::Series;

/// Lowest and highest value in one direction, none where there is no value.
pub(super) type Span = Option<(f64, f64)>;

/// Largest magnitude that can be drawn: spans and their margins stay finite.
const LARGEST: f64 = 1e300;

/// Checks what concerns the figure as a whole.
pub(super) fn figure(figure: &Figure) -> Result<(), ReportError> {
    let name = || figure.id.clone();
    let known = |c: u8| c.is_ascii_lowercase() || c.is_ascii_digit() || c == b'-' || c == b'_';
    let id = figure.id.as_bytes();
    if !(1..=80).contains(&id.len()) || !id[0].is_ascii_lowercase() || !id.iter().all(|c| known(*c))
    {
        return Err(ReportError::FigureId { id: name() });
    }
    if figure.panels.is_empty() {
        return Err(ReportError::NoPanels { figure: name() });
    }
    if figure.columns == 0 {
        return Err(ReportError::NoColumns { figure: name() });
    }
    Ok(())
}

/// Checks a panel (counted from 1) and returns what its data span in x and y.
pub(super) fn panel(
    figure: &Figure,
    number: usize,
    panel: &Panel,
) -> Result<(Span, Span), ReportError> {
    let both_linear = panel.x.scale == Scale::Linear && panel.y.scale == Scale::Linear;
    if panel.aspect == Aspect::Equal && !both_linear {
        return Err(ReportError::EqualAspectOnLog { figure: figure.id.clone(), panel: number });
    }
    let mut spans = [None, None];
    for (axis, name) in [(&panel.x, "x"), (&panel.y, "y")] {
        range(figure, number, axis, name)?;
    }
    for series in &panel.series {
        let mut fault = None;
        for_each(series, |index, x, y| {
            let seen = [(x, &panel.x, "x"), (y, &panel.y, "y")];
            for ((value, axis, name), span) in seen.into_iter().zip(&mut spans) {
                let Some(value) = value else { continue };
                let place = (figure.id.clone(), series.label().to_owned());
                if !drawable(value) {
                    let (figure, series) = place;
                    fault.get_or_insert(ReportError::NotFinite {
                        figure,
                        panel: number,
                        series,
                        index,
                        value,
                    });
                } else if axis.scale == Scale::Log10
                    && (value < 0.0 || (value == 0.0 && axis.range.is_none()))
                {
                    let (figure, series) = place;
                    fault.get_or_insert(ReportError::NotPositive {
                        figure,
                        panel: number,
                        series,
                        index,
                        axis: name,
                        value,
                    });
                } else if axis.scale == Scale::Linear || value > 0.0 {
                    widen(span, value);
                }
            }
        });
        if let Some(fault) = fault {
            return Err(fault);
        }
        if matches!(series, Series::Stems(_))
            && panel.y.scale == Scale::Linear
            && spans[1].is_some()
        {
            widen(&mut spans[1], 0.0);
        }
    }
    for guide in &panel.guides {
        match *guide {
            Guide::UnitCircle => spans.iter_mut().for_each(|span| {
                widen(span, -1.0);
                widen(span, 1.0);
            }),
            Guide::Horizontal(value) | Guide::Vertical(value) if !drawable(value) => {
                let (figure, series) = (figure.id.clone(), "guide".to_owned());
                return Err(ReportError::NotFinite {
                    figure,
                    panel: number,
                    series,
                    index: 0,
                    value,
                });
            }
            Guide::Horizontal(_) | Guide::Vertical(_) => {}
        }
    }
    for (axis, span, name) in [(&panel.x, spans[0], "x"), (&panel.y, spans[1], "y")] {
        if axis.range.is_none() && span.is_none() {
            return Err(ReportError::NoData {
                figure: figure.id.clone(),
                panel: number,
                axis: name,
            });
        }
    }
    Ok((spans[0], spans[1]))
}

fn range(
    figure: &Figure,
    panel: usize,
    axis: &Axis,
    name: &'static str,
) -> Result<(), ReportError> {
    let Some((low, high)) = axis.range else { return Ok(()) };
    let finite = drawable(low) && drawable(high);
    let defined = axis.scale == Scale::Linear || low > 0.0;
    // Closer ends than this cannot be told apart on their labels.
    let apart = high - low > 1e-12 * low.abs().max(high.abs());
    if finite && defined && apart {
        return Ok(());
    }
    Err(ReportError::Range { figure: figure.id.clone(), panel, axis: name, low, high })
}

/// Is it finite, and are spans with their margins?
fn drawable(value: f64) -> bool {
    value.abs() <= LARGEST
}

fn widen(span: &mut Span, value: f64) {
    let (low, high) = span.unwrap_or((value, value));
    *span = Some((low.min(value), high.max(value)));
}

/// Calls back with (index of the item, x, y) for everything that has to be finite; a size has only one of the two.
fn for_each(series: &Series, mut see: impl FnMut(usize, Option<f64>, Option<f64>)) {
    match series {
        Series::Points(s) => {
            s.xy.iter().enumerate().for_each(|(i, p)| see(i, Some(p.0), Some(p.1)))
        }
        Series::Line(s) => s.xy.iter().enumerate().for_each(|(i, p)| see(i, Some(p.0), Some(p.1))),
        Series::Stems(s) => s.xy.iter().enumerate().for_each(|(i, p)| see(i, Some(p.0), Some(p.1))),
        Series::Notes(s) => {
            s.notes.iter().enumerate().for_each(|(i, n)| see(i, Some(n.0), Some(n.1)))
        }
        Series::Band(s) => s.bounds.iter().enumerate().for_each(|(i, b)| {
            see(i, Some(b.0), Some(b.1));
            see(i, None, Some(b.2));
        }),
        Series::Ellipses(s) => s.ellipses.iter().enumerate().for_each(|(i, e)| {
            let (sin, cos) = e.angle_rad.sin_cos();
            let half_x = (e.semi_axes.0 * cos).hypot(e.semi_axes.1 * sin);
            let half_y = (e.semi_axes.0 * sin).hypot(e.semi_axes.1 * cos);
            see(i, Some(e.center.0 - half_x), Some(e.center.1 - half_y));
            see(i, Some(e.center.0 + half_x), Some(e.center.1 + half_y));
        }),
    }
}

#[cfg(test)]
mod tests;
