
Theorem least_thickness : exists <<args>>, narrow <<args>> /\
  <<stands_from>>.
Proof.
  destruct one_solution as (<<witness>> & N & E & _).
  exists <<listed>>. split; [exact N |].
  exact (proj2 (state <<args>> (narrow_is_wide <<args>> N) E)).
Qed.
