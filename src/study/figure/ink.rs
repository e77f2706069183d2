//! The colour, dashes and marker of a line.

use super::canvas::Canvas;
use super::{Kind, Line};
use plotters::style::{RGBColor, WHITE};

/// The colours of Okabe and Ito, which the colour-blind can tell apart, without the yellow.
const COLORS: [RGBColor; 7] = [
    RGBColor(0x00, 0x72, 0xB2),
    RGBColor(0xD5, 0x5E, 0x00),
    RGBColor(0x00, 0x9E, 0x73),
    RGBColor(0x00, 0x00, 0x00),
    RGBColor(0xCC, 0x79, 0xA7),
    RGBColor(0xE6, 0x9F, 0x00),
    RGBColor(0x56, 0xB4, 0xE9),
];
/// Lengths of strokes and gaps in turn. None is a whole line.
const DASHES: [&[f64]; 5] = [&[], &[9.0, 3.0], &[15.0, 3.0, 3.0, 3.0], &[4.0, 2.5], &[18.0, 5.0]];
const MARKERS: [Marker; 8] = [
    Marker::Disc,
    Marker::OpenSquare,
    Marker::Triangle,
    Marker::OpenDiamond,
    Marker::Cross,
    Marker::Square,
    Marker::OpenTriangle,
    Marker::Ring,
];
/// References, in turn.
const REFERENCES: [(RGBColor, &[f64]); 3] = [
    (RGBColor(0x77, 0x77, 0x77), &[7.0, 5.0]),
    (RGBColor(0x77, 0x77, 0x77), &[2.0, 4.0]),
    (RGBColor(0x77, 0x77, 0x77), &[12.0, 4.0, 2.0, 4.0]),
];

#[derive(Clone, Copy, PartialEq)]
enum Marker {
    Disc,
    OpenSquare,
    Triangle,
    OpenDiamond,
    Cross,
    Square,
    OpenTriangle,
    Ring,
}

/// How a line looks.
#[derive(Clone, Copy)]
pub(super) struct Ink {
    color: RGBColor,
    dashes: &'static [f64],
    marker: Option<Marker>,
    width: f64,
    /// From 0 to 1, different for lines that may lie on each other.
    pub phase: f64,
}

/// The ink of every label of a figure.
pub(super) struct Inks<'a> {
    references: Vec<&'a str>,
    others: Vec<&'a str>,
}

impl<'a> Inks<'a> {
    /// One for each label, in the order in which they come up.
    pub(super) fn new(lines: impl Iterator<Item = &'a Line>) -> Self {
        let mut inks = Self { references: Vec::new(), others: Vec::new() };
        for line in lines {
            let labels = match line.kind {
                Kind::Reference => &mut inks.references,
                Kind::Measured | Kind::Steps => &mut inks.others,
            };
            if !labels.contains(&line.label.as_str()) {
                labels.push(&line.label);
            }
        }
        inks
    }

    /// That of a line of the figure.
    pub(super) fn of(&self, line: &Line) -> Ink {
        let turn = |labels: &[&str]| {
            labels.iter().position(|label| *label == line.label).expect("a line of the figure")
        };
        if line.kind == Kind::Reference {
            let (color, dashes) = REFERENCES[turn(&self.references) % REFERENCES.len()];
            return Ink { color, dashes, marker: None, width: 1.8, phase: 0.0 };
        }
        // The lengths have no common factor: together they repeat after 280 lines.
        let turn = turn(&self.others);
        Ink {
            color: COLORS[turn % COLORS.len()],
            dashes: DASHES[turn % DASHES.len()],
            marker: Some(MARKERS[turn % MARKERS.len()]),
            width: 2.2,
            phase: (turn as f64 * 0.618).fract(),
        }
    }
}

impl Ink {
    /// A line through points.
    pub(super) fn stroke(&self, canvas: &Canvas, points: &[(f64, f64)]) {
        for dash in dashed(points, self.dashes) {
            canvas.stroke(&dash, self.color, self.width);
        }
    }

    /// The marker at a point, if the line has one.
    pub(super) fn mark(&self, canvas: &Canvas, (x, y): (f64, f64)) {
        let Some(marker) = self.marker else { return };
        let at = |corners: &[(f64, f64)]| -> Vec<(f64, f64)> {
            corners.iter().map(|(dx, dy)| (x + dx, y + dy)).collect()
        };
        let open = |corners: &[(f64, f64)]| {
            let mut outline = at(corners);
            canvas.fill(&outline, WHITE);
            // Once round and a little further, so that the first corner looks like the others.
            outline.extend_from_within(..2);
            canvas.stroke(&outline, self.color, 1.6);
        };
        match marker {
            Marker::Disc => canvas.disc((x, y), 4.2, self.color),
            Marker::Ring => {
                canvas.disc((x, y), 4.8, self.color);
                canvas.disc((x, y), 3.2, WHITE);
            }
            Marker::Square => canvas.fill(&at(&square(3.9)), self.color),
            Marker::OpenSquare => open(&square(3.6)),
            Marker::Triangle => canvas.fill(&at(&triangle(5.6)), self.color),
            Marker::OpenTriangle => open(&triangle(-5.2)),
            Marker::OpenDiamond => open(&[(0.0, -5.2), (4.6, 0.0), (0.0, 5.2), (-4.6, 0.0)]),
            Marker::Cross => {
                canvas.stroke(&at(&[(-3.8, -3.8), (3.8, 3.8)]), self.color, 2.2);
                canvas.stroke(&at(&[(-3.8, 3.8), (3.8, -3.8)]), self.color, 2.2);
            }
        }
    }
}

fn square(half: f64) -> [(f64, f64); 4] {
    [(-half, -half), (half, -half), (half, half), (-half, half)]
}

/// With the tip up; down for a negative size.
fn triangle(size: f64) -> [(f64, f64); 3] {
    [(0.0, -size), (0.9 * size, 0.6 * size), (-0.9 * size, 0.6 * size)]
}

/// The strokes of a line; `pattern` gives the lengths of strokes and gaps in turn.
fn dashed(points: &[(f64, f64)], pattern: &[f64]) -> Vec<Vec<(f64, f64)>> {
    if pattern.is_empty() || points.is_empty() {
        return vec![points.to_vec()];
    }
    let mut strokes = vec![vec![points[0]]];
    let (mut turn, mut left) = (0, pattern[0]);
    for pair in points.windows(2) {
        let [(mut x, mut y), end] = [pair[0], pair[1]];
        loop {
            let (dx, dy) = (end.0 - x, end.1 - y);
            let way = dx.hypot(dy);
            let on = turn % 2 == 0;
            if way < left {
                left -= way;
                if on {
                    strokes.last_mut().expect("there is one").push(end);
                }
                break;
            }
            (x, y) = (x + dx * left / way, y + dy * left / way);
            match on {
                true => strokes.last_mut().expect("there is one").push((x, y)),
                false => strokes.push(vec![(x, y)]),
            }
            turn += 1;
            left = pattern[turn % pattern.len()];
        }
    }
    strokes.retain(|stroke| stroke.len() > 1);
    strokes
}

#[cfg(test)]
mod tests {
    use super::dashed;

    #[test]
    fn dashes_go_round_corners() {
        let corner = [(0.0, 0.0), (3.0, 0.0), (3.0, 7.0)];
        let strokes = dashed(&corner, &[4.0, 2.0]);
        assert_eq!(
            strokes,
            [vec![(0.0, 0.0), (3.0, 0.0), (3.0, 1.0)], vec![(3.0, 3.0), (3.0, 7.0)]]
        );
        assert_eq!(dashed(&corner, &[]), [corner.to_vec()]);
        assert!(dashed(&[], &[4.0, 2.0])[0].is_empty());
    }

    #[test]
    fn points_on_each_other_have_no_dashes() {
        assert!(dashed(&[(1.0, 1.0); 5], &[4.0, 2.0]).iter().all(|stroke| stroke.len() == 5));
    }
}
