//! Arches that are marked in a map, with what is proved of them.

use super::canvas::Canvas;
use super::plane::Axis;
use crate::arch::SelfWeight;
use crate::atlas::Variable;
use crate::certify::Error;
use crate::certify::state::{Answer, Certify};
use crate::number::{Ball, ExactNumber, arctangent};
use crate::picture::color::{INK, WHITE};
use crate::picture::room::Rectangle;
use crate::picture::{Anchor, Frame, Point, Svg, Type};
use crate::problem::{Arch, Friction};

/// An arch in a map.
#[derive(Clone, Debug)]
pub struct Mark {
    /// The self-weight model.
    weight: SelfWeight,
    half_opening: f64,
    friction_angle: f64,
    /// The given one, else the least; `None` if none is enough.
    thickness: Option<f64>,
    /// What is proved of it.
    words: String,
}

/// Digits of the least thickness, and bits of the coordinates.
const DIGITS: usize = 6;
const BITS: u32 = 64;
/// Of the ring.
const RADIUS: f64 = 10.0;
const LINE: f64 = 1.4;
const SIZE: f64 = 12.0;

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
        let least = match &answer {
            Answer::Stands(state) => {
                format!(
                    "{verdict}least thickness {}, {}",
                    state.thickness.decimal.value, state.mode
                )
            }
            Answer::Falls { fall, .. } => format!("stands at no thickness: {}", fall.reason()),
        };
        let words = format!(
            "α = {}, μ = {}{given}: {least}",
            alpha.replace("deg", "°"),
            mu.replace("deg", "°").replace("inf", "∞")
        );
        let least = match answer {
            Answer::Stands(state) => Some(state.thickness.double),
            Answer::Falls { .. } => None,
        };
        let half_opening = number(arch.half_opening());
        let (weight, thickness) = (arch.weight(), thickness.map(number).or(least));
        Ok(Self { weight, half_opening, friction_angle, thickness, words })
    }

    /// Where it is on a canvas, if it has a thickness or needs none.
    fn at(&self, canvas: &Canvas) -> Option<Point> {
        let on = |axis: &Axis| {
            let value = match axis.coordinate.variable()? {
                Variable::HalfOpening => self.half_opening,
                Variable::FrictionAngle => self.friction_angle,
                _ => self.thickness?,
            };
            Some(axis.shown(value))
        };
        let [x, y] = canvas.axes.each_ref().map(on);
        Some((x?, y?))
    }
}

/// Those of a weight.
pub(super) fn of_weight(marks: &[Mark], weight: SelfWeight) -> Vec<Mark> {
    marks.iter().filter(|mark| mark.weight == weight).cloned().collect()
}

/// What is said of marks below, with their numbers.
pub(super) fn words(marks: &[Mark]) -> Vec<String> {
    (1..).zip(marks).map(|(number, mark)| format!("({number}) {}", mark.words)).collect()
}

/// The numbers of the marks that a frame shows, with their places on the page.
pub(super) fn places(marks: &[Mark], canvas: &Canvas, frame: &Frame) -> Vec<(String, Point)> {
    let place = |(number, mark): (u32, &Mark)| {
        let at = mark.at(canvas).filter(|at| frame.shows(*at))?;
        Some((number.to_string(), frame.at(at)))
    };
    (1..).zip(marks).filter_map(place).collect()
}

/// What a mark takes of the page.
pub(super) fn taken((x, y): Point) -> Rectangle {
    [(x - RADIUS, y - RADIUS), (x + RADIUS, y + RADIUS)]
}

/// Draws them, in a group for each; an `inset` sets the names of its groups apart.
pub(super) fn draw(svg: &mut Svg, places: &[(String, Point)], inset: &str) {
    let of = if inset.is_empty() { String::new() } else { format!("{inset}-") };
    for (number, at) in places {
        svg.group(&format!("{of}mark-{number}"), |svg| {
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
        let said = words(&all);
        assert_eq!(
            said[0],
            "(1) α = 80°, μ = 0.6, η = 0.15: stands; least thickness 0.0686505, [r,r,r]"
        );
        assert!(said[1].contains("η = 0.05: falls; least thickness 0.0686505"), "{}", said[1]);
        assert!(said[2].starts_with("(3) α = 80°, μ = tan(35°): least thickness"), "{}", said[2]);
        assert!(said[3].contains("stands at no thickness: "), "{}", said[3]);
    }

    #[test]
    fn a_mark_is_where_its_arch_is() {
        let (given, least) = (mark("80deg", "1", Some("0.15")), mark("80deg", "inf", None));
        assert_eq!(given.at(&Canvas::usual(Plane::ThicknessFriction)), Some((45.0, 0.15)));
        let (alpha, phi) = least.at(&Canvas::usual(Plane::OpeningFriction)).unwrap();
        assert!((alpha - 80.0).abs() < 1e-12 && phi == 90.0);
        let (_, eta) = least.at(&Canvas::usual(Plane::OpeningThickness)).unwrap();
        assert!((eta - 0.06865046333).abs() < 1e-6);
        let falls = mark("140deg", "0.2", None);
        assert!(falls.at(&Canvas::usual(Plane::OpeningFriction)).is_some());
        assert!(falls.at(&Canvas::usual(Plane::OpeningThickness)).is_none(), "it has no thickness");
    }
}
