//! The state of an arch at its least thickness, proved.
//!
//! For a half opening, a friction and a weight: does the arch stand at any thickness, how thin can it
//! be, and how does it collapse there? The proof has four parts, all in balls:
//!
//! 1. the equations of the mode have exactly one solution in a box (Krawczyk);
//! 2. that state is statically admissible on the whole half arch;
//! 3. no thinner arch has an admissible state, and the mechanism has positive rates;
//! 4. every comparison that chooses the mode is decided.
//!
//! Parts 2 and 3 come down to a few signs; [`crate::arch::contact`] has the lemma. A comparison that is
//! not decided raises the precision; if it stays undecided, that is the answer.

use super::{CertifiedLandmark, Undecided, krawczyk};
use crate::arch::{
    Configuration, Equation, Landmark, Mode, SelfWeight, Unknown, contact, sliding, statics, thrust,
};
use crate::number::{
    Angle, Ball, Dual, Enclosure, ExactNumber, Field, Magnitude, Real, Rounded, Ternary,
};
use crate::solve::{inverse, polish, start_state};
use rug::{Float, Rational};
use std::sync::OnceLock;

/// The friction of the joints.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Friction {
    /// `mu`.
    Coefficient(ExactNumber),
    /// `phi = atan(mu)`, rad.
    Angle(ExactNumber),
    /// No limit.
    Infinite,
}

/// An arch whose thickness is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Arch {
    weight: SelfWeight,
    half_opening: ExactNumber,
    friction: Friction,
}

/// Why an arch is refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ArchError {
    /// The half opening is not between 0 and pi.
    #[error("the half opening {0} is not between 0 and pi (180deg)")]
    HalfOpening(String),
    /// The friction is negative.
    #[error("the friction {0} is negative")]
    Friction(String),
    /// The friction angle is not between 0 and a right angle.
    #[error("the friction angle {0} is not between 0 and pi/2 (90deg)")]
    FrictionAngle(String),
}

/// What is certain of an arch.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It stands from a least thickness on.
    Stands(Box<State>),
    /// It does not stand at any thickness up to the physical limit 2.
    Falls(Fall),
}

/// Why no thickness is enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fall {
    /// The friction is below that of the purely sliding state.
    Sliding,
    /// It would have to be thicker than twice the radius.
    Thickness,
}

/// The state at the least thickness: enclosures, all proved.
#[derive(Clone, Debug)]
pub struct State {
    /// How it collapses.
    pub mode: Mode,
    /// `eta`.
    pub thickness: Ball,
    /// `h`.
    pub thrust: Ball,
    /// `beta_r`, rad; exactly zero at the crown.
    pub rotation_joint: Ball,
    /// `beta_s`, rad, if an inner joint slides.
    pub sliding_joint: Option<Ball>,
    /// The friction below which nothing stands at this half opening.
    pub sliding_friction: Ball,
    /// The friction from which collapse is purely rotational; `None` if no friction is enough.
    pub rotational_friction: Option<Ball>,
}

/// A comparison that is not decided at some precision.
#[derive(Clone, Debug)]
pub struct Doubt {
    /// What could not be told.
    pub question: &'static str,
    /// The modes, or the mode and nothing, between which it stands.
    pub between: Vec<Mode>,
    /// A bound of the difference that could not be told from zero.
    pub gap: f64,
}

type Attempt<T> = Result<T, Doubt>;

impl Arch {
    /// An arch, if its half opening and friction make sense.
    pub fn new(
        weight: SelfWeight,
        half_opening: ExactNumber,
        friction: Friction,
    ) -> Result<Self, ArchError> {
        let between = |x: &ExactNumber, low_is_in: bool, limit: Ball| {
            let x = x.enclosure(limit.prec());
            let positive = x.is_positive() == Ternary::True || (low_is_in && x.mid().is_zero());
            positive && x.is_less_than(&limit) == Ternary::True
        };
        // Far more bits than the longest number that is read has.
        let pi = Ball::integer(1, 80_000).pi();
        if !between(&half_opening, false, pi.clone()) {
            return Err(ArchError::HalfOpening(half_opening.to_string()));
        }
        let friction = match friction {
            Friction::Coefficient(mu) if *mu.factor() < 0 => {
                return Err(ArchError::Friction(mu.to_string()));
            }
            Friction::Angle(phi)
                if !phi.is_rational() && *phi.factor() == Rational::from((1, 2)) =>
            {
                Friction::Infinite
            }
            Friction::Angle(phi) if !between(&phi, true, pi.clone() / pi.int(2)) => {
                return Err(ArchError::FrictionAngle(phi.to_string()));
            }
            friction => friction,
        };
        Ok(Self { weight, half_opening, friction })
    }

    /// The self-weight model.
    pub fn weight(&self) -> SelfWeight {
        self.weight
    }

    /// The half opening as given.
    pub fn half_opening(&self) -> &ExactNumber {
        &self.half_opening
    }

    /// The friction as given.
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    /// Proves the state with numbers of `bits` bits.
    pub fn state(&self, bits: u32) -> Attempt<Outcome> {
        Query::new(self, bits).outcome()
    }

    /// Bits that the smallness of the half opening takes away: the thickness falls like its fourth
    /// power, and the equations cancel as much.
    pub fn bits_lost(&self) -> u32 {
        let size = self.half_opening.enclosure(64).mid().get_exp().unwrap_or(0);
        size.min(0).unsigned_abs() * 6
    }
}

/// A proved state with its digits, or why nothing stands.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The arch stands from a least thickness on.
    Stands(Box<Digits>),
    /// It does not stand at any thickness up to the physical limit.
    Falls(Fall),
}

/// A proved value: decimal digits with bounds, and the nearest double.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Correctly rounded, with outward bounds.
    pub decimal: Rounded,
    /// The correctly rounded double.
    pub double: f64,
}

/// The values of a proved state, correctly rounded.
#[derive(Clone, Debug)]
pub struct Digits {
    /// How it collapses.
    pub mode: Mode,
    /// `eta`.
    pub thickness: Figure,
    /// `h`.
    pub thrust: Figure,
    /// `eta h`.
    pub intrinsic_thrust: Figure,
    /// `beta_r`, rad.
    pub rotation_joint: Figure,
    /// `beta_s`, rad, if an inner joint slides.
    pub sliding_joint: Option<Figure>,
    /// The friction below which nothing stands at this half opening.
    pub sliding_friction: Figure,
    /// The friction from which collapse is purely rotational; `None` if no friction is enough.
    pub rotational_friction: Option<Figure>,
}

/// How often the precision is doubled before a comparison or a rounding counts as undecided.
const ATTEMPTS: u32 = 6;
/// Bits beyond the digits asked for, at the first attempt.
const GUARD: u32 = 48;

impl Arch {
    /// Proves the state and rounds it to `digits` significant digits, raising the precision until
    /// every comparison and every rounding is decided. The doubt that stays is the answer otherwise.
    pub fn certify(&self, digits: usize) -> Result<Answer, Doubt> {
        let wanted = (digits as f64 * std::f64::consts::LOG2_10).ceil() as u32;
        let mut bits = wanted + GUARD + self.bits_lost();
        let mut last = None;
        for _ in 0..ATTEMPTS {
            match self.state(bits) {
                Ok(Outcome::Falls(fall)) => return Ok(Answer::Falls(fall)),
                Ok(Outcome::Stands(state)) => match state.digits(digits) {
                    Some(digits) => return Ok(Answer::Stands(Box::new(digits))),
                    None => last = None,
                },
                Err(doubt) => last = Some(doubt),
            }
            bits *= 2;
        }
        Err(last.unwrap_or(Doubt { question: "the rounding", between: Vec::new(), gap: f64::NAN }))
    }
}

impl Figure {
    /// The value of a ball, if the ball decides it.
    pub fn new(x: &Ball, digits: usize) -> Option<Self> {
        let decimal = match x.mid().is_zero() && x.rad().is_zero() {
            true => Rounded::from_rational(&Rational::new(), digits)?,
            false => Rounded::from_ball(x, digits)?,
        };
        Some(Self { decimal, double: x.nearest_double()? })
    }
}

impl State {
    /// Every value rounded to `digits` significant digits, if the enclosures decide all of them.
    fn digits(&self, digits: usize) -> Option<Digits> {
        let rounded = |x: &Ball| Figure::new(x, digits);
        let optional = |x: &Option<Ball>| match x {
            Some(x) => rounded(x).map(Some),
            None => Some(None),
        };
        Some(Digits {
            mode: self.mode,
            thickness: rounded(&self.thickness)?,
            thrust: rounded(&self.thrust)?,
            intrinsic_thrust: rounded(&(self.thickness.clone() * &self.thrust))?,
            rotation_joint: rounded(&self.rotation_joint)?,
            sliding_joint: optional(&self.sliding_joint)?,
            sliding_friction: rounded(&self.sliding_friction)?,
            rotational_friction: optional(&self.rotational_friction)?,
        })
    }
}

/// An arch at one precision.
struct Query {
    weight: SelfWeight,
    bits: u32,
    /// What is given: the half opening and, if finite, the friction.
    given: Configuration<Ball>,
    friction: Option<Ball>,
}

/// A purely rotational state with the frictions it asks for.
struct Rotation {
    at: Configuration<Ball>,
    shoulder: Ball,
    inner: Ball,
}

impl Query {
    fn new(arch: &Arch, bits: u32) -> Self {
        let alpha = arch.half_opening.enclosure(bits);
        let friction = match &arch.friction {
            Friction::Coefficient(mu) => Some(mu.enclosure(bits)),
            Friction::Angle(phi) => {
                let (sin, cos) = phi.enclosure(bits).sin_cos();
                Some(sin / cos)
            }
            Friction::Infinite => None,
        };
        let mut given = Configuration::zero(&alpha).with(Unknown::HalfOpening, alpha);
        if let Some(friction) = &friction {
            given = given.with(Unknown::Friction, friction.clone());
        }
        Self { weight: arch.weight, bits, given, friction }
    }

    fn outcome(&self) -> Attempt<Outcome> {
        let slides = self.root(Mode::Sliding.system(), &start_state::sliding(&self.alpha()))?;
        let least_friction = slides.friction.clone();
        if let Some(friction) = &self.friction {
            let between = [Mode::Sliding];
            let margin = friction.clone() - &least_friction;
            if !decide(&margin, "whether the friction is enough to stand", &between)? {
                return Ok(Outcome::Falls(Fall::Sliding));
            }
        }
        let [end, limit] = limits(self.weight, self.bits);
        let alpha = &self.given.half_opening.rad;
        let rotates = decide(
            &(end - alpha),
            "whether the half opening is below that of the end of rotation",
            &[Mode::Rotational, Mode::Overturning],
        )?;
        let rotation = if rotates { Some(self.rotation()?) } else { None };
        let frictions = |rotation: Option<&Rotation>| {
            (least_friction.clone(), rotation.map(Rotation::friction))
        };
        match (&rotation, &self.friction) {
            (Some(rotation), None) => {
                self.proved(Mode::Rotational, rotation.at.clone(), frictions(Some(rotation)))
            }
            (None, None) => {
                if !decide(
                    &(limit - alpha),
                    "whether the half opening is below that of the end of overturning",
                    &[Mode::Overturning],
                )? {
                    return Ok(Outcome::Falls(Fall::Thickness));
                }
                let at = self.root(Mode::Overturning.system(), &[self.overturning_start()])?;
                self.proved(Mode::Overturning, at, frictions(None))
            }
            (Some(rotation), Some(friction)) => {
                let frictions = frictions(Some(rotation));
                let margin = |critical: &Ball, mode| {
                    decide(
                        &(friction.clone() - critical),
                        "whether the friction is enough for pure rotation",
                        &[Mode::Rotational, mode],
                    )
                };
                let holds_shoulder = margin(&rotation.shoulder, Mode::SlidingRotational);
                let holds_inner = margin(&rotation.inner, Mode::RotationalSliding);
                // Both can fail only below the purely sliding friction, which is excluded above.
                match (holds_shoulder, holds_inner) {
                    (Ok(true), Ok(true)) => {
                        self.proved(Mode::Rotational, rotation.at.clone(), frictions)
                    }
                    (Ok(false), _) => self.shoulder_sliding(&slides, frictions),
                    (_, Ok(false)) => self.inner_sliding(frictions),
                    (Err(doubt), _) | (_, Err(doubt)) => Err(doubt),
                }
            }
            (None, Some(_)) => self.inner_sliding(frictions(None)),
        }
    }

    fn alpha(&self) -> Float {
        Float::with_val(self.bits, self.given.half_opening.rad.mid())
    }

    fn rotation(&self) -> Attempt<Rotation> {
        let start = start_state::rotational(self.weight, &self.alpha());
        let at = self.root(Mode::Rotational.system(), &start)?;
        let shoulder = sliding::shoulder(&at.half_opening, &at.thrust).value();
        let inner = self.inner_friction(&at);
        Ok(Rotation { at, shoulder, inner })
    }

    /// The friction that the steepest joint asks for at the thrust of a state.
    fn inner_friction(&self, at: &Configuration<Ball>) -> Ball {
        let square = at.thrust.clone() * (at.thrust.int(1) - &at.thrust);
        sliding::inner(&Angle::new(square.sqrt()), &at.thrust).value()
    }

    fn shoulder_sliding(
        &self,
        slides: &Configuration<Ball>,
        frictions: (Ball, Option<Ball>),
    ) -> Attempt<Outcome> {
        let bound =
            sliding::shoulder_thrust(&self.given.half_opening, &self.given.friction).value();
        // Near the purely sliding friction the two thrusts are close, and either is a good start.
        let thrust = if bound.is_bounded() { bound } else { slides.thrust.clone() };
        let thrust = Float::with_val(self.bits, thrust.mid());
        let start = start_state::rotational_with_thrust(self.weight, &thrust);
        let at = self.root(Mode::SlidingRotational.system(), &start)?;
        self.proved(Mode::SlidingRotational, at, frictions)
    }

    fn inner_sliding(&self, frictions: (Ball, Option<Ball>)) -> Attempt<Outcome> {
        let friction = Float::with_val(self.bits, self.given.friction.mid());
        let [h, joint] = start_state::inner_sliding(&friction);
        let sliding = (
            &[Unknown::Thrust, Unknown::SlidingJoint][..],
            &[Equation::InnerSliding, Equation::Steepest][..],
        );
        let slid = self.root(sliding, &[h, joint])?;
        let margin = contact::margin_at_physical_limit(self.weight, &slid);
        if !decide(
            &margin,
            "whether the physical limit of the thickness is enough",
            &[Mode::OverturningSliding],
        )? {
            return Ok(Outcome::Falls(Fall::Thickness));
        }
        let (h, joint) = (slid.thrust.mid(), slid.sliding_joint.rad.mid());
        let start = start_state::rotational_sliding(self.weight, self.alpha().to_f64(), h.to_f64());
        let float = |x: f64| Float::with_val(self.bits, x);
        let at_crown = || {
            let start = [float(start.thickness), h.clone(), joint.clone()];
            let at = self.root(Mode::OverturningSliding.system(), &start)?;
            let slope = contact::crown_slope(self.weight, &at);
            let between = [Mode::OverturningSliding, Mode::RotationalSlidingRotational];
            let nearest = decide(&slope, "whether the intrados is touched at the crown", &between)?;
            Ok((at, nearest))
        };
        if start.joint.is_none() {
            let (at, nearest) = at_crown()?;
            if nearest {
                return self.proved(Mode::OverturningSliding, at, frictions);
            }
        }
        let beta = float(start.joint.unwrap_or(1e-6));
        let start = [beta, float(start.thickness), h.clone(), joint.clone()];
        let (at, mode) = match self.root(Mode::RotationalSliding.system(), &start) {
            Ok(at) => {
                let above = at.rotation_joint.rad.clone() - &at.sliding_joint.rad;
                let between = [Mode::RotationalSliding, Mode::RotationalSlidingRotational];
                let above = decide(&above, "which of the two inner joints is higher", &between)?;
                (at, between[usize::from(!above)])
            }
            // Beside the line beta_r = 0 the joint may be at the crown after all.
            Err(doubt) => match at_crown()? {
                (at, true) => (at, Mode::OverturningSliding),
                (_, false) => return Err(doubt),
            },
        };
        self.proved(mode, at, frictions)
    }

    fn overturning_start(&self) -> Float {
        let alpha = self.alpha().to_f64();
        let a = thrust::opening_variable(&Angle::new(alpha)).value();
        let eta = crate::arch::overturning::thickness(self.weight, &a);
        Float::with_val(self.bits, if eta.is_finite() { eta } else { 1.9 })
    }

    /// Parts 2 and 3 of the proof.
    fn proved(
        &self,
        mode: Mode,
        at: Configuration<Ball>,
        (sliding_friction, rotational_friction): (Ball, Option<Ball>),
    ) -> Attempt<Outcome> {
        for (margin, question) in self.conditions(mode, &at) {
            if !decide(&margin, question, &[mode])? {
                // A root that is not the state of the arch: nothing is known.
                return Err(Doubt { question, between: vec![mode], gap: f64::INFINITY });
            }
        }
        let slides = matches!(
            mode,
            Mode::RotationalSliding | Mode::RotationalSlidingRotational | Mode::OverturningSliding
        );
        Ok(Outcome::Stands(Box::new(State {
            mode,
            thickness: at.thickness,
            thrust: at.thrust,
            rotation_joint: at.rotation_joint.rad,
            sliding_joint: slides.then_some(at.sliding_joint.rad),
            sliding_friction,
            rotational_friction,
        })))
    }

    /// What has to be positive: the admissibility of the whole half arch, and the least thickness.
    /// What is zero by the equations of the mode is not listed.
    fn conditions(&self, mode: Mode, at: &Configuration<Ball>) -> Vec<(Ball, &'static str)> {
        use Mode::*;
        let weight = self.weight;
        let mut all = vec![
            (statics::normal_force(&at.half_opening, &at.thrust), "compression at the shoulder"),
            (at.thickness.clone(), "a positive thickness"),
            (at.thickness.int(2) - &at.thickness, "a thickness below the physical limit"),
        ];
        let mut needs = |margin: Ball, question| all.push((margin, question));
        let friction = &self.given.friction;
        let from_crown = matches!(mode, Rotational | SlidingRotational);
        if mode != Overturning {
            needs(at.thrust.clone(), "a positive thrust");
            needs(at.thrust.int(1) - &at.thrust, "a thrust below one");
        }
        // The line of thrust.
        if from_crown || matches!(mode, RotationalSliding | RotationalSlidingRotational) {
            needs(at.rotation_joint.rad.clone(), "a rotational joint below the crown");
            needs(
                at.half_opening.rad.clone() - &at.rotation_joint.rad,
                "a rotational joint above the shoulder",
            );
        } else {
            needs(
                contact::crown_slope(weight, at),
                "the line of thrust leaves the intrados at the crown",
            );
        }
        if mode == SlidingRotational {
            let moment = contact::crown_moment(at);
            needs(
                contact::extrados_margin_at_shoulder(weight, at, &moment),
                "the line of thrust inside the extrados at the shoulder",
            );
        }
        if !from_crown && mode != Overturning {
            let moment = contact::shoulder_moment(weight, at);
            needs(
                contact::crown_moment(at) - moment,
                "the line of thrust inside the extrados at the crown",
            );
        }
        // Friction.
        if self.friction.is_some() {
            if mode != SlidingRotational {
                let asked = sliding::shoulder(&at.half_opening, &at.thrust).value();
                needs(friction.clone() - asked, "friction enough at the shoulder");
            }
            if from_crown {
                needs(friction.clone() - self.inner_friction(at), "friction enough inside");
            }
        }
        // The least thickness.
        let rates = match mode {
            Rotational => contact::rates_of_rotation(at),
            SlidingRotational => contact::rates_of_shoulder_sliding(at),
            _ => contact::rates_of_inner_sliding(at),
        };
        if mode == Rotational {
            needs(rates.shoulder.clone(), "a mechanism that opens at the shoulder");
        } else {
            needs(rates.sliding.clone(), "a mechanism that slides the right way");
        }
        if mode == SlidingRotational {
            needs(
                sliding::shoulder_thrust(&at.half_opening, friction).denominator,
                "a shoulder that bounds the thrust from above",
            );
        }
        // W is linear in the thrust: it is least at an end of what friction allows.
        let (base, slope) =
            (contact::weight_term(&rates, at), contact::thrust_coefficient(&rates, at));
        let mut thrusts = vec![at.thrust.int(0)];
        match (slope.is_positive(), &self.friction) {
            (Ternary::True, _) => {}
            (_, Some(_)) => {
                thrusts.push(sliding::shoulder_thrust(&at.half_opening, friction).value())
            }
            (_, None) => needs(slope.clone(), "a combination that grows with the thrust"),
        }
        for thrust in thrusts {
            let term = base.clone() + slope.clone() * thrust;
            needs(term.clone(), "a positive weight of the mechanism");
            needs(
                contact::growth(weight, &rates, at, &term),
                "no admissible state in a thinner arch",
            );
        }
        all
    }

    /// The root of a system next to a start value, proved to exist and to be unique in a box.
    fn root(
        &self,
        (unknowns, equations): (&[Unknown], &[Equation]),
        start: &[Float],
    ) -> Attempt<Configuration<Ball>> {
        let doubt = |question| Doubt { question, between: Vec::new(), gap: f64::NAN };
        let exact = |x: &Float| Ball::exact(x.clone(), self.bits);
        let mid = |x: Ball| Float::with_val(self.bits, x.mid());
        let candidate =
            polish(self.weight, (unknowns, equations), &self.given.clone().map(mid), start)
                .ok_or_else(|| doubt("no candidate is found"))?;
        let n = unknowns.len();
        let centre: Vec<Ball> = candidate.iter().map(exact).collect();
        let place = |values: &[Ball]| {
            unknowns
                .iter()
                .zip(values)
                .fold(self.given.clone(), |at, (&u, x)| at.with(u, x.clone()))
        };
        let slopes = |values: &[Ball]| -> Vec<Dual<Ball>> {
            let given = self.given.clone().map(Dual::constant);
            let at =
                unknowns.iter().zip(values).enumerate().fold(given, |at, (index, (&u, x))| {
                    at.with(u, Dual::variable(x.clone(), index))
                });
            equations.iter().map(|e| e.residual(self.weight, &at)).collect()
        };
        let at_centre = slopes(&centre);
        let residuals: Vec<Ball> = at_centre.iter().map(|r| r.value().clone()).collect();
        let entry = |r: &Dual<Ball>, k| {
            r.slope(k)
                .map_or_else(|| Float::new(self.bits), |s| Float::with_val(self.bits, s.mid()))
        };
        let jacobian = at_centre.iter().map(|r| (0..n).map(|k| entry(r, k)).collect()).collect();
        let preconditioner: Vec<Vec<Ball>> = inverse(jacobian)
            .ok_or_else(|| doubt("the Jacobian is singular"))?
            .iter()
            .map(|row| row.iter().map(exact).collect())
            .collect();
        // A box several times as wide as the correction that the residuals ask for.
        let radius = |(row, x): (&Vec<Ball>, &Ball)| {
            let terms = row.iter().zip(&residuals).map(|(y, r)| y.clone() * r);
            let size = terms
                .fold(Magnitude::ZERO, |sum, t| sum.plus(Magnitude::upper(t.mid())).plus(t.rad()));
            size.plus(Magnitude::upper(x.mid()).shifted(-i64::from(self.bits)))
        };
        let radii: Vec<Magnitude> = preconditioner.iter().zip(&centre).map(radius).collect();
        for inflation in [2, 8, 20] {
            let domain: Vec<Ball> = centre
                .iter()
                .zip(&radii)
                .map(|(x, r)| x.clone().widened(r.shifted(inflation)))
                .collect();
            let regular = equations
                .iter()
                .filter_map(|e| e.denominator(self.weight, &place(&domain)))
                .all(|d| d.excludes_zero());
            if !regular {
                continue;
            }
            let image =
                krawczyk::image(&centre, &residuals, &slopes(&domain), &preconditioner, &domain);
            if krawczyk::is_contracted(&image, &domain) {
                return Ok(place(&image));
            }
        }
        Err(doubt("no box around the candidate is mapped into itself"))
    }
}

impl Rotation {
    /// The friction from which collapse is purely rotational: the larger of the two.
    fn friction(&self) -> Ball {
        match self.shoulder.is_less_than(&self.inner) {
            Ternary::True => self.inner.clone(),
            Ternary::False => self.shoulder.clone(),
            // They differ by less than can be told: a ball that holds both.
            Ternary::Undecided => {
                let gap = self.inner.clone() - &self.shoulder;
                let size = Magnitude::upper(gap.mid()).plus(gap.rad());
                self.shoulder.clone().widened(size)
            }
        }
    }
}

/// Whether a margin is positive, or the doubt.
fn decide(margin: &Ball, question: &'static str, between: &[Mode]) -> Attempt<bool> {
    match margin.is_positive() {
        Ternary::True => Ok(true),
        Ternary::False => Ok(false),
        Ternary::Undecided => {
            let gap = Magnitude::upper(margin.mid()).plus(margin.rad()).to_float().to_f64();
            Err(Doubt { question, between: between.to_vec(), gap })
        }
    }
}

/// The half openings of `l` and `L`, to at least `bits` bits.
fn limits(weight: SelfWeight, bits: u32) -> [Ball; 2] {
    static CACHED: [OnceLock<[Ball; 2]>; 2] = [OnceLock::new(), OnceLock::new()];
    const ENOUGH: u32 = 1024;
    let at = |bits: u32| {
        [Landmark::RotationEnd, Landmark::OverturningEnd].map(|landmark| {
            let opening = |point: CertifiedLandmark| -> Result<Ball, Undecided> {
                Ok(point.enclosure(bits)?.configuration().half_opening.rad)
            };
            CertifiedLandmark::new(landmark, weight).and_then(opening).unwrap_or(Ball::whole(bits))
        })
    };
    if bits > ENOUGH {
        return at(bits);
    }
    CACHED[weight.flag() as usize]
        .get_or_init(|| at(ENOUGH))
        .clone()
        .map(|x| x.with_precision(bits))
}
