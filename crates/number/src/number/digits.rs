//! Decimal digits: few of them without a heap.

/// Digits of as many as an answer in doubles has; more are on the heap.
const FEW: usize = 22;

/// Decimal digits as text.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum DecimalDigits {
    /// The first bytes, and how many they are; zeros behind them.
    Few([u8; FEW], u8),
    /// More than fit.
    Many(Box<str>),
}

impl DecimalDigits {
    /// The digits of two texts, one after the other.
    pub(super) fn joined(head: &str, tail: &str) -> Self {
        let (mut few, count) = ([0; FEW], head.len() + tail.len());
        if count > FEW {
            return Self::Many([head, tail].concat().into());
        }
        few[..head.len()].copy_from_slice(head.as_bytes());
        few[head.len()..count].copy_from_slice(tail.as_bytes());
        Self::Few(few, count as u8)
    }

    /// The digits as text.
    pub(super) fn as_str(&self) -> &str {
        match self {
            Self::Few(bytes, count) => {
                std::str::from_utf8(&bytes[..usize::from(*count)]).unwrap_or_default()
            }
            Self::Many(text) => text,
        }
    }
}
