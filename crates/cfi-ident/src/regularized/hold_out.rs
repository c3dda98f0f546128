//! The choice of the penalty's weight on samples that the fit has not seen.

use super::{
    lambda::HoldOutScore, penalised::Penalised, penalty::Regularization, settings::Settings,
};
use crate::{FitError, Segment, Structure};

/// The best candidate on held-out samples, and all scores in the order of the candidates. Of equal scores the larger weight wins.
pub(crate) fn choose(
    segments: &[Segment<'_>],
    structure: &Structure,
    regularization: Regularization,
    candidates: &[f64],
    fraction: f64,
    settings: &Settings,
) -> Result<(f64, Vec<HoldOutScore>), FitError> {
    let cuts = segments.iter().map(|s| cut(s.samples(), fraction));
    let training: Vec<_> =
        segments.iter().zip(cuts.clone()).map(|(s, cut)| s.part(0, cut)).collect();
    let held_out: Vec<_> =
        segments.iter().zip(cuts).map(|(s, cut)| s.part(cut, s.samples())).collect();
    let usable = |s: &&Segment<'_>| structure.orders.equations(s.samples()) > 0;
    let held_out: Vec<_> = held_out.iter().filter(usable).collect();
    if held_out.is_empty() {
        let samples =
            segments.iter().map(|s| s.samples() - cut(s.samples(), fraction)).max().unwrap_or(0);
        let orders = structure.orders;
        return Err(FitError::TooShort { samples, orders, needed: orders.samples_needed(1) });
    }
    let penalised = Penalised::new(&training, structure)?;
    let mut scores = Vec::with_capacity(candidates.len());
    let mut failure = None;
    for lambda in candidates {
        let prediction_rms = match penalised.solve(regularization, *lambda, settings) {
            Ok(fit) => {
                let mut squares = 0.0;
                let mut number = 0;
                for segment in &held_out {
                    let residuals = fit.model.residuals(segment.input(), segment.output())?.values;
                    number += residuals.len();
                    squares += residuals.iter().map(|x| x * x).sum::<f64>();
                }
                Some((squares / number as f64).sqrt())
            }
            Err(error @ FitError::Unsolved { .. }) => {
                failure = Some(error);
                None
            }
            Err(other) => return Err(other),
        };
        scores.push(HoldOutScore { lambda: *lambda, prediction_rms });
    }
    let best = scores
        .iter()
        .filter_map(|score| score.prediction_rms.map(|rms| (rms, score.lambda)))
        .min_by(|a, b| a.0.total_cmp(&b.0).then(b.1.total_cmp(&a.1)));
    match (best, failure) {
        (Some((_, lambda)), _) => Ok((lambda, scores)),
        (None, Some(error)) => Err(error),
        (None, None) => Err(FitError::BadValue {
            what: "the number of candidates for lambda",
            value: 0.0,
            needed: "at least 1",
        }),
    }
}

/// The number of samples left for the fit.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the product is between 0 and the number of samples"
)]
fn cut(samples: usize, fraction: f64) -> usize {
    ((samples as f64 * (1.0 - fraction)).round() as usize).min(samples)
}
