//! The sums over frequencies behind cost, gradient and Gram matrix of one record: the inner loop of the fit.
//!
//! At one frequency, H = C (zI - A)^-1, g = H b + d, Phi = S^-1 - S^-1 g g^H S^-1 / (g^H S^-1 g), S the noise covariance, and e what the sensors
//! read less what known signals explain. The excitation's estimate is U = g^H S^-1 e / (g^H S^-1 g), the state's X = (zI - A)^-1 (b U + f tau), and
//! the cost is e^H Phi e. Every parameter moves the sensors by a column of D = [H, I] times one of the scalars s = (X, U, f): entry (i, l) of A by H_i X_l,
//! b_i by H_i U, entry (s, l) of C by I_s X_l. So the Gram matrix is the sum of Re (D^H Phi D)_ik conj(s_a) s_c, a Kronecker product at each
//! frequency, and the sum is a product of two matrices with one column per frequency.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::lanes::{Lanes, Real, WIDTH};
use super::spectrum::{Entry, RecordSpectrum};

/// Frequencies summed by one matrix product.
const TILE: usize = 16 * WIDTH;

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

/// Adds up one record.
pub(super) fn sums(
    record: &RecordSpectrum,
    seen: &Seen,
    scalars: Scalars,
    keep_spectrum: bool,
) -> Sums {
    let (n, m) = (seen.b.len(), seen.d.len());
    let count = n + 1 + record.entries.len();
    let rows = n + m;
    let (z_rows, w_rows) = (rows * (rows + 1) / 2, count * (count + 1) / 2);
    let mut sums = Sums {
        rows,
        real: Mat::zeros(z_rows, w_rows),
        imaginary: Mat::zeros(z_rows, w_rows),
        descent: vec![0.0; rows * count],
        cost: f64::NAN,
        log_determinant: 0.0,
        information: vec![0.0; m * m],
        score: vec![0.0; m],
        states: vec![0.0; n * n],
        spectrum: keep_spectrum.then(|| Vec::with_capacity(record.frequencies())),
    };
    // Without a Schur form there is no cost: NaN is never below anything.
    if let Some(tables) = Tables::new(record, seen) {
        let mut totals = Totals::new(n, m, count);
        pulp::Arch::new().dispatch(Loop {
            record,
            tables: &tables,
            scalars,
            totals: &mut totals,
            sums: &mut sums,
        });
        totals.give(&mut sums);
    }
    sums
}

/// The loop over frequencies, compiled once for each kind of vectors.
struct Loop<'a> {
    record: &'a RecordSpectrum,
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
    let Loop { record, tables, scalars, totals, sums } = parts;
    let mut tile = Tile::new(sums.real.nrows(), sums.real.ncols());
    let mut at = AtFrequencies::new(tables);
    let frequencies = record.frequencies();
    let mut first = 0;
    while first < frequencies {
        at.load(record, tables, first);
        at.evaluate(record, tables);
        let cost = at.weight * at.cost();
        totals.cost += cost;
        if let Some(spectrum) = &mut sums.spectrum {
            spectrum.extend(&cost.0[..WIDTH.min(frequencies - first)]);
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
        first += WIDTH;
    }
    tile.flush(sums);
}

/// What does not change with frequency: A in Schur form, A = Q T Q^H, and everything in its basis.
struct Tables {
    n: usize,
    m: usize,
    factors: usize,
    /// T, row by row, and the size below which z - T_ii is a rounding error.
    t: Vec<Complex<f64>>,
    floor: f64,
    /// Q, row by row.
    q: Vec<Complex<f64>>,
    /// C Q, row by row.
    c: Vec<Complex<f64>>,
    b: Vec<f64>,
    /// Q^H b.
    b_schur: Vec<Complex<f64>>,
    d: Vec<f64>,
    gain: Vec<f64>,
    /// For each factor the part into the state, Q^H tau; `None` where there is none.
    into_state: Vec<Option<Vec<Complex<f64>>>>,
    /// For each factor the part into the sensors.
    into_sensors: Vec<Option<Vec<f64>>>,
    white: Vec<f64>,
    white_at_zero: Vec<f64>,
    /// Whether the noise covariance is diagonal.
    diagonal: bool,
}

impl Tables {
    fn new(record: &RecordSpectrum, seen: &Seen) -> Option<Self> {
        const ITERATIONS: usize = 10_000;
        let (n, m) = (seen.b.len(), seen.d.len());
        let complex = |matrix: &DMatrix<f64>| matrix.map(|x| Complex::new(x, 0.0));
        let schur = nalgebra::linalg::Schur::try_new(complex(&seen.a), f64::EPSILON, ITERATIONS)?;
        let (q, t) = schur.unpack();
        let by_rows = |matrix: &DMatrix<Complex<f64>>| matrix.transpose().as_slice().to_vec();
        let in_schur = |vector: &DVector<f64>| {
            (q.adjoint() * vector.map(|x| Complex::new(x, 0.0))).as_slice().to_vec()
        };
        let parts = || seen.coefficients.iter().zip(&record.entries);
        let inverse = |variance: &f64| 1.0 / variance;
        Some(Self {
            n,
            m,
            factors: record.entries.len(),
            t: by_rows(&t),
            floor: f64::EPSILON * seen.a.amax().max(1.0),
            c: by_rows(&(complex(&seen.c) * &q)),
            b: seen.b.as_slice().to_vec(),
            b_schur: in_schur(&seen.b),
            d: seen.d.as_slice().to_vec(),
            gain: seen.gain.as_slice().to_vec(),
            into_state: parts()
                .map(|(tau, entry)| {
                    (*entry != Entry::Sensors)
                        .then(|| in_schur(&DVector::from_column_slice(&tau[..n])))
                })
                .collect(),
            into_sensors: parts()
                .map(|(tau, entry)| (*entry != Entry::State).then(|| tau[n..].to_vec()))
                .collect(),
            white: seen.variances.iter().map(inverse).collect(),
            white_at_zero: seen
                .variances
                .iter()
                .zip(&record.offset_variance)
                .map(|(variance, offset)| 1.0 / (variance + offset))
                .collect(),
            diagonal: record.precision.is_none(),
            q: by_rows(&q),
        })
    }
}

/// Sums that are not matrix products, lane by lane.
struct Totals {
    cost: Real,
    log_determinant: f64,
    descent: Vec<Real>,
    information: Vec<Real>,
    score: Vec<Real>,
    states: Vec<Real>,
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
struct Tile {
    z_rows: usize,
    w_rows: usize,
    /// Weighted D^H Phi D, packed: real and imaginary parts.
    z: [Vec<f64>; 2],
    /// conj(s_a) s_c, packed.
    w: [Vec<f64>; 2],
    filled: usize,
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
    fn put(parts: &mut [Vec<f64>; 2], row: usize, at: usize, value: Lanes) {
        let [real, imaginary] = parts;
        let start = row * TILE + at;
        real[start..start + WIDTH].copy_from_slice(&value.re.0);
        imaginary[start..start + WIDTH].copy_from_slice(&value.im.0);
    }
}

/// Everything at eight frequencies.
struct AtFrequencies {
    n: usize,
    m: usize,
    z: Lanes,
    weight: Real,
    factors: Vec<Lanes>,
    /// 1 / (z - T_ii).
    pivots: Vec<Lanes>,
    /// A row of C Q (zI - T)^-1, or a column of (zI - T)^-1.
    work: Vec<Lanes>,
    /// H, m rows of n.
    h: Vec<Lanes>,
    g: Vec<Lanes>,
    /// S^-1 g.
    sg: Vec<Lanes>,
    /// 1 / (g^H S^-1 g), zero where g is.
    inverse_gain: Real,
    /// S^-1 row by row, or its diagonal in the first m places.
    precision: Vec<Lanes>,
    diagonal: bool,
    /// What known signals leave, less g U.
    e: Vec<Lanes>,
    /// Phi e.
    pe: Vec<Lanes>,
    u: Lanes,
    phi: Vec<Lanes>,
    /// Phi H, m rows of n.
    phi_h: Vec<Lanes>,
    /// f Q^H tau, summed over the factors.
    driven: Vec<Lanes>,
    /// X, U, f.
    scalars: Vec<Lanes>,
}

impl AtFrequencies {
    fn new(tables: &Tables) -> Self {
        let (n, m, factors) = (tables.n, tables.m, tables.factors);
        let zeros = |length: usize| vec![Lanes::ZERO; length];
        Self {
            n,
            m,
            z: Lanes::ZERO,
            weight: Real::ZERO,
            factors: zeros(factors),
            pivots: zeros(n),
            work: zeros(n),
            h: zeros(m * n),
            g: zeros(m),
            sg: zeros(m),
            inverse_gain: Real::ZERO,
            precision: zeros(m * m),
            diagonal: tables.diagonal,
            e: zeros(m),
            pe: zeros(m),
            u: Lanes::ZERO,
            phi: zeros(m * m),
            phi_h: zeros(m * n),
            driven: zeros(n),
            scalars: zeros(n + 1 + factors),
        }
    }

    /// The data; lanes beyond the last frequency repeat it with weight zero.
    #[inline(always)]
    fn load(&mut self, record: &RecordSpectrum, tables: &Tables, first: usize) {
        let (m, factors) = (self.m, tables.factors);
        let last = record.frequencies() - 1;
        self.z = Lanes::gather(&record.z, first, 1, last);
        self.weight = Real(std::array::from_fn(|k| {
            if first + k <= last { record.weight[first + k] } else { 0.0 }
        }));
        for s in 0..m {
            self.e[s] = Lanes::gather(&record.y, first * m + s, m, last * m + s);
        }
        for (k, factor) in self.factors.iter_mut().enumerate() {
            *factor =
                Lanes::gather(&record.factors, first * factors + k, factors, last * factors + k);
        }
        if let Some(precision) = &record.precision {
            for (k, entry) in self.precision.iter_mut().enumerate() {
                *entry = Lanes::gather(precision, first * m * m + k, m * m, last * m * m + k);
            }
        } else {
            for s in 0..m {
                self.precision[s].re = Real::all(tables.white[s]);
                if first == 0 && record.starts_at_zero {
                    self.precision[s].re.0[0] = tables.white_at_zero[s];
                }
            }
        }
    }

    #[inline(always)]
    fn evaluate(&mut self, record: &RecordSpectrum, tables: &Tables) {
        let (n, m) = (self.n, self.m);
        let floor = Real::all(tables.floor);
        for (i, pivot) in self.pivots.iter_mut().enumerate() {
            let mut difference = self.z - Lanes::all(tables.t[i * n + i]);
            // z is an eigenvalue to working precision: the solution then points along its eigenvector.
            for k in 0..WIDTH {
                let (re, im) = (difference.re.0[k], difference.im.0[k]);
                let small = re * re + im * im < floor.0[k] * floor.0[k];
                difference.re.0[k] = if small { floor.0[k] } else { re };
                difference.im.0[k] = if small { 0.0 } else { im };
            }
            let inverse = difference.norm_sqr().map(|x| 1.0 / x);
            *pivot = difference.conj().scale(inverse);
        }
        for s in 0..m {
            self.row_of_h(s, tables);
            let mut g = Lanes { re: Real::all(tables.d[s]), im: Real::ZERO };
            for l in 0..n {
                g += self.h[s * n + l].scale(Real::all(tables.b[l]));
            }
            self.g[s] = g;
        }
        self.subtract_known(record, tables);
        for s in 0..m {
            self.sg[s] = self.weighted(s, &self.g);
        }
        let mut gain = Real::ZERO;
        for s in 0..m {
            gain += self.g[s].dot(self.sg[s]);
        }
        self.inverse_gain = gain.map(|x| if x > 0.0 { 1.0 / x } else { 0.0 });
        self.u = Lanes::ZERO;
        // Twice: the second pass removes what the first one's rounding left along g.
        for _ in 0..2 {
            let mut part = Lanes::ZERO;
            for s in 0..m {
                part += self.sg[s].conj_mul(self.e[s]);
            }
            let part = part.scale(self.inverse_gain);
            for s in 0..m {
                self.e[s] -= self.g[s] * part;
            }
            self.u += part;
        }
        for s in 0..m {
            self.pe[s] = self.weighted(s, &self.e);
        }
        self.projector();
    }

    /// Row s of C Q (zI - T)^-1 Q^H.
    #[inline(always)]
    fn row_of_h(&mut self, s: usize, tables: &Tables) {
        let n = self.n;
        for l in 0..n {
            let mut sum = Lanes::all(tables.c[s * n + l]);
            for k in 0..l {
                sum += self.work[k] * Lanes::all(tables.t[k * n + l]);
            }
            self.work[l] = sum * self.pivots[l];
        }
        for i in 0..n {
            let mut sum = Lanes::ZERO;
            for l in 0..n {
                sum += self.work[l] * Lanes::all(tables.q[i * n + l].conj());
            }
            self.h[s * n + i] = sum;
        }
    }

    /// Q (zI - T)^-1 times `work`, into the first n scalars.
    #[inline(always)]
    fn state(&mut self, tables: &Tables) {
        let n = self.n;
        for i in (0..n).rev() {
            let mut sum = self.work[i];
            for l in i + 1..n {
                sum += Lanes::all(tables.t[i * n + l]) * self.work[l];
            }
            self.work[i] = sum * self.pivots[i];
        }
        for i in 0..n {
            let mut sum = Lanes::ZERO;
            for l in 0..n {
                sum += Lanes::all(tables.q[i * n + l]) * self.work[l];
            }
            self.scalars[i] = sum;
        }
    }

    /// Entry s of S^-1 v.
    #[inline(always)]
    fn weighted(&self, s: usize, v: &[Lanes]) -> Lanes {
        if self.diagonal {
            return v[s].scale(self.precision[s].re);
        }
        let mut sum = Lanes::ZERO;
        for (l, v) in v.iter().enumerate() {
            sum += self.precision[s * self.m + l] * *v;
        }
        sum
    }

    /// e = Y - f (H tau + delta). H tau is taken as C Q (zI - T)^-1 Q^H tau.
    #[inline(always)]
    fn subtract_known(&mut self, record: &RecordSpectrum, tables: &Tables) {
        let (n, m) = (self.n, self.m);
        self.driven.fill(Lanes::ZERO);
        for k in 0..record.entries.len() {
            let factor = self.factors[k];
            if let Some(tau) = &tables.into_state[k] {
                for (driven, &tau) in self.driven.iter_mut().zip(tau) {
                    *driven += factor * Lanes::all(tau);
                }
            }
            if let Some(delta) = &tables.into_sensors[k] {
                for (e, &delta) in self.e.iter_mut().zip(delta) {
                    *e -= factor.scale(Real::all(delta));
                }
            }
        }
        self.work.copy_from_slice(&self.driven);
        for i in (0..n).rev() {
            let mut sum = self.work[i];
            for l in i + 1..n {
                sum += Lanes::all(tables.t[i * n + l]) * self.work[l];
            }
            self.work[i] = sum * self.pivots[i];
        }
        for s in 0..m {
            let mut sum = self.e[s];
            for i in 0..n {
                sum -= Lanes::all(tables.c[s * n + i]) * self.work[i];
            }
            self.e[s] = sum;
        }
    }

    /// Phi and Phi H.
    #[inline(always)]
    fn projector(&mut self) {
        let (n, m) = (self.n, self.m);
        for i in 0..m {
            for l in 0..m {
                let precision = if !self.diagonal {
                    self.precision[i * m + l]
                } else if i == l {
                    self.precision[i]
                } else {
                    Lanes::ZERO
                };
                let along = (self.sg[i] * self.sg[l].conj()).scale(self.inverse_gain);
                self.phi[i * m + l] = precision - along;
            }
        }
        for i in 0..m {
            for k in 0..n {
                let mut sum = Lanes::ZERO;
                for l in 0..m {
                    sum += self.phi[i * m + l] * self.h[l * n + k];
                }
                self.phi_h[i * n + k] = sum;
            }
        }
    }

    #[inline(always)]
    fn cost(&self) -> Real {
        let mut sum = Real::ZERO;
        for (e, pe) in self.e.iter().zip(&self.pe) {
            sum += e.dot(*pe);
        }
        sum
    }

    #[inline(always)]
    fn add_levels(&self, totals: &mut Totals) {
        let m = self.m;
        for (sum, phi) in totals.information.iter_mut().zip(&self.phi) {
            *sum += self.weight * phi.norm_sqr();
        }
        for s in 0..m {
            totals.score[s] += self.weight * (self.pe[s].norm_sqr() - self.phi[s * m + s].re);
        }
        if self.diagonal {
            let mut length = Real::ZERO;
            let mut determinant = Real::all(1.0);
            for s in 0..m {
                length += self.g[s].norm_sqr();
                determinant = determinant * self.precision[s].re;
            }
            let volume = length * determinant * self.inverse_gain;
            for (weight, volume) in self.weight.0.iter().zip(volume.0) {
                if volume > 0.0 {
                    totals.log_determinant -= weight * volume.ln();
                }
            }
        }
    }

    #[inline(always)]
    fn estimated_scalars(&mut self, tables: &Tables) {
        let n = self.n;
        for i in 0..n {
            self.work[i] = self.driven[i] + self.u * Lanes::all(tables.b_schur[i]);
        }
        self.state(tables);
        let mut u = self.u;
        for (state, &gain) in self.scalars[..n].iter().zip(&tables.gain) {
            u += state.scale(Real::all(gain));
        }
        self.scalars[n] = u;
        self.scalars[n + 1..].copy_from_slice(&self.factors);
    }

    #[inline(always)]
    fn noise_scalars(&mut self, tables: &Tables) {
        let n = self.n;
        let size = self.inverse_gain.map(f64::sqrt);
        for i in 0..n {
            self.work[i] = Lanes::all(tables.b_schur[i]).scale(size);
        }
        self.state(tables);
        let mut u = Lanes { re: size, im: Real::ZERO };
        for (state, &gain) in self.scalars[..n].iter().zip(&tables.gain) {
            u += state.scale(Real::all(gain));
        }
        self.scalars[n] = u;
        self.scalars[n + 1..].fill(Lanes::ZERO);
    }

    /// Second moments of the states, and the descent.
    #[inline(always)]
    fn add_moments(&self, totals: &mut Totals) {
        let (n, m) = (self.n, self.m);
        let rows = n + m;
        for i in 0..n {
            let weighted = self.scalars[i].scale(self.weight);
            for l in 0..n {
                totals.states[i * n + l] += weighted.dot(self.scalars[l]);
            }
        }
        for i in 0..rows {
            // (D^H Phi e)_i
            let mut slope = Lanes::ZERO;
            if i < n {
                for s in 0..m {
                    slope += self.h[s * n + i].conj_mul(self.pe[s]);
                }
            } else {
                slope = self.pe[i - n];
            }
            let slope = slope.scale(self.weight);
            for (a, scalar) in self.scalars.iter().enumerate() {
                totals.descent[a * rows + i] += scalar.dot(slope);
            }
        }
    }

    #[inline(always)]
    fn fill(&self, tile: &mut Tile) {
        let (n, m) = (self.n, self.m);
        let rows = n + m;
        let mut index = 0;
        for k in 0..rows {
            for i in 0..=k {
                let entry = if k < n {
                    let mut sum = Lanes::ZERO;
                    for s in 0..m {
                        sum += self.h[s * n + i].conj_mul(self.phi_h[s * n + k]);
                    }
                    sum
                } else if i < n {
                    self.phi_h[(k - n) * n + i].conj()
                } else {
                    self.phi[(i - n) * m + k - n]
                };
                Tile::put(&mut tile.z, index, tile.filled, entry.scale(self.weight));
                index += 1;
            }
        }
        let mut index = 0;
        for c in 0..self.scalars.len() {
            for a in 0..=c {
                let entry = self.scalars[a].conj_mul(self.scalars[c]);
                Tile::put(&mut tile.w, index, tile.filled, entry);
                index += 1;
            }
        }
        tile.filled += WIDTH;
    }
}

#[cfg(test)]
mod tests;
