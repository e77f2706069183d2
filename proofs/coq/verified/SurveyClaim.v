(** * The certificate of a survey, and what it claims

    A survey is all arches of one self-weight between measured ends. Of its certificate only the survey and the verdict
    are a claim, [claim_of_survey]; the parts say which arches were looked at. *)

From Coq Require Import Reals ZArith QArith Qreals List.
From Couplet Require Import Arch States Equations Certificate Surveys.
Import ListNotations.

(** ** What is given *)

(** Span and rise are measured at a circle: half thicknesses from there to the centreline, outwards. *)
Inductive circle := AtIntrados | AtCentreline | AtExtrados.
Definition to_centreline (c : circle) : Z := match c with AtIntrados => 1 | AtCentreline => 0 | AtExtrados => -1 end.

(** Least and largest of each measure: half-angle and ratio of thickness to radius, or lengths. *)
Inductive shape :=
  | Free (half_openings thicknesses : number * number)
  | Spanned (at_circle : circle) (spans rises thicknesses : Q * Q).
Record survey := Survey { survey_weight : weight; frictions : friction * friction; its_shape : shape }.

(** ** What is said of it *)

Inductive survey_verdict := AllStand | NoneStands | BothOccur.

(** No limit is above every friction. *)
Definition no_more (mu mu' : option R) : Prop :=
  match mu, mu' with
  | _, None => True
  | Some mu, Some mu' => mu <= mu'
  | None, Some _ => False
  end.
Definition between (l : Q * Q) (x : R) : Prop := Q2R (fst l) <= x <= Q2R (snd l).

(** Half-angle, thickness and friction of an arch between the ends, which belong to the survey. *)
Definition surveyed (s : survey) (alpha eta : R) (mu : option R) : Prop :=
  no_more (coefficient (fst (frictions s))) mu /\ no_more mu (coefficient (snd (frictions s))) /\
  match its_shape s with
  | Free alphas etas => real (fst alphas) <= alpha <= real (snd alphas) /\ real (fst etas) <= eta <= real (snd etas)
  | Spanned c spans rises thicknesses =>
      exists span rise t, between spans span /\ between rises rise /\ between thicknesses t /\
        alpha = opening span rise /\ eta = ratio (IZR (to_centreline c)) t (Surveys.radius span rise)
  end.

(** ** The certificate *)

(** Span and rise. *)
Definition place : Set := Q * Q.
(** Where span and rise are measured a part is for a step between two places. *)
Record part := Part { its_step : option (place * place); its_certificate : certificate }.
Record survey_certificate := SurveyCertificate {
  of_survey : survey; its_verdict : survey_verdict; parts : list part }.

(** Every arch of the survey is one, there are some, and the verdict is true. *)
Definition claim_of_survey (c : survey_certificate) : Prop :=
  let is_one := surveyed (of_survey c) in
  let stand := stands_with (survey_weight (of_survey c)) in
  (forall alpha eta mu, is_one alpha eta mu ->
     0 < alpha < PI /\ 0 < eta <= 2 /\ match mu with Some mu => 0 <= mu | None => True end) /\
  (exists alpha eta mu, is_one alpha eta mu) /\
  match its_verdict c with
  | AllStand => forall alpha eta mu, is_one alpha eta mu -> stand alpha eta mu
  | NoneStands => forall alpha eta mu, is_one alpha eta mu -> ~ stand alpha eta mu
  | BothOccur =>
      (exists alpha eta mu, is_one alpha eta mu /\ stand alpha eta mu) /\
      (exists alpha eta mu, is_one alpha eta mu /\ ~ stand alpha eta mu)
  end.
