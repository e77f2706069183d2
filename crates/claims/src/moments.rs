//! Moments, tangency and centroids: (2)–(6).

use super::letters::ring;
use super::{Checked, Derivation, claims};
use crate::arch::{Ring, statics, thrust};
use crate::number::{Angle, Dual, Field};
use crate::symbolic::{Fraction, Letters, Symbol};

claims! {
    AsPrinted("eq-2", "Eq. (2)", lower):
        "h_L is the thrust that puts the line of thrust on the extrados at the crown and on the intrados at beta";
    AsPrinted("eq-3", "Eq. (3)", upper):
        "h_U is the thrust that puts the line of thrust on the intrados at beta and on the extrados at the shoulder";
    AsPrinted("eq-4", "Eq. (4)", whole):
        "h_2 is the thrust that puts the line of thrust on the extrados at the crown and at the shoulder";
    AsPrinted("eq-4-forms", "Eq. (4)", opening_variable_forms):
        "A(alpha) = alpha sin(alpha)/(1 - cos(alpha)) = alpha cot(alpha/2)";
    Implicit("eq-2-4-imply-3", "Sec. 2.1", upper_follows): "(3) follows from (2) and (4)";
    AsPrinted("eq-5", "Eq. (5)", tangency):
        "h_e is the thrust at which the line of thrust is tangent to the intrados at beta";
    AsPrinted("eq-5-forms", "Eq. (5)", tangency_forms): "both printed forms of h_e are equal";
    AsPrinted("eq-6", "Eq. (6)", centroid):
        "the centroid of an infinitesimal wedge of the ring lies at the radius r (1 + eta^2/12), and fac_M >= 1";
    AsPrinted("eq-5-thin", "Eq. (5)", thin_arch):
        "Heyman's beta cot(beta) is what is left of h_e for a thin arch, with either weight";
    AsPrinted("rotation-friction", "Sec. 2.2", no_friction): "(2)-(5) see no friction";
}

/// `eta/2`, the distance of a face from the centreline.
fn half() -> Fraction {
    Symbol::Thickness.number() / Symbol::Thickness.number().int(2)
}

/// `2 N (e - target)` at a joint, with the eccentricity `crown` at the crown: zero where the pressure point has the
/// eccentricity `target`.
fn miss(joint: &Angle<Fraction>, crown: &Fraction, target: &Fraction) -> Fraction {
    let h = Symbol::Thrust.number();
    let e = statics::eccentricity(joint, &h, crown, &ring().centroid_factor);
    statics::normal_force(joint, &h) * &(e - target) * target.int(2)
}

const NORMAL: &str = "N != 0 at the joints: else there is no pressure point";

/// Checks that an equation without its denominator says how far pressure points miss the faces.
fn misses(
    d: &mut Derivation,
    [denominator, name, words]: [&str; 3],
    residual: &Fraction,
    miss: Fraction,
) -> Checked {
    d.assume(NORMAL);
    d.assume(denominator);
    d.define(name, residual);
    d.identity(words, miss, residual)
}

fn lower(d: &mut Derivation) -> Checked {
    let (joint, half) = (Symbol::joint(), half());
    let words = [
        "2 + eta - (2-eta) cos(beta) != 0",
        "(2) without its denominator, h [2 + eta - (2-eta) C] - …",
        "2 N (e + eta/2) at beta, with e0 = eta/2 at the crown, is the same",
    ];
    let residual = thrust::lower(&joint, &ring()).residual(&Symbol::Thrust.number());
    misses(d, words, &residual, miss(&joint, &half, &-half.clone()))
}

fn upper(d: &mut Derivation) -> Checked {
    let (joint, shoulder, half) = (Symbol::joint(), Symbol::half_opening(), half());
    let words = [
        "(2-eta) cos(beta) - (2+eta) cos(alpha) != 0",
        "(3) without its denominator",
        "2 N (e - eta/2) at alpha minus 2 N (e + eta/2) at beta, for any e0 at the crown",
    ];
    let residual = thrust::upper(&shoulder, &joint, &ring()).residual(&Symbol::Thrust.number());
    let crown = Symbol::CrownEccentricity.number();
    let both = miss(&shoulder, &crown, &half) - miss(&joint, &crown, &-half.clone());
    misses(d, words, &residual, both)
}

fn whole(d: &mut Derivation) -> Checked {
    let (shoulder, ring, half) = (Symbol::half_opening(), ring(), half());
    let words = [
        "(1 - cos(alpha)) (2 + eta) != 0",
        "(4) without its denominator",
        "2 N (e - eta/2) at alpha, with e0 = eta/2 at the crown, is the same",
    ];
    let whole = thrust::whole(&shoulder, &ring);
    let residual = whole.residual(&Symbol::Thrust.number());
    misses(d, words, &residual, miss(&shoulder, &half, &half))?;
    let opening = thrust::opening_variable(&shoulder).value();
    let printed = opening - ring.centroid_factor.int(2) * &ring.centroid_factor / ring.extrados();
    d.identity("h_2 = A - 2 fac_M/(2 + eta)", whole.value(), &printed)
}

fn opening_variable_forms(d: &mut Derivation) -> Checked {
    let half = Symbol::joint();
    d.assume("sin(alpha/2) != 0");
    d.assume("S = sin(alpha/2), C = cos(alpha/2): sin(alpha) = 2 S C, cos(alpha) = 1 - 2 S^2");
    let alpha = Angle {
        rad: Symbol::HalfOpening.number(),
        sin: half.sin.int(2) * &half.sin * &half.cos,
        cos: half.sin.int(1) - half.sin.int(2) * half.sin.square(),
    };
    let circle = alpha.sin.square() + alpha.cos.square();
    d.on_circle("they lie on the circle", &circle, half.sin.int(1))?;
    let cotangent = alpha.rad.clone() * &half.cos / &half.sin;
    let value = thrust::opening_variable(&alpha).value();
    d.identity("A = alpha C/S", &value, &cotangent)
}

fn upper_follows(d: &mut Derivation) -> Checked {
    let (joint, shoulder, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let h = Symbol::Thrust.number();
    d.assume("the denominators of (2), (3), (4) do not vanish");
    let second = thrust::lower(&joint, &ring).residual(&h);
    let third = thrust::upper(&shoulder, &joint, &ring).residual(&h);
    let fourth = thrust::whole(&shoulder, &ring).residual(&h);
    d.define("(2) without its denominator", &second);
    d.define("(4) without its denominator", &fourth);
    let combination = fourth - second;
    d.identity("(4) minus (2) is (3): the cofactors are 1 and -1", &combination, &third)
}

fn tangency(d: &mut Derivation) -> Checked {
    let (joint, ring, half) = (Symbol::joint(), ring(), half());
    d.assume(NORMAL);
    d.assume("sin(beta) != 0 and eta != 2");
    d.assume("the pressure point at beta lies on the intrados, e = -eta/2");
    let along = joint.variable(0);
    let constant = |x: &Fraction| Dual::constant(x.clone());
    let [thrust, crown] = [Symbol::Thrust, Symbol::CrownEccentricity].map(Symbol::number);
    let (h, crown) = (constant(&thrust), constant(&crown));
    let factor = constant(&ring.centroid_factor);
    let e = statics::eccentricity(&along, &h, &crown, &factor);
    let normal = statics::normal_force(&along, &h);
    d.define("the eccentricity e(beta)", e.value());
    d.define("N'(beta)", &normal.derivative(0));
    let residual = thrust::tangency(&joint.times_cotangent(), &ring).residual(&thrust);
    d.define("(5) without its denominator 2 - eta", &residual);
    let two = half.int(2);
    let left = two.clone() * normal.value() * &e.derivative(0)
        + two * normal.derivative(0) * &(e.value().clone() + &half);
    let right = residual * &joint.sin;
    d.on_circle("2 N e' + 2 N' (e + eta/2) = sin(beta) times it", &left, &right)?;
    d.conclude("where e = -eta/2, the derivative e' is zero exactly where (5) holds")
}

fn tangency_forms(d: &mut Derivation) -> Checked {
    let ring = ring();
    d.assume("eta != 0 and eta != 2");
    let (eta, factor) = (&ring.thickness, &ring.centroid_factor);
    let cotangent = Symbol::joint().times_cotangent();
    let first = thrust::tangency(&cotangent, &ring).value();
    d.define("the first form, beta cot(beta) + 1 - 2 fac_M/(2-eta)", &first);
    let bracket = eta.int(1) + eta.int(2) / eta * &(factor.clone() - eta.int(1));
    let second = cotangent - eta.clone() / ring.intrados() * bracket;
    d.identity("beta cot(beta) - eta/(2-eta) [1 + 2/eta (fac_M - 1)] is the same", &second, &first)
}

fn centroid(d: &mut Derivation) -> Checked {
    d.assume("delta_M = 1: the true centroids; lengths in units of r");
    // The radius of a point of the wedge is written S here, a free letter with S' = 1.
    let radius = Symbol::Sine.number();
    let rule = [(Symbol::Sine, Symbol::Sine.polynomial().power(0))];
    let (area, moment) =
        (radius.ratio(1, 2) * radius.square(), { radius.ratio(1, 3) * radius.square() * &radius });
    d.assume("a wedge of angle d beta has the area S dS and the moment S^2 dS about the centre, S the radius");
    d.identity("(S^2/2)' = S", area.derivative(&rule), &radius)?;
    d.identity("(S^3/3)' = S^2", moment.derivative(&rule), radius.square())?;
    let eta = Symbol::Thickness.number();
    let (inner, outer) = (eta.int(1) - eta.ratio(1, 2) * &eta, eta.int(1) + eta.ratio(1, 2) * &eta);
    let between = |primitive: &Fraction| {
        let at = |end: &Fraction| primitive.evaluate(end, |_| end.clone());
        at(&outer) - at(&inner)
    };
    let centroid = between(&moment) / between(&area);
    let factor = Ring::with_flag(&eta.int(1), &eta).centroid_factor;
    d.identity("moment over area, from 1 - eta/2 to 1 + eta/2", &centroid, &factor)?;
    let square = (factor - eta.int(1)) * eta.int(12);
    d.identity("12 (fac_M - 1) is a square, so that fac_M >= 1", &square, eta.square())
}

fn thin_arch(d: &mut Derivation) -> Checked {
    let ring = ring();
    let (eta, delta) = (&ring.thickness, Symbol::Flag.number());
    let cotangent = Symbol::joint().times_cotangent();
    let none = Ring::with_flag(&delta, &eta.int(0));
    let limit = thrust::tangency(&cotangent, &none).value();
    d.identity("h_e at eta = 0", &limit, &cotangent)?;
    let rest = thrust::tangency(&cotangent, &ring).value() - cotangent;
    let expected = -(eta.clone() / ring.intrados() * (eta.int(1) + delta * eta / eta.int(6)));
    d.identity("h_e less beta cot(beta), of the order of eta for either weight", &rest, &expected)
}

fn no_friction(d: &mut Derivation) -> Checked {
    let ring = ring();
    let (joint, shoulder) = (Symbol::joint(), Symbol::half_opening());
    let forms = [
        ("(2)", thrust::lower(&joint, &ring)),
        ("(3)", thrust::upper(&shoulder, &joint, &ring)),
        ("(4)", thrust::whole(&shoulder, &ring)),
        ("(5)", thrust::tangency(&joint.times_cotangent(), &ring)),
    ];
    for (name, form) in forms {
        let slope = form.value().partial(Symbol::Friction);
        d.identity(format!("the derivative of {name} to mu"), &slope, slope.int(0))?;
    }
    Ok(())
}
