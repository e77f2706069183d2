//! Types that are their text: in files, for serde, and where a test shows them.

/// `Serialize` and `Deserialize` of types that are written by `Display` and read by `FromStr`.
///
/// ```
/// use couplet_number::number::ExactNumber;
/// use serde::Deserialize;
/// use serde::de::IntoDeserializer;
/// use serde::de::value::{Error, StrDeserializer};
/// let read = |text: &'static str| {
///     let text: StrDeserializer<'static, Error> = text.into_deserializer();
///     ExactNumber::deserialize(text)
/// };
/// assert_eq!(read("1/3").unwrap().to_string(), "1/3");
/// assert!(read("1/0").unwrap_err().to_string().contains("divides by zero"));
/// ```
#[macro_export]
macro_rules! as_text {
    ($($type:ty),+) => {$(
        impl serde::Serialize for $type {
            fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                to.collect_str(self)
            }
        }

        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let text = <String as serde::Deserialize>::deserialize(from)?;
                text.parse().map_err(serde::de::Error::custom)
            }
        }
    )+};
}

/// `Debug` of types that are shown as `Display` writes them: a line, where a test fails.
///
/// ```
/// struct Metres(u8);
/// impl std::fmt::Display for Metres {
///     fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
///         write!(f, "{} m", self.0)
///     }
/// }
/// couplet_number::shown_as_text!(Metres);
/// assert_eq!(format!("{:?}", [Metres(3)]), "[3 m]");
/// ```
#[macro_export]
macro_rules! shown_as_text {
    ($($type:ty),+) => {$(
        impl std::fmt::Debug for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Display::fmt(self, f)
            }
        }
    )+};
}
