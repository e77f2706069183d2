//! Proof of a purely rotational state, without a branch.
//!
//! **One equation.** For a joint `beta` let `eta` be the thickness and `h` the thrust at which (2), (4) and (5) hold
//! with one and the same moment of the weight, whatever that is: [`thrust::rotating`] and [`thrust::touching`]. The
//! rest is that the moment is the one of the weight, `fac_M(eta)`: with it (4) has the thrust `h` too. That is one
//! equation `F(beta) = 0`, and where it holds, (2), (4) and (5) do. A test has this in exact arithmetic.
//!
//! **One root.** With a double `m` next to it, a double `Y` next to `1/F'(m)` and the box `X = m ± rho`,
//!
//! ```text
//! K = m - Y F(m) + (1 - Y F'(X)) (X - m)
//! ```
//!
//! holds every root in `X`, and if `K` is inside `X` there is exactly one (Krawczyk): `|Y F(m)| + |1 - Y F'(X)| rho <
//! rho`. `F(m)` is enclosed in double-doubles, the slope in doubles. With `beta = m + d` and `d` in `K - m`, `eta` is
//! in `eta(m) + eta'(X) d` by the mean value theorem, and so is `h`; `d` is about `2^-50`, so that slopes in doubles
//! leave about thirty digits. On `X` all is smooth, as a divisor that may be small makes what it divides the whole
//! line.
//!
//! **Sines.** At `alpha` and `m`, which are doubles, both errors are at most [`SinePoint::ERROR`]; on a box `|sin x -
//! sin m| <= |x - m|`, and the same for the cosine.
//!
//! **Signs.** What else makes it the state at the least thickness are the signs of [`margins`], those of
//! [`Condition::of`](couplet_check::problem::Condition::of) without a limit of friction
//! ([`contact`] has the lemma), and with a limit those of [`sliding_margins`], as for arches one by one.

use super::ball::LaneBall;
use super::start::{FIRST, LAST, Starts};
use crate::arch::{
    Configuration, Ring, SelfWeight, contact, overturning, sliding, statics, thrust,
};
use crate::number::{Angle, DoubleDoubleBy, Field, Gradient, Product, SinePoint, power_of_two};

/// Ball of doubles.
type Short = LaneBall<f64>;
/// Ball of double-doubles.
type Long<P> = LaneBall<DoubleDoubleBy<P>>;

/// Ratio of the width of a box to the correction that the residual asks for.
const INFLATION: f64 = 4.0;
/// Least radius of a box.
const LEAST_RADIUS: f64 = power_of_two(-90);

/// The values of a state: what is proved encloses them, and what is not is the whole line.
pub(super) struct Rotation<P> {
    pub(super) thickness: Long<P>,
    pub(super) thrust: Long<P>,
    pub(super) intrinsic_thrust: Long<P>,
    pub(super) rotation_joint: Long<P>,
}

/// Values that (2), (4) and (5) give to a joint.
struct AtJoint<T> {
    thickness: T,
    /// The thrust by (4).
    thrust: T,
    /// `F`: zero where the thrust by (2) and (5) is the same.
    residual: T,
}

#[inline(always)]
fn at_joint<T: Field>(weight: SelfWeight, opening_variable: &T, joint: &Angle<T>) -> AtJoint<T> {
    let ring = Ring::new(weight, &thrust::rotating(joint, opening_variable).value());
    let thrust = opening_variable.clone() - overturning::opening_variable(&ring).value();
    let excess = joint.rad.clone() / &joint.sin - joint.rad.int(1);
    let residual = thrust::touching(&joint.versine(), &excess, &ring).residual(&thrust);
    AtJoint { thickness: ring.thickness, thrust, residual }
}

/// The angle of a double; the whole line where the point does not reach it.
#[inline(always)]
fn angle<P: Product>(rad: f64, point: SinePoint) -> Angle<Long<P>> {
    let (sin, cos) = point.sin_cos(DoubleDoubleBy::exact(rad));
    let error = if point.reaches(rad) { SinePoint::ERROR } else { f64::NAN };
    let [sin, cos] = [sin, cos].map(|x| LaneBall::new(x, error));
    Angle { rad: LaneBall::exact(rad), sin, cos }
}

/// All angles within a distance, in doubles.
#[inline(always)]
fn around<P: Product>(angle: &Angle<Long<P>>, distance: f64) -> Angle<Short> {
    let around = |x: &Long<P>| x.in_doubles().widened(distance);
    Angle { rad: around(&angle.rad), sin: around(&angle.sin), cos: around(&angle.cos) }
}

/// An angle as the unknown.
#[inline(always)]
fn unknown<T: Field + Copy>(angle: &Angle<T>) -> Angle<Gradient<T, 1>> {
    let with = |value: T, slope: T| Gradient { value, slopes: [slope] };
    Angle {
        rad: with(angle.rad, angle.rad.int(1)),
        sin: with(angle.sin, angle.cos),
        cos: with(angle.cos, -angle.sin),
    }
}

/// The state of the arch in a place, at its half opening and friction.
#[inline(always)]
#[allow(clippy::manual_range_contains, reason = "a range decides in two steps")]
pub(super) fn rotation<P: Product, const N: usize>(
    weight: SelfWeight,
    starts: &Starts<N>,
    place: usize,
    [alpha, friction]: [f64; 2],
) -> Rotation<P> {
    let half_opening = angle::<P>(alpha, starts.at_half_openings.get(place));
    let a = thrust::opening_variable(&half_opening).value();

    // A step of Newton's method, in doubles.
    let (start, point) = (starts.joints[place], starts.at_joints.get(place));
    let (sin, cos) = point.sin_cos_in_doubles(start);
    let joint = unknown(&Angle { rad: start, sin, cos });
    let residual = at_joint(weight, &Gradient::constant(a.mid().hi()), &joint).residual;
    let inverse = 1.0 / residual.slopes[0];
    let middle = start - inverse * residual.value;

    // A step of the operator.
    let joint = angle::<P>(middle, point);
    let at_middle = at_joint(weight, &a, &joint);
    let step = at_middle.residual * Long::exact(inverse);
    let radius = INFLATION * step.size() + LEAST_RADIUS;
    let domain = around(&joint, radius);
    let slopes = at_joint(weight, &Gradient::constant(a.in_doubles()), &unknown(&domain));
    let rest = Short::exact(1.0) - slopes.residual.slopes[0] * Short::exact(inverse);
    let image = (-step).widened((rest * Short::exact(radius)).size());
    let is_contracted = image.size() < radius;
    let moved = |x: Long<P>, slope: Short| x + slope.in_double_doubles() * image;
    let thickness = moved(at_middle.thickness, slopes.thickness.slopes[0]);
    let thrust = moved(at_middle.thrust, slopes.thrust.slopes[0]);

    let at = Configuration {
        half_opening: around(&half_opening, 0.0),
        rotation_joint: domain,
        thickness: thickness.in_doubles(),
        thrust: thrust.in_doubles(),
        ..Configuration::zero(&Short::exact(0.0))
    };
    let are_positive = |all: &[Short]| all.iter().fold(true, |are, x| are & x.is_positive());
    let is_least = are_positive(&margins(weight, &at));
    let steepest = steepest_joint::<P>(&at.thrust, starts.at_steepest.get(place));
    let holds = are_positive(&sliding_margins(&at, &steepest, &Short::exact(friction)));
    let in_range = (alpha >= FIRST) & (alpha <= LAST);
    let is_proved = is_contracted & is_least & (holds | (friction == f64::INFINITY)) & in_range;
    let if_proved = |x: Long<P>| LaneBall::new(x.mid(), if is_proved { x.rad() } else { f64::NAN });
    Rotation {
        thickness: if_proved(thickness),
        thrust: if_proved(thrust),
        intrinsic_thrust: if_proved(thickness * thrust),
        rotation_joint: if_proved(joint.rad + image),
    }
}

/// The joint that is steepest at a thrust.
#[inline(always)]
fn steepest_joint<P: Product>(thrust: &Short, point: SinePoint) -> Angle<Short> {
    // `sliding::steepest_joint`, of a number that has no sine of its own.
    let rad = ((thrust.int(1) - thrust) * thrust).sqrt();
    around(&angle::<P>(rad.mid(), point), rad.rad())
}

/// Margins of a purely rotational state: it is the one at the least thickness where all are positive and friction has
/// no limit.
#[inline(always)]
fn margins<T: Field>(weight: SelfWeight, at: &Configuration<T>) -> [T; 12] {
    let (joint, alpha, eta, h) =
        (&at.rotation_joint.rad, &at.half_opening.rad, &at.thickness, &at.thrust);
    let rates = contact::rates_of_rotation(at);
    let of_weight = contact::weight_term(&rates, at);
    [
        statics::normal_force(&at.half_opening, h),
        eta.clone(),
        eta.int(2) - eta,
        h.clone(),
        h.int(1) - h,
        joint.clone(),
        alpha.clone() - joint,
        rates.shoulder.clone(),
        contact::margin_at_physical_limit(weight, at),
        contact::thrust_coefficient(&rates, at),
        of_weight.clone(),
        contact::growth(weight, &rates, at, &of_weight),
    ]
}

/// Margins of friction: no joint slides where all are positive.
#[inline(always)]
fn sliding_margins<T: Field>(at: &Configuration<T>, steepest: &Angle<T>, friction: &T) -> [T; 3] {
    [
        at.half_opening.rad.clone() - &steepest.rad,
        friction.clone() - sliding::shoulder(&at.half_opening, &at.thrust).value(),
        friction.clone() - sliding::inner(steepest, &at.thrust).value(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Ball, Enclosure};
    use couplet_check::problem::{
        Condition, Examined, Mode, inner_friction, room_for_steepest, shoulder_friction,
    };
    use rug::Rational;

    /// Exact joints and half openings, of no state.
    fn exact() -> impl Iterator<Item = (Rational, Angle<Rational>)> {
        let angle = |rad: (i32, i32), sin: (i32, i32), cos: (i32, i32)| Angle {
            rad: rad.into(),
            sin: sin.into(),
            cos: cos.into(),
        };
        let joints = [
            angle((1, 1), (20, 29), (21, 29)),
            angle((2, 3), (5, 13), (12, 13)),
            angle((3, 2), (4, 5), (-3, 5)),
        ];
        let variables = [(3, 2), (9, 7), (1, 2)].map(Rational::from);
        variables.into_iter().flat_map(move |a| joints.clone().map(|joint| (a.clone(), joint)))
    }

    /// With the moment for which (4) holds, (2) and (5) hold; and the residual is what that moment leaves of that of
    /// the weight.
    #[test]
    fn the_residual_is_all_that_is_left() {
        for (a, joint) in exact() {
            for weight in SelfWeight::ALL {
                let eta = thrust::rotating(&joint, &a).value();
                let excess = joint.rad.clone() / &joint.sin - Rational::from(1);
                let ring =
                    |factor: Rational| Ring { thickness: eta.clone(), centroid_factor: factor };
                let h = thrust::touching(&joint.versine(), &excess, &ring(1.into())).value();
                let moment =
                    (a.clone() - &h) * (eta.clone() + Rational::from(2)) / Rational::from(2);
                let ring = ring(moment.clone());
                assert_eq!(thrust::lower(&joint, &ring).residual(&h), 0);
                assert_eq!(thrust::tangency(&joint.times_cotangent(), &ring).residual(&h), 0);
                let found = at_joint(weight, &a, &joint);
                assert_eq!(found.thickness, eta);
                let of_weight = Ring::new(weight, &eta).centroid_factor;
                let left = (moment - &of_weight) * Rational::from(4) * &eta
                    / (eta.clone() + Rational::from(2));
                assert_eq!(found.residual, left);
                assert_ne!(found.residual, 0);
                let other = Ring { centroid_factor: of_weight, ..ring };
                assert_ne!(thrust::lower(&joint, &other).residual(&h), 0, "false twin");
            }
        }
    }

    /// Nothing that a proof one by one looks at is left out.
    #[test]
    fn the_margins_are_those_of_all_conditions() {
        let ball = |n: i32| Ball::integer(n, 128) / Ball::integer(100, 128);
        let at = Configuration {
            half_opening: Angle::new(ball(140)),
            rotation_joint: Angle::new(ball(87)),
            thickness: ball(7),
            thrust: ball(70),
            friction: ball(60),
            ..Configuration::zero(&ball(0))
        };
        for weight in SelfWeight::ALL {
            let examined = Examined::new(weight, Mode::Rotational, &at);
            let expected: Vec<Ball> = Condition::of(Mode::Rotational, false)
                .map(|condition| examined.margin(condition))
                .collect();
            let found = margins(weight, &at);
            assert_eq!(expected.len(), found.len());
            for (found, expected) in found.iter().zip(&expected) {
                assert!(found.overlaps(expected) && found.is_bounded(), "{found:?} {expected:?}");
            }
            // No two are the same, so that each is in its place.
            let others = (0..12).flat_map(|k| (0..k).map(move |j| (j, k)));
            others.for_each(|(j, k)| assert!(!found[j].overlaps(&expected[k]), "{j} {k}"));
        }
        let steepest = Angle::new(sliding::steepest_joint(&at.thrust));
        let expected = [
            room_for_steepest(&at),
            at.friction.clone() - shoulder_friction(&at),
            at.friction.clone() - inner_friction(&at),
        ];
        let found = sliding_margins(&at, &steepest, &at.friction);
        found.iter().zip(&expected).for_each(|(x, y)| assert!(x.overlaps(y) && x.is_bounded()));
    }
}
