//! Where on the map the modes are: the sentences of sections 3 and 5 on friction and sliding.
//!
//! Two frictions belong to a purely rotational state: `M`, which the shoulder asks for, (17), and `m`,
//! which an inner joint asks for, (18). Both grow with the half opening, `M` is the larger one before
//! `T` and the smaller one beyond. All about mixed modes follows from this order, since an admissible
//! state with a hinge at the shoulder has at least the thrust of rotation, and one that slides there
//! has at most the half opening of rotation.

use super::along::{Along, landmark, on_all};
use super::curve::{one_joint_for_each_thickness, states_in_order};
use super::{Claim, Derivation, Finding, Support};
use crate::arch::{
    Configuration, Landmark, Ring, SelfWeight, contact, overturning, sliding, statics, thrust,
};
use crate::certify::Undecided;
use crate::number::{Angle, Ball, Dual, Enclosure, Field, Real, Surd, Ternary};
use crate::symbolic::{
    Fraction, Polynomial, Relations, Symbol, along_the_joint, along_the_opening,
};
use rug::Rational;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "sliding-states-in-order",
        place: "Sec. 2.2",
        statement: "to each half opening belongs one purely sliding state; as it grows, the friction \
                    grows and the thrust falls",
        decide: |d| {
            friction_slopes(d)?;
            friction_of_small_thrust(d)?;
            sliding_states_in_order(d)?;
            Ok(Finding::AsPrinted)
        },
    },
    Claim {
        id: "sliding-thrust-goes-flatly-to-zero",
        place: "Sec. 2.2",
        statement: "the thrust of the purely sliding states goes flatly to 0 as alpha -> pi",
        decide: |d| {
            thrust_of_large_friction(d)?;
            sliding_thrust_goes_flatly_to_zero(d)
        },
    },
    Claim {
        id: "dividing-lines-tend-to-eta-l",
        place: "Sec. 3",
        statement: "the lines beta_r = beta_s and beta_r = 0 tend to eta_l as mu -> inf",
        decide: dividing_lines_tend_to_the_end_of_rotation,
    },
    Claim {
        id: "friction-for-rotation-grows",
        place: "Sec. 5",
        statement: "along the purely rotational states the friction needed to prevent sliding grows \
                    with the half opening, and is unbounded at its end",
        decide: |d| {
            friction_slopes(d)?;
            one_joint_for_each_thickness(d)?;
            states_in_order(d)?;
            frictions_grow(d)?;
            friction_of_small_thrust(d)?;
            d.conclude("As h -> 0 at l, m is unbounded there.");
            Ok(Finding::AsPrinted)
        },
    },
    Claim {
        id: "rotation-meets-sliding-at-T",
        place: "Sec. 2.2, 3",
        statement: "the lines h(alpha) of the purely rotational and of the purely sliding states \
                    intersect at T and nowhere else; beyond T the friction that prevents inner sliding is \
                    higher than the one for the shoulder",
        decide: |d| {
            order_of_frictions(d)?;
            d.conclude(
                "At a given half opening mu_ss - mu_is grows with h and vanishes for the purely sliding \
                 state: the thrust of rotation is larger than that of sliding where M > m, before T, and \
                 smaller beyond.",
            );
            Ok(Finding::AsPrinted)
        },
    },
    Claim {
        id: "no-shoulder-sliding-beyond-T",
        place: "Sec. 3, 5",
        statement: "a friction above mu_T precludes any mixed sliding-rotational mode",
        decide: no_shoulder_sliding_beyond_t,
    },
    Claim {
        id: "inner-sliding-beyond-T",
        place: "Sec. 3, 5",
        statement: "modes with shoulder rotation and inner sliding are seen only on the right of T",
        decide: |d| {
            inner_sliding_beyond_t(d)?;
            Ok(Finding::AsPrinted)
        },
    },
    Claim {
        id: "overturning-sliding-beyond-J",
        place: "Sec. 3",
        statement: "overturning-sliding modes are seen only on the right of J",
        decide: overturning_sliding_beyond_j,
    },
    Claim {
        id: "no-pure-sliding-beyond-B",
        place: "Sec. 3, 5",
        statement: "a friction above mu_B precludes any purely sliding mode of thickness up to 2",
        decide: no_pure_sliding_beyond_b,
    },
];

fn ring() -> Ring<Fraction> {
    Ring::with_flag(&Symbol::Flag.number(), &Symbol::Thickness.number())
}

fn by(symbol: Symbol) -> [(Symbol, Polynomial); 1] {
    [(symbol, Polynomial::from(1))]
}

/// How (17) and (18) change with the half opening and the thrust.
pub(super) fn friction_slopes(d: &mut Derivation) -> Result<(), Undecided> {
    let (alpha, joint, h) = (Symbol::half_opening(), Symbol::joint(), Symbol::Thrust.number());
    let circle = Relations::trigonometric();
    let shoulder = sliding::shoulder(&alpha, &h).value();
    let normal = statics::normal_force(&alpha, &h).square();
    d.identity(
        "d mu_ss/d alpha",
        &shoulder.derivative(&along_the_opening()),
        &((alpha.rad.square() - (h.int(1) - &h) * &h) / &normal),
        &circle,
    )?;
    let words = "d mu_ss/dh";
    d.identity(words, &shoulder.derivative(&by(Symbol::Thrust)), &(alpha.rad / normal), &circle)?;
    let normal = statics::normal_force(&joint, &h);
    let ratio = statics::shear_force(&joint, &h) / &normal;
    d.identity(
        "d(T/N)/dh at a fixed joint; as T/N is stationary at beta_s, this is d mu_is/dh there",
        &ratio.derivative(&by(Symbol::Thrust)),
        &-(joint.rad.clone() / normal.square()),
        &circle,
    )?;
    d.identity(
        "d(T/N)/d beta",
        &ratio.derivative(&along_the_joint()),
        &-(sliding::steepest(&joint.rad, &h) / normal.square()),
        &circle,
    )?;
    d.conclude(
        "mu_ss grows with h, and with alpha from beta_s on; before, -T/N is not positive, since T/N is \
         0 at the crown and grows up to beta_s. mu_is falls as h grows.",
    );
    Ok(())
}

fn sliding_states_in_order(d: &mut Derivation) -> Result<(), Undecided> {
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let numerator = -statics::shear_force(&alpha, &h);
    let slope = numerator.derivative(&along_the_opening());
    let rest = alpha.rad.clone() * &alpha.sin - (h.int(1) - &h) * &alpha.cos;
    d.identity("d(-T)/d alpha", &slope, &rest, &Relations::none())?;
    d.conclude(
        "At h = 1 this is alpha sin(alpha), so that -T > 0 there. At a given half opening mu_is falls \
         from inf to 0 as h grows from 0 to 1, while mu_ss grows from -cot(alpha) to a positive number \
         or, if N vanishes before, to inf: there is one thrust at which they are equal. Along these states dh/d alpha = -(d mu_ss/d alpha)/(d mu_ss/dh \
         - d mu_is/dh) < 0, and mu = mu_is(h) grows.",
    );
    Ok(())
}

/// `mu_is` is unbounded for small thrusts.
fn friction_of_small_thrust(d: &mut Derivation) -> Result<(), Undecided> {
    let joint = Symbol::joint();
    let none = joint.rad.int(0);
    let shear = statics::shear_force(&joint, &none);
    let ratio = shear / statics::normal_force(&joint, &none);
    let cotangent = joint.cos / joint.sin;
    d.identity("T/N at any joint where h = 0", &ratio, &cotangent, &Relations::none())?;
    d.conclude(
        "mu_is(h) is at least T/N at any joint, which tends to cot(beta) as h -> 0: as beta may be as \
         small as one likes, mu_is(h) -> inf.",
    );
    Ok(())
}

/// `h <= 1/(4 mu²)` where an inner joint slides.
fn thrust_of_large_friction(d: &mut Derivation) -> Result<(), Undecided> {
    let (joint, h) = (Symbol::joint(), Symbol::Thrust.number());
    let (shear, normal) = (statics::shear_force(&joint, &h), statics::normal_force(&joint, &h));
    d.identity(
        "T/N, for 0 < beta_s <= 1/2, is below beta/(h + beta tan(beta))",
        &(joint.rad.clone() * &joint.cos / &normal - shear / &normal),
        &(h.clone() * &joint.sin / &normal),
        &Relations::none(),
    )?;
    let tangent = joint.sin.clone() / &joint.cos;
    d.identity(
        "the same bound",
        &(joint.rad.clone() * &joint.cos / &normal),
        &(joint.rad.clone() / (h.clone() + joint.rad.clone() * tangent)),
        &Relations::none(),
    )?;
    let root = Symbol::SquareRoot.number();
    let rooted = Relations::none().with(Symbol::SquareRoot, 2, Symbol::Thrust.polynomial());
    d.identity(
        "h + beta² - 2 √h beta, with q = √h",
        &(h.clone() + joint.rad.square() - h.int(2) * &root * &joint.rad),
        &(root - &joint.rad).square(),
        &rooted,
    )?;
    d.conclude("As tan(beta) > beta, mu_is <= beta/(h + beta²) <= 1/(2 √h): h <= 1/(4 mu²).");
    Ok(())
}

fn sliding_thrust_goes_flatly_to_zero(d: &mut Derivation) -> Result<Finding, Undecided> {
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let cotangent = alpha.cos.clone() / &alpha.sin;
    d.identity(
        "mu_ss + cot(alpha)",
        &(sliding::shoulder(&alpha, &h).value() + cotangent),
        &(h.clone() / (statics::normal_force(&alpha, &h) * &alpha.sin)),
        &Relations::trigonometric(),
    )?;
    d.conclude(
        "With N > 0, mu >= -cot(alpha), so that h <= tan²(alpha)/4, which vanishes at pi with its \
         slope.",
    );
    Ok(Finding::AsPrinted)
}

fn dividing_lines_tend_to_the_end_of_rotation(d: &mut Derivation) -> Result<Finding, Undecided> {
    thrust_of_large_friction(d)?;
    let (ring, eta) = (ring(), Symbol::Thickness.number());
    let limit = thrust::tangency(&eta.int(1), &ring);
    let words = "(5), cleared, for h -> 0 and beta -> 0, where beta cot(beta) -> 1";
    let condition = overturning::end_of_rotation(&ring);
    d.identity(
        words,
        &limit.residual(&eta.int(0)),
        &(eta.int(-2) * &condition),
        &Relations::none(),
    )?;
    let slope = -(eta.int(1) + Symbol::Flag.number() * &eta / eta.int(6));
    let words = "its slope to eta, up to the factor, is not zero";
    d.identity(words, &condition.derivative(&by(Symbol::Thickness)), &slope, &Relations::none())?;
    for (weight, end) in [
        (SelfWeight::Heyman, Surd::rational(1, 3)),
        (SelfWeight::Milankovitch, Surd::new(-6, 4, 3)),
    ] {
        let value = overturning::end_of_rotation(&Ring::new(weight, &end));
        let words = format!("it vanishes at eta_l = {end}, {} weight", weight.name());
        d.equal(words, &value, &end.int(0))?;
    }
    d.conclude(
        "On either line beta_r <= beta_s <= √h, and h <= 1/(4 mu²): as mu -> inf, (5) tends to this \
         condition, whose only root in (0, 2) is eta_l.",
    );
    Ok(Finding::AsPrinted)
}

/// `M` and `m` grow along rotation.
pub(super) fn frictions_grow(d: &mut Derivation) -> Result<(), Undecided> {
    let alpha = Symbol::half_opening();
    let Angle { rad, sin, cos } = alpha.clone();
    let one = rad.int(1);
    let bound = |x: &Ball| {
        let Angle { rad, sin, cos } = Angle::new(x.clone());
        sin - rad.clone() / rad.int(4) - rad.ratio(3, 4) * &rad * cos
    };
    let least = rad.ratio(3, 4) * &rad * alpha.versine() - (rad.clone() - &sin);
    let shown = sin - rad.clone() / rad.int(4) - rad.ratio(3, 4) * &rad * cos;
    d.identity("3/4 alpha (1 - cos) - (alpha - sin)", &least, &shown, &Relations::none())?;
    let term = |n: i32, m: i32, power: usize| {
        Fraction::from(Symbol::HalfOpening.polynomial().power(power)) * one.ratio(n, m)
    };
    let sine = term(1, 1, 1) - term(1, 6, 3);
    let cosine = one.clone() - term(1, 2, 2) + term(1, 24, 4);
    let below = sine - term(1, 4, 1) - term(3, 4, 1) * cosine;
    d.identity(
        "it is at least this, by sin >= alpha - alpha³/6 and cos <= 1 - alpha²/2 + alpha⁴/24; \
         positive for 0 < alpha <= 5/2",
        &below,
        &(term(5, 24, 3) - term(1, 32, 5)),
        &Relations::none(),
    )?;
    let (low, high) = (Rational::from((5, 2)), Rational::from((315, 100)));
    d.positive("sin - alpha/4 - 3/4 alpha cos", (&low, &high), bound)?;
    d.conclude(
        "On the curve h >= A - 1, since 2 fac/(2 + eta) <= 1, and A = 2 x cot(x) >= 2 - x² with x = \
         alpha/2, so that h (1-h) <= 1 - h <= alpha²/4. In N² dM = (alpha² - h (1-h)) d alpha + alpha dh \
         both A and A - h fall, so that d alpha >= -dh (1 - cos)/(alpha - sin): N² dM is at least -dh \
         times (3/4 alpha² (1 - cos)/(alpha - sin) - alpha), which is positive. So M grows with alpha; m \
         = mu_is(h) grows, since h falls.",
    );
    Ok(())
}

/// `M > m` before `T` and `M < m` beyond.
fn order_of_frictions(d: &mut Derivation) -> Result<(), Undecided> {
    friction_slopes(d)?;
    one_joint_for_each_thickness(d)?;
    states_in_order(d)?;
    frictions_grow(d)?;
    small_openings(d)?;
    for weight in SelfWeight::ALL {
        let name = weight.name();
        let (before, beyond) = around(&landmark(Landmark::Triple, weight)?.half_opening.rad, 1000)?;
        let end = landmark(Landmark::RotationEnd, weight)?.half_opening;
        let rotational = |alpha: &Rational| Along::rotational(weight, alpha);
        let ranges = on_all((&Rational::from((1, 2)), &before), &rotational, &|a, b| {
            b.inner_friction().is_less_than(&a.shoulder_friction())
        });
        d.certain(Support::Balls, format!("M > m from 1/2 up to {before}, {name}"), told(ranges)?)?;
        let all = rotational(&before)?.up_to(&rotational(&beyond)?)?;
        // There the joint falls with the half opening, as all else is monotone too.
        let widest = landmark(Landmark::WidestJoint, weight)?.half_opening.rad;
        let words = format!("alpha_sb < {before}, {name}");
        d.certain(
            Support::Balls,
            words,
            widest.is_less_than(&Ball::enclosing(&before, widest.prec())),
        )?;
        let slope = -all.friction_gap_slope()?;
        let words = format!("M - m falls from {before} to {beyond}, which holds alpha_T, {name}");
        d.certain(Support::Balls, words, slope.is_positive())?;
        let last: Rational = below(&end.rad, 100)?;
        let ranges = on_all((&beyond, &last), &rotational, &|a, b| {
            b.shoulder_friction().is_less_than(&a.inner_friction())
        });
        d.certain(Support::Balls, format!("M < m from {beyond} to {last}, {name}"), told(ranges)?)?;
        let limit = sliding::shoulder(&end, &end.rad.int(0)).value();
        let words = format!("M < m from {last} to alpha_l, where h = 0, {name}");
        let order = limit.is_less_than(&rotational(&last)?.inner_friction());
        d.certain(Support::Balls, words, order)?;
    }
    d.conclude(
        "M, m grow with alpha, so that the values at the ends of a range speak for all of it. M = m at \
         T, by (17) and (18): M > m before and M < m beyond.",
    );
    Ok(())
}

fn told(ranges: Result<usize, Undecided>) -> Result<Ternary, Undecided> {
    ranges.map(|_| Ternary::True)
}

/// Multiples of `1/scale` around a value, a little apart from it.
fn around(value: &Ball, scale: i32) -> Result<(Rational, Rational), Undecided> {
    let low = multiple(value, scale)?;
    Ok((Rational::from((low - 1, scale)), Rational::from((low + 2, scale))))
}

/// A multiple of `1/scale` close below a value.
fn below(value: &Ball, scale: i32) -> Result<Rational, Undecided> {
    Ok(Rational::from((multiple(value, scale)? - 1, scale)))
}

fn multiple(value: &Ball, scale: i32) -> Result<i32, Undecided> {
    let scaled = (value.clone() * value.int(scale)).lower();
    let integer = scaled.floor().to_integer().and_then(|n| n.to_i32());
    integer.ok_or_else(|| Undecided("an unbounded landmark".into()))
}

/// `M > m` for `alpha <= 1/2`, from Taylor's theorem.
fn small_openings(d: &mut Derivation) -> Result<(), Undecided> {
    let one = Symbol::HalfOpening.number().int(1);
    let term = |n: i32, m: i32, power: usize| {
        Fraction::from(Symbol::HalfOpening.polynomial().power(power)) * one.ratio(n, m)
    };
    let free = Relations::none();
    // A >= 2 - alpha²/5, times 1 - cos.
    let versine = term(1, 2, 2) - term(1, 24, 4) + term(1, 720, 6);
    let sine = term(1, 1, 1) - term(1, 6, 3);
    let excess = term(1, 1, 1) * &sine - (term(2, 1, 0) - term(1, 5, 2)) * versine;
    d.identity(
        "alpha sin - (2 - alpha²/5)(1 - cos) is at least this, positive for 0 < alpha <= 1",
        &excess,
        &(term(1, 60, 4) - term(1, 90, 6) + term(1, 3600, 8)),
        &free,
    )?;
    let cosine = term(1, 1, 0) - term(1, 2, 2) + term(1, 24, 4);
    let shear = sine - term(1, 1, 1) * &cosine - term(1, 5, 2) * term(1, 1, 1);
    d.identity(
        "so y = 1 - h <= alpha²/5, and sin - alpha cos - y sin is at least this",
        &shear,
        &(term(2, 15, 3) - term(1, 24, 5)),
        &free,
    )?;
    let normal = cosine + term(1, 1, 2);
    d.identity(
        "N <= cos + alpha sin is at most this",
        &normal,
        &(term(1, 1, 0) + term(1, 2, 2) + term(1, 24, 4)),
        &free,
    )?;
    // In z = alpha²: (M/alpha³)² > (m/alpha³)², with m² <= y³/(1 - y).
    let margin = |z: &Ball| {
        let shear = z.ratio(2, 15) - z.ratio(1, 24) * z;
        let normal = z.int(1) + z.ratio(1, 2) * z + z.ratio(1, 24) * z.square();
        (shear / normal).square() - z.ratio(1, 125) / (z.int(1) - z.ratio(1, 5) * z)
    };
    let (low, high) = (Rational::new(), Rational::from((1, 4)));
    d.positive(
        "the lower bound of M² less y³/(1-y), over alpha⁶, in alpha²,",
        (&low, &high),
        margin,
    )?;
    d.conclude(
        "T(beta) <= y beta and N >= h = 1 - y at beta_s = √(y (1-y)), so that m <= y^(3/2)/√(1-y), \
         which grows with y; so M > m for alpha <= 1/2.",
    );
    Ok(())
}

/// All variables as letters.
fn letters() -> Configuration<Fraction> {
    Configuration {
        half_opening: Symbol::half_opening(),
        rotation_joint: Symbol::joint(),
        sliding_joint: Symbol::joint(),
        thickness: Symbol::Thickness.number(),
        thrust: Symbol::Thrust.number(),
        friction: Symbol::Friction.number(),
    }
}

/// The shoulder's distance from the extrados with the crown's pressure point on the extrados.
fn shoulder_margin(d: &mut Derivation) -> Result<(), Undecided> {
    let at = letters();
    for weight in SelfWeight::ALL {
        let ring = Ring::new(weight, &at.thickness);
        let whole = thrust::whole(&at.half_opening, &ring);
        let margin = contact::extrados_margin_at_shoulder(weight, &at, &contact::crown_moment(&at));
        let expected = (whole.value() - &at.thrust) * whole.denominator / at.thrust.int(2);
        let words = format!(
            "the distance of the shoulder from the extrados, if the crown is on it, is h_2 - h up to \
             a positive factor, {} weight",
            weight.name()
        );
        d.identity(words, &margin, &expected, &Relations::none())?;
    }
    Ok(())
}

/// `N` and `U` along an arch first grow and then fall.
fn distances_rise_and_fall(d: &mut Derivation) -> Result<(), Undecided> {
    let (joint, h, ring) = (Symbol::joint(), Symbol::Thrust.number(), ring());
    let (rules, circle) = (along_the_joint(), Relations::trigonometric());
    let normal = statics::normal_force(&joint, &h);
    let rise = h.int(1) - &h + joint.times_cotangent();
    let words = "dN/d beta";
    d.identity(words, &normal.derivative(&rules), &(joint.sin.clone() * &rise), &circle)?;
    let distance = ring.extrados() * &normal / h.int(2) - joint.versine() * &ring.centroid_factor;
    let slope = ring.extrados() * rise / h.int(2) - &ring.centroid_factor;
    let words = "dU/d beta, U = (1 + eta/2) N - p - fac (1 - cos(beta))";
    d.identity(words, &distance.derivative(&rules), &(slope * &joint.sin), &circle)?;
    let bow = joint.rad.clone() - joint.sin.clone() * &joint.cos;
    d.identity(
        "d(beta cot(beta))/d beta, negative",
        &joint.times_cotangent().derivative(&rules),
        &-(bow / joint.sin.square()),
        &circle,
    )?;
    d.conclude(
        "As beta cot(beta) falls, either slope changes its sign at most once, from + to -: N and U are \
         positive between two joints where they are.",
    );
    Ok(())
}

fn no_shoulder_sliding_beyond_t(d: &mut Derivation) -> Result<Finding, Undecided> {
    order_of_frictions(d)?;
    shoulder_margin(d)?;
    distances_rise_and_fall(d)?;
    d.conclude(
        "An admissible state [s,r,r] has (2) and (5), so it lies on the curve of rotation: its \
         thickness and thrust are those of a rotational state of half opening alpha_0. The shoulder \
         within the extrados means A(alpha) >= h + 2 fac/(2 + eta) = A(alpha_0), alpha <= alpha_0. So mu \
         = mu_ss(alpha, h) <= M(alpha_0), as mu_ss grows with alpha. And mu >= m(alpha_0). So M >= m: \
         alpha_0 <= alpha_T, and mu <= M(alpha_0) <= mu_T.",
    );
    Ok(Finding::AsPrinted)
}

fn inner_sliding_beyond_t(d: &mut Derivation) -> Result<(), Undecided> {
    order_of_frictions(d)?;
    shoulder_margin(d)?;
    distances_rise_and_fall(d)?;
    let (at, ring) = (letters(), ring());
    let joint = &at.rotation_joint;
    let lower = thrust::lower(joint, &ring);
    let two = at.thrust.int(2);
    let normal = statics::normal_force(joint, &at.thrust);
    let distances = (ring.extrados() * &at.thrust - ring.intrados() * normal) / &two
        + joint.versine() * &ring.centroid_factor;
    d.identity(
        "the distances of the crown from the extrados and of a joint from the intrados add up to h - \
         h_L up to a positive factor",
        &distances,
        &(lower.residual(&at.thrust) / &two),
        &Relations::none(),
    )?;
    let h = lower.value();
    let whole = h.clone() + overturning::opening_variable(&ring).value();
    let further = two.clone() * &at.thickness * &h / (ring.intrados() * joint.versine())
        + two.clone() * &ring.centroid_factor * (two.clone() * &at.thickness)
            / (ring.intrados() * ring.extrados());
    d.identity(
        "A(beta) less A(alpha) on the curve: positive, so that beta_r < alpha",
        &(thrust::opening_variable(joint).value() - whole),
        &further,
        &Relations::none(),
    )?;
    d.conclude(
        "Let a state be admissible with the shoulder on the extrados, and alpha_0 the half opening of \
         the rotational state of the same thrust h. Then alpha >= alpha_0: else the rotational thrust \
         at alpha is larger than h. The crown within the extrados gives A(alpha) <= h + 2 fac/(2+eta), \
         so that eta is smaller than at the rotational state of alpha. Then the joint of the rotational \
         state of thickness eta is a joint of the arch, and there h >= h_L, the thrust of that \
         state, which is larger still: a contradiction.",
    );
    d.conclude(
        "If besides an inner joint slides, mu = m(alpha_0), and the shoulder gives mu >= mu_ss(alpha, h) \
         >= M(alpha_0), as mu_ss grows with alpha. So M <= m: alpha_0 >= alpha_T, and mu >= mu_T. This is \
         so for [r,r,s], [r,s,r] and [r,s].",
    );
    Ok(())
}

/// `U` at the shoulder where the crown's pressure point is on the intrados.
fn margin_from_intrados<T: Field>(ring: &Ring<T>, alpha: &Angle<T>, h: &T) -> T {
    let normal = statics::normal_force(alpha, h);
    (ring.extrados() * normal - ring.intrados() * h) / h.int(2)
        - alpha.versine() * &ring.centroid_factor
}

/// The thickness at which `h` is the thrust of (5) in the limit `beta -> 0`.
fn thickness_at_crown<T: Real>(weight: SelfWeight, h: &T) -> T {
    let (one, half) = (h.int(1), h.int(1) - h.ratio(1, 2) * h);
    match weight {
        SelfWeight::Heyman => (one - h) / half,
        SelfWeight::Milankovitch => {
            let root = (half.square() + (one - h) / h.int(3)).sqrt();
            (root - half) * h.int(6)
        }
    }
}

fn overturning_sliding_beyond_j(d: &mut Derivation) -> Result<Finding, Undecided> {
    inner_sliding_beyond_t(d)?;
    sliding_states_in_order(d)?;
    let at = letters();
    let ring = ring();
    let upper = thrust::upper(&at.half_opening, &Angle::zero(&at.thrust), &ring);
    let margin = margin_from_intrados(&ring, &at.half_opening, &at.thrust);
    let words = "U at the shoulder with L = 0 at the crown is half of (3) at beta = 0, cleared";
    let half = -(upper.residual(&at.thrust) / at.thrust.int(2));
    d.identity(words, &margin, &half, &Relations::none())?;
    // The thickness of (5) at the crown: the root is the larger one of its quadratic.
    let (h, q) = (Symbol::Thrust.number(), Symbol::SquareRoot.number());
    let inner = h.int(1) - h.ratio(1, 2) * &h;
    let radicand = inner.square() + (h.int(1) - &h) / h.int(3);
    let rooted = Relations::none().with(Symbol::SquareRoot, 2, radicand.numerator().clone());
    let cases = [
        (SelfWeight::Heyman, (h.int(1) - &h) / &inner),
        (SelfWeight::Milankovitch, (q - &inner) * h.int(6)),
    ];
    for (weight, thickness) in cases {
        let at = Configuration { thickness, ..letters() };
        let slope = contact::crown_slope(weight, &at);
        let words = format!("the slope at the crown vanishes at eta_c, {} weight", weight.name());
        d.identity(words, &slope, &h.int(0), &rooted)?;
    }
    for weight in SelfWeight::ALL {
        let name = weight.name();
        let crown = |alpha: &Angle<Ball>, h: &Ball| {
            margin_from_intrados(&Ring::new(weight, &thickness_at_crown(weight, h)), alpha, h)
        };
        let crown_dual = |alpha: &Angle<Dual<Ball>>, h: &Dual<Ball>| {
            margin_from_intrados(&Ring::new(weight, &thickness_at_crown(weight, h)), alpha, h)
        };
        let limit = |alpha: &Angle<Ball>, h: &Ball| {
            margin_from_intrados(&Ring::new(weight, &h.int(2)), alpha, h)
        };
        let sliding = |alpha: &Rational| Along::sliding(alpha);
        let start = below(&landmark(Landmark::Triple, weight)?.half_opening.rad, 100)?;
        let (before, beyond) =
            around(&landmark(Landmark::Junction, weight)?.half_opening.rad, 100)?;
        let positive = |margin: &dyn Fn(&Angle<Ball>, &Ball) -> Ball, a: &Along, b: &Along| {
            a.up_to(b)
                .map_or(Ternary::Undecided, |all| margin(&all.alpha, &all.thrust).is_positive())
        };
        let ranges = on_all((&start, &before), &sliding, &|a, b| positive(&crown, a, b));
        let words = format!("U at eta_c along sliding from {start} to {before}, {name}");
        d.certain(Support::Balls, words, told(ranges)?)?;
        let all = sliding(&before)?.up_to(&sliding(&beyond)?)?;
        let slope = -all.slope_along_sliding(crown_dual);
        let words = format!("it falls from {before} to {beyond}, which holds alpha_J, {name}");
        d.certain(Support::Balls, words, slope.is_positive())?;
        let ranges = on_all((&start, &beyond), &sliding, &|a, b| positive(&limit, a, b));
        let words = format!("U at eta = 2 along sliding from {start} to {beyond}, {name}");
        d.certain(Support::Balls, words, told(ranges)?)?;
    }
    d.conclude(
        "A state [r,s] has L = 0 at the crown, with a slope that is not negative and grows with eta, so \
         eta >= eta_c(h), and U = 0 at the shoulder. Let mu_T <= mu < mu_J, so that h_J < h <= h_T, and alpha_s the \
         half opening of the purely sliding state of thrust h, alpha_T <= alpha_s < alpha_J. The \
         shoulder does not slide, so alpha <= alpha_s. But U at alpha_s is positive: it is so at eta_c \
         and at eta = 2, and is concave in eta. As U along an arch first grows and then falls, from eta h \
         > 0 at the crown, it is positive up to alpha_s: a contradiction. So mu >= mu_J.",
    );
    Ok(Finding::AsPrinted)
}

fn no_pure_sliding_beyond_b(d: &mut Derivation) -> Result<Finding, Undecided> {
    friction_slopes(d)?;
    sliding_states_in_order(d)?;
    let (n, eta) = (Symbol::OpeningVariable.number(), Symbol::Thickness.number());
    let margin = |weight| {
        let ring = Ring::new(weight, &eta);
        ring.extrados() * &n / eta.int(2) - ring.centroid_factor
    };
    let free = Relations::none();
    d.identity(
        "the largest U at the shoulder over 1 - cos, with n = N/(1 - cos), Heyman's weight: linear",
        &margin(SelfWeight::Heyman),
        &((eta.int(2) - &eta) / eta.int(2) * (n.clone() - n.int(1))
            + eta.clone() / eta.int(2) * (n.int(2) * &n - n.int(1))),
        &free,
    )?;
    let top = (n.int(3) * &n - n.int(2)) * (n.clone() + n.int(2)) / n.int(4);
    d.identity(
        "the same for Milankovitch's weight: a top at eta = 3n",
        &margin(SelfWeight::Milankovitch),
        &(top - (eta.clone() - n.int(3) * &n).square() / n.int(12)),
        &free,
    )?;
    d.conclude("It is negative for all eta in (0, 2] if n < 1/2 (Heyman), n < 2/3 (Milankovitch).");
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let normal = statics::normal_force(&alpha, &h) / alpha.versine();
    let opening = thrust::opening_variable(&alpha).value();
    let rest = h * &alpha.cos / alpha.versine();
    d.identity("n, with cos < 0 below A", &normal, &(opening + rest), &free)?;
    for weight in SelfWeight::ALL {
        let name = weight.name();
        let sliding = |alpha: &Rational| Along::sliding(alpha);
        let border = landmark(Landmark::Border, weight)?.half_opening.rad;
        let end = landmark(Landmark::OverturningEnd, weight)?.half_opening;
        let (before, beyond) = around(&border, 1000)?;
        let all = sliding(&before)?.up_to(&sliding(&beyond)?)?;
        let slope =
            -all.slope_along_sliding(|alpha, h| statics::normal_force(alpha, h) / alpha.versine());
        let words = format!("n falls from {before} to {beyond}, which holds alpha_B, {name}");
        d.certain(Support::Balls, words, slope.is_positive())?;
        // A(alpha) passes below the bound at L.
        let bound = match weight {
            SelfWeight::Heyman => Rational::from((1, 2)),
            SelfWeight::Milankovitch => Rational::from((2, 3)),
        };
        let bound = Ball::enclosing(&bound, 128);
        let last = below(&end.rad, 1000)?;
        // The first part falls with alpha, the second with h and, as cos/(1 - cos) does, with alpha.
        let largest = |alpha: &Angle<Ball>, thrust: &Ball| {
            thrust::opening_variable(alpha).value() + thrust.clone() * &alpha.cos / alpha.versine()
        };
        let ranges = on_all((&beyond, &last), &sliding, &|a, b| {
            largest(&a.alpha, &b.thrust).is_less_than(&bound)
        });
        let words = format!("n is below the bound from {beyond} to {last}, {name}");
        d.certain(Support::Balls, words, told(ranges)?)?;
        let least = Ball::enclosing(&Rational::from((1, 50)), 128);
        let joint = Angle::new((least.clone() * (least.int(1) - &least)).sqrt());
        let (inner, shoulder) =
            (sliding::inner(&joint, &least).value(), sliding::shoulder(&end, &least).value());
        let words = format!("mu_ss < mu_is at alpha_L for h = 1/50, so h is larger there, {name}");
        d.certain(Support::Balls, words, shoulder.is_less_than(&inner))?;
        let normal = statics::normal_force(&end, &least);
        d.certain(Support::Balls, format!("N > 0 there, {name}"), normal.is_positive())?;
        let value = largest(&Angle::new(Ball::enclosing(&last, 128)), &least);
        let words = format!("n is below the bound from {last} to alpha_L, {name}");
        d.certain(Support::Balls, words, value.is_less_than(&bound))?;
    }
    d.conclude(
        "At B n is the bound, by (3) at eta = 2; beyond it n is below, and from alpha_L on so is A, \
         above n. A friction above mu_B makes alpha > alpha_B along the purely sliding states, where U \
         at the shoulder is negative for every thickness up to 2, wherever the thrust acts.",
    );
    Ok(Finding::AsPrinted)
}
