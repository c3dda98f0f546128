//! Lateral aircraft dynamics: the linear model from stability derivatives, a catalog, and the names of the modes.
