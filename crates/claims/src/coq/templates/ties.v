
(** What is zero, as other modes or the limit begin here. *)
Lemma ties <<args>> : wide <<args>> -> equations <<args>> ->
  <<ties>>.
Proof.
  intros W E. pose proof (signs <<args>> (digits <<args>> W E)) as S.
  unfold equations in E. ties.
Qed.
