//! SVG as pixels.

#[doc(hidden)]
pub use resvg;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

static FONT: &[u8] = include_bytes!("../../assets/DejaVuSans.ttf");

/// Pixels a unit of the picture: enough for print.
pub const FINE: f32 = 2.0;

/// Tree of an SVG as the program itself writes it, with its font.
#[doc(hidden)]
pub fn tree(svg: &str) -> Tree {
    let mut options = Options { font_family: "DejaVu Sans".into(), ..Options::default() };
    options.fontdb_mut().load_font_data(FONT.to_vec());
    Tree::from_str(svg, &options).expect("the picture is well formed")
}

/// A picture that [`Svg`](super::Svg) wrote, as a PNG file with [`FINE`] pixels a unit.
pub fn render(svg: &str) -> Vec<u8> {
    let tree = tree(svg);
    let size = tree.size();
    let pixels = |length: f32| (length * FINE).round() as u32;
    let mut pixels =
        Pixmap::new(pixels(size.width()), pixels(size.height())).expect("a picture is not empty");
    resvg::render(&tree, Transform::from_scale(FINE, FINE), &mut pixels.as_mut());
    pixels.encode_png().expect("memory takes everything")
}
