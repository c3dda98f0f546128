//! The Rosenbrock system matrix: scaling, and the reduction to a system with invertible feedthrough that has the
//! same finite zeros (Emami-Naeini & Van Dooren, Automatica 18 (1982)).

use nalgebra::DMatrix;

use crate::dense::{Svd, svd};
use crate::scaling::{Balanced, balance, balance_similarity, exponent, invertible_power_of_two};
use crate::{LtiError, StateSpace, TimeDomain};

/// `[A B; C D]` scaled by powers of two.
#[derive(Debug, Clone)]
pub(crate) struct Rosenbrock {
    pub(crate) matrix: DMatrix<f64>,
    /// Frobenius norm of `matrix`.
    pub(crate) norm: f64,
    /// What the zeros of the scaled system have to be multiplied by.
    pub(crate) time_scale: f64,
    states: usize,
}

/// The regular pencil `pencil_a - x pencil_b` whose eigenvalues are the zeros, and the doubt about its size.
#[derive(Debug, Clone)]
pub(crate) struct Reduced {
    pub(crate) pencil_a: DMatrix<f64>,
    pub(crate) pencil_b: DMatrix<f64>,
    pub(crate) normal_rank: usize,
    pub(crate) smallest_kept: f64,
    pub(crate) largest_dropped: f64,
}

impl Rosenbrock {
    pub(crate) fn scaled<T: TimeDomain>(system: &StateSpace<T>) -> Self {
        let (n, m, p) = (system.order(), system.inputs(), system.outputs());
        // A by itself gives the scale of time and a first scale of the states.
        let Balanced { matrix: a, diagonal, scale: time_scale } = balance(system.a());
        let mut matrix = DMatrix::zeros(n + p, n + m);
        // x = time_scale x': the rows of the states are divided by time_scale, B with them.
        matrix.view_mut((0, n), (n, m)).copy_from(&(system.b() / time_scale));
        matrix.view_mut((n, 0), (p, n)).copy_from(system.c());
        for i in 0..n {
            matrix.row_mut(i).unscale_mut(diagonal[i]);
            matrix.column_mut(i).scale_mut(diagonal[i]);
        }
        matrix.view_mut((0, 0), (n, n)).copy_from(&a);
        matrix.view_mut((n, n), (p, m)).copy_from(system.d());
        normalise_channels(&mut matrix, n);
        // One state more stands for the outside world, so that the states are balanced against B and C too.
        let mut closed = DMatrix::zeros(n + 1, n + 1);
        closed.view_mut((0, 0), (n, n)).copy_from(&matrix.view((0, 0), (n, n)));
        for i in 0..n {
            closed[(i, n)] = matrix.view((i, n), (1, m)).norm();
            closed[(n, i)] = matrix.view((n, i), (p, 1)).norm();
        }
        let (_, diagonal) = balance_similarity(&closed);
        for i in 0..n {
            matrix.row_mut(i).unscale_mut(diagonal[i]);
            matrix.column_mut(i).scale_mut(diagonal[i]);
        }
        normalise_channels(&mut matrix, n);
        Self { norm: matrix.norm(), matrix, time_scale, states: n }
    }

    pub(crate) fn states(&self) -> usize {
        self.states
    }

    /// The reduction; `None` as tolerance stands for the rounding level.
    pub(crate) fn reduce(&self, tolerance: Option<f64>) -> Result<Reduced, LtiError> {
        let (n, rows, columns) = (self.states, self.matrix.nrows(), self.matrix.ncols());
        let tolerance = tolerance.unwrap_or(rows.max(columns) as f64 * f64::EPSILON);
        let mut ranks = Ranks {
            level: tolerance * self.norm,
            smallest_kept: f64::INFINITY,
            largest_dropped: 0.0,
        };
        let system = Blocks {
            a: self.matrix.view((0, 0), (n, n)).into_owned(),
            b: self.matrix.view((0, n), (n, columns - n)).into_owned(),
            c: self.matrix.view((n, 0), (rows - n, n)).into_owned(),
            d: self.matrix.view((n, n), (rows - n, columns - n)).into_owned(),
        };
        let full_row_rank = system.with_full_row_rank(&mut ranks)?;
        let Blocks { a, b, c, d } =
            full_row_rank.transposed().with_full_row_rank(&mut ranks)?.transposed();
        let normal_rank = d.nrows();
        if d.ncols() != normal_rank {
            return Err(LtiError::NotConverged {
                operation: "the reduction of the system matrix",
                residual: f64::NAN,
            });
        }
        // [C D] W = [0 X] with W orthogonal; the first columns of [A B] W and [I 0] W make the pencil.
        let states = a.nrows();
        let mut outputs = DMatrix::zeros(normal_rank, states + normal_rank);
        outputs.view_mut((0, 0), c.shape()).copy_from(&c);
        outputs.view_mut((0, states), d.shape()).copy_from(&d);
        let w = svd(&outputs)?.v;
        let null_space = w.columns(normal_rank, states);
        let pencil_b = null_space.rows(0, states).into_owned();
        let pencil_a = a * &pencil_b + b * null_space.rows(states, normal_rank);
        Ok(Reduced {
            pencil_a,
            pencil_b,
            normal_rank,
            smallest_kept: ranks.smallest_kept / self.norm,
            largest_dropped: if ranks.largest_dropped > 0.0 {
                ranks.largest_dropped / self.norm
            } else {
                0.0
            },
        })
    }
}

/// Columns of [B; D] and rows of [C D] to a largest entry of about 1.
fn normalise_channels(matrix: &mut DMatrix<f64>, n: usize) {
    for j in n..matrix.ncols() {
        let factor = invertible_power_of_two(exponent(matrix.column(j).amax()));
        matrix.column_mut(j).unscale_mut(factor);
    }
    for i in n..matrix.nrows() {
        let factor = invertible_power_of_two(exponent(matrix.row(i).amax()));
        matrix.row_mut(i).unscale_mut(factor);
    }
}

/// Rank decisions and how clear they were.
struct Ranks {
    level: f64,
    smallest_kept: f64,
    largest_dropped: f64,
}

impl Ranks {
    fn of(&mut self, singular_values: &[f64]) -> usize {
        let rank = singular_values.iter().filter(|&&s| s > self.level).count();
        if rank > 0 {
            self.smallest_kept = self.smallest_kept.min(singular_values[rank - 1]);
        }
        if rank < singular_values.len() {
            self.largest_dropped = self.largest_dropped.max(singular_values[rank]);
        }
        rank
    }
}

struct Blocks {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    c: DMatrix<f64>,
    d: DMatrix<f64>,
}

impl Blocks {
    fn transposed(&self) -> Self {
        Self {
            a: self.a.transpose(),
            b: self.c.transpose(),
            c: self.b.transpose(),
            d: self.d.transpose(),
        }
    }

    /// A system with the same finite zeros whose D has full row rank.
    fn with_full_row_rank(self, ranks: &mut Ranks) -> Result<Self, LtiError> {
        let Self { mut a, mut b, mut c, mut d } = self;
        loop {
            let (n, m, p) = (a.nrows(), b.ncols(), c.nrows());
            // D = U S V^T: the rows of U^T [C D] beyond the rank act on the states alone.
            let Svd { u, s, .. } = svd(&d)?;
            let rank = ranks.of(&s);
            if rank == p {
                return Ok(Self { a, b, c, d });
            }
            let rotated = u.transpose() * &c;
            let through = (u.transpose() * &d).rows(0, rank).into_owned();
            let dynamic = rotated.rows(0, rank).into_owned();
            let constraint = rotated.rows(rank, p - rank).into_owned();
            // The states that the constraint holds at zero come last.
            let Svd { s, v, .. } = svd(&constraint)?;
            let held = ranks.of(&s);
            if held == 0 {
                return Ok(Self { a, b, c: dynamic, d: through });
            }
            let free = n - held;
            let mut basis = DMatrix::zeros(n, n);
            basis.view_mut((0, 0), (n, free)).copy_from(&v.columns(held, free));
            basis.view_mut((0, free), (n, held)).copy_from(&v.columns(0, held));
            let turned_a = basis.transpose() * &a * &basis;
            let turned_b = basis.transpose() * &b;
            let turned_c = &dynamic * &basis;
            a = turned_a.view((0, 0), (free, free)).into_owned();
            b = turned_b.rows(0, free).into_owned();
            c = DMatrix::zeros(rank + held, free);
            c.view_mut((0, 0), (rank, free)).copy_from(&turned_c.columns(0, free));
            c.view_mut((rank, 0), (held, free)).copy_from(&turned_a.view((free, 0), (held, free)));
            d = DMatrix::zeros(rank + held, m);
            d.view_mut((0, 0), (rank, m)).copy_from(&through);
            d.view_mut((rank, 0), (held, m)).copy_from(&turned_b.rows(free, held));
        }
    }
}

#[cfg(test)]
mod tests;
