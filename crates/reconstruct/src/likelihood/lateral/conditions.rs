//! Were all records flown under one condition? The lateral equations with derivatives of each record's own, which follow its speed.

use nalgebra::{DMatrix, DVector};

use crate::likelihood::cost::evaluation::{Evaluation, Problem};
use crate::likelihood::cost::lateral::LateralParameters;
use crate::likelihood::cost::parameters::Layout;
use crate::likelihood::inference::chi_squared::chi_squared_survival;
use crate::likelihood::inference::fit::Fit;
use crate::likelihood::inference::refit::{Refit, lateral, refit};
use crate::likelihood::inference::uncertainty::{self, Estimate, Mode, ModelBias};
use crate::model::lateral_equations::{NAMES, STATES};
use crate::{ReconstructError, Record};

/// How one record's condition compares with that of the first.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Condition {
    /// Its speed over that of the first record, from its dynamics.
    pub speed_ratio: Estimate,
    /// Each derivative over that of the first record, in the order of [`Fit::derivatives`].
    pub derivative_ratios: Vec<Estimate>,
    /// The modes of its own derivatives, a complex pair once.
    pub modes: Vec<Mode>,
}

/// The lateral equations with derivatives of each record's own.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ConditionTest {
    /// Each record, the first with a speed ratio of 1.
    pub conditions: Vec<Condition>,
    /// The probability that records flown under one condition gain as much.
    pub p_value: f64,
    /// The probability that records which obey these equations gain as much where all entries of the matrices are free but common to all records: where this is small, the equations
    /// are no explanation.
    pub p_value_of_equations: f64,
}

/// How derivatives follow the speed at one height and weight, as exponents of it: the moments of a sideslip with dynamic pressure, dampings with speed, g/U against it; the
/// angle of attack with lift, which dynamic pressure makes up for.
const EXPONENTS: [f64; NAMES.len()] = [1.0, -2.0, 0.0, -1.0, 2.0, 1.0, 1.0, 2.0, 1.0, 1.0, -2.0];
/// A derivative follows its law within this part of it.
const OFF_THE_LAW: f64 = 0.1;
/// The logarithm of a speed ratio is expected within this.
const SPEEDS: f64 = 0.3;
/// A cost so far above that with all entries free is no explanation: with ten degrees of freedom a probability of 1e-4.
const REJECTED: f64 = 40.0;
/// Unknowns of a record beside those of the first: speed, and how far each derivative is off its law.
const OWN: usize = 1 + NAMES.len();
/// Side force and angle of a control.
const CONTROL: usize = 2;

/// Tests one set of derivatives for all records against one for each. `lateral` and `free` are fits of the same records with the lateral equations and with all
/// entries of the matrices free; the noise is that of the latter. `None` where no such fit is found.
///
/// # Errors
///
/// Those of [`identify`](crate::likelihood::identify) for records and options.
///
/// # Example
///
/// The rudder is moved in a flight that is 15 % faster.
///
/// ```
#[doc = include_str!("../../doctest/lateral_flights.md")]
/// use reconstruct::likelihood::{Hold, condition_test, identify_lateral};
/// use reconstruct::output_error::Structure;
/// use reconstruct::{Options, reconstruct};
///
/// let records = [flight("aileron", 9.0, -0.4, 1.0)?, flight("rudder", 1.2, -3.5, 1.15)?];
/// let mut options = Options::default();
/// options.structure = Structure::BlackBox;
/// let found = reconstruct(&records, &options)?;
/// let free = found.fit().ok_or("no likelihood")?;
/// let lateral = identify_lateral(&records, free, &[Hold::ZeroOrder])?;
/// let test = condition_test(&records, &lateral, free)?.ok_or("no such fit")?;
/// assert!(test.p_value < 1e-4 && test.p_value_of_equations > 1e-3);
/// let ratio = test.conditions[1].speed_ratio;
/// assert!((ratio.value - 1.15).abs() < 3.0 * ratio.standard_error);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn condition_test(
    records: &[Record],
    lateral_fit: &Fit,
    free: &Fit,
) -> Result<Option<ConditionTest>, ReconstructError> {
    let Some(shared) = &lateral_fit.lateral else { return Ok(None) };
    let Refit { problem, evaluation, variances, units } = refit(records, free)?;
    let period = free.model.period.seconds();
    let single = |record: usize| {
        let layout = Layout {
            order: STATES,
            sensors: units.len(),
            records: 1,
            feedthrough: Vec::new(),
            hold: lateral_fit.hold,
        };
        let own = lateral(records, &units, &layout, period)?;
        let spectra = vec![problem.spectra[record].clone()];
        let problem = Problem {
            layout,
            lateral: Some(own.clone()),
            spectra,
            threads: problem.threads,
            floors: problem.floors.clone(),
        };
        Some((problem, own))
    };
    let Some(singles) = (0..records.len()).map(single).collect::<Option<Vec<_>>>() else {
        return Ok(None);
    };
    let search = Conditions { singles, variances: &variances };
    let mut start = DVector::zeros(search.count());
    start.rows_mut(0, shared.len()).copy_from(shared);
    let Some((gain, found)) = search.minimise(start, evaluation.cost + REJECTED) else {
        return Ok(None);
    };
    let Some(covariance) = found.gram.clone().try_inverse() else { return Ok(None) };
    let known: f64 = (0..search.count()).map(|k| found.prior[k] * covariance[(k, k)]).sum();
    let free_numbers = free.identifiable as f64;
    let degrees_of_freedom = (free_numbers - (search.count() as f64 - known)).max(1.0);
    let conditions = (0..records.len()).map(|record| search.condition(record, &found, &covariance));
    let Some(conditions) = conditions.collect::<Option<Vec<_>>>() else { return Ok(None) };
    let more = OWN * (records.len() - 1);
    Ok(Some(ConditionTest {
        conditions,
        p_value: chi_squared_survival(gain, more as f64),
        p_value_of_equations: chi_squared_survival(
            found.cost - evaluation.cost,
            degrees_of_freedom,
        ),
    }))
}

/// Each record as a problem of its own. The unknowns are those of the lateral equations for all records; then for each record but the first the logarithm of its
/// speed ratio, and how far its derivatives are off the law.
struct Conditions<'a> {
    singles: Vec<(Problem, LateralParameters)>,
    variances: &'a [f64],
}

/// All records at one set of unknowns.
struct Point {
    unknowns: DVector<f64>,
    cost: f64,
    gram: DMatrix<f64>,
    /// The diagonal of what is known beforehand.
    prior: DVector<f64>,
    descent: DVector<f64>,
}

impl Conditions<'_> {
    fn records(&self) -> usize {
        self.singles.len()
    }

    fn first_own(&self) -> usize {
        NAMES.len() + CONTROL * self.records()
    }

    fn count(&self) -> usize {
        self.first_own() + OWN * (self.records() - 1)
    }

    /// The place of a record's own unknowns; the first record has none.
    fn own(&self, record: usize) -> Option<usize> {
        (record > 0).then(|| self.first_own() + OWN * (record - 1))
    }

    /// The derivatives of a record, and its control; and how they move with the unknowns.
    fn of_record(&self, record: usize, unknowns: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
        let names = NAMES.len();
        let mut values = DVector::zeros(names + CONTROL);
        let mut moves = DMatrix::zeros(names + CONTROL, unknowns.len());
        for k in 0..names {
            values[k] = unknowns[k];
            moves[(k, k)] = 1.0;
            if let Some(own) = self.own(record) {
                let law = (EXPONENTS[k] * unknowns[own]).exp();
                let off = 1.0 + unknowns[own + 1 + k];
                values[k] = unknowns[k] * law * off;
                moves[(k, k)] = law * off;
                moves[(k, own)] = EXPONENTS[k] * values[k];
                moves[(k, own + 1 + k)] = unknowns[k] * law;
            }
        }
        for k in 0..CONTROL {
            let place = names + CONTROL * record + k;
            values[names + k] = unknowns[place];
            moves[(names + k, place)] = 1.0;
        }
        (values, moves)
    }

    fn at_record(&self, record: usize, values: DVector<f64>) -> Option<Evaluation> {
        let (problem, own) = &self.singles[record];
        let evaluation = problem.evaluate(own.system(values)?, self.variances);
        evaluation.cost.is_finite().then_some(evaluation)
    }

    fn evaluate(&self, unknowns: DVector<f64>) -> Option<Point> {
        let count = self.count();
        let mut point = Point {
            cost: 0.0,
            gram: DMatrix::zeros(count, count),
            prior: DVector::zeros(count),
            descent: DVector::zeros(count),
            unknowns,
        };
        for record in 0..self.records() {
            let (values, moves) = self.of_record(record, &point.unknowns);
            let priors = self.singles[record].1.priors(&values);
            let evaluation = self.at_record(record, values)?;
            point.cost += evaluation.cost;
            point.gram += moves.tr_mul(&(&evaluation.gram * &moves));
            point.descent += moves.tr_mul(&evaluation.descent);
            for prior in priors {
                let row = moves.row(prior.parameter) * prior.slope;
                point.prior += row.component_mul(&row).transpose();
            }
            if let Some(own) = self.own(record) {
                let widths = std::iter::once(SPEEDS).chain([OFF_THE_LAW; NAMES.len()]);
                for (k, width) in widths.enumerate() {
                    let weight = 1.0 / (width * width);
                    let value = point.unknowns[own + k];
                    point.cost += weight * value * value;
                    point.gram[(own + k, own + k)] += weight;
                    point.prior[own + k] += weight;
                    point.descent[own + k] -= weight * value;
                }
            }
        }
        Some(point)
    }

    /// The lowest cost, and what it gains over a common condition; `None` where it stays above the ceiling.
    fn minimise(&self, start: DVector<f64>, ceiling: f64) -> Option<(f64, Point)> {
        let first_own = self.first_own();
        let evaluate = |unknowns| self.evaluate(unknowns);
        let own = descend(self.evaluate(start)?, ceiling, |_| true, evaluate);
        if own.cost > ceiling {
            return None;
        }
        let mut common = own.unknowns.clone();
        common.rows_mut(first_own, self.count() - first_own).fill(0.0);
        let is_common = |k| k < first_own;
        let shared = descend(self.evaluate(common)?, f64::INFINITY, is_common, evaluate);
        Some((shared.cost - own.cost, own))
    }

    fn condition(
        &self,
        record: usize,
        found: &Point,
        covariance: &DMatrix<f64>,
    ) -> Option<Condition> {
        let (values, moves) = self.of_record(record, &found.unknowns);
        let evaluation = self.at_record(record, values)?;
        let period = lti::SamplePeriod::new(self.singles[record].1.period()).ok()?;
        let a = evaluation.system.a;
        let of_a = evaluation.tangent?.rows(0, a.len()) * moves;
        let of_a = &of_a * covariance * of_a.transpose();
        let modes = uncertainty::modes(&a, period, &of_a, ModelBias::default()).ok()?;
        let ratio = self.own(record).map_or(Estimate { value: 1.0, standard_error: 0.0 }, |own| {
            let value = found.unknowns[own].exp();
            let standard_error = value * covariance[(own, own)].max(0.0).sqrt();
            Estimate { value, standard_error }
        });
        let derivative_ratios =
            (0..NAMES.len()).map(|k| self.derivative_ratio(record, k, found, covariance)).collect();
        Some(Condition { speed_ratio: ratio, derivative_ratios, modes })
    }

    /// k^e (1 + off), to first order in both.
    fn derivative_ratio(
        &self,
        record: usize,
        derivative: usize,
        found: &Point,
        covariance: &DMatrix<f64>,
    ) -> Estimate {
        let Some(own) = self.own(record) else {
            return Estimate { value: 1.0, standard_error: 0.0 };
        };
        let exponent = EXPONENTS[derivative];
        let law = (exponent * found.unknowns[own]).exp();
        let value = law * (1.0 + found.unknowns[own + 1 + derivative]);
        let mut slope = DVector::zeros(self.count());
        slope[own] = exponent * value;
        slope[own + 1 + derivative] = law;
        let variance = slope.dot(&(covariance * &slope));
        Estimate { value, standard_error: variance.max(0.0).sqrt() }
    }
}

/// Levenberg-Marquardt over the unknowns that are free; ends where it will stay above the ceiling.
fn descend(
    start: Point,
    ceiling: f64,
    is_free: impl Fn(usize) -> bool,
    evaluate: impl Fn(DVector<f64>) -> Option<Point>,
) -> Point {
    const STEPS: usize = 40;
    const FIRST_DAMPING: f64 = 1e-3;
    const LEAST_DAMPING: f64 = 1e-9;
    const MOST_DAMPING: f64 = 1e8;
    /// Of the cost, that the next step would gain.
    const TOLERANCE: f64 = 1e-2;
    /// A cost that is not quadratic may fall by so many times what a quadratic one would.
    const HOPE: f64 = 3.0;
    let mut here = start;
    let mut damping = FIRST_DAMPING;
    for _ in 0..STEPS {
        let scale = DVector::from_fn(here.gram.nrows(), |k, _| {
            let size = here.gram[(k, k)];
            if is_free(k) && size > 0.0 { 1.0 / size.sqrt() } else { 0.0 }
        });
        let unit = DMatrix::from_fn(here.gram.nrows(), here.gram.ncols(), |i, k| {
            here.gram[(i, k)] * scale[i] * scale[k]
        });
        let slope = here.descent.component_mul(&scale);
        let mut lower = None;
        while damping < MOST_DAMPING {
            let mut damped = unit.clone();
            for k in 0..damped.nrows() {
                damped[(k, k)] += if scale[k] > 0.0 { damping } else { 1.0 };
            }
            let Some(factor) = damped.cholesky() else {
                damping *= 10.0;
                continue;
            };
            let step = factor.solve(&slope);
            let gain = step.dot(&slope);
            if gain < TOLERANCE || here.cost - HOPE * gain > ceiling {
                return here;
            }
            match evaluate(&here.unknowns + step.component_mul(&scale)) {
                Some(next) if next.cost < here.cost => {
                    damping = (damping * 0.1).max(LEAST_DAMPING);
                    lower = Some(next);
                    break;
                }
                _ => damping *= 10.0,
            }
        }
        match lower {
            Some(next) => here = next,
            None => return here,
        }
    }
    here
}
