//! The motion of each mode: its blocks fit, its rates have their signs, it moves where joints are at their limits,
//! and the weight works by as much as friction takes.

use super::contacts::label;
use super::letters::{ring, variables};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::{Contact, Joint, Mechanism, Twist};
use crate::arch::{Configuration, contact, sliding, thrust};
use crate::number::{Angle, Field};
use crate::problem::Mode;
use crate::symbolic::{Fraction, Letters, Relations, Symbol};

claims! {
    Implicit("mechanism-fits", "Sec. 4, Fig. 7-12", compatible):
        "in each of the seven modes rigid blocks move together: behind the crown nothing turns and nothing moves \
         sideways, whether a joint that slides opens or not";
    Implicit("mechanism-rates", "Sec. 4, Fig. 7-12", rates):
        "each hinge opens on its side and each joint slides its way, where the lever arms that the mode has are \
         positive; with a dilatancy up to the friction the slips are others, still positive, and the hinges turn as \
         without";
    AsPrinted("mechanism-crown", "Sec. 3", crown_opens):
        "at the crown the halves part along the whole joint in [r], and stay in contact at the intrados in [r,s]";
    Implicit("mechanism-limits", "Sec. 4, Fig. 7-12", at_limit):
        "the equations of a mode put the joints of its mechanism at their limits";
    Implicit("mechanism-power", "Sec. 4, Fig. 7-12", power):
        "at collapse the weight works by as much as friction takes, and by nothing if joints that slide open as the \
         associated flow rule has it";
}

/// The variables of a mode.
fn at(mode: Mode) -> Configuration<Fraction> {
    let at = Configuration { sliding_joint: Symbol::sliding_joint(), ..variables() };
    match mode {
        Mode::OverturningSliding | Mode::Overturning => {
            Configuration { rotation_joint: Angle::zero(&at.thrust), ..at }
        }
        _ => at,
    }
}

/// All joints that move.
fn joints(mechanism: &Mechanism<Fraction>) -> impl Iterator<Item = &Joint<Fraction>> {
    mechanism.joints.iter().chain(&mechanism.crown)
}

/// Opening of a joint for a slip of one.
const OPENS: Symbol = Symbol::Friction;

fn compatible(d: &mut Derivation) -> Checked {
    d.define("a joint that slides opens, for a slip of one, by; none for zero", &OPENS.number());
    for mode in Mode::ALL {
        let at = at(mode);
        let [turn, across] = mode.mechanism(&at, &OPENS.number()).gap(&at.thickness);
        let none = turn.int(0);
        d.on_circle(format!("{mode}: the rotation behind the crown"), &turn, &none)?;
        d.on_circle(format!("{mode}: the horizontal velocity behind it"), &across, &none)?;
    }
    d.conclude(
        "By symmetry the axis behind the crown moves up and down only, and the left half is the mirror image. For the \
         open crown of [r] the two hinges together are the opening along the whole joint.",
    )
}

fn rates(d: &mut Derivation) -> Checked {
    lemmas(d, ["modes-seven", "modes-lever"])?;
    let mu = OPENS.number();
    for mode in Mode::ALL {
        let at = at(mode);
        let (alpha, slides) = (&at.half_opening, &at.sliding_joint);
        let one = at.thrust.int(1);
        // The lever arms of the haunch: both multipliers of friction.
        let up = contact::rates_of_shoulder_sliding(&at).sliding;
        let lo = contact::rates_of_inner_sliding(&at).sliding;
        let out = alpha.sin.clone() - mu.clone() * &alpha.cos;
        let inwards = slides.sin.clone() + mu.clone() * &slides.cos;
        // Each rate by what it has to be, over a factor.
        let expected = match mode {
            Mode::Rotational => vec![(up.clone(), lo.clone()), (up + &lo, lo), (one.clone(), one)],
            Mode::SlidingRotational => {
                vec![(up, out), (one.clone(), one.clone()), (one.clone(), one)]
            }
            Mode::RotationalSliding => {
                vec![(one.clone(), one.clone()), (one.clone(), one), (lo, inwards)]
            }
            Mode::RotationalSlidingRotational | Mode::OverturningSliding => {
                vec![(one.clone(), one.clone()), (lo, inwards), (one.clone(), one)]
            }
            Mode::Overturning => {
                let eta = at.thickness.clone();
                vec![(one.clone(), one), (eta.clone() + &lo, eta.clone()), (lo, eta)]
            }
            Mode::Sliding => vec![(alpha.sin.clone(), out), (alpha.sin.clone(), inwards)],
        };
        let mechanism = mode.mechanism(&at, &mu);
        for (joint, (value, factor)) in joints(&mechanism).zip(expected) {
            let rate = joint.rate.clone() * factor;
            let words =
                format!("{mode}: a rate where {} = 0, times its denominator", label(joint.contact));
            d.identity(words, &rate, &value)?;
        }
    }
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let outwards = Contact::Outwards.margin(&alpha, &ring(), [&h, &h, &mu]);
    let out = alpha.sin.clone() - mu.clone() * &alpha.cos;
    let expected = alpha.rad.clone() * (alpha.cos.clone() + mu * &alpha.sin) - h * out;
    let words = "mu N + T at the shoulder; were sin(alpha) <= mu cos(alpha), it would be positive";
    d.identity(words, &outwards, &expected)?;
    d.conclude(
        "The arm above the haunch is positive, that below is a condition of each state whose mechanism has it, and 0 \
         < beta_s <= 1/2, 0 < alpha < pi; where the shoulder slides sin(alpha) - mu cos(alpha) is positive, as h is. \
         So numerators and denominators are positive. The rates of the hinges are free of mu.",
    )
}

fn crown_opens(d: &mut Derivation) -> Checked {
    lemmas(d, ["modes-seven", "modes-lever"])?;
    let arm = |mode| contact::rates_of_inner_sliding(&at(mode)).sliding;
    d.define("a, the lever arm below the crown", &arm(Mode::Overturning));
    for mode in [Mode::Overturning, Mode::OverturningSliding] {
        let (at, none) = (at(mode), OPENS.number().int(0));
        let (eta, zero) = (&at.thickness, Twist::zero(&none));
        let crown = mode.mechanism(&at, &none).crown;
        let twist = crown.iter().fold(zero, |sum, joint| sum.plus(&joint.twist(eta)));
        let expected = match mode {
            Mode::Overturning => [arm(mode), arm(mode) + eta],
            _ => [none.clone(), eta.clone()],
        };
        let faces = ["intrados", "extrados"].into_iter().zip([-1, 1]).zip(expected);
        for ((face, side), expected) in faces {
            let height = eta.int(1) + eta.ratio(side, 2) * eta;
            // The half beyond the crown moves to the left where the joint opens.
            let [across, _] = twist.at(&[none.clone(), height]);
            d.identity(
                format!("{mode}: how far the crown opens at the {face}"),
                -across,
                &expected,
            )?;
        }
    }
    d.conclude(
        "a is positive, as a condition of each state: in [r] both faces part, in [r,s] the intrados stays in contact \
         and the joint turns about it.",
    )
}

fn at_limit(d: &mut Derivation) -> Checked {
    let (free, mu) = (Relations::none(), Symbol::Friction.number());
    let square = Symbol::Thrust.polynomial() - &Symbol::Thrust.polynomial().power(2);
    let steepest = Relations::none().with(Symbol::SlidingJoint, 2, square);
    for mode in Mode::ALL {
        let at = at(mode);
        let (ring, alpha, haunch) = (ring(), &at.half_opening, &at.rotation_joint);
        let (h, none, two) = (at.thrust.clone(), at.thrust.int(0), at.thrust.int(2));
        let h = if mode == Mode::Overturning { none.clone() } else { h };
        // Where the line of thrust is on the extrados.
        let from_crown =
            matches!(mode, Mode::Rotational | Mode::SlidingRotational | Mode::Overturning);
        let at_crown = ring.extrados() * &h / &two;
        let whole = thrust::whole(alpha, &ring).residual(&h) / &two;
        let p = if from_crown { at_crown.clone() } else { at_crown - &whole };
        for joint in joints(&mode.mechanism(&at, &none)) {
            let margin = joint.contact.margin(&joint.at, &ring, [&h, &p, &mu]);
            let is_crown = joint.at == Angle::zero(&h);
            let is_shoulder = joint.at == *alpha;
            let (equation, expected, relations) = match joint.contact {
                Contact::Extrados if is_shoulder && from_crown => ("(4)", -whole.clone(), &free),
                Contact::Extrados => ("p", none.clone(), &free),
                Contact::Intrados if is_crown && from_crown => ("h = 0", none.clone(), &free),
                Contact::Intrados if from_crown => {
                    ("(2)", thrust::lower(haunch, &ring).residual(&h) / &two, &free)
                }
                Contact::Intrados => {
                    ("(3)", -(thrust::upper(alpha, haunch, &ring).residual(&h) / &two), &free)
                }
                Contact::Outwards => ("(17)", sliding::shoulder(alpha, &h).residual(&mu), &free),
                Contact::Inwards => {
                    let inner = sliding::inner(&joint.at, &h).residual(&mu);
                    ("(18)", inner * &joint.at.rad / (h.int(1) - &h), &steepest)
                }
            };
            let words =
                format!("{mode}: {} where it gives way, by {equation}", label(joint.contact));
            d.identity_under(words, &margin, &expected, relations)?;
        }
    }
    d.conclude(
        "Each is zero where the equations of the mode hold: every rate stands with a margin that is zero. The crown \
         moment p puts the line of thrust on the extrados of the crown where the mode has (2) or no thrust, else on \
         that of the shoulder; [s,s] leaves it open.",
    )
}

fn power(d: &mut Derivation) -> Checked {
    lemmas(d, ["modes-contacts"])?;
    let (mu, p) = (Symbol::Friction.number(), Symbol::CrownMoment.number());
    for (dilatancy, rule) in [(mu.int(0), "without dilatancy"), (mu.clone(), "with it")] {
        for mode in Mode::ALL {
            let (at, ring) = (at(mode), ring());
            let mechanism = mode.mechanism(&at, &dilatancy);
            let slides = joints(&mechanism).any(|joint| !joint.contact.is_hinge());
            let opens = rule == "with it";
            if opens && !slides {
                continue;
            }
            let taken = match opens {
                true => mu.int(0),
                false => mechanism.friction_power(&at.thrust, &mu),
            };
            let left = mechanism.complementarity(&ring, [&at.thrust, &p, &mu]);
            let words = format!("{mode}, {rule}: what the weight works, less what friction takes");
            d.on_circle(words, mechanism.power(&ring) - taken, -left)?;
        }
    }
    d.conclude(
        "For any thrust and crown moment it is the sum of the rates times the margins, with its sign turned: zero in \
         the state of the mode, where each of these margins is.",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The wrong sign of the arm below the haunch: what slides in would have to slide out.
    #[test]
    fn an_arm_with_the_wrong_sign_does_not_fit() {
        let at = at(Mode::RotationalSliding);
        let mut mechanism = Mode::RotationalSliding.mechanism(&at, &at.thrust.int(0));
        mechanism.joints[2].rate = -mechanism.joints[2].rate.clone();
        let [turn, across] = mechanism.gap(&at.thickness);
        let circle = Relations::trigonometric();
        assert!(turn.vanishes(&circle) && !across.vanishes(&circle));
    }

    /// The power of a mechanism whose haunch opens on the other face is not that of the forces.
    #[test]
    fn a_hinge_on_the_wrong_face_breaks_the_balance() {
        let (at, ring) = (at(Mode::Rotational), ring());
        let mut mechanism = Mode::Rotational.mechanism(&at, &at.thrust.int(0));
        mechanism.joints[1].contact = Contact::Extrados;
        let load = [&at.thrust, &Symbol::CrownMoment.number(), &at.friction];
        let sum = mechanism.power(&ring) + mechanism.complementarity(&ring, load);
        assert!(!sum.vanishes(&Relations::trigonometric()));
    }
}
