//! SVG as a renderer reads it, with its letters.

use super::print::Print;
#[doc(hidden)]
pub use resvg;
use resvg::usvg::fontdb::{Database, Family, Query};
use resvg::usvg::{Options, Tree};
use std::io;

static FONT: &[u8] = include_bytes!("../../assets/DejaVuSans.ttf");

/// Tree of an SVG as the program itself writes it, in the family of letters asked for or in the program's own; a
/// family that is not on this machine is refused.
pub fn tree(svg: &str, print: &Print) -> io::Result<Tree> {
    let mut options = Options { font_family: "DejaVu Sans".into(), ..Options::default() };
    let fonts = options.fontdb_mut();
    fonts.load_font_data(FONT.to_vec());
    if let Some(font) = &print.font {
        fonts.load_system_fonts();
        if !has(fonts, font.name()) {
            let message = format!(
                "no font '{}' is on this machine; svg names it without needing it",
                font.name()
            );
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
    }
    Tree::from_str(svg, &options).map_err(io::Error::other)
}

fn has(fonts: &Database, name: &str) -> bool {
    let query = Query { families: &[Family::Name(name)], ..Query::default() };
    fonts.query(&query).is_some()
}
