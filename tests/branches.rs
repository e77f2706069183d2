//! How the rotational and the overturning branch join at `l`: with equal value and slope (C¹), and
//! with different curvatures (not C²).
//!
//! Near `l` the rotational states are analytic in `u = beta_r²`: (2) and (5) see the joint only
//! through `beta sin(beta)`, `cos(beta)` and `beta cot(beta)`, whose series in `u` are
//!
//! ```text
//! beta sin(beta) = u - u²/6 + …    cos(beta) = 1 - u/2 + u²/24 - …    beta cot(beta) = 1 - u/3 - u²/45 - …
//! ```
//!
//! So `eta` and `A` as functions of `u`, and with them `d eta/dA` and `d² eta/dA²` on the side of
//! rotation, follow by implicit differentiation, **exactly** in the field of `√3`.

use couplet::arch::{Landmark, Ring, SelfWeight, overturning, thrust};
use couplet::certify::CertifiedLandmark;
use couplet::number::{Angle, Ball, Dual, Enclosure, ExactField, Field, Surd};

/// A number with first and second derivatives to two variables.
type Second = Dual<Dual<Surd>>;

fn eta_at_l(weight: SelfWeight) -> Surd {
    match weight {
        SelfWeight::Heyman => Surd::rational(1, 3),
        SelfWeight::Milankovitch => Surd::new(-6, 4, 3),
    }
}

/// `a + b u + c u²` as a function of variable 0 at `u = 0`.
fn series(like: &Surd, [a, b, c]: [(i32, i32); 3]) -> Second {
    let [a, b, c] = [a, b, c].map(|(n, d)| like.ratio(n, d));
    let slope = Dual::with_derivative(b.clone(), 0, c * like.int(2));
    Dual::with_derivative(Dual::with_derivative(a, 0, b), 0, slope)
}

/// Variable number `index` with the value `x`.
fn variable(x: &Surd, index: usize) -> Second {
    Dual::variable(Dual::variable(x.clone(), index), index)
}

/// Slope and curvature `d eta/dA`, `d² eta/dA²` on the side of rotation.
fn rotation(weight: SelfWeight) -> (Surd, Surd) {
    let eta0 = eta_at_l(weight);
    let eta = variable(&eta0, 1);
    let ring = Ring::new(weight, &eta);
    // (2) needs beta sin(beta) as a product; `rad = 1` makes the sine that product.
    let joint = Angle {
        rad: eta.int(1),
        sin: series(&eta0, [(0, 1), (1, 1), (-1, 6)]),
        cos: series(&eta0, [(1, 1), (-1, 2), (1, 24)]),
    };
    let cotangent = series(&eta0, [(1, 1), (-1, 3), (-1, 45)]);
    let lower = thrust::lower(&joint, &ring).value();
    let gap = lower.clone() - thrust::tangency(&cotangent, &ring).value();
    assert!(gap.value().value().is_zero(), "(2) = (5) at l");
    // (4): A = h + 2 fac/(2 + eta).
    let a = lower + overturning::opening_variable(&ring).value();

    // Along gap(u, eta(u)) = 0.
    let first = |f: &Second, i: usize| f.value().derivative(i);
    let second = |f: &Second, i: usize, j: usize| f.derivative(i).derivative(j);
    let slope = -(first(&gap, 0) / first(&gap, 1));
    let along = |f: &Second| {
        second(f, 0, 0) + slope.int(2) * second(f, 0, 1) * &slope + second(f, 1, 1) * slope.square()
    };
    let curvature = -(along(&gap) / first(&gap, 1));
    let a_slope = first(&a, 0) + first(&a, 1) * &slope;
    let a_curvature = along(&a) + first(&a, 1) * &curvature;
    // Chain rule from u to A.
    let by_a = slope.clone() / &a_slope;
    let bend = (curvature - by_a.clone() * a_curvature) / a_slope.square();
    (by_a, bend)
}

/// The same on the side of overturning, from (13).
fn overturned(weight: SelfWeight) -> (Surd, Surd) {
    let eta = Dual::variable(Dual::variable(eta_at_l(weight), 0), 0);
    let a = overturning::opening_variable(&Ring::new(weight, &eta)).value();
    let (slope, curvature) = (a.value().derivative(0), a.derivative(0).derivative(0));
    let by_a = slope.int(1) / &slope;
    let bend = -(curvature * by_a.square() * &by_a);
    (by_a, bend)
}

#[test]
fn the_branches_join_with_one_slope_and_two_curvatures() {
    for weight in SelfWeight::ALL {
        let ((slope, bend), (other_slope, other_bend)) = (rotation(weight), overturned(weight));
        println!("{weight:?}: d eta/dA = {slope}, d² eta/dA² = {bend} and {other_bend}");
        assert!((slope.clone() - &other_slope).is_zero(), "C¹: {slope} and {other_slope}");
        assert!(!(bend - &other_bend).is_zero(), "not C²");
    }
}

/// The same in `alpha`: `eta''(alpha) = eta''(A) A'² + eta'(A) A''` on either side, in balls.
#[test]
fn the_curvatures_in_the_half_opening_are_apart() {
    for weight in SelfWeight::ALL {
        let point = CertifiedLandmark::new(Landmark::RotationEnd, weight).unwrap();
        let alpha = point.enclosure(300).unwrap().configuration().half_opening;
        let variable = alpha.variable(0);
        let outer = Angle {
            rad: Dual::new(variable.rad.clone(), vec![Dual::constant(alpha.rad.int(1))]),
            sin: Dual::new(variable.sin.clone(), vec![variable.cos.clone()]),
            cos: Dual::new(variable.cos.clone(), vec![-variable.sin.clone()]),
        };
        let a = thrust::opening_variable(&outer).value();
        let (slope, bend) = (a.value().derivative(0), a.derivative(0).derivative(0));
        let ball = |x: &Surd| {
            let (rational, factor, radicand) = x.parts();
            Ball::enclosing(rational, 300)
                + Ball::enclosing(factor, 300)
                    * couplet::number::Real::sqrt(&Ball::integer(radicand as i32, 300))
        };
        let in_alpha = |(by_a, by_a2): (Surd, Surd)| {
            let by_alpha = ball(&by_a) * &slope;
            (by_alpha, ball(&by_a2) * slope.square() + ball(&by_a) * &bend)
        };
        let ((s1, c1), (s2, c2)) = (in_alpha(rotation(weight)), in_alpha(overturned(weight)));
        println!("{weight:?}: eta' = {s1:?}, eta'' = {c1:?} and {c2:?}");
        assert!(s1.overlaps(&s2) && s1.excludes_zero(), "one slope");
        assert!((c1 - c2).excludes_zero(), "two curvatures");
    }
}
