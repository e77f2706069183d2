//! Signs that make a root the state at the least thickness: those of
//! [`Condition::of`](couplet_check::problem::Condition::of), which [`contact`] has the lemma for.

use super::sine::{Long, Short, Sine, around};
use crate::arch::contact::{self, Rates};
use crate::arch::{Configuration, Quotient, SelfWeight, sliding, statics};
use crate::number::{Angle, Enclosure, Field, Product, SinePoint};

/// Tells whether all are proved to be positive.
#[inline(always)]
pub(super) fn are_positive<const N: usize>(all: &[Short; N]) -> bool {
    all.iter().fold(true, |are, x| are & x.is_positive().is_proved())
}

/// A state in doubles, in which signs are decided: its half opening, thickness, thrust and friction, and the box of the
/// rotational joint; the sliding joint is at the crown.
#[inline(always)]
pub(super) fn in_doubles<P: Product>(
    half_opening: &Angle<Long<P>>,
    [thickness, thrust, friction]: [&Long<P>; 3],
    rotation_joint: Angle<Short>,
) -> Configuration<Short> {
    Configuration {
        half_opening: around(half_opening, 0.0),
        rotation_joint,
        thickness: thickness.in_doubles(),
        thrust: thrust.in_doubles(),
        friction: friction.in_doubles(),
        ..Configuration::zero(&Short::exact(0.0))
    }
}

/// Margins of every state that has a thrust.
#[inline(always)]
pub(super) fn of_state<T: Field>(at: &Configuration<T>) -> [T; 5] {
    let (eta, h) = (&at.thickness, &at.thrust);
    [
        statics::normal_force(&at.half_opening, h),
        eta.clone(),
        eta.int(2) - eta,
        h.clone(),
        h.int(1) - h,
    ]
}

/// Margins of a hinge at the haunch.
#[inline(always)]
pub(super) fn of_haunch<T: Field>(at: &Configuration<T>) -> [T; 2] {
    let joint = &at.rotation_joint.rad;
    [joint.clone(), at.half_opening.rad.clone() - joint]
}

/// Margins that exclude thinner arches, and that make thicker ones stand.
pub(super) struct Thinnest<T> {
    /// Positive whatever bounds the thrust.
    always: [T; 3],
    /// Growth of the weight of the mechanism with the thrust.
    slope: T,
    /// Positive where the weight does not grow: the shoulder bounds the thrust, by which both are then what they are.
    bounded: [T; 3],
}

impl<T: Field> Thinnest<T> {
    /// The margins of a mechanism with rates.
    #[inline(always)]
    pub(super) fn new(weight: SelfWeight, at: &Configuration<T>, rates: &Rates<T>) -> Self {
        let of_weight = contact::weight_term(rates, at);
        let growth = |w: &T| contact::growth(weight, rates, at, w);
        let slope = contact::thrust_coefficient(rates, at);
        let bound = sliding::shoulder_thrust(&at.half_opening, &at.friction);
        let at_bound = of_weight.clone() + slope.clone() * bound.value();
        Self {
            always: [
                contact::margin_at_physical_limit(weight, at),
                of_weight.clone(),
                growth(&of_weight),
            ],
            bounded: [bound.denominator, at_bound.clone(), growth(&at_bound)],
            slope,
        }
    }
}

impl Thinnest<Short> {
    /// Tells whether they are proved to hold.
    #[inline(always)]
    pub(super) fn holds(&self) -> bool {
        are_positive(&self.always)
            & (self.slope.is_positive().is_proved() | are_positive(&self.bounded))
    }

    /// Tells whether they hold with unlimited friction, where nothing bounds the thrust.
    #[inline(always)]
    pub(super) fn holds_unlimited(&self) -> bool {
        are_positive(&self.always) & self.slope.is_positive().is_proved()
    }
}

/// The joint that is steepest at a thrust, and the friction that it asks for.
#[inline(always)]
pub(super) fn steepest<P: Product, T: Sine<P>>(
    thrust: &T,
    point: &SinePoint,
) -> (Angle<T>, Quotient<T>) {
    // `sliding::steepest_joint`, of a number that has no sine of its own.
    let joint = ((thrust.int(1) - thrust) * thrust).root().angle(point);
    let friction = sliding::inner(&joint, thrust);
    (joint, friction)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::number::{Ball, Enclosure};
    use couplet_check::problem::{Condition, Examined, Mode};

    /// A configuration of no state, by hundredths of the half opening, the joints, the thickness, the thrust and the
    /// friction.
    pub(in super::super) fn configuration(hundredths: [i32; 6]) -> Configuration<Ball> {
        let [alpha, rotates, slides, eta, h, mu] =
            hundredths.map(|n| Ball::integer(n, 128) / Ball::integer(100, 128));
        Configuration {
            half_opening: Angle::new(alpha),
            rotation_joint: Angle::new(rotates),
            sliding_joint: Angle::new(slides),
            thickness: eta,
            thrust: h,
            friction: mu,
            ..Configuration::zero(&Ball::integer(0, 128))
        }
    }

    /// Nothing that a proof one by one looks at is left out, and nothing else is looked at.
    pub(in super::super) fn assert_are_all(
        (weight, mode, is_limited): (SelfWeight, Mode, bool),
        at: &Configuration<Ball>,
        found: &[Ball],
        thinnest: &Thinnest<Ball>,
    ) {
        let examined = Examined::new(weight, mode, at);
        let expected: Vec<(Condition, Ball)> = Condition::of(mode, is_limited)
            .map(|condition| (condition, examined.margin(condition)))
            .collect();
        let grows = thinnest.slope.is_positive().is_proved();
        let bounded = if grows { &[][..] } else { &thinnest.bounded };
        let last = if grows { Some(&thinnest.slope) } else { None };
        let found: Vec<&Ball> =
            found.iter().chain(&thinnest.always).chain(bounded).chain(last).collect();
        for (condition, expected) in &expected {
            let same = found.iter().filter(|found| found.overlaps(expected)).count();
            assert!(expected.is_bounded() && same > 0, "{mode} {condition:?}");
        }
        for found in found {
            let same = expected.iter().filter(|(_, expected)| expected.overlaps(found)).count();
            assert!(found.is_bounded() && same > 0, "{mode} {found:?}");
        }
    }

    /// Where the weight of the mechanism does not grow with the thrust, the shoulder has to bound it.
    #[test]
    fn a_bound_of_the_thrust_is_asked_for_where_nothing_else_bounds_it() {
        let number = |x: f64| Short::exact(x);
        let thinnest = |slope: f64, bounded: f64| Thinnest {
            always: [number(1.0); 3],
            slope: number(slope),
            bounded: [number(1.0), number(bounded), number(1.0)],
        };
        assert!(thinnest(1.0, -1.0).holds() && thinnest(-1.0, 1.0).holds());
        assert!(!thinnest(-1.0, -1.0).holds() && !thinnest(-1.0, f64::NAN).holds());
        let never =
            Thinnest { always: [number(1.0), number(-1.0), number(1.0)], ..thinnest(1.0, 1.0) };
        assert!(!never.holds());
        assert!(thinnest(1.0, -1.0).holds_unlimited() && !thinnest(-1.0, 1.0).holds_unlimited());
    }
}
