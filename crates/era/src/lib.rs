//! The eigensystem realization algorithm: Markov parameters to a state-space model, in both directions of time.
