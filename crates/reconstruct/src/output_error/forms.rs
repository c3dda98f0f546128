//! Which form do the records make most likely? The lateral equations, and black boxes of one order after another, under either hold.

use nalgebra::DVector;

use super::black_box::BlackBox;
use super::candidate::{Candidate, Effort, FIRST_LOOK};
use super::cells::{Matrices, Sizes};
use super::fit::Compared;
use super::observer::{Markov, markov};
use super::options::{Lag, Options, RecordedInputs, Structure};
use super::parametrisation::{Form, Parametrisation};
use super::regression::lateral_start;
use super::spectra::{Spectrum, spectra};
use crate::error::option;
use crate::likelihood::{FrequencyBand, Hold};
use crate::model::lateral_equations::LateralEquations;
use crate::subspace::OrderChoice;
use crate::{ReconstructError, Record};

/// Holds whose criteria are closer than this, a likelihood ratio of e^5, cannot be told apart.
const TELLING: f64 = 10.0;
/// A more complicated form is worth it where it is e^10 times as likely.
const DECISIVE: f64 = 20.0;
/// Where the search for the order of a black box starts, and where it ends unless the options say so.
const LOWEST_ORDER: usize = 2;
/// A form with a mode that grows by more than e^15 in a record follows the disturbance, if another form has none.
const LARGEST_GROWTH: f64 = 15.0;
/// The states of the lateral equations.
const LATERAL_ORDER: usize = 4;
/// So many orders in a row that are less likely than the best end the search upwards.
const MISSES: usize = 2;

/// The form that is used, and how it compares.
pub(super) struct Forms {
    pub(super) best: Candidate,
    pub(super) compared: Vec<Compared>,
    /// Minus twice the logarithm of the other hold's likelihood over that of the hold used.
    pub(super) hold_evidence: Option<f64>,
}

/// Records at the frequencies of a band, and what may be fitted to them.
pub(super) struct Search<'a> {
    records: &'a [Record],
    inputs: &'a RecordedInputs,
    options: &'a Options,
    pub(super) band: FrequencyBand,
    pub(super) drift: bool,
    pub(super) spectra: Vec<Spectrum>,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        records: &'a [Record],
        inputs: &'a RecordedInputs,
        options: &'a Options,
        band: FrequencyBand,
        drift: bool,
    ) -> Result<Self, ReconstructError> {
        let spectra = spectra(records, inputs, band, drift)?;
        let numbers: f64 = spectra.iter().map(Spectrum::real_numbers).sum();
        let empty = spectra.iter().any(|spectrum| spectrum.z.is_empty());
        if empty && options.band.is_some() {
            return Err(option("band", "it holds no frequency of a record".to_owned()));
        }
        let parameters = (records[0].channels().len() * (1 + inputs.names.len())) as f64;
        if empty || numbers <= parameters {
            return Err(ReconstructError::TooFewSamples { residuals: numbers, parameters });
        }
        Ok(Self { records, inputs, options, band, drift, spectra })
    }

    /// The most likely form among those that the options leave open, and by how much it is.
    pub(super) fn best_form(&self) -> Result<Forms, ReconstructError> {
        let mut all: Vec<Candidate> = Vec::new();
        let other_order =
            matches!(self.options.order, OrderChoice::Fixed(order) if order != LATERAL_ORDER);
        if other_order && self.options.structure == Structure::Lateral {
            return Err(option(
                "structure",
                "the lateral equations have 4 states; leave the order out".to_owned(),
            ));
        }
        if self.options.structure != Structure::BlackBox && !other_order {
            let lateral = self.lateral();
            if lateral.is_none() && self.options.structure == Structure::Lateral {
                return Err(option(
                    "structure",
                    "the lateral equations need sensors beta, p and r, and no others but phi"
                        .to_owned(),
                ));
            }
            all.extend(lateral);
        }
        // Where the lateral equations were asked for, black boxes are fitted to say whether they hold.
        self.black_boxes(&mut all)?;
        let seconds =
            self.records.iter().map(|record| record.period().seconds() * record.samples() as f64);
        let (longest, period) = (seconds.fold(0.0, f64::max), self.records[0].period().seconds());
        let grows = |own: &Candidate| own.growth(period, longest) > LARGEST_GROWTH;
        if !all.iter().all(grows) {
            all.retain(|own| !grows(own));
        }
        let lowest = all.iter().map(|own| own.criterion).fold(f64::INFINITY, f64::min);
        let asked = self.options.structure == Structure::Lateral;
        let best = all
            .iter()
            .position(|own| match own.parametrisation.form {
                Form::Lateral(_) => asked || own.criterion <= lowest + DECISIVE,
                Form::BlackBox(_) => own.criterion <= lowest + DECISIVE,
            })
            .ok_or_else(|| ReconstructError::Start {
                start: 0,
                message: "no system could be fitted: the records are too short, or the inputs explain nothing".to_owned(),
            })?;
        let best = all.remove(best);
        let compared = all.iter().map(|other| Compared {
            order: other.parametrisation.sizes().states,
            is_lateral: matches!(other.parametrisation.form, Form::Lateral(_)),
            above: other.criterion - best.criterion,
        });
        let compared = compared.collect();
        let other = if self.options.hold.is_none() { self.with_other_hold(&best) } else { None };
        let evidence = other.as_ref().map(|other| other.criterion - best.criterion);
        // Where the records do not tell, inputs are held, as what a computer logs mostly is.
        let held = |own: &Candidate| hold_of(own) == Hold::ZeroOrder;
        let allowance = if held(&best) { -TELLING } else { TELLING };
        let (best, hold_evidence) = match (other, evidence) {
            (Some(other), Some(evidence)) if evidence < allowance => (other, Some(-evidence)),
            (_, evidence) => (best, evidence),
        };
        Ok(Forms { best, compared, hold_evidence })
    }

    fn lags(&self) -> (Vec<Lag>, Vec<Lag>) {
        let or_none = |lags: &[Lag], count: usize| {
            if lags.is_empty() { vec![Lag::Given(0.0); count] } else { lags.to_vec() }
        };
        let sensors = self.records[0].channels().len();
        (
            or_none(&self.options.sensor_lags, sensors),
            or_none(&self.options.input_lags, self.inputs.names.len()),
        )
    }

    fn with_lags(&self, form: Form) -> Parametrisation {
        let (sensor_lags, input_lags) = self.lags();
        Parametrisation { form, sensor_lags, input_lags }
    }

    /// Fits from starts of the form's parameters, free lags at zero.
    fn fit(&self, form: Form, starts: &[DVector<f64>]) -> Option<Candidate> {
        let parametrisation = self.with_lags(form);
        let size = parametrisation.parameters();
        let starts: Vec<_> =
            starts.iter().map(|start| start.clone().resize_vertically(size, 0.0)).collect();
        Candidate::fit(parametrisation, &self.spectra, &starts, FIRST_LOOK)
    }

    /// The holds that may be.
    fn holds(&self) -> Vec<Hold> {
        self.options.hold.map_or_else(|| vec![Hold::ZeroOrder, Hold::FirstOrder], |hold| vec![hold])
    }

    /// The lateral equations, under the more likely hold.
    fn lateral(&self) -> Option<Candidate> {
        /// Frequencies up to which the regressions go, in rad/s.
        const REGRESSIONS: [f64; 2] = [4.0, 8.0];
        let channels = self.records[0].channels();
        let names: Vec<&str> = channels.iter().map(|channel| channel.name.as_str()).collect();
        let period = self.records[0].period().seconds();
        let with = |hold: Hold| {
            let inputs = self.inputs.names.len();
            let equations = LateralEquations::new(&names, inputs, hold, period)?;
            let regression = |&highest: &f64| lateral_start(&self.spectra, &equations, highest);
            let starts: Vec<_> = REGRESSIONS.iter().filter_map(regression).collect();
            self.fit(Form::Lateral(equations), &starts)
        };
        let all = self.holds().into_iter().filter_map(with);
        all.min_by(|x, y| x.criterion.total_cmp(&y.criterion))
    }

    /// Black boxes of one order after another, as long as more states are more likely.
    fn black_boxes(&self, all: &mut Vec<Candidate>) -> Result<(), ReconstructError> {
        let markov = markov(self.records, self.inputs)?;
        let (first, last) = match self.options.order {
            OrderChoice::Fixed(order) => (order, order),
            OrderChoice::Gap { largest } => (LOWEST_ORDER.min(largest), largest),
        };
        let lateral = all.first();
        let (mut lowest, mut misses) = (f64::INFINITY, 0);
        let mut hold = lateral.map(hold_of);
        let lateral = lateral.and_then(Candidate::matrices);
        for order in first..=last {
            if misses == MISSES {
                break;
            }
            let also = lateral.as_ref().filter(|own| own.a.nrows() == order);
            let Some(found) = self.black_box(order, &markov, also, hold) else {
                misses += 1;
                continue;
            };
            misses = if found.criterion < lowest { 0 } else { misses + 1 };
            lowest = lowest.min(found.criterion);
            hold = Some(hold_of(&found));
            all.push(found);
        }
        Ok(())
    }

    /// The black box of one order.
    fn black_box(
        &self,
        order: usize,
        markov: &Markov,
        also: Option<&Matrices>,
        hold: Option<Hold>,
    ) -> Option<Candidate> {
        let sizes = Sizes {
            states: order,
            sensors: self.records[0].channels().len(),
            inputs: self.inputs.names.len(),
        };
        let with = |hold: Hold| {
            let feedthrough = self.options.feedthrough_sensors.clone();
            let form = BlackBox { sizes, hold, feedthrough };
            let starts = markov.model(order);
            let starts: Vec<_> = starts.iter().chain(also).map(|model| form.of(model)).collect();
            self.fit(Form::BlackBox(form), &starts)
        };
        let holds = hold.map_or_else(|| self.holds(), |hold| vec![hold]);
        let all = holds.into_iter().filter_map(with);
        all.min_by(|x, y| x.criterion.total_cmp(&y.criterion))
    }

    /// The same form from its parameters elsewhere.
    pub(super) fn from(&self, other: &Candidate, effort: Effort) -> Option<Candidate> {
        let starts = std::slice::from_ref(&other.evaluation.parameters);
        Candidate::fit(other.parametrisation.clone(), &self.spectra, starts, effort)
    }

    /// Whether these records, in which sensors drift, are decisively more likely than the same without.
    pub(super) fn explains_more(&self, without: &Candidate) -> bool {
        let numbers: f64 = self.spectra.iter().map(Spectrum::real_numbers).sum();
        let drifts = (self.spectra.len() * self.records[0].channels().len()) as f64;
        let price = numbers.ln() * drifts + DECISIVE;
        without.cost_of(&self.spectra).is_some_and(|cost| cost < without.evaluation.cost - price)
    }

    /// The same form with inputs that move the other way between samples.
    fn with_other_hold(&self, found: &Candidate) -> Option<Candidate> {
        let mut parametrisation = found.parametrisation.clone();
        let hold = match &mut parametrisation.form {
            Form::BlackBox(form) => &mut form.hold,
            Form::Lateral(form) => &mut form.hold,
        };
        *hold = match *hold {
            Hold::ZeroOrder => Hold::FirstOrder,
            Hold::FirstOrder => Hold::ZeroOrder,
        };
        let start = &found.evaluation.parameters;
        Candidate::fit(parametrisation, &self.spectra, std::slice::from_ref(start), FIRST_LOOK)
    }
}

pub(super) fn hold_of(found: &Candidate) -> Hold {
    match &found.parametrisation.form {
        Form::BlackBox(form) => form.hold,
        Form::Lateral(form) => form.hold,
    }
}
