//! Parts of the work that a plan leaves out, and why.

use super::nodes::{ArchNode, RANGE_OF_THRUSTS, Work};
use super::plan::Plan;
use super::run::Costs;
use super::schema::MapLine;
use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::certify::quantities;
use crate::certify::state::Wanted;
use crate::claims::claims;
use crate::problem::{Equation, Landmark, Quantity};
use crate::report::words::{count, list};

/// Statements of what is not computed, and why.
pub(super) fn left_out(plan: &Plan, costs: Option<&Costs>) -> Vec<String> {
    let (mut landmarks, mut arches_asked, mut curves) = (Vec::new(), Vec::new(), Vec::new());
    let mut claims_asked = 0;
    for part in &plan.parts {
        match &part.work {
            Work::Landmark(node) => landmarks.push(node),
            Work::Arch(node) => arches_asked.push(node),
            Work::Curve(node) => curves.push(node),
            Work::Claim(_) => claims_asked += 1,
            Work::Drawing(_) | Work::Survey(_) => {}
        }
    }
    let mut lines = Vec::new();
    let not_asked = |what: String| format!("{what}: not asked for");
    for weight in SelfWeight::ALL {
        let asked = |landmark: &Landmark| {
            landmarks.iter().any(|n| (n.landmark, n.weight) == (*landmark, weight))
        };
        let rest: Vec<Landmark> = Landmark::ALL.into_iter().filter(|l| !asked(l)).collect();
        if !rest.is_empty() && !landmarks.is_empty() {
            let symbols = list(rest.into_iter().map(Landmark::symbol));
            lines.push(not_asked(format!("landmarks {symbols} {}", weight.name())));
        }
    }
    let mut partly: Vec<((SelfWeight, usize), Vec<&str>)> = Vec::new();
    for node in landmarks.into_iter().filter(|node| !node.asked.is_empty()) {
        let asked = |quantity: &Quantity| node.asked.iter().any(|(of, _)| of == quantity);
        let rest = quantities(node.landmark).filter(|quantity| !asked(quantity)).count();
        let (key, symbol) = ((node.weight, rest), node.landmark.symbol());
        match partly.iter_mut().find(|(other, _)| *other == key) {
            Some((_, symbols)) => symbols.push(symbol),
            None => partly.push((key, vec![symbol])),
        }
    }
    for ((weight, rest), symbols) in partly.into_iter().filter(|((_, rest), _)| *rest > 0) {
        let (symbols, weight) = (list(symbols), weight.name());
        let rest = count(rest, "quantity", "quantities");
        lines.push(not_asked(format!("{rest} each of {symbols} {weight}")));
    }
    let arches = |without: &dyn Fn(&ArchNode) -> bool| {
        arches_asked.iter().filter(|node| without(node)).count()
    };
    let frictions = arches(&|node| !node.states.is_empty() && !node.frictions());
    if frictions > 0 {
        let names = Quantity::STATE.into_iter().filter(|quantity| quantity.is_friction());
        let (names, arches) = (list(names.map(Quantity::name)), count(frictions, "arch", "arches"));
        lines.push(not_asked(format!("{names} of {arches}")));
    }
    let ranges =
        arches(&|node| node.thicknesses.iter().any(|asked| asked.wanted == Wanted::Standing));
    if ranges > 0 {
        let names = list(RANGE_OF_THRUSTS.map(Quantity::name));
        lines.push(not_asked(format!("{names} of {}", count(ranges, "arch", "arches"))));
    }
    let all = claims().len();
    if (1..all).contains(&claims_asked) {
        lines.push(not_asked(format!("{} of {all} claims", all - claims_asked)));
    }
    for weight in SelfWeight::ALL {
        let asked = |curve: &Curve| {
            let line = MapLine::Curve(*curve);
            curves.iter().any(|node| (node.weight, &node.line) == (weight, &line))
        };
        let rest: Vec<String> =
            Curve::ALL.iter().filter(|c| !asked(c)).map(ToString::to_string).collect();
        // Sliding is the same for both.
        let is_asked = Curve::ALL.iter().any(asked) && rest != [Curve::Sliding.to_string()];
        if is_asked && !rest.is_empty() {
            let names = list(rest.iter().map(String::as_str));
            lines.push(not_asked(format!("curves {names} {}", weight.name())));
        }
    }
    if let Some(costs) = costs {
        let total = costs.total();
        let paper = Equation::ALL.iter().filter(|equation| equation.is_symmetric());
        let unused = paper.filter(|equation| total.tally.of(**equation) == 0);
        let unused = list(unused.map(|equation| equation.label()));
        if !unused.is_empty() {
            lines.push(format!("equations {unused}: nothing needed them"));
        }
    }
    lines
}
