(** * The equations as formulas

    Each printed equation, cleared of its denominator; where the denominator is not zero, the formula is
    zero exactly where the equation holds.  And the numbers that have to be positive besides. *)

From Coq Require Import Reals ZArith Lra Bool List.
From Couplet Require Import Arch Moments Contact States Enclosures Formulas.
Import ListNotations.

(** ** Self-weight *)

Inductive weight := Heyman | Milankovitch.
Definition flag (w : weight) : R := match w with Heyman => 0 | Milankovitch => 1 end.

Lemma flag_between w : 0 <= flag w <= 1.
Proof. destruct w; simpl; lra. Qed.

Definition centroid (w : weight) : formula :=
  match w with
  | Heyman => 1
  | Milankovitch => 1 + Val Eta * Val Eta * Ratio 1 12
  end%formula.

Lemma meaning_centroid w x : meaning x (centroid w) = fac (flag w) (x Eta).
Proof. destruct w; unfold fac; simpl; field. Qed.

(** ** Radii and forces *)

Local Open Scope formula_scope.
Definition inner : formula := 2 - Val Eta.
Definition outer : formula := 2 + Val Eta.
Definition normal (joint : name) : formula := Val Thrust * Cos joint + Val joint * Sin joint.

(** (17), numerator and denominator, *)
Definition shoulder_slides : formula := Val Thrust * Sin Alpha - Val Alpha * Cos Alpha.
(** (18), *)
Definition inner_slides : formula := (1 - Val Thrust) * Cos BetaS - Val BetaS * Sin BetaS.
Definition inner_carries : formula := (1 - Val Thrust) * Sin BetaS + Val BetaS * Cos BetaS.

(** and the lever arms of (2) and (3). *)
Definition lower_lever (joint : name) : formula := outer - inner * Cos joint.
Definition upper_lever (joint : name) : formula := inner * Cos joint - outer * Cos Alpha.

(** ** Equations *)

(** The joint of (2), (3) and (5) has a name: it is that which slides where both are one. *)
Inductive equation :=
  | LowerThrust (joint : name) | UpperThrust (joint : name) | WholeThrust
  | Tangency (joint : name) | TangencyAtCrown | DoubleThickness (joint : name)
  | ShoulderSliding | InnerSliding | Steepest.

(** Numerators of (2) and (5). *)
Definition lower (w : weight) (b : name) : formula := inner * Val b * Sin b - 2 * (1 - Cos b) * centroid w.
Definition touching (w : weight) (b : name) : formula := (1 + Val b * Cot b) * inner - 2 * centroid w.

Definition cleared (w : weight) (e : equation) : formula :=
  match e with
  | LowerThrust b => lower_lever b * Val Thrust - lower w b
  | UpperThrust b =>
      upper_lever b * Val Thrust
      - (outer * Val Alpha * Sin Alpha - inner * Val b * Sin b - (Cos b - Cos Alpha) * centroid w * 2)
  | WholeThrust =>
      (1 - Cos Alpha) * outer * Val Thrust
      - (Val Alpha * Sin Alpha * outer - 2 * centroid w * (1 - Cos Alpha))
  | Tangency b => inner * Val Thrust - touching w b
  | TangencyAtCrown => inner * Val Thrust - (2 * inner - 2 * centroid w)
  | DoubleThickness b => slope Eta (lower w b * inner - touching w b * lower_lever b)
  | ShoulderSliding => normal Alpha * Val Mu - shoulder_slides
  | InnerSliding => inner_carries * Val Mu - inner_slides
  | Steepest => Val BetaS * Val BetaS - (1 - Val Thrust) * Val Thrust
  end.

(** What is divided by. *)
Definition denominator (e : equation) : list formula :=
  match e with
  | LowerThrust b => [lower_lever b]
  | UpperThrust b => [upper_lever b]
  | WholeThrust => [(1 - Cos Alpha) * outer]
  | Tangency _ | TangencyAtCrown => [inner]
  | DoubleThickness b => []
  | ShoulderSliding => [normal Alpha]
  | InnerSliding => [inner_carries]
  | Steepest => []
  end.
Local Close Scope formula_scope.

(** As the paper prints them. *)
Definition printed (d : R) (x : configuration) (e : equation) : Prop :=
  match e with
  | LowerThrust b => x Thrust = h_lower d (x b) (x Eta)
  | UpperThrust b => x Thrust = h_upper d (x Alpha) (x b) (x Eta)
  | WholeThrust => x Thrust = h_whole d (x Alpha) (x Eta)
  | Tangency b => x Thrust = h_tangency d (x b) (x Eta)
  | TangencyAtCrown => x Thrust = end_of_rotation d (x Eta)
  | DoubleThickness b => double_thickness d (x b) (x Eta)
  | ShoulderSliding => x Mu = mu_ss (x Alpha) (x Thrust)
  | InnerSliding => x Mu = mu_inner (x BetaS) (x Thrust)
  | Steepest => x BetaS ^ 2 = x Thrust * (1 - x Thrust)
  end.

(** The same numbers in the names of the theory. *)
Ltac in_numbers :=
  cbn [meaning inner outer normal shoulder_slides inner_slides inner_carries lower_lever upper_lever
       lower touching cleared denominator] in *;
  rewrite ?meaning_centroid in *.

Lemma cleared_iff_printed w x e : (forall f, In f (denominator e) -> meaning x f <> 0) ->
  match e with Tangency b => sin (x b) <> 0 | DoubleThickness _ => False | _ => True end ->
  (meaning x (cleared w e) = 0 <-> printed (flag w) x e).
Proof.
  intros Hdenominator Hsine.
  destruct e; cbn [denominator] in Hdenominator; try specialize (Hdenominator _ (or_introl eq_refl)); in_numbers;
    cbn [printed].
  - rewrite lower_thrust_cleared by exact Hdenominator. split; lra.
  - rewrite upper_thrust_cleared by exact Hdenominator. split; lra.
  - rewrite whole_thrust_cleared by (intros E; apply Hdenominator; rewrite E; ring). split; lra.
  - replace (h_tangency _ _ _) with (((1 + x joint * (cos (x joint) / sin (x joint))) * (2 - x Eta)
      - 2 * fac (flag w) (x Eta)) / (2 - x Eta)) by (unfold h_tangency, cot; field; now split).
    rewrite equals_quotient by exact Hdenominator. split; lra.
  - replace (end_of_rotation _ _) with ((2 * (2 - x Eta) - 2 * fac (flag w) (x Eta)) / (2 - x Eta))
      by (unfold end_of_rotation, fac; field; exact Hdenominator).
    rewrite equals_quotient by exact Hdenominator. split; lra.
  - easy.
  - unfold mu_ss. rewrite equals_quotient by exact Hdenominator. split; lra.
  - unfold mu_inner. rewrite equals_quotient by exact Hdenominator. split; lra.
  - split; lra.
Qed.

(** Where (2) and (5) are equal, their difference has a slope that is zero. *)
Lemma cleared_double w x b : b <> Eta -> meaning x (lower_lever b) <> 0 -> sin (x b) <> 0 -> meaning x inner <> 0 ->
  printed (flag w) x (LowerThrust b) -> printed (flag w) x (Tangency b) ->
  (meaning x (cleared w (DoubleThickness b)) = 0 <-> printed (flag w) x (DoubleThickness b)).
Proof.
  intros Hb Hlever Hs Hi H2 H5. cbn [printed] in *.
  assert (E : h_lower (flag w) (x b) (x Eta) = h_tangency (flag w) (x b) (x Eta)) by congruence.
  rewrite (cleared_double_thickness (flag w) (x b) (x Eta) (sin (x b) * meaning x (cleared w (DoubleThickness b)))
             Hlever Hs Hi E).
  - split; intros H; [rewrite H; ring | now apply Rmult_integral in H as [H | H]].
  - destruct w, b; try easy; unfold fac; simpl; field; easy.
Qed.
