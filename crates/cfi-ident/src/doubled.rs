//! Sums of products as if in twice the working precision.
//!
//! A value is an unevaluated pair `high + low`. Products are split by Veltkamp's method instead of a fused multiply-add, because
//! that one is a slow library call where the target has no such instruction, and the split of a signal can be kept.
//! Source: Ogita, Rump & Oishi, *Accurate sum and dot product*, SIAM J. Sci. Comput. 26 (2005), algorithms 3.1 to 3.3 and 5.3.

/// 2^27 + 1: halves a 53-bit significand.
const SPLITTER: f64 = 134_217_729.0;

/// A signal with each sample cut into a high and a low half of at most 26 bits.
#[derive(Debug, Clone)]
pub(crate) struct Halves {
    high: Vec<f64>,
    low: Vec<f64>,
}

/// Cuts a number into two halves whose products are exact. Magnitudes above 2^996 would overflow.
fn split(x: f64) -> (f64, f64) {
    let c = SPLITTER * x;
    let high = c - (c - x);
    (high, x - high)
}

/// The rounded sum and its rounding error.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let z = sum - a;
    (sum, (a - (sum - z)) + (b - z))
}

impl Halves {
    /// Cuts every sample.
    pub(crate) fn new(signal: &[f64]) -> Self {
        let (high, low) = signal.iter().map(|x| split(*x)).unzip();
        Self { high, low }
    }
}

/// `high[k] + low[k] += factor * signal[from + k]` for every k.
pub(crate) fn add_multiple(
    high: &mut [f64],
    low: &mut [f64],
    factor: f64,
    signal: &[f64],
    halves: &Halves,
    from: usize,
) {
    let to = from + high.len();
    let (factor_high, factor_low) = split(factor);
    let signal = signal[from..to].iter().zip(&halves.high[from..to]).zip(&halves.low[from..to]);
    for ((high, low), ((x, x_high), x_low)) in high.iter_mut().zip(low).zip(signal) {
        let product = factor * x;
        let product_error = factor_low * x_low
            - (((product - factor_high * x_high) - factor_low * x_high) - factor_high * x_low);
        let (sum, sum_error) = two_sum(*high, product);
        *high = sum;
        *low += product_error + sum_error;
    }
}

/// A sum kept as a pair.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    /// Adds one number.
    pub(crate) fn add(&mut self, x: f64) {
        let (sum, error) = two_sum(self.high, x);
        self.high = sum;
        self.low += error;
    }

    /// The sum of several sums.
    pub(crate) fn merge(sums: &[Self]) -> Self {
        sums.iter().fold(Self::default(), |mut total, sum| {
            total.add(sum.high);
            total.low += sum.low;
            total
        })
    }

    /// The rounded value.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

/// `sums += sum over k of weights[k] * signal[from + k]`, in four interleaved sums of a fixed order.
pub(crate) fn add_dot(
    sums: &mut [Sum; LANES],
    weights: &[f64],
    weight_halves: &Halves,
    signal: &[f64],
    halves: &Halves,
    from: usize,
) {
    let to = from + weights.len();
    let weights = weights
        .chunks(LANES)
        .zip(weight_halves.high.chunks(LANES))
        .zip(weight_halves.low.chunks(LANES));
    let signal = signal[from..to]
        .chunks(LANES)
        .zip(halves.high[from..to].chunks(LANES))
        .zip(halves.low[from..to].chunks(LANES));
    for (((w, w_high), w_low), ((x, x_high), x_low)) in weights.zip(signal) {
        for (i, sum) in sums.iter_mut().enumerate().take(w.len()) {
            let product = w[i] * x[i];
            let error = w_low[i] * x_low[i]
                - (((product - w_high[i] * x_high[i]) - w_low[i] * x_high[i])
                    - w_high[i] * x_low[i]);
            sum.add(product);
            sum.low += error;
        }
    }
}

/// Interleaved sums of [`add_dot`].
pub(crate) const LANES: usize = 4;

#[cfg(test)]
mod tests;
