//! A question held against what its own numbers say: sectors by Green's theorem, forces by sums over stones.

use crate::program::Json;
use serde_json::Value;

/// How far off a number may be, over the radius.
const WITHIN: f64 = 1e-12;

/// What a question says, over its radius.
struct Read {
    thickness: f64,
    friction: f64,
    /// The angles of all joints.
    angles: Vec<f64>,
    joints: Vec<[[f64; 2]; 2]>,
    stones: Vec<([[f64; 2]; 4], f64, [f64; 2])>,
    is_heyman: bool,
}

impl Read {
    fn new(of: &Value) -> Self {
        let radius = of["radius"].number();
        let point = |x: &Value| [x[0].number() / radius, x[1].number() / radius];
        let corners = |x: &Value| [0, 1, 2, 3].map(|corner| point(&x[corner]));
        let list = |name: &str| of[name].list().iter();
        let count = of["stones"].as_u64().unwrap();
        let alpha = of["half_opening_rad"].number();
        let angle = |joint: u64| alpha * (2.0 * joint as f64 / count as f64 - 1.0);
        Self {
            thickness: of["thickness_ratio"].number(),
            friction: of["friction_double"].number(),
            angles: (0..=count).map(angle).collect(),
            joints: list("joints").map(|ends| [point(&ends[0]), point(&ends[1])]).collect(),
            stones: list("blocks")
                .map(|stone| {
                    let weight = stone["weight"].number() / radius.powi(2);
                    (corners(&stone["polygon"]), weight, point(&stone["centroid"]))
                })
                .collect(),
            is_heyman: of["weight"] == "heyman",
        }
    }

    /// Angles, weights and centroids of what lies between the crown and a joint on the right of it, summed: over the
    /// weight of a radian.
    fn load(&self, joint: usize) -> (f64, f64) {
        let count = self.stones.len();
        let whole = self.stones[count.div_ceil(2)..joint].iter();
        // The half of a keystone, which is no stone.
        let mut sum = match count % 2 {
            0 => (0.0, 0.0),
            _ => {
                let half = self.angles[count.div_ceil(2)];
                (half, self.centroid_radius(half / 2.0) * (half / 2.0).sin() * half)
            }
        };
        for (_, weight, [x, _]) in whole {
            sum = (sum.0 + weight / self.thickness, sum.1 + weight / self.thickness * x);
        }
        sum
    }

    /// Radius of the centroid of a stone of half the angle `g`.
    fn centroid_radius(&self, g: f64) -> f64 {
        let [inner, outer] = [1.0 - self.thickness / 2.0, 1.0 + self.thickness / 2.0];
        let of_area = 2.0 / 3.0 * (outer.powi(3) - inner.powi(3)) / (outer.powi(2) - inner.powi(2));
        if self.is_heyman { g.sin() / g } else { of_area * g.sin() / g }
    }

    /// `N`, `T` and the moment about the centre at a joint on the right, at a thrust and a crown moment.
    fn forces(&self, joint: usize, [thrust, moment]: [f64; 2]) -> [f64; 3] {
        let (weight, arm) = self.load(joint);
        let (sin, cos) = self.angles[joint].sin_cos();
        [thrust * cos + weight * sin, weight * cos - thrust * sin, moment + arm]
    }

    /// The joints on the right of the crown, with one at it.
    fn right(&self) -> std::ops::RangeInclusive<usize> {
        self.stones.len().div_ceil(2)..=self.stones.len()
    }

    /// Whether a state passes no condition at any joint.
    fn is_admissible(&self, state: [f64; 2]) -> bool {
        self.right().all(|joint| {
            let [normal, shear, moment] = self.forces(joint, state);
            let half = self.thickness / 2.0 * normal;
            normal > 0.0 && (moment - normal).abs() < half && shear.abs() < self.friction * normal
        })
    }

    /// A condition, as what `a h + b p` must not be below.
    fn condition(&self, contact: &Value) -> Option<[f64; 3]> {
        let joint = contact["joint"].as_u64()? as usize;
        self.right().contains(&joint).then_some(())?;
        // All is linear in thrust and moment.
        let none = self.forces(joint, [0.0, 0.0]);
        let one = self.forces(joint, [1.0, 0.0]);
        let [outer, inner] = [1.0, -1.0].map(|side| 1.0 + side * self.thickness / 2.0);
        let mu = self.friction;
        let room = |[normal, shear, moment]: [f64; 3]| match contact["happens"].as_str()? {
            "hinge at the extrados" => Some((outer * normal - moment, -1.0)),
            "hinge at the intrados" => Some((moment - inner * normal, 1.0)),
            "slides inwards" => Some((mu * normal - shear, 0.0)),
            "slides outwards" => Some((mu * normal + shear, 0.0)),
            _ => None,
        };
        let ((at_none, of_moment), (at_one, _)) = (room(none)?, room(one)?);
        Some([at_one - at_none, of_moment, -at_none])
    }

    /// The thrust that conditions together bound from below, or from above; `None` if they bind the moment too.
    fn bound(&self, by: &Value, is_least: bool) -> Option<f64> {
        let conditions: Option<Vec<[f64; 3]>> =
            by.as_array()?.iter().map(|contact| self.condition(contact)).collect();
        let sum = conditions?.iter().fold([0.0; 3], |a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
        (sum[1] == 0.0 && (sum[0] > 0.0) == is_least).then(|| sum[2] / sum[0])
    }
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= WITHIN * (1.0 + b.abs())
}

fn are_near(a: [f64; 2], b: [f64; 2]) -> bool {
    is_near(a[0], b[0]) && is_near(a[1], b[1])
}

/// Area and first moment, along `y`, of a polygon.
fn shoelace(polygon: &[[f64; 2]]) -> (f64, f64) {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).fold((0.0, 0.0), |(area, moment), ([x, y], [u, v])| {
        let cross = x * v - y * u;
        (area + cross / 2.0, moment + cross * (y + v) / 6.0)
    })
}

/// What is wrong with the bodies.
fn fault_of_bodies(read: &Read, supports: &Value, radius: f64) -> Option<&'static str> {
    let radii = [1.0 - read.thickness / 2.0, 1.0 + read.thickness / 2.0];
    let polar = |radius: f64, angle: f64| [radius * angle.sin(), radius * angle.cos()];
    let are_ends = |(ends, angle): (&[[f64; 2]; 2], &f64)| {
        (0..2).all(|end| are_near(ends[end], polar(radii[end], *angle)))
    };
    if read.joints.len() != read.angles.len() || !read.joints.iter().zip(&read.angles).all(are_ends)
    {
        return Some("joints");
    }
    for (place, (polygon, weight, centroid)) in read.stones.iter().enumerate() {
        let [left, right] = [read.joints[place], read.joints[place + 1]];
        if *polygon != [right[0], right[1], left[1], left[0]] {
            return Some("a polygon");
        }
        let [g, middle] =
            [-1.0, 1.0].map(|sign| (read.angles[place + 1] + sign * read.angles[place]) / 2.0);
        // Turned so that its middle is up: the chords, and the segments between them and the arcs.
        let turned = polygon.map(|[x, y]| {
            [x * middle.cos() - y * middle.sin(), x * middle.sin() + y * middle.cos()]
        });
        let (chords, of_chords) = shoelace(&turned);
        let between = |power: i32| radii[1].powi(power) - radii[0].powi(power);
        let area = chords + between(2) * (2.0 * g - (2.0 * g).sin()) / 2.0;
        let moment = of_chords + between(3) * 2.0 / 3.0 * g.sin().powi(3);
        let own = if read.is_heyman { g.sin() / g } else { moment / area };
        if !is_near(*weight, area) {
            return Some("a weight");
        }
        if !are_near(*centroid, polar(own, middle)) {
            return Some("a centroid");
        }
    }
    let alpha = read.angles[read.angles.len() - 1];
    let wide = (2.0 * alpha / read.stones.len() as f64).min((std::f64::consts::PI - alpha) / 2.0);
    let ground = |side: usize, sign: f64| {
        let below = radii.map(|radius| polar(radius, sign * (alpha + wide)));
        let joint = read.joints[side * read.stones.len()];
        let [right, left] = if side == 1 { [below, joint] } else { [joint, below] };
        let corners = [right[0], right[1], left[1], left[0]];
        (0..4).all(|corner| {
            let at = &supports[side][corner];
            are_near([at[0].number() / radius, at[1].number() / radius], corners[corner])
        })
    };
    (!ground(0, -1.0) || !ground(1, 1.0)).then_some("the ground")
}

/// What is wrong with the proof of the verdict.
fn fault_of_proof(read: &Read, of: &Value) -> Option<&'static str> {
    let proof = &of["proof"];
    if of["stands"] == true {
        let state =
            ["thrust", "moment"].map(|name| proof.get(name).map_or(f64::NAN, Json::decimal));
        return (!read.is_admissible(state)).then_some("the state");
    }
    let bound = |name: &str, is_least| {
        let found = read.bound(&proof[name]["by"], is_least)?;
        let told = proof[name]["thrust"].value();
        ((found - told).abs() < 1e-9 * (1.0 + told.abs())).then_some(found)
    };
    match (bound("needed", true), bound("borne", false)) {
        (Some(needed), Some(borne)) if needed > borne => None,
        _ => Some("the bounds"),
    }
}

/// What is wrong with a question and its answer.
pub(super) fn fault(of: &Value) -> Option<&'static str> {
    let read = Read::new(of);
    fault_of_bodies(&read, &of["supports"], of["radius"].number())
        .or_else(|| fault_of_proof(&read, of))
}
