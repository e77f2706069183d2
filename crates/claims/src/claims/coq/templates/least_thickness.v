
(** ** The state *)

(** What is left to look at: the ends of the arch and the joints that open or slide. *)
Lemma signs <<args>> : narrow <<args>> ->
  <<signs>>.
Proof. unfold narrow<<unfolded>>. signs. Qed.

(** The line of thrust is inside<<holds>> at every joint, and no thinner arch stands. *)
Theorem state <<args>> : wide <<args>> -> equations <<args>> ->
  <<admissible>> /\
  <<stands_from>> eta.
Proof.
  intros W E. pose proof (signs <<args>> (digits <<args>> W E)) as S.
  eapply (<<theorem>>); [lra | tauto | exact E | known ..].
Qed.

Theorem least_thickness : exists eta, Rabs (eta - <<least>>) <= <<radius>> /\
  <<stands_from>> eta.
Proof.
  destruct one_solution as (<<witness>> & N & E & _).
  exists eta. split; [unfold narrow in N; tauto |].
  exact (proj2 (state <<args>> (narrow_is_wide <<args>> N) E)).
Qed.
