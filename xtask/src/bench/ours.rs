//! Our fits and Gram matrices, as the groups call them.

use cfi_ident::{ConstantTerm, Fit, FitOptions, Orders, Segment, Structure};
use hankel::{Column, Gram, Layout, Options};

use crate::TaskError;

/// The orders l, r and d of a composite model.
pub(crate) type LRD = [usize; 3];

/// The paper's orders: 54 parameters.
pub(crate) const PAPER: LRD = [4, 25, 25];

pub(crate) fn structure([l, r, d]: LRD) -> Result<Structure, TaskError> {
    let orders = Orders::new(l, r, d).map_err(TaskError::computation("fit"))?;
    Ok(Structure::new(orders, ConstantTerm::Omitted))
}

/// The columns of the paper's regressors and the target, in two channels: pseudo input, pseudo output.
pub(crate) fn cfi_layout([l, r, d]: LRD) -> Result<Layout, TaskError> {
    let lag = |n: usize| isize::try_from(n).map_err(TaskError::computation("layout"));
    let mut columns = Vec::new();
    for i in 1..l {
        columns.push(Column { channel: 1, lag: lag(i)? });
    }
    for i in -lag(d)?..=lag(r)? {
        columns.push(Column { channel: 0, lag: -i });
    }
    columns.push(Column { channel: 1, lag: lag(l)? });
    Layout::new(2, columns).map_err(TaskError::computation("layout"))
}

pub(crate) fn block_hankel(channels: usize, block_rows: usize) -> Result<Layout, TaskError> {
    Layout::block_hankel(channels, block_rows).map_err(TaskError::computation("layout"))
}

pub(crate) fn gram(layout: &Layout, record: &[&[f64]], threads: usize) -> Result<Gram, TaskError> {
    let options = Options { threads, ..Options::default() };
    hankel::gram(layout, record, &options).map_err(TaskError::computation("Gram matrix"))
}

/// How a fit is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum How {
    /// From the Gram matrix in doubled precision.
    Gram { threads: usize },
    /// By Householder reflections, then refined against the data.
    RefinedQr,
    /// By Householder reflections alone.
    PlainQr,
}

pub(crate) fn fit(input: &[f64], output: &[f64], orders: LRD, how: How) -> Result<Fit, TaskError> {
    let fault = TaskError::computation("fit");
    let segment = Segment::new(input, output).map_err(fault)?;
    let default = FitOptions::default();
    let options = match how {
        How::Gram { threads } => {
            let _ = threads;
            FitOptions { refinement_steps: 2, ..default }
        }
        How::RefinedQr => FitOptions { refinement_steps: 4, ..default },
        How::PlainQr => FitOptions { refinement_steps: 0, ..default },
    };
    cfi_ident::fit(&[segment], &structure(orders)?, &options).map_err(fault)
}

pub(crate) struct Stream {
    x: Vec<f64>,
    y: Vec<f64>,
    orders: LRD,
}
pub(crate) fn stream(orders: LRD) -> Result<Stream, TaskError> {
    Ok(Stream { x: vec![], y: vec![], orders })
}
impl Stream {
    pub(crate) fn push(&mut self, x: &[f64], y: &[f64]) -> Result<(), TaskError> {
        self.x.extend(x);
        self.y.extend(y);
        Ok(())
    }
    pub(crate) fn finish(self) -> Result<Fit, TaskError> {
        fit(&self.x, &self.y, self.orders, How::PlainQr)
    }
}
