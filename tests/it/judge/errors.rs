//! What the library tells of a claim is so.

use crate::arches::{H, arch, critical_friction, stands};
use crate::hard::config;
use couplet::certify::state::Digits;
use couplet::judge::{CorrectDigits, Demand, RowClaim, Said, Verdict, judge};
use couplet::number::Decimal;
use couplet::problem::{Arch, Mode, Quantity};
use proptest::prelude::*;
use rug::{Rational, ops::Pow};

const USUAL: Demand = Demand::USUAL;

#[test]
fn what_cannot_be_told_is_accepted_of_nobody() {
    let line = arch(H, "pi/2", &critical_friction());
    let verdict = |mode: &str, thickness: &str| {
        let numbers = vec![(Quantity::Thickness, thickness, false)];
        let said = Said { can_stand: Some("yes"), mode: Some(mode), numbers, ..Said::default() };
        judge(&line, &RowClaim::read(&said).unwrap(), USUAL).verdict
    };
    // Even of the two modes that meet at the line: nearer than can be told is not on it.
    assert_eq!(verdict("rrr", ""), Verdict::Undecided);
    assert_eq!(verdict("srr", ""), Verdict::Undecided);
    assert_eq!(verdict("rrs", ""), Verdict::Undecided);
    assert_eq!(verdict("srr", "0.107"), Verdict::Undecided);
}

fn semicircle() -> (Arch, Box<Digits>) {
    let arch = arch(H, "pi/2", "0.38");
    let state = stands(&arch, 80);
    (arch, state)
}

fn power_of_ten(exponent: i64) -> Rational {
    Rational::from(10).pow(exponent as i32)
}

proptest! {
    #![proptest_config(config(100))]

    /// Claims beside the truth by a known error of any size: what is told of it is so.
    #[test]
    fn errors_are_what_they_are(
        error in 1u32..1_000_000, places in 1i64..40, below in any::<bool>(), extra in 0usize..8,
    ) {
        let (arch, state) = semicircle();
        let truth = state.thickness.decimal.value.to_rational();
        let step = Rational::from(error) * power_of_ten(-6 - places);
        let moved = if below { truth.clone() - &step } else { truth.clone() + &step };
        // Written with a few digits more than the error needs.
        let written = couplet::number::Rounded::from_rational(&moved, places as usize + 7 + extra).unwrap();
        let text = written.value.to_string();
        let numbers = vec![(Quantity::Thickness, text.as_str(), false)];
        let claim = RowClaim::read(&Said { numbers, ..Said::default() }).unwrap();
        let found = judge(&arch, &claim, USUAL);
        let thickness = &found.numbers[0];
        let claimed = written.value.to_rational();
        let size = Rational::from(&claimed - &truth).abs();
        let errors = thickness.errors.as_ref().unwrap();
        let near = |shown: &Decimal, exact: Rational| {
            let slack = exact.clone() / 199u32;
            (shown.to_rational() - exact).abs() <= slack
        };
        prop_assert!(near(&errors.absolute, size.clone()));
        prop_assert!(near(errors.relative.as_ref().unwrap(), size.clone() / &truth));
        prop_assert!(near(&errors.units, size.clone() * power_of_ten(-written.value.exponent())));
        // 0.122 is in [2^-4, 2^-3), where doubles are 2^-56 apart.
        prop_assert!(near(errors.ulp.as_ref().unwrap(), size.clone() << 56u32));
        let CorrectDigits::Digits(digits) = thickness.correct_digits else { panic!() };
        let within = |k: i64| Rational::from(&size * 2u32) <= power_of_ten(-k);
        let rounded = size <= power_of_ten(written.value.exponent()) / 2u32;
        prop_assert_eq!(thickness.is_correctly_rounded(), rounded);
        if !rounded {
            prop_assert!(digits == 0 || within(digits as i64));
            prop_assert!(!within(digits as i64 + 1));
        }
        prop_assert_eq!(thickness.order.unwrap() == std::cmp::Ordering::Less, claimed < truth);
    }

    /// Every mode but the certified one is wrong.
    #[test]
    fn another_mode_is_wrong(place in 0usize..7) {
        let (arch, state) = semicircle();
        let mode = Mode::ALL[place];
        let text = state.thickness.decimal.value.to_string();
        let numbers = vec![(Quantity::Thickness, text.as_str(), false)];
        let said = Said { mode: Some(mode.label()), numbers, ..Said::default() };
        let found = judge(&arch, &RowClaim::read(&said).unwrap(), USUAL);
        prop_assert_eq!(found.verdict == Verdict::WrongMode, mode != state.mode);
        prop_assert_eq!(found.verdict == Verdict::CorrectlyRounded, mode == state.mode);
    }
}
