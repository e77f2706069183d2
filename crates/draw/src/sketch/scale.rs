//! Scale from units of `r` to the page.

use crate::picture::{Path, Point};

/// Scale: the place of the centre of an arch on the page, and how large the radius is.
#[derive(Clone, Copy, Debug)]
pub struct PageScale {
    /// The centre of the centreline.
    pub center: Point,
    /// The radius of the centreline.
    pub radius: f64,
}

/// A point to the right and up of the centre, by its joint and radius.
pub fn polar(joint: f64, radius: f64) -> [f64; 2] {
    [radius * joint.sin(), radius * joint.cos()]
}

/// The radii of the intrados and the extrados, in units of `r`.
pub fn faces(thickness: f64) -> [f64; 2] {
    [1.0 - thickness / 2.0, 1.0 + thickness / 2.0]
}

impl PageScale {
    /// A point to the right and up of the centre; `side` is -1 for the left half. To a hundredth of the page's
    /// unit, which no eye sees and files are shorter by.
    pub fn at(&self, [x, y]: [f64; 2], side: f64) -> Point {
        let to = |length: f64| (100.0 * length).round() / 100.0;
        (to(self.center.0 + side * self.radius * x), to(self.center.1 - self.radius * y))
    }

    /// A point by its joint and radius.
    pub fn polar(&self, joint: f64, radius: f64, side: f64) -> Point {
        self.at(polar(joint, radius), side)
    }

    /// The part of a ring between two joints, once round.
    pub fn sector(&self, [from, to]: [f64; 2], [inner, outer]: [f64; 2], side: f64) -> Path {
        let mut path = Path::default();
        path.start(self.polar(from, outer, side));
        path.arc(self.center, self.radius * outer, [side * from, side * to]);
        path.line(self.polar(to, inner, side));
        if inner > 0.0 {
            path.arc(self.center, self.radius * inner, [side * to, side * from]);
        }
        path.close();
        path
    }

    /// Joints that divide a part of a ring.
    pub fn joints(&self, joints: &[f64], [inner, outer]: [f64; 2], side: f64) -> Path {
        let mut path = Path::default();
        for joint in joints {
            path.start(self.polar(*joint, inner, side));
            path.line(self.polar(*joint, outer, side));
        }
        path
    }
}
