
(** ** <<title>>, <<weight>> *)

Theorem opening_of_<<name>> : exists alpha,
  Rabs (alpha - <<centre>>) <= <<radius>> /\ A alpha = <<opening>> /\
  (forall other, 0 < other < 2 * PI -> A other = <<opening>> -> other = alpha).
Proof.
  destruct (half_opening (<<opening>>) <<lo>> <<hi>>)
    as [alpha [H [HA unique]]];
    [ lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)
    | unfold A; interval with (i_prec 140) |].
  exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].
Qed.
