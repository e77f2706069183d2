//! Content of a map, in its frame or in an inset.

use super::asymmetric::AsymmetricLines;
use super::canvas::Canvas;
use super::chain::{Chain, larger};
use super::plane::{Plane, PlaneAxis};
use super::sheet::Sheet;
use super::{domain, look};
use crate::atlas::{Contour, Curve, Level};
use crate::picture::{Frame, Point, Svg};
use crate::problem::{Landmark, Mode};

/// The domains, lines and landmarks of one weight in a plane.
pub(super) struct PlaneContent {
    /// The domains that are areas, with the way around each.
    pub areas: Vec<(Mode, Chain)>,
    /// The lines around them.
    pub lines: Vec<(Curve, Chain)>,
    /// The levels.
    pub levels: Vec<(Contour, Chain)>,
    /// Overturning, at unlimited friction.
    pub edge: Option<Chain>,
    /// Reach of asymmetric branches.
    pub asymmetric: Option<AsymmetricLines>,
    /// The landmarks.
    pub landmarks: Vec<(Landmark, Point)>,
    /// Canvas on which all this is.
    pub canvas: Canvas,
}

/// The lines between domains, and the limit.
pub(super) fn lines() -> impl Iterator<Item = Curve> {
    let is_line = |curve: &Curve| matches!(curve, Curve::Line(_) | Curve::Limit);
    Curve::ALL.into_iter().filter(is_line)
}

/// The name of the group of a domain: `domain-rrs`.
pub(super) fn domain_id(mode: Mode) -> String {
    "domain-".chars().chain(mode.label().chars().filter(char::is_ascii_alphabetic)).collect()
}

/// The name of the group of a level.
pub(super) fn level_id(contour: &Contour) -> String {
    format!("level-{}", contour.to_string().replace([' ', '/'], "-"))
}

impl PlaneContent {
    /// Content of the curves of a weight on a canvas.
    pub(super) fn new(sheet: &Sheet, canvas: &Canvas) -> Self {
        let chain = |curve| sheet.chain(curve, canvas);
        let area = |mode| Some((mode, domain::around(mode, canvas, chain)?));
        // Below these nothing stands.
        let ends: &[Curve] = match canvas.plane {
            Plane::OpeningThickness => &[Curve::Rotation, Curve::Overturning],
            _ => &[],
        };
        let lines = lines().chain(ends.iter().copied());
        let level =
            |level: &&Level| Some((level.contour.clone(), Chain::of_level(level, &canvas.axes)?));
        Self {
            areas: Mode::ALL.into_iter().filter_map(area).collect(),
            lines: lines.filter_map(|curve| Some((curve, chain(curve)?))).collect(),
            levels: sheet.levels.iter().filter_map(level).collect(),
            edge: chain(Curve::Overturning),
            asymmetric: AsymmetricLines::new(sheet, canvas),
            landmarks: sheet.landmarks(canvas),
            canvas: *canvas,
        }
    }

    /// All lines but the edge.
    pub(super) fn chains(&self) -> impl Iterator<Item = &Chain> {
        let lines = self.lines.iter().map(|(_, chain)| chain);
        let levels = self.levels.iter().map(|(_, chain)| chain);
        lines.chain(levels).chain(self.asymmetric.iter().flat_map(AsymmetricLines::chains))
    }

    /// Distance that a line that a frame shows may have from the truth, along each axis.
    pub(super) fn off(&self, frame: &Frame) -> [(PlaneAxis, f64); 2] {
        let off = self.chains().map(|chain| chain.off(frame)).fold([0.0; 2], larger);
        [0, 1].map(|k| (self.canvas.axes[k], off[k]))
    }

    /// Place of a landmark.
    pub(super) fn of(&self, landmark: Landmark) -> Option<Point> {
        self.landmarks.iter().find(|(of, _)| *of == landmark).map(|(_, at)| *at)
    }

    /// Areas and lines; `of` sets the names of the groups of an inset apart.
    pub(super) fn draw(&self, svg: &mut Svg, frame: &Frame, of: &str) {
        for (mode, way) in &self.areas {
            let id = format!("{of}{}", domain_id(*mode));
            svg.group(&id, |svg| look::fill(svg, *mode, &domain::area(way, frame)));
        }
        if let Some(asymmetric) = &self.asymmetric {
            asymmetric.fill(svg, frame, of);
        }
        for (contour, chain) in &self.levels {
            let id = format!("{of}{}", level_id(contour));
            svg.group(&id, |svg| chain.draw(svg, frame, look::LEVEL));
        }
        for (curve, chain) in &self.lines {
            let id = format!("{of}line-{}", curve.to_string().replace('/', "-"));
            svg.group(&id, |svg| chain.draw(svg, frame, look::DIVIDE));
        }
        if let Some(asymmetric) = &self.asymmetric {
            asymmetric.draw(svg, frame, of);
        }
        if let (Some(edge), true) = (&self.edge, self.canvas.plane != Plane::OpeningThickness) {
            let id = format!("{of}{}", domain_id(Mode::Overturning));
            svg.group(&id, |svg| svg.stroke(&edge.paths(frame)[0], look::EDGE));
        }
    }
}
