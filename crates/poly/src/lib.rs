//! Polynomials, rational functions and polynomial matrices over any ring, and the multiset of roots with multiplicities.
