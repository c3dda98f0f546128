//! Theorem 3.1: two transmissibilities of the same two sensors, and the determinant whose roots contain the eigenvalues.

use lti::Transmissibility;
use num_complex::Complex;
use poly::{Poly, PolyMatrix, Rational, Ring};

use crate::ReconstructError;
use crate::error::check_tolerance;
use crate::model::matching::closest_pairs;

/// Two transmissibilities from the same pseudo input to the same pseudo output of one system, under two excitations.
///
/// Exact over integers and rationals. Over `f64`, [`theorem_rounded`](TransmissibilityPair::theorem_rounded) tells a determinant that
/// vanishes up to rounding from one that does not.
///
/// # Example
///
/// Two sensors read the states of x' = diag(-1, -2) x + b u. The first record has b = (1, 1), the second b = (1, -1).
///
/// ```
/// use lti::Transmissibility;
/// use poly::Poly;
/// use reconstruct::paper::{Statement, TransmissibilityPair};
///
/// let p = |descending: &[i64]| Poly::from_descending(descending);
/// let first = Transmissibility::from_polynomials(p(&[1, 1]), p(&[1, 2]))?; // (p + 1) / (p + 2)
/// let second = Transmissibility::from_polynomials(p(&[-1, -1]), p(&[1, 2]))?;
/// let pair = TransmissibilityPair::new(first, second);
/// let theorem = pair.theorem(2)?;
/// assert_eq!(theorem.determinant.display("p").to_string(), "-2p^2 - 6p - 4"); // -2 (p + 1) (p + 2)
/// assert_eq!(theorem.statement, Statement::DegreeAtLeastOrder { degree: 2, order: 2 });
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TransmissibilityPair<T: Ring> {
    first: Transmissibility<T>,
    second: Transmissibility<T>,
}

/// Which of the two statements of Theorem 3.1 holds. Exactly one does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Statement {
    /// i) det Delta is the zero polynomial: the two transmissibilities are equal, and say nothing about the eigenvalues.
    DeterminantIsZero,
    /// ii) The degree of det Delta is at least the order n, and all eigenvalues are among its roots.
    DegreeAtLeastOrder {
        /// Degree of det Delta.
        degree: usize,
        /// Order n of the system.
        order: usize,
    },
}

/// Theorem 3.1 applied to one pair.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Theorem<T: Ring> {
    /// The determinant; over `f64` without leading coefficients that are rounding errors.
    pub determinant: Poly<T>,
    /// Which statement holds.
    pub statement: Statement,
}

/// How well the spectrum of a system is contained in a multiset of roots.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Containment {
    /// For each eigenvalue, in the order given: its root, and the distance between the two.
    pub matched: Vec<(Complex<f64>, f64)>,
    /// The roots that no eigenvalue took: the invariant zeros of the system from the two excitations to the two sensors.
    pub extra: Vec<Complex<f64>>,
}

impl Containment {
    /// The largest distance of an eigenvalue from its root; infinite where roots are missing.
    #[must_use]
    pub fn largest_distance(&self) -> f64 {
        // A distance that is no number is no small one.
        let distances = self
            .matched
            .iter()
            .map(|(_, distance)| if distance.is_nan() { f64::INFINITY } else { *distance });
        distances.fold(0.0, f64::max)
    }
}

impl<T: Ring> TransmissibilityPair<T> {
    /// Pairs the transmissibility of the first record with that of the second.
    #[must_use]
    pub fn new(first: Transmissibility<T>, second: Transmissibility<T>) -> Self {
        Self { first, second }
    }

    /// The 2 x 2 matrix Delta(p) = [Gamma_i1, Gamma_i2; Gamma_o1, Gamma_o2]: one column per excitation. paper eq. (16)
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "four entries always make a 2 x 2 matrix")]
    pub fn delta(&self) -> PolyMatrix<T> {
        let columns = [&self.first, &self.second];
        let entries = columns
            .map(Transmissibility::denominator)
            .into_iter()
            .chain(columns.map(Transmissibility::numerator));
        PolyMatrix::new(2, 2, entries.cloned().collect()).expect("four entries make a 2 x 2 matrix")
    }

    /// det Delta(p) = Gamma_i1 Gamma_o2 - Gamma_o1 Gamma_i2. paper eq. (17)
    #[must_use]
    pub fn determinant(&self) -> Poly<T> {
        let ([i1, i2], [o1, o2]) = self.numerators();
        i1 * o2 - o1 * i2
    }

    /// The difference T_1 - T_2 over the product of the denominators, nothing cancelled. Its numerator is -det Delta.
    ///
    /// # Errors
    ///
    /// [`ReconstructError::Step`] where the product of the denominators vanishes, as coefficients below 1e-160 can make it over `f64`.
    pub fn difference(&self) -> Result<Rational<T>, ReconstructError> {
        let ([i1, i2], _) = self.numerators();
        Rational::new(-self.determinant(), i1 * i2).map_err(|error| ReconstructError::Step {
            step: "difference of two transmissibilities",
            message: error.to_string(),
        })
    }

    /// Decides which statement of Theorem 3.1 holds for a system of order n, by exact comparison with zero.
    ///
    /// # Errors
    ///
    /// [`ReconstructError::NotOneSystem`] where neither holds: then the transmissibilities do not belong to one system of that order.
    pub fn theorem(&self, order: usize) -> Result<Theorem<T>, ReconstructError> {
        decide(self.determinant(), order)
    }

    fn numerators(&self) -> ([&Poly<T>; 2], [&Poly<T>; 2]) {
        (
            [self.first.denominator(), self.second.denominator()],
            [self.first.numerator(), self.second.numerator()],
        )
    }
}

impl TransmissibilityPair<f64> {
    /// Decides which statement of Theorem 3.1 holds for a system of order n, where coefficients carry rounding errors.
    ///
    /// A leading coefficient of the determinant counts as zero where it is below `tolerance` times what the same coefficient would be if
    /// nothing cancelled, that is the coefficient of |Gamma_i1| |Gamma_o2| + |Gamma_o1| |Gamma_i2|. With coefficients known to
    /// rounding level, 1e-14 leaves room for the few operations that made them.
    ///
    /// # Errors
    ///
    /// [`ReconstructError::NotOneSystem`] as [`theorem`](TransmissibilityPair::theorem), and [`ReconstructError::InvalidTolerance`].
    pub fn theorem_rounded(
        &self,
        order: usize,
        tolerance: f64,
    ) -> Result<Theorem<f64>, ReconstructError> {
        check_tolerance("the tolerance of vanishing coefficients", tolerance)?;
        let magnitude = |p: &Poly<f64>| p.map(|c| c.abs());
        let ([i1, i2], [o1, o2]) = self.numerators();
        let scale = magnitude(i1) * magnitude(o2) + magnitude(o1) * magnitude(i2);
        let determinant = self.determinant();
        let kept = (0..determinant.coefficients().len())
            .rev()
            .find(|&k| determinant.coefficient(k).abs() > tolerance * scale.coefficient(k))
            .map_or(0, |k| k + 1);
        decide(Poly::new(determinant.coefficients()[..kept].to_vec()), order)
    }
}

fn decide<T: Ring>(determinant: Poly<T>, order: usize) -> Result<Theorem<T>, ReconstructError> {
    let statement = match determinant.degree() {
        None => Statement::DeterminantIsZero,
        Some(degree) if degree >= order => Statement::DegreeAtLeastOrder { degree, order },
        Some(degree) => return Err(ReconstructError::NotOneSystem { degree, order }),
    };
    Ok(Theorem { determinant, statement })
}

/// Holds the spectrum of a system against the roots of det Delta: mspec(A) is contained in mroots(det Delta). paper eq. (18)
///
/// Each root serves one eigenvalue only, so multiplicities count. The assignment takes the closest pairs first.
#[must_use]
pub fn containment(spectrum: &[Complex<f64>], roots: &[Complex<f64>]) -> Containment {
    let pairs = closest_pairs(spectrum, roots);
    let matched = (0..spectrum.len())
        .map(|index| {
            let partner = pairs.iter().find(|pair| pair.left == index);
            partner.map_or((Complex::new(f64::NAN, f64::NAN), f64::INFINITY), |pair| {
                (roots[pair.right], pair.distance)
            })
        })
        .collect();
    let extra = (0..roots.len())
        .filter(|index| pairs.iter().all(|pair| pair.right != *index))
        .map(|index| roots[index]);
    Containment { matched, extra: extra.collect() }
}

#[cfg(test)]
mod tests;
