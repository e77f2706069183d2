//! Columns of a file, and what each is.

use super::object::JsonObject;
use super::roles::{Purpose, Role};
use crate::ask::{Field, Spelling, makes_an_arc};
use crate::problem::Quantity;
use crate::report::words::{first_of, shortened};
use std::borrow::Cow;

/// The text of a row, column by column; `None` where the row has no such column.
pub type Cells = Vec<Option<String>>;

/// A column and its role.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowColumn {
    /// Name of the column in the file; our own one in small letters.
    pub theirs: String,
    /// Role of the column.
    pub role: Role,
    /// Unit of the cells that have none of their own; empty where they are numbers.
    pub unit: &'static str,
}

/// The columns of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns {
    /// Columns that may be there.
    pub all: Vec<RowColumn>,
    /// True if the columns were named, and so have to be there.
    named: bool,
    purpose: Purpose,
    /// Names that are handed on.
    kept: Vec<String>,
}

impl Columns {
    /// Our own names.
    pub fn own(purpose: Purpose) -> Self {
        let mut all = Vec::new();
        for role in purpose.roles() {
            // Where arches are asked about a name may have its unit behind it.
            let units = if purpose == Purpose::Ask { role.units() } else { &[] };
            for unit in std::iter::once("").chain(units.iter().copied()) {
                let theirs = |name: &str| plain(&format!("{name} {unit}")).into_owned();
                let column = |name| RowColumn { theirs: theirs(name), role, unit };
                all.extend(role.names(purpose).into_iter().map(column));
            }
        }
        Self { all, named: false, purpose, kept: Vec::new() }
    }

    /// Columns as they are named on the command line, `theirs=ours` or `theirs=ours:deg`; our own names if
    /// none are named.
    pub fn named(named: &[String], purpose: Purpose) -> Result<Self, String> {
        if named.is_empty() {
            return Ok(Self::own(purpose));
        }
        let mut all: Vec<RowColumn> = Vec::new();
        for text in named {
            let column = column(text, purpose)?;
            if let Some(other) = all.iter().find(|other| other.role == column.role) {
                let (a, b) = (&other.theirs, &column.theirs);
                return Err(format!("'{a}' and '{b}' are both named {}", column.role.name()));
            }
            if all.iter().any(|other| other.theirs == column.theirs) {
                return Err(format!("the column '{}' is named twice", column.theirs));
            }
            all.push(column);
        }
        Ok(Self { all, named: true, purpose, kept: Vec::new() })
    }

    /// Tells whether a field of an arch has a column.
    pub fn has(&self, field: Field) -> bool {
        self.all.iter().any(|column| column.role == Role::Given(field))
    }

    /// Columns beside which some names are handed on.
    pub(super) fn beside(self, kept: Vec<String>) -> Self {
        Self { kept, ..self }
    }

    /// Reason why a cell is no range, with what to do instead.
    pub(super) fn why_no_range(&self) -> &'static str {
        match self.purpose {
            Purpose::Ask => {
                ": `couplet states --ranges` tells of every arch inside; give one value here"
            }
            Purpose::Judge | Purpose::Assemblies => {
                ", which is not judged: `couplet states --ranges --keep all` writes what is proved of every arch \
                 beside what the file has"
            }
        }
    }

    /// Tells whether a name of the file, with its plain form, is that of a column. Our own names may have capitals and
    /// blanks.
    fn is_plain(&self, column: &RowColumn, name: &str, plain: &str) -> bool {
        column.theirs == name || (!self.named && column.theirs == plain)
    }

    /// Tells which columns ask anything beside others: in our own answers neither the thickness of states, which is the
    /// least one, nor the circle of sizes that are told.
    fn asks<F: Fn(&str) -> bool>(&self, has: F) -> impl Fn(&RowColumn) -> bool + use<F> {
        let is_ours = self.purpose == Purpose::Ask && (has("can_stand") || has("stands"));
        let is_named = self.named;
        let is_least = is_ours && has("can_stand") && !has("least_thickness");
        let is_told = is_ours && has("half_opening") && !has("span") && !has("radius");
        move |column| match column.role {
            // Of what is told nothing is asked again in another unit; a sample tells half openings in three.
            _ if !column.unit.is_empty() && !is_named => {
                let is_again = has("half_opening") && column.theirs.starts_with("half_opening");
                !is_ours && !is_again
            }
            Role::Given(Field::Thickness) => !is_least,
            Role::Given(Field::MeasuredAt) => !is_told,
            _ => true,
        }
    }

    /// Tells whether a name of the file is that of any column.
    pub(crate) fn have(&self, name: &str) -> bool {
        let plain = &*plain(name);
        self.all.iter().any(|column| self.is_plain(column, name, plain))
    }

    /// The places of each column among the names of a table or of an object, where it is there and asks anything. A
    /// name that asks what is not read is refused, unless nothing stands under it.
    fn found(
        &self,
        names: &[&str],
        is_empty: impl Fn(&str) -> bool,
    ) -> Result<Vec<Vec<usize>>, String> {
        let plains: Vec<Cow<str>> = names.iter().map(|name| plain(name)).collect();
        let asks = self.asks(|name| plains.iter().any(|plain| plain == name));
        let is = |column: &RowColumn, at: usize| self.is_plain(column, names[at], &plains[at]);
        let places = |column: &RowColumn| match asks(column) {
            true => (0..names.len()).filter(|at| is(column, *at)).collect(),
            false => Vec::new(),
        };
        let found: Vec<Vec<usize>> = self.all.iter().map(places).collect();
        let there = || self.all.iter().zip(&found).filter(|(_, places)| !places.is_empty());
        let is_none = |at: &usize| !self.all.iter().any(|column| is(column, *at));
        for name in (0..names.len()).filter(is_none).map(|at| names[at]) {
            let has = |role| there().any(|(column, _)| column.role == role);
            let why = self.unread(name).filter(|_| !is_empty(name));
            why.or_else(|| self.misspelt(name, has)).map_or(Ok(()), Err)?;
        }
        Ok(found)
    }

    /// Keeps the columns that a table has, with their places.
    pub fn places(&mut self, header: &[String]) -> Result<Vec<usize>, String> {
        self.all.retain(self.asks(|name| header.iter().any(|other| plain(other) == name)));
        let names: Vec<&str> = header.iter().map(String::as_str).collect();
        let found = self.found(&names, |_| false)?;
        let seen: Vec<bool> = found.iter().map(|places| !places.is_empty()).collect();
        let shown = |message| format!("{message}; its columns are {}", shown(header));
        self.check(&seen, "the file has").map_err(shown)?;
        if let Some((column, _)) = self.all.iter().zip(&found).find(|(_, all)| all.len() > 1) {
            return Err(format!("the file has two columns '{}'", column.theirs));
        }
        let mut seen = seen.iter();
        self.all.retain(|_| seen.next() == Some(&true));
        Ok(found.concat())
    }

    /// The cells of an object.
    pub fn cells(&self, object: &JsonObject) -> Result<Cells, String> {
        let names: Vec<&str> = object.names().collect();
        let text = |name: &str| object.text(name);
        let found = self.found(&names, |name| text(name).is_none_or(|text| text.is_empty()))?;
        let mut there: Vec<(Role, &str)> = Vec::new();
        for (column, places) in self.all.iter().zip(&found) {
            for name in places.iter().map(|place| names[*place]) {
                if let Some((_, other)) = there.iter().find(|(role, _)| *role == column.role) {
                    return Err(format!("'{other}' and '{}' are the same", shortened(name)));
                }
                there.push((column.role, name));
            }
        }
        Ok(found.iter().map(|places| text(names[*places.first()?])).collect())
    }

    /// Reason why a name of an arch that nothing here is asked about is refused, unless it is handed on by name: it
    /// must not be dropped.
    fn unread(&self, name: &str) -> Option<String> {
        let is_kept = || self.kept.iter().any(|kept| kept == name);
        // The circle of sizes that are told alone asks nothing.
        let is_read = |field: Field| {
            let is = |role: &Role| role.field() == Some(field);
            field == Field::MeasuredAt || self.purpose.roles().iter().any(is)
        };
        let asks = self.purpose != Purpose::Assemblies;
        let why = unanswered(name, is_read).filter(|_| asks && !is_kept())?;
        Some(format!("{why}, and --keep {} hands it on", shortened(name)))
    }

    /// Reason why a name that is nearly one of ours and asks for nothing is refused: what it asks must not be dropped.
    fn misspelt(&self, name: &str, has: impl Fn(Role) -> bool) -> Option<String> {
        if self.purpose != Purpose::Ask {
            return None;
        }
        let nearly = |column: &&RowColumn| {
            let similar = strsim::normalized_damerau_levenshtein(&column.theirs, &plain(name));
            column.theirs.len() > 4 && similar > 0.8 && !has(column.role)
        };
        let (name, ours) = (shortened(name), &self.all.iter().find(nearly)?.theirs);
        Some(format!("'{name}' is not one of our columns; did you mean '{ours}'?"))
    }

    /// Refuses what cannot be asked or judged, by the columns that are there.
    pub fn check(&self, seen: &[bool], have: &str) -> Result<(), String> {
        let missing = self.all.iter().zip(seen).find(|(_, seen)| self.named && !**seen);
        if let Some((column, _)) = missing {
            return Err(format!("{have} no column '{}'", column.theirs));
        }
        let there = || self.all.iter().zip(seen).filter(|(_, seen)| **seen).map(|(c, _)| c);
        let has = |role: Role| there().any(|column| column.role == role);
        for (index, column) in there().enumerate() {
            if let Some(other) = there().skip(index + 1).find(|c| c.role == column.role) {
                let (a, b) = (&column.theirs, &other.theirs);
                let how = if self.purpose == Purpose::Judge { ": use --columns" } else { "" };
                return Err(format!("{have} '{a}' and '{b}', which are the same{how}"));
            }
        }
        let need = |is_there: bool, what: &str, (role, instead): (Role, &str)| {
            let name = role.name();
            match self.purpose {
                _ if is_there => Ok(()),
                Purpose::Ask => Err(format!("{have} no column '{name}', nor {instead}")),
                Purpose::Judge | Purpose::Assemblies => {
                    Err(format!("{have} no column for {what}: name one, --columns theirs={name}"))
                }
            }
        };
        if self.purpose == Purpose::Assemblies {
            return need(has(Role::Stands), "the verdict", (Role::Stands, ""));
        }
        let given = |field| has(Role::Given(field));
        makes_an_arc(given, Spelling::Key).map_err(|misfit| misfit.message)?;
        let sizes = [Field::Span, Field::Rise, Field::Radius].into_iter().filter(|of| given(*of));
        let is_opened = given(Field::HalfOpening) || sizes.count() >= 2;
        let instead = "two of 'span', 'rise' and 'radius'";
        need(is_opened, "the half opening", (Role::Given(Field::HalfOpening), instead))?;
        let [mu, phi] = [Field::Friction, Field::FrictionAngle].map(given);
        need(mu || phi, "the friction", (Role::Given(Field::Friction), "'friction_angle'"))?;
        if mu && phi && self.named {
            return Err(format!("{have} both friction and friction_angle: choose one"));
        }
        let is_judged = self.purpose != Purpose::Judge || there().any(|of| of.role.is_claim());
        need(is_judged, "anything to judge", (Role::Number(Quantity::Thickness), ""))
    }
}

/// Reason why a column of an arch's name is not read, with the command that answers it; nothing of other names.
pub fn unanswered(name: &str, is_read: impl Fn(Field) -> bool) -> Option<String> {
    let field = Field::ALL.iter().copied().find(|field| field.name() == plain(name))?;
    let (name, option) = (shortened(name), Spelling::Option.of(field));
    (!is_read(field))
        .then(|| format!("'{name}' is not read here: `couplet assess {option}` answers it"))
}

/// A name without capitals, with `_` for what joins its words and its unit, and the names of Greek letters.
fn plain(name: &str) -> Cow<'_, str> {
    if name.bytes().all(|c| c.is_ascii_lowercase() || c == b'_') {
        return name.into();
    }
    let mut plain = name.to_lowercase().replace([']', ')'], "").replace("^3", "3");
    for (sign, word) in SIGNS {
        plain = plain.replace(sign, word);
    }
    let words = plain.split([' ', '-', '[', '(', '_']).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_").into()
}

/// Signs of a head, and what they are called; the small mu has two characters.
const SIGNS: [(&str, &str); 8] = [
    ("α", "alpha"),
    ("μ", "mu"),
    ("µ", "mu"),
    ("φ", "phi"),
    ("η", "eta"),
    ("°", "deg"),
    ("º", "deg"),
    ("³", "3"),
];

/// The columns of a file in a message: not all of many, nor all of a long name.
fn shown(header: &[String]) -> String {
    let names: Vec<String> = header.iter().map(|name| format!("'{}'", shortened(name))).collect();
    first_of(&names, 20)
}

/// `theirs=ours`, `theirs=ours:deg`, or a name that is theirs and ours.
fn column(text: &str, purpose: Purpose) -> Result<RowColumn, String> {
    let (theirs, ours) = text.rsplit_once('=').unwrap_or((text, text));
    let (ours, unit) = ours.rsplit_once(':').map_or((ours, None), |(of, unit)| (of, Some(unit)));
    let theirs = if text.contains('=') { theirs } else { ours };
    let roles = purpose.roles();
    let name = plain(ours.trim());
    let Some(role) = roles.iter().copied().find(|role| role.names(purpose).contains(&&*name))
    else {
        let names: Vec<_> = roles.iter().map(|role| role.name()).collect();
        return Err(format!("'{ours}' is not one of our columns: {}", names.join(", ")));
    };
    if theirs.trim().is_empty() {
        return Err(format!("'{text}' does not name a column: theirs={}", role.name()));
    }
    let unit = match (unit, role.units()) {
        (None, _) => "",
        (Some(_), []) => return Err(format!("{} has no unit", role.name())),
        (Some(unit), units) => {
            let known = units.iter().copied().find(|known| known.eq_ignore_ascii_case(unit));
            known.ok_or_else(|| {
                format!("'{unit}' is no unit of {}: {}", role.name(), units.join(", "))
            })?
        }
    };
    Ok(RowColumn { theirs: theirs.trim().to_owned(), role, unit })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(text: &str) -> Result<Columns, String> {
        Columns::named(&text.split(',').map(str::to_owned).collect::<Vec<_>>(), Purpose::Judge)
    }

    #[test]
    fn columns_are_named() {
        let columns = named("a=half_opening:deg,mu,t/r = eta,x=y=thrust,mode").unwrap();
        let shown: Vec<_> =
            columns.all.iter().map(|c| (c.theirs.as_str(), c.role.name(), c.unit)).collect();
        assert_eq!(
            shown,
            [
                ("a", "half_opening", "deg"),
                ("mu", "friction", ""),
                ("t/r", "thickness", ""),
                ("x=y", "thrust", ""),
                ("mode", "mode", ""),
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
            ("a=thickness,b=eta", "both named thickness"),
            ("a=thrust,a=mode", "named twice"),
            ("a=thrust:deg", "has no unit"),
            ("a=half_opening:grad", "'grad' is no unit of half_opening: rad, deg, gon"),
        ] {
            let error = named(text).unwrap_err();
            assert!(error.contains(why), "{text}: {error}");
        }
    }

    fn places(header: &str) -> Result<Vec<usize>, String> {
        let header: Vec<String> = header.split(',').map(str::to_owned).collect();
        Columns::own(Purpose::Ask).places(&header)
    }

    #[test]
    fn our_own_names_may_have_capitals() {
        assert_eq!(places("Weight,Half Opening,MU,id").unwrap(), [0, 1, 2]);
        assert_eq!(places("Eta,alpha,Phi").unwrap(), [1, 2, 0]);
    }

    #[test]
    fn a_head_may_have_a_unit_and_greek_letters() {
        for (header, units) in [
            ("α [°],μ,η", ["deg", "", ""]),
            ("Half Opening (deg),Friction,Thickness_cm", ["deg", "", "cm"]),
            ("ALPHA_GON,phi [°],thickness [m]", ["gon", "deg", "m"]),
            ("alpha rad,friction_deg,eta", ["rad", "deg", ""]),
        ] {
            let header: Vec<String> = header.split(',').map(str::to_owned).collect();
            let mut columns = Columns::own(Purpose::Ask);
            let places = columns.places(&header).unwrap();
            let unit = |k: usize| columns.all[places.iter().position(|p| *p == k).unwrap()].unit;
            assert_eq!([0, 1, 2].map(unit), units, "{header:?}");
        }
        let told = places("half_opening,half_opening_deg,mu").unwrap();
        assert_eq!(told, [0, 2], "what is told beside it");
    }

    #[test]
    fn what_has_two_meanings_is_refused() {
        for (header, why) in [
            ("alpha,half_opening,mu", "'half_opening' and 'alpha', which are the same"),
            ("alpha,alpha_deg,mu", "'alpha' and 'alpha_deg', which are the same"),
            ("alpha,mu,mu", "two columns 'mu'"),
            ("alpha,Alpha,mu", "two columns 'alpha'"),
            ("alpha,mu,eta,thickness", "'thickness' and 'eta', which are the same"),
            (
                "alpha,mu,thicknes",
                "'thicknes' is not one of our columns; did you mean 'thickness'?",
            ),
            (
                "alpha,b",
                "the file has no column 'friction', nor 'friction_angle'; its columns are 'alpha', 'b'",
            ),
            ("alpha_rad,alpha_deg,mu", "'alpha_rad' and 'alpha_deg', which are the same"),
        ] {
            let error = places(header).unwrap_err();
            assert!(error.contains(why), "{header}: {error}");
        }
        assert!(places("alpha,mu,thickness,thicknesses").is_ok(), "the one that is meant is there");
    }

    #[test]
    fn a_name_of_an_arch_that_is_not_read_is_refused_unless_it_is_kept() {
        let named = ["a=alpha", "mu", "eta"].map(str::to_owned);
        for (purpose, named, header, refused) in [
            (
                Purpose::Ask,
                &[][..],
                "alpha,mu,Tilt",
                "'Tilt' is not read here: `couplet assess --tilt`",
            ),
            (Purpose::Ask, &named, "a,mu,eta,joints", "--keep joints hands it on"),
            (Purpose::Judge, &[], "alpha,mu,eta,stones", "`couplet assess --stones` answers it"),
            (Purpose::Judge, &named, "a,mu,eta,span", "'span' is not read here"),
        ] {
            let header: Vec<String> = header.split(',').map(str::to_owned).collect();
            let columns = || Columns::named(named, purpose).unwrap();
            let error = columns().places(&header).unwrap_err();
            assert!(error.contains(refused), "{error}");
            assert!(columns().beside(vec![header.last().unwrap().clone()]).places(&header).is_ok());
        }
        assert!(
            Columns::own(Purpose::Judge)
                .places(&["alpha", "mu", "eta", "measured_at"].map(str::to_owned))
                .is_ok()
        );
    }

    #[test]
    fn an_object_has_its_own_columns() {
        let columns = Columns::own(Purpose::Ask);
        let cells = |text: &str| columns.cells(&JsonObject::parse(text.as_bytes()).unwrap());
        let found = cells(r#"{"Alpha":1.50,"mu":"inf","id":7}"#).unwrap();
        assert_eq!(found.into_iter().flatten().collect::<Vec<_>>(), ["1.50", "inf"]);
        assert!(cells(r#"{"alpha":1,"half_opening":1,"mu":1}"#).is_err());
        assert!(cells(r#"{"alpha":1,"mu":1,"thicknes":1}"#).is_err());
        let found = cells(r#"{"alpha":1,"mu":1,"thickness ":2,"thicknes":3}"#).unwrap();
        assert!(found.into_iter().flatten().eq(["1", "1", "2"]), "the one that is meant is there");
        assert!(cells(r#"{"alpha":1,"frictio":1}"#).unwrap_err().contains("'friction'"));
    }
}
