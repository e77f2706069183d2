//! Sentences of the paper, place by place, and what decides it: the data of the index.

use super::sentence::Decided::{Audit, Claims, Open};
use super::sentence::Sentence;

/// The sentences of a part of the paper: the place, what it says, and what decides it.
macro_rules! sentences {
    ($($place:literal: $says:literal, $decided:expr;)+) => {
        &[$(Sentence { place: $place, says: $says, decided: $decided }),+]
    };
}

/// Abstract and section 2: the equations.
pub(super) const EQUATIONS: &[Sentence] = sentences! {
    "Abstract": "the true weight does not change which modes there are", Claims(&["modes-occur"]);
    "Abstract": "the true weight bears more, so that Heyman's estimates are conservative",
        Claims(&["weights-same-opening"]);
    "Eq. (1)": "the intrinsic thrust is eta h = H/(gamma d r^2)", Claims(&["eq-1"]);
    "Fig. 1": "r is the inner radius", Claims(&["eq-1-radius"]);
    "Eq. (2)": "the thrust by the moment of the upper part about the inner hinge", Claims(&["eq-2"]);
    "Eq. (3)": "the thrust by the moment of the lower part about it", Claims(&["eq-3"]);
    "Eq. (4)": "the thrust by the moment of the half arch about the shoulder", Claims(&["eq-4"]);
    "Eq. (4)": "the half opening enters by A = alpha cot(alpha/2) alone", Claims(&["eq-4-forms"]);
    "Eq. (5)": "the thrust by tangency to the intrados, in two forms", Claims(&["eq-5", "eq-5-forms"]);
    "Eq. (5)": "beta cot(beta) is what is left where the arch is thin", Claims(&["eq-5-thin"]);
    "Eq. (6)": "the centroids lie at r (1 + eta^2/12), and fac_M >= 1", Claims(&["eq-6"]);
    "Eq. (7)": "A, eta and h of pure rotation are roots of three cubics",
        Claims(&["eq-7-A", "eq-7-eta", "eq-7-h"]);
    "Eq. (8)": "f and g, and the identity that links them", Claims(&["eq-8"]);
    "Eq. (9)": "the closed form of A", Claims(&["eq-9"]);
    "Eq. (10)": "the closed form of eta", Claims(&["eq-10"]);
    "Eq. (11)": "the closed form of h", Claims(&["eq-11"]);
    "Eq. (9)-(11)": "two real branches are meaningful", Claims(&["curve-thicknesses"]);
    "Eq. (12)": "the radicand under the roots of (9) to (11)", Claims(&["eq-12"]);
    "Eq. (12)": "it is negative up to beta_sb and vanishes there", Claims(&["eq-12-range"]);
    "Sec. 2.1": "there the rotational joint is stationary and widest", Claims(&["curve-widest"]);
    "Sec. 2.1": "digits of beta_sb and alpha_sb", Audit;
    "Sec. 2.1": "64.2° and 125.8° there", Claims(&["rounded-values"]);
    "Sec. 2.1, Fig. 2": "the rotational joint of Heyman's solution overshoots about and after its peak",
        Claims(&["weights-widest-joint", "weights-rotation"]);
    "Sec. 2.1, Fig. 2": "eta and h of the two weights differ minimally, even where thick",
        Claims(&["weights-minimal"]);
    "Sec. 2.1": "rotation ends at alpha_l, where the joint is back at 0 and h = 0",
        Claims(&["limit-l", "curve-order"]);
    "Sec. 2.1": "digits of alpha_l, eta_l and A_l", Audit;
    "Sec. 2.1": "rotation becomes overturning continuously",
        Claims(&["joining-heyman", "joining-milankovitch"]);
    "Sec. 2.1": "alpha_l and eta_l are slightly higher for Heyman's weight",
        Claims(&["weights-limits", "weights-slightly"]);
    "Sec. 2.1": "alpha_l is around 150° at eta_l near 1", Claims(&["rounded-values"]);
    "Eq. (13)": "A of the states without thrust, from (4) or from (3)", Claims(&["eq-13"]);
    "Eq. (14)": "the same for Heyman's weight, and its inverse", Claims(&["eq-14"]);
    "Eq. (15)": "the same for Milankovitch's weight, and its inverse", Claims(&["eq-15"]);
    "Eq. (16)": "the condition of l, from (5) in the limit", Claims(&["eq-16"]);
    "Sec. 2.1": "its roots: eta_l = 1 and A_l = 2/3; 2 (2√3 - 3) and √3 - 1", Claims(&["limit-l"]);
    "Sec. 2.1": "overturning goes on to eta = 2, with A_L = 1/2 and 2/3", Claims(&["limit-L"]);
    "Sec. 2.1, Fig. 3": "the root in (15) vanishes at A = 2/3, eta = 2", Claims(&["eq-15-branch"]);
    "Sec. 2.1, Fig. 3": "a vertical tangent in A and in alpha there", Claims(&["eq-15-branch"]);
    "Sec. 2.1": "at A = 2/3 overturning ends for one weight and rotation for the other",
        Claims(&["alpha-L-is-alpha-l"]);
    "Sec. 2.1": "the range in A and alpha is narrower for the true weight", Claims(&["weights-limits"]);
    "Sec. 2.1, Fig. 3": "the overturning trends of the two weights differ little",
        Claims(&["weights-overturning"]);
    "Sec. 2.1, Fig. 4": "both trends join with one slope at l",
        Claims(&["joining-heyman", "joining-milankovitch"]);
    "Sec. 2.1": "the growth of eta towards 2 is almost vertical", Claims(&["eq-15-branch"]);
    "Sec. 2.1": "rotation holds up to about 150°, or 160°", Claims(&["weights-range", "rounded-values"]);
    "Eq. (17)": "the friction at which the shoulder slides, and its inverse", Claims(&["eq-17"]);
    "Eq. (18)": "the friction at which an inner joint slides, at beta_s = √(h (1 - h))",
        Claims(&["eq-18", "eq-18-stationary"]);
    "Sec. 2.2": "sliding does not see the weight's centroids", Claims(&["sliding-thickness"]);
    "Sec. 2.2": "where a joint slides, friction sets the thrust", Claims(&["eq-17", "eq-18"]);
    "Sec. 2.2": "no thickness in (17), (18), no friction in (2) to (5), no half opening in (18)",
        Claims(&["sliding-thickness", "rotation-friction", "sliding-opening"]);
    "Sec. 2.2": "each half opening has one purely sliding state", Claims(&["sliding-order"]);
    "Sec. 2.2": "it ends at B, where eta = 2", Claims(&["map-B"]);
    "Sec. 2.2, Fig. 2": "its thrust goes flatly to 0 as alpha -> pi", Claims(&["sliding-flat"]);
    "Sec. 2.2, Fig. 2": "it meets rotation at T", Claims(&["map-T"]);
    "Sec. 2.2": "digits at T and B", Audit;
    "Sec. 2.3": "(2) to (5) describe pure rotation, (17) and (18) pure sliding", Claims(&["modes-seven"]);
    "Sec. 2.3": "five equations rule five variables", Claims(&["landmark-T"]);
};

/// Section 3: the map.
pub(super) const MAP: &[Sentence] = sentences! {
    "Sec. 3": "there are seven symmetric collapse modes", Claims(&["modes-seven", "modes-occur"]);
    "Sec. 3, Fig. 6": "their domains fill the strip between eta = 0 and 2", Claims(&["map-columns"]);
    "Sec. 3, Fig. 6": "[s,r,r] lies between [s,s] and [r,r,r], up to T",
        Claims(&["map-columns", "map-T-shoulder"]);
    "Sec. 3, Fig. 6": "[r,r,s] lies beyond T, below beta_r = beta_s", Claims(&["map-columns", "map-T-inner"]);
    "Sec. 3, Fig. 6": "[r,s,r] lies between beta_r = beta_s and beta_r = 0", Claims(&["map-columns"]);
    "Sec. 3, Fig. 6": "both lines tend to eta_l as mu -> inf", Claims(&["map-asymptotes"]);
    "Sec. 3, Fig. 6": "[r,s] lies between beta_r = 0 and eta = 2", Claims(&["map-columns", "map-J"]);
    "Sec. 3": "in [r,s] friction sets a thrust that is not zero", Claims(&["eq-18"]);
    "Sec. 3, Fig. 6": "[r] lies at mu = inf, from eta_l to 2, without thrust",
        Claims(&["modes-seven", "landmark-inside-unlimited", "limit-l", "limit-L"]);
    "Sec. 3": "one divide parts the modes with rotation from pure sliding", Claims(&["map-columns"]);
    "Tables 1-2": "digits of T, S, J, B for both weights", Audit;
    "Tables 3-4": "digits of l and L for both weights", Audit;
    "Tables 3-4": "A and eta at l and L in closed form", Claims(&["limit-l", "limit-L"]);
    "Sec. 3": "at the landmarks eta is lower for the true weight", Claims(&["weights-thickness"]);
    "Sec. 3": "at the landmarks mu is lower for the true weight", Claims(&["weights-friction"]);
    "Sec. 3": "at the landmarks alpha is lower for it", Claims(&["weights-opening"]);
    "Sec. 3": "at the landmarks h is higher for it", Claims(&["weights-thrust"]);
    "Sec. 3": "at the landmarks beta_r is wider for it", Claims(&["weights-beta-r"]);
    "Sec. 3": "at the landmarks beta_s is wider for it", Claims(&["weights-beta-s"]);
    "Sec. 3": "Heyman's weight is on the safe side", Claims(&["weights-same-opening"]);
    "Sec. 3, Fig. 5": "the dividing lines of the true weight lie below and left",
        Claims(&["weights-dividing-lines"]);
    "Sec. 3, Fig. 5": "the lines of one half opening of the true weight lie below",
        Claims(&["weights-same-opening"]);
    "Sec. 3": "the limits at mu = inf are lower in eta and alpha for the true weight",
        Claims(&["weights-limits", "weights-eta-l"]);
    "Sec. 3": "B is reached at a much lower mu, a slightly lower alpha",
        Claims(&["weights-friction", "weights-opening", "weights-slightly"]);
    "Sec. 3, Fig. 5": "the weights differ most at B", Claims(&["weights-at-B"]);
    "Sec. 3, Fig. 5": "from J to B the true line deviates to the left, the more the thicker",
        Claims(&["weights-J-B"]);
    "Sec. 3, Fig. 5": "it arrives almost vertically at eta = 2", Claims(&["weights-B-slope"]);
    "Sec. 3": "mu is almost saturated there", Claims(&["weights-B-slope"]);
    "Sec. 3": "a friction above mu_T precludes [s,r,r]", Claims(&["map-T-shoulder"]);
    "Sec. 3": "a friction above mu_B precludes [s,s]", Claims(&["map-B"]);
    "Sec. 3": "[r,r,s] and [r,s,r] are seen only right of T", Claims(&["map-T-inner"]);
    "Sec. 3": "[r,s] is seen only right of J", Claims(&["map-J"]);
    "Sec. 3": "there an inner joint asks for more friction than the shoulder", Claims(&["map-T-frictions"]);
    "Sec. 3": "overturning without thrust needs infinite friction", Claims(&["landmark-l"]);
    "Sec. 3": "the joints are slightly wider for the true weight",
        Claims(&["weights-beta-r", "weights-beta-s", "weights-slightly"]);
    "Sec. 3": "the dependences on the joints are flatter",
        Open("which dependences, and flatter than which, is not said");
};

/// Section 4: the states at the landmarks, and the complementarity problem.
pub(super) const ILLUSTRATION: &[Sentence] = sentences! {
    "Eq. (19)": "the complementarity problem of the discretised arch",
        Open("its conditions are those of modes-seven and asymmetric-motion, at every joint; no claim speaks of the \
              discretised form");
    "Eq. (20)": "a programme whose least value is zero at collapse",
        Open("of an arch of given stones couplet complementarity --thickness encloses it; no claim speaks of it");
    "Sec. 4": "that value comes out in the order of 1e-16, at the same cost for both weights",
        Open("it is about the program of the authors");
    "Sec. 4, Fig. 7-12": "the lines of thrust and of friction are inside the arch at T, S, J, B, l, L",
        Claims(&["landmark-inside", "landmark-inside-unlimited"]);
    "Fig. 7-12": "digits in the captions", Audit;
    "Sec. 4, Fig. 7-8": "four modes hold at T",
        Claims(&["landmark-T", "landmark-inside", "landmark-T-modes"]);
    "Sec. 4, Fig. 7-8": "any three of their mechanisms give the fourth", Claims(&["landmark-T-modes"]);
    "Sec. 4": "angles near 140°, 52°, 60°, 20° at T", Claims(&["rounded-values"]);
    "Sec. 4, Fig. 9": "at S one joint turns and slides, [r+s]", Claims(&["landmark-S", "landmark-S-joint"]);
    "Sec. 4": "angles near 145°, 57°, 16° at S", Claims(&["rounded-values"]);
    "Sec. 4, Fig. 10": "at J beta_r = 0, and [r,s] begins", Claims(&["landmark-J"]);
    "Sec. 4": "S and J are rather near", Claims(&["landmark-S-near-J"]);
    "Sec. 4, Fig. 11": "at B eta = 2, and [r,s] meets [s,s]", Claims(&["landmark-inside"]);
    "Sec. 4": "angles near 150°, 62°, 14° at B", Claims(&["rounded-values"]);
    "Sec. 4, Fig. 12": "at l and L the half arch overturns without thrust", Claims(&["landmark-l"]);
    "Sec. 4": "about 150° at l and L", Claims(&["rounded-values"]);
    "Sec. 4": "the two weights differ more towards B, from J on where eta is 0.9 to 2",
        Claims(&["weights-at-B", "rounded-values"]);
};

/// Section 5: the conclusions.
pub(super) const CONCLUSIONS: &[Sentence] = sentences! {
    "Sec. 5": "a friction of about 1.277 prevents [s,r,r]", Claims(&["suffices-T"]);
    "Sec. 5": "that friction is 52°, around 50°", Claims(&["rounded-values"]);
    "Sec. 5": "left of T [s,r,r] may be, with alpha below 2.43", Claims(&["map-T-shoulder"]);
    "Sec. 5": "for the semicircle about 0.395 prevents sliding", Claims(&["semicircle"]);
    "Sec. 5": "the friction of the semicircle is 22°, around 20°", Claims(&["rounded-values"]);
    "Sec. 5": "right of T inner sliding takes more eta and mu", Claims(&["map-T-inner"]);
    "Sec. 5": "the friction that prevents sliding grows with alpha, without bound",
        Claims(&["friction-rotation"]);
    "Sec. 5": "finite friction turns overturning into [r,s]", Claims(&["map-beyond-l"]);
    "Sec. 5": "a friction of about 1.854 prevents [s,s]", Claims(&["suffices-B"]);
    "Sec. 5": "the least thickness is unique, though friction is not associated: for symmetric motions",
        Claims(&["unique-thickness"]);
    "Sec. 5": "the least thickness is unique for asymmetric motions too", Claims(&["unique-asymmetric"]);
    "Sec. 5": "differences are marginal up to the semicircle", Claims(&["weights-marginal"]);
    "Sec. 5": "the differences grow for horseshoes", Claims(&["weights-differences"]);
    "Sec. 5": "the kinds of modes are the same for both weights", Claims(&["modes-occur"]);
};
