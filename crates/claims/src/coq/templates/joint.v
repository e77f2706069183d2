
(** ** <<weight>> *)

Definition slope_<<name>> (beta : R) : R :=
  <<slope>>.

Lemma derivative_<<name>> beta : is_derive (radicand_at <<delta>>) beta (slope_<<name>> beta).
Proof.
  unfold radicand_at, radicand, f_of, g_of, slope_<<name>>. auto_derive; [exact I | ring].
Qed.

Theorem widest_joint_<<name>> : exists beta,
  Rabs (beta - <<centre>>) <= <<radius>> /\
  radicand <<delta>> (f_of beta) (g_of beta) (sin beta) = 0 /\
  (forall other, <<first>> <= other <= <<last>> ->
     radicand <<delta>> (f_of other) (g_of other) (sin other) = 0 -> other = beta).
Proof.
  destruct (one_joint <<delta>> slope_<<name>> <<first>> <<rise>> <<top>> <<last>>
    <<lo>> <<hi>>)
    as [beta [H [Hroot unique]]]; try lra.
  - intros x Hx. unfold radicand_at, radicand, f_of, g_of.
    interval with (i_prec 53, i_bisect x).
  - exact derivative_<<name>>.
  - intros x Hx. unfold slope_<<name>>. interval with (i_prec 53, i_bisect x).
  - intros x Hx. unfold radicand_at, radicand, f_of, g_of.
    interval with (i_prec 53, i_bisect x).
  - unfold radicand_at, radicand, f_of, g_of. interval with (i_prec 140).
  - unfold radicand_at, radicand, f_of, g_of. interval with (i_prec 140).
  - exists beta. split; [apply Rabs_le; lra | split; [exact Hroot | exact unique]].
Qed.

(** It is the joint of the landmark. *)
Theorem joint_of_sb_<<name>> alpha beta_r eta h beta :
  <<module>>.wide alpha beta_r eta h -> <<module>>.equations alpha beta_r eta h ->
  <<first>> <= beta <= <<last>> -> radicand <<delta>> (f_of beta) (g_of beta) (sin beta) = 0 ->
  beta = beta_r.
Proof.
  intros W E Hbeta Hzero. destruct widest_joint_<<name>> as [joint [_ [_ unique]]].
  transitivity joint; [now apply unique | symmetry]. apply unique.
  - unfold <<module>>.wide in W. lra.
  - exact (<<module>>.radicand_vanishes alpha beta_r eta h W E).
Qed.
