//! Straight and curved lines.

use std::fmt;

/// A coordinate of a path is written to this of the unit.
pub const ROUNDED: f64 = 0.001;

/// The longest arc that is drawn as one curve, in rad: the curve is nowhere further from it than 4 millionths of
/// the radius.
const ARC: f64 = 0.8;

/// Straight parts of a curve where only its way matters.
const STEPS: u32 = 6;

/// Point to the right and down, in units of the picture.
pub type Point = (f64, f64);

/// A chain of straight lines and cubic Bézier curves, in one piece or several.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path(Vec<PathStep>);

#[derive(Clone, Copy, Debug, PartialEq)]
enum PathStep {
    Move(Point),
    Line(Point),
    Curve(Point, Point, Point),
    Close,
}

impl Path {
    /// Straight from point to point.
    pub fn through(points: impl IntoIterator<Item = Point>) -> Self {
        let mut path = Self::default();
        for (k, point) in points.into_iter().enumerate() {
            path.0.push(if k == 0 { PathStep::Move(point) } else { PathStep::Line(point) });
        }
        path
    }

    /// Once round straight lines.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Self {
        let mut path = Self::through(points);
        path.close();
        path
    }

    /// A rectangle by two opposite corners.
    pub fn rectangle(a: Point, b: Point) -> Self {
        Self::around([a, (b.0, a.1), b, (a.0, b.1)])
    }

    /// Begins a piece.
    pub fn start(&mut self, at: Point) {
        self.0.push(PathStep::Move(at));
    }

    /// Goes on straight.
    pub fn line(&mut self, to: Point) {
        self.0.push(PathStep::Line(to));
    }

    /// Goes on along a cubic Bézier curve.
    pub fn curve(&mut self, first_handle: Point, second_handle: Point, to: Point) {
        self.0.push(PathStep::Curve(first_handle, second_handle, to));
    }

    /// Goes on along a circle, from one angle to another, both clockwise from upwards: it has to be at the first.
    pub fn arc(&mut self, (x, y): Point, radius: f64, [from, to]: [f64; 2]) {
        let pieces = ((to - from).abs() / ARC).ceil().max(1.0) as u32;
        let step = (to - from) / f64::from(pieces);
        let handle = radius * 4.0 / 3.0 * (step / 4.0).tan();
        let at = |angle: f64, along: f64| {
            let (sin, cos) = angle.sin_cos();
            (x + radius * sin + along * cos, y - radius * cos + along * sin)
        };
        for k in 0..pieces {
            let [start, end] = [k, k + 1].map(|k| from + f64::from(k) * step);
            self.curve(at(start, handle), at(end, -handle), at(end, 0.0));
        }
    }

    /// Ends a piece where it began.
    pub fn close(&mut self) {
        self.0.push(PathStep::Close);
    }

    /// Points so close together that its pieces are nearly straight between them.
    pub(super) fn points(&self) -> Vec<Vec<Point>> {
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        for step in &self.0 {
            if let PathStep::Move(at) = step {
                pieces.push(vec![*at]);
            }
            let Some(piece) = pieces.last_mut() else { continue };
            let (first, last) = (piece[0], piece[piece.len() - 1]);
            match *step {
                PathStep::Move(_) => {}
                PathStep::Line(to) => piece.push(to),
                PathStep::Close => piece.push(first),
                PathStep::Curve(a, b, to) => piece.extend((1..=STEPS).map(|k| {
                    let (t, u) =
                        (f64::from(k) / f64::from(STEPS), 1.0 - f64::from(k) / f64::from(STEPS));
                    let mix = |p: f64, a: f64, b: f64, q: f64| {
                        u * u * u * p + 3.0 * u * u * t * a + 3.0 * u * t * t * b + t * t * t * q
                    };
                    (mix(last.0, a.0, b.0, to.0), mix(last.1, a.1, b.1, to.1))
                })),
            }
        }
        pieces
    }
}

/// Writes the path as the attribute `d` of SVG has it.
impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pair = |(x, y): Point| format!("{} {}", Short(x), Short(y));
        for step in &self.0 {
            match *step {
                PathStep::Move(to) => write!(f, "M{}", pair(to))?,
                PathStep::Line(to) => write!(f, "L{}", pair(to))?,
                PathStep::Curve(a, b, to) => write!(f, "C{} {} {}", pair(a), pair(b), pair(to))?,
                PathStep::Close => f.write_str("Z")?,
            }
        }
        Ok(())
    }
}

/// A length to the nearest thousandth, as short as it goes.
pub(super) struct Short(pub(super) f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&short(self.0, 3))
    }
}

/// A number to so many decimals, as short as it goes.
pub(super) fn short(value: f64, decimals: usize) -> String {
    let mut text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_short() {
        let texts = [0.0, -0.001, 100.0, 12.5, -7.257, 1e-9].map(|x| Short(x).to_string());
        assert_eq!(texts, ["0", "-0.001", "100", "12.5", "-7.257", "0"]);
    }

    #[test]
    fn an_arc_stays_on_its_circle() {
        let mut path = Path::through([(3.0, 1.0)]);
        path.arc((3.0, 4.0), 3.0, [0.0, 2.0]);
        let points = path.points().remove(0);
        assert!(points.iter().all(|(x, y)| ((x - 3.0).hypot(y - 4.0) - 3.0).abs() < 1.2e-5));
        let (at, pieces) = (points[points.len() - 1], (points.len() - 1) / STEPS as usize);
        assert_eq!(pieces, 3);
        assert!(
            (at.0 - 3.0 - 3.0 * 2f64.sin()).abs() + (at.1 - 4.0 + 3.0 * 2f64.cos()).abs() < 1e-12
        );
    }

    #[test]
    fn steps_are_written_in_turn() {
        let mut path = Path::through([(0.0, 0.0), (1.0, 2.0)]);
        path.curve((1.0, 3.0), (2.0, 4.0), (3.0, 4.0));
        path.start((9.0, 9.0));
        path.line((8.0, 9.0));
        path.close();
        assert_eq!(path.to_string(), "M0 0L1 2C1 3 2 4 3 4M9 9L8 9Z");
        assert_eq!(Path::rectangle((0.0, 1.0), (2.0, 3.0)).to_string(), "M0 1L2 1L2 3L0 3Z");
        assert_eq!(Path::through([]).to_string(), "");
    }
}
