//! Reading from TOML to an arch that is drawn.

use super::axes::{axes, example, given, is_measured, product};
use super::drawn::{DrawnArch, Pose};
use super::schema::{ItemKind, Request, SceneDrawing};
use super::table::TableReader;
use super::value::{Entry, TomlReader, TomlValue};
use crate::arch::SelfWeight;
use crate::ask::{ArchGiven, ArchQuestion, Field, Spelling};
use crate::problem::Mode;
use crate::problem::measures::Measures;
use crate::report::{Format, Style};
use toml::de::DeValue;

/// An arch at its least thickness, at a landmark, or as it stands.
pub(super) fn drawing(table: &mut TableReader, format: Option<&'static Format>) -> Option<Request> {
    // All that is wrong is told at once.
    let [dilatant, half, arrows, animate] =
        ["dilatant", "half", "arrows", "animate"].map(|key| table.truth(key));
    let amplitude = table.or("amplitude", Style::default().amplitude, |reader, at| {
        let (least, most) = Style::AMPLITUDES.into_inner();
        reader.double(at, (Style::AMPLITUDES, &format!("{least} to {most}")))
    });
    let stones = table.if_given("stones", |reader, at| {
        let (least, most) = Style::STONES.into_inner();
        reader.whole(at, least as usize..=most as usize).map(|stones| stones as u64)
    });
    let mode = table.if_given("mode", mode);
    let weight = match table.weights(&[SelfWeight::Milankovitch]).as_deref() {
        Some([weight]) => Some(*weight),
        Some(_) => table.refuse("a drawing shows one weight"),
        None => None,
    };
    // Of what is wrong any other does, to read the rest.
    let any = weight.unwrap_or(SelfWeight::Milankovitch);
    let pose = pose(table, any, mode.flatten());
    let ((measures, pose), mode, stones, is_dilatant) = (pose?, mode?, stones?, dilatant?);
    weight?;
    let (amplitude, half, arrows, animate) = (amplitude?, half?, arrows?, animate?);
    let style = Style { amplitude, half, arrows, animate, notation: false };
    let is_svg = format.is_some_and(|format| format.name == "svg");
    let is_picture = format.is_none_or(|format| format.is_picture);
    let wrong = match &pose {
        Pose::Landmark(..) | Pose::Sliding(..) if stones.is_some() => Some(
            "stones are of an arch with half_opening and friction: a landmark, and an arch at the friction at which \
             it slides, have a joint at every angle",
        ),
        _ if style.arrows && !is_picture => {
            Some("only svg, png and pdf have arrows; leave out arrows")
        }
        _ if style.animate && !is_svg => Some("only svg moves; leave out animate"),
        Pose::Standing(..) if mode.is_some() || is_dilatant || style.animate => Some(
            "an arch as it stands does not move; leave out mode, dilatant and animate, or thickness",
        ),
        _ => None,
    };
    if let Some(message) = wrong {
        return table.refuse(message);
    }
    let drawn = DrawnArch { pose, stones, is_dilatant };
    let mut said = vec![("weight", vec![drawn.weight().name().to_owned()])];
    if let Pose::Landmark(landmark, _) = &drawn.pose {
        said.push(("at", vec![landmark.symbol().to_owned()]));
    }
    said.extend(mode.map(|mode| ("mode", vec![mode.label().to_owned()])));
    let command = table.command("couplet draw".to_owned(), ItemKind::Drawing, &said);
    let arches = vec![(drawn, mode.into_iter().collect())];
    Some(Request::Drawing(SceneDrawing { arches, style, measures, command }))
}

/// Reads the pose in which an arch is drawn, with its sizes if it is in metres.
fn pose(
    table: &mut TableReader,
    weight: SelfWeight,
    mode: Option<Mode>,
) -> Option<(Option<Measures>, Pose)> {
    let measured = is_measured(table);
    let fields = given(table);
    let has = |all: &[Field]| fields.iter().any(|(field, _)| all.contains(field));
    let has_friction = has(&[Field::Friction, Field::FrictionAngle]);
    if let Some(value) = table.get("at") {
        if measured {
            return table.refuse("a landmark has no size; leave out at, or the measures");
        }
        let is_alone = fields.is_empty();
        if !is_alone {
            let message = "a landmark has its half_opening, friction and thickness; leave them out";
            table.reader.fault(value.span(), message);
        }
        return match table.landmarks("at")?[..] {
            [landmark] if is_alone => Some((None, Pose::Landmark(landmark, weight))),
            [_] => None,
            _ => table.reader.reject(("at", value), "one of them: a drawing shows one arch"),
        };
    }
    if !has(&[Field::HalfOpening]) && !measured {
        let allowed = example(Field::HalfOpening);
        table.refuse::<()>(format!("half_opening is missing; give {allowed}, or at"));
        return if has_friction {
            None
        } else {
            table.refuse("friction (or friction_angle) is missing")
        };
    }
    if let Some((field, value)) = fields.iter().find(|(_, value)| is_several(value)) {
        let one = "one value: a drawing shows one arch";
        return table.reader.reject((field.name(), value), one);
    }
    // Without a friction of its own an arch slides at the one at which it does.
    let slides = mode == Some(Mode::Sliding) && has(&[Field::Thickness]) && !has_friction;
    let question = ArchQuestion { unlimited: slides, ..ArchQuestion::ANY };
    let axes = axes(table, Some(&question), false)?;
    let asked = product(table, axes, 1, &mut 0)?.pop()?;
    let given = table.fitting(ArchGiven::read(&question, &asked, Spelling::Key))?;
    table.remark_on(&given.friction);
    let pose = table.fitting(Pose::of(&given, weight, slides))?;
    Some((given.measures, pose))
}

/// Tells whether a key has several values, or none; boxes have their own fault.
fn is_several(value: &TomlValue) -> bool {
    match value.get_ref() {
        DeValue::Array(all) => all.len() != 1,
        DeValue::Table(range) => !range.contains_key("boxes"),
        _ => false,
    }
}

fn mode(reader: &mut TomlReader, at: Entry) -> Option<Mode> {
    reader.one_named(at, &Mode::ALL.map(Mode::label), Mode::named)
}
