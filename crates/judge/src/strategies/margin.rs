//! Distance of an assembly from its threshold.

use rug::Rational;
use std::fmt;
use std::str::FromStr;

/// Part of a threshold by which an assembly is above it or below, in 1/10,000: from 0.01 % to 50 %.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Margin(u32);

impl Margin {
    /// Numbers above the threshold and below it, over it.
    pub(super) fn factors(self) -> [Rational; 2] {
        [10_000 + self.0, 10_000 - self.0].map(|parts| Rational::from((parts, 10_000)))
    }

    fn percents(self) -> f64 {
        f64::from(self.0) / 100.0
    }
}

impl Default for Margin {
    /// 0.1 %.
    fn default() -> Self {
        Self(10)
    }
}

impl FromStr for Margin {
    type Err = String;

    /// Reads `0.1%`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let percents = text.trim().strip_suffix('%').and_then(|text| text.trim_end().parse().ok());
        let found = (1..=5_000).map(Self).find(|margin| Some(margin.percents()) == percents);
        found.ok_or_else(|| "a margin is from 0.01% to 50%, of two decimals at most".to_owned())
    }
}

impl fmt::Display for Margin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}%", self.percents())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_margin_is_read_and_told() {
        for (text, told) in [("0.1%", "0.1%"), ("5 %", "5%"), ("0.25%", "0.25%"), ("50%", "50%")] {
            assert_eq!(text.parse::<Margin>().unwrap().to_string(), told);
        }
        assert_eq!("0.10%".parse(), Ok(Margin::default()));
        for text in ["0.1", "0%", "-1%", "50.1%", "0.001%", "pi%", "%", "", "nan%"] {
            assert!(text.parse::<Margin>().is_err(), "{text}");
        }
    }
}
