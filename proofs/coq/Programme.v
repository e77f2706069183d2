(** * The least value of the programme (20)

    Finitely many joints. What each asks of the forces is an affine form, and rates fit where linear equations hold: so
    the value of (20) is affine in the forces and in the rates, each for itself. It is least at rates, and then at
    forces, where as many of the conditions are reached as can be, and there are finitely many choices of these. *)

From Coq Require Import Reals Lra Lia List Classical.
From Couplet Require Import Cones.
Import ListNotations.
Open Scope R_scope.

(** The least of finitely many classes is least of all. *)
Lemma least_of_classes {X} (v : X -> R) (place : X -> Prop) o (Ho : place o) tests : forall P : X -> Prop,
  (forall x, place x -> P x -> exists y, place y /\
     forall z, place z -> P z -> (forall t, In t tests -> (t z <-> t x)) -> v y <= v z) ->
  exists y, place y /\ forall z, place z -> P z -> v y <= v z.
Proof.
  induction tests as [| t tests IH]; intros P H.
  - destruct (classic (exists x, place x /\ P x)) as [(x & Hx & HP) | Hnone].
    + destruct (H x Hx HP) as (y & Hy & Hleast). exists y. split; [easy |]. intros z Hz HPz. now apply Hleast.
    + exists o. split; [easy |]. intros z Hz HPz. now destruct Hnone; exists z.
  - assert (part : forall s : Prop, exists y, place y /\ forall z, place z -> P z /\ (t z <-> s) -> v y <= v z).
    { intros s. apply IH. intros x Hx [HP Hs]. destruct (H x Hx HP) as (y & Hy & Hleast). exists y. split; [easy |].
      intros z Hz [HPz Htz] Hsame. apply Hleast; try easy. intros u [<- | Hu]; [tauto | now apply Hsame]. }
    destruct (part True) as (y & Hy & Hin), (part False) as (y' & Hy' & Hout).
    exists (if Rle_dec (v y) (v y') then y else y'). destruct (Rle_dec _ _); (split; [easy |]); intros z Hz HPz;
      (destruct (classic (t z)); [assert (A := Hin z Hz ltac:(tauto)) | assert (A := Hout z Hz ltac:(tauto))]; lra).
Qed.

(** ** Corners *)

Section Corners.

Context {V : Type}.
Variables (line : V -> V -> R -> V) (forms : list (V -> R)) (inside : V -> Prop).
Hypotheses (flat : forall f, In f forms -> affine line f) (straight : holds_lines line inside).

Definition feasible (x : V) : Prop := inside x /\ forall f, In f forms -> 0 <= f x.
(** Where the forms that are zero here are zero, all others are as they are here. *)
Definition corner (x : V) : Prop := feasible x /\
  forall y, inside y -> (forall f, In f forms -> f x = 0 -> f y = 0) -> forall f, In f forms -> f y = f x.

Fixpoint positive (l : list (V -> R)) (x : V) : nat :=
  match l with f :: rest => ((if Req_EM_T (f x) 0 then 0 else 1) + positive rest x)%nat | [] => 0%nat end.

Lemma fewer l x y : (forall f, In f l -> f x = 0 -> f y = 0) -> (positive l y <= positive l x)%nat /\
  forall f, In f l -> f x <> 0 -> f y = 0 -> (positive l y < positive l x)%nat.
Proof.
  induction l as [| g l IH]; intros H; simpl; [split; [lia | easy] |].
  destruct IH as [Hle Hlt]; [intros f Hf; apply H; now right |]. assert (Hg := H g (or_introl eq_refl)).
  destruct (Req_EM_T (g x) 0), (Req_EM_T (g y) 0); (split; [tauto || lia |]); intros f [<- | Hf] Hx Hy;
    try tauto; try lia; specialize (Hlt f Hf Hx Hy); lia.
Qed.

(** On the way through [y], as far as [far], one of the forms that fall may be the first to be zero. *)
Lemma first_zero l x y far : (forall f, In f l -> affine line f /\ 0 <= f x /\ (f x = 0 -> f y = 0)) -> 0 < far ->
  exists t, 0 < t <= far /\ (forall f, In f l -> 0 <= f (line x y t)) /\
    (t = far \/ exists f, In f l /\ f x <> 0 /\ f (line x y t) = 0).
Proof.
  intros H Hfar. induction l as [| f l IH]; [exists far; split; [lra |]; split; [easy | now left] |].
  destruct IH as (t & Ht & Hall & Hend); [intros h Hh; apply H; now right |].
  destruct (H f (or_introl eq_refl)) as (Hf & Hx & Htight). destruct (Rle_dec 0 (f (line x y t))) as [Hle | Hlow].
  { exists t. split; [easy |]. split; [intros h [<- | Hh]; auto |].
    destruct Hend as [-> | (e & He & E)]; [now left | right; exists e; split; [now right | easy]]. }
  rewrite Hf in Hlow. assert (Hne : f x <> 0) by (intros Z; rewrite (Htight Z), Z in Hlow; lra).
  set (s := f x / (f x - f y)). assert (Hfall : f y < f x) by nra. assert (Hs : 0 < s) by (apply Rdiv_lt_0_compat; lra).
  assert (E : f x = s * (f x - f y)) by (unfold s; field; lra). assert (Hst : s < t) by nra. exists s. split; [lra |].
  split; [| right; exists f; split; [now left | rewrite Hf; split; lra]]. intros h [<- | Hh]; [rewrite Hf; lra |].
  assert (A := Hall h Hh). destruct (H h (or_intror Hh)) as (Hh' & B & _). rewrite Hh' in *. nra.
Qed.

(** From each point one comes to a corner at which a form is no larger, if it grows where no other one falls. *)
Variable g : V -> R.
Hypotheses (level : affine line g) (grows : forall x y, (forall f, In f forms -> f x <= f y) -> g x <= g y).

Lemma to_corner n : forall x, feasible x -> (positive forms x < n)%nat -> exists y, corner y /\ g y <= g x.
Proof.
  induction n as [| n IH]; intros x Hx Hn; [lia |]. apply NNPP. intros Hno. apply Hno. exists x. split; [| lra].
  split; [easy |]. intros y Hy Hsame f Hf. apply NNPP. intros Hne. apply Hno. clear Hno. destruct Hx as [Hin Hpos].
  assert (step : forall w, inside w -> (forall f, In f forms -> f x = 0 -> f w = 0) -> g w <= g x ->
            (exists f, In f forms /\ f w < f x) -> exists y, corner y /\ g y <= g x).
  { intros w Hw Hzero Hg (h & Hh & Hfall). assert (Hfar : 0 < h x / (h x - h w)).
    { assert (A := Hpos h Hh). apply Rdiv_lt_0_compat; [| lra].
      destruct A as [A | A]; [easy | rewrite (Hzero h Hh (eq_sym A)) in Hfall; lra]. }
    destruct (first_zero forms x w _ (fun f Hf => conj (flat f Hf) (conj (Hpos f Hf) (Hzero f Hf))) Hfar)
      as (t & Ht & Hall & Hend). assert (Hreached : exists f, In f forms /\ f x <> 0 /\ f (line x w t) = 0).
    { destruct Hend as [-> | Hend]; [exists h | easy]. split; [easy |]. split.
      - intros Z. rewrite (Hzero h Hh Z) in Hfall. lra.
      - rewrite flat by easy. field. lra. }
    destruct Hreached as (e & He & Hne' & E). destruct (IH (line x w t)) as (z & Hz & Hle).
    - split; [now apply straight | easy].
    - apply Nat.lt_le_trans with (positive forms x); [| lia]. apply (fewer forms x (line x w t)) with e; try easy.
      intros f' Hf' Z. rewrite flat, Z, (Hzero f' Hf' Z) by easy. ring.
    - exists z. split; [easy |]. rewrite level in Hle. nra. }
  assert (falls : forall w, g w < g x -> exists f, In f forms /\ f w < f x).
  { intros w Hw. apply NNPP. intros Hnone. assert (g x <= g w); [| lra]. apply grows. intros h Hh. apply Rnot_lt_le.
    intros A. apply Hnone. now exists h. }
  assert (Hback : forall h, In h forms -> h x = 0 -> h (line x y (-1)) = 0)
    by (intros h Hh Z; rewrite flat, Z, (Hsame h Hh Z) by easy; ring). assert (Hin' := straight x y (-1) Hin Hy).
  assert (G := level x y (-1)). assert (F := flat f Hf x y (-1)).
  destruct (Rtotal_order (g y) (g x)) as [A | [A | A]].
  - apply (step y); auto. lra.
  - destruct (Rlt_le_dec (f y) (f x)); [apply (step y) | apply (step (line x y (-1)))]; auto; try lra;
      exists f; split; auto; lra.
  - apply (step (line x y (-1))); auto; [| apply falls]; lra.
Qed.

(** And at one of them it is least. *)
Lemma least_at_corner : (exists x, feasible x) -> exists x, feasible x /\ forall y, feasible y -> g x <= g y.
Proof.
  intros [o Ho]. destruct (to_corner _ o Ho (Nat.lt_succ_diag_r _)) as (c & Hc & _).
  destruct (least_of_classes g corner c Hc (map (fun f x => f x = 0) forms) (fun _ => True)) as (x & Hx & Hleast).
  - intros x Hx _. exists x. split; [easy |]. intros z [[Hz _] _] _ Hsame. apply grows. intros f Hf. apply Req_le.
    symmetry. apply (proj2 Hx); try easy. intros h Hh Z. apply (Hsame (fun x => h x = 0)); [| easy].
    now apply (in_map (fun (f : V -> R) x => f x = 0)).
  - exists x. split; [apply Hx |]. intros y Hy. destruct (to_corner _ y Hy (Nat.lt_succ_diag_r _)) as (z & Hz & Hle).
    specialize (Hleast z Hz I). lra.
Qed.

End Corners.

(** ** The programme *)

Section Programme.

(** Forces, the margin of each joint that may give way, and the linear equations of the rates: that the springings do
    not move, and that the rates add up to one. *)
Context {V I : Type}.
Variables (line : V -> V -> R -> V) (joints : list I) (margin : I -> V -> R) (equations : list ((I -> R) * R)).
Hypothesis flat : forall i, In i joints -> affine line (margin i).

Definition total (k m : I -> R) : R := fold_right (fun i rest => k i * m i + rest) 0 joints.
Definition is_borne (x : V) : Prop := forall i, In i joints -> 0 <= margin i x.
Definition solves (k : I -> R) : Prop := forall w b, In (w, b) equations -> total k w = b.
Definition fit (k : I -> R) : Prop := solves k /\ forall i, In i joints -> 0 <= k i.
(** What (20) makes least. *)
Definition power (k : I -> R) (x : V) : R := total k (fun i => margin i x).

Lemma total_affine t k m k' m' k'' m'' :
  (forall i, In i joints -> k'' i * m'' i = k i * m i + t * (k' i * m' i - k i * m i)) ->
  total k'' m'' = total k m + t * (total k' m' - total k m).
Proof.
  unfold total. clear. induction joints as [| i rest IH]; intros H; simpl; [ring |].
  rewrite (H i (or_introl eq_refl)), IH; [ring |]. intros j Hj. apply H. now right.
Qed.

Lemma total_compared k m k' m' : (forall i, In i joints -> k i * m i <= k' i * m' i) -> total k m <= total k' m'.
Proof.
  unfold total. clear. induction joints as [| i rest IH]; intros H; simpl; [lra |].
  apply Rplus_le_compat; [apply H; now left | apply IH; intros j Hj; apply H; now right].
Qed.

(** Its value is not negative, and zero exactly where forces and rates solve (19). *)
Theorem zero_if_complementary x k : is_borne x -> fit k ->
  0 <= power k x /\ (power k x = 0 <-> forall i, In i joints -> k i * margin i x = 0).
Proof.
  intros Hx [_ Hk]. assert (H : forall i, In i joints -> 0 <= k i * margin i x)
    by (intros i Hi; apply Rmult_le_pos; [now apply Hk | now apply Hx]).
  unfold power, total. clear - H. induction joints as [| i rest IH]; simpl; [split; [lra | split; [easy | lra]] |].
  destruct IH as [Hrest Hzero]; [intros j Hj; apply H; now right |]. assert (H0 := H i (or_introl eq_refl)).
  split; [lra |]. split.
  - intros E j [<- | Hj]; [lra | apply Hzero; [lra | easy]].
  - intros E. rewrite (E i (or_introl eq_refl)), (proj2 Hzero); [ring |]. intros j Hj. apply E. now right.
Qed.

Definition line_of_rates (k k' : I -> R) (t : R) (i : I) : R := k i + t * (k' i - k i).
Definition rates : list ((I -> R) -> R) := map (fun i k => k i) joints.

Lemma each_rate (P : _ -> Prop) : (forall f, In f rates -> P f) <-> forall i, In i joints -> P (fun k => k i).
Proof.
  unfold rates. split; intros H.
  - intros i Hi. apply H. now apply (in_map (fun i (k : I -> R) => k i)).
  - intros f Hf. apply in_map_iff in Hf as (i & <- & Hi). now apply H.
Qed.

Theorem least_value_is_attained : (exists x, is_borne x) -> (exists k, fit k) ->
  exists x k, is_borne x /\ fit k /\ forall x' k', is_borne x' -> fit k' -> power k x <= power k' x'.
Proof.
  intros [o Ho] [r Hr].
  assert (fit_is_feasible : forall k, fit k <-> feasible rates solves k)
    by (intros k; unfold fit, feasible; now rewrite (each_rate (fun f => 0 <= f k))).
  assert (forces : forall k, fit k -> exists x, is_borne x /\ forall y, is_borne y -> power k x <= power k y).
  { intros k [_ Hk].
    destruct (least_at_corner line (map margin joints) (fun _ => True)) with (power k) as (x & [_ Hx] & H); try easy.
    - intros f Hf. apply in_map_iff in Hf as (i & <- & Hi). now apply flat.
    - intros x y t. apply total_affine. intros i Hi. rewrite flat by easy. ring.
    - intros x y A. apply total_compared. intros i Hi. apply Rmult_le_compat_l; [now apply Hk | now apply A, in_map].
    - exists o. split; [easy |]. intros f Hf. apply in_map_iff in Hf as (i & <- & Hi). now apply Ho.
    - exists x. split; [intros i Hi; now apply Hx, in_map |]. intros y Hy. apply H. split; [easy |].
      intros f Hf. apply in_map_iff in Hf as (i & <- & Hi). now apply Hy. }
  assert (corners : forall x k, is_borne x -> fit k -> exists k', corner rates solves k' /\ power k' x <= power k x).
  { intros x k Hx Hk. apply fit_is_feasible in Hk.
    apply (to_corner line_of_rates rates solves) with (g := fun k => power k x) (n := S (positive rates k));
      try easy; try lia.
    - now apply (each_rate (affine line_of_rates)).
    - intros u u' t Hu Hu' w b Hw. rewrite (total_affine t u w u' w), (Hu w b Hw), (Hu' w b Hw); [ring |].
      intros i _. unfold line_of_rates. ring.
    - intros u u' t. apply total_affine. intros i _. unfold line_of_rates. ring.
    - intros u u' H. rewrite (each_rate (fun f => f u <= f u')) in H. apply total_compared. intros i Hi.
      apply Rmult_le_compat_r; [now apply Hx | now apply H]. }
  destruct (corners o r Ho Hr) as (r' & Hr' & _).
  set (test := fun (f : (I -> R) -> R) (s : V * (I -> R)) => f (snd s) = 0).
  destruct (least_of_classes (fun s => power (snd s) (fst s)) (fun s => is_borne (fst s) /\ corner rates solves (snd s))
    (o, r') (conj Ho Hr') (map test rates) (fun _ => True)) as ([x k] & [Hx Hk] & Hleast).
  - intros [x k] [_ Hk] _. destruct (forces k (proj2 (fit_is_feasible k) (proj1 Hk))) as (y & Hy & Hleast).
    exists (y, k). split; [easy |]. intros [x' k'] [Hx' Hk'] _ Hsame. simpl in *.
    apply Rle_trans with (power k x'); [now apply Hleast |]. apply total_compared. intros i Hi. apply Req_le. f_equal.
    symmetry. revert i Hi. apply (each_rate (fun f => f k' = f k)), (proj2 Hk k' (proj1 (proj1 Hk'))). intros h Hh Z.
    apply (Hsame (test h)); [now apply in_map | easy].
  - exists x, k. split; [easy |]. split; [apply fit_is_feasible, Hk |]. intros x' k' Hx' Hk'.
    destruct (corners x' k' Hx' Hk') as (z & Hz & Hle). eapply Rle_trans; [| exact Hle].
    exact (Hleast (x', z) (conj Hx' Hz) Logic.I).
Qed.

End Programme.
