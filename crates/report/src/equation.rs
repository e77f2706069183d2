//! Equations of the paper, `couplet.equation/1`.

use super::record::Record;
use super::reported::Reported;
use super::tabular::Tabular;
use super::words::{count, model};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::certify::equation::{
    ClosedAt, ClosedForm, EquationValue, Evaluated, LinkAt, NumberedEquation, PolynomialAt,
    RadicandAt, RootAt, RootBranch,
};
use crate::certify::state::Figure;
use crate::number::Decimal;
use crate::problem::Quantity;

/// An equation at given values, and what is proved of it.
#[derive(Debug)]
pub struct EvaluatedEquation {
    /// The equation.
    pub equation: NumberedEquation,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Quantities that are given, as they were.
    pub given: Vec<(Quantity, String)>,
    /// Result that is proved.
    pub found: Result<Evaluated, Undecided>,
}

impl EvaluatedEquation {
    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<Undecided> {
        match &self.found {
            Err(undecided) => Some(undecided.clone()),
            Ok(Evaluated::Cubics(all)) => {
                all.iter().find_map(|of| of.roots.as_ref().err()).cloned()
            }
            Ok(Evaluated::Link(link)) if !link.holds => {
                Some(Undecided::new("the two sides of (8), which differ"))
            }
            Ok(_) => None,
        }
    }
}

/// Arches to which the states of a branch belong.
fn side(branch: RootBranch) -> &'static str {
    match branch {
        RootBranch::Upper => "alpha < alpha_sb",
        RootBranch::Lower => "alpha > alpha_sb",
    }
}

fn between([lower, upper]: &[Decimal; 2]) -> String {
    format!("in [{lower}, {upper}]")
}

impl Reported for EvaluatedEquation {
    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.equation/1");
        let given = self.given.iter().map(|(of, text)| format!("{} = {text}", of.name()));
        let given = given.collect::<Vec<_>>().join(", ");
        let (number, weight) = (self.equation.number(), model(self.weight));
        record.say(format!("Equation ({number}) at {given}, {weight}\n"));
        record.add("equation", number);
        record.add("weight", self.weight.name());
        let given = self.given.iter().map(|(of, text)| (of.name(), text.as_str().into()));
        record.add_record("given", Some(given.collect()));
        let open = self.first_open();
        record.add("verdict", if open.is_some() { "undecided" } else { "proved" });
        record.add("reason", open.map(|open| open.reason.into_owned()));
        match &self.found {
            Err(undecided) => record.say(undecided.to_string()),
            Ok(Evaluated::Values(values)) => record.add_list("values", values.iter().map(value)),
            Ok(Evaluated::Cubics(all)) => polynomials(all, &mut record),
            Ok(Evaluated::Link(found)) => link(found, &mut record),
            Ok(Evaluated::Closed(form, all)) => closed(*form, all, &mut record),
            Ok(Evaluated::Radicand(found)) => radicand(found, &mut record),
        }
        vec![record]
    }

    /// The values, roots or branches.
    fn tabular(&self) -> Tabular {
        let row = |name: &'static str, figure: &Figure, branch: Option<RootBranch>| {
            let mut row = Record::named("name", [name.into()]);
            row.add("branch", branch.map(RootBranch::name));
            row.append(Record::bounds(&figure.decimal));
            row.add("equation", self.equation.number());
            row.add("weight", self.weight.name());
            row
        };
        let value = |of: &EquationValue| row(of.name, &of.figure, None);
        let roots = |of: &PolynomialAt| {
            let [_, name] = of.unknown.words();
            let roots = of.roots.iter().flatten();
            roots.map(|root| row(name, &root.value, root.branch)).collect::<Vec<_>>()
        };
        let rows: Vec<Record> = match &self.found {
            Err(_) => Vec::new(),
            Ok(Evaluated::Values(values)) => values.iter().map(value).collect(),
            Ok(Evaluated::Link(found)) => found.abbreviations.iter().map(value).collect(),
            Ok(Evaluated::Cubics(all)) => all.iter().flat_map(roots).collect(),
            Ok(Evaluated::Closed(form, all)) => {
                let [_, name] = form.words();
                all.iter().map(|of| row(name, &of.printed, Some(of.branch))).collect()
            }
            Ok(Evaluated::Radicand(found)) => vec![row("radicand", &found.value, None)],
        };
        Tabular::of("equation weight name branch value lower upper", rows)
    }
}

fn value(of: &EquationValue) -> Record {
    let mut record = Record::named("name", [of.name.into()]);
    record.say(format!("   {:<20} {:<18} {}", of.name, of.symbol, of.figure));
    record.append(Record::bounds(&of.figure.decimal));
    record
}

fn bounds([lower, upper]: &[Decimal; 2]) -> Record {
    Record::named("lower upper", [lower.to_string().into(), upper.to_string().into()])
}

fn polynomials(all: &[PolynomialAt], record: &mut Record) {
    record.add_list("polynomials", all.iter().map(polynomial));
    if let Some(open) = all.iter().find_map(|of| of.roots.as_ref().err()) {
        return record.say(open.to_string());
    }
    let has_pair = all.iter().any(|of| of.has_complex_pair() == Some(true));
    let sign = if has_pair { "positive" } else { "negative" };
    let mut roots = all.iter().flat_map(|of| of.roots.iter().flatten());
    if roots.all(|root| root.branch.is_none()) {
        record.say("no state has this joint: no root has a thickness between 0 and 2");
    }
    record.say(format!(
        "proved: these are all real roots, each alone in its box; (12) is {sign}, the discriminant of all up to a \
         negative factor"
    ));
}

fn polynomial(of: &PolynomialAt) -> Record {
    let mut record = Record::default();
    let [symbol, name] = of.unknown.words();
    let degree = of.coefficients.len() - 1;
    record.say(format!("{} in {symbol}", if degree == 3 { "cubic" } else { "quadratic" }));
    record.add("unknown", name);
    let coefficient = |(index, figure): (usize, &Figure)| {
        let power = match degree - index {
            0 => "1".to_owned(),
            1 => symbol.to_owned(),
            power => format!("{symbol}^{power}"),
        };
        let mut record = Record::bounds(&figure.decimal);
        record.say(format!("   coefficient of {power:<5}  {figure}"));
        record
    };
    record.add_list("coefficients", of.coefficients.iter().enumerate().map(coefficient));
    record.add_list("real_roots", of.roots.iter().flatten().map(root));
    if of.has_complex_pair() == Some(true) {
        record.say("   two roots are complex");
    }
    record.add("has_complex_pair", of.has_complex_pair());
    record.say("");
    record
}

fn root(of: &RootAt) -> Record {
    let mut record = Record::default();
    record.say(format!("   root  {}", of.value));
    record.say(format!("      residual {}", between(&of.residual)));
    record.say(format!("      {}", fate(of)));
    record.add_bounds("root", Some(&of.value));
    record.add_record("residual", Some(bounds(&of.residual)));
    record.add_bounds("thickness", Some(&of.thickness));
    record.add("branch", of.branch.map(RootBranch::name));
    record
}

/// State of a root, or why it has none.
fn fate(root: &RootAt) -> String {
    match root.branch {
        Some(branch) => {
            format!("the purely rotational state with {}, {} signs", side(branch), branch.name())
        }
        None => format!("no state: its thickness {} is not between 0 and 2", root.thickness),
    }
}

fn link(of: &LinkAt, record: &mut Record) {
    for EquationValue { name, symbol, figure, .. } in &of.abbreviations {
        record.say(format!("   {symbol:<24} {figure}"));
        record.add_bounds(name, Some(figure));
    }
    record.say(format!("   {:<24} {}", "beta S^2 + C f - g", between(&of.difference)));
    record.add_record("difference", Some(bounds(&of.difference)));
    record.add("holds", of.holds);
    let words = if of.holds { "zero is in the enclosure" } else { "zero is not in the enclosure" };
    record.say(format!(
        "\n{words}; that (8) holds for every joint is the claim eq-8 (couplet prove eq-8)"
    ));
}

fn closed(form: ClosedForm, all: &[ClosedAt], record: &mut Record) {
    let [symbol, name] = form.words();
    record.add("unknown", name);
    record.add_list("branches", all.iter().map(|of| branch(symbol, of)));
    record.say(
        "proved: the principal cube root lies in its sector, off the cut; every digit shown is right in both forms",
    );
}

fn branch(symbol: &str, of: &ClosedAt) -> Record {
    let mut record = Record::default();
    let lost = |digits: u32| count(digits as usize, "digit", "digits");
    record.say(format!("{symbol}, {} signs: the state with {}", of.branch.name(), side(of.branch)));
    record.say(format!("   as printed            {}", of.printed));
    record.say(format!("      imaginary part     {}", between(&of.imaginary)));
    record.say(format!("      lost, at most      {}", lost(of.printed_loss)));
    record.say(format!("   trigonometric form    {}", of.trigonometric));
    record.say(format!("      lost, at most      {}\n", lost(of.trigonometric_loss)));
    record.add("branch", of.branch.name());
    record.add_bounds("printed", Some(&of.printed));
    record.add_record("imaginary", Some(bounds(&of.imaginary)));
    record.add("printed_digits_lost", of.printed_loss);
    record.add_bounds("trigonometric", Some(&of.trigonometric));
    record.add("trigonometric_digits_lost", of.trigonometric_loss);
    record
}

fn radicand(of: &RadicandAt, record: &mut Record) {
    let (sign, place) = match of.is_positive {
        true => ("positive", "two roots of (7) are complex: no state has this joint"),
        false => ("negative", "all roots of (7) are real"),
    };
    record.say(format!("   radicand   {}\n\n{sign}, proved: {place}", of.value));
    record.add_bounds("radicand", Some(&of.value));
    record.add("is_positive", of.is_positive);
}
