//! The proof of every landmark once more in intervals.

use super::certified;
use couplet::arch::{Configuration, SelfWeight};
use couplet::check::krawczyk;
use couplet::number::{AstroInterval, Ball, Field};
use couplet::problem::{Landmark, System};
use rug::Float;

/// Krawczyk over intervals, on boxes around the ball midpoints; the images overlap the balls.
#[test]
fn the_second_arithmetic_proves_the_same_points() {
    const PREC: usize = 256;
    for landmark in Landmark::ALL {
        for weight in SelfWeight::ALL {
            let point = certified(landmark, weight);
            let system = *point.isolated().system();
            let refined = point.enclosure(PREC as u32 + 64).unwrap();
            let values: Vec<Ball> =
                system.unknowns.iter().map(|&u| refined.value(u).unwrap()).collect();
            let image = image_in(&system, &values, PREC)
                .unwrap_or_else(|| panic!("{landmark:?} {weight:?} is not proved"));
            for (ball, interval) in values.iter().zip(&image) {
                let (low, high) = interval.ends().unwrap();
                assert!(ball.lower() <= high && low <= ball.upper(), "{landmark:?} {weight:?}");
                assert!(Float::with_val(64, &high - &low) < 1e-50, "and it is narrow");
            }
            // A false twin: a box that does not hold the root is refused.
            let moved: Vec<Ball> =
                values.iter().map(|x| x.clone() + x.clone() * x.ratio(1, 1 << 20)).collect();
            assert!(image_in(&system, &moved, PREC).is_none(), "{landmark:?} {weight:?}");
        }
    }
}

fn image_in(system: &System, values: &[Ball], prec: usize) -> Option<Vec<AstroInterval>> {
    let interval = |low: &Float, high: &Float| AstroInterval::between(low, high, prec);
    let mid = |x: &Ball| Float::with_val(128, x.mid());
    let centre: Vec<_> = values.iter().map(|x| interval(&mid(x), &mid(x))).collect();
    let radius = Float::with_val(128, 1) >> 100;
    let domain: Vec<_> = values
        .iter()
        .map(|x| Float::with_val(256, mid(x)))
        .map(|x| interval(&(x.clone() - &radius), &(x + &radius)))
        .collect();
    let floats: Vec<Float> = values.iter().map(mid).collect();
    let at = system.place(Configuration::zero(&Float::new(128)), &floats);
    let slopes = system.residuals(&system.variables(&at));
    let jacobian =
        slopes.iter().map(|r| (0..floats.len()).map(|k| r.derivative(k)).collect()).collect();
    let preconditioner: Vec<Vec<_>> = couplet::solve::inverse(jacobian)?
        .into_iter()
        .map(|row| row.into_iter().map(|y| interval(&y, &y)).collect())
        .collect();
    let given = || Configuration::zero(&AstroInterval::integer(0, prec));
    let residuals = system.residuals(&system.place(given(), &centre));
    let slopes = system.residuals(&system.variables(&system.place(given(), &domain)));
    let image = krawczyk::image(&centre, &residuals, &slopes, &preconditioner, &domain);
    krawczyk::is_contracted(&image, &domain).then_some(image)
}
