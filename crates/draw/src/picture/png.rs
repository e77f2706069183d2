//! SVG as pixels.

use super::print::Print;
use super::tree::tree;
use resvg::tiny_skia::{Pixmap, Transform};
use std::io;

/// Pixels of the web in an inch: what the reader of SVG counts in.
const WEB: f64 = 96.0;
/// The most pixels: of a sheet so large that it has more, each is larger.
const MOST: f64 = 1e8;

/// A picture that [`Svg`](super::Svg) wrote, as a PNG file.
pub fn render(svg: &str, print: &Print) -> io::Result<Vec<u8>> {
    let tree = tree(svg, print)?;
    let (width, height) = (tree.size().width(), tree.size().height());
    let area = f64::from(width) * f64::from(height);
    let scale = (print.resolution() / WEB).min((MOST / area).sqrt()) as f32;
    let pixels = |length: f32| (length * scale).round().max(1.0) as u32;
    let mut pixels = Pixmap::new(pixels(width), pixels(height)).expect("a picture is not empty");
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(io::Error::other)
}
