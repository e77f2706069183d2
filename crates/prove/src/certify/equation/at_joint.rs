//! One equation at one joint, at one precision.

use super::closed::{RootBranch, trigonometric};
use super::evaluated::{
    ClosedAt, EquationValue, Evaluated, LinkAt, PolynomialAt, RadicandAt, RootAt, outward,
};
use super::polynomial::{coefficients, is_root, real_roots, value};
use crate::arch::closed_form::ClosedForm;
use crate::arch::cubic::{self, Abbreviations};
use crate::arch::{Ring, SelfWeight, overturning, thrust};
use crate::certify::CertifiedLandmark;
use crate::number::{Angle, Ball, ComplexBall, Dual, Enclosure, ExactNumber, Field, Real, Ternary};
use crate::problem::Landmark;
use crate::prover::figure::{Figure, Figured};
use crate::prover::{Error, Refused, Undecided, raise};
use crate::symbolic::Known;
use rug::Rational;

/// Result of an evaluation, to be tried with more bits if it is `None`.
type Tried<T> = Result<Option<T>, Undecided>;

/// Equation at a rotational joint.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum JointEquation {
    /// (7).
    Cubics,
    /// (8).
    Link,
    /// (9), (10) or (11).
    Closed(ClosedForm),
    /// (12).
    Radicand,
}

/// A joint, exact as far as it can be.
pub(super) struct AtJoint {
    weight: SelfWeight,
    joint: Angle<Known>,
    bits: u32,
    digits: usize,
}

/// Bits with which a joint is compared with the widest one at first.
const COMPARED: u32 = 128;

impl AtJoint {
    /// Evaluates an equation at an exact joint, with `first` bits or more.
    pub(super) fn evaluate(
        equation: JointEquation,
        weight: SelfWeight,
        joint: &ExactNumber,
        digits: usize,
        first: u32,
    ) -> Result<Evaluated, Error> {
        let at = |bits| Self { weight, joint: Known::angle(joint, bits), bits, digits };
        if matches!(equation, JointEquation::Closed(_)) {
            // Beyond the widest joint or not: by the landmark, or next to it by the sign of (12).
            let widest =
                CertifiedLandmark::new(Landmark::WidestJoint, weight)?.enclosure(COMPARED)?;
            let widest = &widest.configuration().rotation_joint.rad;
            let is_beyond = match joint.enclosure::<Ball>(COMPARED).is_less_than(widest) {
                Ternary::True => false,
                Ternary::False => true,
                Ternary::Undecided => raise(first, |bits| Ok(Some(at(bits).signed_radicand()?.1)))?,
            };
            if is_beyond {
                return Err(Refused::BeyondWidestJoint(joint.clone()).into());
            }
        }
        let found = raise(first, |bits| match equation {
            JointEquation::Cubics => at(bits).cubics(),
            JointEquation::Link => at(bits).link(),
            JointEquation::Closed(form) => at(bits).closed(form),
            JointEquation::Radicand => at(bits).radicand(),
        });
        match found {
            Err(open) if equation == JointEquation::Cubics => {
                // The coefficients alone, as the roots stay open.
                let roots = || [0; 3].map(|_| Err(open.clone()));
                let shown = |at: Self| at.shown(&at.polynomials(), roots());
                Ok(raise(first, |bits| Ok(shown(at(bits)))).map_err(|_| open.clone())?)
            }
            found => Ok(found?),
        }
    }

    fn abbreviations(&self) -> Abbreviations<Known> {
        cubic::abbreviations(&self.joint)
    }

    /// The joint in balls.
    fn enclosed(&self) -> Angle<Ball> {
        self.joint.clone().map(|x| x.ball())
    }

    /// The polynomials (7).
    fn polynomials(&self) -> [Vec<Known>; 3] {
        let at = self.abbreviations();
        ClosedForm::ALL.map(|unknown| coefficients(unknown, self.weight, &at))
    }

    /// The radicand and whether it is positive.
    fn signed_radicand(&self) -> Result<(Ball, bool), Undecided> {
        let at = cubic::abbreviations(&self.enclosed());
        let radicand = cubic::radicand(&at, &at.sin.int(self.weight.flag()));
        let is_positive = match radicand.is_positive() {
            Ternary::True => true,
            Ternary::False if radicand.excludes_zero() => false,
            _ => return Err(Undecided::new("the sign of (12), which is next to zero")),
        };
        Ok((radicand, is_positive))
    }

    /// Number of the real roots of a polynomial (7): (12) is the discriminant of each, up to a negative factor that is
    /// not zero (the claim `eq-12`).
    fn real_count<T>(&self, polynomial: &[T]) -> Result<usize, Undecided> {
        let degree = polynomial.len() - 1;
        self.signed_radicand().map(|(_, is_positive)| if is_positive { degree - 2 } else { degree })
    }

    /// Figure of a root that is alone in its ball: exact where a decimal of so many digits is proved to be it.
    fn root_figure(&self, polynomial: &[Known], root: &Ball) -> Option<Figure> {
        Figure::proved(root, self.digits, |x| is_root(polynomial, x))
    }

    /// (12).
    fn radicand(&self) -> Tried<Evaluated> {
        let (radicand, is_positive) = self.signed_radicand()?;
        let value = Figure::around(&radicand, self.digits);
        Ok(value.map(|value| Evaluated::Radicand(Box::new(RadicandAt { value, is_positive }))))
    }

    /// (8).
    fn link(&self) -> Tried<Evaluated> {
        let Abbreviations { sin, f, g } = self.abbreviations();
        let difference = cubic::link(&self.joint).ball();
        let named =
            [("sin", "S = sin(beta)", sin), ("f", "f = S + beta C", f), ("g", "g = beta + S C", g)];
        let abbreviations = named.into_iter().map(|(name, symbol, x)| {
            Some(EquationValue { name, symbol, figure: x.figure(self.digits)? })
        });
        let found = || {
            Some(Evaluated::Link(Box::new(LinkAt {
                abbreviations: abbreviations.collect::<Option<_>>()?,
                difference: outward(&difference)?,
                holds: !difference.excludes_zero(),
            })))
        };
        Ok(found())
    }

    /// (7).
    fn cubics(&self) -> Tried<Evaluated> {
        let polynomials = self.polynomials();
        let roots = self.roots(&polynomials)?;
        let Some(roots) = roots else { return Ok(None) };
        Ok(self.shown(&polynomials, roots.map(Ok)))
    }

    fn shown(
        &self,
        polynomials: &[Vec<Known>; 3],
        roots: [Result<Vec<RootAt>, Undecided>; 3],
    ) -> Option<Evaluated> {
        let shown = |((unknown, polynomial), roots): ((ClosedForm, &Vec<Known>), _)| {
            let coefficients = polynomial.iter().map(|x| x.figure(self.digits));
            Some(PolynomialAt {
                unknown,
                coefficients: coefficients.collect::<Option<_>>()?,
                roots,
            })
        };
        let all = ClosedForm::ALL.into_iter().zip(polynomials).zip(roots).map(shown);
        all.collect::<Option<_>>().map(Evaluated::Cubics)
    }

    /// Real roots of the three polynomials, each with the thickness that belongs to it.
    ///
    /// By (5) and (4) each thickness has a thrust and an opening variable, which are roots of the two other
    /// polynomials: of the one that they meet and no other.
    fn roots(&self, polynomials: &[Vec<Known>; 3]) -> Tried<[Vec<RootAt>; 3]> {
        let count = self.real_count(&polynomials[1])?;
        let roots = |of: usize| real_roots(&enclosed(&polynomials[of]), count, self.bits);
        let [openings, thicknesses, thrusts] = [roots(0)?, roots(1)?, roots(2)?];
        let mut found = [const { Vec::new() }; 3];
        let mut branches = RootBranch::ALL.into_iter();
        for eta in &thicknesses {
            let ring = Ring::new(self.weight, eta);
            let joint = self.joint.times_cotangent().ball();
            let thrust = thrust::tangency(&joint, &ring).value();
            let opening = thrust.clone() + overturning::opening_variable(&ring).value();
            let inside = [eta.clone(), ring.intrados()].map(|x| x.is_positive());
            let branch = match inside {
                [Ternary::True, Ternary::True] => {
                    let more = || Undecided::new("to which state a third thickness belongs");
                    Some(branches.next().ok_or_else(more)?)
                }
                [Ternary::False, _] | [_, Ternary::False] => None,
                _ => return Ok(None),
            };
            let own = [meets(&openings, &opening), Some(eta), meets(&thrusts, &thrust)];
            for ((root, polynomial), found) in own.into_iter().zip(polynomials).zip(&mut found) {
                let shown = || {
                    let root = root?;
                    let residual = outward(&value(&enclosed(polynomial), root))?;
                    let value = self.root_figure(polynomial, root);
                    let thickness = self.root_figure(&polynomials[1], eta);
                    Some(RootAt { value: value?, residual, thickness: thickness?, branch })
                };
                let Some(root) = shown() else { return Ok(None) };
                found.push(root);
            }
        }
        for found in &mut found {
            found.sort_by(|a, b| a.value.double.total_cmp(&b.value.double));
        }
        Ok(Some(found))
    }

    /// (9), (10) or (11).
    fn closed(&self, form: ClosedForm) -> Tried<Evaluated> {
        let (radicand, _) = self.signed_radicand()?;
        let joint = self.enclosed();
        let at = cubic::abbreviations(&joint);
        let complex = |x: &Ball| ComplexBall::from(x.clone());
        let of = Abbreviations { sin: complex(&at.sin), f: complex(&at.f), g: complex(&at.g) };
        let Some(q) = ComplexBall::root_of_real(&radicand) else { return Ok(None) };
        let Some(u) = form.cube(&of, &q).cube_root() else {
            return Err(Undecided::new("the cube root, whose argument meets the cut"));
        };
        let root_of_three = joint.rad.int(3).sqrt();
        let branch = |branch: RootBranch| {
            let sign = root_of_three.int(if branch == RootBranch::Upper { 1 } else { -1 });
            let k = ComplexBall { re: root_of_three.int(0), im: root_of_three.clone() * sign };
            let printed = form.value(&of, &u, &k);
            let trigonometric = trigonometric(form, branch, &joint);
            if !printed.re.overlaps(&trigonometric) {
                return Some(Err(Undecided::new("a closed form, whose two ways differ")));
            }
            Some(Ok(ClosedAt {
                branch,
                printed_loss: self.digits_lost(&printed.re),
                printed: Figure::around(&printed.re, self.digits)?,
                imaginary: outward(&printed.im).filter(|_| !printed.im.excludes_zero())?,
                trigonometric_loss: self.digits_lost(&trigonometric),
                trigonometric: Figure::around(&trigonometric, self.digits)?,
            }))
        };
        let branches: Option<Result<Vec<ClosedAt>, Undecided>> =
            RootBranch::ALL.map(branch).into_iter().collect();
        let branches = branches.transpose()?;
        Ok(branches.map(|branches| Evaluated::Closed(form, branches)))
    }

    /// Decimal digits of the precision that a value no longer has, rounded up.
    fn digits_lost(&self, x: &Ball) -> u32 {
        let (Some(radius), Some(size)) = (x.rad().exponent(), x.mid().get_exp()) else { return 0 };
        let lost = i64::from(self.bits) + radius - i64::from(size);
        (lost.max(0) as f64 * std::f64::consts::LOG10_2).ceil() as u32
    }
}

/// Thicknesses between 0 and 2 at which the line of thrust touches the intrados at a joint, (2) = (5): all of them, in
/// their order.
pub(crate) fn touched_thicknesses(
    weight: SelfWeight,
    joint: &Angle<Ball>,
    bits: u32,
) -> Result<Vec<Ball>, Undecided> {
    let polynomial = coefficients(ClosedForm::Thickness, weight, &cubic::abbreviations(joint));
    let at = AtJoint { weight, joint: joint.clone().map(Known::Enclosed), bits, digits: 1 };
    let count = at.real_count(&polynomial)?;
    let mut inside = Vec::new();
    for eta in real_roots(&polynomial, count, bits)? {
        match [eta.clone(), eta.int(2) - &eta].map(|x| x.is_positive()) {
            [Ternary::True, Ternary::True] => inside.push(eta),
            [Ternary::False, _] | [_, Ternary::False] => {}
            _ => return Err(Undecided::new("whether a thickness is between 0 and 2")),
        }
    }
    Ok(inside)
}

/// Tells whether a number in the enclosure of a root of (7) is that root, exactly.
pub(crate) fn solves(
    weight: SelfWeight,
    unknown: ClosedForm,
    joint: &ExactNumber,
    root: &Ball,
    x: &Rational,
) -> bool {
    let at = cubic::abbreviations(&Known::angle(joint, root.prec()));
    let polynomial = coefficients(unknown, weight, &at);
    let variable = Dual::variable(root.clone(), 0);
    let terms: Vec<_> = enclosed(&polynomial).into_iter().map(Dual::constant).collect();
    // With a slope without zero there is no second root in the enclosure.
    is_root(&polynomial, x) && value(&terms, &variable).derivative(0).excludes_zero()
}

fn enclosed(polynomial: &[Known]) -> Vec<Ball> {
    polynomial.iter().map(Known::ball).collect()
}

/// The one root that a number may be, if it is one.
fn meets<'a>(roots: &'a [Ball], x: &Ball) -> Option<&'a Ball> {
    let mut met = roots.iter().filter(|root| root.overlaps(x));
    met.next().filter(|_| met.next().is_none())
}
