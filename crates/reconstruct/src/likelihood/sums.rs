//! The sums over frequencies behind cost, gradient and Gram matrix of one record: the inner loop of the fit.
//!
//! At one frequency, H = C (zI - A)^-1, g = H b + d, Phi = S^-1 - S^-1 g g^H S^-1 / (g^H S^-1 g), S the noise covariance, and e what the sensors
//! read less what known signals explain. The excitation's estimate is U = g^H S^-1 e / (g^H S^-1 g), the state's X = (zI - A)^-1 (b U + f tau), and
//! the cost is e^H Phi e. Every parameter moves the sensors by a column of D = [H, I] times one of the scalars s = (X, U, f): entry (i, l) of A by H_i X_l,
//! b_i by H_i U, entry (s, l) of C by I_s X_l. So the Gram matrix is the sum of Re (D^H Phi D)_ik conj(s_a) s_c, a Kronecker product at each
//! frequency, and the sum is a product of two matrices with one column per frequency.

use std::ops::Range;

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};
use nalgebra::{DMatrix, DVector};

use super::at_frequencies::AtFrequencies;
use super::lanes::{Lanes, Real, WIDTH};
use super::spectrum::RecordSpectrum;
use super::tables::Tables;
use super::threads::in_order;

/// Frequencies summed by one matrix product.
const TILE: usize = 8 * WIDTH;

/// Frequencies that one thread sums at a time. A record is cut there whatever the number of threads, so that its sums do not depend on that.
const SHARE: usize = 512 * TILE;

/// What one record sees of the system: A and C with a feedback (see `feedback.rs`).
#[derive(Debug)]
pub(super) struct Seen {
    pub(super) a: DMatrix<f64>,
    pub(super) c: DMatrix<f64>,
    pub(super) b: DVector<f64>,
    pub(super) d: DVector<f64>,
    /// The feedback's gain.
    pub(super) gain: DVector<f64>,
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
    /// Of nothing.
    fn zero(n: usize, m: usize, count: usize, keep_spectrum: bool) -> Self {
        let rows = n + m;
        let (z_rows, w_rows) = (rows * (rows + 1) / 2, count * (count + 1) / 2);
        Self {
            rows,
            real: Mat::zeros(z_rows, w_rows),
            imaginary: Mat::zeros(z_rows, w_rows),
            descent: vec![0.0; rows * count],
            cost: 0.0,
            log_determinant: 0.0,
            information: vec![0.0; m * m],
            score: vec![0.0; m],
            states: vec![0.0; n * n],
            spectrum: keep_spectrum.then(Vec::new),
        }
    }

    /// Those of the frequencies that follow.
    fn add(&mut self, other: Self) {
        let add = |to: &mut [f64], from: &[f64]| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to += from)
        };
        self.real += &other.real;
        self.imaginary += &other.imaginary;
        add(&mut self.descent, &other.descent);
        self.cost += other.cost;
        self.log_determinant += other.log_determinant;
        add(&mut self.information, &other.information);
        add(&mut self.score, &other.score);
        add(&mut self.states, &other.states);
        if let (Some(spectrum), Some(more)) = (&mut self.spectrum, other.spectrum) {
            spectrum.extend(more);
        }
    }

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

    /// The Gram matrix of these cells.
    pub(super) fn gram_of(&self, cells: &[(usize, usize)]) -> DMatrix<f64> {
        let mut gram = DMatrix::zeros(cells.len(), cells.len());
        for (k, &second) in cells.iter().enumerate() {
            for (i, &first) in cells.iter().enumerate().take(k + 1) {
                let entry = self.gram(first, second);
                gram[(i, k)] = entry;
                gram[(k, i)] = entry;
            }
        }
        gram
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

/// Adds up one record.
pub(super) fn sums(
    record: &RecordSpectrum,
    seen: &Seen,
    scalars: Scalars,
    keep_spectrum: bool,
    threads: usize,
) -> Sums {
    let (n, m) = (seen.b.len(), seen.d.len());
    let count = n + 1 + record.entries.len();
    let mut all = Sums::zero(n, m, count, keep_spectrum);
    let Some(tables) = Tables::new(record, seen) else {
        // Without a Schur form there is no cost: NaN is never below anything.
        all.cost = f64::NAN;
        return all;
    };
    let frequencies = record.frequencies();
    let shares: Vec<Range<usize>> = (0..frequencies)
        .step_by(SHARE)
        .map(|first| first..frequencies.min(first + SHARE))
        .collect();
    let parts = in_order(&shares, threads, |share| {
        let mut sums = Sums::zero(n, m, count, keep_spectrum);
        let mut totals = Totals::new(n, m, count);
        pulp::Arch::new().dispatch(Loop {
            record,
            frequencies: share.clone(),
            tables: &tables,
            scalars,
            totals: &mut totals,
            sums: &mut sums,
        });
        totals.give(&mut sums);
        sums
    });
    let mut parts = parts.into_iter();
    let Some(mut first) = parts.next() else { return all };
    parts.for_each(|part| first.add(part));
    first
}

/// The loop over frequencies, compiled once for each kind of vectors.
struct Loop<'a> {
    record: &'a RecordSpectrum,
    /// From a multiple of [`WIDTH`] on.
    frequencies: Range<usize>,
    tables: &'a Tables,
    scalars: Scalars,
    totals: &'a mut Totals,
    sums: &'a mut Sums,
}

impl pulp::WithSimd for Loop<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _simd: S) {
        add_up(self);
    }
}

#[inline(always)]
fn add_up(parts: Loop<'_>) {
    let Loop { record, frequencies, tables, scalars, totals, sums } = parts;
    let mut tile = Tile::new(sums.real.nrows(), sums.real.ncols());
    let mut at = AtFrequencies::new(tables);
    for first in frequencies.clone().step_by(WIDTH) {
        at.load(record, tables, first);
        at.evaluate(record, tables);
        let cost = at.weight * at.cost();
        totals.cost += cost;
        if let Some(spectrum) = &mut sums.spectrum {
            spectrum.extend(&cost.0[..WIDTH.min(frequencies.end - first)]);
        }
        at.add_levels(totals);
        match scalars {
            Scalars::Estimated => at.estimated_scalars(tables),
            Scalars::NoisePart => at.noise_scalars(tables),
        }
        at.add_moments(totals);
        at.fill(&mut tile);
        if tile.filled == TILE {
            tile.flush(sums);
        }
    }
    tile.flush(sums);
}

/// Sums that are not matrix products, lane by lane.
pub(super) struct Totals {
    pub(super) cost: Real,
    pub(super) log_determinant: f64,
    pub(super) descent: Vec<Real>,
    pub(super) information: Vec<Real>,
    pub(super) score: Vec<Real>,
    pub(super) states: Vec<Real>,
}

impl Totals {
    fn new(n: usize, m: usize, count: usize) -> Self {
        Self {
            cost: Real::ZERO,
            log_determinant: 0.0,
            descent: vec![Real::ZERO; (n + m) * count],
            information: vec![Real::ZERO; m * m],
            score: vec![Real::ZERO; m],
            states: vec![Real::ZERO; n * n],
        }
    }

    fn give(self, sums: &mut Sums) {
        let add = |lanes: Vec<Real>| lanes.into_iter().map(Real::sum).collect();
        sums.cost = self.cost.sum();
        sums.log_determinant = self.log_determinant;
        sums.descent = add(self.descent);
        sums.information = add(self.information);
        sums.score = add(self.score);
        sums.states = add(self.states);
    }
}

/// The factors of the matrix product: a row per frequency.
pub(super) struct Tile {
    pub(super) z_rows: usize,
    pub(super) w_rows: usize,
    /// Weighted D^H Phi D, packed: real and imaginary parts.
    pub(super) z: [Vec<f64>; 2],
    /// conj(s_a) s_c, packed.
    pub(super) w: [Vec<f64>; 2],
    pub(super) filled: usize,
}

impl Tile {
    fn new(z_rows: usize, w_rows: usize) -> Self {
        Self {
            z_rows,
            w_rows,
            z: [vec![0.0; z_rows * TILE], vec![0.0; z_rows * TILE]],
            w: [vec![0.0; w_rows * TILE], vec![0.0; w_rows * TILE]],
            filled: 0,
        }
    }

    fn flush(&mut self, sums: &mut Sums) {
        let targets = [&mut sums.real, &mut sums.imaginary];
        for ((target, z), w) in targets.into_iter().zip(&self.z).zip(&self.w) {
            let left = MatRef::from_column_major_slice(z, TILE, self.z_rows);
            let right = MatRef::from_column_major_slice(w, TILE, self.w_rows);
            let (left, right) = (left.get(..self.filled, ..), right.get(..self.filled, ..));
            matmul(target.as_mut(), Accum::Add, left.transpose(), right, 1.0, Par::Seq);
        }
        self.filled = 0;
    }

    #[inline(always)]
    pub(super) fn put(parts: &mut [Vec<f64>; 2], row: usize, at: usize, value: Lanes) {
        let [real, imaginary] = parts;
        let start = row * TILE + at;
        real[start..start + WIDTH].copy_from_slice(&value.re.0);
        imaginary[start..start + WIDTH].copy_from_slice(&value.im.0);
    }
}

#[cfg(test)]
mod tests;
