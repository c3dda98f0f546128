//! The Newton polygon: how large the roots are, read off the moduli of the coefficients.
//!
//! The upper convex hull of the points `(k, log2 |c_k|)`. Each edge from `k` to `m` announces `m - k` roots
//! of modulus about 2^-slope (Bini 1996, Numerical Algorithms 13).

#[cfg(test)]
mod tests;

/// The upper convex hull of `(k, log2 |c_k|)`.
#[derive(Debug, Clone)]
pub(crate) struct NewtonPolygon {
    /// Degree and height of each corner, degrees ascending.
    corners: Vec<(usize, f64)>,
}

/// One edge of the polygon.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    /// Number of roots that belong to it.
    pub(crate) roots: usize,
    /// Binary logarithm of their modulus.
    pub(crate) log2_modulus: f64,
}

impl NewtonPolygon {
    /// From the binary logarithms of the moduli; zeros are minus infinity. First and last must be finite.
    pub(crate) fn new(heights: &[f64]) -> Self {
        let mut corners: Vec<(usize, f64)> = Vec::new();
        for (k, &height) in heights.iter().enumerate() {
            if height == f64::NEG_INFINITY {
                continue;
            }
            while let [.., a, b] = corners[..] {
                // b lies on or below the line from a to the new point.
                let to_b = (b.1 - a.1) * (k - a.0) as f64;
                let to_new = (height - a.1) * (b.0 - a.0) as f64;
                if to_b > to_new {
                    break;
                }
                corners.pop();
            }
            corners.push((k, height));
        }
        Self { corners }
    }

    /// The edges, moduli ascending.
    pub(crate) fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.corners.windows(2).map(|pair| {
            let roots = pair[1].0 - pair[0].0;
            Edge { roots, log2_modulus: (pair[0].1 - pair[1].1) / roots as f64 }
        })
    }

    /// The height of the hull above degree `k`, for `k` up to the degree.
    pub(crate) fn height(&self, k: usize) -> f64 {
        let after = self.corners.partition_point(|corner| corner.0 < k);
        match (after.checked_sub(1).map(|i| self.corners[i]), self.corners.get(after)) {
            (_, Some(&(degree, height))) if degree == k => height,
            (Some(a), Some(&b)) => a.1 + (b.1 - a.1) * (k - a.0) as f64 / (b.0 - a.0) as f64,
            _ => f64::NEG_INFINITY,
        }
    }
}
