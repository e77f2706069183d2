//! Texts of errors, variant by variant, without a procedural macro: a checker is built without one.

/// `Display` and `Error` of a type, from the text of each of its variants:
///
/// ```text
/// says!(LengthError {
///     Self::Unit(text) => "'{text}' has no unit";
/// } from {
///     ParseExactError => Self::Number;
/// });
/// ```
///
/// What stands behind `from` becomes this error in that variant, and says what it said.
#[macro_export]
macro_rules! says {
    ($error:ty {
        $($variant:pat => $text:literal $(, $more:expr)*;)*
    } $(from { $($inner:ty => $make:path;)+ })?) => {
        impl std::fmt::Display for $error {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $($variant => write!(f, $text $(, $more)*),)*
                    $($($make(error) => write!(f, "{error}"),)+)?
                }
            }
        }

        impl std::error::Error for $error {}

        $($(
            impl From<$inner> for $error {
                fn from(error: $inner) -> Self {
                    $make(error)
                }
            }
        )+)?
    };
}
