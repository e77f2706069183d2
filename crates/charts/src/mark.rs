//! Arches that are marked in a map, or all between two ends, with what is proved of them.

use super::canvas::Canvas;
use super::plane::PlaneAxis;
use crate::arch::SelfWeight;
use crate::atlas::Variable;
use crate::certify::state::{Answer, Certify, Digits};
use crate::certify::{Error, Undecided, asymmetric_thicknesses};
use crate::number::{Ball, ExactNumber, arctangent};
use crate::picture::color::{INK, WHITE};
use crate::picture::room::{Rectangle, about};
use crate::picture::{Anchor, Frame, Path, Point, Stroke, Svg, Type};
use crate::problem::survey::{Side, Survey};
use crate::problem::{Arch, Friction, Mode, Quantity};
use crate::report::words::may_move;
use couplet_survey::{EndValue, ModesFound, RangeEnd, survey};

/// An arch in a map, or all arches of a range.
#[derive(Clone, Debug)]
pub struct Mark {
    /// The self-weight model.
    weight: SelfWeight,
    /// Arch that stands most easily, and the one that does least; one and the same if there is no range.
    ends: [MarkEnd; 2],
    /// True if it is a range.
    is_range: bool,
    /// Statement of what is proved of it.
    words: String,
}

/// An arch of a mark.
#[derive(Clone, Copy, Debug)]
struct MarkEnd {
    half_opening: f64,
    friction_angle: f64,
    /// The least thickness; `None` if none is enough.
    least: Option<f64>,
    /// The one of the arch, if it is given.
    given: Option<f64>,
}

/// Digits of the least thickness, and bits of the coordinates.
const DIGITS: usize = 6;
const BITS: u32 = 64;
/// Radius of the ring.
const RADIUS: f64 = 10.0;
const LINE: f64 = 1.4;
/// Width of the end of a stroke, to each side.
const CAP: f64 = 5.0;
const SIZE: f64 = 14.0;
/// Dashes of the box of the thicknesses that are given, and how much of its ink a box has within.
const DASHES: &[f64] = &[5.0, 3.0];
const WITHIN: f64 = 0.16;
/// Distance of the ring from a box.
const APART: f64 = 3.0;

impl MarkEnd {
    fn new(arch: &Arch, least: Option<f64>, given: Option<&ExactNumber>) -> Self {
        let number = |x: &ExactNumber| x.enclosure::<Ball>(BITS).mid().to_f64();
        let friction_angle = match arch.friction() {
            Friction::Coefficient(mu) => arctangent(&mu.enclosure(BITS)).mid().to_f64(),
            Friction::Angle(phi) => number(phi),
            Friction::Infinite => std::f64::consts::FRAC_PI_2,
        };
        let half_opening = number(arch.half_opening());
        Self { half_opening, friction_angle, least, given: given.map(number) }
    }

    /// Place where an arch of its shape and friction and of some thickness is on a canvas, if that needs none
    /// or there is one.
    fn at(&self, canvas: &Canvas, thickness: Option<f64>) -> Option<Point> {
        let on = |axis: &PlaneAxis| {
            let value = match axis.coordinate.variable()? {
                Variable::HalfOpening => self.half_opening,
                Variable::FrictionAngle => self.friction_angle,
                _ => thickness?,
            };
            Some(axis.shown(value))
        };
        let [x, y] = canvas.axes.each_ref().map(on);
        Some((x?, y?))
    }
}

impl Mark {
    /// An arch, of a given thickness or not, with its proved state.
    pub fn new(arch: &Arch, thickness: Option<&ExactNumber>) -> Result<Self, Error> {
        let answer = arch.certify(DIGITS)?;
        let stands = match thickness {
            Some(eta) => Some(arch.certify_thickness(eta, DIGITS)?.stands?),
            None => None,
        };
        let (alpha, mu) = (arch.half_opening().to_string(), arch.friction().to_string());
        let given = thickness.map(|eta| format!(", η = {eta}")).unwrap_or_default();
        let verdict = match stands {
            Some(true) => "stands; ",
            Some(false) => "falls; ",
            None => "",
        };
        let (least, found) = match &answer {
            Answer::Stands(state) => {
                let Digits { thickness, mode, .. } = &**state;
                let found = format!("{verdict}least thickness {}, {mode}", thickness.decimal.value);
                (Some(thickness.double), found)
            }
            Answer::Falls { fall, .. } => {
                (None, format!("stands at no thickness: {}", fall.reason()))
            }
        };
        let moves = match stands {
            Some(true) => may_move(&asymmetric_thicknesses(arch, DIGITS)?),
            _ => None,
        };
        let moves = moves.map_or(String::new(), |words| format!("; {words}"));
        let words = format!(
            "α = {}, μ = {}{given}: {found}{moves}",
            alpha.replace("deg", "°"),
            mu.replace("deg", "°").replace("inf", "∞")
        );
        let end = MarkEnd::new(arch, least, thickness);
        Ok(Self { weight: arch.weight(), ends: [end; 2], is_range: false, words })
    }

    /// All arches of a survey of half openings and frictions, asked for by a text, with what is proved of all.
    pub(super) fn of_range(text: &str, arches: &Survey) -> Result<Self, Error> {
        let open = || Undecided::new("the least thickness");
        let answer = survey(arches, DIGITS)?;
        let told = || answer.modes.as_ref().map_or(String::new(), modes);
        let mut ranges = answer.ranges.iter();
        let least = ranges.find(|range| range.of == Quantity::LeastThickness).ok_or_else(open)?;
        let verdict = match &answer.verdict {
            Some(Ok(verdict)) => format!("{}; ", verdict.sentence()),
            Some(Err(_)) => "whether each stands is open; ".to_owned(),
            None => String::new(),
        };
        let (lower, upper) = (value(&least.lower), value(&least.upper));
        let found = match (&lower, &upper) {
            (Some(lower), Some(upper)) => {
                format!("{verdict}least thickness {lower} to {upper}, {}", told())
            }
            (Some(lower), None) => {
                let modes = told();
                format!("{verdict}least thickness from {lower}, {modes}; some fall, however thick")
            }
            (None, _) => "all fall, however thick".to_owned(),
        };
        let names = ["α", "μ", "η"].into_iter().zip(text.split(','));
        let names: Vec<String> = names
            .map(|(name, part)| format!("{name} = {}", part.trim().replace("deg", "°")))
            .collect();
        let words = format!("{}: {found}", names.join(", ").replace("inf", "∞"));
        let end = |side, least: Option<String>| {
            let corner = arches.corner(side).ok_or_else(open)?;
            let least = least.and_then(|least| least.parse().ok());
            Ok::<_, Undecided>(MarkEnd::new(&corner.arch, least, corner.thickness.as_ref()))
        };
        let ends = [end(Side::Safe, lower)?, end(Side::Unsafe, upper)?];
        Ok(Self { weight: arches.weight(), ends, is_range: true, words })
    }

    /// Place of an arch and, where it is another, that at the thickness that is given, in the units of the axes.
    fn stroke(&self, canvas: &Canvas) -> Option<(Point, Option<Point>)> {
        let [end, _] = &self.ends;
        let at = end.at(canvas, end.least)?;
        let given = end.given.and_then(|given| end.at(canvas, Some(given)));
        Some((at, given.filter(|given| *given != at)))
    }

    /// Opposite corners, in the units of the axes, of the box of a range at the least thickness or, if it is another
    /// place, at the thickness that is given. Where no thickness is enough the box has no upper end.
    fn corners(&self, canvas: &Canvas, is_given: bool) -> Option<[Point; 2]> {
        let [safe, falling] = &self.ends;
        let (first, last) = match is_given {
            true => (safe.given?, falling.given?),
            false => (safe.least.unwrap_or(f64::NAN), falling.least.unwrap_or(f64::INFINITY)),
        };
        let corners = [safe.at(canvas, Some(first))?, falling.at(canvas, Some(last))?];
        let has_place = corners.iter().all(|(x, y)| !x.is_nan() && !y.is_nan());
        has_place.then_some(corners)
    }

    /// The box of a range on the page, as far as a frame shows it.
    fn outline(&self, canvas: &Canvas, frame: &Frame, is_given: bool) -> Option<Rectangle> {
        let [a, b] = self.corners(canvas, is_given)?;
        let clipped = |a: f64, b: f64, [from, to]: [f64; 2]| {
            let (low, high) = (a.min(b).max(from), a.max(b).min(to));
            (low <= high).then_some((low, high))
        };
        let (left, right) = clipped(a.0, b.0, frame.x)?;
        let (low, high) = clipped(a.1, b.1, frame.y)?;
        Some([frame.at((left, high)), frame.at((right, low))])
    }
}

/// End of the range of the least thickness; none if no thickness is enough.
fn value(end: &RangeEnd) -> Option<String> {
    match &end.value {
        EndValue::Number(number) => Some(number.to_string()),
        _ => None,
    }
}

/// Modes that occur, and those that may.
fn modes(found: &ModesFound) -> String {
    let list = |modes: &[Mode]| modes.iter().map(|mode| mode.label()).collect::<Vec<_>>().join(" ");
    match (&found.occur[..], &found.may_occur[..]) {
        (occur, []) => list(occur),
        ([], may) => format!("perhaps {}", list(may)),
        (occur, may) => format!("{}, perhaps {}", list(occur), list(may)),
    }
}

/// A mark on the page: its state, where its mode is that of the domain around it.
pub(super) struct Placed {
    number: String,
    /// Place at the least thickness; of a range, beside its box.
    pub at: Point,
    /// Boxes of a range, at the least thickness and at the one that is given.
    outlines: [Option<Rectangle>; 2],
    /// The end of a stroke to the thickness that is given, and whether the frame shows that.
    given: Option<(Point, bool)>,
}

/// Marks of a weight.
pub(super) fn of_weight(marks: &[Mark], weight: SelfWeight) -> Vec<Mark> {
    marks.iter().filter(|mark| mark.weight == weight).cloned().collect()
}

/// Words on marks below, with their numbers.
pub(super) fn words(marks: &[Mark], canvas: &Canvas) -> Vec<String> {
    let all = (1..).zip(marks).map(|(number, mark)| format!("({number}) {}", mark.words));
    let has_thickness = |mark: &&Mark| mark.ends[0].at(canvas, None).is_none();
    let is_given = |mark: &&Mark| mark.ends[0].least.is_some() && mark.ends[0].given.is_some();
    let (ranges, single): (Vec<&Mark>, Vec<&Mark>) = marks.iter().partition(|mark| mark.is_range);
    let stroke = single.iter().any(|mark| has_thickness(mark) && is_given(mark));
    let boxes = ranges.first().map(|first| match has_thickness(first) {
        false => BOX.to_owned(),
        true if ranges.iter().any(is_given) => format!("{HULL}{DASHED}."),
        true => format!("{HULL}."),
    });
    all.chain(stroke.then(|| STROKE.to_owned())).chain(boxes).collect()
}

/// Places of marks in the units of the axes: that of an arch and, where there is one, the end of the stroke to the
/// thickness that is given; of a range two corners of its box, within the ranges of the axes.
pub(super) fn ends(marks: &[Mark], canvas: &Canvas) -> Vec<(Point, Option<Point>, bool)> {
    let ends = |mark: &Mark| {
        if mark.is_range {
            let [first, last] = mark.corners(canvas, false)?.map(|(x, y)| {
                let within = |value: f64, [from, to]: [f64; 2]| value.clamp(from, to);
                (within(x, canvas.axes[0].range), within(y, canvas.axes[1].range))
            });
            return Some((first, Some(last), true));
        }
        let (at, given) = mark.stroke(canvas)?;
        Some((at, given, false))
    };
    marks.iter().filter_map(ends).collect()
}

/// Words on boxes in a plane without thickness, and in one with it.
const BOX: &str = "A box holds the arches of its range.";
const HULL: &str = "A box goes from the state of the narrowest and roughest arch of its range to that of the widest and \
                    least rough, at the least thickness: the states of all others lie in it";
const DASHED: &str = "; a dashed one does so at the thicknesses that are given";

/// Words where a thickness is given and shown.
const STROKE: &str = "A mark is the state of its arch at the least thickness, where the map has its mode; the stroke \
                      goes to the thickness that is given.";

/// The marks that a frame shows, with their places on the page.
pub(super) fn places(marks: &[Mark], canvas: &Canvas, frame: &Frame) -> Vec<Placed> {
    let place = |(number, mark): (u32, &Mark)| {
        let number = number.to_string();
        if mark.is_range {
            let least = mark.outline(canvas, frame, false);
            let given = mark.outline(canvas, frame, true).filter(|given| Some(*given) != least);
            let at = beside(least.or(given)?, frame);
            return Some(Placed { number, at, outlines: [least, given], given: None });
        }
        let (at, given) = mark.stroke(canvas).filter(|(at, _)| frame.shows(*at))?;
        let given = given.map(|(x, y)| {
            let [low, high] = frame.y;
            (frame.at((x, y.clamp(low, high))), frame.shows((x, y)))
        });
        Some(Placed { number, at: frame.at(at), outlines: [None, None], given })
    };
    (1..).zip(marks).filter_map(place).collect()
}

/// Place of the ring at a box: to the right or to the left of it or, where there is no room, in it.
fn beside([(left, top), (right, bottom)]: Rectangle, frame: &Frame) -> Point {
    let (middle, off) = (f64::midpoint(top, bottom), RADIUS + APART);
    let middle = middle.clamp(frame.corner.1 + off, frame.bottom() - off);
    match (right + 2.0 * off < frame.right(), left - 2.0 * off > frame.corner.0) {
        (true, _) => (right + off, middle),
        (_, true) => (left - off, middle),
        _ => (f64::midpoint(left, right), middle),
    }
}

impl Placed {
    /// Boxes on the page, as closed lines that no name should cross.
    pub(super) fn lines(&self) -> impl Iterator<Item = Vec<Point>> {
        let around = |[(left, top), (right, bottom)]: Rectangle| {
            vec![(left, top), (right, top), (right, bottom), (left, bottom), (left, top)]
        };
        self.outlines.into_iter().flatten().map(around)
    }

    /// Points that nothing should cover: the ring, and the corners of the boxes.
    pub(super) fn points(&self) -> impl Iterator<Item = Point> {
        std::iter::once(self.at).chain(self.outlines.into_iter().flatten().flatten())
    }
}

/// Area that a mark takes of the page.
pub(super) fn taken(at: Point) -> Rectangle {
    about(at, (RADIUS, RADIUS))
}

/// Draws them, in a group for each; an `inset` sets the names of its groups apart.
pub(super) fn draw(svg: &mut Svg, places: &[Placed], inset: &str) {
    let of = if inset.is_empty() { String::new() } else { format!("{inset}-") };
    for Placed { number, at, outlines, given } in places {
        svg.group(&format!("{of}mark-{number}"), |svg| {
            let [least, dashed] = outlines.map(|of| of.map(|[a, b]| Path::rectangle(a, b)));
            if let Some(path) = least {
                svg.tint(&path, INK, WITHIN);
                svg.stroke(&path, Stroke::new(INK, LINE));
            }
            if let Some(path) = dashed {
                svg.stroke(&path, Stroke { dashes: DASHES, ..Stroke::new(INK, LINE) });
            }
            if let Some((end, is_shown)) = given {
                svg.stroke(&Path::through([*at, *end]), Stroke::new(INK, LINE));
                let cap = [-CAP, CAP].map(|across| (end.0 + across, end.1));
                if *is_shown {
                    svg.stroke(&Path::through(cap), Stroke::new(INK, LINE));
                }
            }
            svg.disc(*at, RADIUS, INK);
            svg.disc(*at, RADIUS - LINE, WHITE);
            svg.text(number, *at, Type::new(SIZE, INK).at(Anchor::Middle));
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Plane;

    fn mark(alpha: &str, mu: &str, eta: Option<&str>) -> Mark {
        let eta: Option<ExactNumber> = eta.map(|eta| eta.parse().unwrap());
        Mark::new(&Arch::parse("milankovitch", alpha, mu).unwrap(), eta.as_ref()).unwrap()
    }

    #[test]
    fn a_mark_says_what_is_proved() {
        let all = [
            mark("80deg", "0.6", Some("0.15")),
            mark("80deg", "0.6", Some("0.05")),
            mark("80deg", "tan(35deg)", None),
            mark("140deg", "0.2", None),
        ];
        let said = words(&all, &Canvas::usual(Plane::ThicknessFriction));
        assert!(said[4].contains("the stroke goes to the thickness that is given"));
        assert_eq!(words(&all, &Canvas::usual(Plane::OpeningFriction)).len(), 4, "no thickness");
        assert_eq!(
            said[0],
            "(1) α = 80°, μ = 0.6, η = 0.15: stands; least thickness 0.0686505, [r,r,r]"
        );
        assert!(said[1].contains("η = 0.05: falls; least thickness 0.0686505"), "{}", said[1]);
        assert!(said[2].starts_with("(3) α = 80°, μ = tan(35°): least thickness"), "{}", said[2]);
        assert!(said[3].contains("stands at no thickness: "), "{}", said[3]);
    }

    #[test]
    fn a_mark_is_where_its_state_is() {
        let at = |mark: &Mark, plane| mark.ends[0].at(&Canvas::usual(plane), mark.ends[0].least);
        let least = mark("80deg", "inf", None);
        let (alpha, phi) = at(&least, Plane::OpeningFriction).unwrap();
        assert!((alpha - 80.0).abs() < 1e-12 && phi == 90.0);
        let (_, eta) = at(&least, Plane::OpeningThickness).unwrap();
        assert!((eta - 0.06865046333).abs() < 1e-6);
        let falls = mark("140deg", "0.2", Some("1"));
        assert!(at(&falls, Plane::OpeningFriction).is_some());
        assert!(at(&falls, Plane::OpeningThickness).is_none(), "it has no state");
        assert_eq!(words(&[falls], &Canvas::usual(Plane::OpeningThickness)).len(), 1);
    }

    /// In the plane of thickness and friction the given thickness is another arch's, of another mode.
    #[test]
    fn a_stroke_goes_from_the_state_to_the_given_thickness() {
        let canvas = Canvas::usual(Plane::ThicknessFriction);
        let [x, y] = canvas.axes.map(|axis| axis.range);
        let frame = Frame { corner: (0.0, 0.0), size: (90.0, 200.0), x, y };
        let all = [mark("80deg", "1", Some("0.15")), mark("80deg", "1", None)];
        let [given, bare] = &places(&all, &canvas, &frame)[..] else { panic!("both are shown") };
        assert_eq!(given.at, bare.at);
        assert!((given.at.1 - 193.1349).abs() < 1e-3, "{:?}", given.at);
        assert_eq!((given.given, bare.given), (Some(((45.0, 185.0), true)), None));
        let near = Frame { y: [0.0, 0.1], ..frame };
        assert_eq!(places(&all, &canvas, &near)[0].given, Some(((45.0, 0.0), false)), "beyond");
    }

    fn range(text: &str) -> Mark {
        text.parse::<crate::marked::Marked>().unwrap().proved(SelfWeight::Heyman).unwrap()
    }

    #[test]
    fn a_range_says_what_is_proved_of_all() {
        let all = [
            range("78deg..82deg,0.6±10%,0.08..0.1"),
            range("78deg..82deg,0.6..inf,0.05..0.1"),
            range("100deg..140deg,0.3..0.5"),
            range("140deg..150deg,0.1..0.2"),
        ];
        let said = words(&all, &Canvas::usual(Plane::OpeningThickness));
        let starts = [
            "(1) α = 78°..82°, μ = 0.6±10%, η = 0.08..0.1: every arch stands; least thickness 0.06",
            "(2) α = 78°..82°, μ = 0.6..∞, η = 0.05..0.1: some arches stand, others do not; least",
            "(3) α = 100°..140°, μ = 0.3..0.5: least thickness from 0.",
            "(4) α = 140°..150°, μ = 0.1..0.2: all fall, however thick",
            "A box goes from",
        ];
        assert_eq!(said.len(), starts.len(), "{said:?}");
        for (said, start) in said.iter().zip(starts) {
            assert!(said.starts_with(start), "{said}");
        }
        assert!(said[0].ends_with(", [r,r,r]") && said[2].ends_with("; some fall, however thick"));
        assert!(said[4].contains("a dashed one"));
        let without = words(&all[2..3], &Canvas::usual(Plane::OpeningFriction));
        assert_eq!(without[1..], [BOX.to_owned()]);
        let points = words(&[mark("80deg", "0.6", None)], &Canvas::usual(Plane::OpeningFriction));
        assert_eq!(points.len(), 1, "no box");
    }

    /// Every arch of a range is in its box, in each plane.
    #[test]
    fn a_box_holds_the_states_of_its_range() {
        let of = range("100deg..120deg,0.42..0.9");
        for plane in Plane::ALL {
            let canvas = Canvas::usual(plane);
            let [x, y] = canvas.axes.map(|axis| axis.range);
            let frame = Frame { corner: (0.0, 0.0), size: (100.0, 100.0), x, y };
            let [(left, top), (right, bottom)] = of.outline(&canvas, &frame, false).unwrap();
            assert!(right - left > 1.0 && bottom - top > 1.0);
            for alpha in ["100deg", "110deg", "120deg"] {
                for mu in ["0.42", "0.6", "0.9"] {
                    let one = Mark::new(&Arch::parse("heyman", alpha, mu).unwrap(), None).unwrap();
                    // Some of them fall, and are nowhere in a map.
                    let Some(at) = one.ends[0].at(&canvas, one.ends[0].least) else { continue };
                    let (u, v) = frame.at(at);
                    let off = 1e-3;
                    assert!(left - off <= u && u <= right + off, "{plane:?} {alpha} {mu}");
                    assert!(top - off <= v && v <= bottom + off, "{plane:?} {alpha} {mu}");
                }
            }
        }
        let outside = range("10deg..20deg,0.1..0.2");
        let canvas = Canvas::usual(Plane::OpeningFriction);
        let frame =
            Frame { corner: (0.0, 0.0), size: (9.0, 9.0), x: [100.0, 120.0], y: [0.0, 90.0] };
        assert!(places(&[outside], &canvas, &frame).is_empty());
    }
}
