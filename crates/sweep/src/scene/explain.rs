//! A plan as a tree: what each item needs, what that cost, and what was left out and why.

use super::cost::Cost;
use super::expected;
use super::left_out::left_out;
use super::nodes::{ArchNode, LandmarkNode};
use super::plan::Plan;
use super::run::Costs;
use super::schema::Item;
use crate::certify::state::Wanted;
use crate::problem::{Equation, tally::Tally};
use crate::report::words::{count, list};
use cpu_time::ProcessTime;
use std::io;

/// A node of the tree: its lines, and what hangs on it.
struct Branch {
    lines: Vec<String>,
    branches: Vec<Branch>,
}

impl Branch {
    fn new(lines: impl IntoIterator<Item = String>) -> Self {
        Self { lines: lines.into_iter().collect(), branches: Vec::new() }
    }

    fn write(&self, indent: &str, last: bool, out: &mut dyn io::Write) -> io::Result<()> {
        let (fork, beside) = if last { ("└─ ", "   ") } else { ("├─ ", "│  ") };
        for (k, line) in self.lines.iter().enumerate() {
            writeln!(out, "{indent}{}{line}", if k == 0 { fork } else { beside })?;
        }
        write_all(&self.branches, &format!("{indent}{beside}"), out)
    }
}

fn write_all(branches: &[Branch], indent: &str, out: &mut dyn io::Write) -> io::Result<()> {
    let last = branches.len().saturating_sub(1);
    branches.iter().enumerate().try_for_each(|(k, branch)| branch.write(indent, k == last, out))
}

/// More arches of one item than this are shown as a sum.
const SHOWN: usize = 12;

/// Writes the plan; with costs, what was spent.
pub fn explain(plan: &Plan, costs: Option<&Costs>, out: &mut dyn io::Write) -> io::Result<()> {
    let pieces: Vec<String> = [
        (plan.landmarks.len(), "landmark", "landmarks"),
        (plan.arches.len(), "arch", "arches"),
        (plan.claims.len(), "claim", "claims"),
        (plan.curves.len(), "curve", "curves"),
        (plan.drawings.len(), "drawn arch", "drawn arches"),
    ]
    .into_iter()
    .filter(|(n, ..)| *n > 0)
    .map(|(n, one, many)| count(n, one, many))
    .collect();
    let items = count(plan.scene.items.len(), "item", "items");
    match pieces.is_empty() {
        true => writeln!(out, "{items}; nothing to compute")?,
        false => writeln!(out, "{items}; to compute: {}, each once", pieces.join(", "))?,
    }
    let mut branches: Vec<Branch> =
        (0..plan.scene.items.len()).map(|index| item(plan, costs, index)).collect();
    let left_out = left_out(plan, costs);
    if !left_out.is_empty() {
        let mut branch = Branch::new(["left out".to_owned()]);
        branch.branches = left_out.into_iter().map(|line| Branch::new([line])).collect();
        branches.push(branch);
    }
    write_all(&branches, "", out)?;
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
    let mut branch = Branch::new([heading(&plan.scene.items[index])]);
    if plan.complete[index] {
        branch.lines.push("complete: nothing is computed".to_owned());
        return branch;
    }
    let needs = &plan.needs[index];
    for &place in &needs.landmarks {
        let node = &plan.landmarks[place];
        let name = format!("{} {}", node.landmark.symbol(), node.weight.name());
        branch.branches.push(match earlier(&node.items, index) {
            Some(other) => Branch::new([format!("{name}: {}", computed_for(plan, other))]),
            None => {
                let mut lines = vec![name];
                lines.extend(landmark(node));
                lines.extend(costs.and_then(|costs| costs.landmarks[place]).as_ref().map(spent));
                Branch::new(lines)
            }
        });
    }
    branch.branches.extend(arches(plan, costs, index));
    for &place in &needs.claims {
        let node = &plan.claims[place];
        let name = format!("{}, {}", node.claim.id, node.claim.place);
        branch.branches.push(match earlier(&node.items, index) {
            Some(other) => Branch::new([format!("{name}: {}", computed_for(plan, other))]),
            None => {
                let cost = costs.and_then(|costs| costs.claims[place]);
                Branch::new(std::iter::once(name).chain(cost.as_ref().map(spent)))
            }
        });
    }
    branch.branches.extend(curves(plan, costs, index));
    for &place in &needs.drawings {
        let node = &plan.drawings[place];
        let name = node.drawn.to_string();
        branch.branches.push(match earlier(&node.items, index) {
            Some(other) => Branch::new([format!("{name}: {}", computed_for(plan, other))]),
            None => {
                let cost = costs.and_then(|costs| costs.drawings[place]);
                Branch::new(std::iter::once(name).chain(cost.as_ref().map(spent)))
            }
        });
    }
    branch
}

/// The curves that are computed for an item, and those that are for another.
fn curves(plan: &Plan, costs: Option<&Costs>, index: usize) -> Vec<Branch> {
    let places = &plan.needs[index].curves;
    let is_mine = |place: &&usize| earlier(&plan.curves[**place].items, index).is_none();
    let (mine, others): (Vec<&usize>, Vec<&usize>) = places.iter().partition(is_mine);
    let own = |place: &usize| {
        let node = &plan.curves[*place];
        let cost = costs.and_then(|costs| costs.curves[*place]);
        let name = format!("{}, in tubes of {:?}", node.name(), node.tolerance);
        Branch::new(std::iter::once(name).chain(cost.as_ref().map(spent)))
    };
    let others = others.into_iter().filter_map(|place| earlier(&plan.curves[*place].items, index));
    mine.into_iter().map(own).chain(from_others(plan, others, "curve", "curves")).collect()
}

/// What is computed for other items, counted by item.
fn from_others(
    plan: &Plan,
    others: impl Iterator<Item = usize>,
    one: &str,
    many: &str,
) -> Vec<Branch> {
    let mut from: Vec<(usize, usize)> = Vec::new();
    for other in others {
        match from.iter_mut().find(|(item, _)| *item == other) {
            Some((_, pieces)) => *pieces += 1,
            None => from.push((other, 1)),
        }
    }
    let branch = |(other, pieces): (usize, usize)| {
        Branch::new([format!("{}: {}", count(pieces, one, many), computed_for(plan, other))])
    };
    from.into_iter().map(branch).collect()
}

fn heading(item: &Item) -> String {
    let output = match &item.output {
        Some(output) => output.display().to_string(),
        None => "standard output".to_owned(),
    };
    let (kind, format) = (item.what.kind().name(), item.format.name);
    format!("{kind} in line {} -> {output} ({format})", item.place.line)
}

/// The item before this one for which a piece is computed.
fn earlier(items: &[usize], index: usize) -> Option<usize> {
    items.first().copied().filter(|first| *first != index)
}

fn computed_for(plan: &Plan, item: usize) -> String {
    format!("computed for the item in line {}", plan.scene.items[item].place.line)
}

fn landmark(node: &LandmarkNode) -> Vec<String> {
    let system = node.landmark.system(node.weight);
    let equations = list(system.equations.iter().map(|equation| equation.label()));
    let mut lines = vec![format!("from {equations}")];
    let mut digits: Vec<usize> = node.asked.iter().map(|(_, digits)| *digits).collect();
    digits.sort_unstable();
    digits.dedup();
    for digits in digits {
        let asked = node.asked.iter().filter(|(_, of)| *of == digits);
        let names = list(asked.map(|(quantity, _)| quantity.name()));
        lines.push(format!("to {digits} digits: {names}"));
    }
    if !node.certificates.is_empty() {
        let digits: Vec<String> = node.certificates.iter().map(ToString::to_string).collect();
        lines.push(format!("the hash of its certificate, to {} digits", digits.join(", ")));
    }
    if node.audited {
        lines.push("for the printed numbers".to_owned());
    }
    lines
}

/// The arches that are computed for an item, the first of them one by one.
fn arches(plan: &Plan, costs: Option<&Costs>, index: usize) -> Vec<Branch> {
    let mut places: Vec<usize> = plan.needs[index].arches.iter().map(|(place, _)| *place).collect();
    places.sort_unstable();
    places.dedup();
    let (mine, others): (Vec<usize>, Vec<usize>) =
        places.into_iter().partition(|&place| earlier(&plan.arches[place].items, index).is_none());
    let cost = |place: usize| costs.and_then(|costs| costs.arches[place]);
    let mut branches: Vec<Branch> = Vec::new();
    // One more is shown by itself rather than as "1 more".
    let shown = if mine.len() <= SHOWN + 1 { mine.len() } else { SHOWN };
    for &place in &mine[..shown] {
        let lines = arch(&plan.arches[place]).into_iter();
        branches.push(Branch::new(lines.chain(cost(place).as_ref().map(spent_on_arch))));
    }
    if shown < mine.len() {
        let costs: Option<Vec<Cost>> = mine[shown..].iter().map(|&place| cost(place)).collect();
        let sum = costs.map(|costs| spent(&costs.iter().sum()));
        let words = format!("{} more", mine.len() - shown);
        branches.push(Branch::new(std::iter::once(words).chain(sum)));
    }
    let others = others.into_iter().filter_map(|place| earlier(&plan.arches[place].items, index));
    branches.extend(from_others(plan, others, "arch", "arches"));
    branches
}

fn arch(node: &ArchNode) -> Vec<String> {
    let (alpha, mu) = (node.arch.half_opening(), node.arch.friction());
    let mut lines = vec![
        format!("half opening {alpha}, friction {mu}, {}", node.arch.weight().name()),
        expected::in_words(node.arch),
    ];
    lines.extend(node.states.iter().map(|(digits, frictions)| {
        let with = if *frictions { " and the frictions at which its mode changes" } else { "" };
        format!("to {digits} digits: its state{with}")
    }));
    lines.extend(node.thicknesses.iter().map(|asked| {
        let what = match asked.wanted {
            Wanted::Standing => "whether it stands",
            Wanted::Everything => "whether it stands, and the range of thrusts",
        };
        format!("to {} digits, thickness {}: {what}", asked.digits, asked.thickness)
    }));
    lines
}

/// The cost of an arch in words. Where nothing was evaluated, one that was proved before says it all.
fn spent_on_arch(cost: &Cost) -> String {
    match cost.tally == Tally::default() {
        true => "as proved for another friction of its half opening".to_owned(),
        false => spent(cost),
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
