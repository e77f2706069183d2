//! One question at a time. Every argument is text, read by what reads the command's, so that the same input gets the
//! same sentence.

use crate::answer::Answer;
use crate::border::{Array, answered, optional, text};
use crate::codes::{COUPLET_OPEN, COUPLET_RESOURCE};
use crate::failure::{Failure, wrong};
use crate::question::{ARCH, certified};
use crate::surveyed::{survey_certified, surveyed};
use crate::threads::{checked, on_threads};
use couplet::arch::SelfWeight;
use couplet::ask::{ArchAsked, ArchGiven, Field, Spelling};
use couplet::certify::state::Certify;
use couplet::certify::{self, quantities};
use couplet::check::{Certificate, Refusal};
use couplet::door::find as sought;
use couplet::problem::{Arch, Landmark, Quantity, Sought};
use couplet::report::{self, Answers, Scope, Understood};
use couplet::sweep::{answer, parse};
use std::ffi::{c_char, c_int, c_void};

/// The model of self-weight of a text.
///
/// # Safety
///
/// As of [`text`].
unsafe fn weight_of(weight: *const c_char) -> Result<SelfWeight, Failure> {
    // SAFETY: as the caller promises.
    parse::weight(unsafe { text(weight, "weight")? }).map_err(wrong)
}

/// Answer about the arch of the texts of fields, or with ranges about every arch inside.
fn answer_of(weight: SelfWeight, asked: &ArchAsked, digits: usize) -> Result<Answer, Failure> {
    match asked.has_range() {
        true => surveyed(asked, weight, digits_of(digits)?),
        false => Ok(arch(weight, asked)?.answer(digits_of(digits)?)),
    }
}

/// Arch of the texts of fields, with its weight.
fn arch(weight: SelfWeight, asked: &ArchAsked) -> Result<ArchRead, Failure> {
    let given = ArchGiven::read(&ARCH, asked, Spelling::Key).map_err(wrong)?;
    let arch = given.arch(weight).map_err(wrong)?;
    Ok(ArchRead { understood: Understood::new(asked, &given), given, arch })
}

/// Fields of an arch by their pointers, of which none is NULL.
///
/// # Safety
///
/// As of [`text`].
unsafe fn fields<const N: usize>(given: [(Field, *const c_char); N]) -> Result<ArchAsked, Failure> {
    let read = |(field, pointer): (Field, *const c_char)| {
        // SAFETY: as the caller promises.
        Ok((field, unsafe { text(pointer, field.name())? }))
    };
    let given: Vec<(Field, &str)> = given.into_iter().map(read).collect::<Result<_, Failure>>()?;
    Ok(ArchAsked::of(given))
}

/// Arch that is read.
struct ArchRead {
    understood: Understood,
    given: ArchGiven,
    arch: Arch,
}

impl ArchRead {
    /// Answer at the thickness, or at the least one.
    fn answer(&self, digits: usize) -> Answer {
        let (arch, measures) = (&self.arch, self.given.measures.as_ref().map(|of| (of, digits)));
        let found = match &self.given.thickness {
            Some(eta) => {
                let found = arch.certify_thickness(eta, digits);
                answer::assessment(report::Extent::ALL, 1, (arch, eta, measures), digits, &found)
            }
            None => answer::state(1, (arch, measures), digits, &arch.certify(digits)),
        };
        let asked = Some(Box::new(self.understood.clone()));
        let told = vec![report::Answer { asked, ..found }];
        Answer::told(Answers::of(Scope::Arch, digits, self.given.quantities(), told))
    }
}

/// A number of significant digits.
fn digits_of(digits: usize) -> Result<usize, Failure> {
    parse::digits(&digits.to_string()).map_err(wrong)
}

/// The quantities of a list with commas, of those that there are; none if it is empty.
pub(crate) fn named(names: &str, possible: &[Quantity]) -> Result<Vec<Quantity>, Failure> {
    let quantity = |name: &str| parse::quantity_of(name.trim(), possible).map_err(wrong);
    match names.trim().is_empty() {
        true => Ok(Vec::new()),
        false => names.split(',').map(quantity).collect(),
    }
}

/// The state of an arch at its least thickness, proved: whether it stands at any thickness, the least one, how it
/// collapses there, and the frictions at which that changes.
///
/// weight: "heyman" or "milankovitch". half_opening: from the crown to the shoulder, between 0 and pi, exact text:
/// radians ("1.4", "pi/2", "7/5") or degrees ("80deg"). friction: a coefficient, 0 or more ("0.6", "3/5", "inf"), or an
/// angle ("31deg"). digits: significant digits, 1 to 1000000; up to 33 cost at most three times what few cost.
///
/// Values: thickness (t/r), thrust (H/(w r)), intrinsic_thrust, rotation_joint and sliding_joint (rad from the crown),
/// sliding_friction, rotational_friction, and asymmetric_thickness, the largest above the least at which an asymmetric
/// mechanism is found and proved: none where none is found. Verdict: "stands" (an admissible symmetric state exists,
/// which with friction does not exclude such a mechanism), "falls" or "undecided".
///
/// A text may be a range: "79deg..81deg", "0.6+-10%", "0.5..inf". Then it is told of every arch inside, which says
/// nothing of how likely one is. Values: the least and the largest of least_thickness and thrust, as lower and upper
/// bound. Verdict: "all_can_stand" at some thickness, "none_can_stand", "both_occur" or "undecided".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_state(
    weight: *const c_char,
    half_opening: *const c_char,
    friction: *const c_char,
    digits: usize,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: the caller promises texts, and a place for the answer.
    unsafe {
        answered(answer, || {
            let asked = fields([(Field::HalfOpening, half_opening), (Field::Friction, friction)])?;
            answer_of(weight_of(weight)?, &asked, digits)
        })
    }
}

/// Whether an arch of a thickness stands, its safety factors, and the thrusts that it can bear, proved. The arch is as
/// for `couplet_state`.
///
/// thickness: t/r, above 0 and at most 2, exact text ("0.12", "3/25").
///
/// Values: least_thickness, geometric_safety, required_friction, friction_safety, least_thrust, largest_thrust, the
/// joints that limit the thrusts, and asymmetric_thickness as for `couplet_state`. Verdict: "stands", "falls" or
/// "undecided"; a value that stays open beside it makes the code `COUPLET_OPEN`.
///
/// With ranges, as for `couplet_state`: the ends of least_thickness, geometric_safety, required_friction,
/// friction_safety and, where all stand, least_thrust and largest_thrust. Verdict: "all_stand", "none_stands",
/// "both_occur" or "undecided".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_assess(
    weight: *const c_char,
    half_opening: *const c_char,
    friction: *const c_char,
    thickness: *const c_char,
    digits: usize,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: as above.
    unsafe {
        answered(answer, || {
            let asked = fields([
                (Field::HalfOpening, half_opening),
                (Field::Friction, friction),
                (Field::Thickness, thickness),
            ])?;
            answer_of(weight_of(weight)?, &asked, digits)
        })
    }
}

/// An arch as it is measured, in ratios or in metres: as `couplet_assess` where it has a thickness, else as
/// `couplet_state`.
///
/// arch: fields with semicolons between them, named as the options of the command, in any order: "span=10m; rise=3m;
/// thickness=60cm; friction=0.6; density=24kN/m3; depth=1m". any two of half_opening, span, rise and
/// radius; friction or friction_angle; measured_at intrados, centreline or extrados.
///
/// Fields may be ranges, as "span=10m+-2cm"; stones, a tilt and forces go with none.
///
/// Values: those of these functions and, in metres, span_m, rise_m, half_opening_degrees, radius_m, thickness_m and
/// least_thickness_m; with density and depth weight_kn and the thrusts in kN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_arch(
    weight: *const c_char,
    arch: *const c_char,
    digits: usize,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: as above.
    unsafe {
        answered(answer, || {
            let asked = ArchAsked::parse(text(arch, "arch")?).map_err(wrong)?;
            answer_of(weight_of(weight)?, &asked, digits)
        })
    }
}

/// A question the other way round: the one answer, with the proof that there is no other. What is not given is NULL.
///
/// With a friction: the widest half opening that stands; with a half opening: the least friction; at the thickness, or
/// at any if that is NULL. With the two modes of a boundary ("rrs/rsr") and either: where one becomes the other.
///
/// Values: half_opening (rad), half_opening_degrees, friction, thickness, thrust, rotation_joint, sliding_joint.
/// Verdict: "found", "nothing" or "undecided".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_find(
    weight: *const c_char,
    modes: *const c_char,
    half_opening: *const c_char,
    friction: *const c_char,
    thickness: *const c_char,
    digits: usize,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: as above.
    unsafe {
        answered(answer, || {
            let weight = weight_of(weight)?;
            let modes = optional(modes, "modes")?.map(sought::line).transpose().map_err(wrong)?;
            let given = [
                (Field::HalfOpening, half_opening),
                (Field::Friction, friction),
                (Field::Thickness, thickness),
            ];
            let mut asked = ArchAsked::default();
            for (field, pointer) in given {
                *asked.at(field) = optional(pointer, field.name())?.map(str::to_owned);
            }
            // What is not given is sought.
            let target = match (modes, &asked.half_opening, &asked.friction) {
                (Some(_), ..) => None,
                (None, None, Some(_)) => Some(Sought::HalfOpening),
                (None, Some(_), None) => Some(Sought::Friction),
                (None, ..) => {
                    return Err(wrong("give friction or half_opening; the other one is found"));
                }
            };
            let question =
                sought::question((target, modes), &asked, Spelling::Key).map_err(wrong)?;
            let understood = sought::understood(&asked, Spelling::Key).map_err(wrong)?;
            let digits = digits_of(digits)?;
            let found = answer::finding(1, (weight, &question), digits).map_err(wrong)?;
            let told = vec![report::Answer { asked: Some(Box::new(understood)), ..found }];
            Ok(Answer::told(Answers::of(Scope::Found, digits, Quantity::FOUND.to_vec(), told)))
        })
    }
}

/// Constants of a landmark, each proved to exist, to be unique in a box, and to have the digits shown.
///
/// landmark: symbol or name: "T" triple, "S" shift, "J" junction, "B" border, "l" rotation-end, "L" overturning-end,
/// "sb" widest-joint. quantity: one, or several with commas ("thickness", "eta,mu"); NULL for all. digits: 1 to
/// 1000000. threads: 1 to 1024, or 0 for one on each core; they end with the call.
///
/// Verdict: "proved" or "undecided".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_constant(
    landmark: *const c_char,
    weight: *const c_char,
    quantity: *const c_char,
    digits: usize,
    threads: usize,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: as above.
    unsafe {
        answered(answer, || {
            let (landmark, weight) = point(landmark, weight)?;
            let possible: Vec<Quantity> = quantities(landmark).collect();
            let wanted = optional(quantity, "quantity")?.unwrap_or_default();
            let wanted = match named(wanted, &possible)? {
                none if none.is_empty() => possible,
                some => some,
            };
            let digits = digits_of(digits)?;
            let asked: Vec<_> = wanted.into_iter().map(|of| (of, digits)).collect();
            let of = (landmark, weight);
            let found = on_threads(checked(threads)?, || answer::landmark(of, &asked))?;
            let found = found.unwrap_or_else(|error| report::Answer::landmark(of, Err(&error)));
            Ok(Answer::told(Answers::constants(digits, vec![found])))
        })
    }
}

/// The landmark and the weight of two texts.
///
/// # Safety
///
/// As of [`text`].
unsafe fn point(
    landmark: *const c_char,
    weight: *const c_char,
) -> Result<(Landmark, SelfWeight), Failure> {
    // SAFETY: as the caller promises.
    let (landmark, weight) = unsafe { (text(landmark, "landmark")?, weight_of(weight)?) };
    Ok((parse::landmark(landmark).map_err(wrong)?, weight))
}

/// A certificate of a landmark, which `couplet_check` accepts without trusting the solver; `couplet_json` has it.
/// Arguments are as for `couplet_constant`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_certify_landmark(
    landmark: *const c_char,
    weight: *const c_char,
    digits: usize,
    threads: usize,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: as above.
    unsafe {
        answered(answer, || {
            let (landmark, weight) = point(landmark, weight)?;
            let digits = digits_of(digits)?;
            let certify = || certify::certify_landmark(landmark, weight, digits);
            certified(on_threads(checked(threads)?, certify)?, Certificate::write)
        })
    }
}

/// A certificate of the state of an arch at its least thickness, or why it stands at none; with a thickness, which may
/// be NULL, that it stands with it or does not. Arguments are as for `couplet_assess`; with ranges it is of the verdict
/// on every arch inside, made by a thread that ends with the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_certify_arch(
    weight: *const c_char,
    half_opening: *const c_char,
    friction: *const c_char,
    thickness: *const c_char,
    digits: usize,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: as above.
    unsafe {
        answered(answer, || {
            let mut asked =
                fields([(Field::HalfOpening, half_opening), (Field::Friction, friction)])?;
            asked.thickness = optional(thickness, "thickness")?.map(str::to_owned);
            let weight = weight_of(weight)?;
            if asked.has_range() {
                return survey_certified(&asked, weight, digits_of(digits)?);
            }
            let ArchRead { arch, given, .. } = arch(weight, &asked)?;
            let made = certify::certify_arch(&arch, given.thickness.as_ref(), digits_of(digits)?);
            certified(made, Certificate::write)
        })
    }
}

/// Checks the bytes of a certificate: that the equations have the root claimed, and that every digit is right. Nothing
/// that they say is believed, and any bytes get a verdict.
///
/// engine: "astro", pure Rust, up to 50000 digits, which NULL is too; or "mpfr".
///
/// Values: those of the certificate, without bounds. Verdict: "accepted"; "refused", with `COUPLET_OPEN`; "not checked"
/// beyond the digits of the engine, with `COUPLET_RESOURCE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_check(
    certificate: *const c_void,
    length: usize,
    engine: *const c_char,
    answer: *mut *mut Answer,
) -> c_int {
    // SAFETY: as above, and that so many bytes are there.
    unsafe {
        answered(answer, || {
            let bytes = Array::<u8>::new(certificate.cast(), Some(length), "certificate")?.values();
            let engine = optional(engine, "engine")?.unwrap_or("astro");
            Ok(match parse::engine(engine).map_err(wrong)?.check(bytes) {
                Ok(accepted) => Answer::accepted(&accepted),
                Err(limit @ Refusal::Limit(..)) => {
                    Answer::new(COUPLET_RESOURCE, "not checked", limit.to_string())
                }
                Err(refusal) => Answer::new(COUPLET_OPEN, "refused", refusal.to_string()),
            })
        })
    }
}
