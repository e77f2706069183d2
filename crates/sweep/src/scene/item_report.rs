//! What an item asked for, as a report.

use super::pieces::{CurvePiece, Pieces};
use super::plan::{PAGE_DIGITS, Plan};
use super::schema::{SceneArch, SceneDrawing, SceneMap, What};
use crate::arch::SelfWeight;
use crate::certify::{Enclosed, Error};
use crate::judge::{audit_of, compare_weights_of};
use crate::problem::Quantity;
use crate::report::{Answer, Answers, Audit, Claims, Drawing, Format, Map, Report, Sketched};
use std::io;

/// What an item asked for.
pub struct ItemReport {
    format: &'static Format,
    /// Nothing where not even a part is known.
    report: Option<Report>,
    /// What could not be decided.
    pub undecided: Vec<String>,
}

impl ItemReport {
    /// What an item asked for, from pieces that are all there.
    pub(super) fn new(plan: &Plan, pieces: &Pieces, index: usize) -> Self {
        let item = &plan.scene.items[index];
        let (report, undecided) = match &item.what {
            What::Constants { quantities, digits, .. } => {
                let list = constants(plan, pieces, index, (quantities, *digits));
                let undecided = undecided_landmarks(&list);
                (Some(Report::Answers(Answers::constants(*digits, list))), undecided)
            }
            What::Arches { quantities, digits, with_thickness, .. } => {
                let list = arches(plan, pieces, index, *digits);
                let (open, all) =
                    (list.iter().filter(|answer| answer.is_undecided()).count(), list.len());
                let undecided = (open > 0).then(|| format!("{open} of {all} arches"));
                let answers = Answers::arches(*digits, *with_thickness);
                let answers = Answers { quantities: quantities.clone(), list, ..answers };
                (Some(Report::Answers(answers)), undecided.into_iter().collect())
            }
            What::Claims { show, .. } => {
                let places = plan.needs[index].claims.iter();
                let decisions: Vec<_> =
                    places.filter_map(|&place| pieces.claims[place].clone()).collect();
                let open = decisions.iter().filter(|decision| decision.outcome.is_err());
                let undecided = open.map(|decision| decision.claim.id.to_owned()).collect();
                // How long a claim took would be another output in every run.
                let claims = Claims { decisions, show: *show, timed: false };
                (Some(Report::Claims(claims)), undecided)
            }
            What::Map(asked) | What::Figure(asked) => map(plan, pieces, index, asked),
            What::Drawing(asked) => drawing(plan, pieces, index, asked),
            What::Audit { .. } => match audit(plan, pieces, index) {
                Ok(audit) => (Some(Report::Audit(audit)), Vec::new()),
                Err(undecided) => (None, vec![undecided.to_string()]),
            },
        };
        Self { format: item.format, report, undecided }
    }

    /// Writes what was found.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        self.report.as_ref().map_or(Ok(()), |report| report.write(self.format, out))
    }

    /// Whether there is anything to write.
    pub fn is_known(&self) -> bool {
        self.report.is_some()
    }
}

fn constants(
    plan: &Plan,
    pieces: &Pieces,
    index: usize,
    (quantities, digits): (&[Quantity], usize),
) -> Vec<Answer> {
    let answer = |&place: &usize| {
        let node = &plan.landmarks[place];
        let name = (node.landmark, node.weight);
        Some(match pieces.landmarks[place].as_ref()? {
            Err(undecided) => Answer::landmark(name, Err(undecided)),
            Ok(piece) => {
                let constants = piece.constants(node, quantities, digits);
                let answer = Answer::landmark(name, Ok((&piece.point, constants)));
                match piece.certificates.get(&digits) {
                    Some(hash) if plan.scene.items[index].format.has_certificates => {
                        answer.with_certificate(digits, hash.clone())
                    }
                    _ => answer,
                }
            }
        })
    };
    plan.needs[index].landmarks.iter().filter_map(answer).collect()
}

fn arches(plan: &Plan, pieces: &Pieces, index: usize, digits: usize) -> Vec<Answer> {
    let What::Arches { arches, .. } = &plan.scene.items[index].what else { return Vec::new() };
    let needs = arches.iter().zip(&plan.needs[index].arches);
    let answers = (1..).zip(needs).map(|(line, (SceneArch { arch, thickness }, (place, of)))| {
        let piece = pieces.arches[*place].as_ref()?;
        let answer = match thickness.as_ref().zip(*of) {
            Some((eta, of)) => Answer::assessment(line, (arch, eta), &piece.thicknesses[of]),
            None => Answer::state(line, arch, piece.states.get(&digits)?),
        };
        let asymmetric = || piece.asymmetric.get(&digits).cloned().unwrap_or(Ok(Vec::new()));
        Some(answer.with_asymmetric(asymmetric))
    });
    answers.flatten().collect()
}

/// A map of what is proved; a picture needs all its curves, as without one it would show other domains.
fn map(
    plan: &Plan,
    pieces: &Pieces,
    index: usize,
    asked: &SceneMap,
) -> (Option<Report>, Vec<String>) {
    let format = plan.scene.items[index].format;
    let (mut traces, mut levels, mut open) = (Vec::new(), Vec::new(), Vec::new());
    for place in &plan.needs[index].curves {
        match &pieces.curves[*place] {
            Some(Ok(CurvePiece::Curve(trace))) => traces.push((**trace).clone()),
            Some(Ok(CurvePiece::Level(level))) => levels.push(level.clone()),
            Some(Err(undecided)) => open.push(undecided.to_string()),
            None => {}
        }
    }
    if (format.is_picture || format.is_page()) && !open.is_empty() {
        return (None, open);
    }
    let landmarks = constants(plan, pieces, index, (&Quantity::LANDMARK, PAGE_DIGITS));
    let names = undecided_landmarks(&landmarks);
    let is_asked = |weight: &SelfWeight| asked.lines.iter().any(|(of, _)| of == weight);
    let weights = SelfWeight::ALL.into_iter().filter(is_asked);
    let mut marks = Vec::new();
    for (weight, mark) in weights.flat_map(|weight| asked.marks.iter().map(move |m| (weight, m))) {
        match mark.proved(weight) {
            Ok(mark) => marks.push(mark),
            Err(undecided) => open.push(undecided.to_string()),
        }
    }
    let (view, axes, command) = (asked.view, asked.axes, asked.command.clone());
    let drawing = Drawing { view, axes, marks, command };
    let map =
        Map { tolerance: asked.tolerance, traces, levels, borders: Vec::new(), landmarks, drawing };
    open.extend(map.open().into_iter().chain(names));
    (Some(Report::Map(map)), open)
}

/// Arches that are drawn, in the modes that are asked for; all of them or none.
fn drawing(
    plan: &Plan,
    pieces: &Pieces,
    index: usize,
    asked: &SceneDrawing,
) -> (Option<Report>, Vec<String>) {
    let (mut sketches, mut open) = (Vec::new(), Vec::new());
    for ((_, modes), place) in asked.arches.iter().zip(&plan.needs[index].drawings) {
        match &pieces.drawings[*place] {
            Some(Ok(sketch)) => match sketch.clone().in_modes(modes) {
                Ok(sketch) => sketches.push(sketch),
                Err(none) => open.push(none.to_string()),
            },
            Some(Err(none)) => open.push(none.to_string()),
            None => {}
        }
    }
    let (style, command) = (asked.style, asked.command.clone());
    let drawn = Sketched { sketches, style, measures: None, command };
    (open.is_empty().then_some(Report::Sketched(drawn)), open)
}

fn undecided_landmarks(list: &[Answer]) -> Vec<String> {
    let open = list.iter().filter(|answer| answer.is_undecided());
    let names = open.filter_map(|answer| {
        let subject = &answer.subject;
        Some(format!("{} {}", subject.landmark()?.symbol(), subject.weight()?.name()))
    });
    names.collect()
}

fn audit(plan: &Plan, pieces: &Pieces, index: usize) -> Result<Audit, Error> {
    let places = plan.needs[index].landmarks.iter();
    let points: Vec<Enclosed> = places
        .filter_map(|&place| pieces.landmarks[place].as_ref())
        .filter_map(|piece| piece.as_ref().map(|piece| piece.enclosed.clone()).transpose())
        .map(|piece| piece.map_err(Clone::clone))
        .collect::<Result<_, _>>()?;
    Ok(Audit { printed: audit_of(&points)?, comparisons: compare_weights_of(&points)? })
}
