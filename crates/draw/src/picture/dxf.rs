//! The writer of DXF: release 2000 (`AC1015`), the oldest that knows its unit, as text. A file is pairs of a code and a
//! value, each on a line.

use super::arcs::Bulge;
use super::path::short;
use super::svg::Anchor;
use crate::problem::measures::LengthUnit;

/// The number that a unit of length has there; no unit is that of the centreline's radius.
fn number_of(unit: Option<LengthUnit>) -> u8 {
    match unit {
        None => 0,
        Some(LengthUnit::Inch) => 1,
        Some(LengthUnit::Foot) => 2,
        Some(LengthUnit::Millimetre) => 4,
        Some(LengthUnit::Centimetre) => 5,
        Some(LengthUnit::Metre) => 6,
        Some(LengthUnit::Yard) => 10,
    }
}

/// A file in the making.
pub struct DxfFile {
    text: String,
    /// Handles so far: each table, record and entity has one.
    handles: u32,
    /// The record of the block whose entities are written.
    owner: String,
    /// The records of the blocks that are still to be written, in the order of their names.
    records: std::vec::IntoIter<String>,
    /// Where what is drawn next begins, in its own units.
    pub x: f64,
    /// Such a unit in that of the file.
    scale: f64,
}

/// The space in which the drawing is, and that of its sheets, which every file has.
const MODEL: &str = "*Model_Space";
const SHEETS: &str = "*Paper_Space";

/// Decimals of a length in these units.
const DECIMALS: i32 = 7;

impl DxfFile {
    /// A file with its layers and their colours by number, and the names of its blocks, up to the first block.
    pub fn new(
        (unit, scale): (Option<LengthUnit>, f64),
        layers: &[(&str, u8)],
        blocks: &[String],
    ) -> Self {
        let (text, owner) = (String::new(), String::new());
        let records = Vec::new().into_iter();
        let mut file = Self { text, handles: 0, owner, records, x: 0.0, scale };
        let name = unit.map_or("units of r", LengthUnit::name);
        file.put(999, &format!("couplet: lengths in {name}"));
        file.begin_section("HEADER");
        let is_english =
            matches!(unit, Some(LengthUnit::Foot | LengthUnit::Inch | LengthUnit::Yard));
        let (unit, system) = (number_of(unit).to_string(), if is_english { "0" } else { "1" });
        file.put_all(&[(9, "$ACADVER"), (1, "AC1015"), (9, "$DWGCODEPAGE"), (3, "ANSI_1252")]);
        // No handle is above the seed.
        file.put_all(&[(9, "$INSUNITS"), (70, &unit), (9, "$MEASUREMENT"), (70, system)]);
        file.put_all(&[(9, "$HANDSEED"), (5, "FFFFFF")]);
        file.end_section();
        file.begin_section("TABLES");
        file.tables(layers, blocks);
        file.end_section();
        file.begin_section("BLOCKS");
        for name in [MODEL, SHEETS] {
            file.block(name, |_| ());
        }
        file
    }

    fn tables(&mut self, layers: &[(&str, u8)], blocks: &[String]) {
        self.table("VPORT", "", &[]);
        let line: &[(u16, &str)] = &[(3, ""), (72, "65"), (73, "0"), (40, "0")];
        let types = ["ByBlock", "ByLayer", "Continuous"].map(|name| (name, line.to_vec()));
        self.table("LTYPE", "AcDbLinetypeTableRecord", &types);
        let colors: Vec<String> = layers.iter().map(|(_, color)| color.to_string()).collect();
        let layer = |name, color| (name, vec![(62, color), (6, "Continuous")]);
        let of_layers = layers.iter().zip(&colors).map(|((name, _), color)| layer(*name, color));
        let layers: Vec<_> = [layer("0", "7")].into_iter().chain(of_layers).collect();
        self.table("LAYER", "AcDbLayerTableRecord", &layers);
        let letters =
            vec![(40, "0"), (41, "1"), (50, "0"), (71, "0"), (42, "1"), (3, "txt"), (4, "")];
        self.table("STYLE", "AcDbTextStyleTableRecord", &[("Standard", letters)]);
        self.table("VIEW", "", &[]);
        self.table("UCS", "", &[]);
        self.table("APPID", "AcDbRegAppTableRecord", &[("ACAD", Vec::new())]);
        self.table("DIMSTYLE", "AcDbDimStyleTableRecord", &[("Standard", Vec::new())]);
        let names = [MODEL, SHEETS].into_iter().chain(blocks.iter().map(String::as_str));
        let records: Vec<_> = names.map(|name| (name, Vec::new())).collect();
        let records = self.table("BLOCK_RECORD", "AcDbBlockTableRecord", &records);
        self.owner = records.first().cloned().unwrap_or_default();
        self.records = records.into_iter();
    }

    /// A table with its records; returns the handles of these.
    fn table(
        &mut self,
        name: &str,
        class: &str,
        records: &[(&str, Vec<(u16, &str)>)],
    ) -> Vec<String> {
        self.put_all(&[(0, "TABLE"), (2, name)]);
        let table = self.handle(5);
        self.put_all(&[(330, "0"), (100, "AcDbSymbolTable"), (70, &records.len().to_string())]);
        let is_of_dimensions = name == "DIMSTYLE";
        if is_of_dimensions {
            self.put_all(&[(100, "AcDbDimStyleTable"), (71, "0")]);
        }
        let record = |(of, values): &(&str, Vec<(u16, &str)>)| {
            self.put(0, name);
            let handle = self.handle(if is_of_dimensions { 105 } else { 5 });
            self.put_all(&[(330, &table), (100, "AcDbSymbolTableRecord"), (100, class), (2, of)]);
            self.put(70, "0");
            self.put_all(values);
            handle
        };
        let handles = records.iter().map(record).collect();
        self.put(0, "ENDTAB");
        handles
    }

    /// A block with its entities, where it is in the order of their names.
    pub fn block(&mut self, name: &str, draw: impl FnOnce(&mut Self)) {
        let record = self.records.next().unwrap_or_default();
        let model = std::mem::replace(&mut self.owner, record);
        self.begin("BLOCK", "0", "AcDbBlockBegin");
        self.put_all(&[(2, name), (70, "0"), (10, "0"), (20, "0"), (30, "0"), (3, name), (1, "")]);
        draw(self);
        self.begin("ENDBLK", "0", "AcDbBlockEnd");
        self.owner = model;
    }

    /// Goes on to the drawing.
    pub fn draw(&mut self) {
        self.end_section();
        self.begin_section("ENTITIES");
    }

    /// The file, ended.
    pub fn finish(mut self) -> String {
        self.end_section();
        self.begin_section("OBJECTS");
        self.put(0, "DICTIONARY");
        let root = self.handle(5);
        let groups = format!("{:X}", self.handles + 1);
        self.put_all(&[(330, "0"), (100, "AcDbDictionary"), (3, "ACAD_GROUP"), (350, &groups)]);
        self.put(0, "DICTIONARY");
        self.handle(5);
        self.put_all(&[(330, &root), (100, "AcDbDictionary")]);
        self.end_section();
        self.put(0, "EOF");
        self.text
    }

    fn begin_section(&mut self, name: &str) {
        self.put_all(&[(0, "SECTION"), (2, name)]);
    }

    fn end_section(&mut self) {
        self.put(0, "ENDSEC");
    }

    fn put(&mut self, code: u16, value: &str) {
        self.text += &format!("{code}\n{value}\n");
    }

    fn put_all(&mut self, pairs: &[(u16, &str)]) {
        pairs.iter().for_each(|(code, value)| self.put(*code, value));
    }

    /// A new handle under a code.
    fn handle(&mut self, code: u16) -> String {
        self.handles += 1;
        let handle = format!("{:X}", self.handles);
        self.put(code, &handle);
        handle
    }

    fn number(&mut self, code: u16, value: f64, decimals: i32) {
        self.put(code, &short(value, decimals.max(0) as usize));
    }

    /// Writes a length, as precise in a small unit as in a large one.
    fn length(&mut self, code: u16, value: f64) {
        let value = value * self.scale;
        self.number(code, value, DECIMALS - self.scale.log10().floor() as i32);
    }

    fn point(&mut self, first: u16, [x, y]: [f64; 2]) {
        self.length(first, self.x + x);
        self.length(first + 10, y);
    }

    fn begin(&mut self, kind: &str, layer: &str, class: &str) {
        self.put(0, kind);
        self.handle(5);
        let owner = self.owner.clone();
        self.put_all(&[(330, &owner), (100, "AcDbEntity"), (8, layer), (100, class)]);
    }

    /// Draws a straight line.
    pub fn line(&mut self, layer: &str, [from, to]: [[f64; 2]; 2]) {
        self.begin("LINE", layer, "AcDbLine");
        self.point(10, from);
        self.point(11, to);
    }

    /// Draws arcs one after the other; an outline ends where it begins.
    pub fn arcs(&mut self, layer: &str, points: &[Bulge], is_outline: bool) {
        self.begin("LWPOLYLINE", layer, "AcDbPolyline");
        let closed = if is_outline { "1" } else { "0" };
        self.put_all(&[(90, &points.len().to_string()), (70, closed)]);
        for (point, bulge) in points {
            self.point(10, *point);
            if *bulge != 0.0 {
                self.number(42, *bulge, DECIMALS);
            }
        }
    }

    /// Draws a circle about a place.
    pub fn circle(&mut self, layer: &str, at: [f64; 2], radius: f64) {
        self.begin("CIRCLE", layer, "AcDbCircle");
        self.point(10, at);
        self.length(40, radius);
    }

    /// About a centre, counter-clockwise from one angle to another, in degrees from the right.
    pub fn arc(&mut self, layer: &str, center: [f64; 2], radius: f64, [from, to]: [f64; 2]) {
        self.begin("ARC", layer, "AcDbCircle");
        self.point(10, center);
        self.length(40, radius);
        self.put(100, "AcDbArc");
        self.number(50, from, DECIMALS);
        self.number(51, to, DECIMALS);
    }

    /// Writes a text of a height, in the middle of it at a place, turned by so many degrees.
    pub fn text(
        &mut self,
        layer: &str,
        words: &str,
        (at, anchor): ([f64; 2], Anchor),
        (height, turn): (f64, f64),
    ) {
        self.begin("TEXT", layer, "AcDbText");
        self.point(10, at);
        self.length(40, height);
        self.put(1, &escaped(words));
        self.number(50, turn, DECIMALS);
        self.put(72, &(anchor as u8).to_string());
        self.point(11, at);
        self.put_all(&[(100, "AcDbText"), (73, "2")]);
    }

    /// Draws a block where what is drawn next begins.
    pub fn insert(&mut self, block: &str) {
        self.begin("INSERT", "0", "AcDbBlockReference");
        self.put(2, block);
        self.point(10, [0.0, 0.0]);
    }
}

/// A text in the letters of the release: others by their number. The letters below the line are no part of its fonts.
fn escaped(words: &str) -> String {
    let of = |c: char| match c {
        'ᵣ' => "r".to_owned(),
        'ₛ' => "s".to_owned(),
        ' '..='~' => c.to_string(),
        _ => format!("\\U+{:04X}", u32::from(c)),
    };
    words.chars().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_handle_is_its_own_and_every_owner_is_there() {
        let blocks = ["A".to_owned(), "B".to_owned()];
        let mut file = DxfFile::new((Some(LengthUnit::Metre), 5.0), &[("ARCH", 7)], &blocks);
        for name in &blocks {
            file.block(name, |file| file.line("ARCH", [[0.0, 0.0], [1.0, 1.0]]));
        }
        file.draw();
        file.insert("A");
        file.text("ARCH", "βᵣ = 3°", ([0.0, 0.5], Anchor::Middle), (0.1, 0.0));
        let text = file.finish();
        let lines: Vec<&str> = text.lines().collect();
        let of = |codes: &[&str]| -> Vec<&str> {
            lines.chunks(2).filter(|pair| codes.contains(&pair[0])).map(|pair| pair[1]).collect()
        };
        let mut handles = of(&["5", "105"]);
        handles.retain(|handle| *handle != "FFFFFF");
        let all: std::collections::BTreeSet<&str> = handles.iter().copied().collect();
        assert_eq!(all.len(), handles.len());
        assert!(of(&["330", "350"]).iter().all(|owner| *owner == "0" || all.contains(owner)));
        assert!(text.contains("\\U+03B2r = 3\\U+00B0") && text.is_ascii());
        assert!(text.contains("$INSUNITS\n70\n6\n") && text.contains("11\n5\n21\n5\n"));
    }
}
