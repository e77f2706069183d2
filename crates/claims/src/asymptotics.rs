//! Small openings: the rotational states as series in `alpha²`.
//!
//! The solver finds the series ([`expansion`]) and starts from them; here they are put back into the
//! equations, and each residual has to vanish to the order known. That a solution **is** such a series
//! needs two slopes that are not zero (implicit functions): with `u = beta_r²`, the gap between (2) and
//! (5) has at `u = 0`, `eta = 0` the slope -4 to `eta`, so that `eta` is an analytic function of `u`; and
//! `alpha²` begins with `2 u`, so that it can be reverted.

use super::landmarks::both;
use super::{Checked, Derivation, claims};
use crate::arch::{Ring, SelfWeight, overturning, thrust};
use crate::certify::Undecided;
use crate::number::{Dual, ExactField, Field};
use crate::solve::expansion::{self, ByJoint, ByOpening};
use crate::symbolic::Series;
use rug::Rational;

claims! {
    Ours("series-heyman", "small openings", |d| small_openings(d, SelfWeight::Heyman)):
        "for Heyman's weight beta_r^2, eta and h are analytic in alpha^2 at 0 and begin with alpha^2/2, alpha^4/48 \
         and 1 - alpha^2/6";
    Ours("series-milankovitch", "small openings", |d| small_openings(d, SelfWeight::Milankovitch)):
        "for Milankovitch's weight beta_r^2, eta and h are analytic in alpha^2 at 0 and begin with alpha^2/2, \
         alpha^4/48 and 1 - alpha^2/6";
    Implicit("series-difference", "Sec. 2.1", difference):
        "the two weights differ little while the arch is thin: eta by alpha^12/1327104 and h by -alpha^8/27648, to \
         leading order";
}

/// Coefficients shown and checked.
const TERMS: usize = 9;

fn unsettled() -> Undecided {
    Undecided::new("the series for small openings do not settle")
}

/// Checks that `beta_r²`, `eta` and `h` solve (2), (5) and (4) with the given `A`, each to the order to
/// which the series are known.
pub(super) fn check_states<T: ExactField + ToString>(
    d: &mut Derivation,
    weight: SelfWeight,
    [joint_squared, thickness, thrust]: [&Series<T>; 3],
    a: &Series<T>,
) -> Checked {
    let ring = Ring::new(weight, thickness);
    let lower = thrust::lower(&expansion::joint(joint_squared), &ring);
    let tangency = thrust::tangency(&expansion::times_cotangent(joint_squared), &ring);
    let opening = overturning::opening_variable(&ring).value() + thrust;
    d.vanishes("(2), cleared", &lower.residual(thrust))?;
    d.vanishes("(5), cleared", &tangency.residual(thrust))?;
    d.vanishes("(4)", &(opening - a))
}

/// The slope of the gap between (2) and (5), cleared, to a thickness, as a series in `u = beta_r²` at the crown.
///
/// Where it is not zero at `u = 0` the thickness is an analytic function of `u`.
pub(super) fn slope_to_thickness<T: ExactField>(
    weight: SelfWeight,
    thickness: &Series<T>,
) -> Series<T> {
    let u = Series::variable(&thickness.coefficient(0), thickness.length());
    let eta = Dual::variable(thickness.clone(), 0);
    let ring = Ring::new(weight, &eta);
    let joint = expansion::joint(&u).map(Dual::constant);
    let tangency = thrust::tangency(&Dual::constant(expansion::times_cotangent(&u)), &ring);
    thrust::lower(&joint, &ring).difference(&tangency).derivative(0)
}

fn small_openings(d: &mut Derivation, weight: SelfWeight) -> Checked {
    d.assume("y = alpha^2, small");
    let ByOpening { joint_squared, thickness, thrust } =
        expansion::by_opening(weight, TERMS).ok_or_else(unsettled)?;
    d.define("beta_r^2", joint_squared.show("y"));
    d.define("eta", thickness.show("y"));
    d.define("h", thrust.show("y"));
    let zero = Rational::new();
    let a = expansion::opening_variable(&Series::variable(&zero, joint_squared.length()));
    check_states(d, weight, [&joint_squared, &thickness, &thrust], &a)?;

    // The two slopes that make them functions.
    let slope = slope_to_thickness(weight, &Series::new(&zero, vec![zero.clone()], 2));
    let words = "the slope of (2) - (5), cleared, to eta at 0";
    d.equal(words, &slope.coefficient(0), &Rational::from(-4))?;
    let ByJoint { opening_variable, .. } =
        expansion::by_joint(weight, &zero, 3).ok_or_else(unsettled)?;
    let by_opening = expansion::opening_variable(&Series::variable(&zero, 3)).coefficient(1);
    let slope = opening_variable.coefficient(1) / by_opening;
    d.equal("d alpha^2/du at 0", &slope, &Rational::from(2))?;
    let drop = thrust.clone() - thrust.int(1);
    for (name, series, power, leading) in [
        ("beta_r^2", &joint_squared, 1, (1, 2)),
        ("eta", &thickness, 2, (1, 48)),
        ("h - 1", &drop, 1, (-1, 6)),
    ] {
        begins_with(d, name, series, power, leading)?;
    }
    Ok(())
}

fn difference(d: &mut Derivation) -> Checked {
    d.assume("y = alpha^2, small");
    let series = |weight| expansion::by_opening(weight, TERMS).ok_or_else(unsettled);
    let [heyman, milankovitch] = both(series)?;
    let thickness = milankovitch.thickness - heyman.thickness;
    let thrust = milankovitch.thrust - heyman.thrust;
    d.define("eta of Milankovitch's weight less that of Heyman's", thickness.show("y"));
    d.define("h of Milankovitch's weight less that of Heyman's", thrust.show("y"));
    for (name, series, power, leading) in
        [("of eta", &thickness, 6, (1, 1_327_104)), ("of h", &thrust, 4, (-1, 27_648))]
    {
        begins_with(d, name, series, power, leading)?;
    }
    Ok(())
}

/// Checks the power and the factor with which a series in `y` begins.
fn begins_with(
    d: &mut Derivation,
    name: &str,
    series: &Series<Rational>,
    power: i32,
    leading: (i32, i32),
) -> Checked {
    let found = Rational::from(series.valuation());
    d.equal(format!("{name}: the first power of y"), &found, &Rational::from(power))?;
    let found = series.coefficient(power);
    d.equal(format!("{name}: the factor of y^{power}"), &found, &Rational::from(leading))
}
