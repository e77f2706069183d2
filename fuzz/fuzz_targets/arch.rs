//! Whatever the text of an arch or of a range of arches: it is read, or refused in one line. A number that is read is
//! that of its own text.
#![no_main]

use couplet_ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Spelling, SurveyGiven};
use couplet_check::arch::SelfWeight;
use couplet_fuzz::is_told;
use couplet_number::number::ExactNumber;
use libfuzzer_sys::fuzz_target;

const ANY: ArchQuestion = ArchQuestion { refuses: &[], needs: &[], unlimited: true, example: "" };

fuzz_target!(|text: &str| {
    let Ok(asked) = ArchAsked::parse(text).map_err(is_told) else { return };
    for field in Field::ALL {
        let number = asked.get(*field).and_then(|text| text.parse::<ExactNumber>().ok());
        let again = number.as_ref().map(|number| number.to_string().parse().expect("its own text"));
        assert_eq!(again, number);
    }
    for spelling in [Spelling::Option, Spelling::Key] {
        if let Ok(given) = ArchGiven::read(&ANY, &asked, spelling).map_err(is_told) {
            let _ = given.divisions().map_err(is_told);
            let _ = given.arch(SelfWeight::Milankovitch).map_err(is_told);
            given.quantities();
        }
        if let Ok(given) = SurveyGiven::read(&ANY, &asked, spelling).map_err(is_told) {
            let _ = given.survey(SelfWeight::Heyman).map_err(is_told);
        }
    }
});
