//! Bodies as Wavefront OBJ: each a prism of unit depth, a group of its own.

use super::assembly::Assembled;
use crate::strategies::Point;
use std::fmt::Write;

/// A file of Wavefront OBJ.
pub fn obj(of: &Assembled) -> String {
    let mut text = format!("# couplet {}\n# weights and centroids are in the JSON\n", of.line());
    let stones = of.blocks.stones.iter().map(|stone| &stone.polygon).enumerate();
    let stones = stones.map(|(place, polygon)| (format!("stone-{place}"), polygon));
    let [left, right] = &of.blocks.supports;
    let ground = [("support-left".to_owned(), left), ("support-right".to_owned(), right)];
    for (place, (name, polygon)) in stones.chain(ground).enumerate() {
        prism(&mut text, &name, polygon, 8 * place + 1);
    }
    text
}

/// A prism whose first vertex has this number, its faces seen from outside.
fn prism(text: &mut String, name: &str, polygon: &[Point; 4], first: usize) {
    let mut line = |words: std::fmt::Arguments<'_>| {
        // A text takes whatever is written.
        let _ = text.write_fmt(words);
    };
    line(format_args!("o {name}\n"));
    for depth in [0, 1] {
        polygon.iter().for_each(|[x, y]| line(format_args!("v {x} {y} {depth}\n")));
    }
    let at = |corner: usize, depth: usize| first + corner % 4 + 4 * depth;
    line(format_args!("f {} {} {} {}\n", at(3, 0), at(2, 0), at(1, 0), at(0, 0)));
    line(format_args!("f {} {} {} {}\n", at(0, 1), at(1, 1), at(2, 1), at(3, 1)));
    for corner in 0..4 {
        let next = corner + 1;
        let face = [at(corner, 0), at(next, 0), at(next, 1), at(corner, 1)];
        line(format_args!("f {} {} {} {}\n", face[0], face[1], face[2], face[3]));
    }
}
