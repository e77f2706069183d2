//! Printing of a picture: its width, its letters, and whether there are words around it.

use super::path::{Point, Short};
use super::text;
use std::fmt;
use std::io;
use std::str::FromStr;

/// Size of the smallest letters of any picture, in its units.
pub const SMALLEST: f64 = 14.0;
/// Size of these letters on paper where only the width is given.
const LETTERS: PaperLength = PaperLength(7.0);
/// Points in a unit of a picture that has no size on paper: a pixel of the web.
const PIXEL: f64 = 0.75;

/// Printing of a picture; by itself as large as it is on a screen, with all its words.
#[derive(Clone, Debug, PartialEq)]
pub struct Print {
    /// Width of the picture.
    pub width: Option<PaperLength>,
    /// Size of its smallest letters.
    pub font_size: Option<PaperLength>,
    /// Family of its letters.
    pub font: Option<Font>,
    /// True if the words below are there.
    pub caption: bool,
    /// True if they are all there, and not only the first paragraph.
    pub details: bool,
    /// True if the headings above are there.
    pub title: bool,
}

impl Default for Print {
    fn default() -> Self {
        Self {
            width: None,
            font_size: None,
            font: None,
            caption: true,
            details: false,
            title: true,
        }
    }
}

impl Print {
    /// Points in a unit of the picture, if it has a size on paper. Letters and strokes have their size in units, so
    /// that the width changes neither.
    fn unit(&self) -> Option<f64> {
        let letters = self.font_size.or(self.width.map(|_| LETTERS))?;
        Some(letters.0 / SMALLEST)
    }

    /// Width of the picture in its units: its own, unless one on paper is given. One below `least` is refused.
    pub fn room(&self, own: f64, least: f64) -> io::Result<f64> {
        let (Some(width), Some(unit)) = (self.width, self.unit()) else { return Ok(own) };
        let room = width.0 / unit;
        if room >= least {
            return Ok(room);
        }
        let letters = self.font_size.unwrap_or(LETTERS);
        let needed = (least * unit * PaperLength::MILLIMETRE.recip()).ceil();
        let message = format!(
            "this picture is at least {needed}mm wide with letters of {letters}, not {width}: give a larger width or a \
             smaller font size"
        );
        Err(io::Error::new(io::ErrorKind::InvalidInput, message))
    }

    /// Width and height as SVG writes them, of a size in units.
    pub(super) fn size(&self, (width, height): Point) -> [String; 2] {
        match self.unit() {
            Some(unit) => [width, height].map(|length| format!("{}pt", Short(length * unit))),
            None => [width, height].map(|length| length.to_string()),
        }
    }

    /// The lines of a caption no wider than `limit`: its first paragraph, all of them or none, as is wanted.
    pub fn caption(&self, paragraphs: &[String], size: f64, limit: f64) -> Vec<String> {
        let count = match (self.caption, self.details) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => paragraphs.len(),
        };
        paragraphs.iter().take(count).flat_map(|words| text::wrap(words, size, limit)).collect()
    }

    /// Dots in an inch of a picture as pixels: two in a pixel of the web, on paper what a press asks for.
    pub fn resolution(&self) -> f64 {
        if self.unit().is_some() { 600.0 } else { 2.0 * 72.0 / PIXEL }
    }
}

/// A length on paper, in points.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct PaperLength(f64);

impl PaperLength {
    const MILLIMETRE: f64 = 72.0 / 25.4;
    const UNITS: [(&str, f64); 4] =
        [("mm", Self::MILLIMETRE), ("cm", 10.0 * Self::MILLIMETRE), ("in", 72.0), ("pt", 1.0)];

    /// Width of a picture, from 20 mm to that of the largest sheet.
    pub fn width(text: &str) -> Result<Self, String> {
        Self::between(text, "a width", ["20mm", "1189mm"], "84mm, 8.4cm, 3.3in or 240pt")
    }

    /// Size of letters.
    pub fn font_size(text: &str) -> Result<Self, String> {
        Self::between(text, "a font size", ["3pt", "30pt"], "7pt or 2.5mm")
    }

    fn between(text: &str, what: &str, range: [&str; 2], examples: &str) -> Result<Self, String> {
        let [least, most] = range.map(str::parse::<Self>);
        let length = text.trim().parse::<Self>().ok();
        let is_within = |length: &Self| {
            least.is_ok_and(|least| least <= *length) && most.is_ok_and(|most| *length <= most)
        };
        length.filter(is_within).ok_or_else(|| {
            format!("{what} is a length from {} to {} on paper, as {examples}", range[0], range[1])
        })
    }
}

impl FromStr for PaperLength {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let of_unit = |(name, points): (&str, f64)| {
            let number = text.strip_suffix(name)?.trim_end();
            let is_decimal = number.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
            Some(points * number.parse::<f64>().ok().filter(|_| is_decimal)?)
        };
        Self::UNITS.into_iter().find_map(of_unit).map(Self).ok_or(())
    }
}

/// Written in millimetres where it is long, and in points where it is a size of letters.
impl fmt::Display for PaperLength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 > 40.0 {
            true => write!(f, "{}mm", Short(self.0 / Self::MILLIMETRE)),
            false => write!(f, "{}pt", Short(self.0)),
        }
    }
}

/// The name of a family of letters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Font(String);

impl Font {
    /// Letters in the longest name.
    const LONGEST: usize = 60;

    /// The name.
    pub fn name(&self) -> &str {
        &self.0
    }
}

impl FromStr for Font {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let name = text.trim();
        let is_name = |c: char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '.' | '_');
        let is_font =
            !name.is_empty() && name.chars().count() <= Self::LONGEST && name.chars().all(is_name);
        match is_font {
            true => Ok(Self(name.to_owned())),
            false => Err("a font is the name of one family, as Arial or Latin Modern Roman".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(width: &str, font_size: Option<&str>) -> Print {
        let width = Some(PaperLength::width(width).unwrap());
        let font_size = font_size.map(|size| PaperLength::font_size(size).unwrap());
        Print { width, font_size, ..Print::default() }
    }

    #[test]
    fn lengths_have_a_unit_and_a_range() {
        let [one, other] = ["8.4cm", "84 mm"].map(|text| PaperLength::width(text).unwrap());
        assert!((one.0 - other.0).abs() < 1e-9);
        assert_eq!((one.to_string(), PaperLength(7.0).to_string()), ("84mm".into(), "7pt".into()));
        for wrong in
            ["84", "mm", "", "-84mm", "84px", "1e3mm", "nanmm", "infmm", "19mm", "2m", "8.4.1cm"]
        {
            let said = PaperLength::width(wrong).unwrap_err();
            assert!(said.contains("from 20mm to 1189mm") && !said.contains('\n'), "{wrong}");
        }
        assert!(PaperLength::font_size("2pt").is_err() && PaperLength::font_size("31pt").is_err());
    }

    /// The width changes the room and never the size of letters.
    #[test]
    fn letters_keep_their_size() {
        for (width, letters) in [("84mm", 7.0), ("180mm", 7.0)] {
            let print = of(width, None);
            assert!((print.unit().unwrap() * SMALLEST - letters).abs() < 1e-12);
        }
        let (narrow, wide) = (of("84mm", Some("6pt")), of("84mm", Some("8pt")));
        let [narrow, wide] = [narrow, wide].map(|print| print.room(944.0, 100.0).unwrap());
        assert!((narrow / wide - 8.0 / 6.0).abs() < 1e-12);
        let said = of("30mm", None).room(944.0, 400.0).unwrap_err();
        assert_eq!(said.kind(), io::ErrorKind::InvalidInput);
        assert!(
            said.to_string().contains("at least 71mm wide with letters of 7pt, not 30mm"),
            "{said}"
        );
        assert_eq!(Print::default().room(944.0, 400.0).unwrap(), 944.0);
    }

    #[test]
    fn a_font_is_a_name() {
        assert_eq!("Latin Modern Roman".parse::<Font>().unwrap().name(), "Latin Modern Roman");
        for wrong in ["", " ", "a\"b", "a,b", "<x>", &"x".repeat(61)] {
            assert!(wrong.parse::<Font>().is_err(), "{wrong}");
        }
    }
}
