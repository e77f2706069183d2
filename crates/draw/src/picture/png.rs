//! SVG as pixels.

use super::print::Print;
use super::tree::tree;
use png::{BitDepth, ColorType, Encoder, PixelDimensions, Unit};
use resvg::tiny_skia::{self, IntRect, Mask, MaskType, Pixmap, PixmapPaint, Transform};
use resvg::usvg::{Group, Node, Paint};
use std::io;

/// Pixels of the web in an inch: what the reader of SVG counts in.
const WEB: f64 = 96.0;
/// An inch in metres.
const INCH: f64 = 0.0254;
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
    draw(tree.root(), Transform::from_scale(scale, scale), &mut pixels);
    let per_metre = (WEB * f64::from(scale) / INCH).round() as u32;
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    let size = PixelDimensions { xppu: per_metre, yppu: per_metre, unit: Unit::Meter };
    encoder.set_pixel_dims(Some(size));
    let mut writer = encoder.write_header().map_err(io::Error::other)?;
    let colors = pixels.pixels().iter().map(|pixel| pixel.demultiply());
    let bytes: Vec<u8> =
        colors.flat_map(|of| [of.red(), of.green(), of.blue(), of.alpha()]).collect();
    writer.write_image_data(&bytes).map_err(io::Error::other)?;
    writer.finish().map_err(io::Error::other)?;
    Ok(file)
}

/// Draws a group; of what is clipped only where the clip is. The renderer makes room for all that is drawn there, and
/// through a window on a map that is up to four times the page to each side.
fn draw(group: &Group, transform: Transform, pixels: &mut Pixmap) {
    let transform = transform.pre_concat(group.transform());
    for node in group.children() {
        match node {
            Node::Group(group) => match group.clip_path() {
                Some(clip) => clipped([group, clip.root()], transform, pixels),
                None => draw(group, transform, pixels),
            },
            _ => match (node.abs_layer_bounding_box(), node) {
                // The renderer moves what it draws to the corner, and knows none of what is level or upright.
                (Some(corner), _) => {
                    let back = transform.pre_translate(corner.x(), corner.y());
                    resvg::render_node(node, back, &mut pixels.as_mut());
                }
                (None, Node::Path(line)) => {
                    let Some(stroke) = line.stroke() else { continue };
                    let mut paint = tiny_skia::Paint::default();
                    if let Paint::Color(color) = stroke.paint() {
                        paint.set_color_rgba8(color.red, color.green, color.blue, u8::MAX);
                    }
                    pixels.stroke_path(
                        line.data(),
                        &paint,
                        &stroke.to_tiny_skia(),
                        transform,
                        None,
                    );
                }
                _ => {}
            },
        }
    }
}

/// Draws a group where a clip is.
fn clipped([group, clip]: [&Group; 2], transform: Transform, pixels: &mut Pixmap) {
    let seen = clip.bounding_box().transform(transform.pre_concat(group.transform()));
    let page = IntRect::from_xywh(0, 0, pixels.width(), pixels.height());
    let seen = seen.and_then(|seen| seen.round_out()?.intersect(&page?));
    let Some(seen) = seen else { return };
    let layer = || Pixmap::new(seen.width(), seen.height()).expect("what is seen is not empty");
    let [mut drawn, mut shown] = [layer(), layer()];
    let transform = transform.post_translate(-seen.x() as f32, -seen.y() as f32);
    draw(group, transform, &mut drawn);
    draw(clip, transform.pre_concat(group.transform()), &mut shown);
    drawn.apply_mask(&Mask::from_pixmap(shown.as_ref(), MaskType::Alpha));
    let (paint, still) = (PixmapPaint::default(), Transform::identity());
    pixels.draw_pixmap(seen.x(), seen.y(), drawn.as_ref(), &paint, still, None);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Color, Hatch, Path, Rigid, Stroke, Svg, Type};

    /// A word processor places it as wide as it was asked for.
    #[test]
    fn pixels_have_a_size() {
        let width = Some(crate::picture::PaperLength::width("84mm").unwrap());
        let print = Print { width, ..Print::default() };
        let room = print.room(20.0, 20.0).unwrap();
        let svg = Svg::printed(&print, (room, 20.0), "", "").finish();
        let file = render(&svg, &print).unwrap();
        let number = |at: usize| u32::from_be_bytes(file[at..at + 4].try_into().unwrap());
        assert_eq!(&file[37..41], b"pHYs");
        let metres = f64::from(number(16)) / f64::from(number(41));
        assert!((metres - 0.084).abs() < 1e-4, "{metres}");
        assert!(Pixmap::decode_png(&file).is_ok());
    }

    /// The picture is that of the renderer, with a clip that cuts off most of it, and a motion.
    #[test]
    fn pixels_are_those_of_the_renderer() {
        let print = Print::default();
        let mut svg = Svg::new((60.0, 50.0), "", "");
        let (ink, ground) = (Color(200, 30, 0), Color(240, 230, 90));
        let window = Path::around([(10.3, 5.0), (50.0, 9.0), (44.0, 44.7)]);
        let to = Rigid { shift: (3.0, 1.0), degrees: 20.0, about: (20.0, 20.0) };
        svg.clipped(&window, |svg| {
            let wide = Path::rectangle((-60.0, -50.0), (90.0, 30.0));
            svg.hatch(&wide, Hatch { ground, color: ink, gap: 7.0, turn: 45.0 });
            svg.group("inner", |svg| {
                svg.stroke(&Path::through([(0.0, 0.0), (70.0, 60.0)]), Stroke::new(ink, 3.0));
            });
        });
        for end in [(2.0, 48.0), (58.0, 3.0)] {
            let line = Path::through([(2.0, 3.0), end]);
            svg.stroke(&line, Stroke { dashes: &[5.0, 3.0], ..Stroke::new(ink, 1.5) });
        }
        svg.moved(to, &[], 1.0, |svg| svg.fill(&Path::rectangle((2.0, 30.0), (9.0, 40.0)), ink));
        svg.text("up", (52.0, 40.0), Type::new(14.0, ink).turned(-90.0).on(ground));
        let svg = svg.finish();
        let tree = tree(&svg, &print).unwrap();
        let mut expected = Pixmap::new(120, 100).unwrap();
        resvg::render(&tree, Transform::from_scale(2.0, 2.0), &mut expected.as_mut());
        let found = Pixmap::decode_png(&render(&svg, &print).unwrap()).unwrap();
        assert_eq!((found.width(), found.height()), (120, 100));
        let pairs = found.data().iter().zip(expected.data());
        let furthest = pairs.map(|(a, b)| a.abs_diff(*b)).max();
        assert!(furthest.is_some_and(|apart| apart <= 2), "{furthest:?}");
    }
}
