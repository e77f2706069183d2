//! An answer: an object that is made by one call, read by any thread, and freed once.

use crate::border::{c_text, optional, or_else, taken};
use crate::codes::{COUPLET_FAULT, COUPLET_OPEN, COUPLET_PROVED, COUPLET_RESOURCE, COUPLET_USAGE};
use crate::failure::Failure;
use couplet::certify::survey::{EndValue, QuantityRange, RangeEnd};
use couplet::check::{AcceptedFile, visible};
use couplet::problem::Quantity;
use couplet::report::words::labels;
use couplet::report::{self, Answers, Format, Reported, Status, Subject, SurveyedArches, Value};
use couplet::rug::Float;
use couplet::rug::float::Round;
use std::borrow::Cow;
use std::ffi::{CStr, CString, c_char, c_int};
use std::io;
use std::sync::OnceLock;

/// What comes back from a question. Its texts live as long as it does.
#[derive(Default)]
pub struct Answer {
    code: c_int,
    verdict: CString,
    mode: CString,
    reason: CString,
    note: CString,
    values: Vec<Known>,
    whole: Whole,
    json: OnceLock<CString>,
}

/// A value.
struct Known {
    quantity: Quantity,
    name: CString,
    /// Lower bound, value, upper bound; empty where there is no bound.
    texts: [CString; 3],
    /// The nearest double, lower and upper bound, where they are proved.
    doubles: Option<[f64; 3]>,
}

/// What JSON is made of.
#[derive(Default)]
enum Whole {
    #[default]
    Nothing,
    Text(String),
    Answers(Box<Answers>),
}

impl Known {
    fn new((quantity, value): &(Quantity, Value)) -> Self {
        let [text, lower, upper] = value.texts().map(ToString::to_string);
        let doubles = Some([value.double, value.binary.lower, value.binary.upper]);
        let texts = [lower, text, upper].map(c_text);
        Self { quantity: *quantity, name: c_text(quantity.name()), texts, doubles }
    }

    /// Ends of a quantity over many arches, which has no one value.
    fn between(QuantityRange { of, lower, upper }: &QuantityRange) -> Self {
        let texts = [lower.value.to_string(), String::new(), upper.value.to_string()].map(c_text);
        let (below, above) = (double(lower, Round::Down), double(upper, Round::Up));
        let doubles = Some([f64::NAN, below, above]);
        Self { quantity: *of, name: c_text(of.name()), texts, doubles }
    }
}

/// The nearest double on the outer side of an end; not a number where no number is enough.
fn double(end: &RangeEnd, outward: Round) -> f64 {
    match &end.value {
        EndValue::Number(number) => {
            let (near, _) = Float::with_val_round(53, number.to_rational(), outward);
            near.to_f64_round(outward)
        }
        EndValue::NotEnough | EndValue::AnyIsEnough => f64::NAN,
        EndValue::Unbounded => f64::INFINITY,
    }
}

impl Answer {
    /// Answer to what was not answered.
    pub(crate) fn failed(failure: Failure) -> Self {
        match failure {
            Failure::Usage(reason) => Self::new(COUPLET_USAGE, "refused", reason),
            Failure::Resource(reason) => Self::new(COUPLET_RESOURCE, "failed", reason),
            Failure::Fault(reason) => Self::new(COUPLET_FAULT, "failed", reason),
        }
    }

    /// The code that the function returns.
    pub(crate) fn code(&self) -> c_int {
        self.code
    }

    /// Without values.
    pub(crate) fn new(code: c_int, verdict: &str, reason: impl Into<String>) -> Self {
        // It may quote what others wrote, as the command's may.
        let (verdict, reason) = (c_text(verdict), c_text(visible(&reason.into())));
        Self { code, verdict, reason, ..Self::default() }
    }

    /// What is undecided, and why.
    pub(crate) fn undecided(reason: String) -> Self {
        Self::new(COUPLET_OPEN, "undecided", reason)
    }

    /// Of arrays: whether every row is decided, and what is not.
    pub(crate) fn rows(open: Option<String>) -> Self {
        open.map_or_else(|| Self::new(COUPLET_PROVED, "proved", ""), Self::undecided)
    }

    /// With what may have been meant otherwise.
    pub(crate) fn with_note(self, note: Option<&str>) -> Self {
        Self { note: c_text(note.unwrap_or_default()), ..self }
    }

    /// What is known of one subject, with all of it for JSON.
    pub(crate) fn told(answers: Answers) -> Self {
        let Some(told) = answers.list.first() else {
            return Self::new(COUPLET_FAULT, "failed", "there is no answer");
        };
        let code = if told.is_undecided() { COUPLET_OPEN } else { COUPLET_PROVED };
        let reason = told.reason().map(Cow::into_owned).or_else(|| told.proved_in_words());
        let mut answer = Self::new(code, verdict(told), reason.unwrap_or_default());
        answer.mode = c_text(labels(&told.modes).join("/"));
        answer.values = told.values.iter().map(Known::new).collect();
        let note = told.note.clone();
        answer.whole = Whole::Answers(Box::new(answers));
        answer.with_note(note.as_deref())
    }

    /// What is known of every arch of a question with ranges.
    pub(crate) fn surveyed(found: &SurveyedArches) -> Self {
        let open = found.first_open();
        let code = if open.is_some() { COUPLET_OPEN } else { COUPLET_PROVED };
        let reason = open.map(ToString::to_string).unwrap_or_default();
        let answer = Self::new(code, found.outcome()[0], reason);
        let modes = found.found.as_ref().ok().and_then(|found| found.modes.as_ref());
        let labels = modes.map_or(Vec::new(), |modes| labels(&modes.occur));
        let whole = Whole::Text(json(found).unwrap_or_default());
        let values = found.ranges().map(Known::between).collect();
        let answer = Self { mode: c_text(labels.join("/")), values, whole, ..answer };
        answer.with_note(found.asked.note())
    }

    /// A certificate, as the text of its file.
    pub(crate) fn certificate(
        write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>,
    ) -> Result<Self, Failure> {
        let mut bytes = Vec::new();
        write(&mut bytes).map_err(|error| Failure::Fault(error.to_string()))?;
        let text = String::from_utf8(bytes).map_err(|error| Failure::Fault(error.to_string()))?;
        Ok(Self { whole: Whole::Text(text), ..Self::new(COUPLET_PROVED, "proved", "") })
    }

    /// A certificate that is accepted, with what it proves.
    pub(crate) fn accepted(accepted: &AcceptedFile) -> Self {
        let value = |(quantity, text): &(Quantity, String)| Known {
            quantity: *quantity,
            name: c_text(quantity.name()),
            texts: [CString::default(), c_text(text.as_str()), CString::default()],
            doubles: None,
        };
        // A survey has no values of its own.
        let values = accepted.certificate().map_or(&[][..], |accepted| &accepted.values);
        let values = values.iter().map(value).collect();
        Self { values, ..Self::new(COUPLET_PROVED, "accepted", accepted.summary()) }
    }

    #[cfg(test)]
    pub(crate) fn reason(&self) -> &CStr {
        &self.reason
    }

    fn value(&self, name: &str) -> Option<&Known> {
        let quantity = Quantity::named(name)?;
        self.values.iter().find(|value| value.quantity == quantity)
    }

    /// The whole as JSON, made once.
    fn json(&self) -> &CStr {
        self.json.get_or_init(|| match &self.whole {
            Whole::Nothing => CString::default(),
            Whole::Text(text) => c_text(text.as_str()),
            Whole::Answers(answers) => c_text(json(&**answers).unwrap_or_default()),
        })
    }
}

/// What became of a subject, in a word.
fn verdict(told: &report::Answer) -> &'static str {
    match (&told.subject, &told.status) {
        (Subject::Arch { .. }, _) => match told.can_stand.or(told.stands) {
            Some(true) => "stands",
            Some(false) => "falls",
            None => "undecided",
        },
        (Subject::Sought { .. }, _) => told.search(),
        (_, Status::Undecided(_)) => "undecided",
        _ => "proved",
    }
}

fn json<R: Reported>(report: &R) -> Option<String> {
    let mut bytes = Vec::new();
    report.write(Format::named(R::content(), "json")?, &mut bytes).ok()?;
    String::from_utf8(bytes).ok()
}

/// A text of an answer; empty where there is no answer.
fn told<'a>(
    answer: Option<&'a Answer>,
    text: impl FnOnce(&'a Answer) -> Option<&'a CStr>,
) -> *const c_char {
    let text = || answer.and_then(text).unwrap_or(c"").as_ptr();
    or_else(c"".as_ptr(), text)
}

/// The verdict, a word: of an arch "stands", "falls" or "undecided"; of what is found "found", "nothing" or
/// "undecided"; of constants, certificates and arrays "proved" or "undecided"; of a check "accepted", "refused" or "not
/// checked"; with ranges as the questions say. A question that makes no sense is "refused", any other failure
/// "failed".
#[unsafe(no_mangle)]
pub extern "C" fn couplet_verdict(answer: Option<&Answer>) -> *const c_char {
    told(answer, |answer| Some(&answer.verdict))
}

/// Why: why an arch falls, why something is undecided, what was wrong with the question; what is proved of something
/// found; of a certificate that is accepted what it proves, in the words of the command. Empty where there is nothing
/// to say.
#[unsafe(no_mangle)]
pub extern "C" fn couplet_reason(answer: Option<&Answer>) -> *const c_char {
    told(answer, |answer| Some(&answer.reason))
}

/// What may have been meant otherwise, as a friction of 31; empty where nothing may. The answer is that to what is
/// written.
#[unsafe(no_mangle)]
pub extern "C" fn couplet_note(answer: Option<&Answer>) -> *const c_char {
    told(answer, |answer| Some(&answer.note))
}

/// How the arch collapses at its least thickness, joints from the shoulder inward, as "[r,r,s]"; of a boundary both
/// modes, as "[r,r,s]/[r,s,r]"; with ranges all that are known to occur. Empty where that is not asked, or there is
/// none.
#[unsafe(no_mangle)]
pub extern "C" fn couplet_mode(answer: Option<&Answer>) -> *const c_char {
    told(answer, |answer| Some(&answer.mode))
}

/// How many values there are.
#[unsafe(no_mangle)]
pub extern "C" fn couplet_count(answer: Option<&Answer>) -> usize {
    answer.map_or(0, |answer| answer.values.len())
}

/// The name of the quantity of a value, counted from 0; empty if there are fewer.
#[unsafe(no_mangle)]
pub extern "C" fn couplet_quantity(answer: Option<&Answer>, index: usize) -> *const c_char {
    told(answer, |answer| Some(&answer.values.get(index)?.name))
}

/// A value as text, "inf" if it is infinite: correctly rounded to the digits asked for (`COUPLET_VALUE`), or a bound
/// (`COUPLET_LOWER`, `COUPLET_UPPER`). With ranges there are bounds alone, which no arch is beyond; "none" for one
/// where no thickness, or no friction, is enough. Empty if there is none: not of this arch, undecided, not asked for,
/// no such name or bound. A certificate that is checked has no bounds. A quantity is a name as "thickness" or a letter
/// as "eta".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_text(
    answer: Option<&Answer>,
    quantity: *const c_char,
    which: c_int,
) -> *const c_char {
    // SAFETY: the caller promises a text or NULL.
    let name = unsafe { optional(quantity, "quantity") };
    told(answer, |answer| {
        let value = answer.value(name.ok()??)?;
        let place = usize::try_from(which.checked_add(1)?).ok()?;
        value.texts.get(place).map(CString::as_c_str)
    })
}

/// A value as the nearest double, correctly rounded, between the two nearest doubles that are bounds of it. Any of the
/// three pointers may be NULL. `COUPLET_PROVED` if there is such a value; `COUPLET_OPEN` if this answer has none, and
/// `COUPLET_USAGE` if there is no such quantity or no answer: then all three are not a number. With ranges the value is
/// not a number, nor a bound where no thickness, or no friction, is enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_double(
    answer: Option<&Answer>,
    quantity: *const c_char,
    value: *mut f64,
    lower: *mut f64,
    upper: *mut f64,
) -> c_int {
    // SAFETY: the caller promises a text or NULL.
    let name = unsafe { optional(quantity, "quantity") };
    let found = || {
        let (Some(answer), Ok(Some(name))) = (answer, name) else { return Err(COUPLET_USAGE) };
        Quantity::named(name).ok_or(COUPLET_USAGE)?;
        answer.value(name).and_then(|value| value.doubles).ok_or(COUPLET_OPEN)
    };
    let found = or_else(Err(COUPLET_FAULT), found);
    let [nearest, below, above] = found.unwrap_or([f64::NAN; 3]);
    for (place, x) in [(value, nearest), (lower, below), (upper, above)] {
        if !place.is_null() {
            // SAFETY: the caller promises that a double can be written there.
            unsafe { place.write(x) };
        }
    }
    found.err().unwrap_or(COUPLET_PROVED)
}

/// The whole as JSON, as the command prints it (docs/columns.md); of `couplet_certify_landmark` and
/// `couplet_certify_arch` the certificate, as its file has it. Empty of a check, of arrays, and where nothing could be
/// asked. It is made at the first call.
#[unsafe(no_mangle)]
pub extern "C" fn couplet_json(answer: Option<&Answer>) -> *const c_char {
    told(answer, |answer| Some(answer.json()))
}

/// Frees an answer with all its texts; NULL is nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_free(answer: *mut Answer) {
    // SAFETY: the caller promises that it is of this library and not freed yet.
    or_else((), || drop(unsafe { taken(answer) }));
}
