//! Text of an arch: each thing that it may be given by once, with the help that a command prints of it.

use super::boxes::{has_extent, middle};
use super::question::{Misfit, Spelling};
use super::range::Range;
use crate::number::{is_range, shown};
use std::str::FromStr;

/// Text as a word of a command line, in quotes where a shell would read it otherwise.
pub fn quoted(text: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "./+-,_:=°±".contains(c);
    match !text.is_empty() && text.chars().all(is_plain) {
        true => text.to_owned(),
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
}

/// Declares [`ArchAsked`] and [`Field`] in one list.
macro_rules! fields {
    ($($(#[doc = $doc:literal])+ $variant:ident $name:ident $value:literal $($letter:literal)? $(in $heading:literal)?),* $(,)?) => {
        /// Arch as it is asked about: exact text, of which nothing is read yet.
        #[derive(Clone, Debug, Default, PartialEq, Eq)]
        #[cfg_attr(feature = "clap", derive(clap::Args))]
        #[cfg_attr(feature = "clap", group(skip))]
        pub struct ArchAsked {
            $(
                $(#[doc = $doc])+
                #[cfg_attr(
                    feature = "clap",
                    arg(long, value_name = $value, $(visible_alias = $letter,)? $(help_heading = $heading,)? allow_hyphen_values = true)
                )]
                pub $name: Option<String>,
            )*
        }

        /// Thing that an arch may be given by.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Field {
            $($(#[doc = $doc])+ $variant,)*
        }

        impl Field {
            /// All of them, in the order in which they are shown.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Name of the field, in keys and columns.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => stringify!($name),)* }
            }

            /// Letter of the field in the paper, which is a name too.
            pub fn letter(self) -> Option<&'static str> {
                let letters: &[&str] = match self { $(Self::$variant => &[$($letter)?],)* };
                letters.first().copied()
            }
        }

        impl ArchAsked {
            /// Text of a field.
            pub fn get(&self, field: Field) -> Option<&str> {
                match field { $(Field::$variant => self.$name.as_deref(),)* }
            }

            /// Place of the text of a field.
            pub fn at(&mut self, field: Field) -> &mut Option<String> {
                match field { $(Field::$variant => &mut self.$name,)* }
            }
        }
    };
}

fields!(
    /// Half opening in radians (2.45, 1/3, pi/2) or degrees (80deg, 80°), between 0 and pi.
    HalfOpening half_opening "ANGLE" "alpha",
    /// Friction coefficient mu (0.6, 3/5, inf), or an angle with its unit (31deg).
    Friction friction "MU" "mu",
    /// Friction angle phi instead of the coefficient (21deg, pi/6).
    FrictionAngle friction_angle "ANGLE" "phi",
    /// Thickness-to-radius ratio, above 0 and up to 2 (0.12, 3/25, 0.12r); of an arch in metres a length (60cm), or a
    /// ratio with its r.
    Thickness thickness "ETA" "eta",
    /// Stones of the whole arch, all of the same angle, with joints between them alone; an odd number has a keystone.
    Stones stones "N",
    /// Angles of the joints of the half arch instead, with commas between them, from the crown (0, or half a
    /// keystone) to the shoulder.
    Joints joints "ANGLES",
    /// A uniform horizontal acceleration over that of gravity (0.1), or the angle by which the ground is tilted (5deg):
    /// whether an admissible state of the whole arch is left, and the largest one with which there is.
    Tilt tilt "K",
    /// Span; of span, rise, radius and half opening any two. A length with its unit (10m, 60cm, 600mm, 33ft, 7in).
    Span span "LENGTH" in "In metres",
    /// Rise, from the springing joints' height to the crown.
    Rise rise "LENGTH" in "In metres",
    /// Radius; of a span and a radius the flatter arc.
    Radius radius "LENGTH" in "In metres",
    /// Circle at which these are measured: intrados (if not given: the clear span), centreline or extrados.
    MeasuredAt measured_at "CIRCLE" in "In metres",
    /// Density of the material (2400kg/m3, 24kN/m3, 150lb/ft3); with --depth, forces are told in kN.
    Density density "DENSITY" in "In metres",
    /// Depth of the arch, across its span.
    Depth depth "LENGTH" in "In metres",
);

impl Field {
    /// Sizes of an arch in metres, and what makes forces of them.
    pub const SIZES: [Self; 6] =
        [Self::Span, Self::Rise, Self::Radius, Self::MeasuredAt, Self::Density, Self::Depth];

    /// Field of a name or a letter.
    pub fn named(name: &str) -> Option<Self> {
        let is = |field: &&Self| field.name() == name || field.letter() == Some(name);
        Self::ALL.iter().find(is).copied()
    }
}

impl ArchAsked {
    /// Arch of these texts.
    pub fn of<'a>(texts: impl IntoIterator<Item = (Field, &'a str)>) -> Self {
        let mut asked = Self::default();
        for (field, text) in texts {
            *asked.at(field) = Some(text.to_owned());
        }
        asked
    }

    /// Reads `span=10m; rise=3m; friction=0.6`: fields by name or letter, each once.
    pub fn parse(text: &str) -> Result<Self, Misfit> {
        let mut asked = Self::default();
        for pair in text.split(';').map(str::trim).filter(|pair| !pair.is_empty()) {
            let Some((name, value)) = pair.split_once('=') else {
                let pair = shown(pair);
                return Err(format!("'{pair}' has no value: fields are name=value").into());
            };
            let Some(field) = Field::named(name.trim()) else {
                let names: Vec<&str> = Field::ALL.iter().map(|field| field.name()).collect();
                let (name, names) = (shown(name.trim()), names.join(", "));
                return Err(format!("'{name}' is none of the fields of an arch: {names}").into());
            };
            if asked.at(field).replace(value.trim().to_owned()).is_some() {
                return Err(Misfit::new(field, format!("{} is given twice", field.name())));
            }
        }
        Ok(asked)
    }

    /// Options of the command that ask the same.
    pub fn options(&self) -> String {
        let said = |of| Some(format!(" {} {}", Spelling::Option.of(of), quoted(self.get(of)?)));
        Field::ALL.iter().copied().filter_map(said).collect()
    }

    /// Fields that are given.
    pub fn fields(&self) -> impl Iterator<Item = Field> {
        Field::ALL.iter().copied().filter(|field| self.get(*field).is_some())
    }

    /// Fields whose texts are ranges; numbers of stones have ranges of their own.
    pub fn ranges(&self) -> impl Iterator<Item = Field> {
        let is_own = |field: &Field| *field == Field::Stones;
        self.fields().filter(move |of| !is_own(of) && self.get(*of).is_some_and(is_range))
    }

    /// Tells whether any field is a range.
    pub fn has_range(&self) -> bool {
        self.ranges().next().is_some()
    }

    /// Range of a field, if it is one.
    fn range(&self, field: Field) -> Result<Option<Range>, Misfit> {
        let range = self.get(field).map_or(Ok(None), Range::read);
        range.map_err(|error| Misfit::new(field, error))
    }

    /// Texts of the lower ends and of the upper ends; a field without a range is the same in both.
    pub fn ends(&self) -> Result<[Self; 2], Misfit> {
        let mut ends = [self.clone(), self.clone()];
        for field in self.ranges() {
            if let Some(Range { lower, upper }) = self.range(field)? {
                let [low, high] = &mut ends;
                (*low.at(field), *high.at(field)) = (Some(lower), Some(upper));
            }
        }
        Ok(ends)
    }

    /// Measures with a tolerance, a range of some extent, on each of which it depends whether an arch stands.
    pub fn tolerances(&self) -> Vec<Field> {
        let has_extent =
            |of: &Field| self.range(*of).ok().flatten().is_some_and(|range| has_extent(&range));
        let is_load = |of: &Field| [Field::Density, Field::Depth].contains(of);
        self.ranges().filter(|of| !is_load(of) && has_extent(of)).collect()
    }

    /// The question in which one measure alone keeps its tolerance, and every other one is at the middle of its own;
    /// without forces. Refused if a range has no exact middle, as one without end.
    pub fn alone(&self, measure: Field) -> Result<Self, Misfit> {
        let mut alone = Self { density: None, depth: None, ..self.clone() };
        for other in self.tolerances().into_iter().filter(|of| *of != measure) {
            let text = shown(self.get(other).unwrap_or_default());
            let middle = self.range(other)?.and_then(|range| middle(&range).ok());
            let why = || format!("{} {text} has no exact middle", other.name());
            *alone.at(other) = Some(middle.ok_or_else(|| Misfit::new(other, why()))?);
        }
        Ok(alone)
    }

    /// Friction as [`Friction`](crate::problem::Friction) reads it.
    pub fn friction_text(&self) -> Option<String> {
        let angle = || self.friction_angle.as_ref().map(|phi| format!("tan({phi})"));
        self.friction.clone().or_else(angle)
    }

    /// Field by which the friction is given, if it is.
    pub(crate) fn friction_field(&self) -> Field {
        if self.friction.is_some() { Field::Friction } else { Field::FrictionAngle }
    }
}

/// Text of a field, read.
pub(super) fn read<T: FromStr<Err: ToString>>(
    asked: &ArchAsked,
    field: Field,
) -> Result<Option<T>, Misfit> {
    let text = asked
        .get(field)
        .map(|text| text.parse().map_err(|error: T::Err| Misfit::new(field, error.to_string())));
    text.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arch_is_one_line_of_text_and_one_of_options() {
        let asked = ArchAsked::parse(" span = 10m;rise=3m; mu=1/2; joints=0,1 ;").unwrap();
        assert_eq!(asked.options(), " --friction 1/2 --joints 0,1 --span 10m --rise 3m");
        for (text, why) in [
            ("colour=red", "none of the fields of an arch: half_opening"),
            ("mu=1; span", "'span' has no value"),
            ("mu=1; friction=2", "friction is given twice"),
        ] {
            let misfit = ArchAsked::parse(text).unwrap_err();
            assert!(misfit.message.contains(why), "{misfit}");
        }
        assert_eq!(ArchAsked::parse("").unwrap(), ArchAsked::default());
    }

    #[test]
    fn a_word_is_quoted_where_a_shell_would_read_it_otherwise() {
        let cases =
            [("10m±2cm", "10m±2cm"), ("", "''"), ("[s,r,r]", "'[s,r,r]'"), ("6'", r"'6'\'''")];
        for (text, word) in cases {
            assert_eq!(quoted(text), word);
        }
    }

    #[test]
    fn one_measure_alone_keeps_its_tolerance() {
        let asked = "span=10m±2cm; rise=2.9m..310cm; eta=60cm..0.6m; mu=0.5..0.7; radius=1m; density=20kN/m3..24kN/m3";
        let asked = ArchAsked::parse(asked).unwrap();
        let measures = asked.tolerances();
        assert_eq!(measures, [Field::Friction, Field::Span, Field::Rise]);
        let alone = measures.iter().map(|of| asked.alone(*of).unwrap().options());
        assert_eq!(
            alone.collect::<Vec<_>>(),
            [
                " --friction 0.5..0.7 --thickness 60cm..0.6m --span 10m --rise 3m --radius 1m",
                " --friction 0.6 --thickness 60cm..0.6m --span 10m±2cm --rise 3m --radius 1m",
                " --friction 0.6 --thickness 60cm..0.6m --span 10m --rise 2.9m..310cm --radius 1m",
            ]
        );
        for (range, alpha) in [("mu=0.5..inf", "2"), ("mu=tan(31deg)..0.7", "2"), ("mu=1", "pi/2")]
        {
            let asked =
                ArchAsked::parse(&format!("alpha=1..{alpha}; eta=0.1..0.2; {range}")).unwrap();
            let misfit = asked.alone(Field::Thickness).unwrap_err();
            assert!(misfit.message.ends_with("has no exact middle"), "{misfit}");
        }
    }

    #[test]
    fn the_ends_of_a_question_are_two_questions() {
        let asked =
            ArchAsked::parse("span=2.98m..3.02m; rise=1m; phi=31deg±1deg; stones=2..9").unwrap();
        assert_eq!(asked.ranges().collect::<Vec<_>>(), [Field::FrictionAngle, Field::Span]);
        let ends = asked.ends().unwrap().map(|end| end.options());
        assert_eq!(
            ends,
            [
                " --friction-angle 30deg --stones 2..9 --span 2.98m --rise 1m",
                " --friction-angle 32deg --stones 2..9 --span 3.02m --rise 1m"
            ]
        );
        let one = ArchAsked::parse("alpha=80deg; mu=0.6; stones=2..9").unwrap();
        assert!(!one.has_range());
        assert_eq!(one.ends(), Ok([one.clone(), one]));
        let misfit = ArchAsked::parse("alpha=80..82deg; mu=1").unwrap().ends().unwrap_err();
        assert_eq!(misfit.field, Some(Field::HalfOpening));
    }
}
