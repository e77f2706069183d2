//! A row of results: its arch, and what it claims.

use super::columns::{Columns, Role};
use crate::arch::SelfWeight;
use crate::cli::commands::parse;
use crate::judge::{Claim, Demand, Said, judge};
use crate::number::{ExactNumber, ParseExactError};
use crate::problem::{Arch, Friction};
use crate::report::judged::JudgedRow;
use rug::Rational;

/// The text of a row, column by column; `None` where the row has no such column.
pub(super) type Cells = Vec<Option<String>>;

/// How rows are read and judged.
pub(super) struct Judge {
    pub columns: Columns,
    /// The weight of all rows, if it is not in a column.
    pub weight: Option<SelfWeight>,
    /// Whether the solver was run at the nearest doubles of what the file has.
    pub doubles: bool,
    pub demand: Demand,
}

impl Judge {
    /// Judges a row.
    pub(super) fn row(&self, line: u64, cells: Result<Cells, String>) -> JudgedRow {
        let mut row = JudgedRow {
            line,
            weight: self.weight.map_or("", SelfWeight::name).to_owned(),
            half_opening: String::new(),
            friction: String::new(),
            claimed_stands: None,
            claimed_mode: None,
            outcome: Err(String::new()),
        };
        row.outcome = cells.and_then(|cells| {
            self.describe(&cells, &mut row);
            let arch = self.arch(&cells)?;
            let claim = self.claim(&cells)?;
            row.claimed_stands = claim.stands;
            row.claimed_mode = claim.mode.map(|mode| mode.label());
            Ok(judge(&arch, &claim, self.demand))
        });
        row
    }

    /// The text of a role, with whether it is in degrees.
    fn said<'a>(&self, cells: &'a Cells, role: Role) -> Option<(&'a str, bool)> {
        self.columns.all.iter().zip(cells).find_map(|(column, cell)| {
            let text = cell.as_deref().filter(|_| column.role == role)?;
            Some((text, column.degrees && !text.ends_with("deg")))
        })
    }

    /// The arch of the row as text, even if it cannot be read.
    fn describe(&self, cells: &Cells, row: &mut JudgedRow) {
        let text = |role| {
            let (text, degrees) = self.said(cells, role)?;
            Some(format!("{text}{}", if degrees { "deg" } else { "" }))
        };
        row.weight = text(Role::Weight).unwrap_or(std::mem::take(&mut row.weight));
        row.half_opening = text(Role::HalfOpening).unwrap_or_default();
        let angle = || text(Role::FrictionAngle).map(|angle| format!("tan({angle})"));
        row.friction = text(Role::Friction).or_else(angle).unwrap_or_default();
    }

    fn arch(&self, cells: &Cells) -> Result<Arch, String> {
        let weight = match (self.weight, self.said(cells, Role::Weight)) {
            (Some(weight), _) => weight,
            (None, Some((text, _))) => parse::weight(text)?,
            (None, None) => return Err("the weight is missing".into()),
        };
        let given = |role: Role| match self.said(cells, role) {
            Some(("", _)) => Err(format!("the {} is empty", role.name())),
            said => Ok(said),
        };
        let half_opening = given(Role::HalfOpening)?.ok_or("the half opening is missing")?;
        let friction = match (given(Role::Friction)?, given(Role::FrictionAngle)?) {
            (Some((text, _)), None) => self.coefficient(text)?,
            (None, Some(phi)) => Friction::Angle(self.angle(phi)?),
            (None, None) => return Err("the friction is missing".into()),
            (Some(_), Some(_)) => return Err("both friction and friction_angle are given".into()),
        };
        Arch::new(weight, self.angle(half_opening)?, friction).map_err(|error| error.to_string())
    }

    fn coefficient(&self, text: &str) -> Result<Friction, String> {
        let unlimited = ["inf", "+inf", "infinity"];
        if unlimited.iter().any(|word| text.eq_ignore_ascii_case(word)) {
            return Ok(Friction::Infinite);
        }
        match text.parse().map_err(error)? {
            Friction::Coefficient(mu) if self.doubles => nearest(&mu).map(Friction::Coefficient),
            // An angle in the column of coefficients, as our own outputs have it.
            Friction::Angle(_) => {
                let inside = text.strip_prefix("tan(").and_then(|rest| rest.strip_suffix(')'));
                self.angle((inside.unwrap_or(text), false)).map(Friction::Angle)
            }
            friction => Ok(friction),
        }
    }

    /// An angle. In doubles, degrees are rounded as they are read and once more in radians.
    fn angle(&self, (text, degrees): (&str, bool)) -> Result<ExactNumber, String> {
        let text = if degrees { format!("{text}deg") } else { text.to_owned() };
        let exact: ExactNumber = text.parse().map_err(error)?;
        if !self.doubles {
            return Ok(exact);
        }
        match text.strip_suffix("deg") {
            Some(degrees) => nearest(&nearest(&degrees.parse().map_err(error)?)?.degrees()),
            None => nearest(&exact),
        }
    }

    fn claim(&self, cells: &Cells) -> Result<Claim, String> {
        let text = |role| self.said(cells, role).map(|(text, _)| text);
        let numbers = self.columns.all.iter().zip(cells).filter_map(|(column, cell)| {
            let Role::Number(quantity) = column.role else { return None };
            Some((quantity, cell.as_deref()?, column.degrees))
        });
        let said =
            Said { stands: text(Role::Stands), mode: text(Role::Mode), numbers: numbers.collect() };
        Claim::read(&said).map_err(|error| error.to_string())
    }
}

fn error(error: ParseExactError) -> String {
    error.to_string()
}

/// The nearest double, exactly.
fn nearest(x: &ExactNumber) -> Result<ExactNumber, String> {
    let exact = x.nearest_double().and_then(Rational::from_f64);
    exact.as_ref().map(ExactNumber::from).ok_or_else(|| format!("'{x}' is beyond all doubles"))
}
