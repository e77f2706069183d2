//! The arch of a row.

use super::columns::{Cells, Columns};
use super::number_style::{NumberStyle, is_bare};
use super::roles::Role;
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Spelling};
use crate::number::{ExactNumber, ParseExactError, is_range, shown};
use crate::parse;
use crate::problem::measures::Measures;
use crate::problem::{Arch, Friction};
use rug::Rational;
use std::borrow::Cow;

/// Arch of a row, with its thickness and its measures where it has any.
pub(super) type RowArch = (Arch, Option<ExactNumber>, Option<Measures>);

/// Reader of the arches of rows.
pub struct ArchReader {
    /// Roles of the cells of a row.
    pub columns: Columns,
    /// The weight of the rows that have none of their own.
    pub weight: SelfWeight,
    /// True if the arches are those at the nearest doubles of what the file has.
    pub doubles: bool,
    /// The words that a table uses for infinity and for nothing.
    pub spelling: NumberStyle,
}

impl ArchReader {
    /// The text of a role, with the unit of its column if it has none of its own.
    pub fn said<'a>(&self, cells: &'a Cells, role: Role) -> Option<(&'a str, &'static str)> {
        self.columns.all.iter().zip(cells).find_map(|(column, cell)| {
            let text = cell.as_deref().filter(|_| column.role == role)?;
            Some((text, if is_bare(text) { column.unit } else { "" }))
        })
    }

    /// The text of a role, where the cell is not empty.
    pub fn given<'a>(&self, cells: &'a Cells, role: Role) -> Option<(&'a str, &'static str)> {
        self.said(cells, role).filter(|(text, _)| !text.is_empty())
    }

    /// The weight, the half opening and the friction of the row as text, even if they cannot be read.
    pub fn described(&self, cells: &Cells) -> [String; 3] {
        let text = |role| {
            let (text, unit) = self.given(cells, role)?;
            Some(format!("{text}{unit}"))
        };
        let given = |field| text(Role::Given(field));
        let angle = || given(Field::FrictionAngle).map(|angle| format!("tan({angle})"));
        [
            text(Role::Weight).unwrap_or_else(|| self.weight.name().to_owned()),
            given(Field::HalfOpening).unwrap_or_default(),
            given(Field::Friction).or_else(angle).unwrap_or_default(),
        ]
    }

    /// The question of a row whose cells may be ranges, and its weight.
    pub fn ranged(&self, cells: &Cells) -> Result<(SelfWeight, ArchAsked), String> {
        let mut asked = ArchAsked::default();
        for (column, cell) in self.columns.all.iter().zip(cells) {
            let text = cell.as_deref().filter(|text| !text.is_empty());
            if let (Some(field), Some(text)) = (column.role.field(), text) {
                *asked.at(field) = Some(self.spelling.exact_range(text, column.unit));
            }
        }
        Ok((self.own_weight(cells)?, asked))
    }

    /// Checks that no cell of the arch is a range, which is many arches.
    fn one_arch(&self, cells: &Cells) -> Result<(), String> {
        let range = self.columns.all.iter().zip(cells).find_map(|(column, cell)| {
            Some((column.role.field()?, cell.as_deref().filter(|text| is_range(text))?))
        });
        range.map_or(Ok(()), |(field, text)| {
            let why = self.columns.why_no_range();
            Err(format!("{} {} is a range{why}", field.name(), shown(text)))
        })
    }

    fn own_weight(&self, cells: &Cells) -> Result<SelfWeight, String> {
        let text = self.given(cells, Role::Weight);
        text.map_or(Ok(self.weight), |(text, _)| parse::weight(text))
    }

    /// The arch of a row, which has no ranges.
    pub fn arch(&self, cells: &Cells) -> Result<RowArch, String> {
        self.one_arch(cells)?;
        let (weight, asked) = self.ranged(cells)?;
        let is_there = |field| self.said(cells, Role::Given(field)).is_some();
        let missing = |field: Field| {
            let how = if is_there(field) { "empty" } else { "missing" };
            format!("the {} is {how}", field.name())
        };
        let fits = ArchQuestion::ANY.fits(&asked, Spelling::Key);
        let given = fits.and_then(|()| ArchGiven::new(&asked, Spelling::Key));
        let ArchGiven { half_opening, friction, thickness, measures, .. } =
            given.map_err(|misfit| misfit.message)?;
        let half_opening = half_opening.ok_or_else(|| missing(Field::HalfOpening))?;
        let friction = friction.ok_or_else(|| match is_there(Field::FrictionAngle) {
            true => missing(Field::FrictionAngle),
            false => missing(Field::Friction),
        })?;
        let friction = match friction {
            Friction::Coefficient(mu) if self.doubles => Friction::Coefficient(nearest(&mu)?),
            Friction::Angle(phi) => Friction::Angle(self.used(phi)?),
            friction => friction,
        };
        let arch = Arch::new(weight, self.used(half_opening)?, friction);
        Ok((arch.map_err(|error| error.to_string())?, thickness, measures))
    }

    /// The exact text of what is said, with its unit.
    pub fn exact<'a>(&self, (text, unit): (&'a str, &str)) -> Cow<'a, str> {
        let exact = self.spelling.exact(text);
        if unit.is_empty() { exact } else { (exact.into_owned() + unit).into() }
    }

    /// An angle as a solver used it. In doubles, degrees are rounded as they are read and once more in
    /// radians.
    fn used(&self, angle: ExactNumber) -> Result<ExactNumber, String> {
        if !self.doubles {
            return Ok(angle);
        }
        match angle.to_string().strip_suffix("deg") {
            Some(degrees) => {
                let degrees: ExactNumber =
                    degrees.parse().map_err(|error: ParseExactError| error.to_string())?;
                nearest(&nearest(&degrees)?.degrees())
            }
            None => nearest(&angle),
        }
    }
}

/// The nearest double, exactly.
fn nearest(x: &ExactNumber) -> Result<ExactNumber, String> {
    let exact = x.nearest_double().and_then(Rational::from_f64);
    exact.as_ref().map(ExactNumber::from).ok_or_else(|| format!("'{x}' is beyond all doubles"))
}
