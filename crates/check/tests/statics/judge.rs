//! The claim of a certificate, judged by statics alone.

use super::ball::Ball;
use super::decide::{Arch, Decided, Joints};
use super::file::{File, dyadic, text};
use super::ring::{Contact, Joint, Load, Ring};
use rug::Integer;
use serde_json::Value;

pub(crate) type Judged = Result<(), String>;

fn require(holds: bool, what: impl FnOnce() -> String) -> Judged {
    if holds { Ok(()) } else { Err(what()) }
}

/// Arches in a row, of which those on one side stand.
pub(crate) struct Row<'a> {
    pub(crate) arch: &'a dyn Fn(&Ball) -> Arch,
    /// Those of larger numbers stand.
    pub(crate) upwards: bool,
}

/// The last arch that does not stand and the first that does, next to each other; joints that decide there.
pub(crate) struct Border {
    pub(crate) falls: Ball,
    pub(crate) stands: Ball,
    pub(crate) joints: Joints,
}

impl Row<'_> {
    fn decide(&self, at: &Ball, hints: &[(Contact, Ball)]) -> Result<Decided, String> {
        (self.arch)(at).decide(hints)
    }

    /// Border between these ends, which the statics have to find on its two sides, as near as asked.
    pub(crate) fn border(
        &self,
        ends: [Ball; 2],
        hints: &[(Contact, Ball)],
        shifts: u32,
    ) -> Result<Border, String> {
        let [mut falls, mut stands] = ends;
        if !self.upwards {
            std::mem::swap(&mut falls, &mut stands);
        }
        let width = |a: &Ball, b: &Ball| Integer::from(&b.mid - &a.mid).abs();
        let enough = width(&falls, &stands) >> shifts;
        let [mut below, mut above] = [self.decide(&falls, hints)?, self.decide(&stands, hints)?];
        require(!below.stands, || "an arch stands beyond the border".into())?;
        require(above.stands, || "an arch does not stand before the border".into())?;
        for round in 0..200 {
            let apart = Integer::from(&stands.mid - &falls.mid);
            if apart.clone().abs() <= enough {
                let joints = below.joints;
                return Ok(Border { falls, stands, joints });
            }
            let hints = hints_of(&below.joints);
            let room = Integer::from(&above.room - &below.room);
            let step = match round % 4 {
                3 => apart.clone() >> 1,
                _ => (-below.room.clone() * &apart) / room,
            };
            for side in [-1, 1] {
                let next = Integer::from(&falls.mid + &step) + (apart.clone() >> 16u32) * side;
                let next = falls.at(next);
                // What was found on the way may lie beyond already.
                if [&falls, &stands].iter().any(|end| width(&next, end) > apart.clone().abs()) {
                    continue;
                }
                let decided = self.decide(&next, &hints)?;
                let nearer = match decided.stands {
                    true => width(&falls, &next) < width(&falls, &stands),
                    false => width(&stands, &next) < width(&falls, &stands),
                };
                match decided.stands {
                    true if nearer => (stands, above) = (next, decided),
                    false if nearer => (falls, below) = (next, decided),
                    _ => {}
                }
            }
            if width(&falls, &stands) == apart.abs() {
                return Err("the border is not found more closely".into());
            }
        }
        Err("no end of halving".into())
    }
}

fn hints_of(joints: &Joints) -> Vec<(Contact, Ball)> {
    joints.iter().map(|(contact, joint)| (*contact, joint.at.clone())).collect()
}

/// Forces of the one state on a border, and its arch.
pub(crate) struct Forces {
    arch: Arch,
    pub(crate) thrust: Ball,
    moment: Option<Ball>,
}

impl Forces {
    /// What joints on a border leave of thrust and moment.
    pub(crate) fn new(arch: Arch, joints: &Joints) -> Result<Self, String> {
        let [Some(low), Some(high)] = arch.thrusts(joints) else {
            return Err("the thrust is not bounded".into());
        };
        require(low <= high, || "the joints leave no thrust".into())?;
        let thrust = arch.half_opening.at(low).hull(&arch.half_opening.at(high));
        let (mut low, mut high): (Option<Integer>, Option<Integer>) = (None, None);
        for (contact, joint) in joints.iter().filter(|(contact, _)| !contact.slides()) {
            let [slope, _, rest] = arch.ring.row(*contact, joint);
            let end = &(&slope * &thrust) + &rest;
            match contact {
                Contact::Intrados => low = low.max(Some(-end.high())),
                _ => high = Some(high.map_or(end.high(), |x| x.min(end.high()))),
            }
        }
        let moment = low.zip(high).map(|(a, b)| thrust.at(a).hull(&thrust.at(b)));
        Ok(Self { arch, thrust, moment })
    }

    /// Slope of the room along the arch: a value alone would do that the forces give but roughly.
    fn slope(&self, contact: Contact, at: &Ball) -> Ball {
        let (zero, one) = (at.int(0), at.int(1));
        let moment = self.moment.as_ref().unwrap_or(&zero);
        let load = Load { thrust: &self.thrust, moment, vertical: &zero, weight: &one };
        self.arch.ring.room(contact, &Joint::new(at), &load, 1)
    }

    /// The room is least between the ends of a value.
    fn touches(&self, file: &File, quantity: &str, contact: Contact) -> Judged {
        let Some(ends) = file.value(quantity) else { return Ok(()) };
        let [falls, rises] = ends.each_ref().map(|at| self.slope(contact, at));
        require(falls.is_negative() && rises.is_positive(), || {
            let [a, b] = [falls, rises].map(|x| x.rational().to_f64());
            format!("{quantity}: the room of {contact:?} does not turn there: {a:e}, {b:e}")
        })
    }
}

/// Joints that give way in a mode, from the crown to the shoulder.
fn contacts(mode: &str, [zero, beta, sliding, alpha]: [&Ball; 4]) -> Option<Vec<(Contact, Ball)>> {
    use Contact::*;
    let crown = (Extrados, zero.clone());
    let inner = (Intrados, beta.clone());
    let turns = (Extrados, alpha.clone());
    let slips = (Inwards, sliding.clone());
    Some(match mode {
        "[r,r,r]" => vec![crown, inner, turns],
        "[s,r,r]" => vec![crown, inner, (Outwards, alpha.clone())],
        "[r,r,s]" | "[r,s,r]" | "[r,s]" => vec![inner, slips, turns],
        "[r]" => vec![crown, inner, turns],
        _ => return None,
    })
}

fn joints_of(contacts: &[(Contact, Ball)]) -> Joints {
    contacts.iter().map(|(contact, at)| (*contact, Joint::new(at))).collect()
}

/// Judges a certificate in so many bits. What is true may want more of them; what is judged right is.
fn judge_with(json: &Value, bits: u32) -> Judged {
    let file = File::new(json, bits);
    let claim = json["claim"].as_object().expect("an object");
    let given = |key: &str| claim.get(key).filter(|x| !x.is_null());
    if let Some(state) = given("state") {
        state_of(&file, state)?;
    } else if let Some(thin) = given("too_thin") {
        let eta = file.number(text(&thin["thickness"]));
        let border = state_of(&file, thin)?;
        require((&border.falls - &eta).is_not_negative(), || "it is as thick as the least".into())?;
        let decided = arch_of(&file, thin, &eta)?.decide(&hints_of(&border.joints))?;
        require(!decided.stands, || "it stands".into())?;
    } else if let Some(slides) = given("slides") {
        slides_of(&file, slides)?;
    } else if let Some(wide) = given("too_wide") {
        too_wide_of(&file, wide)?;
    } else if let Some(stands) = given("stands") {
        let arch = arch_of(&file, stands, &file.number(text(&stands["thickness"])))?;
        let forces =
            ["thrust", "crown_moment"].map(|key| Ball::new(&dyadic(text(&stands[key])), bits));
        require(arch.bears(&forces), || "some joint does not bear the forces".into())?;
        // Where the checker looked is no claim.
        file.value("rotation_joint");
    } else {
        return Err("nothing here judges it".into());
    }
    file.all_judged()
}

/// Judges a certificate, with more bits where these do not show it.
pub(crate) fn judge(json: &Value) -> Judged {
    let mut said = String::new();
    for factor in [1, 2, 4] {
        match judge_once(json, factor) {
            Ok(()) => return Ok(()),
            Err(why) => said = why,
        }
    }
    Err(said)
}

/// The same with a factor of the bits that an arch of its size and digits mostly wants.
pub(crate) fn judge_once(json: &Value, factor: u32) -> Judged {
    let digits = json["digits"].as_u64().expect("a number") as u32;
    let file = File::new(json, 1024);
    let subject = json["claim"].as_object().expect("an object").values();
    let alpha = subject.filter_map(|x| x["half_opening"].as_str()).next();
    let size = alpha.map_or(1024, |alpha| file.number(alpha).mid.significant_bits());
    judge_with(json, factor * (160 + 5 * digits + 12 * 1024u32.saturating_sub(size)))
}

fn arch_of(file: &File, given: &Value, eta: &Ball) -> Result<Arch, String> {
    let half_opening = file.number(text(&given["half_opening"]));
    require(
        half_opening.is_positive() && (&half_opening.pi() - &half_opening).is_positive(),
        || "no arch".into(),
    )?;
    let friction = file.friction(text(&given["friction"]));
    Ok(Arch { ring: Ring::new(file.true_centroids(), eta, friction), half_opening })
}

/// The state of an arch: it stands from its thickness on, and its mode moves there.
fn state_of(file: &File, state: &Value) -> Result<Border, String> {
    const CLOSER: u32 = 40;
    let mode = text(&state["mode"]);
    let arch = |eta: &Ball| arch_of(file, state, eta).expect("an arch");
    let ends = file.value("thickness").ok_or("no thickness is stated")?;
    let half_opening = arch_of(file, state, &ends[0])?.half_opening;
    let zero = half_opening.int(0);
    let [beta, sliding] = ["rotation_joint", "sliding_joint"]
        .map(|unknown| file.hint(unknown).unwrap_or_else(|| zero.clone()));
    let giving = contacts(mode, [&zero, &beta, &sliding, &half_opening]).ok_or("no such mode")?;
    if !matches!(mode, "[r,s]" | "[r]") {
        require(beta.is_positive(), || "no haunch".into())?;
    }
    let row = Row { arch: &arch, upwards: true };
    // The mechanism of the mode, whose weight does work in a thinner arch.
    let unit = &ends[1] - &ends[0];
    let thinner = arch(&(&ends[0] - &unit));
    let known = thinner.ring.contacts();
    require(giving.iter().all(|(contact, _)| known.contains(contact)), || "nothing slides".into())?;
    let rows: Vec<[Ball; 3]> =
        joints_of(&giving).iter().map(|(c, joint)| thinner.ring.row(*c, joint)).collect();
    let [x, y, z] = &rows[..] else { unreachable!("three joints") };
    require(super::decide::contradict([x, y, z]), || {
        format!("{mode} does not move at its joints")
    })?;
    let border = row.border(ends.clone(), &giving, CLOSER)?;
    // The forces on the border, and where they touch it.
    let eta = border.falls.hull(&border.stands);
    let joints = [joints_of(&giving), border.joints.clone()].concat();
    let forces = Forces::new(arch(&eta), &joints)?;
    let [low, high] = [forces.thrust.low(), forces.thrust.high()].map(|x| eta.at(x));
    if mode == "[r]" {
        require(file.says("thrust", "0") && file.says("intrinsic_thrust", "0"), || {
            "a thrust".into()
        })?;
        require(low.mid <= 0 && Integer::from(&high.mid << CLOSER) < eta.mid, || {
            "the thrust is not zero".into()
        })?;
    }
    file.agrees("thrust", [&low, &high])?;
    let pushing = &eta * &forces.thrust;
    file.agrees("intrinsic_thrust", [&pushing.at(pushing.low()), &pushing.at(pushing.high())])?;
    match mode {
        "[r,s]" | "[r]" => require(file.says("rotation_joint", "0"), || "a haunch".into())?,
        _ => forces.touches(file, "rotation_joint", Contact::Intrados)?,
    }
    if giving.iter().any(|(contact, _)| *contact == Contact::Inwards) {
        forces.touches(file, "sliding_joint", Contact::Inwards)?;
    }
    if matches!(mode, "[r,r,s]" | "[r,s,r]") {
        let between = (&beta + &sliding).over(2).point();
        let [turns, slides] =
            [Contact::Intrados, Contact::Inwards].map(|c| forces.slope(c, &between));
        let in_order = match mode {
            "[r,r,s]" => turns.is_negative() && slides.is_positive(),
            _ => turns.is_positive() && slides.is_negative(),
        };
        require(in_order, || format!("the joints are not in the order of {mode}"))?;
    }
    // It stands from there on, up to the physical limit, and no thinner arch does.
    let rest = &border.stands.int(2) - &border.stands;
    for k in [1, 8] {
        let eta = &border.stands + &(&rest * &rest.int(k)).over(8);
        require(row.decide(&eta.point(), &giving)?.stands, || {
            "a thicker arch does not stand".into()
        })?;
        let eta = (&border.falls * &rest.int(k)).over(9);
        require(!row.decide(&eta.point(), &giving)?.stands, || "a thinner arch stands".into())?;
    }
    Ok(border)
}

/// Too little friction for any thickness: joints that slide leave no thrust. With the friction stated they leave one, and
/// with less none.
fn slides_of(file: &File, slides: &Value) -> Judged {
    const CLOSER: u32 = 40;
    let half_opening = arch_of(file, slides, &file.number("1/1"))?.half_opening;
    let mu = file.friction(text(&slides["friction"])).ok_or("no limit of friction")?;
    // A ring that no face bounds: what slides in it slides in any.
    let wide = half_opening.int(1000);
    let arch = |mu: &Ball| Arch {
        ring: Ring::new(false, &wide, Some(mu.clone())),
        half_opening: half_opening.clone(),
    };
    let row = Row { arch: &arch, upwards: true };
    let sliding = file.hint("sliding_joint").ok_or("no joint")?;
    let giving = vec![(Contact::Inwards, sliding), (Contact::Outwards, half_opening.clone())];
    let ends = file.value("friction").ok_or("no friction is stated")?;
    let border = row.border(ends, &giving, CLOSER)?;
    let joints: Joints = joints_of(&giving);
    let forces = Forces::new(arch(&border.falls.hull(&border.stands)), &joints)?;
    let [low, high] = [forces.thrust.low(), forces.thrust.high()].map(|x| mu.at(x));
    file.agrees("thrust", [&low, &high])?;
    forces.touches(file, "sliding_joint", Contact::Inwards)?;
    match arch(&mu).thrusts(&joints) {
        [Some(low), Some(high)] if low > high => {}
        _ => return Err("its friction leaves a thrust".into()),
    }
    require((&border.falls - &mu).is_positive(), || "its friction is enough".into())
}

/// Too wide for any thickness up to the limit.
fn too_wide_of(file: &File, wide: &Value) -> Judged {
    const CLOSER: u32 = 40;
    let own = arch_of(file, wide, &file.number("2/1"))?;
    let arch = |alpha: &Ball| Arch { ring: own.ring.clone(), half_opening: alpha.clone() };
    let row = Row { arch: &arch, upwards: false };
    let ends = file.value("half_opening").ok_or("no half opening is stated")?;
    let zero = own.half_opening.int(0);
    let mut giving = vec![(Contact::Intrados, zero.clone())];
    match file.hint("sliding_joint") {
        Some(sliding) => giving.push((Contact::Inwards, sliding)),
        None => giving.push((Contact::Extrados, zero)),
    }
    let border = row.border(ends, &giving, CLOSER)?;
    let alpha = border.falls.hull(&border.stands);
    giving.push((Contact::Extrados, alpha.clone()));
    let forces = Forces::new(arch(&alpha), &joints_of(&giving))?;
    let [low, high] = [forces.thrust.low(), forces.thrust.high()].map(|x| alpha.at(x));
    file.agrees("thrust", [&low, &high])?;
    if giving[1].0 == Contact::Inwards {
        forces.touches(file, "sliding_joint", Contact::Inwards)?;
    }
    require((&own.half_opening - &border.falls).is_not_negative(), || {
        "it is no wider than what stands".into()
    })?;
    for k in [16, 15, 12, 8, 4, 1] {
        let arch = arch_of(file, wide, &alpha.int(k).over(8))?;
        require(!arch.decide(&giving)?.stands, || format!("it stands at {k}/8"))?;
    }
    Ok(())
}
