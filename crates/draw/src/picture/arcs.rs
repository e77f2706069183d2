//! A chain of points as few arcs, for files that have arcs.

/// Point where an arc begins, and a quarter of its angle by its tangent: positive if it turns
/// counter-clockwise to the next, zero if it is straight. The last begins nothing.
pub type Bulge = ([f64; 2], f64);

/// Arcs through some of the points, none of which is further away from them than `within`.
pub fn arcs(points: &[[f64; 2]], within: f64) -> Vec<Bulge> {
    let mut found = Vec::new();
    let mut from = 0;
    while from + 1 < points.len() {
        let (mut to, mut bulge) = (from + 1, 0.0);
        // As far as it goes; a chain that bends back is left before it does.
        while let Some(&end) = points.get(to + 1) {
            let between = &points[from + 1..=to];
            let middle = between[between.len() / 2];
            let tried = through([points[from], middle, end]);
            if !between.iter().all(|point| distance([points[from], end], tried, *point) <= within) {
                break;
            }
            (to, bulge) = (to + 1, tried);
        }
        found.push((points[from], bulge));
        from = to;
    }
    found.extend(points.last().map(|last| (*last, 0.0)));
    found
}

fn minus([x, y]: [f64; 2], [u, v]: [f64; 2]) -> [f64; 2] {
    [x - u, y - v]
}

/// The bulge of the arc from the first to the last of three points through the second.
fn through([from, middle, to]: [[f64; 2]; 3]) -> f64 {
    let ([x, y], [u, v]) = (minus(from, middle), minus(to, middle));
    // The angle on the circumference is half a turn less half the arc's.
    let angle = (x * v - y * u).atan2(x * u + y * v);
    let half =
        if angle < 0.0 { -std::f64::consts::PI - angle } else { std::f64::consts::PI - angle };
    -(half / 2.0).tan()
}

/// Distance of a point from an arc, of which more than a half counts as the whole circle.
fn distance([from, to]: [[f64; 2]; 2], bulge: f64, point: [f64; 2]) -> f64 {
    let ([x, y], [u, v]) = (minus(to, from), minus(point, from));
    let chord = x.hypot(y);
    let [along, aside] = [(x * u + y * v) / chord, (x * v - y * u) / chord];
    // Up to half a circle an arc is over its chord.
    if bulge.abs() <= 1.0 && !(0.0..=chord).contains(&along) {
        return u.hypot(v).min((u - x).hypot(v - y));
    }
    // The circle through both ends whose height over the chord is bulge times its half, to the right: its power at
    // the point.
    let height = bulge * chord / 2.0;
    let straight = height * height - chord * chord / 4.0;
    let off = height * (along * (along - chord) + aside * aside) + aside * straight;
    let slope = (2.0 * height * aside + straight).hypot(height * (2.0 * along - chord));
    (off / slope).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_one_arc_and_a_line_is_straight() {
        let on = |k: i32| {
            let (sin, cos) = (f64::from(k) / 10.0).sin_cos();
            [3.0 + 2.0 * cos, 1.0 + 2.0 * sin]
        };
        let circle: Vec<[f64; 2]> = (0..20).map(on).collect();
        let found = arcs(&circle, 1e-12);
        assert_eq!(found.len(), 2);
        approx::assert_relative_eq!(found[0].1, (1.9f64 / 4.0).tan(), epsilon = 1e-12);
        let back: Vec<[f64; 2]> = circle.into_iter().rev().collect();
        approx::assert_relative_eq!(
            arcs(&back, 1e-12)[0].1,
            -(1.9f64 / 4.0).tan(),
            epsilon = 1e-12
        );
        let line: Vec<[f64; 2]> = (0..9).map(|k| [f64::from(k), 2.0 * f64::from(k)]).collect();
        assert_eq!(arcs(&line, 1e-12), [([0.0, 0.0], 0.0), ([8.0, 16.0], 0.0)]);
        assert!(arcs(&[], 1.0).is_empty());
    }

    /// The distance is that from the circle, to first order; a corner is not rounded.
    #[test]
    fn no_point_is_further_away_than_allowed() {
        let bulge = (0.5f64).tan();
        // An arc of two radians of the unit circle about the centre, from the right.
        let ends = [[1.0, 0.0], [2f64.cos(), 2f64.sin()]];
        for (joint, off) in [(0.3f64, 1e-4), (1.1, -1e-4), (1.9, 2e-4)] {
            let point = [(1.0 + off) * joint.cos(), (1.0 + off) * joint.sin()];
            approx::assert_relative_eq!(
                distance(ends, bulge, point),
                f64::abs(off),
                epsilon = 1e-7
            );
        }
        assert_eq!(distance(ends, 0.2, [1.5, 0.0]), 0.5, "before its beginning");
        let wave = |k: i32| [f64::from(k) / 100.0, (f64::from(k) / 30.0).sin()];
        let wave: Vec<[f64; 2]> = (0..300).map(wave).collect();
        let found = arcs(&wave, 1e-4);
        assert!((10..80).contains(&found.len()), "{}", found.len());
        let corner = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0]];
        let found: Vec<[f64; 2]> = arcs(&corner, 1e-3).into_iter().map(|(at, _)| at).collect();
        assert!(found.contains(&[2.0, 0.0]), "{found:?}");
    }
}
