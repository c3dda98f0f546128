//! A fit and the record that it comes from.

use std::path::Path;

use cfi_ident::{Fit, Parameter};
use poly::{MrootsOptions, Poly, Root, mroots};

use crate::records::LoadWarning;

/// What one run found.
#[derive(Debug)]
pub(super) struct FitOutcome {
    /// The file's name without its folder.
    pub(super) file: String,
    /// What kind of file it is, for other programs.
    pub(super) format: &'static str,
    pub(super) passes: Passes,
    pub(super) input: String,
    pub(super) output: String,
    /// Where the file says it.
    pub(super) sample_period_s: Option<f64>,
    pub(super) samples: u64,
    /// Samples that are a gap.
    pub(super) missing: u64,
    /// Stretches between gaps.
    pub(super) segments: usize,
    pub(super) fit: Fit,
    /// The roots of D in z, or why they are not known.
    pub(super) poles: Result<Vec<Root>, String>,
    /// What was done to the file.
    pub(super) notes: Vec<LoadWarning>,
}

/// How often the record was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Passes {
    One,
    Several,
}

/// One parameter of the model.
#[derive(Clone, Copy, Debug)]
pub(super) struct Estimate {
    pub(super) parameter: Parameter,
    pub(super) value: f64,
    /// Standard deviation; `None` where the equations say nothing about it.
    pub(super) deviation: Option<f64>,
    /// Whether the record determines it.
    pub(super) identifiable: bool,
}

impl FitOutcome {
    /// All parameters in the order of the model.
    pub(super) fn estimates(&self) -> Vec<Estimate> {
        let fit = &self.fit;
        let open = fit.unidentifiable.as_ref().map_or(&[][..], |open| &open.parameters);
        let estimate = |(index, (parameter, value))| {
            let identifiable = !open.contains(&parameter);
            let known = identifiable && fit.degrees_of_freedom > 0;
            let deviation = || fit.parameter_covariance[(index, index)].max(0.0).sqrt();
            Estimate { parameter, value, deviation: known.then(deviation), identifiable }
        };
        let theta = fit.model.theta();
        fit.model.structure().parameters().zip(theta).enumerate().map(estimate).collect()
    }
}

/// The roots of D(q) in z.
pub(super) fn poles(fit: &Fit) -> Result<Vec<Root>, String> {
    mroots(&Poly::new(fit.model.denominator()), &MrootsOptions::default())
        .map(|found| found.roots)
        .map_err(|error| error.to_string())
}

/// The file's name without its folder.
pub(super) fn short_name(file: &Path) -> String {
    file.file_name().unwrap_or(file.as_os_str()).to_string_lossy().into_owned()
}
