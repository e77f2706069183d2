//! Sentences of the paper, place by place, and what decides it: the data of the index.

use super::sentence::Decided::{Audit, Claims, Open, Opinion, Reading};
use super::sentence::Sentence;

/// The sentences of the paper: the place, what it says, and the claims that decide it, or what else is said of it.
macro_rules! sentences {
    (@ $($id:literal)+) => { Claims(&[$($id),+]) };
    (@ $decided:expr) => { $decided };
    ($($place:literal: $says:literal $(=> $($id:literal)+)? $(, $decided:expr)?;)+) => {
        &[$(Sentence {
            place: $place,
            says: $says,
            decided: sentences!(@ $($($id)+)? $($decided)?),
        }),+]
    };
}

/// Reason why sentences on other works are not decided.
const NOT_READ: &str = "the works that are cited were not at hand";
/// Reason why sentences on the authors' program are not decided.
const THEIR_PROGRAM: &str = "it is about the program of the authors";

/// The sentences, in the order of the paper.
pub(super) const SENTENCES: &[Sentence] = sentences! {
    // Abstract, section 1 and the equations of section 2.
    "Abstract": "the true weight does not change which modes there are" => "modes-occur";
    "Abstract": "the differences have few physical implications", Opinion;
    "Abstract": "the true weight bears more, so that Heyman's estimates are conservative" => "weights-same-opening";
    "Abstract, Sec. 2.1": "Heyman's weight is simpler to treat: quadratics where the true one has cubics"
        => "eq-7-A" "eq-7-eta" "eq-7-h";
    "Sec. 1": "what earlier works found of pure rotation with either weight", Open(NOT_READ);
    "Eq. (1)": "the intrinsic thrust is eta h = H/(gamma d r^2)" => "eq-1";
    "Fig. 1": "r is the inner radius" => "eq-1-radius";
    "Fig. 1": "the half arch weighs W = w r alpha, and the shoulder's vertical reaction is opposite to it"
        => "eq-1-weight";
    "Fig. 1": "the shoulder's horizontal reaction is opposite to the thrust" => "eq-1-weight";
    "Eq. (2)": "the thrust by the moment of the upper part about the inner hinge" => "eq-2";
    "Eq. (3)": "the thrust by the moment of the lower part about it" => "eq-3";
    "Eq. (4)": "the thrust by the moment of the half arch about the shoulder" => "eq-4";
    "Eq. (4)": "the half opening enters by A = alpha cot(alpha/2) alone" => "eq-4" "eq-4-forms";
    "Eq. (5)": "the thrust by tangency to the intrados, in two forms" => "eq-5" "eq-5-forms";
    "Eq. (5)": "beta cot(beta) is what is left where the arch is thin" => "eq-5-thin";
    "Eq. (6)": "the centroids lie at r (1 + eta^2/12), and fac_M >= 1" => "eq-6";
    "Eq. (6)": "fac_M - 1 = eta^2/12 is felt more as eta grows" => "eq-6";
    "Eq. (7)": "A, eta and h of pure rotation are roots of three cubics" => "eq-7-A" "eq-7-eta" "eq-7-h";
    "Eq. (8)": "f and g, and the identity that links them" => "eq-8";
    "Eq. (9)": "the closed form of A" => "eq-9";
    "Eq. (10)": "the closed form of eta" => "eq-10";
    "Eq. (11)": "the closed form of h" => "eq-11";
    "Eq. (9)-(11)": "two real branches are meaningful" => "curve-thicknesses";
    "Eq. (9)-(11)": "the sign is the same in both terms" => "eq-9-11-signs";
    "Eq. (12)": "the radicand under the roots of (9) to (11)" => "eq-12";
    "Eq. (12)": "it is negative up to beta_sb and vanishes there" => "eq-12-range";
    "Sec. 2.1": "there the rotational joint is stationary and widest" => "curve-widest";
    "Sec. 2.1": "digits of beta_sb and alpha_sb", Audit;
    "Sec. 2.1": "64.2° and 125.8° there" => "rounded-values";
    "Sec. 2.1, Fig. 2": "to each half opening belongs one rotational state, and A = alpha cot(alpha/2) one half opening"
        => "curve-order" "alpha-one-to-one";
    "Sec. 2.1, Fig. 2": "the rotational joint of Heyman's solution overshoots about and after its peak"
        => "weights-widest-joint" "weights-rotation";
    "Sec. 2.1, Fig. 2": "eta and h of the two weights differ minimally, even where thick" => "weights-minimal";
    "Sec. 2.1, Fig. 2": "least of all where eta is small" => "series-difference" "weights-differences";
    "Sec. 2.1": "rotation ends at alpha_l, where the joint is back at 0 and h = 0"
        => "limit-l" "curve-order" "curve-joint";
    "Sec. 2.1": "digits of alpha_l, eta_l and A_l", Audit;
    "Sec. 2.1": "rotation becomes overturning continuously" => "joining-heyman" "joining-milankovitch";
    "Sec. 2.1": "alpha_l and eta_l are higher for Heyman's weight" => "weights-limits";
    "Sec. 2.1": "slightly higher" => "weights-slightly";
    "Sec. 2.1": "alpha_l is around 150° at eta_l near 1" => "rounded-values";
    "Eq. (13)": "A of the states without thrust, from (4) or from (3)" => "eq-13";
    "Eq. (14)": "the same for Heyman's weight, and its inverse" => "eq-14";
    "Eq. (15)": "the same for Milankovitch's weight, and its inverse" => "eq-15";
    "Eq. (16)": "the condition of l, from (5) in the limit" => "eq-16";
    "Sec. 2.1": "its roots: eta_l = 1 and A_l = 2/3; 2 (2√3 - 3) and √3 - 1" => "limit-l";
    "Sec. 2.1": "overturning goes on to eta = 2, with A_L = 1/2 and 2/3" => "limit-L";
    "Sec. 2.1": "digits of alpha_L in degrees" => "rounded-values";
    "Sec. 2.1, Fig. 3": "the root in (15) vanishes at A = 2/3, eta = 2" => "eq-15-branch";
    "Sec. 2.1, Fig. 3": "a vertical tangent in A and in alpha there" => "eq-15-branch";
    "Sec. 2.1": "A = 2/3, about 150°, matters for both weights: there overturning ends for one and rotation for the other"
        => "alpha-L-is-alpha-l" "rounded-values";
    "Sec. 2.1": "the range in A and alpha is narrower for the true weight" => "weights-limits";
    "Sec. 2.1, Fig. 3": "the overturning trends of the two weights differ little" => "weights-overturning";
    "Sec. 2.1": "A falls as alpha grows" => "alpha-one-to-one";
    "Sec. 2.1, Fig. 4": "both trends join with one slope at l" => "joining-heyman" "joining-milankovitch";
    "Sec. 2.1, Fig. 3": "for the true weight the growth of eta towards 2 is almost vertical" => "eq-15-branch";
    "Sec. 2.1, Fig. 3": "for Heyman's weight too" => "overturning-growth";
    "Sec. 2.1": "rotation holds up to about 150°, or 160°" => "weights-range" "rounded-values";
    "Eq. (17)": "the friction at which the shoulder slides, and its inverse" => "eq-17";
    "Eq. (18)": "the friction at which an inner joint slides, at beta_s = √(h (1 - h))" => "eq-18" "eq-18-stationary";
    "Sec. 2.2": "sliding does not see the weight's centroids" => "sliding-thickness";
    "Sec. 2.2": "where a joint slides, friction sets the thrust" => "eq-17" "eq-18" "eq-18-falls";
    "Sec. 2.2": "no thickness in (17), (18)" => "sliding-thickness";
    "Sec. 2.2": "no friction in (2) to (5)" => "rotation-friction";
    "Sec. 2.2": "no half opening in (18)" => "sliding-opening";
    "Sec. 2.2": "of a purely sliding state alpha sets mu, mu sets alpha, and either sets h" => "sliding-order";
    "Sec. 2.2": "there is one for each alpha from 0 to pi" => "sliding-order";
    "Sec. 2.2": "it ends at B, where eta = 2" => "map-B";
    "Sec. 2.2, Fig. 2": "its thrust goes flatly to 0 as alpha -> pi" => "sliding-flat";
    "Sec. 2.2, Fig. 2": "it meets rotation at T, where the one becomes the other" => "map-T";
    "Sec. 2.2": "digits at T and B", Audit;
    "Sec. 2.3": "(2) to (5) are three equations" => "eq-2-4-imply-3";
    "Sec. 2.3": "(2) to (5) describe pure rotation, (17) and (18) pure sliding" => "modes-seven" "mechanism-limits";
    "Sec. 2.3": "where some of either hold, modes are mixed" => "modes-seven" "modes-occur";
    "Sec. 2.3": "in general five equations rule five variables",
        Reading(
            &["equations-five"],
            "it is said of a part of (2) to (5) and of (17), (18), three and two among alpha, mu, eta, h and beta_r; \
             one state has fewer of them, at T alone all five",
        );

    // Section 3: the map.
    "Sec. 3": "eta and mu are a plane into which the states are projected, with alpha implied" => "map-function";
    "Sec. 3, Fig. 5": "the maps of the two weights differ little, in detail" => "weights-slightly";
    "Sec. 3, Fig. 5": "the more the higher eta, above all among the asymptotic trends"
        => "weights-differences" "map-asymptotes" "weights-limits";
    "Sec. 3": "there are seven symmetric collapse modes" => "modes-seven" "modes-occur";
    "Sec. 3, Fig. 6": "their domains fill the strip between eta = 0 and 2" => "map-columns";
    "Sec. 3, Fig. 6": "[r,r,r] is South-East, the lowest and the furthest right" => "map-columns" "weights-lines-rise";
    "Sec. 3, Fig. 6": "[s,s] is North-West, the highest and the furthest left" => "map-columns" "weights-lines-rise";
    "Sec. 3, Fig. 6": "[s,r,r] lies between [s,s] and [r,r,r], up to T" => "map-columns" "map-T-shoulder";
    "Sec. 3, Fig. 6": "[r,r,s], beta_r >= beta_s, lies beyond T, below beta_r = beta_s"
        => "map-columns" "map-T-inner" "landmark-S";
    "Sec. 3, Fig. 6": "[r,s,r], beta_r <= beta_s, lies between beta_r = beta_s and beta_r = 0" => "map-columns" "map-S";
    "Sec. 3, Fig. 6": "both lines tend to eta_l as mu -> inf" => "map-asymptotes";
    "Sec. 3, Fig. 6": "[r,s] lies between beta_r = 0 and eta = 2" => "map-columns" "map-J";
    "Sec. 3": "in [r,s] friction sets a thrust that is not zero" => "eq-18" "eq-18-falls" "friction-unbounded";
    "Sec. 3": "in [r,s] the blocks do not part at the crown" => "mechanism-crown";
    "Sec. 3": "in [r] they do" => "mechanism-crown";
    "Sec. 3, Fig. 6": "[r] lies at mu = inf, from eta_l to 2, without thrust"
        => "modes-seven" "landmark-l" "limit-l" "limit-L";
    "Sec. 3": "one divide parts the modes with rotation from pure sliding" => "map-columns";
    "Sec. 3, Fig. 6": "it goes from South-West to North-East, from eta = 0 to 2, through T, S, J, B"
        => "map-lines" "weights-lines-rise";
    "Tables 1-2": "digits of T, S, J, B for both weights", Audit;
    "Tables 3-4": "digits of l and L for both weights", Audit;
    "Tables 3-4": "A and eta at l and L in closed form" => "limit-l" "limit-L";
    "Sec. 3": "at the landmarks eta is lower for the true weight" => "weights-thickness";
    "Sec. 3": "at the landmarks mu is lower for the true weight" => "weights-friction";
    "Sec. 3": "at the landmarks alpha is lower for it" => "weights-opening";
    "Sec. 3": "at the landmarks h is higher for it" => "weights-thrust";
    "Sec. 3": "at the landmarks beta_r is wider for it" => "weights-beta-r";
    "Sec. 3": "at the landmarks beta_s is wider for it" => "weights-beta-s";
    "Sec. 3": "Heyman's weight is reasonable where eta is small" => "series-difference" "weights-marginal";
    "Sec. 3": "Heyman's weight is on the safe side" => "weights-same-opening";
    "Sec. 3": "the range of half openings is more limited for the true weight" => "weights-limits";
    "Sec. 3, Fig. 5": "the landmarks of the true weight lie below" => "weights-thickness";
    "Sec. 3, Fig. 5": "and left" => "weights-friction";
    "Sec. 3, Fig. 5": "the dividing lines of the true weight lie below and left" => "weights-dividing-lines";
    "Sec. 3, Fig. 5": "the lines of one half opening of the true weight lie below" => "weights-same-opening";
    "Sec. 3": "the limits at mu = inf are lower in alpha for the true weight" => "weights-limits";
    "Sec. 3": "and in eta" => "weights-eta-l";
    "Sec. 3": "B is reached at a lower mu and a lower alpha" => "weights-friction" "weights-opening";
    "Sec. 3": "the mu is much lower, the alpha slightly" => "weights-slightly";
    "Sec. 3, Fig. 5": "the weights differ most at B, which lies much further left" => "weights-at-B";
    "Sec. 3": "differences were to be expected as eta grows, above eta_l", Opinion;
    "Sec. 3, Fig. 5": "from J to B the true line deviates to the left, the more the thicker" => "weights-J-B";
    "Sec. 3, Fig. 5": "it arrives almost vertically at eta = 2" => "weights-B-slope";
    "Sec. 3": "mu is almost saturated there as eta grows" => "weights-B-slope";
    "Sec. 3": "and as alpha grows" => "weights-B-opening";
    "Sec. 3": "a friction above mu_T precludes [s,r,r]" => "map-T-shoulder";
    "Sec. 3": "a friction above mu_B precludes [s,s]" => "map-B";
    "Sec. 3": "[r,r,s] and [r,s,r] are seen only right of T" => "map-T-inner";
    "Sec. 3": "[r,s] is seen only right of J" => "map-J";
    "Sec. 3": "there an inner joint asks for more friction than the shoulder" => "map-T-frictions";
    "Sec. 3": "overturning without thrust needs infinite friction" => "landmark-l";
    "Sec. 3": "with finite friction an inner joint slides, at a thrust that is not zero"
        => "map-beyond-l" "friction-unbounded";
    "Sec. 3": "the joints are wider for the true weight" => "weights-beta-r" "weights-beta-s";
    "Sec. 3": "slightly wider" => "weights-slightly";
    "Sec. 3": "the dependences on the joints are flatter",
        Open("which dependences, and flatter than which, is not said");

    // Section 4: the states at the landmarks, and the complementarity problem.
    "Sec. 4": "the program takes either weight at the same cost", Open(THEIR_PROGRAM);
    "Eq. (19)": "conditions on forces and rates at the joints of the discretised arch govern its states"
        => "stones-sums" "mechanism-fits" "mechanism-limits";
    "Eq. (19)": "at collapse they have a solution" => "modes-seven" "unique-thickness";
    "Eq. (20)": "they have one where the least value of a programme is zero" => "programme-zero";
    "Eq. (20)": "a zero shows the onset of collapse, for symmetric motions" => "unique-thickness";
    "Eq. (20)": "and for all motions",
        Reading(&["unique-asymmetric"], "(20) is printed without a word on asymmetric motions; those have more zeros");
    "Sec. 4": "that value comes out in the order of 1e-16", Open(THEIR_PROGRAM);
    "Sec. 4, Fig. 7-12": "the lines of thrust and of friction are inside the arch at T, S, J, B, l, L"
        => "landmark-inside" "landmark-inside-unlimited";
    "Sec. 4, Fig. 7-12": "the motions of the modes are symmetric, fit, and have joints that open and slide as drawn"
        => "mechanism-fits" "mechanism-rates";
    "Sec. 4, Fig. 7-12": "they move where the lines reach their limits, and cost no work"
        => "mechanism-limits" "mechanism-power";
    "Fig. 7-12": "digits in the captions", Audit;
    "Sec. 4, Fig. 7-8": "T parts [s,r,r] from the modes with inner sliding" => "map-T-shoulder" "map-T-inner";
    "Sec. 4, Fig. 7-8": "[r,r,s] meets the other modes at T" => "landmark-T";
    "Sec. 4, Fig. 7-8": "four modes hold at T" => "landmark-T-modes";
    "Sec. 4, Fig. 7-8": "any three of their mechanisms give the fourth" => "landmark-T-modes";
    "Sec. 4": "angles near 140°, 52°, 60°, 20° at T" => "rounded-values";
    "Sec. 4, Fig. 9": "the divide reaches beta_r = beta_s continuously at S" => "map-lines" "landmark-S";
    "Sec. 4, Fig. 9": "at S one joint turns and slides, [r+s]" => "landmark-S" "landmark-S-joint";
    "Sec. 4": "angles near 145°, 57°, 16° at S" => "rounded-values";
    "Sec. 4, Fig. 10": "at J beta_r = 0, and [r,s] begins" => "landmark-J";
    "Sec. 4": "S and J are rather near" => "landmark-S-near-J";
    "Sec. 4, Fig. 11": "at B eta = 2, and [r,s] meets [s,s]" => "landmark-inside" "map-B";
    "Sec. 4": "angles near 150°, 62°, 14° at B" => "rounded-values";
    "Sec. 4, Fig. 12": "at l and L the half arch overturns without thrust, with beta_r = 0"
        => "landmark-l" "limit-l" "limit-L";
    "Sec. 4": "about 150° at l and L" => "rounded-values";
    "Sec. 4": "the kinds of modes are those of Heyman's weight" => "modes-occur";
    "Sec. 4": "the two weights differ the more the larger eta, above and right of T: in the rotational states"
        => "weights-differences";
    "Sec. 4": "and along the divide" => "weights-J-B";
    "Sec. 4": "above all from J to B" => "weights-at-B" "weights-J-B";
    "Sec. 4": "where eta is 0.9 to 2" => "rounded-values";

    // Section 5: the conclusions.
    "Sec. 5": "the deviations become more evident around and above eta_l" => "weights-differences" "weights-J-B";
    "Sec. 5": "a friction of about 1.277 prevents [s,r,r]" => "suffices-T";
    "Sec. 5": "that friction is 52°, around 50°" => "rounded-values";
    "Sec. 5": "left of T [s,r,r] may be, with alpha below 2.43 and less thickness" => "map-T-shoulder";
    "Sec. 5": "at whatever smaller friction" => "map-columns";
    "Sec. 5": "most arches that are built are such", Opinion;
    "Sec. 5": "for the semicircle about 0.395 prevents sliding" => "semicircle";
    "Sec. 5": "the friction of the semicircle is 22°, around 20°" => "rounded-values";
    "Sec. 5": "right of T inner sliding takes more eta and mu" => "map-T-inner";
    "Sec. 5": "the friction that prevents sliding grows with alpha, without bound at the end of rotation"
        => "friction-rotation";
    "Sec. 5": "and in overturning" => "landmark-l";
    "Sec. 5": "states that overturn are precarious", Opinion;
    "Sec. 5": "they are thick, from eta_l to 2" => "limit-l" "limit-L";
    "Sec. 5": "finite friction turns overturning into [r,s]" => "map-beyond-l";
    "Sec. 5": "a friction of about 1.854 prevents [s,s]" => "suffices-B";
    "Sec. 5": "that friction is 62°, around 60°" => "rounded-values";
    "Sec. 5": "what the literature has of finite friction agrees with the maps", Open(NOT_READ);
    "Sec. 5": "the least thickness is unique, though friction is not associated: for symmetric motions"
        => "unique-thickness";
    "Sec. 5": "no sign is recorded that the least thickness is not unique",
        Reading(
            &["unique-asymmetric"],
            "it is told as what was found, and as a subject to look into: asymmetric motions give such a sign",
        );
    "Sec. 5": "their program would have found other solutions", Open(THEIR_PROGRAM);
    "Sec. 5": "for friction that is not associated the limit theorems do not always apply, but uniqueness is proved \
               for arches with symmetrical load and geometry",
        Open("quoted from others, whose works were not at hand; unique-thickness and unique-asymmetric say how far it \
              is so here");
    "Sec. 5": "common programs are not fine enough for a comparison", Opinion;
    "Sec. 5": "exact solutions are the way to understand fundamental problems", Opinion;
    "Sec. 5": "the true weight is Milankovitch's, Heyman's an approximation, the worse the thicker" => "eq-6";
    "Sec. 5": "the true weight adds some little complexity", Opinion;
    "Sec. 5": "differences are marginal up to the semicircle, where the thickness is small" => "weights-marginal";
    "Sec. 5": "the differences grow for horseshoes" => "weights-differences";
    "Sec. 5": "the kinds of modes are the same for both weights" => "modes-occur";
    "Sec. 5": "that might be conjectured, but was unsure", Opinion;
    "Sec. 5": "the maps and figures are a guideline for practice", Opinion;
};
