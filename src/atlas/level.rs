//! The lines of one half opening: how thick it has to be, over the friction.
//!
//! In the plane of friction angle and thickness such a line comes down from the physical limit at the friction of pure
//! sliding, `[s,s]`, or begins on the limit itself; it then runs through the domains in which the arch needs the less
//! thickness the more friction there is, and ends level, `[r,r,r]`, or at unlimited friction, `[r]`. Each part is one
//! chain of proved pieces, or straight; the parts meet on the lines between the modes, in points that are proved.

use super::curve::Curve;
use super::end::{End, EndValues};
use super::form::{Form, Joint, Law, Thrust, Variable};
use super::place::Place;
use super::trace::{Piece, Point, Trace, pieces_of, points_of};
use super::walk::{Walk, walk};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::certify::root::{self, root_near};
use crate::number::{Ball, Enclosure, ExactNumber, Field, Real, Stumpff, Ternary};
use crate::problem::{Landmark, Line, Mode};
use rug::Float;
use rug::float::Round;

/// Why a half opening has no line.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NoLevel {
    /// It is not between 0 and that of the landmark `L`.
    #[error("no arch of the half opening {0} stands at a thickness up to 2, or it is none")]
    Outside(String),
    /// It is that of a landmark, or a proof fails.
    #[error(transparent)]
    Undecided(#[from] Undecided),
}

/// The line of a half opening.
#[derive(Debug)]
pub struct Level {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The half opening.
    pub half_opening: ExactNumber,
    /// Its parts, from the least friction on.
    pub parts: Vec<Part>,
}

/// The part of a line in the domain of one mode.
#[derive(Debug)]
pub struct Part {
    /// The mode.
    pub mode: Mode,
    ends: [Place; 2],
    /// Nothing where the part is straight.
    chain: Option<(Form, Walk)>,
}

impl Part {
    /// The nodes; of a straight part its two ends.
    pub fn points(&self) -> Vec<Point> {
        let end = |place: &Place| Point { parameter: f64::NAN, end: None, place: place.clone() };
        let Some((form, walk)) = &self.chain else { return self.ends.iter().map(end).collect() };
        let mut points = points_of(form, walk);
        for (point, place) in [(0, &self.ends[0]), (points.len() - 1, &self.ends[1])] {
            points[point].place = place.clone();
        }
        points
    }

    /// What it is traced by; nothing where it is straight.
    pub fn parameter(&self) -> Option<Variable> {
        self.chain.as_ref().map(|(form, _)| form.parameter)
    }

    /// The pieces, gaps among them; a straight part has none.
    pub fn pieces(&self) -> impl Iterator<Item = Piece<'_>> {
        self.chain.iter().flat_map(|(form, walk)| pieces_of(form, walk))
    }
}

/// A point in which the line meets a curve of the map.
struct Crossing {
    form: Form,
    s: Ball,
    root: Vec<Ball>,
}

/// The equations of a form with the half opening given: the parameter is the first unknown.
struct AtOpening<'a> {
    form: &'a Form,
    half_opening: &'a Ball,
}

impl root::Form<Ball> for AtOpening<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        let (s, unknowns) = (&x[0], &x[1..]);
        let alpha = self.form.spot(&number, s, unknowns).half_opening;
        let mut residuals = self.form.residuals(&number, s, unknowns);
        residuals.push(alpha - number(self.half_opening));
        residuals
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> bool {
        self.form.divisors(&number, &x[0], &x[1..]).iter().all(Enclosure::excludes_zero)
    }
}

/// Bits in which crossings are enclosed.
const BITS: u32 = 128;
/// Half-width of the tubes in which crossings are looked for.
const COARSE: f64 = 1e-2;

impl Crossing {
    /// Where a curve has a half opening, proved to be on it.
    fn new(curve: Curve, weight: SelfWeight, half_opening: &Ball) -> Result<Self, Undecided> {
        let nowhere = || Undecided::new(format!("{curve} is not proved to have this half opening"));
        let trace = Trace::new(curve, weight, COARSE)?;
        let alpha = half_opening.mid().to_f64();
        let is_here = |piece: &Piece| {
            let [[from, to], _] = piece.cubic(Variable::HalfOpening)?;
            ((from - alpha) * (to - alpha) <= 0.0).then_some([from, to])
        };
        let mut pieces = trace.pieces();
        let (piece, [from, to]) =
            pieces.find_map(|piece| Some((piece, is_here(&piece)?))).ok_or_else(nowhere)?;
        let [low, high] = piece.range();
        let s = low + (alpha - from) / (to - from) * (high - low);
        let about = Ball::exact(Float::with_val(53, s), BITS);
        let (form, tube) = trace.tube_at(&about).ok_or_else(nowhere)?;
        let number = |x: &Ball| Float::with_val(BITS, x.mid());
        let start = [about.clone()].iter().chain(&tube.enclosure(&about)).map(number).collect();
        let mut root = root_near(&AtOpening { form, half_opening }, BITS, start)?;
        let s = root.remove(0);
        match tube.holds(&s, &root) {
            true => Ok(Self { form: form.clone(), s, root }),
            false => Err(nowhere()),
        }
    }

    fn place(&self) -> Place {
        Place::new(&self.form, &self.s, &self.root)
    }

    fn value(&self, variable: Variable) -> Ball {
        let at = self.form.spot(&Ball::clone, &self.s, &self.root);
        match variable {
            Variable::HalfOpening => at.half_opening,
            Variable::FrictionAngle => at.friction_angle,
            Variable::Inclination => at.inclination.rad,
            Variable::JointSquare => at.joint_square,
            Variable::Thickness => at.thickness,
            Variable::Ratio => at.ratio,
        }
    }
}

/// The equations of a mode at a given half opening.
fn form(mode: Mode, weight: SelfWeight, half_opening: &Ball) -> Form {
    use {Law as L, Variable as V};
    let (parameter, unknowns, laws, thrust): (V, &[V], &[L], Thrust) = match mode {
        Mode::SlidingRotational => (
            V::FrictionAngle,
            &[V::JointSquare, V::Thickness],
            &[L::Tangency, L::Touching],
            Thrust::Shoulder,
        ),
        Mode::OverturningSliding => (
            V::Inclination,
            &[V::FrictionAngle, V::Thickness],
            &[L::Cycloid, L::Upper],
            Thrust::Sliding,
        ),
        _ => (
            V::Inclination,
            &[V::FrictionAngle, V::JointSquare, V::Thickness],
            &[L::Cycloid, L::Tangency, L::Upper],
            Thrust::Sliding,
        ),
    };
    let half_opening = Some(half_opening.clone());
    Form { weight, parameter, unknowns, laws, thrust, joint: Joint::Crown, half_opening }
}

/// The chain of a mode from one crossing to another, or to unlimited friction.
fn part(
    mode: Mode,
    half_opening: &Ball,
    from: &Crossing,
    to: Option<&Crossing>,
    tolerance: f64,
) -> Result<Part, Undecided> {
    let form = form(mode, from.form.weight, half_opening);
    let quarter_turn = half_opening.pi() / half_opening.int(2);
    let start = from.value(form.parameter);
    let end = to.map_or(quarter_turn, |to| to.value(form.parameter));
    let guess = form.unknowns.iter().map(|u| from.value(*u).mid().to_f64()).collect();
    let [low, high] =
        [start.lower().to_f64_round(Round::Down), end.upper().to_f64_round(Round::Up)];
    let failed = |what: &str| Undecided::new(format!("{mode} of this half opening: {what}"));
    let walk = walk(&form, low, guess, high, tolerance)
        .ok_or_else(|| failed("a node cannot be proved"))?;
    let meets = |crossing: &Crossing, is_first: bool| {
        let tube = if is_first { walk.tubes.first() } else { walk.tubes.last() };
        let root: Vec<Ball> = form.unknowns.iter().map(|u| crossing.value(*u)).collect();
        let s = crossing.value(form.parameter);
        tube.and_then(Option::as_ref).is_some_and(|tube| tube.holds(&s, &root))
    };
    if !meets(from, true) || !to.is_none_or(|to| meets(to, false)) {
        return Err(failed("it is not proved to meet the next line"));
    }
    let at_end = match (to, walk.tubes.last()) {
        (Some(to), _) => to.place(),
        (None, Some(Some(tube))) => {
            let place = Place::new(&form, &end, &tube.enclosure(&end));
            Place { is_unlimited: true, ..place }
        }
        (None, _) => Place::default(),
    };
    Ok(Part { mode, ends: [from.place(), at_end], chain: Some((form, walk)) })
}

/// The line of pure sliding: from where it begins up to the physical limit.
fn upright(foot: &Crossing) -> Part {
    let from = foot.place();
    let thickness = Some(Ball::integer(2, BITS));
    let to = Place { thickness, rotation_joint: None, ..from.clone() };
    Part { mode: Mode::Sliding, ends: [from, to], chain: None }
}

/// The line of pure rotation: from where it begins to unlimited friction.
fn level(begin: &Crossing) -> Part {
    let from = Place { sliding_joint: None, ..begin.place() };
    let right_angle = begin.s.pi() / begin.s.int(2);
    let to = Place {
        friction_angle: Some(right_angle),
        friction: Some(Ball::whole(BITS)),
        is_unlimited: true,
        ..from.clone()
    };
    Part { mode: Mode::Rotational, ends: [from, to], chain: None }
}

impl Level {
    /// Follows the line of a half opening between 0 and that of `L`, beyond which nothing stands, in tubes as
    /// [`Trace::new`] has them. Undecided if the half opening is that of a landmark, or if a proof fails.
    pub fn new(
        weight: SelfWeight,
        half_opening: &ExactNumber,
        tolerance: f64,
    ) -> Result<Self, NoLevel> {
        let alpha = half_opening.enclosure::<Ball>(BITS);
        let is_below = |landmark: Landmark| -> Result<bool, Undecided> {
            let end = EndValues::of(End::Landmark(landmark), weight)?;
            match alpha.is_less_than(&end.value(Variable::HalfOpening)) {
                Ternary::True => Ok(true),
                Ternary::False => Ok(false),
                Ternary::Undecided => Err(Undecided::new(format!(
                    "the half opening may be that of {}",
                    landmark.symbol()
                ))),
            }
        };
        if !alpha.is_positive().is_proved() || !is_below(Landmark::OverturningEnd)? {
            return Err(NoLevel::Outside(half_opening.to_string()));
        }
        let crossing = |line: Line| Crossing::new(Curve::Line(line), weight, &alpha);
        let part =
            |mode, from: &Crossing, to: Option<&Crossing>| part(mode, &alpha, from, to, tolerance);
        let mut parts = Vec::new();
        if is_below(Landmark::Triple)? {
            let foot = crossing(Line::ShoulderEnd)?;
            let end = crossing(Line::RotationShoulder)?;
            parts.push(upright(&foot));
            parts.push(part(Mode::SlidingRotational, &foot, Some(&end))?);
            parts.push(level(&end));
            return Ok(Self { weight, half_opening: half_opening.clone(), parts });
        }
        // The domains that follow each other from the foot on, each with the line behind it.
        let domains = [
            (Mode::OverturningSliding, Line::Crown),
            (Mode::RotationalSlidingRotational, Line::Joints),
            (Mode::RotationalSliding, Line::RotationInner),
        ];
        let (foot, passed) = if is_below(Landmark::Shift)? {
            (crossing(Line::AboveHaunchEnd)?, 2)
        } else if is_below(Landmark::Junction)? {
            (crossing(Line::BelowHaunchEnd)?, 1)
        } else if is_below(Landmark::Border)? {
            (crossing(Line::CrownEnd)?, 0)
        } else {
            (Crossing::new(Curve::Limit, weight, &alpha)?, 0)
        };
        if foot.form.knows(Variable::Thickness) {
            parts.push(upright(&foot));
        }
        let mut from = foot;
        if !is_below(Landmark::RotationEnd)? {
            parts.push(part(Mode::OverturningSliding, &from, None)?);
            return Ok(Self { weight, half_opening: half_opening.clone(), parts });
        }
        for (mode, line) in &domains[passed..] {
            let to = crossing(*line)?;
            parts.push(part(*mode, &from, Some(&to))?);
            from = to;
        }
        parts.push(level(&from));
        Ok(Self { weight, half_opening: half_opening.clone(), parts })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Mode::{
        OverturningSliding as Rs, Rotational as Rrr, RotationalSliding as Rrs,
        RotationalSlidingRotational as Rsr, Sliding as Ss, SlidingRotational as Srr,
    };

    fn of(weight: SelfWeight, alpha: &str) -> Level {
        Level::new(weight, &alpha.parse().unwrap(), 1e-5).unwrap()
    }

    /// Each half opening meets the domains in their order, each once.
    #[test]
    fn a_line_meets_each_domain_once() {
        let cases: [(&str, &[Mode]); 9] = [
            ("1/100", &[Ss, Srr, Rrr]),
            ("80deg", &[Ss, Srr, Rrr]),
            ("2.4", &[Ss, Srr, Rrr]),
            ("2.47", &[Ss, Rrs, Rrr]),
            ("2.515", &[Ss, Rrs, Rrr]),
            ("2.533", &[Ss, Rsr, Rrs, Rrr]),
            ("2.58", &[Ss, Rs, Rsr, Rrs, Rrr]),
            ("2.62", &[Ss, Rs]),
            ("2.64", &[Rs]),
        ];
        for (alpha, modes) in cases {
            let level = of(SelfWeight::Milankovitch, alpha);
            let found: Vec<Mode> = level.parts.iter().map(|part| part.mode).collect();
            assert_eq!(found, modes, "{alpha}");
            for part in &level.parts {
                assert!(part.pieces().all(|piece| piece.is_proved()), "{alpha} {}", part.mode);
            }
        }
    }

    #[test]
    fn parts_meet_and_have_the_half_opening() {
        for weight in SelfWeight::ALL {
            for alpha in ["0.3", "2.5", "2.56"] {
                let level = of(weight, alpha);
                let exact = level.half_opening.enclosure::<Ball>(64);
                let points: Vec<Vec<Point>> = level.parts.iter().map(Part::points).collect();
                for pair in points.windows(2) {
                    let is_upright = pair[0].len() == 2
                        && pair[0][0].place.rotation_joint.is_some()
                        && pair[0][1].place.rotation_joint.is_none();
                    let (one, other) =
                        (&pair[0][if is_upright { 0 } else { pair[0].len() - 1 }], &pair[1][0]);
                    let eta = |point: &Point| point.place.thickness.clone().unwrap();
                    assert!(eta(one).overlaps(&eta(other)), "{weight:?} {alpha}");
                }
                for point in points.iter().flatten() {
                    assert!(point.place.half_opening.as_ref().unwrap().overlaps(&exact));
                }
            }
        }
    }

    #[test]
    fn beyond_l_there_is_no_line() {
        for alpha in ["0", "-1", "2.9", "pi"] {
            let level = Level::new(SelfWeight::Heyman, &alpha.parse().unwrap(), 1e-3);
            assert!(matches!(level, Err(NoLevel::Outside(_))), "{alpha}");
        }
    }
}
