//! A judged row, and what every format writes of it.

use crate::Kept;
use crate::judge::{Certified, CorrectDigits, ErrorSide, Judged, Judgement, Standing, Verdict};
use crate::number::Decimal;
use crate::problem::Quantity;
use crate::record::Record;
use crate::words::reason;
use serde_json::Value as Json;

/// A row of results, judged or not.
#[derive(Clone, Debug)]
pub struct JudgedRow {
    /// Line of the row in the file.
    pub line: u64,
    /// The self-weight model as given.
    pub weight: String,
    /// The half opening as given.
    pub half_opening: String,
    /// The friction as given.
    pub friction: String,
    /// The thickness as given, where the arch has one.
    pub thickness: Option<String>,
    /// True if the claim is that the arch can stand at some thickness.
    pub claimed_can_stand: Option<bool>,
    /// True if the claim is that the arch stands at the thickness that it has.
    pub claimed_stands: Option<bool>,
    /// The mode that is claimed.
    pub claimed_mode: Option<&'static str>,
    /// Note on what may have been meant otherwise.
    pub note: Option<String>,
    /// Values handed on from the row.
    pub kept: Vec<(String, Kept)>,
    /// The judgement, or why the row cannot be read.
    pub outcome: Result<Judgement, String>,
}

/// The fields of a row, before those of its numbers.
pub(super) const ROW: &str = "line weight half_opening friction thickness verdict accepted correct_digits \
    claimed_can_stand can_stand claimed_stands stands claimed_mode mode boundary \
    boundary_within side reason note";

/// The fields of a number.
pub(super) const NUMBER: &str = "claimed value lower upper error relative_error error_units error_ulp correct_digits \
    rounding nearest_double";

impl Default for JudgedRow {
    /// Row of which nothing is read yet.
    fn default() -> Self {
        Self {
            line: 0,
            weight: String::new(),
            half_opening: String::new(),
            friction: String::new(),
            thickness: None,
            claimed_can_stand: None,
            claimed_stands: None,
            claimed_mode: None,
            note: None,
            kept: Vec::new(),
            outcome: Err(String::new()),
        }
    }
}

impl JudgedRow {
    /// The verdict on the row as a whole.
    pub(crate) fn verdict(&self) -> Verdict {
        self.judgement().map_or(Verdict::BadRow, |judgement| judgement.verdict)
    }

    /// The judgement, if the row could be read.
    pub(crate) fn judgement(&self) -> Option<&Judgement> {
        self.outcome.as_ref().ok()
    }

    /// The numbers that are judged.
    pub(crate) fn numbers(&self) -> &[Judged] {
        self.judgement().map_or(&[], |judgement| &judgement.numbers)
    }

    /// The digits to which every number is correct, if there is any.
    pub(crate) fn correct_digits(&self) -> Option<CorrectDigits> {
        self.judgement()?.correct_digits()
    }

    /// Tells whether the arch can stand, if that is certain.
    fn can_stand(&self) -> Option<bool> {
        match self.judgement()?.standing {
            Standing::Stands(_) => Some(true),
            Standing::Falls(_) => Some(false),
            Standing::Undecided(_) => None,
        }
    }

    /// The certified mode, or all that meet where it is not decided.
    pub(crate) fn modes(&self) -> Option<String> {
        match &self.judgement()?.standing {
            Standing::Stands(mode) => Some(mode.label().to_owned()),
            Standing::Falls(_) => None,
            Standing::Undecided(doubt) => {
                let modes: Vec<&str> = doubt.between.iter().map(|mode| mode.label()).collect();
                Some(modes.join(" ")).filter(|modes| !modes.is_empty())
            }
        }
    }

    /// Reason why it falls, is undecided or cannot be read.
    pub(crate) fn reason(&self) -> Option<&str> {
        match &self.outcome {
            Err(error) => Some(error),
            Ok(judgement) => match &judgement.standing {
                Standing::Stands(_) => None,
                Standing::Falls(fall) => Some(reason(*fall)),
                Standing::Undecided(doubt) => Some(&doubt.reason),
            },
        }
    }

    /// The fields [`ROW`].
    pub(crate) fn fields(&self) -> Record {
        let verdict = self.verdict();
        let side = self.judgement().and_then(|judgement| judgement.side()).map(|side| match side {
            ErrorSide::Thinner => "thinner",
            ErrorSide::Thicker => "thicker",
        });
        let boundary = self.judgement().and_then(|judgement| judgement.boundary.as_ref());
        let values: [Json; 19] = [
            self.line.into(),
            self.weight.as_str().into(),
            self.half_opening.as_str().into(),
            self.friction.as_str().into(),
            self.thickness.as_deref().into(),
            verdict.name().into(),
            verdict.is_accepted().into(),
            self.correct_digits().map(digits).into(),
            self.claimed_can_stand.into(),
            self.can_stand().into(),
            self.claimed_stands.into(),
            self.judgement().and_then(|judgement| judgement.stands).into(),
            self.claimed_mode.into(),
            self.modes().into(),
            boundary.map(|boundary| boundary.quantity.name()).into(),
            boundary.map(|boundary| boundary.within.to_string()).into(),
            side.into(),
            self.reason().into(),
            self.note.as_deref().into(),
        ];
        Record::named(ROW, values)
    }

    /// The number of a quantity, if it is judged.
    pub(crate) fn number(&self, quantity: Quantity) -> Option<&Judged> {
        self.numbers().iter().find(|number| number.quantity == quantity)
    }
}

/// The fields [`NUMBER`]; bounds are rounded outward, errors correctly rounded.
pub(super) fn number(number: &Judged) -> Record {
    let text = |x: Option<&Decimal>| -> Json { x.map(ToString::to_string).into() };
    let errors = number.errors.as_ref();
    let bounds = match &number.certified {
        Certified::Finite(rounded) => Some(rounded),
        Certified::Infinite | Certified::Missing => None,
    };
    let values: [Json; 11] = [
        number.claimed.as_str().into(),
        certified(&number.certified).into(),
        text(bounds.map(|rounded| &rounded.lower)),
        text(bounds.map(|rounded| &rounded.upper)),
        text(errors.map(|errors| &errors.absolute)),
        text(errors.and_then(|errors| errors.relative.as_ref())),
        text(errors.map(|errors| &errors.units)),
        text(errors.and_then(|errors| errors.ulp.as_ref())),
        digits(number.correct_digits).into(),
        number.rounding.map(|rounding| rounding.name()).into(),
        number.is_nearest_double.into(),
    ];
    Record::named(NUMBER, values)
}

/// A number of digits, or `inf` for a number that is exactly the truth.
pub(super) fn digits(correct: CorrectDigits) -> String {
    match correct {
        CorrectDigits::Digits(digits) => digits.to_string(),
        CorrectDigits::Exact => "inf".to_owned(),
    }
}

/// The text of a certified value.
pub(super) fn certified(value: &Certified) -> String {
    match value {
        Certified::Finite(rounded) => rounded.value.to_string(),
        Certified::Infinite => "inf".to_owned(),
        Certified::Missing => "none".to_owned(),
    }
}
