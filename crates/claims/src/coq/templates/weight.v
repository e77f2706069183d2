
(** <<title>>; the primed variables are Milankovitch's. *)
Theorem <<name>> <<args>> <<others>> :
  <<heyman>>.wide <<args>> -> <<heyman>>.equations <<args>> ->
  <<milankovitch>>.wide <<others>> ->
  <<milankovitch>>.equations <<others>> ->
  <<claims>>.
Proof.
  intros W E W' E'.
  apply (<<heyman>>.digits <<args>> W) in E.
  apply (<<milankovitch>>.digits <<others>> W') in E'.
  unfold <<heyman>>.narrow in E. unfold <<milankovitch>>.narrow in E'.
  conjuncts. repeat split; lra.
Qed.
