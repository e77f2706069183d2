//! The two ends of the curve of rotational states, where a table would need ever more nodes: series in
//! `alpha²` for small openings and in `A - A_l` about the end `l`.

use crate::arch::{Ring, SelfWeight, overturning, thrust};
use crate::number::{Angle, Surd};
use crate::solve::expansion::{about_end, by_opening};
use rug::{Float, Rational};
use std::sync::OnceLock;

/// Terms of the series: more than eight digits where they are used, and the more the nearer to the end.
const TERMS: usize = 9;

/// The series for small openings, found once: coefficients of `beta²/alpha²`, `eta/alpha⁴` and
/// `(1 - h)/alpha²` by powers of `alpha²`.
pub(super) struct Small([Vec<Rational>; 3]);

impl Small {
    pub(super) fn of(weight: SelfWeight) -> Option<&'static Self> {
        static SERIES: [OnceLock<Option<Small>>; 2] = [OnceLock::new(), OnceLock::new()];
        let series = SERIES[weight.flag() as usize].get_or_init(|| {
            let found = by_opening(weight, TERMS)?;
            Some(Self([
                found.joint_squared.coefficients(1),
                found.thickness.coefficients(2),
                (-found.thrust).coefficients(1),
            ]))
        });
        series.as_ref()
    }

    /// `beta`, `eta`, `h`.
    pub(super) fn at(&self, alpha: &Float) -> [Float; 3] {
        let square = Float::with_val(alpha.prec(), alpha.square_ref());
        let [ratio, eta, deficit] = self.scaled(&square);
        let h = 1 - deficit * &square;
        [ratio.sqrt() * alpha, eta * square.square(), h]
    }

    /// `(beta/alpha)²`, `eta/alpha⁴`, `(1 - h)/alpha²` at `alpha²`.
    pub(super) fn scaled(&self, square: &Float) -> [Float; 3] {
        let zero = Float::new(square.prec());
        self.0.each_ref().map(|coefficients| {
            coefficients.iter().rev().fold(zero.clone(), |sum, c| sum * square + c)
        })
    }
}

/// Up to this distance from `A_l` the series about the end `l` are used.
pub(super) const NEAR: f64 = 1e-3;

/// The series about the end `l`, found once: `A_l`, and the coefficients of `beta²`, `eta` and `h` by
/// powers of `A - A_l`.
pub(super) struct End {
    opening_variable: Surd,
    series: [Vec<Surd>; 3],
}

impl End {
    pub(super) fn of(weight: SelfWeight) -> Option<&'static Self> {
        static ENDS: [OnceLock<Option<End>>; 2] = [OnceLock::new(), OnceLock::new()];
        let end = ENDS[weight.flag() as usize].get_or_init(|| {
            let thickness = match weight {
                SelfWeight::Heyman => Surd::rational(1, 3),
                SelfWeight::Milankovitch => Surd::new(-6, 4, 3),
            };
            let found = about_end(weight, &thickness, TERMS)?;
            let ring = Ring::new(weight, &thickness);
            Some(Self {
                opening_variable: overturning::opening_variable(&ring).value(),
                series: [found.joint_squared, found.thickness, found.thrust]
                    .map(|series| series.coefficients(0)),
            })
        });
        end.as_ref()
    }

    /// `beta`, `eta`, `h`, if the half opening is near enough to that of `l`, and below it.
    pub(super) fn at(&self, alpha: &Float) -> Option<[Float; 3]> {
        let bits = alpha.prec();
        let number = |surd: &Surd| {
            let (rational, factor, radicand) = surd.parts();
            Float::with_val(bits, radicand).sqrt() * factor + rational
        };
        let a = thrust::opening_variable(&Angle::new(alpha.clone())).value();
        let x = a - number(&self.opening_variable);
        if x <= 0 || x >= NEAR {
            return None;
        }
        let [square, eta, h] = self.series.each_ref().map(|coefficients| {
            coefficients.iter().rev().fold(Float::new(bits), |sum, c| sum * &x + number(c))
        });
        Some([square.sqrt(), eta, h])
    }
}
