//! Does what a plan says: one item after the other, the pieces of an item on all cores.

use super::cost::{Cost, measured};
use super::format::OutputFormat;
use super::plan::{ArchNode, LandmarkNode, Needs, Plan};
use super::schema::What;
use crate::arch::{Quantity, System};
use crate::certify::state::{Answer, AssessmentDigits, Doubt, Inquiry};
use crate::certify::{
    CertifiedLandmark, Constant, Enclosed, Undecided, audit_of, compare_weights_of, enclosed,
};
use crate::claims::Decision;
use crate::report::{
    ArchEntries, Arches, AssessReport, Audit, Claims, Constants, LandmarkReport, Proved, StateOf,
    StateReport,
};
use std::collections::BTreeMap;
use std::io;

/// A plan that is being carried out.
pub struct Run<'p> {
    plan: &'p Plan<'p>,
    landmarks: Vec<Option<Result<LandmarkFound, Undecided>>>,
    arches: Vec<Option<ArchFound>>,
    claims: Vec<Option<Decision>>,
    costs: Costs,
}

/// What each piece of a plan cost, in the order of the plan; nothing for what was not needed yet.
#[derive(Clone, Debug, Default)]
pub struct Costs {
    /// Landmarks.
    pub landmarks: Vec<Option<Cost>>,
    /// Arches.
    pub arches: Vec<Option<Cost>>,
    /// Claims.
    pub claims: Vec<Option<Cost>>,
}

impl Costs {
    /// All of it.
    pub fn total(&self) -> Cost {
        self.landmarks.iter().chain(&self.arches).chain(&self.claims).flatten().sum()
    }
}

/// What was found of a landmark.
struct LandmarkFound {
    system: System,
    relative_radii: Vec<f64>,
    /// In the order in which they are asked for.
    constants: Vec<Constant>,
    enclosed: Option<Enclosed>,
}

/// What was found of an arch.
struct ArchFound {
    /// By the number of digits.
    states: BTreeMap<usize, Result<Answer, Doubt>>,
    /// In the order in which they are asked for.
    thicknesses: Vec<Result<AssessmentDigits, Doubt>>,
}

/// What an item asked for.
pub struct Found<'r> {
    format: OutputFormat,
    /// Nothing where not even a part is known.
    report: Option<Report<'r>>,
    /// What could not be decided.
    pub undecided: Vec<String>,
}

enum Report<'r> {
    Constants(Constants),
    Arches(Arches<'r>),
    Claims(Claims),
    Audit(Audit),
}

impl Found<'_> {
    /// Writes what was found.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        match (&self.report, self.format) {
            (Some(Report::Constants(report)), OutputFormat::Report(format)) => {
                report.write(format, out)
            }
            (Some(Report::Arches(report)), OutputFormat::Report(format)) => {
                report.write(format, out)
            }
            (Some(Report::Audit(report)), OutputFormat::Report(format)) => {
                report.write(format, out)
            }
            (Some(Report::Claims(report)), OutputFormat::Claims(format)) => {
                report.write(format, out)
            }
            // A format is chosen among those of the kind; without a report there is nothing to write.
            _ => Ok(()),
        }
    }

    /// Whether there is anything to write.
    pub fn is_known(&self) -> bool {
        self.report.is_some()
    }
}

/// A result for each piece, none of them there yet.
fn none<T, U>(pieces: &[T]) -> Vec<Option<U>> {
    pieces.iter().map(|_| None).collect()
}

impl<'p> Run<'p> {
    /// Nothing is computed yet.
    pub fn new(plan: &'p Plan<'p>) -> Self {
        let costs = Costs {
            landmarks: none(&plan.landmarks),
            arches: none(&plan.arches),
            claims: none(&plan.claims),
        };
        Self {
            plan,
            landmarks: none(&plan.landmarks),
            arches: none(&plan.arches),
            claims: none(&plan.claims),
            costs,
        }
    }

    /// What the pieces cost so far.
    pub fn costs(&self) -> &Costs {
        &self.costs
    }

    /// Computes what an item needs and no item before it has needed. The items are asked for in their
    /// order; what none of those to come needs is forgotten. `tick` is called [`Plan::ticks`] times in
    /// all.
    pub fn item(&mut self, index: usize, tick: &(dyn Fn() + Sync)) -> Found<'_> {
        for (node, found) in self.plan.arches.iter().zip(&mut self.arches) {
            if node.items.last().is_some_and(|last| *last < index) {
                *found = None;
            }
        }
        let plan = self.plan;
        let needs = &plan.needs[index];
        fill(&needs.landmarks, &mut self.landmarks, &mut self.costs.landmarks, |place| {
            landmark(&plan.landmarks[place], tick)
        });
        let arches: Vec<usize> = needs.arches.iter().map(|(place, _)| *place).collect();
        fill(&arches, &mut self.arches, &mut self.costs.arches, |place| {
            let found = arch(&plan.arches[place]);
            tick();
            found
        });
        fill(&needs.claims, &mut self.claims, &mut self.costs.claims, |place| {
            let decision = plan.claims[place].claim.decide();
            tick();
            decision
        });
        self.found(index, needs)
    }

    fn found(&self, index: usize, needs: &Needs) -> Found<'_> {
        let item = &self.plan.scene.items[index];
        let (report, undecided) = match &item.what {
            What::Constants { quantities, digits, .. } => {
                self.constants(needs, quantities, *digits)
            }
            What::Arches { quantities, with_thickness, digits, .. } => {
                self.arches(index, needs, (quantities, *digits), *with_thickness)
            }
            What::Claims { show, .. } => self.claims(needs, *show),
            What::Audit { .. } => self.audit(needs),
        };
        Found { format: item.format, report, undecided }
    }

    fn constants(
        &self,
        needs: &Needs,
        quantities: &[Quantity],
        digits: usize,
    ) -> (Option<Report<'_>>, Vec<String>) {
        let landmarks: Vec<LandmarkReport> = needs
            .landmarks
            .iter()
            .filter_map(|&place| {
                let node = &self.plan.landmarks[place];
                let proved = |found: &LandmarkFound| Proved {
                    system: found.system,
                    relative_radii: found.relative_radii.clone(),
                    constants: taken(node, found, quantities, digits),
                };
                let outcome = self.landmarks[place].as_ref()?.as_ref().map(proved);
                let outcome = outcome.map_err(ToString::to_string);
                Some(LandmarkReport { landmark: node.landmark, weight: node.weight, outcome })
            })
            .collect();
        let undecided = landmarks
            .iter()
            .filter(|entry| entry.outcome.is_err())
            .map(|entry| format!("{} {}", entry.landmark.symbol(), entry.weight.name()))
            .collect();
        (Some(Report::Constants(Constants { digits, landmarks })), undecided)
    }

    fn arches(
        &self,
        index: usize,
        needs: &Needs,
        (quantities, digits): (&[&'static str], usize),
        with_thickness: bool,
    ) -> (Option<Report<'_>>, Vec<String>) {
        let What::Arches { arches, .. } = &self.plan.scene.items[index].what else {
            return (None, Vec::new());
        };
        // With this many digits a decimal number tells the double.
        let doubles = digits == 17;
        let taken = || {
            arches.iter().zip(&needs.arches).filter_map(|(asked, (place, thickness))| {
                Some((asked, self.arches[*place].as_ref()?, *thickness))
            })
        };
        let entries = if with_thickness {
            ArchEntries::Assessments(
                taken()
                    .filter_map(|(asked, found, place)| {
                        Some(AssessReport {
                            weight: asked.arch.weight(),
                            half_opening: asked.arch.half_opening().to_string(),
                            friction: asked.friction.clone(),
                            thickness: asked.thickness.as_ref()?.to_string(),
                            doubles,
                            outcome: &found.thicknesses[place?],
                        })
                    })
                    .collect(),
            )
        } else {
            ArchEntries::States(
                taken()
                    .filter_map(|(asked, found, _)| {
                        Some(StateReport {
                            weight: asked.arch.weight(),
                            half_opening: asked.arch.half_opening().to_string(),
                            friction: asked.friction.clone(),
                            doubles,
                            outcome: match found.states.get(&digits)? {
                                Ok(Answer::Stands(state)) => StateOf::Stands(state),
                                Ok(Answer::Falls(fall)) => StateOf::Falls(*fall),
                                Err(doubt) => StateOf::Undecided(doubt),
                            },
                        })
                    })
                    .collect(),
            )
        };
        let (all, open) = match &entries {
            ArchEntries::States(states) => {
                let open = |state: &&StateReport| matches!(state.outcome, StateOf::Undecided(_));
                (states.len(), states.iter().filter(open).count())
            }
            ArchEntries::Assessments(all) => {
                (all.len(), all.iter().filter(|one| one.outcome.is_err()).count())
            }
        };
        let undecided = (open > 0).then(|| format!("{open} of {all} arches")).into_iter().collect();
        (
            Some(Report::Arches(Arches { digits, quantities: quantities.to_vec(), entries })),
            undecided,
        )
    }

    fn claims(&self, needs: &Needs, show: bool) -> (Option<Report<'_>>, Vec<String>) {
        let decisions: Vec<Decision> =
            needs.claims.iter().filter_map(|&place| self.claims[place].clone()).collect();
        let open = decisions.iter().filter(|decision| decision.outcome.is_err());
        let undecided = open.map(|decision| decision.claim.id.to_owned()).collect();
        (Some(Report::Claims(Claims { decisions, show, timed: false })), undecided)
    }

    fn audit(&self, needs: &Needs) -> (Option<Report<'_>>, Vec<String>) {
        let points: Result<Vec<Enclosed>, Undecided> = needs
            .landmarks
            .iter()
            .filter_map(|&place| self.landmarks[place].as_ref())
            .filter_map(|found| found.as_ref().map(|found| found.enclosed.clone()).transpose())
            .map(|found| found.map_err(Clone::clone))
            .collect();
        let audit = points.and_then(|points| {
            Ok(Audit { printed: audit_of(&points)?, comparisons: compare_weights_of(&points)? })
        });
        match audit {
            Ok(audit) => (Some(Report::Audit(audit)), Vec::new()),
            Err(undecided) => (None, vec![undecided.to_string()]),
        }
    }
}

/// Computes what is not there yet of some places.
fn fill<T: Send>(
    places: &[usize],
    found: &mut [Option<T>],
    costs: &mut [Option<Cost>],
    compute: impl Fn(usize) -> T + Sync,
) {
    let mut missing: Vec<usize> =
        places.iter().copied().filter(|place| found[*place].is_none()).collect();
    missing.sort_unstable();
    missing.dedup();
    let results = measured(&missing, |place| compute(*place));
    for (place, (result, cost)) in missing.into_iter().zip(results) {
        found[place] = Some(result);
        costs[place] = Some(cost);
    }
}

fn landmark(node: &LandmarkNode, tick: &(dyn Fn() + Sync)) -> Result<LandmarkFound, Undecided> {
    let point = CertifiedLandmark::new(node.landmark, node.weight)?;
    let constants = match node.asked.as_slice() {
        [] => Vec::new(),
        asked => point.constants_of(asked, tick)?,
    };
    let isolated = point.isolated();
    let (system, relative_radii) = (*isolated.system(), isolated.relative_radii());
    let enclosed = if node.audited { Some(enclosed(point)?) } else { None };
    Ok(LandmarkFound { system, relative_radii, constants, enclosed })
}

fn arch(node: &ArchNode) -> ArchFound {
    let mut inquiry = Inquiry::new(node.arch, node.digits(), node.frictions());
    let states = node.states.iter();
    ArchFound {
        states: states
            .map(|(&digits, &frictions)| (digits, inquiry.state(digits, frictions)))
            .collect(),
        thicknesses: node
            .thicknesses
            .iter()
            .map(|asked| inquiry.assess(&asked.thickness, asked.digits, asked.wanted))
            .collect(),
    }
}

/// The constants of a landmark that one item asks for.
fn taken(
    node: &LandmarkNode,
    found: &LandmarkFound,
    quantities: &[Quantity],
    digits: usize,
) -> Vec<Constant> {
    let all = node.asked.iter().zip(&found.constants);
    let mine = all.filter(|((quantity, of), _)| quantities.contains(quantity) && *of == digits);
    let mut mine: Vec<Constant> = mine.map(|(_, constant)| constant.clone()).collect();
    // In the order in which they are always shown, whoever asked first.
    let place = |constant: &Constant| Quantity::ALL.iter().position(|q| *q == constant.quantity);
    mine.sort_by_key(place);
    mine
}
