//! Where the searches start: signal subspaces for levels as estimated and for equal parts of every sensor, each with three numbers of block rows.

use hankel::{Sharing, in_order};

use crate::model::record::deviation;
use crate::reconstruction::options::Options;
use crate::subspace::Intersection;
use crate::{NoiseModel, ReconstructError, Record, SharedModel, subspace};

/// Which number of block rows comes close differs from record to record.
const PARTS_OF_THE_RULE: [(usize, usize); 3] = [(1, 1), (3, 4), (3, 8)];

/// The noise may have this part of each sensor's root mean square.
const LEVEL: f64 = 1e-2;

/// Signal subspaces for levels as estimated and for equal parts of every sensor, each with three numbers of block rows. Only the ratios of the levels
/// matter to a signal subspace.
pub(super) struct Subspaces<'a>(Vec<subspace::Whitened<'a>>);

/// The options of these subspaces, of the levels and the block rows that the first stage has.
pub(super) fn subspace_options(
    records: &[Record],
    options: &Options,
    first: &Intersection,
) -> Vec<subspace::Options> {
    let own = options.subspace();
    let estimated = first.noise.deviations.clone();
    let equal = (0..estimated.len()).map(|sensor| LEVEL * deviation(records, sensor)).collect();
    let shares = match own.block_rows {
        Some(_) => &PARTS_OF_THE_RULE[..1],
        None => &PARTS_OF_THE_RULE[..],
    };
    let with = |levels: &Vec<f64>, (part, of): (usize, usize)| subspace::Options {
        noise: NoiseModel::Levels(levels.clone()),
        block_rows: Some(first.block_rows * part / of),
        ..own.clone()
    };
    [estimated, equal]
        .iter()
        .flat_map(|levels| shares.iter().map(move |&share| with(levels, share)))
        .collect()
}

impl<'a> Subspaces<'a> {
    pub(super) fn new(
        records: &'a [Record],
        all: &'a [subspace::Options],
        threads: usize,
    ) -> Result<Self, ReconstructError> {
        let (mut found, mut error) = (Vec::with_capacity(all.len()), None);
        let all: Vec<&'a subspace::Options> = all.iter().collect();
        in_order(
            &all,
            Sharing { threads, least: 1 },
            |all| all.iter().map(|options| subspace::Whitened::new(records, options)).collect(),
            |whitened| match whitened {
                Ok(whitened) => found.push(whitened),
                Err(other) => error = Some(other),
            },
        );
        match error {
            Some(error) if found.is_empty() => Err(error),
            _ => Ok(Self(found)),
        }
    }

    pub(super) fn starts(&self, order: usize, threads: usize) -> Vec<SharedModel> {
        let mut starts = Vec::with_capacity(self.0.len());
        in_order(
            &self.0,
            Sharing { threads, least: 1 },
            |all| all.iter().map(|subspaces| subspaces.model(order)).collect(),
            |model| starts.extend(model),
        );
        starts
    }
}
