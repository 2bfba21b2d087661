(** The integrals of the paper: in any motion, while cos theta keeps its sign, the gain of phi is the integral over psi of
    h(psi) = (1 - b cos^2 psi) / sqrt ((a + b cos^2 psi)(c + b cos^2 psi)), eqs. (10), (16), (21); at turning points as an improper integral. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase.
From Polhode Require Import FreeBody Loop MotionPhase.
Open Scope R_scope.

Definition phase_kernel (a b c psi : R) := (1 - b * cos psi ^ 2) / sqrt ((a + b * cos psi ^ 2) * (c + b * cos psi ^ 2)).
Lemma phase_kernel_continuous a b c psi : 0 < (a + b * cos psi ^ 2) * (c + b * cos psi ^ 2) -> continuous (phase_kernel a b c) psi.
Proof.
intros H. assert (0 < sqrt ((a + b * cos psi ^ 2) * (c + b * cos psi ^ 2))) by (now apply sqrt_lt_R0).
apply (ex_derive_continuous (phase_kernel a b c)). unfold phase_kernel. auto_derive. simpl in *. repeat split; trivial; lra.
Qed.

Section Integral.
Variable moment : axis -> R.
Variables th ps ph : R -> R.
Hypothesis M : motion moment th ps ph.
Notation Iy := (moment y_axis).
Notation a := (par_a moment).
Notation b := (par_b moment).
Notation x t := (cos (ps t) ^ 2).
Notation c := (par_c moment (th 0) (ps 0)).

Lemma radicand_where_moving t : cos (th t) <> 0 -> 0 < (a + b * x t) * (c + b * x t).
Proof.
intros N. rewrite <- (cos_squared moment th ps ph M t). assert (D := denominator_positive moment th ps ph M t).
apply Rmult_lt_0_compat; trivial. apply Rmult_lt_0_compat; trivial. simpl. rewrite Rmult_1_r. assert (0 < Rsqr (cos (th t))) by (now apply Rlt_0_sqr). unfold Rsqr in H. exact H.
Qed.
Lemma gain_is_integral s t : is_RInt (fun v => (1 - b * x v) / Iy) s t (ph t - ph s).
Proof.
apply (is_RInt_derive (V:=R_CompleteNormedModule) ph).
- intros v _. evar_last. apply (ph_derive moment th ps ph M). apply (phi_rate moment th ps ph M).
- intros v _. assert (X : ex_derive ps v) by apply (ps_differentiable _ _ _ _ M).
  apply (ex_derive_continuous (fun v => (1 - b * x v) / Iy)). auto_derive. exact X.
Qed.
(** Eqs. (16), (21): while cos theta > 0. *)
Theorem gain_over_psi s t : s <= t -> (forall v, s <= v <= t -> 0 < cos (th v)) ->
  is_RInt (phase_kernel a b c) (ps s) (ps t) (ph t - ph s).
Proof.
intros L Pos. destruct (moments moment th ps ph M) as [_ [I _]].
set (dps := fun v => (a + b * x v) * cos (th v) / Iy).
assert (C : forall v, s <= v <= t -> continuous (phase_kernel a b c) (ps v)).
{ intros v Hv. apply phase_kernel_continuous, radicand_where_moving. assert (P := Pos v Hv). lra. }
assert (D : forall v, is_derive ps v (dps v)). { intros v. evar_last. apply (ps_derive moment th ps ph M). apply (psi_rate moment th ps ph M). }
assert (S : is_RInt (fun v => scal (dps v) (phase_kernel a b c (ps v))) s t (RInt (phase_kernel a b c) (ps s) (ps t))).
{ apply (is_RInt_comp (V:=R_CompleteNormedModule) (phase_kernel a b c) ps dps).
  - rewrite Rmin_left, Rmax_right by lra. exact C.
  - intros v _. split. apply D. assert (X : ex_derive ps v) by apply (ps_differentiable _ _ _ _ M). assert (Y : ex_derive th v) by apply (th_differentiable _ _ _ _ M).
    apply (ex_derive_continuous dps). unfold dps. auto_derive. repeat match goal with |- _ /\ _ => split | |- True => trivial | |- ex_derive (fun y => ps y) _ => exact X | |- ex_derive (fun y => th y) _ => exact Y end. }
assert (E : ph t - ph s = RInt (phase_kernel a b c) (ps s) (ps t)).
{ rewrite <- (is_RInt_unique _ _ _ _ S). symmetry. rewrite <- (is_RInt_unique _ _ _ _ (gain_is_integral s t)). apply RInt_ext.
  rewrite Rmin_left, Rmax_right by lra. intros v Hv. unfold scal; simpl; unfold mult; simpl. unfold phase_kernel, dps.
  rewrite (root_is_cos moment th ps ph M). assert (P := Pos v ltac:(lra)). rewrite Rabs_right by lra. assert (N := denominator_positive moment th ps ph M v). 
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. simpl in N |- *. field. lra. }
rewrite E. apply (@RInt_correct R_CompleteNormedModule). apply (@ex_RInt_continuous R_CompleteNormedModule).
intros y Hy. 
assert (Mo : ps s <= ps t).
{ destruct (MVT_gen ps s t dps) as [z [Z Ez]].
  - intros v _. apply D.
  - intros v _. apply continuity_pt_filterlim. apply (ex_derive_continuous ps). eexists; apply D.
  - rewrite Rmin_left, Rmax_right in Z by lra. assert (P := Pos z Z). assert (N := denominator_positive moment th ps ph M z).
    assert (0 <= dps z) by (unfold dps; apply Rmult_le_pos; [apply Rmult_le_pos; lra|left; now apply Rinv_0_lt_compat]). nra. }
destruct (IVT_gen ps s t y) as [v [V Ev]].
- intros v. apply continuity_pt_filterlim. apply (ex_derive_continuous ps). eexists; apply D.
- exact Hy.
- rewrite Rmin_left, Rmax_right in V by lra. rewrite <- Ev. now apply C.
Qed.

(** Eq. (10), one half: from one turning point to the next, with cos theta > 0 between, phi gains the improper integral of the kernel over psi. *)
Theorem gain_over_swing t0 t1 : t0 < t1 -> (forall t, t0 < t < t1 -> 0 < cos (th t)) ->
  is_RInt_gen (phase_kernel a b c) (at_right (ps t0)) (at_left (ps t1)) (ph t1 - ph t0).
Proof.
intros L Pos. set (m := (t0 + t1)/2). assert (Hm : t0 < m < t1) by (unfold m; lra).
destruct (moments moment th ps ph M) as [_ [I _]].
set (dps := fun v => (a + b * x v) * cos (th v) / Iy).
assert (D : forall v, is_derive ps v (dps v)). { intros v. evar_last. apply (ps_derive moment th ps ph M). apply (psi_rate moment th ps ph M). }
assert (Cp : forall v, continuity_pt ps v). { intros v. apply continuity_pt_filterlim. apply (ex_derive_continuous ps). eexists; apply D. }
assert (Cf : forall v, continuity_pt ph v). { intros v. apply continuity_pt_filterlim. apply (ex_derive_continuous ph), (ph_differentiable _ _ _ _ M). }
assert (Inc : forall s t, t0 <= s -> s < t -> t <= t1 -> ps s < ps t).
{ intros s t H1 H2 H3. destruct (MVT_cor2 ps dps s t H2) as [z [Ez Z]]. { intros v _. apply is_derive_Reals, D. }
  assert (P := Pos z ltac:(lra)). assert (N := denominator_positive moment th ps ph M z).
  assert (0 < dps z) by (unfold dps; apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra|now apply Rinv_0_lt_compat]). nra. }
assert (Il := Inc t0 m ltac:(lra) ltac:(lra) ltac:(lra)). assert (Ir := Inc m t1 ltac:(lra) ltac:(lra) ltac:(lra)).
intros Pr [e He]. assert (E0 := cond_pos e). 
destruct (Cf t0 (e/2) ltac:(lra)) as [d0 [Hd0 N0]]. destruct (Cf t1 (e/2) ltac:(lra)) as [d1 [Hd1 N1]]. simpl in N0, N1. unfold R_dist in N0, N1.
set (s0 := Rmin m (t0 + d0/2)). set (s1 := Rmax m (t1 - d1/2)).
assert (S0 : t0 < s0 <= m /\ s0 < t0 + d0). { unfold s0. assert (W1 := Rmin_l m (t0 + d0/2)). assert (W2 := Rmin_r m (t0 + d0/2)). split; [split; [apply Rmin_glb_lt; lra|lra]|lra]. }
assert (S1 : m <= s1 < t1 /\ t1 - d1 < s1). { unfold s1. assert (W1 := Rmax_l m (t1 - d1/2)). assert (W2 := Rmax_r m (t1 - d1/2)). split; [split; [lra|apply Rmax_lub_lt; lra]|lra]. }
assert (K0 := Inc t0 s0 ltac:(lra) ltac:(lra) ltac:(lra)). assert (K1 := Inc s1 t1 ltac:(lra) ltac:(lra) ltac:(lra)).
assert (G0 : 0 < ps s0 - ps t0) by lra. assert (G1 : 0 < ps t1 - ps s1) by lra.
apply (Filter_prod _ _ _ (fun y => ps t0 < y < ps s0) (fun z => ps s1 < z < ps t1)).
- exists (mkposreal _ G0). intros y By Ly. unfold ball in By; simpl in By; unfold AbsRing_ball, abs, minus, plus, opp in By; simpl in By. apply Rabs_def2 in By. lra.
- exists (mkposreal _ G1). intros z Bz Lz. unfold ball in Bz; simpl in Bz; unfold AbsRing_ball, abs, minus, plus, opp in Bz; simpl in Bz. apply Rabs_def2 in Bz. lra.
- intros y z Hy Hz. simpl.
  destruct (IVT_gen ps t0 s0 y Cp) as [s [Vs Es]]. { rewrite Rmin_left, Rmax_right by lra. lra. }
  destruct (IVT_gen ps s1 t1 z Cp) as [t [Vt Et]]. { rewrite Rmin_left, Rmax_right by lra. lra. }
  rewrite Rmin_left, Rmax_right in Vs, Vt by lra.
  assert (s <> t0) by (intros ->; lra). assert (t <> t1) by (intros ->; lra).
  exists (ph t - ph s). split.
  + rewrite <- Es, <- Et. apply gain_over_psi. lra. intros v Hv. apply Pos. lra.
  + apply He. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl.
    assert (A0 : Rabs (ph s - ph t0) < e/2). { apply N0. split. split; [exact Logic.I|auto]. rewrite Rabs_right; lra. }
    assert (A1 : Rabs (ph t - ph t1) < e/2). { apply N1. split. split; [exact Logic.I|auto]. rewrite Rabs_left; lra. }
    apply Rabs_def2 in A0. apply Rabs_def2 in A1. apply Rabs_def1; lra.
Qed.
(** Eq. (10) for the oscillating motions: that improper integral is G(-c/b). *)
Theorem swing_integral t0 t1 : - b < c < 0 -> consecutive_turning_points th t0 t1 -> (forall t, t0 < t < t1 -> 0 < cos (th t)) ->
  is_RInt_gen (phase_kernel a b c) (at_right (ps t0)) (at_left (ps t1)) (HalfPhase.G a b (- c / b)).
Proof.
intros Hc T Pos. rewrite <- (swing_phase moment th ps ph M Hc t0 t1 T). apply gain_over_swing; trivial. apply T.
Qed.
End Integral.
