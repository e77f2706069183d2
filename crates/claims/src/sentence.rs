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
    /// Claims, by their ids; there is at least one, and each has to hold for the sentence to hold.
    Claims(&'static [&'static str]),
    /// Printed digits: `couplet audit` compares each with its certified value.
    Audit,
    /// An opinion of the authors, on what matters or is simple: no proof can decide it.
    Opinion,
    /// The sentence says less than the claims that bear on it, or may be read in more than one way: it is an opinion,
    /// with a note on what the claims leave of it.
    Reading(&'static [&'static str], &'static str),
    /// The sentence is not decided here, and why.
    Open(&'static str),
}
