//! Types that files hold as their text, for serde.

/// `Serialize` and `Deserialize` of types that are written by `Display` and read by `FromStr`.
///
/// ```
/// use couplet_number::number::ExactNumber;
/// let third: ExactNumber = serde_json::from_str("\"1/3\"").unwrap();
/// assert_eq!(serde_json::to_string(&third).unwrap(), "\"1/3\"");
/// assert!(serde_json::from_str::<ExactNumber>("\"1/0\"").is_err());
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
