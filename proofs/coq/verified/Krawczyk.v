(** * Exactly one root in a box, computed

    The test of [Contraction.one_root_by_krawczyk] on enclosures: formulas, a box and a matrix are given; that it is
    regular is seen by elimination over the integers. *)

From Coq Require Import Reals ZArith Lra Lia Bool List.
From Coquelicot Require Import Coquelicot.
From Couplet Require Import Contraction Enclosures Formulas.
Import ListNotations.
Open Scope R_scope.

Definition nought : dyadic := Dyadic 0 0.
Definition entry (l : list dyadic) (i : nat) : R := value (nth i l nought).
Definition entries (m : list (list dyadic)) (i k : nat) : R := entry (nth i m []) k.

Lemma value_nought : value nought = 0.
Proof. unfold value. simpl. ring. Qed.

(** ** A regular matrix *)

Fixpoint product (row : list Z) (v : point) : R :=
  match row with
  | [] => 0
  | a :: rest => IZR a * v 0%nat + product rest (fun j => v (S j))
  end.

(** [a p - b q] *)
Fixpoint combination (a : Z) (p : list Z) (b : Z) (q : list Z) : list Z :=
  match p, q with
  | x :: p', y :: q' => (a * x - b * y)%Z :: combination a p' b q'
  | _, [] => map (Z.mul a) p
  | [], _ => map (Z.mul (- b)) q
  end.

Lemma product_multiple a p v : product (map (Z.mul a) p) v = IZR a * product p v.
Proof. revert v. induction p as [| x p IH]; intros v; simpl; [ring |]. rewrite IH, mult_IZR. ring. Qed.

Lemma product_combination a p b q v : product (combination a p b q) v = IZR a * product p v - IZR b * product q v.
Proof.
  revert q v. induction p as [| x p IH]; intros [| y q] v.
  - simpl. ring.
  - change (combination a [] b (y :: q)) with (map (Z.mul (- b)) (y :: q)). rewrite product_multiple, opp_IZR. simpl.
    ring.
  - change (combination a (x :: p) b []) with (map (Z.mul a) (x :: p)). rewrite product_multiple. simpl. ring.
  - simpl. rewrite IH, minus_IZR, !mult_IZR. ring.
Qed.

(** A row that begins with another number than zero, and the other rows. *)
Fixpoint pivot (rows : list (list Z)) : option (Z * list Z * list (list Z)) :=
  match rows with
  | [] => None
  | (Zpos _ as a :: p) :: rest | (Zneg _ as a :: p) :: rest => Some (a, p, rest)
  | row :: rest =>
      match pivot rest with
      | Some (a, p, others) => Some (a, p, row :: others)
      | None => None
      end
  end.

Lemma pivot_found rows a p others : pivot rows = Some (a, p, others) ->
  a <> 0%Z /\ In (a :: p) rows /\ (forall row, In row others -> In row rows).
Proof.
  revert others. induction rows as [| row rest IH]; intros others; simpl; [easy |].
  assert (later : match pivot rest with
                  | Some (a, p, others) => Some (a, p, row :: others)
                  | None => None
                  end = Some (a, p, others) ->
                  a <> 0%Z /\ (row = a :: p \/ In (a :: p) rest) /\
                  (forall r, In r others -> row = r \/ In r rest)).
  { destruct (pivot rest) as [[[a' p'] others'] |] eqn:Hp; [| easy]. intros [= -> -> <-].
    destruct (IH others' eq_refl) as (Ha & Hin & Hall). repeat split; auto. intros r [<- | Hr]; auto. }
  destruct row as [| [| z | z] q]; auto; intros [= <- <- <-]; repeat split; auto; easy.
Qed.

(** Without the first number, of a row from which the pivot has been taken away. *)
Definition reduced (a : Z) (p row : list Z) : list Z :=
  match row with
  | [] => []
  | b :: q => combination a q b p
  end.

Fixpoint is_regular (n : nat) (rows : list (list Z)) : bool :=
  match n with
  | O => true
  | S m =>
      match pivot rows with
      | Some (a, p, others) => is_regular m (map (reduced a p) others)
      | None => false
      end
  end.

Lemma is_regular_sound n rows v : is_regular n rows = true -> (forall row, In row rows -> product row v = 0) ->
  (forall j, (n <= j)%nat -> v j = 0) -> forall j, (j < n)%nat -> v j = 0.
Proof.
  revert rows v. induction n as [| n IH]; intros rows v Hregular Hrows Hbeyond j Hj; [lia |]. simpl in Hregular.
  destruct (pivot rows) as [[[a p] others] |] eqn:Hp; [| easy].
  destruct (pivot_found _ _ _ _ Hp) as (Ha & Hin & Hothers). assert (first := Hrows _ Hin). simpl in first.
  assert (rest : forall k, (k < n)%nat -> v (S k) = 0).
  { apply (IH (map (reduced a p) others) (fun k => v (S k))); [easy | | intros k Hk; apply Hbeyond; lia].
    intros row Hrow. apply in_map_iff in Hrow. destruct Hrow as (full & <- & Hfull).
    assert (zero := Hrows full (Hothers full Hfull)). destruct full as [| b q]; [easy |]. simpl in *.
    rewrite product_combination. replace (product q (fun j => v (S j))) with (- (IZR b * v 0%nat)) by lra.
    replace (product p (fun j => v (S j))) with (- (IZR a * v 0%nat)) by lra. ring. }
  destruct j as [| j]; [| apply rest; lia].
  assert (nothing : forall row (w : point), (forall k, w k = 0) -> product row w = 0).
  { induction row as [| x row IHrow]; intros w Hw; simpl; [easy |]. rewrite Hw, IHrow; [ring | auto]. }
  rewrite nothing in first.
  - apply (Rmult_eq_reg_l (IZR a)); [lra |]. now apply IZR_neq in Ha.
  - intros k. destruct (Nat.lt_ge_cases k n); [now apply rest | apply Hbeyond; lia].
Qed.

(** The numbers of a row, as integers in units of the finest among them. *)
Definition finest (row : list dyadic) : Z := fold_right (fun d e => Z.min (exponent d) e) 0%Z row.
Definition integers (row : list dyadic) : list Z :=
  let e := finest row in map (fun d => Z.shiftl (mantissa d) (exponent d - e)) row.

Lemma finest_below d row : In d row -> (finest row <= exponent d)%Z.
Proof. induction row as [| a row IH]; simpl; [easy |]. intros [-> | Hd]; [lia |]. specialize (IH Hd). lia. Qed.

Lemma product_integers_in_units row e v : (forall d, In d row -> (e <= exponent d)%Z) ->
  powerRZ 2 e * product (map (fun d => Z.shiftl (mantissa d) (exponent d - e)) row) v
  = Contraction.sum (length row) (fun j => value (nth j row nought) * v j).
Proof.
  revert v. induction row as [| d row IH]; intros v He; [simpl; ring |]. simpl length. rewrite sum_shift. simpl map.
  simpl product. simpl nth. rewrite <- (IH (fun j => v (S j))) by (intros; apply He; now right).
  assert (Hd := He d (or_introl eq_refl)). rewrite Z.shiftl_mul_pow2, mult_IZR by lia. unfold value.
  replace (powerRZ 2 (exponent d)) with (powerRZ 2 e * IZR (2 ^ (exponent d - e))).
  - ring.
  - replace (IZR (2 ^ (exponent d - e))) with (powerRZ 2 (exponent d - e)).
    + rewrite <- powerRZ_add by lra. f_equal. lia.
    + rewrite <- (Z2Nat.id (exponent d - e)) by lia. generalize (Z.to_nat (exponent d - e)). intros n.
      rewrite <- pow_powerRZ, <- pow_IZR. easy.
Qed.

Lemma product_integers row v : Contraction.sum (length row) (fun j => value (nth j row nought) * v j) = 0 ->
  product (integers row) v = 0.
Proof.
  intros Hzero. rewrite <- (product_integers_in_units row (finest row)) in Hzero by (intros; now apply finest_below).
  apply Rmult_integral in Hzero. destruct Hzero as [Hzero | Hzero]; [| exact Hzero]. exfalso. revert Hzero.
  apply powerRZ_NOR. lra.
Qed.

(** [n] rows of [n] numbers. *)
Definition is_square (n : nat) (m : list (list dyadic)) : bool :=
  Nat.eqb (length m) n && forallb (fun row => Nat.eqb (length row) n) m.

Lemma regular_matrix n Y v : is_square n Y = true -> is_regular n (map integers Y) = true ->
  (forall i, (i < n)%nat -> Contraction.sum n (fun j => entries Y i j * v j) = 0) -> forall j, (j < n)%nat -> v j = 0.
Proof.
  intros Hsquare Hregular Hv j Hj. apply andb_true_iff in Hsquare. destruct Hsquare as [Hrows Hlengths].
  apply Nat.eqb_eq in Hrows. set (w := fun j => if Nat.ltb j n then v j else 0).
  assert (Hw : forall j, (j < n)%nat -> w j = v j).
  { intros k Hk. unfold w. now rewrite (proj2 (Nat.ltb_lt k n) Hk). }
  rewrite <- Hw by easy. apply (is_regular_sound n (map integers Y) w); [easy | | | easy].
  - intros row Hrow. apply in_map_iff in Hrow. destruct Hrow as (numbers & <- & Hin). apply product_integers.
    assert (Hlength : length numbers = n) by (apply Nat.eqb_eq; now apply (proj1 (forallb_forall _ _) Hlengths)).
    destruct (In_nth _ _ [] Hin) as (i & Hi & Hnth). rewrite Hrows in Hi. rewrite Hlength.
    transitivity (Contraction.sum n (fun j => entries Y i j * v j)); [| now apply Hv]. apply sum_eq. intros k Hk.
    rewrite Hw by easy. unfold entries, entry. now rewrite Hnth.
  - intros k Hk. unfold w. now rewrite (proj2 (Nat.ltb_ge k n) Hk).
Qed.

(** ** The test *)

Section Test.

(** Bits to compute in, what is solved for, what is zero, and the matrix. *)
Variables (prec : I.precision) (unknowns : list name) (formulas : list formula) (Y : list (list dyadic)).

Notation n := (length unknowns).

Fixpoint total (m : nat) (X : nat -> enclosure) : enclosure :=
  match m with
  | O => integer prec 0
  | S k => I.add prec (total k X) (X k)
  end.

Lemma has_total m X x : (forall i, (i < m)%nat -> has (X i) (x i)) -> has (total m X) (Contraction.sum m x).
Proof.
  induction m as [| m IH]; intros Hall; simpl; [apply has_integer |].
  apply has_add; [apply IH |]; intros; apply Hall; lia.
Qed.

(** A list if all its entries are there. *)
Fixpoint all {A} (l : list (option A)) : option (list A) :=
  match l with
  | [] => Some []
  | x :: rest =>
      match x, all rest with
      | Some a, Some others => Some (a :: others)
      | _, _ => None
      end
  end.

Lemma all_entries {A} (f : nat -> option A) start m l : all (map f (seq start m)) = Some l ->
  forall i d, (i < m)%nat -> f (start + i)%nat = Some (nth i l d).
Proof.
  revert start l. induction m as [| m IH]; intros start l; simpl; [lia |].
  destruct (f start) as [a |] eqn:Ha; [| easy].
  destruct (all (map f (seq (S start) m))) as [others |] eqn:Hrest; [| easy]. intros [= <-] i d Hi.
  destruct i as [| i].
  - now rewrite Nat.add_0_r.
  - simpl. rewrite <- (IH (S start) others Hrest i d) by lia. f_equal. lia.
Qed.

(** The slopes on a box, by equations. *)
Definition slopes (E : surroundings) : list (list enclosure) :=
  map (fun f => map (fun k => enclosed prec E (slope k f)) unknowns) formulas.

(** An entry of [I - Y J]. *)
Definition contraction (S : list (list enclosure)) (i k : nat) : enclosure :=
  I.sub prec (integer prec (if Nat.eqb i k then 1 else 0))
    (total n (fun j => I.mul prec (exact (nth j (nth i Y []) nought)) (nth k (nth j S []) anything))).

(** The largest size of each. *)
Definition bounds (E : surroundings) : option (list (list dyadic)) :=
  let S := slopes E in
  all (map (fun i => all (map (fun k => largest (contraction S i k)) (seq 0 n))) (seq 0 n)).

(** [C r + |Y F(c)| < r], from enclosures of [F(c)]. *)
Definition narrows (C : list (list dyadic)) (residuals : list enclosure) (r : list dyadic) : bool :=
  forallb (fun i =>
    is_positive (I.sub prec (exact (nth i r nought))
      (I.add prec
        (total n (fun k => I.mul prec (exact (nth k (nth i C []) nought)) (exact (nth k r nought))))
        (I.abs (total n (fun j =>
           I.mul prec (exact (nth j (nth i Y []) nought)) (nth j residuals anything)))))))
    (seq 0 n).

Variable given : configuration.

Definition residual (j : nat) (x : point) : R := meaning (place given unknowns x) (nth j formulas (Int 0)).
Definition partial (j k : nat) (x : point) : R :=
  meaning (place given unknowns x) (slope (nth k unknowns Alpha) (nth j formulas (Int 0))).

Hypothesis sizes : length formulas = n.

Lemma bounds_hold E C x : bounds E = Some C -> surrounds E (place given unknowns x) -> forall i k, (i < n)%nat ->
  (k < n)%nat -> Rabs (unit_entry i k - Contraction.sum n (fun j => entries Y i j * partial j k x)) <= entries C i k.
Proof.
  intros HC HE i k Hi Hk. unfold bounds in HC. assert (Hrow := all_entries _ _ _ _ HC i [] Hi). simpl in Hrow.
  assert (Hentry := all_entries _ _ _ _ Hrow k nought Hk). simpl in Hentry. apply (largest_bounds _ _ _ Hentry).
  unfold contraction. apply has_sub.
  - unfold unit_entry. destruct (Nat.eqb i k); apply has_integer.
  - apply has_total. intros j Hj. apply has_mul; [apply has_exact |]. unfold slopes, partial.
    set (g := fun f => map (fun k => enclosed prec E (slope k f)) unknowns).
    assert (Hnth : nth j (map g formulas) [] = g (nth j formulas (Int 0))).
    { rewrite (nth_indep _ [] (g (Int 0))) by (rewrite map_length, sizes; easy). apply map_nth. }
    rewrite Hnth. unfold g. set (h := fun k => enclosed prec E (slope k (nth j formulas (Int 0)))).
    rewrite (nth_indep _ anything (h Alpha)) by (rewrite map_length; easy). rewrite map_nth. now apply has_meaning.
Qed.

(** The box as the theorem wants it. *)
Definition boxed (c r : list dyadic) (x : point) : Prop := within n (entry r) 1 x (entry c).

Theorem one_root C c r residuals : distinct unknowns = true -> (forall x, boxed c r x -> forall f, In f formulas ->
    defined (place given unknowns x) f) -> (forall x, boxed c r x -> forall i k, (i < n)%nat -> (k < n)%nat ->
    Rabs (unit_entry i k - Contraction.sum n (fun j => entries Y i j * partial j k x)) <= entries C i k) ->
  (forall i, (i < n)%nat -> 0 < entry r i) -> (forall j, (j < n)%nat ->
    has (nth j residuals anything) (residual j (entry c))) -> narrows C residuals r = true -> is_square n Y = true ->
  is_regular n (map integers Y) = true -> exists x, boxed c r x /\ solves n residual x /\ (forall y, boxed c r y ->
    solves n residual y -> forall i, (i < n)%nat -> y i = x i).
Proof.
  intros Hdistinct Hdefined HC Hr Hresiduals Hnarrows Hsquare Hregular.
  apply (one_root_by_krawczyk n residual partial (entries Y) (entries C)).
  - exact Hr.
  - intros j Hj x u t Hx. apply slope_along; [easy |]. apply Hdefined; [exact Hx |]. apply nth_In. now rewrite sizes.
  - exact HC.
  - intros i Hi. assert (Htest : In i (seq 0 n)) by (apply in_seq; lia).
    apply (proj1 (forallb_forall _ _) Hnarrows) in Htest.
    enough (0 < entry r i - (Contraction.sum n (fun k => entries C i k * entry r k)
              + Rabs (Contraction.sum n (fun j => entries Y i j * residual j (entry c))))) by lra.
    apply (is_positive_sound _ _ Htest). apply has_sub; [apply has_exact |]. apply has_add.
    + apply has_total. intros k Hk. apply has_mul; apply has_exact.
    + apply has_abs, has_total. intros j Hj. apply has_mul; [apply has_exact | now apply Hresiduals].
  - intros v Hv. now apply (regular_matrix n Y).
Qed.

End Test.
