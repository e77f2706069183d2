//! The report of an item.

use super::nodes::Work;
use super::pieces::{CurvePiece, WorkDone};
use super::plan::{PAGE_DIGITS, Plan};
use super::schema::{MeasuredArch, Request, SceneArch, SceneBoxes, SceneDrawing, SceneMap};
use crate::arch::SelfWeight;
use crate::certify::state::{measured_assessment, measured_state};
use crate::certify::{Enclosed, Error};
use crate::judge::{audit_of, compare_weights_of};
use crate::picture::Print;
use crate::problem::Quantity;
use crate::report::{
    Answer, Answers, Audit, Claims, Drawing, Format, Map, Reported, Sketched, SurveyedArches,
    SurveyedCell, SurveyedCells, Understood,
};
use rayon::prelude::*;
use std::io;
use std::sync::Arc;

/// Answer to an item.
pub struct ItemReport {
    format: &'static Format,
    print: Print,
    /// Report, or nothing where not even a part is known.
    report: Option<Box<dyn Reported>>,
    /// Questions that could not be decided.
    pub undecided: Vec<String>,
}

impl ItemReport {
    /// The report of an item, from parts that are all there.
    pub(super) fn new(plan: &Plan, done: &[Option<WorkDone>], index: usize) -> Self {
        let item = &plan.scene.items[index];
        let parts = ItemParts { plan, done, index };
        let (report, undecided): (Option<Box<dyn Reported>>, Vec<String>) = match &item.what {
            Request::Constants { quantities, digits, .. } => {
                let list = parts.constants(quantities, *digits);
                let undecided = undecided_landmarks(&list);
                (Some(Box::new(Answers::constants(*digits, list))), undecided)
            }
            Request::Arches { arches, quantities, digits, with_thickness } => {
                let list = parts.arches(arches, *digits);
                let (open, all) =
                    (list.iter().filter(|answer| answer.is_undecided()).count(), list.len());
                let undecided = (open > 0).then(|| format!("{open} of {all} arches"));
                let answers = Answers::arches(*digits, *with_thickness);
                let answers = Answers { quantities: quantities.clone(), list, ..answers };
                (Some(Box::new(answers)), undecided.into_iter().collect())
            }
            Request::Surveys { boxes: None, .. } => parts.surveys(),
            Request::Surveys { boxes: Some(boxes), .. } => parts.boxes(boxes),
            Request::Claims { show, .. } => {
                let decision = |done: &WorkDone| match done {
                    WorkDone::Claim(decision) => Some(decision.clone()),
                    _ => None,
                };
                let decisions: Vec<_> = parts.done().filter_map(decision).collect();
                let open = decisions.iter().filter(|decision| decision.outcome.is_err());
                let undecided = open.map(|decision| decision.claim.id.to_owned()).collect();
                // How long a claim took would be another output in every run.
                let claims = Claims { decisions, show: *show, timed: false };
                (Some(Box::new(claims)), undecided)
            }
            Request::Map(asked) | Request::Figure(asked) => parts.map(asked, item.format),
            Request::Drawing(asked) => parts.drawing(asked),
            Request::Audit { .. } => match parts.audit() {
                Ok(audit) => (Some(Box::new(audit)), Vec::new()),
                Err(undecided) => (None, vec![undecided.to_string()]),
            },
        };
        Self { format: item.format, print: item.print.clone(), report, undecided }
    }

    /// Writes what was found.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let how = (self.format, &self.print);
        self.report.as_ref().map_or(Ok(()), |report| report.printed(how, out))
    }

    /// Tells whether there is anything to write.
    pub fn is_known(&self) -> bool {
        self.report.is_some()
    }
}

/// Parts of an item, all of them done.
struct ItemParts<'a> {
    plan: &'a Plan<'a>,
    done: &'a [Option<WorkDone>],
    index: usize,
}

impl<'a> ItemParts<'a> {
    /// The work of each part, with its result.
    fn parts(&self) -> impl Iterator<Item = (&'a Work<'a>, &'a WorkDone)> {
        let Self { plan, done, index } = *self;
        let part = |place: &usize| Some((&plan.parts[*place].work, done[*place].as_ref()?));
        plan.needs[index].iter().filter_map(part)
    }

    /// Results of the parts.
    fn done(&self) -> impl Iterator<Item = &'a WorkDone> {
        self.parts().map(|(_, done)| done)
    }

    fn surveys(&self) -> (Option<Box<dyn Reported>>, Vec<String>) {
        let found = self.done().filter_map(|done| match done {
            WorkDone::Survey(found) => Some(found.clone()),
            _ => None,
        });
        let (found, undecided) = apart(found, |of: &SurveyedArches| of.first_open().is_some());
        (Some(Box::new(found)), undecided)
    }

    /// The boxes of each self-weight.
    fn boxes(&self, boxes: &SceneBoxes) -> (Option<Box<dyn Reported>>, Vec<String>) {
        let found = self.done().filter_map(|done| match done {
            WorkDone::Cell(found) => Some(found.clone()),
            _ => None,
        });
        let (found, undecided) = apart(found, |of: &SurveyedCell| of.reason.is_some());
        let SceneBoxes { asked, given, cut, rows } = boxes;
        let mut all: Vec<SurveyedCells> = Vec::new();
        for cell in found {
            match all.last_mut() {
                Some(last) if last.weight == cell.weight => last.cells.push(cell),
                _ => all.push(SurveyedCells {
                    asked: Understood::of_ranges(asked, given),
                    weight: cell.weight,
                    cut: cut.clone(),
                    cells: vec![cell],
                    rows: rows.clone(),
                }),
            }
        }
        (Some(Box::new(all)), undecided)
    }

    fn constants(&self, quantities: &[Quantity], digits: usize) -> Vec<Answer> {
        let format = self.plan.scene.items[self.index].format;
        let answer = |(work, done): (&Work, &WorkDone)| {
            let (Work::Landmark(node), WorkDone::Landmark(found)) = (work, done) else {
                return None;
            };
            let name = (node.landmark, node.weight);
            Some(match &**found {
                Err(undecided) => Answer::landmark(name, Err(undecided)),
                Ok(piece) => {
                    let constants = piece.constants(node, quantities, digits);
                    let answer = Answer::landmark(name, Ok((&piece.point, constants)));
                    match piece.certificates.get(&digits) {
                        Some(hash) if format.has_certificates => {
                            answer.with_certificate(digits, hash.clone())
                        }
                        _ => answer,
                    }
                }
            })
        };
        self.parts().filter_map(answer).collect()
    }

    fn arches(&self, arches: &[SceneArch], digits: usize) -> Vec<Answer> {
        let all: Vec<_> = arches.iter().zip(self.parts()).collect();
        let proved = self.plan.scene.items[self.index].format.proved_digits(digits);
        let answers = all.par_iter().enumerate().filter_map(|(index, (asked, part))| {
            let SceneArch { arch, thickness, measured } = asked;
            let line = index as u64 + 1;
            let (Work::Arch(node), WorkDone::Arch(piece)) = part else { return None };
            let answer = match thickness {
                Some(eta) => {
                    let found = &piece.thicknesses[node.place(eta, proved)?];
                    Answer::assessment(line, (arch, eta), found)
                }
                None => Answer::state(line, arch, piece.states.get(&proved)?),
            };
            let asymmetric = || piece.asymmetric.get(&proved).cloned().unwrap_or(Ok(Vec::new()));
            let answer = answer.with_asymmetric(asymmetric);
            let Some(MeasuredArch { asked, given }) = measured.as_deref() else {
                return Some(answer);
            };
            let of = given.measures.as_ref()?;
            let sizes = match thickness {
                Some(eta) => measured_assessment((arch, eta), of, digits),
                None => measured_state(arch, of, digits),
            };
            let asked = Some(Box::new(Understood::new(asked, given)));
            Some(Answer { asked, ..answer.measured(of.circle(), sizes) })
        });
        answers.collect()
    }

    /// A map of what is proved; a picture needs all its curves, as without one it would show other domains.
    fn map(&self, asked: &SceneMap, format: &Format) -> (Option<Box<dyn Reported>>, Vec<String>) {
        let (mut traces, mut levels, mut open) = (Vec::new(), Vec::new(), Vec::new());
        for part in self.done() {
            match part {
                WorkDone::Curve(Ok(CurvePiece::Curve(trace))) => traces.push((**trace).clone()),
                WorkDone::Curve(Ok(CurvePiece::Level(level))) => levels.push(level.clone()),
                WorkDone::Curve(Err(undecided)) => open.push(undecided.to_string()),
                _ => {}
            }
        }
        if (format.is_picture || format.is_page()) && !open.is_empty() {
            return (None, open);
        }
        let landmarks = self.constants(&Quantity::LANDMARK, PAGE_DIGITS);
        let names = undecided_landmarks(&landmarks);
        let is_asked = |weight: &SelfWeight| asked.lines.iter().any(|(of, _)| of == weight);
        let weights = SelfWeight::ALL.into_iter().filter(is_asked);
        let mut marks = Vec::new();
        for (weight, mark) in
            weights.flat_map(|weight| asked.marks.iter().map(move |m| (weight, m)))
        {
            match mark.proved(weight) {
                Ok(mark) => marks.push(mark),
                Err(undecided) => open.push(undecided.to_string()),
            }
        }
        let (view, axes, command) = (asked.view, asked.axes, asked.command.clone());
        let drawing = Drawing { view, axes, marks, command };
        let map = Map {
            tolerance: asked.tolerance,
            traces,
            levels,
            borders: Vec::new(),
            landmarks,
            drawing,
        };
        open.extend(map.open().into_iter().chain(names));
        (Some(Box::new(map)), open)
    }

    /// Arches that are drawn, in the modes that are asked for; all of them or none.
    fn drawing(&self, asked: &SceneDrawing) -> (Option<Box<dyn Reported>>, Vec<String>) {
        let (mut sketches, mut open) = (Vec::new(), Vec::new());
        for ((_, modes), part) in asked.arches.iter().zip(self.done()) {
            let WorkDone::Drawing(found) = part else { continue };
            match (**found).clone().and_then(|sketch| sketch.in_modes(modes)) {
                Ok(sketch) => sketches.push(sketch),
                Err(none) => open.push(none.to_string()),
            }
        }
        let (style, command) = (asked.style, asked.command.clone());
        let (measures, between) = (asked.measures.clone(), Vec::new());
        let drawn = Sketched { sketches, style, measures, between, command };
        (open.is_empty().then(|| Box::new(drawn) as Box<dyn Reported>), open)
    }

    fn audit(&self) -> Result<Audit, Error> {
        let enclosed = |part: &WorkDone| match part {
            WorkDone::Landmark(found) => found
                .as_ref()
                .as_ref()
                .map(|piece| piece.enclosed.clone())
                .map_err(Clone::clone)
                .transpose(),
            _ => None,
        };
        let points: Vec<Enclosed> = self.done().filter_map(enclosed).collect::<Result<_, _>>()?;
        Ok(Audit { printed: audit_of(&points)?, comparisons: compare_weights_of(&points)? })
    }
}

/// Answers about ranges, apart from what stays open or makes no sense.
fn apart<T>(
    found: impl Iterator<Item = Result<Arc<T>, String>>,
    is_open: fn(&T) -> bool,
) -> (Vec<Arc<T>>, Vec<String>) {
    let (mut all, mut undecided) = (Vec::new(), Vec::new());
    for one in found {
        match one {
            Ok(one) => all.push(one),
            Err(error) => undecided.push(error),
        }
    }
    let open = all.iter().filter(|one| is_open(one)).count();
    undecided.extend((open > 0).then(|| format!("{open} of {} ranges", all.len())));
    (all, undecided)
}

fn undecided_landmarks(list: &[Answer]) -> Vec<String> {
    let open = list.iter().filter(|answer| answer.is_undecided());
    let names = open.filter_map(|answer| {
        let subject = &answer.subject;
        Some(format!("{} {}", subject.landmark()?.symbol(), subject.weight()?.name()))
    });
    names.collect()
}
