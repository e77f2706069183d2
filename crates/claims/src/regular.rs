//! The forms in which the curves of the map are regular up to their ends, each against the printed equations.

use super::letters::{ring, variables};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::haunch::{Haunch, opening_variable_at_half};
use crate::arch::{cycloid, sliding, statics, thrust};
use crate::number::{Angle, Field};
use crate::symbolic::{Fraction, Letters, Relations, Symbol, along_the_opening};

claims! {
    Ours("eq-18-cycloid", "Eq. (18)", cycloid):
        "(18) is a cycloid: h = cos²(chi), beta_s = sin(chi) cos(chi) and phi = chi - sin(chi) cos(chi), with chi in \
         (0, pi/2) the inclination of the force on the joint that slides";
    Ours("eq-17-angles", "Eq. (17)", shoulder):
        "(17) is h sin(alpha - phi) = alpha cos(alpha - phi), and N is cos(phi) times h cos(alpha - phi) + alpha \
         sin(alpha - phi)";
    Ours("eq-17-flat", "Eq. (17), (18)", flat_shoulder):
        "the purely sliding states of flat arches: with q = (alpha - phi)/chi, (17) is chi³ times q (q² (c_2 - c_3) \
         - c_1(chi²)² c_1) - 4 c_3(4 chi²) c_0, Stumpff's functions at q² chi²";
    Ours("eq-2-touching", "Eq. (2)-(5)", touching):
        "(2) and (5) hold where (5) does and h = (2 - eta)/(2 eta) (1 - cos(beta)) (beta/sin(beta) - 1), which has \
         no quotient that vanishes with the thickness";
    Ours("eq-2-square", "Eq. (2)-(5)", squares):
        "(2)-(5) see the joint through functions of its square, analytic at the crown, and A through those of a \
         quarter of that of the half opening";
}

fn cycloid(d: &mut Derivation) -> Checked {
    d.assume("0 < chi < pi/2");
    // The letters of the half opening are those of chi.
    let chi = Symbol::half_opening();
    let (h, beta) = (cycloid::thrust(&chi), cycloid::joint(&chi));
    let steepest = sliding::steepest(&beta, &h);
    d.on_circle("beta_s² - h (1 - h), with chi for alpha", &steepest, h.int(0))?;
    let words = "beta_s/h, the tangent of the inclination of the force: tan(chi)";
    d.on_circle(words, beta.clone() / &h, chi.sin.clone() / &chi.cos)?;
    let joint = Angle { rad: beta, ..Symbol::joint() };
    let sine = chi.sin.clone() * &joint.cos - chi.cos.clone() * &joint.sin;
    let cosine = chi.cos.clone() * &joint.cos + chi.sin.clone() * &joint.sin;
    let value = sliding::inner(&joint, &h).value();
    d.on_circle("mu_is: tan(chi - beta_s)", &value, sine / cosine)?;
    let slope = cycloid::friction_angle(&chi).derivative(&along_the_opening());
    d.on_circle("d phi/d chi = 2 sin²(chi)", &slope, h.int(2) * chi.sin.square())?;
    d.conclude(
        "mu = tan(phi) with phi = chi - beta_s, which grows from 0 to pi/2 as chi does: to each friction belongs one \
         chi, and h falls from 1 to 0.",
    )
}

fn shoulder(d: &mut Derivation) -> Checked {
    d.assume("0 <= phi < pi/2; beta stands for alpha - phi");
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let inclination = Symbol::joint();
    let sine = alpha.sin.clone() * &inclination.cos - alpha.cos.clone() * &inclination.sin;
    let cosine = alpha.cos.clone() * &inclination.cos + alpha.sin.clone() * &inclination.sin;
    let printed = sliding::shoulder(&alpha, &h).residual(&(sine.clone() / &cosine)) * &cosine;
    let angles = cycloid::shoulder(&alpha.rad, &inclination, &h);
    d.on_circle("(17) at mu = tan(phi), times N cos(phi)", &printed, -angles.clone())?;
    let along = h.clone() * &inclination.cos + alpha.rad.clone() * &inclination.sin;
    let normal = statics::normal_force(&alpha, &h);
    let rest = along * &cosine - angles * &sine;
    d.on_circle("N, less the part that vanishes where the shoulder slides", &normal, &rest)?;
    d.conclude("So where this holds, N > 0 if h cos(alpha - phi) + alpha sin(alpha - phi) > 0.")
}

/// Stumpff's functions `c_0, …, c_3` at `u` in two letters.
fn functions(u: &Fraction) -> [Fraction; 4] {
    let (c2, c3) = (Symbol::F.number(), Symbol::G.number());
    [u.int(1) - u.clone() * &c2, u.int(1) - u.clone() * &c3, c2, c3]
}

fn flat_shoulder(d: &mut Derivation) -> Checked {
    lemmas(d, ["eq-18-cycloid", "eq-17-angles"])?;
    d.assume("0 < chi; c_2, c_3 at q² chi² are the letters f, g, and u stands for q");
    let (chi, q) = (Symbol::half_opening(), Symbol::CubeRoot.number());
    let angle = chi.rad.clone() * &q;
    let at_shoulder = functions(&angle.square());
    let sine = angle.clone() * &at_shoulder[1];
    let inclination = Angle { sin: sine, cos: at_shoulder[0].clone(), rad: angle.clone() };
    let phi = cycloid::friction_angle(&chi);
    let half_opening = phi.clone() + &angle;
    let printed = cycloid::shoulder(&half_opening, &inclination, &cycloid::thrust(&chi));
    let one = chi.rad.int(1);
    let deficit = (chi.sin.clone() / &chi.rad).square();
    let cube = chi.rad.square() * &chi.rad;
    // 2 chi - sin(2 chi) over the cube of 2 chi.
    let twice = [one.clone(), one.clone(), one.clone(), phi / (one.int(4) * &cube)];
    let flat = cycloid::flat_shoulder_from(&q, &at_shoulder, &deficit, &twice);
    d.on_circle("(17) with alpha = q chi + phi", &printed, flat * cube)?;
    let at_zero = one.ratio(1, 3) * q.square() * &q - &q - one.ratio(2, 3);
    let root = (q.clone() - one.int(2)) * (q.clone() + &one).square() / one.int(3);
    let words =
        "at chi = 0, where c_2 - c_3 = 1/3, c_3 = 1/6: one positive root, q = 2, and it is simple";
    d.identity(words, &at_zero, &root)
}

fn touching(d: &mut Derivation) -> Checked {
    d.assume("0 < beta < pi, 0 < eta < 2");
    let (at, ring) = (variables(), ring());
    let (joint, h) = (&at.rotation_joint, &at.thrust);
    let haunch = Haunch::from(joint);
    let tangency = thrust::tangency(&haunch.times_cotangent, &ring);
    let touching = thrust::touching(&haunch.versine, &haunch.excess, &ring);
    let lower = thrust::lower(joint, &ring).residual(h);
    let words = "(2) less 1 - cos(beta) times (5)";
    d.on_circle(words, lower - tangency.residual(h) * &haunch.versine, touching.residual(h))?;
    let difference = tangency.difference(&touching);
    let common = tangency.residual(h) * &touching.denominator;
    let words = "the thrust of (5) put into it, times both denominators";
    let expected = touching.residual(h) * &tangency.denominator - common;
    d.identity(words, &difference, &expected)?;
    let rooted = Relations::none().with(Symbol::SquareRoot, 2, Symbol::Thrust.polynomial());
    let q = Symbol::SquareRoot.number();
    let bow = ring.intrados() * &haunch.versine * &haunch.excess;
    d.identity_under(
        "the same with q = √h: a difference of squares",
        touching.residual(h),
        q.square() * ring.thickness.int(2) * &ring.thickness - bow,
        &rooted,
    )?;
    d.conclude(
        "Where the square root of the last is taken, h and the bow are positive, and so are their roots, of which the \
         one of (1 - cos(beta)) (beta/sin(beta) - 1) is analytic in beta².",
    )
}

fn squares(d: &mut Derivation) -> Checked {
    d.assume("c_2, c_3 at beta² are the letters f, g: sin(beta) = beta c_1, cos(beta) = c_0");
    let beta = Symbol::Joint.number();
    let c = functions(&beta.square());
    let angle = Angle { rad: beta.clone(), sin: beta.clone() * &c[1], cos: c[0].clone() };
    let (printed, even) = (Haunch::from(&angle), Haunch::from_functions(&beta.square(), &c));
    for (words, one, other) in [
        ("cos(beta)", &printed.cosine, &even.cosine),
        ("beta sin(beta)", &printed.times_sine, &even.times_sine),
        ("beta cot(beta)", &printed.times_cotangent, &even.times_cotangent),
        ("1 - cos(beta)", &printed.versine, &even.versine),
        ("beta/sin(beta) - 1", &printed.excess, &even.excess),
    ] {
        d.identity(words, one, other)?;
    }
    let ring = ring();
    let alpha = Symbol::half_opening();
    let upper = thrust::upper(&alpha, &angle, &ring);
    let about =
        thrust::upper_about(&alpha, ring.intrados() * &even.times_sine, &even.cosine, &ring);
    d.identity("(3)", upper.value(), about.value())?;
    // With alpha = 2 beta: the sine and cosine of the whole by those of its half.
    let whole = Angle {
        rad: beta.int(2) * &beta,
        sin: angle.sin.int(2) * &angle.sin * &angle.cos,
        cos: beta.int(1) - angle.sin.int(2) * angle.sin.square(),
    };
    d.identity(
        "A(2 beta): 2 c_0/c_1, as sin(2 beta) = 2 sin cos and cos(2 beta) = 1 - 2 sin²",
        thrust::opening_variable(&whole).value(),
        opening_variable_at_half(&c).value(),
    )?;
    let through = thrust::whole_through(&opening_variable_at_half(&c), &ring);
    d.identity("(4)", thrust::whole(&whole, &ring).value(), through.value())
}
