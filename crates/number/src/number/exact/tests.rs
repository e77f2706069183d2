use super::*;
use crate::number::{AstroInterval, Enclosure, Field, Real};

fn factor(text: &str) -> BigRational {
    text.parse::<ExactNumber>().unwrap().factor().clone()
}

fn quotient(numerator: i32, denominator: i32) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

#[test]
fn a_double_is_the_number_that_it_is() {
    for x in [0.1, -2.5, 0.0, -0.0, f64::from_bits(1), -f64::MIN_POSITIVE, 1e300, f64::MAX] {
        let exact = ExactNumber::try_from(x).unwrap();
        let expected = BigRational::from_float(x).unwrap();
        assert_eq!(
            [exact.factor().numer(), exact.factor().denom()],
            [expected.numer(), expected.denom()]
        );
        assert_eq!(exact.nearest_double(), Some(x));
        assert_eq!(exact.to_rational(), rug::Rational::from_f64(x).unwrap());
        assert_eq!(exact, ExactNumber::from(rug::Rational::from_f64(x).unwrap()));
    }
    assert_ne!(
        ExactNumber::try_from(0.1).unwrap().factor(),
        "0.1".parse::<ExactNumber>().unwrap().factor()
    );
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(ExactNumber::try_from(x), Err(ParseExactError::Syntax(x.to_string())));
    }
    assert_eq!(ExactNumber::from(-7), "-7".parse().unwrap());
    assert_eq!(format!("{:?}", "2pi/3".parse::<ExactNumber>().unwrap()), "2pi/3");
}

#[test]
fn numbers_are_read_exactly() {
    assert_eq!(factor("0.1"), quotient(1, 10));
    assert_eq!(factor("1/3"), quotient(1, 3));
    assert_eq!(factor("pi"), quotient(1, 1));
    assert_eq!(factor("0.5*pi"), quotient(1, 2));
    assert_eq!(factor("1.5pi/3"), quotient(1, 2));
    assert_eq!(factor("0"), quotient(0, 1));
    assert_eq!(factor("-0.5e1"), quotient(-5, 1));
    let hundred = format!("0.{}1", "0".repeat(99));
    assert_eq!(factor(&hundred), factor("1e-100"));
    assert_eq!(factor("45deg"), quotient(1, 4));
}

#[test]
fn fractions_are_in_lowest_terms_whatever_is_below() {
    for above in ["6", "-6", "0", "7", "1.5", "-0.375", "12e3"] {
        for below in [1, 2, 4, 3, 16, 12] {
            let found = factor(&format!("{above}/{below}"));
            let expected = factor(above) / BigInt::from(below);
            assert_eq!([found.numer(), found.denom()], [expected.numer(), expected.denom()]);
        }
    }
}

#[test]
fn a_fraction_is_the_decimal_that_it_is_where_that_is_short() {
    let in_decimals = |text: &str| text.parse::<ExactNumber>().unwrap().in_decimals();
    assert_eq!(["1/8", "-3/40", "6/4"].map(in_decimals), ["0.125", "-0.075", "1.5"]);
    let [tens, twos] = [format!("1/1{}", "0".repeat(30)), format!("1/{}", BigInt::from(1) << 30)];
    assert_eq!(in_decimals(&tens), "1e-30");
    for long in ["1/3", "1/14", &twos, "3602879701896397/36028797018963968"] {
        assert_eq!(in_decimals(long), long);
    }
}

#[test]
fn short_decimals_are_in_lowest_terms_like_long_ones() {
    for (digits, exponent) in [
        ("1", 0),
        ("10", -1),
        ("5", -1),
        ("125", -3),
        ("1024", -10),
        ("97656250", -8),
        ("25", -18),
        ("18446744073709551615", -18),
        ("18446744073709551616", -18),
        ("9223372036854775808", -18),
        ("7", -19),
        ("1", 3),
    ] {
        for sign in ["", "-"] {
            let decimal: Decimal = format!("{sign}{digits}e{exponent}").parse().unwrap();
            let scale = BigInt::from(10).pow(i32::unsigned_abs(exponent));
            let whole: BigInt = format!("{sign}{digits}").parse().unwrap();
            let expected = match exponent < 0 {
                true => BigRational::new(whole, scale),
                false => (whole * scale).into(),
            };
            let found = rational(&decimal);
            assert_eq!((found.numer(), found.denom()), (expected.numer(), expected.denom()));
        }
    }
}

#[test]
fn an_arctangent_is_read_and_a_right_angle_is_half_of_pi() {
    let number = |text: &str| text.parse::<ExactNumber>().unwrap();
    let q = number("2atan(0.6)");
    assert_eq!((q.form(), q.factor()), (Form::TwiceArctangent, &quotient(3, 5)));
    assert_eq!(q.to_string(), "2atan(0.6)");
    assert_eq!(ExactNumber::twice_arctangent(quotient(3, 5)).to_string(), "2atan(3/5)");
    let right = number("2atan(1)");
    assert_eq!((right.form(), right.factor()), (Form::TimesPi, &quotient(1, 2)));
    let raw = ExactNumber::fraction(3.into(), 3.into(), Form::TwiceArctangent).unwrap();
    assert_eq!((raw.form(), raw.factor()), (Form::TimesPi, &quotient(1, 2)));
    for text in ["2atan(0)", "2atan(-1)", "2atan(pi)", "2atan(1deg)", "2atan()", "2atan(3/5)deg"] {
        assert!(text.parse::<ExactNumber>().is_err(), "{text}");
    }
}

#[test]
fn an_error_says_what_is_wrong() {
    let error = |text: &str| text.parse::<ExactNumber>().unwrap_err().to_string();
    assert_eq!(error("1,5"), "'1,5' has a comma; give the decimals behind a point (1.5)");
    assert_eq!(error("1/0"), "'1/0' divides by zero");
    assert_eq!(error("1/00deg"), "'1/00deg' divides by zero");
    assert_eq!(error("2pi rad"), "'2pi rad' has two units");
    assert!(error("x").contains("80deg"));
    assert_eq!(
        error("1e1000"),
        "'1e1000' is out of range: sizes from 1e-1000 to below 1e1000 are read"
    );
    assert!(error("1e-1001").contains("out of range"));
    for text in ["1e-1000", "9.99e999", "0e1000"] {
        assert!(text.parse::<ExactNumber>().is_ok(), "{text}");
    }
}

#[test]
fn absurd_input_is_refused() {
    let long = "1".repeat(1_000_000);
    let tiny = format!("1e-1000/1{}", "0".repeat(18_000));
    for bad in [
        "",
        "nan",
        "inf",
        "1e1000000000",
        "1e-2000",
        "1/0",
        "1/-3",
        "pi2",
        "1//2",
        "1/ 3",
        "1/1_0",
        "2pideg",
        "deg",
        "e",
        "30degdeg",
        &"deg".repeat(6_666),
        &long,
        &tiny,
    ] {
        assert!(bad.parse::<ExactNumber>().is_err(), "{}", &bad[..bad.len().min(20)]);
    }
}

#[test]
fn an_absurd_exponent_is_a_number_out_of_range() {
    for far in ["1e2000", "1e-999999999", "1e99999999999999999999", "1e-99999999pi"] {
        let error = far.parse::<ExactNumber>().unwrap_err();
        assert_eq!(error, ParseExactError::Range(far.to_owned()));
    }
}

#[test]
fn the_nearest_double_is_that_of_the_compiler() {
    for text in ["0.1", "1e-320", "1.5707963267948966", "2.4703282292062328e-324", "1e-400"] {
        let number: ExactNumber = text.parse().unwrap();
        assert_eq!(number.nearest_double(), text.parse().ok(), "{text}");
    }
    let right = "90".parse::<ExactNumber>().unwrap().degrees();
    assert_eq!(right.nearest_double(), Some(std::f64::consts::FRAC_PI_2));
    assert_eq!("1e309".parse::<ExactNumber>().unwrap().nearest_double(), None);
    // Exactly between two doubles.
    let tie: ExactNumber = "9007199254740993".parse().unwrap();
    assert_eq!(tie.nearest_double(), Some(9007199254740992.0));
}

#[test]
fn the_enclosure_holds_the_number() {
    let third: AstroInterval = "1/3".parse::<ExactNumber>().unwrap().enclosure(200);
    assert!((third.clone() * third.int(3)).overlaps(&third.int(1)));
    let right: AstroInterval = "90deg".parse::<ExactNumber>().unwrap().enclosure(200);
    let (_, cos) = right.sin_cos();
    assert!(cos.overlaps(&cos.int(0)) && cos.is_less_than(&cos.ratio(1, 1 << 30)).is_proved());
}

#[test]
fn the_numbers_of_gmp_are_the_same() {
    let long = "123456789012345678901234567890/7";
    let rational: rug::Rational = long.parse().unwrap();
    assert_eq!(long.parse::<ExactNumber>().unwrap().to_rational(), rational);
    let negative = -rational;
    assert_eq!(ExactNumber::from(&negative).to_rational(), negative);
    let held: crate::number::Ball = long.parse::<ExactNumber>().unwrap().enclosure(200);
    assert!(!held.contains(&negative) && held.contains(&-negative));
}
