//! The curves as a picture.

use super::Map;
use std::io;

/// As SVG.
pub(in crate::report) fn svg(map: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    out.write_all(map.drawing.svg(&map.traces, &map.levels, &map.borders)?.as_bytes())
}

/// As PNG.
#[cfg(feature = "plots")]
pub(in crate::report) fn png(map: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    out.write_all(&crate::picture::png::render(&map.drawing.svg(
        &map.traces,
        &map.levels,
        &map.borders,
    )?))
}
