use super::*;
use crate::arch::{Configuration, SelfWeight};
use crate::number::{Field, Real, Stumpff};
use crate::problem::{Landmark, System};
use crate::prover::posed::Posed;
use crate::prover::root::{box_near, root_near};
use crate::solve::start;

const WEIGHT: SelfWeight = SelfWeight::Milankovitch;

fn started(landmark: Landmark) -> (System, Vec<Float>) {
    let start = start::landmark(landmark, WEIGHT).iter().map(|x| Float::with_val(53, x));
    (landmark.system(WEIGHT), start.collect())
}

fn unique(form: &impl Form<Ball>, start: &[Float], bits: u32) -> Unique {
    let [domain, image] = box_near(form, bits, start, true).unwrap();
    Unique::new(domain, &image, bits).unwrap()
}

/// At each number of bits the ladder finds the root that is proved with all of them at once.
#[test]
fn the_ladder_and_newtons_method_at_all_bits_overlap() {
    for landmark in Landmark::ALL {
        let (system, start) = started(landmark);
        let given = Configuration::zero(&Ball::integer(0, 9000));
        let form = Posed { system: &system, given: &given };
        let unique = unique(&form, &start, FEW);
        for bits in [900, 1300, 5000, 9000] {
            let found =
                Ladder { form: &form, unique: &unique, tick: &|| () }.refined(bits).unwrap();
            let [_, plain] = box_near(&form, bits + 100, &start, false).unwrap();
            for (index, (x, plain)) in found.values.iter().zip(&plain).enumerate() {
                assert!(x.overlaps(plain), "{landmark:?} {bits}");
                assert!(x.rad() < Magnitude::power_of_two(-i64::from(bits)), "{landmark:?} {x:?}");
                if system.unknowns[index].is_angle() {
                    let (angle, truth) = (found.sines.angle(x), plain.sin_cos());
                    assert!(angle.sin.overlaps(&truth.0) && angle.cos.overlaps(&truth.1));
                    assert!(angle.sin.rad() < Magnitude::power_of_two(-i64::from(bits)));
                }
            }
        }
    }
}

/// `x² = c`, `x y = 1` with `c` given: what a system without angles is, and with an ill-conditioned root for a small
/// `c`.
struct Roots(Ball);

impl Form<Ball> for Roots {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        vec![x[0].square() - number(&self.0), x[0].clone() * &x[1] - x[0].int(1)]
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, _: impl Fn(&Ball) -> T, x: &[T]) -> bool {
        x[0].excludes_zero()
    }
}

#[test]
fn what_is_given_has_as_many_bits_as_it_takes() {
    for shift in [0i32, 30, 300, 3000] {
        for bits in [300, 1000, 4000, 20_000] {
            let c = Ball::integer(1, bits + 50) / Ball::integer(3, bits + 50);
            let c = c.scaled(-i64::from(shift));
            let large = Float::with_val(53, 3).sqrt() << (shift / 2);
            let start = vec![Float::with_val(53, large.recip_ref()), large];
            let found = root_near(&Roots(c.clone()), bits, start).unwrap();
            let root = c.sqrt();
            assert!(found[0].overlaps(&root) && found[1].overlaps(&(root.int(1) / &root)));
            let last = |x: &Ball| Magnitude::upper(x.mid()).shifted(8 - i64::from(bits));
            assert!(found.iter().all(|x| x.rad() < last(x)), "{shift} {bits}: {found:?}");
        }
    }
}

/// Where nothing is a root, none is found.
#[test]
fn without_a_root_nothing_is_proved() {
    let minus = Ball::integer(-1, 3000);
    let start = vec![Float::with_val(53, 1.0); 2];
    assert!(root_near(&Roots(minus), 3000, start).is_err());
}

/// A box that does not hold the image proves nothing, nor does one beyond the box of uniqueness.
#[test]
fn a_last_step_that_proves_nothing_is_refused() {
    let (system, start) = started(Landmark::Triple);
    let given = Configuration::zero(&Ball::integer(0, 2000));
    let form = Posed { system: &system, given: &given };
    let unique = unique(&form, &start, FEW);
    let ladder = Ladder { form: &form, unique: &unique, tick: &|| () };
    type Spoil = fn(&mut Level<Posed<'_, Ball>>);
    let cases: [(Spoil, &str); 4] = [
        (|level| level.around[1] = level.around[1].midpoint(), "the only one near it"),
        (|level| level.centre[2] += 1e-9, "the only one near it"),
        (|level| level.around[0] = Ball::whole(64), "of the same solution"),
        (
            |level| {
                // Slopes that say nothing.
                let wide = level.around.iter().map(|x| x.clone() * Ball::integer(9, 64));
                let wide: Vec<Ball> = wide.collect();
                level.jacobian = Eliminated::new(&Dual::variables(&wide)).unwrap();
                level.centre[0] += 1e-30;
            },
            "the only one near it",
        ),
    ];
    for (spoil, reason) in cases {
        let mut level = ladder.level(1000, &|| ()).unwrap();
        spoil(&mut level);
        let undecided = level.enclosed().err().unwrap();
        assert!(undecided.to_string().contains(reason), "{undecided}");
    }
    assert!(ladder.level(1000, &|| ()).unwrap().enclosed().is_ok());
}

/// Equations that lose a large part of the bits, and a box that says nothing, are no beginning.
#[test]
fn a_root_that_is_hardly_known_is_no_beginning() {
    let image =
        |rad: i64| [Ball::new(Float::with_val(400, 0.7), Magnitude::power_of_two(rad), 400)];
    let lost = |rad| Unique::new(Vec::new(), &image(rad), 400).map(|unique| unique.lost);
    assert_eq!(
        [lost(-420), lost(-399), lost(-370), lost(-300)],
        [Some(24), Some(26), Some(55), None]
    );
}

#[test]
fn a_climb_ends_at_its_goal_in_few_stages() {
    for (start, goal) in [(100, 112), (100, 300), (100, 301), (333, 11_000), (33_000, 1_100_000)] {
        let bits = climb(start, goal);
        assert!(bits[0] <= SPAN * start && bits.last() == Some(&goal));
        assert!(bits.windows(2).all(|pair| pair[0] < pair[1] && pair[1] <= SPAN * pair[0]));
    }
    assert!(climb(128, 128).is_empty());
}
