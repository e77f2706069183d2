//! SVG as a page of PDF, its letters embedded.

use super::print::Print;
use super::tree::tree;
use std::io;
use svg2pdf::{ConversionOptions, PageOptions};

/// Pixels of the web in an inch: what the reader of SVG counts in, and a page in points.
const WEB: f32 = 96.0;

/// A picture that [`Svg`](super::Svg) wrote, as a PDF file of its size.
pub fn render(svg: &str, print: &Print) -> io::Result<Vec<u8>> {
    let tree = tree(svg, print)?;
    svg2pdf::to_pdf(&tree, ConversionOptions::default(), PageOptions { dpi: WEB })
        .map_err(|error| io::Error::other(format!("{error:?}")))
}
