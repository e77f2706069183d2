(** * Enclosures of real numbers

    CoqInterval's intervals over binary floating-point numbers made of [Z], under names of our own: what
    has a number, and that each operation has the result.  The checker computes with these alone. *)

From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core.
From Interval Require Import Interval.Interval Interval.Float_full Real.Xreal Float.Basic.
From Interval Require Specific_ops Specific_stdz.
From Couplet Require Import IntervalZ.
Open Scope R_scope.

Module I := FloatIntervalFull FloatZ.

Definition enclosure : Type := I.type.
Definition has (X : enclosure) (x : R) : Prop := contains (I.convert X) (Xreal x).

(** The whole line. *)
Definition anything : enclosure := I.nai.

Lemma has_anything (x : R) : has anything x.
Proof. exact Logic.I. Qed.

(** ** Exact numbers *)

(** [mantissa * 2 ^ exponent] *)
Record dyadic := Dyadic { mantissa : Z; exponent : Z }.
Definition value (d : dyadic) : R := IZR (mantissa d) * powerRZ 2 (exponent d).

Definition float (d : dyadic) : FloatZ.type := Specific_ops.Float (mantissa d) (exponent d).
Definition exact (d : dyadic) : enclosure := I.bnd (float d) (float d).

Definition opposite (d : dyadic) : dyadic := Dyadic (- mantissa d) (exponent d).

Lemma value_opposite (d : dyadic) : value (opposite d) = - value d.
Proof. unfold value, opposite. simpl. rewrite opp_IZR. ring. Qed.

Lemma FtoR_value (s : bool) (m : positive) (e : Z) :
  FtoR radix2 s m e = IZR (if s then Zneg m else Zpos m) * powerRZ 2 e.
Proof. rewrite FtoR_split. unfold F2R. simpl. rewrite bpow_powerRZ. now destruct s. Qed.

Lemma toX_float (d : dyadic) : FloatZ.toX (float d) = Xreal (value d).
Proof.
  destruct d as [m e]. unfold FloatZ.toX, FloatZ.toF, float, value. simpl. destruct m as [| p | p]; simpl;
    [f_equal; ring | f_equal; exact (FtoR_value false p e) | f_equal; exact (FtoR_value true p e)].
Qed.

Lemma has_between (a b : dyadic) (x : R) : value a <= x <= value b -> has (I.bnd (float a) (float b)) x.
Proof.
  intros Hx. unfold has. rewrite I.bnd_correct by reflexivity. change I.F.toX with FloatZ.toX. now rewrite !toX_float.
Qed.

Lemma between_has (a b : dyadic) (x : R) : has (I.bnd (float a) (float b)) x -> value a <= x <= value b.
Proof. unfold has. rewrite I.bnd_correct by reflexivity. change I.F.toX with FloatZ.toX. now rewrite !toX_float. Qed.

Lemma has_exact (d : dyadic) : has (exact d) (value d).
Proof. apply has_between. lra. Qed.

(** Zero and as much on either side. *)
Definition symmetric (r : dyadic) : enclosure := I.bnd (float (opposite r)) (float r).

Lemma has_symmetric (r : dyadic) (x : R) : Rabs x <= value r -> has (symmetric r) x.
Proof. intros Hx. apply has_between. rewrite value_opposite. now apply Rabs_le_inv. Qed.

(** A number at least as large as all of an enclosure, of either sign. *)
Definition largest (X : enclosure) : option dyadic :=
  match I.upper (I.abs X) with
  | Specific_ops.Float m e =>
      let d := Dyadic m e in if I.subset X (symmetric d) then Some d else None
  | Specific_ops.Fnan => None
  end.

Lemma largest_bounds (X : enclosure) (d : dyadic) (x : R) : largest X = Some d -> has X x -> Rabs x <= value d.
Proof.
  unfold largest. destruct (I.upper (I.abs X)) as [| m e]; [easy |].
  destruct (I.subset X (symmetric _)) eqn:Hsubset; [| easy]. intros [= <-] Hx.
  assert (H := I.subset_correct _ _ _ Hx Hsubset). apply between_has in H. rewrite value_opposite in H.
  now apply Rabs_le.
Qed.

(** ** Operations *)

Section Operations.

(** Bits of the results. *)
Variable prec : I.precision.

Definition integer (z : Z) : enclosure := I.fromZ prec z.
Lemma has_integer (z : Z) : has (integer z) (IZR z).
Proof. apply I.fromZ_correct. Qed.

Lemma has_neg X x : has X x -> has (I.neg X) (- x).
Proof. exact (I.neg_correct X (Xreal x)). Qed.
Lemma has_add X Y x y : has X x -> has Y y -> has (I.add prec X Y) (x + y).
Proof. exact (I.add_correct prec X Y (Xreal x) (Xreal y)). Qed.
Lemma has_sub X Y x y : has X x -> has Y y -> has (I.sub prec X Y) (x - y).
Proof. exact (I.sub_correct prec X Y (Xreal x) (Xreal y)). Qed.
Lemma has_mul X Y x y : has X x -> has Y y -> has (I.mul prec X Y) (x * y).
Proof. exact (I.mul_correct prec X Y (Xreal x) (Xreal y)). Qed.
Lemma has_abs X x : has X x -> has (I.abs X) (Rabs x).
Proof. exact (I.abs_correct X (Xreal x)). Qed.
Lemma has_sin X x : has X x -> has (I.sin prec X) (sin x).
Proof. exact (I.sin_correct prec X (Xreal x)). Qed.
Lemma has_cos X x : has X x -> has (I.cos prec X) (cos x).
Proof. exact (I.cos_correct prec X (Xreal x)). Qed.
Lemma has_atan X x : has X x -> has (I.atan prec X) (atan x).
Proof. exact (I.atan_correct prec X (Xreal x)). Qed.
Lemma has_pi : has (I.pi prec) PI.
Proof. apply I.pi_correct. Qed.

(** What has no number has all. *)
Lemma has_if_nan X x : contains (I.convert X) Xnan -> has X x.
Proof. unfold has. now destruct (I.convert X). Qed.

Lemma has_sqrt X x : has X x -> has (I.sqrt prec X) (sqrt x).
Proof. exact (I.sqrt_correct prec X (Xreal x)). Qed.

Lemma has_div X Y x y : has X x -> has Y y -> has (I.div prec X Y) (x / y).
Proof.
  intros Hx Hy. assert (H := I.div_correct prec X Y (Xreal x) (Xreal y) Hx Hy). simpl in H. unfold Xdiv' in H.
  destruct (Xreal.is_zero y); [now apply has_if_nan | exact H].
Qed.

(** All numbers within a radius of a centre. *)
Definition around (c r : dyadic) : enclosure := I.add prec (exact c) (symmetric r).

Lemma has_around (c r : dyadic) (x : R) : Rabs (x - value c) <= value r -> has (around c r) x.
Proof.
  intros Hx. replace x with (value c + (x - value c)) by ring.
  apply has_add; [apply has_exact | now apply has_symmetric].
Qed.

End Operations.

(** ** Signs *)

Definition is_positive (X : enclosure) : bool := match I.sign_strict X with Xgt => true | _ => false end.

Lemma is_positive_sound (X : enclosure) (x : R) : is_positive X = true -> has X x -> 0 < x.
Proof.
  unfold is_positive. assert (H := I.sign_strict_correct X). destruct (I.sign_strict X); try easy. intros _ Hx.
  now apply (H (Xreal x)).
Qed.

Definition is_not_zero (X : enclosure) : bool := match I.sign_strict X with Xgt | Xlt => true | _ => false end.

Lemma is_not_zero_sound (X : enclosure) (x : R) : is_not_zero X = true -> has X x -> x <> 0.
Proof.
  unfold is_not_zero. assert (H := I.sign_strict_correct X).
  destruct (I.sign_strict X); try easy; intros _ Hx; destruct (H (Xreal x) Hx) as [_ Hs]; simpl in Hs; lra.
Qed.

Definition is_zero (X : enclosure) : bool := match I.sign_strict X with Xeq => true | _ => false end.

Lemma is_zero_sound (X : enclosure) (x : R) : is_zero X = true -> has X x -> x = 0.
Proof.
  unfold is_zero. assert (H := I.sign_strict_correct X). destruct (I.sign_strict X); try easy. intros _ Hx.
  now injection (H (Xreal x) Hx).
Qed.
