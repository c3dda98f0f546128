//! The result: a matrix of products in doubled precision.

use doubled::{DoubleDouble, power_of_two, times_power_of_two};
use nalgebra::{DMatrix, DVector};

use crate::{
    HankelError, Layout,
    sums::{Sums, times},
};

/// A Gram matrix `X' X`, or a cross product `L' R`, each entry an unevaluated sum of two doubles.
///
/// Inside, each channel is in a unit of a power of two of its own, so that no product overflows.
#[derive(Debug, Clone, PartialEq)]
pub struct Gram {
    /// Column-major, left x right.
    values: Vec<DoubleDouble>,
    /// Entry (i, j) is `values * 2^(left_exponents[i] + right_exponents[j])`.
    left_exponents: Vec<i32>,
    right_exponents: Vec<i32>,
    left_sums: Vec<DoubleDouble>,
    right_sums: Vec<DoubleDouble>,
    symmetric: bool,
    rows: usize,
    rounding: f64,
}

/// From this ratio of squares on a signal is mostly its mean.
const LARGE_MEAN: f64 = 100.0;

/// Roundings of a signal that is mostly its mean are alike and add up instead of cancelling. A constant of 0.1 over 5000 samples shows
/// 250 times what the estimate for varying signals says.
const ALIKE: f64 = 512.0;

impl Gram {
    pub(crate) fn new(layout: &Layout, sums: &Sums, rows: usize) -> Self {
        let plan = layout.plan();
        let (left, right) = (layout.columns(), layout.right_columns());
        let symmetric = layout.is_symmetric();
        let mut values = vec![DoubleDouble::ZERO; left.len() * right.len()];
        let mut variances = vec![0.0; values.len()];
        for (entry, value) in plan.entries.iter().zip(&sums.products) {
            let at = entry.row + entry.column * left.len();
            values[at] = *value;
            variances[at] = sums.variances[entry.pair];
            if symmetric {
                let mirrored = entry.column + entry.row * left.len();
                values[mirrored] = *value;
                variances[mirrored] = sums.variances[entry.pair];
            }
        }
        let exponents = |columns: &[crate::Column]| {
            columns.iter().map(|c| sums.exponents[c.channel]).collect::<Vec<_>>()
        };
        let (left_sums, right_sums) = if symmetric {
            (sums.plain.clone(), sums.plain.clone())
        } else {
            (sums.plain[..left.len()].to_vec(), sums.plain[left.len()..].to_vec())
        };
        let mut gram = Self {
            values,
            left_exponents: exponents(left),
            right_exponents: exponents(right),
            left_sums,
            right_sums,
            symmetric,
            rows,
            rounding: 0.0,
        };
        gram.rounding = gram.relative(&variances);
        gram
    }

    /// The largest standard deviation of an entry over the size of its two columns.
    fn relative(&self, variances: &[f64]) -> f64 {
        let (height, width) = self.shape();
        let worst = if self.symmetric {
            let norm = |i| self.at(i, i).value().max(0.0);
            let inverse = |square: f64| if square > 0.0 { square.recip() } else { 0.0 };
            let inverses: Vec<f64> = (0..height).map(|i| inverse(norm(i))).collect();
            let columns = variances.chunks_exact(height).zip(&inverses);
            columns
                .flat_map(|(column, own)| {
                    column.iter().zip(&inverses).map(move |(v, i)| v * i * own)
                })
                .fold(0.0, f64::max)
        } else {
            // In one unit for all entries.
            let exponent = |i: usize, j: usize| self.left_exponents[i] + self.right_exponents[j];
            let each = || (0..width).flat_map(|j| (0..height).map(move |i| (i, j)));
            let unit = each().map(|(i, j)| exponent(i, j)).max().unwrap_or(0);
            let factor = |i: usize, j: usize| power_of_two(exponent(i, j) - unit);
            let modulus = |(i, j)| self.at(i, j).value().abs() * factor(i, j);
            let largest = each().map(modulus).fold(0.0, f64::max);
            let variance = |(i, j)| variances[i + j * height] * factor(i, j).powi(2);
            let worst = each().map(variance).fold(0.0, f64::max);
            if largest > 0.0 { worst / (largest * largest) } else { 0.0 }
        };
        worst.sqrt().max(f64::EPSILON * f64::EPSILON)
    }

    /// Left and right columns.
    #[must_use]
    pub fn shape(&self) -> (usize, usize) {
        (self.left_exponents.len(), self.right_exponents.len())
    }

    /// Rows of the regressors that were summed.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Whether both sides are the same columns.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// How exact the entries are: the estimated standard deviation of the rounding, relative to the norms of the two columns (for a cross product, to
    /// the largest entry).
    ///
    /// Computed from what was summed: the number of products and the ratio of the largest sample to the root mean square. 1e-30 is
    /// typical. It is an estimate, not a bound: for a signal that is mostly its mean it may be some hundred times too small.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        self.rounding
    }

    pub(crate) fn at(&self, row: usize, column: usize) -> DoubleDouble {
        self.values[row + column * self.left_exponents.len()]
    }

    /// The unit of a left column: its samples are in units of two to this.
    pub(crate) fn exponent(&self, column: usize) -> i32 {
        self.left_exponents[column]
    }

    /// An entry in the units of the record; infinite if it is too large for a double, `None` outside the matrix.
    #[must_use]
    pub fn entry(&self, row: usize, column: usize) -> Option<DoubleDouble> {
        let (height, width) = self.shape();
        (row < height && column < width).then(|| {
            let exponent = self.left_exponents[row] + self.right_exponents[column];
            let value = self.at(row, column);
            let half = exponent / 2;
            times(times(value, power_of_two(half)), power_of_two(exponent - half))
        })
    }

    /// The matrix, rounded to doubles: left x right.
    ///
    /// # Errors
    ///
    /// [`HankelError::Overflow`] if an entry is too large for a double, which samples above 1e154 make it.
    pub fn matrix(&self) -> Result<DMatrix<f64>, HankelError> {
        let (height, width) = self.shape();
        let matrix = DMatrix::from_fn(height, width, |i, j| {
            times_power_of_two(
                self.at(i, j).value(),
                self.left_exponents[i] + self.right_exponents[j],
            )
        });
        if matrix.iter().all(|x| x.is_finite()) {
            Ok(matrix)
        } else {
            Err(HankelError::Overflow { what: "an entry of the Gram matrix" })
        }
    }

    /// Means of the left columns, in the units of the record.
    #[must_use]
    pub fn means(&self) -> DVector<f64> {
        let rows = self.rows as f64;
        let means = self.left_sums.iter().zip(&self.left_exponents);
        DVector::from_iterator(
            self.left_exponents.len(),
            means.map(|(sum, exponent)| times_power_of_two(sum.value() / rows, *exponent)),
        )
    }

    /// The same with the mean of each column subtracted from it: `G - s s' / rows` with the sums s of the columns.
    ///
    /// A constant offset of a channel has no influence on this but rounding: [`Gram::rounding`] of a symmetric matrix grows by what cancels. With several
    /// segments the mean is that of all of them.
    ///
    /// # Example
    ///
    /// ```
    /// use hankel::{Layout, Options, gram};
    ///
    /// let layout = Layout::block_hankel(1, 1)?;
    /// let gram = gram(&layout, &[&[1e9 + 1.0, 1e9 + 2.0, 1e9 + 3.0]], &Options::default())?;
    /// assert_eq!(gram.centred().matrix()?[(0, 0)], 2.0);
    /// # Ok::<(), hankel::HankelError>(())
    /// ```
    #[must_use]
    pub fn centred(&self) -> Self {
        let rows = DoubleDouble::from(self.rows as f64);
        let (height, width) = self.shape();
        let mut centred = self.clone();
        for j in 0..width {
            let mean = self.right_sums[j] / rows;
            for i in 0..height {
                centred.values[i + j * height] = self.at(i, j) - self.left_sums[i] * mean;
            }
        }
        for i in 0..if self.symmetric { height } else { 0 } {
            for j in 0..i {
                centred.values[i + j * height] = centred.values[j + i * height];
            }
        }
        centred.left_sums.fill(DoubleDouble::ZERO);
        centred.right_sums.fill(DoubleDouble::ZERO);
        // Each entry keeps its absolute error while the columns get shorter.
        let grown = (0..if self.symmetric { height } else { 0 }).map(|i| {
            let (before, after) = (self.at(i, i).value(), centred.at(i, i).value());
            if after > 0.0 { before / after } else { 1.0 }
        });
        let grown = grown.fold(1.0, f64::max);
        if grown > LARGE_MEAN {
            centred.rounding *= grown * ALIKE;
        } else {
            centred.rounding *= grown;
        }
        centred
    }

    /// The Gram matrix of some of the columns, in the order given.
    ///
    /// # Errors
    ///
    /// [`HankelError::NotSquare`], [`HankelError::BadSize`] for an index outside the matrix.
    pub fn select(&self, columns: &[usize]) -> Result<Self, HankelError> {
        self.square()?;
        let size = self.left_exponents.len();
        if let Some(index) = columns.iter().find(|index| **index >= size) {
            return Err(HankelError::BadSize {
                what: "the index of a column",
                found: *index,
                needed: format!("below {size}"),
            });
        }
        let exponents: Vec<i32> = columns.iter().map(|i| self.left_exponents[*i]).collect();
        let sums: Vec<DoubleDouble> = columns.iter().map(|i| self.left_sums[*i]).collect();
        Ok(Self {
            values: columns.iter().flat_map(|j| columns.iter().map(|i| self.at(*i, *j))).collect(),
            left_exponents: exponents.clone(),
            right_exponents: exponents,
            left_sums: sums.clone(),
            right_sums: sums,
            ..*self
        })
    }

    /// Only a symmetric matrix can be factorised.
    pub(crate) fn square(&self) -> Result<(), HankelError> {
        let (rows, columns) = self.shape();
        if self.symmetric { Ok(()) } else { Err(HankelError::NotSquare { rows, columns }) }
    }
}
