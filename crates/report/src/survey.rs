//! All arches of a question with ranges, and what is proved of them: `couplet.survey/1`.

use super::record::Record;
use super::reported::Reported;
use super::tabular::Tabular;
use super::understood::Understood;
use super::words::{aligned, distinct, labels, list};
use crate::arch::SelfWeight;
use crate::ask::{Field, SurveyGiven};
use crate::certify::Undecided;
use crate::problem::{Quantity, Sought};
use couplet_survey::{EndValue, ModesFound, QuantityRange, RangeEnd, SurveyAnswer, SurveyedArch};
use rug::Rational;
use std::cmp::Reverse;

/// Schema of the answer.
pub(super) const SCHEMA: &str = "couplet.survey/1";

/// Meaning of a range, the one sentence of all formats.
pub const MEANING: &str =
    "A range means every arch inside it: nothing is said of how likely one is.";

/// All arches of one self-weight between measured ends, and what is proved of them.
#[derive(Debug)]
pub struct SurveyedArches {
    /// Question as it is understood.
    pub asked: Understood,
    /// The arches as they are read.
    pub given: SurveyGiven,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Quantity that is sought of each of them, in place of which an arch has none; `None` if it is asked whether it
    /// stands.
    pub sought: Option<Sought>,
    /// Quantities that are told.
    pub quantities: Vec<Quantity>,
    /// Answer, or why nothing is proved.
    pub found: Result<SurveyAnswer, Undecided>,
    /// Effect of each tolerance on the geometric safety alone, the widest range first; none where that is not told.
    pub alone: Vec<MeasureAlone>,
}

/// A measure that alone keeps its tolerance, every other one being at the middle of its own.
#[derive(Debug)]
pub struct MeasureAlone {
    /// The measure.
    pub measure: Field,
    /// Arches with that tolerance, and their geometric safety; or why there are none.
    pub found: Result<SurveyedArches, String>,
}

impl MeasureAlone {
    /// Range of the geometric safety, or why it stays open.
    fn safety(&self) -> Result<(&SurveyedArches, &QuantityRange), String> {
        let found = self.found.as_ref().map_err(Clone::clone)?;
        let open = || found.first_open().map_or(String::new(), |open| open.reason.to_string());
        found.ranges().next().map(|range| (found, range)).ok_or_else(open)
    }

    /// Order by extent: numbers by their difference, then an end without a number; `None` if it stays open.
    fn extent(&self) -> Option<(bool, Rational)> {
        let (_, QuantityRange { lower, upper, .. }) = self.safety().ok()?;
        Some(match [&lower.value, &upper.value] {
            [EndValue::Number(lower), EndValue::Number(upper)] => {
                (false, upper.to_rational() - lower.to_rational())
            }
            [lower, upper] => (lower != upper, Rational::new()),
        })
    }
}

impl SurveyedArches {
    /// The answer with what each tolerance does alone.
    #[must_use]
    pub fn with_each_alone(self, mut alone: Vec<MeasureAlone>) -> Self {
        // Where one stays open, no order is known.
        if alone.iter().all(|of| of.extent().is_some()) {
            alone.sort_by_key(|of| Reverse(of.extent()));
        }
        Self { alone, ..self }
    }

    /// The measure whose tolerance alone makes the widest range of the geometric safety, where that is told.
    pub(super) fn measure_first(&self) -> Option<&'static str> {
        let is_known = self.alone.iter().all(|of| of.extent().is_some());
        self.alone.first().filter(|_| is_known).map(|of| of.measure.name())
    }

    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<&Undecided> {
        match &self.found {
            Err(open) => Some(open),
            Ok(found) => {
                let verdict = found.verdict.as_ref().and_then(|verdict| verdict.as_ref().err());
                verdict.or(found.open.as_ref())
            }
        }
    }

    /// Answer to whether they stand or, without a thickness, whether they can: a word and a sentence.
    pub fn outcome(&self) -> [&'static str; 2] {
        let Ok(found) = &self.found else { return ["undecided", "undecided"] };
        match &found.verdict {
            Some(Ok(verdict)) => [verdict.name(), verdict.sentence()],
            Some(Err(_)) => ["undecided", "undecided"],
            None => {
                let falls = |end: &RangeEnd| end.value == EndValue::NotEnough;
                let deciding = found.ranges.first();
                let falls = deciding.map(|of| [&of.lower, &of.upper].map(falls));
                let names = ["none_can_stand", "both_occur", "all_can_stand"];
                let kind = match falls {
                    None => return ["undecided", "undecided"],
                    Some([true, true]) => 0,
                    Some([false, false]) => 2,
                    Some(_) => 1,
                };
                [names[kind], can_stand(self.sought)[kind]]
            }
        }
    }

    /// Tells whether the modes of the arches belong to the answer: not to one between stones, nor of what is sought.
    fn tells_modes(&self) -> bool {
        self.sought.is_none() && self.given.stones.is_none()
    }

    /// Ranges of the quantities that are told.
    pub fn ranges(&self) -> impl Iterator<Item = &QuantityRange> {
        let found = self.found.as_ref().ok().into_iter();
        found.flat_map(|found| &found.ranges).filter(|range| self.quantities.contains(&range.of))
    }

    /// The fields of the answer, behind its schema.
    pub(super) fn fields(&self) -> Record {
        let mut record = Record::default();
        self.asked.add_to(&mut record);
        record.add("meaning", MEANING);
        record.add("weight", self.weight.name());
        if let Some(sought) = self.sought {
            record.add("sought", sought.name());
        }
        record.add("outcome", self.outcome()[0]);
        record.add("reason", self.first_open().map(|open| open.reason.to_string()));
        let found = self.found.as_ref().ok();
        record.add_record("worst", found.map(|found| self.arch(&found.worst)));
        record.add_record("best", found.map(|found| self.arch(&found.best)));
        let range = |range: &QuantityRange| {
            let mut record = Record::named("quantity", [range.of.name().into()]);
            record.add_record("lower", Some(self.end(&range.lower)));
            record.add_record("upper", Some(self.end(&range.upper)));
            record
        };
        record.add_list("ranges", self.ranges().map(range));
        if !self.alone.is_empty() {
            let alone = |of: &MeasureAlone| {
                let safety = of.safety();
                let end = |end: fn(&QuantityRange) -> &RangeEnd| {
                    safety.as_ref().ok().map(|(arches, range)| arches.end(end(range)))
                };
                let mut record = Record::named("measure", [of.measure.name().into()]);
                record.add_record("lower", end(|range| &range.lower));
                record.add_record("upper", end(|range| &range.upper));
                record.add("reason", safety.as_ref().err().map(String::as_str));
                record
            };
            record.add_list("measures_alone", self.alone.iter().map(alone));
        }
        if self.tells_modes() {
            let modes = found.and_then(|found| found.modes.as_ref());
            record.add("modes", modes.map_or(Vec::new(), |modes| labels(&modes.occur)));
            record.add("other_modes", modes.map_or(Vec::new(), |modes| labels(&modes.may_occur)));
            record.add("some_fall", modes.and_then(|modes| modes.some_fall));
        }
        record
    }

    /// Command that asks about one arch.
    pub fn command(&self, of: &SurveyedArch) -> String {
        let asked = self.given.one(&of.arch, of.thickness.as_ref(), of.measured.as_ref());
        let command = match (self.sought, &self.given.stones, &of.thickness) {
            (Some(Sought::HalfOpening), ..) => "find half-opening",
            (Some(Sought::Friction), ..) => "find friction",
            (None, Some(_), _) => "voussoirs",
            (None, None, Some(_)) => "assess",
            (None, None, None) => "state",
        };
        format!("couplet {command}{} --weight {}", asked.options(), self.weight.name())
    }

    fn arch(&self, of: &SurveyedArch) -> Record {
        let thickness = of.thickness.as_ref().map(ToString::to_string);
        let mut arch = Record::default();
        let unless = |sought, text: String| (self.sought != Some(sought)).then_some(text);
        let [alpha, mu] = [of.arch.half_opening().to_string(), of.arch.friction().to_string()];
        arch.add("half_opening", unless(Sought::HalfOpening, alpha));
        arch.add("friction", unless(Sought::Friction, mu));
        arch.add("thickness", thickness);
        arch.add("command", self.command(of));
        arch
    }

    fn end(&self, end: &RangeEnd) -> Record {
        let (number, bound) = match &end.value {
            EndValue::Number(number) => (Some(number.to_string()), "number"),
            EndValue::NotEnough => (None, "not_enough"),
            EndValue::AnyIsEnough => (None, "any_is_enough"),
            EndValue::Unbounded => (None, "unbounded"),
        };
        let mut record = Record::default();
        record.add("value", number);
        record.add("bound", bound);
        record.add_record("arch", end.at.as_ref().map(|at| self.arch(at)));
        record
    }
}

/// Sentences for arches none of which can stand, some, and all.
const fn can_stand(sought: Option<Sought>) -> [&'static str; 3] {
    match sought {
        None => [
            "no arch can stand, however thick",
            "some arches can stand, others cannot, however thick",
            "every arch can stand at some thickness",
        ],
        Some(Sought::Friction) => [
            "no arch can stand, however rough",
            "some arches can stand, others cannot, however rough",
            "every arch can stand with some friction",
        ],
        Some(Sought::HalfOpening) => [
            "no half opening stands",
            "of some arches a half opening stands, of others none does",
            "each has a widest half opening that stands",
        ],
    }
}

impl Reported for SurveyedArches {
    fn records(&self) -> Vec<Record> {
        let mut record = Record::of(SCHEMA);
        say(self, &mut record);
        record.append(self.fields());
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        let columns = "weight outcome quantity lower lower_arch upper upper_arch reason";
        let command = |end: &RangeEnd| end.at.as_ref().map(|at| self.command(at));
        let row = |range: Option<&QuantityRange>| {
            let mut row = Record::default();
            row.add("weight", self.weight.name());
            row.add("outcome", self.outcome()[0]);
            row.add("reason", self.first_open().map(|open| open.reason.to_string()));
            row.note(self.asked.note());
            if let Some(QuantityRange { of, lower, upper }) = range {
                row.add("quantity", of.name());
                row.add("lower", lower.value.to_string());
                row.add("lower_arch", command(lower));
                row.add("upper", upper.value.to_string());
                row.add("upper_arch", command(upper));
            }
            row
        };
        let mut rows: Vec<Record> = self.ranges().map(|range| row(Some(range))).collect();
        if rows.is_empty() {
            rows.push(row(None));
        }
        Tabular::of(columns, rows)
    }
}

/// Lines for a person.
fn say(all: &SurveyedArches, record: &mut Record) {
    let subject = match all.sought {
        None => "Every arch",
        Some(Sought::HalfOpening) => "The widest half opening of every arch",
        Some(Sought::Friction) => "The least friction of every arch",
    };
    record.say(format!("{subject} of {}\n", all.asked.with_weight(all.weight)));
    // What stays open beside a verdict comes behind the ranges.
    let (verdict, open) = match (all.outcome(), all.first_open()) {
        (["undecided", _], Some(open)) => (open.to_string(), None),
        ([_, words], open) => (format!("{words}, proved"), open),
    };
    record.say(verdict);
    record.say(MEANING);
    let Ok(found) = &all.found else { return };
    let ends = || all.ranges().flat_map(|range| [&range.lower, &range.upper]);
    let at = ends().filter_map(|end| end.at.as_ref());
    let arches = distinct([&found.worst, &found.best].into_iter().chain(at));
    let number = |of: &SurveyedArch| arches.iter().position(|arch| *arch == of);
    let end = |end: &RangeEnd| {
        let at = end.at.as_ref().and_then(number);
        match at {
            Some(at) => format!("{} ({})", end.value, at + 1),
            None => end.value.to_string(),
        }
    };
    let row = |range: &QuantityRange| {
        let name = range.of.name().to_owned();
        let symbol = range.of.symbol().to_owned();
        vec![name, symbol, end(&range.lower), format!("to {}", end(&range.upper))]
    };
    let rows: Vec<Vec<String>> = all.ranges().map(row).collect();
    if !rows.is_empty() {
        record.say("");
        record.say_all(aligned(&rows).map(|line| format!("   {line}")));
    }
    record.say_all(found.modes.iter().flat_map(modes));
    record.say_all(open.map(|open| format!("\n   {open}")));
    if !all.alone.is_empty() {
        record.say("\n   what to measure better: the geometric safety with one tolerance alone, all else at its middle");
        let row = |of: &MeasureAlone| {
            let range = match of.safety() {
                Ok((_, QuantityRange { lower, upper, .. })) => {
                    format!("{} to {}", lower.value, upper.value)
                }
                Err(why) => format!("undecided: {why}"),
            };
            vec![of.measure.name().to_owned(), range]
        };
        let rows: Vec<Vec<String>> = all.alone.iter().map(row).collect();
        record.say_all(aligned(&rows).map(|line| format!("   {line}")));
    }
    record.say("");
    for (index, arch) in arches.iter().enumerate() {
        record.say(format!("   ({}) {}", index + 1, all.command(arch)));
    }
    let [worst, best] = [&found.worst, &found.best].map(|of| number(of).map_or(0, |at| at + 1));
    let does = match (&found.verdict, all.sought) {
        (Some(_), _) | (None, Some(_)) => ["stands least easily", "most easily"],
        (None, None) => ["needs the largest thickness", "the least"],
    };
    record.say(match worst == best {
        true => format!("\n   ({worst}) {} and {}.", does[0], does[1]),
        false => format!("\n   ({worst}) {}, ({best}) {}.", does[0], does[1]),
    });
    if ends().any(|end| end.at.is_some()) {
        record
            .say("   An end is the value of the arch whose number is behind it, rounded outward.");
    }
    if ends().any(|end| end.value == EndValue::NotEnough) {
        record.say(match all.sought {
            None => "   None: no thickness, or no friction, is enough for that arch.",
            Some(Sought::Friction) => "   None: no friction is enough for that arch.",
            Some(Sought::HalfOpening) => "   None: without friction nothing stands.",
        });
    }
    if ends().any(|end| end.value == EndValue::AnyIsEnough) {
        record.say("   Any: however thin, that arch stands.");
    }
    let is_force = |of: Quantity| of.is_force() && of != Quantity::Weight;
    if all.quantities.iter().any(|of| is_force(*of))
        && !all.ranges().any(|range| is_force(range.of))
    {
        record.say("   Thrusts are told, in kN too, where every arch stands.");
    }
    if ends().any(|end| end.at.is_none()) {
        record.say("   An end without a number behind it encloses: no arch is beyond it, and none need have it.");
    }
}

/// Lines on the modes at the least thickness.
fn modes(modes: &ModesFound) -> Vec<String> {
    let mut lines = Vec::new();
    if !modes.occur.is_empty() {
        lines.push(format!("\n   modes at the least thickness: {}", list(labels(&modes.occur))));
    }
    if !modes.may_occur.is_empty() {
        lines.push(format!("   not excluded: {}", list(labels(&modes.may_occur))));
    }
    let some = match modes.some_fall {
        Some(true) => Some("some arches stand at no thickness"),
        Some(false) => None,
        None => Some("whether any arch stands at no thickness stays open"),
    };
    lines.extend(some.map(|some| format!("   {}", some)));
    lines
}
