//! The slope of a straight line through points on logarithmic axes: the power with which a time grows.

/// The least-squares slope of log(y) over log(x); `None` unless two different x and only positive values are given.
///
/// slope = sum (u - mean u)(v - mean v) / sum (u - mean u)^2, with u = log x and v = log y.
pub(crate) fn log_log_slope(points: &[(f64, f64)]) -> Option<f64> {
    if points.iter().any(|(x, y)| !(*x > 0.0 && *y > 0.0 && x.is_finite() && y.is_finite())) {
        return None;
    }
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let mean =
        |part: fn(&(f64, f64)) -> f64| logs.iter().map(part).sum::<f64>() / logs.len() as f64;
    let (u_mean, v_mean) = (mean(|log| log.0), mean(|log| log.1));
    let along: f64 = logs.iter().map(|(u, _)| (u - u_mean).powi(2)).sum();
    let across: f64 = logs.iter().map(|(u, v)| (u - u_mean) * (v - v_mean)).sum();
    (along > 0.0).then(|| across / along)
}

#[cfg(test)]
mod tests;
