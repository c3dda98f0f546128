//! From sensor records to named modes: the program.
