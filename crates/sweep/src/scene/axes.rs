//! Keys of arches: each is a list of texts, every one read by itself by the reader of every other door, and every
//! combination of them is a question.

use super::same::given_key;
use super::schema::{FIELDS, MAX_ARCHES};
use super::table::TableReader;
use super::value::{Entry, TomlReader, TomlValue};
use crate::ask::{
    ArchAsked, ArchGiven, ArchQuestion, Field, Misfit, Range, Spelling, boxes, steps,
};
use crate::number::{BETWEEN, is_range};
use toml::de::{DeTable, DeValue};

/// Key with its values, which are written out only when it is known that they are not too many.
pub(super) struct ArchAxis {
    pub field: Field,
    /// Number of values.
    pub count: usize,
    pub texts: Box<dyn Iterator<Item = String>>,
    /// Text of all of it, if it is cut into boxes.
    pub whole: Option<String>,
}

impl ArchAxis {
    /// Numbers that the texts say, each by itself, `None` where one is wrong; a grid has too many to tell all that are.
    pub(super) fn parts(self, table: &mut TableReader) -> impl Iterator<Item = Option<ArchGiven>> {
        let part = move |text: String| ArchAsked::of([(self.field, text.as_str())]);
        self.texts.map(move |text| table.fitting(ArchGiven::part(&part(text))))
    }
}

/// Tells whether arches are measured.
pub(super) fn is_measured(table: &TableReader) -> bool {
    Field::SIZES.iter().any(|field| table.get(field.name()).is_some())
}

/// Values of arches that a table gives.
pub(super) fn given<'a>(table: &mut TableReader<'a, '_>) -> Vec<(Field, &'a TomlValue<'a>)> {
    let mut all = Vec::new();
    for field in FIELDS {
        let [named, lettered] = [Some(field.name()), field.letter()].map(|key| table.get(key?));
        if let (Some(_), Some(letter), Some(value)) = (named, field.letter(), lettered) {
            let message = format!("both {} and {letter}; give one of them", field.name());
            table.reader.fault(value.span(), message);
        }
        all.extend(named.or(lettered).map(|value| (field, value)));
    }
    all
}

/// Keys of arches, each read by itself, as ranges too if there may be any; `None` if any is wrong, or if they are not
/// those of the question.
pub(super) fn axes(
    table: &mut TableReader,
    question: Option<&ArchQuestion>,
    ranges: bool,
) -> Option<Vec<ArchAxis>> {
    let before = table.reader.faults.len();
    let given = given(table);
    if let Some(question) = question {
        let asked = ArchAsked::of(given.iter().map(|(field, _)| (*field, "")));
        let fits = question.fits(&asked, Spelling::Key);
        table.fitting(fits.and_then(|()| question.is_whole(&asked, Spelling::Key)));
    }
    let measured = is_measured(table);
    let axes = given.into_iter().filter_map(|(field, value)| {
        AxisReader { field, ranges, measured }.axis(table.reader, value)
    });
    let axes: Vec<ArchAxis> = axes.collect();
    table.is_well_since(before).then_some(axes)
}

/// Reader of the values of a key.
#[derive(Clone, Copy)]
struct AxisReader {
    field: Field,
    /// True if the values may be ranges, and boxes of them.
    ranges: bool,
    /// True of arches in metres, of which a thickness by itself says nothing.
    measured: bool,
}

impl AxisReader {
    /// A key: numbers at equal distances, ranges that touch, or a list of texts, each once. `None` if any is wrong.
    fn axis(self, reader: &mut TomlReader, value: &TomlValue) -> Option<ArchAxis> {
        if let DeValue::Table(parts) = value.get_ref() {
            return self.range(reader, value, parts);
        }
        let (field, text) =
            (self.field, |reader: &mut _, (_, value): Entry| self.text(reader, value));
        let texts = reader.each_once((field.name(), value), example(field), text)?;
        let (count, texts) = (texts.len(), Box::new(texts.into_iter()));
        Some(ArchAxis { field, count, texts, whole: None })
    }

    /// `{ from, to, steps }`: so many numbers at equal distances, both ends included. `{ from, to, boxes }`: so many
    /// ranges that touch each other from end to end.
    fn range(
        self,
        reader: &mut TomlReader,
        value: &TomlValue,
        parts: &DeTable,
    ) -> Option<ArchAxis> {
        let (before, field, name) = (reader.faults.len(), self.field, self.field.name());
        let is_cut = parts.contains_key("boxes");
        let (key, least) = if is_cut { ("boxes", 1) } else { ("steps", 2) };
        if is_cut && !self.ranges {
            let message = format!(
                "{name} is cut into boxes, which [[arches]] of a scene takes alone; give steps here"
            );
            return reader.refuse(value.span(), message);
        }
        let keys = ["from", "to", key];
        reader.unknown_keys(parts, "a range", &keys);
        for missing in keys.iter().filter(|key| !parts.contains_key(**key)) {
            let message =
                format!("{name} has no {missing}; a range is {{ from = …, to = …, {key} = … }}");
            reader.fault(value.span(), message);
        }
        // An end is one number.
        let end = Self { ranges: false, ..self };
        let [lower, upper] = ["from", "to"].map(|key| Some(end.text(reader, parts.get(key)?)?.1));
        let count = parts.get(key).and_then(|of| reader.whole((key, of), least..=MAX_ARCHES));
        let (of, count) = (Range { lower: lower?, upper: upper? }, count?);
        if reader.faults.len() > before {
            return None;
        }
        let text = |of: &Range| format!("{}{BETWEEN}{}", of.lower, of.upper);
        let whole = is_cut.then(|| text(&of));
        let texts: Result<Box<dyn Iterator<Item = String>>, _> = match is_cut {
            true => boxes(&of, count).map(|all| Box::new(all.map(move |part| text(&part))) as _),
            false => steps(&of, count).map(|all| Box::new(all) as _),
        };
        match texts {
            Ok(texts) => Some(ArchAxis { field, count, texts, whole }),
            Err(error) => reader.refuse(value.span(), format!("{name}: {error}")),
        }
    }

    /// One text, with a key that is the same for the same number, however it is written: `0.1` is one tenth with and
    /// without quotes.
    fn text(self, reader: &mut TomlReader, value: &TomlValue) -> Option<(String, String)> {
        let Some(text) = TomlReader::literal(value) else {
            return reader.reject((self.field.name(), value), example(self.field));
        };
        let text = text.strip_prefix('+').unwrap_or(text).to_owned();
        match self.key(&text) {
            Ok(key) => Some((key, text)),
            Err(misfit) => reader.refuse(value.span(), misfit.message),
        }
    }

    /// Key of a text, if it makes sense by itself.
    fn key(self, text: &str) -> Result<String, Misfit> {
        let asked = ArchAsked::of([(self.field, text)]);
        let key = if self.measured && self.field == Field::Thickness {
            None
        } else if self.ranges && is_range(text) {
            asked.ends()?.iter().try_for_each(|end| ArchGiven::part(end).map(|_| ()))?;
            None
        } else {
            given_key(&ArchGiven::part(&asked)?)
        };
        Ok(key.unwrap_or_else(|| text.to_owned()))
    }
}

/// Description of what may be given for a field.
pub(super) fn example(field: Field) -> &'static str {
    match field {
        Field::HalfOpening => "an angle (2.45, \"pi/2\", \"80deg\")",
        Field::Friction => "a coefficient (0.6, \"3/5\", \"inf\") or an angle (\"31deg\")",
        Field::FrictionAngle => "an angle (0.5, \"pi/6\", \"21deg\")",
        Field::Thickness => "a ratio of thickness to radius (0.12, \"3/25\")",
        _ => "a text, as the command has it (\"10m\"), or a list",
    }
}

/// Every combination of the texts of the keys, the last key fastest; `used` counts those of all items, with each
/// weight.
pub(super) fn product(
    table: &mut TableReader,
    axes: Vec<ArchAxis>,
    weights: usize,
    used: &mut usize,
) -> Option<Vec<ArchAsked>> {
    let count = axes.iter().map(|axis| axis.count).fold(weights, usize::saturating_mul);
    if count > MAX_ARCHES - *used {
        let before = if *used > 0 { format!(" after {used} before") } else { String::new() };
        return table.refuse(format!(
            "{count} arches{before} are too many; a scene has at most {MAX_ARCHES}, `couplet states` reads any number"
        ));
    }
    *used += count;
    let mut all = vec![ArchAsked::default()];
    for ArchAxis { field, texts, .. } in axes {
        let texts: Vec<String> = texts.collect();
        let with = |asked: &ArchAsked, text: &String| {
            let mut asked = asked.clone();
            *asked.at(field) = Some(text.clone());
            asked
        };
        all = all.iter().flat_map(|asked| texts.iter().map(|text| with(asked, text))).collect();
    }
    Some(all)
}
