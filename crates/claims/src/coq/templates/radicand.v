
Corollary radicand_vanishes <<args>> :
  wide <<args>> -> equations <<args>> ->
  radicand <<delta>> (f_of beta_r) (g_of beta_r) (sin beta_r) = 0.
Proof.
  unfold wide, equations. intros W E. conjuncts.
  apply radicand_at_double_thickness with eta; try assumption; clearing.
Qed.
