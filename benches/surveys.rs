//! What a verdict on every arch of a survey costs, how often it stays open, and how many ends of its ranges are values
//! of arches; and random arches inside, each with its own proof, which contradict it or do not.
//!
//! `BOXES=10000 ARCHES=100 cargo bench --bench surveys`: so many surveys of each kind, with ranges of at most 5 % to
//! both sides in every measure, and so many arches in each. One thread. Nothing is asserted but that there is no
//! contradiction.

use couplet::certify::state::Certify;
use couplet::certify::survey::{SurveyAnswer, SurveyVerdict, survey};
use couplet::prelude::*;
use couplet::problem::measures::{Circle, Length, Measures, of_span_and_rise};
use couplet::problem::survey::{Shape, Survey};
use couplet::problem::{Friction, Quantity};
use std::time::{Duration, Instant};

/// SplitMix64 (Steele, Lea and Flood 2014): the same surveys in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn within(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.next()
    }

    /// Ends to both sides of a value; one in four is one number.
    fn range(&mut self, of: [f64; 2]) -> [f64; 2] {
        let x = self.within(of);
        let by = (self.within([-0.015, 0.05])).max(0.0);
        [x * (1.0 - by), x * (1.0 + by)]
    }
}

fn text(x: f64) -> String {
    format!("{x:.7}")
}

fn number(x: f64) -> ExactNumber {
    text(x).parse().unwrap()
}

fn length(x: f64) -> Length {
    format!("{x:.7}m").parse().unwrap()
}

fn friction(x: f64) -> Friction {
    text(x).parse().unwrap()
}

#[derive(Default)]
struct Tally {
    surveys: usize,
    undecided: usize,
    verdicts: [usize; 3],
    ends: usize,
    attained: usize,
    arches: usize,
    contradictions: usize,
    total: Duration,
    longest: Duration,
}

impl Tally {
    fn count(&mut self, found: &SurveyAnswer, time: Duration) {
        self.surveys += 1;
        match &found.verdict {
            Some(Ok(verdict)) => self.verdicts[*verdict as usize] += 1,
            _ => self.undecided += 1,
        }
        let decided = |of: Quantity| !matches!(of, Quantity::LeastThrust | Quantity::LargestThrust);
        for range in found.ranges.iter().filter(|range| decided(range.of)) {
            self.ends += 2;
            self.attained += usize::from(range.lower.at.is_some());
            self.attained += usize::from(range.upper.at.is_some());
        }
        self.total += time;
        self.longest = self.longest.max(time);
    }

    /// An arch of a survey, proved by itself.
    fn try_arch(&mut self, found: &SurveyAnswer, arch: &Arch, eta: &ExactNumber) {
        self.arches += 1;
        let Ok(own) = arch.certify_thickness(eta, 10) else { return };
        let Ok(stands) = own.stands else { return };
        let contradicts = match &found.verdict {
            Some(Ok(SurveyVerdict::AllStand)) => !stands,
            Some(Ok(SurveyVerdict::NoneStands)) => stands,
            _ => false,
        };
        self.contradictions += usize::from(contradicts);
    }

    fn row(&self, name: &str) {
        let each = self.total.as_secs_f64() * 1e3 / self.surveys.max(1) as f64;
        let part = 100.0 * self.attained as f64 / self.ends.max(1) as f64;
        let [all, none, both] = self.verdicts;
        println!(
            "| {name} | {} | {all} / {none} / {both} | {} | {part:.2} % | {each:.3} | {:.1} | {} | {} |",
            self.surveys,
            self.undecided,
            self.longest.as_secs_f64() * 1e3,
            self.arches,
            self.contradictions,
        );
        assert_eq!(self.contradictions, 0);
    }
}

fn free(random: &mut Random, boxes: usize, arches: usize) -> Tally {
    let mut tally = Tally::default();
    while tally.surveys < boxes {
        let weight = SelfWeight::ALL[usize::from(random.next() < 0.5)];
        let (alphas, mus) = (random.range([0.3, 2.7]), random.range([0.05, 2.5]));
        let least =
            Arch::new(weight, number(alphas[0]), friction(mus[1])).unwrap().certify_alone(8);
        let least = match least {
            Ok(Answer::Stands(state)) => state.thickness.double,
            _ => random.within([0.05, 1.0]),
        };
        // Thicknesses about the least one: all verdicts are met.
        let etas = random.range([least * 0.8, least * 1.5]).map(|x| x.clamp(1e-4, 2.0));
        let shape =
            Shape::Free { half_opening: alphas.map(number), thickness: Some(etas.map(number)) };
        let Ok(asked) = Survey::new(weight, mus.map(friction), shape) else { continue };
        let start = Instant::now();
        let Ok(found) = survey(&asked, 10) else {
            tally.undecided += 1;
            continue;
        };
        tally.count(&found, start.elapsed());
        for _ in 0..arches {
            let arch =
                Arch::new(weight, number(random.within(alphas)), friction(random.within(mus)));
            tally.try_arch(&found, &arch.unwrap(), &number(random.within(etas)));
        }
    }
    tally
}

fn measured(random: &mut Random, boxes: usize, arches: usize) -> Tally {
    let mut tally = Tally::default();
    while tally.surveys < boxes {
        let weight = SelfWeight::ALL[usize::from(random.next() < 0.5)];
        let circle = Circle::ALL[(random.next() * 3.0) as usize % 3];
        let (spans, rises) = (random.range([4.0, 20.0]), random.range([1.0, 8.0]));
        let (mus, ts) = (random.range([0.1, 1.5]), random.range([0.1, 1.0]));
        let shape = Shape::Spanned {
            circle,
            span: spans.map(length),
            rise: rises.map(length),
            thickness: ts.map(length),
        };
        let Ok(asked) = Survey::new(weight, mus.map(friction), shape) else { continue };
        let start = Instant::now();
        let Ok(found) = survey(&asked, 10) else {
            tally.undecided += 1;
            continue;
        };
        tally.count(&found, start.elapsed());
        for _ in 0..arches {
            let (span, rise) = (length(random.within(spans)), length(random.within(rises)));
            let (alpha, radius) = of_span_and_rise(&span, &rise);
            let eta = Measures::new(circle, radius, None).thickness(&length(random.within(ts)));
            let arch = Arch::new(weight, alpha, friction(random.within(mus))).unwrap();
            tally.try_arch(&found, &arch, &eta.unwrap());
        }
    }
    tally
}

fn main() {
    let count = |name: &str, usual: usize| {
        std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
    };
    let (boxes, arches) = (count("BOXES", 1_000), count("ARCHES", 10));
    println!(
        "| surveys | number | all / none / both | undecided | ends attained | ms each | ms longest | arches inside | contradictions |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    free(&mut Random(1), boxes, arches).row("half opening, friction, thickness");
    measured(&mut Random(2), boxes, arches).row("span, rise, friction, thickness");
}
