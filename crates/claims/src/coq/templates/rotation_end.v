
Theorem only_<<name>> : exists alpha,
  Rabs (alpha - <<centre>>) <= <<radius>> /\
  (forall other eta, 0 < other < 2 * PI -> 0 <= eta < 2 ->
     (<<module>>.equations other eta <-> eta = <<thickness>> /\ other = alpha)).
Proof.
  destruct opening_of_<<name>> as [alpha [H [HA unique]]]. exists alpha. split; [exact H |].
  intros other eta Ho He. unfold <<module>>.equations. rewrite <<lemma>> by exact He.
  split; intros [H1 H2]; (split; [exact H1 |]); [now apply unique | now subst].
Qed.
