//! Reconstruction of a system from sensor records alone, through pairs of transmissibilities.
