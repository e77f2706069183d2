//! One page with the map of each weight in each plane, which says what lies under the pointer. Nothing is loaded from
//! elsewhere.
//!
//! The drawn lines and the tables are certified; what the script computes is in doubles, and the page says so.

use super::Map;
use super::policy::policy;
use super::words::{TITLES, names, verdict};
use crate::arch::SelfWeight;
use crate::atlas::Trace;
use crate::framed::FramedMap;
use crate::number::list;
use crate::plane::Plane;
use crate::problem::{Landmark, Quantity};
use crate::report::words::model;
use crate::report::{Answer, TOOL, Value};
use std::io;

const PAGE: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/page.css");
/// The function of the map, its planes, and the page around them.
const SCRIPT: &str = concat!(
    "\"use strict\";\n",
    include_str!("page/function.js"),
    include_str!("page/given.js"),
    include_str!("page/axis.js"),
    include_str!("page/frame.js"),
    include_str!("page/names.js"),
    include_str!("page/plane.js"),
    include_str!("page/page.js")
);

/// Quantities that the table of landmarks has of each.
const QUANTITIES: [Quantity; 7] = list![Quantity:
    HalfOpening FrictionAngle Friction Thickness Thrust RotationJoint SlidingJoint
];

/// The page.
pub(crate) fn html(map: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    let maps = map.drawing.framed_maps(&map.traces, &map.levels);
    let shown = maps.last().map(|map| map.weight);
    let titles = ["landmark".to_owned(), "weight".to_owned()].into_iter();
    let quantities = QUANTITIES.map(|quantity| quantity.name().replace('_', " "));
    let curve_titles = TITLES.iter().copied().chain(["pieces", "widest tube"]);
    let value = |name: &str| match name {
        "policy" => policy(STYLE, SCRIPT),
        "style" => STYLE.to_owned(),
        "script" => SCRIPT.to_owned(),
        "choices" => {
            let each_once = maps.iter().filter(|map| map.plane == Plane::ThicknessFriction);
            each_once.map(|map| choice(map.weight, shown)).collect()
        }
        "maps" => maps.iter().map(|map| figure(map, shown)).collect(),
        "landmark_titles" => cells("th", titles.clone().chain(quantities.clone())),
        "landmarks" => map.landmarks.iter().map(landmark).collect(),
        "curve_titles" => cells("th", curve_titles.clone()),
        "curves" => map.traces.iter().map(curve).collect(),
        "claim" => escaped(&verdict(map)),
        "tool" => TOOL.to_owned(),
        "command" => escaped(&map.drawing.command),
        _ => unreachable!("the template names it"),
    };
    out.write_all(filled(PAGE, value).as_bytes())
}

/// A template with a value for each name in double braces.
fn filled(template: &str, value: impl Fn(&str) -> String) -> String {
    let mut parts = template.split("{{");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once("}}").unwrap_or((part, ""));
        text += &value(name);
        text += rest;
    }
    text
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

fn cells(tag: &str, texts: impl IntoIterator<Item: AsRef<str>>) -> String {
    let cell = |text: &str| format!("<{tag}>{}</{tag}>", escaped(text));
    texts.into_iter().map(|text| cell(text.as_ref())).collect()
}

fn choice(weight: SelfWeight, shown: Option<SelfWeight>) -> String {
    let (name, checked) = (weight.name(), if shown == Some(weight) { " checked" } else { "" });
    let words = model(weight);
    format!(
        "<label><input type=\"radio\" name=\"weight\" id=\"choose-{name}\"{checked}> {words}</label>\n"
    )
}

/// A map; the names in it begin with those of its weight and plane, so that no two are the same.
fn figure(map: &FramedMap, shown: Option<SelfWeight>) -> String {
    let (weight, plane) = (map.weight.name(), map.plane.name());
    let around = serde_json::to_string(&map.around).unwrap_or_default();
    let hidden = if shown == Some(map.weight) { "" } else { " hidden" };
    let svg = map.svg.replace("id=\"", &format!("id=\"{weight}-{plane}-"));
    let svg = svg.replace("url(#", &format!("url(#{weight}-{plane}-"));
    let caption: String =
        map.caption.iter().map(|words| format!("<p>{}</p>", escaped(words))).collect();
    format!(
        "<figure data-weight=\"{weight}\" data-plane=\"{plane}\" data-around=\"{}\"{hidden}>\n{svg}\
         <figcaption class=\"note\"><button class=\"larger\">Show {} large</button>{caption}</figcaption></figure>\n",
        escaped(&around),
        axes(map.plane)
    )
}

/// Axes of a plane in words.
fn axes(plane: Plane) -> &'static str {
    match plane {
        Plane::ThicknessFriction => "thickness over friction",
        Plane::OpeningFriction => "friction over half opening",
        Plane::OpeningThickness => "thickness over half opening",
    }
}

/// The row of a landmark; of one that is undecided the reason.
fn landmark(answer: &Answer) -> String {
    let name = answer.subject.landmark().map_or("", Landmark::symbol);
    let weight = answer.subject.weight().map_or("", SelfWeight::name);
    let text = |quantity| answer.value(quantity).map(Value::text).unwrap_or_default();
    let found = match answer.reason() {
        Some(reason) => cells("td", [format!("undecided: {reason}")]),
        None => cells("td", QUANTITIES.map(text)),
    };
    format!("<tr>{}{found}</tr>\n", cells("td", [name, weight]))
}

fn curve(trace: &Trace) -> String {
    let pieces = [trace.pieces().count().to_string(), format!("{:.1e}", trace.width())];
    format!("<tr>{}</tr>\n", cells("td", names(trace).into_iter().chain(pieces)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_template_is_filled_once() {
        let value = |name: &str| format!("<{name}{{{{b}}}}>");
        assert_eq!(filled("x {{a}} y {{c}}", value), "x <a{{b}}> y <c{{b}}>");
        assert_eq!(filled("nothing", value), "nothing");
    }
}
