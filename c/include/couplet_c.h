/* couplet for C and C++: certified states and constants of circular masonry arches with finite friction.
 *
 * A question is a function that returns a code: 0 everything asked was proved, 1 something is undecided or refused, 2 the
 * question makes no sense, 3 a resource failed, 4 a fault of couplet. Whatever the code, the last argument, if it is not NULL,
 * gets an answer, which couplet_free frees.
 *
 * - Texts that are given end with a zero, are UTF-8 and are only read during the call. Numbers in them are exact: "0.1" is one
 *   tenth. A NULL where a text has to be given is refused with a sentence, as is what is not UTF-8.
 * - Texts that come back are never NULL, are not to be freed, and live as long as their answer; those of couplet_version and
 *   couplet_mode_name for ever. Functions that read an answer take NULL for one, and have nothing to tell of it.
 * - Every function may be called from any thread at any time. An answer does not change and may be read by several threads; it is
 *   freed once, when nobody reads it any more.
 * - Lengths are in units of the radius r of the centreline, forces in units of w r, angles in radians from the crown.
 *
 * docs/c.md is the manual. This file is made of the source: change it there. */

#ifndef COUPLET_C_H
#define COUPLET_C_H

#include <stddef.h>
#include <stdint.h>

// The version of this header; `couplet_version` has that of the library.
#define COUPLET_C_VERSION "0.1.0"
#define COUPLET_C_VERSION_MAJOR 0
#define COUPLET_C_VERSION_MINOR 1
#define COUPLET_C_VERSION_PATCH 0

// The same as a number: 10203 is 1.2.3.
#define COUPLET_C_VERSION_NUMBER \
  (10000 * COUPLET_C_VERSION_MAJOR + 100 * COUPLET_C_VERSION_MINOR + COUPLET_C_VERSION_PATCH)

// Everything asked was proved; also that an arch falls.
#define COUPLET_PROVED 0

// Something is undecided, or a certificate or a row of an array is refused.
#define COUPLET_OPEN 1

// The question makes no sense: `couplet_reason` says what was wrong and what is allowed.
#define COUPLET_USAGE 2

// Threads cannot be started, or a certificate has more digits than its checker is meant for.
#define COUPLET_RESOURCE 3

// A fault of couplet's own, which did not leave it.
#define COUPLET_FAULT 4

// For `couplet_text`: the bound below the value.
#define COUPLET_LOWER -1

// For `couplet_text`: the value, correctly rounded.
#define COUPLET_VALUE 0

// For `couplet_text`: the bound above the value.
#define COUPLET_UPPER 1

// In `verdict`: the arch stands, at some thickness or at the one that it has.
#define COUPLET_STANDS 0

// In `verdict`: it does not.
#define COUPLET_FALLS 1

// In `verdict`: nothing is known.
#define COUPLET_UNDECIDED 2

// In `verdict`: the row makes no sense: a number is none, or out of its range.
#define COUPLET_REFUSED 3

// In `mode`: there is none.
#define COUPLET_NO_MODE 255

// What comes back from a question. Its texts live as long as it does.
typedef struct couplet_answer couplet_answer;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// The state of an arch at its least thickness, proved: whether it stands at any thickness, the least one, how it
// collapses there, and the frictions at which that changes.
//
// weight: "heyman" or "milankovitch". half_opening: from the crown to the shoulder, between 0 and pi, exact text:
// radians ("1.4", "pi/2", "7/5") or degrees ("80deg"). friction: a coefficient, 0 or more ("0.6", "3/5", "inf"), or an
// angle ("31deg"). digits: significant digits, 1 to 1000000; up to 33 cost at most three times what few cost.
//
// Values: thickness (t/r), thrust (H/(w r)), intrinsic_thrust, rotation_joint and sliding_joint (rad from the crown),
// sliding_friction, rotational_friction, and asymmetric_thickness, the largest above the least at which an asymmetric
// mechanism is found and proved: none where none is found. Verdict: "stands" (an admissible symmetric state exists,
// which with friction does not exclude such a mechanism), "falls" or "undecided".
//
// A text may be a range: "79deg..81deg", "0.6+-10%", "0.5..inf". Then it is told of every arch inside, which says
// nothing of how likely one is. Values: the least and the largest of least_thickness and thrust, as lower and upper
// bound. Verdict: "all_can_stand" at some thickness, "none_can_stand", "both_occur" or "undecided".
int couplet_state(const char *weight,
                  const char *half_opening,
                  const char *friction,
                  size_t digits,
                  struct couplet_answer **answer);

// Whether an arch of a thickness stands, its safety factors, and the thrusts that it can bear, proved. The arch is as
// for `couplet_state`.
//
// thickness: t/r, above 0 and at most 2, exact text ("0.12", "3/25").
//
// Values: least_thickness, geometric_safety, required_friction, friction_safety, least_thrust, largest_thrust, the
// joints that limit the thrusts, and asymmetric_thickness as for `couplet_state`. Verdict: "stands", "falls" or
// "undecided"; a value that stays open beside it makes the code `COUPLET_OPEN`.
//
// With ranges, as for `couplet_state`: the ends of least_thickness, geometric_safety, required_friction,
// friction_safety and, where all stand, least_thrust and largest_thrust. Verdict: "all_stand", "none_stands",
// "both_occur" or "undecided".
int couplet_assess(const char *weight,
                   const char *half_opening,
                   const char *friction,
                   const char *thickness,
                   size_t digits,
                   struct couplet_answer **answer);

// An arch as it is measured, in ratios or in metres: as `couplet_assess` where it has a thickness, else as
// `couplet_state`.
//
// arch: fields with semicolons between them, named as the options of the command, in any order: "span=10m; rise=3m;
// thickness=60cm; friction=0.6; density=24kN/m3; depth=1m". any two of half_opening, span, rise and
// radius; friction or friction_angle; measured_at intrados, centreline or extrados.
//
// Fields may be ranges, as "span=10m+-2cm"; stones, a tilt and forces go with none.
//
// Values: those of these functions and, in metres, span_m, rise_m, half_opening_degrees, radius_m, thickness_m and
// least_thickness_m; with density and depth weight_kn and the thrusts in kN.
int couplet_arch(const char *weight,
                 const char *arch,
                 size_t digits,
                 struct couplet_answer **answer);

// A question the other way round: the one answer, with the proof that there is no other. What is not given is NULL.
//
// With a friction: the widest half opening that stands; with a half opening: the least friction; at the thickness, or
// at any if that is NULL. With the two modes of a boundary ("rrs/rsr") and either: where one becomes the other.
//
// Values: half_opening (rad), half_opening_degrees, friction, thickness, thrust, rotation_joint, sliding_joint.
// Verdict: "found", "nothing" or "undecided".
int couplet_find(const char *weight,
                 const char *modes,
                 const char *half_opening,
                 const char *friction,
                 const char *thickness,
                 size_t digits,
                 struct couplet_answer **answer);

// Constants of a landmark, each proved to exist, to be unique in a box, and to have the digits shown.
//
// landmark: symbol or name: "T" triple, "S" shift, "J" junction, "B" border, "l" rotation-end, "L" overturning-end,
// "sb" widest-joint. quantity: one, or several with commas ("thickness", "eta,mu"); NULL for all. digits: 1 to
// 1000000. threads: 1 to 1024, or 0 for one on each core; they end with the call.
//
// Verdict: "proved" or "undecided".
int couplet_constant(const char *landmark,
                     const char *weight,
                     const char *quantity,
                     size_t digits,
                     size_t threads,
                     struct couplet_answer **answer);

// A certificate of a landmark, which `couplet_check` accepts without trusting the solver; `couplet_json` has it.
// Arguments are as for `couplet_constant`.
int couplet_certify_landmark(const char *landmark,
                             const char *weight,
                             size_t digits,
                             size_t threads,
                             struct couplet_answer **answer);

// A certificate of the state of an arch at its least thickness, or why it stands at none; with a thickness, which may
// be NULL, that it stands with it or does not. Arguments are as for `couplet_assess`; with ranges it is of the verdict
// on every arch inside, made by a thread that ends with the call.
int couplet_certify_arch(const char *weight,
                         const char *half_opening,
                         const char *friction,
                         const char *thickness,
                         size_t digits,
                         struct couplet_answer **answer);

// Checks the bytes of a certificate: that the equations have the root claimed, and that every digit is right. Nothing
// that they say is believed, and any bytes get a verdict.
//
// engine: "astro", pure Rust, up to 50000 digits, which NULL is too; or "mpfr".
//
// Values: those of the certificate, without bounds. Verdict: "accepted"; "refused", with `COUPLET_OPEN`; "not checked"
// beyond the digits of the engine, with `COUPLET_RESOURCE`.
int couplet_check(const void *certificate,
                  size_t length,
                  const char *engine,
                  struct couplet_answer **answer);

// The states of `n` arches, or with thicknesses whether they stand, proved; each double is exactly the number that it
// is.
//
// weight: as for `couplet_state`, of all. half_opening, friction: `n` doubles each; infinity is a friction. thickness:
// `n` doubles, or NULL. quantities: names with commas ("thickness,thrust"), those of `couplet_state`, or with
// thicknesses those of `couplet_assess`; NULL for none. asymmetric_thickness costs rows only where such mechanisms are
// known. threads: 1 for the calling thread alone, up to 1024, or 0 for one on each core; they end with the call.
//
// verdict: `n` bytes, `COUPLET_STANDS`, `COUPLET_FALLS`, `COUPLET_UNDECIDED` or `COUPLET_REFUSED`. mode: `n` bytes,
// which `couplet_mode_name` names, or NULL. values: for each quantity `n` nearest doubles, then `n` lower bounds, then
// `n` upper bounds: the place of row i is `values[(3*q + b)*n + i]`, in a language with columns `values(i, b, q)`. Not
// a number where there is no value. NULL without quantities.
//
// A row that makes no sense, or is undecided, is a row: its verdict says so, the code is `COUPLET_OPEN`, and the
// reason counts such rows and has that of the first. Rows of one half opening share its proofs, and no bit depends on
// it, nor on the threads. Nothing may overlap what is written; if the code is 2 or more, nothing that is written may
// be used.
int couplet_states(const char *weight,
                   size_t n,
                   const double *half_opening,
                   const double *friction,
                   const double *thickness,
                   const char *quantities,
                   size_t threads,
                   uint8_t *verdict,
                   uint8_t *mode,
                   double *values,
                   struct couplet_answer **answer);

// The verdict, a word: of an arch "stands", "falls" or "undecided"; of what is found "found", "nothing" or
// "undecided"; of constants, certificates and arrays "proved" or "undecided"; of a check "accepted", "refused" or "not
// checked"; with ranges as the questions say. A question that makes no sense is "refused", any other failure
// "failed".
const char *couplet_verdict(const struct couplet_answer *answer);

// Why: why an arch falls, why something is undecided, what was wrong with the question; what is proved of something
// found; of a certificate that is accepted what it proves, in the words of the command. Empty where there is nothing
// to say.
const char *couplet_reason(const struct couplet_answer *answer);

// What may have been meant otherwise, as a friction of 31; empty where nothing may. The answer is that to what is
// written.
const char *couplet_note(const struct couplet_answer *answer);

// How the arch collapses at its least thickness, joints from the shoulder inward, as "[r,r,s]"; of a boundary both
// modes, as "[r,r,s]/[r,s,r]"; with ranges all that are known to occur. Empty where that is not asked, or there is
// none.
const char *couplet_mode(const struct couplet_answer *answer);

// How many values there are.
size_t couplet_count(const struct couplet_answer *answer);

// The name of the quantity of a value, counted from 0; empty if there are fewer.
const char *couplet_quantity(const struct couplet_answer *answer,
                             size_t index);

// A value as text, "inf" if it is infinite: correctly rounded to the digits asked for (`COUPLET_VALUE`), or a bound
// (`COUPLET_LOWER`, `COUPLET_UPPER`). With ranges there are bounds alone, which no arch is beyond; "none" for one
// where no thickness, or no friction, is enough. Empty if there is none: not of this arch, undecided, not asked for,
// no such name or bound. A certificate that is checked has no bounds. A quantity is a name as "thickness" or a letter
// as "eta".
const char *couplet_text(const struct couplet_answer *answer,
                         const char *quantity,
                         int which);

// A value as the nearest double, correctly rounded, between the two nearest doubles that are bounds of it. Any of the
// three pointers may be NULL. `COUPLET_PROVED` if there is such a value; `COUPLET_OPEN` if this answer has none, and
// `COUPLET_USAGE` if there is no such quantity or no answer: then all three are not a number. With ranges the value is
// not a number, nor a bound where no thickness, or no friction, is enough.
int couplet_double(const struct couplet_answer *answer,
                   const char *quantity,
                   double *value,
                   double *lower,
                   double *upper);

// The whole as JSON, as the command prints it (docs/columns.md); of `couplet_certify_landmark` and
// `couplet_certify_arch` the certificate, as its file has it. Empty of a check, of arrays, and where nothing could be
// asked. It is made at the first call.
const char *couplet_json(const struct couplet_answer *answer);

// Frees an answer with all its texts; NULL is nothing.
void couplet_free(struct couplet_answer *answer);

// The version of the library, as "0.1.0". The text is never freed.
const char *couplet_version(void);

// The label of a mode by its code in arrays, as "[r,r,s]"; empty if there is none. The text is never freed.
const char *couplet_mode_name(int code);

// Copies a text into a buffer of `size` bytes, zero included, for languages that have no pointers to texts, and
// returns its length without the zero. If that is not below `size`, the buffer gets the empty text: a number is not
// cut. A NULL text is empty; with a NULL buffer only the length is told.
size_t couplet_copy(const char *text,
                    char *buffer,
                    size_t size);

// Writes a double as the exact text of the number that it is, a fraction or "inf", which the functions of one question
// read; as `couplet_copy` does. What is not a number, and minus infinity, have no text: 0. 1100 bytes are always
// enough.
size_t couplet_exact(double x,
                     char *buffer,
                     size_t size);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* COUPLET_C_H */
