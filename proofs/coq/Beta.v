(** The paper's constant beta. K(m) is the complete integral of the first kind of the parameter m. There is exactly one b > 0 with
      K (1/(1+b)) = pi sqrt (1+b),
    between any two numbers at which G, the integral below, is above and below pi; and it is the one with
      agm (sqrt (1+b), sqrt b) = 1/2. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import GaussIntegral AgmLimit.
Open Scope R_scope.

Definition G (b : R) : R := RInt (fun t => / sqrt (b + cos t ^2)) 0 (PI/2).

Lemma G_gauss_integral b : 0 < b -> G b = gauss_integral (sqrt (1+b)) (sqrt b).
Proof.
intros Hb. unfold G, gauss_integral. apply RInt_ext. intros x _. unfold integrand, radicand. f_equal. f_equal.
rewrite !Rpow_mult_distr, !pow2_sqrt by lra. generalize (cos_sq x). intros H. ring [H].
Qed.

Definition K (m : R) : R := RInt (fun t => 1 / sqrt (1 - m * sin t ^2)) 0 (PI/2).

Lemma K_G b : 0 < b -> K (1/(1+b)) = sqrt (1+b) * G b.
Proof.
intros Hb. unfold K.
assert (Hc : forall t, 0 < b + cos t ^2) by (intros t; generalize (pow2_ge_0 (cos t)); lra).
transitivity (RInt (fun t => scal (sqrt (1+b)) (/ sqrt (b + cos t ^2))) 0 (PI/2)).
- apply RInt_ext. intros x _. unfold scal; simpl; unfold mult; simpl. 
  replace (1 - 1/(1+b) * (sin x * (sin x * 1))) with ((b + cos x * (cos x * 1))/(1+b)).
  2:{ assert (H := cos_sq x). field_simplify; try lra. f_equal. ring [H]. }
  assert (H1 := Hc x). simpl in H1.
  rewrite sqrt_div by lra. field.
  split; apply Rgt_not_eq, sqrt_lt_R0; lra.
- apply (RInt_scal (V:=R_CompleteNormedModule)).
  apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _.
  apply (ex_derive_continuous (fun t => / sqrt (b + cos t ^2))). auto_derive.
  assert (H1 := Hc z). simpl in H1. split; [lra|split; [|easy]]. 
  apply Rgt_not_eq, sqrt_lt_R0. lra.
Qed.

Lemma kernel_continuous b t : 0 < b -> continuous (fun t => / sqrt (b + cos t ^2)) t.
Proof.
intros Hb. assert (H1 := pow2_ge_0 (cos t)). simpl in H1.
apply (ex_derive_continuous (fun t => / sqrt (b + cos t ^2))). auto_derive.
split; [lra|split; [|easy]]. apply Rgt_not_eq, sqrt_lt_R0. lra.
Qed.

Lemma kernel_integrable b x y : 0 < b -> ex_RInt (fun t => / sqrt (b + cos t ^2)) x y.
Proof. intros Hb. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. now apply kernel_continuous. Qed.

Lemma G_decreasing b c : 0 < b -> b < c -> G c < G b.
Proof.
intros Hb Hc. assert (HPI := PI_RGT_0). unfold G. apply RInt_lt; try lra.
- intros x _. apply kernel_continuous; lra.
- intros x _. apply kernel_continuous; lra.
- intros x _. assert (H1 := pow2_ge_0 (cos x)). apply Rinv_lt_contravar.
  + apply Rmult_lt_0_compat; apply sqrt_lt_R0; lra.
  + apply sqrt_lt_1_alt; lra.
Qed.

Lemma G_lower_bound b c : 0 < b -> b < c -> b / c * G b <= G c.
Proof.
intros Hb Hc. assert (HPI := PI_RGT_0). unfold G.
replace (b / c * RInt (fun t => / sqrt (b + cos t ^2)) 0 (PI/2)) with
  (RInt (V:=R_CompleteNormedModule) (fun t => scal (b/c) (/ sqrt (b + cos t ^2))) 0 (PI/2)).
2:{ apply (RInt_scal (V:=R_CompleteNormedModule)). now apply kernel_integrable. }
apply RInt_le; try lra.
- apply (@ex_RInt_scal R_NormedModule). now apply kernel_integrable.
- apply kernel_integrable; lra.
- intros x _. unfold scal; simpl; unfold mult; simpl. change (cos x * (cos x * 1)) with (cos x ^2).
  assert (H1 := pow2_ge_0 (cos x)). set (q := cos x ^2) in *.
  assert (Hb' : 0 < sqrt (b + q)) by (apply sqrt_lt_R0; lra).
  assert (Hc' : 0 < sqrt (c + q)) by (apply sqrt_lt_R0; lra).
  assert (b * sqrt (c + q) <= c * sqrt (b + q)).
  { apply Rsqr_incr_0_var; [|apply Rmult_le_pos; lra]. unfold Rsqr.
    replace (b * sqrt (c+q) * (b * sqrt (c+q))) with (b*b*(sqrt (c+q) * sqrt (c+q))) by ring.
    replace (c * sqrt (b+q) * (c * sqrt (b+q))) with (c*c*(sqrt (b+q) * sqrt (b+q))) by ring.
    rewrite !sqrt_sqrt by lra. 
    assert (b*b <= c*c) by nra. assert (b*b*q <= c*c*q) by (apply Rmult_le_compat_r; lra). 
    assert (0 < b*c) by nra. nra. }
  apply (Rmult_le_reg_r (c * sqrt (b+q) * sqrt (c+q))). 
  { repeat apply Rmult_lt_0_compat; lra. }
  field_simplify; lra.
Qed.

Lemma G_pos b : 0 < b -> 0 < G b.
Proof.
intros Hb. rewrite G_gauss_integral by lra. assert (HPI := PI_RGT_0).
assert (0 < sqrt (1+b)) by (apply sqrt_lt_R0; lra). assert (0 < sqrt b) by (apply sqrt_lt_R0; lra).
apply Rlt_le_trans with (PI/2/(sqrt (1+b) + sqrt b)).
- apply Rdiv_lt_0_compat; lra.
- apply gauss_integral_ge; lra.
Qed.

(** On [b0, +oo). *)
Lemma G_lipschitz b0 b c : 0 < b0 -> b0 <= b -> b0 <= c -> Rabs (G b - G c) <= G b0 / b0 * Rabs (b - c).
Proof.
intros H0.
assert (W : forall b c, b0 <= b -> b <= c -> Rabs (G b - G c) <= G b0 / b0 * Rabs (b - c)).
{ clear b c. intros b c Hb [Hc|<-].
  2:{ rewrite !Rminus_eq_0, Rabs_R0. lra. }
  assert (L1 := G_decreasing b c). assert (L2 := G_lower_bound b c). assert (P := G_pos b).
  rewrite Rabs_right by lra. rewrite Rabs_left by lra.
  assert (Gb : G b <= G b0) by (destruct Hb as [Hb|<-]; [left; apply G_decreasing; lra | lra]).
  assert (G b - G c <= G b * ((c - b)/c)).
  { replace (G b * ((c-b)/c)) with (G b - b/c*G b) by (field; lra). lra. }
  apply Rle_trans with (1 := H).
  replace (G b0 / b0 * - (b - c)) with (G b0 * ((c-b)/b0)) by (field; lra).
  apply Rmult_le_compat; try lra.
  - apply Rdiv_le_0_compat; lra.
  - unfold Rdiv. apply Rmult_le_compat_l. lra. apply Rinv_le_contravar; lra. }
intros Hb Hc. destruct (Rle_dec b c).
- now apply W.
- rewrite Rabs_minus_sym, (Rabs_minus_sym b). apply W; lra.
Qed.

Lemma G_continuous b : 0 < b -> continuity_pt G b.
Proof.
intros Hb e He. 
assert (P := G_pos (b/2)). set (M := G (b/2) / (b/2)).
assert (HM : 0 < M) by (unfold M; apply Rdiv_lt_0_compat; lra).
exists (Rmin (b/2) (e/M)). split.
- apply Rmin_pos; [lra|]. now apply Rdiv_lt_0_compat.
- intros x [_ Hx]. simpl in *. unfold R_dist in *.
  assert (H1 : Rabs (x - b) < b/2) by (eapply Rlt_le_trans; [exact Hx | apply Rmin_l]).
  assert (H2 : Rabs (x - b) < e/M) by (eapply Rlt_le_trans; [exact Hx | apply Rmin_r]).
  apply Rabs_def2 in H1.
  apply Rle_lt_trans with (M * Rabs (x - b)). apply G_lipschitz; lra.
  apply (Rmult_lt_compat_l M) in H2; [|lra]. 
  replace (M * (e/M)) with e in H2 by (field; lra). exact H2.
Qed.

Theorem beta_exists_unique lo hi : 0 < lo -> lo < hi -> PI < G lo -> G hi < PI ->
  exists b, (lo < b < hi /\ K (1/(1+b)) = PI * sqrt (1+b)) /\
   forall c, 0 < c -> K (1/(1+c)) = PI * sqrt (1+c) -> c = b.
Proof.
intros H0 H1 Hl Hh.
assert (EQ : forall c, 0 < c -> (K (1/(1+c)) = PI * sqrt (1+c) <-> G c = PI)).
{ intros c Hc. rewrite K_G by lra. assert (0 < sqrt (1+c)) by (apply sqrt_lt_R0; lra).
  split; intros E. apply (Rmult_eq_reg_l (sqrt (1+c))). rewrite E; ring. lra. rewrite E; ring. }
destruct (Ranalysis5.IVT_interv (fun x => PI - G x) lo hi) as [b [Hb1 Hb2]]; try lra.
- intros a Ha. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?. apply G_continuous; lra.
- assert (G b = PI) by lra.
  assert (lo <> b) by (intros E; rewrite E in Hl; lra).
  assert (b <> hi) by (intros E; rewrite E in *; lra).
  exists b. split; [split; [lra|apply (proj2 (EQ b ltac:(lra))); lra]|].
  intros c Hc E. assert (E2 := proj1 (EQ c Hc) E); clear E.
  destruct (Rtotal_order c b) as [L|[L|L]]; trivial; [assert (Hd := G_decreasing c b)|assert (Hd := G_decreasing b c)]; lra.
Qed.

(** The two definitions of beta agree. *)
Corollary beta_agm b : 0 < b ->
 (is_lim_seq (fun n => fst (agm n (sqrt (1+b)) (sqrt b))) (1/2) <-> K (1/(1+b)) = PI * sqrt (1+b)).
Proof.
intros Hb. assert (HPI := PI_RGT_0). assert (Hs : 0 < sqrt b) by now apply sqrt_lt_R0.
assert (Hs1 : 0 < sqrt (1+b)) by (apply sqrt_lt_R0; lra).
assert (Hl : sqrt b <= sqrt (1+b)) by (apply sqrt_le_1_alt; lra).
destruct (agm_limit _ _ Hs Hl) as [L _]. rewrite <- G_gauss_integral in L by trivial.
assert (P := G_pos b Hb). rewrite K_G by trivial. split; intros H.
- assert (E : Finite (1/2) = Finite (PI / (2 * G b))).
  { rewrite <- (is_lim_seq_unique _ _ H). apply is_lim_seq_unique, L. }
  injection E as E. assert (G b = PI). 
  { apply (Rmult_eq_compat_r (2 * G b)) in E. replace (PI / (2 * G b) * (2 * G b)) with PI in E by (field; lra). lra. }
  rewrite H0. ring.
- assert (E : G b = PI) by (apply (Rmult_eq_reg_l (sqrt (1+b))); lra).
  replace (1/2) with (PI / (2 * G b)). exact L. rewrite E. field. lra.
Qed.
