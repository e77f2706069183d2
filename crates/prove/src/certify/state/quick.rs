//! Proofs of this folder in balls of double-doubles, where these are enough: they take a tenth of the time; and in
//! balls of three words, for the digits of a state that those do not have.
//!
//! It is the text of this folder over other numbers. What these balls decide is proved; where they leave anything
//! open, a sign, a box or a rounding, the answer is `None`, and balls of MPFR are asked.

use super::assess::{Assessment, AssessmentDigits, Wanted, assessment};
use super::digits::{Answer, Digits};
use super::enough::enough;
use super::inquiry::Inquiry;
use super::kept::kept_outcome;
use super::mode::{outcome, pure_sliding, sliding_root, steepest_root};
use super::query::{DOUBLE_DOUBLE, Query};
use super::state::Outcome;
use super::thrust_range::Touch;
use super::tier::Tier;
use crate::arch::Configuration;
use crate::number::{Ball, DoubleDoubleBall, ExactNumber, TripleWordBall};
use crate::problem::Arch;
use crate::prover::Undecided;
use crate::prover::arithmetic::Arithmetic;
use crate::prover::figure::Figured;
use crate::prover::in_doubles::Doubles;

/// An arch in these numbers.
fn query<E: Arithmetic + Doubles>(arch: &Arch) -> Query<E> {
    Query::new(arch, E::BITS)
}

/// The state in balls of double-doubles, without the frictions at which its mode changes.
pub fn state_in_double_doubles(arch: &Arch) -> Result<Outcome<DoubleDoubleBall>, Undecided> {
    quick_outcome(arch, false)
}

/// The state in these numbers, with the frictions at which its mode changes if they are asked for.
pub fn quick_outcome<E: Arithmetic + Doubles>(
    arch: &Arch,
    frictions: bool,
) -> Result<Outcome<E>, Undecided> {
    outcome(&query(arch), frictions)
}

/// The friction of the purely sliding state in these numbers.
pub fn quick_sliding<E: Arithmetic + Doubles>(arch: &Arch) -> Result<E, Undecided> {
    pure_sliding(&query(arch))
}

/// The state to `digits` digits.
pub(super) fn state(arch: &Arch, digits: usize, frictions: bool) -> Option<Answer> {
    let double_doubles = || state_in::<DoubleDoubleBall>(arch, digits, frictions);
    first(digits, double_doubles, || state_in::<TripleWordBall>(arch, digits, frictions))
}

/// The digits that the first of these proofs decides.
fn first<T>(
    digits: usize,
    double_doubles: impl Fn() -> Option<T>,
    three_words: impl Fn() -> Option<T>,
) -> Option<T> {
    Tier::of(digits).iter().find_map(|tier| match tier {
        Tier::DoubleDoubles => double_doubles(),
        Tier::ThreeWords => three_words(),
        // One arch alone fills no lanes, and what is left open is asked of balls of MPFR.
        Tier::Lanes | Tier::Mpfr => None,
    })
}

fn state_in<E: Arithmetic + Doubles + Figured>(
    arch: &Arch,
    digits: usize,
    frictions: bool,
) -> Option<Answer> {
    match quick_outcome::<E>(arch, frictions).ok()? {
        Outcome::Falls(fall) => {
            let enough = || Box::new(enough(arch, digits, Tier::DoubleDoubles.has(digits)));
            Some(Answer::Falls { fall, enough: frictions.then(enough) })
        }
        Outcome::Stands(state) => {
            Digits::new(&state, digits).map(|digits| Answer::Stands(Box::new(digits)))
        }
    }
}

/// The friction below which the arches of a half opening fall, and the one from which they have the state of unlimited
/// friction, where these numbers prove them.
pub(crate) fn critical_frictions(unlimited: &Arch) -> [Option<DoubleDoubleBall>; 2] {
    let query = query::<DoubleDoubleBall>(unlimited);
    match outcome(&query, true) {
        Ok(Outcome::Stands(state)) => match state.frictions {
            Some(frictions) => [Some(frictions.sliding), frictions.rotational],
            None => [None; 2],
        },
        // With less friction nothing stands either.
        Ok(Outcome::Falls(_)) => [pure_sliding(&query).ok(); 2],
        Err(_) => [None; 2],
    }
}

/// A proof in enclosures of `bits` bits: in these numbers, where they have so many bits and decide it.
fn enclosed<T>(bits: u32, quick: impl FnOnce() -> Option<T>, proof: impl FnOnce() -> T) -> T {
    let quick = if bits <= DOUBLE_DOUBLE { quick() } else { None };
    quick.unwrap_or_else(proof)
}

/// The state in enclosures of `bits` bits, with the frictions at which the mode changes if they are asked for.
pub fn state_enclosed(arch: &Arch, bits: u32, frictions: bool) -> Result<Outcome, Undecided> {
    let to_ball = |x: DoubleDoubleBall| x.to_ball(bits);
    let quick = || Some(Ok(quick_outcome(arch, frictions).ok()?.map(to_ball)));
    enclosed(bits, quick, || kept_outcome(arch, bits, frictions))
}

/// The friction of the purely sliding state in an enclosure of `bits` bits.
pub fn sliding_enclosed(arch: &Arch, bits: u32) -> Result<Ball, Undecided> {
    let quick = || Some(Ok(quick_sliding::<DoubleDoubleBall>(arch).ok()?.to_ball(bits)));
    enclosed(bits, quick, || pure_sliding(&Query::new(arch, bits)))
}

/// The purely sliding state of a half opening, with all its variables, in balls of `bits` bits.
pub fn sliding_configuration(arch: &Arch, bits: u32) -> Result<Configuration<Ball>, Undecided> {
    sliding_root(&Query::new(arch, bits))
}

/// The thrust at which an inner joint slides, and that joint, at the friction of the arch.
pub fn steepest_configuration(arch: &Arch, bits: u32) -> Result<Configuration<Ball>, Undecided> {
    steepest_root(&Query::new(arch, bits))
}

/// Everything that holds for an arch of a given thickness, in `(0, 2]`, in enclosures of `bits` bits.
pub fn assessment_enclosed(arch: &Arch, thickness: &ExactNumber, bits: u32) -> Assessment {
    let to_ball = |x: DoubleDoubleBall| Ok(x.to_ball(bits));
    let wanted = Wanted::Everything;
    let quick = || Some(decided(arch, thickness, wanted)?.each(to_ball, |open| open));
    let proof = || Inquiry::new(arch, 1, false).assessment(thickness, bits, wanted);
    enclosed(bits, quick, proof)
}

/// Proves what is wanted of an arch of a given thickness, if all of it is decided.
pub fn decided<E: Arithmetic + Doubles>(
    arch: &Arch,
    thickness: &ExactNumber,
    wanted: Wanted,
) -> Option<Assessment<E>> {
    let state = |is_own, _| match is_own {
        true => quick_outcome(arch, false),
        false => quick_outcome(&arch.unlimited(), false),
    };
    let found = assessment(arch, thickness, query(arch), wanted, state);
    // More bits may tell a joint from the shoulder next to it.
    let mut touches = found.thrust.iter().flatten().flatten().map(|limit| &limit.touch);
    let is_near = touches.any(|touch| matches!(touch, Touch::AtShoulder));
    let is_open = found.first_open().is_some();
    (!is_near && !is_open).then_some(found)
}

/// Proves what is wanted of an arch of a given thickness, to `digits` digits.
pub(super) fn assess(
    arch: &Arch,
    thickness: &ExactNumber,
    digits: usize,
    wanted: Wanted,
) -> Option<AssessmentDigits> {
    let double_doubles = || assess_in::<DoubleDoubleBall>(arch, thickness, digits, wanted);
    first(digits, double_doubles, || assess_in::<TripleWordBall>(arch, thickness, digits, wanted))
}

fn assess_in<E: Arithmetic + Doubles + Figured>(
    arch: &Arch,
    thickness: &ExactNumber,
    digits: usize,
    wanted: Wanted,
) -> Option<AssessmentDigits> {
    let found = decided::<E>(arch, thickness, wanted)?.rounded(digits, E::BITS);
    found.first_open().is_none().then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{SelfWeight, Unknown};
    use crate::certify::state::find::{Finding, Question, find};
    use crate::certify::state::{Balls, Certify, Figure};
    use crate::number::{Drawable, Enclosure, Field, Rounded};
    use crate::problem::Friction;
    use rug::Rational;

    fn arch(half_opening: &str, friction: &str) -> Arch {
        Arch::parse("milankovitch", half_opening, friction).unwrap()
    }

    /// Nothing is decided there, and what is asked then decides it.
    fn leaves_open(arch: &Arch, digits: usize) {
        assert!(state(arch, digits, true).is_none(), "{arch}");
        let by_mpfr = Inquiry::new(arch, digits, true).state(digits, true).unwrap();
        let found = arch.certify(digits).unwrap();
        match (found, by_mpfr) {
            (Answer::Stands(found), Answer::Stands(by_mpfr)) => {
                assert_eq!(found.mode, by_mpfr.mode);
                let all = found.figures().zip(by_mpfr.figures());
                all.for_each(|((of, x), (_, y))| {
                    assert_eq!(x.map(|x| &x.decimal), y.map(|y| &y.decimal), "{of:?}");
                });
            }
            (Answer::Falls { fall, .. }, Answer::Falls { fall: by_mpfr, .. }) => {
                assert_eq!(fall, by_mpfr);
            }
            _ => panic!("{arch}"),
        }
    }

    #[test]
    fn what_these_numbers_leave_open_is_asked_of_others() {
        // Numbers out of their range.
        leaves_open(&arch("1e-300", "1e300"), 10);
        leaves_open(&arch("1e-100", "inf"), 10);
        // More digits than they have.
        leaves_open(&arch("1", "1"), 37);
    }

    #[test]
    fn a_comparison_that_they_leave_open_is_asked_of_others() {
        let Answer::Stands(state) = arch("1", "1").certify(45).unwrap() else { panic!() };
        let frictions = state.frictions.unwrap();
        // The critical frictions, moved in their last digit.
        for friction in [frictions.sliding, frictions.rotational.unwrap()] {
            let Rounded { lower, upper, .. } = friction.decimal;
            leaves_open(&arch("1", &lower.to_string()), 16);
            leaves_open(&arch("1", &upper.to_string()), 16);
        }
    }

    /// Equidistributed arches of both weights, to be proved to 18 to 36 digits; every fourth with unlimited friction.
    fn mix(count: usize) -> impl Iterator<Item = (Arch, usize)> {
        let golden = |i: usize, step: f64| (i as f64 * step).fract();
        (1..=count).map(move |i| {
            let (alpha, mu) = (2.66 * golden(i, 0.754_877_666), 5.0 * golden(i, 0.569_840_291));
            let friction = if i % 4 == 0 { "inf".to_owned() } else { format!("{mu:.12}") };
            let weight = SelfWeight::ALL[i % 2].name();
            (Arch::parse(weight, &format!("{alpha:.15}"), &friction).unwrap(), 18 + i % 19)
        })
    }

    /// Three words tell the digits and the doubles that balls of MPFR tell, of nearly all arches.
    #[test]
    fn three_words_find_the_digits_of_balls_of_mpfr() {
        const ARCHES: usize = 2000;
        let mut decided = 0;
        for (arch, digits) in mix(ARCHES) {
            let Some(found) = state(&arch, digits, digits % 2 == 0) else { continue };
            decided += 1;
            match (found, Balls::Mpfr.state(&arch, digits, digits % 2 == 0).unwrap()) {
                (Answer::Stands(found), Answer::Stands(by_mpfr)) => {
                    assert_eq!(found.mode, by_mpfr.mode);
                    assert_eq!(found.figures().count(), by_mpfr.figures().count());
                    for ((of, x), (_, y)) in found.figures().zip(by_mpfr.figures()) {
                        assert_eq!(x.map(|x| &x.decimal), y.map(|y| &y.decimal), "{arch} {of:?}");
                        assert_eq!(x.map(Figure::bounds), y.map(Figure::bounds), "{arch} {of:?}");
                    }
                }
                (Answer::Falls { fall, .. }, Answer::Falls { fall: by_mpfr, .. }) => {
                    assert_eq!(fall, by_mpfr, "{arch}");
                }
                _ => panic!("{arch}"),
            }
        }
        assert!(decided * 100 >= ARCHES * 99, "{decided}");
    }

    /// The enclosures overlap, and those of three words are narrow.
    #[test]
    fn three_words_enclose_what_balls_of_mpfr_do() {
        for (arch, _) in mix(500) {
            let found = quick_outcome::<TripleWordBall>(&arch, true);
            let Ok(Outcome::Stands(found)) = found else { continue };
            let Ok(Outcome::Stands(by_mpfr)) = arch.state(192) else { panic!("{arch}") };
            for unknown in [Unknown::Thickness, Unknown::Thrust, Unknown::RotationJoint] {
                let of = found.value(unknown).unwrap();
                let [x, y] = [&of.to_ball(192), by_mpfr.value(unknown).unwrap()];
                assert!(x.overlaps(y), "{arch} {unknown:?}");
                let is_narrow = of.rad() <= of.mid().hi().abs() * 1e-33;
                assert!(is_narrow || x.contains(&Rational::new()), "{arch} {unknown:?} {of:?}");
                let beside = x.clone() + x.clone() * x.ratio(1, 1 << 30) * x.ratio(1, 1 << 30);
                assert!(!beside.overlaps(y) || x.is_zero(), "false twin: {arch}");
            }
        }
    }

    #[test]
    fn a_rounding_that_they_leave_open_is_asked_of_others() {
        // Half way between two numbers of sixteen digits, but for a part of 10^-44.
        let question = Question::HalfOpening {
            friction: Friction::Infinite,
            thickness: Some("0.12345000000000005".parse().unwrap()),
        };
        let found = find(SelfWeight::Milankovitch, &question, 45).unwrap();
        let Finding::Found(found) = found else { panic!() };
        let alpha = found.figures[0].1.decimal.value.to_string();
        leaves_open(&arch(&alpha, "inf"), 16);
        assert!(state(&arch(&alpha, "inf"), 15, true).is_some(), "not the state");
    }

    /// At the least thickness, moved in its last digit, what stands is told by other numbers.
    #[test]
    fn an_assessment_that_they_leave_open_is_asked_of_others() {
        for (half_opening, friction) in [("1", "1"), ("80deg", "0.35"), ("2.57", "2.2")] {
            let arch = arch(half_opening, friction);
            let Answer::Stands(state) = arch.certify(45).unwrap() else { panic!("{arch}") };
            let Rounded { lower, upper, .. } = state.thickness.decimal;
            for (thickness, stands) in [(lower, false), (upper, true)] {
                let thickness = thickness.to_string().parse().unwrap();
                assert!(assess(&arch, &thickness, 10, Wanted::Everything).is_none(), "{arch}");
                let found = arch.certify_thickness(&thickness, 10).unwrap();
                assert_eq!(found.stands.ok(), Some(stands), "{arch} {thickness}");
            }
            let thickness = "1.5".parse().unwrap();
            assert!(
                assess(&arch, &thickness, 10, Wanted::Everything).is_some(),
                "not the thickness: {arch}"
            );
            assert!(assess(&arch, &thickness, 30, Wanted::Everything).is_some(), "{arch}");
            assert!(
                assess(&arch, &thickness, 37, Wanted::Everything).is_none(),
                "more digits than they have"
            );
        }
    }

    /// Three words tell the digits and the doubles of assessments that balls of MPFR tell.
    #[test]
    fn three_words_assess_as_balls_of_mpfr_do() {
        const ARCHES: usize = 200;
        let mut decided = 0;
        for (place, (arch, digits)) in mix(ARCHES).enumerate() {
            let part = (place + 1) as f64 * 0.381_966_011_250_105;
            let thickness = format!("{:.12}", 0.02 + 1.5 * part.fract().powi(3)).parse().unwrap();
            let Some(found) = assess(&arch, &thickness, digits, Wanted::Everything) else {
                continue;
            };
            decided += 1;
            let by_mpfr =
                Balls::Mpfr.assess(&arch, &thickness, digits, Wanted::Everything).unwrap();
            assert_eq!((&found.stands, found.fall), (&by_mpfr.stands, by_mpfr.fall), "{arch}");
            assert_eq!(found.figures().count(), by_mpfr.figures().count(), "{arch} {thickness}");
            for ((of, x), (_, y)) in found.figures().zip(by_mpfr.figures()) {
                assert_eq!(x.map(|x| &x.decimal), y.map(|y| &y.decimal), "{arch} {of:?}");
                assert_eq!(x.map(Figure::bounds), y.map(Figure::bounds), "{arch} {of:?}");
            }
        }
        assert!(decided * 100 >= ARCHES * 95, "{decided}");
    }
}
