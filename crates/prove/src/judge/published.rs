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

const fn printed(
    place: &'static str,
    weight: SelfWeight,
    landmark: Landmark,
    quantity: Quantity,
    text: &'static str,
) -> Printed {
    Printed { place, weight, landmark, quantity, text }
}

/// Everything printed, in the order tables, text, captions.
#[rustfmt::skip]
pub const PRINTED: &[Printed] = &[
    printed("Table 1", Heyman, Triple, Thickness, "0.6796047320988860"),
    printed("Table 1", Heyman, Triple, Friction, "1.415270827756886"),
    printed("Table 1", Heyman, Triple, HalfOpening, "2.487161163767182"),
    printed("Table 1", Heyman, Triple, Thrust, "0.09780581933963814"),
    printed("Table 1", Heyman, Triple, RotationJoint, "1.037485213550072"),
    printed("Table 1", Heyman, Triple, SlidingJoint, "0.2970519164101457"),
    printed("Table 1", Heyman, Shift, Thickness, "0.9533663968209255"),
    printed("Table 1", Heyman, Shift, Friction, "1.765868462744654"),
    printed("Table 1", Heyman, Shift, HalfOpening, "2.600211150484514"),
    printed("Table 1", Heyman, Shift, Thrust, "0.06791978142522512"),
    printed("Table 1", Heyman, Shift, RotationJoint, "0.2516081968386061"),
    printed("Table 1", Heyman, Shift, SlidingJoint, "0.2516081968386061"),
    printed("Table 1", Heyman, Junction, Thickness, "0.9652414772084208"),
    printed("Table 1", Heyman, Junction, Friction, "1.777213608388237"),
    printed("Table 1", Heyman, Junction, HalfOpening, "2.603266515104794"),
    printed("Table 1", Heyman, Junction, Thrust, "0.06718190191428895"),
    printed("Table 1", Heyman, Junction, RotationJoint, "0"),
    printed("Table 1", Heyman, Junction, SlidingJoint, "0.2503367611228279"),
    printed("Table 1", Heyman, Border, Thickness, "2"),
    printed("Table 1", Heyman, Border, Friction, "2.690297881776622"),
    printed("Table 1", Heyman, Border, HalfOpening, "2.774176793356034"),
    printed("Table 1", Heyman, Border, Thrust, "0.03200476409857036"),
    printed("Table 1", Heyman, Border, RotationJoint, "0"),
    printed("Table 1", Heyman, Border, SlidingJoint, "0.1760126676508405"),
    printed("Table 2", Milankovitch, Triple, Thickness, "0.6183182410743238"),
    printed("Table 2", Milankovitch, Triple, Friction, "1.277021363435198"),
    printed("Table 2", Milankovitch, Triple, HalfOpening, "2.430069103769349"),
    printed("Table 2", Milankovitch, Triple, Thrust, "0.1147600824797408"),
    printed("Table 2", Milankovitch, Triple, RotationJoint, "1.042556808593598"),
    printed("Table 2", Milankovitch, Triple, SlidingJoint, "0.3187321853045027"),
    printed("Table 2", Milankovitch, Shift, Thickness, "0.8734660698200912"),
    printed("Table 2", Milankovitch, Shift, Friction, "1.537913842804309"),
    printed("Table 2", Milankovitch, Shift, HalfOpening, "2.531269027051532"),
    printed("Table 2", Milankovitch, Shift, Thrust, "0.08555323265580009"),
    printed("Table 2", Milankovitch, Shift, RotationJoint, "0.2797031945436853"),
    printed("Table 2", Milankovitch, Shift, SlidingJoint, "0.2797031945436853"),
    printed("Table 2", Milankovitch, Junction, Thickness, "0.8872221963291936"),
    printed("Table 2", Milankovitch, Junction, Friction, "1.546270800988723"),
    printed("Table 2", Milankovitch, Junction, HalfOpening, "2.534077907926732"),
    printed("Table 2", Milankovitch, Junction, Thrust, "0.08479836323759742"),
    printed("Table 2", Milankovitch, Junction, RotationJoint, "0"),
    printed("Table 2", Milankovitch, Junction, SlidingJoint, "0.2785814079040845"),
    printed("Table 2", Milankovitch, Border, Thickness, "2"),
    printed("Table 2", Milankovitch, Border, Friction, "1.853774888450581"),
    printed("Table 2", Milankovitch, Border, HalfOpening, "2.623074865083552"),
    printed("Table 2", Milankovitch, Border, Thrust, "0.06248908922171234"),
    printed("Table 2", Milankovitch, Border, RotationJoint, "0"),
    printed("Table 2", Milankovitch, Border, SlidingJoint, "0.2420417380328302"),
    printed("Table 3", Heyman, RotationEnd, Thickness, "1"),
    printed("Table 3", Heyman, OverturningEnd, Thickness, "2"),
    printed("Table 3", Heyman, RotationEnd, OpeningVariable, "2/3"),
    printed("Table 3", Heyman, OverturningEnd, OpeningVariable, "1/2"),
    printed("Table 3", Heyman, OverturningEnd, OpeningVariable, "0.5"),
    printed("Table 3", Heyman, RotationEnd, HalfOpening, "2.648388899151005"),
    printed("Table 3", Heyman, RotationEnd, HalfOpeningDegrees, "151.7"),
    printed("Table 3", Heyman, OverturningEnd, HalfOpening, "2.786498150651177"),
    printed("Table 3", Heyman, OverturningEnd, HalfOpeningDegrees, "159.7"),
    printed("Table 4", Milankovitch, RotationEnd, Thickness, "0.9282032302755092"),
    printed("Table 4", Milankovitch, OverturningEnd, Thickness, "2"),
    printed("Table 4", Milankovitch, RotationEnd, OpeningVariable, "0.7320508075688773"),
    printed("Table 4", Milankovitch, OverturningEnd, OpeningVariable, "2/3"),
    printed("Table 4", Milankovitch, RotationEnd, HalfOpening, "2.590843443008955"),
    printed("Table 4", Milankovitch, RotationEnd, HalfOpeningDegrees, "148.4"),
    printed("Table 4", Milankovitch, OverturningEnd, HalfOpening, "2.648388899151005"),
    printed("Table 4", Milankovitch, OverturningEnd, HalfOpeningDegrees, "151.7"),
    printed("Sec. 2.1", Milankovitch, WidestJoint, RotationJoint, "1.119864231443752"),
    printed("Sec. 2.1", Milankovitch, WidestJoint, HalfOpening, "2.196404448812124"),
    printed("Sec. 2.1", Milankovitch, RotationEnd, HalfOpening, "2.590843443008955"),
    printed("Sec. 2.1", Milankovitch, RotationEnd, Thickness, "0.9282032302755092"),
    printed("Sec. 2.1", Heyman, RotationEnd, HalfOpening, "2.648388899151005"),
    printed("Sec. 2.1", Milankovitch, RotationEnd, OpeningVariable, "0.7320508075688773"),
    printed("Sec. 2.2", Milankovitch, Border, HalfOpening, "2.623074865083552"),
    printed("Sec. 2.2", Milankovitch, Border, Friction, "1.853774888450581"),
    printed("Sec. 2.2", Milankovitch, Triple, HalfOpening, "2.430069103769349"),
    printed("Sec. 2.2", Milankovitch, Triple, Thrust, "0.1147600824797408"),
    printed("Sec. 2.2", Milankovitch, Triple, SlidingJoint, "0.3187321853045027"),
    printed("Sec. 2.2", Milankovitch, Triple, Friction, "1.277021363435198"),
    printed("Sec. 2.2", Milankovitch, Triple, RotationJoint, "1.042556808593598"),
    printed("Sec. 2.2", Milankovitch, Triple, Thickness, "0.6183182410743238"),
    printed("Sec. 3", Milankovitch, Triple, Friction, "1.277021363435198"),
    printed("Sec. 3", Milankovitch, Border, Friction, "1.853774888450581"),
    printed("Sec. 3", Milankovitch, Junction, Friction, "1.546270800988723"),
    printed("Sec. 4", Milankovitch, Triple, HalfOpening, "2.430069103769349"),
    printed("Sec. 4", Milankovitch, Triple, Friction, "1.277021363435198"),
    printed("Sec. 4", Milankovitch, Triple, Thickness, "0.6183182410743238"),
    printed("Sec. 4", Milankovitch, Triple, Thrust, "0.1147600824797408"),
    printed("Sec. 4", Milankovitch, Shift, HalfOpening, "2.531269027051532"),
    printed("Sec. 4", Milankovitch, Shift, Friction, "1.537913842804309"),
    printed("Sec. 4", Milankovitch, Junction, HalfOpening, "2.534077907926732"),
    printed("Sec. 4", Milankovitch, Junction, Friction, "1.546270800988723"),
    printed("Sec. 4", Milankovitch, Border, HalfOpening, "2.623074865083552"),
    printed("Sec. 4", Milankovitch, Border, Friction, "1.853774888450581"),
    printed("Sec. 4", Milankovitch, RotationEnd, Thickness, "0.9282032302755092"),
    printed("Sec. 4", Milankovitch, RotationEnd, HalfOpening, "2.590843443008955"),
    printed("Sec. 4", Milankovitch, OverturningEnd, HalfOpening, "2.648388899151005"),
    printed("Fig. 7", Milankovitch, Triple, HalfOpening, "2.430069103769349"),
    printed("Fig. 7", Milankovitch, Triple, Friction, "1.277021363435198"),
    printed("Fig. 7", Milankovitch, Triple, Thickness, "0.6183182410743238"),
    printed("Fig. 8", Milankovitch, Triple, HalfOpening, "2.430069103769349"),
    printed("Fig. 8", Milankovitch, Triple, Friction, "1.277021363435198"),
    printed("Fig. 8", Milankovitch, Triple, Thickness, "0.6183182410743238"),
    printed("Fig. 9", Milankovitch, Shift, HalfOpening, "2.531269027051532"),
    printed("Fig. 9", Milankovitch, Shift, Friction, "1.537913842804309"),
    printed("Fig. 9", Milankovitch, Shift, Thickness, "0.8734660698200912"),
    printed("Fig. 10", Milankovitch, Junction, HalfOpening, "2.534077907926732"),
    printed("Fig. 10", Milankovitch, Junction, Friction, "1.546270800988723"),
    printed("Fig. 10", Milankovitch, Junction, Thickness, "0.8872221963291936"),
    printed("Fig. 11", Milankovitch, Border, HalfOpening, "2.623074865083552"),
    printed("Fig. 11", Milankovitch, Border, Friction, "1.853774888450581"),
    printed("Fig. 12", Milankovitch, OverturningEnd, HalfOpening, "2.648388899151005"),
    printed("Fig. 12", Milankovitch, RotationEnd, HalfOpening, "2.590843443008955"),
];
