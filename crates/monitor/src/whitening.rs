//! An autoregression that makes a coloured signal nearly white.

/// Longest memory that is tried, in samples.
const LONGEST: usize = 40;

/// The filter w(k) = e(k) + a_1 e(k-1) + .. + a_q e(k-q).
///
/// # Example
///
/// ```
/// use monitor::Whitening;
///
/// // e(k) = -0.5 e(k-1) + w(k) with alternating w.
/// let mut e = vec![1.0_f64];
/// for k in 1..2000 {
///     let w = if (k * k * 7919) % 104_729 % 2 == 0 { 1.0 } else { -1.0 };
///     e.push(-0.5 * e[k - 1] + w);
/// }
/// let whitening = Whitening::fit(&[&e]);
/// assert!((whitening.coefficients()[0] - 0.5).abs() < 0.1);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Whitening {
    coefficients: Vec<f64>,
}

impl Whitening {
    /// Fits by the Levinson recursion to the autocovariances about zero; the Bayesian information criterion chooses the order.
    #[must_use]
    pub fn fit(stretches: &[&[f64]]) -> Self {
        let samples: usize = stretches.iter().map(|stretch| stretch.len()).sum();
        let longest = LONGEST.min(samples / 10);
        let covariance = |lag: usize| -> f64 {
            stretches
                .iter()
                .map(|e| e.iter().zip(e.iter().skip(lag)).map(|(x, y)| x * y).sum::<f64>())
                .sum()
        };
        let covariances: Vec<f64> = (0..=longest).map(covariance).collect();
        Self { coefficients: levinson(&covariances, samples) }
    }

    /// a_1 .. a_q.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The memory q, in samples.
    pub(crate) fn order(&self) -> usize {
        self.coefficients.len()
    }

    /// The filtered signal, q samples shorter.
    pub(crate) fn apply(&self, signal: &[f64]) -> Vec<f64> {
        let filtered = |window: &[f64]| -> f64 {
            let mut newest_first = window.iter().rev();
            let newest = newest_first.next().copied().unwrap_or_default();
            newest + newest_first.zip(&self.coefficients).map(|(e, a)| a * e).sum::<f64>()
        };
        signal.windows(self.order() + 1).map(filtered).collect()
    }
}

/// The coefficients of the order whose criterion N ln(variance) + q ln N is least.
fn levinson(covariances: &[f64], samples: usize) -> Vec<f64> {
    let n = samples as f64;
    let mut variance = covariances.first().copied().unwrap_or_default();
    let (mut coefficients, mut best) = (Vec::new(), Vec::new());
    if variance <= 0.0 {
        return best;
    }
    let mut least = n * variance.ln();
    for order in 1..covariances.len() {
        let known = coefficients.iter().zip(covariances[1..order].iter().rev());
        let numerator = covariances[order] + known.map(|(a, c): (&f64, &f64)| a * c).sum::<f64>();
        let reflection = -numerator / variance;
        let mirrored: Vec<f64> = coefficients.iter().rev().copied().collect();
        for (a, other) in coefficients.iter_mut().zip(mirrored) {
            *a += reflection * other;
        }
        coefficients.push(reflection);
        variance *= 1.0 - reflection * reflection;
        if variance <= 0.0 {
            break;
        }
        let criterion = n * variance.ln() + order as f64 * n.ln();
        if criterion < least {
            least = criterion;
            best.clone_from(&coefficients);
        }
    }
    best
}

#[cfg(test)]
mod tests;
