//! Signs of the haunch, the half opening and the ring in the claims about arches of one rise.

use super::letters::ring;
use super::sign::{AngleSigns, FromZero, NotNegative, Positive};
use super::{Checked, Derivation};
use crate::number::Field;
use crate::symbolic::{
    Fraction, Letters, Polynomial, Relations, Symbol, along_the_joint, along_the_opening,
};

/// `n/m`.
pub(super) fn ratio(n: u8, m: u8) -> Positive {
    Positive::int(n) / &Positive::int(m)
}

/// Signs of an angle that follow from `x sin(x) > 0`.
pub(super) struct CusaSigns {
    pub angle: AngleSigns,
    /// `2 (1 - cos(x)) - x sin(x)`, so that `x cot(x/2) < 2`.
    pub below_two: Positive,
    /// `x (2 + cos(x)) - 3 sin(x)`.
    pub cusa: Positive,
}

impl CusaSigns {
    pub(super) fn of_joint(d: &mut Derivation) -> Checked<Self> {
        let letters = [Symbol::Joint, Symbol::Sine, Symbol::Cosine];
        let angle = AngleSigns::of_joint(d)?;
        Self::of(d, "beta", letters, &along_the_joint(), angle)
    }

    pub(super) fn of_half_opening(d: &mut Derivation) -> Checked<Self> {
        let letters = [Symbol::HalfOpening, Symbol::SineOfOpening, Symbol::CosineOfOpening];
        let angle = AngleSigns::of_half_opening(d)?;
        Self::of(d, "alpha", letters, &along_the_opening(), angle)
    }

    fn of(
        d: &mut Derivation,
        x: &str,
        letters: [Symbol; 3],
        rules: &[(Symbol, Polynomial)],
        angle: AngleSigns,
    ) -> Checked<Self> {
        let [rad, sin, cos] = &letters.map(Symbol::number);
        let at_zero = |symbol| letters.iter().position(|y| *y == symbol).map(|k| (k == 2).into());
        let range = &FromZero { rules, at_zero: &at_zero, relations: &Relations::none() };
        let turn = angle.rad.clone() * &angle.sin;
        let value = sin.clone() - rad.clone() * cos;
        let turn = turn.is_slope_of(d, &format!("sin({x}) - {x} cos({x})"), &value, range)?;
        let value = (rad.int(1) - cos) * rad.int(2) - rad.clone() * sin;
        let words = format!("2 (1 - cos({x})) - {x} sin({x})");
        let below_two = turn.is_slope_of(d, &words, &value, range)?;
        let value = (rad.int(2) + cos) * rad - sin.int(3) * sin;
        let words = format!("{x} (2 + cos({x})) - 3 sin({x})");
        let cusa = below_two.is_slope_of(d, &words, &value, range)?;
        Ok(Self { angle, below_two, cusa })
    }
}

/// Signs at a haunch above a right angle.
pub(super) struct HaunchSigns {
    pub signs: CusaSigns,
    pub cos: Positive,
    /// `beta sin(beta) - (1 - cos(beta))`.
    pub bulge: Positive,
    /// `1 - cos(beta) + tau cos(beta)`.
    pub arm: Positive,
}

impl HaunchSigns {
    pub(super) fn of(d: &mut Derivation, ring: &ThickRingSigns) -> Checked<Self> {
        let joint = Symbol::joint();
        let signs = CusaSigns::of_joint(d)?;
        let [cos] = Positive::given(d, "beta < pi/2", [&joint.cos]);
        let slope = signs.angle.rad.clone() * &cos;
        let value = joint.rad.clone() * &joint.sin - joint.versine();
        let words = "beta sin(beta) - (1 - cos(beta))";
        let bulge = from_the_crown(d, &slope, words, &value)?;
        let arm = signs.angle.versine.clone() + &(ring.slenderness.clone() * &cos);
        Ok(Self { signs, cos, bulge, arm })
    }
}

/// A value that is zero at the crown and grows along the arch.
pub(super) fn from_the_crown(
    d: &mut Derivation,
    slope: &Positive,
    words: &str,
    value: &Fraction,
) -> Checked<Positive> {
    let at_zero = |symbol| match symbol {
        Symbol::Joint | Symbol::Sine => Some(0),
        Symbol::Cosine => Some(1),
        _ => None,
    };
    let (rules, relations) = (along_the_joint(), Relations::none());
    let range = FromZero { rules: &rules, at_zero: &at_zero, relations: &relations };
    slope.is_slope_of(d, words, value, &range)
}

/// The signs of a ring up to the physical limit.
pub(super) struct ThickRingSigns {
    /// `tau`.
    pub slenderness: Positive,
    /// `(1 - tau)/2`.
    pub half_of_rest: NotNegative,
    /// `n`.
    pub fall: NotNegative,
    /// `1/2 - n`.
    pub half_less_fall: NotNegative,
    /// `g - 1 + tau/2`.
    pub lift: NotNegative,
}

impl ThickRingSigns {
    pub(super) fn of(d: &mut Derivation) -> Checked<Self> {
        let (ring, delta) = (ring(), Symbol::Flag.number());
        let [eta] = Positive::given(d, "0 < eta <= 2", [&ring.thickness]);
        let [intrados] = NotNegative::given(d, "eta <= 2", [&ring.intrados()]);
        let [flag, unflagged] =
            NotNegative::given(d, "0 <= delta_M <= 1", [&delta, &(delta.int(1) - &delta)]);
        let extrados = (Positive::int(2) + &eta).is(d, "2 + eta", ring.extrados())?;
        let slenderness = Positive::int(2) * &eta / &extrados;
        let growth = eta.clone() * &(Positive::int(4) + &eta);
        let fall = intrados.clone() * &(Positive::int(6) + &eta) + &(unflagged * &growth);
        let fall = fall / &Positive::int(24);
        let half_less_fall = flag.clone() * &growth / &Positive::int(24);
        let lift = flag * &(eta.clone() * &eta) / &(Positive::int(6) * &extrados);
        let half_of_rest = intrados / &(Positive::int(2) * &extrados);
        Ok(Self { slenderness, half_of_rest, fall, half_less_fall, lift })
    }
}
