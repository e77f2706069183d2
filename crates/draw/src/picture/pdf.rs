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
    let file = svg2pdf::to_pdf(&tree, ConversionOptions::default(), PageOptions { dpi: WEB })
        .map_err(|error| io::Error::other(format!("{error:?}")))?;
    told(file, svg).ok_or_else(|| io::Error::other("a page without a description"))
}

/// The end of the last object of a page, which says what made it.
const MADE_BY: &[u8] = b"/Producer (svg2pdf)";

/// A page that tells its title and its words, as the picture has them. What stands in the last object moves none of
/// those before it, and of those behind the table alone.
fn told(mut file: Vec<u8>, svg: &str) -> Option<Vec<u8>> {
    let last = |file: &[u8], of: &[u8]| file.windows(of.len()).rposition(|part| part == of);
    let of = |tag: &str| {
        let (_, rest) = svg.split_once(&format!("<{tag}>"))?;
        Some(plain(rest.split_once(&format!("</{tag}>"))?.0))
    };
    let entry = |(key, words): (&str, String)| {
        let code: String = words.encode_utf16().map(|unit| format!("{unit:04X}")).collect();
        format!("/{key} <FEFF{code}> ")
    };
    let made = ("Creator", format!("couplet {}", env!("CARGO_PKG_VERSION")));
    let all = [("Title", of("title")), ("Subject", of("desc"))];
    let all = all.into_iter().filter_map(|(key, words)| Some((key, words?)));
    let more: String = all.chain([made]).map(entry).collect();
    let at = last(&file, MADE_BY)?;
    file.splice(at..at, more.bytes());
    let from = last(&file, b"startxref")? + b"startxref".len();
    let place = last(&file[..from], b"xref\n0 ")?;
    file.truncate(from);
    file.extend(format!("\n{place}\n%%EOF").bytes());
    Some(file)
}

/// A text of SVG without what is escaped in it.
fn plain(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Svg, Type, color};

    /// The table of objects is where the file says it is, and its title is that of the picture.
    #[test]
    fn a_page_has_a_title() {
        let mut svg = Svg::new((90.0, 40.0), "η < 1", "Words.");
        svg.text("η", (20.0, 20.0), Type::new(14.0, color::INK).on(color::WHITE));
        let file = render(&svg.finish(), &Print::default()).unwrap();
        let text = String::from_utf8_lossy(&file);
        assert!(
            text.contains("/Title <FEFF03B70020003C00200031>")
                && text.contains("/Subject <FEFF0057")
        );
        let place = text.rsplit("startxref").next().unwrap().split_whitespace().next().unwrap();
        let table = &file[place.parse::<usize>().unwrap()..];
        assert!(table.starts_with(b"xref\n0 "));
        let rows = String::from_utf8_lossy(table).into_owned();
        for row in rows.lines().skip(3).take_while(|row| row.ends_with("n ") || row.ends_with('n'))
        {
            let at: usize = row.split(' ').next().unwrap().parse().unwrap();
            assert!(String::from_utf8_lossy(&file[at..at + 12]).contains(" 0 obj"), "{row}");
        }
    }
}
