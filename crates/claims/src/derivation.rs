//! The steps of a proof, checked as they are written down.

use crate::certify::{Undecided, cover};
use crate::number::{Ball, Enclosure, ExactField, Field, Ternary, worded};
use crate::symbolic::{Fraction, Notation, Polynomial, Relations, Series, Symbol};
use rug::Rational;
use std::borrow::Borrow;

/// Result of a check: what it gives, or why nothing is proved.
pub(super) type Checked<T = ()> = Result<T, Undecided>;

/// A formula in both notations.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Formula {
    /// Text for a terminal.
    pub text: String,
    /// Text for a document.
    pub latex: String,
}

impl Formula {
    fn new(show: impl Fn(Notation) -> String) -> Self {
        Self { text: show(Notation::Text), latex: show(Notation::Latex) }
    }
}

impl From<String> for Formula {
    /// The text of an exact value: `2(2√3−3)`.
    fn from(text: String) -> Self {
        let latex = text.replace('√', r"\surd ").replace('−', "-");
        Self { text, latex }
    }
}

impl From<(&Polynomial, Symbol)> for Formula {
    /// A polynomial, sorted by the powers of a symbol.
    fn from((polynomial, symbol): (&Polynomial, Symbol)) -> Self {
        Self::new(|notation| polynomial.show_by(symbol, notation))
    }
}

impl From<&Fraction> for Formula {
    /// A polynomial of many terms is sorted by its first symbol.
    fn from(fraction: &Fraction) -> Self {
        let sorted = fraction.as_polynomial().filter(|p| p.len() > 3);
        sorted
            .and_then(|p| Some((p, p.main_symbol()?).into()))
            .unwrap_or_else(|| Self::new(|notation| fraction.show(notation)))
    }
}

worded! {
    /// Support of a step.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Support {
        /// The step is assumed.
        Hypothesis = "hypothesis",
        /// The step gives a name.
        Definition = "definition",
        /// A normal form that is zero, or exact arithmetic.
        Algebra = "algebra",
        /// Balls that cover a whole range.
        Balls = "balls",
        /// Another claim, decided by itself.
        Claim = "claim",
        /// A theorem of `proofs/coq`, which Coq checks and this program does not.
        Theorem = "theorem",
        /// A conclusion from the steps before, in a few words that join them.
        Conclusion = "conclusion",
        /// An argument in words that carries the claim: what is checked before it does not say as much, or the words
        /// are many.
        Argument = "argument",
    }
    /// All of them, in order.
    pub const ALL;
    /// The word used in files.
    pub fn name -> &'static str;
}

/// One line of a derivation.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct DerivationStep {
    /// Support of the step.
    pub support: Support,
    /// Words that it says.
    pub words: String,
    /// The formula it is about.
    pub formula: Option<Formula>,
}

worded! {
    /// Place of an argument in words that no machine has checked.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Argument {
        /// The argument is in the claim itself.
        Own = "own",
        /// The argument is in a claim that is used.
        Beneath = "beneath",
    }
    /// Both places.
    pub const ALL;
    /// The word used in files.
    pub fn name -> &'static str;
}

impl Argument {
    /// Description of the argument.
    pub fn words(self) -> &'static str {
        match self {
            Self::Own => "an argument in words",
            Self::Beneath => "claims that rest on an argument in words",
        }
    }
}

/// Change that the false twin of a check makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Twin {
    /// The first coefficient of an identity or of a series.
    Coefficient,
    /// An exact value.
    Value,
    /// The sign of what is positive, on each piece of a range.
    Sign,
    /// The twin changes the input with which the statement is made: another arch, landmark, range or bound,
    /// at which it does not hold.
    Input,
    /// The sides of an inequality between two numbers.
    Sides,
    /// The twin changes only the verdict: what is proved is a box or a cell, which has no false place at hand.
    Verdict,
}

/// Theorems of `proofs/coq`, one a line: module and name, place in the paper, and what it says.
const THEOREMS: &str = include_str!("hand_theorems.txt");

/// Words of the conclusions of a claim that join its checks, at most; more of them are an argument.
const MOST_WORDS: usize = 60;

/// A proof as far as it has come. A check that fails ends it.
#[derive(Clone, Debug, Default)]
pub struct Derivation {
    steps: Vec<DerivationStep>,
    /// The false twins that the checks so far have.
    twins: Vec<Twin>,
    /// Supports of the claims used.
    beneath: Vec<Support>,
    /// The check that is made on a false twin.
    spoiled: Option<usize>,
    /// Numbers with which the statement holds, and with which it does not.
    numbers: [Vec<String>; 2],
}

impl Derivation {
    /// Derivation without any step yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// A derivation whose check number `index` is made on a false twin of what it is given. No claim may come through.
    #[cfg(test)]
    pub fn spoiled(index: usize) -> Self {
        Self { spoiled: Some(index), ..Self::default() }
    }

    /// The steps so far.
    pub fn steps(&self) -> &[DerivationStep] {
        &self.steps
    }

    /// Changes that the false twin of each check changes.
    #[cfg(test)]
    pub(super) fn twins(&self) -> &[Twin] {
        &self.twins
    }

    /// Assumptions of the derivation.
    pub fn hypotheses(&self) -> impl Iterator<Item = &str> {
        let assumed = self.steps.iter().filter(|step| step.support == Support::Hypothesis);
        assumed.map(|step| step.words.as_str())
    }

    /// Description of what the derivation rests on, in words.
    pub fn method(&self) -> String {
        let uses = |support| self.supports().any(|other| other == support);
        let checked = match (uses(Support::Algebra), uses(Support::Balls)) {
            (true, true) => "algebra (normal forms, exact) and analysis (balls over a whole range)",
            (false, true) => "analysis (balls)",
            _ => "algebra (normal forms, exact)",
        };
        format!("{checked}{}", self.beside_checks().unwrap_or_default())
    }

    /// Supports of the claim beside the checks of this program, if there are any: ` and theorems of Coq`.
    pub fn beside_checks(&self) -> Option<String> {
        let uses_theorems = self.supports().any(|support| support == Support::Theorem);
        let theorems = uses_theorems.then_some("theorems of Coq");
        match [theorems, self.argument().map(Argument::words)] {
            [Some(theorems), Some(argument)] => Some(format!(", {theorems} and {argument}")),
            [theorems, argument] => theorems.or(argument).map(|one| format!(" and {one}")),
        }
    }

    /// Tells whether an argument in words carries the claim, or one that it uses.
    pub fn argument(&self) -> Option<Argument> {
        let carries = |support: &Support| *support == Support::Argument;
        match self.steps.iter().any(|step| carries(&step.support)) {
            true => Some(Argument::Own),
            false => self.beneath.iter().any(carries).then_some(Argument::Beneath),
        }
    }

    /// Calls the conclusions an argument where they have more words than [`MOST_WORDS`] together: they carry the claim.
    pub(super) fn weigh_words(&mut self) {
        let is_conclusion = |step: &DerivationStep| step.support == Support::Conclusion;
        let conclusions = self.steps.iter().filter(|step| is_conclusion(step));
        let words: usize = conclusions.map(|step| step.words.split_whitespace().count()).sum();
        if words > MOST_WORDS {
            let conclusions = self.steps.iter_mut().filter(|step| is_conclusion(step));
            conclusions.for_each(|step| step.support = Support::Argument);
        }
    }

    fn push(&mut self, support: Support, words: impl Into<String>, formula: Option<Formula>) {
        self.steps.push(DerivationStep { support, words: words.into(), formula });
    }

    /// Assumes something: it becomes part of the claim.
    pub fn assume(&mut self, words: &str) {
        self.push(Support::Hypothesis, words, None);
    }

    /// Draws a conclusion from the checks before. It ends a proof, or a part of one.
    pub fn conclude(&mut self, words: impl Into<String>) -> Checked {
        self.push(Support::Conclusion, words, None);
        Ok(())
    }

    /// Draws a conclusion that carries the claim, by an argument in words.
    pub fn argue(&mut self, words: impl Into<String>) -> Checked {
        self.push(Support::Argument, words, None);
        Ok(())
    }

    /// Uses theorems of `proofs/coq` by their names. What they say stands in the list of hand theorems.
    pub fn theorems<const N: usize>(&mut self, names: [&str; N]) -> Checked {
        for name in names {
            let says = THEOREMS.lines().find_map(|line| {
                let (theorem, rest) = line.split_once('\t')?;
                rest.split_once('\t').filter(|_| theorem == name)
            });
            let Some((_, says)) = says else {
                return Err(Undecided::new(format!("{name} is no theorem of the list")));
            };
            self.push(Support::Theorem, format!("{name}: {says}"), None);
        }
        Ok(())
    }

    /// Notes a number with which the statement holds. It may end a proof, as a conclusion does.
    pub fn holds(&mut self, words: impl Into<String>) -> Checked {
        self.numbers[0].push(words.into());
        Ok(())
    }

    /// Notes a number with which it does not.
    pub fn fails(&mut self, words: impl Into<String>) -> Checked {
        self.numbers[1].push(words.into());
        Ok(())
    }

    /// The numbers with which the statement holds, and those with which it does not.
    pub(super) fn numbers(&self) -> [String; 2] {
        self.numbers.each_ref().map(|numbers| numbers.join("; "))
    }

    /// Uses a claim that has been decided: its steps are not repeated, but what they rest on counts here too.
    pub(super) fn use_claim(&mut self, words: String, supports: Vec<Support>) {
        self.beneath.extend(supports);
        self.push(Support::Claim, words, None);
    }

    /// Supports of the steps, and those of the claims used.
    pub(super) fn supports(&self) -> impl Iterator<Item = Support> {
        self.steps.iter().map(|step| step.support).chain(self.beneath.iter().copied())
    }

    /// Names a formula.
    pub fn define(&mut self, words: &str, formula: impl Into<Formula>) {
        self.push(Support::Definition, words, Some(formula.into()));
    }

    /// Tells whether the check that comes next is to be made on its false twin.
    fn twin(&mut self, twin: Twin) -> bool {
        let index = self.twins.len();
        self.twins.push(twin);
        self.spoiled == Some(index)
    }

    /// Checks `left = right` for all values of the letters at which no denominator vanishes.
    pub fn identity(
        &mut self,
        words: impl Into<String>,
        left: impl Borrow<Fraction>,
        right: impl Borrow<Fraction>,
    ) -> Checked {
        self.identity_under(words, left, right, &Relations::none())
    }

    /// Checks `left = right` where each sine and cosine are those of an angle.
    pub fn on_circle(
        &mut self,
        words: impl Into<String>,
        left: impl Borrow<Fraction>,
        right: impl Borrow<Fraction>,
    ) -> Checked {
        self.identity_under(words, left, right, &Relations::trigonometric())
    }

    /// Checks `left = right` wherever the relations hold and no denominator vanishes.
    pub fn identity_under(
        &mut self,
        words: impl Into<String>,
        left: impl Borrow<Fraction>,
        right: impl Borrow<Fraction>,
        relations: &Relations,
    ) -> Checked {
        let right = right.borrow();
        self.identity_as(words, left.borrow(), right, relations, right.into())
    }

    /// Checks such an identity, and shows the right side as it was made.
    pub fn identity_as(
        &mut self,
        words: impl Into<String>,
        left: &Fraction,
        right: &Fraction,
        relations: &Relations,
        shown: Formula,
    ) -> Checked {
        let words = words.into();
        let left = if self.twin(Twin::Coefficient) { false_twin(left) } else { left.clone() };
        if [&left, right].iter().any(|x| relations.normal_form(x.denominator()).is_zero()) {
            return Err(Undecided::new(format!("{words}: a denominator vanishes identically")));
        }
        let difference = left - right;
        let normal_form = relations.normal_form(difference.numerator());
        if !normal_form.is_zero() {
            return Err(Undecided::new(format!("{words}: the difference is {normal_form}")));
        }
        self.push(Support::Algebra, words, Some(shown));
        Ok(())
    }

    /// Checks that two exact values are equal.
    pub fn equal<T: ExactField + ToString>(
        &mut self,
        words: impl Into<String>,
        left: &T,
        right: &T,
    ) -> Checked {
        let words = words.into();
        let left = if self.twin(Twin::Value) { left.int(1) + left } else { left.clone() };
        if !(left.clone() - right).is_zero() {
            return Err(Undecided::new(format!(
                "{words}: {} is not {}",
                left.to_string(),
                right.to_string()
            )));
        }
        self.push(Support::Algebra, words, Some(right.to_string().into()));
        Ok(())
    }

    /// Checks that two exact values differ, and returns the words that show it.
    pub fn differ<T: ExactField + ToString>(
        &mut self,
        words: &str,
        left: &T,
        right: &T,
    ) -> Checked<String> {
        let left = if self.twin(Twin::Value) { right.clone() } else { left.clone() };
        if (left.clone() - right).is_zero() {
            return Err(Undecided::new(format!("{words}: both are {}", right.to_string())));
        }
        let counterexample = format!("{words}: {} is not {}", left.to_string(), right.to_string());
        self.push(Support::Algebra, &counterexample, None);
        Ok(counterexample)
    }

    /// Checks that a series vanishes to the order to which it is known.
    pub fn vanishes<T: ExactField + ToString>(
        &mut self,
        words: &str,
        series: &Series<T>,
    ) -> Checked {
        let spoiled = self.twin(Twin::Coefficient);
        let series = if spoiled { series.int(1) + series } else { series.clone() };
        let (valuation, order) = (series.valuation(), series.order());
        if valuation < order || order < 1 {
            return Err(Undecided::new(format!("{words}: the residual is {}", series.show("x"))));
        }
        self.push(
            Support::Algebra,
            format!("{words}: the residual is zero up to order {order}"),
            None,
        );
        Ok(())
    }

    /// Checks a statement about an input. Its false twin is the same statement about another input, at which it
    /// does not hold: a statement that does not look at its input is not proved here.
    pub fn certain<X>(
        &mut self,
        support: Support,
        words: impl Into<String>,
        [input, elsewhere]: [X; 2],
        holds: impl FnOnce(X) -> Checked<Ternary>,
    ) -> Checked {
        let input = if self.twin(Twin::Input) { elsewhere } else { input };
        self.decided(support, words.into(), holds(input)?)
    }

    /// Checks a statement in balls whose proof is known, as it takes long; for the false twin it is sought elsewhere.
    pub(super) fn known<X, T: Clone>(
        &mut self,
        words: impl Into<String>,
        known: &Checked<T>,
        elsewhere: X,
        proof: impl FnOnce(X) -> Checked<T>,
    ) -> Checked {
        self.certain(Support::Balls, words, [None, Some(elsewhere)], |twin| {
            twin.map_or_else(|| known.clone(), proof).map(|_| Ternary::True)
        })
    }

    /// Checks that one number is less than another. Its false twin exchanges them.
    pub fn less(&mut self, words: impl Into<String>, [less, more]: [&Ball; 2]) -> Checked {
        let sides = if self.twin(Twin::Sides) { [more, less] } else { [less, more] };
        self.decided(Support::Balls, words.into(), sides[0].is_less_than(sides[1]))
    }

    /// Checks that a number is positive. Its false twin is the same number at another input, where it is not.
    pub fn above_zero(&mut self, words: impl Into<String>, values: [&Ball; 2]) -> Checked {
        self.certain(Support::Balls, words, values, |value| Ok(value.is_positive()))
    }

    /// Notes what was proved elsewhere about a whole curve or area. Its false twin has nothing but the other verdict.
    pub fn proved_elsewhere(&mut self, words: impl Into<String>, is_proved: bool) -> Checked {
        let is_proved = is_proved != self.twin(Twin::Verdict);
        let truth = if is_proved { Ternary::True } else { Ternary::Undecided };
        self.decided(Support::Balls, words.into(), truth)
    }

    fn decided(&mut self, support: Support, words: String, truth: Ternary) -> Checked {
        match truth {
            Ternary::True => {
                self.push(support, words, None);
                Ok(())
            }
            Ternary::False => Err(Undecided::new(format!("{words}: false"))),
            Ternary::Undecided => Err(Undecided::new(format!("{words}: not decided"))),
        }
    }

    /// Checks that `value` is positive on all of `[low, high]`, by balls.
    pub fn positive(
        &mut self,
        words: &str,
        (low, high): (&Rational, &Rational),
        value: impl Fn(&Ball) -> Ball,
    ) -> Checked {
        let negated = self.twin(Twin::Sign);
        let holds = |x: &Ball| {
            let value = value(x);
            if negated { (-value).is_positive() } else { value.is_positive() }
        };
        let pieces = cover(low, high, &holds).map_err(|undecided| undecided.about(words))?;
        let range = format!("{words} on [{low}, {high}], {pieces} pieces");
        self.push(Support::Balls, range, None);
        Ok(())
    }
}

/// The fraction with the first coefficient of its numerator changed; one for zero.
fn false_twin(fraction: &Fraction) -> Fraction {
    let changed = fraction.numerator().with_changed_coefficient();
    Fraction::new(changed, fraction.denominator().clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Letters;

    #[test]
    fn a_false_identity_ends_the_derivation() {
        let joint = Symbol::joint();
        let (one, circle) = (joint.sin.int(1), joint.sin.square() + joint.cos.square());
        let mut derivation = Derivation::new();
        derivation.on_circle("the circle", &circle, &one).unwrap();
        assert!(derivation.on_circle("twice", circle.clone() * &one.int(2), &one).is_err());
        assert!(Derivation::spoiled(0).on_circle("twin", &circle, &one).is_err());
        assert_eq!(derivation.steps().len(), 1);
        let undefined = one.clone() / (circle.clone() - &one);
        assert!(derivation.on_circle("1/0", &undefined, &undefined).is_err());
    }

    #[test]
    fn a_sign_is_proved_on_the_whole_range() {
        let range = (&Rational::from(1), &Rational::from(3));
        let mut derivation = Derivation::new();
        derivation.positive("x", range, Ball::clone).unwrap();
        assert!(derivation.positive("x - 2", range, |x| x.clone() - x.int(2)).is_err());
        assert!(Derivation::spoiled(0).positive("x", range, Ball::clone).is_err());
    }

    #[test]
    fn a_statement_that_does_not_look_at_its_input_survives_its_twin() {
        let check = |mut d: Derivation, holds: fn(i32) -> Ternary| {
            d.certain(Support::Balls, "x > 0", [1, -1], |x| Ok(holds(x)))
        };
        let honest = |x| Ball::integer(x, 53).is_positive();
        assert!(check(Derivation::new(), honest).is_ok());
        assert!(check(Derivation::spoiled(0), honest).is_err());
        let blind = |_| Ternary::True;
        assert!(check(Derivation::spoiled(0), blind).is_ok(), "and a test finds it");
    }
}
