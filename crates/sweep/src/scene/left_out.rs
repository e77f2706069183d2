//! Parts of the work that a plan leaves out, and why.

use super::arch_node::ArchNode;
use super::curve_node::CurveNode;
use super::landmark_node::LandmarkNode;
use super::plan::Plan;
use super::run::Costs;
use super::scene_map::MapLine;
use super::work::Work;
use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::certify::quantities;
use crate::certify::state::Wanted;
use crate::claims::claims;
use crate::problem::{Equation, Landmark, Quantity};
use crate::report::words::{count, list};

/// Statements of what is not computed, and why.
pub(super) fn left_out(plan: &Plan, costs: Option<&Costs>) -> Vec<String> {
    let (mut landmarks, mut arches, mut curves, mut claims) =
        <(Vec<_>, Vec<_>, Vec<_>, usize)>::default();
    for part in &plan.parts {
        match &part.work {
            Work::Landmark(node) => landmarks.push(node),
            Work::Arch(node) => arches.push(node),
            Work::Curve(node) => curves.push(node),
            Work::Claim(_) => claims += 1,
            Work::Drawing(_) | Work::Survey(_) => {}
        }
    }
    let all = self::claims().len();
    let claims = (1..all).contains(&claims).then(|| format!("{} of {all} claims", all - claims));
    let lines = of_landmarks(&landmarks).into_iter().chain(of_arches(&arches)).chain(claims);
    let lines = lines.chain(of_curves(&curves)).map(|what| format!("{what}: not asked for"));
    lines.chain(costs.and_then(unused)).collect()
}

fn of_landmarks(nodes: &[&LandmarkNode]) -> Vec<String> {
    let mut lines = Vec::new();
    for weight in SelfWeight::ALL {
        let is_asked =
            |of: &Landmark| nodes.iter().any(|node| (node.landmark, node.weight) == (*of, weight));
        let rest = Landmark::ALL.into_iter().filter(|of| !is_asked(of)).map(Landmark::symbol);
        let rest = list(rest);
        if !rest.is_empty() && !nodes.is_empty() {
            lines.push(format!("landmarks {rest} {}", weight.name()));
        }
    }
    let mut partly: Vec<((SelfWeight, usize), Vec<&str>)> = Vec::new();
    for node in nodes.iter().filter(|node| !node.asked.is_empty()) {
        let is_asked = |quantity: &Quantity| node.asked.iter().any(|(of, _)| of == quantity);
        let rest = quantities(node.landmark).filter(|quantity| !is_asked(quantity)).count();
        let (key, symbol) = ((node.weight, rest), node.landmark.symbol());
        match partly.iter_mut().find(|(other, _)| *other == key) {
            Some((_, symbols)) => symbols.push(symbol),
            None => partly.push((key, vec![symbol])),
        }
    }
    for ((weight, rest), symbols) in partly.into_iter().filter(|((_, rest), _)| *rest > 0) {
        let rest = count(rest, "quantity", "quantities");
        lines.push(format!("{rest} each of {} {}", list(symbols), weight.name()));
    }
    lines
}

fn of_arches(nodes: &[&ArchNode]) -> Vec<String> {
    let frictions = Quantity::STATE.into_iter().filter(|quantity| quantity.is_friction()).collect();
    let without = |quantities: Vec<Quantity>, is_without: &dyn Fn(&ArchNode) -> bool| {
        let arches = nodes.iter().filter(|node| is_without(node)).count();
        let (names, of) =
            (list(quantities.into_iter().map(Quantity::name)), count(arches, "arch", "arches"));
        (arches > 0).then(|| format!("{names} of {of}"))
    };
    let frictions = without(frictions, &|node| !node.states.is_empty() && !node.frictions());
    let ranges = without(Wanted::BY_THRUSTS.to_vec(), &|node| {
        node.thicknesses.values().any(|(_, wanted)| *wanted == Wanted::Standing)
    });
    frictions.into_iter().chain(ranges).collect()
}

fn of_curves(nodes: &[&CurveNode]) -> Vec<String> {
    let of_weight = |weight: SelfWeight| {
        let is_asked = |curve: &&Curve| {
            let line = MapLine::Curve(**curve);
            nodes.iter().any(|node| (node.weight, &node.line) == (weight, &line))
        };
        let rest = Curve::ALL.iter().filter(|curve| !is_asked(curve)).map(Curve::to_string);
        let rest = rest.collect::<Vec<_>>().join(", ");
        // Sliding is the same for both.
        let is_part =
            Curve::ALL.iter().any(|curve| is_asked(&curve)) && rest != Curve::Sliding.to_string();
        (is_part && !rest.is_empty()).then(|| format!("curves {rest} {}", weight.name()))
    };
    SelfWeight::ALL.into_iter().filter_map(of_weight).collect()
}

/// Equations of the paper that nothing needed, if there are any.
fn unused(costs: &Costs) -> Option<String> {
    let total = costs.total();
    let paper = Equation::ALL.iter().filter(|equation| equation.is_symmetric());
    let unused = paper.filter(|equation| total.tally.of(**equation) == 0);
    let unused = list(unused.map(|equation| equation.label()));
    (!unused.is_empty()).then(|| format!("equations {unused}: nothing needed them"))
}
