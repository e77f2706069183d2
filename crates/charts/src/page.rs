//! The page of a map: its frame with the axes, and what is said below.

use super::canvas::Canvas;
use super::plane::{FRICTION_LABEL, Plane, friction_ticks};
use crate::picture::color::INK;
use crate::picture::{Anchor, Frame, FrameSide, Page, Point, Print, Stroke, Svg, Type};
use std::io;

/// The frame of a map, and how wide the page around it is.
pub(super) struct MapPage<'a> {
    pub frame: Frame,
    canvas: Canvas,
    page: Page<'a>,
}

/// The frame on the page where no width is asked for, and its least width and height.
pub(super) const SIZE: Point = (760.0, 610.0);
const LEAST: Point = (220.0, 340.0);
const LEFT: f64 = 88.0;
/// Space below the frame, for its axis.
pub(super) const BELOW: f64 = 80.0;
/// Space where there is an axis of friction, and where there is none.
const AXIS: f64 = 76.0;
const NO_AXIS: f64 = 40.0;
/// Space above, where levels end.
const LEVELS: f64 = 92.0;
/// Sizes of fonts.
const LABEL: f64 = 18.0;
const TICK: f64 = 16.0;

impl<'a> MapPage<'a> {
    /// A page as it is printed; there may be room for the values of levels where these end.
    pub(super) fn new(canvas: &Canvas, levels: bool, print: &'a Print) -> io::Result<Self> {
        let [x, y] = &canvas.axes;
        let room = |is_friction| if is_friction { AXIS } else { NO_AXIS };
        let ends_above = canvas.plane != Plane::ThicknessFriction;
        let top = match levels && ends_above {
            true => LEVELS,
            false => room(x.is_friction_angle()),
        };
        let has_axis = y.is_friction_angle() || (levels && !ends_above);
        let around = LEFT + room(has_axis) + Page::MARGIN;
        let page = Page::new(print, SIZE.0 + around, LEAST.0 + around)?;
        let across = page.width - around;
        let size = (across, (across * SIZE.1 / SIZE.0).max(LEAST.1));
        let frame = Frame { corner: (LEFT, top), size, x: x.range, y: y.range };
        Ok(Self { frame, canvas: *canvas, page })
    }

    /// Tells whether the frame is narrower than usual, so that insets and legends stand below it.
    pub(super) fn is_narrow(&self) -> bool {
        self.frame.size.0 < SIZE.0
    }

    /// The page with a title for those who do not see it, the frame with its axes once what is in it is drawn, and
    /// paragraphs below, so far `down` from the frame.
    pub(super) fn svg(
        &self,
        title: &str,
        words: &[String],
        down: f64,
        draw: impl FnOnce(&mut Svg),
    ) -> Svg {
        self.page.svg(title, words, self.frame.bottom() + BELOW + down, |svg| {
            svg.clipped(&self.frame.outline(), draw);
            svg.stroke(&self.frame.outline(), Stroke::new(INK, 1.4));
            svg.group("axes", |svg| self.axes(svg));
        })
    }

    fn axes(&self, svg: &mut Svg) {
        let (frame, [x, y]) = (&self.frame, &self.canvas.axes);
        let style = Type::new(LABEL, INK).at(Anchor::Middle);
        let (across, up) =
            (frame.corner.0 + frame.size.0 / 2.0, frame.corner.1 + frame.size.1 / 2.0);
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
