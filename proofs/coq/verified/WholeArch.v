(** * Admissible at every joint of the whole arch, computed

    A margin is nowhere negative on a piece of the arch where it is positive in the middle and its slope does not change
    that; or near a joint where it touches zero, as it bends away there; or near the springing where it is zero, as it
    falls towards it.  The arch is cut into pieces until each is one of these. *)

From Coq Require Import Reals ZArith Lra Lia Bool List.
From Interval Require Import Interval.Interval.
From Couplet Require Import Arch Contraction Whole Enclosures Formulas Equations Root.
Import ListNotations.

(** ** The margins at a joint *)

(** A joint to the right of the crown, or as far to the left: its angle with sine and cosine. *)
Record side := Side { angle_of : formula; sine_of : formula; cosine_of : formula }.

Local Open Scope formula_scope.
Definition right (n : name) : side := Side (Val n) (Sin n) (Cos n).
Definition left (n : name) : side := Side (- Val n) (- Sin n) (Cos n).

Definition half_outer : formula := 1 + Val Eta * Ratio 1 2.
Definition half_inner : formula := 1 - Val Eta * Ratio 1 2.
Definition normal_at (j : side) : formula := Val Thrust * cosine_of j + (angle_of j - Val Force) * sine_of j.
Definition shear_at (j : side) : formula := (angle_of j - Val Force) * cosine_of j - Val Thrust * sine_of j.
Definition moment_at (w : weight) (j : side) : formula := Val Moment + centroid w * (1 - cosine_of j).
Definition normal_slope_at (j : side) : formula :=
  (1 - Val Thrust) * sine_of j + (angle_of j - Val Force) * cosine_of j.
Definition shear_slope_at (j : side) : formula :=
  (1 - Val Thrust) * cosine_of j - (angle_of j - Val Force) * sine_of j.

Inductive margin := FromExtrados | FromIntrados | AgainstInwards | AgainstOutwards.
Definition margin_at (w : weight) (m : margin) (j : side) : formula :=
  match m with
  | FromExtrados => half_outer * normal_at j - moment_at w j
  | FromIntrados => moment_at w j - half_inner * normal_at j
  | AgainstInwards => Val Mu * normal_at j - shear_at j
  | AgainstOutwards => Val Mu * normal_at j + shear_at j
  end.
Definition margin_slope_at (w : weight) (m : margin) (j : side) : formula :=
  match m with
  | FromExtrados => half_outer * normal_slope_at j - centroid w * sine_of j
  | FromIntrados => centroid w * sine_of j - half_inner * normal_slope_at j
  | AgainstInwards => Val Mu * normal_slope_at j - shear_slope_at j
  | AgainstOutwards => Val Mu * normal_slope_at j + shear_slope_at j
  end.
Local Close Scope formula_scope.

(** The margins of the theory. *)
Definition is_margin (d : R) (x : configuration) (m : margin) (j : R) : R :=
  match m with
  | FromExtrados => from_extrados d (x Eta) (x Thrust) (x Moment) (x Force) j
  | FromIntrados => from_intrados d (x Eta) (x Thrust) (x Moment) (x Force) j
  | AgainstInwards => against_inwards (x Mu) (x Thrust) (x Force) j
  | AgainstOutwards => against_outwards (x Mu) (x Thrust) (x Force) j
  end.
Definition is_margin_slope (d : R) (x : configuration) (m : margin) (j : R) : R :=
  match m with
  | FromExtrados => extrados_slope d (x Eta) (x Thrust) (x Force) j
  | FromIntrados => intrados_slope d (x Eta) (x Thrust) (x Force) j
  | AgainstInwards => inwards_slope (x Mu) (x Thrust) (x Force) j
  | AgainstOutwards => outwards_slope (x Mu) (x Thrust) (x Force) j
  end.

Ltac margin_in_numbers :=
  unfold margin_at, margin_slope_at, is_margin, is_margin_slope, half_outer, half_inner, normal_at, shear_at, moment_at,
    normal_slope_at, shear_slope_at, right, left; whole;
  cbn [meaning angle_of sine_of cosine_of]; rewrite ?meaning_centroid, ?sin_neg, ?cos_neg; unfold fac.

Lemma margin_right w m n x : meaning x (margin_at w m (right n)) = is_margin (flag w) x m (x n).
Proof. destruct m; margin_in_numbers; field. Qed.
Lemma margin_left w m n x : meaning x (margin_at w m (left n)) = is_margin (flag w) x m (- x n).
Proof. destruct m; margin_in_numbers; field. Qed.
Lemma slope_right w m n x : meaning x (margin_slope_at w m (right n)) = is_margin_slope (flag w) x m (x n).
Proof. destruct m; margin_in_numbers; field. Qed.
Lemma slope_left w m n x : meaning x (margin_slope_at w m (left n)) = is_margin_slope (flag w) x m (- x n).
Proof. destruct m; margin_in_numbers; field. Qed.

(** ** Along the arch *)

Definition at_joint (x : configuration) (j : R) : configuration := fun n => if same Joint n then j else x n.

Definition along (w : weight) (m : margin) : formula := margin_at w m (right Joint).
Definition along_slope (w : weight) (m : margin) : formula := slope Joint (along w m).
Definition along_bend (w : weight) (m : margin) : formula := slope Joint (along_slope w m).

Lemma derivative_along x f j : (forall n, ~ In n (divides f)) ->
  is_derive (fun s => meaning (at_joint x s) f) j (meaning (at_joint x j) (slope Joint f)).
Proof.
  intros Hplain. assert (H := slope_along x [Joint] (fun _ => 0) (fun _ => 1) j f eq_refl).
  assert (E : forall s, place x [Joint] (fun _ => 0 + s * 1) = at_joint x s).
  { intros s. apply FunctionalExtensionality.functional_extensionality. intros n. unfold at_joint. cbn [place].
    destruct (same Joint n); [| easy]. change (0 + s * 1 = s). ring. }
  apply (is_derive_ext (fun s => meaning (place x [Joint] (fun _ => 0 + s * 1)) f)).
  { intros s. now rewrite E. }
  replace (meaning (at_joint x j) (slope Joint f)) with (Contraction.sum (length [Joint]) (fun k =>
    meaning (place x [Joint] (fun _ => 0 + j * 1)) (slope (nth k [Joint] Alpha) f) * 1)).
  - apply H. intros n Hn. now apply Hplain in Hn.
  - rewrite E. cbn [length nth]. change (Contraction.sum 1 ?g) with (0 + g 0%nat). cbn [nth]. ring.
Qed.

Lemma along_plain w m n : ~ In n (divides (along w m)).
Proof. destruct w, m; simpl; tauto. Qed.
Lemma along_slope_plain w m n : ~ In n (divides (along_slope w m)).
Proof. destruct w, m; simpl; tauto. Qed.

Lemma along_is w m x j : meaning (at_joint x j) (along w m) = is_margin (flag w) x m j.
Proof. unfold along. rewrite margin_right. destruct m; reflexivity. Qed.

Lemma margin_has_slope w x m j : is_derive (is_margin (flag w) x m) j (is_margin_slope (flag w) x m j).
Proof.
  destruct m; [apply extrados_has_slope | apply intrados_has_slope | apply inwards_has_slope | apply outwards_has_slope].
Qed.

Lemma along_slope_is w m x j : meaning (at_joint x j) (along_slope w m) = is_margin_slope (flag w) x m j.
Proof.
  assert (H := derivative_along x (along w m) j (along_plain w m)). apply is_derive_unique in H. unfold along_slope.
  rewrite <- H. apply is_derive_unique, (is_derive_ext (is_margin (flag w) x m)); [| apply margin_has_slope].
  intros s. symmetry. apply along_is.
Qed.

(** ** Pieces *)

Section Pieces.

Variables (prec : Z) (w : weight) (E : surroundings).

Definition with_joint (F : functions) : surroundings := fun n => if same Joint n then F else E n.

(** The largest set around a joint on which the margin is shown not to be negative. *)
Definition bends_away (m : margin) (near : enclosure) : bool :=
  is_positive (enclosed prec (with_joint (angle prec near)) (along_bend w m)).
Definition falls (m : margin) (near : enclosure) : bool :=
  is_positive (I.neg (enclosed prec (with_joint (angle prec near)) (along_slope w m))).

Definition widened (X : enclosure) (k : Z) : enclosure := I.add prec X (symmetric (Dyadic 1 (- k))).

Fixpoint neighbourhood (tries : nat) (k : Z) (test : enclosure -> bool) (X : enclosure) : option enclosure :=
  match tries with
  | O => None
  | S rest =>
      let near := widened X k in
      if test near then Some near else neighbourhood rest (k + 1) test X
  end.

(** A margin with the sets on which it is known not to be negative. *)
Definition known_margin : Type := (margin * list enclosure)%type.

(** The piece of radius [2 ^ e] about [m 2 ^ e]. *)
Definition settled (m e : Z) (km : known_margin) (F G : functions) : bool :=
  existsb (I.subset (itself G)) (snd km)
  || is_positive (I.add prec (enclosed prec (with_joint F) (along w (fst km)))
                    (I.mul prec (enclosed prec (with_joint G) (along_slope w (fst km)))
                       (symmetric (Dyadic 1 e)))).

Definition piece (m e : Z) : enclosure := around prec (Dyadic m e) (Dyadic 1 e).

Definition is_beyond (X A : enclosure) : bool := is_positive (I.sub prec X A) || is_positive (I.sub prec (I.neg X) A).

Fixpoint covered (depth : nat) (margins : list known_margin) (m e : Z) : bool :=
  let X := piece m e in
  if is_beyond X (itself (E Alpha)) then true
  else
    let F := angle prec (exact (Dyadic m e)) in
    let r := symmetric (Dyadic 1 e) in
    let G := Functions X (I.add prec (sine F) r) (I.add prec (cosine F) r) anything in
    match filter (fun km => negb (settled m e km F G)) margins with
    | [] => true
    | rest =>
        match depth with
        | O => false
        | S d => covered d rest (2 * m - 1) (e - 1) && covered d rest (2 * m + 1) (e - 1)
        end
    end.

Definition deepest : nat := 27.

(** From -4 to 4, which holds every arch: 32 pieces. *)
Definition whole_covered (margins : list known_margin) : bool :=
  forallb (fun i => covered deepest margins (2 * Z.of_nat i - 31) (-3)) (seq 0 32).

End Pieces.

(** ** What is covered is not negative *)

Lemma convex X a b x : has X a -> has X b -> a <= x <= b -> has X x.
Proof. unfold has. destruct (I.convert X) as [| [| l] [| u]]; simpl; try easy; lra. Qed.

Section Sound.

Variables (prec : Z) (w : weight) (E : surroundings) (x : configuration).
Hypothesis around : surrounds E x.

Notation not_negative m j := (0 <= is_margin (flag w) x m j).

Lemma surrounds_joint F j : covers F j -> surrounds (with_joint E F) (at_joint x j).
Proof. intros HF n. unfold with_joint, at_joint. destruct (same Joint n); [exact HF | apply around]. Qed.

Lemma slope_derivative m j : is_derive (is_margin_slope (flag w) x m) j (meaning (at_joint x j) (along_bend w m)).
Proof.
  apply (is_derive_ext (fun s => meaning (at_joint x s) (along_slope w m))); [intros s; apply along_slope_is
    | apply derivative_along, along_slope_plain].
Qed.

(** A set on which a margin is not negative inside the arch. *)
Definition safe (m : margin) (near : enclosure) : Prop :=
  forall j, has near j -> - x Alpha <= j <= x Alpha -> not_negative m j.

Lemma safe_if_bends m near c : bends_away prec w E m near = true -> has near c ->
  is_margin (flag w) x m c = 0 -> is_margin_slope (flag w) x m c = 0 -> safe m near.
Proof.
  intros Htest Hc H0 H1 j Hj _. assert (bend : forall k, has near k -> 0 <= meaning (at_joint x k) (along_bend w m)).
  { intros k Hk. apply Rlt_le, (is_positive_sound _ _ Htest), has_meaning, surrounds_joint, covers_angle, Hk. }
  apply (Whole.touching (is_margin (flag w) x m) (is_margin_slope (flag w) x m)
           (fun k => meaning (at_joint x k) (along_bend w m)) (Rmin j c) (Rmax j c) c);
    [intros; apply margin_has_slope | intros; apply slope_derivative | exact H0 | exact H1 |
    | split; [apply Rmin_r | apply Rmax_r] | split; [apply Rmin_l | apply Rmax_l]].
  intros k Hk. apply bend. destruct (Rle_dec j c).
  - rewrite Rmin_left, Rmax_right in Hk by lra. now apply (convex near j c).
  - rewrite Rmin_right, Rmax_left in Hk by lra. now apply (convex near c j).
Qed.

Lemma safe_if_falls m near : falls prec w E m near = true -> has near (x Alpha) ->
  is_margin (flag w) x m (x Alpha) = 0 -> safe m near.
Proof.
  intros Htest Halpha H0 j Hj Hin.
  apply (falling (is_margin (flag w) x m) (is_margin_slope (flag w) x m) j (x Alpha));
    [intros; apply margin_has_slope | exact H0 | | lra]. intros k Hk.
  assert (has near k) by (now apply (convex near j (x Alpha))).
  assert (0 < - meaning (at_joint x k) (along_slope w m)).
  { apply (is_positive_sound _ _ Htest), has_neg, has_meaning, surrounds_joint. now apply covers_angle. }
  rewrite along_slope_is in *. lra.
Qed.

Definition is_known (km : known_margin) : Prop := forall near, In near (snd km) -> safe (fst km) near.

Lemma covers_middle m e : covers (angle prec (exact (Dyadic m e))) (value (Dyadic m e)).
Proof. apply covers_angle, has_exact. Qed.

Lemma settled_sound m e km j : let F := angle prec (exact (Dyadic m e)) in let r := symmetric (Dyadic 1 e) in
  let G := Functions (piece prec m e) (I.add prec (sine F) r) (I.add prec (cosine F) r) anything in
  settled prec w E m e km F G = true -> is_known km -> Rabs (j - value (Dyadic m e)) <= value (Dyadic 1 e) ->
  - x Alpha <= j <= x Alpha -> not_negative (fst km) j.
Proof.
  intros F r G Htest Hknown Hj Hin. set (c := value (Dyadic m e)) in *.
  assert (HG : forall k, Rabs (k - c) <= value (Dyadic 1 e) -> covers G k).
  { intros k Hk. assert (HF := covers_middle m e).
    destruct (covers_spread prec _ c (Dyadic 1 e) k HF Hk) as (_ & Hs & Hc & _).
    refine (conj (has_around prec (Dyadic m e) (Dyadic 1 e) k Hk) (conj Hs (conj Hc _))). apply has_anything. }
  unfold settled in Htest. apply orb_true_iff in Htest. destruct Htest as [Hnear | Hpositive].
  - apply existsb_exists in Hnear. destruct Hnear as (near & Hin' & Hsubset). apply (Hknown near Hin'); [| exact Hin].
    apply (I.subset_correct (itself G) near); [apply (HG j Hj) | exact Hsubset].
  - destruct (MVT_gen (is_margin (flag w) x (fst km)) c j (is_margin_slope (flag w) x (fst km))) as (k & Hk & Hvalue).
    + intros k _. apply margin_has_slope.
    + intros k _. apply continuity_pt_filterlim. apply (ex_derive_continuous (is_margin (flag w) x (fst km))).
      eexists. apply margin_has_slope.
    + assert (Hkj : Rabs (k - c) <= value (Dyadic 1 e)).
      { eapply Rle_trans; [| exact Hj]. unfold Rmin, Rmax in Hk. destruct (Rle_dec c j);
          [rewrite !Rabs_pos_eq by lra; lra | rewrite !Rabs_left1 by lra; lra]. }
      enough (0 < is_margin (flag w) x (fst km) c + is_margin_slope (flag w) x (fst km) k * (j - c)) by lra.
      apply (is_positive_sound _ _ Hpositive). apply has_add.
      * rewrite <- along_is. apply has_meaning, surrounds_joint, covers_middle.
      * apply has_mul; [rewrite <- along_slope_is; apply has_meaning, surrounds_joint, HG, Hkj |].
        now apply has_symmetric.
Qed.

Definition covers_all (depth : nat) : Prop := forall margins m e,
  covered prec w E depth margins m e = true -> List.Forall is_known margins ->
  forall j, Rabs (j - value (Dyadic m e)) <= value (Dyadic 1 e) -> - x Alpha <= j <= x Alpha ->
  List.Forall (fun km => not_negative (fst km) j) margins.

Lemma one_piece depth : (forall d, depth = S d -> covers_all d) -> covers_all depth.
Proof.
  intros IH margins m e Htest Hknown j Hj Hin. set (F := angle prec (exact (Dyadic m e))).
  set (r := symmetric (Dyadic 1 e)).
  set (G := Functions (piece prec m e) (I.add prec (sine F) r) (I.add prec (cosine F) r) anything).
  set (open := filter (fun km => negb (settled prec w E m e km F G)) margins).
  assert (Hstep : is_beyond prec (piece prec m e) (itself (E Alpha)) = true \/ open = [] \/ exists d, depth = S d /\
    covered prec w E d open (2 * m - 1) (e - 1) = true /\ covered prec w E d open (2 * m + 1) (e - 1) = true).
  { destruct depth as [| d]; cbn [covered] in Htest; cbv zeta in Htest; fold F r in Htest; fold G in Htest;
      fold open in Htest; (destruct (is_beyond _ _ _); [now left | right]);
      (destruct open as [| first rest]; [now left | right]); [easy |].
    apply andb_true_iff in Htest. now exists d. }
  clear Htest. destruct Hstep as [Hbeyond | Hstep].
  { exfalso. assert (HX := has_around prec (Dyadic m e) (Dyadic 1 e) j Hj). apply orb_true_iff in Hbeyond.
    destruct Hbeyond as [H | H].
    - assert (0 < j - x Alpha) by (apply (is_positive_sound _ _ H), has_sub; [exact HX | apply around]). lra.
    - assert (0 < - j - x Alpha) by (apply (is_positive_sound _ _ H), has_sub; [now apply has_neg | apply around]).
      lra. }
  assert (closed : forall km, In km margins -> In km open \/ not_negative (fst km) j).
  { intros km Hkm. destruct (settled prec w E m e km F G) eqn:Ht.
    - right. apply (settled_sound m e km j Ht); auto. now apply (proj1 (List.Forall_forall _ _) Hknown).
    - left. apply filter_In. now rewrite Ht. }
  assert (Hopen : List.Forall (fun km => not_negative (fst km) j) open).
  { destruct Hstep as [-> | (d & Hd & Hleft & Hright)]; [apply List.Forall_nil |].
    assert (Hknown' : List.Forall is_known open).
    { apply List.Forall_forall. intros km Hkm. apply (proj1 (List.Forall_forall _ _) Hknown). unfold open in Hkm.
      now apply filter_In in Hkm. }
    assert (double : powerRZ 2 e = 2 * powerRZ 2 (e - 1)).
    { replace e with ((e - 1) + 1)%Z at 1 by ring. rewrite powerRZ_add by lra. simpl. ring. }
    assert (half : value (Dyadic 1 e) = 2 * value (Dyadic 1 (e - 1)))
      by (unfold value; cbn [mantissa exponent]; rewrite double; ring).
    assert (parts : forall s, value (Dyadic (2 * m + s) (e - 1))
                              = value (Dyadic m e) + IZR s * value (Dyadic 1 (e - 1))).
    { intros s. unfold value. cbn [mantissa exponent]. rewrite plus_IZR, mult_IZR, double. ring. }
    apply Rabs_le_between in Hj. destruct (Rle_dec j (value (Dyadic m e))).
    - apply (IH d Hd open (2 * m - 1)%Z (e - 1)%Z Hleft Hknown' j); [| exact Hin]. apply Rabs_le.
      replace (2 * m - 1)%Z with (2 * m + -1)%Z by ring. rewrite parts.
      replace (IZR (-1)) with (- (1)) by (simpl; ring). lra.
    - apply (IH d Hd open (2 * m + 1)%Z (e - 1)%Z Hright Hknown' j); [| exact Hin]. apply Rabs_le. rewrite parts. lra. }
  apply List.Forall_forall. intros km Hkm. destruct (closed km Hkm) as [Hin' |]; [| easy].
  now apply (proj1 (List.Forall_forall _ _) Hopen).
Qed.

Lemma covered_sound depth : covers_all depth.
Proof. induction depth as [| depth IH]; apply one_piece; intros d; [easy |]. now intros [= ->]. Qed.

Lemma found_piece (j : R) : - 4 <= j <= 4 ->
  exists i, In i (seq 0 32) /\ Rabs (j - value (Dyadic (2 * Z.of_nat i - 31) (-3))) <= value (Dyadic 1 (-3)).
Proof.
  intros Hj. assert (eighth : powerRZ 2 (-3) = 1 / 8) by (simpl; field). unfold value. cbn [mantissa exponent].
  rewrite eighth. destruct (archimed (4 * (j + 4))) as [Hup Hdown]. set (z := (up (4 * (j + 4)) - 1)%Z).
  assert (Hz : IZR z <= 4 * (j + 4) < IZR z + 1) by (unfold z; rewrite minus_IZR; lra).
  assert (range : (-1 < z < 33)%Z) by (split; apply lt_IZR; lra). exists (Z.to_nat (Z.min z 31)).
  split; [apply in_seq; lia |]. rewrite Z2Nat.id by lia. rewrite minus_IZR, mult_IZR. apply Rabs_le.
  destruct (Z.le_gt_cases z 31) as [Hle | Hgt].
  - rewrite Z.min_l by easy. lra.
  - rewrite Z.min_r by lia. assert (z = 32)%Z as Ez by lia. rewrite Ez in Hz. lra.
Qed.

Theorem whole_covered_sound margins : whole_covered prec w E margins = true -> x Alpha <= 4 ->
  List.Forall is_known margins -> forall j, - x Alpha <= j <= x Alpha ->
  List.Forall (fun km => not_negative (fst km) j) margins.
Proof.
  unfold whole_covered. generalize deepest. intros depth Htest Halpha Hknown j Hj.
  destruct (found_piece j ltac:(lra)) as (i & Hi & Hpiece). assert (Hone := proj1 (forallb_forall _ _) Htest i Hi).
  cbv beta in Hone. exact (covered_sound depth margins _ _ Hone Hknown j Hpiece Hj).
Qed.

End Sound.
