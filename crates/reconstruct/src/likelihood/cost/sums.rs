//! The sums over frequencies of one record: cost, gradient and Gram matrix, and how they are gathered in tiles and lanes.
//! The symbols are those of `accumulate.rs`.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};
use nalgebra::DMatrix;

use super::missing::Absorbed;
use super::simd::{Lanes, Real, WIDTH};

/// Frequencies summed by one matrix product.
pub(crate) const TILE: usize = 8 * WIDTH;

/// The sums.
#[derive(Clone, Debug)]
pub(crate) struct Sums {
    rows: usize,
    /// Re (D^H Phi D)_ik times Re conj(s_a) s_c for i <= k and a <= c.
    pub(crate) real: Mat<f64>,
    /// The same of the imaginary parts.
    pub(crate) imaginary: Mat<f64>,
    /// Re conj(s_a) (D^H Phi e)_i: the steepest descent of half the cost, `rows` entries for each scalar.
    pub(crate) descent: Vec<f64>,
    pub(crate) cost: f64,
    /// The sum of weight times ln det S + ln (g^H S^-1 g / g^H g), for white noise.
    pub(crate) log_determinant: f64,
    /// The sum of weight times |Phi_il|^2, m x m; with a model error a row and a column more, where P_l multiplies it.
    pub(crate) information: Vec<f64>,
    /// The sum of weight times |(Phi e)_i|^2 - Phi_ii; with a model error also the sum of P_i times that.
    pub(crate) score: Vec<f64>,
    /// The sum of weight times Re conj(X_a) X_c, n x n: how far the states move.
    pub(crate) states: Vec<f64>,
    /// Cost at each frequency, where asked for.
    pub(crate) spectrum: Option<Vec<f64>>,
    /// What missing samples take of the Gram matrix.
    pub(crate) absorbed: Option<Absorbed>,
}

impl Sums {
    /// Of nothing.
    pub(crate) fn zero(
        n: usize,
        m: usize,
        levels: usize,
        count: usize,
        keep_spectrum: bool,
    ) -> Self {
        let rows = n + m;
        let (z_rows, w_rows) = (rows * (rows + 1) / 2, count * (count + 1) / 2);
        Self {
            rows,
            real: Mat::zeros(z_rows, w_rows),
            imaginary: Mat::zeros(z_rows, w_rows),
            descent: vec![0.0; rows * count],
            cost: 0.0,
            log_determinant: 0.0,
            information: vec![0.0; levels * levels],
            score: vec![0.0; levels],
            states: vec![0.0; n * n],
            spectrum: keep_spectrum.then(Vec::new),
            absorbed: None,
        }
    }

    /// Those of the frequencies that follow.
    pub(crate) fn add(&mut self, other: Self) {
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
    pub(crate) fn gram(&self, first: (usize, usize), second: (usize, usize)) -> f64 {
        let ((i, a), (k, c)) = (first, second);
        let row = packed(i, k);
        let column = packed(a, c);
        // Both orders reversed conjugate both factors; one reversed, one of them.
        let sign = if (i <= k) == (a <= c) { -1.0 } else { 1.0 };
        let imaginary = if i == k || a == c { 0.0 } else { self.imaginary[(row, column)] };
        let entry = self.real[(row, column)] + sign * imaginary;
        match &self.absorbed {
            None => entry,
            Some(absorbed) => entry - absorbed.of(a * self.rows + i, c * self.rows + k),
        }
    }

    /// The Gram matrix of these cells.
    pub(crate) fn gram_of(&self, cells: &[(usize, usize)]) -> DMatrix<f64> {
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

    pub(crate) fn descent(&self, cell: (usize, usize)) -> f64 {
        self.descent[cell.1 * self.rows + cell.0]
    }
}

/// Index of (i, k) among pairs with i <= k, column by column.
fn packed(i: usize, k: usize) -> usize {
    let (low, high) = if i <= k { (i, k) } else { (k, i) };
    high * (high + 1) / 2 + low
}

/// Sums that are not matrix products, lane by lane.
pub(crate) struct Totals {
    pub(crate) cost: Real,
    pub(crate) log_determinant: f64,
    pub(crate) descent: Vec<Real>,
    pub(crate) information: Vec<Real>,
    pub(crate) score: Vec<Real>,
    pub(crate) states: Vec<Real>,
}

impl Totals {
    pub(crate) fn new(n: usize, m: usize, levels: usize, count: usize) -> Self {
        Self {
            cost: Real::ZERO,
            log_determinant: 0.0,
            descent: vec![Real::ZERO; (n + m) * count],
            information: vec![Real::ZERO; levels * levels],
            score: vec![Real::ZERO; levels],
            states: vec![Real::ZERO; n * n],
        }
    }

    pub(crate) fn give(self, sums: &mut Sums) {
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
pub(crate) struct Tile {
    pub(crate) z_rows: usize,
    pub(crate) w_rows: usize,
    /// Weighted D^H Phi D, packed: real and imaginary parts.
    pub(crate) z: [Vec<f64>; 2],
    /// conj(s_a) s_c, packed.
    pub(crate) w: [Vec<f64>; 2],
    pub(crate) filled: usize,
}

impl Tile {
    pub(crate) fn new(z_rows: usize, w_rows: usize) -> Self {
        Self {
            z_rows,
            w_rows,
            z: [vec![0.0; z_rows * TILE], vec![0.0; z_rows * TILE]],
            w: [vec![0.0; w_rows * TILE], vec![0.0; w_rows * TILE]],
            filled: 0,
        }
    }

    pub(crate) fn flush(&mut self, sums: &mut Sums) {
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
    pub(crate) fn put(parts: &mut [Vec<f64>; 2], row: usize, at: usize, value: Lanes) {
        let [real, imaginary] = parts;
        let start = row * TILE + at;
        real[start..start + WIDTH].copy_from_slice(&value.re.0);
        imaginary[start..start + WIDTH].copy_from_slice(&value.im.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packed_pairs_count_up() {
        let pairs = (0..5).flat_map(|k| (0..=k).map(move |i| (i, k)));
        for (index, (i, k)) in pairs.enumerate() {
            assert_eq!((packed(i, k), packed(k, i)), (index, index));
        }
    }
}
