//! Horizontal accelerations on the command line.

use super::notes;
use super::output::{OutputFile, Printed, is_written};
use crate::ask::{ArchGiven, tilt_note};
use crate::certify::state::{Inquiry, Wanted};
use crate::certify::{
    self, LargestTilt, MOST_TILTED_STONES, VoussoirStanding, assess_voussoirs, measured_tilt,
    tilted_stones,
};
use crate::cli::line::typed;
use crate::number::ExactNumber;
use crate::problem::measures::Measures;
use crate::problem::stones::Stones;
use crate::problem::{Arch, Slope};
use crate::report::{Format, Reported, Sizes, TiltDrawing, TiltedArch, Understood};
use crate::sweep::failure::Failure;

/// Proves and writes the answers for arches under an acceleration.
pub(super) fn write(
    (file, format): (&OutputFile, &Format),
    (asked, arches): (&Understood, &[Arch]),
    of: TiltAsked<'_>,
    digits: TiltDigitsAsked<'_>,
) -> Result<(), Failure> {
    is_written("--tilt", TiltedArch::content(), format)?;
    let (_, tilt, stones) = of;
    are_few(stones)?;
    let output = file.open_for(format)?;
    notes::frictions(arches.iter().take(1).map(Arch::friction));
    notes::tell(tilt_note(tilt));
    let answer = |arch: &Arch| tilted((asked, arch), of, digits);
    let answers: Vec<TiltedArch> = arches.iter().map(answer).collect::<Result<_, Failure>>()?;
    let open = answers.iter().find_map(TiltedArch::first_open).cloned();
    output.report((&answers, format), open)
}

/// Draws arches at the largest acceleration that they bear; tells whether it did, as one that does not stand upright
/// either is drawn as it falls so.
pub(super) fn draw(
    given: &ArchGiven,
    (asked, arches): (&Understood, &[Arch]),
    stones: Option<&Stones>,
    (file, format, look): &Printed<'_>,
    digits: usize,
) -> Result<bool, Failure> {
    let (Some(eta), Some(tilt)) = (&given.thickness, &given.tilt) else { return Ok(false) };
    look.refuse_motion("--tilt", true)?;
    if given.measures.as_ref().is_some_and(Measures::has_forces) {
        return Err(
            "a picture of a tilted arch has no forces: `couplet assess` without one tells them"
                .into(),
        );
    }
    let answer = |arch: &Arch| tilted((asked, arch), (eta, tilt, stones), (digits, None));
    let answers: Vec<TiltedArch> = arches.iter().map(answer).collect::<Result<_, Failure>>()?;
    if let [TiltedArch { found: Ok(None), .. }] = &answers[..] {
        return Ok(false);
    }
    let output = file.open_for(format)?;
    notes::frictions(arches.iter().take(1).map(Arch::friction));
    notes::tell(tilt_note(tilt));
    let open = answers.iter().find_map(TiltedArch::first_open).cloned();
    let (measures, amplitude) = (given.measures.clone(), look.style.amplitude);
    let drawing = TiltDrawing { arches: answers, measures, amplitude };
    output.printed((&drawing, format, &look.print), open)?;
    Ok(true)
}

/// Thickness, acceleration and, where there are joints between stones alone, these.
type TiltAsked<'a> = (&'a ExactNumber, &'a Slope, Option<&'a Stones>);

/// Digits of ratios; measures with the digits of sizes.
type TiltDigitsAsked<'a> = (usize, Option<(&'a Measures, usize)>);

/// Arch under an acceleration, with what is proved of it.
pub fn tilted(
    (asked, arch): (&Understood, &Arch),
    (eta, tilt, stones): TiltAsked<'_>,
    (digits, measures): TiltDigitsAsked<'_>,
) -> Result<TiltedArch, Failure> {
    are_few(stones)?;
    let standing = |digits| Inquiry::new(arch, digits, false).assess(eta, digits, Wanted::Standing);
    let stands = match stones {
        // Few digits tell it, but next to the least thickness.
        None => match standing(1)?.stands {
            Ok(stands) => Ok(stands),
            Err(_) => standing(digits)?.stands,
        },
        Some(stones) => assess_voussoirs(stones, arch.weight(), arch.friction(), eta, digits)?
            .standing
            .map(|standing| matches!(standing, VoussoirStanding::Stands(_))),
    };
    let found = match (stands, stones) {
        (Ok(true), None) => Ok(Some(certify::tilted(arch, eta, tilt, digits)?)),
        (Ok(true), Some(stones)) => Ok(Some(tilted_stones(arch, stones, eta, tilt, digits)?)),
        (Ok(false), _) => Ok(None),
        (Err(undecided), _) => Err(undecided),
    };
    let largest = found.iter().flatten().find_map(|found| match &found.largest {
        Ok(LargestTilt::Limited(_, mechanism)) => Some(&**mechanism),
        _ => None,
    });
    let sizes = measures.map(|(measures, digits)| Sizes {
        measured_at: measures.circle(),
        found: measured_tilt((arch, eta), largest, measures, digits),
    });
    let (asked, arch, stones) = (asked.clone(), arch.clone(), stones.cloned());
    let (thickness, tilt, command) = (eta.clone(), tilt.clone(), typed());
    Ok(TiltedArch { asked, arch, thickness, tilt, stones, digits, command, found, sizes })
}

fn are_few(stones: Option<&Stones>) -> Result<(), Failure> {
    let most = MOST_TILTED_STONES;
    match stones.is_some_and(|stones| stones.count() > most / 2 + 1) {
        true => Err(format!("--tilt looks at every joint: give at most {most} stones").into()),
        false => Ok(()),
    }
}
