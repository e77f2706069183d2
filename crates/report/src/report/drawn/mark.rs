//! Arches that are marked in a map, with what is proved of them.

use super::canvas::Canvas;
use super::plane::PlaneAxis;
use crate::arch::SelfWeight;
use crate::atlas::Variable;
use crate::certify::state::{Answer, Certify, Digits};
use crate::certify::{Error, asymmetric_thicknesses};
use crate::number::{Ball, ExactNumber, arctangent};
use crate::picture::color::{INK, WHITE};
use crate::picture::room::{Rectangle, about};
use crate::picture::{Anchor, Frame, Path, Point, Stroke, Svg, Type};
use crate::problem::{Arch, Friction};
use crate::report::words::may_move;

/// An arch in a map.
#[derive(Clone, Debug)]
pub struct Mark {
    /// The self-weight model.
    weight: SelfWeight,
    half_opening: f64,
    friction_angle: f64,
    /// The least one; `None` if none is enough.
    least: Option<f64>,
    /// The one of the arch, if it is given.
    given: Option<f64>,
    /// Statement of what is proved of it.
    words: String,
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

impl Mark {
    /// An arch, of a given thickness or not, with its proved state.
    pub fn new(arch: &Arch, thickness: Option<&ExactNumber>) -> Result<Self, Error> {
        let number = |x: &ExactNumber| x.enclosure::<Ball>(BITS).mid().to_f64();
        let friction_angle = match arch.friction() {
            Friction::Coefficient(mu) => arctangent(&mu.enclosure(BITS)).mid().to_f64(),
            Friction::Angle(phi) => number(phi),
            Friction::Infinite => std::f64::consts::FRAC_PI_2,
        };
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
        let half_opening = number(arch.half_opening());
        let (weight, given) = (arch.weight(), thickness.map(number));
        Ok(Self { weight, half_opening, friction_angle, least, given, words })
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

/// A mark on the page: its state, where its mode is that of the domain around it.
pub(super) struct Placed {
    number: String,
    /// Place at the least thickness.
    pub at: Point,
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
    let has_stroke = |mark: &Mark| {
        mark.least.is_some() && mark.given.is_some() && mark.at(canvas, None).is_none()
    };
    let stroke = marks.iter().any(has_stroke).then(|| STROKE.to_owned());
    all.chain(stroke).collect()
}

/// Places of marks in the units of the axes, with the ends of strokes to the thicknesses that are given.
pub(super) fn ends(marks: &[Mark], canvas: &Canvas) -> Vec<(Point, Option<Point>)> {
    let ends = |mark: &Mark| {
        let at = mark.at(canvas, mark.least)?;
        let given = mark.given.and_then(|given| mark.at(canvas, Some(given)));
        Some((at, given.filter(|given| *given != at)))
    };
    marks.iter().filter_map(ends).collect()
}

/// Words where a thickness is given and shown.
const STROKE: &str = "A mark is the state of its arch at the least thickness, where the map has its mode; the stroke \
                      goes to the thickness that is given.";

/// The marks that a frame shows, with their places on the page.
pub(super) fn places(marks: &[Mark], canvas: &Canvas, frame: &Frame) -> Vec<Placed> {
    let place = |(number, mark): (u32, &Mark)| {
        let at = mark.at(canvas, mark.least).filter(|at| frame.shows(*at))?;
        let given = mark.given.and_then(|given| mark.at(canvas, Some(given)));
        let given = given.filter(|given| *given != at).map(|(x, y)| {
            let [low, high] = frame.y;
            (frame.at((x, y.clamp(low, high))), frame.shows((x, y)))
        });
        Some(Placed { number: number.to_string(), at: frame.at(at), given })
    };
    (1..).zip(marks).filter_map(place).collect()
}

/// Area that a mark takes of the page.
pub(super) fn taken(at: Point) -> Rectangle {
    about(at, (RADIUS, RADIUS))
}

/// Draws them, in a group for each; an `inset` sets the names of its groups apart.
pub(super) fn draw(svg: &mut Svg, places: &[Placed], inset: &str) {
    let of = if inset.is_empty() { String::new() } else { format!("{inset}-") };
    for Placed { number, at, given } in places {
        svg.group(&format!("{of}mark-{number}"), |svg| {
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
    use super::super::plane::Plane;
    use super::*;

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
        let at = |mark: &Mark, plane| mark.at(&Canvas::usual(plane), mark.least);
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
}
