//! The lateral equations in place of a fit in which all entries of the matrices are free: where they were asked for, or where the records do not reject them.

use super::doubt::{self, Doubt, RecordCondition};
use super::options::Options;
use super::result::ComparedForm;
use super::starts;
use super::white_noise::Fitted;
use crate::likelihood::{
    Condition, Fit, condition_test, identify_lateral, identify_lateral_unless_rejected,
    lateral_test,
};
use crate::model::Hold;
use crate::model::lateral_equations::{LateralEquations, NAMES, STATES};
use crate::output_error::Structure;
use crate::{ReconstructError, Record};

/// Records that obey the equations reject them with this probability.
const REJECTED: f64 = 0.01;
/// Where the equations were asked for, they are doubted only where chance would hardly ever look like that, and where they leave out so much.
const CONTRADICTED: f64 = 1e-4;
const LEFT_OUT: f64 = 1e-2;
/// Conditions that differ are an explanation where what they leave is no less likely than this.
const EXPLAINED: f64 = 1e-3;
/// Derivatives that hardly matter to what sensors read.
const UNIMPORTANT: [&str; 3] = ["Y_p", "Y_r", "tan(theta)"];

/// The fit that is used, and how it compares with the other form of the equations; the latter is `None` where only one was fitted.
pub(super) fn in_form(
    records: &[Record],
    options: &Options,
    found: Fitted,
) -> Result<(Fitted, Option<ComparedForm>), ReconstructError> {
    let asked = options.structure == Structure::Lateral;
    let free_order = found.fit.model.a.nrows();
    if asked && found.stage.order.asked && free_order != STATES {
        let needed = "the lateral equations have 4 states; leave the order out".to_owned();
        return Err(crate::error::option("structure", needed));
    }
    // Fewer states hold less than the equations, which would be no test of them.
    let left_open = options.structure == Structure::Automatic
        && is_possible(records, options)
        && free_order >= STATES
        && (!found.stage.order.asked || free_order == STATES);
    if !asked && !left_open {
        return Ok((found, None));
    }
    let holds = options.hold.map_or_else(|| own_first(found.fit.hold), |hold| vec![hold]);
    let lateral = if asked {
        identify_lateral(records, &found.fit, &holds)
    } else {
        identify_lateral_unless_rejected(records, &found.fit, &holds)
    };
    let lateral = match lateral {
        Err(ReconstructError::Start { .. }) if !asked => return Ok((found, None)),
        other => other?,
    };
    let p_value = lateral_test(&lateral, &found.fit);
    let mut found = found;
    if p_value < REJECTED {
        let doubt = differing_conditions(records, &lateral, &found.fit)?;
        found.doubts.splice(0..0, doubt);
    }
    let above = lateral.bayesian_criterion() - found.fit.bayesian_criterion();
    if !asked && (p_value < REJECTED || p_value.is_nan()) {
        let compared = ComparedForm { order: STATES, is_lateral: true, above, p_value };
        return Ok((found, Some(compared)));
    }
    let compared = ComparedForm { order: free_order, is_lateral: false, above: -above, p_value };
    let is_apart = |doubt: &&Doubt| matches!(doubt, Doubt::ConditionsDiffer { .. });
    let apart = found.doubts.first().filter(is_apart).cloned();
    let (stage, of_first) = if found.stage.order.order == STATES {
        // Those that the fit of the other form has settled stay so.
        let of_first = found.doubts.into_iter().filter(|doubt| matches!(doubt, Doubt::Subspace(_)));
        (found.stage, of_first.collect())
    } else {
        let stage = starts::at_order(records, options, &found.stage, STATES)?;
        let of_first = stage.doubts.clone();
        (stage, of_first)
    };
    let mut doubts =
        doubt::doubts(records, &stage.intersection, of_first, &lateral, &options.noise);
    if let Some(apart) = apart {
        doubts.insert(0, apart);
    } else if p_value < CONTRADICTED && leaves_out(&lateral) {
        let doubt = Doubt::StructureContradicted { order: free_order, p_value };
        doubts.insert(0, doubt);
    }
    Ok((Fitted { stage, fit: lateral, doubts, compared: found.compared }, Some(compared)))
}

/// A doubt where the records obey the equations with derivatives of their own, but not with the same.
fn differing_conditions(
    records: &[Record],
    lateral: &Fit,
    free: &Fit,
) -> Result<Option<Doubt>, ReconstructError> {
    let Some(test) = condition_test(records, lateral, free)? else { return Ok(None) };
    let explains = test.p_value < CONTRADICTED
        && test.p_value_of_equations > EXPLAINED
        && test.conditions.iter().any(|condition| differs(condition, free));
    let all = records.iter().zip(test.conditions).map(|(record, condition)| RecordCondition {
        record: record.name().to_owned(),
        speed_ratio: condition.speed_ratio,
        eigenvalues: condition.modes.into_iter().map(|mode| mode.continuous).collect(),
    });
    Ok(explains
        .then(|| Doubt::ConditionsDiffer { conditions: all.collect(), p_value: test.p_value }))
}

/// Whether a derivative that counts is another than in the first record, by more than a model error of that size makes it.
fn differs(condition: &Condition, free: &Fit) -> bool {
    /// Smaller differences change no mode by more than a few per cent.
    const MATTERS: f64 = 0.05;
    /// A model error of eps moves derivatives by up to ten times as much: large angles of bank make g/U smaller, for one.
    const TIMES_THE_MODEL_ERROR: f64 = 20.0;
    const STANDARD_ERRORS: f64 = 4.0;
    let error = free.model_error.map_or(0.0, |error| error.value);
    let least = MATTERS.max(TIMES_THE_MODEL_ERROR * error);
    NAMES.iter().zip(&condition.derivative_ratios).any(|(name, ratio)| {
        let off = (ratio.value - 1.0).abs();
        !UNIMPORTANT.contains(name) && off > least && off > STANDARD_ERRORS * ratio.standard_error
    })
}

/// Whether the sensors are those of the equations.
fn is_possible(records: &[Record], options: &Options) -> bool {
    let names: Vec<&str> =
        records[0].channels().iter().map(|channel| channel.name.as_str()).collect();
    options.measurement.feedthrough_sensors.is_empty()
        && LateralEquations::new(&names, 1, Hold::ZeroOrder, 1.0).is_some()
}

fn own_first(hold: Hold) -> Vec<Hold> {
    match hold {
        Hold::ZeroOrder => vec![Hold::ZeroOrder, Hold::FirstOrder],
        Hold::FirstOrder => vec![Hold::FirstOrder, Hold::ZeroOrder],
    }
}

/// Whether what the equations leave over matters.
fn leaves_out(lateral: &Fit) -> bool {
    lateral.model_error.is_none_or(|error| error.value > LEFT_OUT)
}
