(** The half phase G(u) takes each value above pi I at exactly one u in (0,1). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Theorem1.
Open Scope R_scope.
Section Values.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
(** g(x) >= m / sqrt x, X <= (sqrt u + t)^2 *)
Lemma h_lower s : 0 < s <= 1 -> (1-b) / sqrt (1 + b/a) / sqrt s <= h a b s.
Proof.
intros Hs. unfold h, Q. assert (B : 0 < b/a) by (apply Rdiv_lt_0_compat; lra).
assert (B1 : b*s/a = b/a*s) by (field; lra). rewrite B1. rewrite sqrt_mult_alt by lra.
assert (S1 : 0 < sqrt s) by (apply sqrt_lt_R0; lra).
assert (P1 : 0 < b/a*s) by (apply Rmult_lt_0_compat; lra).
assert (S2 : 0 < sqrt (1 + b/a*s)) by (apply sqrt_lt_R0; lra).
assert (S3 : 0 < sqrt (1 + b/a)) by (apply sqrt_lt_R0; lra).
assert (L : sqrt (1 + b/a*s) <= sqrt (1+b/a)) by (apply sqrt_le_1_alt; nra).
apply (Rmult_le_reg_r (sqrt s * sqrt (1 + b/a*s) * sqrt (1+b/a))). { repeat apply Rmult_lt_0_compat; lra. }
replace ((1-b)/sqrt (1+b/a)/sqrt s*(sqrt s*sqrt (1+b/a*s)*sqrt (1+b/a))) with ((1-b)*sqrt (1+b/a*s)) by (field; lra).
replace ((1-b*s)/(sqrt s*sqrt (1+b/a*s))*(sqrt s*sqrt (1+b/a*s)*sqrt (1+b/a))) with ((1-b*s)*sqrt (1+b/a)) by (field; lra).
apply Rmult_le_compat; try lra. nra.
Qed.

Definition m := 2 / sqrt (a*b) * ((1-b) / sqrt (1+b/a)).
Lemma m_pos : 0 < m.
Proof.
unfold m. assert (B : 0 < b/a) by (apply Rdiv_lt_0_compat; lra).
assert (0 < a*b) by (apply Rmult_lt_0_compat; lra).
assert (0 < sqrt (a*b)) by (apply sqrt_lt_R0; lra). assert (0 < sqrt (1+b/a)) by (apply sqrt_lt_R0; lra).
apply Rmult_lt_0_compat; apply Rdiv_lt_0_compat; lra.
Qed.
Lemma sin_le t : 0 <= t -> sin t <= t.
Proof. intros [Ht|<-]. left; now apply sin_lt_x. rewrite sin_0. lra. Qed.

Lemma G_lower u : 0 < u <= 1 -> m * (ln (sqrt u + PI/2) - ln (sqrt u)) <= G a b u.
Proof.
intros Hu. assert (HPI := PI_RGT_0). assert (S : 0 < sqrt u) by (apply sqrt_lt_R0; lra).
set (r := (1-b) / sqrt (1+b/a)).
assert (R0 : 0 < r). { unfold r. apply Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0. assert (0 < b/a) by (apply Rdiv_lt_0_compat; lra). lra. }
assert (I : is_RInt (fun t => scal r (/ (sqrt u + t))) 0 (PI/2) (scal r (minus (ln (sqrt u + PI/2)) (ln (sqrt u + 0))))).
{ apply (is_RInt_scal (V:=R_NormedModule)). 
  apply (is_RInt_derive (V:=R_CompleteNormedModule) (fun t => ln (sqrt u + t))).
  - rewrite Rmin_left, Rmax_right by lra. intros t Ht. auto_derive. lra. field. lra.
  - rewrite Rmin_left, Rmax_right by lra. intros t Ht. apply (ex_derive_continuous (fun t => / (sqrt u + t))). auto_derive. lra. }
rewrite Rplus_0_r in I.
unfold G, m. fold r. rewrite Rmult_assoc. apply Rmult_le_compat_l.
{ apply Rlt_le, Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0, Rmult_lt_0_compat; lra. }
change (r * (ln (sqrt u + PI/2) - ln (sqrt u))) with (scal r (minus (ln (sqrt u + PI/2)) (ln (sqrt u))) : R).
rewrite <- (is_RInt_unique _ _ _ _ I). apply RInt_le; try lra.
- eexists; exact I.
- apply (@ex_RInt_continuous R_CompleteNormedModule). intros t _. 
  apply (continuous_comp (fun t => X u (sin t)) (h a b)). apply X_continuous. apply h_continuous; try lra. apply X_pos_any; lra.
- intros t Ht. unfold scal; simpl; unfold mult; simpl.
  assert (X1 : 0 < X u (sin t) <= 1).
  { split. apply X_pos_any; lra. unfold X. generalize (SIN_bound t). intros. assert (sin t ^2 <= 1) by nra. nra. }
  apply Rle_trans with (2 := h_lower _ X1). fold r. unfold Rdiv. apply Rmult_le_compat_l; [lra|].
  assert (0 < sqrt (X u (sin t))) by (apply sqrt_lt_R0; lra).
  apply Rinv_le_contravar; [lra|].
  rewrite <- (sqrt_pow2 (sqrt u + t)) by lra. apply sqrt_le_1_alt. unfold X.
  assert (L := sin_le t ltac:(lra)). assert (0 <= sin t) by (apply sin_ge_0; lra).
  assert (sqrt u * sqrt u = u) by (apply sqrt_sqrt; lra). 
  assert (sin t ^2 <= t^2) by nra. assert (0 <= u * sin t ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). nra.
Qed.

(** Every value above pi I exactly once on (0,1), and no other. *)
Theorem takes_each_value_once v : PI * geometric_constant a b < v <-> exists u, 0 < u < 1 /\ G a b u = v /\ forall w, 0 < w < 1 -> G a b w = v -> w = u.
Proof.
split.
- intros Hv. assert (M := m_pos).
  set (u0 := exp (- 2 * (Rmax v 0 + 1) / m)).
  assert (V0 := Rmax_l v 0). assert (V1 := Rmax_r v 0).
  assert (U0 : 0 < u0 < 1).
  { split. apply exp_pos. rewrite <- exp_0. apply exp_increasing. assert (0 < (Rmax v 0+1)/m) by (apply Rdiv_lt_0_compat; lra). unfold Rdiv in *. lra. }
  assert (L : v < G a b u0).
  { apply Rlt_le_trans with (2 := G_lower u0 ltac:(lra)). 
    assert (E : ln (sqrt u0) = - (Rmax v 0 + 1)/m).
    { assert (E2 : sqrt u0 = exp (- (Rmax v 0 + 1)/m)).
      { unfold u0. rewrite <- (sqrt_pow2 (exp (- (Rmax v 0 + 1)/m))) by (left; apply exp_pos). f_equal.
        simpl. rewrite Rmult_1_r, <- exp_plus. f_equal. field. lra. }
      rewrite E2. apply ln_exp. }
    rewrite E. assert (HPI := PI2_1). assert (S : 0 < sqrt u0) by (apply sqrt_lt_R0; lra).
    assert (0 < ln (sqrt u0 + PI/2)). { rewrite <- ln_1. apply ln_increasing; lra. }
    replace (m * (ln (sqrt u0 + PI/2) - - (Rmax v 0 + 1)/m)) with (m * ln (sqrt u0 + PI/2) + (Rmax v 0 + 1)) by (field; lra). 
    assert (0 < m * ln (sqrt u0 + PI/2)) by (apply Rmult_lt_0_compat; lra). lra. }
  destruct (Ranalysis5.IVT_interv (fun u => v - G a b u) u0 1) as [u [Hu Eu]]; try lra.
  + intros x Hx. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?.
    apply continuity_pt_filterlim. apply (ex_derive_continuous (G a b)). eexists. apply G_derive; lra.
  + rewrite G_at_one by assumption. lra.
  + assert (u <> 1). { intros ->. rewrite G_at_one in Eu by assumption. lra. }
    exists u. split; [lra|]. split; [lra|]. intros w Hw Ew.
    destruct (Rtotal_order w u) as [D|[D|D]]; trivial; [assert (N := G_decreasing a b Ha Hb w u)|assert (N := G_decreasing a b Ha Hb u w)]; lra.
- intros [u [Hu [E _]]]. rewrite <- E, <- G_at_one by assumption. apply G_decreasing; lra.
Qed.
(** Lemma 7: G tends to pi I as u tends to 1, and to infinity as u tends to 0. *)
Theorem lemma_7_at_1 : filterlim (G a b) (locally 1) (locally (PI * geometric_constant a b)).
Proof.
rewrite <- G_at_one by assumption. apply (ex_derive_continuous (G a b)). eexists. apply G_derive; lra.
Qed.
Theorem lemma_7_at_0 : filterlim (G a b) (at_right 0) (Rbar_locally p_infty).
Proof.
intros P [M HM]. assert (V := Rmax_l M (PI * geometric_constant a b)). assert (W := Rmax_r M (PI * geometric_constant a b)).
destruct (proj1 (takes_each_value_once (Rmax M (PI * geometric_constant a b) + 1))) as [u0 [Hu [E _]]]; [lra|].
exists (mkposreal u0 (proj1 Hu)). intros u B Hu0. apply HM. unfold ball in B; simpl in B; unfold AbsRing_ball, abs, minus, plus, opp in B; simpl in B.
assert (L : u < u0). { apply Rabs_def2 in B. lra. }
assert (D := G_decreasing a b Ha Hb u u0 ltac:(lra) L ltac:(lra)). lra.
Qed.
End Values.
