
(** At less friction nothing stands. *)
Theorem <<less_friction>> <<args>> : wide <<args>> -> equations <<args>> ->
  forall mu', 0 <= mu' < mu -> stands_at_no_thickness alpha mu'.
Proof.
  intros W E. pose proof (signs <<args>> (digits <<args>> W E)) as S.
  unfold equations in E.
  apply (purely_sliding alpha mu h beta_s); [tauto | tauto | known ..].
Qed.
