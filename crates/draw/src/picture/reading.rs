//! Readings of a picture, for tests: of this crate, and of others that draw.

use crate::picture::room::Rectangle;
use crate::picture::text::width;

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

/// The value of an attribute of a tag.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    tag.split_once(&format!(" {name}=\""))?.1.split('"').next()
}

/// Sizes of the fonts of a document.
pub(crate) fn sizes(svg: &str) -> Vec<f64> {
    let after = svg.split(" font-size=\"").skip(1);
    after.map(|rest| rest.split('"').next().unwrap().parse().unwrap()).collect()
}

/// The texts of a document with their boxes, as the layout of pictures has them: as high as capitals and descenders.
pub(crate) fn boxes(svg: &str) -> Vec<(String, Rectangle)> {
    let of = |piece: &str| {
        let (tag, text) = piece.split_once("</text>")?.0.split_once('>')?;
        let number = |name| attribute(tag, name)?.parse::<f64>().ok();
        let (x, y, size) = (number("x")?, number("y")?, number("font-size")?);
        let text = text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
        let long = width(&text, size);
        let left = match attribute(tag, "text-anchor") {
            Some("middle") => -long / 2.0,
            Some("end") => -long,
            _ => 0.0,
        };
        let turn = attribute(tag, "transform")
            .and_then(|of| of.strip_prefix("rotate(")?.split(' ').next()?.parse().ok());
        let (sin, cos) = turn.unwrap_or(0.0_f64).to_radians().sin_cos();
        let corners = [
            (left, -0.76 * size),
            (left + long, -0.76 * size),
            (left, 0.2 * size),
            (left + long, 0.2 * size),
        ];
        let corners =
            corners.map(|(along, up)| (x + along * cos - up * sin, y + along * sin + up * cos));
        let end = |pick: fn(f64, f64) -> f64| {
            corners.into_iter().reduce(|a, b| (pick(a.0, b.0), pick(a.1, b.1))).unwrap()
        };
        Some((text, [end(f64::min), end(f64::max)]))
    };
    svg.split("<text").skip(1).filter_map(of).collect()
}

/// The first text that leaves the page or lies on another.
pub(crate) fn trouble(svg: &str) -> Option<String> {
    let page: Vec<f64> =
        attribute(svg, "viewBox").unwrap().split(' ').map(|x| x.parse().unwrap()).collect();
    let boxes = boxes(svg);
    for (k, (text, [low, high])) in boxes.iter().enumerate() {
        if low.0 < 0.0 || low.1 < 0.0 || high.0 > page[2] || high.1 > page[3] {
            return Some(format!("{text:?} leaves the page: {low:?} {high:?}"));
        }
        let meets = |[a, b]: &Rectangle| low.0 < b.0 && a.0 < high.0 && low.1 < b.1 && a.1 < high.1;
        if let Some((other, _)) = boxes[..k].iter().find(|(_, of)| meets(of)) {
            return Some(format!("{text:?} lies on {other:?}"));
        }
    }
    None
}

#[test]
fn texts_off_the_page_and_on_others_are_found() {
    use crate::picture::{Anchor, Color, Svg, Type};
    let drawn = |places: &[((f64, f64), f64)]| {
        let mut svg = Svg::new((100.0, 100.0), "", "");
        let style = Type::new(10.0, Color(0, 0, 0)).at(Anchor::Middle);
        places.iter().for_each(|(at, turn)| svg.text("words", *at, style.turned(*turn)));
        trouble(&svg.finish())
    };
    assert_eq!(drawn(&[((50.0, 50.0), 0.0), ((50.0, 61.0), 0.0), ((10.0, 50.0), -90.0)]), None);
    for wrong in [
        &[((90.0, 50.0), 0.0)][..],
        &[((50.0, 2.0), 0.0)],
        &[((50.0, 90.0), -90.0)],
        &[((50.0, 50.0), 0.0), ((50.0, 58.0), 0.0)],
        &[((50.0, 50.0), 0.0), ((40.0, 50.0), 90.0)],
    ] {
        assert!(drawn(wrong).is_some(), "{wrong:?}");
    }
}

/// Texts and strokes of a document as a renderer has them.
#[cfg(feature = "plots")]
pub(crate) mod rendered {
    use crate::picture::print::Print;
    use crate::picture::tree::resvg::tiny_skia::{self, PathSegment, Rect};
    use crate::picture::tree::resvg::usvg::{Group, Node, Paint};
    use crate::picture::tree::tree;

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

    /// Points so close together on the strokes of a document, but for the pale ones of a grid, that no letter lies
    /// between two; each where its clip shows it.
    fn strokes(group: &Group, clip: Option<Rect>) -> Vec<(f32, f32)> {
        let clip = group.clip_path().map(|path| path.root().abs_bounding_box()).or(clip);
        let of = |node: &Node| match node {
            Node::Group(group) => strokes(group, clip),
            Node::Path(path) if path.stroke().is_some_and(|stroke| !is_pale(stroke.paint())) => {
                let transform = path.abs_transform();
                let data = path.data().clone().transform(transform);
                let points = data.as_ref().map(points).unwrap_or_default();
                let is_seen = |(x, y): &(f32, f32)| {
                    clip.is_none_or(|of| {
                        of.left() <= *x && *x <= of.right() && of.top() <= *y && *y <= of.bottom()
                    })
                };
                points.into_iter().filter(is_seen).collect()
            }
            _ => Vec::new(),
        };
        group.children().iter().flat_map(of).collect()
    }

    fn is_pale(paint: &Paint) -> bool {
        matches!(paint, Paint::Color(color) if color.red.min(color.green).min(color.blue) > 0xD0)
    }

    fn points(path: &tiny_skia::Path) -> Vec<(f32, f32)> {
        let (mut found, mut at) = (Vec::new(), (0.0, 0.0));
        for segment in path.segments() {
            let corners = match segment {
                PathSegment::MoveTo(to) => {
                    at = (to.x, to.y);
                    continue;
                }
                PathSegment::LineTo(to) => [at, at, (to.x, to.y), (to.x, to.y)],
                PathSegment::CubicTo(a, b, to) => [at, (a.x, a.y), (b.x, b.y), (to.x, to.y)],
                _ => continue,
            };
            let way: f32 = corners
                .windows(2)
                .map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1))
                .sum();
            let count = way.ceil().max(1.0);
            for k in 0..=count as u32 {
                let (t, u) = (k as f32 / count, 1.0 - k as f32 / count);
                let weights = [u * u * u, 3.0 * u * u * t, 3.0 * u * t * t, t * t * t];
                let sum = |of: fn(&(f32, f32)) -> f32| -> f32 {
                    corners.iter().zip(weights).map(|(corner, w)| w * of(corner)).sum()
                };
                found.push((sum(|p| p.0), sum(|p| p.1)));
            }
            at = corners[3];
        }
        found
    }

    /// The texts that a stroke goes through.
    pub(crate) fn crossed(svg: &str) -> Vec<String> {
        let tree = tree(svg, &Print::default()).unwrap();
        let strokes = strokes(tree.root(), None);
        let is_crossed = |(_, of): &(String, Rect)| {
            let flat = of.inset(1.0, 0.25 * of.height().min(of.width())).unwrap_or(*of);
            strokes.iter().any(|(x, y)| {
                flat.left() < *x && *x < flat.right() && flat.top() < *y && *y < flat.bottom()
            })
        };
        boxes(tree.root()).into_iter().filter(is_crossed).map(|(text, _)| text).collect()
    }

    #[test]
    fn a_text_on_a_line_is_seen_unless_the_line_is_cut_off() {
        use crate::picture::{Color, Path, Stroke, Svg, Type};
        let mut svg = Svg::new((100.0, 100.0), "", "");
        let (line, ink) = (Path::through([(0.0, 50.0), (100.0, 50.0)]), Color(0, 0, 0));
        let left = Path::rectangle((0.0, 0.0), (40.0, 100.0));
        svg.clipped(&left, |svg| svg.stroke(&line, Stroke::new(ink, 1.0)));
        svg.text("on", (5.0, 50.0), Type::new(16.0, ink));
        svg.text("beyond", (45.0, 50.0), Type::new(14.0, ink));
        svg.text("above", (5.0, 20.0), Type::new(14.0, ink));
        let svg = svg.finish();
        assert_eq!(crossed(&svg), ["on"]);
        assert_eq!(super::sizes(&svg), [16.0, 14.0, 14.0]);
    }
}
