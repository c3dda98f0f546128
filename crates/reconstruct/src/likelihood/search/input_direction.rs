//! The direction of each record's excitation with A and C held, from the spectra: a small eigenvalue problem, no starting point.
//!
//! Whitened, a record reads Y = (H b + d) U + z H t + V. Where the noise V vanishes, Y - z H t is parallel to g = H b + d, so that every 2 x 2 minor of the two
//! does: (Y_i - z H_i t) g_l - (Y_l - z H_l t) g_i = 0. The minor of H t and H b depends on t and b through t_p b_q - t_q b_p alone: linear in the unknowns
//! (b, d) and these products, which are taken as free. The sum of squared minors over |g|^2 is the likelihood's own residual, and noise adds
//! (m - 1) [H I]^H [H I] to its matrix on average; so (b, d) is the smallest eigenvector of the sum relative to that noise part. |g|^2 is unknown at first and is
//! taken from the previous solution (iterative quadratic maximum likelihood, Bresler & Macovski 1986, with the bias of the noise taken out).

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use crate::likelihood::cost::parameters::{Layout, System};
use crate::likelihood::cost::resolvent::Resolvent;
use crate::likelihood::cost::spectrum::{Entry, RecordSpectrum};

/// How often |g|^2 is taken from the previous solution. The direction settles to its final uncertainty after two or three.
const REWEIGHTINGS: usize = 3;
/// Frequencies whose z lies so close to an eigenvalue of A, relative to A, are left out: minors lose all digits there.
const CLOSEST_POLE: f64 = 1e-7;
/// The most frequencies that are looked at, evenly spread: what comes out is a start, which millions of frequencies do not make better.
const MOST_FREQUENCIES: usize = 16_384;
/// Squares of singular values below this part of the largest one are rounding errors.
const RANK_TOLERANCE: f64 = 1e-12;

/// Estimates (b, d) of one record; the sensors without feedthrough get d = 0. `None` where the record determines nothing.
pub(crate) fn input_direction(
    spectrum: &RecordSpectrum,
    system: &System,
    layout: &Layout,
    variances: &[f64],
) -> Option<(DVector<f64>, DVector<f64>)> {
    let n = layout.order;
    let minors = Minors::new(spectrum, layout);
    let mut weights: Option<DVector<f64>> = None;
    for _ in 0..REWEIGHTINGS {
        let (data, noise) = minors.sums(spectrum, system, variances, weights.as_ref());
        weights = Some(smallest(&data, &noise, minors.unknown)?);
    }
    let solution = weights?;
    let b = solution.rows(0, n).into_owned();
    let mut d = DVector::zeros(layout.sensors);
    for (k, &sensor) in layout.feedthrough.iter().enumerate() {
        d[sensor] = solution[n + k];
    }
    Some((b, d))
}

/// Which products are unknown.
struct Minors {
    n: usize,
    m: usize,
    /// Columns of [H, I]: index below n a state, n + s sensor s.
    columns: Vec<usize>,
    /// Length of (b, d).
    unknown: usize,
    /// For each signal, the pairs of columns whose minors it needs.
    products: Vec<(usize, usize, usize)>,
}

impl Minors {
    fn new(spectrum: &RecordSpectrum, layout: &Layout) -> Self {
        let (n, m) = (layout.order, layout.sensors);
        let through: Vec<usize> = (0..n).chain(layout.feedthrough.iter().map(|&s| n + s)).collect();
        let mut products = Vec::new();
        for (signal, entry) in spectrum.entries.iter().enumerate() {
            let enters: Vec<usize> = match entry {
                Entry::State => (0..n).collect(),
                Entry::StateAndFeedthrough => through.clone(),
                Entry::Sensors => (n..n + m).collect(),
            };
            // t_p b_q - t_q b_p for each pair of columns of which one can be in t and the other in (b, d).
            for p in 0..n + m {
                for q in p + 1..n + m {
                    let one = enters.contains(&p) && through.contains(&q);
                    let other = enters.contains(&q) && through.contains(&p);
                    if one || other {
                        products.push((signal, p, q));
                    }
                }
            }
        }
        Self { n, m, unknown: through.len(), columns: through, products }
    }

    /// The matrix of squared minors over |g|^2 and what noise adds to it.
    fn sums(
        &self,
        spectrum: &RecordSpectrum,
        system: &System,
        variances: &[f64],
        previous: Option<&DVector<f64>>,
    ) -> (DMatrix<f64>, DMatrix<f64>) {
        let (n, m) = (self.n, self.m);
        let size = self.unknown + self.products.len();
        let mut data = Squares::new(size);
        let mut noise = Squares::new(self.unknown);
        let a = system.a.transpose().as_slice().to_vec();
        let mut resolvent = Resolvent::new(n);
        let mut full = DMatrix::<Complex<f64>>::zeros(m, n + m);
        let mut row = vec![Complex::new(0.0, 0.0); n];
        let mut minor = vec![Complex::new(0.0, 0.0); size];
        let stride = spectrum.frequencies().div_ceil(MOST_FREQUENCIES).max(1);
        for k in (0..spectrum.frequencies()).step_by(stride) {
            resolvent.factor(spectrum.z[k], &a);
            if resolvent.smallest_pivot() < CLOSEST_POLE {
                continue;
            }
            let whitening = Whitening::at(spectrum, variances, k);
            full.fill(Complex::new(0.0, 0.0));
            for s in 0..m {
                for (l, entry) in row.iter_mut().enumerate() {
                    *entry = Complex::new(system.c[(s, l)], 0.0);
                }
                resolvent.solve_row(&mut row);
                for (l, entry) in row.iter().enumerate() {
                    full[(s, l)] = *entry;
                }
                full[(s, n + s)] = Complex::new(1.0, 0.0);
            }
            let mut y: Vec<Complex<f64>> = spectrum.y[k * m..(k + 1) * m].to_vec();
            whitening.apply(&mut full, &mut y);
            let weight = spectrum.weight[k] / self.length(&full, previous);
            let factors = &spectrum.factors[k * spectrum.entries.len()..];
            let scale = weight.sqrt();
            for i in 0..m {
                for l in i + 1..m {
                    for (target, &column) in minor.iter_mut().zip(&self.columns) {
                        *target = (y[i] * full[(l, column)] - y[l] * full[(i, column)]) * scale;
                    }
                    for (target, &(signal, p, q)) in
                        minor[self.unknown..].iter_mut().zip(&self.products)
                    {
                        let minor = full[(i, p)] * full[(l, q)] - full[(l, p)] * full[(i, q)];
                        *target = -factors[signal] * minor * scale;
                    }
                    data.add(&minor);
                }
            }
            let scale = scale * ((m - 1) as f64).sqrt();
            for s in 0..m {
                for (target, &column) in minor.iter_mut().zip(&self.columns) {
                    *target = full[(s, column)] * scale;
                }
                noise.add(&minor[..self.unknown]);
            }
        }
        (data.finish(), noise.finish())
    }

    /// |g|^2 of the previous solution, or, before there is one, of all directions together.
    fn length(&self, full: &DMatrix<Complex<f64>>, previous: Option<&DVector<f64>>) -> f64 {
        let length: f64 = (0..self.m)
            .map(|s| match previous {
                Some(previous) => self
                    .columns
                    .iter()
                    .zip(previous.iter())
                    .map(|(&column, &b)| full[(s, column)] * b)
                    .sum::<Complex<f64>>()
                    .norm_sqr(),
                None => {
                    self.columns.iter().map(|&column| full[(s, column)].norm_sqr()).sum::<f64>()
                }
            })
            .sum();
        length.max(f64::MIN_POSITIVE)
    }
}

/// The sum of Re r^H r over rows r, gathered in blocks for matrix products.
struct Squares {
    size: usize,
    /// Real and imaginary parts of rows, one real row after the other.
    block: Vec<f64>,
    sum: Mat<f64>,
}

impl Squares {
    /// Real rows in a block.
    const ROWS: usize = 512;

    fn new(size: usize) -> Self {
        Self { size, block: Vec::with_capacity(size * Self::ROWS), sum: Mat::zeros(size, size) }
    }

    fn add(&mut self, row: &[Complex<f64>]) {
        self.block.extend(row.iter().map(|entry| entry.re));
        self.block.extend(row.iter().map(|entry| entry.im));
        if self.block.len() >= self.size * Self::ROWS {
            self.flush();
        }
    }

    fn flush(&mut self) {
        let rows = self.block.len() / self.size.max(1);
        let block = MatRef::from_column_major_slice(&self.block, self.size, rows);
        matmul(self.sum.as_mut(), Accum::Add, block, block.transpose(), 1.0, Par::Seq);
        self.block.clear();
    }

    fn finish(mut self) -> DMatrix<f64> {
        self.flush();
        DMatrix::from_fn(self.size, self.size, |i, k| self.sum[(i.min(k), i.max(k))])
    }
}

/// The smallest eigenvector of the data's matrix, products eliminated, relative to the noise's.
fn smallest(data: &DMatrix<f64>, noise: &DMatrix<f64>, unknown: usize) -> Option<DVector<f64>> {
    let products = data.nrows() - unknown;
    let mut reduced = data.view((0, 0), (unknown, unknown)).into_owned();
    if products > 0 {
        let mixed = data.view((unknown, 0), (products, unknown)).into_owned();
        let own = data.view((unknown, unknown), (products, products)).into_owned();
        let scale = own.diagonal().map(|d| if d > 0.0 { 1.0 / d.sqrt() } else { 0.0 });
        let unit = DMatrix::from_fn(products, products, |i, k| own[(i, k)] * scale[i] * scale[k]);
        let mixed = DMatrix::from_fn(products, unknown, |i, k| mixed[(i, k)] * scale[i]);
        let eigen = unit.symmetric_eigen();
        let largest = eigen.eigenvalues.max();
        for (k, &value) in eigen.eigenvalues.iter().enumerate() {
            if value > RANK_TOLERANCE * largest {
                let part = mixed.transpose() * eigen.eigenvectors.column(k);
                reduced -= &part * part.transpose() / value;
            }
        }
    }
    let factor = noise.clone().cholesky()?.l();
    let half = factor.solve_lower_triangular(&reduced)?;
    let whitened = factor.solve_lower_triangular(&half.transpose())?;
    let eigen = (0.5 * (&whitened + whitened.transpose())).symmetric_eigen();
    let vector = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
    let solution = factor.transpose().solve_upper_triangular(&vector)?;
    let length = solution.norm();
    (length > 0.0 && length.is_finite()).then(|| solution / length)
}

/// A matrix W with W^H W the inverse noise covariance.
enum Whitening {
    Diagonal(Vec<f64>),
    Full(DMatrix<Complex<f64>>),
}

impl Whitening {
    fn at(spectrum: &RecordSpectrum, variances: &[f64], k: usize) -> Self {
        let m = spectrum.offset_variance.len();
        if let Some(precision) = &spectrum.precision {
            let matrix = DMatrix::from_row_slice(m, m, &precision[k * m * m..(k + 1) * m * m]);
            if let Some(factor) = matrix.cholesky() {
                return Self::Full(factor.l().adjoint());
            }
        }
        Self::Diagonal((0..m).map(|s| 1.0 / spectrum.variance(k, s, variances).sqrt()).collect())
    }

    fn apply(&self, full: &mut DMatrix<Complex<f64>>, y: &mut [Complex<f64>]) {
        match self {
            Self::Diagonal(diagonal) => {
                for (s, &scale) in diagonal.iter().enumerate() {
                    y[s] *= scale;
                    for entry in full.row_mut(s).iter_mut() {
                        *entry *= scale;
                    }
                }
            }
            Self::Full(matrix) => {
                *full = matrix * &*full;
                let product = matrix * DVector::from_column_slice(y);
                y.copy_from_slice(product.as_slice());
            }
        }
    }
}

#[cfg(test)]
mod tests;
