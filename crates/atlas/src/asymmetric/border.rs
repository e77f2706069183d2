//! Ranges of half opening and friction in which asymmetric branches run, and where their kinds change.
//!
//! In the plane of half opening and friction angle four lines are proved for each weight, each over the half
//! opening:
//!
//! | line | what holds | from – to |
//! |---|---|---|
//! | begins | a symmetric state at its least thickness, `[s,r,r]`, has an asymmetric mechanism: the hinges fit | X – Y |
//! | inner/alone | an inner joint slides, and the hinges fit | X – Z |
//! | alone/opening | the hinges fit, and the shoulder just opens | Y – Z |
//! | inner/opening | an inner joint slides, and the shoulder just opens | Z – T |
//!
//! X is on the edge of `[s,s]`, Y on that of `[r,r,r]`, both symmetric; in Z three kinds meet. For each half
//! opening its [`Branch`](super::Branch) leaves the edge of `[s,s]` between X and T, and ends on the first line or,
//! between Y and T, on the edge of `[r,r,r]`. For Heyman's weight the last two lines are beyond that edge: there a
//! branch turns back, so that they bound what it reaches; for Milankovitch's they are before it.
//!
//! With Milankovitch's weight asymmetric solutions are nowhere else, by the claim `asymmetric-number`. With
//! Heyman's an arch has two at the most, and none is outside the [table](crate::problem::asymmetric_region) about
//! these lines; **that none is between the table and the lines is not proved.**

use super::super::crossing::Crossing;
use super::super::curve::Curve;
use super::super::end::{CurveEnd, EndValues};
use super::super::form::CurveForm;
use super::super::law::Law;
use super::super::search;
use super::super::section::Section;
use super::super::trace::Trace;
use super::super::variable::Variable;
use super::kind::{beginning, between};
use crate::arch::asymmetric::AsymmetricMode::{
    self, InnerSliding, ShoulderOpening, ShoulderSliding,
};
use crate::arch::{SelfWeight, cycloid};
use crate::certify::Undecided;
use crate::number::{Angle, Ball, Field};
use crate::problem::{Landmark, Line};
use rug::Float;

/// Line that bounds asymmetric branches, or divides their kinds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BorderLine {
    /// The symmetric states in which a branch ends.
    Begins,
    /// The line where one kind becomes another.
    Between([AsymmetricMode; 2]),
}

impl BorderLine {
    /// All four lines, as above.
    pub const ALL: [Self; 4] = [
        Self::Begins,
        Self::Between([InnerSliding, ShoulderSliding]),
        Self::Between([ShoulderSliding, ShoulderOpening]),
        Self::Between([InnerSliding, ShoulderOpening]),
    ];

    /// The name in files.
    pub fn name(self) -> String {
        match self {
            Self::Begins => "asymmetric_begins".to_owned(),
            Self::Between([one, other]) => format!("{}/{}", one.name(), other.name()),
        }
    }

    /// Tells whether the line bounds what the branches of a weight reach.
    pub fn is_outer(self, weight: SelfWeight) -> bool {
        match self {
            Self::Begins => true,
            Self::Between([_, other]) => other == ShoulderOpening && weight == SelfWeight::Heyman,
        }
    }

    fn form(self, weight: SelfWeight) -> CurveForm {
        match self {
            Self::Begins => beginning(weight),
            Self::Between(kinds) => between(kinds, weight),
        }
    }
}

/// A line, proved from end to end.
#[derive(Clone, Debug)]
pub struct Border {
    /// Line that is the border.
    pub line: BorderLine,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Section of the line over the half opening.
    pub section: Section,
}

/// Bits of what is searched for.
const BITS: u32 = 128;
/// Half-width of the tubes in which the line of pure sliding is followed, to find where the lines begin.
const FINE: f64 = 1e-4;
/// A half opening on it next to X, rad.
const NEAR: f64 = 2.2;
/// Steps from X to T at the most.
const STEPS: f64 = 256.0;

impl Border {
    /// The lines of a weight, in tubes as [`Trace::new`] has them.
    pub fn all(weight: SelfWeight, tolerance: f64) -> Result<Vec<Self>, Undecided> {
        let [begins, alone, opening, last] = BorderLine::ALL;
        let triple = triple(&last.form(weight), weight)?;
        let far = triple.value(Variable::HalfOpening).mid().to_f64();
        let x = start(weight)?;
        let y = along(&begins.form(weight), &x, Law::ShoulderOpens, far)?;
        let z = along(&opening.form(weight), &y, Law::InnerSlides, far)?;
        let between = |line: BorderLine, from: &Crossing, to: &Crossing| {
            let section = Section::between(line.form(weight), [from, to], tolerance);
            let section = section.map_err(|undecided| undecided.about(&line.name()))?;
            Ok(Self { line, weight, section })
        };
        [(begins, &x, &y), (alone, &x, &z), (opening, &y, &z), (last, &z, &triple)]
            .into_iter()
            .map(|(line, from, to)| between(line, from, to))
            .collect()
    }
}

/// T on a line that ends there.
fn triple(form: &CurveForm, weight: SelfWeight) -> Result<Crossing, Undecided> {
    let values = EndValues::of(CurveEnd::Landmark(Landmark::Triple), weight)?;
    let thrust = values.value(Variable::Inclination);
    let thrust = cycloid::thrust(&Angle::new(thrust));
    let eta = values.value(Variable::Thickness);
    let moment = (eta.clone() / eta.int(2) + eta.int(1)) * &thrust;
    let (s, root) = form.point(|variable| match variable {
        Variable::CrownMoment => moment.clone(),
        known => values.value(known),
    });
    Ok(Crossing::known(form, s, root))
}

/// X: on the edge of `[s,s]` the hinges fit.
fn start(weight: SelfWeight) -> Result<Crossing, Undecided> {
    let line = Trace::new(Curve::Line(Line::ShoulderEnd), weight, FINE)?;
    let near = Ball::exact(Float::with_val(BITS, NEAR), BITS);
    let near = Crossing::find(&line, Variable::HalfOpening, &near)?
        .ok_or_else(|| Undecided::new("the edge of [s,s] is not found"))?;
    let double = |variable: Variable| near.value(variable).mid().to_f64();
    let eta = double(Variable::Thickness);
    let value = |variable: &Variable| match variable {
        Variable::CrownMoment => double(Variable::Inclination).cos().powi(2) * (1.0 + eta / 2.0),
        known => double(*known),
    };
    let form = beginning(weight);
    let starts = form.variables().map(value);
    let starts = starts.map(|x| Float::with_val(BITS, x)).collect();
    Crossing::proved(&form, Some(Law::InnerSlides), starts)
}

/// Point where another equation holds on a line, from one of its points on.
fn along(form: &CurveForm, from: &Crossing, law: Law, far: f64) -> Result<Crossing, Undecided> {
    let lost = || Undecided::new("the end of a line is not found");
    let double = |variable: &Variable| from.value(*variable).mid().to_f64();
    let number = |given: &Ball| given.mid().to_f64();
    let start = double(&form.parameter);
    let mut x: Vec<f64> = form.unknowns.iter().map(double).collect();
    let step = (far - start) / STEPS;
    for k in 1..STEPS as u32 {
        let alpha = start + f64::from(k) * step;
        x = search::point(form, alpha, x).ok_or_else(lost)?.x;
        if form.residual(law, &number, &alpha, &x) < 0.0 {
            let starts = [alpha].iter().chain(&x).map(|x| Float::with_val(BITS, *x)).collect();
            return Crossing::proved(form, Some(law), starts);
        }
    }
    Err(lost())
}

#[cfg(test)]
mod tests {
    use super::super::super::place::Place;
    use super::super::branch::Branch;
    use super::*;
    use crate::number::Enclosure;
    use crate::problem::asymmetric_region::some_may_move;

    fn value(place: &Place, variable: Variable) -> Ball {
        place.coordinate(variable).unwrap().clone()
    }

    fn degrees(place: &Place) -> f64 {
        value(place, Variable::HalfOpening).mid().to_f64().to_degrees()
    }

    /// As the claim `asymmetric-begins` has their ends by another system of equations.
    #[test]
    fn the_lines_are_proved_from_end_to_end() {
        for (weight, first, second) in
            [(SelfWeight::Milankovitch, 126.21, 128.72), (SelfWeight::Heyman, 125.62, 128.72)]
        {
            let lines = Border::all(weight, 1e-4).unwrap();
            assert!(
                lines.iter().all(|line| !line.section.has_gap() && line.section.width() <= 1e-4)
            );
            let ends = |k: usize| lines[k].section.ends().each_ref().map(degrees);
            for (found, known) in [(ends(0), [first, second]), (ends(1), [first, ends(2)[1]])] {
                let is_near = |k: usize| (0.0..0.01).contains(&(found[k] - known[k]));
                assert!((0..2).all(is_near), "{weight:?} {found:?}");
            }
            assert_eq!(ends(2)[1], ends(3)[0], "three kinds meet");
            let triple = EndValues::of(CurveEnd::Landmark(Landmark::Triple), weight).unwrap();
            let last = &lines[3].section.ends()[1];
            assert!(triple.value(Variable::Thickness).overlaps(&value(last, Variable::Thickness)));
        }
    }

    /// A branch changes its kind and ends on them; a line a millionth off is refused.
    #[test]
    fn branches_meet_them() {
        let weight = SelfWeight::Milankovitch;
        let lines = Border::all(weight, 1e-9).unwrap();
        let at = |line: &Border, alpha: f64| {
            let place = line.section.pieces().find_map(|piece| piece.place(alpha));
            value(&place.unwrap(), Variable::FrictionAngle)
        };
        // Exact in doubles.
        let alpha = 2.21875;
        let branch = Branch::new(weight, &"2.21875".parse().unwrap(), 1e-4).unwrap();
        for (meeting, line) in branch.meetings().skip(1).zip([&lines[1], &lines[0]]) {
            let found = value(&meeting.place(), Variable::FrictionAngle);
            let expected = at(line, alpha);
            assert!(expected.overlaps(&found), "{}", line.line.name());
            let off = Ball::exact(Float::with_val(53, 1e-6), 64);
            assert!(!(expected + off).overlaps(&found), "false twin");
        }
    }

    /// The table of half openings and frictions holds what the lines bound, with room to spare, and little more.
    #[test]
    fn the_table_holds_what_branches_reach_and_little_more() {
        for weight in SelfWeight::ALL {
            let lines = Border::all(weight, 1e-4).unwrap();
            let edges = [Line::ShoulderEnd, Line::RotationShoulder]
                .map(|line| Trace::new(Curve::Line(line), weight, 1e-4).unwrap());
            let tangent = |phi: &Ball| phi.mid().to_f64().tan();
            let on_line = |line: &Border, alpha: f64| {
                let place = line.section.pieces().find_map(|piece| piece.place(alpha))?;
                Some(tangent(&value(&place, Variable::FrictionAngle)))
            };
            let on_edge = |edge: &Trace, alpha: f64| {
                let alpha = Ball::exact(Float::with_val(BITS, alpha), BITS);
                let place = Crossing::find(edge, Variable::HalfOpening, &alpha).unwrap().unwrap();
                tangent(&place.value(Variable::FrictionAngle))
            };
            let ends = [&lines[0].section.ends()[0], &lines[3].section.ends()[1]];
            let [from, to] = ends.map(|end| value(end, Variable::HalfOpening).mid().to_f64());
            let holds = |alpha: f64, mu: f64| some_may_move(weight, [alpha; 2], [mu; 2]);
            for k in 0..40 {
                let alpha = from + (f64::from(k) + 0.5) / 40.0 * (to - from);
                let least = on_edge(&edges[0], alpha);
                let outer = lines.iter().filter(|line| line.line.is_outer(weight));
                let outer = outer.filter_map(|line| on_line(line, alpha)).reduce(f64::max);
                let largest = outer.unwrap_or_else(|| on_edge(&edges[1], alpha));
                assert!(least < largest, "{weight:?} {alpha}");
                assert!(holds(alpha, least - 0.0005) && holds(alpha, largest + 0.0005));
                assert!(!holds(alpha, least - 0.007) && !holds(alpha, largest + 0.007));
            }
            let all = [0.0, f64::INFINITY];
            for (alpha, inside) in [
                (from, true),
                (from - 0.001, true),
                (from - 0.01, false),
                (to, true),
                (to + 0.01, false),
            ] {
                assert_eq!(some_may_move(weight, [alpha; 2], all), inside, "{weight:?} {alpha}");
            }
        }
    }

    /// On which side of the edge of `[r,r,r]` the shoulder begins to open, at some half openings.
    #[test]
    fn one_weight_reaches_beyond_the_edge_of_rotation() {
        for weight in SelfWeight::ALL {
            let edge = Trace::new(Curve::Line(Line::RotationShoulder), weight, 1e-6).unwrap();
            for line in Border::all(weight, 1e-6).unwrap().iter().skip(2) {
                let [from, to] =
                    line.section.ends().each_ref().map(|end| value(end, Variable::HalfOpening));
                let [from, to] = [from, to].map(|end| end.mid().to_f64());
                for share in [0.05, 0.3, 0.6, 0.95] {
                    let alpha = from + share * (to - from);
                    let place = line.section.pieces().find_map(|piece| piece.place(alpha)).unwrap();
                    let [here, edge] =
                        [place, edge.pieces().find_map(|piece| piece.place(alpha)).unwrap()]
                            .map(|place| value(&place, Variable::FrictionAngle));
                    let (one, other) =
                        if line.line.is_outer(weight) { (edge, here) } else { (here, edge) };
                    assert!(one.is_less_than(&other).is_proved(), "{weight:?} {alpha}");
                }
            }
        }
    }
}
