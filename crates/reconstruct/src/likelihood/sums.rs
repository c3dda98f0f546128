//! The sums over frequencies behind cost, gradient and Gram matrix of one record: the inner loop of the fit.
//!
//! At one frequency, H = C (zI - A)^-1, g = H b + d, Phi = S^-1 - S^-1 g g^H S^-1 / (g^H S^-1 g), S the noise covariance, and e what the sensors
//! read less what known signals explain. The excitation's estimate is U = g^H S^-1 e / (g^H S^-1 g), the state's X = (zI - A)^-1 (b U + f tau), and
//! the cost is e^H Phi e. Every parameter moves the sensors by a column of D = [H, I] times one of the scalars s = (X, U, f): entry (i, l) of A by H_i X_l,
//! b_i by H_i U, entry (s, l) of C by I_s X_l. So the Gram matrix is the sum of Re (D^H Phi D)_ik conj(s_a) s_c, a Kronecker product at each
//! frequency, and the sum is a product of two matrices with one column per frequency.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par};
use num_complex::Complex;

use super::resolvent::Resolvent;
use super::spectrum::{Entry, RecordSpectrum};

const ZERO: Complex<f64> = Complex::new(0.0, 0.0);
/// Frequencies summed by one matrix product; a multiple of every vector width.
const TILE: usize = 64;

/// What one record sees of the system: A and C with a feedback (see `feedback.rs`), row by row.
#[derive(Debug)]
pub(super) struct Seen {
    pub(super) a: Vec<f64>,
    pub(super) c: Vec<f64>,
    pub(super) b: Vec<f64>,
    pub(super) d: Vec<f64>,
    /// The feedback's gain.
    pub(super) gain: Vec<f64>,
    /// For each known factor, n + m coefficients: into the state, into the sensors.
    pub(super) coefficients: Vec<Vec<f64>>,
    /// Noise variances of the sensors; not used where the spectrum has its own covariances.
    pub(super) variances: Vec<f64>,
}

/// Which scalars multiply D.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalars {
    /// The estimates X and U.
    Estimated,
    /// Only what noise alone would contribute to them: U = 1 / sqrt(g^H S^-1 g), X = (zI - A)^-1 b U, f = 0.
    NoisePart,
}

/// The sums.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    rows: usize,
    /// Re (D^H Phi D)_ik times Re conj(s_a) s_c for i <= k and a <= c.
    real: Mat<f64>,
    /// The same of the imaginary parts.
    imaginary: Mat<f64>,
    /// Re conj(s_a) (D^H Phi e)_i: the steepest descent of half the cost, `rows` entries for each scalar.
    descent: Vec<f64>,
    pub(super) cost: f64,
    /// The sum of weight times ln det S + ln (g^H S^-1 g / g^H g), for white noise.
    pub(super) log_determinant: f64,
    /// The sum of weight times |Phi_il|^2, m x m.
    pub(super) information: Vec<f64>,
    /// The sum of weight times |(Phi e)_i|^2 - Phi_ii.
    pub(super) score: Vec<f64>,
    /// The sum of weight times Re conj(X_a) X_c, n x n: how far the states move.
    pub(super) states: Vec<f64>,
    /// Cost at each frequency, where asked for.
    pub(super) spectrum: Option<Vec<f64>>,
}

impl Sums {
    /// The entry of the Gram matrix for the cells (row of D, scalar).
    pub(super) fn gram(&self, first: (usize, usize), second: (usize, usize)) -> f64 {
        let ((i, a), (k, c)) = (first, second);
        let row = packed(i, k);
        let column = packed(a, c);
        // Both orders reversed conjugate both factors; one reversed, one of them.
        let sign = if (i <= k) == (a <= c) { -1.0 } else { 1.0 };
        let imaginary = if i == k || a == c { 0.0 } else { self.imaginary[(row, column)] };
        self.real[(row, column)] + sign * imaginary
    }

    pub(super) fn descent(&self, cell: (usize, usize)) -> f64 {
        self.descent[cell.1 * self.rows + cell.0]
    }

}

/// Index of (i, k) among pairs with i <= k, column by column.
fn packed(i: usize, k: usize) -> usize {
    let (low, high) = if i <= k { (i, k) } else { (k, i) };
    high * (high + 1) / 2 + low
}

/// Buffers of the inner loop.
#[derive(Debug)]
struct Tile {
    /// Weighted D^H Phi D, packed, one column per frequency: real and imaginary parts.
    z: [Vec<f64>; 2],
    /// conj(s_a) s_c, packed, one column per frequency.
    w: [Vec<f64>; 2],
    filled: usize,
}

/// Adds up one record.
pub(super) fn sums(
    record: &RecordSpectrum,
    seen: &Seen,
    scalars: Scalars,
    keep_spectrum: bool,
) -> Sums {
    let (n, m) = (seen.b.len(), seen.d.len());
    let factors = record.entries.len();
    let (rows, count) = (n + m, n + 1 + factors);
    let (z_rows, w_rows) = (rows * (rows + 1) / 2, count * (count + 1) / 2);
    let mut sums = Sums {
        rows,
        real: Mat::zeros(z_rows, w_rows),
        imaginary: Mat::zeros(z_rows, w_rows),
        descent: vec![0.0; rows * count],
        cost: 0.0,
        log_determinant: 0.0,
        information: vec![0.0; m * m],
        score: vec![0.0; m],
        states: vec![0.0; n * n],
        spectrum: keep_spectrum.then(|| Vec::with_capacity(record.frequencies())),
    };
    let mut tile = Tile {
        z: [vec![0.0; z_rows * TILE], vec![0.0; z_rows * TILE]],
        w: [vec![0.0; w_rows * TILE], vec![0.0; w_rows * TILE]],
        filled: 0,
    };
    let mut at = AtFrequency::new(n, m, factors);
    let white: Vec<f64> = seen.variances.iter().map(|variance| 1.0 / variance).collect();
    for k in 0..record.frequencies() {
        at.evaluate(record, seen, &white, k);
        let weight = record.weight[k];
        let cost = weight * at.cost();
        sums.cost += cost;
        if let Some(spectrum) = &mut sums.spectrum {
            spectrum.push(cost);
        }
        at.add_levels(weight, &mut sums);
        match scalars {
            Scalars::Estimated => at.estimated_scalars(record, seen, k),
            Scalars::NoisePart => at.noise_scalars(seen),
        }
        at.add_states(weight, &mut sums);
        at.add_descent(weight, &mut sums);
        at.fill(weight, &mut tile);
        if tile.filled == TILE {
            flush(&mut tile, &mut sums);
        }
    }
    flush(&mut tile, &mut sums);
    sums
}

fn flush(tile: &mut Tile, sums: &mut Sums) {
    let depth = tile.filled;
    if depth == 0 {
        return;
    }
    let targets = [&mut sums.real, &mut sums.imaginary];
    for ((target, z), w) in targets.into_iter().zip(&tile.z).zip(&tile.w) {
        let (z_rows, w_rows) = (target.nrows(), target.ncols());
        let left = MatRef::from_column_major_slice(&z[..z_rows * depth], z_rows, depth);
        let right = MatRef::from_column_major_slice(&w[..w_rows * depth], w_rows, depth);
        let target: MatMut<'_, f64> = target.as_mut();
        matmul(target, Accum::Add, left, right.transpose(), 1.0, Par::Seq);
    }
    tile.filled = 0;
}

/// Everything at one frequency.
#[derive(Debug)]
struct AtFrequency {
    n: usize,
    m: usize,
    resolvent: Resolvent,
    /// H, m rows of n.
    h: Vec<Complex<f64>>,
    g: Vec<Complex<f64>>,
    /// S^-1 g.
    sg: Vec<Complex<f64>>,
    /// g^H S^-1 g.
    gain: f64,
    /// S^-1 where it is not diagonal, else its diagonal in the first m places.
    precision: Vec<Complex<f64>>,
    diagonal: bool,
    /// What known signals leave, then also less g U.
    e: Vec<Complex<f64>>,
    /// Phi e.
    q: Vec<Complex<f64>>,
    u: Complex<f64>,
    /// Phi, m x m.
    phi: Vec<Complex<f64>>,
    /// Phi H, m rows of n.
    phi_h: Vec<Complex<f64>>,
    /// X, U, f.
    scalars: Vec<Complex<f64>>,
    state: Vec<Complex<f64>>,
}

impl AtFrequency {
    fn new(n: usize, m: usize, factors: usize) -> Self {
        Self {
            n,
            m,
            resolvent: Resolvent::new(n),
            h: vec![ZERO; m * n],
            g: vec![ZERO; m],
            sg: vec![ZERO; m],
            gain: 0.0,
            precision: vec![ZERO; m * m],
            diagonal: true,
            e: vec![ZERO; m],
            q: vec![ZERO; m],
            u: ZERO,
            phi: vec![ZERO; m * m],
            phi_h: vec![ZERO; m * n],
            scalars: vec![ZERO; n + 1 + factors],
            state: vec![ZERO; n],
        }
    }

    fn evaluate(&mut self, record: &RecordSpectrum, seen: &Seen, white: &[f64], k: usize) {
        let (n, m) = (self.n, self.m);
        self.resolvent.factor(record.z[k], &seen.a);
        for s in 0..m {
            let row = &mut self.h[s * n..(s + 1) * n];
            for (entry, &c) in row.iter_mut().zip(&seen.c[s * n..(s + 1) * n]) {
                *entry = Complex::new(c, 0.0);
            }
            self.resolvent.solve_row(row);
            self.g[s] = Complex::new(seen.d[s], 0.0);
            for (entry, &b) in row.iter().zip(&seen.b) {
                self.g[s] += entry * b;
            }
        }
        self.load_precision(record, seen, white, k);
        self.residual(record, seen, k);
        for s in 0..m {
            self.sg[s] = self.weighted(s, &self.g);
        }
        self.gain = self.g.iter().zip(&self.sg).map(|(g, sg)| (g.conj() * sg).re).sum();
        self.u = ZERO;
        if self.gain > 0.0 {
            // Twice: the second pass removes what the first one's rounding left along g.
            for _ in 0..2 {
                let part =
                    self.sg.iter().zip(&self.e).map(|(sg, e)| sg.conj() * e).sum::<Complex<f64>>()
                        / self.gain;
                for (e, g) in self.e.iter_mut().zip(&self.g) {
                    *e -= g * part;
                }
                self.u += part;
            }
        }
        for s in 0..m {
            self.q[s] = self.weighted(s, &self.e);
        }
        self.projector();
    }

    fn load_precision(&mut self, record: &RecordSpectrum, seen: &Seen, white: &[f64], k: usize) {
        let m = self.m;
        if let Some(precision) = &record.precision {
            self.diagonal = false;
            self.precision.copy_from_slice(&precision[k * m * m..(k + 1) * m * m]);
        } else if k == 0 && record.starts_at_zero {
            for s in 0..m {
                let variance = seen.variances[s] + record.offset_variance[s];
                self.precision[s] = Complex::new(1.0 / variance, 0.0);
            }
        } else {
            for (entry, &white) in self.precision.iter_mut().zip(white) {
                *entry = Complex::new(white, 0.0);
            }
        }
    }

    /// Entry s of S^-1 v.
    fn weighted(&self, s: usize, v: &[Complex<f64>]) -> Complex<f64> {
        if self.diagonal {
            return v[s] * self.precision[s].re;
        }
        self.precision[s * self.m..(s + 1) * self.m].iter().zip(v).map(|(p, v)| p * v).sum()
    }

    /// e = Y - f (H tau + delta).
    fn residual(&mut self, record: &RecordSpectrum, seen: &Seen, k: usize) {
        let (n, m) = (self.n, self.m);
        self.e.copy_from_slice(&record.y[k * m..(k + 1) * m]);
        let factors = &record.factors[k * record.entries.len()..];
        self.state.fill(ZERO);
        for ((coefficients, factor), entry) in
            seen.coefficients.iter().zip(factors).zip(&record.entries)
        {
            if *entry != Entry::Sensors {
                for (state, &tau) in self.state.iter_mut().zip(coefficients) {
                    *state += factor * tau;
                }
            }
            if *entry != Entry::State {
                for (e, &delta) in self.e.iter_mut().zip(&coefficients[n..]) {
                    *e -= factor * delta;
                }
            }
        }
        for s in 0..m {
            let row = &self.h[s * n..(s + 1) * n];
            self.e[s] -=
                row.iter().zip(&self.state).map(|(h, state)| h * state).sum::<Complex<f64>>();
        }
    }

    /// Phi and Phi H.
    fn projector(&mut self) {
        let (n, m) = (self.n, self.m);
        let inverse = if self.gain > 0.0 { 1.0 / self.gain } else { 0.0 };
        for i in 0..m {
            for l in 0..m {
                let precision = if !self.diagonal {
                    self.precision[i * m + l]
                } else if i == l {
                    self.precision[i]
                } else {
                    ZERO
                };
                self.phi[i * m + l] = precision - self.sg[i] * self.sg[l].conj() * inverse;
            }
        }
        for i in 0..m {
            let target = &mut self.phi_h[i * n..(i + 1) * n];
            target.fill(ZERO);
            for l in 0..m {
                let phi = self.phi[i * m + l];
                for (target, h) in target.iter_mut().zip(&self.h[l * n..(l + 1) * n]) {
                    *target += phi * h;
                }
            }
        }
    }

    fn cost(&self) -> f64 {
        self.e.iter().zip(&self.q).map(|(e, q)| (e.conj() * q).re).sum()
    }

    fn add_levels(&self, weight: f64, sums: &mut Sums) {
        let m = self.m;
        for (sum, phi) in sums.information.iter_mut().zip(&self.phi) {
            *sum += weight * phi.norm_sqr();
        }
        for s in 0..m {
            sums.score[s] += weight * (self.q[s].norm_sqr() - self.phi[s * m + s].re);
        }
        if self.diagonal && self.gain > 0.0 {
            let length: f64 = self.g.iter().map(Complex::norm_sqr).sum();
            let determinant: f64 = self.precision[..m].iter().map(|p| p.re).product();
            sums.log_determinant += weight * (self.gain / (length * determinant)).ln();
        }
    }

    fn estimated_scalars(&mut self, record: &RecordSpectrum, seen: &Seen, k: usize) {
        let n = self.n;
        for (state, &b) in self.state.iter_mut().zip(&seen.b) {
            *state += self.u * b;
        }
        self.resolvent.solve(&mut self.state);
        let mut u = self.u;
        for (state, &gain) in self.state.iter().zip(&seen.gain) {
            u += state * gain;
        }
        self.scalars[..n].copy_from_slice(&self.state);
        self.scalars[n] = u;
        let factors = record.entries.len();
        self.scalars[n + 1..].copy_from_slice(&record.factors[k * factors..(k + 1) * factors]);
    }

    fn noise_scalars(&mut self, seen: &Seen) {
        let n = self.n;
        let size = if self.gain > 0.0 { 1.0 / self.gain.sqrt() } else { 0.0 };
        for (state, &b) in self.state.iter_mut().zip(&seen.b) {
            *state = Complex::new(b * size, 0.0);
        }
        self.resolvent.solve(&mut self.state);
        let mut u = Complex::new(size, 0.0);
        for (state, &gain) in self.state.iter().zip(&seen.gain) {
            u += state * gain;
        }
        self.scalars[..n].copy_from_slice(&self.state);
        self.scalars[n] = u;
        self.scalars[n + 1..].fill(ZERO);
    }

    fn add_states(&self, weight: f64, sums: &mut Sums) {
        let states = &self.scalars[..self.n];
        for (row, first) in sums.states.chunks_exact_mut(self.n).zip(states) {
            for (sum, second) in row.iter_mut().zip(states) {
                *sum += weight * (first.re * second.re + first.im * second.im);
            }
        }
    }

    fn add_descent(&self, weight: f64, sums: &mut Sums) {
        let (n, m) = (self.n, self.m);
        let rows = n + m;
        for i in 0..rows {
            // (D^H Phi e)_i
            let slope: Complex<f64> = if i < n {
                (0..m).map(|s| self.h[s * n + i].conj() * self.q[s]).sum()
            } else {
                self.q[i - n]
            };
            let slope = slope * weight;
            for (a, scalar) in self.scalars.iter().enumerate() {
                sums.descent[a * rows + i] += scalar.re * slope.re + scalar.im * slope.im;
            }
        }
    }

    fn fill(&self, weight: f64, tile: &mut Tile) {
        let (n, m) = (self.n, self.m);
        let rows = n + m;
        let z_rows = rows * (rows + 1) / 2;
        let start = tile.filled * z_rows;
        let [real, imaginary] = &mut tile.z;
        let (real, imaginary) =
            (&mut real[start..start + z_rows], &mut imaginary[start..start + z_rows]);
        let mut index = 0;
        for k in 0..rows {
            for i in 0..=k {
                let entry: Complex<f64> = if k < n {
                    (0..m).map(|s| self.h[s * n + i].conj() * self.phi_h[s * n + k]).sum()
                } else if i < n {
                    self.phi_h[(k - n) * n + i].conj()
                } else {
                    self.phi[(i - n) * m + k - n]
                };
                real[index] = weight * entry.re;
                imaginary[index] = weight * entry.im;
                index += 1;
            }
        }
        let count = self.scalars.len();
        let w_rows = count * (count + 1) / 2;
        let start = tile.filled * w_rows;
        let [real, imaginary] = &mut tile.w;
        let (real, imaginary) =
            (&mut real[start..start + w_rows], &mut imaginary[start..start + w_rows]);
        let mut index = 0;
        for (c, second) in self.scalars.iter().enumerate() {
            for first in &self.scalars[..=c] {
                let product = first.conj() * second;
                real[index] = product.re;
                imaginary[index] = product.im;
                index += 1;
            }
        }
        tile.filled += 1;
    }
}

#[cfg(test)]
mod tests;
