//! The numbers the paper prints, as printed: data only.
//!
//! Tables 1–4, and every value of 16 digits in the text and the captions, occurrence by occurrence.

use crate::arch::SelfWeight;
use crate::problem::{Landmark, Quantity};
use Landmark::*;
use Quantity::*;
use SelfWeight::*;

/// One printed number.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Printed {
    /// The table, section or figure caption.
    pub place: &'static str,
    /// The self-weight model it is printed for.
    pub weight: SelfWeight,
    /// The landmark it belongs to.
    pub landmark: Landmark,
    /// The quantity it gives.
    pub quantity: Quantity,
    /// A decimal number, or a fraction of two integers.
    pub text: &'static str,
}

/// Numbers from rows: the place, the weight and the landmark, and what is printed there of it.
macro_rules! printed {
    ($($place:literal $weight:ident $landmark:ident: $($quantity:ident $text:literal),+;)+) => {
        &[$($(
            Printed { place: $place, weight: $weight, landmark: $landmark, quantity: $quantity, text: $text }
        ),+),+]
    };
}

/// Everything printed, in the order tables, text, captions.
pub const PRINTED: &[Printed] = printed! {
    "Table 1" Heyman Triple: Thickness "0.6796047320988860", Friction "1.415270827756886",
        HalfOpening "2.487161163767182", Thrust "0.09780581933963814", RotationJoint "1.037485213550072",
        SlidingJoint "0.2970519164101457";
    "Table 1" Heyman Shift: Thickness "0.9533663968209255", Friction "1.765868462744654",
        HalfOpening "2.600211150484514", Thrust "0.06791978142522512", RotationJoint "0.2516081968386061",
        SlidingJoint "0.2516081968386061";
    "Table 1" Heyman Junction: Thickness "0.9652414772084208", Friction "1.777213608388237",
        HalfOpening "2.603266515104794", Thrust "0.06718190191428895", RotationJoint "0",
        SlidingJoint "0.2503367611228279";
    "Table 1" Heyman Border: Thickness "2", Friction "2.690297881776622", HalfOpening "2.774176793356034",
        Thrust "0.03200476409857036", RotationJoint "0", SlidingJoint "0.1760126676508405";
    "Table 2" Milankovitch Triple: Thickness "0.6183182410743238", Friction "1.277021363435198",
        HalfOpening "2.430069103769349", Thrust "0.1147600824797408", RotationJoint "1.042556808593598",
        SlidingJoint "0.3187321853045027";
    "Table 2" Milankovitch Shift: Thickness "0.8734660698200912", Friction "1.537913842804309",
        HalfOpening "2.531269027051532", Thrust "0.08555323265580009", RotationJoint "0.2797031945436853",
        SlidingJoint "0.2797031945436853";
    "Table 2" Milankovitch Junction: Thickness "0.8872221963291936", Friction "1.546270800988723",
        HalfOpening "2.534077907926732", Thrust "0.08479836323759742", RotationJoint "0",
        SlidingJoint "0.2785814079040845";
    "Table 2" Milankovitch Border: Thickness "2", Friction "1.853774888450581", HalfOpening "2.623074865083552",
        Thrust "0.06248908922171234", RotationJoint "0", SlidingJoint "0.2420417380328302";
    "Table 3" Heyman RotationEnd: Thickness "1";
    "Table 3" Heyman OverturningEnd: Thickness "2";
    "Table 3" Heyman RotationEnd: OpeningVariable "2/3";
    "Table 3" Heyman OverturningEnd: OpeningVariable "1/2", OpeningVariable "0.5";
    "Table 3" Heyman RotationEnd: HalfOpening "2.648388899151005", HalfOpeningDegrees "151.7";
    "Table 3" Heyman OverturningEnd: HalfOpening "2.786498150651177", HalfOpeningDegrees "159.7";
    "Table 4" Milankovitch RotationEnd: Thickness "0.9282032302755092";
    "Table 4" Milankovitch OverturningEnd: Thickness "2";
    "Table 4" Milankovitch RotationEnd: OpeningVariable "0.7320508075688773";
    "Table 4" Milankovitch OverturningEnd: OpeningVariable "2/3";
    "Table 4" Milankovitch RotationEnd: HalfOpening "2.590843443008955", HalfOpeningDegrees "148.4";
    "Table 4" Milankovitch OverturningEnd: HalfOpening "2.648388899151005", HalfOpeningDegrees "151.7";
    "Sec. 2.1" Milankovitch WidestJoint: RotationJoint "1.119864231443752", HalfOpening "2.196404448812124";
    "Sec. 2.1" Milankovitch RotationEnd: HalfOpening "2.590843443008955", Thickness "0.9282032302755092";
    "Sec. 2.1" Heyman RotationEnd: HalfOpening "2.648388899151005";
    "Sec. 2.1" Milankovitch RotationEnd: OpeningVariable "0.7320508075688773";
    "Sec. 2.2" Milankovitch Border: HalfOpening "2.623074865083552", Friction "1.853774888450581";
    "Sec. 2.2" Milankovitch Triple: HalfOpening "2.430069103769349", Thrust "0.1147600824797408",
        SlidingJoint "0.3187321853045027", Friction "1.277021363435198", RotationJoint "1.042556808593598",
        Thickness "0.6183182410743238";
    "Sec. 3" Milankovitch Triple: Friction "1.277021363435198";
    "Sec. 3" Milankovitch Border: Friction "1.853774888450581";
    "Sec. 3" Milankovitch Junction: Friction "1.546270800988723";
    "Sec. 4" Milankovitch Triple: HalfOpening "2.430069103769349", Friction "1.277021363435198",
        Thickness "0.6183182410743238", Thrust "0.1147600824797408";
    "Sec. 4" Milankovitch Shift: HalfOpening "2.531269027051532", Friction "1.537913842804309";
    "Sec. 4" Milankovitch Junction: HalfOpening "2.534077907926732", Friction "1.546270800988723";
    "Sec. 4" Milankovitch Border: HalfOpening "2.623074865083552", Friction "1.853774888450581";
    "Sec. 4" Milankovitch RotationEnd: Thickness "0.9282032302755092", HalfOpening "2.590843443008955";
    "Sec. 4" Milankovitch OverturningEnd: HalfOpening "2.648388899151005";
    "Fig. 7" Milankovitch Triple: HalfOpening "2.430069103769349", Friction "1.277021363435198",
        Thickness "0.6183182410743238";
    "Fig. 8" Milankovitch Triple: HalfOpening "2.430069103769349", Friction "1.277021363435198",
        Thickness "0.6183182410743238";
    "Fig. 9" Milankovitch Shift: HalfOpening "2.531269027051532", Friction "1.537913842804309",
        Thickness "0.8734660698200912";
    "Fig. 10" Milankovitch Junction: HalfOpening "2.534077907926732", Friction "1.546270800988723",
        Thickness "0.8872221963291936";
    "Fig. 11" Milankovitch Border: HalfOpening "2.623074865083552", Friction "1.853774888450581";
    "Fig. 12" Milankovitch OverturningEnd: HalfOpening "2.648388899151005";
    "Fig. 12" Milankovitch RotationEnd: HalfOpening "2.590843443008955";
};
