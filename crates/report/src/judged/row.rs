//! A judged row, and what every format writes of it.

use crate::Kept;
use crate::column::Column::{Integer, Made, Shown, Text, Truth};
use crate::column::NamedColumn;
use crate::judge::{
    Certified, CorrectDigits, ErrorSide, Judged, Judgement, RowClaim, Standing, Verdict,
};
use crate::number::ExactNumber;
use crate::problem::{Mode, Quantity};
use crate::words::{labels, reason};
use std::fmt::Display;

/// Quantities that have columns, and the names of what is handed on.
pub type JudgedColumns<'a> = (&'a [Quantity], &'a [String]);

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
    /// The claim, if the row could be read.
    pub claim: Option<RowClaim>,
    /// Note on what may have been meant otherwise.
    pub note: Option<String>,
    /// Values handed on from the row.
    pub kept: Vec<(String, Kept)>,
    /// The judgement, or why the row cannot be read.
    pub outcome: Result<Judgement, String>,
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

    /// The thickness that the arch has, if it has one.
    pub(crate) fn thickness(&self) -> Option<&ExactNumber> {
        self.claim.as_ref()?.thickness.as_ref()
    }

    /// The mode that is claimed.
    pub(crate) fn claimed_mode(&self) -> Option<&'static str> {
        self.claim.as_ref()?.mode.map(Mode::label)
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
                Some(labels(&doubt.between).join(" ")).filter(|modes| !modes.is_empty())
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

    /// The columns of a row, before those of its numbers.
    pub(super) const COLUMNS: [NamedColumn<Self>; 19] = [
        ("line", Integer(|row| Some(row.line))),
        ("weight", Text(|row| Some(&row.weight))),
        ("half_opening", Text(|row| Some(&row.half_opening))),
        ("friction", Text(|row| Some(&row.friction))),
        ("thickness", Shown(|row| Some(row.thickness()?))),
        ("verdict", Text(|row| Some(row.verdict().name()))),
        ("accepted", Truth(|row| Some(row.verdict().is_accepted()))),
        ("correct_digits", Made(|row| row.correct_digits().map(digits))),
        ("claimed_can_stand", Truth(|row| row.claim.as_ref()?.can_stand)),
        ("can_stand", Truth(Self::can_stand)),
        ("claimed_stands", Truth(|row| row.claim.as_ref()?.stands)),
        ("stands", Truth(|row| row.judgement()?.stands)),
        ("claimed_mode", Text(Self::claimed_mode)),
        ("mode", Made(Self::modes)),
        ("boundary", Text(|row| Some(row.judgement()?.boundary.as_ref()?.quantity.name()))),
        ("boundary_within", Shown(|row| Some(&row.judgement()?.boundary.as_ref()?.within))),
        ("side", Text(Self::side)),
        ("reason", Text(Self::reason)),
        ("note", Text(|row| row.note.as_deref())),
    ];

    /// The side of the least thickness on which the claim errs.
    fn side(&self) -> Option<&'static str> {
        Some(match self.judgement()?.side()? {
            ErrorSide::Thinner => "thinner",
            ErrorSide::Thicker => "thicker",
        })
    }

    /// The number of a quantity, if it is judged.
    pub(crate) fn number(&self, quantity: Quantity) -> Option<&Judged> {
        self.numbers().iter().find(|number| number.quantity == quantity)
    }
}

/// The columns of a number; bounds are rounded outward, errors correctly rounded.
pub(super) const NUMBER: [NamedColumn<Judged>; 11] = [
    ("claimed", Text(|number| Some(&number.claimed))),
    ("value", Shown(|number| Some(certified(&number.certified)))),
    ("lower", Shown(|number| Some(&number.certified.finite()?.lower))),
    ("upper", Shown(|number| Some(&number.certified.finite()?.upper))),
    ("error", Shown(|number| Some(&number.errors.as_ref()?.absolute))),
    ("relative_error", Shown(|number| Some(number.errors.as_ref()?.relative.as_ref()?))),
    ("error_units", Shown(|number| Some(&number.errors.as_ref()?.units))),
    ("error_ulp", Shown(|number| Some(number.errors.as_ref()?.ulp.as_ref()?))),
    ("correct_digits", Made(|number| Some(digits(number.correct_digits)))),
    ("rounding", Text(|number| Some(number.rounding?.name()))),
    ("nearest_double", Truth(|number| number.is_nearest_double)),
];

/// A number of digits, or `inf` for a number that is exactly the truth.
pub(super) fn digits(correct: CorrectDigits) -> String {
    match correct {
        CorrectDigits::Digits(digits) => digits.to_string(),
        CorrectDigits::Exact => "inf".to_owned(),
    }
}

/// The certified value, or the word for none.
pub(super) fn certified(value: &Certified) -> &dyn Display {
    match value {
        Certified::Finite(rounded) => &rounded.value,
        Certified::Infinite => &"inf",
        Certified::Missing => &"none",
    }
}
