//! Meaning of the values of a column of a Parquet file: what is stored as a whole number may be hundredths, or a day.

use ::parquet::basic::{ConvertedType, LogicalType, Type};
use ::parquet::schema::types::ColumnDescriptor;

/// Kind of the values of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ValueKind {
    /// The values mean what they are stored as.
    Plain,
    /// Whole numbers of either sign.
    Signed,
    /// Whole numbers from 0 on.
    Unsigned,
    /// Whole numbers of units with so many places behind the point.
    Decimal(usize),
    Text,
    /// Neither numbers nor texts.
    Other,
}

/// The most digits of a decimal that is stored as a whole number.
const MAX_SCALE: usize = 18;

impl ValueKind {
    /// Kind of a column; or that it has neither numbers nor texts.
    pub(super) fn of(column: &ColumnDescriptor) -> Result<Self, String> {
        // Old files have the one note, new ones both, which say the same.
        let kind = match (Self::logical(column), Self::converted(column)) {
            (Some(one), Some(other)) if one != other => Self::Other,
            (one, other) => one.or(other).unwrap_or(Self::Plain),
        };
        let stored = column.physical_type();
        match (stored, kind) {
            (Type::DOUBLE | Type::FLOAT, Self::Plain)
            | (Type::INT32 | Type::INT64, Self::Plain | Self::Signed | Self::Unsigned)
            | (Type::BYTE_ARRAY, Self::Plain | Self::Text) => Ok(kind),
            (Type::INT32 | Type::INT64, Self::Decimal(0..=MAX_SCALE)) => Ok(kind),
            _ => Err(format!(
                "its column '{}' is of the type {}; DOUBLE, FLOAT, whole numbers, DECIMAL as INT32 or INT64 and \
                 texts are read",
                column.path().string(),
                name(column)
            )),
        }
    }

    fn logical(column: &ColumnDescriptor) -> Option<Self> {
        Some(match column.logical_type_ref()? {
            LogicalType::String | LogicalType::Enum => Self::Text,
            LogicalType::Integer(whole) if whole.is_signed => Self::Signed,
            LogicalType::Integer(_) => Self::Unsigned,
            LogicalType::Decimal(decimal) => Self::decimal(decimal.scale),
            // Of a column without values.
            LogicalType::Unknown => Self::Plain,
            _ => Self::Other,
        })
    }

    fn converted(column: &ColumnDescriptor) -> Option<Self> {
        Some(match column.converted_type() {
            ConvertedType::NONE => return None,
            ConvertedType::UTF8 | ConvertedType::ENUM => Self::Text,
            ConvertedType::INT_8
            | ConvertedType::INT_16
            | ConvertedType::INT_32
            | ConvertedType::INT_64 => Self::Signed,
            ConvertedType::UINT_8
            | ConvertedType::UINT_16
            | ConvertedType::UINT_32
            | ConvertedType::UINT_64 => Self::Unsigned,
            ConvertedType::DECIMAL => Self::decimal(column.type_scale()),
            _ => Self::Other,
        })
    }

    fn decimal(scale: i32) -> Self {
        usize::try_from(scale).map_or(Self::Other, Self::Decimal)
    }

    /// The text of a whole number as it is stored, with and without a sign.
    pub(super) fn whole(self, signed: i64, unsigned: u64) -> String {
        match self {
            Self::Unsigned => unsigned.to_string(),
            Self::Decimal(scale @ 1..) => {
                let digits = format!("{:0width$}", signed.unsigned_abs(), width = scale + 1);
                let (whole, behind) = digits.split_at(digits.len() - scale);
                let sign = if signed < 0 { "-" } else { "" };
                format!("{sign}{whole}.{behind}")
            }
            _ => signed.to_string(),
        }
    }
}

/// The name of a type, as the format has it.
fn name(column: &ColumnDescriptor) -> String {
    let stored = column.physical_type();
    match (column.logical_type_ref(), column.converted_type()) {
        (None, ConvertedType::NONE) => stored.to_string(),
        (None, converted) => format!("{converted} as {stored}"),
        (Some(logical), _) => {
            let whole = format!("{logical:?}");
            let name = whole.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
            format!("{} as {stored}", name.to_uppercase())
        }
    }
}
