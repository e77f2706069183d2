//! Questions that can be asked the other way round, and the answers in digits.

use super::line::{beyond, point_on};
use super::widest::{at_thickness, bits_lost, exact_end, widest};
use crate::arch::{Configuration, SelfWeight};
use crate::certify::state::assess::Wanted;
use crate::certify::state::inquiry::Inquiry;
use crate::certify::state::query::{DOUBLE_DOUBLE, GUARD, Query};
use crate::certify::state::state::Fall;
use crate::number::{Ball, ExactNumber, Field, Real, bits_of};
use crate::problem::asymmetric_region::{STANDS, some_may_move as reaches};
use crate::problem::{Arch, ArchError, Friction, Line, Mode, Quantity, Sought};
use crate::prover::{Error, Figure, Refused, Undecided, raise};
use rug::Rational;
use rug::float::Round;

/// A question the other way round.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Question {
    /// The widest half opening that stands: at a thickness in `(0, 2]`, or at any if none is given.
    HalfOpening {
        /// The friction.
        friction: Friction,
        /// The thickness.
        thickness: Option<ExactNumber>,
    },
    /// The least friction with which an arch stands: at a thickness in `(0, 2]`, or at any if none is given.
    Friction {
        /// The half opening, rad.
        half_opening: ExactNumber,
        /// The thickness.
        thickness: Option<ExactNumber>,
    },
    /// Question about the boundary where one mode becomes another.
    Boundary {
        /// The line of the map.
        line: Line,
        /// Given values of its point.
        given: Given,
    },
}

/// Given values of a point on a line of the map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Given {
    /// The half opening, rad; the friction is asked for.
    HalfOpening(ExactNumber),
    /// The friction; the half opening is asked for.
    Friction(Friction),
}

impl Given {
    /// Quantity that is asked for: the other one.
    fn sought(&self) -> Sought {
        match self {
            Self::HalfOpening(_) => Sought::Friction,
            Self::Friction(_) => Sought::HalfOpening,
        }
    }
}

/// The answer to a question the other way round.
#[derive(Clone, Debug)]
pub enum Finding {
    /// The answer is found, and what else is known there.
    Found(Found),
    /// A proof says that there is none, as nothing stands; or, without a reason for that, as the thickness is
    /// below the least one whatever the friction.
    Nothing(Option<Fall>),
    /// A proof says that the line of the map has no such point: it runs between these ends, in words.
    Beyond(Line, String),
}

/// Answer that was asked for, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Found {
    /// Modes in which the arch collapses there; both modes on a line.
    pub modes: Vec<Mode>,
    /// Figures that were asked for, and what else is known there.
    pub figures: Vec<(Quantity, Figure)>,
    /// Statement of what is proved besides: why there is no other answer.
    pub proved: String,
    /// True if an asymmetric mechanism of (19) is [known](crate::problem::asymmetric_region) of any of the
    /// arches that stand by this.
    pub some_may_move: bool,
}

/// Bits with which a line is looked at, before it is known whether it has the point.
const FEW: u32 = 128;

/// Modes that meet there, and the values.
type FoundBalls = (Vec<Mode>, Vec<(Quantity, Ball)>);

impl Question {
    /// Quantity that is asked for.
    pub fn sought(&self) -> Sought {
        match self {
            Self::HalfOpening { .. } => Sought::HalfOpening,
            Self::Friction { .. } => Sought::Friction,
            Self::Boundary { given, .. } => given.sought(),
        }
    }

    /// The friction, if it is given.
    pub fn friction(&self) -> Option<&Friction> {
        match self {
            Self::HalfOpening { friction, .. }
            | Self::Boundary { given: Given::Friction(friction), .. } => Some(friction),
            _ => None,
        }
    }

    /// Arch that is given, with something else in place of what is not: it has to be in its range.
    fn arch(&self, weight: SelfWeight) -> Result<Arch, ArchError> {
        let one = || ExactNumber::from(&Rational::from(1));
        let (half_opening, friction) = match self {
            Self::HalfOpening { friction, .. } => (one(), friction.clone()),
            Self::Friction { half_opening, .. } => (half_opening.clone(), Friction::Infinite),
            Self::Boundary { given, .. } => match given {
                Given::HalfOpening(alpha) => (alpha.clone(), Friction::Infinite),
                Given::Friction(friction) => (one(), friction.clone()),
            },
        };
        Arch::new(weight, half_opening, friction)
    }

    /// The thickness, if one is given.
    pub fn thickness(&self) -> Option<&ExactNumber> {
        match self {
            Self::HalfOpening { thickness, .. } | Self::Friction { thickness, .. } => {
                thickness.as_ref()
            }
            Self::Boundary { .. } => None,
        }
    }
}

/// Answers a question, with every value correctly rounded to `digits` significant digits. Refused if what is given
/// is out of its range, and digits beyond [`MAX_DIGITS`](crate::certify::MAX_DIGITS).
pub fn find(weight: SelfWeight, question: &Question, digits: usize) -> Result<Finding, Error> {
    Refused::digits(digits)?;
    let arch = question.arch(weight)?;
    question.thickness().map_or(Ok(()), Refused::thickness)?;
    let two = ExactNumber::from(&Rational::from(2));
    let eta = question.thickness().unwrap_or(&two);
    let found: Result<Finding, Error> = match question {
        Question::HalfOpening { .. } if arch.friction().is_zero() => {
            Ok(Finding::Nothing(Some(Fall::Sliding)))
        }
        Question::HalfOpening { thickness, .. } => {
            let query = |bits| at_thickness(&arch, eta, bits);
            let proved = match thickness {
                Some(_) => "every narrower arch stands at this thickness, no wider one does",
                None => "every narrower arch stands at some thickness, no wider one does at any",
            };
            let end = exact_end(weight, Quantity::Thickness, eta);
            Ok(in_digits(&query, digits, &defined(proved), |query| {
                let (mode, at) = widest(query, end)?;
                Ok(place(vec![mode], &at, Sought::HalfOpening))
            })?)
        }
        Question::Friction { thickness, .. } => {
            least_friction(&arch, eta, thickness.is_some(), digits)
        }
        Question::Boundary { line, given } => boundary(&arch, *line, given, digits),
    };
    found.map(|finding| match finding {
        Finding::Found(found) => {
            let some_may_move = some_may_move(question, &arch, &found);
            Finding::Found(Found { some_may_move, ..found })
        }
        nothing => nothing,
    })
}

/// Tells whether an asymmetric mechanism is known of any of the arches of which the answer says that they stand.
fn some_may_move(question: &Question, arch: &Arch, found: &Found) -> bool {
    // Balls of doubles know nothing of a size that no arch has.
    let given = arch.given::<Ball>(53);
    let range = |x: &Ball| [x.lower().to_f64_round(Round::Down), x.upper().to_f64_round(Round::Up)];
    let bounds =
        |of: Quantity| found.figures.iter().find(|(name, _)| *name == of).map(|(_, x)| &x.binary);
    let ranges = match question {
        Question::HalfOpening { .. } if arch.is_limited() => bounds(Quantity::HalfOpening)
            .map(|widest| ([0.0, widest.upper], range(&given.friction))),
        Question::Friction { .. } => bounds(Quantity::Friction)
            .map(|least| (range(&given.half_opening.rad), [least.lower, f64::INFINITY])),
        _ => None,
    };
    ranges.is_some_and(|(alphas, mus)| reaches(arch.weight(), alphas, mus))
}

/// The point of a line of the map where it has the given half opening or friction, or the ends between which it runs.
fn boundary(arch: &Arch, line: Line, given: &Given, digits: usize) -> Result<Finding, Error> {
    let sought = given.sought();
    let query = |bits| {
        let query = Query::new(arch, bits);
        Query { is_limited: query.is_limited || sought == Sought::Friction, ..query }
    };
    if *given == Given::Friction(Friction::Infinite) {
        return Err(Refused::UnlimitedFriction.into());
    }
    let few = query(FEW);
    if point_on(&few, line, sought).is_err()
        && let Ok(Some(ends)) = beyond(&few, line, sought)
    {
        return Ok(Finding::Beyond(line, ends));
    }
    Ok(in_digits(&query, digits, &sides(line, sought), |query| {
        let at = point_on(query, line, sought)?;
        Ok(place(line.modes().to_vec(), &at, sought))
    })?)
}

/// The least friction with which an arch stands at a thickness, or at the physical limit.
fn least_friction(
    arch: &Arch,
    thickness: &ExactNumber,
    is_given: bool,
    digits: usize,
) -> Result<Finding, Error> {
    let found = Inquiry::new(arch, digits, false).assess(thickness, digits, Wanted::Everything)?;
    let proved = match is_given {
        true => "it stands at this thickness with every larger friction, with none that is smaller",
        false => {
            "it stands at some thickness with every larger friction, at none with a smaller one"
        }
    };
    Ok(match found.required_friction? {
        Some(friction) => {
            let figures = vec![(Quantity::Friction, friction)];
            let (modes, proved) = (Vec::new(), defined(proved));
            Finding::Found(Found { modes, figures, proved, some_may_move: false })
        }
        None if is_given => Finding::Nothing(found.fall),
        None => Finding::Nothing(Some(Fall::Thickness)),
    })
}

/// Statement that is proved, with the meaning of its word.
fn defined(proved: &str) -> String {
    format!("{proved}; stands: {STANDS}")
}

/// Description of the two sides of a line.
fn sides(line: Line, sought: Sought) -> String {
    let [first, second] = line.modes();
    let (what, more, less) = match sought {
        Sought::Friction => ("friction", "above", "below"),
        Sought::HalfOpening => ("half opening", "below", "above"),
    };
    match second {
        Mode::Sliding => {
            format!("the only such {what}: {first} next {more} it, nothing stands {less}")
        }
        second => format!("the only such {what}: {first} next {more} it, {second} next {less}"),
    }
}

/// Quantities that are known where a state was found.
fn place(modes: Vec<Mode>, at: &Configuration<Ball>, sought: Sought) -> FoundBalls {
    let alpha = &at.half_opening.rad;
    let is_line = modes.len() > 1;
    let mut values = match sought {
        Sought::HalfOpening => vec![
            (Quantity::HalfOpening, alpha.clone()),
            (Quantity::HalfOpeningDegrees, alpha.clone() * alpha.int(180) / alpha.pi()),
        ],
        Sought::Friction => vec![(Quantity::Friction, at.friction.clone())],
    };
    if is_line {
        values.push((Quantity::Thickness, at.thickness.clone()));
    }
    values.push((Quantity::Thrust, at.thrust.clone()));
    if modes[0] != Mode::Sliding {
        values.push((Quantity::RotationJoint, at.rotation_joint.rad.clone()));
    }
    if modes.iter().any(|mode| mode.slides_inside()) {
        values.push((Quantity::SlidingJoint, at.sliding_joint.rad.clone()));
    }
    (modes, values)
}

/// Figures that a proof finds, with more bits until every digit is decided.
fn in_digits(
    query: &dyn Fn(u32) -> Query,
    digits: usize,
    proved: &str,
    proof: impl Fn(&Query) -> Result<FoundBalls, Undecided>,
) -> Result<Finding, Undecided> {
    let first = bits_of(digits) + GUARD;
    let first = first.saturating_add(bits_lost(&query(DOUBLE_DOUBLE)));
    raise(first, |bits| {
        let (modes, values) = proof(&query(bits))?;
        let figures = values.iter().map(|(of, x)| Some((*of, Figure::new(x, digits)?)));
        let Some(figures) = figures.collect::<Option<Vec<_>>>() else { return Ok(None) };
        let proved = proved.to_owned();
        Ok(Some(Finding::Found(Found { modes, figures, proved, some_may_move: false })))
    })
}
