
Corollary <<name>> <<args>> :
  wide <<args>> -> equations <<args>> ->
  <<claim>>.
Proof. intros W E. apply (digits <<args>> W) in E. unfold narrow in E. compare. Qed.
