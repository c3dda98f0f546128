//! Least-squares identification of noncausal composite FIR/IIR models.
