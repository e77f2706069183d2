//! Units of `r`, `w` and `h`: (1), and the caption of Fig. 1.

use super::letters::{ring, with};
use super::{Checked, Derivation, Finding, claims};
use crate::arch::{Ring, SelfWeight, overturning, statics, thrust};
use crate::number::Field;
use crate::symbolic::{Fraction, Letters, Symbol};
use rug::Rational;

claims! {
    AsPrinted("eq-1", "Eq. (1)", intrinsic_thrust): "the intrinsic thrust eta h is H/(gamma d r^2)";
    AsPrinted("eq-1-weight", "Fig. 1, caption", half_weight):
        "the half arch weighs W = w r alpha; the shoulder's reactions are W upwards and the thrust H sideways";
    Finds("eq-1-radius", "Fig. 1, caption", inner_radius): "r is the inner radius of the arch";
}

fn intrinsic_thrust(d: &mut Derivation) -> Checked {
    let [eta, h, radius] = [Symbol::Thickness, Symbol::Thrust, Symbol::Radius].map(Symbol::number);
    let [depth, gamma] = [Symbol::Depth, Symbol::SpecificWeight].map(Symbol::number);
    d.assume("gamma, d, r are not zero");
    let thickness = eta.clone() * &radius;
    d.define("t, from eta = t/r", &thickness);
    let weight = gamma.clone() * thickness * &depth;
    d.define("w = gamma t d", &weight);
    let force = h.clone() * weight * &radius;
    d.define("H, from h = H/(w r)", &force);
    let intrinsic = force / (gamma * depth * radius.square());
    d.identity("H/(gamma d r^2) is eta h", &intrinsic, eta * h)
}

/// The part of a half arch of the opening one between two radii: half the difference of their squares.
fn area([inner, outer]: [&Fraction; 2]) -> Fraction {
    (outer.square() - inner.square()) / outer.int(2)
}

/// The radii of the faces, in units of `r`, where `r` is that of the centreline.
fn faces(eta: &Fraction) -> [Fraction; 2] {
    let half = eta.ratio(1, 2) * eta;
    [eta.int(1) - &half, eta.int(1) + half]
}

fn half_weight(d: &mut Derivation) -> Checked {
    let [eta, h, radius] = [Symbol::Thickness, Symbol::Thrust, Symbol::Radius].map(Symbol::number);
    let [depth, gamma] = [Symbol::Depth, Symbol::SpecificWeight].map(Symbol::number);
    let alpha = Symbol::half_opening();
    d.assume("the ring lies between the radii r (1 - eta/2) and r (1 + eta/2), as in (2)-(6)");
    let [inner, outer] = faces(&eta);
    let weight = gamma.clone() * &depth * radius.square() * area([&inner, &outer]) * &alpha.rad;
    let printed = gamma * eta * &radius * depth * &radius * &alpha.rad;
    d.identity("gamma d times the area is w r alpha, w = gamma t d, t = eta r", &weight, printed)?;
    let (normal, shear) = (statics::normal_force(&alpha, &h), statics::shear_force(&alpha, &h));
    let upwards = normal.clone() * &alpha.sin + shear.clone() * &alpha.cos;
    d.on_circle("the shoulder bears upwards, in units of w r", &upwards, &alpha.rad)?;
    let sideways = normal * &alpha.cos - shear * &alpha.sin;
    d.on_circle("and sideways", &sideways, &h)
}

/// A formula of `eta` and the ring's centroid factor.
type PrintedFormula<T> = fn(&Ring<T>) -> T;

/// Value of the formula for a ring whose centreline has the radius `r (1 + eta/2)`, so that `r` is its inner
/// radius: `eta` and the value, both in units of the centreline, become those in units of `r`.
fn measured_inside<T: Field>(delta: &T, eta: &T, printed: PrintedFormula<T>) -> T {
    let centreline = eta.int(1) + eta.ratio(1, 2) * eta;
    printed(&Ring::with_flag(delta, &(eta.clone() / &centreline))) * centreline
}

/// (4) where `A = 1`.
fn whole<T: Field>(ring: &Ring<T>) -> T {
    ring.thickness.int(1) - overturning::opening_variable(ring).value()
}

/// (6).
fn centroid<T: Field>(ring: &Ring<T>) -> T {
    ring.centroid_factor.clone()
}

fn inner_radius(d: &mut Derivation) -> Checked<Finding> {
    let (ring, alpha) = (ring(), Symbol::half_opening());
    let (eta, delta) = (&ring.thickness, Symbol::Flag.number());
    d.assume("eta > 0; lengths in units of r, forces in units of w r");
    d.conclude(
        "(2)-(6) are proved of a ring between the radii 1 - eta/2 and 1 + eta/2. Were r the inner radius, \
         the ring would lie between 1 and 1 + eta: the same equations would hold with eta and h over the \
         radius 1 + eta/2 of its centreline.",
    )?;
    let opening = thrust::opening_variable(&alpha).value();
    let words = "h_2 of (4), less A, is h_2 at A = 1 less 1";
    let second = thrust::whole(&alpha, &ring).value() - opening;
    d.identity(words, &second, whole(&ring) - eta.int(1))?;
    let radius = Symbol::Radius.number();
    let (inner, outer) = (radius.int(1), radius.int(1) + eta);
    let primitive = |power: usize, at: &Fraction| {
        let one = Fraction::from(Symbol::Radius.polynomial().power(power));
        with(&one, &[Symbol::Radius], at)
    };
    let between = |power| primitive(power, &outer) - primitive(power, &inner);
    let wedge = between(3) * eta.int(2) / (between(2) * eta.int(3));
    let words = "the centroid of a wedge between the radii 1 and 1 + eta, moment over area";
    let inside = measured_inside(&delta.int(1), eta, centroid);
    d.identity(words, &wedge, &inside)?;
    let thick = area([&inner, &outer]) / eta;
    let middle = eta.int(1) + eta.ratio(1, 2) * eta;
    let words = "the weight of the half arch over w r alpha, were r the inner radius";
    d.identity(words, &thick, &middle)?;
    let one = Rational::from(1);
    let at_one = middle.evaluate(&one, |_| one.clone());
    let words = "W over w r alpha at eta = 1: with the inner radius";
    let mut found = vec![d.differ(words, &at_one, &one)?];
    let formulas: [(&str, PrintedFormula<Rational>, SelfWeight); 3] = [
        ("the radius of the centroids, (6), at eta = 1", centroid, SelfWeight::Milankovitch),
        ("h_2 of (4) at A = 1, eta = 1, Heyman's weight", whole, SelfWeight::Heyman),
        ("h_2 of (4) at A = 1, eta = 1, Milankovitch's weight", whole, SelfWeight::Milankovitch),
    ];
    for (words, printed, weight) in formulas {
        let words = format!("{words}: with the inner radius");
        let inside = measured_inside(&Rational::from(weight.flag()), &one, printed);
        found.push(d.differ(&words, &inside, &printed(&Ring::new(weight, &one)))?);
    }
    Ok(Finding::Misprint {
        counterexample: found.join("; "),
        corrected: "r is the radius of the centreline",
    })
}
