//! Values that the text gives to few digits, and frictions that are said to suffice.

use super::along::{self, CurveStates, landmark};
use super::landmarks::{both, certain_if, semicircle, state_of};
use super::measured::at_most;
use super::{Checked, Derivation, Support, claims, lemmas};
use crate::arch::{SelfWeight, Unknown};
use crate::certify::Undecided;
use crate::number::{Ball, Decimal, Field, Rounded, arctangent, degrees};
use crate::problem::{Landmark, Mode, Quantity};
use rug::Rational;

claims! {
    AsPrinted("rounded-values", "Sec. 2.1-5, Fig. 7-12", rounded_values):
        "the values given to few digits, such as beta_r = 59.7° at T or, coarser, 20° for 22°, are roundings of the \
         true ones";
    Measured("landmark-S-near-J", "Sec. 4", nearness): "S and J are rather near in the eta-mu map";
    Measured("semicircle", "Sec. 5", semicircle_suffices):
        "for the semicircle a friction of about 0.395, 22°, suffices to prevent sliding of the shoulder and warrants \
         purely rotational collapse";
    Measured("suffices-T", "Sec. 5", no_shoulder_sliding):
        "a friction of about 1.277, 52°, suffices to prevent any mixed sliding-rotational mode";
    Measured("suffices-B", "Sec. 5", no_pure_sliding):
        "a friction of about 1.854, 62°, suffices to prevent any purely sliding mode";
}

/// The values to few digits: landmark, weight, quantity, text, places where it stands.
const ROUNDED: &[(Landmark, SelfWeight, Quantity, &[&str])] = {
    use {Landmark::*, Quantity::*, SelfWeight::*};
    &[
        (WidestJoint, Milankovitch, RotationJointDegrees, &["64.2"]),
        (WidestJoint, Milankovitch, HalfOpeningDegrees, &["125.8"]),
        (RotationEnd, Milankovitch, HalfOpeningDegrees, &["148.4", "1.5e2"]),
        (RotationEnd, Milankovitch, Thickness, &["0.93"]),
        (RotationEnd, Heyman, HalfOpeningDegrees, &["151.7", "1.5e2"]),
        (OverturningEnd, Heyman, HalfOpeningDegrees, &["159.7", "1.6e2"]),
        (OverturningEnd, Milankovitch, HalfOpeningDegrees, &["151.7", "1.5e2"]),
        (Triple, Milankovitch, HalfOpening, &["2.43"]),
        (Triple, Milankovitch, HalfOpeningDegrees, &["139.2", "139", "1.4e2"]),
        (Triple, Milankovitch, Friction, &["1.277"]),
        (Triple, Milankovitch, FrictionAngleDegrees, &["51.9", "52", "5e1"]),
        (Triple, Milankovitch, RotationJointDegrees, &["59.7", "60"]),
        (Triple, Milankovitch, SlidingJointDegrees, &["18.3", "2e1"]),
        (Shift, Milankovitch, HalfOpeningDegrees, &["145.0", "145"]),
        (Shift, Milankovitch, FrictionAngleDegrees, &["57.0", "57"]),
        (Shift, Milankovitch, SlidingJointDegrees, &["16.0", "16"]),
        (Junction, Milankovitch, Thickness, &["0.9"]),
        (Junction, Milankovitch, HalfOpeningDegrees, &["145.2"]),
        (Junction, Milankovitch, FrictionAngleDegrees, &["57.1"]),
        (Junction, Milankovitch, SlidingJointDegrees, &["16.0"]),
        (Border, Milankovitch, HalfOpeningDegrees, &["150.3", "150"]),
        (Border, Milankovitch, Friction, &["1.854"]),
        (Border, Milankovitch, FrictionAngleDegrees, &["61.7", "62", "6e1"]),
        (Border, Milankovitch, SlidingJointDegrees, &["13.9", "14"]),
    ]
};

/// Checks that `text` is the value rounded to its digits.
fn rounds_to(d: &mut Derivation, words: &str, value: &Ball, text: &str) -> Checked {
    let printed: Decimal = text.parse().map_err(|e| Undecided::new(format!("{e}")))?;
    let rounded = Rounded::from_ball(value, printed.significant_digits())
        .ok_or_else(|| Undecided::new(format!("the rounding of {words}")))?;
    let words = format!("{words} to the digits of {text}");
    d.equal(words, &rounded.value.to_rational(), &printed.to_rational())
}

fn rounded_values(d: &mut Derivation) -> Checked {
    for (landmark, weight, quantity, texts) in ROUNDED {
        let words = format!("{quantity} at {landmark}, {weight}");
        let value = along::quantity(*landmark, *weight, *quantity)?;
        for text in *texts {
            rounds_to(d, &words, &value, text)?;
        }
    }
    let [[_, heyman], [_, milankovitch]] = both(semicircle)?;
    let words = "the friction that the shoulder of a semicircle asks for, milankovitch weight,";
    rounds_to(d, words, &milankovitch, "0.395")?;
    for (friction, weight) in
        [(heyman, SelfWeight::Heyman), (milankovitch, SelfWeight::Milankovitch)]
    {
        let degrees = degrees(&arctangent(&friction));
        for text in ["22", "2e1"] {
            rounds_to(d, &format!("its angle in degrees, {weight} weight,"), &degrees, text)?;
        }
    }
    Ok(())
}

fn nearness(d: &mut Derivation) -> Checked {
    for weight in SelfWeight::ALL {
        let shift = landmark(Landmark::Shift, weight)?;
        let junction = landmark(Landmark::Junction, weight)?;
        for unknown in [Unknown::Thickness, Unknown::Friction] {
            let distance = junction.value(unknown).clone() - shift.value(unknown);
            let words = format!("{} from S to J, {weight} weight", unknown.name());
            at_most(d, (&words, &distance, ""), 3)?;
        }
    }
    Ok(())
}

/// Notes a friction, and its angle, that is the least to suffice.
fn least_friction(d: &mut Derivation, words: &str, friction: &Ball, digits: usize) -> Checked {
    at_most(d, (words, friction, ""), digits)?;
    let degrees = degrees(&arctangent(friction));
    at_most(d, ("its angle", &degrees, "°"), 3)
}

/// Checks the mode of an arch; with the other friction it has another.
fn collapses(
    d: &mut Derivation,
    (alpha, [friction, other]): (&str, [&str; 2]),
    weight: SelfWeight,
    mode: Mode,
) -> Checked {
    let words = format!("alpha = {alpha}, mu = {friction} gives {mode}, {weight} weight");
    d.certain(Support::Balls, words, [friction, other], |friction| {
        Ok(certain_if(state_of(alpha, friction, weight)?.mode == mode))
    })
}

fn semicircle_suffices(d: &mut Derivation) -> Checked {
    let sufficient = [(SelfWeight::Milankovitch, "0.3953"), (SelfWeight::Heyman, "0.3959")];
    for (weight, enough) in sufficient {
        let words = format!("the friction that the shoulder asks for, {weight} weight");
        least_friction(d, &words, &semicircle(weight)?[1], 4)?;
        collapses(d, ("pi/2", [enough, "0.395"]), weight, Mode::Rotational)?;
        collapses(d, ("pi/2", ["0.395", enough]), weight, Mode::SlidingRotational)?;
    }
    d.fails("a friction of 0.395 itself: [s,r,r] with either weight")
}

fn no_shoulder_sliding(d: &mut Derivation) -> Checked {
    lemmas(d, ["map-T-shoulder"])?;
    let (weight, words) = (SelfWeight::Milankovitch, "mu_T, milankovitch weight");
    least_friction(d, words, &landmark(Landmark::Triple, weight)?.friction, 5)?;
    collapses(d, ("2.430058", ["1.277", "1.3"]), weight, Mode::SlidingRotational)?;
    d.fails("a friction of 1.277 itself: alpha = 2.430058 is [s,r,r]")
}

fn no_pure_sliding(d: &mut Derivation) -> Checked {
    lemmas(d, ["map-B"])?;
    let (weight, words) = (SelfWeight::Milankovitch, "mu_B, milankovitch weight");
    let friction = landmark(Landmark::Border, weight)?.friction;
    least_friction(d, words, &friction, 5)?;
    // An arch thinner than B that slides purely with hardly less friction.
    let (text, alpha) = ("2.62307", Rational::from((262_307, 100_000)));
    let slides = CurveStates::sliding(&alpha)?.inner_friction();
    let least = Ball::enclosing(&Rational::from((18_537, 10_000)), slides.prec());
    d.less(format!("alpha = {text} slides purely with more than 1.8537"), [&least, &slides])?;
    let state = state_of(text, "1.8538", weight)?;
    d.less("with 1.8538 it stands, with eta < 2", [&state.thickness, &friction.int(2)])?;
    let printed = Ball::enclosing(&Rational::from((1854, 1000)), friction.prec());
    d.less("mu_B is below 1.854", [&friction, &printed])?;
    d.holds("a friction of 1.854 itself")
}
