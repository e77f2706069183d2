//! All arches between measured ends: which of them decide for all.
//!
//! A state is a thrust `h` and a crown moment `p`. What a joint asks of them knows neither where the arch ends nor the
//! other joints, and asks no more where there is more friction or, up to the physical limit, more thickness. So the
//! states of an arch are among those of each narrower, rougher and thicker one.
//!
//! Where span, rise and thickness are measured they make the half opening and the ratio of the thickness to the radius
//! together. An arch does not change with its scale: of those with one ratio of rise to span the largest is the
//! thinnest. And of one rise the longer is the safer, so that the shortest span with the highest rise decides.

use super::contacts::{label, margin_at};
use super::landmarks::state_of;
use super::letters::{ring, with};
use super::rises::{along_the_rise, slenderness};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::{SelfWeight, statics};
use crate::number::{Angle, Field};
use crate::problem::measures::{Circle, circle};
use crate::symbolic::{Fraction, Letters, Symbol, along_the_opening};

claims! {
    Ours("survey-corners", "Sec. 2", corners):
        "each state that is admissible in an arch is so in every arch with the same weight, no wider half opening, no \
         less friction and no less thickness eta, up to 2: if the widest, least rough and thinnest arch of a box \
         stands all do, and if the narrowest, roughest and thickest falls all do";
    Ours("survey-course", "Fig. 1", course):
        "of the arches between measured spans, rises and thicknesses, the friction being one, none stands less easily \
         than a thinnest one with the longest span or the highest rise, and none more easily than a thickest one with \
         the shortest span or the lowest rise";
    Ours("survey-step", "Fig. 1", step):
        "of the arches with one span between two rises, or with one rise between two spans, none stands less easily \
         than one with the half opening of the highest or shortest and the larger radius of the two ends, and none \
         more easily than one with the half opening of the lowest or longest and the least radius, which is that of an \
         end or half the span";
    Ours("survey-rise", "Fig. 1", rise):
        "if an arch stands, each with the same weight, thickness and rise and no less friction stands that has a \
         longer span, wherever the rise is measured";
    Ours("survey-worst", "Fig. 1", worst):
        "of the arches between measured spans, rises, thicknesses and frictions none stands less easily than the \
         thinnest and least rough one with the shortest span and the highest rise, and none more easily than the \
         thickest and roughest one with the longest span and the lowest rise";
}

fn corners(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 < eta <= 2, 0 <= mu <= inf, 0 <= delta_M <= 1");
    let (joint, ring) = (Symbol::joint(), ring());
    let [h, p, delta] =
        [Symbol::Thrust, Symbol::CrownMoment, Symbol::Flag].map(|symbol| symbol.number());
    let (eta, two, none) = (&ring.thickness, h.int(2), h.int(0));
    let normal = statics::normal_force(&joint, &h);
    let [upper, lower] =
        [Contact::Extrados, Contact::Intrados].map(|contact| margin_at(contact, &joint));
    let words = "U + L: where neither is negative N is not, and h is not, which is N at the crown";
    d.identity(words, upper.clone() + &lower, normal.clone() * eta)?;
    let crown = margin_at(Contact::Intrados, &Angle::zero(&h));
    let words = "L at the crown: so p is not negative either";
    d.identity(words, crown, p.clone() - ring.intrados() * &h / &two)?;
    for contact in Contact::ALL {
        let margin = margin_at(contact, &joint);
        let words = format!("d({})/d alpha at a joint", label(contact));
        d.identity(words, margin.derivative(&along_the_opening()), &none)?;
        let is_of_friction = matches!(contact, Contact::Inwards | Contact::Outwards);
        let (by_friction, words) = match is_of_friction {
            true => (&normal, "not negative; without limit the condition is N >= 0"),
            false => (&none, "a face knows no friction"),
        };
        let words = format!("d({})/d mu: {words}", label(contact));
        d.identity(words, margin.partial(Symbol::Friction), by_friction)?;
        if is_of_friction {
            let words = format!("d({})/d eta: friction knows no thickness", label(contact));
            d.identity(words, margin.partial(Symbol::Thickness), &none)?;
        }
    }
    let growth = normal / &two + delta.clone() * eta * joint.versine() / h.int(6);
    d.identity("dL/d eta: not negative", lower.partial(Symbol::Thickness), growth)?;
    let outwards = ring.extrados() / &two;
    let held = h.int(12) - delta.clone() * eta * (h.int(4) + eta);
    let growth = (p / &two + joint.versine() * &held / h.int(24)) / outwards.square();
    let per_radius = upper / outwards;
    let words = "d(U/(1 + eta/2))/d eta: not negative where the bracket is not";
    d.identity(words, per_radius.partial(Symbol::Thickness), growth)?;
    let at_limit = ring.intrados() * (h.int(6) + eta);
    let further = (h.int(1) - delta) * eta * (h.int(4) + eta);
    d.identity("the bracket: not negative up to eta = 2", held, at_limit + further)?;
    d.theorems(["Surveys.admissible_if_narrower_rougher_thicker"])?;
    d.theorems(["Surveys.least_thickness_is_monotone"])?;
    d.conclude(
        "The least friction does not fall as the half opening grows, nor rise with the thickness; the largest thrust h \
         falls with the half opening and rises with friction and thickness, the least rises and falls: all of them not \
         always strictly.",
    )
}

/// The span and the rise as letters.
fn measured() -> [Fraction; 2] {
    [Symbol::Span, Symbol::Rise].map(|symbol| symbol.number())
}

/// The half opening and the radius by span and rise.
fn geometry(d: &mut Derivation) -> Checked {
    let (alpha, r) = (Symbol::half_opening(), Symbol::Radius.number());
    let [span, rise] = [r.int(2) * &r * &alpha.sin, r.clone() * alpha.versine()];
    let [quotient, radius] = circle(&span, &rise);
    let words =
        "the radius of the circle with the span 2 r sin(alpha) and the rise r (1 - cos(alpha))";
    d.on_circle(words, radius, &r)?;
    let words = "q = 2 rise/s there, which is tan(alpha/2)";
    d.on_circle(words, &quotient, alpha.versine() / &alpha.sin)?;
    let slope = quotient.derivative(&along_the_opening());
    let words = "dq/d alpha: positive, so that the half opening grows with q and knows no more";
    d.on_circle(words, slope, r.int(1) / (r.int(1) + &alpha.cos))
}

/// The ratio of the thickness to the radius falls with the radius and grows with the thickness.
fn ratio_of_thickness(d: &mut Derivation) -> Checked {
    let (t, radius) = (Symbol::MeasuredThickness.number(), Symbol::Radius.number());
    for circle in Circle::ALL {
        let centreline = radius.clone() + t.ratio(circle.to_centreline(), 2) * &t;
        let circle = circle.name();
        let ratio = t.clone() / &centreline;
        let square = centreline.square();
        let words = format!("d eta/dr, r measured at the {circle}: negative");
        d.identity(words, ratio.partial(Symbol::Radius), -(t.clone() / &square))?;
        let words = format!("d eta/dt there, {circle}: positive");
        d.identity(words, ratio.partial(Symbol::MeasuredThickness), radius.clone() / square)?;
    }
    Ok(())
}

fn course(d: &mut Derivation) -> Checked {
    d.assume("the thickness is at most twice the radius of the centreline");
    lemmas(d, ["survey-corners"])?;
    geometry(d)?;
    ratio_of_thickness(d)?;
    let [span, rise] = measured();
    let [quotient, radius] = circle(&span, &rise);
    let words = "s dr/ds + rise dr/d rise: the radius of an arch grows with its scale";
    let scaled = radius.partial(Symbol::Span) * &span + radius.partial(Symbol::Rise) * &rise;
    d.identity(words, scaled, &radius)?;
    let scaled = quotient.partial(Symbol::Span) * &span + quotient.partial(Symbol::Rise) * &rise;
    d.identity("s dq/ds + rise dq/d rise: its half opening does not", scaled, rise.int(0))?;
    d.conclude(
        "Make an arch larger, with its thickness kept, up to the longest span or the highest rise: the half opening \
         is the same, the radius larger and eta smaller, and it stands no more easily. Made smaller, down to the \
         shortest span or the lowest rise, it stands no less easily. So does each with the least thickness, and with \
         the largest.",
    )?;
    for weight in SelfWeight::ALL {
        let [narrow, wide] = [("pi/2", (2, 1)), ("2atan(20/21)", (841, 400))];
        let [narrow, wide] = [narrow, wide].map(|(alpha, (n, m))| {
            let eta = state_of(alpha, "0.6", weight)?.thickness;
            Ok(eta.ratio(n, m) * eta)
        });
        let words = "a longer span may be the safer one: rise 2 m, friction 0.6, the least thickness of a span of 4.2 \
                     m is below that of 4 m";
        d.less(format!("{words}, {weight}"), [&wide?, &narrow?])?;
    }
    Ok(())
}

fn step(d: &mut Derivation) -> Checked {
    lemmas(d, ["survey-corners", "survey-course"])?;
    let [span, rise] = measured();
    let [quotient, radius] = circle(&span, &rise);
    let quarter = span.clone() / (rise.int(4) * &rise);
    d.identity("dr/ds: positive", radius.partial(Symbol::Span), quarter)?;
    let (half, two) = (span.clone() / span.int(2), rise.int(2));
    let slope = radius.partial(Symbol::Rise);
    let expected = (rise.clone() - &half) * (rise.clone() + &half) / (two.clone() * rise.square());
    d.identity("dr/d rise: of the sign of rise - s/2", &slope, expected)?;
    let bend = span.square() / (rise.int(4) * rise.square() * &rise);
    let words = "d²r/d rise²: positive, so that r is largest at an end";
    d.identity(words, slope.partial(Symbol::Rise), bend)?;
    let words = "r where the rise is half the span: the least of a span";
    d.identity(words, with(&radius, &[Symbol::Rise], &half), &half)?;
    let words = "dq/ds: negative";
    d.identity(words, quotient.partial(Symbol::Span), -(quotient.clone() / &span))?;
    d.identity("dq/d rise: positive", quotient.partial(Symbol::Rise), two / &span)?;
    d.conclude(
        "From a longer span to a shorter, and from a lower rise to a higher, the half opening grows. One with the \
         largest half opening and, by the largest radius, the least eta stands no more easily than any of them; one \
         with the smallest half opening and the least radius no less easily. Neither need be an arch of them.",
    )
}

fn rise(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 < eta <= 2, 0 < mu <= inf, 0 <= delta_M <= 1");
    lemmas(d, ["survey-corners"])?;
    let (alpha, eta) = (Symbol::half_opening(), Symbol::Thickness.number());
    let over_rise = slenderness() / alpha.versine();
    let words = "D of tau/(1 - cos(alpha)), the thickness over the rise of the extrados";
    d.on_circle(words, along_the_rise(&over_rise), eta.int(0))?;
    for (circle, outwards) in [("intrados", 1), ("centreline", 0), ("extrados", -1)] {
        let radius = eta.int(1) - eta.ratio(outwards, 2) * &eta;
        let over_rise = eta.clone() / (radius * alpha.versine());
        let expected = eta.int(1 + outwards) * &eta / (eta.int(2) - eta.int(outwards) * &eta);
        let words = format!("D of the logarithm of the thickness over the rise, {circle}");
        d.on_circle(words, along_the_rise(&over_rise) / &over_rise, expected)?;
    }
    d.theorems(["Rises.longer_arch_stands", "Rises.longer_span_stands"])
}

fn worst(d: &mut Derivation) -> Checked {
    d.assume("the thickness is at most twice the radius of the centreline");
    lemmas(d, ["survey-corners", "survey-course", "survey-rise"])?;
    let [span, rise] = measured();
    let scale = Symbol::Radius.number();
    let words = "q of an arch, and of that with k times the span and k times the rise";
    let [quotient, _] = circle(&span, &rise);
    let [scaled, _] = circle(&(span * &scale), &(rise * &scale));
    d.identity(words, scaled, quotient)?;
    d.conclude(
        "Let the arch with the shortest span and the highest rise stand. Another one, made larger up to the highest \
         rise, has a span that is no shorter: it stands. Made smaller again, with its thickness kept, it has a larger \
         eta, and stands. Let an arch stand. One of its rise, as much longer as the longest span with the lowest rise \
         asks for, stands too, and made smaller down to the lowest rise it is that.",
    )?;
    d.conclude(
        "Neither more thickness nor more friction is in the way of it. So the least thickness in m grows with the \
         rise and falls with the span, not always strictly; and with a thickness given the friction that is required \
         does.",
    )
}
