//! Readings of a picture, for tests: of this crate, and of others that draw.

/// The texts of a document, if its tags are closed in order, its attributes quoted, and nothing is
/// left unescaped.
pub(crate) fn texts(svg: &str) -> Option<Vec<String>> {
    let plain = |text: &str| {
        text.split('&').skip(1).all(|rest| {
            ["lt;", "gt;", "amp;", "quot;", "apos;"].iter().any(|name| rest.starts_with(name))
        })
    };
    let (mut open, mut texts) = (Vec::new(), Vec::new());
    for piece in svg.split('<').skip(1) {
        let (tag, text) = piece.split_once('>')?;
        if let Some(name) = tag.strip_prefix('/') {
            (open.pop()? == name).then_some(())?;
        } else {
            let (name, attributes) = tag.trim_end_matches('/').split_once(' ').unwrap_or((tag, ""));
            let mut quoted = attributes.split('"');
            while let Some(key) = quoted.next().filter(|key| !key.trim().is_empty()) {
                (key.ends_with('=') && plain(quoted.next()?)).then_some(())?;
            }
            if !tag.ends_with('/') {
                open.push(name);
            }
        }
        plain(text).then_some(())?;
        if !text.trim().is_empty() {
            texts.push(text.trim().to_owned());
        }
    }
    open.is_empty().then_some(texts)
}

#[test]
fn what_is_not_well_formed_is_refused() {
    assert!(texts("<svg a=\"1\"><text b=\"2\">x</svg></text>").is_none());
    assert!(texts("<svg a=\"1\">x & y</svg>").is_none());
    assert!(texts("<svg a=1>x</svg>").is_none());
    assert_eq!(texts("<svg a=\"1\"><g><b c=\"\"/>x</g></svg>").unwrap(), ["x"]);
}

/// Boxes of the texts of a document, with the page.
#[cfg(feature = "plots")]
pub(crate) mod boxes {
    use crate::picture::png::resvg::tiny_skia::Rect;
    use crate::picture::png::resvg::usvg::{Group, Node};
    use crate::picture::png::tree;

    fn boxes(group: &Group) -> Vec<(String, Rect)> {
        let of = |node: &Node| match node {
            Node::Group(group) => boxes(group),
            Node::Text(text) => {
                let words = text.chunks().iter().map(|chunk| chunk.text());
                vec![(words.collect(), text.abs_bounding_box())]
            }
            _ => Vec::new(),
        };
        group.children().iter().flat_map(of).collect()
    }

    /// The first text that leaves the page or lies on another.
    pub(crate) fn trouble(svg: &str) -> Option<String> {
        let tree = tree(svg);
        let page = tree.size();
        let boxes = boxes(tree.root());
        for (k, (text, one)) in boxes.iter().enumerate() {
            let within = one.left() >= 0.0
                && one.top() >= 0.0
                && one.right() <= page.width()
                && one.bottom() <= page.height();
            if !within {
                return Some(format!("{text:?} leaves the page: {one:?}"));
            }
            // The boxes are as high as the font, its accents included: 1.17 sizes.
            let flat = |rect: &Rect| {
                let least = rect.height().min(rect.width());
                rect.inset(
                    0.12 * least * f32::from(rect.width() < rect.height()),
                    0.12 * least * f32::from(rect.width() >= rect.height()),
                )
            };
            let flat = flat(one)?;
            if let Some((other, _)) = boxes[..k].iter().find(|(_, b)| flat.intersect(b).is_some()) {
                return Some(format!("{text:?} lies on {other:?}"));
            }
        }
        None
    }
}
