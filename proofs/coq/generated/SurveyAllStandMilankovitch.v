(** * All arches of a survey, Milankovitch's self-weight. Written by `couplet prove --coq`. *)
From Couplet Require Import SurveySound.

Definition this : survey_certificate :=
  SurveyCertificate (Survey Milankovitch ((Coefficient (Fraction 1 2)), (Coefficient (Fraction 3 5))) (Free ((TimesPi 7 18), (TimesPi 4 9)) ((Fraction 1 10), (Fraction 1 5)))) AllStand
    [Part None
    (Certificate (Stands (Arch Milankovitch (TimesPi 4 9) (Coefficient (Fraction 1 2))) (Fraction 1 10) (Dyadic (25244350183) (-35)) (Dyadic (101617080761) (-37)) AtHaunch) 10
    (Box [(Dyadic (265570970720546773512058648547598701863) (-128))] [(Dyadic (921384395) (-34))])
    [[(Dyadic (316117008788405099440430443642548045809) (-128))]]
    (Box [(Dyadic (1113885384777072214328721637837787425618041141) (-150))] [(Dyadic (921384395) (-169))])
    [])].

Theorem claim : claim_of_survey this.
Proof. apply sound_survey. vm_cast_no_check (eq_refl true). Qed.
