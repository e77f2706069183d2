//! The equations of the paper by their numbers: what each needs, and its values.

use super::at_joint::{AtJoint, JointEquation};
use super::evaluated::{EquationValue, Evaluated};
use crate::arch::closed_form::ClosedForm;
use crate::arch::{Quotient, Ring, SelfWeight, overturning, sliding, thrust};
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Field, Real, bits_of, worded};
use crate::problem::Quantity::{self, self as Q};
use crate::prover::figure::Figured;
use crate::prover::{Error, Refused, Undecided, raise};
use crate::symbolic::Known;

/// Number of an equation, and at what it is evaluated.
#[derive(Clone, Copy)]
struct Row {
    number: u8,
    /// Quantities that have to be given: all of one choice.
    choices: &'static [&'static [Quantity]],
    /// The one self-weight that it is for, and the limits of what is given.
    only: Option<(SelfWeight, [&'static str; 2])>,
}

const fn row(number: u8, choices: &'static [&'static [Quantity]]) -> Row {
    Row { number, choices, only: None }
}

/// A row of the thickness of purely overturning states.
const fn overturning(number: u8, weight: SelfWeight, least: &'static str) -> Row {
    Row { only: Some((weight, [least, "1"])), ..row(number, &[&[Q::OpeningVariable]]) }
}

worded! {
    /// An equation of the paper that is evaluated at given values: (7)–(12) at a rotational joint, the others to
    /// values.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum NumberedEquation {
        /// (2), `h_L`.
        LowerThrust = row(2, &[&[Q::RotationJoint, Q::Thickness]]),
        /// (3), `h_U`.
        UpperThrust = row(3, &[&[Q::HalfOpening, Q::RotationJoint, Q::Thickness]]),
        /// (4), `A` and `h_2`.
        WholeThrust = row(4, &[&[Q::HalfOpening, Q::Thickness], &[Q::OpeningVariable, Q::Thickness]]),
        /// (5), `h_e`.
        Tangency = row(5, &[&[Q::RotationJoint, Q::Thickness]]),
        /// (6), `fac_M`.
        CentroidFactor = row(6, &[&[Q::Thickness]]),
        /// (7), the cubics in `A`, `eta` and `h`.
        Cubics = row(7, &[&[Q::RotationJoint]]),
        /// (8), the link of the abbreviations `f`, `g`, `S`, `C` and `beta`.
        Link = row(8, &[&[Q::RotationJoint]]),
        /// (9), the closed form of `A`.
        OpeningVariable = row(9, &[&[Q::RotationJoint]]),
        /// (10), the closed form of `eta`.
        Thickness = row(10, &[&[Q::RotationJoint]]),
        /// (11), the closed form of `h`.
        Thrust = row(11, &[&[Q::RotationJoint]]),
        /// (12), the radicand of the square root in (9)–(11).
        Radicand = row(12, &[&[Q::RotationJoint]]),
        /// (13), `A` of purely overturning states.
        OverturningVariable = row(13, &[&[Q::Thickness]]),
        /// (14), the thickness of a purely overturning state, Heyman's weight.
        OverturningHeyman = overturning(14, SelfWeight::Heyman, "1/2"),
        /// (15), the thickness of a purely overturning state, Milankovitch's weight.
        OverturningMilankovitch = overturning(15, SelfWeight::Milankovitch, "2/3"),
        /// (16) as corrected: `2 - eta - fac_M`, and the thickness at which it is zero.
        EndOfRotation = row(16, &[&[Q::Thickness]]),
        /// (17), the friction that the shoulder asks for.
        ShoulderSliding = row(17, &[&[Q::HalfOpening, Q::Thrust]]),
        /// (18), the steepest joint and the friction that it asks for.
        InnerSliding = row(18, &[&[Q::Thrust]]),
    }
    /// All of them, in the order of their numbers.
    pub const ALL;
    fn row -> Row;
}

/// Bits beyond the digits asked for, at the first attempt.
const GUARD: u32 = 48;
/// Powers of a small value that the equations lose to cancellation, at the most: a start only.
const POWERS_LOST: u32 = 12;

/// Name and symbol of a value, and the value.
type Named = (&'static str, &'static str, Known);

impl NumberedEquation {
    /// Equation of a number, with its brackets or without.
    pub fn named(text: &str) -> Option<Self> {
        let number: u8 = text.trim().trim_start_matches('(').trim_end_matches(')').parse().ok()?;
        Self::ALL.into_iter().find(|equation| equation.number() == number)
    }

    /// Number of the equation in the paper.
    pub fn number(self) -> u8 {
        self.row().number
    }

    /// Quantities that have to be given: all of one choice.
    pub fn choices(self) -> &'static [&'static [Quantity]] {
        self.row().choices
    }

    /// The equation at a rotational joint, if it is one.
    fn at_joint(self) -> Option<JointEquation> {
        Some(match self {
            Self::Cubics => JointEquation::Cubics,
            Self::Link => JointEquation::Link,
            Self::OpeningVariable => JointEquation::Closed(ClosedForm::OpeningVariable),
            Self::Thickness => JointEquation::Closed(ClosedForm::Thickness),
            Self::Thrust => JointEquation::Closed(ClosedForm::Thrust),
            Self::Radicand => JointEquation::Radicand,
            _ => return None,
        })
    }

    /// Checks what is given, and that the equation is for the self-weight.
    fn check(self, weight: SelfWeight, given: &[(Quantity, ExactNumber)]) -> Result<(), Refused> {
        let Row { number: equation, choices, only } = self.row();
        let holds_all = |choice: &&&[Quantity]| given.iter().all(|(of, _)| choice.contains(of));
        let needs = choices.iter().find(holds_all).map_or(choices[0], |choice| choice);
        for (quantity, value) in given {
            Refused::quantity(*quantity, needs)?;
            Refused::value_of(*quantity, value)?;
        }
        if let Some(&missing) =
            needs.iter().find(|needed| given.iter().all(|(of, _)| of != *needed))
        {
            return Err(Refused::Missing { missing, needed: needs.to_vec() });
        }
        match only {
            Some((own, limits)) if own == weight => {
                given.iter().try_for_each(|(of, value)| Refused::from_to(*of, value, limits))
            }
            Some(_) => Err(Refused::OtherWeight { equation, weight }),
            None => match (self.at_joint(), weight) {
                (Some(JointEquation::Closed(_)), SelfWeight::Heyman) => {
                    Err(Refused::ClosedFormOfHeyman)
                }
                _ => Ok(()),
            },
        }
    }

    /// Values in so many bits; none of an equation at a joint.
    fn values(
        self,
        weight: SelfWeight,
        given: &[(Quantity, ExactNumber)],
        bits: u32,
    ) -> Option<Vec<Named>> {
        let of = |of| given.iter().find(|given| given.0 == of).map(|given| &given.1);
        let at = |quantity| Some(Known::new(of(quantity)?, bits));
        let angle = |quantity| Some(Known::angle(of(quantity)?, bits));
        let ring = || Some(Ring::new(weight, &at(Q::Thickness)?));
        Some(match self {
            Self::LowerThrust => {
                vec![("thrust", "h_L", thrust::lower(&angle(Q::RotationJoint)?, &ring()?).value())]
            }
            Self::UpperThrust => {
                let (alpha, beta) = (angle(Q::HalfOpening)?, angle(Q::RotationJoint)?);
                vec![("thrust", "h_U", thrust::upper(&alpha, &beta, &ring()?).value())]
            }
            Self::WholeThrust => {
                let ring = ring()?;
                let opening = match at(Q::OpeningVariable) {
                    Some(a) => Quotient { denominator: a.int(1), numerator: a },
                    None => thrust::opening_variable(&angle(Q::HalfOpening)?),
                };
                let whole = thrust::whole_through(&opening, &ring).value();
                vec![("A", "alpha cot(alpha/2)", opening.value()), ("thrust", "h_2", whole)]
            }
            Self::Tangency => {
                let joint = angle(Q::RotationJoint)?.times_cotangent();
                vec![("thrust", "h_e", thrust::tangency(&joint, &ring()?).value())]
            }
            Self::CentroidFactor => vec![("centroid_factor", "fac_M", ring()?.centroid_factor)],
            Self::OverturningVariable => {
                let opening = overturning::opening_variable(&ring()?).value();
                vec![("A", "alpha cot(alpha/2)", opening)]
            }
            Self::OverturningHeyman | Self::OverturningMilankovitch => {
                let eta = overturning::thickness(weight, &at(Q::OpeningVariable)?);
                vec![("thickness", "eta", eta)]
            }
            Self::EndOfRotation => {
                let ring = ring()?;
                let root = ring.thickness.int(3).sqrt();
                let end = overturning::thickness_at_end(weight, &root);
                let residual = overturning::end_of_rotation(&ring);
                vec![("residual", "2 - eta - fac_M", residual), ("thickness_at_end", "eta_l", end)]
            }
            Self::ShoulderSliding => {
                let mu = sliding::shoulder(&angle(Q::HalfOpening)?, &at(Q::Thrust)?).value();
                vec![("friction", "mu_ss", mu)]
            }
            Self::InnerSliding => {
                let h = at(Q::Thrust)?;
                let joint = Angle::new(sliding::steepest_joint(&h));
                let mu = sliding::inner(&joint, &h).value();
                vec![("sliding_joint", "beta_s, rad", joint.rad), ("friction", "mu_is", mu)]
            }
            _ => return None,
        })
    }

    /// Evaluates the equation at exact values, every figure to `digits` significant digits.
    ///
    /// Refused: what the equation does not need, or needs and has not; a value out of its range; a pole; an equation of
    /// the other weight, as the closed forms are for Heyman's; a closed form at a joint beyond the widest one, where
    /// its values are not real. Where the sign of (12) stays open, the roots of (7) do, and the closed forms.
    ///
    /// ```
    /// use couplet_prove::prelude::*;
    /// use couplet_prove::certify::equation::{Evaluated, NumberedEquation};
    /// let given = [(Quantity::RotationJoint, "1.0".parse()?)];
    /// let found = NumberedEquation::Thickness.evaluate(SelfWeight::Milankovitch, &given, 12)?;
    /// let Evaluated::Closed(_, branches) = found else { panic!() };
    /// assert_eq!(branches[0].printed.to_string(), "0.142745381947");
    /// let given = [(Quantity::Thickness, "0.6".parse()?)];
    /// let found = NumberedEquation::CentroidFactor.evaluate(SelfWeight::Milankovitch, &given, 5)?;
    /// let Evaluated::Values(values) = found else { panic!() };
    /// assert_eq!(values[0].figure.to_string(), "1.03");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn evaluate(
        self,
        weight: SelfWeight,
        given: &[(Quantity, ExactNumber)],
        digits: usize,
    ) -> Result<Evaluated, Error> {
        Refused::digits(digits)?;
        self.check(weight, given)?;
        let size = |(_, value): &(Quantity, ExactNumber)| {
            value.enclosure::<Ball>(64).mid().get_exp().unwrap_or(0).min(0).unsigned_abs()
        };
        let small = given.iter().map(size).max().unwrap_or(0);
        let first = bits_of(digits) + GUARD + POWERS_LOST * small;
        if let Some(equation) = self.at_joint() {
            return AtJoint::evaluate(equation, weight, &given[0].1, digits, first);
        }
        let values = self.values(weight, given, first).unwrap_or_default();
        // What is exactly zero is so whatever the bits.
        if values.iter().any(|(.., x)| matches!(x, Known::Undefined(_))) {
            return Err(Refused::DividesByZero { equation: self.number() }.into());
        }
        let found = raise(first, |bits| {
            let values = self.values(weight, given, bits).unwrap_or_default();
            if values.iter().any(|(.., x)| !x.ball().is_bounded()) {
                return Err(Undecided::new("whether a divisor is zero"));
            }
            let shown = |(name, symbol, x): Named| {
                Some(EquationValue { name, symbol, figure: x.figure(digits)? })
            };
            Ok(values.into_iter().map(shown).collect())
        });
        Ok(Evaluated::Values(found?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certify::state::{Certify, Digits};
    use crate::problem::Arch;
    use crate::prover::Figure;

    fn of(
        number: u8,
        weight: SelfWeight,
        given: &[(Quantity, String)],
    ) -> Result<Vec<EquationValue>, Error> {
        let equation = NumberedEquation::named(&number.to_string()).unwrap();
        let read = |(of, text): &(Quantity, String)| (*of, text.parse().unwrap());
        let given: Vec<(Quantity, ExactNumber)> = given.iter().map(read).collect();
        match equation.evaluate(weight, &given, 30)? {
            Evaluated::Values(values) => Ok(values),
            other => panic!("{other:?}"),
        }
    }

    fn state(arch: [&str; 3]) -> (SelfWeight, Digits) {
        let arch = Arch::parse(arch[0], arch[1], arch[2]).unwrap();
        (arch.weight(), arch.least(40).unwrap())
    }

    fn is_near(x: &EquationValue, y: &Figure) -> bool {
        let error = x.figure.decimal.value.to_rational() - y.decimal.value.to_rational();
        error.to_f64().abs() < 1e-28
    }

    /// At a certified state each equation of its mode gives the thrust, or the friction.
    #[test]
    fn each_equation_gives_what_a_certified_state_has() {
        for weight in ["heyman", "milankovitch"] {
            let (weight, found) = state([weight, "80deg", "0.6"]);
            let (beta, eta) = (found.rotation_joint.to_string(), found.thickness.to_string());
            let alpha = (Q::HalfOpening, "80deg".to_owned());
            let (beta, eta) = ((Q::RotationJoint, beta), (Q::Thickness, eta));
            let cases = [
                (2, vec![beta.clone(), eta.clone()]),
                (3, vec![alpha.clone(), beta.clone(), eta.clone()]),
                (4, vec![alpha.clone(), eta.clone()]),
                (5, vec![beta, eta]),
            ];
            for (number, given) in cases {
                let value = of(number, weight, &given).unwrap();
                assert!(is_near(value.last().unwrap(), &found.thrust), "({number})");
                let spoiled = (Q::Thickness, "0.07".to_owned());
                let given: Vec<_> =
                    given.into_iter().filter(|(of, _)| *of != Q::Thickness).collect();
                let other = of(number, weight, &[given, vec![spoiled]].concat()).unwrap();
                assert!(!is_near(other.last().unwrap(), &found.thrust), "false twin");
            }
        }
        let (weight, found) = state(["heyman", "80deg", "0.29"]);
        let given = [(Q::HalfOpening, "80deg".into()), (Q::Thrust, found.thrust.to_string())];
        let mu = of(17, weight, &given).unwrap()[0].figure.double;
        assert!((mu - 0.29).abs() < 1e-15);
        let (weight, found) = state(["milankovitch", "2.45", "1.35"]);
        let value = of(18, weight, &[(Q::Thrust, found.thrust.to_string())]).unwrap();
        assert!(is_near(&value[0], found.sliding_joint.as_ref().unwrap()));
        assert!((value[1].figure.double - 1.35).abs() < 1e-15);
    }

    #[test]
    fn overturning_has_one_thickness_for_each_opening_variable() {
        for (number, weight, a) in
            [(14, SelfWeight::Heyman, "0.6"), (15, SelfWeight::Milankovitch, "0.68")]
        {
            let eta = of(number, weight, &[(Q::OpeningVariable, a.into())]).unwrap();
            let back = of(13, weight, &[(Q::Thickness, eta[0].figure.to_string())]).unwrap();
            assert!(
                (back[0].figure.double - a.parse::<f64>().unwrap()).abs() < 1e-15,
                "({number})"
            );
        }
        let end = of(16, SelfWeight::Heyman, &[(Q::Thickness, "1".into())]).unwrap();
        assert_eq!(end[0].figure.to_string(), "0");
        let end = of(16, SelfWeight::Milankovitch, &[(Q::Thickness, "1".into())]).unwrap();
        assert!(end[0].figure.double < 0.0 && (end[1].figure.double - 0.928_203).abs() < 1e-6);
    }

    #[test]
    fn what_is_given_fits_the_equation() {
        let thickness = |text: &str| (Q::Thickness, text.to_owned());
        let opening = |text: &str| (Q::OpeningVariable, text.to_owned());
        for (number, weight, given, words) in [
            (2, SelfWeight::Heyman, vec![thickness("0.1")], "rotation_joint is missing"),
            (6, SelfWeight::Heyman, vec![opening("0.7")], "the quantities are thickness"),
            (4, SelfWeight::Heyman, vec![opening("0.7")], "the equation needs A, thickness"),
            (4, SelfWeight::Heyman, vec![thickness("0.1")], "half_opening is missing"),
            (6, SelfWeight::Heyman, vec![thickness("2.1")], "not between 0 and 2"),
            (14, SelfWeight::Heyman, vec![opening("1.2")], "A = 1.2 is not between 1/2 and 1"),
            (15, SelfWeight::Milankovitch, vec![opening("0.6")], "not between 2/3 and 1"),
            (15, SelfWeight::Heyman, vec![opening("0.7")], "(15) is not for heyman"),
            (14, SelfWeight::Milankovitch, vec![opening("0.7")], "(14) is not for milankovitch"),
        ] {
            let error = of(number, weight, &given).unwrap_err();
            assert!(
                matches!(error, Error::Refused(_)) && error.to_string().contains(words),
                "{error}"
            );
        }
        let given = [(Q::RotationJoint, "1".to_owned()), thickness("2")];
        let error = of(5, SelfWeight::Heyman, &given).unwrap_err().to_string();
        assert_eq!(error, "(5) has no value there: what it divides by is exactly zero");
        let near = [(Q::RotationJoint, "1".to_owned()), thickness("1.999999999999999999999")];
        assert!(of(5, SelfWeight::Heyman, &near).is_ok(), "false twin");
    }
}
