
Theorem least_thickness : exists eta, Rabs (eta - <<least>>) <= <<radius>> /\
  <<stands_from>>.
Proof.
  destruct one_solution as (<<witness>> & N & E & _).
  exists eta. split; [unfold narrow in N; tauto |].
  exact (proj2 (state <<args>> (narrow_is_wide <<args>> N) E)).
Qed.
