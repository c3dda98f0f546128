//! Linear time-invariant systems: state space in continuous and discrete time, responses, poles, zeros, modes and transmissibilities.
