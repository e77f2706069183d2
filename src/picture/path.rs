//! Straight and curved lines.

use std::fmt;

/// A coordinate of a path is written to this of the unit.
pub const ROUNDED: f64 = 0.001;

/// To the right and down, in units of the picture.
pub type Point = (f64, f64);

/// A chain of straight lines and cubic Bézier curves, in one piece or several.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path(Vec<Step>);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Step {
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
            path.0.push(if k == 0 { Step::Move(point) } else { Step::Line(point) });
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
        self.0.push(Step::Move(at));
    }

    /// Goes on straight.
    pub fn line(&mut self, to: Point) {
        self.0.push(Step::Line(to));
    }

    /// Goes on along a cubic Bézier curve.
    pub fn curve(&mut self, first_handle: Point, second_handle: Point, to: Point) {
        self.0.push(Step::Curve(first_handle, second_handle, to));
    }

    /// Ends a piece where it began.
    pub fn close(&mut self) {
        self.0.push(Step::Close);
    }
}

/// As the attribute `d` of SVG has it.
impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pair = |(x, y): Point| format!("{} {}", Short(x), Short(y));
        for step in &self.0 {
            match *step {
                Step::Move(to) => write!(f, "M{}", pair(to))?,
                Step::Line(to) => write!(f, "L{}", pair(to))?,
                Step::Curve(a, b, to) => write!(f, "C{} {} {}", pair(a), pair(b), pair(to))?,
                Step::Close => f.write_str("Z")?,
            }
        }
        Ok(())
    }
}

/// A length to the nearest thousandth, as short as it goes.
pub(super) struct Short(pub(super) f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:.3}", self.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
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
