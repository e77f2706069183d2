//! The report of an item.

use super::arch_node::ArchPiece;
use super::computable::Done;
use super::landmark_node::LandmarkPiece;
use super::plan::{PAGE_DIGITS, Plan};
use super::scene_map::{CurvePiece, SceneMap};
use super::schema::{MeasuredArch, Request, SceneArch, SceneBoxes, SceneDrawing};
use crate::answer;
use crate::arch::SelfWeight;
use crate::atlas::{NoLevel, NoSketch, Sketch};
use crate::certify::{Enclosed, Error};
use crate::claims::Decision;
use crate::judge::{audit_of, compare_weights_of};
use crate::picture::Print;
use crate::problem::{Landmark, Quantity};
use crate::report::{
    Answer, Answers, Audit, Claims, Drawing, Extent, Format, Map, Reported, Sketched,
    SurveyedArches, SurveyedCell, SurveyedCells, Understood,
};
use rayon::prelude::*;
use std::any::Any;
use std::io;
use std::sync::Arc;

/// A report, or nothing where not even a part is known, and the questions that could not be decided.
type ItemFound = (Option<Box<dyn Reported>>, Vec<String>);

/// Answer to an item.
pub struct ItemReport {
    format: &'static Format,
    print: Print,
    /// Report, or nothing where not even a part is known.
    pub report: Option<Box<dyn Reported>>,
    /// Questions that could not be decided.
    pub undecided: Vec<String>,
    /// Reason why no arch has what was asked for, where that is seen by a proof only.
    pub misfit: Option<String>,
}

impl ItemReport {
    /// The report of an item, from parts that are all there.
    pub(super) fn new(plan: &Plan, done: &[Option<Done>], index: usize) -> Self {
        let item = &plan.scene.items[index];
        let parts = ItemParts { plan, done, index };
        let mut misfit = None;
        let (report, undecided): ItemFound = match &item.what {
            Request::Constants { points, quantities, digits } => {
                let list = parts.constants(points, quantities, *digits);
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
            Request::Surveys { surveys, boxes: None, .. } => {
                let is_open = |of: &SurveyedArches| of.first_open().is_some();
                let (found, undecided) = parts.apart(surveys.len(), is_open);
                (Some(Box::new(found)), undecided)
            }
            Request::Surveys { surveys, boxes: Some(boxes), .. } => {
                parts.boxes(boxes, surveys.len())
            }
            Request::Claims { claims, show } => {
                let decisions: Vec<Decision> = parts.done(claims.len()).cloned().collect();
                let open = decisions.iter().filter(|decision| decision.outcome.is_err());
                let undecided = open.map(|decision| decision.claim.id.to_owned()).collect();
                // How long a claim took would be another output in every run.
                let claims = Claims { decisions, show: *show, timed: false };
                (Some(Box::new(claims)), undecided)
            }
            Request::Map(asked) => parts.map(asked, item.format).unwrap_or_else(|why| {
                misfit = Some(why);
                (None, Vec::new())
            }),
            Request::Drawing(asked) => parts.drawing(asked),
            Request::Audit { points } => match parts.audit(points.len()) {
                Ok(audit) => (Some(Box::new(audit)), Vec::new()),
                Err(undecided) => (None, vec![undecided.to_string()]),
            },
        };
        Self { format: item.format, print: item.print.clone(), report, undecided, misfit }
    }

    /// Writes what was found.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let how = (self.format, &self.print);
        self.report.as_ref().map_or(Ok(()), |report| report.printed(how, out))
    }
}

/// Parts of an item, all of them done.
struct ItemParts<'a> {
    plan: &'a Plan<'a>,
    done: &'a [Option<Done>],
    index: usize,
}

impl<'a> ItemParts<'a> {
    /// Results of the parts that have this type, in the order in which the item asks for so many of them.
    fn done<T: Any>(&self, asked: usize) -> impl Iterator<Item = &'a T> + use<'a, T> {
        let Self { plan, done, index } = *self;
        let of_type = |place: &usize| done[*place].as_ref()?.downcast_ref();
        let found = plan.needs[index].iter().filter_map(of_type);
        // An item whose part had another type would be answered without it.
        debug_assert_eq!(found.clone().count(), asked);
        found
    }

    /// Answers about ranges, apart from what stays open or makes no sense.
    fn apart<T: Any>(&self, asked: usize, is_open: fn(&T) -> bool) -> (Vec<Arc<T>>, Vec<String>)
    where
        Arc<T>: Send + Sync,
    {
        let (mut all, mut undecided) = (Vec::new(), Vec::new());
        for found in self.done::<Result<Arc<T>, String>>(asked) {
            match found {
                Ok(found) => all.push(found.clone()),
                Err(error) => undecided.push(error.clone()),
            }
        }
        let open = all.iter().filter(|one| is_open(one)).count();
        undecided.extend((open > 0).then(|| format!("{open} of {} ranges", all.len())));
        (all, undecided)
    }

    /// The boxes of each self-weight.
    fn boxes(&self, boxes: &SceneBoxes, asked: usize) -> ItemFound {
        let (found, undecided) = self.apart(asked, |of: &SurveyedCell| of.reason.is_some());
        let SceneBoxes { asked, cut, rows } = boxes;
        let of_weight = |cells: &[Arc<SurveyedCell>]| SurveyedCells {
            asked: asked.clone(),
            weight: cells[0].weight,
            cut: cut.clone(),
            cells: cells.to_vec(),
            rows: rows.clone(),
        };
        let all: Vec<_> = found.chunk_by(|a, b| a.weight == b.weight).map(of_weight).collect();
        (Some(Box::new(all)), undecided)
    }

    fn constants(
        &self,
        points: &[(Landmark, SelfWeight)],
        quantities: &[Quantity],
        digits: usize,
    ) -> Vec<Answer> {
        let format = self.plan.scene.items[self.index].format;
        let answer = |(name, found): (_, &Result<LandmarkPiece, Error>)| match found {
            Err(undecided) => Answer::landmark(name, Err(undecided)),
            Ok(piece) => {
                let constants = piece.constants(quantities, digits);
                let answer = Answer::landmark(name, Ok((&piece.point, constants)));
                match piece.certificates.get(&digits) {
                    Some(hash) if format.has_certificates => {
                        answer.with_certificate(digits, hash.clone())
                    }
                    _ => answer,
                }
            }
        };
        points.iter().copied().zip(self.done(points.len())).map(answer).collect()
    }

    fn arches(&self, arches: &[SceneArch], digits: usize) -> Vec<Answer> {
        let all: Vec<_> = arches.iter().zip(self.done::<ArchPiece>(arches.len())).collect();
        let proved = self.plan.scene.items[self.index].format.proved_digits(digits);
        let answers = all.par_iter().enumerate().filter_map(|(index, (asked, piece))| {
            let SceneArch { arch, thickness, measured } = asked;
            let line = index as u64 + 1;
            let measured = measured.as_deref();
            let measures = measured.and_then(|of| of.given.measures.as_ref());
            let measures = measures.map(|of| (of, digits));
            let answer = match thickness {
                Some(eta) => {
                    let found = piece.thicknesses.get(&(eta.to_rational(), proved))?;
                    answer::assessment(Extent::ALL, line, (arch, eta, measures), proved, found)
                }
                None => answer::state(line, (arch, measures), proved, piece.states.get(&proved)?),
            };
            let understood = |of: &MeasuredArch| Box::new(Understood::new(&of.asked, &of.given));
            Some(Answer { asked: measured.map(understood), ..answer })
        });
        answers.collect()
    }

    /// A map of what is proved, or why no arch is on it; a picture needs all its curves, as without one it would show
    /// other domains.
    fn map(&self, asked: &SceneMap, format: &Format) -> Result<ItemFound, String> {
        let is_asked = |weight: &SelfWeight| asked.lines.iter().any(|(of, _)| of == weight);
        let weights = SelfWeight::ALL.into_iter().filter(is_asked);
        let marked = weights.flat_map(|weight| asked.marks.iter().map(move |of| (weight, of)));
        let (mut marks, mut open) = (Vec::new(), Vec::new());
        for (weight, mark) in marked {
            match mark.proved(weight) {
                Ok(mark) => marks.push(mark),
                Err(Error::Undecided(undecided)) => open.push(undecided.to_string()),
                Err(Error::Refused(refused)) => return Err(refused.to_string()),
            }
        }
        let (view, axes, command) = (asked.view, asked.axes, asked.command.clone());
        let drawing = Drawing { view, axes, marks, command };
        let landmarks = self.constants(&asked.landmarks, &Quantity::LANDMARK, PAGE_DIGITS);
        let (traces, levels, borders) = (Vec::new(), Vec::new(), Vec::new());
        let mut map =
            Map { tolerance: asked.tolerance, traces, levels, borders, landmarks, drawing };
        for part in self.done::<Result<CurvePiece, NoLevel>>(asked.lines.len()) {
            match part {
                Ok(CurvePiece::Curve(trace)) => map.traces.push((**trace).clone()),
                Ok(CurvePiece::Level(level)) => map.levels.push(level.clone()),
                Ok(CurvePiece::Borders(borders)) => map.borders.extend(borders.iter().cloned()),
                Err(NoLevel::Outside(why)) => return Err(why.clone()),
                Err(undecided) => open.push(undecided.to_string()),
            }
        }
        if (format.is_picture || format.is_page()) && !open.is_empty() {
            return Ok((None, open));
        }
        open.extend(map.open().into_iter().chain(undecided_landmarks(&map.landmarks)));
        Ok((Some(Box::new(map)), open))
    }

    /// Arches that are drawn, in the modes that are asked for; all of them or none.
    fn drawing(&self, asked: &SceneDrawing) -> ItemFound {
        let (mut sketches, mut open) = (Vec::new(), Vec::new());
        for ((_, modes), part) in asked.arches.iter().zip(self.done(asked.arches.len())) {
            let found: &Result<Sketch, NoSketch> = part;
            match found.clone().and_then(|sketch| sketch.in_modes(modes)) {
                Ok(sketch) => sketches.push(sketch),
                Err(none) => open.push(none.to_string()),
            }
        }
        let (style, command) = (asked.style, asked.command.clone());
        let (measures, between) = (asked.measures.clone(), Vec::new());
        let drawn = Sketched { sketches, style, measures, between, command };
        (open.is_empty().then(|| Box::new(drawn) as Box<dyn Reported>), open)
    }

    fn audit(&self, asked: usize) -> Result<Audit, Error> {
        let enclosed = |found: &Result<LandmarkPiece, Error>| match found {
            Ok(piece) => piece.enclosed.clone().map(Ok),
            Err(error) => Some(Err(error.clone())),
        };
        let points: Vec<Enclosed> =
            self.done(asked).filter_map(enclosed).collect::<Result<_, _>>()?;
        Ok(Audit { printed: audit_of(&points)?, comparisons: compare_weights_of(&points)? })
    }
}

fn undecided_landmarks(list: &[Answer]) -> Vec<String> {
    let open = list.iter().filter(|answer| answer.is_undecided());
    let names = open.filter_map(|answer| {
        let subject = &answer.subject;
        Some(format!("{} {}", subject.landmark()?.symbol(), subject.weight()?.name()))
    });
    names.collect()
}
