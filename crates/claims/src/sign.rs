//! Signs by algebra: what is positive by a hypothesis, and what follows from that.
//!
//! A number of these types carries the proof of its sign, which holds wherever the hypotheses of its derivation
//! do. It is taken from a hypothesis, or made of others by sums, products and quotients, by growing from zero
//! with a positive slope, or as one of two whose sum and product are positive. Nothing else makes one.

use super::letters::ring;
use super::{Checked, Derivation, Formula};
use crate::arch::thrust;
use crate::number::Field;
use crate::symbolic::{
    Fraction, Letters, Polynomial, Relations, Symbol, along_the_joint, along_the_opening,
};
use std::borrow::Borrow;
use std::ops::{Add, Div, Mul};

/// A number that is not negative, or is positive.
#[derive(Clone, Debug)]
pub(super) struct Signed<const IS_POSITIVE: bool>(Expression);

/// A number that is positive.
pub(super) type Positive = Signed<true>;
/// A number that is not negative.
pub(super) type NotNegative = Signed<false>;

/// A number, and how it was made of others.
#[derive(Clone, Debug)]
struct Expression {
    value: Fraction,
    formula: Formula,
    /// True if the text needs brackets in a product.
    is_sum: bool,
}

impl Expression {
    /// Made value of the value itself and nothing else.
    fn whole(value: &Fraction) -> Self {
        let is_sum = value.as_polynomial().is_none_or(|polynomial| polynomial.len() > 1);
        Self { value: value.clone(), formula: value.into(), is_sum }
    }

    fn factor(&self) -> Formula {
        let Formula { text, latex } = &self.formula;
        match self.is_sum {
            true => Formula { text: format!("({text})"), latex: format!("({latex})") },
            false => self.formula.clone(),
        }
    }
}

fn joined(left: Formula, between: &str, right: &Formula) -> Formula {
    let join = |left: &str, right: &str| format!("{left}{between}{right}");
    Formula { text: join(&left.text, &right.text), latex: join(&left.latex, &right.latex) }
}

impl Add<&Self> for Expression {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        let formula = joined(self.formula, " + ", &other.formula);
        Self { value: self.value + &other.value, formula, is_sum: true }
    }
}

impl Mul<&Self> for Expression {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let formula = joined(self.factor(), " ", &other.factor());
        Self { value: self.value * &other.value, formula, is_sum: false }
    }
}

impl Div<&Self> for Expression {
    type Output = Self;

    fn div(self, other: &Self) -> Self {
        let Formula { text, latex } = &other.formula;
        let below = Formula { text: format!("[{text}]"), latex: format!("[{latex}]") };
        let formula = joined(self.factor(), "/", &below);
        Self { value: self.value / &other.value, formula, is_sum: false }
    }
}

/// A variable that grows from zero: how letters change with it, and what those that do are at zero.
pub(super) struct FromZero<'a> {
    pub rules: &'a [(Symbol, Polynomial)],
    pub at_zero: &'a dyn Fn(Symbol) -> Option<i32>,
    pub relations: &'a Relations,
}

impl<const IS_POSITIVE: bool> Signed<IS_POSITIVE> {
    /// Quantities that a hypothesis says have this sign: `0 < beta < pi` of `beta` and of its sine.
    pub(super) fn given<const N: usize>(
        d: &mut Derivation,
        hypothesis: &str,
        values: [&Fraction; N],
    ) -> [Self; N] {
        d.assume(hypothesis);
        values.map(|value| Self(Expression::whole(value)))
    }
}

impl Positive {
    /// A positive integer; for zero, one.
    pub(super) fn int(n: u8) -> Self {
        Signed(Expression::whole(&Symbol::Joint.number().int(i32::from(n.max(1)))))
    }

    /// Checks that a value is what is positive already, whatever the letters.
    pub(super) fn is(
        &self,
        d: &mut Derivation,
        words: &str,
        value: impl Borrow<Fraction>,
    ) -> Checked<Self> {
        self.check(d, format!("{words}: positive"), value.borrow(), &Relations::none())
    }

    /// Checks that a value is what is positive already, where each sine and cosine are those of an angle.
    pub(super) fn is_on_circle(
        &self,
        d: &mut Derivation,
        words: &str,
        value: impl Borrow<Fraction>,
    ) -> Checked<Self> {
        self.check(d, format!("{words}: positive"), value.borrow(), &Relations::trigonometric())
    }

    fn check(
        &self,
        d: &mut Derivation,
        words: String,
        value: &Fraction,
        relations: &Relations,
    ) -> Checked<Self> {
        d.identity_as(words, value, &self.0.value, relations, self.0.formula.clone())?;
        Ok(Signed(Expression::whole(value)))
    }

    /// Checks that a value is zero at the beginning of a range and has this slope on it.
    pub(super) fn is_slope_of(
        &self,
        d: &mut Derivation,
        words: &str,
        value: &Fraction,
        range: &FromZero<'_>,
    ) -> Checked<Self> {
        let zero = value.int(0);
        let at_zero =
            |symbol: Symbol| (range.at_zero)(symbol).map_or(symbol.number(), |n| zero.int(n));
        let start = value.evaluate(&zero, at_zero);
        d.identity(format!("{words} begins with 0"), &start, &zero)?;
        let slope = value.derivative(range.rules);
        self.check(d, format!("and grows: {words} is positive"), &slope, range.relations)?;
        Ok(Signed(Expression::whole(value)))
    }

    /// Checks that two values have this product and a positive sum.
    pub(super) fn is_product_of(
        &self,
        d: &mut Derivation,
        words: &str,
        values: [&Fraction; 2],
        sum: &Self,
        relations: &Relations,
    ) -> Checked<[Self; 2]> {
        let [a, b] = values;
        self.check(d, format!("the product of {words}: positive"), &(a.clone() * b), relations)?;
        sum.check(d, "their sum: positive, so both are".to_owned(), &(a.clone() + b), relations)?;
        Ok(values.map(|value| Signed(Expression::whole(value))))
    }
}

macro_rules! operators {
    ($($left:ident $operator:ident $method:ident $right:ident = $result:ident;)*) => { $(
        impl $operator<&$right> for $left {
            type Output = $result;

            fn $method(self, right: &$right) -> $result {
                Signed(self.0.$method(&right.0))
            }
        }
    )* };
}

operators! {
    Positive Add add Positive = Positive;
    Positive Add add NotNegative = Positive;
    Positive Mul mul Positive = Positive;
    Positive Div div Positive = Positive;
    NotNegative Add add NotNegative = NotNegative;
    NotNegative Add add Positive = Positive;
    NotNegative Mul mul Positive = NotNegative;
    NotNegative Mul mul NotNegative = NotNegative;
    NotNegative Div div Positive = NotNegative;
}

/// The signs of an angle between 0 and pi.
pub(super) struct AngleSigns {
    pub rad: Positive,
    pub sin: Positive,
    /// `1 - cos`.
    pub versine: Positive,
    /// `1 + cos`.
    pub coversine: Positive,
    /// The angle less its sine.
    pub excess: Positive,
    /// The angle less sine times cosine.
    pub bow: Positive,
}

impl AngleSigns {
    /// Signs of the rotational joint.
    pub(super) fn of_joint(d: &mut Derivation) -> Checked<Self> {
        Self::of(d, "beta", [Symbol::Joint, Symbol::Sine, Symbol::Cosine], &along_the_joint())
    }

    /// Signs of the half opening.
    pub(super) fn of_half_opening(d: &mut Derivation) -> Checked<Self> {
        let letters = [Symbol::HalfOpening, Symbol::SineOfOpening, Symbol::CosineOfOpening];
        Self::of(d, "alpha", letters, &along_the_opening())
    }

    fn of(
        d: &mut Derivation,
        name: &str,
        letters: [Symbol; 3],
        rules: &[(Symbol, Polynomial)],
    ) -> Checked<Self> {
        let [rad, sin, cos] = &letters.map(Symbol::number);
        // Angle and sine begin with zero, the cosine with one.
        let at_zero = |symbol| letters.iter().position(|x| *x == symbol).map(|k| (k == 2).into());
        let range = &FromZero { rules, at_zero: &at_zero, relations: &Relations::trigonometric() };
        let [positive_rad, positive_sin] =
            Positive::given(d, &format!("0 < {name} < pi"), [rad, sin]);
        let square = positive_sin.clone() * &positive_sin;
        let [versine, coversine] = square.is_product_of(
            d,
            &format!("1 - cos({name}) and 1 + cos({name})"),
            [&(rad.int(1) - cos), &(rad.int(1) + cos)],
            &Positive::int(2),
            range.relations,
        )?;
        let words = format!("{name} - sin({name})");
        let excess = versine.is_slope_of(d, &words, &(rad.clone() - sin), range)?;
        let words = format!("{name} - sin({name}) cos({name})");
        let bow = rad.clone() - sin.clone() * cos;
        let bow = (Positive::int(2) * &square).is_slope_of(d, &words, &bow, range)?;
        Ok(Self { rad: positive_rad, sin: positive_sin, versine, coversine, excess, bow })
    }
}

/// The signs of a ring thinner than the physical limit.
pub(super) struct RingSigns {
    pub thickness: Positive,
    /// `2 - eta`.
    pub intrados: Positive,
    /// `2 + eta`.
    pub extrados: Positive,
    /// `delta_M`.
    pub flag: NotNegative,
    /// `1 - delta_M`.
    pub unflagged: NotNegative,
    /// `fac`.
    pub factor: Positive,
    /// `2 - fac`.
    pub unfactored: Positive,
}

impl RingSigns {
    pub(super) fn of(d: &mut Derivation) -> Checked<Self> {
        let ring = ring();
        let flag = Symbol::Flag.number();
        let [thickness, intrados] =
            Positive::given(d, "0 < eta < 2", [&ring.thickness, &ring.intrados()]);
        let [flag, unflagged] =
            NotNegative::given(d, "0 <= delta_M <= 1", [&flag, &(flag.int(1) - &flag)]);
        let extrados = (Positive::int(2) + &thickness).is(d, "2 + eta", ring.extrados())?;
        let square = thickness.clone() * &thickness / &Positive::int(12);
        let factor =
            (Positive::int(1) + &(flag.clone() * &square)).is(d, "fac", &ring.centroid_factor)?;
        let part = (Positive::int(8) + &(intrados.clone() * &extrados)) / &Positive::int(12);
        let rest = ring.thickness.int(2) - &ring.centroid_factor;
        // 1 - eta²/12, and what delta_M < 1 adds.
        let unfactored =
            (Positive::int(1) * &part + &(unflagged.clone() * &square)).is(d, "2 - fac", &rest)?;
        Ok(Self { thickness, intrados, extrados, flag, unflagged, factor, unfactored })
    }

    /// `2 + eta - (2 - eta) cos(beta)`, the lever arm in (2).
    pub(super) fn lever_arm(&self, d: &mut Derivation, angle: &AngleSigns) -> Checked<Positive> {
        let arm = Positive::int(2) * &angle.versine + &(self.thickness.clone() * &angle.coversine);
        let lower = thrust::lower(&Symbol::joint(), &ring());
        arm.is(d, "the lever arm in (2)", &lower.denominator)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_made_of_positive_parts_is_refused() {
        let (mut d, joint) = (Derivation::new(), Symbol::joint());
        let circle = Relations::trigonometric();
        let (rules, at_zero) = (along_the_joint(), |symbol| (symbol == Symbol::Cosine).into());
        let range = FromZero { rules: &rules, at_zero: &|s| Some(at_zero(s)), relations: &circle };
        let angle = AngleSigns::of_joint(&mut d).unwrap();
        let below = joint.sin.clone() - &joint.rad;
        assert!(angle.excess.is(&mut d, "sin(beta) - beta", &below).is_err());
        assert!(angle.versine.is_slope_of(&mut d, "sin(beta) - beta", &below, &range).is_err());
        let raised = joint.rad.clone() - &joint.sin - joint.rad.int(1);
        let words = "beta - sin(beta) - 1, which begins with -1";
        assert!(angle.versine.is_slope_of(&mut d, words, &raised, &range).is_err());
        let square = angle.sin.clone() * &angle.sin;
        let negative =
            [joint.cos.clone() - joint.cos.int(1), -joint.cos.clone() - joint.cos.int(1)];
        let [a, b] = &negative;
        let sum = &Positive::int(2);
        let words = "cos - 1 and -cos - 1";
        assert!(square.is_product_of(&mut d, words, [a, b], sum, &circle).is_err());
    }

    #[test]
    fn a_sign_shows_how_it_is_made() {
        let mut d = Derivation::new();
        let signs = RingSigns::of(&mut d).unwrap();
        let made = (signs.thickness.clone() + &Positive::int(3)) * &signs.thickness;
        let value = ring().thickness;
        let value = (value.clone() + value.int(3)) * &value;
        made.is(&mut d, "eta (eta + 3)", &value).unwrap();
        let formula = d.steps().last().unwrap().formula.clone().unwrap();
        assert_eq!(formula.text, "(eta + 3) eta");
    }
}
