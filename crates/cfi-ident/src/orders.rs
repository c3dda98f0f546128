//! Which coefficients a model has: its orders, and whether D(q) has a constant term.

use crate::FitError;

/// The orders `l`, `r` and `d` of a composite noncausal FIR/IIR model.
///
/// | field | symbol | meaning |
/// |---|---|---|
/// | `iir` | l | degree of D(q): the poles kept in the IIR factor |
/// | `causal` | r | the FIR factor reaches `r` samples into the past: h_0 .. h_r |
/// | `anticausal` | d | and `d` samples into the future: h_-d .. h_-1 |
///
/// Each may be zero. With l = 0 the model is a pure noncausal FIR, with d = 0 it is causal, with l = r = d = 0 it is a gain.
///
/// # Example
///
/// ```
/// use cfi_ident::Orders;
///
/// let orders = Orders::new(4, 25, 25)?;
/// assert_eq!((orders.iir(), orders.causal(), orders.anticausal()), (4, 25, 25));
/// assert_eq!(orders.to_string(), "l = 4, r = 25, d = 25");
/// # Ok::<(), cfi_ident::FitError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Orders {
    iir: usize,
    causal: usize,
    anticausal: usize,
}

/// More parameters than this are refused: the triangle alone would take 800 MB.
pub(crate) const MAX_PARAMETERS: usize = 10_000;

impl Orders {
    /// Orders `l` (IIR), `r` (causal) and `d` (anticausal).
    ///
    /// # Errors
    ///
    /// [`FitError::OrdersTooLarge`] if l + r + d + 1 exceeds 10 000.
    #[doc(alias = "l")]
    #[doc(alias = "r")]
    #[doc(alias = "d")]
    pub fn new(iir: usize, causal: usize, anticausal: usize) -> Result<Self, FitError> {
        let parameters = iir.saturating_add(causal).saturating_add(anticausal).saturating_add(1);
        if parameters > MAX_PARAMETERS {
            return Err(FitError::OrdersTooLarge {
                iir,
                causal,
                anticausal,
                limit: MAX_PARAMETERS,
            });
        }
        Ok(Self { iir, causal, anticausal })
    }

    /// `l`, the degree of D(q).
    pub fn iir(self) -> usize {
        self.iir
    }

    /// `r`, the causal length.
    pub fn causal(self) -> usize {
        self.causal
    }

    /// `d`, the anticausal length.
    pub fn anticausal(self) -> usize {
        self.anticausal
    }

    /// How far a model equation at step k looks ahead: `max(l, d)`.
    pub(crate) fn reach(self) -> usize {
        self.iir.max(self.anticausal)
    }

    /// Number of model equations that `samples` consecutive samples give: `samples - r - max(l, d)`, or none.
    ///
    /// ```
    /// # use cfi_ident::Orders;
    /// assert_eq!(Orders::new(4, 25, 25)?.equations(2000), 1950);
    /// # Ok::<(), cfi_ident::FitError>(())
    /// ```
    pub fn equations(self, samples: usize) -> usize {
        samples.saturating_sub(self.causal + self.reach())
    }

    /// Consecutive samples that this many model equations take, at least one of them: the counterpart of [`Orders::equations`].
    ///
    /// ```
    /// # use cfi_ident::Orders;
    /// assert_eq!(Orders::new(4, 25, 25)?.samples_needed(1950), 2000);
    /// # Ok::<(), cfi_ident::FitError>(())
    /// ```
    pub fn samples_needed(self, equations: usize) -> usize {
        equations + self.causal + self.reach()
    }
}

impl std::fmt::Display for Orders {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "l = {}, r = {}, d = {}", self.iir, self.causal, self.anticausal)
    }
}

/// Whether the denominator D(q) has a constant term `c_0`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum ConstantTerm {
    /// As the paper prints it: D(q) = q^l + c_(l-1) q^(l-1) + .. + c_1 q. One root of D is zero and does no harm: it
    /// only shifts the FIR factor by one sample. So `l` fits a transmissibility with l - 1 poles, and its parameters are unique.
    #[default]
    Omitted,
    /// D(q) = q^l + c_(l-1) q^(l-1) + .. + c_1 q + c_0: `l` poles, none of them fixed. If the transmissibility has
    /// fewer, the parameters are not unique and a noise-free fit is rank deficient.
    Included,
}

/// Orders, and the form of D(q): everything that says which coefficients a model has.
///
/// The parameters stand in the order of the vector (42): c from the lowest power, then h from the farthest future.
///
/// # Example
///
/// ```
/// use cfi_ident::{ConstantTerm, Orders, Structure};
///
/// let orders = Orders::new(3, 1, 2)?;
/// let printed = Structure::new(orders, ConstantTerm::Omitted);
/// let names: Vec<String> = printed.parameters().map(|p| p.to_string()).collect();
/// assert_eq!(names, ["c_1", "c_2", "h_-2", "h_-1", "h_0", "h_1"]);
/// # Ok::<(), cfi_ident::FitError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Structure {
    /// The orders l, r, d.
    pub orders: Orders,
    /// The form of D(q).
    pub constant_term: ConstantTerm,
}

impl Structure {
    /// Binds orders and the form of D(q).
    pub fn new(orders: Orders, constant_term: ConstantTerm) -> Self {
        Self { orders, constant_term }
    }

    /// The lowest power of q whose coefficient is unknown: 1 as printed, 0 with the constant term.
    pub(crate) fn lowest_power(self) -> usize {
        match self.constant_term {
            ConstantTerm::Omitted => 1,
            ConstantTerm::Included => 0,
        }
    }

    /// Number of unknown coefficients of D(q).
    pub fn denominator_count(self) -> usize {
        self.orders.iir.saturating_sub(self.lowest_power())
    }

    /// Number of Markov parameters h_-d .. h_r.
    pub fn markov_count(self) -> usize {
        self.orders.causal + self.orders.anticausal + 1
    }

    /// Number of all parameters.
    pub fn parameter_count(self) -> usize {
        self.denominator_count() + self.markov_count()
    }

    /// The parameters in their order.
    pub fn parameters(self) -> impl Iterator<Item = Parameter> {
        let low = self.lowest_power();
        let future = -signed(self.orders.anticausal);
        let denominator = (low..self.orders.iir).map(Parameter::Denominator);
        denominator.chain((future..=signed(self.orders.causal)).map(Parameter::Markov))
    }
}

/// The name of one parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Parameter {
    /// `c_i`, the coefficient of q^i in D(q).
    ///
    /// Source: paper eq. (43), the part `[c_1 .. c_(l-1)]` of the parameter vector.
    Denominator(usize),
    /// `h_i`, the Markov parameter of q^-i.
    ///
    /// Source: paper eq. (44), the part `[h_-d .. h_r]` of the parameter vector.
    Markov(isize),
}

impl std::fmt::Display for Parameter {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Denominator(power) => write!(f, "c_{power}"),
            Self::Markov(index) => write!(f, "h_{index}"),
        }
    }
}

/// An order or sample index as a signed number.
pub(crate) fn signed(index: usize) -> isize {
    isize::try_from(index).expect("a slice index and an order fit in isize")
}

#[cfg(test)]
mod tests;
