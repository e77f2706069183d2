//! Request for a map: what is to be shown, and whether it goes together: for the command and for a scene.

use crate::arch::SelfWeight;
use crate::atlas::{Contour, Curve};
use crate::report::Format;
use crate::{Axes, Marked, Plane};

/// Request for a map.
pub struct MapAsked {
    /// Format in which it is written.
    pub format: &'static Format,
    /// The weights.
    pub weights: Vec<SelfWeight>,
    /// The curves that are named.
    pub curves: Vec<Curve>,
    /// The levels that are named.
    pub contours: Vec<Contour>,
    /// The plane, if one is named.
    pub plane: Option<Plane>,
    /// True if the lines alone are named.
    pub lines: bool,
    /// True if there are no levels.
    pub bare: bool,
    /// True if there are asymmetric branches.
    pub asymmetric: bool,
    /// Ranges and units in which the quantities are shown.
    pub axes: Axes,
    /// The arches that are marked.
    pub marks: Vec<Marked>,
    /// The largest half-width of a tube.
    pub tolerance: f64,
}

impl MapAsked {
    /// The plane: the usual one, if none is named.
    pub fn plane(&self) -> Plane {
        self.plane.unwrap_or(Plane::ThicknessFriction)
    }

    /// Misfit of an option: one that has no effect or no sense beside the rest, in the words of who asks:
    /// `key` says what he calls an option.
    pub fn misfit(&self, key: fn(&str) -> String) -> Option<String> {
        let (is_picture, is_page) = (self.format.is_picture, self.format.is_page());
        let (plane, has_axes) = (self.plane(), self.axes != Axes::default());
        let is_drawn_otherwise = self.plane.is_some() || self.lines || self.bare;
        let has_contours = !self.contours.is_empty();
        let is_over_opening = is_picture && plane == Plane::OpeningFriction;
        let crosses = self.contours.iter().all(|contour| plane.is_crossed_by(contour));
        let [curve, over, lines, bare, weight, asymmetric, mark, friction] =
            ["curve", "plane", "lines", "bare", "weight", "asymmetric", "mark", "friction"]
                .map(key);
        let levels = ["half_opening", "thickness"].map(key).join(", ");
        let axes = plane.name().replace('-', " and ");
        Some(if is_page && (!self.curves.is_empty() || is_drawn_otherwise) {
            format!("a page shows the whole map; leave out {curve}, {over}, {lines} and {bare}")
        } else if !is_picture && is_drawn_otherwise {
            format!("{over}, {lines} and {bare} are for a picture, svg, png or pdf")
        } else if self.lines && plane != Plane::ThicknessFriction {
            format!("{lines} are drawn over thickness and friction; leave out {over}")
        } else if is_picture && !self.lines && self.weights.len() > 1 {
            format!("a map shows one {weight}; {lines} shows the lines of both")
        } else if self.lines && (self.bare || has_contours) {
            format!("{lines} are drawn alone; leave out {bare}, {levels} and {friction}")
        } else if self.bare && has_contours {
            format!("a map that is {bare} has no {levels} or {friction}")
        } else if is_picture && !crosses {
            format!("over {axes} lines of a {} are drawn", plane.contour_name())
        } else if self.asymmetric && (is_page || (is_picture && !is_over_opening)) {
            format!("{asymmetric} is drawn with {over} opening-friction, as svg, png or pdf")
        } else if !self.marks.is_empty() && (!(is_picture || is_page) || self.lines) {
            format!("for {mark} give a map as svg, png, pdf or html, without {lines}")
        } else if has_axes && (!is_picture || self.lines) {
            format!("units, ranges and a scale are for a map as svg, png or pdf, without {lines}")
        } else {
            return self.axes.misfit(plane);
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Map;
    use crate::report::Reported;

    /// Each that has no effect is refused, and none that has one.
    #[test]
    fn what_has_no_effect_is_refused() {
        let level: Contour = Contour::Friction("31deg".parse().unwrap());
        let levels = [level];
        for (name, plane, [lines, bare, level], expected) in [
            ("csv", None, [false, false, true], None),
            ("csv", None, [false, true, false], Some("are for a picture")),
            ("csv", None, [true, false, true], Some("are for a picture")),
            ("table", Some("opening-friction"), [false; 3], Some("are for a picture")),
            ("json", Some("thickness-friction"), [false; 3], Some("are for a picture")),
            ("html", None, [false; 3], None),
            ("html", None, [false, true, false], Some("a page shows the whole map")),
            ("svg", None, [true, false, false], None),
            ("svg", None, [true, true, false], Some("lines are drawn alone")),
            ("svg", None, [true, false, true], Some("lines are drawn alone")),
            ("svg", None, [false, true, true], Some("a map that is bare has no")),
            ("svg", None, [false, false, true], Some("lines of a half opening are drawn")),
            ("svg", Some("opening-thickness"), [false, false, true], None),
            ("svg", Some("opening-thickness"), [true, false, false], Some("leave out plane")),
        ] {
            let asked = MapAsked {
                format: Format::named(Map::content(), name).unwrap(),
                weights: vec![SelfWeight::Heyman],
                curves: Vec::new(),
                contours: levels[..usize::from(level)].to_vec(),
                plane: plane.and_then(Plane::named),
                lines,
                bare,
                asymmetric: false,
                axes: Axes::default(),
                marks: Vec::new(),
                tolerance: 1e-4,
            };
            let found = asked.misfit(str::to_owned);
            match expected {
                Some(words) => {
                    assert!(found.as_ref().is_some_and(|x| x.contains(words)), "{found:?}")
                }
                None => assert_eq!(found, None, "{name}"),
            }
        }
    }
}
