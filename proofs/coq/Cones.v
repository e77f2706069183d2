(** * Linear inequalities without a strict solution have multipliers

    Gordan's theorem, for affine forms of finitely many unknowns, by elimination of one unknown after
    the other: if finitely many forms are positive at no common point, a sum of them with factors
    that are not negative, and not all zero, is a constant that is not positive. *)

From Coq Require Import Reals Lra Lia List.
Import ListNotations.
Open Scope R_scope.

(** ** Affine forms *)

(** A form of [n] unknowns is a list of their coefficients with the constant behind them; a point is
    the list of its coordinates. *)
Fixpoint value (f x : list R) : R :=
  match f, x with
  | a :: f', t :: x' => a * t + value f' x'
  | c :: _, [] => c
  | [], _ => 0
  end.

Fixpoint plus (f g : list R) : list R :=
  match f, g with
  | a :: f', b :: g' => (a + b) :: plus f' g'
  | _, _ => []
  end.

Definition scale (k : R) (f : list R) : list R := map (Rmult k) f.

Lemma length_of_scale (k : R) (f : list R) : length (scale k f) = length f.
Proof. apply map_length. Qed.

Lemma length_of_plus (f g : list R) : length f = length g -> length (plus f g) = length f.
Proof. revert g. induction f as [|a f IH]; intros [|b g] H; try easy. simpl. f_equal. apply IH. now injection H. Qed.

Lemma value_of_scale (k : R) (f x : list R) : value (scale k f) x = k * value f x.
Proof. revert x. induction f as [|a f IH]; intros [|t x]; simpl; try ring. rewrite IH. ring. Qed.

Lemma value_of_plus (f g x : list R) : length f = length g -> value (plus f g) x = value f x + value g x.
Proof.
  revert g x. induction f as [|a f IH]; intros [|b g] x H; try easy.
  - destruct x; simpl; ring.
  - destruct x as [|t x]; simpl; [easy|]. rewrite IH; [ring | now injection H].
Qed.

(** Sums with positive factors, at least one of them: the cone without its apex. *)
Inductive cone (forms : list (list R)) : list R -> Prop :=
  | one f : In f forms -> cone forms f
  | scaled k f : 0 < k -> cone forms f -> cone forms (scale k f)
  | added f g : cone forms f -> cone forms g -> cone forms (plus f g).

(** ** A number between two lists *)

Lemma below_all {X} (above : list X) (b : X -> R) (m : R) :
  (forall g, In g above -> m < b g) -> exists t, m < t /\ forall g, In g above -> t < b g.
Proof.
  induction above as [|g above IH]; intros H.
  - exists (m + 1). split; [lra | easy].
  - destruct IH as (t & Ht & Hall); [intros f Hf; apply H; now right|]. assert (Hg := H g (or_introl eq_refl)).
    exists (Rmin t ((m + b g) / 2)). split.
    + apply Rmin_glb_lt; lra.
    + intros f [<- | Hf].
      * apply Rle_lt_trans with ((m + b g) / 2); [apply Rmin_r | lra].
      * apply Rle_lt_trans with t; [apply Rmin_l | now apply Hall].
Qed.

Lemma between {X} (below above : list X) (b : X -> R) : (forall f g, In f below -> In g above -> b f < b g) ->
  exists t, (forall f, In f below -> b f < t) /\ (forall g, In g above -> t < b g).
Proof.
  intros H.
  enough (exists m, (forall f, In f below -> b f <= m) /\ (forall g, In g above -> m < b g)) as (m & Hbelow & Habove).
  { destruct (below_all above b m Habove) as (t & Ht & Hall). exists t. split; [|easy]. intros f Hf.
    assert (H' := Hbelow f Hf). lra. }
  induction below as [|f below IH].
  - clear H. induction above as [|g above IH]; [now exists 0|]. destruct IH as (m & _ & Hm).
    exists (Rmin m (b g - 1)). split; [easy|]. intros f [<- | Hf].
    + apply Rle_lt_trans with (b g - 1); [apply Rmin_r | lra].
    + apply Rle_lt_trans with m; [apply Rmin_l | now apply Hm].
  - destruct IH as (m & Hm & Hm'); [intros f' g Hf Hg; apply H; [now right | easy]|]. exists (Rmax (b f) m). split.
    + intros f' [<- | Hf]; [apply Rmax_l|]. apply Rle_trans with m; [now apply Hm | apply Rmax_r].
    + intros g Hg. apply Rmax_lub_lt; [apply H; [now left | easy] | now apply Hm'].
Qed.

(** ** Elimination of the first unknown *)

Definition first (f : list R) : R := hd 0 f.

(** A positive sum of two forms in which the first coefficient vanishes. *)
Definition pair (f g : list R) : list R :=
  plus (scale (- first g) (tl f)) (scale (first f) (tl g)).

Definition rising (f : list R) : bool := if Rlt_dec 0 (first f) then true else false.
Definition falling (f : list R) : bool := if Rlt_dec (first f) 0 then true else false.
Definition flat (f : list R) : bool := if Req_EM_T (first f) 0 then true else false.

Definition eliminated (forms : list (list R)) : list (list R) :=
  map (@tl R) (filter flat forms)
  ++ flat_map (fun f => map (pair f) (filter falling forms)) (filter rising forms).

Lemma in_eliminated (forms : list (list R)) (e : list R) : In e (eliminated forms) <->
  (exists f, In f forms /\ first f = 0 /\ e = tl f) \/
  (exists f g, In f forms /\ In g forms /\ 0 < first f /\ first g < 0 /\ e = pair f g).
Proof.
  unfold eliminated. rewrite in_app_iff, in_map_iff, in_flat_map. split.
  - intros [(f & <- & Hf) | (f & Hf & He)].
    + left. exists f. apply filter_In in Hf. unfold flat in Hf.
      destruct (Req_EM_T (first f) 0); [easy | now destruct Hf].
    + right. apply in_map_iff in He. destruct He as (g & <- & Hg). exists f, g. apply filter_In in Hf, Hg.
      unfold rising, falling in *. destruct (Rlt_dec 0 (first f)); [|now destruct Hf].
      destruct (Rlt_dec (first g) 0); [easy | now destruct Hg].
  - intros [(f & Hf & E & ->) | (f & g & Hf & Hg & Ef & Eg & ->)].
    + left. exists f. split; [easy|]. apply filter_In. unfold flat. destruct (Req_EM_T (first f) 0); easy.
    + right. exists f. split.
      * apply filter_In. unfold rising. destruct (Rlt_dec 0 (first f)); easy.
      * apply in_map, filter_In. unfold falling. destruct (Rlt_dec (first g) 0); easy.
Qed.

Lemma forms_of_one_more (n : nat) (f : list R) : length f = S n -> f = first f :: tl f.
Proof. now destruct f. Qed.

Lemma length_of_tail (n : nat) (f : list R) : length f = S n -> length (tl f) = n.
Proof. destruct f; [easy|]. intros H. now injection H. Qed.

Lemma length_of_pair (n : nat) (f g : list R) : length f = S n -> length g = S n -> length (pair f g) = n.
Proof.
  intros Hf Hg. apply length_of_tail in Hf, Hg. unfold pair.
  rewrite length_of_plus; rewrite ?length_of_scale; congruence.
Qed.

(** What is a sum of the eliminated forms is one of the forms themselves. *)
Lemma cone_of_eliminated (n : nat) (forms : list (list R)) : (forall f, In f forms -> length f = S n) ->
  forall e, cone (eliminated forms) e -> cone forms (0 :: e).
Proof.
  intros Hlength e H. induction H as [e He | k e Hk _ IH | e e' _ IH _ IH'].
  - apply in_eliminated in He. destruct He as [(f & Hf & E & ->) | (f & g & Hf & Hg & Ef & Eg & ->)].
    + apply one. now rewrite <- E, <- (forms_of_one_more n f (Hlength f Hf)).
    + assert (Hpair : 0 :: pair f g = plus (scale (- first g) f) (scale (first f) g)).
      { rewrite (forms_of_one_more n f (Hlength f Hf)) at 2. rewrite (forms_of_one_more n g (Hlength g Hg)) at 3.
        simpl. f_equal. ring. }
      rewrite Hpair. apply added; apply scaled; try lra; now apply one.
  - replace (0 :: scale k e) with (scale k (0 :: e)); [now apply scaled|]. simpl. f_equal. ring.
  - replace (0 :: plus e e') with (plus (0 :: e) (0 :: e')); [now apply added|]. simpl. f_equal. ring.
Qed.

(** A point at which the eliminated forms are positive can be completed. *)
Lemma point_of_eliminated (n : nat) (forms : list (list R)) (x : list R) : (forall f, In f forms -> length f = S n) ->
  (forall e, In e (eliminated forms) -> 0 < value e x) ->
  exists t, forall f, In f forms -> 0 < value f (t :: x).
Proof.
  intros Hlength Hpositive. set (bound := fun f => - value (tl f) x / first f).
  destruct (between (filter rising forms) (filter falling forms) bound) as (t & Hlow & Hhigh).
  { intros f g Hf Hg. apply filter_In in Hf, Hg. unfold rising, falling in *.
    destruct (Rlt_dec 0 (first f)) as [Ef|]; [|now destruct Hf].
    destruct (Rlt_dec (first g) 0) as [Eg|]; [|now destruct Hg]. assert (H : 0 < value (pair f g) x).
    { apply Hpositive, in_eliminated. right. exists f, g. tauto. }
    unfold pair in H. rewrite value_of_plus, !value_of_scale in H.
    2:{ rewrite !length_of_scale, !(length_of_tail n); [easy | now apply Hlength..]. }
    unfold bound. apply (Rmult_lt_reg_r (first f * - first g)).
    - apply Rmult_lt_0_compat; lra.
    - replace (- value (tl f) x / first f * (first f * - first g)) with (value (tl f) x * first g) by (field; lra).
      replace (- value (tl g) x / first g * (first f * - first g)) with (value (tl g) x * first f) by (field; lra).
      lra. }
  exists t. intros f Hf. rewrite (forms_of_one_more n f (Hlength f Hf)). simpl.
  destruct (Rtotal_order (first f) 0) as [E | [E | E]].
  - assert (H : t < bound f).
    { apply Hhigh, filter_In. unfold falling. destruct (Rlt_dec (first f) 0); easy. }
    unfold bound in H. apply (Rmult_lt_compat_r (- first f)) in H; [|lra].
    replace (- value (tl f) x / first f * - first f) with (value (tl f) x) in H by (field; lra). lra.
  - rewrite E, Rmult_0_l, Rplus_0_l. apply Hpositive, in_eliminated. left. now exists f.
  - assert (H : bound f < t).
    { apply Hlow, filter_In. unfold rising. destruct (Rlt_dec 0 (first f)); easy. }
    unfold bound in H. apply (Rmult_lt_compat_r (first f)) in H; [|lra].
    replace (- value (tl f) x / first f * first f) with (- value (tl f) x) in H by (field; lra). lra.
Qed.

(** ** Gordan's theorem *)

(** The constant form. *)
Definition constant (n : nat) (c : R) : list R := repeat 0 n ++ [c].

Lemma value_of_constant (n : nat) (c : R) (x : list R) : length x = n -> value (constant n c) x = c.
Proof.
  revert x. unfold constant. induction n as [|n IH]; intros [|t x] H; try easy. simpl.
  rewrite IH; [ring | now injection H].
Qed.

Lemma strict_point_or_constant (n : nat) : forall forms : list (list R),
  (forall f, In f forms -> length f = S n) ->
  (exists x, length x = n /\ forall f, In f forms -> 0 < value f x) \/
  (exists c, c <= 0 /\ cone forms (constant n c)).
Proof.
  induction n as [|n IH]; intros forms Hlength.
  - destruct (Exists_dec (fun f => first f <= 0) forms) as [H | H].
    { intros f. destruct (Rle_dec (first f) 0); [now left | now right]. }
    + right. apply Exists_exists in H. destruct H as (f & Hf & Hc). exists (first f). split; [easy|]. apply one.
      unfold constant. simpl. assert (E := Hlength f Hf). destruct f as [|c [|]]; easy.
    + left. exists []. split; [easy|]. intros f Hf. assert (E := Hlength f Hf). destruct f as [|c f]; [easy|]. simpl.
      apply Rnot_le_lt. intros Hc. apply H. apply Exists_exists. now exists (c :: f).
  - destruct (IH (eliminated forms)) as [(x & Hx & Hpositive) | (c & Hc & Hcone)].
    { intros e He. apply in_eliminated in He. destruct He as [(f & Hf & _ & ->) | (f & g & Hf & Hg & _ & _ & ->)].
      - apply length_of_tail; now apply Hlength.
      - apply length_of_pair; now apply Hlength. }
    + left. destruct (point_of_eliminated (S n) forms x Hlength Hpositive) as (t & Ht). exists (t :: x).
      split; [now simpl; f_equal | easy].
    + right. exists c. split; [easy|]. exact (cone_of_eliminated (S n) forms Hlength _ Hcone).
Qed.

(** The sum of the values with factors. *)
Fixpoint weighted (k : list R) (forms : list (list R)) (x : list R) : R :=
  match k, forms with
  | a :: k', f :: forms' => a * value f x + weighted k' forms' x
  | _, _ => 0
  end.

Fixpoint sum (k : list R) : R := match k with a :: k' => a + sum k' | [] => 0 end.

Lemma weighted_of_scale (a : R) (k : list R) (forms : list (list R)) (x : list R) :
  weighted (scale a k) forms x = a * weighted k forms x.
Proof. revert forms. induction k as [|b k IH]; intros [|f forms]; simpl; try ring. rewrite IH. ring. Qed.

Lemma weighted_of_plus (k l : list R) (forms : list (list R)) (x : list R) :
  length k = length l -> weighted (plus k l) forms x = weighted k forms x + weighted l forms x.
Proof.
  revert l forms. induction k as [|a k IH]; intros [|b l] [|f forms] H; simpl; try ring; try easy.
  rewrite IH; [ring | now injection H].
Qed.

Lemma sum_of_scale (a : R) (k : list R) : sum (scale a k) = a * sum k.
Proof. induction k as [|b k IH]; simpl; [ring | rewrite IH; ring]. Qed.

Lemma sum_of_plus (k l : list R) : length k = length l -> sum (plus k l) = sum k + sum l.
Proof.
  revert l. induction k as [|a k IH]; intros [|b l] H; try easy; simpl; [ring|]. rewrite IH; [ring | now injection H].
Qed.

Lemma single_factor (forms : list (list R)) (f : list R) : In f forms ->
  exists k, length k = length forms /\ (forall a, In a k -> 0 <= a) /\ 0 < sum k /\
    forall x, value f x = weighted k forms x.
Proof.
  assert (Hnone : forall forms x, weighted (map (fun _ => 0) forms) forms x = 0).
  { intros l x. induction l as [|g l IH]; simpl; [easy | rewrite IH; ring]. }
  assert (Hsum : forall forms : list (list R), sum (map (fun _ => 0) forms) = 0).
  { induction forms0 as [|g l IH]; simpl; [easy | rewrite IH; ring]. }
  induction forms as [|g forms IH]; [easy|]. intros [-> | Hf].
  - exists (1 :: map (fun _ => 0) forms). simpl. rewrite map_length. repeat split.
    + intros a [<- | Ha]; [lra|]. apply in_map_iff in Ha. destruct Ha as (_ & <- & _). lra.
    + rewrite Hsum. lra.
    + intros x. rewrite Hnone. ring.
  - destruct (IH Hf) as (k & Hk & Hnotneg & Hpos & E). exists (0 :: k). simpl. repeat split; [now f_equal | | | ].
    + intros a [<- | Ha]; [lra | now apply Hnotneg].
    + lra.
    + intros x. rewrite E. ring.
Qed.

Lemma in_plus (k l : list R) (a : R) : In a (plus k l) -> exists b c, In b k /\ In c l /\ a = b + c.
Proof.
  revert l. induction k as [|b k IH]; intros [|c l] H; try easy. destruct H as [<- | H].
  - exists b, c. simpl. tauto.
  - destruct (IH l H) as (b' & c' & Hb & Hc & ->). exists b', c'. simpl. tauto.
Qed.

Lemma factors_of_cone (n : nat) (forms : list (list R)) (f : list R) :
  (forall f, In f forms -> length f = n) -> cone forms f ->
  length f = n /\
  exists k, length k = length forms /\ (forall a, In a k -> 0 <= a) /\ 0 < sum k /\
    forall x, value f x = weighted k forms x.
Proof.
  intros Hlength H.
  induction H as [f Hf | a f Ha _ (Hf & k & Hk & Hnotneg & Hpos & E)
                 | f g _ (Hf & k & Hk & Hnotneg & Hpos & E) _ (Hg & l & Hl & Hnotneg' & Hpos' & E')].
  - split; [now apply Hlength | now apply single_factor].
  - split; [now rewrite length_of_scale|]. exists (scale a k). rewrite length_of_scale. repeat split; [easy | | | ].
    + intros b Hb. apply in_map_iff in Hb. destruct Hb as (c & <- & Hc).
      apply Rmult_le_pos; [lra | now apply Hnotneg].
    + rewrite sum_of_scale. now apply Rmult_lt_0_compat.
    + intros x. now rewrite value_of_scale, weighted_of_scale, E.
  - assert (Hkl : length k = length l) by congruence. split; [now rewrite length_of_plus; congruence|].
    exists (plus k l). rewrite length_of_plus by easy. repeat split; [easy | | | ].
    + intros b Hb. destruct (in_plus k l b Hb) as (c & d & Hc & Hd & ->). assert (H1 := Hnotneg c Hc).
      assert (H2 := Hnotneg' d Hd). lra.
    + rewrite sum_of_plus by easy. lra.
    + intros x. rewrite value_of_plus by congruence. now rewrite weighted_of_plus, E, E'.
Qed.

(** Either all forms are positive at one point, or a sum of them with factors that are not negative,
    and not all zero, is a constant that is not positive. *)
Theorem strict_point_or_multipliers (n : nat) (forms : list (list R)) : (forall f, In f forms -> length f = S n) ->
  (exists x, length x = n /\ forall f, In f forms -> 0 < value f x) \/
  (exists k c, length k = length forms /\ (forall a, In a k -> 0 <= a) /\ 0 < sum k /\ c <= 0 /\
     forall x, length x = n -> weighted k forms x = c).
Proof.
  intros Hlength. destruct (strict_point_or_constant n forms Hlength) as [H | (c & Hc & Hcone)]; [now left | right].
  destruct (factors_of_cone (S n) forms _ Hlength Hcone) as (_ & k & Hk & Hnotneg & Hpos & E). exists k, c.
  repeat split; try easy. intros x Hx. rewrite <- E. now apply value_of_constant.
Qed.

(** Not both. *)
Theorem no_strict_point_with_multipliers (forms : list (list R)) (k x : list R) (c : R) :
  length k = length forms -> (forall a, In a k -> 0 <= a) -> 0 < sum k -> c <= 0 ->
  weighted k forms x = c -> ~ (forall f, In f forms -> 0 < value f x).
Proof.
  intros Hk Hnotneg Hpos Hc E Hall. enough (0 <= weighted k forms x /\ (0 < sum k -> 0 < weighted k forms x)) by lra.
  clear E Hc Hpos. revert forms Hk Hall. induction k as [|a k IH]; intros [|f forms] Hk Hall; try easy; simpl; [lra|].
  destruct (IH (fun b Hb => Hnotneg b (or_intror Hb)) forms (eq_add_S _ _ Hk) (fun g Hg => Hall g (or_intror Hg))).
  assert (Hf := Hall f (or_introl eq_refl)). destruct (Hnotneg a (or_introl eq_refl)) as [Ha | <-].
  - assert (0 < a * value f x) by now apply Rmult_lt_0_compat. lra.
  - rewrite Rmult_0_l, !Rplus_0_l. easy.
Qed.
