//! The arc of an arch in metres: any two of half opening, span, rise and radius make it.
//!
//! Span and rise hold wherever both are given, else half opening and radius; what is given beside them has to agree, as
//! a survey rounds, and tells which of two arcs it is.

use super::asked::{ArchAsked, Field, read};
use super::question::{Misfit, Spelling};
use crate::arch::SelfWeight;
use crate::number::{DoubleBall, Enclosure, ExactNumber, Field as _, Real, decimal};
use crate::problem::measures::{
    Circle, Length, Measures, half_opening_of, of_span_and_rise, radius_at,
};
use crate::problem::{Arch, Friction};
use num_bigint::BigInt;
use num_rational::BigRational;

/// A measure beside two others is off by at most this part of what they make.
const TOLERANCE: (i32, i32) = (1, 200);

/// Half opening and radius of what is given; `alpha` is the half opening that is.
pub(super) fn arc(
    asked: &ArchAsked,
    alpha: Option<ExactNumber>,
    spelling: Spelling,
) -> Result<(Option<ExactNumber>, Option<Length>), Misfit> {
    let [span, rise, radius] =
        [Field::Span, Field::Rise, Field::Radius].map(|field| read::<Length>(asked, field));
    let (span, rise, radius) = (span?, rise?, radius?);
    let chord = [span.as_ref(), rise.as_ref()];
    let ((half_opening, size), by) = match (&alpha, chord, &radius) {
        (_, [Some(span), Some(rise)], _) => {
            (of_span_and_rise(span, rise), [Field::Span, Field::Rise])
        }
        (Some(alpha), _, Some(radius)) => {
            ((alpha.clone(), radius.clone()), [Field::HalfOpening, Field::Radius])
        }
        (Some(_), [None, None], None) => return Ok((alpha, None)),
        (Some(of), _, None) => {
            let radius = radius_at(of, chord).ok_or_else(|| inexact(asked, of, spelling))?;
            return Ok((alpha, Some(radius)));
        }
        (None, _, given) => {
            let made = given.as_ref().map_or(Ok(None), |radius| of_chord(chord, radius));
            return Ok((made?, radius));
        }
    };
    let made = near(&half_opening);
    let measures = Measures::new(Circle::Centreline, size.clone(), None);
    let [s, f] = measures.span_and_rise(&made, 0);
    let metres = |of: &Option<Length>| of.as_ref().map(|x| of_rational(x.metres()));
    for (field, given, made) in [
        (Field::HalfOpening, alpha.as_ref().map(near), made),
        (Field::Span, metres(&span), s),
        (Field::Rise, metres(&rise), f),
        (Field::Radius, metres(&radius), near(&measures.radius())),
    ] {
        let Some(given) = given.filter(|_| !by.contains(&field)) else { continue };
        let (off, most) = (given - made, made * made.ratio(TOLERANCE.0, TOLERANCE.1));
        if off.is_less_than(&most).is_proved() && (-most).is_less_than(&off).is_proved() {
            continue;
        }
        let told = match field {
            Field::Radius => size.to_string(),
            Field::HalfOpening => between(&(made.int(180) * made / made.pi()), "deg", " to "),
            _ => between(&made, " m", " to "),
        };
        let [name, one, other] = [field, by[0], by[1]].map(|field| spelling.of(field));
        let text = asked.get(field).unwrap_or_default().trim();
        let message = format!(
            "{name} {text} contradicts {one} and {other}, which make it {told}: give two of these, or what agrees to \
             0.5%"
        );
        return Err(Misfit::new(field, message));
    }
    Ok((Some(half_opening), Some(size)))
}

/// Half opening of a span or a rise of this radius, if there is one.
pub(super) fn of_chord(
    chord: [Option<&Length>; 2],
    radius: &Length,
) -> Result<Option<ExactNumber>, Misfit> {
    let field = if chord[0].is_some() { Field::Span } else { Field::Rise };
    half_opening_of(chord, radius).transpose().map_err(|error| Misfit::new(field, error))
}

fn near(x: &ExactNumber) -> DoubleBall {
    x.enclosure(0)
}

fn of_rational(x: &BigRational) -> DoubleBall {
    near(&ExactNumber::rational(x.clone()))
}

/// Refusal of a half opening and a span or a rise of which no rational radius is made, with the arches to ask about
/// instead.
fn inexact(asked: &ArchAsked, alpha: &ExactNumber, spelling: Spelling) -> Misfit {
    if let Err(error) = Arch::new(SelfWeight::Heyman, alpha.clone(), Friction::Infinite) {
        return Misfit::new(Field::HalfOpening, error);
    }
    let (place, field) = if asked.span.is_some() { (0, Field::Span) } else { (1, Field::Rise) };
    let one = Measures::new(Circle::Centreline, Length::new(BigInt::from(1).into()), None);
    let of_one = one.span_and_rise(&near(alpha), 0)[place];
    let text = asked.get(field).unwrap_or_default().trim();
    let metres = text.parse().map(|x: Length| of_rational(x.metres()));
    let radius = metres.map_or(String::new(), |x| between(&(x / of_one), "m", ".."));
    let [name, size, span, rise] =
        [field, Field::Radius, Field::Span, Field::Rise].map(|field| spelling.of(field));
    let message = format!(
        "{name} {text} and the half opening make a radius that is no exact number: give {span} and {rise}, or every \
         {size} between, {radius}"
    );
    Misfit::new(field, message)
}

/// Neighbours of six decimals between which a number above zero lies, with the word between them.
fn between(x: &DoubleBall, unit: &str, word: &str) -> String {
    const PARTS: i32 = 1_000_000;
    // An exact number is between its neighbours too.
    let below = BigInt::from((x.mid() * f64::from(PARTS) - 0.5).floor() as i64);
    let ends = [below.clone(), below + 2].map(|n| BigRational::new(n, PARTS.into()));
    let [low, high] = ends.each_ref().map(of_rational);
    match low.is_less_than(x).is_proved() && x.is_less_than(&high).is_proved() {
        true => ends.map(|end| decimal(&end) + unit).join(word),
        false => "another one".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(words: &str) -> Result<(Option<String>, Option<String>), String> {
        let asked = ArchAsked::parse(words).unwrap();
        let alpha = read(&asked, Field::HalfOpening).unwrap();
        let found = arc(&asked, alpha, Spelling::Key).map_err(|misfit| misfit.message)?;
        Ok((found.0.map(|x| x.to_string()), found.1.map(|x| x.to_string())))
    }

    /// Each pair makes the circle of the others; with a radius its arc is the flatter one unless a third tells.
    #[test]
    fn any_two_make_the_arc() {
        for (words, alpha, radius) in [
            ("span=8m; rise=2m", "2atan(1/2)", "5 m"),
            ("span=8m; radius=5m", "2atan(1/2)", "5 m"),
            ("rise=2m; radius=5m", "2atan(1/2)", "5 m"),
            ("span=8m; alpha=2atan(1/2)", "2atan(1/2)", "5 m"),
            ("rise=2m; alpha=2atan(1/2)", "2atan(1/2)", "5 m"),
            ("radius=5m; alpha=2atan(1/2)", "2atan(1/2)", "5 m"),
            ("rise=8m; radius=5m", "2atan(2)", "5 m"),
            ("span=8m; rise=8m; radius=5m", "2atan(2)", "5 m"),
            ("span=8m; alpha=2atan(2); radius=5m", "2atan(2)", "5 m"),
            ("span=10m; radius=5m", "1pi/2", "5 m"),
            ("rise=5m; radius=5m", "1pi/2", "5 m"),
            ("span=5m; radius=5m", "1pi/6", "5 m"),
            ("rise=7.5m; radius=5m", "2pi/3", "5 m"),
            ("span=5m; alpha=30deg", "30deg", "5 m"),
            ("rise=2.5m; alpha=60deg", "60deg", "5 m"),
            ("span=6m; radius=5m; rise=1m", "2atan(1/3)", "5 m"),
            ("span=3300mm; radius=1995mm", "atan(√(12100/5589))", "1.995 m"),
            ("rise=3m; radius=5m", "atan(√(21/4))", "5 m"),
            ("rise=7m; radius=5m", "pi-atan(√(21/4))", "5 m"),
            ("span=1467mm; rise=593mm; radius=750mm", "2atan(1186/1467)", "0.750144… m"),
            ("span=1467mm; rise=593mm; alpha=78deg", "2atan(1186/1467)", "0.750144… m"),
            ("alpha=78deg; radius=750mm; span=1467mm; ", "78deg", "0.75 m"),
        ] {
            assert_eq!(of(words), Ok((Some(alpha.into()), Some(radius.into()))), "{words}");
        }
    }

    #[test]
    fn what_makes_no_arc_is_told_in_decimals() {
        for (words, why) in [
            (
                "span=4m; radius=1995mm",
                "the span 4 m is too large for the radius 1.995 m: its diameter is 3.99 m",
            ),
            (
                "rise=10m; radius=5m",
                "the rise 10 m is too large for the radius 5 m: its diameter is 10 m",
            ),
            (
                "span=1467mm; rise=593mm; radius=760mm",
                "radius 760mm contradicts span and rise, which make it 0.750144… m",
            ),
            ("span=1467mm; rise=593mm; alpha=70deg", "which make it 77.907795deg to 77.907797deg"),
            (
                "alpha=90deg; radius=5m; span=9m",
                "span 9m contradicts half_opening and radius, which make it 9.999999 m to 10.000001 m",
            ),
            (
                "alpha=1; radius=5m; rise=3m",
                "which make it 2.298487 m to 2.298489 m: give two of these",
            ),
            (
                "alpha=78deg; span=1467mm",
                "give span and rise, or every radius between, 0.749886m..0.749888m",
            ),
            ("alpha=1; rise=1m", "2.175342m..2.175344m"),
        ] {
            let message = of(words).unwrap_err();
            assert!(message.contains(why), "{words}: {message}");
        }
    }
}
