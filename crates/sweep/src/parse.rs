//! Readers of the values of options: one language for every command, and for other doors to the program.

use crate::arch::SelfWeight;
use crate::arch::asymmetric::AsymmetricMode;
use crate::certify::{MAX_DIGITS, Refused};
use crate::check::{self, Engine};
use crate::claims::{Claim, claims};
use crate::number::{Ball, ExactNumber};
use crate::problem::{Arch, Landmark, Mode, NoLandmark, Quantity};
use crate::report::words::{did_you_mean, distinct, list, shortened};
use crate::report::{Content, Format};

/// A name that is not known: what the names are, and the one that was perhaps meant.
pub fn unknown(kind: &str, written: &str, names: &[&str]) -> String {
    let hint = did_you_mean(written, names);
    format!("{kind} is one of {}{hint}", list(names.iter().copied()))
}

/// An arithmetic that checks certificates: one of the checker's own, or that of MPFR.
pub fn engine(text: &str) -> Result<Engine, String> {
    let mpfr = Engine::new("mpfr", |bytes| check::check_file::<Ball>(bytes, check::MAX_DIGITS));
    Engine::named(text, &[mpfr])
}

/// A landmark by its symbol or its long name.
pub fn landmark(text: &str) -> Result<Landmark, String> {
    landmark_or(text, &[])
}

/// Reads a landmark, where other names are read too.
pub fn landmark_or(text: &str, others: &[&str]) -> Result<Landmark, String> {
    text.parse().map_err(|none: NoLandmark| {
        let long = Landmark::ALL.map(Landmark::long_name);
        let names: Vec<&str> =
            Landmark::ALL.into_iter().map(Landmark::symbol).chain(long).collect();
        let names = [&names, others].concat();
        let hint = did_you_mean(text, &names);
        let others = match others {
            [rest @ .., last] => format!(", or {} or {last}", rest.join(", ")),
            [] => String::new(),
        };
        format!("{none}{others}{hint}")
    })
}

/// A mode by its letters, with brackets and commas or without.
pub fn mode(text: &str) -> Result<Mode, String> {
    let names = || list(Mode::ALL.map(Mode::label));
    Mode::named(text).ok_or_else(|| format!("a mode is one of {}", names()))
}

/// A self-weight model by its name.
pub fn weight(text: &str) -> Result<SelfWeight, String> {
    let names = SelfWeight::ALL.map(SelfWeight::name);
    SelfWeight::named(text).ok_or_else(|| unknown("a weight", text, &names))
}

/// One self-weight model, or both.
pub type Weights = &'static [SelfWeight];

/// A self-weight model, or `both`.
pub fn weights(text: &str) -> Result<Weights, String> {
    let all: Weights = &SelfWeight::ALL;
    if text.eq_ignore_ascii_case("both") {
        return Ok(all);
    }
    let [heyman, milankovitch] = SelfWeight::ALL.map(SelfWeight::name);
    let one = SelfWeight::named(text).and_then(|of| all.chunks(1).find(|one| one[0] == of));
    one.ok_or_else(|| unknown("a weight", text, &[heyman, milankovitch, "both"]))
}

/// A quantity by its name.
pub fn quantity(text: &str) -> Result<Quantity, String> {
    use Quantity as Q;
    let measured = [&Q::MEASURED_STATE[..], &Q::MEASURED_ASSESSMENT].concat();
    let all = [&Q::LANDMARK[..], &Q::STATE, &Q::ASSESSMENT, &measured].concat();
    let names = distinct(all.into_iter().map(Q::name));
    Quantity::named(text).ok_or_else(|| unknown("a quantity", text, &names))
}

/// A quantity by its name, of those that there are; others are not offered.
pub fn quantity_of(text: &str, possible: &[Quantity]) -> Result<Quantity, String> {
    let names: Vec<&str> = possible.iter().map(|of| of.name()).collect();
    let quantity = Quantity::named(text).ok_or_else(|| unknown("a quantity", text, &names))?;
    let refused = |refused: Refused| refused.to_string();
    Refused::quantity(quantity, possible).map(|()| quantity).map_err(refused)
}

/// Reads the way in which the mechanism of an asymmetric solution closes, by its name.
pub fn asymmetric_mode(text: &str) -> Result<AsymmetricMode, String> {
    let names = AsymmetricMode::ALL.map(AsymmetricMode::name);
    let mode = AsymmetricMode::ALL.into_iter().find(|mode| mode.name() == text);
    mode.ok_or_else(|| format!("it is one of {}", names.join(", ")))
}

/// Reader of the name of a format.
pub fn format(
    content: Content,
) -> impl Fn(&str) -> Result<&'static Format, String> + Clone + Send + Sync + 'static {
    move |name| {
        let names: Vec<&str> = Format::all(content).map(|format| format.name).collect();
        let format =
            Format::named(content, name).ok_or_else(|| unknown("a format", name, &names))?;
        format.missing().map_or(Ok(format), Err)
    }
}

/// Help of an option of formats.
pub fn format_help(content: Content) -> String {
    format!("Output format: {}", Format::names(content))
}

/// Help of an option of formats of which one is usual.
pub fn usual_format_help(content: Content, usual: &str) -> String {
    let names = format_help(content);
    format!(
        "{names}; if not given what the name of the file ends with tells it, else it is {usual}"
    )
}

/// A number of significant digits.
pub fn digits(text: &str) -> Result<usize, String> {
    // What is no whole number is as little a number of digits as zero.
    let digits = text.parse().unwrap_or(0);
    Refused::digits_to(digits, MAX_DIGITS).map(|()| digits).map_err(|refused| refused.to_string())
}

/// A thickness-to-radius ratio between 0 and the physical limit 2.
pub fn thickness(text: &str) -> Result<ExactNumber, String> {
    crate::problem::thickness(text, None).map_err(|error| error.to_string())
}

/// The arch of a weight, a half opening and a friction.
pub fn arch([weight, half_opening, friction]: [&str; 3]) -> Result<Arch, String> {
    let weight = self::weight(weight)?;
    Arch::parse(weight.name(), half_opening, friction).map_err(|error| error.to_string())
}

/// The claims named, all if none is: each by its id or by the beginning of it up to a hyphen.
pub fn claims_named(names: &[String]) -> Result<Vec<Claim>, String> {
    let all = claims();
    if let Some(unknown) = names.iter().find(|name| !all.iter().any(|claim| claim.is_named(name))) {
        let ids: Vec<&str> = all.iter().map(|claim| claim.id).collect();
        let hint = did_you_mean(unknown, &ids);
        return Err(format!("unknown claim '{}'{hint}", shortened(unknown)));
    }
    let chosen = |claim: &Claim| names.is_empty() || names.iter().any(|name| claim.is_named(name));
    Ok(all.into_iter().filter(chosen).collect())
}
