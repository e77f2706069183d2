//! From TOML to arches that are drawn: any arch, or those of a figure of the paper.

use super::overall::Overall;
use super::read_arches::{frictions, product};
use super::read_numbers::{Meaning, SceneNumber, numbers};
use super::schema::{Drawn, SceneArch, SceneDrawing, What};
use super::value::{Reader, Value};
use crate::arch::SelfWeight;
use crate::problem::{Arch, Friction, Landmark, Mode};
use crate::report::words::list;
use crate::report::{Format, Style};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// The arches of a figure of the paper.
pub(super) fn arch_figure(
    reader: &mut Reader,
    span: &Range<usize>,
    (number, shown): (usize, &[(Landmark, &[Mode])]),
    weights: &[SelfWeight],
    has_tolerance: bool,
) -> Option<What> {
    let [weight] = *weights else {
        reader.fault(span.clone(), format!("figure {number} shows one weight"));
        return None;
    };
    if has_tolerance {
        let message = format!("figure {number} has no curves of the map; leave out tolerance");
        reader.fault(span.clone(), message);
        return None;
    }
    let arch = |(landmark, modes): &(Landmark, &[Mode])| {
        (Drawn::Landmark { landmark: *landmark, weight, is_dilatant: false }, modes.to_vec())
    };
    Some(What::Drawing(SceneDrawing {
        arches: shown.iter().map(arch).collect(),
        style: Style::of_figure(number),
        command: format!("couplet figure {number} --weight {}", weight.name()),
    }))
}

/// An arch at its least thickness, at a landmark, or as it stands.
pub(super) fn drawing(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
    overall: &Overall,
    format: Option<&'static Format>,
) -> Option<What> {
    let before = reader.faults.len();
    let truth = |reader: &mut Reader, key: &str| {
        table.get(key).map_or(Some(false), |value| reader.truth(key, value))
    };
    let [dilatant, half, arrows, animate] =
        ["dilatant", "half", "arrows", "animate"].map(|key| truth(reader, key));
    // All that is wrong is told at once.
    let (amplitude, stones) = (amplitude(reader, table), stones(reader, table));
    let mode = table.get("mode").map_or(Some(None), |value| mode(reader, value).map(Some));
    let weights = overall.weights(reader, table, &[SelfWeight::Milankovitch]);
    let weight = match weights.as_deref() {
        Some([weight]) => Some(*weight),
        Some(_) => {
            reader.fault(span.clone(), "a drawing shows one weight".to_owned());
            None
        }
        None => None,
    };
    // Of what is wrong any other does, to read the rest.
    let any = weight.unwrap_or(SelfWeight::Milankovitch);
    let about = (any, mode.flatten(), stones.flatten(), dilatant.unwrap_or(false));
    let drawn = arch(reader, span, table, about);
    let (drawn, mode) = (drawn?, mode?);
    weight?;
    let style = Style {
        amplitude: amplitude?,
        half: half?,
        arrows: arrows?,
        animate: animate?,
        notation: false,
    };
    let is_svg = format.is_some_and(|format| format.name == "svg");
    let is_picture = format.is_none_or(|format| format.is_picture);
    let wrong = match &drawn {
        Drawn::Landmark { .. } | Drawn::Sliding { .. } if stones?.is_some() => Some(
            "stones are of an arch with half_opening and friction: a landmark, and an arch at the friction at which it slides, \
             have a joint at every angle",
        ),
        _ if style.arrows && !is_picture => Some("only svg and png have arrows; leave out arrows"),
        _ if style.animate && !is_svg => Some("only svg moves; leave out animate"),
        Drawn::Standing { .. } if mode.is_some() || dilatant? || style.animate => Some(
            "an arch as it stands does not move; leave out mode, dilatant and animate, or thickness",
        ),
        _ => None,
    };
    if let Some(message) = wrong {
        reader.fault(span.clone(), message.to_owned());
    }
    let command = command(&drawn, mode, &style);
    let arches = vec![(drawn, mode.into_iter().collect())];
    (reader.faults.len() == before).then_some(What::Drawing(SceneDrawing {
        arches,
        style,
        command,
    }))
}

/// What is drawn.
fn arch(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
    (weight, mode, stones, is_dilatant): (SelfWeight, Option<Mode>, Option<u64>, bool),
) -> Option<Drawn> {
    let before = reader.faults.len();
    let mut given = |meaning: Meaning| Some((meaning, meaning.given(reader, table)?));
    let alpha = given(Meaning::HalfOpening);
    let eta = given(Meaning::Thickness);
    let mu = given(Meaning::Friction).or_else(|| given(Meaning::FrictionAngle));
    if let Some(value) = table.get("at") {
        if alpha.is_some() || eta.is_some() || mu.is_some() {
            let message = "a landmark has its half_opening, friction and thickness; leave them out";
            reader.fault(value.span(), message.to_owned());
        }
        let symbols = Landmark::ALL.map(|landmark| (landmark.symbol(), landmark));
        let long_names = Landmark::ALL.map(|landmark| (landmark.long_name(), landmark));
        let found = reader.names("at", value, &[symbols, long_names].concat())?;
        let landmark = one(reader, "at", value, found)?;
        let drawn = Drawn::Landmark { landmark, weight, is_dilatant };
        return (reader.faults.len() == before).then_some(drawn);
    }
    let alpha = match alpha {
        Some((_, alpha)) => single(reader, Meaning::HalfOpening, alpha),
        None => {
            let allowed = Meaning::HalfOpening.allowed();
            reader.fault(span.clone(), format!("half_opening is missing; give {allowed}, or at"));
            None
        }
    };
    let has_thickness = eta.is_some();
    let thickness = eta.map(|(meaning, value)| single(reader, meaning, value)?.number);
    if let (true, None, Some(Mode::Sliding)) = (has_thickness, &mu, mode) {
        let arch = Arch::new(weight, alpha?.number?, Friction::Infinite).ok()?;
        return Some(Drawn::Sliding { arch, thickness: thickness??, is_dilatant });
    }
    let all = frictions(reader, span, table);
    let thickness = match thickness {
        Some(thickness) => Some(thickness?),
        None => None,
    };
    let (alpha, all) = (alpha?, all?);
    let friction = match (mu, all.len()) {
        (Some((meaning, value)), many) if many != 1 => {
            reader.is_not(meaning.key(), value, "one number: a drawing shows one arch");
            return None;
        }
        _ => all.all().ok()?,
    };
    let arches = product(&[weight], &[alpha], &friction, &[thickness]);
    let SceneArch { arch, thickness } = arches.into_iter().next()?;
    Some(match thickness {
        Some(thickness) => Drawn::Standing { arch, stones, thickness },
        None => Drawn::Least { arch, stones, is_dilatant },
    })
}

/// The one number of a key.
fn single(reader: &mut Reader, meaning: Meaning, value: &Value) -> Option<SceneNumber> {
    let all = numbers(reader, meaning, value)?;
    if all.len() != 1 {
        reader.is_not(meaning.key(), value, "one number: a drawing shows one arch");
        return None;
    }
    all.all().ok()?.pop()
}

fn one<T: Copy>(reader: &mut Reader, key: &str, value: &Value, all: Vec<T>) -> Option<T> {
    if let [one] = all[..] {
        return Some(one);
    }
    reader.is_not(key, value, "one of them: a drawing shows one arch");
    None
}

fn mode(reader: &mut Reader, value: &Value) -> Option<Mode> {
    let found = value.get_ref().as_str().and_then(Mode::named);
    if found.is_none() {
        reader.is_not("mode", value, &format!("one of {}", list(Mode::ALL.map(Mode::label))));
    }
    found
}

/// A number as text or not.
fn amplitude(reader: &mut Reader, table: &DeTable) -> Option<f64> {
    let Some(value) = table.get("amplitude") else { return Some(Style::default().amplitude) };
    let text = match value.get_ref() {
        DeValue::String(text) => text.as_ref(),
        DeValue::Float(float) => float.as_str(),
        DeValue::Integer(integer) => integer.as_str(),
        _ => "",
    };
    let allowed = Style::AMPLITUDES;
    let amplitude = text.parse().ok().filter(|r| allowed.contains(r));
    if amplitude.is_none() {
        let (least, most) = allowed.into_inner();
        reader.is_not("amplitude", value, &format!("a number from {least} to {most}"));
    }
    amplitude
}

fn stones(reader: &mut Reader, table: &DeTable) -> Option<Option<u64>> {
    let Some(value) = table.get("stones") else { return Some(None) };
    let (least, most) = Style::STONES.into_inner();
    let stones = reader.whole("stones", value, least as usize..=most as usize)?;
    Some(u64::try_from(stones).ok())
}

/// The command that asks for the same.
fn command(drawn: &Drawn, mode: Option<Mode>, style: &Style) -> String {
    let mut command = match drawn {
        Drawn::Landmark { landmark, .. } => format!("couplet draw --at {}", landmark.symbol()),
        Drawn::Sliding { arch, .. } => {
            format!("couplet draw --half-opening {}", arch.half_opening())
        }
        Drawn::Least { arch, .. } | Drawn::Standing { arch, .. } => {
            format!(
                "couplet draw --half-opening {} --friction {}",
                arch.half_opening(),
                arch.friction()
            )
        }
    };
    if let Drawn::Standing { thickness, .. } | Drawn::Sliding { thickness, .. } = drawn {
        command += &format!(" --thickness {thickness}");
    }
    command += &format!(" --weight {}", drawn.weight().name());
    if let Some(mode) = mode {
        command += &format!(" --mode {}", mode.label());
    }
    if style.amplitude != Style::default().amplitude {
        command += &format!(" --amplitude {:?}", style.amplitude);
    }
    if let Drawn::Least { stones: Some(stones), .. }
    | Drawn::Standing { stones: Some(stones), .. } = drawn
    {
        command += &format!(" --stones {stones}");
    }
    for (is_asked, name) in [
        (drawn.is_dilatant(), " --dilatant"),
        (style.half, " --half"),
        (style.arrows, " --arrows"),
        (style.animate, " --animate"),
    ] {
        if is_asked {
            command += name;
        }
    }
    command
}
