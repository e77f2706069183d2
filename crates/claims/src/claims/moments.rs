//! Moments, tangency and centroids: (2)–(6).

use super::{Claim, Derivation, Proof, claim, implied};
use crate::arch::{Ring, statics, thrust};
use crate::number::{Angle, Dual, Field};
use crate::symbolic::{Fraction, Letters, Symbol};

pub(super) const CLAIMS: &[Claim] = &[
    claim("eq-2", "Eq. (2)", lower).states(
        "h_L is the thrust that puts the line of thrust on the extrados at the crown and on the \
         intrados at beta",
    ),
    claim("eq-3", "Eq. (3)", upper).states(
        "h_U is the thrust that puts the line of thrust on the intrados at beta and on the \
         extrados at the shoulder",
    ),
    claim("eq-4", "Eq. (4)", whole).states(
        "h_2 is the thrust that puts the line of thrust on the extrados at the crown and at the \
         shoulder",
    ),
    claim("eq-4-forms", "Eq. (4)", opening_variable_forms)
        .states("A(alpha) = alpha sin(alpha)/(1 - cos(alpha)) = alpha cot(alpha/2)"),
    implied("eq-2-4-imply-3", "Sec. 2.1", upper_follows).states("(3) follows from (2) and (4)"),
    claim("eq-5", "Eq. (5)", tangency)
        .states("h_e is the thrust at which the line of thrust is tangent to the intrados at beta"),
    claim("eq-5-forms", "Eq. (5)", tangency_forms).states("both printed forms of h_e are equal"),
    claim("eq-6", "Eq. (6)", centroid).states(
        "the centroid of an infinitesimal wedge of the ring lies at the radius r (1 + eta^2/12), \
         and fac_M >= 1",
    ),
    claim("eq-5-thin", "Eq. (5)", thin_arch).states(
        "Heyman's beta cot(beta) is what is left of h_e for a thin arch, with either weight",
    ),
    claim("rotation-friction", "Sec. 2.2", no_friction).states("(2)-(5) see no friction"),
];

/// The letters of this file: thrust, crown eccentricity, and a ring with symbolic `delta_M`.
struct RingLetters {
    thrust: Fraction,
    crown: Fraction,
    ring: Ring<Fraction>,
    half: Fraction,
}

fn arch() -> RingLetters {
    let thickness = Symbol::Thickness.number();
    RingLetters {
        thrust: Symbol::Thrust.number(),
        crown: Symbol::CrownEccentricity.number(),
        half: thickness.ratio(1, 2) * &thickness,
        ring: Ring::with_flag(&Symbol::Flag.number(), &thickness),
    }
}

impl RingLetters {
    /// `2 N (e - target)` at a joint: zero where the pressure point has the eccentricity `target`.
    fn miss(&self, joint: &Angle<Fraction>, crown: &Fraction, target: &Fraction) -> Fraction {
        let factor = &self.ring.centroid_factor;
        let e = statics::eccentricity(joint, &self.thrust, crown, factor);
        let normal = statics::normal_force(joint, &self.thrust);
        normal * &(e - target) * target.int(2)
    }
}

const NORMAL: &str = "N != 0 at the joints: else there is no pressure point";

fn lower(d: &mut Derivation) -> Proof {
    let arch = arch();
    let joint = Symbol::joint();
    d.assume(NORMAL);
    d.assume("2 + eta - (2-eta) cos(beta) != 0");
    let residual = thrust::lower(&joint, &arch.ring).residual(&arch.thrust);
    d.define("(2) without its denominator, h [2 + eta - (2-eta) C] - …", &residual);
    let miss = arch.miss(&joint, &arch.half, &-arch.half.clone());
    let words = "2 N (e + eta/2) at beta, with e0 = eta/2 at the crown, is the same";
    d.identity(words, &miss, &residual)
}

fn upper(d: &mut Derivation) -> Proof {
    let arch = arch();
    let (joint, shoulder) = (Symbol::joint(), Symbol::half_opening());
    d.assume(NORMAL);
    d.assume("(2-eta) cos(beta) - (2+eta) cos(alpha) != 0");
    let residual = thrust::upper(&shoulder, &joint, &arch.ring).residual(&arch.thrust);
    d.define("(3) without its denominator", &residual);
    let at_shoulder = arch.miss(&shoulder, &arch.crown, &arch.half);
    let at_joint = arch.miss(&joint, &arch.crown, &-arch.half.clone());
    let words = "2 N (e - eta/2) at alpha minus 2 N (e + eta/2) at beta, for any e0 at the crown";
    d.identity(words, at_shoulder - &at_joint, &residual)
}

fn whole(d: &mut Derivation) -> Proof {
    let arch = arch();
    let shoulder = Symbol::half_opening();
    d.assume(NORMAL);
    d.assume("(1 - cos(alpha)) (2 + eta) != 0");
    let residual = thrust::whole(&shoulder, &arch.ring).residual(&arch.thrust);
    d.define("(4) without its denominator", &residual);
    let words = "2 N (e - eta/2) at alpha, with e0 = eta/2 at the crown, is the same";
    d.identity(words, arch.miss(&shoulder, &arch.half, &arch.half), &residual)?;
    let opening = thrust::opening_variable(&shoulder).value();
    let printed = opening
        - arch.ring.centroid_factor.int(2) * &arch.ring.centroid_factor / arch.ring.extrados();
    let value = thrust::whole(&shoulder, &arch.ring).value();
    d.identity("h_2 = A - 2 fac_M/(2 + eta)", &value, &printed)
}

fn opening_variable_forms(d: &mut Derivation) -> Proof {
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

fn upper_follows(d: &mut Derivation) -> Proof {
    let arch = arch();
    let (joint, shoulder) = (Symbol::joint(), Symbol::half_opening());
    d.assume("the denominators of (2), (3), (4) do not vanish");
    let second = thrust::lower(&joint, &arch.ring).residual(&arch.thrust);
    let third = thrust::upper(&shoulder, &joint, &arch.ring).residual(&arch.thrust);
    let fourth = thrust::whole(&shoulder, &arch.ring).residual(&arch.thrust);
    d.define("(2) without its denominator", &second);
    d.define("(4) without its denominator", &fourth);
    let combination = fourth - second;
    d.identity("(4) minus (2) is (3): the cofactors are 1 and -1", &combination, &third)
}

fn tangency(d: &mut Derivation) -> Proof {
    let arch = arch();
    let joint = Symbol::joint();
    d.assume(NORMAL);
    d.assume("sin(beta) != 0 and eta != 2");
    d.assume("the pressure point at beta lies on the intrados, e = -eta/2");
    let along = joint.variable(0);
    let constant = |x: &Fraction| Dual::constant(x.clone());
    let (thrust, crown) = (constant(&arch.thrust), constant(&arch.crown));
    let factor = constant(&arch.ring.centroid_factor);
    let e = statics::eccentricity(&along, &thrust, &crown, &factor);
    let normal = statics::normal_force(&along, &thrust);
    d.define("the eccentricity e(beta)", e.value());
    d.define("N'(beta)", &normal.derivative(0));
    let residual = thrust::tangency(&joint.times_cotangent(), &arch.ring).residual(&arch.thrust);
    d.define("(5) without its denominator 2 - eta", &residual);
    let two = arch.half.int(2);
    let left = two.clone() * normal.value() * &e.derivative(0)
        + two * normal.derivative(0) * &(e.value().clone() + &arch.half);
    let right = residual * &joint.sin;
    d.on_circle("2 N e' + 2 N' (e + eta/2) = sin(beta) times it", &left, &right)?;
    d.conclude("where e = -eta/2, the derivative e' is zero exactly where (5) holds")
}

fn tangency_forms(d: &mut Derivation) -> Proof {
    let arch = arch();
    d.assume("eta != 0 and eta != 2");
    let (eta, factor) = (&arch.ring.thickness, &arch.ring.centroid_factor);
    let cotangent = Symbol::joint().times_cotangent();
    let first = thrust::tangency(&cotangent, &arch.ring).value();
    d.define("the first form, beta cot(beta) + 1 - 2 fac_M/(2-eta)", &first);
    let bracket = eta.int(1) + eta.int(2) / eta * &(factor.clone() - eta.int(1));
    let second = cotangent - eta.clone() / arch.ring.intrados() * bracket;
    d.identity("beta cot(beta) - eta/(2-eta) [1 + 2/eta (fac_M - 1)] is the same", &second, &first)
}

fn centroid(d: &mut Derivation) -> Proof {
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

fn thin_arch(d: &mut Derivation) -> Proof {
    let RingLetters { ring, .. } = arch();
    let (eta, delta) = (&ring.thickness, Symbol::Flag.number());
    let cotangent = Symbol::joint().times_cotangent();
    let none = Ring::with_flag(&delta, &eta.int(0));
    let limit = thrust::tangency(&cotangent, &none).value();
    d.identity("h_e at eta = 0", &limit, &cotangent)?;
    let rest = thrust::tangency(&cotangent, &ring).value() - cotangent;
    let expected = -(eta.clone() / ring.intrados() * (eta.int(1) + delta * eta / eta.int(6)));
    d.identity("h_e less beta cot(beta), of the order of eta for either weight", &rest, &expected)
}

fn no_friction(d: &mut Derivation) -> Proof {
    let RingLetters { ring, .. } = arch();
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
