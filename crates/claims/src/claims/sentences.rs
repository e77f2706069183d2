//! What the paper says, place by place, and what decides it: the data of the index.

use super::sentence::{Decided, Sentence};
use Decided::{Audit, Claims, Open};

const fn said(
    place: &'static str,
    says: &'static str,
    claims: &'static [&'static str],
) -> Sentence {
    Sentence { place, says, decided: Claims(claims) }
}

const fn printed(place: &'static str, says: &'static str) -> Sentence {
    Sentence { place, says, decided: Audit }
}

/// Abstract and section 2: the equations.
pub(super) const EQUATIONS: &[Sentence] = &[
    said("Abstract", "the true weight does not change which modes there are", &["modes-occur"]),
    said(
        "Abstract",
        "the true weight bears more, so that Heyman's estimates are conservative",
        &["weights-same-opening"],
    ),
    said("Eq. (1)", "the intrinsic thrust is eta h = H/(gamma d r^2)", &["eq-1"]),
    said("Fig. 1", "r is the inner radius", &["eq-1-radius"]),
    said("Eq. (2)", "the thrust by the moment of the upper part about the inner hinge", &["eq-2"]),
    said("Eq. (3)", "the thrust by the moment of the lower part about it", &["eq-3"]),
    said("Eq. (4)", "the thrust by the moment of the half arch about the shoulder", &["eq-4"]),
    said("Eq. (4)", "the half opening enters by A = alpha cot(alpha/2) alone", &["eq-4-forms"]),
    said(
        "Eq. (5)",
        "the thrust by tangency to the intrados, in two forms",
        &["eq-5", "eq-5-forms"],
    ),
    said("Eq. (5)", "beta cot(beta) is what is left where the arch is thin", &["eq-5-thin"]),
    said("Eq. (6)", "the centroids lie at r (1 + eta^2/12), and fac_M >= 1", &["eq-6"]),
    said(
        "Eq. (7)",
        "A, eta and h of pure rotation are roots of three cubics",
        &["eq-7-A", "eq-7-eta", "eq-7-h"],
    ),
    said("Eq. (8)", "f and g, and the identity that links them", &["eq-8"]),
    said("Eq. (9)", "the closed form of A", &["eq-9"]),
    said("Eq. (10)", "the closed form of eta", &["eq-10"]),
    said("Eq. (11)", "the closed form of h", &["eq-11"]),
    said("Eq. (9)-(11)", "two real branches are meaningful", &["curve-thicknesses"]),
    said("Eq. (12)", "the radicand under the roots of (9) to (11)", &["eq-12"]),
    said("Eq. (12)", "it is negative up to beta_sb and vanishes there", &["eq-12-range"]),
    said("Sec. 2.1", "there the rotational joint is stationary and widest", &["curve-widest"]),
    printed("Sec. 2.1", "digits of beta_sb and alpha_sb"),
    said("Sec. 2.1", "64.2° and 125.8° there", &["rounded-values"]),
    said(
        "Sec. 2.1, Fig. 2",
        "the rotational joint of Heyman's solution overshoots about and after its peak",
        &["weights-widest-joint", "weights-rotation"],
    ),
    said(
        "Sec. 2.1, Fig. 2",
        "eta and h of the two weights differ minimally, even where thick",
        &["weights-minimal"],
    ),
    said(
        "Sec. 2.1",
        "rotation ends at alpha_l, where the joint is back at 0 and h = 0",
        &["limit-l", "curve-order"],
    ),
    printed("Sec. 2.1", "digits of alpha_l, eta_l and A_l"),
    said(
        "Sec. 2.1",
        "rotation becomes overturning continuously",
        &["joining-heyman", "joining-milankovitch"],
    ),
    said(
        "Sec. 2.1",
        "alpha_l and eta_l are slightly higher for Heyman's weight",
        &["weights-limits", "weights-slightly"],
    ),
    said("Sec. 2.1", "alpha_l is around 150° at eta_l near 1", &["rounded-values"]),
    said("Eq. (13)", "A of the states without thrust, from (4) or from (3)", &["eq-13"]),
    said("Eq. (14)", "the same for Heyman's weight, and its inverse", &["eq-14"]),
    said("Eq. (15)", "the same for Milankovitch's weight, and its inverse", &["eq-15"]),
    said("Eq. (16)", "the condition of l, from (5) in the limit", &["eq-16"]),
    said("Sec. 2.1", "its roots: eta_l = 1 and A_l = 2/3; 2 (2√3 - 3) and √3 - 1", &["limit-l"]),
    said("Sec. 2.1", "overturning goes on to eta = 2, with A_L = 1/2 and 2/3", &["limit-L"]),
    said("Sec. 2.1, Fig. 3", "the root in (15) vanishes at A = 2/3, eta = 2", &["eq-15-branch"]),
    said("Sec. 2.1, Fig. 3", "a vertical tangent in A and in alpha there", &["eq-15-branch"]),
    said(
        "Sec. 2.1",
        "at A = 2/3 overturning ends for one weight and rotation for the other",
        &["alpha-L-is-alpha-l"],
    ),
    said(
        "Sec. 2.1",
        "the range in A and alpha is narrower for the true weight",
        &["weights-limits"],
    ),
    said(
        "Sec. 2.1, Fig. 3",
        "the overturning trends of the two weights differ little",
        &["weights-overturning"],
    ),
    said(
        "Sec. 2.1, Fig. 4",
        "both trends join with one slope at l",
        &["joining-heyman", "joining-milankovitch"],
    ),
    said("Sec. 2.1", "the growth of eta towards 2 is almost vertical", &["eq-15-branch"]),
    said(
        "Sec. 2.1",
        "rotation holds up to about 150°, or 160°",
        &["weights-range", "rounded-values"],
    ),
    said("Eq. (17)", "the friction at which the shoulder slides, and its inverse", &["eq-17"]),
    said(
        "Eq. (18)",
        "the friction at which an inner joint slides, at beta_s = √(h (1 - h))",
        &["eq-18", "eq-18-stationary"],
    ),
    said("Sec. 2.2", "sliding does not see the weight's centroids", &["sliding-thickness"]),
    said("Sec. 2.2", "where a joint slides, friction sets the thrust", &["eq-17", "eq-18"]),
    said(
        "Sec. 2.2",
        "no thickness in (17), (18), no friction in (2) to (5), no half opening in (18)",
        &["sliding-thickness", "rotation-friction", "sliding-opening"],
    ),
    said("Sec. 2.2", "each half opening has one purely sliding state", &["sliding-order"]),
    said("Sec. 2.2", "it ends at B, where eta = 2", &["map-B"]),
    said("Sec. 2.2, Fig. 2", "its thrust goes flatly to 0 as alpha -> pi", &["sliding-flat"]),
    said("Sec. 2.2, Fig. 2", "it meets rotation at T", &["map-T"]),
    printed("Sec. 2.2", "digits at T and B"),
    said(
        "Sec. 2.3",
        "(2) to (5) describe pure rotation, (17) and (18) pure sliding",
        &["modes-seven"],
    ),
    said("Sec. 2.3", "five equations rule five variables", &["landmark-T"]),
];

/// Section 3: the map.
pub(super) const MAP: &[Sentence] = &[
    said("Sec. 3", "there are seven symmetric collapse modes", &["modes-seven", "modes-occur"]),
    said("Sec. 3, Fig. 6", "their domains fill the strip between eta = 0 and 2", &["map-columns"]),
    said(
        "Sec. 3, Fig. 6",
        "[s,r,r] lies between [s,s] and [r,r,r], up to T",
        &["map-columns", "map-T-shoulder"],
    ),
    said(
        "Sec. 3, Fig. 6",
        "[r,r,s] lies beyond T, below beta_r = beta_s",
        &["map-columns", "map-T-inner"],
    ),
    said("Sec. 3, Fig. 6", "[r,s,r] lies between beta_r = beta_s and beta_r = 0", &["map-columns"]),
    said("Sec. 3, Fig. 6", "both lines tend to eta_l as mu -> inf", &["map-asymptotes"]),
    said("Sec. 3, Fig. 6", "[r,s] lies between beta_r = 0 and eta = 2", &["map-columns", "map-J"]),
    said("Sec. 3", "in [r,s] friction sets a thrust that is not zero", &["eq-18"]),
    said(
        "Sec. 3, Fig. 6",
        "[r] lies at mu = inf, from eta_l to 2, without thrust",
        &["modes-seven", "landmark-inside-unlimited", "limit-l", "limit-L"],
    ),
    said("Sec. 3", "one divide parts the modes with rotation from pure sliding", &["map-columns"]),
    printed("Tables 1-2", "digits of T, S, J, B for both weights"),
    printed("Tables 3-4", "digits of l and L for both weights"),
    said("Tables 3-4", "A and eta at l and L in closed form", &["limit-l", "limit-L"]),
    said("Sec. 3", "at the landmarks eta is lower for the true weight", &["weights-thickness"]),
    said("Sec. 3", "at the landmarks mu is lower for the true weight", &["weights-friction"]),
    said("Sec. 3", "at the landmarks alpha is lower for it", &["weights-opening"]),
    said("Sec. 3", "at the landmarks h is higher for it", &["weights-thrust"]),
    said("Sec. 3", "at the landmarks beta_r is wider for it", &["weights-beta-r"]),
    said("Sec. 3", "at the landmarks beta_s is wider for it", &["weights-beta-s"]),
    said("Sec. 3", "Heyman's weight is on the safe side", &["weights-same-opening"]),
    said(
        "Sec. 3, Fig. 5",
        "the dividing lines of the true weight lie below and left",
        &["weights-dividing-lines"],
    ),
    said(
        "Sec. 3, Fig. 5",
        "the lines of one half opening of the true weight lie below",
        &["weights-same-opening"],
    ),
    said(
        "Sec. 3",
        "the limits at mu = inf are lower in eta and alpha for the true weight",
        &["weights-limits", "weights-eta-l"],
    ),
    said(
        "Sec. 3",
        "B is reached at a much lower mu, a slightly lower alpha",
        &["weights-friction", "weights-opening", "weights-slightly"],
    ),
    said("Sec. 3, Fig. 5", "the weights differ most at B", &["weights-at-B"]),
    said(
        "Sec. 3, Fig. 5",
        "from J to B the true line deviates to the left, the more the thicker",
        &["weights-J-B"],
    ),
    said("Sec. 3, Fig. 5", "it arrives almost vertically at eta = 2", &["weights-B-slope"]),
    said("Sec. 3", "mu is almost saturated there", &["weights-B-slope"]),
    said("Sec. 3", "a friction above mu_T precludes [s,r,r]", &["map-T-shoulder"]),
    said("Sec. 3", "a friction above mu_B precludes [s,s]", &["map-B"]),
    said("Sec. 3", "[r,r,s] and [r,s,r] are seen only right of T", &["map-T-inner"]),
    said("Sec. 3", "[r,s] is seen only right of J", &["map-J"]),
    said(
        "Sec. 3",
        "there an inner joint asks for more friction than the shoulder",
        &["map-T-frictions"],
    ),
    said("Sec. 3", "overturning without thrust needs infinite friction", &["landmark-l"]),
    said(
        "Sec. 3",
        "the joints are slightly wider for the true weight",
        &["weights-beta-r", "weights-beta-s", "weights-slightly"],
    ),
    Sentence {
        place: "Sec. 3",
        says: "the dependences on the joints are flatter",
        decided: Open("which dependences, and flatter than which, is not said"),
    },
];

/// Section 4: the states at the landmarks, and the complementarity problem.
pub(super) const ILLUSTRATION: &[Sentence] = &[
    Sentence {
        place: "Eq. (19)",
        says: "the complementarity problem of the discretised arch",
        decided: Open(
            "its conditions are those of modes-seven and asymmetric-motion, at every joint; no claim speaks of the discretised form",
        ),
    },
    Sentence {
        place: "Eq. (20)",
        says: "a programme whose least value is zero at collapse",
        decided: Open(
            "of an arch of given stones couplet complementarity --thickness encloses it; no claim speaks of it",
        ),
    },
    Sentence {
        place: "Sec. 4",
        says: "that value comes out in the order of 1e-16, at the same cost for both weights",
        decided: Open("it is about the program of the authors"),
    },
    said(
        "Sec. 4, Fig. 7-12",
        "the lines of thrust and of friction are inside the arch at T, S, J, B, l, L",
        &["landmark-inside", "landmark-inside-unlimited"],
    ),
    printed("Fig. 7-12", "digits in the captions"),
    said(
        "Sec. 4, Fig. 7-8",
        "four modes hold at T",
        &["landmark-T", "landmark-inside", "landmark-T-modes"],
    ),
    said(
        "Sec. 4, Fig. 7-8",
        "any three of their mechanisms give the fourth",
        &["landmark-T-modes"],
    ),
    said("Sec. 4", "angles near 140°, 52°, 60°, 20° at T", &["rounded-values"]),
    said(
        "Sec. 4, Fig. 9",
        "at S one joint turns and slides, [r+s]",
        &["landmark-S", "landmark-S-joint"],
    ),
    said("Sec. 4", "angles near 145°, 57°, 16° at S", &["rounded-values"]),
    said("Sec. 4, Fig. 10", "at J beta_r = 0, and [r,s] begins", &["landmark-J"]),
    said("Sec. 4", "S and J are rather near", &["landmark-S-near-J"]),
    said("Sec. 4, Fig. 11", "at B eta = 2, and [r,s] meets [s,s]", &["landmark-inside"]),
    said("Sec. 4", "angles near 150°, 62°, 14° at B", &["rounded-values"]),
    said("Sec. 4, Fig. 12", "at l and L the half arch overturns without thrust", &["landmark-l"]),
    said("Sec. 4", "about 150° at l and L", &["rounded-values"]),
    said(
        "Sec. 4",
        "the two weights differ more towards B, from J on where eta is 0.9 to 2",
        &["weights-at-B", "rounded-values"],
    ),
];

/// Section 5: the conclusions.
pub(super) const CONCLUSIONS: &[Sentence] = &[
    said("Sec. 5", "a friction of about 1.277 prevents [s,r,r]", &["suffices-T"]),
    said("Sec. 5", "that friction is 52°, around 50°", &["rounded-values"]),
    said("Sec. 5", "left of T [s,r,r] may be, with alpha below 2.43", &["map-T-shoulder"]),
    said("Sec. 5", "for the semicircle about 0.395 prevents sliding", &["semicircle"]),
    said("Sec. 5", "the friction of the semicircle is 22°, around 20°", &["rounded-values"]),
    said("Sec. 5", "right of T inner sliding takes more eta and mu", &["map-T-inner"]),
    said(
        "Sec. 5",
        "the friction that prevents sliding grows with alpha, without bound",
        &["friction-rotation"],
    ),
    said("Sec. 5", "finite friction turns overturning into [r,s]", &["map-beyond-l"]),
    said("Sec. 5", "a friction of about 1.854 prevents [s,s]", &["suffices-B"]),
    said(
        "Sec. 5",
        "the least thickness is unique, though friction is not associated: for symmetric motions",
        &["unique-thickness"],
    ),
    said(
        "Sec. 5",
        "the least thickness is unique for asymmetric motions too",
        &["unique-asymmetric"],
    ),
    said("Sec. 5", "differences are marginal up to the semicircle", &["weights-marginal"]),
    said("Sec. 5", "the differences grow for horseshoes", &["weights-differences"]),
    said("Sec. 5", "the kinds of modes are the same for both weights", &["modes-occur"]),
];
