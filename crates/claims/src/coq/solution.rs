//! One solution of a system: the claim in printed equations, the table, and its check.

use super::names::{DECIMALS, argument, symbols, weight_name};
use super::numeral::{text, unit};
use super::root::CoqRoot;
use super::table::{ClearedSystem, ContractionTable};
use super::template::fill;
use crate::arch::Unknown;
use crate::certify::Undecided;
use crate::problem::{Equation, System};
use rug::Rational;

/// Texts that fill the holes of a template.
pub(super) type Holes = Vec<(&'static str, String)>;

/// The theorem that a system has one solution in a box.
pub(super) struct CoqSolution {
    /// Texts that the theorem is made of.
    pub values: Holes,
    /// The names of its unknowns.
    pub symbols: Vec<&'static str>,
}

impl CoqSolution {
    /// Chooses the numbers.
    pub(super) fn new(root: &CoqRoot) -> Result<Self, Undecided> {
        let system = &root.system;
        let cleared = ClearedSystem::new(system);
        let table = ContractionTable::new(root, &cleared)?;
        let symbols = symbols(system);
        let mut values = claim(system, &symbols, &table);
        values.extend(numbers(&cleared, &table));
        values.extend(check(system, &symbols));
        Ok(Self { values, symbols })
    }

    /// The file: this between a heading and theorems that follow.
    pub(super) fn between(&self, heading: &str, theorems: &[&str]) -> String {
        [fill(heading, &self.values), self.text(), self.followed_by(theorems)].concat()
    }

    /// Theorems that follow.
    pub(super) fn followed_by(&self, theorems: &[&str]) -> String {
        theorems.iter().map(|template| fill(template, &self.values)).collect()
    }

    /// The claim, the table and its check.
    pub(super) fn text(&self) -> String {
        fill(include_str!("templates/solution.v"), &self.values)
    }
}

/// Statement of the theorem.
fn claim(system: &System, symbols: &[&str], table: &ContractionTable) -> Holes {
    let labels: Vec<&str> = system.equations.iter().map(|equation| equation.label()).collect();
    let equations = system.equations.iter().map(|&e| equation(e, system));
    let wide = symbols.iter().zip(&table.wide);
    let wide = wide.map(|(x, (lo, hi))| format!("{} <= {x} <= {}", text(lo), text(hi)));
    let narrow = symbols.iter().zip(&table.centre);
    let narrow =
        narrow.map(|(x, c)| format!("Rabs ({x} - {}) <= {}", text(c), text(&unit(DECIMALS))));
    let all = |parts: Vec<String>| parts.join(" /\\\n  ");
    vec![
        ("weight", weight_name(system.weight).into()),
        ("delta", system.weight.flag().to_string()),
        ("labels", labels.join("; ")),
        ("args", symbols.join(" ")),
        ("equations", all(equations.collect())),
        ("wide", all(wide.collect())),
        ("narrow", all(narrow.collect())),
        ("radius", text(&unit(DECIMALS))),
    ]
}

/// An equation as the paper prints it, in the names of `Arch.v` and `Instance.v`; of an asymmetric state in those
/// of `Whole.v`.
fn equation(equation: Equation, system: &System) -> String {
    let of = |unknown| argument(system, unknown);
    let (alpha, eta) = (of(Unknown::HalfOpening), of(Unknown::Thickness));
    let (beta, h, mu) = (of(Unknown::RotationJoint), of(Unknown::Thrust), of(Unknown::Friction));
    let joint = of(Unknown::SlidingJoint);
    let (b0, p, v) =
        (of(Unknown::CrownHinge), of(Unknown::CrownMoment), of(Unknown::VerticalForce));
    let delta = system.weight.flag();
    match equation {
        Equation::LowerThrust => format!("{h} = h_lower {delta} {beta} {eta}"),
        Equation::UpperThrust => format!("{h} = h_upper {delta} {alpha} {beta} {eta}"),
        Equation::WholeThrust => format!("{h} = h_whole {delta} {alpha} {eta}"),
        Equation::Tangency => format!("{h} = h_tangency {delta} {beta} {eta}"),
        Equation::TangencyAtCrown => format!("{h} = end_of_rotation {delta} {eta}"),
        Equation::DoubleThickness => format!("double_thickness {delta} {beta} {eta}"),
        Equation::ShoulderSliding => format!("{mu} = mu_ss {alpha} {h}"),
        Equation::InnerSliding => format!("{mu} = mu_is {h}"),
        Equation::Steepest => format!("{joint} = Arch.beta_s {h}"),
        Equation::CrownHinge => format!("from_extrados {delta} {eta} {h} {p} {v} {b0} = 0"),
        Equation::CrownTangency => format!("extrados_slope {delta} {eta} {h} {v} {b0} = 0"),
        Equation::HaunchHinge => format!("from_intrados {delta} {eta} {h} {p} {v} (- {beta}) = 0"),
        Equation::HaunchTangency => format!("intrados_slope {delta} {eta} {h} {v} (- {beta}) = 0"),
        Equation::ShoulderSlides => format!("against_outwards {mu} {h} {v} {alpha} = 0"),
        Equation::InnerSlides => format!("against_outwards {mu} {h} {v} (- {joint}) = 0"),
        Equation::InnerSteepest => format!("outwards_slope {mu} {h} {v} (- {joint}) = 0"),
        Equation::ShoulderOpens => format!("from_extrados {delta} {eta} {h} {p} {v} {alpha} = 0"),
        Equation::Fits => {
            format!("(2 - {eta}) * cos ({beta} + {alpha}) = (2 + {eta}) * cos ({alpha} - {b0})")
        }
    }
}

/// The lemma of `Instance.v` or `Whole.v` that links the cleared form of an equation to the printed one.
fn lemma(equation: Equation) -> Option<&'static str> {
    Some(match equation {
        Equation::LowerThrust => "cleared_lower",
        Equation::UpperThrust => "cleared_upper",
        Equation::WholeThrust => "cleared_whole",
        Equation::Tangency => "cleared_tangency",
        Equation::TangencyAtCrown => "cleared_tangency_at_crown",
        Equation::DoubleThickness => "cleared_double_thickness",
        Equation::ShoulderSliding => "cleared_shoulder_sliding",
        Equation::InnerSliding => "cleared_inner_sliding",
        // With the equation before it.
        Equation::Steepest => return None,
        _ => "cleared_margin",
    })
}

/// The table.
fn numbers(cleared: &ClearedSystem, table: &ContractionTable) -> Holes {
    let terms: Vec<String> = cleared.residuals.iter().map(|term| term.to_string()).collect();
    let slopes = cleared.jacobian.iter().map(|row| {
        let row: Vec<String> = row.iter().map(|term| term.to_string()).collect();
        format!("[{}]", row.join(";\n     "))
    });
    vec![
        ("residuals", terms.join(";\n    ")),
        ("jacobian", slopes.collect::<Vec<_>>().join(";\n    ")),
        ("centre", numerals(&table.centre, ";\n    ")),
        ("radii", numerals(&table.radii, "; ")),
        ("inverse", matrix(&table.inverse)),
        ("slopes", matrix(&table.slopes)),
        ("spreads", matrix(&table.spreads)),
        ("size", text(&table.residual)),
        ("factor", text(&table.factor)),
        ("precision", table.precision.to_string()),
    ]
}

fn numerals(numbers: &[Rational], between: &str) -> String {
    numbers.iter().map(text).collect::<Vec<_>>().join(between)
}

fn matrix(rows: &[Vec<Rational>]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| format!("[{}]", numerals(row, "; "))).collect();
    rows.join(";\n    ")
}

/// Values that the check has to spell out for each unknown or equation.
fn check(system: &System, symbols: &[&str]) -> Holes {
    let n = system.unknowns.len();
    let each = |f: &dyn Fn(usize) -> String| (0..n).map(f).collect::<Vec<_>>();
    let others: Vec<String> = symbols.iter().map(|x| format!("{x}'")).collect();
    let equal: Vec<String> = symbols.iter().map(|x| format!("{x}' = {x}")).collect();
    let coordinates = each(&|k| format!("(x {k}%nat)"));
    let bounds = each(&|k| format!("generalize (bounds Hx {k} ltac:(lia))."));
    let same = each(&|k| format!("apply (same {k}%nat); lia"));
    vec![
        ("n", n.to_string()),
        ("coordinates", coordinates.join(" ")),
        ("witnesses", coordinates.join(", ")),
        ("bounds", bounds.join("\n  ")),
        ("hypotheses", each(&|k| format!("B{k}")).join(" ")),
        ("clearing", clearing(system).join("\n  ")),
        ("others", others.join(" ")),
        ("others_list", others.join("; ")),
        ("pattern", others.join(" & ")),
        ("witness", symbols.join(" & ")),
        ("listed", symbols.join(", ")),
        ("equal", equal.join(" /\\ ")),
        ("same", same.join(" | ")),
    ]
}

/// One step for each equation; (18) takes the last two together.
fn clearing(system: &System) -> Vec<String> {
    let lemmas: Vec<&str> = system.equations.iter().filter_map(|&e| lemma(e)).collect();
    let last = lemmas.len() - 1;
    let step = |(index, lemma): (usize, &&str)| {
        let tactic = if *lemma == "cleared_margin" { "margins" } else { "clearing" };
        if index == last {
            format!("apply {lemma}; {tactic}.")
        } else {
            format!("apply both_under; [apply {lemma}; {tactic} | intros E{index}].")
        }
    };
    lemmas.iter().enumerate().map(step).collect()
}
