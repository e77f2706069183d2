//! Sliding joints: (17) and (18).

use super::{Checked, Derivation, claims};
use crate::arch::{sliding, statics};
use crate::number::Field;
use crate::symbolic::{Fraction, Letters, Relations, Symbol, along_the_joint, along_the_opening};

claims! {
    AsPrinted("eq-17", "Eq. (17)", shoulder):
        "mu_ss = (h sin(alpha) - alpha cos(alpha))/(h cos(alpha) + alpha sin(alpha)) is the friction at which the \
         shoulder slides, and h_mu its inverse";
    AsPrinted("eq-18-stationary", "Eq. (18)", stationary):
        "T/N is stationary along the arch at beta_s = sqrt(h (1-h)), rises before and falls after: it has one \
         maximum";
    AsPrinted("eq-18", "Eq. (18)", inner):
        "the friction at which an inner joint slides is ((1-h) cos(beta) - beta sin(beta))/((1-h) sin(beta) + beta \
         cos(beta)) at beta_s";
    Implicit("eq-18-falls", "Eq. (18)", inner_falls): "mu_is falls strictly as h grows on (0, 1)";
    AsPrinted("sliding-thickness", "Sec. 2.2", no_thickness):
        "(17) and (18) see neither the thickness nor the self-weight model";
    AsPrinted("sliding-opening", "Sec. 2.2", no_half_opening):
        "the half opening enters sliding by (17) alone: (18) does not see it";
}

/// `T` and `N` at `beta`.
fn forces() -> (Fraction, Fraction) {
    let (joint, thrust) = (Symbol::joint(), Symbol::Thrust.number());
    (statics::shear_force(&joint, &thrust), statics::normal_force(&joint, &thrust))
}

/// Without thrust an inner joint asks for the cotangent.
pub(super) fn ratio_without_thrust(d: &mut Derivation) -> Checked {
    let joint = Symbol::joint();
    let none = joint.rad.int(0);
    let ratio = statics::shear_force(&joint, &none) / statics::normal_force(&joint, &none);
    d.identity("T/N at any joint where h = 0", ratio, joint.cos / joint.sin)
}

fn shoulder(d: &mut Derivation) -> Checked {
    let (alpha, thrust, friction) =
        (Symbol::half_opening(), Symbol::Thrust.number(), Symbol::Friction.number());
    d.assume("N(alpha) != 0; sin(alpha) - mu cos(alpha) != 0");
    let ratio = statics::shear_force(&alpha, &thrust) / statics::normal_force(&alpha, &thrust);
    let printed = (thrust.clone() * &alpha.sin - alpha.rad.clone() * &alpha.cos)
        / (thrust.clone() * &alpha.cos + alpha.rad.clone() * &alpha.sin);
    let value = sliding::shoulder(&alpha, &thrust).value();
    d.identity("(17) as printed", &value, &printed)?;
    d.identity("it is -T/N at alpha", -ratio, &value)?;
    let inverse = sliding::shoulder_thrust(&alpha, &friction).value();
    let printed = alpha.rad.clone() * &(alpha.cos.clone() + friction.clone() * &alpha.sin)
        / (alpha.sin.clone() - friction.clone() * &alpha.cos);
    d.identity("h_mu as printed", &inverse, &printed)?;
    let back = sliding::shoulder(&alpha, &inverse).value();
    d.on_circle("mu_ss(h_mu) = mu", &back, &friction)
}

fn stationary(d: &mut Derivation) -> Checked {
    d.assume("0 < h < 1, 0 <= beta < pi, N > 0 there (it is h at the crown)");
    let (shear, normal) = forces();
    let slope = (shear / &normal).derivative(&along_the_joint());
    d.define("(T/N)'", &slope.reduced(&Relations::trigonometric()));
    let joint = Symbol::Joint.number();
    let expected = -sliding::steepest(&joint, &Symbol::Thrust.number()) / normal.square();
    let words = "it is (h (1-h) - beta^2)/N^2: positive before beta_s, negative after";
    d.on_circle(words, &slope, &expected)
}

fn inner(d: &mut Derivation) -> Checked {
    let (joint, thrust) = (Symbol::joint(), Symbol::Thrust.number());
    d.assume("beta^2 = h (1-h), 0 < h < 1; the denominators do not vanish");
    let steepest = &Symbol::Thrust.polynomial() - &Symbol::Thrust.polynomial().power(2);
    let relations = Relations::trigonometric().with(Symbol::Joint, 2, steepest);
    let rest = thrust.int(1) - &thrust;
    let printed = (rest.clone() * &joint.cos - joint.rad.clone() * &joint.sin)
        / (rest * &joint.sin + joint.rad.clone() * &joint.cos);
    let value = sliding::inner(&joint, &thrust).value();
    d.identity("(18) as printed", &value, &printed)?;
    let (shear, normal) = forces();
    d.identity_under("it is T/N at beta_s", shear / &normal, &value, &relations)
}

fn inner_falls(d: &mut Derivation) -> Checked {
    d.assume("0 < h < 1; N > 0 at beta_s");
    let (shear, normal) = forces();
    let slope = (shear / &normal).partial(Symbol::Thrust);
    let expected = -(Symbol::Joint.number() / normal.square());
    d.on_circle("at a fixed joint, d(T/N)/dh = -beta/N^2, negative", &slope, &expected)?;
    let moved = (forces().0 / forces().1).derivative(&along_the_joint());
    let steepest = &Symbol::Thrust.polynomial() - &Symbol::Thrust.polynomial().power(2);
    let relations = Relations::trigonometric().with(Symbol::Joint, 2, steepest);
    let words = "d(T/N)/d beta = 0 at beta_s, so that d mu_is/dh is -beta_s/N(beta_s)^2";
    d.identity_under(words, &moved, moved.int(0), &relations)
}

fn no_thickness(d: &mut Derivation) -> Checked {
    let (alpha, joint, thrust) = (Symbol::half_opening(), Symbol::joint(), Symbol::Thrust.number());
    let forms = [
        ("(17)", sliding::shoulder(&alpha, &thrust).value()),
        ("(18)", sliding::inner(&joint, &thrust).value()),
    ];
    for (name, form) in forms {
        for symbol in [Symbol::Thickness, Symbol::Flag] {
            let slope = form.partial(symbol);
            let words = format!("the derivative of {name} to {}", symbol.names().0);
            d.identity(words, &slope, slope.int(0))?;
        }
    }
    Ok(())
}

fn no_half_opening(d: &mut Derivation) -> Checked {
    let (alpha, joint, thrust) = (Symbol::half_opening(), Symbol::joint(), Symbol::Thrust.number());
    let rules = along_the_opening();
    let inner = sliding::inner(&joint, &thrust).value().derivative(&rules);
    d.identity("the derivative of (18) to alpha", &inner, inner.int(0))?;
    let steepest = sliding::steepest(&alpha.rad, &thrust);
    d.on_circle(
        "the derivative of (17) to alpha, not zero but at beta_s",
        sliding::shoulder(&alpha, &thrust).value().derivative(&rules),
        steepest / statics::normal_force(&alpha, &thrust).square(),
    )
}
