//! What an item asked for, as a report.

use super::format::OutputFormat;
use super::pieces::ArchFound;
use super::plan::Needs;
use super::run::Run;
use super::schema::{AskedArch, What};
use crate::certify::Undecided;
use crate::certify::state::Answer;
use crate::claims::Decision;
use crate::judge::{Enclosed, audit_of, compare_weights_of};
use crate::problem::Quantity;
use crate::report::{
    ArchEntries, Arches, AssessReport, Audit, Claims, Constants, LandmarkReport, StateOf,
    StateReport,
};
use std::io;

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
        use OutputFormat as F;
        match (&self.report, self.format) {
            (Some(Report::Constants(report)), F::Constants(format)) => report.write(format, out),
            (Some(Report::Arches(report)), F::Report(format)) => report.write(format, out),
            (Some(Report::Audit(report)), F::Report(format)) => report.write(format, out),
            (Some(Report::Claims(report)), F::Claims(format)) => report.write(format, out),
            // A format is one of those of its kind; without a report there is nothing to write.
            _ => Ok(()),
        }
    }

    /// Whether there is anything to write.
    pub fn is_known(&self) -> bool {
        self.report.is_some()
    }
}

/// A report, and what in it could not be decided.
type Told<'r> = (Option<Report<'r>>, Vec<String>);

/// With this many digits a decimal number tells the double, which is given too.
const DOUBLE: usize = 17;

impl Run<'_> {
    /// What an item asked for, from pieces that are all there.
    pub(super) fn found(&self, index: usize) -> Found<'_> {
        let (item, needs) = (&self.plan.scene.items[index], &self.plan.needs[index]);
        let (report, undecided) = match &item.what {
            What::Constants { quantities, digits, .. } => {
                self.constants(item.format, needs, (quantities, *digits))
            }
            What::Arches { arches, quantities, with_thickness, digits } => {
                let taken = || {
                    arches.iter().zip(&needs.arches).filter_map(|(asked, (place, thickness))| {
                        Some((asked, self.arches[*place].as_ref()?, *thickness))
                    })
                };
                let entries = match with_thickness {
                    true => ArchEntries::Assessments(
                        taken().filter_map(|taken| assessment(taken, *digits)).collect(),
                    ),
                    false => ArchEntries::States(
                        taken()
                            .filter_map(|(asked, found, _)| state(asked, found, *digits))
                            .collect(),
                    ),
                };
                let undecided = open(&entries).into_iter().collect();
                let report = Arches { digits: *digits, quantities: quantities.clone(), entries };
                (Some(Report::Arches(report)), undecided)
            }
            What::Claims { show, .. } => self.claims(needs, *show),
            What::Audit { .. } => self.audit(needs),
        };
        Found { format: item.format, report, undecided }
    }

    fn constants(
        &self,
        format: OutputFormat,
        needs: &Needs,
        (quantities, digits): (&[Quantity], usize),
    ) -> Told<'_> {
        let entry = |&place: &usize| {
            let node = &self.plan.landmarks[place];
            let found = self.landmarks[place].as_ref()?.as_ref();
            let fingerprint = match found {
                Ok(found) if format.has_certificates() => found.certificates.get(&digits).cloned(),
                _ => None,
            };
            let outcome = found
                .map(|found| found.proved(node, quantities, digits))
                .map_err(ToString::to_string);
            let (landmark, weight) = (node.landmark, node.weight);
            Some(LandmarkReport { landmark, weight, outcome, fingerprint })
        };
        let landmarks: Vec<LandmarkReport> = needs.landmarks.iter().filter_map(entry).collect();
        let undecided = landmarks
            .iter()
            .filter(|entry| entry.outcome.is_err())
            .map(|entry| format!("{} {}", entry.landmark.symbol(), entry.weight.name()))
            .collect();
        (Some(Report::Constants(Constants { digits, landmarks })), undecided)
    }

    fn claims(&self, needs: &Needs, show: bool) -> Told<'_> {
        let decisions: Vec<Decision> =
            needs.claims.iter().filter_map(|&place| self.claims[place].clone()).collect();
        let open = decisions.iter().filter(|decision| decision.outcome.is_err());
        let undecided = open.map(|decision| decision.claim.id.to_owned()).collect();
        // How long a claim took would be another output in every run.
        (Some(Report::Claims(Claims { decisions, show, timed: false })), undecided)
    }

    fn audit(&self, needs: &Needs) -> Told<'_> {
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

fn state<'r>(asked: &AskedArch, found: &'r ArchFound, digits: usize) -> Option<StateReport<'r>> {
    Some(StateReport {
        weight: asked.arch.weight(),
        half_opening: asked.arch.half_opening().to_string(),
        friction: asked.friction.clone(),
        doubles: digits == DOUBLE,
        outcome: match found.states.get(&digits)? {
            Ok(Answer::Stands(state)) => StateOf::Stands(state),
            Ok(Answer::Falls(fall)) => StateOf::Falls(*fall),
            Err(doubt) => StateOf::Undecided(doubt),
        },
    })
}

fn assessment<'r>(
    (asked, found, place): (&AskedArch, &'r ArchFound, Option<usize>),
    digits: usize,
) -> Option<AssessReport<'r>> {
    Some(AssessReport {
        weight: asked.arch.weight(),
        half_opening: asked.arch.half_opening().to_string(),
        friction: asked.friction.clone(),
        thickness: asked.thickness.as_ref()?.to_string(),
        doubles: digits == DOUBLE,
        outcome: &found.thicknesses[place?],
    })
}

/// How many of the arches are undecided, if any.
fn open(entries: &ArchEntries) -> Option<String> {
    let (open, all) = match entries {
        ArchEntries::States(states) => {
            let open = |state: &&StateReport| matches!(state.outcome, StateOf::Undecided(_));
            (states.iter().filter(open).count(), states.len())
        }
        ArchEntries::Assessments(all) => {
            (all.iter().filter(|one| one.outcome.is_err()).count(), all.len())
        }
    };
    (open > 0).then(|| format!("{open} of {all} arches"))
}
