//! The colours.

use std::fmt;

/// Red, green and blue, written as `#rrggbb`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

/// Text and frames.
pub const INK: Color = Color(0x22, 0x22, 0x22);
/// The page.
pub const WHITE: Color = Color(0xFF, 0xFF, 0xFF);
/// The lines of a grid.
pub const GRID: Color = Color(0xE2, 0xE2, 0xE2);
/// Colour of guides, which lead the eye.
pub const GUIDE: Color = Color(0xAA, 0xAA, 0xAA);

/// The colours of Okabe and Ito (Color Universal Design, 2008), which the colour-blind can tell apart,
/// without the yellow.
pub const OKABE_ITO: [Color; 7] = [
    Color(0x00, 0x72, 0xB2),
    Color(0xD5, 0x5E, 0x00),
    Color(0x00, 0x9E, 0x73),
    Color(0x00, 0x00, 0x00),
    Color(0xCC, 0x79, 0xA7),
    Color(0xE6, 0x9F, 0x00),
    Color(0x56, 0xB4, 0xE9),
];

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_written_in_six_digits() {
        assert_eq!(Color(0, 0x0A, 0xFF).to_string(), "#000aff");
    }
}
