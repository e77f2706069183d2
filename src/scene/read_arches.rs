//! From TOML to arches: every half opening with every friction, thickness and weight.

use super::number::{Given, Meaning, Numbers};
use super::read::Overall;
use super::schema::{AskedArch, MAX_ARCH_DIGITS, MAX_ARCHES, What};
use super::value::Reader;
use crate::arch::SelfWeight;
use crate::number::{ExactNumber, ParseExactError};
use crate::problem::{Arch, Friction};
use crate::report::{ASSESS_VALUES, STATE_VALUES};
use std::ops::Range;
use toml::de::DeTable;

impl<'s> Reader<'s> {
    /// An item of arches; `used` counts the arches of all items.
    pub fn arches(
        &mut self,
        span: &Range<usize>,
        table: &DeTable<'s>,
        overall: &Overall,
        used: &mut usize,
    ) -> Option<What> {
        let with_thickness = table.contains_key("thickness");
        let weights = self.item_weights(table, overall, &[SelfWeight::Milankovitch]);
        let half_openings = match table.get("half_opening") {
            Some(value) => self.numbers(Meaning::HalfOpening, value),
            None => {
                let allowed = Meaning::HalfOpening.allowed();
                self.fault(span.clone(), format!("half_opening is missing; give {allowed}"));
                None
            }
        };
        let frictions = self.frictions(span, table);
        let thicknesses = match table.get("thickness") {
            Some(value) => self.numbers(Meaning::Thickness, value).map(Some),
            None => Some(None),
        };
        let names: &[&'static str] = if with_thickness { &ASSESS_VALUES } else { &STATE_VALUES };
        let known: Vec<(&'static str, &'static str)> = names.iter().map(|&n| (n, n)).collect();
        let asked = match table.get("quantities") {
            Some(value) => self.names("quantities", value, &known),
            None => Some(names.to_vec()),
        };
        let digits = self.arch_digits(span, table, overall);
        let (weights, half_openings, (meaning, frictions)) = (weights?, half_openings?, frictions?);
        let (thicknesses, asked, digits) = (thicknesses?, asked?, digits?);
        let thickness_count = thicknesses.as_ref().map_or(1, Numbers::len);
        let count = [weights.len(), half_openings.len(), frictions.len(), thickness_count]
            .into_iter()
            .fold(1usize, usize::saturating_mul);
        if count > MAX_ARCHES - *used {
            let before = if *used > 0 { format!(" after {used} before") } else { String::new() };
            let message =
                format!("{count} arches{before} are too many; a scene has at most {MAX_ARCHES}");
            self.fault(span.clone(), message);
            return None;
        }
        *used += count;
        let mut written = |numbers: Numbers| {
            let fault = |error: ParseExactError| self.fault(span.clone(), error.to_string());
            numbers.all().map_err(fault).ok()
        };
        let (half_openings, frictions) = (written(half_openings)?, written(frictions)?);
        let thicknesses = match thicknesses {
            Some(numbers) => written(numbers)?.into_iter().map(|given| given.number).collect(),
            None => vec![None],
        };
        let arches = product(&weights, &half_openings, (meaning, &frictions), &thicknesses);
        let quantities = names.iter().copied().filter(|name| asked.contains(name)).collect();
        Some(What::Arches { arches, quantities, with_thickness, digits })
    }

    fn frictions(
        &mut self,
        span: &Range<usize>,
        table: &DeTable<'s>,
    ) -> Option<(Meaning, Numbers)> {
        let given = [Meaning::Friction, Meaning::FrictionAngle].map(|meaning| {
            let value = table.get(meaning.key())?;
            Some((meaning, value.span(), self.numbers(meaning, value)))
        });
        match given {
            [Some(_), Some((_, angle, _))] => {
                self.fault(angle, "friction_angle besides friction; give one of them".to_owned());
                None
            }
            [Some((meaning, _, numbers)), None] | [None, Some((meaning, _, numbers))] => {
                Some((meaning, numbers?))
            }
            [None, None] => {
                let (mu, phi) = (Meaning::Friction.allowed(), Meaning::FrictionAngle.allowed());
                let message = format!("friction is missing; give {mu}, or friction_angle, {phi}");
                self.fault(span.clone(), message);
                None
            }
        }
    }

    fn arch_digits(
        &mut self,
        span: &Range<usize>,
        table: &DeTable<'s>,
        overall: &Overall,
    ) -> Option<usize> {
        match table.get("digits") {
            Some(value) => self.whole("digits", value, 1..=MAX_ARCH_DIGITS),
            None if overall.digits > MAX_ARCH_DIGITS => {
                let message = format!(
                    "the scene's {} digits are too many for arches; give this item digits of its own, 1 \
                     to {MAX_ARCH_DIGITS}",
                    overall.digits
                );
                self.fault(span.clone(), message);
                None
            }
            None => Some(overall.digits),
        }
    }
}

/// Every weight with every half opening, friction and thickness, in this order.
fn product(
    weights: &[SelfWeight],
    half_openings: &[Given],
    (meaning, frictions): (Meaning, &[Given]),
    thicknesses: &[Option<ExactNumber>],
) -> Vec<AskedArch> {
    let mut arches = Vec::new();
    for &weight in weights {
        for half_opening in half_openings.iter().filter_map(|given| given.number.as_ref()) {
            for friction in frictions {
                let (friction, text) = in_words(meaning, friction);
                // Each number was found to be in its range.
                let Ok(arch) = Arch::new(weight, half_opening.clone(), friction) else { continue };
                arches.extend(thicknesses.iter().map(|thickness| AskedArch {
                    arch: arch.clone(),
                    friction: text.clone(),
                    thickness: thickness.clone(),
                }));
            }
        }
    }
    arches
}

/// A friction and how it is shown.
fn in_words(meaning: Meaning, given: &Given) -> (Friction, String) {
    match (&given.number, meaning) {
        (None, _) => (Friction::Infinite, given.text.clone()),
        (Some(phi), Meaning::FrictionAngle) => {
            (Friction::Angle(phi.clone()), format!("tan({phi})"))
        }
        (Some(mu), _) => (Friction::Coefficient(mu.clone()), given.text.clone()),
    }
}
