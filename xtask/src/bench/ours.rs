//! Our fits and Gram matrices, as the groups call them.

use cfi_ident::{Accumulator, ConstantTerm, Engine, Fit, FitOptions, Orders, Segment, Structure};
use hankel::{Column, Gram, Layout, Options};

use crate::TaskError;

/// The orders l, r and d of a composite model.
pub(crate) type ModelOrders = [usize; 3];

/// The paper's orders: 54 parameters.
pub(crate) const PAPER: ModelOrders = [4, 25, 25];

pub(crate) fn structure([l, r, d]: ModelOrders) -> Result<Structure, TaskError> {
    let orders = Orders::new(l, r, d).map_err(TaskError::computation("fit"))?;
    Ok(Structure::new(orders, ConstantTerm::Omitted))
}

/// The columns of the paper's regressors and the target, in two channels: pseudo input, pseudo
/// output.
pub(crate) fn cfi_layout([l, r, d]: ModelOrders) -> Result<Layout, TaskError> {
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
    /// As it comes: from the Gram matrix in doubled precision, refined on the data where that
    /// brings anything.
    Gram { threads: usize },
    /// From the Gram matrix alone: one pass over the data.
    OnePass,
    /// By Householder reflections in doubles.
    Qr,
}

pub(crate) fn fit(
    input: &[f64],
    output: &[f64],
    orders: ModelOrders,
    how: How,
) -> Result<Fit, TaskError> {
    let fault = TaskError::computation("fit");
    let segment = Segment::new(input, output).map_err(fault)?;
    let default = FitOptions::default();
    let options = match how {
        How::Gram { threads } => FitOptions { engine: Engine::Gram, threads, ..default },
        How::OnePass => FitOptions { engine: Engine::Gram, refinement_steps: 0, ..default },
        How::Qr => FitOptions { engine: Engine::Qr, ..default },
    };
    cfi_ident::fit(&[segment], &structure(orders)?, &options).map_err(fault)
}

/// A fit that is given its record in pieces.
pub(crate) fn streaming(orders: ModelOrders) -> Result<Accumulator, TaskError> {
    Accumulator::new(&structure(orders)?, &FitOptions::default())
        .map_err(TaskError::computation("fit"))
}
