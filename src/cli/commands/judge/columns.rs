//! Which column of a file is what.

use crate::cli::failure::Failure;
use crate::problem::Quantity;
use crate::report::words::shortened;

/// What a column can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Weight,
    HalfOpening,
    Friction,
    FrictionAngle,
    Stands,
    Mode,
    Number(Quantity),
}

impl Role {
    fn all() -> impl Iterator<Item = Self> {
        use Role::*;
        let others = [Weight, HalfOpening, Friction, FrictionAngle, Stands, Mode];
        others.into_iter().chain(Quantity::STATE.map(Number))
    }

    /// Our name for it.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Weight => "weight",
            Self::HalfOpening => "half_opening",
            Self::Friction => "friction",
            Self::FrictionAngle => "friction_angle",
            Self::Stands => "stands",
            Self::Mode => "mode",
            Self::Number(quantity) => quantity.name(),
        }
    }

    /// What else it is called where no columns are named.
    fn alias(self) -> Option<&'static str> {
        match self {
            Self::HalfOpening => Some("alpha"),
            Self::Friction => Some("mu"),
            Self::Number(Quantity::Thickness) => Some("eta"),
            _ => None,
        }
    }

    fn is_angle(self) -> bool {
        match self {
            Self::HalfOpening | Self::FrictionAngle => true,
            Self::Number(quantity) => quantity.is_angle(),
            _ => false,
        }
    }

    /// Whether it is something that can be judged.
    fn is_claim(self) -> bool {
        matches!(self, Self::Stands | Self::Mode | Self::Number(_))
    }
}

/// A column and its role.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Column {
    /// Its name in the file.
    pub theirs: String,
    /// What it is.
    pub role: Role,
    /// Whether it is an angle in degrees.
    pub degrees: bool,
}

/// The columns of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Columns {
    /// Those that may be there.
    pub all: Vec<Column>,
    /// Whether they were named, and so have to be there.
    named: bool,
}

impl Columns {
    /// Columns as they are named on the command line, `theirs=ours` or `theirs=ours:deg`; our own names
    /// if none are named.
    pub(super) fn new(named: &[String]) -> Result<Self, String> {
        if named.is_empty() {
            let own = Role::all().flat_map(|role| {
                let names = [Some(role.name()), role.alias()].into_iter().flatten();
                names.map(move |name| Column { theirs: name.to_owned(), role, degrees: false })
            });
            return Ok(Self { all: own.collect(), named: false });
        }
        let mut all: Vec<Column> = Vec::new();
        for text in named {
            let column = column(text)?;
            if let Some(other) = all.iter().find(|other| other.role == column.role) {
                let (a, b) = (&other.theirs, &column.theirs);
                return Err(format!("'{a}' and '{b}' are both named {}", column.role.name()));
            }
            if all.iter().any(|other| other.theirs == column.theirs) {
                return Err(format!("the column '{}' is named twice", column.theirs));
            }
            all.push(column);
        }
        Ok(Self { all, named: true })
    }

    /// Keeps the columns that a CSV file has, with their places.
    pub(super) fn places(&mut self, header: &csv::StringRecord) -> Result<Vec<usize>, Failure> {
        let place = |column: &Column| header.iter().position(|name| name == column.theirs);
        let seen: Vec<bool> = self.all.iter().map(|column| place(column).is_some()).collect();
        let shown =
            |message| Failure::Input(format!("{message}; its columns are {}", shown(header)));
        self.check(&seen, "the file has").map_err(shown)?;
        self.all.retain(|column| place(column).is_some());
        for column in &self.all {
            if header.iter().filter(|name| *name == column.theirs).count() > 1 {
                let message = format!("the file has two columns '{}'", column.theirs);
                return Err(Failure::Input(message));
            }
        }
        Ok(self.all.iter().filter_map(place).collect())
    }

    /// Refuses what cannot be judged, by the columns that are there.
    pub(super) fn check(&self, seen: &[bool], have: &str) -> Result<(), String> {
        let missing = self.all.iter().zip(seen).find(|(_, seen)| self.named && !**seen);
        if let Some((column, _)) = missing {
            return Err(format!("{have} no column '{}'", column.theirs));
        }
        let there = || self.all.iter().zip(seen).filter(|(_, seen)| **seen).map(|(c, _)| c);
        let has = |role: Role| there().any(|column| column.role == role);
        for (index, column) in there().enumerate() {
            if let Some(other) = there().skip(index + 1).find(|c| c.role == column.role) {
                let (a, b) = (&column.theirs, &other.theirs);
                return Err(format!("{have} '{a}' and '{b}', which are the same: use --columns"));
            }
        }
        let wanted = |what: &str, how: &str| {
            Err(format!("{have} no column for {what}: name one, --columns {how}"))
        };
        if !has(Role::HalfOpening) {
            return wanted("the half opening", "theirs=half_opening");
        }
        match (has(Role::Friction), has(Role::FrictionAngle)) {
            (false, false) => return wanted("the friction", "theirs=friction"),
            (true, true) => {
                return Err(format!("{have} both friction and friction_angle: choose one"));
            }
            _ => {}
        }
        if !there().any(|column| column.role.is_claim()) {
            return wanted("anything to judge", "theirs=thickness");
        }
        Ok(())
    }

    /// The weight is in a column or given for all rows, and not both.
    pub(super) fn check_weight(&self, seen: &[bool], is_given: bool) -> Result<(), Failure> {
        let column = self.all.iter().zip(seen).any(|(c, seen)| *seen && c.role == Role::Weight);
        match (column, is_given) {
            (true, true) => Err("the file has a column for the weight, so --weight is not needed"),
            (false, false) => {
                Err("the weight is missing: --weight heyman or --weight milankovitch, or a column")
            }
            _ => Ok(()),
        }
        .map_err(|message| Failure::Input(message.into()))
    }
}

/// The columns of a file in a message: not all of many, nor all of a long name.
fn shown(header: &csv::StringRecord) -> String {
    const COLUMNS: usize = 20;
    let name = |name: &str| format!("'{}'", shortened(name).escape_debug());
    let mut names: Vec<String> = header.iter().take(COLUMNS).map(name).collect();
    if header.len() > COLUMNS {
        names.push(format!("and {} more", header.len() - COLUMNS));
    }
    names.join(", ")
}

/// `theirs=ours`, `theirs=ours:deg`, or a name that is theirs and ours.
fn column(text: &str) -> Result<Column, String> {
    let (theirs, ours) = text.rsplit_once('=').unwrap_or((text, text));
    let (ours, unit) = match ours.rsplit_once(':') {
        Some((ours, unit)) => (ours, Some(unit)),
        None => (ours, None),
    };
    let theirs = if text.contains('=') { theirs } else { ours };
    let Some(role) = Role::all().find(|role| role.name() == ours.trim()) else {
        let names: Vec<_> = Role::all().map(Role::name).collect();
        return Err(format!("'{ours}' is not one of our columns: {}", names.join(", ")));
    };
    if theirs.trim().is_empty() {
        return Err(format!("'{text}' does not name a column: theirs={}", role.name()));
    }
    let degrees = match unit {
        None => false,
        Some("rad") if role.is_angle() => false,
        Some("deg") if role.is_angle() => true,
        Some(unit) if role.is_angle() => {
            return Err(format!("'{unit}' is not a unit of angles: rad or deg"));
        }
        Some(_) => return Err(format!("{} has no unit; only angles have", role.name())),
    };
    Ok(Column { theirs: theirs.trim().to_owned(), role, degrees })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(text: &str) -> Result<Columns, String> {
        Columns::new(&text.split(',').map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn columns_are_named() {
        let columns =
            named("a=half_opening:deg,mu=friction,t/r = thickness,x=y=thrust,mode").unwrap();
        let shown: Vec<_> =
            columns.all.iter().map(|c| (c.theirs.as_str(), c.role.name(), c.degrees)).collect();
        assert_eq!(
            shown,
            [
                ("a", "half_opening", true),
                ("mu", "friction", false),
                ("t/r", "thickness", false),
                ("x=y", "thrust", false),
                ("mode", "mode", false),
            ]
        );
    }

    #[test]
    fn wrong_names_are_refused() {
        for (text, why) in [
            ("a=opening", "is not one of our columns"),
            ("a", "is not one of our columns"),
            ("=thrust", "does not name a column"),
            ("", "is not one of our columns"),
            ("a=thrust,b=thrust", "both named thrust"),
            ("a=thrust,a=mode", "named twice"),
            ("a=thrust:deg", "has no unit"),
            ("a=half_opening:grad", "rad or deg"),
        ] {
            let error = named(text).unwrap_err();
            assert!(error.contains(why), "{text}: {error}");
        }
    }
}
