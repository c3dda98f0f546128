//! Everything that the sums need at one frequency, for eight frequencies at a time. The symbols are those of `accumulate.rs`.

use num_complex::Complex;

use super::schur_form::SchurForm;
use super::simd::{Lanes, Real, WIDTH};
use super::spectrum::RecordSpectrum;
use super::sums::{Tile, Totals};

/// Everything at eight frequencies.
pub(crate) struct FrequencyBlock {
    n: usize,
    m: usize,
    z: Lanes,
    pub(crate) weight: Real,
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
    /// Power of each sensor, where a part of it counts as model error; else empty.
    power: Vec<Real>,
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

/// What [`FrequencyBlock::write_down`] writes, frequency after frequency.
#[derive(Debug, Default)]
pub(crate) struct AtFrequencies {
    /// Phi, m x m, row by row.
    pub(crate) projector: Vec<Complex<f64>>,
    /// Phi e, m.
    pub(crate) weighted_residual: Vec<Complex<f64>>,
    /// Phi H, m x n, row by row.
    pub(crate) projected_response: Vec<Complex<f64>>,
    /// X, U, f.
    pub(crate) scalars: Vec<Complex<f64>>,
    /// Power of each sensor, where a part of it counts as model error.
    pub(crate) power: Vec<f64>,
}

impl FrequencyBlock {
    pub(crate) fn new(schur: &SchurForm) -> Self {
        let (n, m, factors) = (schur.n, schur.m, schur.factors);
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
            diagonal: schur.diagonal,
            power: if schur.has_relative { vec![Real::ZERO; m] } else { Vec::new() },
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
    pub(crate) fn load(&mut self, record: &RecordSpectrum, schur: &SchurForm, first: usize) {
        let (m, factors) = (self.m, schur.factors);
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
                self.precision[s].re = Real::all(schur.white[s]);
                if first == 0 && record.starts_at_zero {
                    self.precision[s].re.0[0] = schur.white_at_zero[s];
                }
            }
            if let Some(power) = &record.power {
                self.load_power(power, schur, first, last);
            }
        }
    }

    /// The precisions where a part of each sensor's power is added to its variance.
    #[inline(always)]
    fn load_power(&mut self, power: &[f64], schur: &SchurForm, first: usize, last: usize) {
        let m = self.m;
        let relative = Real::all(schur.relative);
        for s in 0..m {
            let power = Real(std::array::from_fn(|k| power[(first + k).min(last) * m + s]));
            self.power[s] = power;
            let white = self.precision[s].re.map(|x| 1.0 / x);
            self.precision[s].re = (white + relative * power).map(|x| 1.0 / x);
        }
    }

    #[inline(always)]
    pub(crate) fn evaluate(&mut self, record: &RecordSpectrum, schur: &SchurForm) {
        let (n, m) = (self.n, self.m);
        let floor = Real::all(schur.floor);
        for (i, pivot) in self.pivots.iter_mut().enumerate() {
            let mut difference = self.z - Lanes::all(schur.t[i * n + i]);
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
            self.row_of_h(s, schur);
            let mut g = Lanes { re: Real::all(schur.d[s]), im: Real::ZERO };
            for l in 0..n {
                g += self.h[s * n + l].scale(Real::all(schur.b[l]));
            }
            self.g[s] = g;
        }
        self.subtract_known(record, schur);
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
    fn row_of_h(&mut self, s: usize, schur: &SchurForm) {
        let n = self.n;
        for l in 0..n {
            let mut sum = Lanes::all(schur.c[s * n + l]);
            for k in 0..l {
                sum += self.work[k] * Lanes::all(schur.t[k * n + l]);
            }
            self.work[l] = sum * self.pivots[l];
        }
        for i in 0..n {
            let mut sum = Lanes::ZERO;
            for l in 0..n {
                sum += self.work[l] * Lanes::all(schur.q[i * n + l].conj());
            }
            self.h[s * n + i] = sum;
        }
    }

    /// Q (zI - T)^-1 times `work`, into the first n scalars.
    #[inline(always)]
    fn state(&mut self, schur: &SchurForm) {
        let n = self.n;
        for i in (0..n).rev() {
            let mut sum = self.work[i];
            for l in i + 1..n {
                sum += Lanes::all(schur.t[i * n + l]) * self.work[l];
            }
            self.work[i] = sum * self.pivots[i];
        }
        for i in 0..n {
            let mut sum = Lanes::ZERO;
            for l in 0..n {
                sum += Lanes::all(schur.q[i * n + l]) * self.work[l];
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
    fn subtract_known(&mut self, record: &RecordSpectrum, schur: &SchurForm) {
        let (n, m) = (self.n, self.m);
        self.driven.fill(Lanes::ZERO);
        for k in 0..record.entries.len() {
            let factor = self.factors[k];
            if let Some(tau) = &schur.into_state[k] {
                for (driven, &tau) in self.driven.iter_mut().zip(tau) {
                    *driven += factor * Lanes::all(tau);
                }
            }
            if let Some(delta) = &schur.into_sensors[k] {
                for (e, &delta) in self.e.iter_mut().zip(delta) {
                    *e -= factor.scale(Real::all(delta));
                }
            }
        }
        self.work.copy_from_slice(&self.driven);
        for i in (0..n).rev() {
            let mut sum = self.work[i];
            for l in i + 1..n {
                sum += Lanes::all(schur.t[i * n + l]) * self.work[l];
            }
            self.work[i] = sum * self.pivots[i];
        }
        for s in 0..m {
            let mut sum = self.e[s];
            for i in 0..n {
                sum -= Lanes::all(schur.c[s * n + i]) * self.work[i];
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
    pub(crate) fn cost(&self) -> Real {
        let mut sum = Real::ZERO;
        for (e, pe) in self.e.iter().zip(&self.pe) {
            sum += e.dot(*pe);
        }
        sum
    }

    #[inline(always)]
    pub(crate) fn add_levels(&self, totals: &mut Totals) {
        let m = self.m;
        // A variance for each sensor and, where there is a model error, one for that.
        let levels = totals.score.len();
        for i in 0..m {
            for l in 0..m {
                totals.information[i * levels + l] += self.weight * self.phi[i * m + l].norm_sqr();
            }
        }
        for s in 0..m {
            totals.score[s] += self.weight * (self.pe[s].norm_sqr() - self.phi[s * m + s].re);
        }
        if levels > m {
            for i in 0..m {
                let mut with = Real::ZERO;
                for l in 0..m {
                    with += self.power[l] * self.phi[i * m + l].norm_sqr();
                }
                let with = self.weight * with;
                totals.information[i * levels + m] += with;
                totals.information[m * levels + i] += with;
                totals.information[m * levels + m] += self.power[i] * with;
                totals.score[m] +=
                    self.weight * self.power[i] * (self.pe[i].norm_sqr() - self.phi[i * m + i].re);
            }
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
    pub(crate) fn estimated_scalars(&mut self, schur: &SchurForm) {
        let n = self.n;
        for i in 0..n {
            self.work[i] = self.driven[i] + self.u * Lanes::all(schur.b_schur[i]);
        }
        self.state(schur);
        let mut u = self.u;
        for (state, &gain) in self.scalars[..n].iter().zip(&schur.gain) {
            u += state.scale(Real::all(gain));
        }
        self.scalars[n] = u;
        self.scalars[n + 1..].copy_from_slice(&self.factors);
    }

    #[inline(always)]
    pub(crate) fn noise_scalars(&mut self, schur: &SchurForm) {
        let n = self.n;
        let size = self.inverse_gain.map(f64::sqrt);
        for i in 0..n {
            self.work[i] = Lanes::all(schur.b_schur[i]).scale(size);
        }
        self.state(schur);
        let mut u = Lanes { re: size, im: Real::ZERO };
        for (state, &gain) in self.scalars[..n].iter().zip(&schur.gain) {
            u += state.scale(Real::all(gain));
        }
        self.scalars[n] = u;
        self.scalars[n + 1..].fill(Lanes::ZERO);
    }

    /// Second moments of the states, and the descent.
    #[inline(always)]
    pub(crate) fn add_moments(&self, totals: &mut Totals) {
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

    /// Writes down Phi, Phi e, Phi H, the scalars and the power of so many frequencies, for whoever needs more than their sums.
    #[inline(always)]
    pub(crate) fn write_down(&self, count: usize, into: &mut AtFrequencies) {
        for lane in 0..count {
            let complex = |all: &Lanes| Complex::new(all.re.0[lane], all.im.0[lane]);
            into.projector.extend(self.phi.iter().map(complex));
            into.weighted_residual.extend(self.pe.iter().map(complex));
            into.projected_response.extend(self.phi_h.iter().map(complex));
            into.scalars.extend(self.scalars.iter().map(complex));
            into.power.extend(self.power.iter().map(|power| power.0[lane]));
        }
    }

    #[inline(always)]
    pub(crate) fn fill(&self, tile: &mut Tile) {
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
