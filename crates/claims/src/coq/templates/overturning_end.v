
Theorem only_<<name>> : exists alpha,
  Rabs (alpha - <<centre>>) <= <<radius>> /\
  (forall other, 0 < other < 2 * PI -> (<<module>>.equations other <-> other = alpha)).
Proof.
  destruct opening_of_<<name>> as [alpha [H [HA unique]]]. exists alpha. split; [exact H |].
  intros other Ho. unfold <<module>>.equations. rewrite <<lemma>>.
  split; intros E; [now apply unique | now subst].
Qed.
