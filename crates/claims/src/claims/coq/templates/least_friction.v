
Theorem least_friction : exists mu, Rabs (mu - <<least>>) <= <<radius>> /\
  (forall mu', 0 <= mu' < mu -> stands_at_no_thickness alpha mu').
Proof.
  destruct one_solution as (<<witness>> & N & E & _).
  exists mu. split; [unfold narrow in N; tauto |].
  exact (state <<args>> (narrow_is_wide <<args>> N) E).
Qed.

(** That of the certificate is less. *)
Theorem stands_not : stands_at_no_thickness alpha <<friction>>.
Proof.
  destruct one_solution as (<<witness>> & N & E & _).
  apply (state <<args>> (narrow_is_wide <<args>> N) E).
  pose proof (signs <<args>> N). tauto.
Qed.
