//! Names of what has one: for people, for files, and for serde.

use super::{Friction, Landmark, Mode, NoLandmark, Quantity};
use crate::arch::{NoWeight, SelfWeight};
use crate::number::{as_text, says};
use std::fmt;
use std::str::FromStr;

/// Reason why a text is no mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoMode;

/// Reason why a text is no quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoQuantity;

says!(NoMode { Self => "a mode is one of {}", Mode::ALL.map(Mode::label).join(", "); });
says!(NoQuantity { Self => "a quantity is one of {}", Quantity::ALL.map(Quantity::name).join(", "); });

/// `Display` of types by their names, and `FromStr` by what has a name.
macro_rules! named {
    ($($type:ident by $name:ident, $read:expr, $none:ident;)+) => {$(
        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.pad(self.$name())
            }
        }

        impl FromStr for $type {
            type Err = $none;

            fn from_str(text: &str) -> Result<Self, $none> {
                $read(text).ok_or($none)
            }
        }

        as_text!($type);
    )+};
}

named! {
    SelfWeight by name, SelfWeight::named, NoWeight;
    Landmark by symbol, Landmark::named, NoLandmark;
    Mode by label, Mode::named, NoMode;
    Quantity by name, known, NoQuantity;
}

as_text!(Friction);

/// The quantity of a name or of a letter of the paper, whatever has it.
fn known(name: &str) -> Option<Quantity> {
    let is = |quantity: &Quantity| quantity.name() == name || quantity.letter() == Some(name);
    Quantity::ALL.into_iter().find(is)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::{Deserialize, Serialize};
    use std::fmt::Debug;

    fn comes_back<T>(value: T, text: &str)
    where
        T: Serialize + for<'a> Deserialize<'a> + FromStr + fmt::Display + Debug + PartialEq,
    {
        let json = serde_json::to_string(&value).unwrap();
        assert_eq!((json.as_str(), value.to_string()), (format!("{text:?}").as_str(), text.into()));
        assert_eq!(serde_json::from_str::<T>(&json).unwrap(), value);
        assert_eq!(text.parse::<T>().ok(), Some(value));
        assert!(
            "nothing".parse::<T>().is_err() && serde_json::from_str::<T>("\"nothing\"").is_err()
        );
    }

    #[test]
    fn what_has_a_name_is_read_by_it() {
        SelfWeight::ALL.into_iter().for_each(|weight| comes_back(weight, weight.name()));
        Landmark::ALL.into_iter().for_each(|landmark| comes_back(landmark, landmark.symbol()));
        Mode::ALL.into_iter().for_each(|mode| comes_back(mode, mode.label()));
        Quantity::ALL.into_iter().for_each(|quantity| comes_back(quantity, quantity.name()));
        comes_back(Friction::Infinite, "inf");
        assert_eq!("rrs".parse(), Ok(Mode::RotationalSliding));
        assert_eq!("eta".parse(), Ok(Quantity::Thickness));
        let error = "L".parse::<Mode>().unwrap_err().to_string();
        assert!(error.starts_with("a mode is one of [r,r,r], "), "{error}");
        let error = "x".parse::<Quantity>().unwrap_err().to_string();
        assert!(error.starts_with("a quantity is one of thickness, "), "{error}");
    }
}
