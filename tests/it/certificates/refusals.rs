//! A table of spoiled certificates: one test for each, which names why it has to be refused.

use super::originals::{file_alike, landmark, state};
use couplet::check::Refusal;
use serde_json::Value;

/// The largest number of digits that is accepted.
pub(super) const MAX_DIGITS: usize = 60;

/// A spoiled certificate, and what was done to it.
pub(super) struct Spoiled {
    pub what: String,
    pub bytes: Vec<u8>,
}

impl Spoiled {
    pub(super) fn new(what: &str, bytes: impl Into<Vec<u8>>) -> Self {
        Self { what: what.to_owned(), bytes: bytes.into() }
    }
}

/// A certificate that is accepted, to be spoiled.
#[derive(Clone, Copy)]
pub(super) struct Original(pub &'static Value);

/// That of the triple point.
pub(super) fn point() -> Original {
    Original(landmark("T"))
}

/// That of an arch.
pub(super) fn arch() -> Original {
    Original(state("2.45", "1.35"))
}

impl Original {
    /// With another value at some place.
    pub(super) fn with(self, place: &str, value: impl Into<Value>) -> Spoiled {
        let value = value.into();
        let what = format!("{place} = {value:.60}");
        self.changed(&what, |copy| *copy.pointer_mut(place).expect(place) = value)
    }

    /// Without one of the fields of an object.
    pub(super) fn without(self, place: &str, key: &str) -> Spoiled {
        let what = format!("{place} without {key}");
        self.changed(&what, |copy| {
            let object = copy.pointer_mut(place).unwrap().as_object_mut().unwrap();
            assert!(object.remove(key).is_some(), "{what}");
        })
    }

    /// With one text replaced by another.
    pub(super) fn replaced(self, from: &str, to: &str) -> Spoiled {
        let text = self.0.to_string();
        assert!(text.contains(from), "{from}");
        Spoiled::new(to, text.replacen(from, to, 1))
    }

    pub(super) fn changed(self, what: &str, change: impl FnOnce(&mut Value)) -> Spoiled {
        let mut copy = self.0.clone();
        change(&mut copy);
        Spoiled::new(what, copy.to_string())
    }
}

/// Spoiled copies of one kind with their reasons.
pub(super) type Cases = Vec<(Spoiled, Refusal)>;

/// Whether a refusal is for this reason, as Rust writes it, in few words and without a sequence of its own. Behind what
/// a format is told to be come the place in the file and the types expected, which are serde's words.
pub(super) fn is_reason(refusal: &Refusal, reason: &str) -> bool {
    let (words, found) = (refusal.to_string(), format!("{refusal:?}"));
    let is_told = match reason.strip_suffix("\")").filter(|_| reason.starts_with("Format(")) {
        Some(reason) => found.starts_with(reason),
        None => found == reason,
    };
    is_told && words.len() < 400 && !words.contains(char::is_control)
}

/// Every arithmetic refuses each copy for exactly its reason.
pub(super) fn refused(cases: Cases) {
    for (Spoiled { what, bytes }, expected) in cases {
        let found = file_alike(&bytes, MAX_DIGITS).expect_err(&what);
        assert!(is_reason(&found, &format!("{expected:?}")), "{what}: {found:?} {expected:?}");
    }
}

/// A table of spoiled copies: `name: copy => reason;` or, for copies of one kind, `name: cases;`.
macro_rules! refusals {
    (@cases $spoiled:expr => $refusal:expr) => { vec![($spoiled, $refusal)] };
    (@cases $cases:expr) => { $cases };
    ($($name:ident: $spoiled:expr $(=> $refusal:expr)?;)*) => {
        $(
            #[test]
            fn $name() {
                $crate::certificates::refusals::refused(refusals!(@cases $spoiled $(=> $refusal)?));
            }
        )*

        /// The table.
        pub(super) fn cases() -> $crate::certificates::refusals::Cases {
            let tables: Vec<$crate::certificates::refusals::Cases> =
                vec![$(refusals!(@cases $spoiled $(=> $refusal)?)),*];
            tables.into_iter().flatten().collect()
        }
    };
}
