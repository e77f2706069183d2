//! Decimals of what balls of double-doubles enclose: only those that are proved.

use couplet_number::number::{DoubleDoubleBall, Enclosure, Tens, Written};

/// Bits of a double-double.
pub(crate) const BITS: u32 = 106;

/// The correct rounding to as many of `digits` digits as are decided, without zeros at the end of a fraction.
pub(crate) fn rounded(x: &DoubleDoubleBall, digits: usize) -> Option<String> {
    Some(shortened(&with_zeros(x, digits)?))
}

/// The same with these zeros, which say how near a quotient is to one.
pub(crate) fn with_zeros(x: &DoubleDoubleBall, digits: usize) -> Option<String> {
    let mut tens = Tens::new(BITS as usize);
    (1..=digits).rev().find_map(|digits| {
        let text = format!("{:.*e}", digits - 1, x.mid().hi());
        let written = Written::parse(&text)?;
        let [low, high]: [DoubleDoubleBall; 2] = written.bounds(digits, &mut tens)?;
        let is_proved = low.is_less_than(x).and(x.is_less_than(&high)).is_proved();
        is_proved.then(|| written.to_string())
    })
}

/// Without the zeros at the end of a decimal fraction.
fn shortened(text: &str) -> String {
    match text.contains('.') && !text.contains('e') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use couplet_number::number::{DoubleDouble, Field};

    #[test]
    fn only_decided_digits_are_written() {
        let third = DoubleDoubleBall::exact(DoubleDouble::exact(1.0)).ratio(1, 3);
        assert_eq!(rounded(&third, 12).unwrap(), "0.333333333333");
        assert_eq!(rounded(&third.widened(1e-5), 12).unwrap(), "0.3333");
        assert_eq!(rounded(&third.widened(1.0), 12), None);
        assert_eq!(rounded(&third.ratio(5, 2), 12).unwrap(), "2.5");
        assert_eq!(with_zeros(&third.ratio(5, 2), 4).unwrap(), "2.500");
    }
}
