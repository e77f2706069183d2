//! Search for room for a label.

use super::path::Point;

/// A rectangle by its upper left and its lower right corner.
pub type Rectangle = [Point; 2];

/// Rectangle about its middle, by half its width and height.
pub fn about(middle: Point, half: Point) -> Rectangle {
    [(middle.0 - half.0, middle.1 - half.1), (middle.0 + half.0, middle.1 + half.1)]
}

/// The least and the largest of some values.
pub fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// Points of the grid that is searched, in each direction; then around the best, ever finer.
const GRID: usize = 40;
const TURNS: usize = 3;

/// The middle of a label of so many halves of width and height that is furthest, in these halves, from the
/// outline of an area, from lines in it and from what is `taken`. `None` if it has no room in the area.
pub fn roomiest(
    outline: &[Point],
    half: Point,
    taken: &[Rectangle],
    lines: &[Vec<Point>],
) -> Option<Point> {
    // In halves of the label it is a square of side 2, and the distance is the larger of the two.
    let scaled = |(x, y): Point| (x / half.0, y / half.1);
    let corners: Vec<Point> = outline.iter().copied().map(scaled).collect();
    let taken: Vec<Rectangle> = taken.iter().map(|r| r.map(scaled)).collect();
    let along = |line: &Vec<Point>| {
        let points: Vec<Point> = line.iter().copied().map(scaled).collect();
        points.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()
    };
    let sides = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| [*a, *b]);
    let edge: Vec<[Point; 2]> = sides.chain(lines.iter().flat_map(along)).collect();
    // How far everything is, if it is further than so much.
    let clearance = |at: Point, least: f64| {
        let from_taken = taken.iter().map(|[a, b]| {
            let across = (a.0 - at.0).max(at.0 - b.0);
            across.max((a.1 - at.1).max(at.1 - b.1))
        });
        let mut away = from_taken.chain(edge.iter().map(|side| distance(side, at)));
        let room = away.try_fold(f64::INFINITY, |room, away| {
            let nearer = if away < room { away } else { room };
            (nearer > least).then_some(nearer)
        });
        room.filter(|_| is_inside(&corners, at))
    };
    let (mut x, mut y) = (span(corners.iter().map(|p| p.0)), span(corners.iter().map(|p| p.1)));
    let mut best: Option<(f64, Point)> = None;
    for _ in 0..TURNS {
        let place = |[low, high]: [f64; 2], k| low + (high - low) * (k as f64 + 0.5) / GRID as f64;
        for (i, j) in (0..GRID).flat_map(|i| (0..GRID).map(move |j| (i, j))) {
            let at = (place(x, i), place(y, j));
            let least = best.map_or(f64::NEG_INFINITY, |(most, _)| most);
            best = clearance(at, least).map(|here| (here, at)).or(best);
        }
        let (_, at) = best?;
        let around = |[low, high]: [f64; 2], middle: f64| {
            let step = 2.0 * (high - low) / GRID as f64;
            [middle - step, middle + step]
        };
        (x, y) = (around(x, at.0), around(y, at.1));
    }
    best.filter(|(room, _)| *room >= 1.0).map(|(_, at)| (at.0 * half.0, at.1 * half.1))
}

/// The distance of a point from a straight part, by the larger of across and up: at an end, or where the two are equal.
fn distance([a, b]: &[Point; 2], at: Point) -> f64 {
    let (x, y) = (a.0 - at.0, a.1 - at.1);
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let larger = |share: f64| {
        let (x, y) = ((x + share * dx).abs(), (y + share * dy).abs());
        if x > y { x } else { y }
    };
    let equal = |rest: f64, way: f64| if way == 0.0 { 0.0 } else { (rest / way).clamp(0.0, 1.0) };
    let shares = [1.0, equal(y - x, dx - dy), equal(-x - y, dx + dy)];
    shares.into_iter().map(larger).fold(larger(0.0), |least, d| if d < least { d } else { least })
}

/// Tells whether a point is inside an area: whether a ray from it leaves the area.
fn is_inside(corners: &[Point], (x, y): Point) -> bool {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let crossed = sides
        .filter(|(a, b)| (a.1 > y) != (b.1 > y) && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0));
    crossed.count() % 2 == 1
}

/// The part of an area within a rectangle (Sutherland and Hodgman, 1974).
pub fn within(outline: &[Point], [low, high]: Rectangle) -> Vec<Point> {
    type Side = (fn(&Point) -> f64, f64, f64);
    let sides: [Side; 4] = [
        (|p| p.0, low.0, 1.0),
        (|p| p.0, high.0, -1.0),
        (|p| p.1, low.1, 1.0),
        (|p| p.1, high.1, -1.0),
    ];
    sides.into_iter().fold(outline.to_vec(), |area, (of, bound, sign)| {
        let inside = |p: &Point| sign * (of(p) - bound);
        let pairs = area.iter().zip(area.iter().cycle().skip(1));
        let kept = pairs.flat_map(|(a, b)| {
            let (from, to) = (inside(a), inside(b));
            let crossing = (from * to < 0.0).then(|| {
                let share = from / (from - to);
                (a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1))
            });
            let end = (to >= 0.0).then_some(*b);
            [crossing, end].into_iter().flatten()
        });
        kept.collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point; 4] = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)];

    #[test]
    fn a_label_stands_in_the_middle_or_beside_what_is_taken() {
        let (x, y) = roomiest(&SQUARE, (20.0, 20.0), &[], &[]).unwrap();
        assert!((x - 50.0).abs() < 2.0 && (y - 50.0).abs() < 2.0, "{x} {y}");
        let (x, _) = roomiest(&SQUARE, (20.0, 20.0), &[[(0.0, 0.0), (50.0, 100.0)]], &[]).unwrap();
        assert!((x - 75.0).abs() < 2.0, "{x}");
        assert_eq!(roomiest(&SQUARE, (20.0, 20.0), &[[(30.0, 0.0), (70.0, 100.0)]], &[]), None);
        assert_eq!(roomiest(&SQUARE, (51.0, 1.0), &[], &[]), None);
        assert!(roomiest(&SQUARE, (49.0, 1.0), &[], &[]).is_some());
        let line = vec![vec![(0.0, 30.0), (100.0, 30.0)]];
        let (_, y) = roomiest(&SQUARE, (20.0, 20.0), &[], &line).unwrap();
        assert!((y - 65.0).abs() < 2.0, "{y}");
        assert_eq!(roomiest(&[], (1.0, 1.0), &[], &[]), None);
    }

    #[test]
    fn the_distance_of_a_part_is_that_of_its_nearest_point() {
        let part = [(0.0, 0.0), (10.0, 5.0)];
        for at in [(-2.0, 1.0), (3.0, 9.0), (9.0, 2.0), (12.0, 6.0), (5.0, 2.5), (4.0, -7.0)] {
            let near = (0..=100_000).map(|k| {
                let share = f64::from(k) / 1e5;
                (10.0 * share - at.0).abs().max((5.0 * share - at.1).abs())
            });
            let nearest = near.fold(f64::INFINITY, f64::min);
            assert!((distance(&part, at) - nearest).abs() < 1e-3, "{at:?}");
        }
        assert_eq!(distance(&[(1.0, 1.0), (1.0, 1.0)], (4.0, 2.0)), 3.0);
    }

    #[test]
    fn a_bay_is_outside() {
        let bay = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (50.0, 30.0), (0.0, 100.0)];
        assert!(is_inside(&bay, (50.0, 20.0)) && !is_inside(&bay, (50.0, 60.0)));
        let (_, y) = roomiest(&bay, (10.0, 5.0), &[], &[]).unwrap();
        assert!(y < 60.0);
    }

    #[test]
    fn an_area_is_cut_at_the_rectangle() {
        let triangle = [(0.0, 0.0), (100.0, 0.0), (0.0, 100.0)];
        let cut = within(&triangle, [(-10.0, -10.0), (50.0, 200.0)]);
        assert!(cut.iter().all(|p| p.0 <= 50.0) && cut.contains(&(50.0, 0.0)));
        assert!(cut.iter().any(|p| (p.0 - 50.0).abs() < 1e-9 && (p.1 - 50.0).abs() < 1e-9));
        assert!(within(&triangle, [(101.0, 0.0), (200.0, 10.0)]).is_empty());
    }
}
