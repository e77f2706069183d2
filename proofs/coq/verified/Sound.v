(** * What is checked is true *)

From Coq Require Import Reals Lra Lia Bool.
From Coq Require Export ZArith List.
From Interval Require Import Interval.Interval.
From Couplet Require Import Arch States Verdicts Whole Krawczyk Root WholeArch Check.
From Couplet Require Export Enclosures Formulas Equations Certificate.
Export ListNotations.

(** ** What is given *)

Lemma has_quotient prec p q : has (quotient prec p q) (fraction p q).
Proof. apply has_div; apply has_integer. Qed.

Lemma has_number prec n : has (enclosed_number prec n) (real n).
Proof.
  destruct n; cbn [enclosed_number real].
  - apply has_quotient.
  - apply has_mul; [apply has_quotient | apply has_pi].
  - apply has_mul; [apply (has_integer prec 2) | apply has_atan, has_quotient].
Qed.

Definition coefficient_or_zero (f : friction) : R := match coefficient f with Some mu => mu | None => 0 end.

Lemma coefficient_is f : coefficient f = if is_limited f then Some (coefficient_or_zero f) else None.
Proof. now destruct f. Qed.

Lemma has_friction prec f : has (enclosed_friction prec f) (coefficient_or_zero f).
Proof.
  destruct f; cbn [enclosed_friction]; unfold coefficient_or_zero; cbn [coefficient]; [apply has_number
    | apply has_div; [apply has_sin | apply has_cos]; apply has_number | rewrite <- value_nought; apply has_exact].
Qed.

(** The numbers that are given; the others are zero. *)
Definition numbers_in (l : list (name * R)) : configuration := fun n =>
  match find (fun nx => same n (fst nx)) l with Some nx => snd nx | None => 0 end.

Definition agree (nX : name * enclosure) (nx : name * R) : Prop := fst nX = fst nx /\ has (snd nX) (snd nx).

Lemma surrounds_given L l : (forall prec, List.Forall2 agree (L prec) l) ->
  forall prec, surrounds (given L prec) (numbers_in l).
Proof.
  intros Hall prec. apply surrounds_remembered. intros n. apply covers_functions. unfold numbers_in.
  specialize (Hall prec). induction Hall as [| nX nx L' l' [Hn Hx] _ IH]; cbn [find];
    [rewrite <- value_nought; apply has_exact | rewrite Hn; destruct (same n (fst nx)); [exact Hx | exact IH]].
Qed.

Lemma real_positive n : (0 < numerator n)%Z -> 0 < real n.
Proof.
  intros Hn. assert (F : forall q, 0 < fraction (numerator n) q) by (intros q; apply Rdiv_lt_0_compat; now apply IZR_lt).
  destruct n as [p q | p q | p q]; cbn [real numerator] in *; [easy | |].
  - apply Rmult_lt_0_compat; [easy | apply PI_RGT_0].
  - apply Rmult_lt_0_compat; [lra |]. rewrite <- atan_0. now apply atan_increasing.
Qed.

Lemma real_not_negative n : (0 <= numerator n)%Z -> 0 <= real n.
Proof.
  intros Hn. apply Zle_lt_or_eq in Hn as [Hn | Hn]; [now apply Rlt_le, real_positive |].
  destruct n; cbn [real numerator] in *; subst; unfold fraction;
    replace (0 / IZR (Zpos q)) with 0 by (unfold Rdiv; ring); rewrite ?atan_0; lra.
Qed.

Lemma is_below_sound prec n limit y : is_below prec n limit = true -> has limit y -> real n < y.
Proof.
  intros Htest Hy. apply (is_positive_sound _ (y - real n)) in Htest; [lra |].
  apply has_sub; [exact Hy | apply has_number].
Qed.

Lemma is_given_sound prec a : is_given prec a = true -> is_arch a.
Proof.
  unfold is_given, is_arch. intros Htest. conditions. split.
  - split; [now apply real_positive, Z.ltb_lt | now apply (is_below_sound prec _ (I.pi prec)), has_pi].
  - destruct (its_friction a); [now apply real_not_negative, Z.leb_le | | easy]. conditions.
    split; [now apply real_not_negative, Z.leb_le |].
    apply (is_below_sound prec _ (I.div prec (I.pi prec) (integer prec 2))); [easy |].
    apply has_div; [apply has_pi | apply (has_integer prec 2)].
Qed.

Lemma friction_not_negative a : is_arch a -> 0 <= coefficient_or_zero (its_friction a).
Proof.
  intros [_ H]. unfold coefficient_or_zero. destruct (its_friction a); cbn [coefficient]; [easy | | lra].
  apply Rmult_le_pos; [positive | apply Rlt_le, Rinv_0_lt_compat, cos_gt_0; lra].
Qed.

Ltac given_numbers :=
  intros; unfold its_numbers, its_opening;
  repeat (apply List.Forall2_cons;
          [split; [reflexivity | cbn [snd]; first [apply has_number | apply has_friction | apply has_exact]] |]);
  apply List.Forall2_nil.

(** ** Decimals *)

Lemma has_quantity prec (limited : bool) E (x : configuration) (mu : option R) q : surrounds E x -> mu = (if limited then Some (x Mu) else None) ->
  has (enclosed_quantity prec limited E q) (value_of mu x q).
Proof.
  intros HE ->. unfold enclosed_quantity. cbv zeta.
  assert (degrees : forall X y, has X y ->
            has (I.div prec (I.mul prec (integer prec 180) X) (I.pi prec)) (180 * y / PI)).
  { intros X y HX. apply has_div; [| apply has_pi]. apply has_mul; [apply (has_integer prec 180) | exact HX]. }
  assert (angle : has (if limited then I.atan prec (itself (E Mu)) else I.div prec (I.pi prec) (integer prec 2))
                    (friction_angle (if limited then Some (x Mu) else None))).
  { destruct limited; [apply has_atan, HE | apply has_div; [apply has_pi | apply (has_integer prec 2)]]. }
  destruct q; cbn [value_of];
    [apply HE | apply degrees, HE | apply has_mul; apply HE | | exact angle | now apply degrees].
  apply has_div; [apply has_mul; apply HE |]. apply has_sub; [apply (has_integer prec 1) | apply HE].
Qed.

Lemma power_of_ten k : (0 <= k)%Z -> IZR (10 ^ k) = powerRZ 10 k.
Proof. intros Hk. rewrite <- (Z2Nat.id k) by easy. now rewrite <- pow_powerRZ, <- pow_IZR. Qed.

Lemma has_twentieths prec m e : has (twentieths prec m e) (IZR m / 20 * powerRZ 10 e).
Proof.
  unfold twentieths. destruct (Z.leb_spec 0 e).
  - replace (IZR m / 20 * powerRZ 10 e) with (IZR (m * 10 ^ e) / 20)
      by (rewrite mult_IZR, power_of_ten by easy; field). apply has_div; apply has_integer.
  - replace (IZR m / 20 * powerRZ 10 e) with (IZR m / IZR (20 * 10 ^ (- e))).
    + apply has_div; apply has_integer.
    + assert (Q : powerRZ 10 (- e) <> 0) by (apply powerRZ_NOR; lra).
      assert (product : powerRZ 10 e * powerRZ 10 (- e) = 1)
        by (rewrite <- powerRZ_add by lra; now rewrite Z.add_opp_diag_r).
      replace (powerRZ 10 e) with (/ powerRZ 10 (- e))
        by (apply (Rmult_eq_reg_r (powerRZ 10 (- e))); [now rewrite product, Rinv_l | easy]).
      rewrite mult_IZR, power_of_ten by lia. now field.
Qed.

Lemma holds_value_sound prec digits (limited : bool) E (x : configuration) (mu : option R) qv :
  holds_value prec digits limited E qv = true -> surrounds E x ->
  mu = (if limited then Some (x Mu) else None) -> is_value digits mu x (fst qv) (snd qv).
Proof.
  destruct qv as [q [| m e]]; unfold holds_value; cbn [fst snd is_value].
  - intros Htest HE ->. destruct q as [[] | | | | |]; try easy. now destruct limited.
  - intros Htest HE Hmu. assert (HX := has_quantity prec limited E x mu q HE Hmu). unfold is_rounding.
    apply andb_true_iff in Htest. destruct Htest as [Hknown Htest].
    split; [intros ->; rewrite Hmu; now destruct limited |]. cbv zeta in *.
    destruct (Z.eqb_spec m 0) as [Hzero | Hne].
    + left. split; [easy | now apply (is_zero_sound (enclosed_quantity prec limited E q))].
    + right. conditions. in_integers. split; [easy |]. set (unit := powerRZ 10 e).
      assert (above := has_sub prec _ _ _ _ HX
                         (has_twentieths prec (20 * m - (if (m =? 10 ^ (digits - 1))%Z then 1 else 10)) e)).
      assert (below := has_sub prec _ _ _ _ (has_twentieths prec (20 * m + 10) e) HX).
      apply is_positive_sound in above; [| assumption]. apply is_positive_sound in below; [| assumption].
      fold unit in above, below. rewrite plus_IZR, mult_IZR in below. rewrite minus_IZR, mult_IZR in above.
      destruct (m =? 10 ^ (digits - 1))%Z; lra.
Qed.

Lemma hold_values_sound prec (limited : bool) E c (x : configuration) (mu : option R) : hold_values prec limited E c = true ->
  surrounds E x -> mu = (if limited then Some (x Mu) else None) -> values_hold c mu x.
Proof.
  intros Hall HE Hmu q v Hq. apply (each_one _ _ (q, v)) in Hall; [| exact Hq]. apply andb_true_iff in Hall.
  split; [easy | now apply (holds_value_sound prec (digits c) limited E x mu (q, v))].
Qed.

(** ** States *)

(** A state with its steepest joint. *)
Definition steepest_of (x : configuration) : configuration := fun n =>
  match n with BetaS => beta_s (x Thrust) | _ => x n end.

Lemma surrounds_steepest prec E x : surrounds E x -> surrounds (with_steepest prec E) (steepest_of x).
Proof.
  intros HE n. unfold with_steepest. destruct n; try apply HE.
  apply covers_functions, has_sqrt, has_mul; [apply HE |]. apply has_sub; [apply (has_integer prec 1) | apply HE].
Qed.

Lemma are_all_positive_sound prec E x l f : are_all_positive prec E l = true -> surrounds E x ->
  In f l -> 0 < meaning x f.
Proof.
  intros Hall HE Hf. apply (is_positive_sound (enclosed prec E f)); [| now apply has_meaning].
  exact (each_one _ l f Hall Hf).
Qed.

Lemma all_signs prec E x l : are_all_positive prec E l = true -> surrounds E x ->
  List.Forall (fun g => 0 < meaning x g) l.
Proof. intros H HE. apply List.Forall_forall. intros g Hg. now apply (are_all_positive_sound prec E x l). Qed.

Lemma is_open_sound prec X alpha : is_open prec X = true -> has X alpha -> alpha < PI.
Proof.
  intros Htest HX. apply (is_positive_sound _ (PI - alpha)) in Htest; [lra |]. now apply has_sub; [apply has_pi |].
Qed.

Lemma difference_sound prec X Y x y : is_positive (I.sub prec X Y) = true -> has X x -> has Y y -> y < x.
Proof. intros Htest HX HY. apply (is_positive_sound _ (x - y)) in Htest; [lra |]. now apply has_sub. Qed.

Ltac list_of H :=
  cbn [signs landmark_signs standing_signs carried thick some_thrust haunch steepest app equations
       equations_of] in H;
  repeat (apply List.Forall_cons_iff in H; let first := fresh in destruct H as [first H]); clear H.

(** Names of the theory for what the formulas mean. *)
Lemma meaning_limit w x : meaning x (limit w)
  = 2 * normal_force (x Alpha) (x Thrust) - fac (flag w) 2 * (1 - cos (x Alpha)).
Proof. destruct w; unfold limit, normal_force, fac; simpl; field. Qed.

Lemma meaning_extrados w x : meaning x (extrados_at_shoulder w)
  = 2 * (at_shoulder (flag w) (x Alpha) (x Eta) (x Thrust) - at_crown (x Eta) (x Thrust)).
Proof. unfold extrados_at_shoulder, at_shoulder, at_crown, extrados, normal_force. in_numbers. field. Qed.

Lemma meaning_next w x : meaning x (next_to_crown w) = fac (flag w) (x Eta) - intrados (x Eta) * (2 - x Thrust).
Proof. unfold next_to_crown, intrados. in_numbers. field. Qed.

Lemma friction_below x num den : 0 < meaning x den -> 0 < meaning x (den * Val Mu - num)%formula ->
  meaning x num / meaning x den < x Mu.
Proof.
  intros Hden H. simpl in H. apply (Rmult_lt_reg_r (meaning x den)); [easy |]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

(** Friction at the shoulder and inside; the joint that is steepest. *)
Ltac frictions Hsteepest :=
  try match goal with
    | grip : 0 < meaning ?x grip_at_shoulder |- _ =>
        assert (shoulder : mu_ss (x Alpha) (x Thrust) < x Mu)
          by (now apply (friction_below x shoulder_slides (normal Alpha)))
    end;
  try match goal with
    | grip : 0 < meaning ?x grip_inside |- _ =>
        assert (inside : mu_inner (x BetaS) (x Thrust) < x Mu)
          by (now apply (friction_below x inner_slides inner_carries));
        rewrite Hsteepest in inside by easy; fold (mu_is (x Thrust)) in inside
    end;
  try match goal with
    | square : ?x BetaS ^ 2 = _ |- _ =>
        assert (joint : x BetaS = beta_s (x Thrust))
          by (unfold beta_s; rewrite <- square, sqrt_pow2; [easy | cbn [meaning] in *; lra]);
        match goal with
        | friction : x Mu = mu_inner (x BetaS) _ |- _ => rewrite joint in friction; fold (mu_is (x Thrust)) in friction
        end
    end.

Lemma signs_suffice w m f x : fits m f = true -> x Alpha < PI ->
  List.Forall (fun g => 0 < meaning x g) (signs w m (is_limited f)) ->
  List.Forall (printed (flag w) x) (equations m) -> coefficient f = (if is_limited f then Some (x Mu) else None) ->
  (slides_inside m = false -> is_limited f = true -> x BetaS = beta_s (x Thrust)) ->
  match m with | OverturningSliding => x BetaR = 0 | Overturning => x BetaR = 0 /\ x Thrust = 0 | _ => True end ->
  in_order m x /\ is_least (flag w) (coefficient f) x (crown_moment m (flag w) x).
Proof.
  intros Hfits Hopen Hsigns Hequations Hmu Hsteepest Hfixed. rewrite Hmu. clear Hmu.
  assert (weight := flag_between w). destruct m, (is_limited f) eqn:Hlimited; try (destruct f; discriminate).
  all: list_of Hsigns; list_of Hequations.
  all: cbn [printed] in *; rewrite ?meaning_limit, ?meaning_extrados, ?meaning_next in *.
  all: assert (N : 0 < normal_force (x Alpha) (x Thrust)) by assumption. all: frictions Hsteepest.
  all: cbn [meaning inner outer upper_lever] in *; rewrite ?meaning_extrados in *.
  all: unfold in_order, is_least, is_admissible, crown_moment.
  - split; [split; split; lra |]. apply (rotational _ _ _ weight) with (beta := x BetaR); try tauto; try lra.
    rewrite <- Hsteepest by easy. lra.
  - split; [split; split; lra |]. apply (rotational_without_limit _ _ weight) with (beta := x BetaR); tauto || lra.
  - split; [split; split; lra |]. apply (sliding_rotational _ _ _ weight) with (beta := x BetaR); try tauto; try lra.
    rewrite <- Hsteepest by easy. lra.
  - split; [change (0 < x Eta < 2 /\ 0 < x BetaS < x BetaR /\ x BetaR < x Alpha); lra |].
    apply (rotational_sliding _ _ _ weight) with (beta := x BetaR) (joint := x BetaS); try tauto; try lra.
  - split; [change (0 < x Eta < 2 /\ 0 < x BetaR < x BetaS /\ x BetaS < x Alpha); lra |].
    apply (rotational_sliding _ _ _ weight) with (beta := x BetaR) (joint := x BetaS); try tauto; try lra.
  - split; [change (0 < x Eta < 2 /\ x BetaR = 0 /\ 0 < x BetaS < x Alpha); lra |]. rewrite Hfixed in *.
    apply (overturning_sliding _ _ _ weight) with (joint := x BetaS); try tauto; try lra.
  - destruct Hfixed as [Hb Hh]. split; [split; split; lra |]. rewrite Hh, Hb in *.
    assert (E := shoulder_from_crown (flag w) (x Alpha) ltac:(lra) (x Eta) 0 ltac:(lra) ltac:(easy)).
    unfold at_crown in E. rewrite Rmult_0_r in E. rewrite <- E. apply (overturning _ _ weight); try tauto; try lra.
Qed.

(** The equations that the root of a system solves, as printed. *)
Lemma equations_hold w x e : (forall f, In f (map (cleared w) e) -> meaning x f = 0 /\ defined x f) ->
  (forall f, In f (flat_map denominator e) -> meaning x f <> 0) -> (forall b, ~ In (DoubleThickness b) e) ->
  List.Forall (holds (flag w) x) e.
Proof.
  intros Hzeros Hdivisors Hsimple. apply List.Forall_forall. intros g Hg.
  assert (denominators : forall f, In f (denominator g) -> meaning x f <> 0)
    by (intros f Hf; apply Hdivisors, in_flat_map; now exists g).
  assert (sine : match g with Tangency b | DoubleThickness b => sin (x b) <> 0 | _ => True end).
  { destruct g; try exact Logic.I.
    - apply (Hzeros (cleared w (Tangency joint))); [now apply (in_map (cleared w)) | simpl; auto].
    - now destruct (Hsimple joint). }
  refine (conj _ (conj denominators sine)). apply cleared_iff_printed; [easy | |];
    [destruct g; try easy; now destruct (Hsimple joint) | apply Hzeros; now apply (in_map (cleared w))].
Qed.

Lemma is_only_sound c w u e x g : (forall b, ~ In (DoubleThickness b) e) -> (forall n, existsb (same n) u = false ->
    x n = g n) -> (in_box u (unique c) x /\ forall y, in_box u (unique c) y ->
    (forall n, existsb (same n) u = false -> y n = g n) -> (forall f, In f (map (cleared w) e) -> meaning y f = 0) ->
    forall n, y n = x n) -> is_only c w u e x.
Proof.
  intros Hsimple Hgiven [Hbox Honly]. split; [exact Hbox |]. intros y Hy Hsame Hholds. apply Honly; [exact Hy | |].
  - intros n Hn. rewrite <- Hgiven by exact Hn. apply Hsame. intros Hin.
    enough (existsb (same n) u = true) by congruence. apply existsb_exists. exists n.
    split; [exact Hin | now destruct (same_spec n n)].
  - intros f Hf. apply in_map_iff in Hf as (g' & <- & Hg).
    destruct (proj1 (List.Forall_forall _ _) Hholds g' Hg) as (Hprinted & D & Hsine).
    apply cleared_iff_printed; [exact D | destruct g'; try exact Hsine; now apply (Hsimple joint) | exact Hprinted].
Qed.

Lemma holds_printed d x l : List.Forall (holds d x) l -> List.Forall (printed d x) l.
Proof. apply List.Forall_impl. now intros e [H _]. Qed.

Ltac no_double := intros ? Hdouble; simpl in Hdouble; repeat destruct Hdouble as [Hdouble | Hdouble]; easy.

Lemma arch_numbers a prec :
  List.Forall2 agree (its_numbers a prec)
    [(Mu, coefficient_or_zero (its_friction a)); (Alpha, real (half_opening a))].
Proof. given_numbers. Qed.

Theorem state_found_sound c m a E : state_found c m a = Some E ->
  is_arch a /\ exists x, surrounds E x /\ is_state m a x /\ is_only_state c m a x /\ values_hold c (coefficient (its_friction a)) x.
Proof.
  unfold state_found. cbv zeta. set (w := self_weight a). set (f := its_friction a). set (full := full_bits c).
  destruct (located _ _ _ _) as [E' |] eqn:Hlocated; [| easy].
  match goal with |- (if ?b then _ else _) = _ -> _ => destruct b eqn:Hall; [| easy] end. intros [= ->]. conditions.
  destruct (located_sound _ _ _ _ _ _ (surrounds_given _ _ (arch_numbers a)) Hlocated)
    as (x & HE & Hgiven & Hzeros & Hdivisors & Honly).
  assert (alpha : x Alpha = real (half_opening a)) by (now destruct m; apply Hgiven).
  assert (mu : x Mu = coefficient_or_zero f) by (now destruct m; apply Hgiven).
  assert (Hholds : List.Forall (holds (flag w) x) (equations m))
    by (apply equations_hold; [exact Hzeros | exact Hdivisors | destruct m; no_double]).
  assert (Hprinted := holds_printed _ _ _ Hholds). assert (Harch : is_arch a) by (now apply (is_given_sound full)).
  set (S := if is_limited f && negb (slides_inside m) then with_steepest full E else E) in *.
  set (y := if is_limited f && negb (slides_inside m) then steepest_of x else x). assert (HS : surrounds S y).
  { unfold S, y. destruct (is_limited f && negb (slides_inside m)); [now apply surrounds_steepest | exact HE]. }
  assert (same_numbers : forall n, n <> BetaS -> y n = x n).
  { intros n Hn. unfold y. destruct (is_limited f && negb (slides_inside m)), n; easy. }
  assert (Hopen : x Alpha < PI) by (rewrite alpha; apply Harch).
  assert (friction : coefficient f = (if is_limited f then Some (x Mu) else None))
    by (rewrite coefficient_is, mu; easy). destruct (signs_suffice w m f y) as [Horder Hleast]; try easy.
  - now rewrite same_numbers.
  - apply List.Forall_forall. intros g Hg. now apply (are_all_positive_sound full S y (signs w m (is_limited f))).
  - apply List.Forall_forall. intros e He. assert (Hp := proj1 (List.Forall_forall _ _) Hprinted e He). unfold y.
    destruct m, (is_limited f); simpl in He;
      repeat match goal with H : _ \/ _ |- _ => destruct H as [<- | H] end; easy.
  - now rewrite friction, same_numbers.
  - intros Hm Hf. unfold y. rewrite Hm, Hf. easy.
  - destruct m; try easy; rewrite ?same_numbers by easy; repeat split; now apply Hgiven.
  - split; [exact Harch |]. exists x. split; [exact HE | split].
    + unfold is_state. fold f w. refine (conj alpha (conj _ (conj Hholds (conj _ _)))).
      * rewrite coefficient_is, mu. now destruct (is_limited f).
      * unfold y in Horder. destruct m, (is_limited f); exact Horder.
      * unfold y in Hleast. destruct m, (is_limited f); exact Hleast.
    + split; [| now apply (hold_values_sound full (is_limited f) E)].
      now apply (is_only_sound c w (unknowns_of m) (equations m) x _ ltac:(destruct m; no_double) Hgiven).
Qed.

Lemma check_state_sound c m a : about c = State m a -> check_state c m a = true -> claim_of c.
Proof.
  intros Habout. unfold check_state, claim_of. rewrite Habout.
  destruct (state_found c m a) as [E |] eqn:Hfound; [| easy]. intros _.
  destruct (state_found_sound c m a E Hfound) as (Harch & x & _ & Hstate). exact (conj Harch (ex_intro _ x Hstate)).
Qed.

(** ** The other verdicts *)

Lemma is_state_least m a x : is_state m a x -> forall eta, 0 < eta <= 2 -> stands a eta -> x Eta <= eta.
Proof.
  intros (alpha & _ & _ & _ & _ & Hleast) eta He. unfold stands, stands_with, is_least in *. rewrite <- alpha.
  destruct (coefficient (its_friction a)); now apply Hleast.
Qed.

Lemma is_thickness_sound t : is_thickness t = true -> 0 < real t <= 2.
Proof.
  destruct t as [p q | |]; try easy. intros Ht. simpl in Ht. conditions. in_integers.
  assert (Hq : 0 < IZR (Zpos q)) by (now apply IZR_lt). cbn [real]. unfold fraction. split.
  - apply Rdiv_lt_0_compat; [now apply IZR_lt | exact Hq].
  - apply (Rmult_le_reg_r (IZR (Zpos q))); [exact Hq |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    rewrite <- (mult_IZR 2). now apply IZR_le.
Qed.

Lemma check_too_thin_sound c m a t : about c = TooThin m a t -> check_too_thin c m a t = true -> claim_of c.
Proof.
  intros Habout. unfold check_too_thin, claim_of. rewrite Habout. cbv zeta. set (full := full_bits c).
  destruct (state_found c m a) as [E |] eqn:Hfound; [| easy]. intros Htest. conditions.
  destruct (state_found_sound c m a E Hfound) as (Harch & x & HE & Hstate & Honly & Hvalues).
  assert (Ht := is_thickness_sound t ltac:(easy)). assert (Hless : real t < x Eta).
  { apply (difference_sound full (itself (E Eta)) (enclosed_number full t)); [easy | apply HE | apply has_number]. }
  refine (conj Harch (conj (ex_intro _ x (conj Hstate (conj Honly (conj Hvalues Hless)))) (conj (proj1 Ht) _))).
  intros Hstands. assert (Hmost := is_state_least m a x Hstate (real t) Ht Hstands). lra.
Qed.

Lemma check_slides_sound c a : about c = Slides a -> check_slides c a = true -> claim_of c.
Proof.
  intros Habout. unfold check_slides, claim_of. rewrite Habout. cbv zeta. set (w := self_weight a).
  set (f := its_friction a). set (full := full_bits c). destruct (located _ _ _ _) as [E |] eqn:Hlocated; [| easy].
  intros Htest. conditions.
  destruct (located_sound _ _ _ _ _ _ (surrounds_given (its_opening a) [(Alpha, real (half_opening a))]
    ltac:(given_numbers)) Hlocated) as (x & HE & Hgiven & Hzeros & Hdivisors & Honly).
  assert (alpha : x Alpha = real (half_opening a)) by (now apply Hgiven).
  assert (Hholds := equations_hold w x _ Hzeros Hdivisors ltac:(no_double)).
  assert (Hprinted := holds_printed _ _ _ Hholds). assert (Harch := is_given_sound full a ltac:(easy)).
  assert (Hmu := friction_not_negative a Harch). fold f in Hmu.
  assert (Hopen : x Alpha < PI) by (rewrite alpha; apply Harch).
  assert (Hsigns := all_signs full E x _ ltac:(eassumption) HE). assert (Hless : coefficient_or_zero f < x Mu).
  { apply (difference_sound full (itself (E Mu)) (enclosed_friction full f)); [easy | apply HE | apply has_friction]. }
  split; [exact Harch | split].
  - exists x. refine (conj alpha (conj Hholds (conj _ (conj _ _)))).
    + list_of Hsigns. cbn [meaning] in *. lra.
    + exists (coefficient_or_zero f). fold f. rewrite coefficient_is. now replace (is_limited f) with true by easy.
    + now apply (hold_values_sound full true E).
  - intros eta. unfold stands, stands_with. fold f. rewrite coefficient_is, <- alpha.
    replace (is_limited f) with true by easy. list_of Hsigns; list_of Hprinted. cbn [printed] in *. frictions Logic.I.
    cbn [meaning] in *. apply (purely_sliding (x Alpha) (x Mu) (x Thrust) (x BetaS)); try tauto; try lra.
Qed.

(** The limit of the half-angle: the physical limit of the thickness is just enough. *)
Lemma check_too_wide_sound c a : about c = TooWide a -> check_too_wide c a = true -> claim_of c.
Proof.
  intros Habout. unfold check_too_wide, unknowns_too_wide, claim_of. rewrite Habout. cbv zeta.
  set (w := self_weight a). set (f := its_friction a). set (full := full_bits c).
  destruct (located _ _ _ _) as [E |] eqn:Hlocated; [| easy]. intros Htest. conditions.
  destruct (located_sound _ _ _ _ _ _ (surrounds_given (fun prec =>
    [(Eta, exact two); (Mu, enclosed_friction prec f)]) [(Eta, value two);
    (Mu, coefficient_or_zero f)] ltac:(given_numbers)) Hlocated) as (x & HE & Hgiven & Hzeros & Hdivisors & Honly).
  assert (weight : flag w = 0 \/ flag w = 1) by (destruct w; auto). assert (eta : x Eta = 2).
  { rewrite Hgiven by (now destruct (is_limited f)). unfold numbers_in, two, value. simpl. ring. }
  assert (crown : x BetaR = 0) by (rewrite Hgiven by (now destruct (is_limited f)); easy).
  assert (Hless : x Alpha < real (half_opening a)).
  { apply (difference_sound full (enclosed_number full (half_opening a)) (itself (E Alpha)));
      [easy | apply has_number | apply HE]. }
  assert (Harch := is_given_sound full a ltac:(easy)). assert (Hopen : real (half_opening a) < PI) by apply Harch.
  assert (Hvalues : values_hold c (coefficient f) x).
  { apply (hold_values_sound full (is_limited f) E); [easy | exact HE |]. rewrite coefficient_is.
    destruct (is_limited f); [| easy]. rewrite Hgiven by easy. easy. }
  assert (Hsigns := all_signs full E x _ ltac:(eassumption) HE). unfold stands, stands_with. fold f w.
  rewrite coefficient_is in *. destruct (is_limited f) eqn:Hlimited.
  - assert (mu : x Mu = coefficient_or_zero f) by (now apply Hgiven).
    assert (Hholds := equations_hold w x _ Hzeros Hdivisors ltac:(no_double)).
    assert (Hprinted := holds_printed _ _ _ Hholds).
    refine (conj Harch (conj (ex_intro _ x (conj crown (conj eta (conj (conj mu Hholds) (conj Hvalues Hless))))) _)).
    list_of Hsigns; list_of Hprinted. cbn [printed] in *. frictions Logic.I.
    cbn [meaning upper_lever inner outer] in *. rewrite crown, eta in *. rewrite <- mu. intros e He.
    assert (Hthrust : 0 < x Thrust < 1) by nra.
    assert (Hlimit := nothing_left_at_border (flag w) (x Alpha) (x Thrust) ltac:(lra) ltac:(easy)).
    apply (too_wide (flag w) (x Alpha) _ _ (x Thrust)); try easy; lra.
  - assert (thrust : x Thrust = 0) by (now apply Hgiven).
    assert (Hholds := equations_hold w x _ Hzeros Hdivisors ltac:(no_double)).
    assert (Hprinted := holds_printed _ _ _ Hholds). apply List.Forall_inv in Hholds.
    list_of Hsigns; list_of Hprinted. cbn [meaning] in *.
    refine (conj Harch (conj (ex_intro _ x (conj crown (conj eta (conj (conj thrust Hholds) (conj Hvalues _))))) _));
      [exact Hless |]. intros e He (h & p & Hinside). cbn [printed] in *. rewrite thrust, eta in *.
    assert (Hlimit := nothing_left_at_end_of_overturning (flag w) (x Alpha) ltac:(lra) ltac:(easy)).
    now apply (too_wide_without_limit (flag w) (x Alpha) (real (half_opening a))) with (eta := e) (h := h) (p := p).
Qed.

Lemma enough_sound prec E x : enough prec E = true -> surrounds E x -> 0 < x Thrust < 1 -> 0 < x Alpha < PI ->
  0 < normal_force (x Alpha) (x Thrust) -> forall y, 0 <= y <= x Alpha -> friction_holds y (x Mu) (x Thrust).
Proof.
  unfold enough. cbv zeta. intros Htest HE Hthrust Halpha N. apply andb_true_iff in Htest.
  destruct Htest as [Hshoulder Hinside]. assert (HS := surrounds_steepest prec E x HE).
  assert (shoulder : mu_ss (x Alpha) (x Thrust) < x Mu).
  { apply (friction_below x shoulder_slides (normal Alpha)); [exact N |].
    now apply (are_all_positive_sound prec E x [grip_at_shoulder]); [| | left]. }
  destruct (are_all_positive prec (with_steepest prec E) [(Val BetaS - Val Alpha)%formula]) eqn:Hshort.
  - assert (beyond := are_all_positive_sound _ _ _ _ _ Hshort HS (or_introl eq_refl)). cbn in beyond.
    assert (H := are_all_positive_sound _ _ _ _ _ Hinside HE (or_introl eq_refl)).
    apply friction_of_short_arch; try easy; try lra. unfold mu_ss.
    assert (E1 : x Thrust * cos (x Alpha) + x Alpha * sin (x Alpha) = normal_force (x Alpha) (x Thrust))
      by (unfold normal_force; ring). cbn in H. rewrite E1 in *.
    apply (Rmult_le_reg_r (normal_force (x Alpha) (x Thrust))); [easy |]. field_simplify; lra.
  - assert (carries := are_all_positive_sound _ _ _ _ inner_carries Hinside HS (or_introl eq_refl)).
    assert (grip := are_all_positive_sound _ _ _ _ grip_inside Hinside HS ltac:(simpl; auto)).
    assert (H := friction_below (steepest_of x) inner_slides inner_carries carries grip).
    apply friction_by_steepest; try easy; try lra. now apply Rlt_le.
Qed.

(** A state of any thickness. *)
Lemma check_stands_sound c a t h p there :
  about c = Stands a t h p there -> check_stands c a t h p there = true -> claim_of c.
Proof.
  intros Habout. unfold check_stands, claim_of. rewrite Habout. cbv zeta. set (w := self_weight a).
  set (f := its_friction a). set (full := (Z.max _ _ + 64)%Z).
  destruct (located _ _ _ _) as [E |] eqn:Hlocated; [| easy]. intros Htest. conditions.
  destruct (located_sound _ _ _ _ _ _ (surrounds_given (fun prec => (Eta, enclosed_number prec t) ::
    (Thrust, exact h) :: (Moment, exact p) :: its_numbers a prec) [(Eta, real t); (Thrust, value h);
    (Moment, value p); (Mu, coefficient_or_zero f); (Alpha, real (half_opening a))] ltac:(given_numbers)) Hlocated)
    as (x & HE & Hgiven & Hzeros & Hdivisors & Honly).
  assert (alpha : x Alpha = real (half_opening a)) by (now destruct there; apply Hgiven).
  assert (eta : x Eta = real t) by (now destruct there; apply Hgiven).
  assert (thrust : x Thrust = value h) by (now destruct there; apply Hgiven).
  assert (moment : x Moment = value p) by (now destruct there; apply Hgiven).
  assert (mu : x Mu = coefficient_or_zero f) by (now destruct there; apply Hgiven).
  assert (Hthick := is_thickness_sound t ltac:(easy)). rewrite <- eta in Hthick.
  assert (Harch := is_given_sound full a ltac:(easy)). assert (Hopen : x Alpha < PI) by (rewrite alpha; apply Harch).
  assert (Hprinted := holds_printed _ _ _ (equations_hold w x _ Hzeros Hdivisors ltac:(destruct there; no_double))).
  assert (Hsigns := all_signs full E x _ ltac:(eassumption) HE).
  assert (inside : thrust_inside (flag w) (x Alpha) (x Eta) (x Thrust) (value p)).
  { rewrite <- moment. destruct there; list_of Hsigns; list_of Hprinted; rewrite ?meaning_next in *.
    all: assert (N : 0 < normal_force (x Alpha) (x Thrust)) by assumption.
    all: assert (crown : x Moment <= at_crown (x Eta) (x Thrust)) by (in_numbers; unfold at_crown, extrados; lra).
    all: assert (shoulder : x Moment <= at_shoulder (flag w) (x Alpha) (x Eta) (x Thrust))
      by (in_numbers; unfold at_shoulder, extrados, normal_force; lra).
    - apply inside_nearest_at_crown; try easy; in_numbers; try lra. unfold Verdicts.room, intrados, normal_force.
      rewrite cos_0, sin_0. unfold room_at_crown in *. in_numbers. lra.
    - apply (inside_nearest_at_haunch _ _ _ _ _) with (beta := x BetaR); try easy; unfold room in *; in_numbers; try lra.
      + assert (Hinner : meaning x inner <> 0) by (apply Hdivisors; simpl; auto). in_numbers. lra.
      + unfold Verdicts.room, intrados, normal_force. lra.
    - apply inside_nearest_at_shoulder; try easy; unfold room, still_nearer in *; in_numbers; try lra;
        [unfold Verdicts.room, intrados, normal_force; lra | unfold intrados; lra]. }
  assert (admitted : is_admissible (flag w) (coefficient f) x (value p)).
  { rewrite coefficient_is. unfold is_admissible. destruct (is_limited f); [| exact inside]. rewrite <- mu.
    intros y Hy. split; [now apply inside |].
    apply (enough_sound full E); try easy; destruct there; list_of Hsigns; in_numbers; try assumption; lra. }
  split; [exact Harch | split; [now rewrite <- eta | split]].
  - unfold stands, stands_with. fold w f. rewrite <- alpha, <- eta. unfold is_admissible in admitted.
    destruct (coefficient f); now exists (x Thrust), (value p).
  - exists x. fold w f. refine (conj alpha (conj eta (conj thrust (conj _ admitted)))).
    apply (hold_values_sound full (is_limited f) E); try easy. rewrite coefficient_is, mu. easy.
Qed.

(** ** Landmarks *)

(** A configuration with one joint for both. *)
Definition one_joint_of (x : configuration) : configuration := fun n => match n with BetaR => x BetaS | _ => x n end.

Lemma surrounds_one_joint E x : surrounds E x -> surrounds (with_one_joint E) (one_joint_of x).
Proof. intros HE []; apply HE. Qed.

Lemma landmark_holds w x l : (forall f, In f (map (cleared w) (equations_of l)) -> meaning x f = 0 /\ defined x f) ->
  (forall f, In f (flat_map denominator (equations_of l)) -> meaning x f <> 0) ->
  List.Forall (holds (flag w) x) (equations_of l).
Proof.
  intros Hzeros Hdivisors. destruct l; try (apply equations_hold; [exact Hzeros | exact Hdivisors | no_double]).
  set (first := [LowerThrust BetaR; WholeThrust; Tangency BetaR]). assert (H : List.Forall (holds (flag w) x) first).
  { apply equations_hold; [| | no_double]; intros f Hf; [apply Hzeros | apply Hdivisors]; simpl in *; tauto. }
  apply (List.Forall_app (holds (flag w) x) first [DoubleThickness BetaR]). split; [exact H |].
  assert (sine : sin (x BetaR) <> 0) by (apply (Hzeros (cleared w (Tangency BetaR))); simpl; auto).
  apply List.Forall_cons; [| apply List.Forall_nil]. split; [| now split]. apply (cleared_double w x BetaR); try easy.
  1-2: apply Hdivisors; simpl; auto.
  - exact (proj1 (proj1 (List.Forall_forall _ _) H (LowerThrust BetaR) ltac:(simpl; auto))).
  - exact (proj1 (proj1 (List.Forall_forall _ _) H (Tangency BetaR) ltac:(simpl; auto))).
  - apply Hzeros. simpl. auto.
Qed.

(** (3) is (2) and (4). *)
Lemma upper_from_lower_and_whole d x : holds d x (LowerThrust BetaR) -> holds d x WholeThrust ->
  0 < meaning x (upper_lever BetaR) -> holds d x (UpperThrust BetaR).
Proof.
  intros (H2 & D2 & _) (H4 & D4 & _) Hlever. specialize (D2 _ (or_introl eq_refl)).
  specialize (D4 _ (or_introl eq_refl)). split; [| split; [intros f [<- | []]; lra | easy]]. cbn [printed] in *.
  in_numbers. apply lower_and_whole_imply_upper; try easy; try lra; intros Hzero; apply D4; rewrite Hzero; ring.
Qed.

(** What the signs and the equations of a landmark are in the names of the theory. *)
Ltac at_landmark w x l Hsigns Hprinted :=
  assert (weight := flag_between w);
  destruct l; cbn [is_fixed] in *; list_of Hsigns; list_of Hprinted; cbn [printed] in *;
  rewrite ?meaning_limit, ?meaning_next in *;
  assert (N : 0 < normal_force (x Alpha) (x Thrust)) by assumption;
  frictions Logic.I; cbn [meaning inner outer upper_lever] in *; rewrite ?meaning_extrados in *.

Lemma landmark_least w x l : x Alpha < PI -> is_fixed l x ->
  List.Forall (fun g => 0 < meaning x g) (landmark_signs w l) -> List.Forall (printed (flag w) x) (equations_of l) ->
  is_least (flag w) (friction_there l x) x (moment_there l (flag w) x).
Proof.
  intros Hopen Hfixed Hsigns Hprinted.
  at_landmark w x l Hsigns Hprinted; unfold is_least, is_admissible; cbn [friction_there moment_there].
  - apply (rotational _ _ _ weight) with (beta := x BetaR); try tauto; try lra.
  - apply (rotational_sliding _ _ _ weight) with (beta := x BetaS) (joint := x BetaS); try tauto; try lra.
  - rewrite Hfixed in *. assert (next := no_room_next_to_crown (flag w) (x Eta) (x Thrust) ltac:(lra) ltac:(easy)).
    apply (overturning_sliding _ _ _ weight) with (joint := x BetaS); try tauto; try lra.
  - destruct Hfixed as [Hb He]. rewrite Hb, He in *.
    apply (overturning_sliding _ _ _ weight) with (joint := x BetaS); try tauto; try lra.
  - destruct Hfixed as (Hb & _ & Hh). rewrite Hb, Hh in *.
    assert (next := no_room_next_to_crown (flag w) (x Eta) 0 ltac:(lra) ltac:(easy)).
    assert (E := shoulder_from_crown (flag w) (x Alpha) ltac:(lra) (x Eta) 0 ltac:(lra) ltac:(easy)).
    unfold at_crown in E. rewrite Rmult_0_r in E. rewrite <- E. apply (overturning _ _ weight); try tauto; try lra.
  - destruct Hfixed as (Hb & _ & Hh & He). rewrite Hb, Hh, He in *.
    assert (E := shoulder_from_crown (flag w) (x Alpha) ltac:(lra) 2 0 ltac:(lra) ltac:(easy)). unfold at_crown in E.
    rewrite Rmult_0_r in E. rewrite <- E. apply (overturning _ _ weight); try tauto; try lra.
  - apply (rotational_without_limit _ _ weight) with (beta := x BetaR); try tauto; try lra.
Qed.

(** At sb the radicand vanishes. *)
Lemma radicand_there w x : List.Forall (holds (flag w) x) (equations_of WidestJoint) ->
  radicand (flag w) (f_of (x BetaR)) (g_of (x BetaR)) (sin (x BetaR)) = 0.
Proof.
  intros Hholds. list_of Hholds. unfold holds in *. cbn [printed denominator] in *.
  repeat match goal with H : _ /\ _ |- _ => destruct H end.
  repeat match goal with D : forall f, _ -> meaning _ f <> 0 |- _ => specialize (D _ (or_introl eq_refl)) end.
  in_numbers. apply radicand_at_double_thickness with (eta := x Eta); try easy. congruence.
Qed.

(** What is zero there and what is not, and that nothing stands with less friction. *)
Lemma landmark_meets w x l : x Alpha < PI -> is_fixed l x ->
  List.Forall (fun g => 0 < meaning x g) (landmark_signs w l) -> List.Forall (holds (flag w) x) (equations_of l) ->
  is_zero_there l (flag w) x /\ is_left_there l (flag w) x /\ is_least_friction l x.
Proof.
  intros Hopen Hfixed Hsigns Hholds. assert (Hprinted := holds_printed _ _ _ Hholds).
  assert (sb : l = WidestJoint -> radicand (flag w) (f_of (x BetaR)) (g_of (x BetaR)) (sin (x BetaR)) = 0)
    by (intros ->; now apply radicand_there). unfold is_zero_there, is_left_there, is_least_friction. clear Hholds.
  at_landmark w x l Hsigns Hprinted; cbn [friction_there].
  1-4: assert (less : forall mu', 0 <= mu' < x Mu -> stands_at_no_thickness (x Alpha) mu')
    by (apply (purely_sliding (x Alpha) (x Mu) (x Thrust) (x BetaS)); try tauto; try lra).
  - assert (E := shoulder_from_crown (flag w) (x Alpha) ltac:(lra) (x Eta) (x Thrust) ltac:(lra) ltac:(easy)).
    repeat split; try easy; lra.
  - repeat split; try easy; rewrite ?Hfixed; lra.
  - assert (next := no_room_next_to_crown (flag w) (x Eta) (x Thrust) ltac:(lra) ltac:(easy)).
    repeat split; try easy; lra.
  - destruct Hfixed as [Hb He]. rewrite Hb, He in *.
    assert (left := nothing_left_at_border (flag w) (x Alpha) (x Thrust) ltac:(lra) ltac:(easy)).
    repeat split; try easy; lra.
  - destruct Hfixed as (Hb & _ & Hh). rewrite Hb, Hh in *.
    assert (next := no_room_next_to_crown (flag w) (x Eta) 0 ltac:(lra) ltac:(easy)). repeat split; try easy; lra.
  - destruct Hfixed as (Hb & _ & Hh & He). rewrite Hb, Hh, He in *.
    assert (left := nothing_left_at_end_of_overturning (flag w) (x Alpha) ltac:(lra) ltac:(easy)).
    repeat split; try easy; lra.
  - repeat split; try easy; try lra. now apply sb.
Qed.

(** The modes that meet there, and the order of the joints. *)
Lemma landmark_there w x l : x Alpha < PI -> is_fixed l x ->
  List.Forall (fun g => 0 < meaning x g) (landmark_signs w l) -> List.Forall (holds (flag w) x) (equations_of l) ->
  is_zero_there l (flag w) x -> (forall m, In m (modes_of l) -> is_state_there l (flag w) x m) /\ in_order_there l x.
Proof.
  intros Hopen Hfixed Hsigns Hholds [_ Hzero].
  destruct l; cbn [is_fixed modes_of] in *; list_of Hsigns; list_of Hholds.
  all: split; [| unfold in_order_there; cbn [meaning inner] in *; repeat split; lra].
  all: intros m Hm; split; [repeat destruct Hm as [<- | Hm]; try easy | intros e He; simpl in Hm;
    repeat destruct Hm as [<- | Hm]; try easy; cbn [equations] in He; simpl in He; repeat destruct He as [<- | He];
    try easy]. 1: now apply upper_from_lower_and_whole.
  1-4: unfold holds in *; cbn [printed denominator] in *; rewrite Hfixed;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; repeat split; try easy;
    intros f [<- | []]; in_numbers; rewrite ?Hfixed;
    match goal with D : forall f, _ -> meaning _ f <> 0 |- _ => now apply (D _ (or_introl eq_refl)) end.
  - cbn [meaning inner] in *. apply shoulder_from_crown; [lra | lra |].
    now match goal with H : holds _ x WholeThrust |- _ => destruct H end.
  - destruct Hfixed as (Hb & _ & Hh). unfold holds. cbn [printed denominator]. rewrite Hb, Hh.
    repeat split; [unfold h_lower; rewrite sin_0, cos_0; unfold Rdiv; ring |]. intros f [<- | []]. in_numbers.
    rewrite Hb, cos_0. cbn [meaning] in *. lra.
Qed.

(** A solution is fixed by its unknowns. *)
Lemma landmark_only c w l x g : in_box (landmark_unknowns l) (unique c) x -> is_fixed l g ->
  (forall y, in_box (landmark_unknowns l) (unique c) y -> (forall n, existsb (same n) (landmark_unknowns l) = false ->
    y n = g n) -> (forall f, In f (map (cleared w) (equations_of l)) -> meaning y f = 0) -> forall n, y n = x n) ->
  forall y, in_box (landmark_unknowns l) (unique c) y -> solves_there l w y -> forall n, In n (landmark_unknowns l) ->
  y n = x n.
Proof.
  intros Hbox Hg Honly y Hy [Hholds Hfixed] n Hn.
  set (z := fun n => if existsb (same n) (landmark_unknowns l) then y n else g n).
  assert (own : forall k, In k (landmark_unknowns l) -> z k = y k).
  { intros k Hk. unfold z. replace (existsb (same k) (landmark_unknowns l)) with true; [easy | symmetry].
    apply existsb_exists. exists k. split; [exact Hk | now destruct (same_spec k k)]. }
  rewrite <- own by exact Hn. apply Honly.
  - intros i Hi. rewrite own by (now apply nth_In). now apply Hy.
  - intros k Hk. unfold z. now rewrite Hk.
  - intros f Hf. apply in_map_iff in Hf as (e & <- & He). transitivity (meaning y (cleared w e)).
    + apply meaning_alike. intros k Hk. unfold z.
      destruct l; simpl in He; repeat destruct He as [<- | He]; try easy; destruct w, k; try easy;
        cbn [is_fixed existsb same landmark_unknowns orb] in *; intuition congruence.
    + destruct (proj1 (List.Forall_forall _ _) Hholds e He) as (Hprinted & D & Hsine).
      destruct e; try (now apply cleared_iff_printed).
      destruct l; simpl in He; repeat destruct He as [He | He]; try easy. injection He as <-. list_of Hholds.
      unfold holds in *. cbn [denominator] in *. repeat match goal with H : _ /\ _ |- _ => destruct H end.
      repeat match goal with D : forall f, _ -> meaning _ f <> 0 |- _ => specialize (D _ (or_introl eq_refl)) end.
      now apply cleared_double.
Qed.

Lemma check_landmark_sound c l w : about c = Landmark l w -> check_landmark c l w = true -> claim_of c.
Proof.
  intros Habout. unfold check_landmark, claim_of. rewrite Habout. cbv zeta. set (full := full_bits c).
  destruct (located _ _ _ _) as [E |] eqn:Hlocated; [| easy]. intros Htest. conditions.
  set (fixed := match l with Border | OverturningEnd => [(Eta, value two)] | _ => [] end).
  destruct (located_sound _ _ _ _ _ _ (surrounds_given (landmark_given l) fixed ltac:(unfold fixed; destruct l;
    given_numbers)) Hlocated) as (x & HE & Hgiven & Hzeros & Hdivisors & Hbox & Honly).
  assert (two_is : value two = 2) by (unfold two, value; simpl; ring).
  set (y := match l with Shift => one_joint_of x | _ => x end).
  set (S := match l with Shift => with_one_joint E | _ => E end) in *.
  assert (HS : surrounds S y) by (unfold S, y; destruct l; try exact HE; now apply surrounds_one_joint).
  assert (Hsame : forall n, In n (landmark_unknowns l) -> y n = x n)
    by (intros n Hn; unfold y; destruct l; try easy; now repeat destruct Hn as [<- | Hn]).
  assert (Hholds : List.Forall (holds (flag w) y) (equations_of l)).
  { assert (Hp := landmark_holds w x l Hzeros Hdivisors). unfold y. destruct l; try exact Hp.
    apply List.Forall_forall. intros e He.
    destruct (proj1 (List.Forall_forall _ _) Hp e He) as (Hprinted & D & Hsine). simpl in He.
    repeat destruct He as [<- | He]; try easy;
      (refine (conj Hprinted (conj _ Hsine)); intros f Hf; specialize (D f Hf); now repeat destruct Hf as [<- | Hf]). }
  assert (Hprinted := holds_printed _ _ _ Hholds). assert (Hfixed : is_fixed l y).
  { unfold y.
    destruct l; cbn [is_fixed]; try easy; repeat split; rewrite ?Hgiven by easy; unfold fixed, numbers_in;
      cbn [find same fst snd]; easy. }
  assert (Hopen : y Alpha < PI) by (apply (is_open_sound full (itself (S Alpha))); [easy | apply HS]).
  assert (Hsigns := all_signs full S y _ ltac:(eassumption) HS).
  destruct (landmark_meets w y l Hopen Hfixed Hsigns Hholds) as (Hzero & Hleft & Hless).
  destruct (landmark_there w y l Hopen Hfixed Hsigns Hholds Hzero) as [Hthere Horder]. exists y. unfold is_landmark.
  refine (conj (conj Hholds Hfixed) (conj (conj _ _) (conj _ (conj _ (conj Hthere (conj Horder
            (conj Hzero (conj Hleft Hless)))))))).
  - intros i Hi. rewrite Hsame by (now apply nth_In). now apply Hbox.
  - intros z Hz Hsolves n Hn. rewrite Hsame by exact Hn.
    apply (landmark_only c w l x (numbers_in fixed) Hbox); try easy. unfold fixed. destruct l; now repeat split.
  - apply (hold_values_sound full (landmark_limited l) S); try easy. now destruct l.
  - now apply landmark_least.
Qed.

(** ** Asymmetric solutions *)

Lemma neighbourhood_sound prec test X tries k near x :
  neighbourhood prec tries k test X = Some near -> has X x -> test near = true /\ has near x.
Proof.
  intros Hfound HX. revert k Hfound. induction tries as [| tries IH]; intros k; simpl; [easy |].
  destruct (test (widened prec X k)) eqn:Htest; [| apply IH]. intros [= <-]. split; [exact Htest |]. unfold widened.
  replace x with (x + 0) by ring. apply has_add; [exact HX |]. apply has_symmetric. rewrite Rabs_R0. unfold value.
  apply Rlt_le, Rmult_lt_0_compat; [simpl; lra | apply powerRZ_lt; lra].
Qed.

Section Known.

Variables (w : weight) (E : surroundings) (x : configuration).
Hypothesis around : surrounds E x.

Lemma near_joint_sound m X j near : In near (near_joint w E m X) -> has X j ->
  is_margin (flag w) x m j = 0 -> is_margin_slope (flag w) x m j = 0 -> safe w x m near.
Proof.
  unfold near_joint. intros Hin HX H0 H1. destruct (neighbourhood _ _ _ _ _) as [found |] eqn:Hfound; [| easy].
  destruct Hin as [<- | []]. destruct (neighbourhood_sound _ _ _ _ _ _ j Hfound HX) as [Htest Hnear].
  now apply (safe_if_bends piece_bits w E x around m found j).
Qed.

Lemma near_end_sound m near : In near (near_end w E m) -> is_margin (flag w) x m (x Alpha) = 0 -> safe w x m near.
Proof.
  unfold near_end. intros Hin H0. destruct (neighbourhood _ _ _ _ _) as [found |] eqn:Hfound; [| easy].
  destruct Hin as [<- | []].
  destruct (neighbourhood_sound _ _ _ _ _ _ (x Alpha) Hfound ltac:(apply around)) as [Htest Hnear].
  now apply (safe_if_falls piece_bits w E x around m found).
Qed.

End Known.

(** The configuration with its rates, and with the power. *)
Definition slips_of (k : kind) (x : configuration) : configuration :=
  let rate f := meaning x f / meaning x (rate_divisor k) in
  fun n => match n with
    | Slip => rate (slip_numerator k)
    | InnerSlip | Opening => rate gap_along
    | _ => x n
    end.
Definition rates_of (k : kind) (x : configuration) : configuration :=
  fun n => match n with Power => meaning (slips_of k x) (power_of k) | _ => slips_of k x n end.

Lemma surrounds_slips prec k E x : surrounds E x -> surrounds (with_slips prec k E) (slips_of k x).
Proof. intros HE n. destruct n; first [apply HE | apply covers_plain; apply has_div; now apply has_meaning]. Qed.

Lemma surrounds_rates prec k E x : surrounds E x -> surrounds (with_rates prec k E) (rates_of k x).
Proof.
  intros HE n. assert (HF := surrounds_slips prec k E x HE).
  destruct n; first [apply HF | apply covers_plain; now apply has_meaning].
Qed.

(** The rates of the theory. *)
Lemma meaning_across x : meaning x gap_across = across (x Eta) (x Hinge) (x BetaR).
Proof. unfold gap_across, half_outer, half_inner, across, extrados, intrados. cbn [meaning]. field. Qed.
Lemma meaning_upwards x : meaning x gap_upwards = upwards (x Eta) (x Hinge) (x BetaR).
Proof. unfold gap_upwards, half_outer, half_inner, upwards, extrados, intrados. cbn [meaning]. field. Qed.

Lemma slips_inside x : slips_of SlidesInside x Slip = shoulder_slip (x Alpha) (x Eta) (x Hinge) (x BetaR) (x BetaS) /\
  slips_of SlidesInside x InnerSlip = inner_slip (x Alpha) (x Eta) (x Hinge) (x BetaR) (x BetaS).
Proof.
  unfold slips_of, shoulder_slip, inner_slip. cbv zeta. cbn [slip_numerator rate_divisor]. unfold gap_along.
  cbn [meaning]. rewrite meaning_across, meaning_upwards. now split.
Qed.

Lemma slips_opening x : slips_of OpensAtShoulder x Slip = slip_of_opening (x Alpha) (x Eta) (x Hinge) (x BetaR) /\
  slips_of OpensAtShoulder x Opening = shoulder_opening (x Alpha) (x Eta) (x Hinge) (x BetaR) /\
  meaning x (rate_divisor OpensAtShoulder) = shoulder_determinant (x Alpha) (x Eta) (x BetaR).
Proof.
  unfold slips_of, slip_of_opening, shoulder_opening, shoulder_determinant. cbv zeta.
  cbn [slip_numerator rate_divisor].
  unfold gap_along, arm_upwards, arm_across, half_outer, half_inner, extrados, intrados. cbn [meaning].
  rewrite meaning_across, meaning_upwards. replace (x Eta * (1 / 2)) with (x Eta / 2) by field. repeat split.
Qed.

(** A margin or a slope that is one of those that are zero. *)
Ltac vanishes zero :=
  rewrite <- ?margin_right, <- ?margin_left, <- ?slope_right, <- ?slope_left; apply zero;
  cbn [asymmetric_zeros app In]; tauto.

Lemma check_asymmetric_sound c k a : about c = Asymmetric k a -> check_asymmetric c k a = true -> claim_of c.
Proof.
  intros Habout. unfold check_asymmetric, claim_of. rewrite Habout. cbv zeta. set (w := self_weight a).
  set (f := its_friction a). set (full := full_bits c). destruct (located _ _ _ _) as [E |] eqn:Hlocated; [| easy].
  intros Htest. conditions.
  destruct (located_sound _ _ _ _ _ _ (surrounds_given _ _ (arch_numbers a)) Hlocated)
    as (x & HE & Hgiven & Hzeros & _ & _).
  assert (alpha : x Alpha = real (half_opening a)) by (now destruct k; apply Hgiven).
  assert (mu : x Mu = coefficient_or_zero f) by (now destruct k; apply Hgiven).
  assert (Harch := is_given_sound full a ltac:(easy)). assert (Hopen : x Alpha < PI) by (rewrite alpha; apply Harch).
  assert (Hvalues : values_hold c (Some (x Mu)) (rates_of k x)).
  { apply (hold_values_sound full true (with_rates full k E)); try easy. now apply surrounds_rates. }
  assert (zero : forall g, In g (asymmetric_zeros w k) -> meaning x g = 0) by (intros g Hg; now apply Hzeros).
  assert (crown : is_margin (flag w) x FromExtrados (x Hinge) = 0) by vanishes zero.
  assert (crown' : is_margin_slope (flag w) x FromExtrados (x Hinge) = 0) by vanishes zero.
  assert (haunch : is_margin (flag w) x FromIntrados (- x BetaR) = 0) by vanishes zero.
  assert (haunch' : is_margin_slope (flag w) x FromIntrados (- x BetaR) = 0) by vanishes zero.
  assert (shoulder : is_margin (flag w) x AgainstOutwards (x Alpha) = 0) by vanishes zero.
  assert (inside : k = SlidesInside -> is_margin (flag w) x AgainstOutwards (- x BetaS) = 0 /\
    is_margin_slope (flag w) x AgainstOutwards (- x BetaS) = 0) by (intros ->; split; vanishes zero).
  assert (opens : k = OpensAtShoulder -> is_margin (flag w) x FromExtrados (x Alpha) = 0)
    by (intros ->; vanishes zero).
  assert (Hknown : List.Forall (is_known w x) (known_margins w k E)).
  { unfold known_margins.
    repeat apply List.Forall_cons; try apply List.Forall_nil;
      intros near Hnear; cbn [fst snd] in *; rewrite ?in_app_iff in Hnear.
    - destruct Hnear as [Hin | Hin]; [now apply (near_joint_sound w E x HE _ _ (x Hinge) _ Hin); [apply HE | |] |].
      destruct k; try easy. now apply (near_end_sound w E x HE _ _ Hin), opens.
    - now apply (near_joint_sound w E x HE _ _ (- x BetaR) _ Hnear); [apply has_neg, HE | |].
    - easy.
    - destruct Hnear as [Hin | Hin]; [now apply (near_end_sound w E x HE _ _ Hin) |]. destruct k; try easy.
      destruct (inside eq_refl). now apply (near_joint_sound w E x HE _ _ (- x BetaS) _ Hin); [apply has_neg, HE | |]. }
  assert (admitted : whole_admissible (flag w) (x Alpha) (x Eta) (x Mu) (x Thrust) (x Moment) (x Force)).
  { intros j Hj.
    assert (Hall := whole_covered_sound piece_bits w E x HE (known_margins w k E) ltac:(easy)
                      ltac:(pose proof PI_4; lra) Hknown j Hj).
    unfold known_margins in Hall. list_of Hall. cbn [fst is_margin] in *. tauto. }
  assert (Hsigns := all_signs full E x _ ltac:(eassumption) HE).
  assert (Hs : 0 < x Alpha -> sin (x Alpha) <> 0) by (intros Ha; positive).
  split; [exact Harch |]. exists (rates_of k x). refine (conj alpha (conj _ (conj _ (conj _ Hvalues)))).
  - rewrite coefficient_is. fold f. change (rates_of k x Mu) with (x Mu). rewrite mu.
    now replace (is_limited f) with true.
  - cbn [is_margin] in *. assert (admitted' := admitted). unfold whole_admissible in admitted'.
    assert (thickness : 0 < x Eta < 2) by (split; [| enough (0 < meaning x inner) by (cbn [meaning inner] in *; lra)];
      [apply (proj1 (List.Forall_forall _ _) Hsigns (Val Eta)) | apply (proj1 (List.Forall_forall _ _) Hsigns inner)];
      destruct k; simpl; tauto).
    assert (compressed : forall j, - x Alpha <= j <= x Alpha -> 0 <= whole_normal (x Thrust) (x Force) j).
    { intros j Hj. destruct (admitted' j Hj) as (Hout & Hin & _). unfold from_extrados, from_intrados in *.
      apply (Rmult_le_reg_l (x Eta)); [easy |]. unfold extrados, intrados in *. lra. }
    split; [change (0 < x Eta <= 2); lra | split; [exact compressed |]].
    destruct k; list_of Hsigns; cbn [meaning slip_numerator rate_divisor inner outer] in *.
    + destruct (inside eq_refl) as [slides _]. destruct (slips_inside x) as [Es Eu].
      change (asymmetric_solution (flag w) (x Alpha) (x Mu) (x Eta) (x Thrust) (x Moment) (x Force) (x Hinge) (x BetaR)
                (x BetaS) (slips_of SlidesInside x Slip) (slips_of SlidesInside x InnerSlip)).
      assert (divisor : 0 < determinant (x Alpha) (x BetaS)) by assumption.
      assert (slip : 0 < slips_of SlidesInside x Slip) by (apply Rdiv_lt_0_compat; assumption).
      assert (inner : 0 < slips_of SlidesInside x InnerSlip) by (apply Rdiv_lt_0_compat; assumption).
      assert (fit := rates_fit (x Alpha) (x Eta) (x Hinge) (x BetaR) (x BetaS) ltac:(lra)).
      rewrite <- Es, <- Eu in fit. unfold asymmetric_solution.
      repeat split; try assumption; try lra; now apply admitted'.
    + assert (gapes := opens eq_refl). destruct (slips_opening x) as (Es & Ew & Ed).
      change (shoulder_solution (flag w) (x Alpha) (x Mu) (x Eta) (x Thrust) (x Moment) (x Force) (x Hinge) (x BetaR)
                (slips_of OpensAtShoulder x Slip) (slips_of OpensAtShoulder x Opening)
              /\ 0 < slips_of OpensAtShoulder x Opening).
      assert (slip : 0 < slips_of OpensAtShoulder x Slip) by (apply Rdiv_lt_0_compat; assumption).
      assert (opening : 0 < slips_of OpensAtShoulder x Opening) by (apply Rdiv_lt_0_compat; assumption).
      assert (divisor : 0 < shoulder_determinant (x Alpha) (x Eta) (x BetaR)) by (rewrite <- Ed; assumption).
      assert (fit := opening_fits (x Alpha) (x Eta) (x Hinge) (x BetaR) ltac:(lra)). rewrite <- Es, <- Ew in fit.
      unfold shoulder_solution. rewrite gapes, Rmult_0_r. repeat split; try assumption; try lra; now apply admitted'.
    + assert (misfit := zero _ ltac:(cbn [asymmetric_zeros app In]; right; right; right; right; right; left; reflexivity)).
      cbn [meaning inner outer] in misfit.
      change (shoulder_solution (flag w) (x Alpha) (x Mu) (x Eta) (x Thrust) (x Moment) (x Force) (x Hinge) (x BetaR)
                (slips_of SlidesAlone x Slip) 0).
      assert (slip : 0 < slips_of SlidesAlone x Slip) by (apply Rdiv_lt_0_compat; assumption).
      assert (Es : slips_of SlidesAlone x Slip = across (x Eta) (x Hinge) (x BetaR) / sin (x Alpha)).
      { change (meaning x gap_across / sin (x Alpha) = across (x Eta) (x Hinge) (x BetaR) / sin (x Alpha)).
        now rewrite meaning_across. }
      assert (fit := slip_alone_fits (x Alpha) (x Eta) (x Hinge) (x BetaR) ltac:(lra)
                       ltac:(unfold extrados, intrados; lra)).
      rewrite <- Es in fit. unfold shoulder_solution. repeat split; try assumption; try lra; now apply admitted'.
  - unfold is_power.
    destruct k; unfold rates_of; cbn [power_of meaning right left normal_at angle_of sine_of cosine_of];
      unfold whole_normal; rewrite ?sin_neg, ?cos_neg; cbn [slips_of]; ring.
Qed.

(** ** The theorem *)

Theorem sound c : check c = true -> claim_of c.
Proof.
  unfold check. destruct (about c) eqn:Habout; [now apply check_state_sound | now apply check_too_thin_sound
    | now apply check_slides_sound | now apply check_too_wide_sound | now apply check_stands_sound
    | now apply check_landmark_sound | now apply check_asymmetric_sound].
Qed.
