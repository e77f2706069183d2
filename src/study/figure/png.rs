//! SVG as pixels.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

static FONT: &[u8] = include_bytes!("../../../assets/DejaVuSans.ttf");

/// What the program itself writes, with its font, as a tree.
pub(super) fn tree(svg: &str) -> Tree {
    let mut options = Options { font_family: "DejaVu Sans".into(), ..Options::default() };
    options.fontdb_mut().load_font_data(FONT.to_vec());
    Tree::from_str(svg, &options).expect("the figure is well formed")
}

/// The picture as a PNG file.
pub(super) fn render(svg: &str) -> Vec<u8> {
    let tree = tree(svg);
    let size = tree.size().to_int_size();
    let mut pixels = Pixmap::new(size.width(), size.height()).expect("a figure is not empty");
    resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
    pixels.encode_png().expect("memory takes everything")
}
