//! Fields that a question takes, those that it needs, and the reasons why it does not take the rest.

use super::asked::{ArchAsked, Field};
use crate::number::list;
use std::fmt::{self, Display};

/// Question about an arch.
pub struct ArchQuestion {
    /// Fields that it does not take, each with the reason.
    pub refuses: &'static [(Field, &'static str)],
    /// Fields that it needs beside a half opening and a friction.
    pub needs: &'static [Field],
    /// True if it needs no friction: the arch's is unlimited then.
    pub unlimited: bool,
    /// Command line that has everything.
    pub example: &'static str,
}

/// Spelling of a field at a door.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spelling {
    /// Option of a command: `--half-opening`.
    Option,
    /// Key, column or argument: `half_opening`.
    Key,
}

/// Reason why what is given makes no sense.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misfit {
    /// Field of which that is said, where it is one.
    pub field: Option<Field>,
    /// Reason in words: what is wrong, and what is allowed.
    pub message: String,
}

impl Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Misfit {}

impl From<String> for Misfit {
    fn from(message: String) -> Self {
        Self { field: None, message }
    }
}

impl Spelling {
    /// Field as the door calls it.
    pub fn of(self, field: Field) -> String {
        match self {
            Self::Option => format!("--{}", field.name().replace('_', "-")),
            Self::Key => field.name().to_owned(),
        }
    }
}

impl Misfit {
    pub(crate) fn new(field: Field, message: impl Display) -> Self {
        Self { field: Some(field), message: message.to_string() }
    }
}

/// Pairs of which one excludes the other.
const INSTEAD: [(Field, Field); 3] = [
    (Field::HalfOpening, Field::Joints),
    (Field::Stones, Field::Joints),
    (Field::Friction, Field::FrictionAngle),
];
/// Measures of which any two make an arc; joints have a half opening.
const ARC: [Field; 5] = list![Field: HalfOpening Span Rise Radius Joints];
/// Pairs of which one makes no sense without the other.
const WITH: [(Field, Field); 2] = [(Field::Density, Field::Depth), (Field::Depth, Field::Density)];

/// Refuses a span or a rise of which alone no arc is made.
pub fn makes_an_arc(has: impl Fn(Field) -> bool, spelling: Spelling) -> Result<(), Misfit> {
    let mut of_arc = ARC.into_iter().filter(|field| has(*field));
    if let (Some(one @ (Field::Span | Field::Rise)), None) = (of_arc.next(), of_arc.next()) {
        let other = if one == Field::Span { Field::Rise } else { Field::Span };
        let all = [one, other, Field::Radius, Field::HalfOpening];
        let [one_of, other, radius, alpha] = all.map(|field| spelling.of(field));
        return Err(Misfit::new(one, format!("{one_of} needs {other}, {radius} or {alpha}")));
    }
    Ok(())
}

impl ArchQuestion {
    /// Question that takes any field, about an arch with a half opening and a friction.
    pub const ANY: Self = Self { refuses: &[], needs: &[], unlimited: false, example: "" };

    /// Checks that what is given goes together.
    pub fn fits(&self, asked: &ArchAsked, spelling: Spelling) -> Result<(), Misfit> {
        let has = |field: Field| asked.get(field).is_some();
        let name = |field: Field| spelling.of(field);
        if let Some((field, why)) = self.refuses.iter().find(|(field, _)| has(*field)) {
            return Err(Misfit::new(
                *field,
                format!("{} does not belong here: {why}", name(*field)),
            ));
        }
        if let Some((one, other)) = INSTEAD.into_iter().find(|(a, b)| has(*a) && has(*b)) {
            let message =
                format!("{} and {} say the same: give one of them", name(one), name(other));
            return Err(Misfit::new(other, message));
        }
        makes_an_arc(has, spelling)?;
        if let Some((one, other)) = WITH.into_iter().find(|(a, b)| has(*a) && !has(*b)) {
            return Err(Misfit::new(one, format!("{} needs {}", name(one), name(other))));
        }
        let has_size = [Field::Span, Field::Rise, Field::Radius].into_iter().any(has);
        let sized = [Field::Density, Field::MeasuredAt].into_iter().find(|of| has(*of));
        if let Some(sized) = sized.filter(|_| !has_size) {
            let what = match sized {
                Field::Density => "forces need".to_owned(),
                _ => format!("{} needs", name(sized)),
            };
            let [span, rise, radius] = [Field::Span, Field::Rise, Field::Radius].map(name);
            let message = format!("{what} a size: give {span} and {rise}, or {radius}");
            return Err(Misfit::new(sized, message));
        }
        Ok(())
    }

    /// Checks that nothing is missing. All that is missing is told at once.
    pub fn is_whole(&self, asked: &ArchAsked, spelling: Spelling) -> Result<(), Misfit> {
        let missing = self.missing(asked, spelling);
        if missing.is_empty() {
            return Ok(());
        }
        let verb = if missing.len() == 1 { "is" } else { "are" };
        let example = match spelling {
            Spelling::Option => format!("; for example: {}", self.example),
            Spelling::Key => String::new(),
        };
        let message = format!("{} {verb} missing{example}", missing.join(", "));
        Err(Misfit { field: None, message })
    }

    /// Fields that are missing, with what would do as well.
    fn missing(&self, asked: &ArchAsked, spelling: Spelling) -> Vec<String> {
        let has = |field: Field| asked.get(field).is_some();
        let mut missing = Vec::new();
        if ![Field::HalfOpening, Field::Span, Field::Rise, Field::Joints].into_iter().any(has) {
            missing.push(spelling.of(Field::HalfOpening));
        }
        if !self.unlimited && !has(Field::Friction) && !has(Field::FrictionAngle) {
            let [mu, phi] = [Field::Friction, Field::FrictionAngle].map(|of| spelling.of(of));
            missing.push(format!("{mu} (or {phi})"));
        }
        for &field in self.needs {
            if field == Field::Stones && !has(Field::Stones) && !has(Field::Joints) {
                missing.push(format!("{} (or {})", spelling.of(field), spelling.of(Field::Joints)));
            } else if field != Field::Stones && !has(field) {
                missing.push(spelling.of(field));
            }
        }
        missing
    }
}
