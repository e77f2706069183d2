//! An equation or a sentence of the paper, with what decides it.

/// An equation or a sentence of the paper.
#[derive(Clone, Copy, Debug)]
pub struct Sentence {
    /// Place in the paper.
    pub place: &'static str,
    /// Content of the sentence.
    pub says: &'static str,
    /// Decision on it.
    pub decided: Decided,
}

/// Decision on a sentence.
#[derive(Clone, Copy, Debug)]
pub enum Decided {
    /// Claims, by their ids; there is at least one.
    Claims(&'static [&'static str]),
    /// Printed digits: `couplet audit` compares each with its certified value.
    Audit,
    /// The sentence is not decided here, and why.
    Open(&'static str),
}

impl Sentence {
    /// Names the claims that decide it.
    pub(super) const fn by(self, claims: &'static [&'static str]) -> Self {
        Self { decided: Decided::Claims(claims), ..self }
    }

    /// Says why it is not decided.
    pub(super) const fn open(self, why: &'static str) -> Self {
        Self { decided: Decided::Open(why), ..self }
    }
}
