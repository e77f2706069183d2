(** * What is checked is true *)

From Coq Require Import Reals ZArith Lra Lia Bool List.
From Interval Require Import Interval.Interval.
From Couplet Require Import Arch Contraction States Enclosures Formulas Krawczyk Equations Certificate Check.
Import ListNotations.
Open Scope R_scope.

(** A test of many conditions, taken apart. *)
Ltac conditions :=
  repeat match goal with
    | H : (_ && _)%bool = true |- _ => apply andb_true_iff in H; destruct H
    | H : negb _ = false |- _ => apply negb_false_iff in H
    | H : Nat.eqb _ _ = true |- _ => apply Nat.eqb_eq in H
    end.

Lemma each_one {A} (test : A -> bool) l a : forallb test l = true -> In a l -> test a = true.
Proof. intros H. exact (proj1 (forallb_forall test l) H a). Qed.

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

Definition coefficient_or_zero (f : friction) : R :=
  match coefficient f with Some mu => mu | None => 0 end.

Lemma has_friction prec f : has (enclosed_friction prec f) (coefficient_or_zero f).
Proof.
  destruct f; cbn [enclosed_friction coefficient coefficient_or_zero]; unfold coefficient_or_zero; cbn [coefficient].
  - apply has_number.
  - apply has_div; [apply has_sin | apply has_cos]; apply has_number.
  - rewrite <- value_nought. apply has_exact.
Qed.

Lemma surrounds_remembered E x : surrounds E x -> surrounds (remembered E) x.
Proof. intros HE []; apply HE. Qed.

Lemma surrounds_of prec X x : (forall n, has (X n) (x n)) -> surrounds (surroundings_of prec X) x.
Proof. intros HX. apply surrounds_remembered. intros n. now apply covers_functions. Qed.

(** The numbers of an arch; what its mode neither solves for nor is given is zero. *)
Definition numbers_of (a : arch) : configuration := fun n =>
  match n with
  | Alpha => real (half_opening a)
  | Mu => coefficient_or_zero (its_friction a)
  | _ => 0
  end.

Lemma surrounds_given a prec : surrounds (given_enclosures a prec) (numbers_of a).
Proof.
  apply surrounds_of. intros []; cbn [numbers_of];
    first [apply has_number | apply has_friction | rewrite <- value_nought; apply has_exact].
Qed.

(** ** Boxes *)

Section Box.

Variables (prec : Z) (u : list name).
Notation n := (length u).

Lemma surrounds_box G g b x : surrounds G g ->
  length (centre b) = n -> length (radius b) = n -> boxed u (centre b) (radius b) x ->
  surrounds (remembered (sited G u (boxes prec u b))) (place g u x).
Proof.
  intros HG Hc Hr Hx. apply surrounds_remembered, surrounds_sited; [exact HG | |].
  - unfold boxes. rewrite map_length, !combine_length, Hc, Hr, !Nat.min_id. easy.
  - intros i Hi. unfold boxes.
    set (f := fun nb : name * (dyadic * dyadic) =>
                functions_of prec (fst nb) (around prec (fst (snd nb)) (snd (snd nb)))).
    rewrite (nth_indep _ _ (f (Alpha, (nought, nought))))
      by (rewrite map_length, !combine_length, Hc, Hr, !Nat.min_id; easy).
    rewrite map_nth, !combine_nth by (rewrite ?combine_length, ?Hc, ?Hr, ?Nat.min_id; easy).
    apply covers_functions, has_around. simpl.
    specialize (Hx i Hi). now rewrite Rmult_1_l in Hx.
Qed.

Lemma points_nth c i : length c = n -> (i < n)%nat ->
  nth i (points prec u c) (plain anything)
  = functions_of prec (nth i u Alpha) (exact (nth i c nought)).
Proof.
  intros Hc Hi. unfold points.
  set (f := fun nc : name * dyadic => functions_of prec (fst nc) (exact (snd nc))).
  rewrite (nth_indep _ _ (f (Alpha, nought)))
    by (rewrite map_length, combine_length, Hc, Nat.min_id; easy).
  now rewrite map_nth, combine_nth by easy.
Qed.

Lemma points_length c : length c = n -> length (points prec u c) = n.
Proof. intros Hc. unfold points. rewrite map_length, combine_length, Hc. apply Nat.min_id. Qed.

Lemma surrounds_centre G g c : surrounds G g -> length c = n ->
  surrounds (remembered (sited G u (points prec u c))) (place g u (entry c)).
Proof.
  intros HG Hc. apply surrounds_remembered, surrounds_sited; [exact HG | now apply points_length |].
  intros i Hi. rewrite points_nth by easy. apply covers_functions, has_exact.
Qed.

(** Sine and cosine move no faster than the angle. *)
Lemma sine_moves x y : Rabs (sin x - sin y) <= Rabs (x - y).
Proof.
  destruct (MVT_gen sin y x cos) as (t & _ & Ht).
  - intros t _. apply is_derive_sin.
  - intros t _. apply continuity_sin.
  - rewrite Ht, Rabs_mult. destruct (COS_bound t).
    assert (Rabs (cos t) <= 1) by (apply Rabs_le; lra). pose proof (Rabs_pos (x - y)). nra.
Qed.

Lemma cosine_moves x y : Rabs (cos x - cos y) <= Rabs (x - y).
Proof.
  rewrite <- !sin_shift, (Rabs_minus_sym x y).
  replace (y - x) with ((PI / 2 - x) - (PI / 2 - y)) by ring. apply sine_moves.
Qed.

Lemma covers_spread F c r x : covers F c -> Rabs (x - c) <= value r -> covers (spread prec F r) x.
Proof.
  intros (Hc & Hs & Hcos & _) Hx.
  assert (moved : forall X y z, has X y -> Rabs (z - y) <= value r -> has (I.add prec X (symmetric r)) z).
  { intros X y z HX Hz. replace z with (y + (z - y)) by ring. apply has_add; [exact HX |].
    now apply has_symmetric. }
  refine (conj (moved _ _ _ Hc Hx) (conj (moved _ _ _ Hs _) (conj (moved _ _ _ Hcos _) _))).
  - eapply Rle_trans; [apply sine_moves | exact Hx].
  - eapply Rle_trans; [apply cosine_moves | exact Hx].
  - apply has_anything.
Qed.

Lemma surrounds_spread G g c r x : surrounds G g -> length c = n -> length r = n -> boxed u c r x ->
  surrounds (remembered
    (sited G u (map (fun Fr => spread prec (fst Fr) (snd Fr)) (combine (points prec u c) r))))
    (place g u x).
Proof.
  intros HG Hc Hr Hx. assert (Hlength := points_length c Hc).
  apply surrounds_remembered, surrounds_sited; [exact HG | |].
  - rewrite map_length, combine_length, Hlength, Hr. apply Nat.min_id.
  - intros i Hi.
    set (f := fun Fr : functions * dyadic => spread prec (fst Fr) (snd Fr)).
    rewrite (nth_indep _ _ (f (plain anything, nought)))
      by (rewrite map_length, combine_length, Hlength, Hr, Nat.min_id; easy).
    rewrite map_nth, combine_nth, points_nth by congruence. unfold f. simpl fst. simpl snd.
    apply (covers_spread _ (value (nth i c nought))).
    + apply covers_functions, has_exact.
    + specialize (Hx i Hi). now rewrite Rmult_1_l in Hx.
Qed.

Lemma is_inside_sound b B x : is_inside prec n b B = true ->
  boxed u (centre b) (radius b) x -> boxed u (centre B) (radius B) x.
Proof.
  intros Htest Hx i Hi. specialize (Hx i Hi). rewrite Rmult_1_l in Hx |- *.
  apply (each_one _ _ i) in Htest; [| apply in_seq; lia].
  assert (H := is_positive_sound _
    (entry (radius B) i - (entry (radius b) i + Rabs (entry (centre b) i - entry (centre B) i))) Htest).
  assert (0 < entry (radius B) i - (entry (radius b) i + Rabs (entry (centre b) i - entry (centre B) i))).
  { apply H. apply has_sub; [apply has_exact |]. apply has_add; [apply has_exact |].
    apply has_abs, has_sub; apply has_exact. }
  replace (x i - entry (centre B) i)
    with ((x i - entry (centre b) i) + (entry (centre b) i - entry (centre B) i)) by ring.
  eapply Rle_trans; [apply Rabs_triang | lra].
Qed.

End Box.

Lemma are_positive_sound l n i : are_positive l = true -> length l = n -> (i < n)%nat -> 0 < entry l i.
Proof.
  intros Hall <- Hi. apply (each_one _ _ (nth i l nought)) in Hall; [| now apply nth_In].
  apply Z.ltb_lt in Hall. unfold entry, value.
  apply Rmult_lt_0_compat; [now apply IZR_lt | apply powerRZ_lt; lra].
Qed.

(** ** The root *)

Lemma place_given g u x n : existsb (same n) u = false -> place g u x n = g n.
Proof.
  revert x. induction u as [| m u IH]; intros x Habsent; [easy |].
  simpl in *. apply orb_false_elim in Habsent. destruct Habsent as [Hm Hu].
  destruct (same_spec m n) as [-> | _]; [| now apply IH].
  destruct (same_spec n n); easy.
Qed.

Theorem located_sound c given g s E :
  (forall prec, surrounds (given prec) g) -> located c given s = Some E ->
  exists x : configuration,
    surrounds E x /\ (forall n, existsb (same n) (unknowns s) = false -> x n = g n) /\
    (forall f, In f (zeros s) -> meaning x f = 0 /\ defined x f) /\
    (forall f, In f (divisors s) -> meaning x f <> 0).
Proof.
  intros Hg. unfold located. set (u := unknowns s). set (n := length u).
  set (wide := (longest (centre (unique c)) + 64)%Z). set (full := (longest (centre (root c)) + 64)%Z).
  cbv zeta. set (X := remembered (sited (given wide) u (boxes wide u (unique c)))).
  repeat match goal with
    | |- (if ?b then _ else _) = _ -> _ => destruct b eqn:?; try easy
    | |- match ?b with Some _ => _ | None => _ end = _ -> _ => destruct b as [C |] eqn:HC; try easy
    end.
  intros [= <-]. conditions.
  set (m := remembered (sited (given full) u (points full u (centre (root c))))) in *.
  assert (within : forall x, boxed u (centre (root c)) (radius (root c)) x -> surrounds X (place g u x)).
  { intros x Hx. apply surrounds_box; auto. now apply (is_inside_sound full u (root c) (unique c)). }
  destruct (one_root wide u (zeros s) (inverse c) g ltac:(easy) C (centre (root c)) (radius (root c))
              (map (enclosed full m) (zeros s))) as (x & Hx & Hsolves & _); auto.
  - intros y Hy f Hf. apply (is_defined_sound X); [now apply (each_one _ (zeros s)) | now apply within].
  - intros y Hy. now apply (bounds_hold wide u (zeros s) (inverse c) g ltac:(easy) X), within.
  - intros i Hi. now apply (are_positive_sound _ n).
  - intros j Hj. unfold residual.
    rewrite (nth_indep _ _ (enclosed full m (Int 0))) by (rewrite map_length; lia).
    rewrite map_nth. apply has_meaning, surrounds_centre; auto.
  - exists (place g u x). refine (conj _ (conj _ (conj _ _))).
    + now apply surrounds_spread.
    + intros k Hk. now apply place_given.
    + intros f Hf. split.
      * destruct (In_nth _ _ (Int 0) Hf) as (j & Hj & <-). apply Hsolves. lia.
      * apply (is_defined_sound X); [now apply (each_one _ (zeros s)) | now apply within].
    + intros f Hf. apply (is_not_zero_sound (enclosed wide X f)); [| now apply has_meaning, within].
      now apply (each_one (fun f => is_not_zero (enclosed wide X f)) (divisors s)).
Qed.

(** ** Decimals *)

Lemma has_quantity prec E x q : surrounds E x -> has (enclosed_quantity prec E q) (value_of q x).
Proof.
  intros HE. destruct q; cbn [enclosed_quantity value_of].
  - apply HE.
  - apply has_div; [| apply has_pi]. apply has_mul; [apply (has_integer prec 180) | apply HE].
  - apply has_mul; apply HE.
Qed.

Lemma has_twentieths prec m e : has (twentieths prec m e) (IZR m / 20 * powerRZ 10 e).
Proof.
  assert (ten : forall k, (0 <= k)%Z -> IZR (10 ^ k) = powerRZ 10 k).
  { intros k Hk. rewrite <- (Z2Nat.id k) by easy. now rewrite <- pow_powerRZ, <- pow_IZR. }
  unfold twentieths. destruct (Z.leb_spec 0 e).
  - replace (IZR m / 20 * powerRZ 10 e) with (IZR (m * 10 ^ e) / 20)
      by (rewrite mult_IZR, ten by easy; field).
    apply has_div; apply has_integer.
  - replace (IZR m / 20 * powerRZ 10 e) with (IZR m / IZR (20 * 10 ^ (- e))).
    + apply has_div; apply has_integer.
    + assert (Q : powerRZ 10 (- e) <> 0) by (apply powerRZ_NOR; lra).
      assert (product : powerRZ 10 e * powerRZ 10 (- e) = 1)
        by (rewrite <- powerRZ_add by lra; now rewrite Z.add_opp_diag_r).
      replace (powerRZ 10 e) with (/ powerRZ 10 (- e))
        by (apply (Rmult_eq_reg_r (powerRZ 10 (- e))); [now rewrite product, Rinv_l | easy]).
      rewrite mult_IZR, ten by lia. now field.
Qed.

Lemma holds_value_sound prec digits E x qv : holds_value prec digits E qv = true -> surrounds E x ->
  is_rounding digits (snd qv) (value_of (fst qv) x).
Proof.
  destruct qv as [q v]. unfold holds_value, is_rounding. cbn [fst snd].
  intros Htest HE. assert (HX := has_quantity prec E x q HE).
  destruct (Z.eqb_spec (digits_of v) 0) as [Hzero | Hne].
  - left. split; [easy | now apply (is_zero_sound (enclosed_quantity prec E q))].
  - right. conditions.
    repeat match goal with
      | H : (_ <=? _)%Z = true |- _ => apply Z.leb_le in H
      | H : (_ <? _)%Z = true |- _ => apply Z.ltb_lt in H
      end.
    split; [easy |]. set (m := digits_of v) in *. set (unit := powerRZ 10 (power v)).
    assert (above := has_sub prec _ _ _ _ HX
                       (has_twentieths prec (20 * m - (if (m =? 10 ^ (digits - 1))%Z then 1 else 10)) (power v))).
    assert (below := has_sub prec _ _ _ _ (has_twentieths prec (20 * m + 10) (power v)) HX).
    apply is_positive_sound in above; [| assumption]. apply is_positive_sound in below; [| assumption].
    fold unit in above, below. rewrite plus_IZR, mult_IZR in below. rewrite minus_IZR, mult_IZR in above.
    destruct (m =? 10 ^ (digits - 1))%Z; lra.
Qed.

(** ** States *)

(** A state with its steepest joint. *)
Definition steepest_of (x : configuration) : configuration := fun n =>
  match n with BetaS => beta_s (x Thrust) | _ => x n end.

Lemma surrounds_steepest prec E x : surrounds E x -> surrounds (with_steepest prec E) (steepest_of x).
Proof.
  intros HE n. unfold with_steepest. destruct n; try apply HE.
  apply covers_functions, has_sqrt, has_mul; [apply HE |].
  apply has_sub; [apply (has_integer prec 1) | apply HE].
Qed.

Lemma are_all_positive_sound prec E x l f : are_all_positive prec E l = true -> surrounds E x ->
  In f l -> 0 < meaning x f.
Proof.
  intros Hall HE Hf. apply (is_positive_sound (enclosed prec E f)); [| now apply has_meaning].
  exact (each_one _ l f Hall Hf).
Qed.

Lemma is_open_sound prec E x : is_open prec E = true -> surrounds E x -> x Alpha < PI.
Proof.
  intros Htest HE. apply (is_positive_sound _ (PI - x Alpha)) in Htest; [lra |].
  apply has_sub; [apply has_pi | apply HE].
Qed.

Ltac list_of H :=
  cbn [signs some_thrust haunch steepest app equations] in H;
  repeat (apply List.Forall_cons_iff in H; let first := fresh in destruct H as [first H]); clear H.

(** Names of the theory for what the formulas mean. *)
Lemma meaning_limit w x : meaning x (limit w)
  = 2 * normal_force (x Alpha) (x Thrust) - fac (flag w) 2 * (1 - cos (x Alpha)).
Proof. destruct w; unfold limit, normal_force, fac; simpl; field. Qed.

Lemma meaning_extrados w x : meaning x (extrados_at_shoulder w)
  = 2 * (at_shoulder (flag w) (x Alpha) (x Eta) (x Thrust) - at_crown (x Eta) (x Thrust)).
Proof.
  unfold extrados_at_shoulder, at_shoulder, at_crown, extrados, normal_force.
  in_numbers. field.
Qed.

Lemma meaning_next w x : meaning x (next_to_crown w)
  = fac (flag w) (x Eta) - intrados (x Eta) * (2 - x Thrust).
Proof. unfold next_to_crown, intrados. in_numbers. field. Qed.

Lemma friction_below x num den : 0 < meaning x den -> 0 < meaning x (den * Val Mu - num)%formula ->
  meaning x num / meaning x den < x Mu.
Proof.
  intros Hden H. simpl in H. apply (Rmult_lt_reg_r (meaning x den)); [easy |].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
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

Lemma signs_suffice w m f x :
  fits m f = true -> x Alpha < PI ->
  List.Forall (fun g => 0 < meaning x g) (signs w m (is_limited f)) ->
  List.Forall (printed (flag w) x) (equations m) ->
  coefficient f = (if is_limited f then Some (x Mu) else None) ->
  (slides_inside m = false -> is_limited f = true -> x BetaS = beta_s (x Thrust)) ->
  match m with
  | OverturningSliding => x BetaR = 0
  | Overturning => x BetaR = 0 /\ x Thrust = 0
  | _ => True
  end ->
  in_order m x /\ is_least (flag w) (coefficient f) x (crown_moment m (flag w) x).
Proof.
  intros Hfits Hopen Hsigns Hequations Hmu Hsteepest Hfixed. rewrite Hmu. clear Hmu.
  assert (weight := flag_between w).
  destruct m, (is_limited f) eqn:Hlimited; try (destruct f; discriminate).
  all: list_of Hsigns; list_of Hequations.
  all: cbn [printed] in *; rewrite ?meaning_limit, ?meaning_extrados, ?meaning_next in *.
  all: assert (N : 0 < normal_force (x Alpha) (x Thrust)) by assumption.
  all: frictions Hsteepest.
  all: cbn [meaning inner outer upper_lever] in *; rewrite ?meaning_extrados in *.
  all: unfold in_order, is_least, crown_moment.
  - split; [lra |]. apply (rotational _ _ _ weight) with (beta := x BetaR); try tauto; try lra.
    rewrite <- Hsteepest by easy. lra.
  - split; [lra |]. apply (rotational_without_limit _ _ weight) with (beta := x BetaR); try tauto; try lra.
  - split; [lra |]. apply (sliding_rotational _ _ _ weight) with (beta := x BetaR); try tauto; try lra.
    rewrite <- Hsteepest by easy. lra.
  - split; [lra |]. apply (rotational_sliding _ _ _ weight) with (beta := x BetaR) (joint := x BetaS);
      try tauto; try lra.
  - split; [lra |]. apply (rotational_sliding _ _ _ weight) with (beta := x BetaR) (joint := x BetaS);
      try tauto; try lra.
  - split; [lra |]. rewrite Hfixed in *.
    apply (overturning_sliding _ _ _ weight) with (joint := x BetaS); try tauto; try lra.
  - destruct Hfixed as [Hb Hh]. split; [lra |]. rewrite Hh, Hb in *.
    assert (E := shoulder_from_crown (flag w) (x Alpha) ltac:(lra) (x Eta) 0 ltac:(lra) ltac:(easy)).
    unfold at_crown in E. rewrite Rmult_0_r in E. rewrite <- E.
    apply (overturning _ _ weight); try tauto; try lra.
Qed.

Lemma coefficient_is f : coefficient f = if is_limited f then Some (coefficient_or_zero f) else None.
Proof. now destruct f. Qed.

Theorem check_state_sound c m a : about c = State m a -> check_state c m a = true -> claim_of c.
Proof.
  intros Habout Hcheck. unfold check_state in Hcheck. cbv zeta in Hcheck.
  set (w := self_weight a) in *. set (f := its_friction a) in *.
  set (full := (longest (centre (root c)) + 64)%Z) in *.
  apply andb_true_iff in Hcheck. destruct Hcheck as [Hfits Hcheck].
  destruct (located _ _ _) as [E |] eqn:Hlocated; [| easy]. conditions.
  destruct (located_sound _ _ (numbers_of a) _ _ (surrounds_given a) Hlocated)
    as (x & HE & Hgiven & Hzeros & Hdivisors).
  assert (alpha : x Alpha = real (half_opening a)) by (now destruct m; apply Hgiven).
  assert (mu : x Mu = coefficient_or_zero f) by (now destruct m; apply Hgiven).
  assert (Hprinted : List.Forall (printed (flag w) x) (equations m)).
  { apply List.Forall_forall. intros e He. apply cleared_is_printed.
    - intros g Hg. apply Hdivisors. apply in_flat_map. now exists e.
    - destruct e; try exact Logic.I. apply (Hzeros (cleared w (Tangency joint))).
      + now apply (in_map (cleared w)).
      + simpl. auto.
    - apply Hzeros. now apply (in_map (cleared w)). }
  set (S := if is_limited f && negb (slides_inside m) then with_steepest full E else E) in *.
  set (y := if is_limited f && negb (slides_inside m) then steepest_of x else x).
  assert (HS : surrounds S y).
  { unfold S, y. destruct (is_limited f && negb (slides_inside m)); [now apply surrounds_steepest | exact HE]. }
  assert (same_numbers : forall n, n <> BetaS -> y n = x n).
  { intros n Hn. unfold y. destruct (is_limited f && negb (slides_inside m)), n; easy. }
  assert (Hopen := is_open_sound full E x ltac:(easy) HE).
  destruct (signs_suffice w m f y) as [Horder Hleast]; try easy.
  - now rewrite same_numbers.
  - apply List.Forall_forall. intros g Hg. now apply (are_all_positive_sound full S y (signs w m (is_limited f))).
  - apply List.Forall_forall. intros e He. assert (Hp := proj1 (List.Forall_forall _ _) Hprinted e He).
    unfold y. destruct m, (is_limited f); simpl in He;
      repeat match goal with H : _ \/ _ |- _ => destruct H as [<- | H] end; easy.
  - rewrite coefficient_is, same_numbers, mu by easy. easy.
  - intros Hm Hf. unfold y. rewrite Hm, Hf. easy.
  - destruct m; try easy; rewrite ?same_numbers by easy; repeat split; now apply Hgiven.
  - assert (rounded : values_hold c x).
    { intros q v Hq. apply (holds_value_sound full (digits c) E x (q, v)); [| exact HE].
      now apply (each_one _ (values c)). }
    unfold claim_of. rewrite Habout. exists x. fold f w.
    refine (conj alpha (conj _ (conj Hprinted (conj _ (conj rounded _))))).
    + rewrite coefficient_is, mu. now destruct f.
    + unfold y in Horder. destruct m, (is_limited f); exact Horder.
    + unfold y in Hleast. destruct m, (is_limited f); exact Hleast.
Qed.

Theorem sound c : check c = true -> claim_of c.
Proof.
  unfold check. destruct (about c) as [m a] eqn:Habout. now apply check_state_sound.
Qed.
