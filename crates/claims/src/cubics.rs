//! The cubics (7) and their abbreviations (8).

use super::letters::with;
use super::sign::{AngleSigns, NotNegative, Positive, RingSigns};
use super::{Checked, Derivation, claims};
use crate::arch::cubic::{self, Abbreviations};
use crate::arch::{Quotient, Ring, overturning, thrust};
use crate::number::Field;
use crate::symbolic::{Elimination, Fraction, Letters, Polynomial, Symbol};
use crate::symbolic::{along_the_joint, eliminate};

claims! {
    AsPrinted("eq-8", "Eq. (8)", abbreviations):
        "f = (beta S)' = S + beta C; g = f C + beta S^2 = beta + S C; beta S^2 + C f - g = 0";
    AsPrinted("eq-7-eta", "Eq. (7), second", in_thickness):
        "the thickness of the purely rotational state is a root of pol_eta; for symbolic delta_M, with Heyman's \
         quadratic at delta_M = 0";
    AsPrinted("eq-7-A", "Eq. (7), first", in_opening_variable):
        "the A of the purely rotational state is a root of pol_A; for symbolic delta_M, with Heyman's quadratic at \
         delta_M = 0";
    AsPrinted("eq-7-h", "Eq. (7), third", in_thrust):
        "the thrust of the purely rotational state is a root of pol_h; for symbolic delta_M, with Heyman's quadratic \
         at delta_M = 0";
    Ours("eq-7-denominators", "Sec. 2.1", denominators):
        "no denominator on the way to (7) vanishes for 0 < beta < pi, 0 < eta < 2, and 0 < A";
}

/// `S`, `f`, `g` as free letters.
pub(super) fn letters() -> Abbreviations<Fraction> {
    Abbreviations { sin: Symbol::Sine.number(), f: Symbol::F.number(), g: Symbol::G.number() }
}

fn polynomial(fraction: &Fraction) -> Polynomial {
    fraction.as_polynomial().expect("an equation without denominators").clone()
}

fn abbreviations(d: &mut Derivation) -> Checked {
    let joint = Symbol::joint();
    let Abbreviations { sin, f, g } = cubic::abbreviations(&joint);
    let product = joint.rad.clone() * &sin;
    let slope = product.derivative(&along_the_joint());
    d.on_circle("(beta S)' by beta' = 1, S' = C, C' = -S", &slope, &f)?;
    let first_form = f.clone() * &joint.cos + joint.rad.clone() * sin.square();
    d.on_circle("f C + beta S^2 with C^2 = 1 - S^2", &first_form, &g)?;
    d.on_circle("beta S^2 + C f - g", cubic::link(&joint), sin.int(0))
}

fn in_thickness(d: &mut Derivation) -> Checked {
    let (joint, eta, delta) = (Symbol::joint(), Symbol::Thickness.number(), Symbol::Flag.number());
    let ring = Ring::with_flag(&delta, &eta);
    assume_denominators(d);
    let (lower, tangent) =
        (thrust::lower(&joint, &ring), thrust::tangency(&joint.times_cotangent(), &ring));
    let cubic = cubic::in_thickness(&cubic::abbreviations(&joint), &delta, &eta);
    let difference = lower.difference(&tangent) * eta.int(3) * &joint.sin;
    let words = "3 S times (2) - (5), times both denominators, is pol_eta with delta_M kept";
    d.on_circle(words, &difference, &cubic)?;
    d.conclude("where S and the denominators are not zero, (2) and (5) give one thrust exactly where pol_eta = 0")?;
    let free = cubic::in_thickness(&letters(), &delta, &eta);
    d.define("pol_eta in f, g, S", (&polynomial(&free), Symbol::Thickness));
    let [one, zero] = [1, 0].map(|n| cubic::in_thickness(&letters(), &eta.int(n), &eta));
    let Abbreviations { sin, f, g } = letters();
    let quadratic = (f.clone() + &g) * eta.int(3) * eta.square()
        - (g.clone() - &sin) * eta.int(12) * &eta
        + (g - &f) * eta.int(12);
    let printed = sin * &eta * eta.square() + &quadratic;
    d.identity("delta_M = 1: as printed", &one, &printed)?;
    d.identity("delta_M = 0: Heyman's quadratic", &zero, &quadratic)
}

fn assume_denominators(d: &mut Derivation) {
    d.assume("S != 0, 2 - eta != 0, 2 + eta != 0, 2 + eta - (2-eta) C != 0");
}

/// (2) and (5) as two equations in `eta` and `h` with coefficients in `f`, `g`, `S`, derived from the
/// equations in `beta`, `S`, `C`.
struct Reduced {
    /// `(2+eta) S h + 2 S fac - (2-eta) g`.
    sum: Fraction,
    /// `(2-eta) (S h - f) + 2 S fac`.
    tangent: Fraction,
}

fn reduced(d: &mut Derivation) -> Checked<Reduced> {
    let (eta, h, delta) =
        (Symbol::Thickness.number(), Symbol::Thrust.number(), Symbol::Flag.number());
    let ring = Ring::with_flag(&delta, &eta);
    let in_letters = |Abbreviations { sin, f, g }: &Abbreviations<Fraction>| {
        let weight = eta.int(2) * sin * &ring.centroid_factor;
        let thrust = h.clone() * sin;
        Reduced {
            sum: ring.extrados() * &thrust + &weight - ring.intrados() * g,
            tangent: ring.intrados() * (thrust - f) + weight,
        }
    };
    let joint = Symbol::joint();
    let target = in_letters(&cubic::abbreviations(&joint));
    let lower = thrust::lower(&joint, &ring).residual(&h);
    let tangent = thrust::tangency(&joint.times_cotangent(), &ring).residual(&h) * &joint.sin;
    d.on_circle("Q = S times (5), cleared", &tangent, &target.tangent)?;
    let sum = lower * &joint.sin + tangent * &joint.cos;
    d.on_circle("P = S times (2), cleared, plus C Q, by link (8)", &sum, &target.sum)?;
    let free = in_letters(&letters());
    d.define("P in f, g, S", (&polynomial(&free.sum), Symbol::Thickness));
    d.define("Q in f, g, S", (&polynomial(&free.tangent), Symbol::Thickness));
    Ok(free)
}

fn in_opening_variable(d: &mut Derivation) -> Checked {
    let (a, eta) = (Symbol::OpeningVariable.number(), Symbol::Thickness.number());
    let delta = Symbol::Flag.number();
    assume_denominators(d);
    d.assume("g + S A != 0");
    let free = reduced(d)?;
    let ring = Ring::with_flag(&delta, &eta);
    let Abbreviations { sin, g, .. } = letters();
    // (4): h = A - 2 fac/(2+eta).
    let overturned: Quotient<Fraction> = overturning::opening_variable(&ring);
    let thrust = a.clone() - overturned.value();
    let linear = ring.extrados() * &sin * &a - ring.intrados() * &g;
    let words = "(4) put into P: what contains delta_M cancels";
    d.identity(words, with(&free.sum, &[Symbol::Thrust], &thrust), &linear)?;
    let thickness = (g.clone() - sin.clone() * &a) * a.int(2) / (g.clone() + sin.clone() * &a);
    d.identity(
        "it is solved by eta = 2 (g - S A)/(g + S A)",
        with(&linear, &[Symbol::Thickness], &thickness),
        a.int(0),
    )?;
    let cubic = cubic::in_thickness(&letters(), &delta, &eta);
    let cubic = with(&cubic, &[Symbol::Thickness], &thickness);
    let found = cubic::in_opening_variable(&letters(), &delta, &a);
    d.define("pol_A with delta_M kept", (&polynomial(&found), Symbol::OpeningVariable));
    let sum = g.clone() + sin.clone() * &a;
    let expected = a.int(16) * &sin * &found / (sum.square() * &sum);
    d.identity("pol_eta there is 16 S pol_A/(g + S A)^3", &cubic, &expected)?;
    let Abbreviations { sin, f, g } = letters();
    let printed = ((sin.square() * (g.int(3) * &g - g.int(2) * &sin) * &a
        + g.int(3) * &g * &sin * (g.clone() - &f))
        * &a
        - g.int(3) * &f * g.square())
        * &a
        + g.int(2) * &g * g.square();
    let [one, zero] = [1, 0].map(|n| cubic::in_opening_variable(&letters(), &a.int(n), &a));
    d.identity("delta_M = 1: as printed", &one, &printed)?;
    let quadratic = (sin.int(2) * &g - &sin) * &sin * a.square()
        - (f.clone()) * sin.int(2) * &g * &a
        + g.square();
    let heyman = (sin.clone() * &a + &g) * sin.ratio(3, 2) * &quadratic;
    d.define("Heyman's quadratic", (&polynomial(&quadratic), Symbol::OpeningVariable));
    d.identity(
        "delta_M = 0: 3/2 (S A + g) times Heyman's quadratic; the factor is extraneous, S A + g > 0",
        &zero,
        &heyman,
    )
}

fn in_thrust(d: &mut Derivation) -> Checked {
    let (h, delta) = (Symbol::Thrust.number(), Symbol::Flag.number());
    assume_denominators(d);
    let free = reduced(d)?;
    let (p, q) = (polynomial(&free.sum), polynomial(&free.tangent));
    let Elimination { resultant, u, v } = eliminate(&p, &q, Symbol::Thickness);
    d.define("cofactor u of P", (&u, Symbol::Thickness));
    d.define("cofactor v of Q", (&v, Symbol::Thickness));
    let combination = Fraction::from(&u * &p + &(&v * &q));
    let found = cubic::in_thrust(&letters(), &delta, &h);
    d.define("pol_h with delta_M kept", (&polynomial(&found), Symbol::Thrust));
    let Abbreviations { sin, f, g } = letters();
    let expected = h.ratio(2, 9) * &delta * sin.square() * &found;
    d.identity("u P + v Q, free of eta, is 2/9 delta_M S^2 pol_h", &combination, &expected)?;
    d.identity("it is the resultant of P and Q", Fraction::from(resultant), &expected)?;
    let printed = ((h.int(6) * sin.square() * &h
        - sin.int(3) * &sin * (f.int(3) * &f - &g - sin.int(2) * &sin))
        * &h
        - (g.clone() - &f) * g.int(3) * (f.clone() - sin.int(2) * &sin))
        * &h
        + (g.clone() - &f).square() * g.int(2);
    let [one, zero] = [1, 0].map(|n| cubic::in_thrust(&letters(), &h.int(n), &h));
    d.identity("delta_M = 1: as printed", &one, &printed)?;
    // At delta_M = 0 both P and Q are linear in eta, and the resultant above loses its meaning.
    let linear = |p: &Polynomial| p.substitute(Symbol::Flag, &Polynomial::zero());
    let heyman = eliminate(&linear(&p), &linear(&q), Symbol::Thickness).resultant;
    let quadratic = Fraction::from(heyman) / &sin;
    d.define(
        "delta_M = 0: the resultant of P and Q over S, Heyman's quadratic",
        (&polynomial(&quadratic), Symbol::Thrust),
    );
    let extraneous = sin.int(2) * &sin * &h + (g - &f);
    let words = "3/4 (2 S h + g - f) times it is pol_h at delta_M = 0";
    d.identity(words, extraneous * quadratic * h.ratio(3, 4), &zero)?;
    let angle = AngleSigns::of_joint(d)?;
    let [h] = NotNegative::given(d, "h >= 0", [&h]);
    let wide = cubic::abbreviations(&Symbol::joint());
    let factor = Symbol::Thrust.number() * &wide.sin * wide.sin.int(2) + (wide.g - &wide.f);
    let positive = h * &angle.sin * &Positive::int(2) + &(angle.excess * &angle.versine);
    positive.is(d, "2 S h + g - f, which is extraneous", &factor).map(|_| ())
}

fn denominators(d: &mut Derivation) -> Checked {
    let (angle, signs) = (AngleSigns::of_joint(d)?, RingSigns::of(d)?);
    let opening = Symbol::OpeningVariable.number();
    let [positive_opening] = Positive::given(d, "A > 0", [&opening]);
    signs.lever_arm(d, &angle)?;
    let Abbreviations { sin, f, g } = cubic::abbreviations(&Symbol::joint());
    let difference = angle.excess.clone() * &angle.versine;
    difference.is(d, "g - f", g.clone() - f)?;
    let sum = (angle.excess + &(angle.sin.clone() * &angle.coversine)).is(d, "g", &g)?;
    let whole = sum + &(angle.sin * &positive_opening);
    whole.is(d, "g + S A", g + sin * &opening).map(|_| ())
}
