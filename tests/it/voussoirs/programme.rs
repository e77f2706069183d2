//! A programme that knows no polynomial, no mode and no lemma: every joint is looked at, the gap that is left for
//! the crown moment is a concave function of the thrust, and the thickness is halved.

use super::{equal, found, joints};
use crate::hard::random;
use couplet::arch::SelfWeight;
use couplet::certify::{VoussoirLimit, VoussoirStanding, Voussoirs, assess_voussoirs};
use couplet::problem::Mode;

/// The programme in doubles.
pub(crate) struct Programme {
    joints: Vec<f64>,
    flag: f64,
    mu: f64,
}

impl Programme {
    /// The programme of so many stones of one angle.
    pub(crate) fn new(stones: u64, half_opening: f64, weight: SelfWeight, mu: f64) -> Self {
        Self { joints: joints(stones, half_opening), flag: f64::from(weight.flag()), mu }
    }

    /// The room for the crown moment at a thrust: negative where there is none.
    fn room(&self, eta: f64, h: f64) -> f64 {
        let fac = 1.0 + self.flag * eta * eta / 12.0;
        let moment =
            |radius: f64, b: f64| radius * (h * b.cos() + b * b.sin()) - fac * (1.0 - b.cos());
        let joints = self.joints.iter();
        let most = joints.clone().map(|b| moment(1.0 + eta / 2.0, *b)).fold(f64::MAX, f64::min);
        let least = joints.map(|b| moment(1.0 - eta / 2.0, *b)).fold(f64::MIN, f64::max);
        most - least
    }

    /// The thrusts that friction and normal forces allow; `None` if there are none.
    fn thrusts(&self) -> Option<(f64, f64)> {
        let (mut least, mut most) = (f64::MIN, f64::MAX);
        let mut at_most = |coefficient: f64, bound: f64| {
            if coefficient > 1e-14 {
                most = most.min(bound / coefficient);
            } else if coefficient < -1e-14 {
                least = least.max(bound / coefficient);
            }
        };
        for b in &self.joints {
            let (s, c) = b.sin_cos();
            at_most(-c, b * s);
            if self.mu.is_finite() {
                at_most(-s - self.mu * c, -b * (c - self.mu * s));
                at_most(s - self.mu * c, b * (c + self.mu * s));
            }
        }
        (least <= most).then_some((least.max(-10.0), most.min(10.0)))
    }

    /// The thrust with the most room.
    fn best(&self, eta: f64) -> Option<f64> {
        let (mut low, mut high) = self.thrusts()?;
        for _ in 0..100 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            match self.room(eta, a) < self.room(eta, b) {
                true => low = a,
                false => high = b,
            }
        }
        Some((low + high) / 2.0)
    }

    /// Whether an arch of this thickness stands.
    pub(crate) fn stands(&self, eta: f64) -> bool {
        self.best(eta).is_some_and(|best| self.room(eta, best) >= 0.0)
    }

    /// The least and the largest thrust with room, of those between two.
    fn range(&self, eta: f64) -> Option<(f64, f64)> {
        let (first, last) = self.thrusts()?;
        let best = self.best(eta)?;
        let end = |outside: f64| match self.room(eta, outside) >= 0.0 {
            true => outside,
            false => halved(100, best, outside, |thrust| self.room(eta, thrust) >= 0.0),
        };
        (self.room(eta, best) >= 0.0).then(|| (end(first), end(last)))
    }

    /// The least thickness up to 2; `None` if none is enough.
    fn thickness(&self) -> Option<f64> {
        self.stands(2.0).then(|| halved(45, 2.0, 0.0, |eta| self.stands(eta)))
    }
}

/// Where between two numbers something ceases to be so, on the side where it is.
fn halved(steps: usize, mut inside: f64, mut outside: f64, is_so: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..steps {
        let middle = (inside + outside) / 2.0;
        match is_so(middle) {
            true => inside = middle,
            false => outside = middle,
        }
    }
    inside
}

/// What is proved of arches of all modes is what the programme finds. Gives the modes met.
fn agree(count: usize, seed: u64) -> Vec<Mode> {
    let mut random = random(seed);
    let mut modes = Vec::new();
    for _ in 0..count {
        let weight = SelfWeight::ALL[usize::from(random() < 0.5)];
        let stones = 4 + (random() * random() * 196.0) as u64;
        let alpha = format!("{:.6}", 0.3 + 2.5 * random());
        let mu = match random() < 0.1 {
            true => "inf".to_owned(),
            false => format!("{:.6}", 3.0 * random() * random()),
        };
        let programme = Programme::new(stones, alpha.parse().unwrap(), weight, mu.parse().unwrap());
        let case = format!("{} {alpha} {mu} {stones}", weight.name());
        match (found(&equal(stones, &alpha), weight, &mu, 12), programme.thickness()) {
            (Voussoirs::Stands(state), Some(eta)) => {
                assert!((state.thickness.double - eta).abs() < 1e-9, "{case}: {state:?} {eta}");
                if !modes.contains(&state.mode) {
                    modes.push(state.mode);
                }
            }
            (Voussoirs::Slides, None) => assert!(programme.thrusts().is_none(), "{case}"),
            (Voussoirs::TooThick, None) => assert!(programme.thrusts().is_some(), "{case}"),
            (proved, programme) => panic!("{case}: {proved:?} {programme:?}"),
        }
    }
    modes
}

#[test]
fn a_programme_over_all_joints_finds_the_same() {
    let modes = agree(400, 0x9e37_79b9_7f4a_7c15);
    for mode in [
        Mode::Rotational,
        Mode::SlidingRotational,
        Mode::RotationalSliding,
        Mode::OverturningSliding,
        Mode::Overturning,
    ] {
        assert!(modes.contains(&mode), "{mode:?} {modes:?}");
    }
}

#[test]
#[ignore = "long"]
fn a_programme_over_all_joints_finds_the_same_ten_thousand_times() {
    agree(10_000, 0x2545_f491_4f6c_dd1d);
}

/// What is proved of arches of given thicknesses is what the programme finds: whether they stand, the ends of the
/// thrust, and the least friction.
#[test]
fn a_programme_finds_the_same_thrusts_and_friction() {
    let mut random = random(0x6c62_272e_07bb_0142);
    let (mut stood, mut fell, mut limits) = (0, 0, std::collections::BTreeSet::new());
    for _ in 0..250 {
        let weight = SelfWeight::ALL[usize::from(random() < 0.5)];
        let stones = 4 + (random() * random() * 90.0) as u64;
        let alpha = format!("{:.6}", 0.3 + 2.4 * random());
        let eta = format!("{:.6}", 0.02 + 1.9 * random() * random());
        let mu = match random() < 0.2 {
            true => "inf".to_owned(),
            false => format!("{:.6}", 0.1 + 2.0 * random() * random()),
        };
        let programme = Programme::new(stones, alpha.parse().unwrap(), weight, mu.parse().unwrap());
        let case = format!("{} {alpha} {mu} {stones} {eta}", weight.name());
        let double: f64 = eta.parse().unwrap();
        let exact = eta.parse().unwrap();
        let found =
            assess_voussoirs(&equal(stones, &alpha), weight, &mu.parse().unwrap(), &exact, 12);
        let found = found.unwrap();
        match (found.standing.as_ref().unwrap(), programme.range(double)) {
            (VoussoirStanding::Stands(ends), Some((least, largest))) => {
                let of =
                    |end: &VoussoirLimit| end.thrust.as_ref().map_or(10.0, |x| x.double.min(10.0));
                assert!((of(&ends[0]) - least).abs() < 1e-8, "{case}: {ends:?} {least}");
                assert!((of(&ends[1]) - largest).abs() < 1e-8, "{case}: {ends:?} {largest}");
                stood += 1;
                limits.extend(
                    ends.iter().flat_map(|end| end.contacts.iter().map(|c| format!("{:?}", c.0))),
                );
            }
            (VoussoirStanding::Falls([least, most]), None) => {
                let [least, most] = [least, most].map(|end| end.thrust.as_ref().unwrap().double);
                assert!(least > most, "{case}");
                fell += 1;
            }
            (proved, programme) => panic!("{case}: {proved:?} {programme:?}"),
        }
        let with = |mu| Programme { mu, joints: programme.joints.clone(), ..programme };
        match found.required_friction.unwrap_or_else(|open| panic!("{case}: {open}")) {
            // A thrust of the range at which both meet may be beyond those that the programme looks at.
            Some(needed) => {
                assert!(with(needed.double * (1.0 + 1e-6)).stands(double), "{case}: {needed}");
                assert!(!with(needed.double * (1.0 - 1e-6)).stands(double), "{case}: {needed}");
            }
            None => assert!(!with(1e9).stands(double), "{case}"),
        }
    }
    assert!(stood > 60 && fell > 30 && limits.len() == 4, "{stood} {fell} {limits:?}");
}
