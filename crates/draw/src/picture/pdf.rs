//! SVG as a page of PDF, its letters embedded.

use super::print::Print;
use super::tree::tree;
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, TextStr};
use std::collections::HashMap;
use std::io;
use svg2pdf::ConversionOptions;

/// Points in a pixel of the web, in which the reader of SVG counts.
const POINTS: f32 = 72.0 / 96.0;
const PICTURE: Name = Name(b"P");

/// A picture that [`Svg`](super::Svg) wrote, as a PDF file of its size that tells its title and its words.
pub fn render(svg: &str, print: &Print) -> io::Result<Vec<u8>> {
    let tree = tree(svg, print)?;
    let (chunk, picture) = svg2pdf::to_chunk(&tree, ConversionOptions::default())
        .map_err(|error| io::Error::other(format!("{error:?}")))?;
    let mut free = Ref::new(1);
    let [catalog, pages, page, content, info] = [(); 5].map(|()| free.bump());
    let mut numbers = HashMap::new();
    let mut number = |old| *numbers.entry(old).or_insert_with(|| free.bump());
    let (picture, chunk) = (number(picture), chunk.renumber(number));
    let mut file = Pdf::new();
    file.catalog(catalog).pages(pages);
    file.pages(pages).kids([page]).count(1);
    let [width, height] = [tree.size().width(), tree.size().height()].map(|size| size * POINTS);
    let mut sheet = file.page(page);
    sheet.media_box(Rect::new(0.0, 0.0, width, height)).parent(pages).contents(content);
    sheet.resources().x_objects().pair(PICTURE, picture);
    sheet.finish();
    let mut drawn = Content::new();
    drawn.transform([width, 0.0, 0.0, height, 0.0, 0.0]).x_object(PICTURE);
    file.stream(content, &drawn.finish());
    file.extend(&chunk);
    let made_by = concat!("couplet ", env!("CARGO_PKG_VERSION"));
    let mut told = file.document_info(info);
    told.title(TextStr(&within(svg, "title"))).subject(TextStr(&within(svg, "desc")));
    told.creator(TextStr(made_by)).producer(TextStr("svg2pdf"));
    told.finish();
    Ok(file.finish())
}

/// The words between the first tags of a name.
fn within(svg: &str, tag: &str) -> String {
    let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
    let words = svg.split_once(&open).and_then(|(_, rest)| rest.split_once(&close));
    plain(words.map_or("", |(words, _)| words))
}

/// A text of SVG without what is escaped in it.
fn plain(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Svg, Type, color};

    /// The table of objects is where the file says it is, and the title is that of the picture.
    #[test]
    fn a_page_has_a_title() {
        let mut svg = Svg::new((90.0, 40.0), "η < 1", "Words.");
        svg.text("η", (20.0, 20.0), Type::new(14.0, color::INK).on(color::WHITE));
        let file = render(&svg.finish(), &Print::default()).unwrap();
        let text = String::from_utf8_lossy(&file);
        assert!(text.contains("/Title <FEFF03B70020003C00200031>"), "{text}");
        assert!(text.contains("/Subject (Words.)") && text.contains("/Creator (couplet "));
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
