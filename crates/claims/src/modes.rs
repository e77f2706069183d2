//! Reasons why there are seven collapse modes, and no others.
//!
//! A mechanism gives each joint at its limit a rate that is not negative, so that neither the thrust `h` nor the
//! crown moment `p` works on it. In an admissible state few joints are at their limit. Let `u` be the rate of the
//! crown's hinge, `l` of the haunch's, `v` of the shoulder's, `s` of the joint that slides inwards and `t` of the
//! shoulder that slides outwards. Then `l = u + v`, and with `a` and `b` the lever arms of the haunch,
//!
//! ```text
//! a u + sin(beta_s) s = b v + sin(alpha) t,      a, b > 0
//! ```
//!
//! **What gives way inside is carried by what gives way at the shoulder**: each mechanism is a sum of four, with one
//! term on each side.

use super::along::CurveStates;
use super::contacts::{label, margin_at, row_at, slopes};
use super::landmarks::{certain_if, state_of};
use super::letters::{ring, variables, with};
use super::{Checked, Derivation, Support, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::{Configuration, SelfWeight, contact, statics};
use crate::number::{Angle, Ball, Field};
use crate::problem::Mode;
use crate::symbolic::{Fraction, Letters, Symbol, along_the_joint};
use rug::Rational;

claims! {
    Ours("modes-lever", "Sec. 3", lever):
        "a line of thrust on the shoulder's extrados and on the intrados above it has a positive lever arm between \
         the two";
    AsPrinted("modes-seven", "Sec. 3", seven_modes):
        "the seven modes are all the symmetric ones there are: a mechanism without dilatancy that is its own mirror \
         image is one of them, or several at once";
    AsPrinted("modes-occur", "Sec. 3", modes_occur): "each of the seven modes occurs, with either weight";
}

/// The lever arm between the haunch's intrados and the shoulder's extrados.
fn lever(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 <= beta <= alpha, 0 < eta <= 2, h >= 0");
    let (joint, alpha, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let (h, eta) = (Symbol::Thrust.number(), &ring.thickness);
    let two = h.int(2);
    let arm = (ring.intrados() * &joint.cos - ring.extrados() * &alpha.cos) / &two;
    let sum = margin_at(Contact::Intrados, &joint) + margin_at(Contact::Extrados, &alpha);
    let bracket = sum.clone() + h.clone() * &arm;
    let free_of_h: Fraction = bracket.partial(Symbol::Thrust);
    d.identity("L(beta) + U(alpha) + h b is free of h", &free_of_h, h.int(0))?;
    let area = |at: &Angle<Fraction>| at.rad.clone() * &at.sin + &at.cos;
    let growth = area(&alpha) - area(&joint);
    let gain = (h.int(6) - Symbol::Flag.number() * eta) * eta / h.int(12);
    let expected = growth * ring.extrados() / &two
        + joint.rad.clone() * &joint.sin * eta
        + (joint.cos.clone() - &alpha.cos) * gain;
    d.identity("it is", &bracket, &expected)?;
    let words = "d(beta sin(beta) + cos(beta))/d beta, positive below pi/2";
    let slope = area(&joint).derivative(&along_the_joint());
    d.identity(words, &slope, joint.rad.clone() * &joint.cos)?;
    d.conclude(
        "Suppose b <= 0. As cos(alpha) <= cos(beta), cos(alpha) is not negative, so that alpha <= pi/2, \
         and each of the three terms is not negative; one is positive, as alpha > 0. But L = U = 0 \
         and -h b >= 0: a contradiction. So b > 0.",
    )
}

fn seven_modes(d: &mut Derivation) -> Checked {
    lemmas(d, ["modes-contacts", "modes-lever"])?;
    let (joint, alpha, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let (h, crown) = (Symbol::Thrust.number(), Angle::zero(&ring.thickness));
    let two = h.int(2);
    for contact in [Contact::Extrados, Contact::Intrados] {
        let [by_thrust, by_moment] = slopes(&margin_at(contact, &joint));
        let [row, unit] = row_at(contact, &joint);
        let name = label(contact);
        d.identity(format!("the work of h on a hinge, d{name}/dh"), &by_thrust, &row)?;
        d.identity(format!("the work of p on it, d{name}/dp"), &by_moment, &unit)?;
    }
    let shear = slopes(&statics::shear_force(&joint, &h));
    let [row, _] = row_at(Contact::Inwards, &joint);
    let words = "the work of h on a joint that slides along itself is that on T";
    d.identity(words, -shear[0].clone(), &row)?;
    // With the multiple of the haunch's row for p that takes the haunch out.
    let balance = |[by_thrust, by_moment]: [Fraction; 2]| {
        by_thrust + by_moment * ring.intrados() * &joint.cos / &two
    };
    let (inner, outer) = (ring.intrados() * &joint.cos, ring.extrados());
    let (a, b) = ((outer.clone() - &inner) / &two, (inner - outer * &alpha.cos) / &two);
    let terms = [
        ("a u, of the crown's hinge", row_at(Contact::Extrados, &crown), a.clone()),
        ("no l, of the haunch's hinge", row_at(Contact::Intrados, &joint), h.int(0)),
        ("-b v, of the shoulder's hinge", row_at(Contact::Extrados, &alpha), -b.clone()),
        ("s sin(beta_s), of an inner joint", row_at(Contact::Inwards, &joint), joint.sin.clone()),
        ("-t sin(alpha), of the shoulder", row_at(Contact::Outwards, &alpha), -alpha.sin.clone()),
    ];
    for (words, row, expected) in terms {
        d.identity(format!("the balance of h has {words}"), balance(row), &expected)?;
    }
    let opening = (joint.cos.int(1) + &joint.cos) * &ring.thickness / &two;
    d.identity("a, positive as eta is", &a, joint.versine() + opening)?;
    let at = variables();
    let rates = [
        (Mode::Rotational, contact::rates_of_rotation(&at), 0),
        (Mode::SlidingRotational, contact::rates_of_shoulder_sliding(&at), -1),
        (Mode::RotationalSliding, contact::rates_of_inner_sliding(&at), 1),
    ];
    for (mode, rates, side) in rates {
        let sum = a.clone() * &rates.crown - b.clone() * &rates.shoulder
            + rates.sliding * h.int(side)
            + (rates.haunch - rates.crown - rates.shoulder) * ring.intrados();
        d.identity(format!("the rates by which {mode} is proved are in balance"), &sum, h.int(0))?;
    }
    let slope = margin_at(Contact::Intrados, &joint).derivative(&along_the_joint());
    let shear = statics::shear_force(&joint, &h);
    let thick =
        ring.thickness.clone() / &two + Symbol::Flag.number() * ring.thickness.square() / h.int(12);
    d.identity(
        "dL/d beta again: positive where T < 0, so that L is not zero first at a shoulder that slides",
        &slope,
        thick * &joint.sin - ring.intrados() * shear / &two,
    )?;
    d.theorems(["Modes.mechanism_is_one_of_moves", "Modes.sum_of_modes"])?;
    d.conclude(
        "The third, s and v, is [r,r,s] for beta_r >= beta_s, [r,s,r] for 0 < beta_r <= beta_s and [r,s] for \
         beta_r = 0.",
    )?;
    let p = Symbol::CrownMoment.number();
    for (contact, expected) in [(Contact::Extrados, -p.clone()), (Contact::Intrados, p)] {
        let words = format!("{} at the crown without thrust", label(contact));
        let margin = with(&margin_at(contact, &crown), &[Symbol::Thrust], &h.int(0));
        d.identity(words, &margin, &expected)?;
    }
    d.theorems(["Modes.modes_without_limit"])
}

/// A half opening and a friction.
type GivenArch = (&'static str, &'static str);

/// Half opening and friction of an arch of each mode that has a least thickness, for Heyman's and for Milankovitch's
/// weight.
const EXAMPLES: [(Mode, [GivenArch; 2]); 6] = [
    (Mode::Rotational, [("3/2", "1"); 2]),
    (Mode::SlidingRotational, [("pi/2", "0.35"); 2]),
    (Mode::RotationalSliding, [("2.54", "1.6"), ("2.45", "1.35")]),
    (Mode::RotationalSlidingRotational, [("2.607", "1.9"), ("2.535", "1.57")]),
    (Mode::OverturningSliding, [("2.65", "2.2"), ("2.57", "2.2")]),
    (Mode::Overturning, [("2.7", "inf"), ("2.62", "inf")]),
];

fn modes_occur(d: &mut Derivation) -> Checked {
    // Each arch beside that of the next mode, which has another.
    for ((mode, arches), (_, others)) in EXAMPLES.iter().zip(EXAMPLES.iter().cycle().skip(1)) {
        for (weight, (arch, other)) in SelfWeight::ALL.into_iter().zip(arches.iter().zip(others)) {
            let (alpha, mu) = arch;
            let words = format!("alpha = {alpha}, mu = {mu}: {mode}, {weight}");
            d.certain(Support::Balls, words, [arch, other], |(alpha, mu)| {
                Ok(certain_if(state_of(alpha, mu, weight)?.mode == *mode))
            })?;
        }
    }
    pure_sliding_has_room(d, "")?;
    d.conclude(
        "At its least friction the arch of half opening 1 and thickness 1 has room for the line of thrust \
         that starts in the middle of the crown: L is least at the crown, U at crown or shoulder. It \
         can only slide, at beta_s and at the shoulder: [s,s].",
    )
}

/// Room that is left to a line of thrust in an arch that only slides: half opening 1, thickness 1, thrust in
/// the middle of the crown; and the same where it is not positive, with a thrust that pulls, or with the half
/// opening 3. What it is told for stands before the words.
pub(super) fn pure_sliding_has_room(d: &mut Derivation, of: &str) -> Checked {
    let CurveStates { alpha, thrust: h, .. } = CurveStates::sliding(&Rational::from(1))?;
    let at = Configuration {
        half_opening: alpha,
        rotation_joint: Angle::zero(&h),
        sliding_joint: Angle::zero(&h),
        thickness: h.int(1),
        thrust: h.clone(),
        friction: h.int(0),
        ..Configuration::zero(&h)
    };
    let pulled = Configuration { thrust: -h.clone(), ..at.clone() };
    let wide = Configuration { half_opening: Angle::new(h.int(3)), ..at.clone() };
    type Room = fn(SelfWeight, &Configuration<Ball>) -> Ball;
    let rooms: [(&str, Room, &Configuration<Ball>); 4] = [
        ("h > 0 at alpha = 1", |_, at| at.thrust.clone(), &pulled),
        ("dL/d beta > 0 next to the crown, eta = 1", contact::crown_slope, &pulled),
        (
            "U > 0 at the shoulder",
            |weight, at| contact::extrados_margin_at_shoulder(weight, at, &at.thrust),
            &wide,
        ),
        ("N > 0 there", |_, at| statics::normal_force(&at.half_opening, &at.thrust), &wide),
    ];
    for weight in SelfWeight::ALL {
        for (words, room, elsewhere) in rooms {
            let rooms = [&room(weight, &at), &room(weight, elsewhere)];
            d.above_zero(format!("{of}{words}, {weight}"), rooms)?;
        }
    }
    Ok(())
}
