//! Caption of an arch above and below its picture.

use super::Sketched;
use super::falling::Falling;
use super::metres::{Metres, Size};
use super::motion::{reached, unit};
use super::numbers::{DIGITS, FEW, shown, told};
use crate::atlas::{Bound, Collapse, Forces, Sketch, Stability, Subject};
use crate::number::{Ball, ExactNumber, Form, arctangent, degrees};
use crate::problem::asymmetric_region::STANDS;
use crate::problem::measures::Measures;
use crate::problem::{Arch, Landmark, Mode};
use crate::report::numbers::rounded;
use crate::report::words;

/// Description of how a mode falls, in a few words.
fn falls(mode: Mode) -> &'static str {
    match mode {
        Mode::Rotational => "shoulder, haunch and crown open",
        Mode::SlidingRotational => "the shoulder slides, haunch and crown open",
        Mode::RotationalSliding => "shoulder and haunch open, a joint above the haunch slides",
        Mode::RotationalSlidingRotational => {
            "shoulder and haunch open, a joint between them slides"
        }
        Mode::OverturningSliding => "shoulder and crown open, a joint between them slides",
        Mode::Overturning => "the half arch turns about the shoulder, without thrust",
        Mode::Sliding => "the shoulder slides outwards, an inner joint inwards",
    }
}

/// A mode as it is named there: at S one joint opens and slides.
pub(super) fn name(sketch: &Sketch, mode: Mode) -> (&'static str, &'static str) {
    match (&sketch.subject, mode) {
        (Subject::Landmark(Landmark::Shift), Mode::RotationalSliding) => {
            ("[r,r+s]", "the shoulder opens, one inner joint opens and slides")
        }
        (_, Mode::Rotational) if has_keystone(sketch) => {
            (mode.label(), "shoulder, haunch and the joint beside the keystone open")
        }
        (_, Mode::SlidingRotational) if has_keystone(sketch) => {
            (mode.label(), "the shoulder slides, haunch and the joint beside the keystone open")
        }
        _ => (mode.label(), falls(mode)),
    }
}

fn has_keystone(sketch: &Sketch) -> bool {
    sketch.stones.as_ref().is_some_and(|stones| !stones.has_joint_at_crown())
}

/// The heading of a panel: the mode or the verdict, and what that means.
pub(super) fn title(sketch: &Sketch, collapse: Option<&Collapse>) -> [String; 2] {
    let is_dilatant = collapse.is_some_and(|collapse| collapse.is_dilatant);
    let rule = if is_dilatant { ", associated flow rule" } else { "" };
    let fails = |of| format!("{}{}", fails(of), at_joints(sketch, " at its joints"));
    match (collapse, &sketch.subject) {
        (Some(collapse), Subject::Standing { stability, .. }) => {
            let falls = format!("does not stand: falls as {}{rule}", collapse.mode.label());
            [falls, fails(stability)]
        }
        (Some(collapse), _) => {
            let (label, falls) = name(sketch, collapse.mode);
            let place = match &sketch.subject {
                Subject::Landmark(landmark) => format!(" at {}", words::symbol(*landmark)),
                _ => String::new(),
            };
            [format!("{label}{place}{rule}"), falls.to_owned()]
        }
        (None, Subject::Standing { stability, .. }) => match stability.stands {
            true => [
                "stands".into(),
                "its lines of thrust, from the least thrust to the largest".into(),
            ],
            false => ["does not stand".into(), fails(stability)],
        },
        (None, _) => [String::new(), String::new()],
    }
}

/// Name of the condition that an arch that does not stand fails.
fn fails(stability: &Stability) -> &'static str {
    match &stability.required_friction {
        None => "no line of thrust lies within it",
        Some(_) => "lines of thrust lie within it, none keeps within friction",
    }
}

/// Heading that says what the picture shows, for those who do not see it.
pub(super) fn heading(drawn: &Sketched) -> String {
    let all: Vec<String> = drawn
        .sketches
        .iter()
        .map(|sketch| subject(sketch, drawn.metres(sketch).as_ref()))
        .collect();
    all.join("; ")
}

/// Description of what is drawn.
fn subject(sketch: &Sketch, metres: Option<&Metres>) -> String {
    let model = words::model(sketch.weight);
    let shape = |arch: &Arch| shape(arch, sketch, metres);
    let eta = |given: &ExactNumber| {
        metres.map_or(given.to_string(), |of| told(of, &of.thickness, DIGITS))
    };
    match &sketch.subject {
        Subject::Landmark(landmark) => {
            format!("{} {}, {model}", words::capital(landmark.name()), words::symbol(*landmark))
        }
        Subject::Least(arch) | Subject::Standing { arch, is_chosen: true, .. } => {
            format!("Arch of {}, friction {}, {model}", shape(arch), arch.friction())
        }
        Subject::Standing { arch, thickness, .. } => format!(
            "Arch of {}, friction {}, thickness {}, {model}",
            shape(arch),
            arch.friction(),
            eta(thickness)
        ),
        Subject::Sliding { arch, thickness } => format!(
            "Arch of {}, thickness {}, {model}, at the friction at which it slides",
            shape(arch),
            eta(thickness)
        ),
    }
}

/// The half opening; in metres what it follows from.
fn shape(arch: &Arch, sketch: &Sketch, metres: Option<&Metres>) -> String {
    let given = arch.half_opening();
    let alpha = match given.form() {
        Form::TwiceArctangent | Form::ArctangentOfRoot => {
            format!("{}°", rounded(&degrees(&sketch.at.half_opening.rad), DIGITS))
        }
        _ => given.to_string(),
    };
    let stones = sketch.stones.as_ref().map(|stones| format!("{}, ", words::division(stones)));
    let stones = stones.unwrap_or_default();
    match metres {
        Some(of) => format!(
            "{stones}span {} and rise {} at its {}, half opening {alpha}",
            told(of, &of.span, DIGITS),
            told(of, &of.rise, DIGITS),
            of.circle.name()
        ),
        None => format!("{stones}half opening {alpha}"),
    }
}

/// Values known in units of length and in kilonewtons beyond the span and the rise.
fn sizes(sketch: &Sketch, measures: &Measures, of: &Metres) -> String {
    let size = |size: &Size| shown(size, DIGITS);
    let [radius, thickness] = [&of.radius, &of.thickness].map(|size| told(of, size, DIGITS));
    let mut said = format!(" Sizes: r = {radius}, t = {thickness}");
    if let Subject::Standing { stability, .. } = &sketch.subject
        && let Some(least) = &stability.least_thickness
    {
        let least = told(of, &Metres::thickness_of(measures, sketch, least), DIGITS);
        said += &format!(", least t = {least}");
    }
    let Some(loads) = &of.loads else { return said + "." };
    said += &format!(
        ". In kN: weight of the arch {}, on each shoulder V = {}",
        size(&loads.weight),
        size(&loads.reaction)
    );
    let thrust = |of: &Forces| size(&loads.thrust(&of.thrust));
    let is_standing = sketch.stands();
    said += &match &sketch.forces[..] {
        [] => String::new(),
        // One of many with which it falls.
        [_] if sketch.falls() => String::new(),
        [one] if is_standing => format!(", thrust H = hwr = {} or more", thrust(one)),
        [one] => format!(", thrust H = hwr = {}", thrust(one)),
        [least, largest, ..] => {
            format!(", thrust H = hwr from {} to {}", thrust(least), thrust(largest))
        }
    };
    said + "."
}

/// Meaning of the symbols of Figure 1.
const SYMBOLS: &str = "α half opening; βᵣ and βₛ rotational and sliding inner joint, from the crown; r radius of the \
                       centreline, t thickness, η = t/r; w = γtd weight of a unit length of the centreline, for the \
                       weight γ of a unit volume and the depth d; μ = tan φ friction; W = wrα weight of the half \
                       arch, V and H reactions of the shoulder, H also the thrust at the crown, h = H/(wr). The \
                       weight of an element acts at its centroid G, at the radius r(1 + η²/12), in the \
                       Milankovitch-like model, on the centreline in the Heyman-like one.";

/// The paragraphs below.
pub(super) fn paragraphs(drawn: &Sketched) -> Vec<String> {
    if !drawn.between.is_empty() {
        return along(drawn);
    }
    let [short, more] = [0, 1].map(|k| -> Vec<String> {
        drawn.sketches.iter().map(|sketch| said(drawn, sketch)[k].trim().to_owned()).collect()
    });
    let mut all = vec![short.join(" ")];
    all.extend(more.into_iter().filter(|words| !words.is_empty()));
    let has = |is: fn(&Sketch) -> bool| drawn.sketches.iter().any(is);
    if drawn.style.notation {
        all.push(SYMBOLS.to_owned());
    }
    if has(Sketch::falls) {
        all.extend(
            drawn.sketches.iter().filter_map(Falling::of).flat_map(|of| of.paragraphs(drawn)),
        );
    } else if has(|sketch| !sketch.collapses.is_empty()) {
        let is_sliding = has(|sketch| matches!(sketch.subject, Subject::Sliding { .. }));
        let is_landmark = has(|sketch| matches!(sketch.subject, Subject::Landmark(_)));
        // A landmark has more joints at their limits than one of its modes moves.
        let lines = match (is_sliding, is_landmark) {
            (true, _) => "nothing stands with less friction",
            _ if has(|sketch| sketch.stones.is_some()) => {
                "the conditions hold at every joint between the stones, where the lines have their points, none thinner"
            }
            (_, true) => {
                "the lines within the arch and on its faces only at joints that give way in one of the modes there, \
                 none thinner"
            }
            _ => {
                "the lines within the arch and on its faces only at the joints that give way, none thinner"
            }
        };
        all.push(format!(
            "Proved: one solution of the equations, {lines}; every rate of a mechanism is positive. Blocks are moved \
             rigidly, the corner that moves most by {}.",
            reached(drawn)
        ));
    }
    all.push(format!("Command: {}", drawn.command));
    all
}

/// The frictions between which an arch collapses as it is drawn, in words.
pub(super) fn between(drawn: &Sketched, place: usize) -> Option<String> {
    let [from, to] = drawn.between.get(place)?;
    let few = |x: &Ball| rounded(x, DIGITS);
    Some(match (from, to) {
        (Some(from), Some(to)) => format!("friction {} to {}", few(from), few(to)),
        (Some(from), None) => format!("friction {} and more", few(from)),
        (None, Some(to)) => format!("friction below {}", few(to)),
        (None, None) => "all frictions looked at".to_owned(),
    })
}

/// The paragraphs below the modes of one half opening.
fn along(drawn: &Sketched) -> Vec<String> {
    let one = |(place, sketch): (usize, &Sketch)| {
        let [said, _] = said(drawn, sketch);
        format!("{}: {said}", words::capital(&between(drawn, place).unwrap_or_default()))
    };
    let shape = drawn.sketches.first().map(|sketch| {
        let alpha = rounded(&degrees(&sketch.at.half_opening.rad), DIGITS);
        format!(
            "How arches of half opening {alpha}° fall as their friction grows, {}.",
            words::model(sketch.weight)
        )
    });
    let mut all: Vec<String> = shape.into_iter().collect();
    all.extend(drawn.sketches.iter().enumerate().map(one));
    all.push(format!(
        "Proved: the frictions at which the mode changes, and each arch as above. Blocks are moved rigidly, the corner \
         that moves most by {}.",
        reached(drawn)
    ));
    all.push(format!("Command: {}", drawn.command));
    all
}

/// Statement of what is drawn and how safe it is, and all else that is known of it.
fn said(drawn: &Sketched, sketch: &Sketch) -> [String; 2] {
    let metres = drawn.metres(sketch);
    let said = subject(sketch, metres.as_ref());
    let sizes =
        drawn.measures.as_ref().zip(metres).map(|(measures, of)| sizes(sketch, measures, &of));
    let sizes = sizes.unwrap_or_default();
    if let Subject::Standing { stability, asymmetric, thickness, is_chosen, .. } = &sketch.subject {
        let of_stones = sketch.stones.as_ref().filter(|_| stability.stands && sketch.is_limited);
        let may_move = words::may_move(asymmetric).or(of_stones.map(words::stones_may_move));
        let may_move = may_move.map_or(String::new(), |all| format!(" {}.", words::capital(&all)));
        let chosen = match is_chosen {
            true => format!(" It is drawn with t/r = {thickness}."),
            false => String::new(),
        };
        let [verdict, more] = standing(stability, sketch);
        return [format!("{said}. {verdict}.{chosen}"), more + &may_move + &sizes];
    }
    let values: Vec<String> = values(sketch).collect();
    let falls = |collapse: &Collapse| {
        let is_alone =
            sketch.collapses.len() == 1 && !matches!(sketch.subject, Subject::Landmark(_));
        let start = if is_alone { "It falls as " } else { "" };
        format!(" {start}{}", balance(sketch, collapse))
    };
    let falls = sketch.collapses.iter().map(falls).collect::<String>();
    let short = format!("{said}. {}.", words::capital(&values.join(", ")));
    [short, sizes + &falls + &relation(sketch)]
}

/// The numbers of a state.
fn values(sketch: &Sketch) -> impl Iterator<Item = String> + '_ {
    let at = &sketch.at;
    let angle = |symbol: &str, x: &Ball| format!("{symbol} = {}°", rounded(&degrees(x), DIGITS));
    let is_sliding = matches!(sketch.subject, Subject::Sliding { .. });
    let is_landmark = matches!(sketch.subject, Subject::Landmark(_));
    let has = |of: fn(Mode) -> bool| sketch.collapses.iter().any(|c| of(c.mode));
    let friction = match sketch.is_limited {
        true => format!(
            "friction μ = {} (φ = {}°)",
            rounded(&at.friction, DIGITS),
            rounded(&degrees(&arctangent(&at.friction)), FEW)
        ),
        false => "unlimited friction".into(),
    };
    [
        (!is_sliding)
            .then(|| format!("least thickness η = t/r = {}", rounded(&at.thickness, DIGITS))),
        is_landmark.then(|| angle("half opening α", &at.half_opening.rad)),
        (is_landmark || is_sliding).then_some(friction),
        Some(format!("thrust h = H/(wr) = {}", rounded(&at.thrust, DIGITS))),
        has(Mode::has_haunch).then(|| angle("βᵣ", &at.rotation_joint.rad)),
        has(Mode::slides_inside).then(|| angle("βₛ", &at.sliding_joint.rad)),
    ]
    .into_iter()
    .flatten()
}

/// Statement of how the crown moves, and what takes the power.
fn balance(sketch: &Sketch, collapse: &Collapse) -> String {
    let (label, _) = name(sketch, collapse.mode);
    let drop = collapse.crown_drop.mid().to_f64();
    let crown = if drop < 0.0 { "rises" } else { "goes down" };
    let slides = collapse.mechanism.joints.iter().any(|joint| !joint.contact.is_hinge());
    let taken = match (slides, collapse.is_dilatant) {
        (false, _) => "the weight does no work".to_owned(),
        (true, true) => "the weight does no work, as joints open where they slide".to_owned(),
        (true, false) => {
            let power = rounded(&collapse.friction_power, FEW);
            format!(
                "friction takes the power of the weight, {power} wr for {}",
                unit(collapse.mode)
            )
        }
    };
    format!("{label}: the crown {crown}, {taken}.")
}

/// At T the four mechanisms have one relation.
fn relation(sketch: &Sketch) -> String {
    let rate = |mode: Mode| {
        let found = sketch.collapses.iter().find(|collapse| collapse.mode == mode);
        found.and_then(|collapse| collapse.mechanism.joints.first()).map(|joint| &joint.rate)
    };
    let is_dilatant = sketch.collapses.iter().any(|collapse| collapse.is_dilatant);
    match (&sketch.subject, rate(Mode::SlidingRotational), rate(Mode::Rotational)) {
        (Subject::Landmark(Landmark::Triple), Some(a), Some(c))
            if sketch.collapses.len() == 4 && !is_dilatant =>
        {
            let [a, c] = [a, c].map(|x| rounded(x, DIGITS));
            format!(" The four depend on each other: [r,r,r] + {a} [s,s] = [s,r,r] + {c} [r,r,s].")
        }
        _ => String::new(),
    }
}

/// The safety of an arch as it stands, in words, and what else is known of its lines.
fn standing(found: &Stability, sketch: &Sketch) -> [String; 2] {
    let six = |x: &Option<Ball>| x.as_ref().map(|x| rounded(x, DIGITS));
    let few = |x: &Option<Ball>| x.as_ref().map(|x| rounded(x, FEW));
    let (least, required) = (six(&found.least_thickness), six(&found.required_friction));
    if !found.stands {
        let said = match (least, found.fall) {
            (_, Some(fall)) => format!("It stands at no thickness: {}", fall.reason()),
            (Some(least), _) => {
                format!("It does not stand: it is thinner than the least, t/r = {least}")
            }
            _ => "It does not stand".into(),
        };
        let more =
            required.map(|of| format!("; with its thickness it asks for a friction of {of}"));
        return [format!("{said}{}, which is proved", more.unwrap_or_default()), String::new()];
    }
    let mut said = format!("It stands, which is proved: {STANDS}");
    if let (Some(least), Some(safety)) = (least, few(&found.geometric_safety)) {
        said += &format!("; its thickness is {safety} times the least, t/r = {least}");
    }
    if let Some(required) = required {
        said += &match few(&found.friction_safety) {
            Some(times) => format!(", its friction {times} times what it asks for, {required}"),
            None => format!("; it asks for a friction of {required}"),
        };
    }
    let end = |Bound { thrust, by }: &Bound| match thrust {
        Some(thrust) => format!("{} ({by})", rounded(thrust, DIGITS)),
        None => "any size".into(),
    };
    let mut more = String::new();
    if let [Some(least), Some(largest)] =
        found.thrust.each_ref().map(|bound| bound.as_ref().map(end))
    {
        more += &format!("Its thrust h = H/(wr) is from {least} to {largest}.");
    }
    let several = |forces: &Forces| forces.marks.iter().any(|mark| !mark.contact.is_hinge());
    if sketch.forces.iter().any(several) {
        more += " Where friction limits the thrust, several lines of thrust fit: drawn is the highest at the crown \
                 for the least thrust, the lowest for the largest.";
    }
    more += at_joints(
        sketch,
        " The conditions hold at the joints between stones, where it can open and slide.",
    );
    [said, more]
}

/// Words for an arch of stones; none for another.
fn at_joints<'a>(sketch: &Sketch, words: &'a str) -> &'a str {
    if sketch.stones.is_some() { words } else { "" }
}
