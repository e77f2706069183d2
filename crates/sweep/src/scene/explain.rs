//! A plan as a tree: what each item needs, what that cost, and what was left out and why.

use super::arch_node::ArchNode;
use super::cost::Cost;
use super::landmark_node::LandmarkNode;
use super::plan::{Plan, PlannedPart, Work};
use super::run::Costs;
use super::scene_map::{CurveNode, MapLine};
use super::schema::{Request, SceneItem};
use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::certify::quantities;
use crate::certify::state::Wanted;
use crate::claims::claims;
use crate::problem::{Equation, Landmark, Quantity, tally::Tally};
use crate::report::words::{count, list};
use cpu_time::ProcessTime;
use std::io;

/// A branch of the tree: its lines, and those of each branch of its own.
type Branch = (Vec<String>, Vec<Vec<String>>);

/// Writes the lines of a branch, and answers what stands before those of its own branches.
fn write_lines(
    lines: &[String],
    (indent, is_last): (&str, bool),
    out: &mut dyn io::Write,
) -> io::Result<String> {
    let (fork, beside) = if is_last { ("└─ ", "   ") } else { ("├─ ", "│  ") };
    for (k, line) in lines.iter().enumerate() {
        writeln!(out, "{indent}{}{line}", if k == 0 { fork } else { beside })?;
    }
    Ok(format!("{indent}{beside}"))
}

/// More arches of one item than this are shown as a sum.
const SHOWN: usize = 12;

/// Writes the plan; with costs, what was spent.
pub fn explain(plan: &Plan, costs: Option<&Costs>, out: &mut dyn io::Write) -> io::Result<()> {
    let pieces = Work::KINDS.into_iter().filter_map(|kind @ (one, many)| {
        let n = plan.parts.iter().filter(|part| part.work.kind() == kind).count();
        (n > 0).then(|| count(n, one, many))
    });
    let pieces: Vec<String> = pieces.collect();
    let items = count(plan.scene.items.len(), "item", "items");
    match pieces.is_empty() {
        true => writeln!(out, "{items}; nothing to compute")?,
        false => writeln!(out, "{items}; to compute: {}, each once", pieces.join(", "))?,
    }
    let mut branches: Vec<Branch> =
        (0..plan.scene.items.len()).map(|index| item(plan, costs, index)).collect();
    let left_out = left_out(plan, costs);
    if !left_out.is_empty() {
        let left_out = left_out.into_iter().map(|line| vec![line]).collect();
        branches.push((vec!["left out".to_owned()], left_out));
    }
    for (k, (lines, parts)) in branches.iter().enumerate() {
        let indent = write_lines(lines, ("", k + 1 == branches.len()), out)?;
        for (k, part) in parts.iter().enumerate() {
            write_lines(part, (&indent, k + 1 == parts.len()), out)?;
        }
    }
    if let Some(costs) = costs {
        // Threads that proofs share are seen here alone.
        let all = ProcessTime::try_now().map(|time| time.as_duration());
        let total = costs.total();
        let total = Cost { time: all.unwrap_or(total.time), ..total };
        writeln!(out, "in all, processor time of the program: {}", spent(&total))?;
    }
    Ok(())
}

fn item(plan: &Plan, costs: Option<&Costs>, index: usize) -> Branch {
    let heading = heading(&plan.scene.items[index]);
    if plan.complete[index] {
        return (vec![heading, "complete: nothing is computed".to_owned()], Vec::new());
    }
    let mut branches = Vec::new();
    let mut places = plan.needs[index].clone();
    let cost = |place: usize| costs.and_then(|costs| costs.0[place]);
    let mut shown = usize::MAX;
    if matches!(plan.scene.items[index].what, Request::Arches { .. } | Request::Surveys { .. }) {
        places.sort_unstable();
        places.dedup();
        let mine = places.iter().filter(|place| plan.parts[**place].first == index).count();
        // One more is shown by itself rather than as "1 more".
        shown = if mine <= SHOWN + 1 { mine } else { SHOWN };
    }
    let (mut more, mut others) = (Vec::new(), Vec::<(usize, usize, _)>::new());
    for place in places {
        let PlannedPart { work, first, .. } = &plan.parts[place];
        match work {
            _ if *first == index && branches.len() == shown => more.push(cost(place)),
            _ if *first == index => {
                let spent = cost(place).map(|cost| spent_on(work, &cost));
                branches.push(work.of().lines().into_iter().chain(spent).collect());
            }
            Work::Arch(_) | Work::Curve(_) | Work::Survey(_) => {
                match others.iter_mut().find(|(item, ..)| item == first) {
                    Some((_, parts, _)) => *parts += 1,
                    None => others.push((*first, 1, work.kind())),
                }
            }
            _ => {
                let line = format!("{}: {}", work.of().lines()[0], computed_for(plan, *first));
                branches.push(vec![line]);
            }
        }
    }
    if !more.is_empty() {
        let mut lines = vec![format!("{} more", more.len())];
        let costs: Option<Vec<Cost>> = more.into_iter().collect();
        lines.extend(costs.map(|costs| spent(&costs.iter().sum())));
        branches.push(lines);
    }
    branches.extend(others.into_iter().map(|(other, parts, (one, many))| {
        vec![format!("{}: {}", count(parts, one, many), computed_for(plan, other))]
    }));
    (vec![heading], branches)
}

fn heading(item: &SceneItem) -> String {
    let output = item.output.as_ref().map(|output| output.display().to_string());
    let output = output.unwrap_or_else(|| "standard output".to_owned());
    let (kind, format) = (item.kind.name(), item.format.name);
    format!("{kind} in line {} -> {output} ({format})", item.place.line)
}

fn computed_for(plan: &Plan, item: usize) -> String {
    format!("computed for the item in line {}", plan.scene.items[item].place.line)
}

/// The cost of a part in words. Where nothing of an arch was evaluated, one that was proved before says it all.
fn spent_on(work: &Work, cost: &Cost) -> String {
    match work {
        Work::Arch(_) if cost.tally == Tally::default() => {
            "as proved for another friction of its half opening".to_owned()
        }
        _ => spent(cost),
    }
}

/// A cost in words.
fn spent(cost: &Cost) -> String {
    let tally = &cost.tally;
    let mut words = vec![format!("{:.1} ms", 1000.0 * cost.time.as_secs_f64())];
    for (n, one, many) in [
        (u64::from(tally.working_bits), "bit", "bits"),
        (tally.conditions, "condition", "conditions"),
        (tally.landmarks, "comparison with l and L", "comparisons with l and L"),
        (tally.newton_steps, "Newton step", "Newton steps"),
        (tally.evaluations(), "evaluation", "evaluations"),
    ] {
        if n > 0 {
            words.push(count(n, one, many));
        }
    }
    let each: Vec<String> = Equation::ALL
        .iter()
        .map(|equation| (equation.label(), tally.of(*equation)))
        .filter(|(_, count)| *count > 0)
        .map(|(label, count)| format!("{label} {count}"))
        .collect();
    match each.is_empty() {
        true => words.join(", "),
        false => format!("{}: {}", words.join(", "), each.join(", ")),
    }
}

/// Statements of what is not computed, and why.
fn left_out(plan: &Plan, costs: Option<&Costs>) -> Vec<String> {
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
