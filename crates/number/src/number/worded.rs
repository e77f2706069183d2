//! Enums whose variants have words: each stands beside its variant, and nowhere else; and lists of variants.

/// An enum with a list of its variants and a method that gives what stands beside each:
///
/// ```
/// couplet_number::worded! {
///     /// A weight.
///     #[derive(Clone, Copy, Debug, PartialEq)]
///     pub enum Weight {
///         /// On the centreline.
///         Heyman = "heyman",
///         /// At the centroids.
///         Milankovitch = "milankovitch",
///     }
///     /// All weights.
///     pub const ALL;
///     /// The name used in files.
///     pub fn name -> &'static str;
/// }
/// assert_eq!(Weight::ALL.map(Weight::name), ["heyman", "milankovitch"]);
/// ```
#[macro_export]
macro_rules! worded {
    (
        $(#[$of:meta])* $vis:vis enum $name:ident {
            $($(#[$meaning:meta])* $variant:ident = $words:expr,)+
        }
        $(#[$every:meta])* $listed:vis const ALL;
        $(#[$says:meta])* $said:vis fn $method:ident -> $type:ty;
    ) => {
        $(#[$of])*
        $vis enum $name { $($(#[$meaning])* $variant,)+ }

        impl $name {
            $(#[$every])*
            $listed const ALL: [Self; [$(stringify!($variant)),+].len()] = [$(Self::$variant),+];

            $(#[$says])*
            $said const fn $method(self) -> $type {
                match self { $(Self::$variant => $words,)+ }
            }
        }
    };
}

/// An array of variants of an enum, by their names alone.
///
/// ```
/// use std::cmp::Ordering;
/// assert_eq!(couplet_number::list![Ordering: Less Equal], [Ordering::Less, Ordering::Equal]);
/// ```
#[macro_export]
macro_rules! list {
    ($of:ident: $($variant:ident)+) => { [$($of::$variant),+] };
}
