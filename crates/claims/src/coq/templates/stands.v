
(** The line of thrust is inside<<holds>> at every joint, and no thinner arch stands. *)
Theorem state <<args>> : wide <<args>> -> equations <<args>> ->
  <<admissible>> /\
  <<stands_from>>.
Proof.
  intros W E. pose proof (signs <<args>> (digits <<args>> W E)) as S.<<tied>>
  unfold equations in E.
  eapply <<theorem>>; [lra | tauto | tauto | known ..].
Qed.
