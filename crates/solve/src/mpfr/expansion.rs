//! The purely rotational states as power series: for small openings, and about their end `l`.
//!
//! (2) and (5) see the joint only through `beta sin(beta)`, `cos(beta)` and `beta cot(beta)`, analytic
//! functions of `u = beta²`. At `u = 0` what remains of `(2) = (5)` has two roots `eta` in `[0, 2)`: zero
//! for the arch of no opening, and `eta_l` for the end of rotation. About either the thickness, the
//! thrust and `A` are series in `u`, found here by Newton's method in exact arithmetic; reverted, they
//! are series in what is given.

use crate::arch::{Ring, SelfWeight, overturning, thrust};
use crate::number::{Angle, Dual, ExactField, Field};
use crate::symbolic::Series;
use rug::Rational;

/// The rotational states by `u = beta_r²`.
#[derive(Clone, Debug)]
pub struct ByJoint<T> {
    /// `eta(u)`.
    pub thickness: Series<T>,
    /// `h(u)`.
    pub thrust: Series<T>,
    /// `A(u)`.
    pub opening_variable: Series<T>,
}

/// The rotational states about `u = 0` on the branch with the thickness given there: 0, or `eta_l`.
/// `None` if it is no root of `(2) = (5)` there, or a double one.
pub fn by_joint<T: ExactField>(
    weight: SelfWeight,
    thickness: &T,
    terms: usize,
) -> Option<ByJoint<T>> {
    let u = Series::variable(thickness, terms);
    let joint = joint(&u);
    let cotangent = times_cotangent(&u);
    let gap = |eta: &Dual<Series<T>>| {
        let ring = Ring::new(weight, eta);
        let tangency = thrust::tangency(&Dual::constant(cotangent.clone()), &ring);
        thrust::lower(&joint.clone().map(Dual::constant), &ring).difference(&tangency)
    };
    let thickness = Series::root(Series::new(thickness, vec![thickness.clone()], terms), gap)?;
    let ring = Ring::new(weight, &thickness);
    let thrust = thrust::tangency(&cotangent, &ring).value();
    let opening_variable = thrust.clone() + overturning::opening_variable(&ring).value();
    Some(ByJoint { thickness, thrust, opening_variable })
}

/// A joint whose square is the series `u`, as (2) sees it: `rad * sin` is `beta sin(beta)`.
pub fn joint<T: ExactField>(u: &Series<T>) -> Angle<Series<T>> {
    let (quotient, cosine) = functions(u);
    Angle { rad: u.int(1), sin: u.clone() * quotient, cos: cosine }
}

/// `beta cot(beta)` for `beta² = u`.
pub fn times_cotangent<T: ExactField>(u: &Series<T>) -> Series<T> {
    let (quotient, cosine) = functions(u);
    cosine / quotient
}

/// `A(alpha) = alpha cot(alpha/2)` for `alpha² = y`.
pub fn opening_variable<T: ExactField>(y: &Series<T>) -> Series<T> {
    times_cotangent(&(y.clone() / y.int(4))) * y.int(2)
}

/// `sin(beta)/beta` and `cos(beta)` for `beta² = u`.
fn functions<T: ExactField>(u: &Series<T>) -> (Series<T>, Series<T>) {
    let (quotient, cosine) = Series::sine_quotient_and_cosine(&u.coefficient(0), u.length());
    (quotient.compose(u), cosine.compose(u))
}

/// The rotational states of small half openings by `y = alpha²`.
#[derive(Clone, Debug)]
pub struct ByOpening {
    /// `beta_r²`, which begins with `y/2`.
    pub joint_squared: Series<Rational>,
    /// `eta`, which begins with `y²/48`.
    pub thickness: Series<Rational>,
    /// `h`, which begins with `1 - y/6`.
    pub thrust: Series<Rational>,
}

/// The series of the rotational states in `alpha²`; about `terms` coefficients are known.
pub fn by_opening(weight: SelfWeight, terms: usize) -> Option<ByOpening> {
    let zero = Rational::new();
    let ByJoint { thickness, thrust, opening_variable: a } = by_joint(weight, &zero, terms)?;
    let y = Series::variable(&zero, terms);
    let drop = opening_variable(&y) - y.int(2);
    let opening_squared = drop.reversion().compose(&(a - y.int(2)));
    let joint_squared = opening_squared.reversion();
    Some(ByOpening {
        thickness: thickness.compose(&joint_squared),
        thrust: thrust.compose(&joint_squared),
        joint_squared,
    })
}

/// The states about `l` by `x = A - A_l`.
#[derive(Clone, Debug)]
pub struct AboutEnd<T> {
    /// `beta_r²` on the side of rotation, `x > 0`.
    pub joint_squared: Series<T>,
    /// `eta` on the side of rotation.
    pub thickness: Series<T>,
    /// `h` on the side of rotation.
    pub thrust: Series<T>,
    /// `eta` of the purely overturning states, `x < 0`, where `h = 0`.
    pub overturning_thickness: Series<T>,
}

/// The series about the end of rotation, from its thickness `eta_l`.
pub fn about_end<T: ExactField>(
    weight: SelfWeight,
    thickness: &T,
    terms: usize,
) -> Option<AboutEnd<T>> {
    let by_joint = by_joint(weight, thickness, terms)?;
    let a = by_joint.opening_variable;
    let joint_squared = (a.clone() - constant(&a, 0)).reversion();
    let eta = Series::new(thickness, vec![thickness.clone(), thickness.int(1)], terms);
    let overturned = overturning::opening_variable(&Ring::new(weight, &eta)).value();
    let step = (overturned.clone() - constant(&overturned, 0)).reversion();
    let start = constant(&eta, 0);
    Some(AboutEnd {
        thickness: by_joint.thickness.compose(&joint_squared),
        thrust: by_joint.thrust.compose(&joint_squared),
        joint_squared,
        overturning_thickness: start + step,
    })
}

/// The coefficient of a power as a constant series.
fn constant<T: ExactField>(series: &Series<T>, power: i32) -> Series<T> {
    let value = series.coefficient(power);
    Series::new(&value.clone(), vec![value], series.length())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_leading_terms_are_those_known() {
        for weight in SelfWeight::ALL {
            let series = by_opening(weight, 8).unwrap();
            assert_eq!(series.joint_squared.coefficient(1), Rational::from((1, 2)));
            assert_eq!(series.thickness.valuation(), 2);
            assert_eq!(series.thickness.coefficient(2), Rational::from((1, 48)));
            assert_eq!(series.thrust.coefficient(1), Rational::from((-1, 6)));
        }
    }

    #[test]
    fn a_thickness_that_is_no_root_has_no_series() {
        assert!(by_joint(SelfWeight::Heyman, &Rational::from((1, 2)), 6).is_none());
        assert!(by_joint(SelfWeight::Heyman, &Rational::from(1), 6).is_some());
    }
}
