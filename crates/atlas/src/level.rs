//! The lines of one half opening, of one least thickness, of one friction.
//!
//! In the plane of friction angle and thickness the line of a half opening comes down from the physical limit at the
//! friction of pure sliding, `[s,s]`, or begins on the limit itself; it then runs through the domains in which the arch
//! needs the less thickness the more friction there is, and ends level, `[r,r,r]`, or at unlimited friction, `[r]`.
//! A line of one thickness runs across the same domains from the edge of `[s,s]` on, one of a friction up through
//! them from the edge of `[r,r,r]`.
//!
//! Each part is one chain of proved pieces, or straight; the parts meet on the lines between the modes, in points
//! that are proved. Each line between modes is proved to be met there only, and the others nowhere
//! ([`Crossing`](super::crossing)), so that a part stays in the domain of its mode. A straight part is what an
//! equation without the thickness or the friction leaves: `[s,s]` begins in a point in which (17) and (18) hold,
//! which do not see the thickness, `[r,r,r]` in one in which (2), (4) and (5) hold, which do not see the friction.
//! That the arch stands as far as the part is drawn are the claims `unique-thicker` and `map-rows` of `couplet
//! prove`.

use super::contour::Contour;
use super::crossing::{BITS, Crossing};
use super::curve::Curve;
use super::part::Part;
use super::place::Place;
use super::trace::Trace;
use super::variable::Variable;
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::number::{Ball, Enclosure, Ternary, says};
use crate::problem::{Line, Mode};

/// Reason why there is no line.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum NoLevel {
    /// No arch has it.
    Outside(String),
    /// The level is that of a landmark, or a proof fails.
    Undecided(String, Undecided),
}

says!(NoLevel {
    Self::Outside(why) => "{why}";
    Self::Undecided(level, error) => "{level}: {error}";
});

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
    /// Quantity that is the same on it.
    pub contour: Contour,
    /// Parts of the level, from the least friction on; of a friction from the least thickness on.
    pub parts: Vec<Part>,
}

/// Half-width of the tubes in which the lines between modes are followed, to find where they are met.
const FINE: f64 = 1e-4;

/// The lines between modes that are met, each once, and the limit.
struct Crossings {
    lines: Vec<(Line, Crossing)>,
    limit: Option<Crossing>,
}

impl Crossings {
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

    /// The quantities at a friction angle, of a half opening or a thickness; `None` in pure sliding, where an inner
    /// joint slides, and where a proof fails.
    pub fn at_friction_angle(&self, phi: &Ball) -> Option<Place> {
        Part::among(&self.parts, phi)
    }

    /// Tells whether a piece is not proved.
    pub fn has_gap(&self) -> bool {
        self.parts.iter().flat_map(Part::pieces).any(|piece| !piece.is_proved())
    }

    /// The curves that [`Level::among`] needs.
    pub fn curves() -> impl Iterator<Item = Curve> {
        Line::ALL.into_iter().map(Curve::Line).chain([Curve::Limit])
    }

    /// Some curves of a weight.
    pub fn lines(weight: SelfWeight) -> Result<Vec<Trace>, Undecided> {
        Self::curves().map(|curve| Trace::new(curve, weight, FINE)).collect()
    }

    /// Follows a line, in tubes as [`Trace::new`] has them: of a half opening between 0 and that of `L`, beyond
    /// which nothing stands, of a thickness between 0 and 2, of a positive friction. Undecided if a landmark lies
    /// on it, or if a proof fails.
    pub fn new(weight: SelfWeight, contour: &Contour, tolerance: f64) -> Result<Self, NoLevel> {
        let undecided = |error| NoLevel::Undecided(contour.to_string(), error);
        Self::among(&Self::lines(weight).map_err(undecided)?, weight, contour, tolerance)
    }

    /// Level with the lines between modes among some curves.
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
        let mut met = Crossings::new(traces, weight, given).map_err(undecided)?;
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

/// Parts from the edge of pure sliding, or from the limit, towards unlimited friction.
fn falling(
    met: &mut Crossings,
    given: (Variable, &Ball),
    tolerance: f64,
) -> Result<Vec<Part>, Undecided> {
    let mut parts = Vec::new();
    let (mut mode, mut from) = match (met.next(Mode::Sliding), met.limit.take()) {
        (Some(foot), None) => {
            // A thickness has one point of pure sliding.
            parts.extend((given.0 != Variable::Thickness).then(|| Part::upright(&foot.1)));
            foot
        }
        (None, Some(limit)) => (Mode::OverturningSliding, limit),
        _ => return Err(Undecided::new("it does not begin once")),
    };
    while let Some((behind, to)) = met.next(mode) {
        parts.push(Part::between(mode, given, &from, Some(&to), tolerance)?);
        (mode, from) = (behind, to);
    }
    parts.push(match mode {
        Mode::Rotational => Part::level(&from),
        _ => Part::between(mode, given, &from, None, tolerance)?,
    });
    Ok(parts)
}

/// Parts from the edge of pure rotation to that of pure sliding, and up to the limit.
fn rising(
    met: &mut Crossings,
    given: (Variable, &Ball),
    tolerance: f64,
) -> Result<Vec<Part>, Undecided> {
    let mut parts = Vec::new();
    let nowhere = || Undecided::new("it does not begin once");
    let (mut mode, mut from) = met.next(Mode::Rotational).ok_or_else(nowhere)?;
    while let Some((behind, to)) = met.next(mode) {
        parts.push(Part::between(mode, given, &from, Some(&to), tolerance)?);
        (mode, from) = (behind, to);
    }
    parts.push(match (mode, met.limit.take()) {
        (Mode::Sliding, None) => Part::upright(&from),
        (Mode::OverturningSliding, Some(limit)) => {
            Part::between(mode, given, &from, Some(&limit), tolerance)?
        }
        _ => return Err(nowhere()),
    });
    Ok(parts)
}

#[cfg(test)]
mod tests {
    use super::super::trace::TracePoint;
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

    const CASES: [(&str, &str, &[Mode]); 21] = [
        ("alpha", "1/100", &[Ss, Srr, Rrr]),
        ("alpha", "2.4", &[Ss, Srr, Rrr]),
        ("alpha", "2.47", &[Ss, Rrs, Rrr]),
        ("alpha", "2.533", &[Ss, Rsr, Rrs, Rrr]),
        ("alpha", "2.58", &[Ss, Rs, Rsr, Rrs, Rrr]),
        ("alpha", "2.62", &[Ss, Rs]),
        ("alpha", "2.64", &[Rs]),
        ("eta", "0.001", &[Srr, Rrr]),
        ("eta", "0.65", &[Rrs, Rrr]),
        ("eta", "0.86", &[Rrs, Rrr]),
        ("eta", "0.88", &[Rsr, Rrs, Rrr]),
        ("eta", "0.92", &[Rs, Rsr, Rrs, Rrr]),
        ("eta", "1", &[Rs]),
        ("eta", "1.99", &[Rs]),
        ("mu", "0.01", &[Srr, Ss]),
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
                let points: Vec<Vec<TracePoint>> = level.parts.iter().map(Part::points).collect();
                for pair in points.windows(2) {
                    // Pure sliding begins where the next part does.
                    let is_upright =
                        pair[0].len() == 2 && pair[0][1].place.rotation_joint.is_none();
                    let one = &pair[0][if is_upright { 0 } else { pair[0].len() - 1 }];
                    for variable in Variable::PLANE {
                        let at =
                            |point: &TracePoint| point.place.coordinate(variable).unwrap().clone();
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
        for (quantity, values) in [
            ("alpha", &["0", "-1", "2.9", "pi"][..]),
            ("eta", &["0", "-0.1", "2", "2.1"]),
            ("mu", &["0", "-1", "inf"]),
        ] {
            for value in values {
                let (weight, contour) = (SelfWeight::Heyman, contour(quantity, value));
                let error = Level::among(lines(weight), weight, &contour, 1e-3).unwrap_err();
                assert!(matches!(error, NoLevel::Outside(_)), "{quantity} {value}: {error}");
            }
        }
    }
}
