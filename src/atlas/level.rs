//! The lines of one half opening, of one least thickness, of one friction.
//!
//! In the plane of friction angle and thickness the line of a half opening comes down from the physical limit at the
//! friction of pure sliding, `[s,s]`, or begins on the limit itself; it then runs through the domains in which the arch
//! needs the less thickness the more friction there is, and ends level, `[r,r,r]`, or at unlimited friction, `[r]`. A line of one thickness
//! runs across the same domains from the edge of `[s,s]` on, one of a friction up through them from the edge of `[r,r,r]`.
//!
//! Each part is one chain of proved pieces, or straight; the parts meet on the lines between the modes, in points that are
//! proved. Each line between modes is proved to be met there only, and the others nowhere
//! ([`Crossing`](super::crossing)), so that a part stays in the domain of its mode. A straight part is what an
//! equation without the thickness or the friction leaves: `[s,s]` begins in a point in which (17) and (18) hold, which do not see the
//! thickness, `[r,r,r]` in one in which (2), (4) and (5) hold, which do not see the friction. That the arch stands as far as
//! the part is drawn are the claims `unique-thicker` and `map-rows` of `couplet prove`.

use super::contour::Contour;
use super::crossing::{BITS, Crossing};
use super::curve::Curve;
use super::form::{Form, Joint, Law, Thrust, Variable};
use super::place::Place;
use super::trace::{Piece, Point, Trace, pieces_of, points_of};
use super::walk::{Walk, walk};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::number::{Ball, Enclosure, Field, Real, Ternary};
use crate::problem::{Line, Mode};
use rug::float::Round;

/// Why there is no line.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NoLevel {
    /// No arch has it.
    #[error("{0}")]
    Outside(String),
    /// It is that of a landmark, or a proof fails.
    #[error("{0}: {1}")]
    Undecided(String, Undecided),
}

fn no_arch(contour: &Contour) -> String {
    match contour {
        Contour::HalfOpening(alpha) => {
            format!(
                "no arch of the half opening {alpha} stands at a thickness up to 2, or it is none"
            )
        }
        Contour::Thickness(eta) => format!("the thickness {eta} is not between 0 and 2"),
        Contour::Friction(friction) => {
            format!("the friction {friction} is not positive and finite")
        }
    }
}

/// The line of a half opening, a thickness or a friction.
#[derive(Clone, Debug)]
pub struct Level {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// What is the same on it.
    pub contour: Contour,
    /// Its parts, from the least friction on; of a friction from the least thickness on.
    pub parts: Vec<Part>,
}

/// The part of a line in the domain of one mode.
#[derive(Clone, Debug)]
pub struct Part {
    /// The mode.
    pub mode: Mode,
    ends: [Place; 2],
    /// Nothing where the part is straight.
    chain: Option<(Form, Walk)>,
}

impl Part {
    /// The quantities of its two ends.
    pub fn ends(&self) -> &[Place; 2] {
        &self.ends
    }

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

/// Half-width of the tubes in which the lines between modes are followed, to find where they are met.
const FINE: f64 = 1e-4;

/// The equations of a mode with what is given.
fn form(mode: Mode, weight: SelfWeight, (fixed, value): (Variable, &Ball)) -> Form {
    use {Law as L, Variable as V};
    let turns = matches!(mode, Mode::RotationalSliding | Mode::RotationalSlidingRotational);
    let (laws, thrust): (&[L], Thrust) = match mode {
        Mode::SlidingRotational => (&[L::Tangency, L::Touching], Thrust::Shoulder),
        _ if turns => (&[L::Cycloid, L::Tangency, L::Upper], Thrust::Sliding),
        _ => (&[L::Cycloid, L::Upper], Thrust::Sliding),
    };
    let (parameter, unknowns): (V, &[V]) = match (mode, fixed) {
        (Mode::SlidingRotational, V::HalfOpening) => {
            (V::FrictionAngle, &[V::JointSquare, V::Thickness])
        }
        (Mode::SlidingRotational, V::Thickness) => {
            (V::FrictionAngle, &[V::JointSquare, V::HalfOpening])
        }
        (Mode::SlidingRotational, _) => (V::HalfOpening, &[V::JointSquare, V::Thickness]),
        (_, V::HalfOpening) if turns => {
            (V::Inclination, &[V::FrictionAngle, V::JointSquare, V::Thickness])
        }
        (_, V::HalfOpening) => (V::Inclination, &[V::FrictionAngle, V::Thickness]),
        (_, V::Thickness) if turns => {
            (V::Inclination, &[V::FrictionAngle, V::JointSquare, V::HalfOpening])
        }
        (_, V::Thickness) => (V::Inclination, &[V::FrictionAngle, V::HalfOpening]),
        _ if turns => (V::Thickness, &[V::Inclination, V::JointSquare, V::HalfOpening]),
        _ => (V::Thickness, &[V::Inclination, V::HalfOpening]),
    };
    let given = Some((fixed, value.clone()));
    Form { weight, parameter, unknowns, laws, thrust, joint: Joint::Crown, given }
}

/// The chain of a mode from one crossing to another, or to unlimited friction.
fn part(
    mode: Mode,
    given: (Variable, &Ball),
    from: &Crossing,
    to: Option<&Crossing>,
    tolerance: f64,
) -> Result<Part, Undecided> {
    let form = form(mode, from.form.weight, given);
    let quarter_turn = given.1.pi() / given.1.int(2);
    let start = from.value(form.parameter);
    let end = to.map_or(quarter_turn, |to| to.value(form.parameter));
    let guess = form.unknowns.iter().map(|u| from.value(*u).mid().to_f64()).collect();
    let [low, high] =
        [start.lower().to_f64_round(Round::Down), end.upper().to_f64_round(Round::Up)];
    let failed = |what: &str| Undecided::new(format!("{mode}: {what}"));
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
    let alpha = begin.value(Variable::HalfOpening);
    let right_angle = alpha.pi() / alpha.int(2);
    let to = Place {
        friction_angle: Some(right_angle),
        friction: Some(Ball::whole(BITS)),
        is_unlimited: true,
        ..from.clone()
    };
    Part { mode: Mode::Rotational, ends: [from, to], chain: None }
}

/// The lines between modes that are met, each once, and the limit.
struct Met {
    lines: Vec<(Line, Crossing)>,
    limit: Option<Crossing>,
}

impl Met {
    fn new(
        traces: &[Trace],
        weight: SelfWeight,
        (variable, value): (Variable, &Ball),
    ) -> Result<Self, Undecided> {
        let find = |curve: Curve| {
            let is_it = |trace: &&Trace| trace.weight == weight && trace.curve == curve;
            let missing = || Undecided::new(format!("{curve} is not proved"));
            Crossing::find(traces.iter().find(is_it).ok_or_else(missing)?, variable, value)
        };
        let mut lines = Vec::new();
        for line in Line::ALL {
            lines.extend(find(Curve::Line(line))?.map(|crossing| (line, crossing)));
        }
        // Its thickness is 2 throughout.
        let is_limit = variable == Variable::Thickness;
        let limit = if is_limit { None } else { find(Curve::Limit)? };
        Ok(Self { lines, limit })
    }

    /// The line of a mode that has not been used yet, with the mode behind it.
    fn next(&mut self, mode: Mode) -> Option<(Mode, Crossing)> {
        let index = self.lines.iter().position(|(line, _)| line.modes().contains(&mode))?;
        let (line, crossing) = self.lines.remove(index);
        line.modes().into_iter().find(|other| *other != mode).map(|other| (other, crossing))
    }
}

impl Level {
    /// The largest half-width of a tube.
    pub fn width(&self) -> f64 {
        let pieces = self.parts.iter().flat_map(Part::pieces);
        pieces.filter_map(|piece| piece.width()).fold(0.0, f64::max)
    }

    /// Whether a piece is not proved.
    pub fn has_gap(&self) -> bool {
        self.parts.iter().flat_map(Part::pieces).any(|piece| !piece.is_proved())
    }

    /// The curves that [`Level::among`] needs.
    pub fn curves() -> impl Iterator<Item = Curve> {
        Line::ALL.into_iter().map(Curve::Line).chain([Curve::Limit])
    }

    /// These curves of a weight.
    pub fn lines(weight: SelfWeight) -> Result<Vec<Trace>, Undecided> {
        Self::curves().map(|curve| Trace::new(curve, weight, FINE)).collect()
    }

    /// Follows a line, in tubes as [`Trace::new`] has them: of a half opening between 0 and that of `L`, beyond which nothing stands,
    /// of a thickness between 0 and 2, of a positive friction. Undecided if a landmark lies on it, or if a proof
    /// fails.
    pub fn new(weight: SelfWeight, contour: &Contour, tolerance: f64) -> Result<Self, NoLevel> {
        let undecided = |error| NoLevel::Undecided(contour.to_string(), error);
        Self::among(&Self::lines(weight).map_err(undecided)?, weight, contour, tolerance)
    }

    /// The same, with the lines between modes among some curves.
    pub fn among(
        traces: &[Trace],
        weight: SelfWeight,
        contour: &Contour,
        tolerance: f64,
    ) -> Result<Self, NoLevel> {
        let undecided = |error| NoLevel::Undecided(contour.to_string(), error);
        let outside = || NoLevel::Outside(no_arch(contour));
        let value = contour.value(BITS).ok_or_else(outside)?;
        if value.is_positive() != Ternary::True {
            return Err(outside());
        }
        let given = (contour.variable(), &value);
        let mut met = Met::new(traces, weight, given).map_err(undecided)?;
        if met.lines.is_empty() && met.limit.is_none() {
            return Err(outside());
        }
        let parts = match contour {
            Contour::Friction(_) => rising(&mut met, given, tolerance),
            _ => falling(&mut met, given, tolerance),
        };
        let parts = parts.and_then(|parts| match met.lines.is_empty() {
            true => Ok(parts),
            false => Err(Undecided::new("it meets a line that is not next to it")),
        });
        Ok(Self { weight, contour: contour.clone(), parts: parts.map_err(undecided)? })
    }
}

/// From the edge of pure sliding, or from the limit, towards unlimited friction.
fn falling(
    met: &mut Met,
    given: (Variable, &Ball),
    tolerance: f64,
) -> Result<Vec<Part>, Undecided> {
    let mut parts = Vec::new();
    let (mut mode, mut from) = match (met.next(Mode::Sliding), met.limit.take()) {
        (Some(foot), None) => {
            // A thickness has one point of pure sliding.
            parts.extend((given.0 != Variable::Thickness).then(|| upright(&foot.1)));
            foot
        }
        (None, Some(limit)) => (Mode::OverturningSliding, limit),
        _ => return Err(Undecided::new("it does not begin once")),
    };
    while let Some((behind, to)) = met.next(mode) {
        parts.push(part(mode, given, &from, Some(&to), tolerance)?);
        (mode, from) = (behind, to);
    }
    parts.push(match mode {
        Mode::Rotational => level(&from),
        _ => part(mode, given, &from, None, tolerance)?,
    });
    Ok(parts)
}

/// From the edge of pure rotation to that of pure sliding, and up to the limit.
fn rising(met: &mut Met, given: (Variable, &Ball), tolerance: f64) -> Result<Vec<Part>, Undecided> {
    let mut parts = Vec::new();
    let nowhere = || Undecided::new("it does not begin once");
    let (mut mode, mut from) = met.next(Mode::Rotational).ok_or_else(nowhere)?;
    while let Some((behind, to)) = met.next(mode) {
        parts.push(part(mode, given, &from, Some(&to), tolerance)?);
        (mode, from) = (behind, to);
    }
    parts.push(match (mode, met.limit.take()) {
        (Mode::Sliding, None) => upright(&from),
        (Mode::OverturningSliding, Some(limit)) => {
            part(mode, given, &from, Some(&limit), tolerance)?
        }
        _ => return Err(nowhere()),
    });
    Ok(parts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use Mode::{
        OverturningSliding as Rs, Rotational as Rrr, RotationalSliding as Rrs,
        RotationalSlidingRotational as Rsr, Sliding as Ss, SlidingRotational as Srr,
    };
    use std::sync::OnceLock;

    fn contour(quantity: &str, value: &str) -> Contour {
        match quantity {
            "alpha" => Contour::HalfOpening(value.parse().unwrap()),
            "eta" => Contour::Thickness(value.parse().unwrap()),
            _ => Contour::Friction(value.parse().unwrap()),
        }
    }

    fn lines(weight: SelfWeight) -> &'static [Trace] {
        static LINES: [OnceLock<Vec<Trace>>; 2] = [OnceLock::new(), OnceLock::new()];
        LINES[usize::from(weight == SelfWeight::Heyman)]
            .get_or_init(|| Level::lines(weight).unwrap())
    }

    fn of(weight: SelfWeight, quantity: &str, value: &str) -> Level {
        Level::among(lines(weight), weight, &contour(quantity, value), 1e-5).unwrap()
    }

    const CASES: [(&str, &str, &[Mode]); 25] = [
        ("alpha", "1/100", &[Ss, Srr, Rrr]),
        ("alpha", "80deg", &[Ss, Srr, Rrr]),
        ("alpha", "2.4", &[Ss, Srr, Rrr]),
        ("alpha", "2.47", &[Ss, Rrs, Rrr]),
        ("alpha", "2.515", &[Ss, Rrs, Rrr]),
        ("alpha", "2.533", &[Ss, Rsr, Rrs, Rrr]),
        ("alpha", "2.58", &[Ss, Rs, Rsr, Rrs, Rrr]),
        ("alpha", "2.62", &[Ss, Rs]),
        ("alpha", "2.64", &[Rs]),
        ("eta", "0.001", &[Srr, Rrr]),
        ("eta", "0.1", &[Srr, Rrr]),
        ("eta", "0.65", &[Rrs, Rrr]),
        ("eta", "0.86", &[Rrs, Rrr]),
        ("eta", "0.88", &[Rsr, Rrs, Rrr]),
        ("eta", "0.92", &[Rs, Rsr, Rrs, Rrr]),
        ("eta", "1", &[Rs]),
        ("eta", "1.99", &[Rs]),
        ("mu", "0.01", &[Srr, Ss]),
        ("mu", "0.6", &[Srr, Ss]),
        ("mu", "tan(50deg)", &[Srr, Ss]),
        ("mu", "1.4", &[Rrs, Ss]),
        ("mu", "1.54", &[Rrs, Rsr, Ss]),
        ("mu", "1.6", &[Rrs, Rsr, Rs, Ss]),
        ("mu", "3", &[Rrs, Rsr, Rs]),
        ("mu", "100", &[Rrs, Rsr, Rs]),
    ];

    /// Each line meets the domains in their order, each once.
    #[test]
    fn a_line_meets_each_domain_once() {
        for (quantity, value, modes) in CASES {
            let level = of(SelfWeight::Milankovitch, quantity, value);
            let found: Vec<Mode> = level.parts.iter().map(|part| part.mode).collect();
            assert_eq!(found, modes, "{quantity} {value}");
            for part in &level.parts {
                assert!(part.pieces().all(|piece| piece.is_proved()), "{value} {}", part.mode);
            }
        }
    }

    #[test]
    fn parts_meet_and_have_what_is_given() {
        for weight in SelfWeight::ALL {
            for (quantity, value) in
                [("alpha", "0.3"), ("alpha", "2.5"), ("alpha", "2.56"), ("eta", "0.3"), ("mu", "2")]
            {
                let level = of(weight, quantity, value);
                let exact = level.contour.value(64).unwrap();
                let fixed = level.contour.variable();
                let points: Vec<Vec<Point>> = level.parts.iter().map(Part::points).collect();
                for pair in points.windows(2) {
                    // Pure sliding begins where the next part does.
                    let is_upright =
                        pair[0].len() == 2 && pair[0][1].place.rotation_joint.is_none();
                    let one = &pair[0][if is_upright { 0 } else { pair[0].len() - 1 }];
                    for variable in Variable::PLANE {
                        let at = |point: &Point| point.place.coordinate(variable).unwrap().clone();
                        assert!(
                            at(one).overlaps(&at(&pair[1][0])),
                            "{weight:?} {quantity} {value}"
                        );
                    }
                }
                for point in points.iter().flatten() {
                    assert!(point.place.coordinate(fixed).unwrap().overlaps(&exact));
                }
            }
        }
    }

    /// A straight part has the friction of the purely sliding states, or the thickness of the purely rotational ones.
    #[test]
    fn straight_parts_are_on_the_curves_of_the_pure_states() {
        let straight = |curve, mode: Mode, same: Variable| {
            let trace = Trace::new(curve, SelfWeight::Heyman, 1e-4).unwrap();
            for alpha in ["0.1", "80deg", "2.47", "2.53"] {
                let level = of(SelfWeight::Heyman, "alpha", alpha);
                let exact = level.contour.value(BITS).unwrap();
                let pure = Crossing::find(&trace, Variable::HalfOpening, &exact).unwrap().unwrap();
                let part = level.parts.iter().find(|part| part.mode == mode).unwrap();
                for place in part.ends() {
                    assert!(place.coordinate(same).unwrap().overlaps(&pure.value(same)), "{alpha}");
                }
                let other = &level.parts[1].ends()[usize::from(mode == Mode::Sliding)];
                assert!(!other.coordinate(same).unwrap().overlaps(&pure.value(same)), "false twin");
            }
        };
        straight(Curve::Sliding, Mode::Sliding, Variable::FrictionAngle);
        straight(Curve::Rotation, Mode::Rotational, Variable::Thickness);
    }

    #[test]
    fn outside_there_is_no_line() {
        let none = |quantity, value| {
            let (weight, contour) = (SelfWeight::Heyman, contour(quantity, value));
            Level::among(lines(weight), weight, &contour, 1e-3).unwrap_err()
        };
        for (quantity, value) in [
            ("alpha", "0"),
            ("alpha", "-1"),
            ("alpha", "2.9"),
            ("alpha", "pi"),
            ("eta", "0"),
            ("eta", "-0.1"),
            ("eta", "2"),
            ("eta", "2.1"),
            ("mu", "0"),
            ("mu", "-1"),
            ("mu", "inf"),
        ] {
            let error = none(quantity, value);
            assert!(matches!(error, NoLevel::Outside(_)), "{quantity} {value}: {error}");
        }
    }
}
