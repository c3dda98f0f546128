//! Cost, gradient and Gram matrix of all records at one system, with what each record's known signals explain taken out.

use hankel::Sharing;
use nalgebra::{DMatrix, DVector};
use realfft::RealFftPlanner;

use super::accumulate::{SHARE, Scalars, accumulate};
use super::first_order_hold::FirstOrder;
use super::inverse_factor::inverse_factor;
use super::lateral::LateralParameters;
use super::noise::floors;
use super::parameters::{Layout, System};
use super::record_system::RecordSystem;
use super::spectrum::{Entry, RecordSpectrum, transform};
use super::sums::Sums;
use crate::likelihood::options::Options;
use crate::model::Hold;
use crate::model::lateral_equations::Prior;
use crate::{ReconstructError, Record};

/// The records as the fit sees them.
#[derive(Debug)]
pub(crate) struct Problem {
    pub(crate) layout: Layout,
    /// What is free where the entries of the matrices are not.
    pub(crate) lateral: Option<LateralParameters>,
    pub(crate) spectra: Vec<RecordSpectrum>,
    /// How many threads sum.
    pub(crate) threads: usize,
    /// What no variance falls below: one for each sensor and, where there is a relative model error, one for its square.
    pub(crate) floors: Vec<f64>,
}

/// The coefficients of each record's known signals: for each record and signal, n entries into the state and m into the sensors.
pub(crate) type Coefficients = Vec<Vec<Vec<f64>>>;

/// What one record's known signals can explain: a basis of their coefficients, and how these follow the parameters.
#[derive(Clone, Debug)]
struct Eliminated {
    /// The change of the coefficients that minimises the cost, in the cells of `cells`.
    best: DVector<f64>,
    /// The change of that change with the record's local parameters.
    response: DMatrix<f64>,
    /// (signal, row) of each coefficient.
    cells: Vec<(usize, usize)>,
    rank: usize,
}

/// The same in coordinates in which the coefficients' own Gram matrix is the identity.
struct Explained {
    /// Their descent.
    own: DVector<f64>,
    /// Their Gram matrix with the local parameters.
    mixed: DMatrix<f64>,
}

/// The likelihood at one system.
#[derive(Clone, Debug)]
pub(crate) struct Evaluation {
    pub(crate) system: System,
    pub(crate) coefficients: Coefficients,
    eliminated: Vec<Eliminated>,
    /// The derivatives of the entries by the parameters, where these are not the entries.
    pub(crate) tangent: Option<DMatrix<f64>>,
    /// The cost with the best coefficients.
    pub(crate) cost: f64,
    /// Its part from each record.
    pub(crate) record_costs: Vec<f64>,
    /// Half the Gauss-Newton matrix of the cost, coefficients eliminated.
    pub(crate) gram: DMatrix<f64>,
    /// Half the direction of steepest descent.
    pub(crate) descent: DVector<f64>,
    /// The number of coefficients that the records determine.
    pub(crate) nuisance_rank: usize,
    /// For the noise levels: see [`Sums`].
    pub(crate) log_determinant: f64,
    pub(crate) information: DMatrix<f64>,
    pub(crate) score: DVector<f64>,
    /// Second moments of the states over all records, n x n.
    pub(crate) states: DMatrix<f64>,
}

impl Problem {
    /// The records in the frequency domain, each sensor in its unit.
    pub(crate) fn new(
        layout: Layout,
        records: &[Record],
        units: &[f64],
        options: &Options,
    ) -> Result<Self, ReconstructError> {
        let mut planner = RealFftPlanner::new();
        let spectra = records
            .iter()
            .enumerate()
            .map(|(index, record)| transform(record, index, units, options, &mut planner))
            .collect::<Result<_, _>>()?;
        let floors = floors(records, units, options);
        Ok(Self { layout, lateral: None, spectra, threads: options.threads, floors })
    }

    /// The same without some of the data.
    pub(crate) fn with_spectra(&self, spectra: Vec<RecordSpectrum>) -> Self {
        let (layout, lateral) = (self.layout.clone(), self.lateral.clone());
        Self { layout, lateral, spectra, threads: self.threads, floors: self.floors.clone() }
    }

    /// How searches share the threads. Where a record is so long that its sums are shared, one search has them all.
    pub(crate) fn sharing(&self) -> Sharing {
        let long = self.spectra.iter().any(|spectrum| spectrum.frequencies() > SHARE);
        Sharing { threads: if long { 1 } else { self.threads }, least: 1 }
    }

    /// Coefficients that explain nothing.
    pub(crate) fn no_coefficients(&self) -> Coefficients {
        let length = self.layout.order + self.layout.sensors;
        self.spectra
            .iter()
            .map(|spectrum| vec![vec![0.0; length]; spectrum.entries.len()])
            .collect()
    }

    /// The sums of one record.
    pub(crate) fn record_sums(
        &self,
        record: usize,
        system: &System,
        coefficients: &Coefficients,
        variances: &[f64],
        scalars: Scalars,
        keep_spectrum: bool,
    ) -> Sums {
        let record_system = RecordSystem::new(system, record, &coefficients[record], variances);
        let spectrum = &self.spectra[record];
        let sum = |spectrum: &RecordSpectrum| {
            accumulate(spectrum, &record_system, scalars, keep_spectrum, self.threads)
        };
        match &spectrum.missing {
            None => sum(spectrum),
            Some(missing) => missing.sums(spectrum, &record_system, scalars, None, sum),
        }
    }

    /// Evaluates the likelihood with what known signals explain at its best: once to find that, once around it.
    pub(crate) fn evaluate(&self, system: System, variances: &[f64]) -> Evaluation {
        self.evaluate_near(system, self.no_coefficients(), variances)
    }

    /// The same from coefficients of the known signals that are close already.
    pub(crate) fn evaluate_near(
        &self,
        system: System,
        coefficients: Coefficients,
        variances: &[f64],
    ) -> Evaluation {
        let first = self.evaluate_around(system, coefficients, variances);
        self.evaluate_again(first, variances)
    }

    /// Evaluates the same system around its best coefficients.
    pub(crate) fn evaluate_again(&self, evaluation: Evaluation, variances: &[f64]) -> Evaluation {
        let still = DVector::zeros(evaluation.descent.len());
        let coefficients = evaluation.coefficients_after(&still, &self.layout);
        self.evaluate_around(evaluation.system, coefficients, variances)
    }

    /// Evaluates the likelihood around these coefficients of the known signals. They should be close to the best ones, to which the cost then
    /// belongs but for rounding errors.
    pub(crate) fn evaluate_around(
        &self,
        system: System,
        coefficients: Coefficients,
        variances: &[f64],
    ) -> Evaluation {
        let layout = &self.layout;
        let (p, n) = (layout.parameters(), layout.order);
        let levels = variances.len();
        let cells = layout.local_cells();
        let mut system = system;
        let hold = self.tie(&mut system);
        let mut result = Evaluation {
            eliminated: Vec::with_capacity(layout.records),
            tangent: None,
            cost: 0.0,
            record_costs: Vec::with_capacity(layout.records),
            gram: DMatrix::zeros(p, p),
            descent: DVector::zeros(p),
            nuisance_rank: 0,
            log_determinant: 0.0,
            information: DMatrix::zeros(levels, levels),
            score: DVector::zeros(levels),
            states: DMatrix::zeros(n, n),
            system,
            coefficients,
        };
        if hold.is_none() && layout.hold == Hold::FirstOrder {
            // Without the hold's matrix there is no cost: NaN is never below anything.
            result.cost = f64::NAN;
            return result;
        }
        for record in 0..layout.records {
            let sums = self.record_sums(
                record,
                &result.system,
                &result.coefficients,
                variances,
                Scalars::Estimated,
                false,
            );
            let (mut eliminated, explained) = self.eliminate(record, &result.system, &sums, &cells);
            let cost = sums.cost - explained.own.norm_squared();
            // Rounding errors may lie below zero; what is not a number stays none.
            let cost = if cost < 0.0 { 0.0 } else { cost };
            result.cost += cost;
            result.record_costs.push(cost);
            // The best coefficients follow the parameters, so that descent and Gram matrix are those of what is left.
            let gram = sums.gram_of(&cells) - explained.mixed.tr_mul(&explained.mixed);
            let descent =
                DVector::from_iterator(cells.len(), cells.iter().map(|&cell| sums.descent(cell)))
                    - explained.mixed.tr_mul(&explained.own);
            let tangent = hold.as_ref().map(|hold| hold.tangent(&result.system, record, layout));
            layout.add(record, tangent.as_ref(), gram, &mut result.gram);
            match &tangent {
                Some(tangent) => {
                    layout.add_vector(record, &tangent.tr_mul(&descent), &mut result.descent);
                    eliminated.response *= tangent;
                }
                None => layout.add_vector(record, &descent, &mut result.descent),
            }
            result.nuisance_rank += eliminated.rank;
            result.log_determinant += sums.log_determinant;
            result.information += DMatrix::from_row_slice(levels, levels, &sums.information);
            result.score += DVector::from_column_slice(&sums.score);
            result.states += DMatrix::from_row_slice(n, n, &sums.states);
            result.eliminated.push(eliminated);
        }
        if let Some(lateral) = &self.lateral {
            in_derivatives(lateral, &mut result);
        }
        result
    }

    /// Directions that the records can determine.
    pub(crate) fn identifiable(&self) -> usize {
        self.lateral.as_ref().map_or_else(|| self.layout.identifiable(), LateralParameters::count)
    }

    /// How many parameters rest on what is known beforehand rather than on the records.
    pub(crate) fn known_beforehand(&self, system: &System, covariance: &DMatrix<f64>) -> f64 {
        let (Some(lateral), Some(own)) = (&self.lateral, &system.derivatives) else { return 0.0 };
        let share = |prior: Prior| {
            prior.slope * prior.slope * covariance[(prior.parameter, prior.parameter)]
        };
        lateral.priors(own).into_iter().map(share).sum()
    }

    /// The system after a step in the parameters; `None` where there is none.
    pub(crate) fn moved(&self, system: &System, step: &DVector<f64>) -> Option<System> {
        let moved = match (&self.lateral, &system.derivatives) {
            (Some(lateral), Some(derivatives)) => lateral.system(derivatives + step)?,
            _ => system.moved(step, &self.layout),
        };
        moved.is_finite().then_some(moved)
    }

    /// The tangents of changes that leave the likelihood as it is, one a column; derivatives have none.
    pub(crate) fn invariant_tangents(&self, system: &System) -> DMatrix<f64> {
        match &self.lateral {
            Some(lateral) => DMatrix::zeros(lateral.count(), 0),
            None => system.invariant_tangents(&self.layout),
        }
    }

    /// Sets what the hold says of d_j; `None` where it says nothing.
    pub(crate) fn tie(&self, system: &mut System) -> Option<FirstOrder> {
        if self.layout.hold == Hold::ZeroOrder {
            return None;
        }
        let hold = FirstOrder::new(&system.a)?;
        hold.tie(system, &self.layout);
        Some(hold)
    }

    /// The cell of a coefficient among those of the sums: scalars are X, U, then the signals.
    fn cell(&self, (signal, row): (usize, usize)) -> (usize, usize) {
        (row, self.layout.order + 1 + signal)
    }

    /// Solves for the coefficients, within the part of them that the excitation cannot imitate.
    fn eliminate(
        &self,
        record: usize,
        system: &System,
        sums: &Sums,
        cells: &[(usize, usize)],
    ) -> (Eliminated, Explained) {
        // Directions below this share of the largest one are rounding errors; the squares of singular values are compared.
        const RANK_TOLERANCE: f64 = 1e-12;
        let (own, basis) = self.coefficient_basis(record, system);
        let size = own.len();
        let gram =
            DMatrix::from_fn(size, size, |i, k| sums.gram(self.cell(own[i]), self.cell(own[k])));
        let reduced = basis.transpose() * gram * &basis;
        let factor = inverse_factor(&reduced, RANK_TOLERANCE)
            .map_or_else(|| DMatrix::zeros(0, size), |factor| factor * basis.transpose());
        let descent =
            DVector::from_iterator(size, own.iter().map(|&cell| sums.descent(self.cell(cell))));
        let mixed =
            DMatrix::from_fn(size, cells.len(), |i, k| sums.gram(self.cell(own[i]), cells[k]));
        let explained = Explained { own: &factor * descent, mixed: &factor * mixed };
        let eliminated = Eliminated {
            best: factor.tr_mul(&explained.own),
            response: -factor.tr_mul(&explained.mixed),
            cells: own,
            rank: factor.nrows(),
        };
        (eliminated, explained)
    }

    /// The coefficients of one record, and a basis of those combinations that differ from the excitation's own direction. A signal along
    /// (b, d) is part of the excitation, which is free.
    fn coefficient_basis(
        &self,
        record: usize,
        system: &System,
    ) -> (Vec<(usize, usize)>, DMatrix<f64>) {
        let (n, m) = (self.layout.order, self.layout.sensors);
        let direct = self.layout.direct();
        let (mut cells, mut blocks) = (Vec::new(), Vec::new());
        for (signal, entry) in self.spectra[record].entries.iter().enumerate() {
            let rows: Vec<usize> = match entry {
                Entry::State => (0..n).collect(),
                Entry::StateAndFeedthrough => (0..n).chain(direct.iter().map(|&s| n + s)).collect(),
                Entry::Sensors => (n..n + m).collect(),
            };
            // (b, d) is out of reach of a signal that enters the state alone, if any sensor has a feedthrough.
            let imitated = match entry {
                Entry::State => direct.is_empty(),
                Entry::StateAndFeedthrough => true,
                Entry::Sensors => false,
            };
            let direction = DVector::from_iterator(
                rows.len(),
                rows.iter().map(|&row| {
                    if row < n { system.b[record][row] } else { system.d[record][row - n] }
                }),
            );
            blocks.push(if imitated {
                complement(&direction)
            } else {
                DMatrix::identity(rows.len(), rows.len())
            });
            cells.extend(rows.into_iter().map(|row| (signal, row)));
        }
        let columns = blocks.iter().map(DMatrix::ncols).sum();
        let mut basis = DMatrix::zeros(cells.len(), columns);
        let (mut row, mut column) = (0, 0);
        for block in &blocks {
            basis.view_mut((row, column), block.shape()).copy_from(block);
            row += block.nrows();
            column += block.ncols();
        }
        (cells, basis)
    }
}

impl Evaluation {
    /// The best coefficients after a step in the parameters, to first order; the best ones here for a step of zero.
    pub(crate) fn coefficients_after(&self, step: &DVector<f64>, layout: &Layout) -> Coefficients {
        let mut moved = self.coefficients.clone();
        let of_entries = self.tangent.as_ref().map(|tangent| tangent * step);
        let step = of_entries.as_ref().unwrap_or(step);
        let locals = layout.shared() + layout.per_record();
        for (record, eliminated) in self.eliminated.iter().enumerate() {
            let local = DVector::from_fn(locals, |k, _| step[layout.global(k, record)]);
            let change = &eliminated.best + &eliminated.response * local;
            for (&(signal, row), change) in eliminated.cells.iter().zip(change.iter()) {
                moved[record][signal][row] += change;
            }
        }
        moved
    }
}

/// Cost, gradient and Gram matrix by the derivatives, with what is known of these beforehand.
fn in_derivatives(lateral: &LateralParameters, evaluation: &mut Evaluation) {
    let Some(tangent) = lateral.tangent(&evaluation.system) else {
        evaluation.cost = f64::NAN;
        return;
    };
    evaluation.gram = tangent.tr_mul(&(&evaluation.gram * &tangent));
    evaluation.descent = tangent.tr_mul(&evaluation.descent);
    for prior in evaluation.system.derivatives.iter().flat_map(|own| lateral.priors(own)) {
        let Prior { deviation, parameter, slope } = prior;
        evaluation.cost += deviation * deviation;
        evaluation.gram[(parameter, parameter)] += slope * slope;
        evaluation.descent[parameter] -= slope * deviation;
    }
    evaluation.tangent = Some(tangent);
}

/// An orthonormal basis of what is orthogonal to a vector, one direction a column: the columns of a Householder reflection but the first.
fn complement(vector: &DVector<f64>) -> DMatrix<f64> {
    let n = vector.len();
    let length = vector.norm();
    if length == 0.0 {
        return DMatrix::identity(n, n);
    }
    let mut normal = vector / length;
    normal[0] += if normal[0] < 0.0 { -1.0 } else { 1.0 };
    let square = normal.norm_squared();
    DMatrix::from_fn(n, n - 1, |i, k| {
        f64::from(i == k + 1) - 2.0 * normal[i] * normal[k + 1] / square
    })
}

#[cfg(test)]
mod tests;
