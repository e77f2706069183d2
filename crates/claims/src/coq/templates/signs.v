
(** ** The state *)

(** What is left to look at: <<looked_at>>. *)
Lemma signs <<args>> : narrow <<args>> ->
  <<signs>>.
Proof. unfold narrow. signs. Qed.
