//! `+`, `-`, `*` and unary `-` of polynomials, by value and by reference.

use crate::{Poly, Ring};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

fn sum<T: Ring>(a: &Poly<T>, b: &Poly<T>) -> Poly<T> {
    let (long, short) = if a.coefficients.len() >= b.coefficients.len() { (a, b) } else { (b, a) };
    let mut coefficients = long.coefficients.clone();
    for (c, d) in coefficients.iter_mut().zip(&short.coefficients) {
        *c = c.clone() + d.clone();
    }
    Poly::new(coefficients)
}

fn difference<T: Ring>(a: &Poly<T>, b: &Poly<T>) -> Poly<T> {
    let mut coefficients = a.coefficients.clone();
    for (c, d) in coefficients.iter_mut().zip(&b.coefficients) {
        *c = c.clone() - d.clone();
    }
    coefficients.extend(b.coefficients.iter().skip(a.coefficients.len()).map(|d| -d.clone()));
    Poly::new(coefficients)
}

fn product<T: Ring>(a: &Poly<T>, b: &Poly<T>) -> Poly<T> {
    if a.is_zero() || b.is_zero() {
        return Poly::zero();
    }
    let mut coefficients = vec![T::zero(); a.coefficients.len() + b.coefficients.len() - 1];
    for (i, c) in a.coefficients.iter().enumerate() {
        for (k, d) in b.coefficients.iter().enumerate() {
            coefficients[i + k] = coefficients[i + k].clone() + c.clone() * d.clone();
        }
    }
    Poly::new(coefficients)
}

macro_rules! binary {
    ($Trait:ident, $method:ident, $Assign:ident, $assign:ident, $function:ident) => {
        impl<T: Ring> $Trait<&Poly<T>> for &Poly<T> {
            type Output = Poly<T>;
            fn $method(self, other: &Poly<T>) -> Poly<T> {
                $function(self, other)
            }
        }
        impl<T: Ring> $Trait<Poly<T>> for &Poly<T> {
            type Output = Poly<T>;
            fn $method(self, other: Poly<T>) -> Poly<T> {
                $function(self, &other)
            }
        }
        impl<T: Ring> $Trait<&Poly<T>> for Poly<T> {
            type Output = Poly<T>;
            fn $method(self, other: &Poly<T>) -> Poly<T> {
                $function(&self, other)
            }
        }
        impl<T: Ring> $Trait<Poly<T>> for Poly<T> {
            type Output = Poly<T>;
            fn $method(self, other: Poly<T>) -> Poly<T> {
                $function(&self, &other)
            }
        }
        impl<T: Ring> $Assign<&Poly<T>> for Poly<T> {
            fn $assign(&mut self, other: &Poly<T>) {
                *self = $function(self, other);
            }
        }
        impl<T: Ring> $Assign<Poly<T>> for Poly<T> {
            fn $assign(&mut self, other: Poly<T>) {
                *self = $function(self, &other);
            }
        }
    };
}

binary!(Add, add, AddAssign, add_assign, sum);
binary!(Sub, sub, SubAssign, sub_assign, difference);
binary!(Mul, mul, MulAssign, mul_assign, product);

impl<T: Ring> Neg for &Poly<T> {
    type Output = Poly<T>;
    fn neg(self) -> Poly<T> {
        self.map(|c| -c.clone())
    }
}

impl<T: Ring> Neg for Poly<T> {
    type Output = Poly<T>;
    fn neg(self) -> Poly<T> {
        -&self
    }
}

impl<T: Ring> Zero for Poly<T> {
    fn zero() -> Self {
        Self::zero()
    }
    fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }
}

impl<T: Ring> One for Poly<T> {
    fn one() -> Self {
        Self::one()
    }
}

impl<T: Ring> std::iter::Sum for Poly<T> {
    fn sum<I: Iterator<Item = Self>>(iterator: I) -> Self {
        iterator.fold(Self::zero(), |a, b| a + b)
    }
}

impl<T: Ring> std::iter::Product for Poly<T> {
    fn product<I: Iterator<Item = Self>>(iterator: I) -> Self {
        iterator.fold(Self::one(), |a, b| a * b)
    }
}
