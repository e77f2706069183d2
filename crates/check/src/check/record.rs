//! The records of a certificate: JSON objects and nothing else, with every field once and no other. Serde's own derived
//! code would take a list of the values too, and `null` for a field that may be left out; and it would need a
//! procedural macro, which a checker is built without. Lists end: one that is longer than any certificate needs is
//! not read to its end.

use crate::number::Dyadic;
use serde::de::{DeserializeSeed, Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;
use std::marker::PhantomData;

/// Content of a field.
pub(super) trait Entry: Sized {
    /// Reads it.
    fn read<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error>;

    /// Content of a field that is left out, if it may be.
    fn absent() -> Option<Self> {
        None
    }

    /// True if the field is left out.
    fn is_absent(&self) -> bool {
        false
    }
}

/// Entries that serde reads as they should be read.
macro_rules! entries {
    ($($type:ty),+) => {
        $(impl Entry for $type {
            fn read<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                Self::deserialize(from)
            }
        })+
    };
}

entries!(String, usize, Dyadic);

/// A field that may be left out: `null` stands for nothing.
impl<T: Entry> Entry for Option<T> {
    fn read<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        T::read(from).map(Some)
    }

    fn absent() -> Option<Self> {
        Some(None)
    }

    fn is_absent(&self) -> bool {
        self.is_none()
    }
}

impl<T: Entry> Entry for Vec<T> {
    fn read<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_seq(Entries { most: LONGEST, of: PhantomData })
    }
}

/// The longest list that is read: there are fewer unknowns, and fewer quantities.
const LONGEST: usize = 32;

/// A list of at most so many entries.
pub(super) struct Entries<T> {
    pub most: usize,
    pub of: PhantomData<T>,
}

impl<'de, T: Entry> Visitor<'de> for Entries<T> {
    type Value = Vec<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a sequence")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<T>, A::Error> {
        let mut all = Vec::new();
        while let Some(entry) = list.next_element_seed(RecordValue(PhantomData))? {
            if all.len() == self.most {
                let most = self.most;
                return Err(A::Error::custom(format_args!("a list of more than {most} entries")));
            }
            all.push(entry);
        }
        Ok(all)
    }
}

/// The value of a field, or an entry of a list.
pub(super) struct RecordValue<T>(pub PhantomData<T>);

impl<'de, T: Entry> DeserializeSeed<'de> for RecordValue<T> {
    type Value = T;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<T, D::Error> {
        T::read(from)
    }
}

/// The name of a field, one of these.
pub(super) struct Name(pub &'static [&'static str]);

impl<'de> DeserializeSeed<'de> for Name {
    type Value = &'static str;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Self::Value, D::Error> {
        from.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Name {
    type Value = &'static str;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("field identifier")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Self::Value, E> {
        let known = self.0.iter().find(|known| **known == name);
        known.copied().ok_or_else(|| E::unknown_field(name, self.0))
    }
}

/// A record of the file: the type, how it is read, and how it is written. Fields stand in the file in this order, and
/// are read in any.
macro_rules! record {
    ($(#[$about:meta])* pub struct $record:ident { $($(#[$doc:meta])* pub $field:ident: $type:ty,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub struct $record {
            $($(#[$doc])* pub $field: $type,)+
        }

        impl $crate::check::record::Entry for $record {
            fn read<'de, D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                use {serde::de::Error, std::marker::PhantomData, $crate::check::record as read};
                struct Fields;
                impl<'de> serde::de::Visitor<'de> for Fields {
                    type Value = $record;

                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str("an object")
                    }

                    fn visit_map<A: serde::de::MapAccess<'de>>(self, mut map: A) -> Result<$record, A::Error> {
                        const FIELDS: &[&str] = &[$(stringify!($field)),+];
                        $(let mut $field = None;)+
                        while let Some(name) = map.next_key_seed(read::Name(FIELDS))? {
                            $(if name == stringify!($field) {
                                if $field.is_some() {
                                    return Err(A::Error::duplicate_field(name));
                                }
                                $field = Some(map.next_value_seed(read::RecordValue(PhantomData))?);
                            })+
                        }
                        Ok($record {
                            $($field: $field
                                .or_else(read::Entry::absent)
                                .ok_or_else(|| A::Error::missing_field(stringify!($field)))?,)+
                        })
                    }
                }
                from.deserialize_map(Fields)
            }
        }

        impl<'de> serde::Deserialize<'de> for $record {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                $crate::check::record::Entry::read(from)
            }
        }

        impl serde::Serialize for $record {
            fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                use {serde::ser::SerializeMap, $crate::check::record::Entry};
                let mut fields = to.serialize_map(None)?;
                $(if !self.$field.is_absent() {
                    fields.serialize_entry(stringify!($field), &self.$field)?;
                })+
                fields.end()
            }
        }
    };
}

pub(super) use record;
