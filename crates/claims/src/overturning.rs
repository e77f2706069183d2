//! Purely overturning states and the end of rotation: (13)–(16).

use super::letters::{ring, with};
use super::{Checked, Derivation, Finding, claims, lemmas};
use crate::arch::{Ring, SelfWeight, overturning, thrust};
use crate::number::{Angle, Field, Surd};
use crate::symbolic::{Fraction, Letters, Relations, Symbol, along_the_opening};
use rug::Rational;

claims! {
    AsPrinted("eq-13", "Eq. (13)", without_thrust):
        "h_2 = 0 in (4), or h_U = 0 at beta_r = 0 in (3), gives A = 2/(2+eta) (1 + delta_M eta^2/12)";
    AsPrinted("eq-14", "Eq. (14)", heyman): "for Heyman's weight A = 2/(2+eta), and eta = 2 (1/A - 1)";
    AsPrinted("eq-15", "Eq. (15)", milankovitch):
        "for Milankovitch's weight A = (12 + eta^2)/(6 (2+eta)), and eta = 3A - sqrt(3 (3A^2 + 4A - 4))";
    AsPrinted("eq-15-branch", "Eq. (15)", milankovitch_branch):
        "on 0 <= eta <= 2, A falls from 1 to 2/3, where the square root in (15) is zero and eta(A) and eta(alpha) \
         have a vertical tangent; the other sign of the root has eta >= 2";
    Finds("eq-16", "Eq. (16)", end_of_rotation):
        "h_e = 0 at beta_r = 0 in (5) gives 1 - eta/(2-eta) (1 + delta_M eta^2/12) = 0, with the root 2 (2√3 - 3) \
         for delta_M = 1";
    AsPrinted("limit-l", "Sec. 2.1, Tables 3-4", limit_values):
        "eta_l = 1, A_l = 2/3 (Heyman); eta_l = 2 (2√3 - 3), A_l = √3 - 1 (Milankovitch)";
    AsPrinted("limit-L", "Sec. 2.1, Tables 3-4", physical_limit):
        "at eta = 2: A_L = 1/2 (Heyman), A_L = 2/3 (Milankovitch)";
    Implicit("alpha-one-to-one", "Sec. 2.1", opening_variable_falls):
        "A(alpha) falls strictly from 2 to 0 on (0, pi), so that A fixes alpha";
    AsPrinted("alpha-L-is-alpha-l", "Sec. 2.1", shared_opening):
        "alpha_L of Milankovitch's weight is alpha_l of Heyman's";
}

fn without_thrust(d: &mut Derivation) -> Checked {
    d.assume("h = 0; 2 + eta != 0; cos(alpha) != 1");
    let (ring, alpha) = (ring(), Symbol::half_opening());
    let zero = ring.thickness.int(0);
    let opening = thrust::opening_variable(&alpha);
    let thirteen = overturning::opening_variable(&ring);
    d.define("A of (13)", &thirteen.value());
    let printed = ring.thickness.int(2) / ring.extrados() * &ring.centroid_factor;
    d.identity("it is 2/(2+eta) fac_M", thirteen.value(), &printed)?;
    let difference = opening.difference(&thirteen);
    d.define("A(alpha) = A of (13), cleared", &difference);
    let fourth = -thrust::whole(&alpha, &ring).residual(&zero);
    d.identity("(4) at h = 0, cleared, is the same", &fourth, &difference)?;
    let crown = Angle::zero(&zero);
    let third = -thrust::upper(&alpha, &crown, &ring).residual(&zero);
    d.identity("(3) at h = 0 and beta = 0 too", &third, &difference)
}

/// `A` of (13) at a thickness.
pub(super) fn opening_at<T: Field>(weight: SelfWeight, eta: &T) -> T {
    overturning::opening_variable(&Ring::new(weight, eta)).value()
}

fn heyman(d: &mut Derivation) -> Checked {
    d.assume("2 + eta != 0, A != 0");
    let (eta, a) = (Symbol::Thickness.number(), Symbol::OpeningVariable.number());
    let value = opening_at(SelfWeight::Heyman, &eta);
    let printed = eta.int(2) / (eta.int(2) + &eta);
    d.identity("A(eta)", &value, &printed)?;
    let inverse = overturning::heyman(&a);
    let back = opening_at(SelfWeight::Heyman, &inverse);
    d.identity("A(eta(A)) = A, with eta(A) = 2 (1/A - 1)", &back, &a)?;
    let forth = value.evaluate(&eta, |_| eta.clone());
    let both = with(&inverse, &[Symbol::OpeningVariable], &forth);
    d.identity("eta(A(eta)) = eta", both, &eta)
}

fn milankovitch(d: &mut Derivation) -> Checked {
    let (eta, a, q) =
        (Symbol::Thickness.number(), Symbol::OpeningVariable.number(), Symbol::SquareRoot.number());
    d.assume("2 + eta != 0; q^2 = 3 (3A^2 + 4A - 4)");
    let ring = Ring::new(SelfWeight::Milankovitch, &eta);
    let thirteen = overturning::opening_variable(&ring);
    let printed = (eta.int(12) + eta.square()) / ((eta.int(2) + &eta) * eta.int(6));
    d.identity("A(eta)", thirteen.value(), &printed)?;
    let quadratic = (eta.square() - a.int(6) * &a * &eta + a.int(12) - a.int(12) * &a) / eta.int(6);
    let words = "A = A(eta), cleared: eta^2 - 6 A eta + 12 - 12 A = 0, over 6";
    d.identity(words, -thirteen.residual(&a), &quadratic)?;
    let rooted = Relations::none().with(
        Symbol::SquareRoot,
        2,
        overturning::radicand(&a).numerator().clone(),
    );
    let root =
        |q: &Fraction| with(&quadratic, &[Symbol::Thickness], &overturning::milankovitch(&a, q));
    d.identity_under("eta = 3A - q is a root", root(&q), a.int(0), &rooted)?;
    d.identity_under("and so is eta = 3A + q", root(&-q.clone()), a.int(0), &rooted)
}

fn milankovitch_branch(d: &mut Derivation) -> Checked {
    let (eta, a) = (Symbol::Thickness.number(), Symbol::OpeningVariable.number());
    let ring = Ring::new(SelfWeight::Milankovitch, &eta);
    let value = overturning::opening_variable(&ring).value();
    let slope = value.partial(Symbol::Thickness);
    let expected = (eta.clone() - eta.int(2)) * (eta.clone() + eta.int(6))
        / (ring.extrados().square() * eta.int(6));
    d.identity("dA/d eta, negative on 0 <= eta < 2", &slope, &expected)?;
    let at = |n: i32| opening_at(SelfWeight::Milankovitch, &Rational::from(n));
    d.equal("A at eta = 0", &at(0), &Rational::from(1))?;
    d.equal("A at eta = 2", &at(2), &Rational::from((2, 3)))?;
    let factors = (a.int(3) * &a - a.int(2)) * (a.clone() + a.int(2)) * a.int(3);
    let words = "the radicand of (15) is 3 (3A - 2)(A + 2): zero at 2/3, positive above";
    d.identity(words, overturning::radicand(&a), &factors)?;
    let sum = a.int(3) * &a + a.int(3) * &a - a.int(4);
    let expected = (a.int(3) * &a - a.int(2)) * a.int(2);
    d.identity("the two roots have the sum 6A, and 6A - 4 = 2 (3A - 2) >= 0", &sum, &expected)?;
    lemmas(d, ["alpha-one-to-one"])?;
    let end = slope.evaluate(&Rational::new(), |_| Rational::from(2));
    d.equal("dA/d eta at eta = 2", &end, &Rational::new())?;
    d.conclude(
        "With one root in [0, 2] the other is 6A - eta >= 2: the sign in (15) is right. d alpha/d eta is \
         dA/d eta over dA/d alpha, which is not zero: both vanish at eta = 2.",
    )
}

fn end_of_rotation(d: &mut Derivation) -> Checked<Finding> {
    let ring = ring();
    let (eta, delta) = (&ring.thickness, Symbol::Flag.number());
    d.assume("h = 0; 2 - eta != 0; beta cot(beta) = 1, its limit at beta = 0");
    let fifth = thrust::tangency(&eta.int(1), &ring).value();
    d.define("(5) at beta -> 0", &fifth);
    let with = |inner: Fraction| eta.int(1) - eta.clone() / ring.intrados() * &(eta.int(1) + inner);
    let corrected = with(delta.clone() * eta / eta.int(6));
    d.identity("it is 1 - eta/(2-eta) (1 + delta_M eta/6)", &corrected, &fifth)?;
    let printed = with(delta * eta.square() / eta.int(12));
    let code = overturning::end_of_rotation(&ring) * eta.int(2) / ring.intrados();
    let words = "2 (2 - eta - fac_M)/(2 - eta), which the program uses, is the same";
    d.identity(words, &code, &fifth)?;
    // At the root the paper gives, the corrected form is zero and the printed one is not.
    let root = Surd::new(-6, 4, 3);
    let at = |form: &Fraction| {
        form.evaluate(&root, |x| if x == Symbol::Flag { root.int(1) } else { root.clone() })
    };
    d.equal("the corrected form at delta_M = 1, eta = 2 (2√3 - 3)", &at(&corrected), &root.int(0))?;
    let counterexample = d.differ(
        "the printed form at delta_M = 1, eta = 2 (2√3 - 3)",
        &at(&printed),
        &root.int(0),
    )?;
    let one = Rational::from(1);
    let heyman = |form: &Fraction| {
        form.evaluate(&one, |x| if x == Symbol::Flag { Rational::new() } else { one.clone() })
    };
    d.equal(
        "for delta_M = 0 both forms agree, with the root 1",
        &heyman(&printed),
        &Rational::new(),
    )?;
    d.equal("(corrected)", &heyman(&corrected), &Rational::new())?;
    Ok(Finding::Misprint {
        counterexample,
        corrected: "1 - eta/(2-eta) (1 + delta_M eta/6) = 0, as the second form of (5) has it",
    })
}

/// The condition behind (16) falls with the thickness, and vanishes at `eta_l`.
pub(super) fn end_of_rotation_is_simple(
    d: &mut Derivation,
    words: &str,
    shown: impl Fn(&Surd) -> String,
) -> Checked {
    let (ring, delta) = (ring(), Symbol::Flag.number());
    let slope = overturning::end_of_rotation(&ring).partial(Symbol::Thickness);
    d.identity(words, slope, -(delta.int(1) + delta.clone() * &ring.thickness / delta.int(6)))?;
    for weight in SelfWeight::ALL {
        let end = overturning::thickness_at_end(weight, &Surd::new(0, 1, 3));
        let value = overturning::end_of_rotation(&Ring::new(weight, &end));
        let words = format!("it vanishes at eta_l{}, {weight} weight", shown(&end));
        d.equal(words, &value, &end.int(0))?;
    }
    Ok(())
}

fn limit_values(d: &mut Derivation) -> Checked {
    d.assume("h = 0, beta_r -> 0, 0 < eta < 2");
    let cases = [
        (SelfWeight::Heyman, Surd::rational(1, 3), Surd::rational((2, 3), 3)),
        (SelfWeight::Milankovitch, Surd::new(-6, 4, 3), Surd::new(-1, 1, 3)),
    ];
    for (weight, eta, a) in cases {
        let ring = Ring::new(weight, &eta);
        let rest = overturning::end_of_rotation(&ring);
        d.equal(format!("{weight}: (16) corrected at eta = {eta}"), &rest, &eta.int(0))?;
        d.equal(format!("{weight}: A by (13)"), &opening_at(weight, &eta), &a)?;
    }
    let eta = Symbol::Thickness.number();
    let residual =
        overturning::end_of_rotation(&Ring::new(SelfWeight::Milankovitch, &eta)) * eta.int(12);
    let quadratic = eta.int(12) - eta.int(12) * &eta - eta.square();
    d.identity(
        "12 times (16) is 12 - 12 eta - eta^2 for Milankovitch: falling for eta > 0, so the root is the only one",
        &residual,
        &quadratic,
    )
}

fn physical_limit(d: &mut Derivation) -> Checked {
    for (weight, a) in [(SelfWeight::Heyman, (1, 2)), (SelfWeight::Milankovitch, (2, 3))] {
        let opening = opening_at(weight, &Rational::from(2));
        d.equal(format!("{weight}: A by (13) at eta = 2"), &opening, &Rational::from(a))?;
    }
    Ok(())
}

fn opening_variable_falls(d: &mut Derivation) -> Checked {
    let alpha = Symbol::half_opening();
    d.assume("0 < alpha < pi");
    let rules = along_the_opening();
    let opening = thrust::opening_variable(&alpha).value();
    let slope = opening.derivative(&rules);
    let rest = alpha.rad.clone() - &alpha.sin;
    let expected = -(rest.clone() / alpha.versine());
    d.on_circle("dA/d alpha = -(alpha - sin(alpha))/(1 - cos(alpha))", &slope, &expected)?;
    let words =
        "(alpha - sin(alpha))' = 1 - cos(alpha), positive: so alpha > sin(alpha), and A falls";
    d.on_circle(words, rest.derivative(&rules), alpha.versine())?;
    let parts = thrust::opening_variable(&alpha);
    for (words, part, at_zero) in [
        ("alpha sin(alpha) at 0 has the second derivative", &parts.numerator, 2),
        ("1 - cos(alpha) has it too, so that A -> 2", &parts.denominator, 1),
    ] {
        let bend = part.derivative(&rules).derivative(&rules);
        let none = Rational::new();
        let start = |x| Rational::from(i32::from(x == Symbol::CosineOfOpening));
        d.equal(words, &bend.evaluate(&none, start), &Rational::from(at_zero))?;
    }
    let straight = |x| Rational::from(i32::from(x == Symbol::HalfOpening));
    let end = parts.numerator.evaluate(&Rational::new(), straight);
    d.equal("alpha sin(alpha) at pi, where sin(alpha) = 0", &end, &Rational::new())
}

fn shared_opening(d: &mut Derivation) -> Checked {
    d.assume("A fixes alpha (alpha-one-to-one)");
    let [one, two] = [1, 2].map(Rational::from);
    let (last, end) =
        (opening_at(SelfWeight::Milankovitch, &two), opening_at(SelfWeight::Heyman, &one));
    d.equal("A_L of Milankovitch's weight and A_l of Heyman's", &last, &end)?;
    let rest = overturning::end_of_rotation(&Ring::new(SelfWeight::Heyman, &one));
    d.equal("eta = 1 is Heyman's eta_l", &rest, &Rational::new())
}
