//! The landmarks as states of the whole arch: inside at every joint, and how the mechanisms that meet there move.
//!
//! In an admissible state the lines of thrust and of friction are at their limits at the joints of a mechanism only
//! (`modes.rs`). So "strictly inside" holds everywhere else, and there it cannot.

use super::along::landmark;
use super::contacts::{margin_at, row_at};
use super::landmarks::certain_if;
use super::letters::{ring, variables, with};
use super::{Checked, Derivation, Finding, Support, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::{
    Configuration, SelfWeight, Unknown, contact, overturning, sliding, statics, thrust,
};
use crate::number::{Angle, Ball, Enclosure, Field, Ternary};
use crate::problem::{Condition, Examined, Fixed, Landmark, Mode};
use crate::symbolic::{Fraction, Letters, Relations, Symbol, along_the_joint};

claims! {
    Finds("landmark-inside", "Sec. 4, Fig. 7-11", landmarks_stand):
        "at T, S, J and B the lines of thrust and of friction are strictly inside the whole arch, and no thinner \
         arch stands";
    Finds("landmark-inside-unlimited", "Sec. 4, Fig. 12", landmarks_without_thrust_stand):
        "at l and L the lines of thrust and of friction are strictly inside the whole arch, and no thinner arch \
         stands";
    AsPrinted("landmark-T-modes", "Sec. 4, Fig. 7-8", four_mechanisms_at_t):
        "at T four modes are possible at once, and the mechanism of each is a linear combination of the other three";
    AsPrinted("landmark-S-joint", "Sec. 4, Fig. 9", one_joint_rotates_and_slides):
        "at S one inner joint both rotates and slides: [r,r+s]";
}

/// Every condition of every mode that meets at a landmark, but for those that are zero by its equations.
fn conditions_hold(d: &mut Derivation, point: Landmark) -> Checked {
    for weight in SelfWeight::ALL {
        let at = landmark(point, weight)?;
        let turned = turned(&at);
        // The range of what is solved for comes first, and belongs to all modes.
        for (place, (mode, conditions)) in point.conditions(weight).into_iter().enumerate() {
            let of = if place == 0 { "the range of the unknowns" } else { mode.label() };
            let words =
                format!("{}, {of}: {} conditions, {weight}", point.symbol(), conditions.len());
            d.certain(Support::Balls, words, [&at, &turned], |at| {
                let state = Examined::new(weight, mode, at);
                let holds = |condition: &Condition| state.margin(*condition).is_positive();
                Ok(conditions.iter().map(holds).fold(Ternary::True, Ternary::and))
            })?;
        }
    }
    Ok(())
}

/// The haunch where the shoulder is and the shoulder where the haunch is, with a thrust that pulls: no state has the
/// signs of this.
fn turned(at: &Configuration<Ball>) -> Configuration<Ball> {
    Configuration {
        half_opening: at.rotation_joint.clone(),
        rotation_joint: at.half_opening.clone(),
        thrust: -at.thrust.clone(),
        thickness: -at.thickness.clone(),
        friction: -at.friction.clone(),
        ..at.clone()
    }
}

fn landmarks_stand(d: &mut Derivation) -> Checked<Finding> {
    lemmas(d, ["modes-contacts"])?;
    let (joint, alpha, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let (h, mu) = (Symbol::Thrust.number(), Symbol::Friction.number());
    let two = h.int(2);
    let at_crown = ring.extrados() * &h / &two;
    let upper = margin_at(Contact::Extrados, &alpha);
    let lower = margin_at(Contact::Intrados, &joint);
    let whole = thrust::whole(&alpha, &ring).residual(&h);
    let words = "(4): U at the shoulder, if U = 0 at the crown";
    d.identity(words, with(&upper, &[Symbol::CrownMoment], &at_crown), -(whole / &two))?;
    let above = thrust::lower(&joint, &ring).residual(&h);
    let words = "(2): L at the joint, if U = 0 at the crown";
    d.identity(words, with(&lower, &[Symbol::CrownMoment], &at_crown), above / &two)?;
    let below = thrust::upper(&alpha, &joint, &ring).residual(&h);
    let words = "(3): L at the joint, if U = 0 at the shoulder";
    d.identity(words, lower.clone() + upper, -(below / &two))?;
    let touching = thrust::tangency(&joint.times_cotangent(), &ring).residual(&h);
    let slope = lower.derivative(&along_the_joint());
    let expected = touching * &joint.sin / &two;
    d.on_circle("(5): dL/d beta", &slope, &expected)?;
    let shoulder = sliding::shoulder(&alpha, &h).residual(&mu);
    d.identity("(17): mu N + T at the shoulder", margin_at(Contact::Outwards, &alpha), &shoulder)?;
    let square = Symbol::Thrust.polynomial() - &Symbol::Thrust.polynomial().power(2);
    let steepest = Relations::none().with(Symbol::Joint, 2, square);
    let inner = sliding::inner(&joint, &h).residual(&mu) * &joint.rad / (h.int(1) - &h);
    let words = "(18): mu N - T at beta_s";
    d.identity_under(words, margin_at(Contact::Inwards, &joint), &inner, &steepest)?;
    d.conclude(
        "So the equations of a landmark say which margins are exactly zero: those of the joints that turn or \
         slide in one of its modes.",
    )?;
    for landmark in [Landmark::Triple, Landmark::Shift, Landmark::Junction, Landmark::Border] {
        conditions_hold(d, landmark)?;
    }
    d.conclude("With the ends, the steepest joint and the touching joint inside, every joint is.")?;
    Ok(Finding::Equality {
        at: "the joints of the mechanisms: hinges, where the line of thrust is on a face, and sliding \
             joints, where the line of friction is at its limit"
            .to_owned(),
    })
}

fn landmarks_without_thrust_stand(d: &mut Derivation) -> Checked<Finding> {
    let (joint, alpha, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let h = Symbol::Thrust.number();
    let (none, two) = (h.int(0), h.int(2));
    let unloaded = |value: &Fraction| with(value, &[Symbol::Thrust, Symbol::CrownMoment], &none);
    let normal = statics::normal_force(&joint, &none);
    let words = "N where h = 0: positive below the crown, where nothing acts";
    d.identity(words, &normal, joint.rad.clone() * &joint.sin)?;
    let upper = unloaded(&margin_at(Contact::Extrados, &alpha));
    let whole = thrust::whole(&alpha, &ring).residual(&none);
    d.identity("(4): U at the shoulder", &upper, -(whole / &two))?;
    let slope = unloaded(&margin_at(Contact::Intrados, &joint)).derivative(&along_the_joint());
    let fall = (h.int(1) - joint.times_cotangent()) * ring.intrados() / &two;
    let expected = (fall - overturning::end_of_rotation(&ring)) * &joint.sin;
    let words = "dL/d beta, with beta cot(beta) < 1 and, from eta_l on, the condition behind (16) not positive";
    d.on_circle(words, &slope, &expected)?;
    d.conclude(
        "So L, zero at the crown, grows. U grows and then falls from 0 to 0, and is positive between. Thinner arches \
         have a positive bracket: at L it is zero for Milankovitch's weight, and falls as the thickness grows.",
    )?;
    for landmark in [Landmark::RotationEnd, Landmark::OverturningEnd] {
        conditions_hold(d, landmark)?;
    }
    let ratio = statics::shear_force(&joint, &none) / normal;
    d.identity("T/N", &ratio, joint.cos / joint.sin)?;
    d.conclude(
        "It is bounded on any part of the arch off the crown, and unbounded next to it: the line of friction is \
         inside if friction is infinite, and for no finite friction.",
    )?;
    Ok(Finding::Equality {
        at: "the crown, where no force acts, and the shoulder's extrados; with infinite friction alone"
            .to_owned(),
    })
}

/// The rates of the crown's, the haunch's and the shoulder's hinge, of the inner joint and of the sliding shoulder,
/// those of sliding joints times the sine of the joint.
type MotionRates = [Fraction; 5];

/// `[r,r,r]`, `[s,r,r]`, `[r,r,s]`, `[s,s]`.
fn motions() -> [MotionRates; 4] {
    let at: Configuration<Fraction> = variables();
    let none = at.thrust.int(0);
    let (turns, shoulder, inner) = (
        contact::rates_of_rotation(&at),
        contact::rates_of_shoulder_sliding(&at),
        contact::rates_of_inner_sliding(&at),
    );
    let one = none.int(1);
    [
        [turns.crown, turns.haunch, turns.shoulder, none.clone(), none.clone()],
        [shoulder.crown, shoulder.haunch, shoulder.shoulder, none.clone(), shoulder.sliding],
        [inner.crown, inner.haunch, inner.shoulder, inner.sliding, none.clone()],
        [none.clone(), none.clone(), none, one.clone(), one],
    ]
}

fn four_mechanisms_at_t(d: &mut Derivation) -> Checked {
    lemmas(d, ["modes-seven"])?;
    let [turns, shoulder, inner, slides] = motions();
    let (a, ratio) = (shoulder[4].clone(), turns[2].clone());
    d.define("a, the rate of the shoulder in [s,r,r]", &a);
    d.define("c, that of the shoulder's hinge in [r,r,r]", &ratio);
    let sum = "[s,r,r] + c [r,r,s] - a [s,s] is [r,r,r], hinge at the";
    let places = [
        format!("{sum} crown"),
        format!("{sum} haunch"),
        format!("{sum} shoulder"),
        "the same, the inner joint sliding".to_owned(),
        "the same, the shoulder sliding".to_owned(),
    ];
    for (rate, words) in places.into_iter().enumerate() {
        let sum = shoulder[rate].clone() + ratio.clone() * &inner[rate] - a.clone() * &slides[rate];
        d.identity(words, &sum, &turns[rate])?;
    }
    let [x, y, z] =
        [&shoulder, &inner, &slides].map(|motion| [0, 2, 3].map(|rate| motion[rate].clone()));
    let minor = |i: usize, j: usize| y[i].clone() * &z[j] - y[j].clone() * &z[i];
    let determinant =
        x[0].clone() * minor(1, 2) - x[1].clone() * minor(0, 2) + x[2].clone() * minor(0, 1);
    let words = "the determinant of [s,r,r], [r,r,s], [s,s] in u, v, s: not zero";
    d.identity(words, &determinant, x[0].int(1))?;
    let [by_thrust, by_moment] = row_at(Contact::Extrados, &Angle::zero(&a));
    let [slip, none] = row_at(Contact::Inwards, &Symbol::joint());
    let words =
        "of the two balances, that of h and p on the crown's hinge and the inner joint: not zero";
    d.identity(words, by_thrust * none - by_moment * slip, Symbol::Sine.number())?;
    for weight in SelfWeight::ALL {
        let at = landmark(Landmark::Triple, weight)?;
        let turned = Configuration { thickness: at.thickness.int(-2), ..at.clone() };
        let a = |at: &Configuration<Ball>| contact::rates_of_shoulder_sliding(at).sliding;
        let c = |at: &Configuration<Ball>| contact::rates_of_rotation(at).shoulder;
        d.above_zero(format!("a > 0 at T, {weight}"), [&a(&at), &a(&turned)])?;
        d.above_zero(format!("c > 0 at T, {weight}"), [&c(&at), &c(&turned)])?;
    }
    d.conclude(
        "All rates are positive, and five rates with two balances leave three free: three of the four span all \
         motions, and as neither 1, c nor a is zero, any three do. Not all with positive coefficients: \
         [r,r,r] + a [s,s] = [s,r,r] + c [r,r,s].",
    )
}

fn one_joint_rotates_and_slides(d: &mut Derivation) -> Checked {
    lemmas(d, ["modes-seven"])?;
    for weight in SelfWeight::ALL {
        let (name, at) = (weight.name(), landmark(Landmark::Shift, weight)?);
        let words = format!("beta_r = beta_s, {name}");
        let points = [Landmark::Shift, Landmark::Triple];
        d.certain(Support::Algebra, words, points, |point| {
            let joint = point.system(weight).fixed_value(Unknown::RotationJoint);
            Ok(certain_if(joint == Some(Fixed::SameAs(Unknown::SlidingJoint))))
        })?;
        // At T the crown has a hinge.
        let words = format!("U > 0 at the crown, {name}");
        d.certain(Support::Balls, words, points, |point| {
            let at = landmark(point, weight)?;
            let state = Examined::new(weight, Mode::RotationalSliding, &at);
            Ok(state.margin(Condition::ExtradosAtCrown).is_positive())
        })?;
        let [here, there] = [&at, &turned(&at)].map(contact::rates_of_inner_sliding);
        d.above_zero(format!("it slides, {name}"), [&here.sliding, &there.sliding])?;
    }
    d.conclude(
        "The crown has no hinge; the joint turns as the shoulder does, which slides too in [s,s].",
    )
}
