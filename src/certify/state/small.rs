//! States of small half openings: the same proof in variables of order one, in which nothing cancels.
//!
//! Three modes are met there: pure rotation, sliding of the shoulder, and pure sliding. The equations and
//! margins are those of [`arch::small`], the printed ones divided by a power of the half opening.

use super::choice::State;
use super::question::{Attempt, Query, require};
use super::root::{Equations, no_candidate, unique_root};
use crate::arch::small::{self, Scaled};
use crate::arch::{SelfWeight, Unknown};
use crate::number::{Ball, Dual, Enclosure, Field, Real, Stumpff, stumpff_terms};
use crate::problem::{Equation, Mode, tally};
use crate::solve::start;
use rug::Float;

/// More terms than this, and sines and cosines with a few more bits are cheaper.
const MANY_TERMS: i32 = 24;
/// `alpha²` is below two to this power: then the series of the start values hold.
const SMALL: i64 = -4;

/// Whether a half opening of a number of bits is treated as small: that of a bound `2^exponent` of its
/// square.
pub(super) fn is_small(exponent: i64, bits: u32) -> bool {
    exponent <= SMALL && stumpff_terms(bits, exponent) <= MANY_TERMS
}

/// An arch of a small half opening at one precision.
pub(super) struct Small {
    weight: SelfWeight,
    bits: u32,
    alpha: Ball,
    /// The half opening and, if finite, the friction.
    given: Scaled<Ball>,
    is_limited: bool,
}

/// The root of a mode's equations in scaled variables.
pub(super) struct SmallRoot {
    pub(super) at: Scaled<Ball>,
    alpha: Ball,
}

impl Query {
    /// The arch in scaled variables, if its half opening is small.
    pub(super) fn small(&self) -> Option<Small> {
        let alpha = &self.given.half_opening.rad;
        let exponent = 2 * i64::from(alpha.mid().get_exp()?);
        if !is_small(exponent, self.bits) {
            return None;
        }
        let y = alpha.square();
        let cube = y.clone() * alpha;
        let mut given = Scaled::new(&y);
        if let Some(friction) = &self.friction {
            given = given.with(Unknown::Friction, friction.clone() / cube);
        }
        Some(Small {
            weight: self.weight,
            bits: self.bits,
            alpha: alpha.clone(),
            given,
            is_limited: self.friction.is_some(),
        })
    }
}

impl Small {
    /// The purely rotational state, proved for unlimited friction.
    pub(super) fn rotation(&self) -> Attempt<SmallRoot> {
        let start = start::scaled_rotational(self.weight, &self.candidate().opening.square);
        self.state(Mode::Rotational, Some(start), false)
    }

    /// The state in which the shoulder slides.
    pub(super) fn shoulder_sliding(&self) -> Attempt<SmallRoot> {
        let start = start::scaled_shoulder_sliding(self.weight, &self.candidate());
        self.state(Mode::SlidingRotational, Some(start), self.is_limited)
    }

    /// The purely sliding state.
    pub(super) fn pure_sliding(&self) -> Attempt<SmallRoot> {
        let start = start::scaled_sliding(&self.candidate().opening.square);
        let slides = self.root(Mode::Sliding, Some(start))?;
        require(&slides.at.friction, "a positive purely sliding friction", &[])?;
        require(&slides.room_for_steepest(), "the steepest joint above the shoulder", &[])?;
        Ok(slides)
    }

    fn candidate(&self) -> Scaled<Float> {
        self.given.clone().map(|x| Float::with_val(self.bits, x.mid()))
    }

    fn state(&self, mode: Mode, start: Option<[Float; 3]>, limited: bool) -> Attempt<SmallRoot> {
        let root = self.root(mode, start)?;
        let conditions = self.conditions(mode, &root, limited);
        tally::conditions(conditions.len());
        conditions.iter().try_for_each(|(margin, question)| require(margin, question, &[mode]))?;
        Ok(root)
    }

    fn root(&self, mode: Mode, start: Option<[Float; 3]>) -> Attempt<SmallRoot> {
        let equations = ScaledEquations { small: self, mode };
        let start = start.ok_or_else(no_candidate)?;
        let root = unique_root(&equations, self.bits, start.to_vec())?;
        let at = equations.place(self.given.clone(), root);
        Ok(SmallRoot { at, alpha: self.alpha.clone() })
    }

    /// What [`conditions`](crate::problem::conditions) lists for these modes, each divided by a power
    /// of the half opening.
    fn conditions(&self, mode: Mode, root: &SmallRoot, limited: bool) -> Vec<(Ball, &'static str)> {
        let (weight, at) = (self.weight, &root.at);
        let (one, two) = (at.deficit.int(1), at.deficit.int(2));
        let (y, haunch) = (&at.opening, &at.rotation);
        let (eta, normal) = (small::thickness(at), small::normal_force(at));
        let (upper, lower) = small::arms(at);
        let at_limit = one.clone() + one.ratio(weight.flag(), 3);
        let mut all = vec![
            (normal.clone(), "compression at the shoulder"),
            (at.thickness.clone(), "a positive thickness"),
            (two.clone() - &eta, "a thickness below the physical limit"),
            (one.clone() - small::rest(at), "a positive thrust"),
            (at.deficit.clone(), "a thrust below one"),
            (haunch.square.clone(), "a rotational joint below the crown"),
            (one.clone() - &haunch.square, "a rotational joint above the shoulder"),
            (
                two * normal - at_limit * &y.square * &y.functions[2],
                "every thicker arch stands up to the physical limit",
            ),
        ];
        let slides = mode == Mode::SlidingRotational;
        if slides {
            all.push((
                small::extrados_margin_at_shoulder(weight, at),
                "the line of thrust inside the extrados at the shoulder",
            ));
            all.push((upper.clone(), "a mechanism that slides the right way"));
        }
        if limited {
            let [shoulder, inner] = root.scaled_frictions();
            all.push((root.room_for_steepest(), "the steepest joint above the shoulder"));
            all.push((self.given.friction.clone() - inner, "friction enough inside"));
            if !slides {
                all.push((
                    self.given.friction.clone() - shoulder,
                    "friction enough at the shoulder",
                ));
            }
            // The denominator of the thrust that the shoulder can bear, over alpha.
            let depth = y.square.clone() * &self.given.friction;
            all.push((
                y.functions[1].clone() - depth * &y.functions[0],
                "a shoulder that bounds the thrust from above",
            ));
        }
        // The least thickness: the rates are one at the crown, one more than the shoulder's at the haunch.
        let shoulder = if slides { one.int(0) } else { upper / lower };
        let turned = shoulder.clone() + &one;
        if !slides {
            all.push((shoulder.clone(), "a mechanism that opens at the shoulder"));
        }
        let slope = one.clone()
            + turned.clone() * &haunch.functions[0]
            + shoulder.clone() * &y.functions[0];
        all.push((slope, "a combination that grows with the thrust"));
        let weight_term = turned.clone() * &haunch.square * &haunch.functions[1]
            + shoulder.clone() * &y.functions[1];
        let drop = turned * &haunch.square * &haunch.functions[2] - shoulder * &y.functions[2];
        let growth =
            weight_term.clone() / one.int(2) + one.int(weight.flag()) * eta * drop / one.int(6);
        all.push((weight_term, "a positive weight of the mechanism"));
        all.push((growth, "no admissible state in a thinner arch"));
        all
    }
}

/// The equations of a mode in scaled variables.
struct ScaledEquations<'a> {
    small: &'a Small,
    mode: Mode,
}

impl ScaledEquations<'_> {
    fn place<T: Stumpff>(&self, given: Scaled<T>, x: Vec<T>) -> Scaled<T> {
        let (unknowns, _) = self.mode.system();
        unknowns.iter().zip(x).fold(given, |at, (&unknown, x)| at.with(unknown, x))
    }

    fn residuals<T: Stumpff>(&self, given: Scaled<T>, x: Vec<Dual<T>>) -> Vec<Dual<T>> {
        let (_, equations) = self.mode.system();
        let at = self.place(given.map(Dual::constant), x);
        // An equation without a scaled form would leave none, and nothing would be proved.
        let residual = |e: &Equation| e.scaled_residual(self.small.weight, &at);
        equations.iter().map(residual).collect::<Option<_>>().unwrap_or_default()
    }
}

impl Equations for ScaledEquations<'_> {
    fn approximate(&self, bits: u32, x: Vec<Dual<Float>>) -> Vec<Dual<Float>> {
        self.residuals(self.small.given.clone().map(|x| Float::with_val(bits, x.mid())), x)
    }

    fn enclose(&self, bits: u32, x: Vec<Dual<Ball>>) -> Vec<Dual<Ball>> {
        self.residuals(self.small.given.clone().map(|x| x.with_precision(bits)), x)
    }

    /// (2), (4) and (5) have no denominator that can vanish for half openings below a right angle and
    /// thicknesses below 2; those of (17) and (18) are looked at.
    fn is_regular(&self, x: &[Ball]) -> bool {
        let at = self.place(self.small.given.clone(), x.to_vec());
        let inner = || small::inner(&at).denominator.excludes_zero();
        small::shoulder(&at).denominator.excludes_zero() && (self.mode != Mode::Sliding || inner())
    }
}

impl SmallRoot {
    /// `mu`.
    pub(super) fn friction(&self) -> Ball {
        self.unscaled(&self.at.friction)
    }

    /// The frictions that the shoulder and an inner joint ask for.
    pub(super) fn frictions(&self) -> Attempt<[Ball; 2]> {
        require(&self.room_for_steepest(), "the steepest joint above the shoulder", &[])?;
        Ok(self.scaled_frictions().map(|m| self.unscaled(&m)))
    }

    /// The state, without the frictions at which its mode changes.
    pub(super) fn into_state(self, mode: Mode) -> State {
        let joint = self.at.rotation.square.sqrt() * &self.alpha;
        // As many bits as the difference from one has: they cost nothing, and show that it is not one.
        let rest = small::rest(&self.at);
        let gap = rest.mid().get_exp().map_or(0, |exponent| exponent.min(0).unsigned_abs());
        State {
            mode,
            thickness: small::thickness(&self.at),
            thrust: Ball::integer(1, joint.prec() + gap) - rest,
            rotation_joint: joint,
            sliding_joint: None,
            frictions: None,
        }
    }

    fn unscaled(&self, m: &Ball) -> Ball {
        m.clone() * &self.at.opening.square * &self.alpha
    }

    fn scaled_frictions(&self) -> [Ball; 2] {
        let h = self.at.deficit.int(1) - small::rest(&self.at);
        let steepest = (h * &self.at.deficit).sqrt();
        let at = self.at.clone().with(Unknown::SlidingJoint, steepest);
        tally::equation(Equation::ShoulderSliding);
        tally::equation(Equation::InnerSliding);
        [small::shoulder(&at).value(), small::inner(&at).value()]
    }

    /// `1 - (beta_s/alpha)²` at the joint that is steepest at this thrust.
    fn room_for_steepest(&self) -> Ball {
        let h = self.at.deficit.int(1) - small::rest(&self.at);
        h.int(1) - h * &self.at.deficit
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::Configuration;
    use crate::certify::state::{Arch, Friction};
    use crate::number::Magnitude;
    use crate::problem::conditions;

    /// The power of the half opening by which a condition was divided.
    fn power(question: &str, slides: bool) -> i32 {
        match question {
            "a positive thickness" => 4,
            "the line of thrust inside the extrados at the shoulder" => 4,
            "friction enough inside" | "friction enough at the shoulder" => 3,
            "a thrust below one" | "a positive weight of the mechanism" => 2,
            "no admissible state in a thinner arch" => 2,
            "a mechanism that slides the right way" if slides => 2,
            "a shoulder that bounds the thrust from above" => 1,
            _ => 0,
        }
    }

    /// Each condition is the printed one over a power of the half opening; those on the joints have the
    /// same sign, as they are differences of squares here.
    #[test]
    fn the_conditions_are_the_printed_ones() {
        for weight in SelfWeight::ALL {
            // Between alpha³/12 and alpha³/6 the shoulder slides.
            for (friction, mode) in
                [("1", Mode::Rotational), ("12/100000000", Mode::SlidingRotational)]
            {
                let friction = Friction::Coefficient(friction.parse().unwrap());
                let arch = Arch::new(weight, "1/100".parse().unwrap(), friction).unwrap();
                let query = Query::new(&arch, 256);
                let small = query.small().unwrap();
                let root = match mode {
                    Mode::Rotational => small.rotation().unwrap(),
                    _ => small.shoulder_sliding().unwrap(),
                };
                let scaled = small.conditions(mode, &root, true);
                let state = SmallRoot { at: root.at.clone(), alpha: root.alpha.clone() };
                let state = state.into_state(mode);
                let at = Configuration::clone(&query.given)
                    .with(Unknown::RotationJoint, state.rotation_joint)
                    .with(Unknown::Thickness, state.thickness)
                    .with(Unknown::Thrust, state.thrust);
                let printed = conditions(weight, mode, &at, query.friction.as_ref());
                for (margin, question) in &printed {
                    let found = scaled.iter().find(|(_, other)| other == question);
                    let (other, _) = found.unwrap_or_else(|| panic!("{mode:?}: no '{question}'"));
                    if question.contains("joint") {
                        assert_eq!(margin.is_positive(), other.is_positive(), "{question}");
                        continue;
                    }
                    let power = power(question, mode == Mode::SlidingRotational);
                    let unscaled =
                        (0..power).fold(other.clone(), |x, _| x * &query.given.half_opening.rad);
                    let difference = unscaled - margin;
                    let size = Magnitude::upper(difference.mid());
                    assert!(difference.overlaps(&margin.int(0)), "{mode:?} {question}");
                    // Not because nothing is known.
                    let known = Magnitude::upper(margin.mid()).shifted(-60);
                    assert!(size < known && difference.rad() < known, "{mode:?} {question}");
                }
            }
        }
    }
}
