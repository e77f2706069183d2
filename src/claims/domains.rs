//! Where on the map the modes are: T, J and B as limits of the modes, sections 3 and 5.
//!
//! All about mixed modes follows from the order of the two frictions along rotation, since an admissible
//! state with a hinge at the shoulder has at least the thrust of rotation, and one that slides there has
//! at most the half opening of rotation.

use super::along::{Along, around, below, landmark, on_all};
use super::curve::STATES_IN_ORDER;
use super::frictions::{
    FRICTION_FOR_ROTATION_GROWS, ROTATION_MEETS_SLIDING, SLIDING_STATES_IN_ORDER,
    SLOPES_OF_FRICTION,
};
use super::letters::{ring, variables};
use super::{Claim, Derivation, Finding, Support};
use crate::arch::{
    Configuration, Ring, SelfWeight, contact, overturning, sliding, statics, thrust,
};
use crate::certify::Undecided;
use crate::number::{Angle, Ball, Dual, Enclosure, Field, Real, Ternary};
use crate::problem::Landmark;
use crate::symbolic::{Letters, Relations, Symbol, along_the_joint};
use rug::Rational;

pub(super) const CLAIMS: &[Claim] = &[
    DISTANCES_RISE_AND_FALL,
    Claim {
        id: "map-T-shoulder",
        place: "Sec. 3, 5",
        statement: "a friction above mu_T precludes any mixed sliding-rotational mode; its thickness is at \
                    most eta_T and its half opening at most alpha_T",
        decide: no_shoulder_sliding_beyond_t,
    },
    INNER_SLIDING_BEYOND_T,
    Claim {
        id: "map-J",
        place: "Sec. 3",
        statement: "overturning-sliding modes are seen only on the right of J, and above it",
        decide: overturning_sliding_beyond_j,
    },
    Claim {
        id: "map-B",
        place: "Sec. 3, 5",
        statement: "a friction above mu_B precludes any purely sliding mode of thickness up to 2",
        decide: no_pure_sliding_beyond_b,
    },
];

pub(super) const DISTANCES_RISE_AND_FALL: Claim = Claim {
    id: "map-distances",
    place: "Sec. 2.1",
    statement: "along an admissible arch the normal force N and the distance U from the extrados first \
                grow and then fall",
    decide: distances_rise_and_fall,
};

pub(super) const INNER_SLIDING_BEYOND_T: Claim = Claim {
    id: "map-T-inner",
    place: "Sec. 3, 5",
    statement: "modes with shoulder rotation and inner sliding are seen only on the right of T, and \
                above it",
    decide: inner_sliding_beyond_t,
};

/// The shoulder's distance from the extrados with the crown's pressure point on the extrados.
fn shoulder_margin(d: &mut Derivation) -> Result<(), Undecided> {
    let at = variables();
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
fn distances_rise_and_fall(d: &mut Derivation) -> Result<Finding, Undecided> {
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
    Ok(Finding::Implicit)
}

fn no_shoulder_sliding_beyond_t(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&STATES_IN_ORDER)?;
    d.lemma(&SLOPES_OF_FRICTION)?;
    d.lemma(&FRICTION_FOR_ROTATION_GROWS)?;
    d.lemma(&ROTATION_MEETS_SLIDING)?;
    d.lemma(&DISTANCES_RISE_AND_FALL)?;
    shoulder_margin(d)?;
    d.conclude(
        "An admissible state [s,r,r] has (2) and (5), so it lies on the curve of rotation: its \
         thickness and thrust are those of a rotational state of half opening alpha_0. The shoulder \
         within the extrados means A(alpha) >= h + 2 fac/(2 + eta) = A(alpha_0), alpha <= alpha_0. So mu \
         = mu_ss(alpha, h) <= M(alpha_0), as mu_ss grows with alpha. And mu >= m(alpha_0). So M >= m: \
         alpha <= alpha_0 <= alpha_T, eta <= eta_T, and mu <= M(alpha_0) <= mu_T.",
    );
    Ok(Finding::AsPrinted)
}

fn inner_sliding_beyond_t(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&STATES_IN_ORDER)?;
    d.lemma(&SLOPES_OF_FRICTION)?;
    d.lemma(&FRICTION_FOR_ROTATION_GROWS)?;
    d.lemma(&ROTATION_MEETS_SLIDING)?;
    d.lemma(&DISTANCES_RISE_AND_FALL)?;
    shoulder_margin(d)?;
    let (at, ring) = (variables(), ring());
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
         >= M(alpha_0), as mu_ss grows with alpha. So M <= m: alpha_0 >= alpha_T, h <= h_T and mu >= mu_T. \
         Were \
         eta < eta_T, the joint of the rotational state of that thickness would be a joint of the arch, \
         with h >= h_L > h_T: so eta >= eta_T. This is so for [r,r,s], [r,s,r] and [r,s].",
    );
    Ok(Finding::AsPrinted)
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
    d.lemma(&SLOPES_OF_FRICTION)?;
    d.lemma(&INNER_SLIDING_BEYOND_T)?;
    d.lemma(&SLIDING_STATES_IN_ORDER)?;
    d.lemma(&DISTANCES_RISE_AND_FALL)?;
    let at = variables();
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
        let at = Configuration { thickness, ..variables() };
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
        let truth = on_all((&start, &before), &sliding, &|a, b| positive(&crown, a, b));
        let words = format!("U at eta_c along sliding from {start} to {before}, {name}");
        d.certain(Support::Balls, words, truth?)?;
        let all = sliding(&before)?.up_to(&sliding(&beyond)?)?;
        let slope = -all.slope_along_sliding(crown_dual);
        let words = format!("it falls from {before} to {beyond}, which holds alpha_J, {name}");
        d.certain(Support::Balls, words, slope.is_positive())?;
        let truth = on_all((&start, &beyond), &sliding, &|a, b| positive(&limit, a, b));
        let words = format!("U at eta = 2 along sliding from {start} to {beyond}, {name}");
        d.certain(Support::Balls, words, truth?)?;
    }
    d.conclude(
        "A state [r,s] has L = 0 at the crown, with a slope that is not negative and grows with eta, so \
         eta >= eta_c(h), and U = 0 at the shoulder. Let mu_T <= mu < mu_J, so that h_J < h <= h_T, and alpha_s the \
         half opening of the purely sliding state of thrust h, alpha_T <= alpha_s < alpha_J. The \
         shoulder does not slide, so alpha <= alpha_s. But U at alpha_s is positive: it is so at eta_c \
         and at eta = 2, and is concave in eta. As U along an arch first grows and then falls, from eta h \
         > 0 at the crown, it is positive up to alpha_s: a contradiction. So mu >= \
         mu_J, h <= h_J and eta >= eta_c(h) >= eta_c(h_J) = eta_J, as eta_c falls with h.",
    );
    Ok(Finding::AsPrinted)
}

fn no_pure_sliding_beyond_b(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&SLIDING_STATES_IN_ORDER)?;
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
        let truth = on_all((&beyond, &last), &sliding, &|a, b| {
            largest(&a.alpha, &b.thrust).is_less_than(&bound)
        });
        let words = format!("n is below the bound from {beyond} to {last}, {name}");
        d.certain(Support::Balls, words, truth?)?;
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
