//! The decimals of a certificate: each has to be the correct rounding of everything in the small box.

use super::format::ValueFile;
use super::refusal::Refusal;
use super::visible::shortened;
use crate::arch::Configuration;
use crate::number::{Engine, Tens, Written};
use crate::problem::{Known, Problem, Quantity};

/// Decimals of a certificate, what they are compared with, and what they share.
pub(super) struct Decimals<'a, E> {
    problem: &'a Problem,
    /// Place of the root.
    at: &'a Configuration<E>,
    digits: usize,
    bits: usize,
    tens: Tens<E>,
    /// The degrees of a radian.
    radian: Option<E>,
    /// Enclosures of angles that are known by their tangents.
    angles: Vec<(Quantity, E)>,
}

impl<'a, E: Engine> Decimals<'a, E> {
    /// Decimals of a problem whose root lies in `at`, to `digits` significant digits, in numbers of `bits` bits.
    pub(super) fn new(
        problem: &'a Problem,
        at: &'a Configuration<E>,
        digits: usize,
        bits: usize,
    ) -> Self {
        Self { problem, at, digits, bits, tens: Tens::new(bits), radian: None, angles: Vec::new() }
    }

    /// The quantities with their values in one spelling, if each value is the correct rounding.
    pub(super) fn accept(mut self, file: &[ValueFile]) -> Result<Vec<(Quantity, String)>, Refusal> {
        let mut values: Vec<(Quantity, String)> = Vec::new();
        for value in file {
            let quantity = Quantity::LANDMARK
                .into_iter()
                .chain(Quantity::ASYMMETRIC)
                .find(|quantity| quantity.name() == value.quantity)
                .filter(|quantity| self.problem.has(*quantity))
                .filter(|quantity| values.iter().all(|(known, _)| known != quantity));
            let unknown = || Refusal::Quantity(shortened(&value.quantity));
            let quantity = quantity.ok_or_else(unknown)?;
            values.push((quantity, self.accept_one(quantity, value)?));
        }
        Ok(values)
    }

    fn accept_one(&mut self, quantity: Quantity, file: &ValueFile) -> Result<String, Refusal> {
        let unknown = || Refusal::Quantity(shortened(&file.quantity));
        let known = self.problem.known(quantity, self.at).ok_or_else(unknown)?;
        let refused = Refusal::Rounding(quantity.name());
        if file.value == "inf" {
            return if known.is_infinite() { Ok(file.value.clone()) } else { Err(refused) };
        }
        let decimal = || Refusal::Decimal(quantity.name());
        let written = Written::parse(&file.value).ok_or_else(decimal)?;
        let is_proved = if written.is_zero() {
            known.is_zero()
        } else {
            let bounds = written.bounds(self.digits, &mut self.tens).ok_or_else(decimal)?;
            self.value(quantity, &known, &bounds).is_some_and(|value| {
                let [low, high] = bounds;
                low.is_less_than(&value).and(value.is_less_than(&high)).is_proved()
            })
        };
        if is_proved { Ok(written.to_string()) } else { Err(refused) }
    }

    /// An enclosure of a quantity in its unit; `None` if the bounds are nowhere near.
    fn value(&mut self, quantity: Quantity, known: &Known<E>, bounds: &[E; 2]) -> Option<E> {
        let [low, high] = bounds;
        let Some(angle) = quantity.in_radians() else {
            return self.plain(quantity, known, || (low.clone() + high) / low.int(2));
        };
        let radian = self.radian.get_or_insert_with(|| low.int(180) / low.pi()).clone();
        let near = || (low.clone() + high) / (radian.int(2) * &radian);
        Some(self.plain(angle, known, near)? * &radian)
    }

    /// Decimal of a quantity that is not in degrees; an angle known by its tangent is computed from a number
    /// near it, once.
    fn plain(&mut self, quantity: Quantity, known: &Known<E>, near: impl Fn() -> E) -> Option<E> {
        if let Known::Enclosed(x) = known {
            return Some(x.clone());
        }
        if let Some((_, angle)) = self.angles.iter().find(|(angle, _)| *angle == quantity) {
            return Some(angle.clone());
        }
        let angle = known.enclosed(&near(), self.bits)?;
        self.angles.push((quantity, angle.clone()));
        Some(angle)
    }
}
