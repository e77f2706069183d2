(** * The equations of the finite-friction Couplet-Heyman problem

    Every equation of the paper once, written as the paper prints it, as a definition that the other
    files prove things about.  Nothing is proved here.

    Units: lengths in [r], the radius of the centreline, forces in [w r] with [w] the weight per
    unit length of the centreline, angles in radians.

    Arguments come in the order [delta], [alpha], [beta], [eta], [h]:
    - [delta]: the flag delta_M; 0 is Heyman's self-weight, 1 Milankovitch's. It is kept as a real
      number wherever possible, so that both cases are instances;
    - [alpha]: half-angle of embrace; [beta]: angle of an inner joint from the crown;
    - [eta = t/r]: thickness; [h = H/(w r)]: horizontal thrust. *)

From Coq Require Import Reals.
Open Scope R_scope.

Definition cot (x : R) : R := cos x / sin x.

(** ** Self-weight and ring *)

(** (6): the radius at which the weight of a thin slice acts. *)
Definition fac (delta eta : R) : R := 1 + delta * eta ^ 2 / 12.

(** The radii of the two faces of the arch. *)
Definition intrados (eta : R) : R := 1 - eta / 2.
Definition extrados (eta : R) : R := 1 + eta / 2.

(** ** Statics of the half arch

    Normal and shear force on the joint [beta], and the radius at which the line of thrust crosses it when the thrust
    acts at the radius [crown] on the crown. The shear is positive where the joint tends to slide inwards. *)

Definition normal_force (beta h : R) : R := h * cos beta + beta * sin beta.
Definition shear_force (beta h : R) : R := beta * cos beta - h * sin beta.
Definition pressure_point (delta beta eta h crown : R) : R :=
  (h * crown + fac delta eta * (1 - cos beta)) / normal_force beta h.

(** ** Rotation: (2)-(5) *)

(** (2) *)
Definition h_lower (delta beta eta : R) : R :=
  ((2 - eta) * beta * sin beta - 2 * (1 - cos beta) * fac delta eta)
  / (2 + eta - (2 - eta) * cos beta).

(** (3) *)
Definition h_upper (delta alpha beta eta : R) : R :=
  ((2 + eta) * alpha * sin alpha - (2 - eta) * beta * sin beta
     - 2 * (cos beta - cos alpha) * fac delta eta)
  / ((2 - eta) * cos beta - (2 + eta) * cos alpha).

(** (4): both printed forms of [A], and [h_2]. *)
Definition A (alpha : R) : R := alpha * sin alpha / (1 - cos alpha).
Definition A_half_angle (alpha : R) : R := alpha * cot (alpha / 2).
Definition h_whole (delta alpha eta : R) : R := A alpha - 2 / (2 + eta) * fac delta eta.

(** (5): both printed forms. *)
Definition h_tangency (delta beta eta : R) : R := beta * cot beta + 1 - 2 / (2 - eta) * fac delta eta.
Definition h_tangency_second (delta beta eta : R) : R :=
  beta * cot beta - eta / (2 - eta) * (1 + 2 / eta * (fac delta eta - 1)).

(** ** The cubic problem: (7), (8), (12) *)

(** (8): both printed forms of [g]. *)
Definition f_of (beta : R) : R := sin beta + beta * cos beta.
Definition g_of (beta : R) : R := beta + sin beta * cos beta.
Definition g_first (beta : R) : R := f_of beta * cos beta + beta * sin beta ^ 2.

(** (7) as printed, for delta_M = 1.  [S] stands for [sin beta], [f] and [g] for (8). *)
Definition pol_A_printed (f g S A : R) : R :=
  S ^ 2 * (3 * g - 2 * S) * A ^ 3 + 3 * g * S * (g - f) * A ^ 2 - 3 * f * g ^ 2 * A + 2 * g ^ 3.
Definition pol_eta_printed (f g S eta : R) : R :=
  S * eta ^ 3 + 3 * (f + g) * eta ^ 2 - 12 * (g - S) * eta + 12 * (g - f).
Definition pol_h_printed (f g S h : R) : R :=
  6 * S ^ 2 * h ^ 3 - 3 * S * (3 * f - g - 2 * S) * h ^ 2 - 3 * (g - f) * (f - 2 * S) * h
  + 2 * (g - f) ^ 2.

(** (7) for any delta_M. In [A] the flag enters through [(1 - delta) / 2 * S], in [h] only in the last coefficient. *)
Definition pol_A (delta f g S A : R) : R :=
  S ^ 2 * (3 * g - (3 + delta) / 2 * S) * A ^ 3
  + 3 * g * S * (g - f - (1 - delta) / 2 * S) * A ^ 2
  - 3 * g ^ 2 * (f - (1 - delta) / 2 * S) * A
  + (3 + delta) / 2 * g ^ 3.
Definition pol_eta (delta f g S eta : R) : R :=
  delta * S * eta ^ 3 + 3 * (f + g) * eta ^ 2 - 12 * (g - S) * eta + 12 * (g - f).
Definition pol_h (delta f g S h : R) : R :=
  6 * S ^ 2 * h ^ 3 - 3 * S * (3 * f - g - 2 * S) * h ^ 2 - 3 * (g - f) * (f - 2 * S) * h
  + (3 + delta) / 2 * (g - f) ^ 2.

(** What remains of (7) for delta_M = 0: Heyman's quadratics. *)
Definition heyman_A (f g S A : R) : R := S * (2 * g - S) * A ^ 2 - 2 * f * g * A + g ^ 2.
Definition heyman_eta (f g S eta : R) : R := (f + g) * eta ^ 2 - 4 * (g - S) * eta + 4 * (g - f).
Definition heyman_h (f g S h : R) : R := 2 * S * h ^ 2 - 2 * (f - S) * h + (g - f).

(** (12): the term under the square root, as printed and for any delta_M. *)
Definition radicand_printed (f g S : R) : R :=
  9 * S ^ 2 * (g - f) ^ 2
  - 2 * S * (g - S) * (9 * f ^ 2 - g ^ 2 - 16 * g * S + 8 * S ^ 2)
  - 3 * (f + g) ^ 2 * (f ^ 2 - 2 * g * S + S ^ 2).
Definition radicand (delta f g S : R) : R :=
  delta ^ 2 * 9 * S ^ 2 * (g - f) ^ 2
  - delta * 2 * S * (g - S) * (9 * f ^ 2 - g ^ 2 - 16 * g * S + 8 * S ^ 2)
  - 3 * (f + g) ^ 2 * (f ^ 2 - 2 * g * S + S ^ 2).

(** ** Overturning: (13)-(16) *)

(** (13) *)
Definition A_overturning (delta eta : R) : R := 2 / (2 + eta) * (1 + delta * eta ^ 2 / 12).

(** (14) *)
Definition A_heyman (eta : R) : R := 2 / (2 + eta).
Definition eta_heyman (A : R) : R := 2 * (1 / A - 1).

(** (15) *)
Definition A_milankovitch (eta : R) : R := (12 + eta ^ 2) / (6 * (2 + eta)).
Definition eta_milankovitch (A : R) : R := 3 * A - sqrt (3 * (3 * A ^ 2 + 4 * A - 4)).

(** (16): the left side as printed, and as it has to read. *)
Definition end_of_rotation_printed (delta eta : R) : R := 1 - eta / (2 - eta) * (1 + delta * eta ^ 2 / 12).
Definition end_of_rotation (delta eta : R) : R := 1 - eta / (2 - eta) * (1 + delta * eta / 6).

(** The thickness at which rotation ends, Milankovitch's self-weight. *)
Definition eta_l_milankovitch : R := 2 * (2 * sqrt 3 - 3).

(** ** Sliding: (17), (18) *)

(** (17): both printed forms. *)
Definition mu_ss (alpha h : R) : R := (h * sin alpha - alpha * cos alpha) / (h * cos alpha + alpha * sin alpha).
Definition h_mu (alpha mu : R) : R := alpha * ((cos alpha + mu * sin alpha) / (sin alpha - mu * cos alpha)).

(** (18): the printed quotient at a joint, the joint, and the friction. *)
Definition mu_inner (beta h : R) : R :=
  ((1 - h) * cos beta - beta * sin beta) / ((1 - h) * sin beta + beta * cos beta).
Definition beta_s (h : R) : R := sqrt (h * (1 - h)).
Definition mu_is (h : R) : R := mu_inner (beta_s h) h.
