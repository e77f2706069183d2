//! Sentences of the paper, place by place, and what decides it: the data of the index.

use super::sentence::{Decided, Sentence};

/// A sentence that claims decide.
const fn said(place: &'static str, says: &'static str) -> Sentence {
    Sentence { place, says, decided: Decided::Claims(&[]) }
}

/// Digits.
const fn printed(place: &'static str, says: &'static str) -> Sentence {
    Sentence { place, says, decided: Decided::Audit }
}

/// Abstract and section 2: the equations.
pub(super) const EQUATIONS: &[Sentence] = &[
    said("Abstract", "the true weight does not change which modes there are").by(&["modes-occur"]),
    said("Abstract", "the true weight bears more, so that Heyman's estimates are conservative")
        .by(&["weights-same-opening"]),
    said("Eq. (1)", "the intrinsic thrust is eta h = H/(gamma d r^2)").by(&["eq-1"]),
    said("Fig. 1", "r is the inner radius").by(&["eq-1-radius"]),
    said("Eq. (2)", "the thrust by the moment of the upper part about the inner hinge")
        .by(&["eq-2"]),
    said("Eq. (3)", "the thrust by the moment of the lower part about it").by(&["eq-3"]),
    said("Eq. (4)", "the thrust by the moment of the half arch about the shoulder").by(&["eq-4"]),
    said("Eq. (4)", "the half opening enters by A = alpha cot(alpha/2) alone").by(&["eq-4-forms"]),
    said("Eq. (5)", "the thrust by tangency to the intrados, in two forms")
        .by(&["eq-5", "eq-5-forms"]),
    said("Eq. (5)", "beta cot(beta) is what is left where the arch is thin").by(&["eq-5-thin"]),
    said("Eq. (6)", "the centroids lie at r (1 + eta^2/12), and fac_M >= 1").by(&["eq-6"]),
    said("Eq. (7)", "A, eta and h of pure rotation are roots of three cubics")
        .by(&["eq-7-A", "eq-7-eta", "eq-7-h"]),
    said("Eq. (8)", "f and g, and the identity that links them").by(&["eq-8"]),
    said("Eq. (9)", "the closed form of A").by(&["eq-9"]),
    said("Eq. (10)", "the closed form of eta").by(&["eq-10"]),
    said("Eq. (11)", "the closed form of h").by(&["eq-11"]),
    said("Eq. (9)-(11)", "two real branches are meaningful").by(&["curve-thicknesses"]),
    said("Eq. (12)", "the radicand under the roots of (9) to (11)").by(&["eq-12"]),
    said("Eq. (12)", "it is negative up to beta_sb and vanishes there").by(&["eq-12-range"]),
    said("Sec. 2.1", "there the rotational joint is stationary and widest").by(&["curve-widest"]),
    printed("Sec. 2.1", "digits of beta_sb and alpha_sb"),
    said("Sec. 2.1", "64.2° and 125.8° there").by(&["rounded-values"]),
    said(
        "Sec. 2.1, Fig. 2",
        "the rotational joint of Heyman's solution overshoots about and after its peak",
    )
    .by(&["weights-widest-joint", "weights-rotation"]),
    said("Sec. 2.1, Fig. 2", "eta and h of the two weights differ minimally, even where thick")
        .by(&["weights-minimal"]),
    said("Sec. 2.1", "rotation ends at alpha_l, where the joint is back at 0 and h = 0")
        .by(&["limit-l", "curve-order"]),
    printed("Sec. 2.1", "digits of alpha_l, eta_l and A_l"),
    said("Sec. 2.1", "rotation becomes overturning continuously")
        .by(&["joining-heyman", "joining-milankovitch"]),
    said("Sec. 2.1", "alpha_l and eta_l are slightly higher for Heyman's weight")
        .by(&["weights-limits", "weights-slightly"]),
    said("Sec. 2.1", "alpha_l is around 150° at eta_l near 1").by(&["rounded-values"]),
    said("Eq. (13)", "A of the states without thrust, from (4) or from (3)").by(&["eq-13"]),
    said("Eq. (14)", "the same for Heyman's weight, and its inverse").by(&["eq-14"]),
    said("Eq. (15)", "the same for Milankovitch's weight, and its inverse").by(&["eq-15"]),
    said("Eq. (16)", "the condition of l, from (5) in the limit").by(&["eq-16"]),
    said("Sec. 2.1", "its roots: eta_l = 1 and A_l = 2/3; 2 (2√3 - 3) and √3 - 1").by(&["limit-l"]),
    said("Sec. 2.1", "overturning goes on to eta = 2, with A_L = 1/2 and 2/3").by(&["limit-L"]),
    said("Sec. 2.1, Fig. 3", "the root in (15) vanishes at A = 2/3, eta = 2").by(&["eq-15-branch"]),
    said("Sec. 2.1, Fig. 3", "a vertical tangent in A and in alpha there").by(&["eq-15-branch"]),
    said("Sec. 2.1", "at A = 2/3 overturning ends for one weight and rotation for the other")
        .by(&["alpha-L-is-alpha-l"]),
    said("Sec. 2.1", "the range in A and alpha is narrower for the true weight")
        .by(&["weights-limits"]),
    said("Sec. 2.1, Fig. 3", "the overturning trends of the two weights differ little")
        .by(&["weights-overturning"]),
    said("Sec. 2.1, Fig. 4", "both trends join with one slope at l")
        .by(&["joining-heyman", "joining-milankovitch"]),
    said("Sec. 2.1", "the growth of eta towards 2 is almost vertical").by(&["eq-15-branch"]),
    said("Sec. 2.1", "rotation holds up to about 150°, or 160°")
        .by(&["weights-range", "rounded-values"]),
    said("Eq. (17)", "the friction at which the shoulder slides, and its inverse").by(&["eq-17"]),
    said("Eq. (18)", "the friction at which an inner joint slides, at beta_s = √(h (1 - h))")
        .by(&["eq-18", "eq-18-stationary"]),
    said("Sec. 2.2", "sliding does not see the weight's centroids").by(&["sliding-thickness"]),
    said("Sec. 2.2", "where a joint slides, friction sets the thrust").by(&["eq-17", "eq-18"]),
    said(
        "Sec. 2.2",
        "no thickness in (17), (18), no friction in (2) to (5), no half opening in (18)",
    )
    .by(&["sliding-thickness", "rotation-friction", "sliding-opening"]),
    said("Sec. 2.2", "each half opening has one purely sliding state").by(&["sliding-order"]),
    said("Sec. 2.2", "it ends at B, where eta = 2").by(&["map-B"]),
    said("Sec. 2.2, Fig. 2", "its thrust goes flatly to 0 as alpha -> pi").by(&["sliding-flat"]),
    said("Sec. 2.2, Fig. 2", "it meets rotation at T").by(&["map-T"]),
    printed("Sec. 2.2", "digits at T and B"),
    said("Sec. 2.3", "(2) to (5) describe pure rotation, (17) and (18) pure sliding")
        .by(&["modes-seven"]),
    said("Sec. 2.3", "five equations rule five variables").by(&["landmark-T"]),
];

/// Section 3: the map.
pub(super) const MAP: &[Sentence] = &[
    said("Sec. 3", "there are seven symmetric collapse modes").by(&["modes-seven", "modes-occur"]),
    said("Sec. 3, Fig. 6", "their domains fill the strip between eta = 0 and 2")
        .by(&["map-columns"]),
    said("Sec. 3, Fig. 6", "[s,r,r] lies between [s,s] and [r,r,r], up to T")
        .by(&["map-columns", "map-T-shoulder"]),
    said("Sec. 3, Fig. 6", "[r,r,s] lies beyond T, below beta_r = beta_s")
        .by(&["map-columns", "map-T-inner"]),
    said("Sec. 3, Fig. 6", "[r,s,r] lies between beta_r = beta_s and beta_r = 0")
        .by(&["map-columns"]),
    said("Sec. 3, Fig. 6", "both lines tend to eta_l as mu -> inf").by(&["map-asymptotes"]),
    said("Sec. 3, Fig. 6", "[r,s] lies between beta_r = 0 and eta = 2")
        .by(&["map-columns", "map-J"]),
    said("Sec. 3", "in [r,s] friction sets a thrust that is not zero").by(&["eq-18"]),
    said("Sec. 3, Fig. 6", "[r] lies at mu = inf, from eta_l to 2, without thrust").by(&[
        "modes-seven",
        "landmark-inside-unlimited",
        "limit-l",
        "limit-L",
    ]),
    said("Sec. 3", "one divide parts the modes with rotation from pure sliding")
        .by(&["map-columns"]),
    printed("Tables 1-2", "digits of T, S, J, B for both weights"),
    printed("Tables 3-4", "digits of l and L for both weights"),
    said("Tables 3-4", "A and eta at l and L in closed form").by(&["limit-l", "limit-L"]),
    said("Sec. 3", "at the landmarks eta is lower for the true weight").by(&["weights-thickness"]),
    said("Sec. 3", "at the landmarks mu is lower for the true weight").by(&["weights-friction"]),
    said("Sec. 3", "at the landmarks alpha is lower for it").by(&["weights-opening"]),
    said("Sec. 3", "at the landmarks h is higher for it").by(&["weights-thrust"]),
    said("Sec. 3", "at the landmarks beta_r is wider for it").by(&["weights-beta-r"]),
    said("Sec. 3", "at the landmarks beta_s is wider for it").by(&["weights-beta-s"]),
    said("Sec. 3", "Heyman's weight is on the safe side").by(&["weights-same-opening"]),
    said("Sec. 3, Fig. 5", "the dividing lines of the true weight lie below and left")
        .by(&["weights-dividing-lines"]),
    said("Sec. 3, Fig. 5", "the lines of one half opening of the true weight lie below")
        .by(&["weights-same-opening"]),
    said("Sec. 3", "the limits at mu = inf are lower in eta and alpha for the true weight")
        .by(&["weights-limits", "weights-eta-l"]),
    said("Sec. 3", "B is reached at a much lower mu, a slightly lower alpha").by(&[
        "weights-friction",
        "weights-opening",
        "weights-slightly",
    ]),
    said("Sec. 3, Fig. 5", "the weights differ most at B").by(&["weights-at-B"]),
    said("Sec. 3, Fig. 5", "from J to B the true line deviates to the left, the more the thicker")
        .by(&["weights-J-B"]),
    said("Sec. 3, Fig. 5", "it arrives almost vertically at eta = 2").by(&["weights-B-slope"]),
    said("Sec. 3", "mu is almost saturated there").by(&["weights-B-slope"]),
    said("Sec. 3", "a friction above mu_T precludes [s,r,r]").by(&["map-T-shoulder"]),
    said("Sec. 3", "a friction above mu_B precludes [s,s]").by(&["map-B"]),
    said("Sec. 3", "[r,r,s] and [r,s,r] are seen only right of T").by(&["map-T-inner"]),
    said("Sec. 3", "[r,s] is seen only right of J").by(&["map-J"]),
    said("Sec. 3", "there an inner joint asks for more friction than the shoulder")
        .by(&["map-T-frictions"]),
    said("Sec. 3", "overturning without thrust needs infinite friction").by(&["landmark-l"]),
    said("Sec. 3", "the joints are slightly wider for the true weight").by(&[
        "weights-beta-r",
        "weights-beta-s",
        "weights-slightly",
    ]),
    said("Sec. 3", "the dependences on the joints are flatter")
        .open("which dependences, and flatter than which, is not said"),
];

/// Section 4: the states at the landmarks, and the complementarity problem.
pub(super) const ILLUSTRATION: &[Sentence] = &[
    said("Eq. (19)", "the complementarity problem of the discretised arch").open(
        "its conditions are those of modes-seven and asymmetric-motion, at every joint; no claim \
         speaks of the discretised form",
    ),
    said("Eq. (20)", "a programme whose least value is zero at collapse").open(
        "of an arch of given stones couplet complementarity --thickness encloses it; no claim \
         speaks of it",
    ),
    said("Sec. 4", "that value comes out in the order of 1e-16, at the same cost for both weights")
        .open("it is about the program of the authors"),
    said(
        "Sec. 4, Fig. 7-12",
        "the lines of thrust and of friction are inside the arch at T, S, J, B, l, L",
    )
    .by(&["landmark-inside", "landmark-inside-unlimited"]),
    printed("Fig. 7-12", "digits in the captions"),
    said("Sec. 4, Fig. 7-8", "four modes hold at T").by(&[
        "landmark-T",
        "landmark-inside",
        "landmark-T-modes",
    ]),
    said("Sec. 4, Fig. 7-8", "any three of their mechanisms give the fourth")
        .by(&["landmark-T-modes"]),
    said("Sec. 4", "angles near 140°, 52°, 60°, 20° at T").by(&["rounded-values"]),
    said("Sec. 4, Fig. 9", "at S one joint turns and slides, [r+s]")
        .by(&["landmark-S", "landmark-S-joint"]),
    said("Sec. 4", "angles near 145°, 57°, 16° at S").by(&["rounded-values"]),
    said("Sec. 4, Fig. 10", "at J beta_r = 0, and [r,s] begins").by(&["landmark-J"]),
    said("Sec. 4", "S and J are rather near").by(&["landmark-S-near-J"]),
    said("Sec. 4, Fig. 11", "at B eta = 2, and [r,s] meets [s,s]").by(&["landmark-inside"]),
    said("Sec. 4", "angles near 150°, 62°, 14° at B").by(&["rounded-values"]),
    said("Sec. 4, Fig. 12", "at l and L the half arch overturns without thrust")
        .by(&["landmark-l"]),
    said("Sec. 4", "about 150° at l and L").by(&["rounded-values"]),
    said("Sec. 4", "the two weights differ more towards B, from J on where eta is 0.9 to 2")
        .by(&["weights-at-B", "rounded-values"]),
];

/// Section 5: the conclusions.
pub(super) const CONCLUSIONS: &[Sentence] = &[
    said("Sec. 5", "a friction of about 1.277 prevents [s,r,r]").by(&["suffices-T"]),
    said("Sec. 5", "that friction is 52°, around 50°").by(&["rounded-values"]),
    said("Sec. 5", "left of T [s,r,r] may be, with alpha below 2.43").by(&["map-T-shoulder"]),
    said("Sec. 5", "for the semicircle about 0.395 prevents sliding").by(&["semicircle"]),
    said("Sec. 5", "the friction of the semicircle is 22°, around 20°").by(&["rounded-values"]),
    said("Sec. 5", "right of T inner sliding takes more eta and mu").by(&["map-T-inner"]),
    said("Sec. 5", "the friction that prevents sliding grows with alpha, without bound")
        .by(&["friction-rotation"]),
    said("Sec. 5", "finite friction turns overturning into [r,s]").by(&["map-beyond-l"]),
    said("Sec. 5", "a friction of about 1.854 prevents [s,s]").by(&["suffices-B"]),
    said(
        "Sec. 5",
        "the least thickness is unique, though friction is not associated: for symmetric motions",
    )
    .by(&["unique-thickness"]),
    said("Sec. 5", "the least thickness is unique for asymmetric motions too")
        .by(&["unique-asymmetric"]),
    said("Sec. 5", "differences are marginal up to the semicircle").by(&["weights-marginal"]),
    said("Sec. 5", "the differences grow for horseshoes").by(&["weights-differences"]),
    said("Sec. 5", "the kinds of modes are the same for both weights").by(&["modes-occur"]),
];
