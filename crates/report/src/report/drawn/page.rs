//! The page of a map: its frame with the axes, and what is said below.

use super::canvas::Canvas;
use super::plane::{FRICTION_LABEL, Plane, friction_ticks};
use crate::picture::color::INK;
use crate::picture::{Anchor, Frame, FrameSide, Point, Stroke, Svg, Type, text};

/// The frame of a map, and the lines below it.
pub(super) struct Page {
    pub frame: Frame,
    canvas: Canvas,
    lines: Vec<String>,
}

/// The frame on the page, and the page around it.
pub(super) const SIZE: Point = (760.0, 610.0);
const LEFT: f64 = 88.0;
const BELOW: f64 = 80.0;
const MARGIN: f64 = 20.0;
/// Space where there is an axis of friction, and where there is none.
const AXIS: f64 = 76.0;
const NO_AXIS: f64 = 40.0;
/// Space above, where levels end.
const LEVELS: f64 = 92.0;
/// Sizes of fonts.
const LABEL: f64 = 18.0;
const TICK: f64 = 16.0;
const SMALL: f64 = 15.0;

impl Page {
    /// An empty page with a title for those who do not see it, and paragraphs to stand below; there may be room for the
    /// values of levels where these end.
    pub(super) fn new(canvas: &Canvas, title: &str, words: &[String], levels: bool) -> (Self, Svg) {
        let [x, y] = &canvas.axes;
        let room = |is_friction| if is_friction { AXIS } else { NO_AXIS };
        let ends_above = canvas.plane != Plane::ThicknessFriction;
        let top = match levels && ends_above {
            true => LEVELS,
            false => room(x.is_friction_angle()),
        };
        let frame = Frame { corner: (LEFT, top), size: SIZE, x: x.range, y: y.range };
        let has_axis = y.is_friction_angle() || (levels && !ends_above);
        let right = room(has_axis) + MARGIN;
        let width = frame.right() + right;
        let wrapped = |words: &String| text::wrap(words, SMALL, width - 2.0 * MARGIN);
        let lines: Vec<String> = words.iter().flat_map(wrapped).collect();
        let height = frame.bottom() + BELOW + lines.len() as f64 * SMALL * text::LEADING + MARGIN;
        let svg = Svg::new((width, height), title, &words.join(" "));
        (Self { frame, canvas: *canvas, lines }, svg)
    }

    /// The frame with its axes and the words below.
    pub(super) fn draw(&self, svg: &mut Svg) {
        svg.stroke(&self.frame.outline(), Stroke::new(INK, 1.4));
        svg.group("axes", |svg| self.axes(svg));
        let below = (MARGIN, self.frame.bottom() + BELOW);
        svg.group("caption", |svg| svg.lines(&self.lines, below, Type::new(SMALL, INK)));
    }

    fn axes(&self, svg: &mut Svg) {
        let (frame, [x, y]) = (&self.frame, &self.canvas.axes);
        let style = Type::new(LABEL, INK).at(Anchor::Middle);
        let (across, up) = (frame.corner.0 + SIZE.0 / 2.0, frame.corner.1 + SIZE.1 / 2.0);
        frame.ticks(svg, FrameSide::Bottom, &x.ticks(x.range, None), TICK);
        frame.ticks(svg, FrameSide::Left, &y.ticks(y.range, None), TICK);
        svg.text(x.label, (across, frame.bottom() + 49.0), style);
        svg.text(y.label, (frame.corner.0 - 58.0, up), style.turned(-90.0));
        if x.is_friction_angle() {
            frame.ticks(svg, FrameSide::Top, &friction_ticks(x), TICK);
            svg.text(FRICTION_LABEL, (across, frame.corner.1 - 46.0), style);
        }
        if y.is_friction_angle() {
            frame.ticks(svg, FrameSide::Right, &friction_ticks(y), TICK);
            svg.text(FRICTION_LABEL, (frame.right() + 70.0, up), style.turned(-90.0));
        }
    }
}
