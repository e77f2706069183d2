//! The room that an arch takes.

use std::f64::consts::FRAC_PI_2;

/// Smallest upright rectangle around what is drawn, in units of `r` from the centre.
#[derive(Clone, Copy, Debug)]
pub struct Hull {
    /// The left end.
    pub left: f64,
    /// The right end.
    pub right: f64,
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl Hull {
    /// Around a whole arch of a half opening (rad) between the radii of its intrados and its extrados.
    pub fn of_ring(half_opening: f64, [inner, outer]: [f64; 2]) -> Self {
        let wide = if half_opening > FRAC_PI_2 { outer } else { outer * half_opening.sin() };
        let low = (inner * half_opening.cos()).min(outer * half_opening.cos());
        Self { left: -wide, right: wide, low, high: outer }
    }

    /// Around a point too.
    pub fn with(self, [x, y]: [f64; 2]) -> Self {
        let Self { left, right, low, high } = self;
        Self { left: left.min(x), right: right.max(x), low: low.min(y), high: high.max(y) }
    }

    /// Around all of some; around half a circle where there is none.
    pub fn around(all: impl Iterator<Item = Self>) -> Self {
        let both = |a: Self, b: Self| a.with([b.left, b.low]).with([b.right, b.high]);
        all.reduce(both).unwrap_or(Self { left: -1.0, right: 1.0, low: 0.0, high: 1.0 })
    }

    /// Distance between its left and its right end.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Halfway between them.
    pub fn middle(&self) -> f64 {
        (self.left + self.right) / 2.0
    }

    /// Distance between its lower and its upper end.
    pub fn height(&self) -> f64 {
        self.high - self.low
    }
}
