//! What is proved of the rows of a part. Rows of one half opening share its proofs, wherever they stand in the part;
//! no bit depends on it.

use super::query::{Asked, Query};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::certify::state::{Answer, Certify, Column, Figure};
use crate::problem::{Arch, Mode, Quantity};
use std::borrow::Cow;
use std::collections::HashMap;
use std::ptr;
use std::sync::Arc;

/// As many rows of a half opening as cost less together.
const SHARED: usize = 4;

/// The verdicts on rows, in the order in which they are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    Stands,
    Falls,
    Undecided,
    Refused,
}

impl Verdict {
    pub(super) const ALL: [Self; 4] = [Self::Stands, Self::Falls, Self::Undecided, Self::Refused];

    /// The name used in files.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Stands => "stands",
            Self::Falls => "falls",
            Self::Undecided => "undecided",
            Self::Refused => "refused",
        }
    }
}

/// What is known of a row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    pub verdict: Verdict,
    pub mode: Option<Mode>,
    /// For each quantity its value, where there is one.
    pub values: Vec<Option<Value>>,
    /// Why it is undecided or refused.
    pub reason: Option<String>,
}

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Value {
    /// The nearest double.
    pub double: f64,
    /// Where the true value lies: -1 below the double, 0 on it, 1 above it; none where that is not proved.
    pub side: Option<i32>,
    /// The digits, where there are more than a double tells.
    pub text: Option<String>,
}

/// What is asked of every row.
pub(super) struct Wanted {
    pub quantities: Vec<Quantity>,
    pub digits: usize,
    /// Whether values are written as text too.
    pub has_texts: bool,
}

impl Wanted {
    fn value(&self, figure: Option<&Figure>) -> Value {
        let Some(figure) = figure else {
            let text = self.has_texts.then(|| "inf".to_owned());
            return Value { double: f64::INFINITY, side: Some(0), text };
        };
        let (double, binary) = (figure.double, &figure.binary);
        let side = match (binary.lower >= double, binary.upper <= double) {
            (true, true) => Some(0),
            (true, false) => Some(1),
            (false, true) => Some(-1),
            (false, false) => None,
        };
        Value { double, side, text: self.has_texts.then(|| figure.to_string()) }
    }

    fn without(&self, verdict: Verdict, reason: Option<String>) -> Found {
        Found { verdict, mode: None, values: vec![None; self.quantities.len()], reason }
    }

    fn found(&self, answer: Result<&Answer, &Undecided>) -> Found {
        match answer {
            Ok(Answer::Stands(digits)) => {
                let figures: Vec<_> = digits.figures().collect();
                let value = |of: &Quantity| {
                    let (_, figure) = figures.iter().find(|(quantity, _)| quantity == of)?;
                    Some(self.value(*figure))
                };
                let values = self.quantities.iter().map(value).collect();
                Found { verdict: Verdict::Stands, mode: Some(digits.mode), values, reason: None }
            }
            Ok(Answer::Falls { enough, .. }) => {
                let sliding = enough.as_ref().and_then(|enough| enough.sliding_friction.as_ref());
                let mut found = self.without(Verdict::Falls, None);
                let place = self.quantities.iter().position(|of| *of == Quantity::SlidingFriction);
                if let Some(place) = place {
                    found.values[place] = sliding.map(|figure| self.value(Some(figure)));
                }
                found
            }
            Err(undecided) => {
                self.without(Verdict::Undecided, Some(undecided.reason.clone().into_owned()))
            }
        }
    }

    /// Of a row by itself, without what others share.
    pub(super) fn alone(&self, asked: &Asked) -> Found {
        let Asked { weight, half_opening, friction } = asked;
        let arch = Arch::new(*weight, (**half_opening).clone(), (**friction).clone());
        let answer = match arch {
            Ok(arch) if self.asks_frictions() => arch.certify(self.digits),
            Ok(arch) => arch.certify_alone(self.digits),
            Err(error) => return self.without(Verdict::Refused, Some(error.to_string())),
        };
        self.found(answer.as_ref())
    }

    fn asks_frictions(&self) -> bool {
        self.quantities.iter().any(|of| of.is_friction())
    }

    /// Of the rows of a part, in their order; those that share an answer share it here.
    pub(super) fn all(&self, queries: &[Query]) -> Vec<Arc<Found>> {
        let mut found: Vec<Option<Arc<Found>>> = vec![None; queries.len()];
        // The rows of each half opening; one after the other, so that one column is held at a time.
        let mut groups: Vec<Vec<usize>> = Vec::new();
        let mut group_of: HashMap<(SelfWeight, &[u8]), usize> = HashMap::new();
        for (place, query) in queries.iter().enumerate() {
            match &query.asked {
                Err(reason) => {
                    found[place] =
                        Some(Arc::new(self.without(Verdict::Refused, Some(reason.clone()))))
                }
                Ok(asked) => {
                    let key = (asked.weight, query.texts[1].data());
                    let group = *group_of.entry(key).or_insert_with(|| {
                        groups.push(Vec::new());
                        groups.len() - 1
                    });
                    groups[group].push(place);
                }
            }
        }
        for group in groups {
            let column = self.column(queries, &group);
            let mut last: Option<(&Answer, Arc<Found>)> = None;
            for place in group {
                let Ok(asked) = &queries[place].asked else { continue };
                let answer = column
                    .as_ref()
                    .and_then(|column| column.certify_alone((*asked.friction).clone()).ok());
                found[place] = Some(match (answer, &last) {
                    (Some(Ok(Cow::Borrowed(answer))), Some((of, found)))
                        if ptr::eq(*of, answer) =>
                    {
                        Arc::clone(found)
                    }
                    (Some(Ok(Cow::Borrowed(answer))), _) => {
                        let found = Arc::new(self.found(Ok(answer)));
                        last = Some((answer, Arc::clone(&found)));
                        found
                    }
                    (Some(answer), _) => Arc::new(self.found(answer.as_deref())),
                    (None, _) => Arc::new(self.alone(asked)),
                });
            }
        }
        found.into_iter().flatten().collect()
    }

    /// The column of some rows of one half opening, where it is cheaper.
    fn column(&self, queries: &[Query], group: &[usize]) -> Option<Column> {
        if group.len() < SHARED || self.asks_frictions() {
            return None;
        }
        let asked = queries[group[0]].asked.as_ref().ok()?;
        Column::new(asked.weight, (*asked.half_opening).clone(), self.digits).ok()
    }
}
