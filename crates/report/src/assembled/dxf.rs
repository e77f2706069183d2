//! Bodies as DXF: closed outlines with the arcs of the ring, centroids, and the question.

use super::assembly::Assembled;
use crate::picture::{Anchor, dxf::DxfFile};
use crate::problem::measures::LengthUnit;
use crate::strategies::Point;

/// The layers and their colours by number.
const LAYERS: [(&str, u8); 4] = [("STONES", 7), ("SUPPORTS", 8), ("CENTROIDS", 1), ("TEXT", 7)];
/// Radius of the mark of a centroid, and height of letters, as parts of the radius.
const MARK: f64 = 0.005;
const LETTERS: f64 = 0.05;

/// A file of DXF.
pub fn dxf(of: &Assembled) -> String {
    let unit = (of.unit() == "m").then_some(LengthUnit::Metre);
    let mut dxf = DxfFile::new((unit, 1.0), &LAYERS, &[]);
    dxf.draw();
    for stone in &of.blocks.stones {
        dxf.arcs("STONES", &sector(&stone.polygon), true);
        dxf.circle("CENTROIDS", stone.centroid, MARK * of.blocks.radius);
    }
    of.blocks.supports.iter().for_each(|ground| dxf.arcs("SUPPORTS", &sector(ground), true));
    let letters = LETTERS * of.blocks.radius;
    dxf.text("TEXT", &of.line(), ([0.0, -letters], Anchor::Middle), (letters, 0.0));
    dxf.finish()
}

/// Corners with the arcs at the extrados, after the second, and at the intrados, after the last.
fn sector(polygon: &[Point; 4]) -> [(Point, f64); 4] {
    let [right, above, _, left] = *polygon;
    let turned = |[x, y]: Point, [u, v]: Point| (x * v - y * u).atan2(x * u + y * v);
    // The intrados may be the centre.
    let bulge = (turned(above, polygon[2]) / 4.0).tan();
    [(right, 0.0), (above, bulge), (polygon[2], 0.0), (left, -bulge)]
}
