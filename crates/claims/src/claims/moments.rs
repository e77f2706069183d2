//! Moments, tangency and centroids: (2)–(6).

use super::{Claim, Derivation, Finding};
use crate::arch::{Ring, statics, thrust};
use crate::certify::Undecided;
use crate::number::{Angle, Dual, Field};
use crate::symbolic::{Fraction, Letters, Relations, Symbol};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-2",
        place: "Eq. (2)",
        statement: "h_L is the thrust that puts the line of thrust on the extrados at the crown and \
                    on the intrados at beta",
        decide: lower,
    },
    Claim {
        id: "eq-3",
        place: "Eq. (3)",
        statement: "h_U is the thrust that puts the line of thrust on the intrados at beta and on the \
                    extrados at the shoulder",
        decide: upper,
    },
    Claim {
        id: "eq-4",
        place: "Eq. (4)",
        statement: "h_2 is the thrust that puts the line of thrust on the extrados at the crown and \
                    at the shoulder",
        decide: whole,
    },
    Claim {
        id: "eq-4-forms",
        place: "Eq. (4)",
        statement: "A(alpha) = alpha sin(alpha)/(1 - cos(alpha)) = alpha cot(alpha/2)",
        decide: opening_variable_forms,
    },
    Claim {
        id: "eq-2-4-imply-3",
        place: "Sec. 2.1",
        statement: "(3) follows from (2) and (4)",
        decide: upper_follows,
    },
    Claim {
        id: "eq-5",
        place: "Eq. (5)",
        statement: "h_e is the thrust at which the line of thrust is tangent to the intrados at beta",
        decide: tangency,
    },
    Claim {
        id: "eq-5-forms",
        place: "Eq. (5)",
        statement: "both printed forms of h_e are equal",
        decide: tangency_forms,
    },
    Claim {
        id: "eq-6",
        place: "Eq. (6)",
        statement: "the centroid of an infinitesimal wedge of the ring lies at the radius \
                    r (1 + eta^2/12), and fac_M >= 1",
        decide: centroid,
    },
    Claim {
        id: "eq-5-thin",
        place: "Eq. (5)",
        statement: "Heyman's beta cot(beta) is what is left of h_e for a thin arch, with either weight",
        decide: thin_arch,
    },
    Claim {
        id: "rotation-friction",
        place: "Sec. 2.2",
        statement: "(2)-(5) see no friction",
        decide: no_friction,
    },
];

/// The letters of this file: thrust, crown eccentricity, and a ring with symbolic `delta_M`.
struct Arch {
    thrust: Fraction,
    crown: Fraction,
    ring: Ring<Fraction>,
    half: Fraction,
}

fn arch() -> Arch {
    let thickness = Symbol::Thickness.number();
    Arch {
        thrust: Symbol::Thrust.number(),
        crown: Symbol::CrownEccentricity.number(),
        half: thickness.ratio(1, 2) * &thickness,
        ring: Ring::with_flag(&Symbol::Flag.number(), &thickness),
    }
}

impl Arch {
    /// `2 N (e - target)` at a joint: zero where the pressure point has the eccentricity `target`.
    fn miss(&self, joint: &Angle<Fraction>, crown: &Fraction, target: &Fraction) -> Fraction {
        let factor = &self.ring.centroid_factor;
        let e = statics::eccentricity(joint, &self.thrust, crown, factor);
        let normal = statics::normal_force(joint, &self.thrust);
        normal * &(e - target) * target.int(2)
    }
}

const NORMAL: &str = "N != 0 at the joints: else there is no pressure point";

fn lower(d: &mut Derivation) -> Result<Finding, Undecided> {
    let arch = arch();
    let joint = Symbol::joint();
    d.assume(NORMAL);
    d.assume("2 + eta - (2-eta) cos(beta) != 0");
    let residual = thrust::lower(&joint, &arch.ring).residual(&arch.thrust);
    d.define("(2) without its denominator, h [2 + eta - (2-eta) C] - …", &residual);
    let miss = arch.miss(&joint, &arch.half, &-arch.half.clone());
    d.identity(
        "2 N (e + eta/2) at beta, with e0 = eta/2 at the crown, is the same",
        &miss,
        &residual,
        &Relations::none(),
    )?;
    Ok(Finding::AsPrinted)
}

fn upper(d: &mut Derivation) -> Result<Finding, Undecided> {
    let arch = arch();
    let (joint, shoulder) = (Symbol::joint(), Symbol::half_opening());
    d.assume(NORMAL);
    d.assume("(2-eta) cos(beta) - (2+eta) cos(alpha) != 0");
    let residual = thrust::upper(&shoulder, &joint, &arch.ring).residual(&arch.thrust);
    d.define("(3) without its denominator", &residual);
    let at_shoulder = arch.miss(&shoulder, &arch.crown, &arch.half);
    let at_joint = arch.miss(&joint, &arch.crown, &-arch.half.clone());
    d.identity(
        "2 N (e - eta/2) at alpha minus 2 N (e + eta/2) at beta, for any e0 at the crown",
        &(at_shoulder - &at_joint),
        &residual,
        &Relations::none(),
    )?;
    Ok(Finding::AsPrinted)
}

fn whole(d: &mut Derivation) -> Result<Finding, Undecided> {
    let arch = arch();
    let shoulder = Symbol::half_opening();
    d.assume(NORMAL);
    d.assume("(1 - cos(alpha)) (2 + eta) != 0");
    let residual = thrust::whole(&shoulder, &arch.ring).residual(&arch.thrust);
    d.define("(4) without its denominator", &residual);
    d.identity(
        "2 N (e - eta/2) at alpha, with e0 = eta/2 at the crown, is the same",
        &arch.miss(&shoulder, &arch.half, &arch.half),
        &residual,
        &Relations::none(),
    )?;
    let opening = thrust::opening_variable(&shoulder).value();
    let printed = opening
        - arch.ring.centroid_factor.int(2) * &arch.ring.centroid_factor / arch.ring.extrados();
    let value = thrust::whole(&shoulder, &arch.ring).value();
    d.identity("h_2 = A - 2 fac_M/(2 + eta)", &value, &printed, &Relations::none())?;
    Ok(Finding::AsPrinted)
}

fn opening_variable_forms(d: &mut Derivation) -> Result<Finding, Undecided> {
    let half = Symbol::joint();
    d.assume("sin(alpha/2) != 0");
    d.assume("S = sin(alpha/2), C = cos(alpha/2): sin(alpha) = 2 S C, cos(alpha) = 1 - 2 S^2");
    let alpha = Angle {
        rad: Symbol::HalfOpening.number(),
        sin: half.sin.int(2) * &half.sin * &half.cos,
        cos: half.sin.int(1) - half.sin.int(2) * half.sin.square(),
    };
    let circle = alpha.sin.square() + alpha.cos.square();
    let trigonometric = Relations::trigonometric();
    d.identity("they lie on the circle", &circle, &half.sin.int(1), &trigonometric)?;
    let cotangent = alpha.rad.clone() * &half.cos / &half.sin;
    let value = thrust::opening_variable(&alpha).value();
    d.identity("A = alpha C/S", &value, &cotangent, &Relations::none())?;
    Ok(Finding::AsPrinted)
}

fn upper_follows(d: &mut Derivation) -> Result<Finding, Undecided> {
    let arch = arch();
    let (joint, shoulder) = (Symbol::joint(), Symbol::half_opening());
    d.assume("the denominators of (2), (3), (4) do not vanish");
    let second = thrust::lower(&joint, &arch.ring).residual(&arch.thrust);
    let third = thrust::upper(&shoulder, &joint, &arch.ring).residual(&arch.thrust);
    let fourth = thrust::whole(&shoulder, &arch.ring).residual(&arch.thrust);
    d.define("(2) without its denominator", &second);
    d.define("(4) without its denominator", &fourth);
    let combination = fourth - second;
    let words = "(4) minus (2) is (3): the cofactors are 1 and -1";
    d.identity(words, &combination, &third, &Relations::none())?;
    Ok(Finding::Implicit)
}

fn tangency(d: &mut Derivation) -> Result<Finding, Undecided> {
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
    d.identity(
        "2 N e' + 2 N' (e + eta/2) = sin(beta) times it",
        &left,
        &right,
        &Relations::trigonometric(),
    )?;
    d.conclude("where e = -eta/2, the derivative e' is zero exactly where (5) holds");
    Ok(Finding::AsPrinted)
}

fn tangency_forms(d: &mut Derivation) -> Result<Finding, Undecided> {
    let arch = arch();
    d.assume("eta != 0 and eta != 2");
    let (eta, factor) = (&arch.ring.thickness, &arch.ring.centroid_factor);
    let cotangent = Symbol::joint().times_cotangent();
    let first = thrust::tangency(&cotangent, &arch.ring).value();
    d.define("the first form, beta cot(beta) + 1 - 2 fac_M/(2-eta)", &first);
    let bracket = eta.int(1) + eta.int(2) / eta * &(factor.clone() - eta.int(1));
    let second = cotangent - eta.clone() / arch.ring.intrados() * bracket;
    d.identity(
        "beta cot(beta) - eta/(2-eta) [1 + 2/eta (fac_M - 1)] is the same",
        &second,
        &first,
        &Relations::none(),
    )?;
    Ok(Finding::AsPrinted)
}

fn centroid(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.assume("delta_M = 1: the true centroids; lengths in units of r");
    // The radius of a point of the wedge is written S here, a free letter with S' = 1.
    let radius = Symbol::Sine.number();
    let rule = [(Symbol::Sine, Symbol::Sine.polynomial().power(0))];
    let (area, moment) =
        (radius.ratio(1, 2) * radius.square(), { radius.ratio(1, 3) * radius.square() * &radius });
    d.assume("a wedge of angle d beta has the area S dS and the moment S^2 dS about the centre, S the radius");
    let free = Relations::none();
    d.identity("(S^2/2)' = S", &area.derivative(&rule), &radius, &free)?;
    d.identity("(S^3/3)' = S^2", &moment.derivative(&rule), &radius.square(), &free)?;
    let eta = Symbol::Thickness.number();
    let (inner, outer) = (eta.int(1) - eta.ratio(1, 2) * &eta, eta.int(1) + eta.ratio(1, 2) * &eta);
    let between = |primitive: &Fraction| {
        let at = |end: &Fraction| primitive.evaluate(end, |_| end.clone());
        at(&outer) - at(&inner)
    };
    let centroid = between(&moment) / between(&area);
    let factor = Ring::with_flag(&eta.int(1), &eta).centroid_factor;
    d.identity("moment over area, from 1 - eta/2 to 1 + eta/2", &centroid, &factor, &free)?;
    let square = (factor - eta.int(1)) * eta.int(12);
    let words = "12 (fac_M - 1) is a square, so that fac_M >= 1";
    d.identity(words, &square, &eta.square(), &free)?;
    Ok(Finding::AsPrinted)
}

fn thin_arch(d: &mut Derivation) -> Result<Finding, Undecided> {
    let Arch { ring, .. } = arch();
    let (eta, delta) = (&ring.thickness, Symbol::Flag.number());
    let cotangent = Symbol::joint().times_cotangent();
    let none = Ring::with_flag(&delta, &eta.int(0));
    let limit = thrust::tangency(&cotangent, &none).value();
    d.identity("h_e at eta = 0", &limit, &cotangent, &Relations::none())?;
    let rest = thrust::tangency(&cotangent, &ring).value() - cotangent;
    let expected = -(eta.clone() / ring.intrados() * (eta.int(1) + delta * eta / eta.int(6)));
    d.identity(
        "h_e less beta cot(beta), of the order of eta for either weight",
        &rest,
        &expected,
        &Relations::none(),
    )?;
    Ok(Finding::AsPrinted)
}

fn no_friction(d: &mut Derivation) -> Result<Finding, Undecided> {
    let Arch { ring, .. } = arch();
    let (joint, shoulder) = (Symbol::joint(), Symbol::half_opening());
    let forms = [
        ("(2)", thrust::lower(&joint, &ring)),
        ("(3)", thrust::upper(&shoulder, &joint, &ring)),
        ("(4)", thrust::whole(&shoulder, &ring)),
        ("(5)", thrust::tangency(&joint.times_cotangent(), &ring)),
    ];
    for (name, form) in forms {
        let slope = form.value().partial(Symbol::Friction);
        let words = format!("the derivative of {name} to mu");
        d.identity(words, &slope, &slope.int(0), &Relations::none())?;
    }
    Ok(Finding::AsPrinted)
}
