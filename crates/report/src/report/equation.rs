//! Equations of the paper: for a person, and JSON (`couplet.equation/1`).

use super::fields::Fields;
use super::json;
use super::words::{apart, count, model};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::certify::equation::{
    ClosedAt, ClosedForm, EquationValue, Evaluated, LinkAt, PolynomialAt, RadicandAt, RootAt,
    RootBranch,
};
use crate::number::Decimal;
use crate::problem::Quantity;
use std::io;

/// An equation at given values, and what is proved of it.
#[derive(Debug)]
pub struct EvaluatedEquation {
    /// Number of the equation.
    pub equation: u8,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Quantities that are given, as they were.
    pub given: Vec<(Quantity, String)>,
    /// Result that is proved.
    pub found: Result<EquationFound, Undecided>,
}

/// Result of an equation.
#[derive(Debug)]
pub enum EquationFound {
    /// (7) to (12), at a joint.
    AtJoint(Evaluated),
    /// Values of another equation.
    Values(Vec<EquationValue>),
}

impl EvaluatedEquation {
    /// Result at a joint, or why there is none; `None` of other equations.
    fn at_joint(&self) -> Option<Result<&Evaluated, &Undecided>> {
        match &self.found {
            Ok(EquationFound::AtJoint(found)) => Some(Ok(found)),
            Ok(EquationFound::Values(_)) => None,
            Err(undecided) => Some(Err(undecided)),
        }
    }

    /// Values of an equation that has no joint of its own.
    fn values(&self) -> &[EquationValue] {
        match &self.found {
            Ok(EquationFound::Values(values)) => values,
            _ => &[],
        }
    }

    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<Undecided> {
        match self.at_joint()? {
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

/// Symbol and name of an unknown.
fn unknown(form: ClosedForm) -> (&'static str, &'static str) {
    match form {
        ClosedForm::OpeningVariable => ("A", "opening_variable"),
        ClosedForm::Thickness => ("eta", "thickness"),
        ClosedForm::Thrust => ("h", "thrust"),
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

pub(super) fn table(all: &[EvaluatedEquation], out: &mut dyn io::Write) -> io::Result<()> {
    apart(all, out, one)
}

fn one(of: &EvaluatedEquation, out: &mut dyn io::Write) -> io::Result<()> {
    let given = of.given.iter().map(|(quantity, text)| format!("{} = {text}", quantity.name()));
    let given: Vec<String> = given.collect();
    let (number, given, weight) = (of.equation, given.join(", "), model(of.weight));
    writeln!(out, "Equation ({number}) at {given}, {weight}\n")?;
    for value in of.values() {
        writeln!(out, "   {:<20} {:<18} {}", value.name, value.symbol, value.figure)?;
    }
    let Some(found) = of.at_joint() else { return Ok(()) };
    match found {
        Err(undecided) => writeln!(out, "{undecided}"),
        Ok(Evaluated::Cubics(all)) => {
            all.iter().try_for_each(|polynomial| self::polynomial(polynomial, out))?;
            let open = all.iter().find_map(|of| of.roots.as_ref().err());
            match open {
                Some(open) => writeln!(out, "{open}"),
                None => roots_proved(all, out),
            }
        }
        Ok(Evaluated::Link(found)) => link(found, out),
        Ok(Evaluated::Closed(form, branches)) => closed(*form, branches, out),
        Ok(Evaluated::Radicand(found)) => radicand(found, out),
    }
}

fn polynomial(of: &PolynomialAt, out: &mut dyn io::Write) -> io::Result<()> {
    let (symbol, _) = unknown(of.unknown);
    let degree = of.coefficients.len() - 1;
    let kind = if degree == 3 { "cubic" } else { "quadratic" };
    writeln!(out, "{kind} in {symbol}")?;
    for (index, coefficient) in of.coefficients.iter().enumerate() {
        let power = match degree - index {
            0 => "1".to_owned(),
            1 => symbol.to_owned(),
            power => format!("{symbol}^{power}"),
        };
        writeln!(out, "   coefficient of {power:<5}  {coefficient}")?;
    }
    for root in of.roots.iter().flatten() {
        writeln!(out, "   root  {}", root.value)?;
        writeln!(out, "      residual {}", between(&root.residual))?;
        writeln!(out, "      {}", fate(root))?;
    }
    if of.has_complex_pair() == Some(true) {
        writeln!(out, "   two roots are complex")?;
    }
    writeln!(out)
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

fn roots_proved(all: &[PolynomialAt], out: &mut dyn io::Write) -> io::Result<()> {
    let has_pair = all.iter().any(|of| of.has_complex_pair() == Some(true));
    let sign = if has_pair { "positive" } else { "negative" };
    let roots = all.iter().flat_map(|of| of.roots.iter().flatten());
    if roots.clone().all(|root| root.branch.is_none()) {
        writeln!(out, "no state has this joint: no root has a thickness between 0 and 2")?;
    }
    writeln!(
        out,
        "proved: these are all real roots, each alone in its box; (12) is {sign}, the discriminant of all up to a \
         negative factor"
    )
}

fn link(of: &LinkAt, out: &mut dyn io::Write) -> io::Result<()> {
    let names = ["S = sin(beta)", "f = S + beta C", "g = beta + S C"];
    for (name, figure) in names.iter().zip(&of.abbreviations) {
        writeln!(out, "   {name:<24} {figure}")?;
    }
    writeln!(out, "   {:<24} {}", "beta S^2 + C f - g", between(&of.difference))?;
    let words = if of.holds { "zero is in the enclosure" } else { "zero is not in the enclosure" };
    writeln!(
        out,
        "\n{words}; that (8) holds for every joint is the claim eq-8 (couplet prove eq-8)"
    )
}

fn closed(form: ClosedForm, all: &[ClosedAt], out: &mut dyn io::Write) -> io::Result<()> {
    let (symbol, _) = unknown(form);
    for of in all {
        writeln!(out, "{symbol}, {} signs: the state with {}", of.branch.name(), side(of.branch))?;
        let lost = |digits: u32| count(digits as usize, "digit", "digits");
        writeln!(out, "   as printed            {}", of.printed)?;
        writeln!(out, "      imaginary part     {}", between(&of.imaginary))?;
        writeln!(out, "      lost, at most      {}", lost(of.printed_loss))?;
        writeln!(out, "   trigonometric form    {}", of.trigonometric)?;
        writeln!(out, "      lost, at most      {}\n", lost(of.trigonometric_loss))?;
    }
    writeln!(
        out,
        "proved: the principal cube root lies in its sector, off the cut; every digit shown is right in both forms"
    )
}

fn radicand(of: &RadicandAt, out: &mut dyn io::Write) -> io::Result<()> {
    let (sign, place) = match of.is_positive {
        true => ("positive", "two roots of (7) are complex: no state has this joint"),
        false => ("negative", "all roots of (7) are real"),
    };
    writeln!(out, "   radicand   {}\n\n{sign}, proved: {place}", of.value)
}

pub(super) fn json(all: &[EvaluatedEquation], out: &mut dyn io::Write) -> io::Result<()> {
    json::write_all(all.iter().map(fields), out)
}

fn fields(of: &EvaluatedEquation) -> Fields {
    let mut fields = Fields::of("couplet.equation/1");
    fields.add("equation", of.equation);
    fields.add("weight", of.weight.name());
    let given = of.given.iter().map(|(quantity, text)| (quantity.name(), text.as_str().into()));
    fields.add_fields("given", Some(given.collect()));
    let open = of.first_open();
    fields.add("verdict", if open.is_some() { "undecided" } else { "proved" });
    fields.add("reason", open.map(|open| open.reason.into_owned()));
    if !of.values().is_empty() {
        let values = of.values().iter().map(|value| {
            let mut fields = Fields::named("name", [value.name.into()]);
            fields.append(Fields::bounds(&value.figure.decimal));
            fields
        });
        fields.add_list("values", values);
    }
    match of.at_joint() {
        None | Some(Err(_)) => {}
        Some(Ok(Evaluated::Cubics(all))) => {
            fields.add_list("polynomials", all.iter().map(of_polynomial))
        }
        Some(Ok(Evaluated::Link(found))) => {
            for (name, figure) in ["sin", "f", "g"].into_iter().zip(&found.abbreviations) {
                fields.add_bounds(name, Some(figure));
            }
            fields.add_fields("difference", Some(bounds(&found.difference)));
            fields.add("holds", found.holds);
        }
        Some(Ok(Evaluated::Closed(form, all))) => {
            fields.add("unknown", unknown(*form).1);
            fields.add_list("branches", all.iter().map(of_branch));
        }
        Some(Ok(Evaluated::Radicand(found))) => {
            fields.add_bounds("radicand", Some(&found.value));
            fields.add("is_positive", found.is_positive);
        }
    }
    fields
}

fn bounds([lower, upper]: &[Decimal; 2]) -> Fields {
    Fields::named("lower upper", [lower.to_string().into(), upper.to_string().into()])
}

fn of_polynomial(of: &PolynomialAt) -> Fields {
    let mut fields = Fields::default();
    fields.add("unknown", unknown(of.unknown).1);
    let coefficients = of.coefficients.iter().map(|figure| Fields::bounds(&figure.decimal));
    fields.add_list("coefficients", coefficients);
    let root = |root: &RootAt| {
        let mut fields = Fields::default();
        fields.add_bounds("root", Some(&root.value));
        fields.add_fields("residual", Some(bounds(&root.residual)));
        fields.add_bounds("thickness", Some(&root.thickness));
        fields.add("branch", root.branch.map(RootBranch::name));
        fields
    };
    fields.add_list("real_roots", of.roots.iter().flatten().map(root));
    fields.add("has_complex_pair", of.has_complex_pair());
    fields
}

fn of_branch(of: &ClosedAt) -> Fields {
    let mut fields = Fields::default();
    fields.add("branch", of.branch.name());
    fields.add_bounds("printed", Some(&of.printed));
    fields.add_fields("imaginary", Some(bounds(&of.imaginary)));
    fields.add("printed_digits_lost", of.printed_loss);
    fields.add_bounds("trigonometric", Some(&of.trigonometric));
    fields.add("trigonometric_digits_lost", of.trigonometric_loss);
    fields
}
