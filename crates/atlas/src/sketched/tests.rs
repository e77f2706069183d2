mod falling;

use super::*;
use crate::arch::mechanism::Contact;
use crate::arch::{Ring, SelfWeight};
use crate::number::{Angle, Ball, Drawable, Field};
use crate::problem::{Arch, Landmark, Mode};
use crate::sketch::NoCollapse;
use rug::Float;

/// An arch of each mode that has a least thickness, for Heyman's and for Milankovitch's weight.
const ARCHES: [(Mode, [[&str; 2]; 2]); 6] = [
    (Mode::Rotational, [["3/2", "1"]; 2]),
    (Mode::SlidingRotational, [["pi/2", "0.35"]; 2]),
    (Mode::RotationalSliding, [["2.54", "1.6"], ["2.45", "1.35"]]),
    (Mode::RotationalSlidingRotational, [["2.607", "1.9"], ["2.535", "1.57"]]),
    (Mode::OverturningSliding, [["2.65", "2.2"], ["2.57", "2.2"]]),
    (Mode::Overturning, [["2.7", "inf"], ["2.62", "inf"]]),
];
const DRAWN: [Landmark; 6] = [
    Landmark::Triple,
    Landmark::Shift,
    Landmark::Junction,
    Landmark::Border,
    Landmark::RotationEnd,
    Landmark::OverturningEnd,
];

fn arch(weight: SelfWeight, [half_opening, friction]: [&str; 2]) -> Arch {
    Arch::parse(weight.name(), half_opening, friction).unwrap()
}

/// Each mode with each weight, and the landmarks.
fn sketches() -> Vec<Sketch> {
    let mut all = Vec::new();
    for (weight, k) in SelfWeight::ALL.into_iter().zip(0..) {
        for (mode, arches) in ARCHES {
            let sketch = Sketch::least(&arch(weight, arches[k]), false).unwrap();
            assert_eq!(sketch.collapses.len(), 1);
            assert_eq!(sketch.collapses[0].mode, mode);
            all.push(sketch);
        }
        let wide = arch(weight, ["1", "1"]);
        all.push(Sketch::sliding(&wide, &"1".parse().unwrap(), false).unwrap());
        all.extend(DRAWN.map(|landmark| Sketch::landmark(landmark, weight, false).unwrap()));
    }
    all
}

/// At a thousand joints no line is proved to leave the arch, and the line of thrust is on a face at the marks alone.
#[test]
fn lines_are_inside_and_touch_where_joints_give_way() {
    for sketch in sketches() {
        let at = &sketch.at;
        let ring = Ring::new(sketch.weight, &at.thickness);
        for forces in &sketch.forces {
            let load = |p| [&forces.thrust, p, &at.friction];
            let margins = |joint: &Angle<Ball>| {
                let faces = forces.moments.iter().flat_map(|p| {
                    [Contact::Extrados, Contact::Intrados].map(|c| c.margin(joint, &ring, load(p)))
                });
                let friction = [Contact::Inwards, Contact::Outwards]
                    .map(|contact| contact.margin(joint, &ring, load(&forces.moments[0])));
                faces.chain(friction.into_iter().filter(|_| sketch.is_limited)).collect::<Vec<_>>()
            };
            for k in 0..=1000 {
                let share = Float::with_val(at.thrust.prec(), k) / 1000u32;
                let joint = Angle::new(Ball::exact(share, at.thrust.prec()) * &at.half_opening.rad);
                for margin in margins(&joint) {
                    assert!(margin.upper() >= 0, "{:?} at {k}: {margin:?}", sketch.subject);
                }
            }
            let p = forces.moments[0].clone();
            for mark in
                forces.marks.iter().filter(|mark| mark.contact.is_hinge() || sketch.is_limited)
            {
                let joint = Angle::new(mark.at.clone());
                if forces.thrust_lines.len() == 1 || !mark.contact.is_hinge() {
                    let margin = mark.contact.margin(&joint, &ring, load(&p));
                    assert!(
                        margin.contains(&rug::Rational::new()),
                        "{:?}: {mark:?}",
                        sketch.subject
                    );
                }
            }
        }
        let lines =
            sketch.forces.iter().flat_map(|f| f.thrust_lines.iter().chain([&f.friction_line]));
        for [_, offset] in lines.flat_map(|line| &line.points) {
            assert!(offset.abs() <= 0.5 + 1e-12, "{:?} {offset}", sketch.subject);
        }
    }
}

#[test]
fn a_hinge_is_on_the_face_that_its_mode_says() {
    use Contact::*;
    for (mode, expected) in [
        (Mode::Rotational, &[Extrados, Intrados, Extrados][..]),
        (Mode::SlidingRotational, &[Outwards, Intrados, Extrados]),
        (Mode::RotationalSliding, &[Extrados, Intrados, Inwards]),
        (Mode::RotationalSlidingRotational, &[Extrados, Inwards, Intrados]),
        (Mode::OverturningSliding, &[Extrados, Inwards, Intrados]),
        (Mode::Overturning, &[Extrados]),
        (Mode::Sliding, &[Outwards, Inwards]),
    ] {
        let found = sketches().into_iter().flat_map(|sketch| sketch.collapses);
        let mut seen = 0;
        for collapse in found.filter(|collapse| collapse.mode == mode) {
            let contacts: Vec<Contact> = collapse.joints_at_limit().iter().map(|x| x.0).collect();
            assert_eq!(contacts, expected, "{mode}");
            seen += 1;
        }
        assert!(seen >= 2, "{mode}");
    }
}

/// Slips, crown drops and powers, and with dilatancy slips and drops, computed on their own to 45 digits.
#[test]
fn rates_are_those_computed_elsewhere() {
    let milankovitch = |arch_given| arch(SelfWeight::Milankovitch, arch_given);
    let heyman = |arch_given| arch(SelfWeight::Heyman, arch_given);
    for (arch, slip, drop, power, dilatant) in [
        (milankovitch(["1.5", "0.9"]), None, 0.4982805139, 0.0, None),
        (
            milankovitch(["2.3", "1.05"]),
            Some(1.232394368927),
            1.4839057320,
            2.0592559511,
            Some([0.63585834, 0.588577057]),
        ),
        (
            milankovitch(["2.45", "1.35"]),
            Some(4.577272728790),
            4.0873551603,
            1.1937882084,
            Some([0.87046274, 0.198736084]),
        ),
        (
            milankovitch(["2.532", "1.5405"]),
            Some(6.253084117293),
            5.3231630379,
            1.5320067954,
            Some([0.98160224, -0.16091789]),
        ),
        (
            milankovitch(["2.57", "2.2"]),
            Some(8.461379412011),
            7.4706562673,
            1.6559921948,
            Some([0.74720576, -0.41672141]),
        ),
        (
            heyman(["2.3", "1.05"]),
            Some(1.262927120683),
            1.5000854343,
            2.1102743201,
            Some([0.65161182, 0.582574860]),
        ),
        (
            heyman(["2.56", "1.7"]),
            Some(6.186537251243),
            5.6300935799,
            1.4352006761,
            Some([0.83481296, 0.093395058]),
        ),
    ] {
        let of = |is_dilatant| Sketch::least(&arch, is_dilatant).unwrap().collapses.remove(0);
        let slip_of = |collapse: &Collapse| {
            let mut joints = collapse.mechanism.joints.iter();
            joints.find(|joint| !joint.contact.is_hinge()).map(|joint| joint.rate.double())
        };
        let near = |x: f64, y: f64, within: f64| assert!((x - y).abs() < within, "{arch}: {x} {y}");
        let collapse = of(false);
        near(slip_of(&collapse).unwrap_or(0.0), slip.unwrap_or(0.0), 1e-11);
        near(collapse.crown_drop.mid().to_f64(), drop, 1e-9);
        near(collapse.friction_power.mid().to_f64(), power, 1e-9);
        near(collapse.power.mid().to_f64(), power, 1e-9);
        if let Some([slip, drop]) = dilatant {
            let collapse = of(true);
            near(slip_of(&collapse).unwrap(), slip, 1e-8);
            near(collapse.crown_drop.mid().to_f64(), drop, 1e-8);
        }
    }
}

/// Between stones too, with a keystone that goes up and down or with a joint at the crown: blocks displaced by a
/// millionth are where their velocities bring them.
#[test]
fn stones_move_as_their_rates_say() {
    let number = |x: &Ball| x.double();
    for (alpha, mu, stones, blocks) in [
        ("pi/2", "1", 9, 3),
        ("120deg", "0.75", 21, 3),
        ("120deg", "0.75", 20, 2),
        ("2.45", "1.35", 21, 3),
        ("2.57", "2.2", 21, 2),
    ] {
        let arch = arch(SelfWeight::Milankovitch, [alpha, mu]);
        let sketch = Sketch::least_of_stones(&arch, stones, false).unwrap();
        let collapse = &sketch.collapses[0];
        let Moved { blocks: found, by } = moved(collapse, &sketch.at, 1e-6);
        assert_eq!(found.len(), blocks, "{alpha} {mu} {stones}");
        let corners = |block: &Block| {
            let radii = sketch.radii();
            block.between.map(|at| radii.map(|r| [r * at.sin(), r * at.cos()])).concat()
        };
        let velocity = |block: &Block, corner: &[f64; 2]| {
            let twist = &collapse.twists[block.place];
            let (turn, [x, y]) = (number(&twist.rotation), twist.velocity.each_ref().map(number));
            [x - turn * corner[1], y + turn * corner[0]]
        };
        let all = || {
            let of = |block| corners(block).into_iter().map(move |corner| (block, corner));
            found.iter().flat_map(of)
        };
        let fastest = all().map(|(block, at)| velocity(block, &at)).map(|[x, y]| x.hypot(y));
        let unit = by / fastest.fold(0.0, f64::max);
        for (block, at) in all() {
            let (to, velocity) = (block.motion.to(&at), velocity(block, &at));
            let off = [0, 1].map(|k| to[k] - at[k] - unit * velocity[k]);
            assert!(off[0].hypot(off[1]) < 1e-10, "{alpha} {mu} {stones}: {off:?}");
        }
    }
}

/// Rates at B, where the intrados is a point, and at l and L, where friction is unlimited: rises of the crown.
#[test]
fn rates_of_degenerate_states_are_those_computed_elsewhere() {
    let of = |landmark, mode, is_dilatant| {
        let sketch = Sketch::landmark(landmark, SelfWeight::Milankovitch, is_dilatant).unwrap();
        sketch.in_modes(&[mode]).unwrap().collapses.remove(0)
    };
    let near =
        |x: &Ball, y: f64, within: f64| assert!((x.double() - y).abs() < within, "{x:?} {y}");
    for (mode, inner, drop, power, dilatant) in [
        (
            Mode::OverturningSliding,
            7.247457697650,
            6.0450122269,
            1.5945034084,
            [0.85176478, -0.54270864],
        ),
        (Mode::Sliding, 2.067682929158, 2.8759659697, 2.7641613332, [1.03249660, 0.493474608]),
    ] {
        let slip = |collapse: &Collapse| {
            let mut joints = collapse.mechanism.joints.iter();
            joints.find(|joint| joint.contact == Contact::Inwards).unwrap().rate.clone()
        };
        let collapse = of(Landmark::Border, mode, false);
        near(&slip(&collapse), inner, 1e-11);
        near(&collapse.crown_drop, drop, 1e-9);
        near(&collapse.power, power, 1e-9);
        near(&collapse.friction_power, power, 1e-9);
        let collapse = of(Landmark::Border, mode, true);
        // With dilatancy rates are in units of the shoulder's.
        near(&(slip(&collapse) / &collapse.mechanism.joints[0].rate), dilatant[0], 1e-8);
        near(
            &(collapse.crown_drop.clone() / &collapse.mechanism.joints[0].rate),
            dilatant[1],
            1e-8,
        );
    }
    for (landmark, drop) in
        [(Landmark::RotationEnd, -0.766202152), (Landmark::OverturningEnd, -0.946900491)]
    {
        let collapse = of(landmark, Mode::Overturning, false);
        near(&collapse.crown_drop, drop, 1e-9);
        near(&collapse.power, 0.0, 1e-15);
    }
}

/// Blocks of true states, turned by a millionth, are where their rates bring them: each mode with each weight, and
/// where joints meet, the intrados is a point or friction is unlimited. Rates that are turned the other way do not.
#[test]
fn blocks_turned_by_a_millionth_follow_their_rates() {
    const BY: f64 = 1e-6;
    let (mut modes, mut places) = (Vec::new(), [0; 3]);
    for sketch in sketches() {
        let at = sketch.at.map_ref(Drawable::double);
        for collapse in &sketch.collapses {
            let rate = collapse.mechanism.joints[0].rate.double();
            let moves = collapse.mode.moves(&at, &BY, &0.0);
            assert_eq!(moves.len(), collapse.twists.len());
            let mut joints: Vec<f64> =
                collapse.mechanism.joints.iter().map(|joint| joint.at.rad.double()).collect();
            joints.push(0.0);
            for ((motion, twist), ends) in moves.iter().zip(&collapse.twists).zip(joints.windows(2))
            {
                let turn = twist.rotation.double();
                let [across, up] = twist.velocity.each_ref().map(|x| x.double());
                for (joint, radius) in
                    ends.iter().flat_map(|joint| sketch.radii().map(|r| (*joint, r)))
                {
                    let [x, y] = [radius * joint.sin(), radius * joint.cos()];
                    let to = motion.to(&[x, y]);
                    let velocity = [across - turn * y, up + turn * x];
                    let moved = [(to[0] - x) / BY, (to[1] - y) / BY];
                    for axis in [0, 1] {
                        let expected = velocity[axis] / rate;
                        let off = (moved[axis] - expected).abs();
                        assert!(off < 1e-4 * (1.0 + expected.abs()), "{}: {off}", collapse.mode);
                        if expected.abs() > 1e-3 {
                            assert!((moved[axis] + expected).abs() > off, "{}", collapse.mode);
                        }
                    }
                }
            }
            modes.push((collapse.mode, sketch.weight));
            places[0] += usize::from(at.rotation_joint.rad == 0.0);
            places[1] += usize::from(at.thickness == 2.0);
            places[2] += usize::from(!sketch.is_limited);
        }
    }
    for of in Mode::ALL.into_iter().flat_map(|mode| SelfWeight::ALL.map(|weight| (mode, weight))) {
        assert!(modes.contains(&of), "{of:?}");
    }
    assert!(places.iter().all(|seen| *seen >= 4), "{places:?}");
}

#[test]
fn landmarks_have_the_mechanisms_that_differ() {
    use Mode::*;
    for weight in SelfWeight::ALL {
        for (landmark, modes) in [
            (Landmark::Triple, &[Rotational, SlidingRotational, RotationalSliding, Sliding][..]),
            (Landmark::Shift, &[RotationalSliding, Sliding]),
            (Landmark::Junction, &[OverturningSliding, Sliding]),
            (Landmark::Border, &[OverturningSliding, Sliding]),
            (Landmark::RotationEnd, &[Overturning]),
            (Landmark::OverturningEnd, &[Overturning]),
        ] {
            let sketch = Sketch::landmark(landmark, weight, false).unwrap();
            let found: Vec<Mode> = sketch.collapses.iter().map(|collapse| collapse.mode).collect();
            assert_eq!(found, modes, "{landmark:?}");
            let last = *modes.last().unwrap();
            let only = sketch.in_modes(&[last]).unwrap();
            assert_eq!(only.collapses.len(), 1);
            assert!(only.in_modes(&[SlidingRotational]).is_err());
        }
        assert!(matches!(
            Sketch::landmark(Landmark::WidestJoint, weight, false),
            Err(NoSketch::NoFriction(_))
        ));
    }
}

/// No corner has moved by more than the amplitude, one has by so much, and blocks stay apart: a joint only opens.
#[test]
fn blocks_are_moved_by_the_amplitude() {
    for sketch in sketches() {
        let [inner, outer] = sketch.radii();
        for collapse in &sketch.collapses {
            for amplitude in [0.001, 0.12] {
                let Moved { blocks, by } = moved(collapse, &sketch.at, amplitude);
                let corners = |block: &Block| {
                    block
                        .between
                        .map(|joint| [inner, outer].map(|r| [r * joint.sin(), r * joint.cos()]))
                };
                let away = blocks.iter().flat_map(|block| {
                    corners(block).concat().into_iter().map(|corner| {
                        let to = block.motion.to(&corner);
                        (to[0] - corner[0]).hypot(to[1] - corner[1])
                    })
                });
                let most = away.fold(0.0, f64::max);
                assert!((most - amplitude).abs() < 1e-9, "{}: {most}", collapse.mode);
                assert_eq!(by, amplitude);
                for pair in blocks.windows(2) {
                    // The face of the lower block, and the corners of the one above it.
                    let joint = pair[0].between[0];
                    let face = [inner, outer]
                        .map(|r| pair[0].motion.to(&[r * joint.sin(), r * joint.cos()]));
                    let along = [face[1][0] - face[0][0], face[1][1] - face[0][1]];
                    for corner in corners(&pair[1])[1] {
                        let to = pair[1].motion.to(&corner);
                        let off = [to[0] - face[0][0], to[1] - face[0][1]];
                        let side = along[0] * off[1] - along[1] * off[0];
                        // Beyond the end of the face there is nothing to meet.
                        let ahead = along[0] * off[0] + along[1] * off[1];
                        assert!(side > -1e-12 || ahead < 0.0, "{}: {side}", collapse.mode);
                    }
                }
                for block in &blocks {
                    for corner in corners(block).concat() {
                        assert!(block.motion.to(&corner)[0] > -1e-12, "beyond the axis");
                    }
                }
            }
        }
    }
}

#[test]
fn an_arch_as_it_stands_has_both_extremes() {
    let standing = |given, eta: &str| {
        Sketch::standing(&arch(SelfWeight::Milankovitch, given), &eta.parse().unwrap(), false)
            .unwrap()
    };
    let both = standing(["80deg", "0.35"], "0.16");
    assert_eq!(both.forces.len(), 2);
    assert!(both.collapses.is_empty());
    let words: Vec<_> =
        both.forces.iter().filter_map(|forces| forces.limited_by.as_deref()).collect();
    assert_eq!(words, ["intrados at the haunch", "sliding of the shoulder"]);
    // Without thrust the line starts at half the radius of the centroids.
    let loose = standing(["80deg", "inf"], "1.2");
    let first = loose.forces[0].thrust_lines[0].points[0];
    let radius = 1.0 + 1.2 * first[1];
    assert!((radius - (1.0 + 1.44 / 12.0) / 2.0).abs() < 1e-15, "{first:?}");
    // Nothing bounds the thrust of a thick narrow arch without friction limits.
    assert_eq!(standing(["1/2", "inf"], "1.9").forces.len(), 1);
}

#[test]
fn what_is_not_there_is_not_drawn() {
    let thin =
        Sketch::sliding(&arch(SelfWeight::Heyman, ["1", "1"]), &"0.001".parse().unwrap(), false);
    assert!(matches!(thin, Err(NoSketch::NoRoom)));
}

#[test]
fn rates_that_are_not_positive_are_undecided() {
    let sketch = Sketch::least(&arch(SelfWeight::Heyman, ["3/2", "1"]), false).unwrap();
    // As if the haunch were below the shoulder: the lever arm turns its sign.
    let mut at = sketch.at.clone();
    at.rotation_joint.cos = -at.rotation_joint.cos.clone();
    let refused = Collapse::new(sketch.weight, Mode::Rotational, &at, false);
    assert_eq!(refused.unwrap_err(), NoCollapse::Rates(Mode::Rotational));
}

/// Between stones nothing says where a line is: it has its points at the joints, over a keystone it is straight.
#[test]
fn lines_of_stones_are_those_of_their_joints() {
    for (alpha, mu, stones) in [("2.3", "1.05", 3), ("pi/2", "0.7", 7), ("120deg", "0.75", 20)] {
        let arch = arch(SelfWeight::Milankovitch, [alpha, mu]);
        let thickness = "1.2".parse().unwrap();
        let sketches = [
            Sketch::least_of_stones(&arch, stones, false).unwrap(),
            Sketch::standing_of_stones(&arch, stones, &thickness, false).unwrap(),
        ];
        for sketch in sketches {
            let joints = sketch.stone_joints();
            assert!(!sketch.forces.is_empty());
            for line in sketch.forces.iter().flat_map(|forces| &forces.thrust_lines) {
                assert!(line.points.iter().zip(&joints).all(|([at, _], joint)| at == joint));
                assert_eq!(line.points.len(), joints.len() + 1, "{alpha} {stones}");
                // Admissible at every joint.
                let within = |[_, offset]: &[f64; 2]| offset.abs() < 0.5 + 1e-9;
                assert!(line.points.iter().all(within), "{alpha} {stones}: {line:?}");
                // Over a keystone the line is as straight on the page as it is unrolled.
                let half = &line.across(true).points;
                let keystone = usize::from(joints[0] > 0.0);
                assert_eq!(
                    (half[0], half.len()),
                    ([0.0, line.points[0][1]], joints.len() + 1 + keystone)
                );
                assert_eq!(line.across(false).points.len(), 2 * joints.len() + 1 + keystone);
            }
        }
    }
}
